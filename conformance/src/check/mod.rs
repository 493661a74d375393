//! What a check is: its definition, the harness that runs it, the tally of errors, the outcome.

mod definition;
mod harness;
mod outcome;
mod tally;
mod unit;

pub use definition::Check;
pub use harness::{Effort, Harness, Subject};
pub use outcome::{Outcome, Verdict};
pub use tally::{ComparedCases, Reach, Tally};
pub use unit::Unit;
