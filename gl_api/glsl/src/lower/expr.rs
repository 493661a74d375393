//! Expressions to scalars. The order of the operations here is the definition of their results.

use super::{LowerError, LowerResult, Lowerer};
use crate::ast::{BinaryOp, IncDec, IncDecResult, UnaryOp};
use crate::builtins::expand::{self, Args, geometric};
use crate::builtins::function::{FunctionRow, Lowering};
use crate::hir::{Expr, ExprKind};
use crate::types::{Scalar, Type};
use rasterizer::ir::{Op, Stmt, Ty, Value};

impl Lowerer<'_> {
    /// The scalars of an expression.
    pub(super) fn expr(&mut self, expr: &Expr) -> LowerResult<Vec<Value>> {
        let values = self.nested(|lowerer| lowerer.expr_kind(expr))?;
        self.emit.work.add(values.len());
        Ok(values)
    }

    fn expr_kind(&mut self, expr: &Expr) -> LowerResult<Vec<Value>> {
        match &expr.kind {
            ExprKind::Const(words) => Ok(self.constants(words, &expr.ty.flat())),
            ExprKind::Var(_) => self.load_expr(expr),
            ExprKind::Convert(inner) => {
                let values = self.expr(inner)?;
                let types = expr.ty.flat();
                Ok(values.iter().zip(types).map(|(&v, ty)| self.emit.convert(v, ty)).collect())
            }
            ExprKind::Unary(op, inner) => {
                let values = self.expr(inner)?;
                Ok(values.iter().map(|&value| self.unary(*op, value)).collect())
            }
            ExprKind::Binary(op @ (BinaryOp::And | BinaryOp::Or), left, right) => {
                self.logical(*op, left, right)
            }
            ExprKind::Binary(op, left, right) => {
                let (a, b) = (self.expr(left)?, self.expr(right)?);
                Ok(self.binary(*op, (&left.ty, &a), (&right.ty, &b)))
            }
            ExprKind::Assign(op, target, value) => {
                let chain = self.access_chain(target)?.ok_or_else(not_a_variable)?;
                let values = match op {
                    None => self.expr(value)?,
                    Some(op) => {
                        // The target is loaded after the value, which may write it.
                        let values = self.expr(value)?;
                        let old = self.load(&chain)?;
                        self.binary(*op, (&target.ty, &old), (&value.ty, &values))
                    }
                };
                self.store(&chain, &values)?;
                Ok(values)
            }
            ExprKind::IncDec(step, result, target) => {
                let chain = self.access_chain(target)?.ok_or_else(not_a_variable)?;
                let old = self.load(&chain)?;
                let op = match step {
                    IncDec::Increment => BinaryOp::Add,
                    IncDec::Decrement => BinaryOp::Sub,
                };
                let new: Vec<Value> = old.iter().map(|&value| self.count(op, value)).collect();
                self.store(&chain, &new)?;
                Ok(match result {
                    IncDecResult::After => new,
                    IncDecResult::Before => old,
                })
            }
            ExprKind::Conditional(parts) => self.conditional(parts),
            ExprKind::Comma(all) => {
                let mut last = Vec::new();
                for expr in all {
                    last = self.expr(expr)?;
                }
                Ok(last)
            }
            ExprKind::Index(base, index) => {
                if expr.root().is_some() {
                    return self.load_expr(expr);
                }
                let values = self.expr(base)?;
                let index = self.expr(index)?[0];
                let chain = Self::value_chain(values, base.ty.clone());
                let element = self.element(chain, index, &expr.ty)?;
                self.load(&element)
            }
            ExprKind::Field(base, index) => {
                if expr.root().is_some() {
                    return self.load_expr(expr);
                }
                let values = self.expr(base)?;
                let Type::Struct(structure) = &base.ty else { return Ok(values) };
                let before = &structure.fields[..*index as usize];
                let start: u32 = before.iter().map(|(_, ty)| ty.scalars()).sum();
                let (start, len) = (start as usize, expr.ty.scalars() as usize);
                Ok(values[start..start + len].to_vec())
            }
            ExprKind::Swizzle(base, components) => {
                if expr.root().is_some() {
                    return self.load_expr(expr);
                }
                let values = self.expr(base)?;
                Ok(components.iter().map(|&c| values[usize::from(c)]).collect())
            }
            ExprKind::Construct(parts) => self.construct(&expr.ty, parts),
            ExprKind::Call(function, arguments) => self.call(*function, arguments),
            ExprKind::Builtin(row, arguments) => self.builtin(row, arguments, &expr.ty),
            ExprKind::Error => Err(LowerError("an expression with an error".to_owned())),
        }
    }

    fn load_expr(&mut self, expr: &Expr) -> LowerResult<Vec<Value>> {
        let chain = self.access_chain(expr)?.ok_or_else(not_a_variable)?;
        self.load(&chain)
    }

    fn unary(&mut self, op: UnaryOp, value: Value) -> Value {
        match (op, self.emit.ty(value)) {
            (UnaryOp::Plus, _) => value,
            (UnaryOp::Negate, Ty::F32) => self.emit.op(Op::Neg, &[value]),
            (UnaryOp::Negate | UnaryOp::BitNot | UnaryOp::Not, Ty::Bool) => {
                self.emit.op(Op::Not, &[value])
            }
            (UnaryOp::Negate, Ty::I32) => self.emit.op(Op::INeg, &[value]),
            (UnaryOp::Negate, Ty::U32) => {
                let zero = self.emit.uint(0);
                self.emit.op(Op::USub, &[zero, value])
            }
            (UnaryOp::BitNot | UnaryOp::Not, ty) => {
                let bits = self.emit.convert(value, Ty::U32);
                let flipped = self.emit.op(Op::BitNot, &[bits]);
                self.emit.convert(flipped, ty)
            }
        }
    }

    /// `a + 1` or `a - 1`.
    fn count(&mut self, op: BinaryOp, value: Value) -> Value {
        let ty = self.emit.ty(value);
        let one = match ty {
            Ty::F32 => self.emit.float(1.0),
            Ty::I32 | Ty::U32 | Ty::Bool => self.emit.constant(1, ty),
        };
        self.scalar(op, value, one)
    }

    /// `&&` and `||`: the right operand is evaluated conditionally if it has effects.
    fn logical(&mut self, op: BinaryOp, left: &Expr, right: &Expr) -> LowerResult<Vec<Value>> {
        let a = self.expr(left)?[0];
        let combine = if op == BinaryOp::And { Op::And } else { Op::Or };
        if !right.has_effects() {
            let b = self.expr(right)?[0];
            return Ok(vec![self.emit.op(combine, &[a, b])]);
        }
        let var = self.emit.builder.variable("logical", Ty::Bool);
        self.emit.push(Stmt::Store { var, value: a });
        self.emit.builder.begin();
        let b = self.expr(right);
        if let Ok(b) = &b {
            self.emit.push(Stmt::Store { var, value: b[0] });
        }
        let block = self.emit.builder.end();
        b?;
        let (accept, reject) =
            if op == BinaryOp::And { (block, Vec::new()) } else { (Vec::new(), block) };
        self.emit.push(Stmt::If { condition: a, accept, reject });
        Ok(vec![self.emit.load(var)])
    }

    fn conditional(&mut self, parts: &[Expr; 3]) -> LowerResult<Vec<Value>> {
        let [condition, accept, reject] = parts;
        let condition = self.expr(condition)?[0];
        if !accept.has_effects() && !reject.has_effects() {
            let (a, b) = (self.expr(accept)?, self.expr(reject)?);
            let pairs = a.iter().zip(&b);
            return Ok(pairs.map(|(&a, &b)| self.emit.select(condition, a, b)).collect());
        }
        let storage = self.new_vars("chosen", &accept.ty.flat());
        let mut blocks = Vec::new();
        for part in [accept, reject] {
            self.emit.builder.begin();
            let values = self.expr(part);
            if let Ok(values) = &values {
                self.fill(&storage, values);
            }
            blocks.push(self.emit.builder.end());
            values?;
        }
        let not_chosen = blocks.pop().unwrap_or_default();
        let chosen = blocks.pop().unwrap_or_default();
        self.emit.push(Stmt::If { condition, accept: chosen, reject: not_chosen });
        self.load_all(storage, &accept.ty)
    }

    /// A binary operation other than `&&` and `||`.
    fn binary(&mut self, op: BinaryOp, a: (&Type, &[Value]), b: (&Type, &[Value])) -> Vec<Value> {
        if matches!(op, BinaryOp::Equal | BinaryOp::NotEqual) {
            let mut all = self.emit.constant(rasterizer::ir::TRUE, Ty::Bool);
            for (&a, &b) in a.1.iter().zip(b.1) {
                let same = self.emit.equal(a, b);
                all = self.emit.op(Op::And, &[all, same]);
            }
            if op == BinaryOp::NotEqual {
                all = self.emit.op(Op::Not, &[all]);
            }
            return vec![all];
        }
        if op == BinaryOp::Mul && !a.0.is_scalar() && !b.0.is_scalar() {
            if let Some(rows) = a.0.rows() {
                return self.matrix_times(a.1, usize::from(rows), b.1);
            }
            if let Some(rows) = b.0.rows() {
                let columns = b.1.chunks(usize::from(rows));
                return columns
                    .map(|column| geometric::dot_product(&mut self.emit, a.1, column))
                    .collect();
            }
        }
        let len = a.1.len().max(b.1.len());
        let at = |values: &[Value], i: usize| values[i.min(values.len() - 1)];
        (0..len).map(|i| self.scalar(op, at(a.1, i), at(b.1, i))).collect()
    }

    /// A matrix of `rows` rows times a column, or the columns of a matrix one by one.
    fn matrix_times(&mut self, matrix: &[Value], rows: usize, right: &[Value]) -> Vec<Value> {
        let columns = right.chunks(matrix.len() / rows);
        columns.flat_map(|column| self.multiply(matrix, column, rows)).collect()
    }

    /// Matrix times column: each row's dot product, summed from the first column on.
    fn multiply(&mut self, matrix: &[Value], column: &[Value], rows: usize) -> Vec<Value> {
        let row = |row: usize| {
            let of_row: Vec<Value> = matrix[row..].iter().step_by(rows).copied().collect();
            geometric::dot_product(&mut self.emit, &of_row, column)
        };
        (0..rows).map(row).collect()
    }

    fn scalar(&mut self, op: BinaryOp, a: Value, b: Value) -> Value {
        let ty = self.emit.ty(a);
        let pick = |float: Op, int: Op, uint: Op| match ty {
            Ty::F32 => float,
            Ty::I32 => int,
            Ty::U32 | Ty::Bool => uint,
        };
        let (op, operands) = match op {
            BinaryOp::Add => (pick(Op::Add, Op::IAdd, Op::UAdd), [a, b]),
            BinaryOp::Sub => (pick(Op::Sub, Op::ISub, Op::USub), [a, b]),
            BinaryOp::Mul => (pick(Op::Mul, Op::IMul, Op::UMul), [a, b]),
            BinaryOp::Div => (pick(Op::Div, Op::IDiv, Op::UDiv), [a, b]),
            BinaryOp::Rem => (pick(Op::IRem, Op::IRem, Op::URem), [a, b]),
            BinaryOp::Less => (pick(Op::Less, Op::ILess, Op::ULess), [a, b]),
            BinaryOp::Greater => (pick(Op::Less, Op::ILess, Op::ULess), [b, a]),
            BinaryOp::LessEqual => (pick(Op::LessEqual, Op::ILessEqual, Op::ULessEqual), [a, b]),
            BinaryOp::GreaterEqual => (pick(Op::LessEqual, Op::ILessEqual, Op::ULessEqual), [b, a]),
            BinaryOp::And => (Op::And, [a, b]),
            BinaryOp::Or => (Op::Or, [a, b]),
            BinaryOp::Xor => (Op::Xor, [a, b]),
            BinaryOp::Equal => return self.emit.equal(a, b),
            BinaryOp::NotEqual => {
                let equal = self.emit.equal(a, b);
                return self.emit.op(Op::Not, &[equal]);
            }
            BinaryOp::ShiftRight => {
                let by = self.emit.convert(b, Ty::U32);
                (pick(Op::IShiftRight, Op::IShiftRight, Op::UShiftRight), [a, by])
            }
            BinaryOp::BitAnd => return self.bits(Op::BitAnd, a, b),
            BinaryOp::BitOr => return self.bits(Op::BitOr, a, b),
            BinaryOp::BitXor => return self.bits(Op::BitXor, a, b),
            BinaryOp::ShiftLeft => return self.bits(Op::ShiftLeft, a, b),
        };
        self.emit.op(op, &operands)
    }

    /// An operation on the bits of integers; the result has the type of `a`.
    fn bits(&mut self, op: Op, a: Value, b: Value) -> Value {
        let ty = self.emit.ty(a);
        let [a, b] = [a, b].map(|x| self.emit.convert(x, Ty::U32));
        let result = self.emit.op(op, &[a, b]);
        self.emit.convert(result, ty)
    }

    /// A constructor: GLSL 1.30 section 5.4.
    fn construct(&mut self, ty: &Type, parts: &[Expr]) -> LowerResult<Vec<Value>> {
        let mut all = Vec::new();
        for part in parts {
            all.extend(self.expr(part)?);
        }
        let scalar = match ty {
            Type::Vector(scalar, _) => *scalar,
            Type::Matrix(..) => Scalar::Float,
            Type::Void | Type::Sampler(_) | Type::Struct(_) | Type::Array(..) | Type::Error => {
                return Ok(all);
            }
        };
        let needed = ty.scalars() as usize;
        let convert = |lowerer: &mut Self, value| lowerer.emit.convert(value, scalar.ty());
        if let (Some(rows), [part]) = (ty.rows(), parts) {
            let rows = usize::from(rows);
            if let Some(source_rows) = part.ty.rows() {
                return Ok(self.resized(&all, source_rows.into(), rows, needed));
            }
            if all.len() == 1 {
                let (value, zero) = (convert(self, all[0]), self.emit.float(0.0));
                let at = |index: usize| if index / rows == index % rows { value } else { zero };
                return Ok((0..needed).map(at).collect());
            }
        }
        if all.len() == 1 {
            let value = convert(self, all[0]);
            return Ok(vec![value; needed]);
        }
        Ok(all.iter().take(needed).map(|&value| convert(self, value)).collect())
    }

    /// A matrix from a matrix: missing elements come from the identity.
    fn resized(
        &mut self,
        source: &[Value],
        source_rows: usize,
        rows: usize,
        needed: usize,
    ) -> Vec<Value> {
        let (zero, one) = (self.emit.float(0.0), self.emit.float(1.0));
        let at = |index: usize| {
            let (column, row) = (index / rows, index % rows);
            let inside = row < source_rows && column * source_rows + row < source.len();
            match inside {
                true => source[column * source_rows + row],
                false if column == row => one,
                false => zero,
            }
        };
        (0..needed).map(at).collect()
    }

    fn builtin(
        &mut self,
        row: &FunctionRow,
        arguments: &[Expr],
        result: &Type,
    ) -> LowerResult<Vec<Value>> {
        if let Lowering::Texture(lookup) = row.lowering {
            return self.texture(lookup, arguments, result);
        }
        if let (Lowering::Modf, [x, whole]) = (row.lowering, arguments) {
            let values = self.expr(x)?;
            let chain = self.access_chain(whole)?.ok_or_else(not_a_variable)?;
            let trunc = |&x: &Value| self.emit.op(Op::Trunc, &[x]);
            let wholes: Vec<Value> = values.iter().map(trunc).collect();
            self.store(&chain, &wholes)?;
            let pairs = values.iter().zip(&wholes);
            return Ok(pairs.map(|(&x, &whole)| self.emit.op(Op::Sub, &[x, whole])).collect());
        }
        match row.lowering {
            Lowering::EmitVertex => return self.emit_vertex().map(|()| Vec::new()),
            Lowering::EndPrimitive => {
                self.emit.push(Stmt::EndPrimitive);
                return Ok(Vec::new());
            }
            Lowering::PerComponent(_)
            | Lowering::Derivative(_)
            | Lowering::Expand(_)
            | Lowering::ExpandAtRunTime(_)
            | Lowering::Texture(_)
            | Lowering::Modf
            | Lowering::Ftransform => {}
        }
        let mut values = Vec::new();
        let mut types = Vec::new();
        for argument in arguments {
            values.push(self.expr(argument)?);
            types.push(argument.ty.clone());
        }
        let args = Args { values: &values, types: &types };
        match row.lowering {
            Lowering::PerComponent(op) => Ok(expand::per_component(&mut self.emit, args, op)),
            Lowering::Expand(expand) | Lowering::ExpandAtRunTime(expand) => {
                Ok(expand(&mut self.emit, args))
            }
            Lowering::Derivative(axis) => {
                Ok(values[0].iter().map(|&value| self.emit.derivative(axis, value)).collect())
            }
            Lowering::Texture(_)
            | Lowering::Modf
            | Lowering::Ftransform
            | Lowering::EmitVertex
            | Lowering::EndPrimitive => {
                Err(LowerError(format!("`{}` takes other arguments", row.name)))
            }
        }
    }
}

pub(super) fn not_a_variable() -> LowerError {
    LowerError("what is written is no variable".to_owned())
}
