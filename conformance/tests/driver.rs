//! Every check, with a sixteenth of its cases.

use conformance::chapters::checks;
use conformance::check::{Effort, Harness, Outcome, Subject, Verdict};
use conformance::mutation::Variant;
use conformance::report;

#[test]
fn every_check_passes() {
    let harness =
        Harness { subject: Subject::Driver, effort: Effort::Quick, variant: Variant::CORRECT };
    let outcomes: Vec<Outcome> = checks().map(|check| check.run(&harness)).collect();
    let passed = outcomes.iter().all(|outcome| outcome.verdict == Verdict::Pass);
    assert!(passed, "\n{}", report::table(report::Layout::Narrow, &outcomes));
}
