//! The context: all state, all objects, and the driver they are drawn with.

mod arithmetic;
mod changes;
pub(crate) mod debug;
pub(crate) mod limits;
pub(crate) mod log;
pub(crate) mod log_calls;
pub(crate) mod said;
mod surface;

use crate::abi::osmesa::Mirror;
use crate::draw::Recorder;
use crate::draw::ended::{Ended, draw_ended};
use crate::draw::immediate::Immediate;
use crate::entry::{Fallback, Place};
use crate::error::{ErrorCode, GlError, Result};
use crate::evaluate::Maps;
use crate::explain::Watched;
use crate::feedback::Feedback;
use crate::framebuffer::Window;
use crate::glsl::FixIts;
use crate::list::{Compiling, Lists};
use crate::object::Objects;
use crate::object::queries::ActiveQueries;
use crate::object::sharing::{Entered, Group, Invitation, Shared, Turn};
use crate::state::State;
use crate::state::attrib::AttribStacks;
use crate::transform_feedback::TransformFeedback;
use crate::uniform_buffer::UniformBuffers;
use changes::Changes;
pub use debug::{Message, Severity};
pub use log::GLDEBUGPROC;
use rasterizer::driver::{Device, DeviceDesc, DeviceError};
use std::sync::{Arc, OnceLock};
pub use surface::{SurfaceColor, SurfaceDesc};
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
    /// Where an OSMesa client wants the picture.
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
        let fix_its = desc.fix_its;
        let (device, window) = Self::parts(desc)?;
        Ok(Self::assemble(device, window, fix_its, None))
    }

    /// What a context is made of that there may not be.
    fn parts(desc: ContextDesc) -> Result<(Arc<Device>, Window), ContextError> {
        let ContextDesc { width, height, fix_its: _, device, surface } = desc;
        let limit = limits::MAX_VIEWPORT_DIMS;
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

    /// A context that shares textures, samplers, buffers, renderbuffers, shaders, programs and
    /// display lists with this one (GL 2.1, appendix D), and its device unless `desc` has one. The
    /// two may be current on different threads; their calls take turns.
    ///
    /// # Errors
    /// As [`Context::new`].
    pub fn new_shared(&mut self, desc: ContextDesc) -> Result<Self, ContextError> {
        Self::boxed(desc, Some(self.share())).map(|context| *context)
    }

    /// As [`Context::new`], sharing what another context gave with [`Self::share`]. On the heap: a
    /// context is too large to be moved about on the stack of a client's thread, where there may be
    /// as little as 128 KB.
    #[inline(never)]
    pub(crate) fn boxed(
        desc: ContextDesc,
        shared: Option<Shared>,
    ) -> Result<Box<Self>, ContextError> {
        let fix_its = desc.fix_its;
        let (group, device) = shared.map(|shared| (shared.group, shared.device)).unzip();
        let (device, window) = Self::parts(ContextDesc { device: desc.device.or(device), ..desc })?;
        Ok(Box::new(Self::assemble(device, window, fix_its, group)))
    }

    /// What a new context needs to share this one's objects.
    pub(crate) fn share(&mut self) -> Shared {
        // What was recorded is drawn before another thread can change what it reads.
        self.flush();
        self.shared()
    }

    /// As [`Self::share`], where nothing is recorded; no call of another context is waited for.
    pub(crate) fn shared(&mut self) -> Shared {
        let objects = &mut self.objects;
        let group = self.group.get_or_insert_with(|| Group::of(objects)).clone();
        Shared { group, device: self.recorder.device() }
    }

    /// Gives another thread what it waits for. Not within a call, whose objects are in use.
    pub(crate) fn answer_invitation(&mut self) {
        if self.invitation.is_open() {
            let shared = self.share();
            self.invitation.answer(shared);
        }
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
        let turn = Turn::begin(self);
        let result = match place {
            Place::Outside if !turn.context.leave_vertices(name) => Ok(R::fallback()),
            Place::Outside | Place::Anywhere => f(turn.context),
        };
        drop(turn);
        let result = result.unwrap_or_else(|error: GlError| {
            self.refuse(name, error);
            R::fallback()
        });
        self.debug.deliver();
        result
    }

    /// Before a call that may not stand between `glBegin` and `glEnd`: what ended is drawn with the
    /// state of now. Whether the call may follow.
    #[inline(never)]
    fn leave_vertices(&mut self, name: &'static str) -> bool {
        if self.immediate.is_some() {
            self.refuse(name, between_begin_and_end());
            return false;
        }
        if self.ended.as_ref().is_some_and(|ended| !ended.outlasts(name)) {
            draw_ended(self);
        }
        self.changes.count();
        true
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

#[cold]
#[inline(never)]
fn between_begin_and_end() -> GlError {
    GlError::new(
        ErrorCode::InvalidOperation,
        "GL 2.1, section 2.6.3",
        "must not be called between glBegin and glEnd",
    )
}
