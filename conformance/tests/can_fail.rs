//! The suite can fail: each wrong variant of a formula is noticed by the check that is about it,
//! and the formula itself by none.

use conformance::check::{Bench, Effort, Subject, Verdict, checks};
use conformance::mutation::{MUTATIONS, Variant};

fn bench(variant: Variant) -> Bench {
    Bench { subject: Subject::Oracle, effort: Effort::Quick, variant }
}

#[test]
fn the_true_formulas_agree_with_themselves() {
    for check in checks() {
        let outcome = check.run(&bench(Variant::TRUE));
        assert_eq!(outcome.verdict, Verdict::Pass, "{}", check.name);
        assert_eq!(outcome.largest_error, 0.0, "{}", check.name);
        assert!(outcome.cases > 0, "{}", check.name);
    }
}

#[test]
fn every_mistake_is_noticed() {
    let mut unnoticed = Vec::new();
    for row in MUTATIONS {
        let check = checks().find(|check| check.name == row.check);
        let verdict = check.map(|check| check.run(&bench(Variant::wrong(row.mutation))).verdict);
        if verdict != Some(Verdict::Fail) {
            unnoticed.push((row.mutation, row.check, verdict));
        }
    }
    assert!(unnoticed.is_empty(), "{unnoticed:#?}");
}

#[test]
fn every_check_has_mistakes_to_notice() {
    for check in checks() {
        assert!(MUTATIONS.iter().any(|row| row.check == check.name), "{}", check.name);
    }
}
