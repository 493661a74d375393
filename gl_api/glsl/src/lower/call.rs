//! Inlining of calls.

use super::access_chain::{AccessChain, VarStorage};
use super::expr::not_a_variable;
use super::{CallTarget, LowerError, LowerResult, Lowerer, Region};
use crate::hir::{Direction, Expr, Function, Stmt, Variable};
use crate::types::Type;
use rasterizer::ir::{Stmt as IrStmt, Value};
use std::rc::Rc;

/// The steps of a call, beside its arguments and its body.
const CALL: usize = 4;

impl<'a> Lowerer<'a> {
    pub(super) fn call(&mut self, index: u32, arguments: &[Expr]) -> LowerResult<Vec<Value>> {
        self.check_size()?;
        let unit = self.frame().unit;
        let (unit, function, returns_early) = match &self.targets[unit][index as usize] {
            &CallTarget::Defined { unit, function, returns_early } => {
                (unit, function, returns_early)
            }
            CallTarget::Undefined(signature) => {
                return Err(LowerError(format!("`{signature}` is called and never defined")));
            }
        };
        self.emit.work.add(CALL);

        // Arguments are evaluated once, in the frame of the caller, from left to right.
        let mut chains: Vec<Option<AccessChain>> = Vec::new();
        let mut storages = Vec::new();
        for ((argument, direction), parameter) in
            arguments.iter().zip(&function.directions).zip(&function.locals)
        {
            match direction {
                Direction::In => {
                    storages.push(self.argument(argument, parameter)?);
                    chains.push(None);
                }
                Direction::Out | Direction::Inout => {
                    let chain = self.access_chain(argument)?.ok_or_else(not_a_variable)?;
                    let types = parameter.ty.flat();
                    let storage = self.new_storage(parameter, &types);
                    let start = match direction {
                        Direction::Inout => self.load(&chain)?,
                        Direction::In | Direction::Out => {
                            types.iter().map(|&ty| self.emit.constant(0, ty)).collect()
                        }
                    };
                    self.fill(&storage, &start);
                    storages.push(storage);
                    chains.push(Some(chain));
                }
            }
        }

        self.open_frame(unit, Some(function), &function.locals);
        for (number, storage) in storages.iter().enumerate() {
            self.frame().storages[number] = Some(storage.clone());
        }
        let result = self.nested(|lowerer| lowerer.inline(function, returns_early));
        self.frames.pop();
        let result = result?;
        for ((chain, storage), parameter) in chains.into_iter().zip(storages).zip(&function.locals)
        {
            if let Some(chain) = chain {
                let values = self.load_all(storage, &parameter.ty)?;
                let types = chain.ty.flat();
                let pairs = values.into_iter().zip(types);
                let values: Vec<Value> =
                    pairs.map(|(value, ty)| self.emit.convert(value, ty)).collect();
                self.store(&chain, &values)?;
            }
        }
        Ok(result)
    }

    /// The storage of an `in` parameter: that of the argument, if neither is written.
    fn argument(&mut self, argument: &Expr, parameter: &'a Variable) -> LowerResult<VarStorage> {
        let chain = self.access_chain(argument)?;
        if !parameter.written
            && let Some(chain) = &chain
            && matches!(chain.storage, VarStorage::Uniform(..))
        {
            return Ok(VarStorage::Alias(Rc::new(chain.clone())));
        }
        let values = match &chain {
            Some(chain) => self.load(chain)?,
            None => self.expr(argument)?,
        };
        if !parameter.written && !parameter.dynamically_indexed {
            return Ok(VarStorage::Values(values.into()));
        }
        let storage = self.new_storage(parameter, &parameter.ty.flat());
        self.fill(&storage, &values);
        Ok(storage)
    }

    pub(super) fn load_all(&mut self, storage: VarStorage, ty: &Type) -> LowerResult<Vec<Value>> {
        let mut whole = Self::value_chain(Vec::new(), ty.clone());
        whole.storage = storage;
        self.load(&whole)
    }

    /// Inlines the body of a function whose frame is open; gives its result.
    fn inline(&mut self, function: &'a Function, returns_early: bool) -> LowerResult<Vec<Value>> {
        let Some(body) = &function.body else { return Ok(Vec::new()) };
        if !returns_early {
            let Some((Stmt::Return(value), before)) = body.split_last() else {
                self.statements(body)?;
                // A missing `return` gives zeros.
                let types = function.result.flat();
                return Ok(types.iter().map(|&ty| self.emit.constant(0, ty)).collect());
            };
            self.statements(before)?;
            return value.as_ref().map_or(Ok(Vec::new()), |value| self.expr(value));
        }
        let types = function.result.flat();
        let storage = self.new_vars(&function.name, &types);
        if let VarStorage::Vars(vars) = &storage {
            self.frame().result = vars.to_vec();
        }
        self.scope(body)?;
        self.load_all(storage, &function.result)
    }

    /// Lowers statements in a scope that `return` leaves.
    pub(super) fn scope(&mut self, body: &'a [Stmt]) -> LowerResult<()> {
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

/// The statements before a `return` at the end, or all if there is none.
pub(super) fn without_last_return(body: &[Stmt]) -> &[Stmt] {
    if let Some((Stmt::Return(_), before)) = body.split_last() { before } else { body }
}

/// Whether a `return` stands anywhere but at the end.
pub(super) fn returns_early(body: &[Stmt]) -> bool {
    contains(without_last_return(body), Jump::Return)
}

/// Which jumps to look for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Jump {
    /// `return`.
    Return,
    /// `continue` of the enclosing loop.
    Continue,
}

/// Whether statements contain such a jump.
pub(super) fn contains(statements: &[Stmt], jumps: Jump) -> bool {
    statements.iter().any(|statement| match statement {
        Stmt::Return(_) => jumps == Jump::Return,
        Stmt::Continue => jumps == Jump::Continue,
        Stmt::Block(block) => contains(block, jumps),
        Stmt::If(_, accept, reject) => contains(accept, jumps) || contains(reject, jumps),
        Stmt::Loop(looped) => jumps == Jump::Return && contains(&looped.body, jumps),
        Stmt::Switch(_, cases) => cases.iter().any(|case| contains(&case.body, jumps)),
        Stmt::Declare(..) | Stmt::Expr(_) | Stmt::Break | Stmt::Discard => false,
    })
}
