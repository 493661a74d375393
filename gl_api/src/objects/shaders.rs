//! Shader objects: GL 2.1, sections 2.15.1 and 6.1.14.

use crate::base::args::TextOut;
use crate::base::constants::*;
use crate::base::error::{Result, Table, not_negative};
use crate::base::types::*;
use crate::glsl;

const SECTION: &str = "GL 2.1, section 2.15.1";

/// A shader object.
#[derive(Debug)]
pub(crate) struct ShaderObject {
    pub stage: glsl::Stage,
    pub source: String,
    /// Where each of its strings but the first begins.
    pub strings: Vec<u32>,
    /// The result of the last successful compilation.
    pub compiled: Option<glsl::Shader>,
    pub log: String,
    /// How many programs it is attached to.
    pub attachments: usize,
    /// Whether it was deleted: it is removed once it is attached to no program.
    pub doomed: bool,
}

pub(crate) const STAGE: Table<glsl::Stage> = Table {
    section: SECTION,
    rows: &[
        (GL_VERTEX_SHADER, glsl::Stage::Vertex),
        (GL_GEOMETRY_SHADER, glsl::Stage::Geometry),
        (GL_FRAGMENT_SHADER, glsl::Stage::Fragment),
    ],
};

/// The length of a text with C's final zero; 0 for none.
pub(crate) fn c_length(text: &str) -> GLint {
    if text.is_empty() { 0 } else { GLint::try_from(text.len() + 1).unwrap_or(GLint::MAX) }
}

/// Writes text and its length as `glGet…InfoLog` and others do.
pub(crate) fn put_text(
    text: &str,
    max_length: GLsizei,
    length: &mut [GLsizei],
    out: TextOut<'_>,
) -> Result<()> {
    let limit = not_negative("GL 2.1, section 6.1.14", "maxLength", max_length.into())?;
    let written = out.write(text, limit);
    if let Some(length) = length.first_mut() {
        *length = written as GLsizei;
    }
    Ok(())
}
