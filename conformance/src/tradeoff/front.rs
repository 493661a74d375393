//! What a table of errors and times says: which alternatives no other one beats, and one sentence of advice.

/// What the advice weighs of an alternative.
#[derive(Clone, Debug, PartialEq)]
pub struct Weighed {
    /// Its name.
    pub name: String,
    /// Its error.
    pub error: f64,
    /// Its cost: time, or memory.
    pub cost: f64,
}

/// Errors below are those of rounding a picture to bytes, which no alternative is without: 1/255/√12.
pub const BYTES: f64 = 0.0011;

/// Of each, whether no other has at most its error and at most its cost, and less of one.
pub fn is_on_front(all: &[Weighed]) -> Vec<bool> {
    let beats = |a: &Weighed, b: &Weighed| {
        a.error <= b.error && a.cost <= b.cost && (a.error < b.error || a.cost < b.cost)
    };
    all.iter().map(|one| !all.iter().any(|other| beats(other, one))).collect()
}

/// One sentence: of the front, the alternative with the least product of error and cost, what is cheaper, and what is more
/// exact. Halving the error is worth twice the cost.
pub fn advice(all: &[Weighed], cost: &str) -> String {
    let fronts = is_on_front(all);
    let mut front: Vec<&Weighed> =
        all.iter().zip(&fronts).filter(|(_, is_on)| **is_on).map(|(one, _)| one).collect();
    front.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    let product = |one: &Weighed| one.error.max(BYTES) * one.cost;
    let Some(&best) = front.iter().min_by(|a, b| product(a).total_cmp(&product(b))) else {
        return "nothing was measured".to_owned();
    };
    let mut text = format!("take {}", best.name);
    if let Some(cheap) = front.first().filter(|cheap| cheap.cost < best.cost) {
        let (less, more) = (best.cost / cheap.cost, cheap.error / best.error.max(BYTES));
        text += &format!(
            "; {} costs {less:.1} times less {cost}, for {more:.1} times the error",
            cheap.name
        );
    }
    if let Some(exact) =
        front.last().filter(|exact| exact.error < best.error && exact.cost > best.cost)
    {
        let (more, less) = (exact.cost / best.cost, best.error / exact.error.max(BYTES));
        if less > 1.05 {
            text += &format!(
                "; {} has {less:.1} times less error, for {more:.1} times the {cost}",
                exact.name
            );
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one(name: &str, error: f64, cost: f64) -> Weighed {
        Weighed { name: name.to_owned(), error, cost }
    }

    #[test]
    fn what_is_beaten_is_not_on_the_front() {
        let all = [one("a", 0.4, 1.0), one("b", 0.1, 2.0), one("c", 0.2, 3.0), one("d", 0.05, 9.0)];
        assert_eq!(is_on_front(&all), [true, true, false, true]);
    }

    #[test]
    fn the_least_product_is_advised() {
        let all = [one("a", 0.4, 1.0), one("b", 0.1, 2.0), one("c", 0.2, 3.0), one("d", 0.05, 9.0)];
        assert_eq!(
            advice(&all, "time"),
            "take b; a costs 2.0 times less time, for 4.0 times the error; \
             d has 2.0 times less error, for 4.5 times the time"
        );
        assert_eq!(advice(&all[..1], "time"), "take a");
    }
}
