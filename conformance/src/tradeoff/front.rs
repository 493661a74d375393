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
    /// From where to where half of what was measured of the cost lies.
    pub quartiles: [f64; 2],
}

/// Errors below a step of a byte are not seen.
pub const UNSEEN: f64 = 1.0 / 255.0;

/// Errors that are no further apart, as part of the larger, are the same.
const SAME: f64 = 0.02;

/// What costs more than this many times as much as the cheapest is named for its error, and not advised.
const AFFORDABLE: f64 = 10.0;

/// Ratios nearer to 1 are not worth a word.
const WORTH_A_WORD: f64 = 1.1;

impl Weighed {
    /// Whether its error is less, by more than a trifle.
    fn is_more_exact_than(&self, other: &Self) -> bool {
        self.error < (1.0 - SAME) * other.error
    }

    /// Whether its cost is less, by more than it varies.
    fn is_cheaper_than(&self, other: &Self) -> bool {
        self.quartiles[1] < other.quartiles[0]
    }

    fn beats(&self, other: &Self) -> bool {
        let is_no_worse = !other.is_more_exact_than(self) && !other.is_cheaper_than(self);
        is_no_worse && (self.is_more_exact_than(other) || self.is_cheaper_than(other))
    }

    /// As good as another as far as is measured and seen.
    fn is_as_good_as(&self, other: &Self) -> bool {
        let both_unseen = self.error <= UNSEEN && other.error <= UNSEEN;
        (both_unseen || !other.is_more_exact_than(self)) && !other.is_cheaper_than(self)
    }

    /// What n×n samples leave as it is, which have 1/n of the error for n² times the cost: one with less of it gets further
    /// for its cost than another that is supersampled.
    fn weight(&self) -> f64 {
        self.error.max(UNSEEN).powi(2) * self.cost
    }
}

/// Of each, whether no other is better in error or cost, and no worse in the other.
pub fn is_on_front(all: &[Weighed]) -> Vec<bool> {
    all.iter().map(|one| !all.iter().any(|other| other.beats(one))).collect()
}

/// A ratio in as many digits as say something.
fn times(ratio: f64) -> String {
    if ratio < 9.95 { format!("{ratio:.1} times") } else { format!("{ratio:.0} times") }
}

/// One sentence: of the affordable part of the front, the alternative with the least product of squared error and cost; those
/// that are as good, what is cheaper, and what is more exact.
pub fn advice(all: &[Weighed], cost: &str) -> String {
    let fronts = is_on_front(all);
    let front = || all.iter().zip(&fronts).filter(|(_, is_on)| **is_on).map(|(one, _)| one);
    let cheapest = front().min_by(|a, b| a.cost.total_cmp(&b.cost));
    let most = cheapest.map_or(0.0, |cheap| AFFORDABLE * cheap.cost);
    let affordable = front().filter(|one| one.cost <= most);
    let Some(best) = affordable.min_by(|a, b| a.weight().total_cmp(&b.weight())) else {
        return "nothing was measured".to_owned();
    };
    let as_good: Vec<&str> = all
        .iter()
        .filter(|one| one.name != best.name && one.is_as_good_as(best))
        .map(|one| one.name.as_str())
        .collect();
    if all.len() > 1 && as_good.len() + 1 == all.len() {
        return "take any: no difference is seen or measured".to_owned();
    }
    let mut text = format!("take {}", best.name);
    if !as_good.is_empty() {
        text += &format!(" (as good: {})", as_good.join(", "));
    }
    if best.error <= UNSEEN && all.iter().any(|one| one.error > UNSEEN) {
        text += ", whose error is below a step of a byte";
    }
    if let Some(cheap) = cheapest
        && cheap.is_cheaper_than(best)
        && best.cost / cheap.cost >= WORTH_A_WORD
    {
        let (less, more) = (best.cost / cheap.cost, cheap.error / best.error.max(UNSEEN));
        let (less, more) = (times(less), times(more));
        text += &format!("; {} takes {less} less {cost}, for {more} the error", cheap.name);
    }
    let most_exact = front().min_by(|a, b| a.error.total_cmp(&b.error));
    if let Some(exact) = most_exact
        && best.error.max(UNSEEN) / exact.error.max(UNSEEN) >= WORTH_A_WORD
    {
        let (less, more) = (best.error / exact.error.max(UNSEEN), exact.cost / best.cost);
        let (less, more) = (times(less), times(more));
        text += &format!("; {} has {less} less error, for {more} the {cost}", exact.name);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An alternative whose cost varies by a hundredth.
    fn one(name: &str, error: f64, cost: f64) -> Weighed {
        let quartiles = [0.995 * cost, 1.005 * cost];
        Weighed { name: name.to_owned(), error, cost, quartiles }
    }

    #[test]
    fn what_is_beaten_is_not_on_the_front() {
        let all = [one("a", 0.4, 1.0), one("b", 0.1, 2.0), one("c", 0.2, 3.0), one("d", 0.05, 9.0)];
        assert_eq!(is_on_front(&all), [true, true, false, true]);
        // As good as the first, within what is measured.
        let all = [one("a", 0.4, 1.0), one("b", 0.401, 1.004), one("c", 0.4, 1.1)];
        assert_eq!(is_on_front(&all), [true, true, false]);
    }

    #[test]
    fn the_advice_is_what_is_worth_more_than_samples() {
        let all = [one("a", 0.4, 1.0), one("b", 0.1, 2.0), one("c", 0.2, 3.0), one("d", 0.05, 9.0)];
        assert_eq!(
            advice(&all, "time"),
            "take b; a takes 2.0 times less time, for 4.0 times the error; d has 2.0 times less \
             error, for 4.5 times the time"
        );
        assert_eq!(advice(&all[..1], "time"), "take a");
        assert_eq!(advice(&[], "time"), "nothing was measured");
        // Half the error for less than four times the cost, or for more.
        let half = |cost: f64| advice(&[one("a", 0.1, 1.0), one("b", 0.05, cost)], "time");
        assert!(half(3.9).starts_with("take b;"), "{}", half(3.9));
        assert!(half(4.1).starts_with("take a;"), "{}", half(4.1));
    }

    #[test]
    fn what_is_not_seen_costs_nothing() {
        let all = [one("a", 0.2, 1.0), one("b", 0.0031, 2.0), one("c", 0.0001, 11.0)];
        assert_eq!(
            advice(&all, "time"),
            "take b, whose error is below a step of a byte; a takes 2.0 times less time, for 51 \
             times the error"
        );
    }

    #[test]
    fn what_is_as_good_is_named() {
        let all = [one("a", 0.1, 1.0), one("b", 0.1, 1.002), one("c", 0.1, 3.0)];
        assert_eq!(advice(&all, "time"), "take a (as good: b)");
        assert_eq!(advice(&all[..2], "time"), "take any: no difference is seen or measured");
        let all =
            [one("a", 0.0, 1.0), one("b", 0.0, 1.001), one("c", 0.0, 1.002), one("d", 0.0, 2.0)];
        assert_eq!(advice(&all, "time"), "take a (as good: b, c)");
    }

    #[test]
    fn what_nobody_affords_is_named_only() {
        let all = [one("a", 0.2, 1.0), one("b", 0.1, 3.0), one("c", 0.004, 11.0)];
        assert_eq!(
            advice(&all, "time"),
            "take b; a takes 3.0 times less time, for 2.0 times the error; c has 25 times less \
             error, for 3.7 times the time"
        );
    }

    #[test]
    fn what_saves_nothing_is_no_alternative() {
        let all = [one("a", 0.4, 1.0), one("b", 0.1, 1.05)];
        assert_eq!(advice(&all, "time"), "take b");
    }
}
