//! The description of a pipeline.

use super::blend::ColorState;
use super::depth_stencil::DepthState;
use super::output::OutputState;
use super::primitive::{Cull, FrontFace, Provoking, Topology};
use crate::ir::{Effect, GeometryInput, GeometryOutput, Module};
use std::hash::{Hash, Hasher};
use std::sync::Arc;
use thiserror::Error;

/// A validated shader stage. Equal when it is the same module, not an equal one.
#[derive(Clone, Debug)]
pub struct ShaderModule(Arc<Validated>);

#[derive(Debug)]
struct Validated {
    module: Module,
    effect: Effect,
}

impl ShaderModule {
    /// Validates a module.
    ///
    /// # Errors
    /// When the module breaks a rule of the IR.
    pub fn new(module: Module) -> Result<Self, crate::ir::IrError> {
        module.validate()?;
        let effect = Effect::of(&module);
        Ok(Self(Arc::new(Validated { module, effect })))
    }

    /// The module.
    pub fn module(&self) -> &Module {
        &self.0.module
    }

    /// What is known of its picture.
    pub fn effect(&self) -> &Effect {
        &self.0.effect
    }
}

impl PartialEq for ShaderModule {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for ShaderModule {}

impl Hash for ShaderModule {
    fn hash<H: Hasher>(&self, state: &mut H) {
        Arc::as_ptr(&self.0).hash(state);
    }
}

/// The complete description of a pipeline; also its cache key.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct PipelineDesc {
    /// The vertex stage.
    pub vertex: ShaderModule,
    /// The geometry stage, if there is one: then vertices make primitives of its kind of input.
    pub geometry: Option<ShaderModule>,
    /// The fragment stage; varyings meet by slot.
    pub fragment: ShaderModule,
    /// How vertices make primitives.
    pub topology: Topology,
    /// Which faces are not drawn.
    pub cull: Cull,
    /// Which winding is the front.
    pub front_face: FrontFace,
    /// The provoking vertex, the source of flat varyings.
    pub provoking: Provoking,
    /// Depth test; `None` neither tests nor writes.
    pub depth: Option<DepthState>,
    /// By colour attachment; missing ones are not written.
    pub colors: Vec<ColorState>,
    /// The other operations on fragments after the shader.
    pub output: OutputState,
}

impl PipelineDesc {
    /// The topology of what is drawn. What a geometry program emits is drawn primitive by primitive.
    pub(crate) fn drawn(&self) -> Topology {
        let interface = self.geometry.as_ref().and_then(|stage| stage.module().geometry.as_ref());
        match interface.map(|interface| interface.output) {
            Some(GeometryOutput::Points) => Topology::Points,
            Some(GeometryOutput::LineStrip) => Topology::Lines,
            Some(GeometryOutput::TriangleStrip) => Topology::Triangles,
            None => self.topology,
        }
    }
}

impl Topology {
    /// What a geometry program that runs for these primitives takes; `None` if none does.
    pub fn geometry_input(self) -> Option<GeometryInput> {
        match self {
            Self::Points => Some(GeometryInput::Points),
            Self::Lines | Self::LineStrip | Self::LineLoop => Some(GeometryInput::Lines),
            Self::LinesAdjacency | Self::LineStripAdjacency => Some(GeometryInput::LinesAdjacency),
            Self::Triangles | Self::TriangleStrip | Self::TriangleFan => {
                Some(GeometryInput::Triangles)
            }
            Self::TrianglesAdjacency | Self::TriangleStripAdjacency => {
                Some(GeometryInput::TrianglesAdjacency)
            }
            Self::Quads | Self::QuadStrip | Self::Polygon => None,
        }
    }
}

/// Why a pipeline is invalid.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("pipeline: {0}")]
pub struct PipelineError(pub String);
