//! The geometry stage run by itself, for primitives that transform feedback captures or queries count.
//! `draw/capture.rs` runs it.

use crate::base::error::{Result, invalid_operation};
use crate::context::recorder::vertex_stage::{PreparedStage, Vertices};
use rasterizer::driver::{DeviceDesc, Provoking};
use rasterizer::ir::{GeometryInterface, Input};
use rasterizer::shader::{Emission, Invocation, Machine};
use std::sync::Arc;
use texunit::lanes::{Isa, LANES, U32s};

impl PreparedStage {
    /// What the geometry stage makes of primitives: the corners of its primitives one after the other. Those of a
    /// primitive lie together in `input`; `numbers` are those of the primitives.
    ///
    /// # Errors
    /// Where the shader runs too long.
    pub fn emit(
        &self,
        (isa, machine): (Isa, &mut Machine),
        interface: &GeometryInterface,
        (input, numbers): (&Vertices, &[u32]),
        provoking: Provoking,
    ) -> Result<Vertices> {
        let Self { stage, prepared, textures, .. } = self;
        let program = &stage.program;
        let each = usize::from(interface.input.vertices());
        machine.begin(program);
        let mut corners: Vec<f32> = Vec::new();
        for (batch, numbers) in numbers.chunks(LANES).enumerate() {
            let first = batch * LANES;
            for (index, &wanted) in program.inputs().iter().enumerate() {
                let lanes = machine.input_mut(index);
                match wanted {
                    Input::OfVertex { vertex, output } => {
                        let place = input.output_index(output);
                        *lanes = U32s::from_fn(|lane| {
                            let at = (first + lane) * each + usize::from(vertex);
                            place.map_or(0, |place| input.value(at, place).to_bits())
                        });
                    }
                    Input::PrimitiveId => lanes.0[..numbers.len()].copy_from_slice(numbers),
                    Input::Varying(_)
                    | Input::Gradient { .. }
                    | Input::FragCoord(_)
                    | Input::FrontFacing
                    | Input::PointCoord(_)
                    | Input::Coverage
                    | Input::SampleId
                    | Input::SamplePosition(_)
                    | Input::LineDirection(_)
                    | Input::Attribute { .. }
                    | Input::VertexId
                    | Input::InstanceId => *lanes = U32s::ZERO,
                }
            }
            let invocation = Invocation {
                isa,
                program,
                prepared,
                textures,
                active: u64::MAX >> (LANES - numbers.len()),
                budget: DeviceDesc::batch_budget(DeviceDesc::BUDGET),
            };
            if machine.run(invocation).is_err() {
                return invalid_operation(
                    "GL 3.2, section 2.12",
                    "the geometry shader runs so long that it was stopped",
                );
            }
            for lane in 0..numbers.len() {
                append(machine.emission(), lane, interface, provoking, &mut corners);
            }
        }
        Ok(Vertices::of_rows(Arc::clone(stage), &corners))
    }
}

/// Appends the scalars of the corners of a lane's primitives.
fn append(
    emission: &Emission,
    lane: usize,
    interface: &GeometryInterface,
    provoking: Provoking,
    corners: &mut Vec<f32>,
) {
    let mut position = 0;
    for vertex in 0..emission.count(lane) {
        position = if emission.begins_strip(lane, vertex) { 0 } else { position + 1 };
        for back in provoking.corners_of_strip(interface.output, position) {
            let words = 0..interface.outputs.len();
            corners.extend(words.map(|word| emission.values(vertex - back, word).as_f32()[lane]));
        }
    }
}
