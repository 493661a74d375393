//! The suite can fail: each wrong variant of a formula is noticed by the check that is about it,
//! and the formula itself by none.

use conformance::chapters::checks;
use conformance::check::{Effort, Harness, Subject, Verdict};
use conformance::mutation::{MUTATIONS, Variant};
use conformance::self_test;

#[test]
fn the_true_formulas_agree_with_themselves() {
    let variant = Variant::CORRECT;
    let harness = Harness { subject: Subject::Oracle, effort: Effort::Quick, variant };
    for check in checks() {
        let outcome = check.run(&harness);
        assert_eq!(outcome.verdict, Verdict::Pass, "{}", check.name);
        assert_eq!(outcome.largest_error, 0.0, "{}", check.name);
        assert!(outcome.cases > 0, "{}", check.name);
    }
}

#[test]
fn every_mistake_is_noticed() {
    let trials = self_test::run(Subject::Oracle, &MUTATIONS.iter().collect::<Vec<_>>());
    let missed: Vec<_> = trials.iter().filter(|trial| !trial.noticed).collect();
    assert!(missed.is_empty(), "{missed:#?}");
}

#[test]
fn the_readme_counts_the_mistakes() {
    let mistakes = format!("{} known mistakes", MUTATIONS.len());
    assert!(include_str!("../../README.md").contains(&mistakes), "README.md: {mistakes}");
}

#[test]
fn every_check_has_mistakes_to_notice() {
    for check in checks() {
        assert!(MUTATIONS.iter().any(|row| row.check == check.name), "{}", check.name);
    }
}
