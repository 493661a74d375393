//! Calls, inlined.

use super::expr::not_a_variable;
use super::place::{Place, Slot};
use super::{Failure, Lowered, Lowerer, Region};
use crate::hir::{Direction, Expr, Function, Stmt, Variable};
use crate::types::Type;
use rasterizer::ir::{Stmt as IrStmt, Value};
use std::rc::Rc;

impl<'a> Lowerer<'a> {
    pub(super) fn call(&mut self, index: u32, arguments: &[Expr]) -> Lowered<Vec<Value>> {
        self.check_size()?;
        let unit = self.frame().unit;
        let signature = self.unit_functions[unit][index as usize].signature();
        let Some(&(unit, function)) = self.functions.get(&signature) else {
            return Err(Failure(format!("`{signature}` is called and never defined")));
        };

        // Arguments belong to the caller; they are evaluated once, from left to right.
        let mut places: Vec<Option<Place>> = Vec::new();
        let mut slots = Vec::new();
        for ((argument, direction), parameter) in
            arguments.iter().zip(&function.directions).zip(&function.locals)
        {
            match direction {
                Direction::In => {
                    slots.push(self.argument(argument, parameter)?);
                    places.push(None);
                }
                Direction::Out | Direction::Inout => {
                    let place = self.place(argument)?.ok_or_else(not_a_variable)?;
                    let types = parameter.ty.flat();
                    let slot = self.new_slot(parameter, &types);
                    let start = match direction {
                        Direction::Inout => self.load(&place)?,
                        Direction::In | Direction::Out => {
                            types.iter().map(|&ty| self.emit.constant(0, ty)).collect()
                        }
                    };
                    self.fill(&slot, &start);
                    slots.push(slot);
                    places.push(Some(place));
                }
            }
        }

        self.open_frame(unit, &function.locals);
        for (number, slot) in slots.iter().enumerate() {
            self.frame().slots[number] = Some(slot.clone());
        }
        let result = self.nested(|lowerer| lowerer.inline(function));
        self.frames.pop();
        let result = result?;
        for ((place, slot), parameter) in places.into_iter().zip(slots).zip(&function.locals) {
            if let Some(place) = place {
                let values = self.load_all(slot, &parameter.ty)?;
                let types = place.ty.flat();
                let pairs = values.into_iter().zip(types);
                let values: Vec<Value> =
                    pairs.map(|(value, ty)| self.emit.convert(value, ty)).collect();
                self.store(&place, &values)?;
            }
        }
        Ok(result)
    }

    /// Where an `in` parameter lives: in the argument itself, where nobody can tell the difference.
    fn argument(&mut self, argument: &Expr, parameter: &'a Variable) -> Lowered<Slot> {
        let place = self.place(argument)?;
        if !parameter.written
            && let Some(place) = &place
            && matches!(place.slot, Slot::Uniform(..))
        {
            return Ok(Slot::Alias(Rc::new(place.clone())));
        }
        let values = match &place {
            Some(place) => self.load(place)?,
            None => self.expr(argument)?,
        };
        if !parameter.written && !parameter.dynamic {
            return Ok(Slot::Values(values.into()));
        }
        let slot = self.new_slot(parameter, &parameter.ty.flat());
        self.fill(&slot, &values);
        Ok(slot)
    }

    pub(super) fn load_all(&mut self, slot: Slot, ty: &Type) -> Lowered<Vec<Value>> {
        let mut whole = Self::value_place(Vec::new(), ty.clone());
        whole.slot = slot;
        self.load(&whole)
    }

    /// The body of a function whose frame is open; gives its result.
    fn inline(&mut self, function: &'a Function) -> Lowered<Vec<Value>> {
        let Some(body) = &function.body else { return Ok(Vec::new()) };
        if !returns_early(body) {
            let Some((Stmt::Return(value), before)) = body.split_last() else {
                self.statements(body)?;
                // A function that ends without a `return` gives zeros.
                let types = function.result.flat();
                return Ok(types.iter().map(|&ty| self.emit.constant(0, ty)).collect());
            };
            self.statements(before)?;
            return value.as_ref().map_or(Ok(Vec::new()), |value| self.expr(value));
        }
        let types = function.result.flat();
        let slot = self.new_vars(&function.name, &types);
        if let Slot::Vars(vars) = &slot {
            self.frame().result = vars.to_vec();
        }
        self.scope(body)?;
        self.load_all(slot, &function.result)
    }

    /// Statements in a scope that `return` leaves.
    pub(super) fn scope(&mut self, body: &'a [Stmt]) -> Lowered<()> {
        self.frame().regions.push(Region::Function);
        self.emit.builder.begin();
        let result = self.statements(body);
        let block = self.emit.builder.end();
        self.frame().regions.pop();
        result?;
        self.emit.push(IrStmt::Scope(block));
        Ok(())
    }
}

/// The statements before a `return` at the very end, or all if there is none.
pub(super) fn without_last_return(body: &[Stmt]) -> &[Stmt] {
    if let Some((Stmt::Return(_), before)) = body.split_last() { before } else { body }
}

/// Whether a `return` stands anywhere but at the very end.
pub(super) fn returns_early(body: &[Stmt]) -> bool {
    contains(without_last_return(body), Jumps::Return)
}

/// Which jumps to look for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Jumps {
    /// `return`.
    Return,
    /// `continue` of the loop around.
    Continue,
}

/// Whether statements hold such a jump.
pub(super) fn contains(statements: &[Stmt], jumps: Jumps) -> bool {
    statements.iter().any(|statement| match statement {
        Stmt::Return(_) => jumps == Jumps::Return,
        Stmt::Continue => jumps == Jumps::Continue,
        Stmt::Block(block) => contains(block, jumps),
        Stmt::If(_, accept, reject) => contains(accept, jumps) || contains(reject, jumps),
        Stmt::Loop(turn) => jumps == Jumps::Return && contains(&turn.body, jumps),
        Stmt::Switch(_, cases) => cases.iter().any(|case| contains(&case.body, jumps)),
        Stmt::Declare(..) | Stmt::Expr(_) | Stmt::Break | Stmt::Discard => false,
    })
}
