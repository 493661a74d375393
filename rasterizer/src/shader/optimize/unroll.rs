//! Loop unrolling: a loop whose iterations can be counted becomes that many copies of its body.
//!
//! A loop is tried out: its statements run on what is known where it begins, until the one `break`
//! at its outermost level is taken. So any counter, step and condition will do. Loops with other
//! ways out, or with a `continue`, stay.

use crate::ir::{Block, Expr, Module, Stmt, Value, Var};
use std::collections::HashMap;

/// How many statements the copies of one loop may have.
const LARGEST: usize = 1024;

/// The copies of a loop's statements, if it can be unrolled into at most `max_statements` statements.
/// `known` gives the word of a value that is constant, `variable` that of a variable, where the
/// loop begins.
pub(super) fn run(
    module: &mut Module,
    [body, continuing]: [&Block; 2],
    max_statements: usize,
    known: impl Fn(&Module, Value) -> Option<u32>,
    variable: impl Fn(&Module, Var) -> Option<u32>,
) -> Option<Block> {
    let iteration: Vec<&Stmt> = body.iter().chain(continuing).collect();
    let exit = exit_of(&iteration)?;
    let mut size = 0;
    iteration.iter().for_each(|stmt| stmt.walk(&mut |_| size += 1));
    let iterations =
        TrialRun { module, known, variable, values: HashMap::new(), variables: HashMap::new() }
            .iterations(&iteration, exit, LARGEST.min(max_statements) / size)?;
    let mut out = Vec::with_capacity(iterations * iteration.len() + exit);
    for at in 0..=iterations {
        let mut copy = Copy { module, of: HashMap::new() };
        let end = if at == iterations { exit } else { iteration.len() };
        for (place, stmt) in iteration[..end].iter().enumerate() {
            if place != exit {
                out.push(copy.stmt(stmt));
            }
        }
    }
    Some(out)
}

/// Where the only `break` of a loop stands, if no other statement ends an iteration.
fn exit_of(iteration: &[&Stmt]) -> Option<usize> {
    let mut exits = iteration.iter().enumerate().filter(|(_, stmt)| exits_iteration(stmt));
    match (exits.next(), exits.next()) {
        (Some((at, Stmt::If { accept, reject, .. })), None) => {
            let exit =
                matches!((&accept[..], &reject[..]), ([Stmt::Break], []) | ([], [Stmt::Break]));
            exit.then_some(at)
        }
        _ => None,
    }
}

/// Whether a statement holds a `break` or `continue` of the loop that it stands in.
fn exits_iteration(stmt: &Stmt) -> bool {
    match stmt {
        Stmt::Break | Stmt::Continue => true,
        Stmt::Loop { .. }
        | Stmt::Eval(_)
        | Stmt::Store { .. }
        | Stmt::StoreAt { .. }
        | Stmt::Leave
        | Stmt::Discard
        | Stmt::EmitVertex(_)
        | Stmt::EndPrimitive => false,
        Stmt::If { .. } | Stmt::Scope(_) => stmt.blocks().flatten().any(exits_iteration),
    }
}

/// A loop that is run on what is known.
struct TrialRun<'a, K, V> {
    module: &'a Module,
    known: K,
    variable: V,
    /// The values of this iteration.
    values: HashMap<Value, Option<u32>>,
    /// What the loop has stored.
    variables: HashMap<Var, Option<u32>>,
}

impl<K, V> TrialRun<'_, K, V>
where
    K: Fn(&Module, Value) -> Option<u32>,
    V: Fn(&Module, Var) -> Option<u32>,
{
    /// How many whole iterations there are, if at most `most`.
    fn iterations(mut self, iteration: &[&Stmt], exit: usize, most: usize) -> Option<usize> {
        for iterations in 0..=most {
            for (at, stmt) in iteration.iter().enumerate() {
                match stmt {
                    Stmt::If { condition, accept, .. } if at == exit => {
                        let holds = self.value(*condition)? != 0;
                        if holds != accept.is_empty() {
                            return Some(iterations);
                        }
                    }
                    Stmt::Eval(value) => {
                        let word = self.eval(*value);
                        self.values.insert(*value, word);
                    }
                    Stmt::Store { var, value } => {
                        let word = self.value(*value);
                        self.variables.insert(*var, word);
                    }
                    _ => stmt.walk(&mut |stmt| {
                        if let Stmt::Store { var, .. } = stmt {
                            self.variables.insert(*var, None);
                        }
                    }),
                }
            }
        }
        None
    }

    fn value(&self, value: Value) -> Option<u32> {
        self.values.get(&value).copied().unwrap_or_else(|| (self.known)(self.module, value))
    }

    fn eval(&self, value: Value) -> Option<u32> {
        match self.module.expr(value) {
            Expr::Load(var) => {
                let stored = self.variables.get(var).copied();
                stored.unwrap_or_else(|| (self.variable)(self.module, *var))
            }
            Expr::Op { op, args } => {
                let mut words = [0; 3];
                for (word, arg) in words.iter_mut().zip(&args[..op.args().len()]) {
                    *word = self.value(*arg)?;
                }
                Some(op.eval(words))
            }
            Expr::Const { .. }
            | Expr::Input(_)
            | Expr::Uniform { .. }
            | Expr::UniformAt { .. }
            | Expr::LoadAt { .. }
            | Expr::Derivative { .. }
            | Expr::Tabulated { .. }
            | Expr::Sample(_)
            | Expr::Component { .. } => self.value(value),
        }
    }
}

/// A copy of an iteration, with values of its own.
struct Copy<'a> {
    module: &'a mut Module,
    of: HashMap<Value, Value>,
}

impl Copy<'_> {
    fn value(&self, value: Value) -> Value {
        self.of.get(&value).copied().unwrap_or(value)
    }

    fn block(&mut self, block: &Block) -> Block {
        block.iter().map(|stmt| self.stmt(stmt)).collect()
    }

    fn stmt(&mut self, stmt: &Stmt) -> Stmt {
        match stmt {
            Stmt::Eval(value) => {
                let expr = self.module.expr(*value).map(&mut |operand| self.value(operand));
                let copy = Value(self.module.values.len() as u32);
                self.module.values.push(expr);
                self.of.insert(*value, copy);
                Stmt::Eval(copy)
            }
            Stmt::Store { var, value } => Stmt::Store { var: *var, value: self.value(*value) },
            Stmt::StoreAt { var, index, value } => {
                Stmt::StoreAt { var: *var, index: self.value(*index), value: self.value(*value) }
            }
            Stmt::If { condition, accept, reject } => Stmt::If {
                condition: self.value(*condition),
                accept: self.block(accept),
                reject: self.block(reject),
            },
            Stmt::Loop { body, continuing } => {
                Stmt::Loop { body: self.block(body), continuing: self.block(continuing) }
            }
            Stmt::Scope(body) => Stmt::Scope(self.block(body)),
            Stmt::EmitVertex(values) => {
                Stmt::EmitVertex(values.iter().map(|value| self.value(*value)).collect())
            }
            Stmt::Break | Stmt::Continue | Stmt::Leave | Stmt::Discard | Stmt::EndPrimitive => {
                stmt.clone()
            }
        }
    }
}
