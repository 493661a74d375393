//! What plans have in common: the work that they name.

use serde::Serialize;

/// How the plan of a feature compares with that of the plain scene.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub enum PlanFound {
    /// It names the same work.
    SameWork,
    /// The first line of work that only the feature's plan has.
    More(String),
}

impl PlanFound {
    /// Compares the plans of two frames.
    pub fn of(plain: &[String], asked: &[String]) -> Self {
        let (plain, asked) = (work(plain), work(asked));
        match asked.iter().find(|line| !plain.contains(line)) {
            Some(line) => Self::More(line.clone()),
            None => Self::SameWork,
        }
    }
}

/// The lines of plans that name work: without what is left out, and without figures of the source.
fn work(plans: &[String]) -> Vec<String> {
    plans.iter().flat_map(|plan| plan.lines()).filter_map(work_of).collect()
}

/// What a line of a plan names as work.
fn work_of(line: &str) -> Option<String> {
    let line = line.trim();
    let (subject, rest) = line.split_once(' ')?;
    let rest = rest.split("; left out: ").next().unwrap_or(rest).trim();
    match subject {
        // Why work is left out.
        "facts" => None,
        // How many statements the source had is not work.
        "vertex" | "fragment" if !rest.starts_with("left out") => {
            let from = rest.find(" optimized, ").map_or(0, |at| at + " optimized, ".len());
            let until = rest.find(", samples slot").unwrap_or(rest.len());
            let kept = &rest[from..until.max(from)];
            let instructions = kept.split(", ").next().unwrap_or(kept);
            Some(format!("{subject} {instructions}"))
        }
        _ if rest.starts_with("left out: blending") => Some(format!("{subject} stored")),
        _ if rest.contains("left out: ") => None,
        _ => Some(format!("{subject} {rest}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLAN: &str = "  fragment     9 statements, 8 optimized, 7 instructions, 5 registers, samples slot 0\n  \
                        texture 1    left out: not sampled\n";

    #[test]
    fn what_is_left_out_is_no_work() {
        let other = PLAN.replace("9 statements", "50 statements");
        let plain = PLAN.lines().next().unwrap_or_default().to_owned();
        assert_eq!(PlanFound::of(&[plain], &[other]), PlanFound::SameWork);
    }

    #[test]
    fn an_instruction_more_is_work() {
        let other = PLAN.replace("7 instructions", "8 instructions");
        let found = PlanFound::of(&[PLAN.to_owned()], &[other]);
        assert_eq!(found, PlanFound::More("fragment 8 instructions".to_owned()));
    }
}
