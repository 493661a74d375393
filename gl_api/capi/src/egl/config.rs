//! The configs (EGL 1.5, section 3.4).

use super::constants::*;
use super::error::{Code, Result, fail};
use super::raw::{Handle, Id, Int};
use gl_api::host::limits::MAX_VIEWPORT_DIMS;
use gl_api::{SurfaceColor, SurfaceDesc};

/// What a default framebuffer has; sizes in bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Config {
    pub id: Int,
    pub alpha: Int,
    pub depth: Int,
    pub stencil: Int,
    pub samples: Int,
}

/// The APIs that draw to surfaces of every config.
const CLIENT_APIS: Int = EGL_OPENGL_BIT | EGL_OPENGL_ES2_BIT | EGL_OPENGL_ES3_BIT;

/// Bits of alpha, with 8 each of red, green and blue.
const ALPHA: [Int; 2] = [8, 0];
/// Bits of depth and stencil.
const DEPTH_STENCIL: [(Int, Int); 5] = [(24, 8), (24, 0), (16, 0), (0, 8), (0, 0)];
/// Samples of a pixel; 0 is not multisampled.
const SAMPLES: [Int; 2] = [0, 4];
const COUNT: usize = ALPHA.len() * DEPTH_STENCIL.len() * SAMPLES.len();

/// Every config: all combinations; `id` counts from 1.
pub(super) static CONFIGS: [Config; COUNT] = {
    let mut configs = [Config { id: 0, alpha: 0, depth: 0, stencil: 0, samples: 0 }; COUNT];
    let mut at = 0;
    while at < COUNT {
        let (depth, stencil) = DEPTH_STENCIL[at % DEPTH_STENCIL.len()];
        let at_color = at / DEPTH_STENCIL.len();
        let alpha = ALPHA[at_color % ALPHA.len()];
        let samples = SAMPLES[at_color / ALPHA.len()];
        configs[at] = Config { id: at as Int + 1, alpha, depth, stencil, samples };
        at += 1;
    }
    configs
};

impl Config {
    /// By its handle.
    pub fn find(config: Handle) -> Result<&'static Self> {
        let id = config.addr();
        match CONFIGS.iter().find(|config| config.handle_id() == id) {
            Some(config) => Ok(config),
            None => fail(
                Code::BadConfig,
                format!("config = {id:#x} is none that eglChooseConfig or eglGetConfigs gave"),
            ),
        }
    }

    /// What the default framebuffer is made of.
    pub fn surface(&self) -> SurfaceDesc {
        SurfaceDesc {
            color: if self.alpha > 0 { SurfaceColor::Rgba8 } else { SurfaceColor::Rgb8 },
            depth_bits: self.depth as u8,
            stencil_bits: self.stencil as u8,
            samples: self.samples as u8,
        }
    }

    pub fn handle_id(&self) -> Id {
        0x100 + self.id as Id
    }

    /// An attribute's value; `None` if there is none of that name.
    pub fn get(&self, attribute: Int) -> Option<Int> {
        Some(match attribute {
            EGL_BUFFER_SIZE => 24 + self.alpha,
            EGL_RED_SIZE | EGL_GREEN_SIZE | EGL_BLUE_SIZE => 8,
            EGL_ALPHA_SIZE => self.alpha,
            EGL_DEPTH_SIZE => self.depth,
            EGL_STENCIL_SIZE => self.stencil,
            EGL_SAMPLE_BUFFERS => Int::from(self.samples > 0),
            EGL_SAMPLES => self.samples,
            EGL_CONFIG_ID => self.id,
            EGL_COLOR_BUFFER_TYPE => EGL_RGB_BUFFER,
            EGL_COLOR_COMPONENT_TYPE_EXT => EGL_COLOR_COMPONENT_TYPE_FIXED_EXT,
            EGL_CONFIG_CAVEAT | EGL_TRANSPARENT_TYPE | EGL_NATIVE_VISUAL_TYPE => EGL_NONE,
            EGL_CONFORMANT | EGL_RENDERABLE_TYPE => CLIENT_APIS,
            EGL_SURFACE_TYPE => EGL_PBUFFER_BIT,
            EGL_MAX_PBUFFER_WIDTH | EGL_MAX_PBUFFER_HEIGHT => MAX_VIEWPORT_DIMS as Int,
            EGL_MAX_PBUFFER_PIXELS => (MAX_VIEWPORT_DIMS * MAX_VIEWPORT_DIMS) as Int,
            EGL_LUMINANCE_SIZE
            | EGL_ALPHA_MASK_SIZE
            | EGL_BIND_TO_TEXTURE_RGB
            | EGL_BIND_TO_TEXTURE_RGBA
            | EGL_LEVEL
            | EGL_MAX_SWAP_INTERVAL
            | EGL_MIN_SWAP_INTERVAL
            | EGL_NATIVE_RENDERABLE
            | EGL_NATIVE_VISUAL_ID
            | EGL_TRANSPARENT_RED_VALUE
            | EGL_TRANSPARENT_GREEN_VALUE
            | EGL_TRANSPARENT_BLUE_VALUE => 0,
            _ => return None,
        })
    }
}
