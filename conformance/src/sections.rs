//! What each subcommand runs, prints and writes.

use crate::failure::Failure;
use crate::{Args, Counted, ReportSection};
use conformance::chapters::checks;
use conformance::check::{Check, Effort, Harness, Outcome, Subject, Verdict};
use conformance::judge::{self, Driver};
use conformance::left_out::{self, Feature};
use conformance::mutation::{MUTATIONS, MutationRow, Variant};
use conformance::peers;
use conformance::report::{Count, NOISY, bar};
use conformance::sweep::{SWEEPS, Sweep, SweepOutcome};
use conformance::tradeoff::choices::{CHOICES, Choice, ChoiceOutcome};
use conformance::tradeoff::{self, Scene, functions};
use conformance::{filter_pictures, report, self_test};
use indicatif::ProgressBar;
use serde::Serialize;

/// The JSON of `error-vs-time`.
#[derive(Serialize)]
struct Tradeoff<'a> {
    scenes: &'a [tradeoff::Row],
    choices: &'a [ChoiceOutcome],
    functions: &'a [functions::FunctionRow],
}

impl Args {
    /// Everything; what `--only` selects nothing of is left out.
    pub fn all(&self) -> Counted {
        let parts: [fn(&Self) -> Counted; 5] =
            [Self::formulas, Self::self_test, Self::error_vs_time, Self::extremes, Self::left_out];
        let mut counts = Vec::new();
        let mut names = Vec::new();
        for part in parts {
            match part(self) {
                Ok(of) => counts.extend(of),
                Err(Failure::NoMatch(_, of)) => names.push(of),
                Err(failure) => return Err(failure),
            }
        }
        if counts.is_empty() {
            return Err(Failure::NoMatch(self.only.clone().unwrap_or_default(), names.join(",\n")));
        }
        if self.json {
            println!("{}", report::json(&*self.found.borrow())?);
        }
        Ok(counts)
    }

    pub fn formulas(&self) -> Counted {
        let selected = self.selected(checks(), |check: &Check| [check.name, check.citation])?;
        let harness =
            Harness { subject: Subject::Driver, effort: self.effort(), variant: Variant::CORRECT };
        let bar = bar(selected.len());
        let outcomes: Vec<Outcome> = selected
            .iter()
            .map(|check| {
                bar.set_message(check.name);
                let outcome = check.run(&harness);
                bar.inc(1);
                outcome
            })
            .collect();
        bar.finish_and_clear();
        self.print(ReportSection::Formulas, || report::table(self.layout(), &outcomes), &outcomes)?;
        if !self.json {
            let pictures =
                if self.only.is_none() { filter_pictures::pictures()? } else { Vec::new() };
            let page = self.page("index");
            report::checks_page(&self.out, &page, &outcomes, &pictures)?;
            self.print_path(&page);
        }
        let passes = |outcome: &Outcome| outcome.verdict == Verdict::Pass;
        Ok(vec![Count::of(&outcomes, "checks pass", passes)])
    }

    /// The checks by DetGL and by other libraries.
    pub fn judge(&self) -> Counted {
        let selected = self.selected(checks(), |check: &Check| [check.name, check.citation])?;
        let drivers = self.driver.iter().map(|name| Driver::open(name));
        let drivers = drivers.collect::<Result<Vec<_>, _>>()?;
        let bar = bar(selected.len());
        let rows: Vec<judge::Row> = selected
            .iter()
            .map(|check| {
                bar.set_message(check.name);
                let row = judge::judge(check, self.effort(), &drivers);
                bar.inc(1);
                row
            })
            .collect();
        bar.finish_and_clear();
        let (summary, table) = (judge::summary(&rows, &drivers), judge::page(&rows, &drivers));
        println!("{summary}\n{table}");
        std::fs::create_dir_all(&self.out)?;
        let path = self.out.join("drivers.md");
        std::fs::write(&path, format!("{summary}\n{table}"))?;
        println!("{}", path.display());
        let own = rows.iter().filter(|row| row.own.verdict == Verdict::Pass).count();
        Ok(vec![Count { passed: own, all: rows.len(), what: "checks of DetGL pass" }])
    }

    pub fn self_test(&self) -> Counted {
        let rows = self.selected(MUTATIONS.iter(), |row: &MutationRow| [row.check, row.what])?;
        let bar = bar(rows.len());
        let trials = self_test::run_with(Subject::Driver, &rows, &|| bar.inc(1));
        bar.finish_and_clear();
        self.print(
            ReportSection::SelfTest,
            || report::trials_table(self.layout(), &trials),
            &trials,
        )?;
        if !self.json {
            let page = self.page("self-test");
            report::trials_page(&self.out, &page, &trials)?;
            self.print_path(&page);
        }
        Ok(vec![Count::of(&trials, "mistakes noticed", |trial| trial.noticed)])
    }

    pub fn error_vs_time(&self) -> Counted {
        let side = match self.effort() {
            Effort::Quick => 96,
            Effort::Full => 256,
            Effort::Thorough => 512,
        };
        let scenes = tradeoff::scenes(side);
        let chosen: Vec<&Scene> =
            scenes.iter().filter(|scene| self.is_selected(&[scene.name, scene.what])).collect();
        let calls: Vec<&str> =
            functions::names().filter(|name| self.is_selected(&[name])).collect();
        let choices: Vec<&Choice> =
            CHOICES.iter().filter(|choice| self.is_selected(&[choice.name, choice.what])).collect();
        if chosen.is_empty() && choices.is_empty() && calls.is_empty() {
            let names = scenes.iter().map(|scene| scene.name);
            let names = names.chain(CHOICES.iter().map(|choice| choice.name));
            let names = names.chain(functions::names());
            return Err(self.no_match(names.collect()));
        }
        let bar = bar(chosen.len() + choices.len() + 1);
        let measured = tradeoff::measure(side, chosen, |scene| {
            bar.set_message(scene.name);
            bar.inc(1);
        })?;
        let mut chosen = Vec::with_capacity(choices.len());
        for choice in choices {
            bar.set_message(choice.name);
            chosen.push(choice.measure(side / 2)?);
            bar.inc(1);
        }
        bar.set_message("functions");
        let functions = functions::measure(&calls)?;
        bar.finish_and_clear();
        let table = || {
            let all = tradeoff::overall(&measured.rows);
            let rows = [measured.rows.clone(), all].concat();
            let layout = self.layout();
            let tables = [
                (!measured.rows.is_empty()).then(|| report::tradeoff_table(layout, &rows)),
                (!chosen.is_empty()).then(|| report::choices_table(layout, &chosen)),
                (!functions.is_empty()).then(|| report::functions_table(layout, &functions)),
            ];
            tables.into_iter().flatten().collect::<Vec<_>>().join("\n")
        };
        self.print(
            ReportSection::ErrorVsTime,
            table,
            &Tradeoff { scenes: &measured.rows, choices: &chosen, functions: &functions },
        )?;
        if !self.json {
            let page = self.page("error-vs-time");
            report::tradeoff_page(&self.out, &page, &measured, &chosen, &functions)?;
            self.print_path(&page);
        }
        let noisy = measured.rows.iter().filter(|row| row.spread() > NOISY).count();
        let noisy = noisy + chosen.iter().filter(|choice| choice.spread() > NOISY).count();
        self.warn(noisy, measured.rows.len() + chosen.len());
        let of_choices: usize = chosen.iter().map(|choice| choice.rows.len()).sum();
        let all = measured.rows.len() + of_choices + functions.len();
        Ok(vec![Count { passed: all, all, what: "times measured" }])
    }

    pub fn extremes(&self) -> Counted {
        let selected =
            self.selected(SWEEPS.iter(), |sweep: &Sweep| [sweep.name, sweep.parameter])?;
        let bar = bar(selected.len());
        let swept: Vec<SweepOutcome> = selected
            .iter()
            .map(|sweep| {
                bar.set_message(sweep.name);
                let outcome = sweep.run();
                bar.inc(1);
                outcome
            })
            .collect();
        bar.finish_and_clear();
        self.print(
            ReportSection::Extremes,
            || report::sweeps_table(self.layout(), &swept),
            &swept,
        )?;
        if !self.json {
            let page = self.page("extremes");
            report::sweeps_page(&self.out, &page, &swept)?;
            self.print_path(&page);
        }
        Ok(vec![Count::of(&swept, "sweeps pass", SweepOutcome::passes)])
    }

    /// The features of `left-out`, timed in other libraries, too: those of `--driver`, or llvmpipe where it is installed.
    pub fn left_out_beside_others(&self) -> Counted {
        let drivers = match &self.driver[..] {
            [] => Vec::from_iter(Driver::open("llvmpipe").ok()),
            names => names.iter().map(|name| Driver::open(name)).collect::<Result<_, _>>()?,
        };
        self.left_out_beside(&drivers)
    }

    fn left_out(&self) -> Counted {
        self.left_out_beside(&[])
    }

    fn left_out_beside(&self, drivers: &[Driver]) -> Counted {
        let selected =
            self.selected(left_out::features(), |feature: &Feature| [feature.name, feature.what])?;
        let rounds = match self.effort() {
            Effort::Quick => 3,
            Effort::Full => 9,
            Effort::Thorough => 28,
        };
        let bar = bar(selected.len());
        let mut rows = Vec::with_capacity(selected.len());
        for feature in selected {
            bar.set_message(feature.name);
            let row = left_out::measure(feature, rounds)?;
            let peers =
                drivers.iter().map(|driver| driver.time(feature.name, rounds.min(3))).collect();
            rows.push(left_out::Row { peers, ..row });
            bar.inc(1);
        }
        bar.finish_and_clear();
        let names: Vec<&str> = drivers.iter().map(|driver| driver.name.as_str()).collect();
        self.print(
            ReportSection::LeftOut,
            || report::left_out_table(self.layout(), &rows, &names),
            &rows,
        )?;
        if !self.json {
            let page = self.page("left-out");
            report::left_out_page(&self.out, &page, &rows, &names)?;
            self.print_path(&page);
        }
        self.warn(rows.iter().filter(|row| row.timing.noise > NOISY).count(), rows.len());
        Ok(vec![Count::of(&rows, "features pass", left_out::Row::passes)])
    }

    pub fn peers(&self, options: &peers::Options) -> Counted {
        let only = self.only.as_deref().unwrap_or_default();
        let scenes = peers::selected(only);
        if scenes.is_empty() {
            return Err(self.no_match(peers::names()));
        }
        let bar = ProgressBar::new_spinner();
        let comparison = peers::compare(options, &scenes, |what| {
            bar.set_message(what.to_owned());
            bar.tick();
        })?;
        bar.finish_and_clear();
        self.print(ReportSection::Peers, || peers::table(self.layout(), &comparison), &comparison)?;
        if !self.json {
            let subject = self.page("peers");
            let name = subject.file().trim_end_matches(".html");
            peers::write(&self.out, name, &comparison)?;
            println!("{}", self.out.join(format!("{name}.md")).display());
        }
        Ok(vec![Count { passed: scenes.len(), all: scenes.len(), what: "scenes compared" }])
    }
}
