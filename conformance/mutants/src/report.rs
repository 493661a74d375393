//! Tables of what became of mistakes.

use crate::choice::Mutant;
use crate::trial::Fate;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

/// How many mistakes had which fate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// All that compile.
    pub planted: usize,
    /// Some check, sweep or picture runs it.
    pub reached: usize,
    /// Something is different, or fails.
    pub changing: usize,
    /// A check or a sweep fails.
    pub noticed: usize,
}

impl Counts {
    fn add(&mut self, fate: &Fate) {
        self.planted += 1;
        self.reached += usize::from(*fate != Fate::Unreached);
        self.changing += usize::from(matches!(fate, Fate::Noticed(_) | Fate::Survived(_)));
        self.noticed += usize::from(matches!(fate, Fate::Noticed(_)));
    }

    /// Percent of those that change something which are noticed.
    pub fn percent(&self) -> f64 {
        100.0 * self.noticed as f64 / self.changing.max(1) as f64
    }
}

/// The counts of all.
pub fn counts<'a>(fates: impl IntoIterator<Item = &'a (Mutant, Fate)>) -> Counts {
    let mut counts = Counts::default();
    fates.into_iter().for_each(|(_, fate)| counts.add(fate));
    counts
}

fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ").replace('|', "\\|")
}

/// A page: counts by folder, and each mistake that survived.
pub fn page(fates: &[(Mutant, Fate)], of: &str) -> String {
    let mut by_folder: BTreeMap<&str, Counts> = BTreeMap::new();
    for (mutant, fate) in fates {
        let folder = mutant.file.rsplit_once('/').map_or("", |(folder, _)| folder);
        by_folder.entry(folder).or_default().add(fate);
    }
    let all = counts(fates);
    let mut out = format!("# Mistakes planted in the driver\n\n{of}\n\n");
    out += "| folder | planted | reached | change something | noticed | percent |\n|---|---|---|---|---|---|\n";
    for (folder, counts) in by_folder.iter().map(|(f, c)| (*f, c)).chain([("**all**", &all)]) {
        let Counts { planted, reached, changing, noticed } = counts;
        let percent = counts.percent();
        let _ = writeln!(
            out,
            "| {folder} | {planted} | {reached} | {changing} | {noticed} | {percent:.1} |"
        );
    }
    out += "\n## Survivors\n\n| mistake | line | expression | becomes | what differs |\n|---|---|---|---|---|\n";
    for (mutant, fate) in fates {
        let Fate::Survived(changed) = fate else { continue };
        let Mutant { number, file, replacement } = mutant;
        let (before, after) = (one_line(&replacement.before), one_line(&replacement.after));
        let few: Vec<&str> = changed.iter().take(4).map(String::as_str).collect();
        let more = if changed.len() > few.len() {
            format!(" and {} more", changed.len() - few.len())
        } else {
            String::new()
        };
        let _ = writeln!(
            out,
            "| {number} | {file}:{} | `{before}` | `{after}` | {}{more} |",
            replacement.line,
            few.join(", ")
        );
    }
    out
}

const SURVIVED: &str = "survived, changes ";

/// Of a listing ([`listing`]), the mistakes that survived: file, expression, and what stands there instead.
pub fn survivors(listing: &str) -> BTreeSet<[String; 3]> {
    let rows = listing.lines().filter_map(|line| {
        let [_, at, before, after, fate] = line.split('\t').collect::<Vec<_>>()[..] else {
            return None;
        };
        let file = at.rsplit_once(':')?.0;
        fate.starts_with(SURVIVED).then(|| [file, before, after].map(str::to_owned))
    });
    rows.collect()
}

/// What [`survivors`] says of a mistake.
pub fn survivor_key(mutant: &Mutant) -> [String; 3] {
    let Mutant { file, replacement, .. } = mutant;
    [file.clone(), one_line(&replacement.before), one_line(&replacement.after)]
}

/// A line for each mistake: number, file and line, change, fate.
pub fn listing(fates: &[(Mutant, Fate)]) -> String {
    let mut out = String::new();
    for (Mutant { number, file, replacement }, fate) in fates {
        let fate = match fate {
            Fate::Unreached => "unreached".to_owned(),
            Fate::Unchanged => "unchanged".to_owned(),
            Fate::Noticed(by) => format!("noticed by {by}"),
            Fate::Survived(changed) => format!("{SURVIVED}{}", changed.join(", ")),
        };
        let (before, after) = (one_line(&replacement.before), one_line(&replacement.after));
        let _ = writeln!(out, "{number}\t{file}:{}\t{before}\t{after}\t{fate}", replacement.line);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::replacements::Replacement;

    #[test]
    fn survivors_are_named_and_counted() {
        let mutant = |number| Mutant {
            number,
            file: "a/src/b.rs".to_owned(),
            replacement: Replacement {
                line: 7,
                range: 0..1,
                before: "x ||\n y".to_owned(),
                after: "y".to_owned(),
            },
        };
        let fates = [
            (mutant(1), Fate::Unreached),
            (mutant(2), Fate::Unchanged),
            (mutant(3), Fate::Noticed("check fog".to_owned())),
            (mutant(4), Fate::Survived(vec!["picture moon".to_owned()])),
        ];
        let all = counts(&fates);
        assert_eq!(all, Counts { planted: 4, reached: 3, changing: 2, noticed: 1 });
        let page = page(&fates, "Four.");
        assert!(page.contains("| a/src | 4 | 3 | 2 | 1 | 50.0 |"), "{page}");
        assert!(
            page.contains("| 4 | a/src/b.rs:7 | `x \\|\\| y` | `y` | picture moon |"),
            "{page}"
        );
        let listing = listing(&fates);
        assert!(listing.contains("3\ta/src/b.rs:7\tx \\|\\| y\ty\tnoticed by check fog\n"));
        assert_eq!(survivors(&listing), BTreeSet::from([survivor_key(&mutant(4))]));
    }
}
