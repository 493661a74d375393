//! Functions.

use super::{Direction, Stmt, Storage, Variable};
use crate::text::source::Span;
use crate::types::Type;
use std::sync::Arc;

/// A function.
#[derive(Clone, Debug)]
pub struct Function {
    /// Its name.
    pub name: Arc<str>,
    /// The directions of its parameters, whose variables are the first locals.
    pub directions: Vec<Direction>,
    /// What it returns.
    pub result: Type,
    /// Parameters and local variables.
    pub locals: Vec<Variable>,
    /// Its body; `None` for a prototype.
    pub body: Option<Vec<Stmt>>,
    /// Where its name stands.
    pub span: Span,
    /// The line of that, as `#line` counts.
    pub line: i64,
    /// The functions it calls, with repetitions.
    pub calls: Vec<(u32, Span)>,
    /// The globals it references, each once, in order.
    pub globals: Vec<u32>,
}

impl Function {
    /// The storage of each parameter: direction and `const`.
    pub fn parameter_storages(&self) -> impl Iterator<Item = Storage> {
        self.locals.iter().take(self.directions.len()).map(|local| local.storage)
    }

    /// The types of the parameters.
    pub fn parameters(&self) -> impl Iterator<Item = &Type> {
        self.locals[..self.directions.len()].iter().map(|local| &local.ty)
    }

    /// Name and parameter types, which identify a function.
    pub fn signature(&self) -> String {
        let types: Vec<String> = self.parameters().map(ToString::to_string).collect();
        format!("{}({})", self.name, types.join(", "))
    }
}
