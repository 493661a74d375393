//! Program pipeline objects, which are a context's own: ARB_separate_shader_objects, section 2.14.PPO.

use crate::base::types::GLuint;
use crate::glsl::{Stage, WordsOfPart};
use crate::objects::bound::Bound;
use crate::objects::name_table::NameTable;
use crate::objects::programs::{LinkSources, Linked};
use std::sync::Arc;

/// The stages of a pipeline, in order.
pub(crate) const STAGES: [Stage; 3] = [Stage::Vertex, Stage::Geometry, Stage::Fragment];

/// A program pipeline object.
#[derive(Debug, Default)]
pub(crate) struct ProgramPipeline {
    /// The program of each of [`STAGES`].
    pub stages: [Bound; 3],
    /// The program whose uniforms `glUniform` sets.
    pub active: Bound,
    pub validated: bool,
    pub log: String,
}

impl ProgramPipeline {
    /// The names of its programs, by stage.
    pub fn names(&self) -> [GLuint; 3] {
        [0, 1, 2].map(|stage| self.stages[stage].name())
    }
}

/// What the programs of a pipeline were linked from, by stage.
pub(crate) type PipelineKey = [Option<Arc<LinkSources>>; 3];

/// The programs of a pipeline, linked together.
#[derive(Debug)]
pub(crate) struct PipelineExecutable {
    pub key: PipelineKey,
    /// The executable, or why there is none.
    pub result: Result<Box<Linked>, String>,
    /// The stage by which each program is found.
    pub parts: Vec<usize>,
    /// Where its uniforms come from.
    pub words: Vec<WordsOfPart>,
    /// Where each of its uniform blocks comes from: the program, and the index there.
    pub blocks: Vec<(usize, usize)>,
}

/// What the bound pipeline draws with.
#[derive(Debug, Default)]
pub(crate) enum PipelineInUse {
    /// It has no program.
    #[default]
    Empty,
    /// An executable, by its index.
    Linked(usize),
    /// It cannot run, and why.
    Refused(String),
}

/// The pipelines of a context.
#[derive(Debug, Default)]
pub(crate) struct Pipelines {
    pub named: NameTable<ProgramPipeline>,
    /// The name of the bound one.
    pub bound: GLuint,
    /// What was linked for them.
    pub linked: Vec<PipelineExecutable>,
    /// What the bound one draws with, as of the last draw.
    pub in_use: PipelineInUse,
}

impl Pipelines {
    /// The bound pipeline.
    pub fn current(&self) -> Option<&ProgramPipeline> {
        if self.bound == 0 { None } else { self.named.get(self.bound) }
    }

    /// The executable of the bound pipeline.
    pub fn executable(&self) -> Option<&Linked> {
        match self.in_use {
            PipelineInUse::Linked(index) if self.bound != 0 => {
                self.linked.get(index)?.result.as_deref().ok()
            }
            PipelineInUse::Linked(_) | PipelineInUse::Empty | PipelineInUse::Refused(_) => None,
        }
    }

    /// The same, to be changed.
    pub fn executable_mut(&mut self) -> Option<&mut Linked> {
        match self.in_use {
            PipelineInUse::Linked(index) if self.bound != 0 => {
                self.linked.get_mut(index)?.result.as_deref_mut().ok()
            }
            PipelineInUse::Linked(_) | PipelineInUse::Empty | PipelineInUse::Refused(_) => None,
        }
    }
}
