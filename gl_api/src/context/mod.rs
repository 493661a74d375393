//! The context: all state, all objects, and the driver they are drawn with.

pub(crate) mod debug;
pub(crate) mod depth_history;
pub(crate) mod feedback;
pub(crate) mod immediate;
pub(crate) mod lists;
pub(crate) mod log;
pub(crate) mod mirror;
pub(crate) mod pending_bitmaps;
pub(crate) mod pending_primitives;
pub(crate) mod profile;
pub(crate) mod program_in_use;
pub(crate) mod recorder;
pub(crate) mod reset;
pub(crate) mod sharing;
mod state_changes;
mod surface;
mod unoptimized;
mod unread;
pub(crate) mod warnings;
pub(crate) mod watched_pixel;
pub(crate) mod window;

use crate::base::availability::{Api, Version};
use crate::base::error::{GlError, Result};
use crate::context::feedback::Feedback;
use crate::context::immediate::Immediate;
use crate::context::lists::{Compiling, Lists};
use crate::context::pending_primitives::{PendingPrimitives, PendingState};
use crate::context::recorder::Recorder;
use crate::context::sharing::ShareHandle;
use crate::context::watched_pixel::WatchedPixel;
use crate::context::window::Window;
use crate::glsl::{self, FixIts, Strictness};
use crate::objects::Objects;
use crate::objects::queries::ActiveQueries;
use crate::objects::shared::ShareGroup;
use crate::state::State;
use crate::state::attrib::AttribStacks;
use crate::state::evaluators::EvaluatorMaps;
use crate::state::transform_feedback::{TransformFeedback, TransformFeedbackObjects};
use crate::state::uniform_buffers::UniformBuffers;
pub use debug::{Message, Severity};
pub use log::GLDEBUGPROC;
use mirror::Mirror;
pub use profile::ForwardCompatible;
use profile::Profile;
use rasterizer::driver::{Device, DeviceDesc, DeviceError};
pub use reset::ResetNotification;
use reset::Resets;
use state_changes::StateChanges;
use std::sync::{Arc, OnceLock};
pub use surface::{SurfaceColor, SurfaceDesc};
use texunit::lanes::FloatEnv;
use thiserror::Error;

/// How a context is to be made.
#[derive(Clone, Debug)]
pub struct ContextDesc {
    /// The API: [`Api::Compatibility`] has everything that any version of OpenGL had, [`Api::Core`] is without what
    /// later versions removed, [`Api::Es2`] is OpenGL ES.
    pub api: Api,
    /// The version that is asked for, at most 3.3, and 3.0 of OpenGL ES. Contexts of all versions are of the latest one.
    pub version: Version,
    /// Whether the context is without what is deprecated.
    pub forward_compatible: ForwardCompatible,
    /// Pixels across of the default framebuffer, 1 to 8192.
    pub width: u32,
    /// Pixels up of the default framebuffer, 1 to 8192.
    pub height: u32,
    /// Whether the GLSL compiler applies the fixes it suggests.
    pub fix_its: FixIts,
    /// Whether the GLSL compiler accepts, with a warning, what a shader's version does not have and
    /// all drivers accept: `##` before GLSL 1.30, lines continued by a backslash, the suffix `f` in
    /// GLSL 1.10, undefined names in conditions, late `#extension`, and some functions.
    pub strictness: Strictness,
    /// The device; `None` shares one that the environment describes.
    pub device: Option<Arc<Device>>,
    /// The buffers of the default framebuffer.
    pub surface: SurfaceDesc,
    /// How long the shaders of a draw may run ([`DeviceDesc::budget`]); `None` is the budget of the device.
    pub draw_budget: Option<u64>,
    /// What is reported of draws that exceed it.
    pub reset_notification: ResetNotification,
}

impl Default for ContextDesc {
    fn default() -> Self {
        let surface = SurfaceDesc::default();
        let (fix_its, strictness) = (FixIts::Suggest, Strictness::Lenient);
        let (device, draw_budget) = (None, None);
        Self {
            api: Api::Compatibility,
            version: Version::new(1, 0),
            forward_compatible: ForwardCompatible::No,
            width: 512,
            height: 512,
            fix_its,
            strictness,
            device,
            surface,
            draw_budget,
            reset_notification: ResetNotification::Never,
        }
    }
}

impl ContextDesc {
    /// The options of its GLSL compiler.
    fn compiler(&self, profile: Profile) -> glsl::Options {
        let context = profile.language();
        glsl::Options { fix_its: self.fix_its, strictness: self.strictness, context }
    }
}

/// A context that cannot be made.
#[derive(Debug, Error)]
#[non_exhaustive]
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
    /// There is no such version.
    #[error(
        "OpenGL {asked} was asked for; DetGL has {most} (DETGL_GL_VERSION={asked} lets programs start that \
         use nothing later)"
    )]
    Version {
        /// What was asked for.
        asked: Version,
        /// The latest.
        most: Version,
    },
    /// There is no such API.
    #[error("{0:?} was asked for; DetGL has Api::Compatibility, Api::Core and Api::Es2")]
    Api(Api),
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
    pub(crate) profile: Profile,
    pub(crate) state: State,
    pub(crate) objects: Objects,
    pub(crate) window: Window,
    /// What the default framebuffer is read from, if not from `window`.
    pub(crate) read_window: Option<Window>,
    pub(crate) debug: debug::Debug,
    pub(crate) resets: Resets,
    /// The draw warnings that were given.
    given_warnings: warnings::GivenWarnings,
    /// The attributes that were set outside of `glBegin` and `glEnd`, bit by location, for warnings.
    pub(crate) attributes_set: u64,
    /// The units whose targets were enabled or disabled by the client at any time, bit by unit, for warnings.
    pub(crate) units_switched: u8,
    /// The vertices since `glBegin`; `None` outside of `glBegin` and `glEnd`.
    pub(crate) immediate: Option<Immediate>,
    /// Primitives after `glEnd`, and bitmaps, that wait to be batched with more.
    pub(crate) pending: Option<PendingPrimitives>,
    /// The plain state that pending vertices are drawn with, if setters may have changed it since.
    pub(crate) pending_state: Option<PendingState>,
    pub(crate) recorder: Recorder,
    /// Display lists, and the one that is being compiled.
    pub(crate) lists: Lists,
    pub(crate) compiling: Option<Compiling>,
    pub(crate) attribs: AttribStacks,
    pub(crate) queries: ActiveQueries,
    /// The control points of evaluators.
    pub(crate) evaluators: EvaluatorMaps,
    /// Selection and feedback.
    pub(crate) feedback: Feedback,
    pub(crate) transform_feedback: TransformFeedback,
    pub(crate) transform_feedback_objects: TransformFeedbackObjects,
    pub(crate) uniform_buffers: UniformBuffers,
    pub(crate) state_changes: StateChanges,
    pub(crate) compiler: glsl::Options,
    /// The client memory that gets the picture.
    pub(crate) mirror: Option<Mirror>,
    /// The pixel that is watched.
    pub(crate) watched: Option<Box<WatchedPixel>>,
}

/// The device of contexts that are made without one.
fn shared_device() -> Result<Arc<Device>, DeviceError> {
    static SHARED: OnceLock<Arc<Device>> = OnceLock::new();
    if let Some(device) = SHARED.get() {
        return Ok(Arc::clone(device));
    }
    let device = Arc::new(Device::new(DeviceDesc::from_env()?)?);
    Ok(Arc::clone(SHARED.get_or_init(|| device)))
}

/// The calls that take a picture. Where one is refused, no later one may come that says what is wrong.
const PICTURES: [&str; 2] = ["glReadPixels", "glReadnPixels"];

impl Context {
    /// A context in its initial state.
    ///
    /// # Errors
    /// When the size is out of range or the device cannot be made.
    pub fn new(desc: ContextDesc) -> Result<Self, ContextError> {
        let _float_env = FloatEnv::enter();
        let profile = Profile::of(&desc)?;
        let (compiler, draw_budget, resets) =
            (desc.compiler(profile), desc.draw_budget, Resets::new(desc.reset_notification));
        let (device, window) = Self::parts(desc)?;
        let mut context =
            Self::assemble(device, window, (profile, compiler), ShareGroup::default());
        context.recorder.draw_budget = draw_budget;
        context.resets = resets;
        context.begin_with_profile();
        Ok(context)
    }

    /// The parts that may fail to be made: the device and the default framebuffer.
    fn parts(desc: ContextDesc) -> Result<(Arc<Device>, Window), ContextError> {
        let ContextDesc { width, height, device, surface, .. } = desc;
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
        (profile, compiler): (Profile, glsl::Options),
        group: ShareGroup,
    ) -> Self {
        Self {
            profile,
            state: State::new(window.width, window.height),
            objects: Objects::new(group),
            window,
            read_window: None,
            debug: debug::Debug::from_env(device.desc()),
            resets: Resets::new(ResetNotification::Never),
            given_warnings: warnings::GivenWarnings::default(),
            attributes_set: 0,
            units_switched: 0,
            immediate: None,
            pending: None,
            pending_state: None,
            recorder: Recorder::new(device),
            lists: Lists::default(),
            compiling: None,
            attribs: AttribStacks::default(),
            queries: ActiveQueries::default(),
            evaluators: EvaluatorMaps::default(),
            feedback: Feedback::default(),
            transform_feedback: TransformFeedback::default(),
            transform_feedback_objects: TransformFeedbackObjects::default(),
            uniform_buffers: UniformBuffers::default(),
            state_changes: StateChanges::default(),
            compiler,
            mirror: None,
            watched: None,
        }
    }

    /// As [`Context::new`], in the group of [`Self::share`]. On the heap: a
    /// context is too large to be moved about on the stack of a client's thread, where there may be
    /// as little as 128 KB.
    #[inline(never)]
    pub(crate) fn boxed(
        desc: ContextDesc,
        shared: Option<ShareHandle>,
    ) -> Result<Box<Self>, ContextError> {
        let _float_env = FloatEnv::enter();
        let profile = Profile::of(&desc)?;
        let (compiler, draw_budget, resets) =
            (desc.compiler(profile), desc.draw_budget, Resets::new(desc.reset_notification));
        let (group, device) = match shared {
            Some(ShareHandle { group, device }) => (group.join(), Some(device)),
            None => (ShareGroup::default(), None),
        };
        let (device, window) = Self::parts(ContextDesc { device: desc.device.or(device), ..desc })?;
        let mut context = Box::new(Self::assemble(device, window, (profile, compiler), group));
        context.recorder.draw_budget = draw_budget;
        context.resets = resets;
        context.begin_with_profile();
        Ok(context)
    }

    /// What a new context needs to share this one's objects. Takes no lock.
    pub(crate) fn share(&self) -> ShareHandle {
        ShareHandle { group: self.objects.shared.group().clone(), device: self.recorder.device() }
    }

    /// Takes the queued messages, oldest first.
    pub fn messages(&mut self) -> Vec<Message> {
        self.debug.drain()
    }

    /// Width and height of the default framebuffer.
    pub fn size(&self) -> (u32, u32) {
        (self.window.width, self.window.height)
    }

    /// Reports an error of a call: the flag and the message.
    #[cold]
    #[inline(never)]
    pub(crate) fn refuse(&mut self, name: &'static str, error: GlError) {
        self.debug.error(name, &error);
        if PICTURES.contains(&name) {
            self.debug.end_of_frame();
        }
    }
}
