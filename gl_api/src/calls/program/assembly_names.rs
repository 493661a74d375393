//! Assembly programs and their names: ARB_vertex_program, section 2.14.1.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::context::Context;
use crate::objects::assemblies::{Assembly, TARGET};
use crate::objects::name_table::{Sweep, listed};

const SECTION: &str = "ARB_vertex_program, section 2.14.1";

pub(crate) fn gen_programs(
    context: &mut Context,
    n: GLsizei,
    programs: &mut [GLuint],
) -> Result<()> {
    context.objects.shared.assemblies.reserve(SECTION, n, programs)
}

pub(crate) fn delete_programs(
    context: &mut Context,
    n: GLsizei,
    programs: &[GLuint],
) -> Result<()> {
    for &name in listed(SECTION, n, programs)?.iter().filter(|&&name| name != 0) {
        let gone = context.objects.shared.assemblies.hold(name);
        context.state.assembly.bound.iter_mut().for_each(|bound| bound.forget(&gone));
        drop(gone);
        context.objects.shared.assemblies.remove(name);
    }
    context.objects.shared.sweep(Sweep::Deleted);
    Ok(())
}

pub(crate) fn bind_program(context: &mut Context, target: GLenum, program: GLuint) -> Result<()> {
    let target = TARGET.decode("target", target)?;
    if let Some(object) = context.objects.shared.assemblies.get(program)
        && object.target != target
    {
        let was = enum_name(TARGET.encode(object.target));
        let rule = format!("program {program} was first bound to {was}, it is none of this target");
        return invalid_operation(SECTION, rule);
    }
    context.objects.shared.assemblies.create(program, || Assembly::new(target));
    context.state.assembly.bound[target as usize] = context.objects.shared.assemblies.hold(program);
    Ok(())
}

pub(crate) fn is_assembly_program(context: &mut Context, program: GLuint) -> Result<bool> {
    Ok(context.objects.shared.assemblies.get(program).is_some())
}
