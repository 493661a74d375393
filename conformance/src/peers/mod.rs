//! `conformance peers`: the same scenes through the same C functions, on DetGL's shared library and
//! on every other GL driver of the machine.
//!
//! A scene is data, a [`FrameDescription`](frame::FrameDescription). [`replay`] draws it with a driver, [`mod@reference`]
//! with the formulas. Every measurement runs in a process of its own, so that first frames and memory
//! belong to one driver only. The drivers alternate over several rounds, and their medians are
//! compared.

mod client;
mod comparison;
mod distance;
mod driver;
mod error;
mod frame;
mod median;
mod options;
pub mod process;
mod reference;
mod replay;
mod report;
mod scene;

pub use comparison::{Comparison, compare};
pub use error::PeersError;
pub use options::Options;
pub use report::{WriteError, table, write};

use scene::{Scene, scenes};

/// The scenes whose name contains `only`.
pub fn selected(only: &str) -> Vec<&'static Scene> {
    scenes().filter(|scene| scene.name.contains(only)).collect()
}

/// The names of all scenes.
pub fn names() -> Vec<&'static str> {
    scenes().map(|scene| scene.name).collect()
}
