//! Programs of several stages, and what they capture by transform feedback.

use super::error::ProbeError;
use super::session::Session;
use super::shader::compile;
use crate::gl::*;
use crate::oracle::painter::Mode;
use gl_api::constants::*;

/// The sources of a program, without the line of the version; an empty one is a stage that is not
/// there.
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "the stages' names")]
pub struct Stages<'a> {
    pub vertex: &'a str,
    pub geometry: &'a str,
    pub fragment: &'a str,
}

/// What a program captures.
#[derive(Clone, Copy, Debug)]
pub struct Capture<'a> {
    /// The program.
    pub stages: Stages<'a>,
    /// The outputs, one after the other.
    pub names: &'a [&'a str],
    /// `GL_POINTS`, `GL_LINES` or `GL_TRIANGLES`.
    pub primitives: u32,
    /// The size of the buffer in words.
    pub capacity: usize,
}

/// What was captured.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Captured {
    /// All words of the buffer; [`Captured::UNTOUCHED`] where nothing was written.
    pub words: Vec<u32>,
    /// `GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN`.
    pub written: u32,
}

impl Captured {
    /// What the buffer holds before.
    pub const UNTOUCHED: u32 = 0xdead_beef;
}

impl Session {
    /// Compiles, links and uses a program, with a vertex array object bound.
    ///
    /// # Errors
    /// With the info log, when it is rejected.
    pub fn stages(&self, stages: &Stages<'_>) -> Result<u32, ProbeError> {
        self.program_of(stages, &[])
    }

    /// A program of a vertex shader whose outputs go to a buffer each, with a vertex array object bound.
    ///
    /// # Errors
    /// With the info log, when it is rejected.
    pub fn feedback_program(&self, vertex: &str, outputs: &[&str]) -> Result<u32, ProbeError> {
        let name = self.program_of(&Stages { vertex, geometry: "", fragment: "" }, &[])?;
        glTransformFeedbackVaryings(name, outputs.len(), outputs, GL_SEPARATE_ATTRIBS);
        self.link_program(name)?;
        Ok(name)
    }

    fn program_of(&self, stages: &Stages<'_>, captured: &[&str]) -> Result<u32, ProbeError> {
        let mut array = 0u32;
        glGenVertexArrays(1, &mut array);
        glBindVertexArray(array);
        let name = glCreateProgram();
        for (kind, stage, source) in [
            (GL_VERTEX_SHADER, "vertex shader", stages.vertex),
            (GL_GEOMETRY_SHADER, "geometry shader", stages.geometry),
            (GL_FRAGMENT_SHADER, "fragment shader", stages.fragment),
        ] {
            if !source.is_empty() {
                compile(name, kind, stage, &format!("{}{source}", self.dialect.head()))?;
            }
        }
        if !captured.is_empty() {
            glTransformFeedbackVaryings(name, captured.len(), captured, GL_INTERLEAVED_ATTRIBS);
        }
        self.link_program(name)?;
        glUseProgram(name);
        self.check("using a program")?;
        Ok(name)
    }

    /// Specifies an array of floats, a component after the other, from a new buffer.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn float_array(&self, index: u32, size: usize, data: &[f32]) -> Result<(), ProbeError> {
        new_buffer(GL_ARRAY_BUFFER);
        glBufferData(GL_ARRAY_BUFFER, size_of_val(data), data, GL_STATIC_DRAW);
        glVertexAttribPointer(index, size, GL_FLOAT, false, 0, BUFFER_OFFSET(0));
        glEnableVertexAttribArray(index);
        self.check("specifying an array of floats")
    }

    /// Specifies an array of unsigned integers from a new buffer.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn word_array(&self, index: u32, size: usize, data: &[u32]) -> Result<(), ProbeError> {
        new_buffer(GL_ARRAY_BUFFER);
        glBufferData(GL_ARRAY_BUFFER, size_of_val(data), data, GL_STATIC_DRAW);
        glVertexAttribIPointer(index, size, GL_UNSIGNED_INT, 0, BUFFER_OFFSET(0));
        glEnableVertexAttribArray(index);
        self.check("specifying an array of words")
    }

    /// Binds indices from a new buffer.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn indices(&self, data: &[u8]) -> Result<(), ProbeError> {
        new_buffer(GL_ELEMENT_ARRAY_BUFFER);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, data.len(), data, GL_STATIC_DRAW);
        self.check("specifying indices")
    }

    /// What a program captures of draws. `draw` is called with the program in use.
    ///
    /// # Errors
    /// When a call sets the error flag or the program is rejected.
    pub fn captured(
        &self,
        capture: &Capture<'_>,
        draw: impl FnOnce(u32) -> Result<(), ProbeError>,
    ) -> Result<Captured, ProbeError> {
        let program = self.program_of(&capture.stages, capture.names)?;
        let untouched = vec![Captured::UNTOUCHED; capture.capacity];
        let (target, bytes) = (GL_TRANSFORM_FEEDBACK_BUFFER, capture.capacity * 4);
        let (mut buffer, mut query) = (0u32, 0u32);
        glGenBuffers(1, &mut buffer);
        glGenQueries(1, &mut query);
        glBindBuffer(target, buffer);
        glBufferData(target, bytes, &untouched, GL_STATIC_READ);
        glBindBufferBase(target, 0, buffer);
        glEnable(GL_RASTERIZER_DISCARD);
        glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, query);
        glBeginTransformFeedback(capture.primitives);
        draw(program)?;
        glEndTransformFeedback();
        glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
        glDisable(GL_RASTERIZER_DISCARD);
        let (mut words, mut written) = (untouched, 0u32);
        glGetBufferSubData(target, 0, bytes, words.as_mut_slice());
        glGetQueryObjectuiv(query, GL_QUERY_RESULT, &mut written);
        self.check("capturing a draw")?;
        Ok(Captured { words, written })
    }
}

fn new_buffer(target: u32) {
    let mut buffer = 0u32;
    glGenBuffers(1, &mut buffer);
    glBindBuffer(target, buffer);
}

/// GL's name of a mode.
pub fn mode_enum(mode: Mode) -> u32 {
    match mode {
        Mode::Points => GL_POINTS,
        Mode::Lines => GL_LINES,
        Mode::LineStrip => GL_LINE_STRIP,
        Mode::LineLoop => GL_LINE_LOOP,
        Mode::Triangles => GL_TRIANGLES,
        Mode::TriangleStrip => GL_TRIANGLE_STRIP,
        Mode::TriangleFan => GL_TRIANGLE_FAN,
        Mode::LinesAdjacency => GL_LINES_ADJACENCY,
        Mode::LineStripAdjacency => GL_LINE_STRIP_ADJACENCY,
        Mode::TrianglesAdjacency => GL_TRIANGLES_ADJACENCY,
        Mode::TriangleStripAdjacency => GL_TRIANGLE_STRIP_ADJACENCY,
        Mode::Quads => GL_QUADS,
        Mode::QuadStrip => GL_QUAD_STRIP,
        Mode::Polygon => GL_POLYGON,
    }
}
