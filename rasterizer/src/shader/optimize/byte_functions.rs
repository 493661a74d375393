//! Long functions of the bytes of a texel, as tables: `pow(texture2D(…).r, 2.2)` has 256 results where the lookup gives
//! one texel of bytes. The table is computed by the operations that it replaces.

use super::super::Facts;
use super::super::facts::filtered_slot;
use crate::ir::{ByteTable, Expr, FunctionTable, Module, Op, Stmt, Ty, Value};
use std::sync::Arc;

/// Functions of more values stay.
const MAX_VALUES: usize = 24;

/// The most tables of a module: they share the first cache with the registers.
const MAX_TABLES: usize = 8;

/// The texture slots of which the module computes long functions, if their lookups gave bytes; bit by slot.
pub(in super::super) fn slots(module: &Module) -> u64 {
    let mut slots = 0;
    evaluated(module, |value| {
        let slot = |value| slot_of_component(module, value);
        if let Some(function) = Function::of(module, value, |value| slot(value).is_some()) {
            slots |= slot(function.source).map_or(0, |slot| 1 << slot);
        }
    });
    slots
}

/// Runs the pass.
pub(super) fn run(module: &mut Module, facts: &Facts) {
    let mut values = Vec::new();
    evaluated(module, |value| values.push(value));
    let mut tables: Vec<Arc<ByteTable>> = Vec::new();
    for value in values {
        let Some(function) = Function::of(module, value, |value| facts.is_byte(module, value))
        else {
            continue;
        };
        let table = ByteTable::new(|fraction| function.eval(fraction));
        let known = tables.iter().find(|known| ***known == table).cloned();
        let table = match known {
            Some(table) => table,
            None if tables.len() == MAX_TABLES => continue,
            None => {
                let table = Arc::new(table);
                tables.push(Arc::clone(&table));
                table
            }
        };
        module.values[value.0 as usize] =
            Expr::Tabulated { value: function.source, table: FunctionTable::OfByte(table) };
    }
}

/// The values that statements evaluate, in program order.
fn evaluated(module: &Module, mut f: impl FnMut(Value)) {
    let mut visit = |stmt: &Stmt| {
        if let Stmt::Eval(value) = stmt {
            f(*value);
        }
    };
    module.body.iter().for_each(|stmt| stmt.walk(&mut visit));
}

/// The texture slot of a component of a filtered lookup.
fn slot_of_component(module: &Module, value: Value) -> Option<u32> {
    let Expr::Component { sample, .. } = module.expr(value) else { return None };
    filtered_slot(module, *sample)
}

/// A value that a function computes.
enum Node {
    /// The component.
    Source,
    Const(u32),
    /// Of nodes before it; beyond the arity 0.
    Op {
        op: Op,
        args: [usize; 3],
    },
    /// Of a node before it.
    Tabulated {
        of: usize,
        table: FunctionTable,
    },
}

/// A long function of one component of a lookup.
struct Function {
    /// The component.
    source: Value,
    /// Operands first; the result is the last.
    nodes: Vec<Node>,
}

impl Function {
    /// The function that a value is the result of, if its last operation is long, and if it depends on nothing but
    /// constants and one component for which `is_source` holds.
    fn of(module: &Module, value: Value, is_source: impl Fn(Value) -> bool) -> Option<Self> {
        match module.expr(value) {
            Expr::Op { op, .. } if op.cost() >= Op::Pow.cost() && op.result() == Ty::F32 => {}
            Expr::Tabulated { table: FunctionTable::Power(_), .. } => {}
            Expr::Tabulated { table: FunctionTable::OfByte(_), .. }
            | Expr::Op { .. }
            | Expr::Const { .. }
            | Expr::Input(_)
            | Expr::Uniform { .. }
            | Expr::UniformAt { .. }
            | Expr::Load(_)
            | Expr::LoadAt { .. }
            | Expr::Derivative { .. }
            | Expr::Sample(_)
            | Expr::Component { .. } => return None,
        }
        let mut search =
            Search { module, is_source, source: None, values: Vec::new(), nodes: Vec::new() };
        search.add(value, MAX_VALUES)?;
        Some(Self { source: search.source?, nodes: search.nodes })
    }

    /// Its result for a fraction.
    fn eval(&self, fraction: f32) -> u32 {
        let mut words = [0; MAX_VALUES];
        for (at, node) in self.nodes.iter().enumerate() {
            words[at] = match node {
                Node::Source => fraction.to_bits(),
                Node::Const(bits) => *bits,
                Node::Op { op, args } => op.eval(args.map(|arg| words[arg])),
                Node::Tabulated { of, table } => table.word(f32::from_bits(words[*of])),
            };
        }
        words[self.nodes.len() - 1]
    }
}

struct Search<'a, F> {
    module: &'a Module,
    is_source: F,
    source: Option<Value>,
    /// By node.
    values: Vec<Value>,
    nodes: Vec<Node>,
}

impl<F: Fn(Value) -> bool> Search<'_, F> {
    /// The node of a value, at most so many operands deep.
    fn add(&mut self, value: Value, depth: usize) -> Option<usize> {
        if let Some(known) = self.values.iter().position(|known| *known == value) {
            return Some(known);
        }
        let depth = depth.checked_sub(1)?;
        let node = match self.module.expr(value) {
            Expr::Const { bits, .. } => Node::Const(*bits),
            Expr::Component { .. } => {
                let is_other = *self.source.get_or_insert(value) != value;
                if is_other || !(self.is_source)(value) {
                    return None;
                }
                Node::Source
            }
            Expr::Op { op, args } => {
                let mut nodes = [0; 3];
                for (node, arg) in nodes.iter_mut().zip(&args[..op.args().len()]) {
                    *node = self.add(*arg, depth)?;
                }
                Node::Op { op: *op, args: nodes }
            }
            Expr::Tabulated { value, table } => {
                Node::Tabulated { of: self.add(*value, depth)?, table: table.clone() }
            }
            Expr::Input(_)
            | Expr::Uniform { .. }
            | Expr::UniformAt { .. }
            | Expr::Load(_)
            | Expr::LoadAt { .. }
            | Expr::Derivative { .. }
            | Expr::Sample(_) => return None,
        };
        if self.nodes.len() == MAX_VALUES {
            return None;
        }
        self.values.push(value);
        self.nodes.push(node);
        Some(self.nodes.len() - 1)
    }
}
