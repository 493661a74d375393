//! Runs the checks that reach a mistake, until one fails.

use crate::error::MutantsError;
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use wait_timeout::ChildExt;

/// What a check, a sweep or a picture shows without a mistake.
#[derive(Clone, Debug)]
pub struct Shown {
    /// Whether it passes.
    pub passes: bool,
    /// A digest of what was seen.
    pub digest: String,
    /// Run time.
    pub seconds: f64,
    /// The mistakes that it reaches.
    pub reached: BTreeSet<u32>,
}

/// What became of a mistake.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fate {
    /// No check, sweep or picture reaches it.
    Unreached,
    /// It is reached, and nothing is different.
    Unchanged,
    /// What notices it: a check that fails, the end of the program, or that there is none.
    Noticed(String),
    /// Something is different, and nothing fails; the names of what differs.
    Survived(Vec<String>),
}

/// How a run ended.
enum End {
    Done,
    Crashed,
    OutOfTime,
}

/// How many cases checks try.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Effort {
    /// A sixteenth.
    Quick,
    /// As many as each check asks for.
    Full,
}

/// Runs mistakes one by one.
#[derive(Debug)]
pub struct Trials {
    /// The program that was built.
    pub runner: PathBuf,
    /// Where its output goes.
    pub folder: PathBuf,
    /// The least time that a check, a sweep or a picture gets.
    pub time_limit: Duration,
    /// How many cases.
    pub effort: Effort,
}

/// Kilobytes of address space that a run gets.
const MEMORY: u32 = 6_000_000;
/// How often a run is looked at.
const LOOK: Duration = Duration::from_millis(200);
/// What an item gets of which nothing is known.
const UNKNOWN: Duration = Duration::from_secs(3600);

impl Trials {
    /// Runs items, each with the time that it usually takes; all that there are if none is named.
    fn run(
        &self,
        mutant: &str,
        items: &[(&str, f64)],
    ) -> Result<(BTreeMap<String, Shown>, End), MutantsError> {
        let path = self.folder.join(format!("{mutant}.txt"));
        let file = File::create(&path).map_err(MutantsError::io(&path))?;
        let mut child = Command::new("sh")
            .args(["-c", &format!("ulimit -v {MEMORY}; exec \"$0\" \"$@\"")])
            .arg(&self.runner)
            .args((self.effort == Effort::Full).then_some("--full"))
            .args(items.iter().map(|(name, _)| name))
            .env("DETGL_MUTANT", mutant)
            .env("DETGL_THREADS", "1")
            .stdin(Stdio::null())
            .stdout(file)
            .stderr(Stdio::null())
            .spawn()
            .map_err(|source| MutantsError::Start { program: self.runner.clone(), source })?;
        let read = || fs::read_to_string(&path).map_err(MutantsError::io(&path));
        let (mut done, mut since) = (0, Instant::now());
        let end = loop {
            match child.wait_timeout(LOOK).map_err(MutantsError::io(&self.runner))? {
                Some(status) if status.success() => break End::Done,
                Some(_) => break End::Crashed,
                None => {}
            }
            let now = read()?.lines().count();
            if now != done {
                (done, since) = (now, Instant::now());
            }
            let usual = |&(_, usual): &(&str, f64)| Duration::from_secs_f64(10.0 * usual);
            let limit = items.get(done).map_or(UNKNOWN, |item| self.time_limit + usual(item));
            if since.elapsed() > limit {
                child.kill().and_then(|()| child.wait()).map_err(MutantsError::io(&self.runner))?;
                break End::OutOfTime;
            }
        };
        let text = read()?;
        fs::remove_file(&path).map_err(MutantsError::io(&path))?;
        Ok((text.lines().filter_map(parse).collect(), end))
    }

    /// What everything shows without a mistake, and which mistakes it reaches.
    ///
    /// # Errors
    /// When something fails.
    pub fn baseline(&self) -> Result<BTreeMap<String, Shown>, MutantsError> {
        let (shown, end) = self.run("record", &[])?;
        let failing: Vec<&str> = shown
            .iter()
            .filter(|(_, shown)| !shown.passes)
            .map(|(name, _)| name.as_str())
            .collect();
        match end {
            End::Done if failing.is_empty() => Ok(shown),
            End::Done => Err(MutantsError::Baseline(failing.join(", "))),
            End::Crashed | End::OutOfTime => Err(MutantsError::Baseline("the program".to_owned())),
        }
    }

    /// Tries a mistake.
    ///
    /// # Errors
    /// When the program cannot be started.
    pub fn try_mutant(
        &self,
        number: u32,
        baseline: &BTreeMap<String, Shown>,
    ) -> Result<Fate, MutantsError> {
        let reaching = |kind: &str| {
            let of_kind = baseline.iter().filter(|(name, _)| name.starts_with(kind));
            let mut all: Vec<(&str, &Shown)> = of_kind
                .filter(|(_, shown)| shown.reached.contains(&number))
                .map(|(name, shown)| (name.as_str(), shown))
                .collect();
            // What is quick and reaches little besides is likely to notice it soon.
            let cost = |shown: &Shown| shown.seconds * shown.reached.len() as f64;
            all.sort_by(|(_, a), (_, b)| cost(a).total_cmp(&cost(b)));
            all
        };
        let mut changed = Vec::new();
        let mut is_reached = false;
        for kind in ["check ", "sweep ", "picture "] {
            let items = reaching(kind);
            if items.is_empty() {
                continue;
            }
            is_reached = true;
            let names: Vec<&str> = items.iter().map(|(name, _)| *name).collect();
            let items: Vec<(&str, f64)> =
                items.iter().map(|(name, shown)| (*name, shown.seconds)).collect();
            let (shown, end) = self.run(&number.to_string(), &items)?;
            if let Some((name, _)) = shown.iter().find(|(_, shown)| !shown.passes) {
                return Ok(Fate::Noticed(name.clone()));
            }
            let next = names.iter().find(|name| !shown.contains_key(**name));
            match (end, next) {
                // A picture is no check: who looks at the gallery sees that there is none.
                (End::Crashed | End::OutOfTime, Some(next)) if kind == "picture " => {
                    changed.push((*next).to_owned());
                }
                (End::Crashed, next) => {
                    return Ok(Fate::Noticed(format!("{}: it ends", next.unwrap_or(&"?"))));
                }
                (End::OutOfTime, next) => {
                    return Ok(Fate::Noticed(format!("{}: no end", next.unwrap_or(&"?"))));
                }
                (End::Done, _) => {}
            }
            let differs = |(name, shown): &(&String, &Shown)| {
                baseline.get(*name).is_some_and(|usual| usual.digest != shown.digest)
            };
            changed.extend(shown.iter().filter(differs).map(|(name, _)| name.clone()));
        }
        Ok(match (is_reached, changed.is_empty()) {
            (false, _) => Fate::Unreached,
            (true, true) => Fate::Unchanged,
            (true, false) => Fate::Survived(changed),
        })
    }
}

/// A line of the program: name, verdict, digest, seconds, mistakes.
fn parse(line: &str) -> Option<(String, Shown)> {
    let mut cells = line.split('\t');
    let (name, verdict, digest) = (cells.next()?, cells.next()?, cells.next()?);
    let seconds = cells.next()?.parse().ok()?;
    let reached = cells.next()?.split(',').filter_map(|number| number.parse().ok()).collect();
    let shown = Shown { passes: verdict == "pass", digest: digest.to_owned(), seconds, reached };
    Some((name.to_owned(), shown))
}

/// The folder of the runs' output, made if there is none.
///
/// # Errors
/// When it cannot be made.
pub fn output_folder(copy_root: &Path) -> Result<PathBuf, MutantsError> {
    let folder = copy_root.join("runs");
    fs::create_dir_all(&folder).map_err(MutantsError::io(&folder))?;
    Ok(folder)
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::os::unix::fs::PermissionsExt;

    /// Trials of a script that stands for the program.
    fn script(folder: &Path, body: &str) -> Trials {
        let runner = folder.join("runner");
        fs::write(&runner, format!("#!/bin/sh\n{body}\n")).expect("a script");
        fs::set_permissions(&runner, fs::Permissions::from_mode(0o755)).expect("it may run");
        let time_limit = Duration::from_millis(300);
        Trials { runner, folder: folder.to_owned(), time_limit, effort: Effort::Quick }
    }

    #[test]
    fn what_becomes_of_mistakes() {
        let folder = tempfile::tempdir().expect("a folder");
        let trials = script(
            folder.path(),
            r#"line() { printf '%s\t%s\t%s\t0.001\t%s\n' "$1" "$2" "$3" "$4"; }
            case $DETGL_MUTANT in
            record) line 'check a' pass 0 1,2,3,4,6; line 'picture b' pass 0 1,5;;
            1) line "$1" fail 1 '';;
            2) exit 1;;
            3) sleep 5;;
            4) line "$1" pass 0 '';;
            5|6) line "$1" pass 9 '';;
            esac"#,
        );
        let baseline = trials.baseline().expect("all pass");
        assert_eq!(baseline["check a"].reached.len(), 5);
        let fate = |number| trials.try_mutant(number, &baseline).expect("it starts");
        assert_eq!(fate(1), Fate::Noticed("check a".to_owned()));
        assert_eq!(fate(2), Fate::Noticed("check a: it ends".to_owned()));
        assert_eq!(fate(3), Fate::Noticed("check a: no end".to_owned()));
        assert_eq!(fate(4), Fate::Unchanged);
        assert_eq!(fate(5), Fate::Survived(vec!["picture b".to_owned()]));
        assert_eq!(fate(6), Fate::Survived(vec!["check a".to_owned()]));
        assert_eq!(fate(7), Fate::Unreached);
    }

    #[test]
    fn what_fails_without_a_mistake_is_said() {
        let folder = tempfile::tempdir().expect("a folder");
        let trials = script(folder.path(), r"printf 'check a\tfail\t0\t0.1\t\n'");
        assert!(
            matches!(trials.baseline(), Err(MutantsError::Baseline(name)) if name == "check a")
        );
    }
}
