//! What scenes ask for without effect is left out: by plans and pictures, without a clock.

use conformance::left_out::{LeaveOut, PlanFound, Row, features, measure, pictures};

#[test]
fn plans_leave_out_what_has_no_effect() {
    let rows: Vec<Row> =
        features().map(|feature| measure(feature, 0).expect(feature.name)).collect();
    assert!(rows.len() >= 60, "only {} features", rows.len());
    let wrong: Vec<String> = rows
        .iter()
        .filter(|row| !row.passes())
        .map(|row| {
            format!(
                "{}: {} bytes differ, by {}; {:?}",
                row.name, row.different, row.largest, row.plan
            )
        })
        .collect();
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

/// `DETGL_LEAVE_OUT=0` changes no bit.
#[test]
fn pictures_are_the_same_where_nothing_is_left_out() {
    for feature in features() {
        let [with, without] = [LeaveOut::WithoutEffect, LeaveOut::Nothing]
            .map(|leave_out| pictures(feature, leave_out).expect(feature.name));
        assert!(with == without, "{}", feature.name);
    }
}

/// An allowance for work that is not done any more hides the next mistake.
#[test]
fn no_allowance_is_superfluous() {
    let superfluous: Vec<&str> = features()
        .map(|feature| measure(feature, 0).expect(feature.name))
        .filter(|row| row.allowance == Some("not left out") && row.plan == PlanFound::SameWork)
        .map(|row| row.name)
        .collect();
    assert_eq!(superfluous, ["hidden-behind"], "plans of single draws cannot show that one");
}
