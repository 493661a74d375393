//! What is wrong with a sweep: errors above its bound, and all by which it would show nothing.

use super::definition::Sweep;
use super::series::Series;
use std::collections::BTreeSet;

/// The fewest points of a line.
pub const FEWEST_POINTS: usize = 16;

/// The bound may be this many times the largest error. Every instruction set has the same errors.
pub const SLACK: f64 = 2.0;

/// What is wrong with what a sweep measured, in words.
pub fn faults(sweep: &Sweep, lines: &[Series]) -> Vec<String> {
    let mut faults = Vec::new();
    let mut largest: f64 = 0.0;
    for Series { name, points } in lines {
        let distinct: BTreeSet<u64> = points.iter().map(|point| point.results).collect();
        if points.len() < FEWEST_POINTS {
            faults.push(format!("{name}: {} points, at least {FEWEST_POINTS}", points.len()));
        }
        if (distinct.len() as f64) < sweep.distinct * points.len() as f64 {
            let (found, all) = (distinct.len(), points.len());
            let share = 100.0 * sweep.distinct;
            faults.push(format!(
                "{name}: {found} different results at {all} points, at least {share:.0} %"
            ));
        }
        for point in points {
            largest = largest.max(point.error);
            if point.kept == 0 || (point.kept as f64) < sweep.kept * point.tried as f64 {
                let (kept, tried, at) = (point.kept, point.tried, point.parameter);
                let share = 100.0 * sweep.kept;
                faults.push(format!(
                    "{name}: {kept} of {tried} cases kept at {at:.3e}, at least {share:.0} %"
                ));
            }
            if point.error > sweep.bound {
                let (error, at) = (point.error, point.parameter);
                faults.push(format!(
                    "{name}: error {error:.3e} at {at:.3e}, bound {:.3e}",
                    sweep.bound
                ));
            }
        }
    }
    if lines.is_empty() {
        faults.push("no line".to_owned());
    }
    if sweep.bound > SLACK * largest {
        let bound = sweep.bound;
        faults.push(format!("bound {bound:.3e} is above {SLACK} times the error {largest:.3e}"));
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::super::series::{Compared, Point};
    use super::*;

    const SWEEP: Sweep = Sweep {
        name: "test",
        what: "",
        parameter: "",
        unit: "",
        bound: 1.0,
        why: "",
        breaks: "",
        kept: 0.5,
        distinct: 0.5,
        before: &[],
        run: || Ok(Vec::new()),
    };

    fn line(point: impl Fn(usize) -> Point) -> Vec<Series> {
        vec![Series { name: "line".to_owned(), points: (0..FEWEST_POINTS).map(point).collect() }]
    }

    fn point(error: f64, left_out: usize, result: f64) -> Point {
        let mut compared = Compared::new();
        compared.add(error, &[result]);
        (0..left_out).for_each(|_| compared.leave_out());
        compared.at(1.0)
    }

    #[test]
    fn each_fault_is_named() {
        assert_eq!(faults(&SWEEP, &line(|i| point(0.9, 1, i as f64))), Vec::<String>::new());
        let table = [
            (line(|i| point(1.1, 0, i as f64)), "bound 1.000e0"),
            (line(|i| point(f64::NAN, 0, i as f64)), "error inf"),
            (line(|i| point(0.9, 2, i as f64)), "1 of 3 cases kept"),
            (line(|i| point(0.9, 0, (i / 3) as f64)), "6 different results"),
            (line(|i| point(0.4, 0, i as f64)), "above 2 times"),
            (Vec::new(), "no line"),
        ];
        for (lines, words) in table {
            let faults = faults(&SWEEP, &lines);
            assert!(faults.iter().any(|fault| fault.contains(words)), "{words}: {faults:?}");
        }
        let mut short = line(|i| point(0.9, 0, i as f64));
        short[0].points.pop();
        assert!(faults(&SWEEP, &short)[0].contains("15 points"));
    }
}
