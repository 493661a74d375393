//! Statements.

use super::access_chain::VarStorage;
use super::call::{Jump, contains};
use super::{LowerResult, Lowerer, Region};
use crate::hir::{Case, Expr, Loop, Stmt};
use crate::limits::MAX_CLEARED;
use rasterizer::ir::{Block, Op, Stmt as IrStmt, Ty, Value};

impl<'a> Lowerer<'a> {
    pub(super) fn statements(&mut self, statements: &'a [Stmt]) -> LowerResult<()> {
        for statement in statements {
            self.check_size()?;
            self.nested(|lowerer| lowerer.statement(statement))?;
        }
        Ok(())
    }

    fn statement(&mut self, statement: &'a Stmt) -> LowerResult<()> {
        match statement {
            Stmt::Declare(local, init) => self.declare(*local, init.as_ref()),
            Stmt::Expr(expr) => self.expr(expr).map(|_| ()),
            Stmt::Block(block) => self.unlabelled(|lowerer| lowerer.statements(block)),
            Stmt::If(condition, accept, reject) => {
                let condition = self.expr(condition)?[0];
                match self.emit.known(condition) {
                    Some(0) => return self.unlabelled(|lowerer| lowerer.statements(reject)),
                    Some(_) => return self.unlabelled(|lowerer| lowerer.statements(accept)),
                    None => {}
                }
                let accept = self.block(|lowerer| lowerer.statements(accept))?;
                let reject = self.block(|lowerer| lowerer.statements(reject))?;
                self.emit.push(IrStmt::If { condition, accept, reject });
                Ok(())
            }
            Stmt::Loop(looped) => {
                self.loops += 1;
                self.frame().regions.push(Region::Loop);
                let result = self.loop_statement(looped);
                self.frame().regions.pop();
                self.loops -= 1;
                result
            }
            Stmt::Switch(selector, cases) => self.switch(selector, cases),
            Stmt::Return(value) => {
                if let Some(value) = value {
                    let values = self.expr(value)?;
                    let result = self.frame().result.clone();
                    self.fill(&VarStorage::Vars(result.into()), &values);
                }
                self.leave_function();
                Ok(())
            }
            Stmt::Break => {
                let inner = self.frame().regions.last().copied();
                self.emit.push(match inner {
                    Some(Region::Switch { .. }) => IrStmt::Leave,
                    Some(Region::Loop | Region::Function) | None => IrStmt::Break,
                });
                Ok(())
            }
            Stmt::Continue => {
                self.continue_loop();
                Ok(())
            }
            Stmt::Discard => {
                self.emit.push(IrStmt::Discard);
                Ok(())
            }
        }
    }

    /// Lowers into a block of its own.
    fn block(&mut self, lower: impl FnOnce(&mut Self) -> LowerResult<()>) -> LowerResult<Block> {
        self.emit.builder.begin();
        let result = self.unlabelled(lower);
        let block = self.emit.builder.end();
        result.map(|()| block)
    }

    /// Inside a block, no jump to a label can skip a declaration.
    fn unlabelled(&mut self, lower: impl FnOnce(&mut Self) -> LowerResult<()>) -> LowerResult<()> {
        let before = std::mem::replace(&mut self.frame().labelled, false);
        let result = lower(self);
        self.frame().labelled = before;
        result
    }

    fn declare(&mut self, local: u32, init: Option<&Expr>) -> LowerResult<()> {
        let frame = self.frame();
        let (variable, labelled) = (&frame.locals[local as usize], frame.labelled);
        let values = init.map(|init| self.expr(init)).transpose()?;
        let storage = match values {
            Some(values) if !variable.written && !variable.dynamically_indexed && !labelled => {
                VarStorage::Values(values.into())
            }
            values => {
                let types = variable.ty.flat();
                let storage = self.new_storage(variable, &types);
                match values {
                    Some(values) => self.fill(&storage, &values),
                    // Without an initializer it is zero, also in the next iteration of a loop.
                    None if self.loops > 0 && types.len() <= MAX_CLEARED => {
                        let zeros: Vec<Value> =
                            types.iter().map(|&ty| self.emit.constant(0, ty)).collect();
                        self.fill(&storage, &zeros);
                    }
                    None => {}
                }
                storage
            }
        };
        self.frame().storages[local as usize] = Some(storage);
        Ok(())
    }

    fn loop_statement(&mut self, looped: &'a Loop) -> LowerResult<()> {
        let body = self.block(|lowerer| {
            if let Some(local) = looped.declare {
                // The step is in another block, so the variable of the condition needs IR storage.
                lowerer.declare(local, looped.condition_before.as_ref())?;
                let storage = lowerer.frame().storages[local as usize].clone();
                if let Some(VarStorage::Vars(vars)) = storage {
                    let condition = lowerer.emit.load(vars[0]);
                    lowerer.break_unless(condition);
                }
            } else if let Some(before) = &looped.condition_before {
                let condition = lowerer.expr(before)?[0];
                lowerer.break_unless(condition);
            }
            lowerer.statements(&looped.body)
        })?;
        let continuing = self.block(|lowerer| {
            if let Some(step) = &looped.step {
                lowerer.expr(step)?;
            }
            if let Some(after) = &looped.condition_after {
                let condition = lowerer.expr(after)?[0];
                lowerer.break_unless(condition);
            }
            Ok(())
        })?;
        self.emit.push(IrStmt::Loop { body, continuing });
        Ok(())
    }

    fn break_unless(&mut self, condition: Value) {
        if self.emit.known(condition).is_some_and(|word| word != 0) {
            return;
        }
        let reject = vec![IrStmt::Break];
        self.emit.push(IrStmt::If { condition, accept: Vec::new(), reject });
    }

    /// Leaves the function, through the switches that are open in it.
    fn leave_function(&mut self) {
        let regions = self.frame().regions.iter().rev();
        let inner = regions.copied().find(|region| !matches!(region, Region::Loop));
        if let Some(Region::Switch { returned: Some(var), .. }) = inner {
            let value = self.emit.constant(rasterizer::ir::TRUE, Ty::Bool);
            self.emit.push(IrStmt::Store { var, value });
        }
        self.emit.push(IrStmt::Leave);
    }

    /// Continues the innermost loop, through the switches that are open in it.
    fn continue_loop(&mut self) {
        let inner = self.frame().regions.last().copied();
        match inner {
            Some(Region::Switch { continued, .. }) => {
                if let Some(var) = continued {
                    let value = self.emit.constant(rasterizer::ir::TRUE, Ty::Bool);
                    self.emit.push(IrStmt::Store { var, value });
                }
                self.emit.push(IrStmt::Leave);
            }
            Some(Region::Loop | Region::Function) | None => self.emit.push(IrStmt::Continue),
        }
    }

    /// A scope that `break` leaves. `active` is whether a label was reached; each group of
    /// statements runs if it is true, which gives fall-through.
    fn switch(&mut self, selector: &'a Expr, cases: &'a [Case]) -> LowerResult<()> {
        let selector = self.expr(selector)?[0];
        let ty = self.emit.ty(selector);
        let no = self.emit.constant(0, Ty::Bool);
        let flag = |lowerer: &mut Self, jumps: Jump| {
            let needed = cases.iter().any(|case| contains(&case.body, jumps));
            needed.then(|| {
                let var = lowerer.emit.builder.variable("jump", Ty::Bool);
                lowerer.emit.push(IrStmt::Store { var, value: no });
                var
            })
        };
        let returned = flag(self, Jump::Return);
        let continued = flag(self, Jump::Continue);

        let mut reached = Vec::new();
        let mut any = no;
        for case in cases {
            let mut here = no;
            for &label in &case.labels {
                let label = self.emit.constant(label, ty);
                let same = self.emit.equal(selector, label);
                here = self.emit.op(Op::Or, &[here, same]);
            }
            any = self.emit.op(Op::Or, &[any, here]);
            reached.push(here);
        }
        let none = self.emit.op(Op::Not, &[any]);

        self.frame().regions.push(Region::Switch { returned, continued });
        let before = std::mem::replace(&mut self.frame().labelled, true);
        self.emit.builder.begin();
        let mut result = Ok(());
        let mut active = no;
        for (case, here) in cases.iter().zip(reached) {
            active = self.emit.op(Op::Or, &[active, here]);
            if case.default {
                active = self.emit.op(Op::Or, &[active, none]);
            }
            self.emit.builder.begin();
            result = self.statements(&case.body);
            let accept = self.emit.builder.end();
            if result.is_err() {
                break;
            }
            self.emit.push(IrStmt::If { condition: active, accept, reject: Vec::new() });
        }
        let block = self.emit.builder.end();
        self.frame().labelled = before;
        self.frame().regions.pop();
        result?;
        self.emit.push(IrStmt::Scope(block));

        if let Some(var) = returned {
            let condition = self.emit.load(var);
            let accept = self.block(|lowerer| {
                lowerer.leave_function();
                Ok(())
            })?;
            self.emit.push(IrStmt::If { condition, accept, reject: Vec::new() });
        }
        if let Some(var) = continued {
            let condition = self.emit.load(var);
            let accept = self.block(|lowerer| {
                lowerer.continue_loop();
                Ok(())
            })?;
            self.emit.push(IrStmt::If { condition, accept, reject: Vec::new() });
        }
        Ok(())
    }
}
