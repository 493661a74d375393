//! The attribute stacks: `glPushAttrib`, GL 2.1, section 6.1.17 and the attribute groups of tables 6.5 to 6.37. Groups
//! of client state are in [`super::client_attrib`].

use crate::base::error::{ErrorCode, GlError, Result};
use crate::base::limits;
use crate::base::types::*;
use crate::interface::MAX_TEXTURE_UNITS;
use crate::objects::bound::Bound;
use crate::objects::color_buffers::Selection;
use crate::objects::sampler::SamplerState;
use crate::objects::target::TextureTarget;
use crate::pixel::transfer::Transfer;
use crate::state::client_attrib::ClientAttribs;
use crate::state::enable::Enables;
use crate::state::evaluators::EvaluatorState;
use crate::state::matrix::MatrixMode;
use crate::state::raster_position::RasterPosition;
use crate::state::texture_units::Units;
use crate::state::versioned::Versioned;
use crate::state::{State, clamp, clip, fog, fragment, light, material, raster, viewport};

const SECTION: &str = "GL 2.1, section 6.1.17";

/// The depth of each stack (table 6.35).
pub(crate) const MAX_ATTRIB_STACK_DEPTH: usize = 16;

/// The state that `glPushAttrib` saves: the groups of its mask.
#[derive(Debug, Default)]
pub(crate) struct ServerAttribs {
    pub mask: GLbitfield,
    pub enables: Enables,
    pub clamp: clamp::ClampState,
    pub matrix_mode: MatrixMode,
    pub list_base: GLuint,
    pub pixel_zoom: [f32; 2],
    pub current: Option<([[f32; 4]; limits::LOCATIONS], RasterPosition)>,
    pub lighting: Option<(Versioned<light::Lights>, Versioned<material::Materials>)>,
    pub fog: Option<fog::FogState>,
    pub clip: Option<clip::ClipState>,
    /// Of `GL_POINT_BIT`, `GL_LINE_BIT`, `GL_POLYGON_BIT` and others of rasterization.
    pub raster: Option<raster::RasterState>,
    /// Of the groups of per-fragment operations.
    pub fragment: Option<fragment::FragmentState>,
    pub clear: Option<fragment::ClearState>,
    pub transfer: Option<Transfer>,
    pub viewport: Option<viewport::ViewportState>,
    pub evaluators: Option<EvaluatorState>,
    pub selection: Option<Selection>,
    /// Of `GL_ENABLE_BIT`, the capabilities outside `enables`.
    pub switches: Option<Switches>,
    /// Of `GL_POINT_BIT`: bit by unit.
    pub coord_replace: Option<u64>,
    /// Of `GL_TEXTURE_BIT`.
    pub units: Option<Units>,
    /// As `units`; the vector is reused.
    pub textures: Vec<Parameters>,
    /// The version of the units.
    pub units_version: u64,
}

/// Capabilities outside [`Enables`].
#[derive(Debug)]
pub(crate) struct Switches {
    pub lights: u8,
    pub clip: u8,
    pub evaluators: EvaluatorState,
    pub scissor_tests: u16,
    pub blend: [bool; limits::MAX_COLOR_ATTACHMENTS],
    /// Of each unit that has coordinates: enabled targets and generated coordinates.
    pub units: [([bool; TextureTarget::COUNT], [bool; 4]); MAX_TEXTURE_UNITS as usize],
}

impl Switches {
    pub(crate) fn of(state: &State) -> Self {
        Self {
            lights: state.lights.enabled,
            clip: state.clip.enabled,
            evaluators: state.evaluators,
            scissor_tests: state.fragment.scissor_tests,
            blend: std::array::from_fn(|buffer| state.fragment.buffers[buffer].blend),
            units: std::array::from_fn(|unit| state.units.units[unit].switches()),
        }
    }
}

/// The saved parameters of a bound texture.
#[derive(Clone, Debug)]
pub(crate) struct Parameters {
    pub target: TextureTarget,
    pub bound: Bound,
    pub state: SamplerState,
    pub generate_mipmap: bool,
    pub priority: f32,
}

/// Both stacks.
#[derive(Debug, Default)]
pub(crate) struct AttribStacks {
    pub server: Vec<Box<ServerAttribs>>,
    /// Popped entries, emptied, whose memory is reused.
    pub spare: Vec<Box<ServerAttribs>>,
    pub(crate) client: Vec<ClientAttribs>,
}

impl AttribStacks {
    /// The number of entries on the stack of server and of client state.
    pub fn depths(&self) -> [usize; 2] {
        [self.server.len(), self.client.len()]
    }
}

pub(crate) fn stack_error<T>(code: ErrorCode, rule: String) -> Result<T> {
    Err(GlError::new(code, SECTION, rule))
}
