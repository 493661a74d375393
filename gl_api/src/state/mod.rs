//! The state of a context, by chapter of the specification, as plain values. Objects are in [`crate::objects`].

pub(crate) mod assembly;
pub(crate) mod attrib;
pub(crate) mod blend;
pub(crate) mod clamp;
pub(crate) mod client_attrib;
pub(crate) mod clip;
pub(crate) mod draw_buffers;
pub(crate) mod enable;
pub(crate) mod evaluators;
pub(crate) mod fog;
pub(crate) mod fragment;
pub(crate) mod light;
pub(crate) mod locked_arrays;
pub(crate) mod material;
pub(crate) mod matrix;
pub(crate) mod multisample;
pub(crate) mod per_viewport;
pub(crate) mod plain;
pub(crate) mod points;
pub(crate) mod polygon;
pub(crate) mod raster;
pub(crate) mod raster_position;
pub(crate) mod stencil;
pub(crate) mod texture_units;
pub(crate) mod transform_feedback;
pub(crate) mod uniform_buffers;
pub(crate) mod versioned;
pub(crate) mod viewport;

use crate::base::limits::LOCATIONS;
use crate::base::types::GLuint;
use crate::interface::{ATTRIB_COLOR, ATTRIB_EDGE_FLAG, ATTRIB_INDEX, ATTRIB_NORMAL};
use crate::objects::bound::Bound;
use crate::objects::texture::Proxies;
use crate::pixel::store::PixelStore;
use crate::pixel::transfer::Transfer;
use crate::state::assembly::AssemblyState;
use crate::state::clamp::ClampState;
use crate::state::clip::ClipState;
use crate::state::enable::Enables;
use crate::state::evaluators::EvaluatorState;
use crate::state::fog::FogState;
use crate::state::fragment::{ClearState, FragmentState};
use crate::state::light::Lights;
use crate::state::material::Materials;
use crate::state::matrix::Matrices;
use crate::state::raster::RasterState;
use crate::state::raster_position::RasterPosition;
use crate::state::texture_units::Units;
use crate::state::versioned::Versioned;
use crate::state::viewport::{Viewport, ViewportState};

/// The bound objects, as references or names; 0 where none is bound.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bindings {
    pub array_buffer: Bound,
    pub element_array_buffer: Bound,
    pub pixel_pack_buffer: Bound,
    pub pixel_unpack_buffer: Bound,
    pub texture_buffer: Bound,
    pub copy_read_buffer: Bound,
    pub copy_write_buffer: Bound,
    pub transform_feedback_buffer: Bound,
    pub uniform_buffer: Bound,
    pub draw_indirect_buffer: Bound,
    pub vertex_array: GLuint,
    pub draw_framebuffer: GLuint,
    pub read_framebuffer: GLuint,
    pub renderbuffer: Bound,
    pub program: Bound,
}

/// All state other than objects.
#[derive(Debug)]
pub(crate) struct State {
    pub matrices: Matrices,
    pub viewport: ViewportState,
    /// The current value of each attribute, by location.
    pub current: [[f32; 4]; LOCATIONS],
    pub arrays: Box<crate::objects::arrays::Arrays>,
    /// The index that restarts a primitive; of no vertex array object.
    pub restart_index: GLuint,
    pub locked: locked_arrays::LockedArrays,
    pub enables: Enables,
    pub lights: Versioned<Lights>,
    pub materials: Versioned<Materials>,
    pub fog: FogState,
    pub clip: ClipState,
    pub raster: RasterState,
    pub fragment: FragmentState,
    pub clear: ClearState,
    pub clamp: ClampState,
    pub pack: PixelStore,
    pub unpack: PixelStore,
    pub transfer: Transfer,
    pub pixel_zoom: [f32; 2],
    pub raster_position: RasterPosition,
    pub proxies: Proxies,
    pub units: Units,
    pub evaluators: EvaluatorState,
    pub bindings: Bindings,
    pub assembly: AssemblyState,
}

impl State {
    /// The initial state for a window of this size.
    pub fn new(width: u32, height: u32) -> Self {
        let mut current = [[0.0, 0.0, 0.0, 1.0]; LOCATIONS];
        current[usize::from(ATTRIB_COLOR)] = [1.0; 4];
        current[usize::from(ATTRIB_EDGE_FLAG)] = [1.0, 0.0, 0.0, 1.0];
        current[usize::from(ATTRIB_INDEX)] = [1.0, 0.0, 0.0, 1.0];
        current[usize::from(ATTRIB_NORMAL)] = [0.0, 0.0, 1.0, 1.0];
        Self {
            matrices: Matrices::default(),
            viewport: ViewportState::new(Viewport::new(width, height)),
            current,
            arrays: Box::default(),
            restart_index: 0,
            locked: locked_arrays::LockedArrays::default(),
            enables: Enables::default(),
            lights: Versioned::new(Lights::default()),
            materials: Versioned::new(Materials::default()),
            fog: FogState::default(),
            clip: ClipState::default(),
            raster: RasterState::default(),
            fragment: FragmentState::new(width, height),
            clear: ClearState::default(),
            clamp: ClampState::default(),
            pack: PixelStore::default(),
            unpack: PixelStore::default(),
            transfer: Transfer::default(),
            pixel_zoom: [1.0; 2],
            raster_position: RasterPosition::default(),
            proxies: Proxies::default(),
            units: Units::default(),
            evaluators: EvaluatorState::default(),
            bindings: Bindings::default(),
            assembly: AssemblyState::default(),
        }
    }
}
