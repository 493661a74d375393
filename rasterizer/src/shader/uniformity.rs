//! What every lane of a run does alike: values, variables, and the loops and scopes that lanes leave
//! together. Such a branch is one scalar test, such a loop a jump, and neither reads a mask.
//!
//! A variable is alike if all that is stored in it is, and no lane misses a store that it could
//! notice. A lane misses stores while it is away: in a branch it did not take, or after it left a
//! loop, a turn or a scope, up to the end of that. It does not notice if every read of the variable
//! stands in there, where it does not come again. So a counter stays alike in a branch that only some
//! lanes take, and behind an early `return`.
//!
//! It begins with all alike, and takes away what contradicts itself until nothing does.

use crate::ir::{Block, Expr, Module, Stmt, Value, Var};

/// The most rounds; if they do not suffice, nothing is taken as uniform.
const ROUNDS: usize = 32;

/// What is uniform.
#[derive(Debug, Default)]
pub(super) struct Alike {
    /// By value.
    values: Vec<bool>,
    /// By variable.
    variables: Vec<bool>,
    /// By loop, in the order of the code.
    loops: Vec<bool>,
    /// By scope, in the order of the code.
    scopes: Vec<bool>,
}

impl Alike {
    pub fn of(module: &Module) -> Self {
        let mut places = Places { reads: vec![None; module.variables.len()], ..Places::default() };
        places.block(module, &module.body);
        for (_, var) in &module.outputs {
            places.read(*var, u32::MAX);
        }
        let mut alike = Self {
            values: vec![false; module.values.len()],
            variables: module.variables.iter().map(|variable| variable.len == 1).collect(),
            loops: vec![true; places.loops],
            scopes: vec![true; places.scopes],
        };
        for _ in 0..ROUNDS {
            let mut walk = Walk {
                module,
                places: &places,
                alike: &mut alike,
                changed: false,
                at: 0,
                away: Vec::new(),
                loops: Vec::new(),
                scopes: Vec::new(),
                next_loop: 0,
                next_scope: 0,
            };
            walk.block(&module.body);
            if !walk.changed {
                return alike;
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
            | Expr::Sample(_)
            | Expr::Component { .. } => self.values.get(value.0 as usize) == Some(&true),
        }
    }

    /// Whether the variable holds one word in all lanes, and is stored in all.
    pub fn variable(&self, var: Var) -> bool {
        self.variables.get(var.0 as usize) == Some(&true)
    }

    /// Whether lanes take all turns of this loop together.
    pub fn turns(&self, number: usize) -> bool {
        self.loops.get(number) == Some(&true)
    }

    /// Whether lanes leave this scope together.
    pub fn scope(&self, number: usize) -> bool {
        self.scopes.get(number) == Some(&true)
    }
}

/// Where statements end and variables are read, counted in statements.
#[derive(Default)]
struct Places {
    /// By statement: the end of its first block, and its own.
    ends: Vec<[u32; 2]>,
    /// By variable: the first and the last read.
    reads: Vec<Option<[u32; 2]>>,
    loops: usize,
    scopes: usize,
}

impl Places {
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
                | Stmt::Discard => {}
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
        | Stmt::Scope(_) => false,
    }
}

/// What lanes are away from.
#[derive(Clone, Copy, PartialEq, Eq)]
enum CodeRegion {
    /// A side of this branch.
    Side(u32),
    /// An iteration of this loop.
    Iteration(u32),
    /// This loop or scope.
    Whole(u32),
}

/// A part of the code that some lanes may not be in while others are.
#[derive(Clone, Copy)]
struct DivergentRegion {
    part: CodeRegion,
    start: u32,
    end: u32,
    /// Whether the part itself is run more than once.
    again: bool,
}

/// An open loop or scope.
#[derive(Clone, Copy)]
struct Open {
    number: usize,
    start: u32,
    /// How many parts had lanes away when it was entered.
    away: usize,
    /// How many loops are around it.
    depth: usize,
}

/// One round.
struct Walk<'a> {
    module: &'a Module,
    places: &'a Places,
    alike: &'a mut Alike,
    changed: bool,
    /// The number of the next statement.
    at: u32,
    /// The parts that lanes may be away from here.
    away: Vec<DivergentRegion>,
    loops: Vec<Open>,
    scopes: Vec<Open>,
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
                    self.alike.values[value.0 as usize] = self.eval(*value);
                }
                Stmt::Store { var, value } => self.store(*var, *value),
                Stmt::StoreAt { var, .. } => self.varies(*var),
                Stmt::If { condition, accept, reject } => {
                    self.branch(start, *condition, accept, reject);
                }
                Stmt::Loop { body, continuing } => self.repeat(start, body, continuing),
                Stmt::Scope(body) => self.scope(start, body),
                Stmt::Break => return self.end_turn(None),
                Stmt::Continue => {
                    let end = self.loops.last().map(|open| self.ends(open.start)[0]);
                    return self.end_turn(end);
                }
                Stmt::Leave => return self.leave(),
                // Those lanes never come back, and a loop must end when there are no others.
                Stmt::Discard => return self.part_ways(0),
            }
        }
    }

    fn ends(&self, start: u32) -> [u32; 2] {
        self.places.ends[start as usize]
    }

    fn eval(&self, value: Value) -> bool {
        let alike = |value| self.alike.value(self.module, value);
        match self.module.expr(value) {
            Expr::Const { .. } | Expr::Uniform { .. } => true,
            Expr::UniformAt { index, .. } => alike(*index),
            Expr::Op { op, args } => args[..op.args().len()].iter().all(|arg| alike(*arg)),
            Expr::Load(var) => self.alike.variable(*var),
            Expr::Input(_)
            | Expr::LoadAt { .. }
            | Expr::Derivative { .. }
            | Expr::Sample(_)
            | Expr::Component { .. } => false,
        }
    }

    fn store(&mut self, var: Var, value: Value) {
        let reads = self.places.reads[var.0 as usize];
        let notices = |away: &DivergentRegion| {
            let inside = |[first, last]: [u32; 2]| away.start <= first && last < away.end;
            away.again || !reads.is_none_or(inside)
        };
        if !self.alike.value(self.module, value) || self.away.iter().any(notices) {
            self.varies(var);
        }
    }

    fn varies(&mut self, var: Var) {
        let known = &mut self.alike.variables[var.0 as usize];
        self.changed |= std::mem::replace(known, false);
    }

    fn branch(&mut self, start: u32, condition: Value, accept: &Block, reject: &Block) {
        let together = self.alike.value(self.module, condition);
        let [middle, end] = self.ends(start);
        let again = !self.loops.is_empty();
        let part = CodeRegion::Side(start);
        for (block, start, end) in [(accept, start, middle), (reject, middle, end)] {
            if !together {
                self.away.push(DivergentRegion { part, start, end, again });
            }
            self.block(block);
            self.at = end;
            self.back(part);
        }
    }

    fn repeat(&mut self, start: u32, body: &Block, continuing: &Block) {
        let number = self.next_loop;
        self.next_loop += 1;
        let [middle, end] = self.ends(start);
        let depth = self.loops.len();
        if !self.alike.loops[number] {
            // From the second iteration on, lanes may have left.
            self.away.push(DivergentRegion {
                part: CodeRegion::Whole(start),
                start,
                end,
                again: depth > 0,
            });
        }
        self.loops.push(Open { number, start, away: self.away.len(), depth });
        self.block(body);
        self.at = middle;
        self.back(CodeRegion::Iteration(start));
        self.block(continuing);
        self.at = end;
        self.loops.pop();
        self.back(CodeRegion::Whole(start));
    }

    /// Lanes rejoin at the end of a region.
    fn back(&mut self, from: CodeRegion) {
        self.away.retain(|away| away.part != from);
    }

    fn scope(&mut self, start: u32, body: &Block) {
        let number = self.next_scope;
        self.next_scope += 1;
        let depth = self.loops.len();
        self.scopes.push(Open { number, start, away: self.away.len(), depth });
        self.block(body);
        let end = self.ends(start)[1];
        self.at = end;
        self.scopes.pop();
        self.back(CodeRegion::Whole(start));
    }

    /// A `Break`, or a `Continue` to the end of the body.
    fn end_turn(&mut self, body: Option<u32>) {
        let Some(open) = self.loops.last().copied() else { return };
        if self.away.len() == open.away && self.alike.loops[open.number] {
            return;
        }
        self.part_ways(open.depth);
        if let Some(end) = body {
            let (part, start) = (CodeRegion::Iteration(open.start), open.start);
            self.away.push(DivergentRegion { part, start, end, again: true });
        }
    }

    fn leave(&mut self) {
        let Some(open) = self.scopes.last().copied() else { return };
        if self.away.len() == open.away && self.alike.scopes[open.number] {
            return;
        }
        let known = &mut self.alike.scopes[open.number];
        self.changed |= std::mem::replace(known, false);
        self.part_ways(open.depth);
        let end = self.ends(open.start)[1];
        let (part, start) = (CodeRegion::Whole(open.start), open.start);
        self.away.push(DivergentRegion { part, start, end, again: open.depth > 0 });
    }

    /// Lanes leave the loops from this one inwards on their own.
    fn part_ways(&mut self, outermost: usize) {
        for open in &self.loops[outermost..] {
            let known = &mut self.alike.loops[open.number];
            self.changed |= std::mem::replace(known, false);
        }
    }
}
