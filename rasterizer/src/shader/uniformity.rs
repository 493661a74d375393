//! Uniformity analysis: values, variables, loops and scopes that are the same for all lanes of a run. A uniform branch is
//! one scalar test, a uniform loop a jump, and neither reads a mask.
//!
//! A variable is uniform if all values stored in it are uniform and no lane can observe that it missed a store. A lane
//! misses stores while it is divergent: in a branch that it did not take, or after it left a loop, an iteration or a
//! scope, up to the end of that region. It cannot observe this if every read of the variable is inside of the region and
//! the region is not repeated. So a counter stays uniform in a branch that only some lanes take, and behind an early
//! `return`.
//!
//! The analysis begins with everything uniform and removes contradictions until a fixed point is reached.

use crate::ir::{Block, Expr, Module, Stmt, Value, Var};

/// The most rounds; if they do not suffice, nothing is taken as uniform.
const ROUNDS: usize = 32;

/// What is uniform.
#[derive(Debug, Default)]
pub(super) struct Uniformity {
    /// By value.
    values: Vec<bool>,
    /// By variable.
    variables: Vec<bool>,
    /// By loop, in the order of the code.
    loops: Vec<bool>,
    /// By scope, in the order of the code.
    scopes: Vec<bool>,
}

impl Uniformity {
    pub fn of(module: &Module) -> Self {
        let mut ranges = StatementRanges {
            reads: vec![None; module.variables.len()],
            ..StatementRanges::default()
        };
        ranges.block(module, &module.body);
        for (_, var) in &module.outputs {
            ranges.read(*var, u32::MAX);
        }
        let mut uniformity = Self {
            values: vec![false; module.values.len()],
            variables: module.variables.iter().map(|variable| variable.len == 1).collect(),
            loops: vec![true; ranges.loops],
            scopes: vec![true; ranges.scopes],
        };
        for _ in 0..ROUNDS {
            let mut walk = Walk {
                module,
                ranges: &ranges,
                uniformity: &mut uniformity,
                changed: false,
                at: 0,
                divergent: Vec::new(),
                loops: Vec::new(),
                scopes: Vec::new(),
                next_loop: 0,
                next_scope: 0,
            };
            walk.block(&module.body);
            if !walk.changed {
                return uniformity;
            }
        }
        Self::default()
    }

    /// Whether the value is the same word in all lanes wherever it is known.
    pub fn value(&self, module: &Module, value: Value) -> bool {
        match module.expr(value) {
            Expr::Const { .. } | Expr::Uniform { .. } => true,
            Expr::Input(_) => false,
            Expr::UniformAt { .. }
            | Expr::Load(_)
            | Expr::LoadAt { .. }
            | Expr::Op { .. }
            | Expr::Derivative { .. }
            | Expr::Tabulated { .. }
            | Expr::Sample(_)
            | Expr::Component { .. } => self.values.get(value.0 as usize) == Some(&true),
        }
    }

    /// Whether the variable holds one word in all lanes, and is stored in all.
    pub fn variable(&self, var: Var) -> bool {
        self.variables.get(var.0 as usize) == Some(&true)
    }

    /// Whether all lanes iterate this loop equally often.
    pub fn is_uniform_loop(&self, number: usize) -> bool {
        self.loops.get(number) == Some(&true)
    }

    /// Whether all lanes leave this scope at once.
    pub fn is_uniform_scope(&self, number: usize) -> bool {
        self.scopes.get(number) == Some(&true)
    }
}

/// The ends of statements and the reads of variables, counted in statements.
#[derive(Default)]
struct StatementRanges {
    /// By statement: the end of its first block, and its own.
    ends: Vec<[u32; 2]>,
    /// By variable: the first and the last read.
    reads: Vec<Option<[u32; 2]>>,
    loops: usize,
    scopes: usize,
}

impl StatementRanges {
    fn read(&mut self, var: Var, at: u32) {
        let [first, last] = self.reads[var.0 as usize].get_or_insert([at, at]);
        *first = at.min(*first);
        *last = at.max(*last);
    }

    fn block(&mut self, module: &Module, block: &Block) {
        for stmt in block {
            let at = self.ends.len();
            self.ends.push([0; 2]);
            match stmt {
                Stmt::Eval(value) => {
                    if let Expr::Load(var) | Expr::LoadAt { var, .. } = module.expr(*value) {
                        self.read(*var, at as u32);
                    }
                }
                Stmt::Loop { .. } => self.loops += 1,
                Stmt::Scope(_) => self.scopes += 1,
                Stmt::If { .. }
                | Stmt::Store { .. }
                | Stmt::StoreAt { .. }
                | Stmt::Break
                | Stmt::Continue
                | Stmt::Leave
                | Stmt::Discard
                | Stmt::EmitVertex(_)
                | Stmt::EndPrimitive => {}
            }
            let mut first = None;
            for inner in stmt.blocks() {
                self.block(module, inner);
                first.get_or_insert(self.ends.len() as u32);
            }
            let end = self.ends.len() as u32;
            self.ends[at] = [first.unwrap_or(end), end];
            if is_jump(stmt) {
                return;
            }
        }
    }
}

/// Whether nothing after the statement is reached.
fn is_jump(stmt: &Stmt) -> bool {
    match stmt {
        Stmt::Break | Stmt::Continue | Stmt::Leave | Stmt::Discard => true,
        Stmt::Eval(_)
        | Stmt::Store { .. }
        | Stmt::StoreAt { .. }
        | Stmt::If { .. }
        | Stmt::Loop { .. }
        | Stmt::Scope(_)
        | Stmt::EmitVertex(_)
        | Stmt::EndPrimitive => false,
    }
}

/// A region of code.
#[derive(Clone, Copy, PartialEq, Eq)]
enum CodeRegion {
    /// A side of this branch.
    Side(u32),
    /// An iteration of this loop.
    Iteration(u32),
    /// This loop or scope.
    Whole(u32),
}

/// A region that some lanes may have left while others execute it.
#[derive(Clone, Copy)]
struct DivergentRegion {
    region: CodeRegion,
    start: u32,
    end: u32,
    /// Whether the region itself may execute more than once.
    is_repeated: bool,
}

/// An open loop or scope.
#[derive(Clone, Copy)]
struct OpenConstruct {
    number: usize,
    start: u32,
    /// The number of divergent regions when it was entered.
    divergent: usize,
    /// How many loops are around it.
    depth: usize,
}

/// One round of the analysis.
struct Walk<'a> {
    module: &'a Module,
    ranges: &'a StatementRanges,
    uniformity: &'a mut Uniformity,
    changed: bool,
    /// The number of the next statement.
    at: u32,
    /// The regions that some lanes may have left.
    divergent: Vec<DivergentRegion>,
    loops: Vec<OpenConstruct>,
    scopes: Vec<OpenConstruct>,
    next_loop: usize,
    next_scope: usize,
}

impl Walk<'_> {
    fn block(&mut self, block: &Block) {
        for stmt in block {
            let start = self.at;
            self.at += 1;
            match stmt {
                Stmt::Eval(value) => {
                    self.uniformity.values[value.0 as usize] = self.eval(*value);
                }
                Stmt::Store { var, value } => self.store(*var, *value),
                Stmt::StoreAt { var, .. } => self.set_divergent(*var),
                Stmt::If { condition, accept, reject } => {
                    self.branch(start, *condition, accept, reject);
                }
                Stmt::Loop { body, continuing } => self.repeat(start, body, continuing),
                Stmt::Scope(body) => self.scope(start, body),
                Stmt::EmitVertex(_) | Stmt::EndPrimitive => {}
                Stmt::Break => return self.end_iteration(None),
                Stmt::Continue => {
                    let end = self.loops.last().map(|open| self.ends(open.start)[0]);
                    return self.end_iteration(end);
                }
                Stmt::Leave => return self.leave(),
                // Those lanes never come back, and a loop must end when there are no others.
                Stmt::Discard => return self.diverge_loops(0),
            }
        }
    }

    fn ends(&self, start: u32) -> [u32; 2] {
        self.ranges.ends[start as usize]
    }

    fn eval(&self, value: Value) -> bool {
        let is_uniform = |value| self.uniformity.value(self.module, value);
        match self.module.expr(value) {
            Expr::Const { .. } | Expr::Uniform { .. } => true,
            Expr::UniformAt { index, .. } => is_uniform(*index),
            Expr::Op { op, args } => args[..op.args().len()].iter().all(|arg| is_uniform(*arg)),
            Expr::Tabulated { value, .. } => is_uniform(*value),
            Expr::Load(var) => self.uniformity.variable(*var),
            Expr::Input(_)
            | Expr::LoadAt { .. }
            | Expr::Derivative { .. }
            | Expr::Sample(_)
            | Expr::Component { .. } => false,
        }
    }

    fn store(&mut self, var: Var, value: Value) {
        let reads = self.ranges.reads[var.0 as usize];
        let is_observed = |divergent: &DivergentRegion| {
            let inside = |[first, last]: [u32; 2]| divergent.start <= first && last < divergent.end;
            divergent.is_repeated || !reads.is_none_or(inside)
        };
        if !self.uniformity.value(self.module, value) || self.divergent.iter().any(is_observed) {
            self.set_divergent(var);
        }
    }

    fn set_divergent(&mut self, var: Var) {
        let flag = &mut self.uniformity.variables[var.0 as usize];
        self.changed |= std::mem::replace(flag, false);
    }

    fn branch(&mut self, start: u32, condition: Value, accept: &Block, reject: &Block) {
        let is_uniform = self.uniformity.value(self.module, condition);
        let [middle, end] = self.ends(start);
        let is_repeated = !self.loops.is_empty();
        let region = CodeRegion::Side(start);
        for (block, start, end) in [(accept, start, middle), (reject, middle, end)] {
            if !is_uniform {
                self.divergent.push(DivergentRegion { region, start, end, is_repeated });
            }
            self.block(block);
            self.at = end;
            self.rejoin(region);
        }
    }

    fn repeat(&mut self, start: u32, body: &Block, continuing: &Block) {
        let number = self.next_loop;
        self.next_loop += 1;
        let [middle, end] = self.ends(start);
        let depth = self.loops.len();
        if !self.uniformity.loops[number] {
            // From the second iteration on, lanes may have left.
            self.divergent.push(DivergentRegion {
                region: CodeRegion::Whole(start),
                start,
                end,
                is_repeated: depth > 0,
            });
        }
        self.loops.push(OpenConstruct { number, start, divergent: self.divergent.len(), depth });
        self.block(body);
        self.at = middle;
        self.rejoin(CodeRegion::Iteration(start));
        self.block(continuing);
        self.at = end;
        self.loops.pop();
        self.rejoin(CodeRegion::Whole(start));
    }

    /// Lanes rejoin at the end of a region.
    fn rejoin(&mut self, from: CodeRegion) {
        self.divergent.retain(|divergent| divergent.region != from);
    }

    fn scope(&mut self, start: u32, body: &Block) {
        let number = self.next_scope;
        self.next_scope += 1;
        let depth = self.loops.len();
        self.scopes.push(OpenConstruct { number, start, divergent: self.divergent.len(), depth });
        self.block(body);
        let end = self.ends(start)[1];
        self.at = end;
        self.scopes.pop();
        self.rejoin(CodeRegion::Whole(start));
    }

    /// A `Break`, or a `Continue` to the end of the body.
    fn end_iteration(&mut self, body: Option<u32>) {
        let Some(open) = self.loops.last().copied() else { return };
        if self.divergent.len() == open.divergent && self.uniformity.loops[open.number] {
            return;
        }
        self.diverge_loops(open.depth);
        if let Some(end) = body {
            let (region, start) = (CodeRegion::Iteration(open.start), open.start);
            self.divergent.push(DivergentRegion { region, start, end, is_repeated: true });
        }
    }

    fn leave(&mut self) {
        let Some(open) = self.scopes.last().copied() else { return };
        if self.divergent.len() == open.divergent && self.uniformity.scopes[open.number] {
            return;
        }
        let flag = &mut self.uniformity.scopes[open.number];
        self.changed |= std::mem::replace(flag, false);
        self.diverge_loops(open.depth);
        let end = self.ends(open.start)[1];
        let (region, start) = (CodeRegion::Whole(open.start), open.start);
        self.divergent.push(DivergentRegion { region, start, end, is_repeated: open.depth > 0 });
    }

    /// Lanes leave the loops from this one inwards at different times.
    fn diverge_loops(&mut self, outermost: usize) {
        for open in &self.loops[outermost..] {
            let flag = &mut self.uniformity.loops[open.number];
            self.changed |= std::mem::replace(flag, false);
        }
    }
}
