//! Every check, with a sixteenth of its cases.

use conformance::check::{Bench, Effort, Outcome, Subject, Verdict, checks};
use conformance::mutation::Variant;
use conformance::report;

#[test]
fn every_check_passes() {
    let bench = Bench { subject: Subject::Driver, effort: Effort::Quick, variant: Variant::TRUE };
    let outcomes: Vec<Outcome> = checks().map(|check| check.run(&bench)).collect();
    let passed = outcomes.iter().all(|outcome| outcome.verdict == Verdict::Pass);
    assert!(passed, "\n{}", report::table(&outcomes));
}
