//! Runs checks, sweeps and the gallery's programs by name, with the mistake that `DETGL_MUTANT` chooses; a line for
//! each says name, `pass` or `fail`, a digest of what was seen, seconds, and the mistakes that were reached. Ends at
//! the first that fails. Without names: all of them, and no end.

use conformance::chapters::checks;
use conformance::check::{Effort, Harness, Subject, Verdict};
use conformance::mutation::Variant;
use conformance::sweep::SWEEPS;
use examples::programs;
use examples::window::render;
use gl_api::context::ContextDesc;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write;
use std::time::Instant;

/// Side of the gallery's pictures.
const SIDE: usize = 96;

/// An item: its name, and what says whether it passes, with a digest.
type Item = (String, Box<dyn Fn() -> (bool, String)>);

fn items(effort: Effort) -> Vec<Item> {
    let mut items: Vec<Item> = Vec::new();
    let harness = Harness { subject: Subject::Driver, effort, variant: Variant::CORRECT };
    for check in checks() {
        let run = move || {
            let outcome = check.run(&harness);
            (outcome.verdict == Verdict::Pass, outcome.digest)
        };
        items.push((format!("check {}", check.name), Box::new(run)));
    }
    for sweep in SWEEPS {
        let run = move || {
            let outcome = sweep.run();
            (outcome.passes(), digest(&format!("{:?}", outcome.lines)))
        };
        items.push((format!("sweep {}", sweep.name), Box::new(run)));
    }
    for program in &programs::ALL {
        // A picture cannot fail: it only shows that something changes.
        let run = move || match render(program, SIDE, None, &ContextDesc::default()) {
            Ok(rendered) => (true, digest(&format!("{:?}", rendered.picture))),
            Err(error) => (true, error.to_string().replace(['\t', '\n'], " ")),
        };
        items.push((format!("picture {}", program.name), Box::new(run)));
    }
    items
}

fn digest(text: &str) -> String {
    let mut hasher = DefaultHasher::new();
    text.hash(&mut hasher);
    format!("{:016x}", hasher.finish())
}

fn main() {
    mutant_switch::start();
    let mut names: Vec<String> = std::env::args().skip(1).collect();
    let effort = match names.first().map(String::as_str) {
        Some("--full") => Effort::Full,
        _ => Effort::Quick,
    };
    names.retain(|name| name != "--full");
    let all = items(effort);
    let chosen: Vec<&Item> = match names.is_empty() {
        true => all.iter().collect(),
        false => names.iter().filter_map(|name| all.iter().find(|(own, _)| own == name)).collect(),
    };
    let mut out = std::io::stdout();
    for (name, run) in chosen {
        mutant_switch::reached();
        let start = Instant::now();
        let (passes, digest) = run();
        let seconds = start.elapsed().as_secs_f64();
        let reached: Vec<_> = mutant_switch::reached().iter().map(u32::to_string).collect();
        let verdict = if passes { "pass" } else { "fail" };
        let line = format!("{name}\t{verdict}\t{digest}\t{seconds:.4}\t{}", reached.join(","));
        if writeln!(out, "{line}").and_then(|()| out.flush()).is_err() {
            return;
        }
        if !passes && !names.is_empty() {
            return;
        }
    }
}
