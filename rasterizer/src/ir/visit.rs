//! Walking over a module: the operands of an expression, the blocks of a statement.

use super::{Block, Expr, Lod, Module, Sample, Stmt, Value};

impl Expr {
    /// The same expression over other operands.
    #[must_use]
    pub fn map(&self, f: &mut impl FnMut(Value) -> Value) -> Self {
        match self {
            Self::Const { .. } | Self::Input(_) | Self::Uniform { .. } | Self::Load(_) => {
                self.clone()
            }
            Self::UniformAt { base, len, index, ty } => {
                Self::UniformAt { base: *base, len: *len, index: f(*index), ty: *ty }
            }
            Self::LoadAt { var, index } => Self::LoadAt { var: *var, index: f(*index) },
            Self::Op { op, args } => {
                let mut mapped = [Value(0); 3];
                for (to, from) in mapped.iter_mut().zip(&args[..op.args().len()]) {
                    *to = f(*from);
                }
                Self::Op { op: *op, args: mapped }
            }
            Self::Derivative { axis, value } => Self::Derivative { axis: *axis, value: f(*value) },
            Self::Tabulated { value, table } => {
                Self::Tabulated { value: f(*value), table: table.clone() }
            }
            Self::Sample(sample) => Self::Sample(Box::new(Sample {
                texture: sample.texture,
                access: sample.access,
                coords: sample.coords.map(&mut *f),
                layer: sample.layer.map(&mut *f),
                reference: sample.reference.map(&mut *f),
                lod: match sample.lod {
                    Lod::Implicit { bias } => Lod::Implicit { bias: bias.map(f) },
                    Lod::Explicit(lod) => Lod::Explicit(f(lod)),
                    Lod::Gradient { dx, dy, bias } => Lod::Gradient {
                        dx: dx.map(&mut *f),
                        dy: dy.map(&mut *f),
                        bias: bias.map(f),
                    },
                },
            })),
            Self::Component { sample, component } => {
                Self::Component { sample: f(*sample), component: *component }
            }
        }
    }

    /// Visits the operands.
    pub fn operands(&self, mut f: impl FnMut(Value)) {
        let _ = self.map(&mut |value| {
            f(value);
            value
        });
    }

    /// Whether it is the same wherever it is evaluated, and so needs no [`Stmt::Eval`].
    pub fn is_everywhere(&self) -> bool {
        match self {
            Self::Const { .. } | Self::Input(_) | Self::Uniform { .. } => true,
            Self::UniformAt { .. }
            | Self::Load(_)
            | Self::LoadAt { .. }
            | Self::Op { .. }
            | Self::Derivative { .. }
            | Self::Tabulated { .. }
            | Self::Sample(_)
            | Self::Component { .. } => false,
        }
    }
}

impl Stmt {
    /// The blocks inside, in the order in which they run.
    pub fn blocks(&self) -> impl Iterator<Item = &Block> {
        let (first, second) = match self {
            Self::If { accept, reject, .. } => (Some(accept), Some(reject)),
            Self::Loop { body, continuing } => (Some(body), Some(continuing)),
            Self::Scope(body) => (Some(body), None),
            Self::Eval(_)
            | Self::Store { .. }
            | Self::StoreAt { .. }
            | Self::Break
            | Self::Continue
            | Self::Leave
            | Self::Discard
            | Self::EmitVertex(_)
            | Self::EndPrimitive => (None, None),
        };
        first.into_iter().chain(second)
    }

    /// Visits this statement and all inside it, in program order.
    pub fn walk(&self, f: &mut impl FnMut(&Self)) {
        f(self);
        for stmt in self.blocks().flatten() {
            stmt.walk(f);
        }
    }

    /// Whether the statements after it in its block are unreachable.
    pub fn is_jump(&self) -> bool {
        match self {
            Self::Break | Self::Continue | Self::Leave | Self::Discard => true,
            Self::Eval(_)
            | Self::Store { .. }
            | Self::StoreAt { .. }
            | Self::If { .. }
            | Self::Loop { .. }
            | Self::Scope(_)
            | Self::EmitVertex(_)
            | Self::EndPrimitive => false,
        }
    }
}

impl Module {
    /// Whether statements are nested more than `levels` blocks deep.
    pub(crate) fn nests_deeper_than(&self, levels: usize) -> bool {
        fn deeper(block: &[Stmt], levels: usize) -> bool {
            let mut inner = block.iter().flat_map(Stmt::blocks);
            inner.any(|inner| levels == 0 || deeper(inner, levels - 1))
        }
        deeper(&self.body, levels)
    }
}
