//! The program that draws run: that of `glUseProgram`, or else those of the bound program pipeline.

use crate::base::types::GLuint;
use crate::context::Context;
use crate::glsl::Stage;
use crate::objects::pipelines::PipelineInUse;
use crate::objects::programs::Linked;

impl Context {
    /// The executable in use; that of a pipeline as of the last draw or `glBegin`.
    pub(crate) fn executable(&self) -> Option<&Linked> {
        match self.state.bindings.program.name() {
            0 => self.objects.pipelines.executable(),
            name => self.objects.shared.linked_program(name),
        }
    }

    /// Whether a program is in use, by itself or in a pipeline.
    pub(crate) fn has_program(&self) -> bool {
        let pipelines = &self.objects.pipelines;
        self.state.bindings.program.name() != 0
            || pipelines.bound != 0 && !matches!(pipelines.in_use, PipelineInUse::Empty)
    }

    /// The name of the program of a stage, for messages.
    pub(crate) fn program_of(&self, stage: Stage) -> GLuint {
        match (self.state.bindings.program.name(), self.objects.pipelines.current()) {
            (0, Some(pipeline)) => pipeline.stages[stage as usize].name(),
            (name, _) => name,
        }
    }
}
