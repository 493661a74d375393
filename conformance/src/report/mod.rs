//! The results as tables, as JSON, and as HTML pages with plots.

mod case_pictures;
pub mod page;
mod pages;
pub mod tables;

pub use pages::{checks_page, sweeps_page, tradeoff_page};
pub use tables::{functions_table, json, sweeps_table, table, tradeoff_table, trials_table};
