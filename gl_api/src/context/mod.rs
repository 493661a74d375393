//! The context: all state, all objects, and the driver they are drawn with.

pub(crate) mod debug;
pub(crate) mod limits;

use crate::draw::Recorder;
use crate::draw::immediate::Immediate;
use crate::entry::{Fallback, Place};
use crate::error::{GlError, Result, invalid_operation};
use crate::framebuffer::{Buffers, Window};
use crate::glsl::Repairs;
use crate::object::Objects;
use crate::state::State;
pub use debug::{Message, Severity};
use rasterizer::driver::{Device, DeviceDesc, DeviceError};
use std::sync::{Arc, OnceLock};
use thiserror::Error;

/// What a context is made from.
#[derive(Clone, Debug)]
pub struct ContextDesc {
    /// Pixels across of the default framebuffer, 1 to 8192.
    pub width: u32,
    /// Pixels up of the default framebuffer, 1 to 8192.
    pub height: u32,
    /// Whether the GLSL compiler applies the fixes it suggests.
    pub repairs: Repairs,
    /// The device; `None` shares one that the environment describes.
    pub device: Option<Arc<Device>>,
}

impl Default for ContextDesc {
    fn default() -> Self {
        Self { width: 512, height: 512, repairs: Repairs::Off, device: None }
    }
}

/// A context that cannot be made.
#[derive(Debug, Error)]
pub enum ContextError {
    /// The default framebuffer cannot have this size.
    #[error("a default framebuffer of {width}×{height} pixels: both sides must be 1 to {limit}")]
    Size {
        /// Pixels across.
        width: u32,
        /// Pixels up.
        height: u32,
        /// The largest side.
        limit: u32,
    },
    /// There is no memory for the default framebuffer.
    #[error("no memory for the default framebuffer")]
    Memory,
    /// The device cannot be made.
    #[error(transparent)]
    Device(#[from] DeviceError),
}

/// A GL context, with a default framebuffer of its own (RGBA8 and 24 bits of depth).
///
/// Every entry point is a method, named without `gl` and in snake case; the free functions with
/// GL's names work on the thread's current context (see [`Context::make_current`]).
#[derive(Debug)]
pub struct Context {
    pub(crate) state: State,
    pub(crate) objects: Objects,
    pub(crate) window: Window,
    pub(crate) debug: debug::Debug,
    /// Between `glBegin` and `glEnd`.
    pub(crate) immediate: Option<Immediate>,
    pub(crate) recorder: Recorder,
    pub(crate) repairs: Repairs,
}

/// The device that contexts share which bring none.
fn shared_device() -> Result<Arc<Device>, DeviceError> {
    static SHARED: OnceLock<Arc<Device>> = OnceLock::new();
    if let Some(device) = SHARED.get() {
        return Ok(Arc::clone(device));
    }
    let device = Arc::new(Device::new(DeviceDesc::from_env()?)?);
    Ok(Arc::clone(SHARED.get_or_init(|| device)))
}

impl Context {
    /// A context in its initial state.
    ///
    /// # Errors
    /// When the size is out of range or the device cannot be made.
    pub fn new(desc: ContextDesc) -> Result<Self, ContextError> {
        let ContextDesc { width, height, repairs, device } = desc;
        let limit = limits::MAX_VIEWPORT_DIMS;
        if !(1..=limit).contains(&width) || !(1..=limit).contains(&height) {
            return Err(ContextError::Size { width, height, limit });
        }
        let device = match device {
            Some(device) => device,
            None => shared_device()?,
        };
        Ok(Self {
            state: State::new(width, height),
            objects: Objects::default(),
            window: Window::new(width, height, Buffers::DEFAULT).map_err(|_| ContextError::Memory)?,
            debug: debug::Debug::from_env(),
            immediate: None,
            recorder: Recorder::new(device),
            repairs,
        })
    }

    /// Takes the messages that have gathered, oldest first.
    pub fn messages(&mut self) -> Vec<Message> {
        self.debug.drain()
    }

    /// Width and height of the default framebuffer.
    pub fn size(&self) -> (u32, u32) {
        (self.window.width, self.window.height)
    }

    /// Runs the entry point `name`: an error sets the flag and says why.
    pub(crate) fn call<R: Fallback>(
        &mut self,
        name: &'static str,
        place: Place,
        f: impl FnOnce(&mut Self) -> Result<R>,
    ) -> R {
        let result = match place {
            Place::Outside if self.immediate.is_some() => invalid_operation(
                "GL 2.1, section 2.6.3",
                "must not be called between glBegin and glEnd",
            ),
            Place::Outside | Place::Anywhere => f(self),
        };
        result.unwrap_or_else(|error: GlError| {
            self.debug.error(name, &error);
            R::fallback()
        })
    }
}
