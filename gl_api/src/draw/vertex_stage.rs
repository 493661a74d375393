//! Runs the vertex stage that a draw would run, for vertices that are not drawn: selection, feedback and transform
//! feedback. `context/recorder/vertex_stage.rs` has the stage.

use crate::base::error::Result;
use crate::context::Context;
use crate::context::recorder::stages::Stages;
use crate::context::recorder::vertex_stage::{Outputs, PreparedStage, VertexInstance, Vertices};
use rasterizer::driver::{Antialiasing, VertexBinding, VertexSource};
use rasterizer::ir::Input;
use std::sync::Arc;
use texunit::lanes::{Isa, LANES, U32s};

/// An input of the stage for up to 64 vertices.
fn input(
    isa: Isa,
    vertices: &[VertexBinding],
    input: Input,
    ids: &[VertexInstance],
    out: &mut U32s,
) {
    match input {
        Input::Attribute { location, component } => {
            // Where all locations are bound, the bindings lie in their order.
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
        Input::OfVertex { .. }
        | Input::PrimitiveId
        | Input::Varying(_)
        | Input::FragCoord(_)
        | Input::FrontFacing
        | Input::PointCoord(_)
        | Input::Gradient { .. }
        | Input::Coverage
        | Input::SampleId
        | Input::SamplePosition(_)
        | Input::LineDirection(_) => *out = U32s::splat(0),
    }
}

impl PreparedStage {
    /// The vertex stage of a draw.
    pub fn new(context: &mut Context, stages: Stages, outputs: Outputs) -> Self {
        let Stages { vertex, reads, .. } = stages;
        let stage = context.recorder.standalone_stage(&vertex, outputs);
        let isa = context.recorder.isa();
        let prepared = stage.program.prepare(isa, &reads.words, &reads.vertex_textures);
        let textures = reads.vertex_textures;
        Self { stage, prepared, textures, words: reads.words, keys: reads.keys }
    }

    /// The geometry stage of a draw, if there is one.
    pub fn of_geometry(context: &mut Context, stages: &Stages) -> Option<Self> {
        let module = stages.geometry.as_ref()?;
        let stage = context.recorder.standalone_stage(module, Outputs::All);
        let (words, textures) = (&stages.reads.words, Arc::clone(&stages.reads.geometry_textures));
        let prepared = stage.program.prepare(context.recorder.isa(), words, &textures);
        Some(Self { stage, prepared, textures, words: Vec::new(), keys: None })
    }

    /// The same stage after a change of values only; `None` where another may have to be chosen.
    pub fn again(mut self, context: &mut Context) -> Option<Self> {
        let keys = self.keys.as_ref().filter(|_| self.textures.is_empty())?;
        let words = crate::draw::stages::words(context, keys)?;
        if words != self.words {
            let isa = context.recorder.isa();
            self.prepared = self.stage.program.prepare(isa, &words, &self.textures);
            self.words = words;
        }
        Some(self)
    }
}

/// Runs the vertex stage of the current state for vertices.
///
/// # Errors
/// As a draw, and where the shader runs too long.
pub(crate) fn shade(
    context: &mut Context,
    vertices: &[VertexBinding],
    ids: &[VertexInstance],
    outputs: Outputs,
) -> Result<Vertices> {
    let stages = crate::draw::stages::choose(context, vertices, Antialiasing::Aliased)?;
    shade_with(context, stages, vertices, ids, outputs)
}

/// Runs the vertex stage of these for vertices.
///
/// # Errors
/// Where the shader runs too long.
pub(crate) fn shade_with(
    context: &mut Context,
    stages: Stages,
    vertices: &[VertexBinding],
    ids: &[VertexInstance],
    outputs: Outputs,
) -> Result<Vertices> {
    let ready = PreparedStage::new(context, stages, outputs);
    let isa = context.recorder.isa();
    ready.run((isa, &mut context.feedback.machine), ids.len(), |wanted, of, out| {
        input(isa, vertices, wanted, &ids[of], out);
    })
}
