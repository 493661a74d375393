//! Single fragments under the alpha test, the stencil test and a logical operation.

use super::error::ProbeError;
use super::session::Session;
use super::texture::compare_enum;
use crate::gl::*;
use crate::oracle::compare::Compare;
use crate::oracle::fragment::{Stencil, StencilOp};
use gl_api::constants::*;

impl Session {
    /// `glAlphaFunc` of a comparison with `reference`, and `GL_ALPHA_TEST`.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn alpha_test(&self, compare: Compare, reference: f32) -> Result<(), ProbeError> {
        glEnable(GL_ALPHA_TEST);
        glAlphaFunc(compare_enum(compare), reference);
        self.check("setting up the alpha test")
    }

    /// Binds a framebuffer of 4×4 pixels with depth and stencil.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn stencil_buffer(&self) -> Result<(), ProbeError> {
        let mut names = [0u32; 3];
        glGenFramebuffers(1, &mut names[0]);
        glGenRenderbuffers(2, &mut names[1..]);
        glBindFramebuffer(GL_FRAMEBUFFER, names[0]);
        for (name, format) in names[1..].iter().zip([GL_RGBA8, GL_DEPTH24_STENCIL8]) {
            glBindRenderbuffer(GL_RENDERBUFFER, *name);
            glRenderbufferStorage(GL_RENDERBUFFER, format, 4, 4);
        }
        let points = [
            (GL_COLOR_ATTACHMENT0, names[1]),
            (GL_DEPTH_ATTACHMENT, names[2]),
            (GL_STENCIL_ATTACHMENT, names[2]),
        ];
        for (point, name) in points {
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
        }
        glViewport(0, 0, 4, 4);
        glEnable(GL_STENCIL_TEST);
        glEnable(GL_DEPTH_TEST);
        self.check("making a stencil buffer")
    }

    /// The stencil value after a fragment, and 1 if it was drawn.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn stenciled(&self, of: &Stencil) -> Result<[f64; 4], ProbeError> {
        glStencilMask(0xff);
        glClearStencil(of.stored);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        glStencilFunc(compare_enum(of.compare), of.reference, of.mask);
        let [fail, depth_fail, pass] = of.operations.map(operation_enum);
        glStencilOp(fail, depth_fail, pass);
        glStencilMask(of.write_mask);
        glDepthFunc(if of.depth_passes { GL_LESS } else { GL_GREATER });
        glColor4f(1, 1, 1, 1);
        glBegin(GL_QUADS);
        for [x, y] in [[-1, -1], [1, -1], [1, 1], [-1, 1]] {
            glVertex2f(x, y);
        }
        glEnd();
        let (mut stencil, mut color) = ([0u8], [0u8; 4]);
        glReadPixels(1, 2, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &mut stencil);
        glReadPixels(1, 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut color);
        self.check("reading a stencil value")?;
        Ok([stencil[0].into(), f64::from(color[0]) / 255.0, 0.0, 0.0])
    }

    /// The result of a logical operation on pairs of bytes (source, destination).
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn logic_op(
        &self,
        operation: usize,
        pairs: &[[[u8; 4]; 2]],
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        glEnable(GL_COLOR_LOGIC_OP);
        let mut values = Vec::with_capacity(pairs.len());
        for [source, destination] in pairs {
            for (operation, color) in
                [(GL_COPY, destination), (GL_CLEAR + operation as u32, source)]
            {
                let [r, g, b, a] = *color;
                glLogicOp(operation);
                glColor4ub(r, g, b, a);
                glBegin(GL_TRIANGLES);
                for [x, y] in [[-1.0, -1.0], [-0.9, -1.0], [-1.0, -0.9f32]] {
                    glVertex2f(x, y);
                }
                glEnd();
            }
            values.push(self.read_square(1)?[0].map(f64::from));
        }
        Ok(values)
    }
}

/// GL's name of an operation.
pub fn operation_enum(operation: StencilOp) -> u32 {
    match operation {
        StencilOp::Keep => GL_KEEP,
        StencilOp::Zero => GL_ZERO,
        StencilOp::Replace => GL_REPLACE,
        StencilOp::Increment => GL_INCR,
        StencilOp::Decrement => GL_DECR,
        StencilOp::Invert => GL_INVERT,
        StencilOp::IncrementWrap => GL_INCR_WRAP,
        StencilOp::DecrementWrap => GL_DECR_WRAP,
    }
}
