//! The sweeps: enough of them, each with a name of its own, and all of them pass.

use conformance::sweep::{SWEEPS, Sweep, SweepOutcome};
use std::collections::BTreeSet;

#[test]
fn every_sweep_passes() {
    let failed: Vec<String> = SWEEPS
        .iter()
        .map(Sweep::run)
        .filter(|outcome| !outcome.passes())
        .map(|SweepOutcome { name, faults, .. }| format!("{name}: {}", faults.join("; ")))
        .collect();
    assert!(failed.is_empty(), "\n{}", failed.join("\n"));
}

#[test]
fn sweeps_say_where_they_break() {
    let names: BTreeSet<&str> = SWEEPS.iter().map(|sweep| sweep.name).collect();
    assert_eq!(names.len(), SWEEPS.len(), "names are given twice");
    assert!(SWEEPS.len() >= 45);
    for Sweep { name, what, parameter, unit, why, breaks, .. } in SWEEPS {
        for text in [what, parameter, unit, why, breaks] {
            assert!(!text.is_empty(), "{name}");
        }
    }
    let counted = format!("{} sweeps", SWEEPS.len());
    assert!(include_str!("../../README.md").contains(&counted), "README.md: {counted}");
}
