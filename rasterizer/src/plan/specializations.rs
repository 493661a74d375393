//! The fragment programs that a pipeline's was specialized to by what is known of its draws.

use super::Pipeline;
use super::pipeline::SHALLOW;
use crate::ir::Module;
use crate::shader::{FactSources, Facts, Program};
use parking_lot::Mutex;

/// The most programs that a fragment program is specialized to.
const MAX_SPECIALIZATIONS: usize = 8;

/// What fragment programs are specialized from.
#[derive(Debug)]
pub(super) struct Specializable {
    /// The module that was lowered.
    pub module: Module,
    pub sources: FactSources,
    known: Mutex<Vec<Specialization>>,
}

/// The draws with some facts.
#[derive(Debug)]
struct Specialization {
    facts: Facts,
    /// What was compiled for them; `None` for the general program.
    pipeline: Option<Pipeline>,
    state: SpecializationState,
}

/// Whether a program was compiled for facts: at the second draw that has them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SpecializationState {
    SeenOnce,
    Compiled,
}

impl Specializable {
    /// That of a program which was lowered from this module, if any draw may know facts of it.
    pub fn new(program: &Program, module: Module) -> Option<Self> {
        let sources = program.fact_sources(&module);
        let is_small = !module.nests_deeper_than(SHALLOW);
        let depends = program.depends_on_uniforms() || !program.texture_slots().is_empty();
        (is_small && depends).then(|| Self { module, sources, known: Mutex::default() })
    }

    /// The pipeline for facts, which `compile` makes at the second draw that has them.
    pub fn find(
        &self,
        facts: Facts,
        compile: impl FnOnce(&Facts) -> Option<Pipeline>,
    ) -> Option<Pipeline> {
        let mut known = self.known.lock();
        let Some(found) = known.iter_mut().find(|known| known.facts == facts) else {
            if known.len() < MAX_SPECIALIZATIONS {
                let state = SpecializationState::SeenOnce;
                known.push(Specialization { facts, pipeline: None, state });
            }
            return None;
        };
        if found.state == SpecializationState::SeenOnce {
            found.state = SpecializationState::Compiled;
            found.pipeline = compile(&found.facts);
        }
        found.pipeline.clone()
    }
}
