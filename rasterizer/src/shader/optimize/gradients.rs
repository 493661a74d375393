//! Gives lookups whose coordinates are sums, products or quotients of varyings the analytic gradients of the planes.
//! They are exact at each pixel; the differences of a quad have rounding errors and neglect the curvature of a
//! perspective.
//!
//! Formal differentiation over the few operations that such coordinates are made of. A coordinate
//! that is made of anything else keeps the differences of the quad, and so do the others of its
//! lookup.
//!
//! Of lines, the scale factor is made of the derivative along the line (GL 2.1, section 3.8.8), which
//! takes the place of that along x; that along y is 0. Of points, pixel rectangles and bitmaps it is 1.

use crate::ir::{
    Access, Axis, Block, Expr, Input, Interpolation, Lod, Module, Op, Stage, Stmt, Ty, Value,
};
use crate::shader::LevelOfDetail;

/// The depth of operations up to which a coordinate is followed.
const DEPTH: u32 = 12;

/// Runs the pass; returns whether it changed the module.
pub(super) fn run(module: &mut Module, lod: LevelOfDetail) -> bool {
    if module.stage != Stage::Fragment {
        return false;
    }
    let body = std::mem::take(&mut module.body);
    let mut pass = Pass { module, lod, changed: false };
    let body = pass.block(body);
    let changed = pass.changed;
    module.body = body;
    changed
}

struct Pass<'a> {
    module: &'a mut Module,
    lod: LevelOfDetail,
    changed: bool,
}

/// The derivatives of a value along x and y.
#[derive(Clone, Copy)]
enum Gradient {
    /// The value is uniform over the draw.
    Zero,
    Values([Value; 2]),
}

impl Pass<'_> {
    fn block(&mut self, block: Block) -> Block {
        let mut out = Vec::with_capacity(block.len());
        for stmt in block {
            let stmt = match stmt {
                Stmt::Eval(value) => {
                    self.add_gradient(value, &mut out);
                    stmt
                }
                Stmt::If { condition, accept, reject } => {
                    let (accept, reject) = (self.block(accept), self.block(reject));
                    Stmt::If { condition, accept, reject }
                }
                Stmt::Loop { body, continuing } => {
                    Stmt::Loop { body: self.block(body), continuing: self.block(continuing) }
                }
                Stmt::Scope(body) => Stmt::Scope(self.block(body)),
                Stmt::Store { .. }
                | Stmt::StoreAt { .. }
                | Stmt::Break
                | Stmt::Continue
                | Stmt::Leave
                | Stmt::Discard
                | Stmt::EmitVertex(_)
                | Stmt::EndPrimitive => stmt,
            };
            out.push(stmt);
        }
        out
    }

    /// Gives a lookup with an implicit level of detail the derivatives of its coordinates, whose
    /// values go to `out`.
    fn add_gradient(&mut self, value: Value, out: &mut Block) {
        let Expr::Sample(sample) = self.module.expr(value) else { return };
        let (Access::Filter { .. } | Access::Lod, Lod::Implicit { bias }) =
            (sample.access, sample.lod)
        else {
            return;
        };
        let (coords, texture) = (sample.coords, sample.texture);
        let axes = match self.module.textures[texture.0 as usize].shape {
            shape if shape.is_cube() => 3,
            shape => shape.axes(),
        };
        let mut emitted = Vec::new();
        let mut gradients = [Gradient::Zero; 3];
        for (gradient, coord) in gradients.iter_mut().zip(&coords[..axes]) {
            match self.gradient(*coord, DEPTH, &mut emitted) {
                Some(found) => *gradient = found,
                // What a program computes, as from the place of the fragment, may differ within a point or a rectangle.
                None if self.lod != LevelOfDetail::Lines => return,
                None => *gradient = Gradient::Values(self.differences(*coord, &mut emitted)),
            }
        }
        let zero = self.push(Expr::Const { bits: 0, ty: Ty::F32 });
        if self.lod == LevelOfDetail::UnitScaleFactor {
            // log2 of 1.
            let lod = Lod::Explicit(bias.unwrap_or(zero));
            if let Expr::Sample(sample) = &mut self.module.values[value.0 as usize] {
                sample.lod = lod;
                self.changed = true;
                out.push(Stmt::Eval(zero));
            }
            return;
        }
        if self.lod == LevelOfDetail::Lines {
            self.derivatives_along_line(&mut gradients, zero, &mut emitted);
        }
        let along = |axis: usize| {
            gradients.map(|gradient| match gradient {
                Gradient::Zero => zero,
                Gradient::Values(values) => values[axis],
            })
        };
        let lod = Lod::Gradient { dx: along(0), dy: along(1), bias };
        if let Expr::Sample(sample) = &mut self.module.values[value.0 as usize] {
            sample.lod = lod;
            self.changed = true;
            out.extend(emitted.into_iter().map(Stmt::Eval));
        }
    }

    /// The differences of a value in its quad.
    fn differences(&mut self, value: Value, emitted: &mut Vec<Value>) -> [Value; 2] {
        [Axis::X, Axis::Y].map(|axis| {
            let difference = self.push(Expr::Derivative { axis, value });
            emitted.push(difference);
            difference
        })
    }

    /// Where the fragment is of a line, makes derivatives along x and y that along the line and 0: the formula of
    /// polygons then gives that of lines.
    fn derivatives_along_line(
        &mut self,
        gradients: &mut [Gradient; 3],
        zero: Value,
        emitted: &mut Vec<Value>,
    ) {
        let direction =
            [Axis::X, Axis::Y].map(|axis| self.push(Expr::Input(Input::LineDirection(axis))));
        let is_set = direction.map(|part| self.op(Op::NotEqual, [part, zero], emitted));
        let is_line = self.op(Op::Or, is_set, emitted);
        for gradient in gradients {
            let Gradient::Values(values) = *gradient else { continue };
            let parts =
                [0, 1].map(|axis| self.op(Op::Mul, [values[axis], direction[axis]], emitted));
            let along = self.op(Op::Add, parts, emitted);
            let turned = [(along, values[0]), (zero, values[1])].map(|(of_line, other)| {
                let select = Expr::Op { op: Op::SelectF, args: [is_line, of_line, other] };
                let value = self.push(select);
                emitted.push(value);
                value
            });
            *gradient = Gradient::Values(turned);
        }
    }

    /// The derivatives of a value, if it is computed from varyings and uniform values alone. The values to be evaluated
    /// for them are appended to `emitted`.
    fn gradient(&mut self, value: Value, depth: u32, emitted: &mut Vec<Value>) -> Option<Gradient> {
        let below = depth.checked_sub(1)?;
        match *self.module.expr(value) {
            Expr::Const { .. } | Expr::Uniform { .. } => Some(Gradient::Zero),
            Expr::Input(Input::Varying(slot)) => {
                let mode = self.module.varyings.get(usize::from(slot))?;
                if *mode == Interpolation::Flat {
                    return Some(Gradient::Zero);
                }
                let gradients = [Axis::X, Axis::Y]
                    .map(|axis| self.push(Expr::Input(Input::Gradient { slot, axis })));
                Some(Gradient::Values(gradients))
            }
            Expr::Op { op, args: [a, b, _] } => {
                let of_a = self.gradient(a, below, emitted)?;
                if op == Op::Neg {
                    return Some(self.map_axes(of_a, emitted, |pass, da, emitted| {
                        pass.op(Op::Neg, [da, da], emitted)
                    }));
                }
                if !matches!(op, Op::Add | Op::Sub | Op::Mul | Op::Div) {
                    return None;
                }
                let of_b = self.gradient(b, below, emitted)?;
                self.binary(op, value, [a, b], [of_a, of_b], emitted)
            }
            Expr::Input(_)
            | Expr::UniformAt { .. }
            | Expr::Load(_)
            | Expr::LoadAt { .. }
            | Expr::Derivative { .. }
            | Expr::Tabulated { .. }
            | Expr::Sample(_)
            | Expr::Component { .. } => None,
        }
    }

    /// The derivatives of `value = a op b`.
    fn binary(
        &mut self,
        op: Op,
        value: Value,
        [a, b]: [Value; 2],
        gradients: [Gradient; 2],
        emitted: &mut Vec<Value>,
    ) -> Option<Gradient> {
        Some(match (op, gradients) {
            (_, [Gradient::Zero, Gradient::Zero]) => Gradient::Zero,
            (Op::Add | Op::Sub, [of_a, Gradient::Zero]) => of_a,
            (Op::Add, [Gradient::Zero, of_b]) => of_b,
            (Op::Sub, [Gradient::Zero, of_b]) => {
                self.map_axes(of_b, emitted, |pass, db, emitted| {
                    pass.op(Op::Neg, [db, db], emitted)
                })
            }
            (Op::Add | Op::Sub, [Gradient::Values(da), Gradient::Values(db)]) => {
                Gradient::Values([0, 1].map(|i| self.op(op, [da[i], db[i]], emitted)))
            }
            (Op::Mul | Op::Div, [of_a, Gradient::Zero]) => {
                self.map_axes(of_a, emitted, |pass, da, emitted| pass.op(op, [da, b], emitted))
            }
            (Op::Mul, [Gradient::Zero, of_b]) => {
                self.map_axes(of_b, emitted, |pass, db, emitted| pass.op(Op::Mul, [a, db], emitted))
            }
            // (a / b)' = (a' - a / b · b') / b
            (Op::Div, [of_a, Gradient::Values(db)]) => Gradient::Values([0, 1].map(|i| {
                let product = self.op(Op::Mul, [value, db[i]], emitted);
                let numerator = match of_a {
                    Gradient::Values(da) => self.op(Op::Sub, [da[i], product], emitted),
                    Gradient::Zero => self.op(Op::Neg, [product, product], emitted),
                };
                self.op(Op::Div, [numerator, b], emitted)
            })),
            _ => return None,
        })
    }

    /// Applies `f` to the derivative along each axis.
    fn map_axes(
        &mut self,
        gradient: Gradient,
        emitted: &mut Vec<Value>,
        f: impl Fn(&mut Self, Value, &mut Vec<Value>) -> Value,
    ) -> Gradient {
        match gradient {
            Gradient::Zero => Gradient::Zero,
            Gradient::Values(along) => Gradient::Values(along.map(|value| f(self, value, emitted))),
        }
    }

    fn op(&mut self, op: Op, [a, b]: [Value; 2], emitted: &mut Vec<Value>) -> Value {
        let mut args = [a, b, Value(0)];
        args[op.args().len()..].fill(Value(0));
        let value = self.push(Expr::Op { op, args });
        emitted.push(value);
        value
    }

    fn push(&mut self, expr: Expr) -> Value {
        self.module.values.push(expr);
        Value(self.module.values.len() as u32 - 1)
    }
}
