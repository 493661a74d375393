//! A context that takes turns with others on a thread.

use super::error::ProbeError;
use gl_api::constants::*;
use gl_api::context::{Context, ContextDesc};
use gl_api::*;
use rasterizer::driver::Device;
use std::sync::Arc;

/// A context with a square window, current only while work runs in it.
pub struct OwnContext {
    context: Option<Context>,
    side: usize,
}

impl OwnContext {
    /// A context of a device, of `side` × `side` pixels.
    ///
    /// # Errors
    /// When it cannot be made.
    pub fn new(device: &Arc<Device>, side: usize) -> Result<Self, ProbeError> {
        let desc = ContextDesc {
            width: side as u32,
            height: side as u32,
            device: Some(Arc::clone(device)),
            ..ContextDesc::default()
        };
        let context = Context::new(desc).map_err(|error| ProbeError::Context(error.to_string()))?;
        Ok(Self { context: Some(context), side })
    }

    /// Runs `work` in the context; `after` names it in an error.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn run<R>(
        &mut self,
        after: &'static str,
        work: impl FnOnce() -> R,
    ) -> Result<R, ProbeError> {
        let lost = || ProbeError::Context("the context was lost".to_owned());
        let current = self.context.take().ok_or_else(lost)?.make_current();
        let result = work();
        let code = glGetError();
        self.context = current.release();
        match code {
            GL_NO_ERROR => Ok(result),
            _ => {
                let messages = self.context.as_mut().map(Context::messages).unwrap_or_default();
                let message = messages.last().map(ToString::to_string).unwrap_or_default();
                Err(ProbeError::Gl { after, code, message })
            }
        }
    }

    /// The bytes of its window after `draw`, red, green, blue and alpha.
    ///
    /// # Errors
    /// As [`Self::run`].
    pub fn picture(
        &mut self,
        after: &'static str,
        draw: impl FnOnce(),
    ) -> Result<Vec<u8>, ProbeError> {
        let side = self.side;
        self.run(after, || {
            draw();
            let mut bytes = vec![0u8; side * side * 4];
            glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, &mut bytes);
            bytes
        })
    }
}
