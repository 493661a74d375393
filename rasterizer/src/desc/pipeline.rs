//! The description of a pipeline.

use super::blend::ColorState;
use super::depth_stencil::DepthState;
use super::output::OutputState;
use super::primitive::{Cull, FrontFace, Provoking, Topology};
use crate::ir::Module;
use std::hash::{Hash, Hasher};
use std::sync::Arc;
use thiserror::Error;

/// A validated shader stage. Equal when it is the same module, not an equal one.
#[derive(Clone, Debug)]
pub struct ShaderModule(Arc<Module>);

impl ShaderModule {
    /// Validates a module.
    ///
    /// # Errors
    /// When the module breaks a rule of the IR.
    pub fn new(module: Module) -> Result<Self, crate::ir::IrError> {
        module.validate()?;
        Ok(Self(Arc::new(module)))
    }

    /// The module.
    pub fn module(&self) -> &Module {
        &self.0
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

/// Why a pipeline is invalid.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("pipeline: {0}")]
pub struct PipelineError(pub String);
