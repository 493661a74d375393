//! The vertex program over batches of 64, and the viewport transform of what it gives.

use super::fetch;
use crate::driver::{VertexBinding, VertexSource, Viewport};
use crate::ir::{Input, Output};
use crate::shader::{Machine, OverBudget, Prepared, Program, Run};
use rayon::prelude::*;
use std::num::NonZeroU32;
use std::sync::Arc;
use texunit::lanes::{Isa, LANES, U32s};
use texunit::plan::SamplePlan;

/// Window coordinates beyond this many pixels are cut off before they become fixed point: with 8
/// bits of subpixels every edge function then fits its integers ([`crate::raster`]).
pub const GUARD_BAND: f64 = 32768.0;

/// On which sides of the clip volume a vertex is out; a bit each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outcode(pub u16);

impl Outcode {
    /// `x < -w`.
    pub const LEFT: u16 = 1;
    /// `x > w`.
    pub const RIGHT: u16 = 2;
    /// `y < -w`.
    pub const BOTTOM: u16 = 4;
    /// `y > w`.
    pub const TOP: u16 = 8;
    /// `z < -w`.
    pub const NEAR: u16 = 16;
    /// `z > w`.
    pub const FAR: u16 = 32;
    /// `w` is not above zero.
    pub const BEHIND: u16 = 64;
    /// Outside the guard band.
    pub const GUARD: u16 = 128;
    /// A coordinate is inf or NaN: the primitive is dropped.
    pub const INVALID: u16 = 256;
    /// Out on one of these by every vertex: nothing can be seen.
    pub const REJECT: u16 =
        Self::LEFT | Self::RIGHT | Self::BOTTOM | Self::TOP | Self::NEAR | Self::FAR | Self::BEHIND;
    /// Out on one of these by any vertex: the primitive is cut.
    pub const CUT: u16 = Self::NEAR | Self::FAR | Self::BEHIND | Self::GUARD;
}

/// A vertex after its program.
#[derive(Clone, Copy, Debug, Default)]
pub struct ShadedVertex {
    /// Clip coordinates.
    pub clip: [f32; 4],
    /// Window x and y; meaningless unless `w > 0`.
    pub window: [f64; 2],
    /// `gl_PointSize`.
    pub point_size: f32,
    /// Where it is.
    pub outcode: Outcode,
}

/// The vertices of a chunk of a draw.
#[derive(Debug, Default)]
pub struct Geometry {
    /// One for each vertex.
    pub vertices: Vec<ShadedVertex>,
    /// `stride` for each vertex.
    pub varyings: Vec<f32>,
    /// Varyings of a vertex.
    pub stride: usize,
}

impl Geometry {
    /// The varyings of a vertex.
    pub fn varyings_of(&self, vertex: u32) -> &[f32] {
        &self.varyings[vertex as usize * self.stride..][..self.stride]
    }
}

/// What every vertex of a draw goes through.
pub struct VertexStage<'a> {
    /// The instruction set.
    pub isa: Isa,
    /// Instructions a batch may run.
    pub budget: u64,
    /// The vertex program.
    pub program: &'a Program,
    /// Its values of this draw.
    pub prepared: &'a Prepared,
    /// Its textures.
    pub textures: &'a [Option<Arc<SamplePlan>>],
    /// Its attributes.
    pub bindings: &'a [VertexBinding],
    /// Where the window is.
    pub viewport: Viewport,
    /// Varying slots that the fragment stage reads, in the order they are stored.
    pub varyings: &'a [u16],
    /// The size of a point whose program writes none.
    pub point_size: f32,
}

/// Shades the vertices `ids`, in parallel where there are many.
///
/// # Errors
/// When a batch runs over its budget.
pub fn shade(stage: &VertexStage<'_>, ids: &[u32], instance: u32) -> Result<Geometry, OverBudget> {
    let stride = stage.varyings.len();
    let mut geometry = Geometry {
        vertices: vec![ShadedVertex::default(); ids.len()],
        varyings: vec![0.0; ids.len() * stride],
        stride,
    };
    let sources: Vec<Source> = stage.program.inputs().iter().map(|&i| stage.source(i)).collect();
    let targets: Vec<Target> = stage.program.outputs().iter().map(|&o| stage.target(o)).collect();
    let new_machine = || {
        let mut machine = Machine::default();
        machine.begin(stage.program);
        machine
    };
    let batch = |machine: &mut Machine,
                 ids: &[u32],
                 vertices: &mut [ShadedVertex],
                 out: &mut [f32]| {
        stage.batch(machine, &sources, &targets, Batch { ids, instance, vertices, varyings: out })
    };
    // `chunks_mut(0)` would panic; without varyings every batch takes an empty slice.
    if ids.len() <= 4 * LANES {
        let mut machine = new_machine();
        let mut rest = geometry.varyings.as_mut_slice();
        for (ids, vertices) in ids.chunks(LANES).zip(geometry.vertices.chunks_mut(LANES)) {
            let (out, after) = rest.split_at_mut(ids.len() * stride);
            rest = after;
            batch(&mut machine, ids, vertices, out)?;
        }
    } else {
        let mut outs: Vec<&mut [f32]> = Vec::with_capacity(ids.len().div_ceil(LANES));
        let mut rest = geometry.varyings.as_mut_slice();
        for ids in ids.chunks(LANES) {
            let (out, after) = rest.split_at_mut(ids.len() * stride);
            rest = after;
            outs.push(out);
        }
        ids.par_chunks(LANES)
            .zip(geometry.vertices.par_chunks_mut(LANES))
            .zip(outs)
            .with_min_len(4)
            .try_for_each_init(new_machine, |machine, ((ids, vertices), out)| {
                batch(machine, ids, vertices, out)
            })?;
    }
    Ok(geometry)
}

/// Where an input of the program comes from.
enum Source<'a> {
    Attribute(&'a VertexSource, u8),
    /// An attribute with an element for so many instances.
    Instanced(&'a VertexSource, u8, NonZeroU32),
    /// An attribute without a binding.
    Missing(f32),
    VertexId,
    InstanceId,
}

/// Where an output of the program goes.
enum Target {
    Position(usize),
    PointSize,
    Varying(usize),
    Nowhere,
}

/// A batch of vertices: what goes in, and where the results go.
struct Batch<'a> {
    ids: &'a [u32],
    instance: u32,
    vertices: &'a mut [ShadedVertex],
    varyings: &'a mut [f32],
}

impl VertexStage<'_> {
    fn source(&self, input: Input) -> Source<'_> {
        match input {
            Input::Attribute { location, component } => {
                match self.bindings.iter().find(|binding| binding.location == location) {
                    Some(VertexBinding { source, .. }) => match source.divisor() {
                        Some(divisor) => Source::Instanced(source, component, divisor),
                        None => Source::Attribute(source, component),
                    },
                    None => Source::Missing(if component == 3 { 1.0 } else { 0.0 }),
                }
            }
            Input::VertexId => Source::VertexId,
            Input::InstanceId => Source::InstanceId,
            Input::Varying(_)
            | Input::Slope { .. }
            | Input::FragCoord(_)
            | Input::FrontFacing
            | Input::PointCoord(_) => Source::Missing(0.0),
        }
    }

    fn target(&self, output: Output) -> Target {
        match output {
            Output::Position(component) => Target::Position(usize::from(component)),
            Output::PointSize => Target::PointSize,
            Output::Varying(slot) => match self.varyings.iter().position(|&s| s == slot) {
                Some(at) => Target::Varying(at),
                None => Target::Nowhere,
            },
            Output::ClipDistance(_) | Output::Color { .. } | Output::Depth => Target::Nowhere,
        }
    }

    fn batch(
        &self,
        machine: &mut Machine,
        sources: &[Source<'_>],
        targets: &[Target],
        batch: Batch<'_>,
    ) -> Result<(), OverBudget> {
        let Batch { ids, instance, vertices, varyings } = batch;
        for (index, source) in sources.iter().enumerate() {
            let lanes = machine.input_mut(index);
            match source {
                Source::Attribute(source, component) => {
                    fetch::component(source, *component, ids, lanes.as_f32_mut());
                }
                Source::Instanced(source, component, divisor) => {
                    let element = instance / *divisor;
                    fetch::component(source, *component, &[element], lanes.as_f32_mut());
                    *lanes = U32s::splat(lanes[0]);
                }
                Source::Missing(value) => lanes.0 = [value.to_bits(); LANES],
                Source::VertexId => lanes.0[..ids.len()].copy_from_slice(ids),
                Source::InstanceId => lanes.0 = [instance; LANES],
            }
        }
        machine.run(Run {
            isa: self.isa,
            program: self.program,
            prepared: self.prepared,
            textures: self.textures,
            active: !0 >> (LANES - ids.len()),
            budget: self.budget,
        })?;
        let stride = self.varyings.len();
        for vertex in vertices.iter_mut() {
            vertex.point_size = self.point_size;
        }
        for (index, target) in targets.iter().enumerate() {
            let lanes = machine.output(index).as_f32();
            match *target {
                Target::Position(component) => {
                    for (vertex, &value) in vertices.iter_mut().zip(&lanes.0) {
                        vertex.clip[component] = value;
                    }
                }
                Target::PointSize => {
                    for (vertex, &value) in vertices.iter_mut().zip(&lanes.0) {
                        vertex.point_size = value;
                    }
                }
                Target::Varying(at) => {
                    for (all, &value) in varyings.chunks_exact_mut(stride).zip(&lanes.0) {
                        all[at] = value;
                    }
                }
                Target::Nowhere => {}
            }
        }
        for vertex in vertices {
            place(vertex, &self.viewport);
        }
        Ok(())
    }
}

/// Viewport transform (GL 2.1, section 2.11.1) and clip tests of one vertex.
fn place(vertex: &mut ShadedVertex, viewport: &Viewport) {
    let clip @ [x, y, z, w] = vertex.clip.map(f64::from);
    let bit = |out: bool, bit: u16| if out { bit } else { 0 };
    if !(x.is_finite() && y.is_finite() && z.is_finite() && w.is_finite()) {
        vertex.outcode = Outcode(Outcode::INVALID);
        return;
    }
    vertex.window = viewport.window(&clip);
    let guard = |v: f64| v.is_nan() || v.abs() > GUARD_BAND;
    vertex.outcode = Outcode(
        bit(x < -w, Outcode::LEFT)
            | bit(x > w, Outcode::RIGHT)
            | bit(y < -w, Outcode::BOTTOM)
            | bit(y > w, Outcode::TOP)
            | bit(z < -w, Outcode::NEAR)
            | bit(z > w, Outcode::FAR)
            | bit(w <= 0.0, Outcode::BEHIND)
            | bit(guard(vertex.window[0]) || guard(vertex.window[1]), Outcode::GUARD),
    );
}
