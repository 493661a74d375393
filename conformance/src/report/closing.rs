//! The closing line of a run.

use super::machine::Machine;

/// What a run counts: passed, all, and what they are ("checks pass").
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// How many are as they should be.
    pub passed: usize,
    /// How many there are.
    pub all: usize,
    /// What they are and do.
    pub what: &'static str,
}

impl Count {
    /// Counts the items of which `passes` holds.
    pub fn of<T>(items: &[T], what: &'static str, passes: impl Fn(&T) -> bool) -> Self {
        let passed = items.iter().filter(|item| passes(item)).count();
        Self { passed, all: items.len(), what }
    }
}

/// `93 of 93 checks pass, 69 of 69 sweeps pass, 2.3 s`, and the machine on a line of its own.
pub fn closing(counts: &[Count], seconds: f64, machine: &Machine) -> String {
    let counts =
        counts.iter().map(|Count { passed, all, what }| format!("{passed} of {all} {what}"));
    let parts: Vec<String> = counts.chain([format!("{seconds:.1} s")]).collect();
    format!("{}\n{machine}", parts.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_time() {
        let checks = Count::of(&[1, 2, 3], "checks pass", |&n| n < 3);
        let sweeps = Count { passed: 4, all: 4, what: "sweeps" };
        let text = closing(&[checks, sweeps], 2.345, &Machine::here());
        assert!(text.starts_with("2 of 3 checks pass, 4 of 4 sweeps, 2.3 s\n"), "{text}");
    }
}
