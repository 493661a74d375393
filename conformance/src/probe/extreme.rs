//! Measurements that only sweeps need: depth buffers, layers of blending, matrix stacks.

use super::blend::{BlendState, set_blend};
use super::error::ProbeError;
use super::session::Session;
use crate::gl::*;
use gl_api::constants::*;

/// The format of a depth buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DepthBuffer {
    /// `GL_DEPTH_COMPONENT16`.
    Bits16,
    /// `GL_DEPTH_COMPONENT24`.
    Bits24,
    /// `GL_DEPTH_COMPONENT32F`.
    Float,
}

impl DepthBuffer {
    /// The name in legends.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bits16 => "16 bits",
            Self::Bits24 => "24 bits",
            Self::Float => "32-bit float",
        }
    }
}

/// A call that changes the current matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MatrixStep {
    /// `glRotated`: degrees and axis.
    Rotate(f64, [f64; 3]),
    /// `glScaled`.
    Scale([f64; 3]),
}

impl Session {
    /// Binds a framebuffer of 4×4 pixels with this depth buffer.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn depth_buffer(&self, buffer: DepthBuffer) -> Result<(), ProbeError> {
        let format = match buffer {
            DepthBuffer::Bits16 => GL_DEPTH_COMPONENT16,
            DepthBuffer::Bits24 => GL_DEPTH_COMPONENT24,
            DepthBuffer::Float => GL_DEPTH_COMPONENT32F,
        };
        let mut names = [0u32; 3];
        glGenFramebuffers(1, &mut names[0]);
        glGenRenderbuffers(2, &mut names[1..]);
        glBindFramebuffer(GL_FRAMEBUFFER, names[0]);
        let attachments = [(GL_COLOR_ATTACHMENT0, GL_RGBA8), (GL_DEPTH_ATTACHMENT, format)];
        for (name, (point, format)) in names[1..].iter().zip(attachments) {
            glBindRenderbuffer(GL_RENDERBUFFER, *name);
            glRenderbufferStorage(GL_RENDERBUFFER, format, 4, 4);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, *name);
        }
        glViewport(0, 0, 4, 4);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_ALWAYS);
        self.check("making a depth buffer")
    }

    /// The stored depth after a square with clip coordinates z and w is drawn over the framebuffer.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn kept_depth(&self, z: f32, w: f32) -> Result<f64, ProbeError> {
        glBegin(GL_QUADS);
        for [x, y] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0f32]] {
            glVertex4f(x * w, y * w, z, w);
        }
        glEnd();
        let mut depth = [0.0f32];
        glReadPixels(1, 2, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &mut depth);
        self.check("reading a depth")?;
        Ok(depth[0].into())
    }

    /// Clears the picture to transparent black and sets the blend state of [`Session::layers`].
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn begin_layers(&self, state: &BlendState) -> Result<(), ProbeError> {
        glClear(GL_COLOR_BUFFER_BIT);
        set_blend(state);
        glEnable(GL_BLEND);
        self.check("setting up blending")
    }

    /// Blends layers of these colours over a pixel and returns its colour.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn layers(&self, colors: &[[f32; 4]]) -> Result<[f64; 4], ProbeError> {
        glBegin(GL_TRIANGLES);
        for &[r, g, b, a] in colors {
            glColor4f(r, g, b, a);
            glVertex2f(-1, -1);
            glVertex2f(-0.9, -1);
            glVertex2f(-1, -0.9);
        }
        glEnd();
        Ok(self.read_square(1)?[0].map(|c| f64::from(c) / 255.0))
    }

    /// The model-view matrix, column by column, after these calls; it is the identity before.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn model_view(&self, steps: &[MatrixStep]) -> Result<[f32; 16], ProbeError> {
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        for step in steps {
            glPushMatrix();
            match *step {
                MatrixStep::Rotate(angle, [x, y, z]) => glRotated(angle, x, y, z),
                MatrixStep::Scale([x, y, z]) => glScaled(x, y, z),
            }
        }
        let mut matrix = [0.0f32; 16];
        glGetFloatv(GL_MODELVIEW_MATRIX, &mut matrix);
        self.check("multiplying matrices")?;
        Ok(matrix)
    }
}
