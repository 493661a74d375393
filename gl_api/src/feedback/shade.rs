//! Vertices through the vertex stage of the state, for what is not drawn: selection, feedback,
//! transform feedback, raster positions.

use crate::context::Context;
use crate::draw::stages;
use crate::error::{Result, invalid_operation};
use crate::interface::{VARYING_BACK_COLOR, VARYING_COLOR, VARYING_TEX_COORD};
use rasterizer::driver::{Rim, ShaderModule, VertexBinding, VertexSource};
use rasterizer::ir::{Input, Output};
use rasterizer::shader::{Program, Run};
use std::sync::Arc;
use texunit::lanes::{Isa, LANES, U32s};

/// Which vertex of which instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Id {
    pub vertex: u32,
    pub instance: u32,
}

/// Which outputs of the stage are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Outputs {
    /// All of them.
    All,
    /// What feedback writes and clips by.
    Corners,
    /// What clips.
    Positions,
}

impl Outputs {
    fn has(self, output: Output) -> bool {
        let four = |first: u16, slot: u16| (first..first + 4).contains(&slot);
        match output {
            Output::Position(_) | Output::ClipDistance(_) => true,
            Output::Varying(slot) => match self {
                Self::All => true,
                Self::Corners => [VARYING_COLOR, VARYING_BACK_COLOR, VARYING_TEX_COORD]
                    .into_iter()
                    .any(|first| four(first, slot)),
                Self::Positions => false,
            },
            Output::PointSize | Output::Color { .. } | Output::Depth => self == Self::All,
        }
    }
}

/// A vertex stage with the outputs that are looked at.
#[derive(Debug)]
pub(crate) struct Single {
    program: Program,
    /// How many outputs it has.
    outputs: usize,
    /// Where each varying is among [`Program::outputs`], by its slot.
    varyings: Vec<Option<usize>>,
    /// Where others are.
    others: Vec<(Output, usize)>,
}

impl Single {
    pub fn new(module: &ShaderModule, outputs: Outputs) -> Self {
        let program = Program::new(module.module(), |output| outputs.has(output));
        let (mut varyings, mut others) = (Vec::new(), Vec::new());
        for (place, output) in program.outputs().enumerate() {
            if let Output::Varying(slot) = output {
                let slot = usize::from(slot);
                varyings.resize(varyings.len().max(slot + 1), None);
                varyings[slot] = Some(place);
            } else {
                others.push((output, place));
            }
        }
        let outputs = program.outputs().len();
        Self { program, outputs, varyings, others }
    }
}

/// What the vertex stage made of vertices.
pub(crate) struct Vertices {
    stage: Arc<Single>,
    /// The outputs of the first 64 vertices, then those of the next: each output of all of them.
    values: Vec<f32>,
    len: usize,
}

impl Vertices {
    /// How many there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Which of the outputs this is, if the stage has it.
    pub fn place(&self, wanted: Output) -> Option<usize> {
        if let Output::Varying(slot) = wanted {
            return self.stage.varyings.get(usize::from(slot)).copied().flatten();
        }
        self.stage.others.iter().find(|(output, _)| *output == wanted).map(|(_, place)| *place)
    }

    /// The places of the clip coordinates.
    pub fn position(&self) -> [Option<usize>; 4] {
        [0, 1, 2, 3].map(|i| self.place(Output::Position(i)))
    }

    /// The places of four varyings from a slot on.
    pub fn varyings(&self, first: u16) -> [Option<usize>; 4] {
        [0, 1, 2, 3].map(|i| self.place(Output::Varying(first + i)))
    }

    /// The output at a [`Self::place`], of vertex `at`.
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

/// What the vertex stage made of a vertex.
#[derive(Clone, Copy)]
pub(crate) struct Shaded<'a> {
    vertices: &'a Vertices,
    at: usize,
}

impl Shaded<'_> {
    /// An output, if the stage has it.
    pub fn get(&self, wanted: Output) -> Option<f32> {
        self.vertices.place(wanted).map(|place| self.vertices.value(self.at, place))
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

/// An input of the stage for up to 64 vertices.
fn input(isa: Isa, vertices: &[VertexBinding], input: Input, ids: &[Id], out: &mut U32s) {
    match input {
        Input::Attribute { location, component } => {
            // Where all are bound, they lie in order.
            let is_its = |binding: &&VertexBinding| binding.location == location;
            let in_order = vertices.get(usize::from(location)).filter(is_its);
            match in_order.or_else(|| vertices.iter().find(is_its)) {
                Some(VertexBinding { source: source @ VertexSource::Constant(_), .. }) => {
                    source.component(isa, component, &[], out.as_f32_mut());
                }
                Some(VertexBinding { source, .. }) => {
                    let mut elements = [0; LANES];
                    for (element, id) in elements.iter_mut().zip(ids) {
                        *element = source.element(id.vertex, id.instance);
                    }
                    source.component(isa, component, &elements[..ids.len()], out.as_f32_mut());
                }
                None => *out = U32s::splat(0),
            }
        }
        Input::VertexId | Input::InstanceId => {
            for (lane, id) in ids.iter().enumerate() {
                out[lane] = if input == Input::VertexId { id.vertex } else { id.instance };
            }
        }
        Input::Varying(_)
        | Input::FragCoord(_)
        | Input::FrontFacing
        | Input::PointCoord(_)
        | Input::Slope { .. }
        | Input::Coverage => *out = U32s::splat(0),
    }
}

/// Runs the vertex stage of the state for vertices.
///
/// # Errors
/// As a draw, and where the shader runs too long.
pub(crate) fn shade(
    context: &mut Context,
    vertices: &[VertexBinding],
    ids: &[Id],
    outputs: Outputs,
) -> Result<Vertices> {
    let stages = stages::choose(context, vertices, Rim::Aliased)?;
    let isa = context.recorder.isa();
    let stage = context.recorder.single_vertex(&stages.vertex, outputs);
    let program = &stage.program;
    let prepared = program.prepare(isa, &stages.reads.words, &stages.reads.vertex_textures);
    let machine = &mut context.feedback.machine;
    machine.begin(program);
    let mut values = Vec::with_capacity(ids.len() * stage.outputs);
    for ids in ids.chunks(LANES) {
        for (index, &wanted) in program.inputs().iter().enumerate() {
            input(isa, vertices, wanted, ids, machine.input_mut(index));
        }
        let run = Run {
            isa,
            program,
            prepared: &prepared,
            textures: &stages.reads.vertex_textures,
            active: u64::MAX >> (LANES - ids.len()),
            budget: rasterizer::driver::DeviceDesc::BUDGET,
        };
        if machine.run(run).is_err() {
            return invalid_operation(
                "GL 2.1, section 2.15",
                "the vertex shader runs so long that it was stopped",
            );
        }
        for place in 0..stage.outputs {
            values.extend_from_slice(&machine.output(place).as_f32().0[..ids.len()]);
        }
    }
    Ok(Vertices { stage, values, len: ids.len() })
}
