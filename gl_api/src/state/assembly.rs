//! State of assembly programs: bindings and environment parameters (ARB_vertex_program, section 2.14.1).

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
    /// `program.env` by target, up to the last one that was set; the others are zeros.
    pub env: [Vec<[f32; 4]>; 2],
    /// The error in the last program text, and its position.
    pub error: Option<(GLint, &'static str)>,
}

/// The program parameters that a call names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scope {
    /// Environment parameters, of all programs of a target.
    Env,
    /// Local parameters, of the bound program.
    Local,
}

/// The index of the first of `count` parameters, which must be within the limit.
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
