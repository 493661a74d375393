//! Framebuffers of any colour format and number of samples, and what is read from them.

use super::error::ProbeError;
use super::session::Session;
use gl_api::constants::*;
use gl_api::entry::*;

impl Session {
    /// Binds a framebuffer of one renderbuffer, cleared to 0; its viewport is all of it.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn frame(
        &self,
        internal: u32,
        [width, height]: [usize; 2],
        samples: usize,
    ) -> Result<(), ProbeError> {
        let (mut framebuffer, mut renderbuffer) = (0u32, 0u32);
        glGenFramebuffers(1, &mut framebuffer);
        glGenRenderbuffers(1, &mut renderbuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, internal, width, height);
        let point = GL_COLOR_ATTACHMENT0;
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, renderbuffer);
        self.begin_frame([width, height])
    }

    /// Sets the viewport to the framebuffer that is bound, and clears it to 0.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn begin_frame(&self, [width, height]: [usize; 2]) -> Result<(), ProbeError> {
        glViewport(0, 0, width, height);
        let status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
        if status != GL_FRAMEBUFFER_COMPLETE {
            let message = enum_name(status);
            return Err(ProbeError::Gl { after: "making a framebuffer", code: status, message });
        }
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT);
        self.check("making a framebuffer")
    }

    /// The framebuffer's colours as floats, row by row from the lowest.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn read_floats(&self, [width, height]: [usize; 2]) -> Result<Vec<[f64; 4]>, ProbeError> {
        let mut texels = vec![[0.0f32; 4]; width * height];
        glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, texels.as_flattened_mut());
        self.check("drawing and reading floats")?;
        Ok(texels.into_iter().map(|texel| texel.map(f64::from)).collect())
    }

    /// The framebuffer's unsigned integers, row by row from the lowest.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn read_words(&self, [width, height]: [usize; 2]) -> Result<Vec<[u32; 4]>, ProbeError> {
        let mut texels = vec![[0u32; 4]; width * height];
        let (format, ty) = (GL_RGBA_INTEGER, GL_UNSIGNED_INT);
        glReadPixels(0, 0, width, height, format, ty, texels.as_flattened_mut());
        self.check("drawing and reading words")?;
        Ok(texels)
    }
}
