//! Assembly program objects: ARB_vertex_program, section 2.14.1.

use crate::assembly::layout::Row;
use crate::assembly::{Counts, Position, Target};
use crate::base::constants::*;
use crate::base::error::Table;
use crate::objects::Objects;
use crate::objects::bound::Bound;
use crate::objects::programs::Linked;
use std::sync::Arc;

const SECTION: &str = "ARB_vertex_program, section 2.14.1";

/// The targets that programs are bound to.
pub(crate) const TARGET: Table<Target> = Table {
    section: SECTION,
    rows: &[(GL_VERTEX_PROGRAM_ARB, Target::Vertex), (GL_FRAGMENT_PROGRAM_ARB, Target::Fragment)],
};

/// What draws run of an assembly program.
#[derive(Debug)]
pub(crate) struct AssemblyExecutable {
    pub linked: Linked,
    /// The words that a draw fills in beside the state, by their first words.
    pub rows: Vec<(u32, Row)>,
    pub counts: Counts,
    pub position: Position,
}

/// An assembly program.
#[derive(Debug)]
pub(crate) struct Assembly {
    pub target: Target,
    pub text: String,
    /// What draws run, once a text was loaded.
    pub loaded: Option<Arc<AssemblyExecutable>>,
    /// `program.local`, as far as it was set; the others are zeros.
    pub local: Vec<[f32; 4]>,
}

impl Assembly {
    /// A program without a text.
    pub fn new(target: Target) -> Self {
        Self { target, text: String::new(), loaded: None, local: Vec::new() }
    }
}

impl Objects {
    /// The referenced assembly program; if none is, the target's default one.
    pub fn assembly(&self, target: Target, bound: &Bound) -> &Assembly {
        self.shared.assemblies.bound(bound).unwrap_or(&self.default_assemblies[target as usize])
    }

    /// The referenced assembly program, to be changed.
    pub fn assembly_mut(&mut self, target: Target, bound: &Bound) -> &mut Assembly {
        self.shared
            .assemblies
            .bound_mut(bound)
            .unwrap_or(&mut self.default_assemblies[target as usize])
    }
}
