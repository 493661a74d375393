//! The text and the parameters of programs: ARB_vertex_program, section 2.14.1;
//! EXT_gpu_program_parameters.

use crate::base::assembly_limits as limits;
use crate::base::error::{Result, invalid_value};
use crate::base::types::*;
use crate::objects::bound::Bound;

pub(crate) const SECTION: &str = "ARB_vertex_program, section 2.14.1";

/// The state of assembly programs.
#[derive(Debug, Default)]
pub(crate) struct AssemblyState {
    /// The programs that are bound, by target.
    pub bound: [Bound; 2],
    /// `program.env` by target, as far as it was set; the others are zeros.
    pub env: [Vec<[f32; 4]>; 2],
    /// What was wrong with the last text, and where.
    pub error: Option<(GLint, &'static str)>,
}

/// Whose parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scope {
    /// All programs' of the target.
    Env,
    /// The bound program's.
    Local,
}

/// The place of `count` parameters from `index` on.
pub(crate) fn checked(scope: Scope, index: GLuint, count: usize) -> Result<usize> {
    let (limit, name) = match scope {
        Scope::Env => (limits::MAX_ENV_PARAMETERS, "GL_MAX_PROGRAM_ENV_PARAMETERS_ARB"),
        Scope::Local => (limits::MAX_LOCAL_PARAMETERS, "GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB"),
    };
    if u64::from(index) + count as u64 > u64::from(limit) {
        return invalid_value(
            SECTION,
            format!("index = {index}: {count} parameters from there on go beyond {name}, {limit}"),
        );
    }
    Ok(index as usize)
}
