//! A module that is optimized, before it becomes a program.

use super::optimize;
use super::optimize::SideVaryings;
use super::program::{Fusing, Program};
use crate::ir::{Block, Module, Output, Stmt};

/// By which formula lookups with an implicit level of detail have it (GL 2.1, section 3.8.8).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LevelOfDetail {
    /// From the derivatives along x and y.
    Polygons,
    /// Of lines from the derivative along the line, else as of polygons.
    Lines,
    /// Of points, pixel rectangles and bitmaps, whose coordinates are the same everywhere: 1, not what derivatives of 0 give.
    UnitScaleFactor,
}

/// A module that is optimized by itself, and not lowered.
pub(crate) struct OptimizedModule {
    pub module: Module,
    /// How many statements it had before.
    statements_before: usize,
}

impl OptimizedModule {
    /// Optimizes `module`, keeping only the outputs for which `keep` holds. The module has been validated.
    pub fn new(module: &Module, keep: impl Fn(Output) -> bool) -> Self {
        let mut module = module.clone();
        let before = statements(&module);
        module.outputs.retain(|(output, _)| keep(*output));
        retain_emitted(&mut module, keep);
        optimize::optimize(&mut module);
        Self { module, statements_before: before }
    }

    /// Hoists what vertices can compute as well to `vertex`, the module of the vertex stage that this one runs with;
    /// `None` where there is nothing to hoist.
    pub fn hoist_to_vertex(&mut self, vertex: &Module) -> Option<Module> {
        optimize::hoist_to_vertex(vertex, &mut self.module)
    }

    /// Gives its lookups the level of detail.
    pub fn finish(&mut self, lod: LevelOfDetail) {
        optimize::finish(&mut self.module, lod);
    }

    /// Makes one varying of those that it selects by facing. It must be finished.
    pub fn merge_sides(&mut self) -> Vec<SideVaryings> {
        optimize::merge_sides(&mut self.module)
    }

    /// Lowers it, and returns the module that was lowered.
    pub fn lower(self) -> (Program, Module) {
        let left = statements(&self.module);
        let program = Program {
            statements: [self.statements_before, left],
            ..Program::lowered(&self.module, Fusing::On)
        };
        (program, self.module)
    }
}

/// Keeps of what a geometry module emits only the outputs for which `keep` holds.
fn retain_emitted(module: &mut Module, keep: impl Fn(Output) -> bool) {
    fn block(stmts: &mut Block, kept: &[bool]) {
        for stmt in stmts {
            match stmt {
                Stmt::EmitVertex(values) => {
                    let mut kept = kept.iter();
                    values.retain(|_| kept.next() == Some(&true));
                }
                Stmt::If { accept: a, reject: b, .. } | Stmt::Loop { body: a, continuing: b } => {
                    block(a, kept);
                    block(b, kept);
                }
                Stmt::Scope(body) => block(body, kept),
                Stmt::Eval(_)
                | Stmt::Store { .. }
                | Stmt::StoreAt { .. }
                | Stmt::Break
                | Stmt::Continue
                | Stmt::Leave
                | Stmt::Discard
                | Stmt::EndPrimitive => {}
            }
        }
    }
    let Some(interface) = &mut module.geometry else { return };
    let kept: Vec<bool> = interface.outputs.iter().map(|output| keep(*output)).collect();
    interface.outputs.retain(|output| keep(*output));
    block(&mut module.body, &kept);
}

/// How many statements a module has.
pub(super) fn statements(module: &Module) -> usize {
    let mut count = 0;
    module.body.iter().for_each(|stmt| stmt.walk(&mut |_| count += 1));
    count
}
