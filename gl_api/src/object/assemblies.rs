//! Assembly programs and their names: ARB_vertex_program, section 2.14.1.

use super::bound::Bound;
use super::{Objects, Sweep, listed};
use crate::assembly::{Loaded, Target};
use crate::constants::*;
use crate::context::Context;
use crate::error::{Result, Table, invalid_operation};
use crate::types::*;
use std::sync::Arc;

const SECTION: &str = "ARB_vertex_program, section 2.14.1";

/// The targets that programs are bound to.
pub(crate) const TARGET: Table<Target> = Table {
    section: SECTION,
    rows: &[(GL_VERTEX_PROGRAM_ARB, Target::Vertex), (GL_FRAGMENT_PROGRAM_ARB, Target::Fragment)],
};

/// An assembly program.
#[derive(Debug)]
pub(crate) struct Assembly {
    pub target: Target,
    pub text: String,
    /// What draws run, once a text was loaded.
    pub loaded: Option<Arc<Loaded>>,
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
    /// The assembly program that is bound; if none is, the target's own.
    pub fn assembly(&self, target: Target, bound: &Bound) -> &Assembly {
        self.assemblies.bound(bound).unwrap_or(&self.default_assemblies[target as usize])
    }

    /// The assembly program that is bound, to be changed.
    pub fn assembly_mut(&mut self, target: Target, bound: &Bound) -> &mut Assembly {
        self.assemblies.bound_mut(bound).unwrap_or(&mut self.default_assemblies[target as usize])
    }
}

pub(crate) fn gen_programs(
    context: &mut Context,
    n: GLsizei,
    programs: &mut [GLuint],
) -> Result<()> {
    context.objects.assemblies.reserve(SECTION, n, programs)
}

pub(crate) fn delete_programs(
    context: &mut Context,
    n: GLsizei,
    programs: &[GLuint],
) -> Result<()> {
    for &name in listed(SECTION, n, programs)?.iter().filter(|&&name| name != 0) {
        let gone = context.objects.assemblies.hold(name);
        context.state.assembly.bound.iter_mut().for_each(|bound| bound.forget(&gone));
        drop(gone);
        context.objects.assemblies.remove(name);
    }
    context.objects.sweep(Sweep::Deleted);
    Ok(())
}

pub(crate) fn bind_program(context: &mut Context, target: GLenum, program: GLuint) -> Result<()> {
    let target = TARGET.decode("target", target)?;
    if let Some(object) = context.objects.assemblies.get(program)
        && object.target != target
    {
        let was = enum_name(TARGET.encode(object.target));
        let rule = format!("program {program} was first bound to {was}, it is none of this target");
        return invalid_operation(SECTION, rule);
    }
    context.objects.assemblies.create(program, || Assembly::new(target));
    context.state.assembly.bound[target as usize] = context.objects.assemblies.hold(program);
    Ok(())
}

pub(crate) fn is_assembly_program(context: &mut Context, program: GLuint) -> Result<bool> {
    Ok(context.objects.assemblies.get(program).is_some())
}
