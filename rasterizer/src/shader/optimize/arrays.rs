//! Arrays that are only indexed by constants become scalars.

use crate::ir::{Block, Expr, Module, Stmt, Value, Var, Variable};

/// Runs the pass; returns whether it changed the module.
pub(super) fn run(module: &mut Module) -> bool {
    let mut indexed = vec![false; module.variables.len()];
    let mut body = std::mem::take(&mut module.body);
    for stmt in &body {
        stmt.walk(&mut |stmt| {
            let (var, index) = if let Stmt::StoreAt { var, index, .. } = stmt {
                (var, index)
            } else if let Stmt::Eval(value) = stmt
                && let Expr::LoadAt { var, index } = module.expr(*value)
            {
                (var, index)
            } else {
                return;
            };
            indexed[var.0 as usize] |= module.constant(*index).is_none();
        });
    }
    // By array: the variables that its elements become.
    let mut elements: Vec<Option<Elements>> = Vec::with_capacity(indexed.len());
    for (at, indexed) in indexed.into_iter().enumerate() {
        let Variable { ty, len, ref name } = module.variables[at];
        let first = module.variables.len() as u32;
        let split = len > 1 && !indexed;
        elements.push(split.then_some(Elements { first, len }));
        if split {
            let names: Vec<String> = (0..len).map(|element| format!("{name}[{element}]")).collect();
            module.variables.extend(names.into_iter().map(|name| Variable { ty, len: 1, name }));
            // Nothing names the array any more.
            module.variables[at].len = 1;
        }
    }
    let any = elements.iter().any(Option::is_some);
    if any {
        Split { module, elements }.block(&mut body);
    }
    module.body = body;
    any
}

#[derive(Clone, Copy)]
struct Elements {
    first: u32,
    len: u32,
}

struct Split<'a> {
    module: &'a mut Module,
    elements: Vec<Option<Elements>>,
}

impl Split<'_> {
    fn element(&self, var: Var, index: Value) -> Option<Var> {
        let Elements { first, len } = self.elements[var.0 as usize]?;
        Some(Var(first + self.module.constant(index)?.min(len - 1)))
    }

    fn block(&mut self, block: &mut Block) {
        for stmt in block {
            match stmt {
                Stmt::StoreAt { var, index, value } => {
                    if let Some(var) = self.element(*var, *index) {
                        *stmt = Stmt::Store { var, value: *value };
                    }
                }
                Stmt::Eval(value) => {
                    if let Expr::LoadAt { var, index } = *self.module.expr(*value)
                        && let Some(var) = self.element(var, index)
                    {
                        self.module.values[value.0 as usize] = Expr::Load(var);
                    }
                }
                Stmt::If { accept: a, reject: b, .. } | Stmt::Loop { body: a, continuing: b } => {
                    self.block(a);
                    self.block(b);
                }
                Stmt::Scope(body) => self.block(body),
                Stmt::Store { .. }
                | Stmt::EmitVertex(_)
                | Stmt::EndPrimitive
                | Stmt::Break
                | Stmt::Continue
                | Stmt::Leave
                | Stmt::Discard => {}
            }
        }
    }
}
