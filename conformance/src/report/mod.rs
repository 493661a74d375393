//! The results as tables, as JSON, and as HTML pages with plots.

mod case_pictures;
mod closing;
mod layout;
mod left_out;
mod machine;
pub mod page;
mod pages;
pub mod tables;
mod terminal;

pub use closing::{Count, closing};
pub(crate) use layout::right;
pub use layout::{Layout, NARROW};
pub use left_out::{left_out_page, left_out_table};
pub use machine::{Machine, NOISY};
pub use page::{PageError, PageName};
pub use pages::{checks_page, sweeps_page, tradeoff_page, trials_page};
pub use tables::{
    choices_table, functions_table, json, sweeps_table, table, tradeoff_table, trials_table,
};
pub use terminal::{bar, listed};
