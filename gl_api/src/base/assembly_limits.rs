//! Limits of assembly programs, which `glGetProgramivARB` reports.

/// `GL_MAX_PROGRAM_INSTRUCTIONS_ARB`, of arithmetic and of texture lookups too.
pub(crate) const MAX_INSTRUCTIONS: u32 = 4096;
/// `GL_MAX_PROGRAM_TEMPORARIES_ARB`.
pub(crate) const MAX_TEMPORARIES: u32 = 4096;
/// `GL_MAX_PROGRAM_PARAMETERS_ARB`.
pub(crate) const MAX_PARAMETERS: u32 = 4096;
/// `GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB`.
pub(crate) const MAX_LOCAL_PARAMETERS: u32 = 2048;
/// `GL_MAX_PROGRAM_ENV_PARAMETERS_ARB`.
pub(crate) const MAX_ENV_PARAMETERS: u32 = 256;
/// `GL_MAX_PROGRAM_ADDRESS_REGISTERS_ARB`, of vertex programs.
pub(crate) const MAX_ADDRESS_REGISTERS: u32 = 1;
/// `GL_MAX_PROGRAM_ATTRIBS_ARB` of fragment programs: two colours, coordinates, fog and position.
pub(crate) const MAX_FRAGMENT_ATTRIBS: u32 = 12;
/// `GL_MAX_PROGRAM_MATRICES_ARB`.
pub(crate) const MAX_PROGRAM_MATRICES: u8 = 8;
/// `GL_MAX_PROGRAM_MATRIX_STACK_DEPTH_ARB`.
pub(crate) const MAX_PROGRAM_MATRIX_STACK_DEPTH: usize = 4;
