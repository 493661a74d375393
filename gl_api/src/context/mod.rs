//! The context: all state, all objects, and the driver they are drawn with.

pub(crate) mod counting;
pub(crate) mod feedback;
pub(crate) mod raster_passed;
pub(crate) mod swap;

pub(crate) mod bitmaps;
pub(crate) mod draw_note;
pub(crate) mod ended;
pub(crate) mod immediate;
pub(crate) mod lists;
pub(crate) mod presence;
pub(crate) mod recorder;
pub(crate) mod sharing;
pub(crate) mod watched;
pub(crate) mod window;

mod changes;
pub(crate) mod debug;
pub(crate) mod log;
pub(crate) mod mirror;
pub(crate) mod said;
mod surface;

use crate::base::error::{GlError, Result};
use crate::context::ended::Ended;
use crate::context::feedback::Feedback;
use crate::context::immediate::Immediate;
use crate::context::lists::{Compiling, Lists};
use crate::context::recorder::Recorder;
use crate::context::sharing::{Entered, Group, Invitation, Shared};
use crate::context::watched::Watched;
use crate::context::window::Window;
use crate::glsl::FixIts;
use crate::objects::Objects;
use crate::objects::queries::ActiveQueries;
use crate::state::State;
use crate::state::attrib::AttribStacks;
use crate::state::evaluate::Maps;
use crate::state::transform_feedback::TransformFeedback;
use crate::state::uniform_buffers::UniformBuffers;
use changes::Changes;
pub use debug::{Message, Severity};
pub use log::GLDEBUGPROC;
use mirror::Mirror;
use rasterizer::driver::{Device, DeviceDesc, DeviceError};
use std::sync::{Arc, OnceLock};
pub use surface::{SurfaceColor, SurfaceDesc};
use texunit::lanes::FloatEnv;
use thiserror::Error;

/// What a context is made from.
#[derive(Clone, Debug)]
pub struct ContextDesc {
    /// Pixels across of the default framebuffer, 1 to 8192.
    pub width: u32,
    /// Pixels up of the default framebuffer, 1 to 8192.
    pub height: u32,
    /// Whether the GLSL compiler applies the fixes it suggests.
    pub fix_its: FixIts,
    /// The device; `None` shares one that the environment describes.
    pub device: Option<Arc<Device>>,
    /// What the default framebuffer has.
    pub surface: SurfaceDesc,
}

impl Default for ContextDesc {
    fn default() -> Self {
        let surface = SurfaceDesc::default();
        Self { width: 512, height: 512, fix_its: FixIts::Suggest, device: None, surface }
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
    /// The default framebuffer cannot have so many bits or samples.
    #[error("{0:?}: at most 32 bits of depth and 8 of stencil, and 1, 2 or 4 samples")]
    Surface(SurfaceDesc),
    /// There is no memory for the default framebuffer.
    #[error("no memory for the default framebuffer")]
    Memory,
    /// The device cannot be made.
    #[error(transparent)]
    Device(#[from] DeviceError),
}

/// A GL context, with a default framebuffer of its own ([`SurfaceDesc`]).
///
/// Every entry point is a method, named without `gl` and in snake case; the free functions with
/// GL's names work on the thread's current context (see [`Context::make_current`]).
#[derive(Debug)]
pub struct Context {
    pub(crate) state: State,
    pub(crate) objects: Objects,
    pub(crate) window: Window,
    /// What the default framebuffer is read from, if not from `window`.
    pub(crate) read_window: Option<Window>,
    pub(crate) debug: debug::Debug,
    /// Which hints were given.
    said: said::Said,
    /// Between `glBegin` and `glEnd`.
    pub(crate) immediate: Option<Immediate>,
    /// What ended and is not drawn yet, as more like it may follow.
    pub(crate) ended: Option<Ended>,
    pub(crate) recorder: Recorder,
    /// Display lists, and the one that is being compiled.
    pub(crate) lists: Lists,
    pub(crate) compiling: Option<Compiling>,
    pub(crate) attribs: AttribStacks,
    pub(crate) queries: ActiveQueries,
    /// The control points of evaluators.
    pub(crate) evaluators: Maps,
    /// Selection and feedback.
    pub(crate) feedback: Feedback,
    pub(crate) transform_feedback: TransformFeedback,
    pub(crate) uniform_buffers: UniformBuffers,
    /// The contexts that this one shares objects with.
    group: Option<Group>,
    /// Where another thread asks for the group.
    pub(crate) invitation: Invitation,
    pub(crate) changes: Changes,
    /// Whether a call runs.
    pub(crate) entered: Entered,
    pub(crate) fix_its: FixIts,
    /// The client memory that shows the picture.
    pub(crate) mirror: Option<Mirror>,
    /// The pixel that is watched.
    pub(crate) watched: Option<Box<Watched>>,
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
        let _float_env = FloatEnv::enter();
        let fix_its = desc.fix_its;
        let (device, window) = Self::parts(desc)?;
        Ok(Self::assemble(device, window, fix_its, None))
    }

    /// What a context is made of that there may not be.
    fn parts(desc: ContextDesc) -> Result<(Arc<Device>, Window), ContextError> {
        let ContextDesc { width, height, fix_its: _, device, surface } = desc;
        let limit = crate::base::limits::MAX_VIEWPORT_DIMS;
        if !(1..=limit).contains(&width) || !(1..=limit).contains(&height) {
            return Err(ContextError::Size { width, height, limit });
        }
        if !surface.is_possible() {
            return Err(ContextError::Surface(surface));
        }
        let device = match device {
            Some(device) => device,
            None => shared_device()?,
        };
        let window = Window::new(width, height, surface).map_err(|_| ContextError::Memory)?;
        Ok((device, window))
    }

    /// Puts a context together; viewport and scissor have the window's size.
    fn assemble(
        device: Arc<Device>,
        window: Window,
        fix_its: FixIts,
        group: Option<Group>,
    ) -> Self {
        Self {
            state: State::new(window.width, window.height),
            objects: Objects::default(),
            window,
            read_window: None,
            debug: debug::Debug::from_env(device.desc()),
            said: said::Said::default(),
            immediate: None,
            ended: None,
            recorder: Recorder::new(device),
            lists: Lists::default(),
            compiling: None,
            attribs: AttribStacks::default(),
            queries: ActiveQueries::default(),
            evaluators: Maps::default(),
            feedback: Feedback::default(),
            transform_feedback: TransformFeedback::default(),
            uniform_buffers: UniformBuffers::default(),
            group,
            invitation: Invitation::default(),
            changes: Changes::default(),
            entered: Entered::No,
            fix_its,
            mirror: None,
            watched: None,
        }
    }

    /// As [`Context::new`], sharing what another context gave with [`Self::share`]. On the heap: a
    /// context is too large to be moved about on the stack of a client's thread, where there may be
    /// as little as 128 KB.
    #[inline(never)]
    pub(crate) fn boxed(
        desc: ContextDesc,
        shared: Option<Shared>,
    ) -> Result<Box<Self>, ContextError> {
        let _float_env = FloatEnv::enter();
        let fix_its = desc.fix_its;
        let (group, device) = shared.map(|shared| (shared.group, shared.device)).unzip();
        let (device, window) = Self::parts(ContextDesc { device: desc.device.or(device), ..desc })?;
        Ok(Box::new(Self::assemble(device, window, fix_its, group)))
    }

    /// What a new context needs to share this one's objects, where nothing is recorded; no call of another context is waited for.
    pub(crate) fn shared(&mut self) -> Shared {
        let objects = &mut self.objects;
        let group = self.group.get_or_insert_with(|| Group::of(objects)).clone();
        Shared { group, device: self.recorder.device() }
    }

    /// Takes the messages that have gathered, oldest first.
    pub fn messages(&mut self) -> Vec<Message> {
        self.debug.drain()
    }

    /// Width and height of the default framebuffer.
    pub fn size(&self) -> (u32, u32) {
        (self.window.width, self.window.height)
    }

    /// Whether no other context shares its objects.
    pub(crate) fn is_alone(&self) -> bool {
        self.group.is_none()
    }

    /// The group whose objects a call has to fetch.
    pub(crate) fn group_outside(&self) -> Option<&Group> {
        self.group.as_ref().filter(|_| self.entered == Entered::No)
    }

    /// Takes note of an error.
    #[cold]
    #[inline(never)]
    pub(crate) fn refuse(&mut self, name: &'static str, error: GlError) {
        self.debug.error(name, &error);
    }
}
