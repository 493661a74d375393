//! The results as tables, as JSON, and as HTML pages with plots.

mod case_pictures;
mod left_out;
pub mod page;
mod pages;
pub mod tables;

pub use left_out::{left_out_page, left_out_table};
pub use pages::{checks_page, sweeps_page, tradeoff_page};
pub use tables::{functions_table, json, sweeps_table, table, tradeoff_table, trials_table};
