//! What the language brings: its functions and variables as rows of tables.

pub mod functions;
pub mod lookups;
pub mod math;
pub mod matrix;
mod noise;
pub mod state;
mod table;
pub mod variables;
