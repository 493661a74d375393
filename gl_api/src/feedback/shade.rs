//! Vertices through the vertex stage of the state, for what never becomes fragments: selection,
//! feedback, raster positions.

use crate::context::Context;
use crate::draw::stages;
use crate::error::{Result, invalid_operation};
use rasterizer::driver::{Rim, VertexBinding};
use rasterizer::ir::{Input, Output};
use rasterizer::shader::{Machine, Run};
use texunit::lanes::{Isa, LANES, U32s};

/// Which vertex of which instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Id {
    pub vertex: u32,
    pub instance: u32,
}

/// What the vertex stage made of a vertex.
pub(crate) struct Shaded {
    outputs: Vec<(Output, f32)>,
}

impl Shaded {
    /// An output, if the stage has it.
    pub fn get(&self, wanted: Output) -> Option<f32> {
        self.outputs.iter().find(|(output, _)| *output == wanted).map(|(_, value)| *value)
    }

    /// The clip coordinates.
    pub fn position(&self) -> [f64; 4] {
        [0, 1, 2, 3].map(|i| self.get(Output::Position(i)).unwrap_or(0.0).into())
    }

    /// Four varyings from a slot on; those that are not written are `otherwise`.
    pub fn varyings(&self, first: u16, otherwise: [f32; 4]) -> [f32; 4] {
        [0, 1, 2, 3]
            .map(|i| self.get(Output::Varying(first + i)).unwrap_or(otherwise[usize::from(i)]))
    }
}

/// An input of the stage for up to 64 vertices.
fn input(vertices: &[VertexBinding], input: Input, ids: &[Id], out: &mut U32s) {
    match input {
        Input::Attribute { location, component } => {
            match vertices.iter().find(|binding| binding.location == location) {
                Some(VertexBinding { source, .. }) => {
                    let mut elements = [0; LANES];
                    for (element, id) in elements.iter_mut().zip(ids) {
                        *element = source.element(id.vertex, id.instance);
                    }
                    source.component(component, &elements[..ids.len()], out.as_f32_mut());
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

/// Runs the vertex stage for vertices.
///
/// # Errors
/// As a draw, and where the shader runs too long.
pub(crate) fn shade(
    context: &mut Context,
    vertices: &[VertexBinding],
    ids: &[Id],
) -> Result<Vec<Shaded>> {
    let stages = stages::choose(context, vertices, Rim::Aliased)?;
    // Every instruction set gives the same bits.
    let isa = Isa::best();
    let program = context.recorder.single_vertex(&stages.vertex);
    let prepared = program.prepare(isa, &stages.words, &stages.vertex_textures);
    let mut machine = Machine::default();
    machine.begin(&program);
    let mut shaded = Vec::with_capacity(ids.len());
    for ids in ids.chunks(LANES) {
        for (index, &wanted) in program.inputs().iter().enumerate() {
            input(vertices, wanted, ids, machine.input_mut(index));
        }
        let run = Run {
            isa,
            program: &program,
            prepared: &prepared,
            textures: &stages.vertex_textures,
            active: u64::MAX >> (LANES - ids.len()),
            budget: rasterizer::driver::DeviceDesc::BUDGET,
        };
        if machine.run(run).is_err() {
            return invalid_operation(
                "GL 2.1, section 2.15",
                "the vertex shader runs so long that it was stopped",
            );
        }
        for lane in 0..ids.len() {
            let outputs = program.outputs().enumerate();
            let value = |index: usize| machine.output(index).as_f32()[lane];
            shaded.push(Shaded {
                outputs: outputs.map(|(index, output)| (output, value(index))).collect(),
            });
        }
    }
    Ok(shaded)
}
