//! What an instruction computes: an operation, or several as one, so that what is between them stays in
//! registers.
//!
//! A row of the table is a tree of operations over up to eight operands. It is read twice: as the
//! kernel, where each node is the operation's own body ([`scalar`]), and as the pattern that is
//! looked for in the code. So a fused instruction cannot differ from the operations it replaces.
//!
//! Operands in capital letters are uniform: they hold the same word in all lanes, as constants and uniform values do.
//! They are read as scalars from a compact array, not from the registers of 256 bytes: registers 4 KiB apart alias in
//! the store buffer.

use super::inst::Reg;
use crate::ir::{Op, Ty, batch, scalar, with_operations};
use crate::trace::Expression;
use texunit::lanes::{F32s, LANES, Simd, U32s};

/// The most operands of an instruction.
pub(super) const OPERANDS: usize = 8;

/// A tree of operations.
#[derive(Clone, Copy, Debug)]
pub(super) enum Tree {
    /// An operand of the fused instruction; it may occur several times in the tree.
    Operand(usize, OperandStorage),
    Node(Op, &'static [Self]),
}

/// Whether an operand has a value per lane or one for all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OperandStorage {
    /// A number per lane, in a register.
    PerLane,
    /// One number for all lanes, see [`super::lower::RegisterContent::Splat`].
    Uniform,
}

/// An operand with a value per lane: a small letter of the table.
struct LaneOperand(usize);

/// A uniform operand: a capital letter of the table.
struct UniformOperand(usize);

/// The values of the operands that the tree of an instruction reads.
struct Operands<'a> {
    lanes: [&'a F32s; OPERANDS],
    uniform: [f32; OPERANDS],
}

impl<'a> Operands<'a> {
    /// `storage` is constant where this is inlined: for operands that the tree does not have, no code remains.
    #[inline(always)]
    fn of(
        storage: [Option<OperandStorage>; OPERANDS],
        registers: &'a [U32s],
        splats: &[f32],
        args: &[Reg; OPERANDS],
    ) -> Self {
        let mut operands = Self { lanes: [&F32s::ZERO; OPERANDS], uniform: [0.0; OPERANDS] };
        for at in 0..OPERANDS {
            let register = args[at].0 as usize;
            match storage[at] {
                Some(OperandStorage::PerLane) => operands.lanes[at] = registers[register].as_f32(),
                Some(OperandStorage::Uniform) => operands.uniform[at] = splats[register],
                None => {}
            }
        }
        operands
    }
}

impl LaneOperand {
    const fn tree(self) -> Tree {
        Tree::Operand(self.0, OperandStorage::PerLane)
    }

    #[inline(always)]
    fn of(self, operands: &Operands<'_>, lane: usize) -> f32 {
        operands.lanes[self.0][lane]
    }
}

impl UniformOperand {
    const fn tree(self) -> Tree {
        Tree::Operand(self.0, OperandStorage::Uniform)
    }

    #[inline(always)]
    fn of(self, operands: &Operands<'_>, _lane: usize) -> f32 {
        operands.uniform[self.0]
    }
}

macro_rules! tree {
    ($op:ident ($($arg:tt)*)) => { Tree::Node(Op::$op, tree!(@list [] $($arg)*)) };
    (@list [$($done:expr,)*]) => { const { &[$($done),*] } };
    (@list [$($done:expr,)*] $op:ident ($($arg:tt)*) $(, $($rest:tt)*)?) => {
        tree!(@list [$($done,)* tree!($op ($($arg)*)),] $($($rest)*)?)
    };
    (@list [$($done:expr,)*] $operand:ident $(, $($rest:tt)*)?) => {
        tree!(@list [$($done,)* operand::$operand.tree(),] $($($rest)*)?)
    };
}

/// The operands by their letters in the table.
#[expect(non_upper_case_globals, reason = "they are letters of the table")]
mod operand {
    use super::{LaneOperand, UniformOperand};

    pub const a: LaneOperand = LaneOperand(0);
    pub const b: LaneOperand = LaneOperand(1);
    pub const c: LaneOperand = LaneOperand(2);
    pub const d: LaneOperand = LaneOperand(3);
    pub const e: LaneOperand = LaneOperand(4);
    pub const f: LaneOperand = LaneOperand(5);
    pub const g: LaneOperand = LaneOperand(6);
    pub const B: UniformOperand = UniformOperand(1);
    pub const C: UniformOperand = UniformOperand(2);
    pub const D: UniformOperand = UniformOperand(3);
    pub const E: UniformOperand = UniformOperand(4);
    pub const F: UniformOperand = UniformOperand(5);
    pub const G: UniformOperand = UniformOperand(6);
    pub const H: UniformOperand = UniformOperand(7);
}

/// The tree as an expression on one lane.
macro_rules! expression {
    ($S:ident $args:ident $lane:ident $op:ident ($($arg:tt)*)) => {
        expression!(@list $S $args $lane $op [] $($arg)*)
    };
    (@list $S:ident $args:ident $lane:ident $op:ident [$($done:expr,)*]) => {
        scalar::$op::<$S>($($done),*)
    };
    (@list $S:ident $args:ident $lane:ident $op:ident [$($done:expr,)*] $inner:ident ($($arg:tt)*) $(, $($rest:tt)*)?) => {
        expression!(@list $S $args $lane $op
            [$($done,)* expression!($S $args $lane $inner ($($arg)*)),] $($($rest)*)?)
    };
    (@list $S:ident $args:ident $lane:ident $op:ident [$($done:expr,)*] $operand:ident $(, $($rest:tt)*)?) => {
        expression!(@list $S $args $lane $op
            [$($done,)* operand::$operand.of(&$args, $lane),] $($($rest)*)?)
    };
}

macro_rules! trees {
    ([$($One:ident)*] $($(#[doc = $doc:literal])+ $Name:ident = $op:ident ($($arg:tt)*);)*) => {
        /// What an instruction computes. (One enum, so that it takes one jump to run it.)
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(super) enum Compute {
            $(#[doc = "The operation of this name by itself."] $One,)*
            $($(#[doc = $doc])+ $Name,)*
        }

        impl From<Op> for Compute {
            fn from(op: Op) -> Self {
                match op {
                    $(Op::$One => Self::$One,)*
                }
            }
        }

        impl Compute {
            /// The trees. Larger ones before those that they contain.
            pub const TREES: &[(Self, Tree)] = &[$((Self::$Name, tree!($op ($($arg)*)))),*];

            /// The tree, or what is an operation by itself.
            pub fn as_tree(self) -> Result<Tree, Op> {
                match self {
                    $(Self::$One => Err(Op::$One),)*
                    $(Self::$Name => Ok(tree!($op ($($arg)*))),)*
                }
            }

            /// Computes 64 lanes of a register file of registers: what is at `args` to `out`, which may be
            /// one of them. Operands beyond the arity are not read. `splats` has what the first
            /// registers hold in all their lanes.
            #[inline(always)]
            pub fn run<S: Simd>(
                self,
                registers: &mut [U32s],
                splats: &[f32],
                out: Reg,
                args: &[Reg; OPERANDS],
            ) {
                let out = out.0 as usize;
                let [a, b, c, ..] = args;
                match self {
                    $(Self::$One => {
                        let args = [a.0 as usize, b.0 as usize, c.0 as usize];
                        batch::$One::<S>(registers, out, args);
                    })*
                    $(Self::$Name => {
                        // All operands of the table are floats, and are loaded as such.
                        let storage = const { tree!($op ($($arg)*)).operands() };
                        let args = Operands::of(storage, registers, splats, args);
                        // Of each arm by itself, so that the compiler knows that no operand is written.
                        let mut result = F32s::ZERO;
                        for lane in 0..LANES {
                            result[lane] = expression!(S args lane $op ($($arg)*));
                        }
                        registers[out] = *result.as_u32();
                    })*
                }
            }
        }
    };
}

with_operations! { trees! {
    /// A lattice point's number in noise: `mod((C x + D) x, E) / E` of `x = a + b`; `F` is the inverse of `E`.
    HashSum = Div(ModPositive(Mul(Add(Mul(Add(a, b), C), D), Add(a, b)), E, F), E);
    /// The same before it is divided.
    PermuteSum = ModPositive(Mul(Add(Mul(Add(a, b), C), D), Add(a, b)), E, F);
    /// `mod((a B + C) a, D)`; `E` is the inverse of `D`.
    Permute = ModPositive(Mul(Add(Mul(a, B), C), a), D, E);
    /// `x - floor(x D) E` of `x = (a B + C) a`.
    PermuteFloor = Sub(Mul(Add(Mul(a, B), C), a), Mul(Floor(Mul(Mul(Add(Mul(a, B), C), a), D)), E));
    /// `a - floor(a B) C`.
    SubFloor = Sub(a, Mul(Floor(Mul(a, B)), C));
    /// A row of a matrix times a vector, `a B + c D + e F + g H`.
    Dot4Uniform = Add(Add(Add(Mul(a, B), Mul(c, D)), Mul(e, F)), Mul(g, H));
    /// `a B + c D + e F`.
    Dot3Uniform = Add(Add(Mul(a, B), Mul(c, D)), Mul(e, F));
    /// `a b + c d + e f`, but at least `G`.
    Dot3AtLeast = AtLeast(Add(Add(Mul(a, b), Mul(c, d)), Mul(e, f)), G);
    /// Hermite's cubic of the fraction of `a`.
    FractSmooth = Mul(Mul(Fract(a), Fract(a)), Sub(B, Mul(C, Fract(a))));
    /// Hermite's cubic, `a² (B - C a)`.
    Smooth = Mul(Mul(a, a), Sub(B, Mul(C, a)));
    /// GLSL's `mix`, `a (C - d) + b d`.
    Mix = Add(Mul(a, Sub(C, d)), Mul(b, d));
    /// One over the length of (`a`, `b`, `c`).
    InverseLength3 = InverseSqrt(Add(Add(Mul(a, a), Mul(b, b)), Mul(c, c)));
    /// One over the length of a vector of (`a`, `b`) and what has the square `C`.
    InverseLength2Uniform = InverseSqrt(Add(Add(Mul(a, a), Mul(b, b)), C));
    /// The length of (`a`, `b`, `c`).
    Length3 = Sqrt(Add(Add(Mul(a, a), Mul(b, b)), Mul(c, c)));
    /// `E √(a² + b² + (c + D)²)`, what sphere maps divide by.
    SphereMap = Mul(Sqrt(Add(Add(Mul(a, a), Mul(b, b)), Mul(Add(c, D), Add(c, D)))), E);
    /// `a² + b² + c²`.
    Squares3 = Add(Add(Mul(a, a), Mul(b, b)), Mul(c, c));
    /// The length of (`a`, `b`).
    Length2 = Sqrt(Add(Mul(a, a), Mul(b, b)));
    /// `a b + c d + e f`.
    Dot3 = Add(Add(Mul(a, b), Mul(c, d)), Mul(e, f));
    /// `a² - b² + c`.
    SquaresSubAdd = Add(Sub(Mul(a, a), Mul(b, b)), c);
    /// `(a b + c d) e`.
    Dot2Mul = Mul(Add(Mul(a, b), Mul(c, d)), e);
    /// `a B + c D`.
    Dot2Uniform = Add(Mul(a, B), Mul(c, D));
    /// `a b + c D`.
    Dot2HalfUniform = Add(Mul(a, b), Mul(c, D));
    /// `a b + c d`.
    Dot2 = Add(Mul(a, b), Mul(c, d));
    /// `a b - c d`.
    Cross = Sub(Mul(a, b), Mul(c, d));
    /// `(a B + C) a`.
    MulAddMulSelf = Mul(Add(Mul(a, B), C), a);
    /// `(a B + C) d`.
    MulAddMulUniform = Mul(Add(Mul(a, B), C), d);
    /// `(a b + c) d`.
    MulAddMul = Mul(Add(Mul(a, b), c), d);
    /// `(a b) c + d`.
    MulMulAdd = Add(Mul(Mul(a, b), c), d);
    /// `(a + b) C + d`.
    AddMulAddUniform = Add(Mul(Add(a, b), C), d);
    /// `(a + b) c + d`.
    AddMulAdd = Add(Mul(Add(a, b), c), d);
    /// `(a - b) c + d`.
    SubMulAdd = Add(Mul(Sub(a, b), c), d);
    /// `c` where `a < b`, else `d`.
    LessSelect = SelectF(Less(a, b), c, d);
    /// `c` where `a <= b`, else `d`.
    LessEqualSelect = SelectF(LessEqual(a, b), c, d);
    /// `a` held between `B` and `C`, times `d`.
    ClampMul = Mul(AtMost(AtLeast(a, B), C), d);
    /// `a` held between `B` and `C`.
    Clamp = AtMost(AtLeast(a, B), C);
    /// `a / b + C`.
    DivAddUniform = Add(Div(a, b), C);
    /// The root of `a`, times `B`.
    SqrtMulUniform = Mul(Sqrt(a), B);
    /// `a B + C`.
    MulAddUniform = Add(Mul(a, B), C);
    /// `a B + c`.
    MulUniformAdd = Add(Mul(a, B), c);
    /// `a b + c`, two roundings.
    MulAdd = Add(Mul(a, b), c);
    /// `a B - C`.
    MulSubUniform = Sub(Mul(a, B), C);
    /// `a b - c`.
    MulSub = Sub(Mul(a, b), c);
    /// `c - a b`.
    SubMul = Sub(c, Mul(a, b));
    /// `(a + b) c`.
    AddThenMul = Mul(Add(a, b), c);
    /// `(a - b) c`.
    SubThenMul = Mul(Sub(a, b), c);
    /// `a b c`.
    MulMul = Mul(Mul(a, b), c);
    /// `a + b + c`.
    AddAdd = Add(Add(a, b), c);
    /// The fraction of `a b`.
    MulFract = Fract(Mul(a, b));
    /// The fraction of `a + b`.
    AddFract = Fract(Add(a, b));
    /// `a b`, but at least `C`.
    MulAtLeast = AtLeast(Mul(a, b), C);
    /// `a + b`, but at least `C`.
    AddAtLeast = AtLeast(Add(a, b), C);
    /// `a + B`.
    AddUniform = Add(a, B);
    /// `a - B`.
    SubUniform = Sub(a, B);
    /// `B - a`.
    SubFromUniform = Sub(B, a);
    /// `a B`.
    MulUniform = Mul(a, B);
    /// `a / B`.
    DivUniform = Div(a, B);
    /// `a`, but at least `B`.
    AtLeastUniform = AtLeast(a, B);
    /// GLSL's `mod` of `a + B` and `C` above 0, whose inverse is `D`.
    AddMod = ModPositive(Add(a, B), C, D);
    /// GLSL's `mod` of `a` and `B` above 0, whose inverse is `C`.
    ModUniform = ModPositive(a, B, C);
} }

impl Compute {
    /// The number of operands; a tree may read an operand more than once, or not at all.
    pub fn arity(self) -> usize {
        match self.as_tree() {
            Ok(_) => OPERANDS,
            Err(op) => op.args().len(),
        }
    }

    /// The type of the result.
    pub fn result(self) -> Ty {
        match self.as_tree() {
            Ok(Tree::Node(op, _)) | Err(op) => op.result(),
            Ok(Tree::Operand(..)) => Ty::F32,
        }
    }

    /// The formula, with what `operand` makes of its operands.
    pub fn expression(self, operand: &impl Fn(usize, Ty) -> Expression) -> Expression {
        match self.as_tree() {
            Ok(tree) => tree.expression(Ty::F32, operand),
            Err(op) => {
                let args = op.args().iter().enumerate().map(|(at, &ty)| operand(at, ty));
                Expression::Apply(op, args.collect())
            }
        }
    }

    /// The cost in additions, approximately: of all operations, and of the longest chain.
    pub fn size(self) -> [u32; 2] {
        match self.as_tree() {
            Ok(tree) => tree.size(),
            Err(op) => [op.cost(), op.cost().min(8)],
        }
    }
}

impl Tree {
    /// The storage of each operand, `None` for those that the tree does not have.
    const fn operands(self) -> [Option<OperandStorage>; OPERANDS] {
        let mut all = [None; OPERANDS];
        match self {
            Self::Operand(at, storage) => all[at] = Some(storage),
            Self::Node(_, trees) => {
                let mut tree = 0;
                while tree < trees.len() {
                    let of = trees[tree].operands();
                    let mut at = 0;
                    while at < OPERANDS {
                        if of[at].is_some() {
                            all[at] = of[at];
                        }
                        at += 1;
                    }
                    tree += 1;
                }
            }
        }
        all
    }

    fn size(&self) -> [u32; 2] {
        match self {
            Self::Operand(..) => [0, 0],
            Self::Node(op, trees) => {
                let (mut cost, mut depth) = (0, 0);
                for [of, under] in trees.iter().map(Self::size) {
                    cost += of;
                    depth = under.max(depth);
                }
                [cost + op.cost(), depth + op.cost()]
            }
        }
    }

    fn expression(&self, ty: Ty, operand: &impl Fn(usize, Ty) -> Expression) -> Expression {
        match self {
            Self::Operand(at, _) => operand(*at, ty),
            Self::Node(op, trees) => {
                let args = trees.iter().zip(op.args());
                let args = args.map(|(tree, &ty)| tree.expression(ty, operand));
                Expression::Apply(*op, args.collect())
            }
        }
    }
}
