//! The optimizer: passes over the structured IR, each in its own file. Every pass keeps the bits,
//! but [`affine`] and [`gradients`], which make them better; what they do depends on the modules alone.
//!
//! | pass | does |
//! |---|---|
//! | [`powers`] | powers with a constant exponent become functions of one number |
//! | [`scopes`] | early returns become `else` |
//! | [`simplify`] | one walk in program order: [`fold`] constants, [`forward`] stores to loads, share [`common`] values, take branches that are decided, [`unroll`] loops that are counted |
//! | [`arrays`] | arrays that are only indexed by constants become scalars |
//! | [`flatten`] | small branches become selects |
//! | [`stores`] | stores that are overwritten before anybody reads them go |
//! | [`dead`] | what no output depends on goes |
//! | [`byte_functions`] | functions of the bytes of a texel become tables, where a draw's textures are known |
//! | [`affine`] | what fragments make of varyings by affine maps moves to the vertices |
//! | [`gradients`] | the level of detail of a varying's lookup from the varying's planes |
//! | [`sides`] | selects between varyings by facing become one varying |
//!
//! What depends on uniform words only is split off later, by [`super::preamble`].

mod affine;
mod arrays;
pub(super) mod byte_functions;
mod common;
mod dead;
mod flatten;
mod fold;
mod forward;
mod gradients;
mod powers;
mod scopes;
mod sides;
mod simplify;
mod stores;
mod unroll;

pub(super) use affine::hoist_to_vertex;
pub(crate) use sides::SideVaryings;

use super::{Facts, LevelOfDetail};
use crate::ir::Module;

/// How often the passes that make work for each other are repeated at most.
const ROUNDS: usize = 6;

/// Optimizes a valid module in place, by itself.
pub(super) fn optimize(module: &mut Module) {
    powers::run(module);
    scopes::run(module);
    for _ in 0..ROUNDS {
        simplify::run(module, &Facts::NONE);
        dead::run(module);
        let split = arrays::run(module);
        let flattened = flatten::run(module);
        if !split && !flattened {
            break;
        }
    }
    stores::run(module);
    dead::run(module);
}

/// Optimizes a finished module again by what is known of a draw.
pub(super) fn specialize(module: &mut Module, facts: &Facts) {
    for _ in 0..ROUNDS {
        simplify::run(module, facts);
        dead::run(module);
        if !flatten::run(module) {
            break;
        }
    }
    stores::run(module);
    byte_functions::run(module, facts);
    dead::run(module);
}

/// Makes one varying of those that are selected by facing; nothing may look for varyings' gradients after it.
pub(super) fn merge_sides(module: &mut Module) -> Vec<SideVaryings> {
    sides::run(module)
}

/// The final passes.
pub(super) fn finish(module: &mut Module, lod: LevelOfDetail) {
    if gradients::run(module, lod) {
        simplify::run(module, &Facts::NONE);
        dead::run(module);
    }
}
