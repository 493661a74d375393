//! Appends IR: folds constants, emits each constant, uniform and input once, and bounds the number
//! of values.

use crate::limits::MAX_VALUES;
use crate::work::Work;
use rasterizer::ir::{
    Access, Axis, Builder, Expr, Input, Op, Sample, Stage, Stmt, Texture, TextureDecl, Ty, Value,
    Var,
};
use std::collections::BTreeMap;

/// An expression that is emitted once per module.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum PooledExpr {
    Const(u32, u8),
    Uniform(u32, u8),
    Input(Input),
}

/// Appends to a module.
pub struct Emit {
    /// The module.
    pub builder: Builder,
    /// The work of all that was emitted, and of what calls this.
    pub work: Work,
    pool: BTreeMap<PooledExpr, Value>,
}

fn tag(ty: Ty) -> u8 {
    match ty {
        Ty::F32 => 0,
        Ty::I32 => 1,
        Ty::U32 => 2,
        Ty::Bool => 3,
    }
}

impl Emit {
    /// An empty module.
    pub fn new(stage: Stage) -> Self {
        Self { builder: Builder::new(stage), work: Work::default(), pool: BTreeMap::new() }
    }

    /// Whether there are too many values; from then on, operations give constants.
    pub fn is_full(&self) -> bool {
        self.builder.module().values.len() >= MAX_VALUES
    }

    /// The type of a value.
    pub fn ty(&self, value: Value) -> Ty {
        self.builder.module().ty(value)
    }

    /// The word of a value that is constant.
    pub fn known(&self, value: Value) -> Option<u32> {
        self.builder.module().constant(value)
    }

    /// A constant.
    pub fn constant(&mut self, bits: u32, ty: Ty) -> Value {
        self.work.add(1);
        let builder = &mut self.builder;
        *self
            .pool
            .entry(PooledExpr::Const(bits, tag(ty)))
            .or_insert_with(|| builder.constant(bits, ty))
    }

    /// A constant `f32`.
    pub fn float(&mut self, value: f32) -> Value {
        self.constant(value.to_bits(), Ty::F32)
    }

    /// A constant `u32`.
    pub fn uint(&mut self, value: u32) -> Value {
        self.constant(value, Ty::U32)
    }

    /// A uniform word.
    pub fn uniform(&mut self, word: u32, ty: Ty) -> Value {
        self.work.add(1);
        let builder = &mut self.builder;
        *self
            .pool
            .entry(PooledExpr::Uniform(word, tag(ty)))
            .or_insert_with(|| builder.uniform(word, ty))
    }

    /// An input.
    pub fn input(&mut self, input: Input) -> Value {
        let builder = &mut self.builder;
        *self.pool.entry(PooledExpr::Input(input)).or_insert_with(|| builder.input(input))
    }

    /// Any expression, unless there are too many.
    pub fn value(&mut self, expr: Expr, ty: Ty) -> Value {
        self.work.add(1);
        if self.is_full() {
            return self.constant(0, ty);
        }
        self.builder.value(expr)
    }

    /// An operation, folded if its operands are constant. What is not constant times a constant zero is 0, also where it
    /// is infinite, NaN or negative: every compiler of a GPU folds that product.
    pub fn op(&mut self, op: Op, operands: &[Value]) -> Value {
        let mut words = [0; 3];
        let mut all = [Value(0); 3];
        let mut constant = true;
        for (index, &operand) in operands.iter().enumerate() {
            all[index] = operand;
            match self.known(operand) {
                Some(word) => words[index] = word,
                None => constant = false,
            }
        }
        if constant {
            return self.constant(op.fold(words), op.result());
        }
        let is_zero = |value: &Value| self.known(*value).is_some_and(|word| word << 1 == 0);
        if op == Op::Mul && operands.iter().any(is_zero) {
            return self.float(0.0);
        }
        self.value(Expr::Op { op, args: all }, op.result())
    }

    /// A derivative; of a constant, zero.
    pub fn derivative(&mut self, axis: Axis, value: Value) -> Value {
        if self.known(value).is_some() {
            return self.float(0.0);
        }
        self.value(Expr::Derivative { axis, value }, Ty::F32)
    }

    /// `a == b` of any type.
    pub fn equal(&mut self, a: Value, b: Value) -> Value {
        match self.ty(a) {
            Ty::F32 => self.op(Op::Equal, &[a, b]),
            Ty::I32 => self.op(Op::IEqual, &[a, b]),
            Ty::U32 => {
                let [a, b] = [a, b].map(|x| self.op(Op::UintToInt, &[x]));
                self.op(Op::IEqual, &[a, b])
            }
            Ty::Bool => {
                let differ = self.op(Op::Xor, &[a, b]);
                self.op(Op::Not, &[differ])
            }
        }
    }

    /// `condition ? a : b` of any type.
    pub fn select(&mut self, condition: Value, a: Value, b: Value) -> Value {
        let op = match self.ty(a) {
            Ty::F32 => Op::SelectF,
            Ty::I32 => Op::SelectI,
            Ty::U32 => Op::SelectU,
            Ty::Bool => Op::SelectB,
        };
        match self.known(condition) {
            Some(0) => b,
            Some(_) => a,
            None => self.op(op, &[condition, a, b]),
        }
    }

    /// A scalar as another type, as constructors convert (GLSL 1.30 section 5.4.1).
    pub fn convert(&mut self, value: Value, to: Ty) -> Value {
        let from = self.ty(value);
        match (from, to) {
            (Ty::F32, Ty::F32) | (Ty::I32, Ty::I32) | (Ty::U32, Ty::U32) | (Ty::Bool, Ty::Bool) => {
                value
            }
            (Ty::F32, Ty::I32) => self.op(Op::FloatToInt, &[value]),
            (Ty::F32, Ty::U32) => self.op(Op::FloatToUint, &[value]),
            (Ty::I32, Ty::F32) => self.op(Op::IntToFloat, &[value]),
            (Ty::U32, Ty::F32) => self.op(Op::UintToFloat, &[value]),
            (Ty::I32, Ty::U32) => self.op(Op::IntToUint, &[value]),
            (Ty::U32, Ty::I32) => self.op(Op::UintToInt, &[value]),
            (Ty::Bool, Ty::F32) => self.op(Op::BoolToFloat, &[value]),
            (Ty::Bool, Ty::I32) => self.op(Op::BoolToInt, &[value]),
            (Ty::Bool, Ty::U32) => self.op(Op::BoolToUint, &[value]),
            (Ty::F32 | Ty::I32 | Ty::U32, Ty::Bool) => {
                let zero = self.constant(0, from);
                let equal = self.equal(value, zero);
                self.op(Op::Not, &[equal])
            }
        }
    }

    /// The current value of a variable of one element.
    pub fn load(&mut self, var: Var) -> Value {
        let ty = self.builder.module().variable(var).ty;
        self.value(Expr::Load(var), ty)
    }

    /// An element of a variable.
    pub fn load_at(&mut self, var: Var, index: Value) -> Value {
        let ty = self.builder.module().variable(var).ty;
        self.value(Expr::LoadAt { var, index }, ty)
    }

    /// Appends a statement.
    pub fn push(&mut self, stmt: Stmt) {
        self.work.add(1);
        self.builder.push(stmt);
    }

    /// A texture access.
    pub fn access(&mut self, sample: Sample) -> [Value; 4] {
        if self.is_full() {
            let decl = self.builder.module().textures[sample.texture.0 as usize];
            let ty = match sample.access {
                Access::Size => Ty::I32,
                Access::Lod => Ty::F32,
                Access::Filter { .. } | Access::Gather { .. } | Access::Fetch { .. } => decl.texels,
            };
            return [self.constant(0, ty); 4];
        }
        self.builder.access(sample)
    }

    /// A new texture slot.
    pub fn texture(&mut self, decl: TextureDecl) -> Texture {
        self.builder.texture(decl)
    }
}
