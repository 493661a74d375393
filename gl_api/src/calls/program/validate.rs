//! `glValidateProgram`: GL 2.1, section 2.15.4.

use crate::base::error::Result;
use crate::base::types::*;
use crate::calls::program::programs::program;
use crate::context::Context;
use crate::draw::validate::runnable;

pub(crate) fn validate_program(context: &mut Context, name: GLuint) -> Result<()> {
    let object = program(context, name)?;
    let problem = match object.linked() {
        None => Err(format!("program {name} is not linked: call glLinkProgram")),
        Some(linked) => runnable(linked),
    };
    object.validated = problem.is_ok();
    object.log = problem.err().map_or_else(String::new, |problem| format!("error: {problem}\n"));
    Ok(())
}
