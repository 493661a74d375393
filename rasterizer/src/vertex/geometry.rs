//! The shaded vertices of a chunk of a draw.

use super::viewport::{Outcode, snap};
use crate::desc::Viewport;
use crate::sizes::GUARD_BAND;

/// The vertices of a chunk of a draw.
#[derive(Clone, Debug, Default)]
pub struct Geometry {
    /// `stride` for each vertex: x, y, z and w in clip coordinates, and its varyings.
    pub values: Vec<f32>,
    /// Values of a vertex, padded to a multiple of four.
    pub stride: usize,
    /// Window coordinates on the subpixel grid; meaningless unless `w > 0`.
    pub snapped: Vec<[i32; 2]>,
    /// The [`Outcode`] of each vertex.
    pub outcodes: Vec<u32>,
    /// `gl_PointSize` of each vertex; empty where it does not matter.
    pub(super) point_sizes: Vec<f32>,
    /// `planes` clip distances for each vertex.
    pub(super) distances: Vec<f32>,
    /// Clip distances of a vertex.
    pub(super) planes: usize,
    /// The layer of each vertex, any number; empty where all go to one.
    pub(super) layers: Vec<u32>,
    /// The number of the viewport of each vertex, any number; empty where all go to one.
    pub(super) viewports: Vec<u32>,
    /// The edge flag of each vertex; empty where all are set.
    pub(super) edge_flags: Vec<f32>,
}

/// Index of the first varying among the values of a vertex.
pub const VARYINGS: usize = 4;

impl Geometry {
    /// How many vertices there are.
    pub fn len(&self) -> usize {
        self.outcodes.len()
    }

    /// Removes all vertices.
    pub fn clear(&mut self) {
        self.values.clear();
        self.snapped.clear();
        self.outcodes.clear();
        self.point_sizes.clear();
        self.distances.clear();
        self.layers.clear();
        self.viewports.clear();
        self.edge_flags.clear();
    }

    fn values_of(&self, vertex: u32) -> &[f32] {
        &self.values[vertex as usize * self.stride..][..self.stride]
    }

    /// The clip coordinates of a vertex.
    pub fn clip(&self, vertex: u32) -> [f32; 4] {
        self.values_of(vertex).first_chunk().copied().unwrap_or_default()
    }

    /// The varyings of a vertex.
    pub fn varyings_of(&self, vertex: u32) -> &[f32] {
        &self.values_of(vertex)[VARYINGS..]
    }

    /// Sets a varying of a vertex that the vertex stage does not write.
    pub fn set_varying(&mut self, vertex: u32, varying: usize, value: f32) {
        self.values[vertex as usize * self.stride + VARYINGS + varying] = value;
    }

    /// Window x and y of a vertex; meaningless unless `w > 0`.
    pub fn window(&self, viewport: &Viewport, vertex: u32) -> [f64; 2] {
        viewport.window(&self.clip(vertex).map(f64::from))
    }

    /// The sides of the clip volume that a vertex is outside of.
    pub fn outcode(&self, vertex: u32) -> Outcode {
        Outcode(self.outcodes[vertex as usize])
    }

    /// The point size that the vertex stage wrote, if it did.
    pub fn point_size(&self, vertex: u32) -> Option<f32> {
        self.point_sizes.get(vertex as usize).copied()
    }

    /// The clip distances of a vertex.
    pub fn distances(&self, vertex: u32) -> &[f32] {
        &self.distances[vertex as usize * self.planes..][..self.planes]
    }

    /// Whether vertices have layers.
    pub fn has_layers(&self) -> bool {
        !self.layers.is_empty()
    }

    /// The layer of a vertex, if there are several.
    pub fn layer(&self, vertex: u32) -> Option<u32> {
        self.layers.get(vertex as usize).copied()
    }

    /// The number of the viewport of a vertex, if they have one.
    pub fn viewport(&self, vertex: u32) -> Option<u32> {
        self.viewports.get(vertex as usize).copied()
    }

    /// The same vertices in another viewport, which differs from theirs in nothing but its sides and depths.
    pub fn in_viewport(&self, viewport: &Viewport) -> Self {
        let mut other = self.clone();
        for vertex in 0..self.len() {
            let window = self.window(viewport, vertex as u32);
            other.snapped[vertex] = window.map(snap);
            let outcode = &mut other.outcodes[vertex];
            let in_band = window.iter().all(|side| side.abs() <= GUARD_BAND);
            if *outcode & Outcode::INVALID == 0 {
                let guard = if in_band { 0 } else { Outcode::GUARD };
                *outcode = *outcode & !Outcode::GUARD | guard;
            }
        }
        other
    }

    /// Whether a boundary edge begins at a vertex (GL 2.1, section 2.6.2).
    pub fn begins_boundary(&self, vertex: u32) -> bool {
        self.edge_flags.get(vertex as usize).is_none_or(|&flag| flag != 0.0)
    }
}
