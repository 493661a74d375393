//! A GL context, and draws in it.

use super::error::ProbeError;
use super::pack;
use super::picture::{CELLS, FIELD, SIZE, cell_corners, cell_values};
use super::program::{Precision, Program};
use crate::gl::*;
use gl_api::constants::*;
use gl_api::context::ContextDesc;
use gl_api::{Api, Version};
use std::time::Instant;

/// A vertex: clip coordinates, and the three vectors that the shaders call `a`, `b` and `c`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Clip x, y, z, w.
    pub position: [f32; 4],
    /// Interpolated to the fragments.
    pub inputs: [[f32; 4]; 3],
}

/// The API of a context, and the language of its shaders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialect {
    /// OpenGL 3.3 with what later versions removed.
    Compatibility,
    /// OpenGL 3.3 core, GLSL 3.30.
    Core,
    /// OpenGL ES 3.0, GLSL ES 3.00.
    Es,
}

impl Dialect {
    fn desc(self) -> ContextDesc {
        let side = FIELD as u32;
        let (api, version) = match self {
            Self::Compatibility => (Api::Compatibility, ContextDesc::default().version),
            Self::Core => (Api::Core, Version::new(3, 3)),
            Self::Es => (Api::Es2, Version::new(3, 0)),
        };
        ContextDesc { api, version, width: side, height: side, ..ContextDesc::default() }
    }

    /// The first lines of a shader.
    pub(super) fn head(self) -> &'static str {
        match self {
            Self::Compatibility => {
                "#version 330 compatibility\n#extension GL_ARB_texture_gather : enable\n"
            }
            Self::Core => "#version 330 core\n#extension GL_ARB_texture_gather : enable\n",
            Self::Es => {
                "#version 300 es\nprecision highp float;\nprecision highp int;\n\
                 precision highp sampler2D;\nprecision highp isampler2D;\n\
                 precision highp usampler2D;\nprecision highp sampler2DArray;\n"
            }
        }
    }
}

/// A context that is current on this thread until the session is dropped.
#[derive(Debug)]
pub struct Session {
    pub(super) dialect: Dialect,
    _current: CurrentContext,
}

impl Session {
    /// Makes a new context in its initial state current; the viewport has [`SIZE`] × [`SIZE`] pixels.
    ///
    /// # Errors
    /// When the context cannot be made, or has an error already.
    pub fn open() -> Result<Self, ProbeError> {
        Self::open_in(Dialect::Compatibility)
    }

    /// As [`Session::open`], of this API.
    ///
    /// # Errors
    /// When the context cannot be made, or has an error already.
    pub fn open_in(dialect: Dialect) -> Result<Self, ProbeError> {
        let current = open(dialect.desc()).map_err(ProbeError::Context)?;
        let session = Self { dialect, _current: current };
        glViewport(0, 0, SIZE, SIZE);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        session.check("opening a context")?;
        Ok(session)
    }

    /// Checks the error flag.
    ///
    /// # Errors
    /// When it is set.
    pub fn check(&self, after: &'static str) -> Result<(), ProbeError> {
        match glGetError() {
            GL_NO_ERROR => Ok(()),
            code => Err(ProbeError::Gl { after, code, message: last_error() }),
        }
    }

    /// Sets the window depths of the near and far planes.
    pub fn depth_range(&self, [near, far]: [f64; 2]) {
        glDepthRange(near, far);
    }

    /// The value of each cell; all vertices of its quad have the same `inputs`.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn cells(
        &self,
        program: &Program,
        inputs: &[[[f32; 4]; 3]],
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        let mut values = Vec::with_capacity(inputs.len());
        for chunk in inputs.chunks(CELLS * CELLS) {
            let vertices: Vec<Vertex> = chunk
                .iter()
                .enumerate()
                .flat_map(|(k, &inputs)| {
                    cell_corners(k).map(|[x, y]| Vertex { position: [x, y, 0.0, 1.0], inputs })
                })
                .collect();
            let picture = self.draw(program, GL_QUADS, &vertices)?;
            values.extend(cell_values(&picture).take(chunk.len()));
        }
        Ok(values)
    }

    /// The picture of triangles, row by row from the lowest.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn triangles(
        &self,
        program: &Program,
        vertices: &[Vertex],
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        self.draw(program, GL_TRIANGLES, vertices)
    }

    /// Nanoseconds a pixel of a square over the whole picture: the minimum of several draws.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn nanoseconds(&self, program: &Program) -> Result<f64, ProbeError> {
        let corner = |x: f32, y: f32| Vertex {
            position: [x, y, 0.0, 1.0],
            inputs: [[0.7 + 0.2 * x, 0.6 - 0.3 * y, 0.5 + 0.1 * x * y, 0.4 - 0.2 * x]; 3],
        };
        let square = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        glUseProgram(program.name);
        glViewport(0, 0, FIELD, FIELD);
        let mut fastest = f64::INFINITY;
        for _ in 0..8 {
            let start = Instant::now();
            immediate(GL_QUADS, &square);
            glFinish();
            fastest = fastest.min(start.elapsed().as_secs_f64());
        }
        glViewport(0, 0, SIZE, SIZE);
        self.check("timing a shader")?;
        Ok(fastest * 1e9 / (FIELD * FIELD) as f64)
    }

    fn draw(
        &self,
        program: &Program,
        mode: u32,
        vertices: &[Vertex],
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        glUseProgram(program.name);
        match program.precision {
            Precision::Bytes => {
                immediate(mode, vertices);
                self.read_components()
            }
            Precision::Exact { components } => {
                let mut picture = vec![[0.0; 4]; SIZE * SIZE];
                let location = glGetUniformLocation(program.name, "component");
                for component in 0..components {
                    let mut select = [0.0f32; 4];
                    select[component] = 1.0;
                    glUniform4f(location, select[0], select[1], select[2], select[3]);
                    immediate(mode, vertices);
                    for (value, pixel) in picture.iter_mut().zip(self.read()?) {
                        value[component] = pack::unpack(pixel);
                    }
                }
                Ok(picture)
            }
        }
    }

    /// The picture as RGBA in [0, 1].
    pub(super) fn read_components(&self) -> Result<Vec<[f64; 4]>, ProbeError> {
        Ok(self.read()?.into_iter().map(|p| p.map(|c| f64::from(c) / 255.0)).collect())
    }

    /// The picture as RGBA bytes.
    pub(super) fn read(&self) -> Result<Vec<[u8; 4]>, ProbeError> {
        self.read_square(SIZE)
    }

    /// The lower left `side` × `side` pixels as RGBA bytes.
    pub(super) fn read_square(&self, side: usize) -> Result<Vec<[u8; 4]>, ProbeError> {
        let mut bytes = vec![0u8; side * side * 4];
        glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, &mut bytes);
        self.check("drawing and reading")?;
        Ok(bytes.chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect())
    }
}

pub(super) fn immediate(mode: u32, vertices: &[Vertex]) {
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(mode);
    for Vertex { position: [x, y, z, w], inputs } in vertices {
        for (unit, [s, t, r, q]) in [GL_TEXTURE0, GL_TEXTURE1, GL_TEXTURE2].iter().zip(inputs) {
            glMultiTexCoord4f(*unit, *s, *t, *r, *q);
        }
        glVertex4f(*x, *y, *z, *w);
    }
    glEnd();
}
