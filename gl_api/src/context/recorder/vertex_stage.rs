//! The vertex stage run by itself, for vertices that are not drawn: selection, feedback, transform feedback and raster
//! positions. `draw/vertex_stage.rs` runs it for the vertices of a draw.

use crate::base::error::{Result, invalid_operation};
use crate::base::memory::out_of_memory;
use crate::context::recorder::fixed_function::StageKeys;
use crate::context::recorder::stages::Textures;
use crate::interface::{MAX_TEXTURE_UNITS, VARYING_BACK_COLOR, VARYING_COLOR, VARYING_TEX_COORD};
use rasterizer::driver::{DeviceDesc, ShaderModule};
use rasterizer::ir::{Input, Output};
use rasterizer::shader::{Invocation, Machine, Prepared, Program};
use std::ops::Range;
use std::sync::Arc;
use texunit::lanes::{Isa, LANES, U32s};

const SECTION: &str = "GL 2.1, section 2.15";

/// Which vertex of which instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct VertexInstance {
    pub vertex: u32,
    pub instance: u32,
}

/// Which outputs of the stage are used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Outputs {
    /// All of them.
    All,
    /// All but the texture coordinates of units whose bit is not set.
    Units(u8),
    /// Those that feedback writes, and those that clip.
    Corners,
    /// Those that clip.
    Positions,
}

impl Outputs {
    fn has(self, output: Output) -> bool {
        let four = |first: u16, slot: u16| (first..first + 4).contains(&slot);
        match output {
            Output::Position(_) | Output::ClipDistance(_) | Output::CullDistance(_) => true,
            Output::Varying(slot) => match self {
                Self::All => true,
                Self::Units(units) => (0..MAX_TEXTURE_UNITS)
                    .filter(|unit| units >> unit & 1 == 0)
                    .all(|unit| !four(VARYING_TEX_COORD + 4 * u16::from(unit), slot)),
                Self::Corners => [VARYING_COLOR, VARYING_BACK_COLOR, VARYING_TEX_COORD]
                    .into_iter()
                    .any(|first| four(first, slot)),
                Self::Positions => false,
            },
            Output::PointSize
            | Output::Color { .. }
            | Output::SecondColor(_)
            | Output::Depth
            | Output::StencilReference
            | Output::SampleMask
            | Output::Layer
            | Output::PrimitiveId
            | Output::ViewportIndex => match self {
                Self::All | Self::Units(_) => true,
                Self::Corners | Self::Positions => false,
            },
        }
    }
}

/// A vertex stage with the outputs that are used.
#[derive(Debug)]
pub(crate) struct StandaloneStage {
    pub program: Program,
    /// How many outputs it has.
    outputs: usize,
    /// The index of each varying among [`Program::outputs`], by its slot.
    varyings: Vec<Option<usize>>,
    /// The indices of other outputs.
    others: Vec<(Output, usize)>,
}

impl StandaloneStage {
    pub fn new(module: &ShaderModule, outputs: Outputs) -> Self {
        let program = Program::new(module.module(), |output| outputs.has(output));
        let (mut varyings, mut others) = (Vec::new(), Vec::new());
        let outputs: Vec<Output> = match program.geometry() {
            Some(interface) => interface.outputs.clone(),
            None => program.outputs().collect(),
        };
        for (place, &output) in outputs.iter().enumerate() {
            if let Output::Varying(slot) = output {
                let slot = usize::from(slot);
                varyings.resize(varyings.len().max(slot + 1), None);
                varyings[slot] = Some(place);
            } else {
                others.push((output, place));
            }
        }
        Self { program, outputs: outputs.len(), varyings, others }
    }
}

/// Shaded vertices: the outputs of the stage.
pub(crate) struct Vertices {
    stage: Arc<StandaloneStage>,
    /// The outputs of the first 64 vertices, then those of the next: each output of all of them.
    values: Vec<f32>,
    len: usize,
}

impl Vertices {
    /// The vertices of a stage, whose outputs are given vertex by vertex.
    pub fn of_rows(stage: Arc<StandaloneStage>, rows: &[f32]) -> Self {
        let outputs = stage.outputs;
        let mut values = Vec::with_capacity(rows.len());
        for rows in rows.chunks((outputs * LANES).max(1)) {
            let of = |place| rows.iter().skip(place).step_by(outputs).copied();
            values.extend((0..outputs).flat_map(of));
        }
        Self { values, len: rows.len().checked_div(outputs).unwrap_or(0), stage }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// The index of an output, if the stage has it.
    pub fn output_index(&self, wanted: Output) -> Option<usize> {
        if let Output::Varying(slot) = wanted {
            return self.stage.varyings.get(usize::from(slot)).copied().flatten();
        }
        self.stage.others.iter().find(|(output, _)| *output == wanted).map(|(_, place)| *place)
    }

    /// The indices of the clip coordinates.
    pub fn position(&self) -> [Option<usize>; 4] {
        [0, 1, 2, 3].map(|i| self.output_index(Output::Position(i)))
    }

    /// The indices of four varyings from a slot on.
    pub fn varyings(&self, first: u16) -> [Option<usize>; 4] {
        [0, 1, 2, 3].map(|i| self.output_index(Output::Varying(first + i)))
    }

    /// The output of an index ([`Self::output_index`]), of vertex `at`.
    pub fn value(&self, at: usize, place: usize) -> f32 {
        let (first, lane) = (at - at % LANES, at % LANES);
        let lanes = self.len.saturating_sub(first).min(LANES);
        let index = first * self.stage.outputs + place * lanes + lane;
        self.values.get(index).copied().unwrap_or_default()
    }

    /// Four outputs of vertex `at`; those that the stage lacks are `otherwise`.
    pub fn four(&self, at: usize, places: [Option<usize>; 4], otherwise: [f32; 4]) -> [f32; 4] {
        std::array::from_fn(|i| places[i].map_or(otherwise[i], |place| self.value(at, place)))
    }

    /// Vertex `at`.
    pub fn vertex(&self, at: usize) -> Shaded<'_> {
        Shaded { vertices: self, at }
    }
}

/// A shaded vertex.
#[derive(Clone, Copy)]
pub(crate) struct Shaded<'a> {
    vertices: &'a Vertices,
    at: usize,
}

impl Shaded<'_> {
    /// An output, if the stage has it.
    pub fn get(&self, wanted: Output) -> Option<f32> {
        self.vertices.output_index(wanted).map(|place| self.vertices.value(self.at, place))
    }

    /// The clip and cull distances.
    pub fn clip_distances(self) -> impl Iterator<Item = f32> {
        let clips = |of: &(Output, usize)| {
            matches!(of.0, Output::ClipDistance(_) | Output::CullDistance(_)).then_some(of.1)
        };
        let places = self.vertices.stage.others.iter().filter_map(clips);
        places.map(move |place| self.vertices.value(self.at, place))
    }

    /// The clip coordinates.
    pub fn position(&self) -> [f64; 4] {
        self.vertices.four(self.at, self.vertices.position(), [0.0; 4]).map(f64::from)
    }

    /// Four varyings from a slot on; those that are not written are `otherwise`.
    pub fn varyings(&self, first: u16, otherwise: [f32; 4]) -> [f32; 4] {
        self.vertices.four(self.at, self.vertices.varyings(first), otherwise)
    }
}

/// A vertex stage with its uniform words and textures, ready to run.
#[derive(Debug)]
pub(crate) struct PreparedStage {
    pub stage: Arc<StandaloneStage>,
    pub prepared: Prepared,
    pub textures: Textures,
    pub words: Vec<u32>,
    /// What the words are made by, if they can be made again by it alone.
    pub keys: Option<StageKeys>,
}

impl PreparedStage {
    /// Runs the stage for `len` vertices; `fill` gives an input of up to 64 of them.
    ///
    /// # Errors
    /// Where the shader runs too long.
    pub fn run(
        &self,
        (isa, machine): (Isa, &mut Machine),
        len: usize,
        fill: impl Fn(Input, Range<usize>, &mut U32s),
    ) -> Result<Vertices> {
        let Self { stage, prepared, textures, .. } = self;
        let program = &stage.program;
        machine.begin(program);
        let mut values = Vec::new();
        let words = len.saturating_mul(stage.outputs);
        values.try_reserve_exact(words).map_err(out_of_memory(SECTION, "shaded vertices"))?;
        for first in (0..len).step_by(LANES) {
            let lanes = (len - first).min(LANES);
            for (index, &wanted) in program.inputs().iter().enumerate() {
                fill(wanted, first..first + lanes, machine.input_mut(index));
            }
            let invocation = Invocation {
                isa,
                program,
                prepared,
                textures,
                active: u64::MAX >> (LANES - lanes),
                budget: DeviceDesc::batch_budget(DeviceDesc::BUDGET),
            };
            if machine.run(invocation).is_err() {
                return invalid_operation(
                    SECTION,
                    "the vertex shader runs so long that it was stopped",
                );
            }
            for place in 0..stage.outputs {
                values.extend_from_slice(&machine.output(place).as_f32().0[..lanes]);
            }
        }
        Ok(Vertices { stage: Arc::clone(stage), values, len })
    }
}

/// The vertex stage that transformed the last raster position, kept for the next.
#[derive(Debug)]
pub(crate) struct RasterPositionStage {
    /// [`crate::context::state_changes::StateChanges::calls`] when it was chosen.
    pub at: u64,
    pub ready: PreparedStage,
}
