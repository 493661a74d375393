//! The state that setters change which do nothing else: plain values that draws depend on. It is compared where a draw
//! comes, not where it is set, so that a call that sets what is set, or takes back what another did, costs a draw nothing.
//! Matrices belong to it; shaders and pipelines are chosen without them.

use crate::state::State;
use crate::state::enable::Enables;
use crate::state::fragment::FragmentState;
use crate::state::raster::RasterState;
use crate::state::viewport::ViewportState;
use glam::DMat4;

/// The plain state of a context at some time.
#[derive(Clone, Debug)]
pub(crate) struct PlainState {
    enables: Enables,
    fragment: FragmentState,
    raster: RasterState,
    viewport: ViewportState,
    clip_planes: u8,
    lights: u8,
    modelview: DMat4,
    projection: DMat4,
}

impl PlainState {
    /// That of now.
    pub fn of(state: &State) -> Box<Self> {
        Box::new(Self {
            enables: state.enables.clone(),
            fragment: state.fragment.clone(),
            raster: state.raster.clone(),
            viewport: state.viewport.clone(),
            clip_planes: state.clip.enabled,
            lights: state.lights.enabled,
            modelview: state.matrices.modelview.top,
            projection: state.matrices.projection.top,
        })
    }

    /// Whether it is that of now.
    pub fn is_of(&self, state: &State) -> bool {
        is_same_matrix(&self.modelview, &state.matrices.modelview.top)
            && is_same_matrix(&self.projection, &state.matrices.projection.top)
            && self.decides_alike(state)
    }

    /// Whether shaders and pipelines are chosen by it as by that of now. Of equal numbers only the blend colour shows the
    /// sign of a zero.
    pub fn decides_alike(&self, state: &State) -> bool {
        let Self { enables, fragment, raster, viewport, clip_planes, lights, .. } = self;
        let bits = |color: [f32; 4]| color.map(f32::to_bits);
        *enables == state.enables
            && *clip_planes == state.clip.enabled
            && *lights == state.lights.enabled
            && *viewport == state.viewport
            && *fragment == state.fragment
            && bits(fragment.blend_color) == bits(state.fragment.blend_color)
            && *raster == state.raster
    }

    /// Exchanges it with that of now.
    pub fn swap(&mut self, state: &mut State) {
        let Self {
            enables,
            fragment,
            raster,
            viewport,
            clip_planes,
            lights,
            modelview,
            projection,
        } = self;
        std::mem::swap(enables, &mut state.enables);
        std::mem::swap(fragment, &mut state.fragment);
        std::mem::swap(raster, &mut state.raster);
        std::mem::swap(viewport, &mut state.viewport);
        std::mem::swap(clip_planes, &mut state.clip.enabled);
        // What is as it was keeps its version.
        if *lights != state.lights.enabled {
            std::mem::swap(lights, &mut state.lights.enabled);
        }
        std::mem::swap(modelview, &mut state.matrices.modelview.top);
        std::mem::swap(projection, &mut state.matrices.projection.top);
    }
}

/// Whether two matrices are equal to the bit.
pub(crate) fn is_same_matrix(a: &DMat4, b: &DMat4) -> bool {
    let bits = |matrix: &DMat4| matrix.to_cols_array().map(f64::to_bits);
    bits(a) == bits(b)
}
