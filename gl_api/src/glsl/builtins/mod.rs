//! What the language brings: functions, variables and constants, each a row of a table.

pub mod functions;
pub mod math;
pub mod variables;
