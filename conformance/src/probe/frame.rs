//! Framebuffers of any colour format and number of samples, and what is read from them.

use super::error::ProbeError;
use super::session::Session;
use crate::gl::*;
use gl_api::constants::*;

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

    /// As [`Session::frame`], with a buffer of depth, or of depth and stencil, which is cleared too.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn deep_frame(
        &self,
        internal: u32,
        depth: u32,
        [width, height]: [usize; 2],
        samples: usize,
    ) -> Result<(), ProbeError> {
        self.frame(internal, [width, height], samples)?;
        let mut renderbuffer = 0u32;
        glGenRenderbuffers(1, &mut renderbuffer);
        glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, depth, width, height);
        let stencil = matches!(depth, GL_DEPTH24_STENCIL8 | GL_DEPTH32F_STENCIL8);
        let point = if stencil { GL_DEPTH_STENCIL_ATTACHMENT } else { GL_DEPTH_ATTACHMENT };
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, renderbuffer);
        glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        self.begin_frame([width, height])
    }

    /// Adds a texture-less colour buffer to the framebuffer that is bound, at this attachment.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn add_color(
        &self,
        attachment: u32,
        internal: u32,
        [width, height]: [usize; 2],
    ) -> Result<(), ProbeError> {
        let mut renderbuffer = 0u32;
        glGenRenderbuffers(1, &mut renderbuffer);
        glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
        glRenderbufferStorage(GL_RENDERBUFFER, internal, width, height);
        let point = GL_COLOR_ATTACHMENT0 + attachment;
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, renderbuffer);
        self.check("adding a colour buffer")
    }

    /// Binds a new framebuffer as with [`Session::frame`] of one sample, copies the colours of the one that was
    /// bound to it, which resolves samples, and reads floats.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn read_resolved(
        &self,
        internal: u32,
        [width, height]: [usize; 2],
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        let mut source = [0i32; 1];
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &mut source);
        let scissor = glIsEnabled(GL_SCISSOR_TEST);
        glDisable(GL_SCISSOR_TEST);
        self.frame(internal, [width, height], 0)?;
        let mut target = [0i32; 1];
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &mut target);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, source[0]);
        let (w, h) = (width, height);
        glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, target[0]);
        let picture = self.read_floats([width, height])?;
        glBindFramebuffer(GL_FRAMEBUFFER, source[0]);
        if scissor {
            glEnable(GL_SCISSOR_TEST);
        }
        self.check("resolving")?;
        Ok(picture)
    }

    /// Depths in [0, 1], row by row from the lowest.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn read_depths(&self, [width, height]: [usize; 2]) -> Result<Vec<[f64; 4]>, ProbeError> {
        let mut depths = vec![0.0f32; width * height];
        glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, &mut depths);
        self.check("drawing and reading depths")?;
        Ok(depths.into_iter().map(|depth| [f64::from(depth), 0.0, 0.0, 0.0]).collect())
    }

    /// Depths in [0, 1] with 32 bits, or as floats where the buffer has floats, row by row from the lowest.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn read_depth_codes(&self, [width, height]: [usize; 2]) -> Result<Vec<f64>, ProbeError> {
        let mut kind = [0i32; 1];
        let (point, pname) = (GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE);
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, point, pname, &mut kind);
        if kind[0] == GL_FLOAT as i32 {
            return Ok(self.read_depths([width, height])?.iter().map(|depth| depth[0]).collect());
        }
        let mut codes = vec![0u32; width * height];
        glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &mut codes);
        self.check("drawing and reading depths")?;
        Ok(codes.into_iter().map(|code| f64::from(code) / f64::from(u32::MAX)).collect())
    }

    /// Stencil values, row by row from the lowest.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn read_stencil(&self, [width, height]: [usize; 2]) -> Result<Vec<[f64; 4]>, ProbeError> {
        let mut values = vec![0u8; width * height];
        glReadPixels(0, 0, width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &mut values);
        self.check("drawing and reading stencil values")?;
        Ok(values.into_iter().map(|value| [f64::from(value), 0.0, 0.0, 0.0]).collect())
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

    /// The framebuffer's colours as bytes of what it holds, in [0, 1].
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn read_bytes(&self, [width, height]: [usize; 2]) -> Result<Vec<[f64; 4]>, ProbeError> {
        let mut bytes = vec![[0u8; 4]; width * height];
        let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
        glReadPixels(0, 0, width, height, format, ty, bytes.as_flattened_mut());
        self.check("drawing and reading bytes")?;
        Ok(bytes.into_iter().map(|p| p.map(|c| f64::from(c) / 255.0)).collect())
    }

    /// Uses a fragment shader that writes to `count` targets, each half of the one before, the first the texel of unit 0.
    ///
    /// # Errors
    /// When it is rejected.
    pub fn show_textures(&self, count: usize) -> Result<(), ProbeError> {
        let writes: String = (0..count)
            .map(|i| format!("gl_FragData[{i}] = texel / float({});\n", 1 << i))
            .collect();
        self.fragment_only(&format!(
            "uniform sampler2D image;
            void main() {{
                vec4 texel = texture2D(image, gl_TexCoord[0].xy);
                {writes}
            }}"
        ))
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
