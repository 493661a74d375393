//! What an instruction computes: an operation, or several as one, so that what is between them stays in
//! registers.
//!
//! A row of the table is a tree of operations over up to four operands. It is read twice: as the
//! kernel, where each node is the operation's own body ([`scalar`]), and as the pattern that is
//! looked for in the code. So a fused instruction cannot differ from the operations it replaces.
//!
//! Operands with large letters hold the same in all lanes: constants and values of uniforms, of which shaders are
//! full. They are read once, and not where the lanes' registers are: those lie at multiples of 256 bytes, and a
//! processor that knows stores on their way by the low twelve bits of their addresses takes every sixteenth
//! register for the same.

use super::inst::{Inst, Reg, Role};
use super::lower::{Kind, Lowered};
use crate::ir::{Op, Ty, batch, scalar, with_operations};
use crate::trace::Expression;
use texunit::lanes::{F32s, LANES, Simd, U32s};

/// The most operands of an instruction.
pub(super) const OPERANDS: usize = 4;

/// A tree of operations.
#[derive(Clone, Copy, Debug)]
enum Tree {
    /// An operand of the fused instruction; the same one each time it stands in the tree.
    Operand(usize, Holds),
    Node(Op, &'static [Self]),
}

/// What an operand holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Holds {
    /// A number for each lane.
    Lanes,
    /// The same number in all lanes, see [`Kind::Splat`].
    Same,
}

/// A small letter of the table.
struct Lanes(usize);

/// A large letter of the table.
struct Same(usize);

/// What the operands of an instruction hold, as far as its tree asks.
struct Operands<'a> {
    lanes: [&'a F32s; OPERANDS],
    same: [f32; OPERANDS],
}

impl Lanes {
    const fn tree(self) -> Tree {
        Tree::Operand(self.0, Holds::Lanes)
    }

    #[inline(always)]
    fn of(self, operands: &Operands<'_>, lane: usize) -> f32 {
        operands.lanes[self.0][lane]
    }
}

impl Same {
    const fn tree(self) -> Tree {
        Tree::Operand(self.0, Holds::Same)
    }

    #[inline(always)]
    fn of(self, operands: &Operands<'_>, _lane: usize) -> f32 {
        operands.same[self.0]
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
    use super::{Lanes, Same};

    pub const a: Lanes = Lanes(0);
    pub const b: Lanes = Lanes(1);
    pub const c: Lanes = Lanes(2);
    pub const d: Lanes = Lanes(3);
    pub const B: Same = Same(1);
    pub const C: Same = Same(2);
    pub const D: Same = Same(3);
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
            const TREES: &[(Self, Tree)] = &[$((Self::$Name, tree!($op ($($arg)*)))),*];

            /// The tree, or what is an operation by itself.
            fn as_tree(self) -> Result<Tree, Op> {
                match self {
                    $(Self::$One => Err(Op::$One),)*
                    $(Self::$Name => Ok(tree!($op ($($arg)*))),)*
                }
            }

            /// Computes 64 lanes of a file of registers: what is at `args` to `out`, which may be
            /// one of them. Operands that there are not are not looked at. `same` has what the first
            /// registers hold in all their lanes.
            #[inline(always)]
            pub fn run<S: Simd>(
                self,
                registers: &mut [U32s],
                same: &[f32],
                out: Reg,
                args: [Reg; OPERANDS],
            ) {
                let (out, args) = (out.0 as usize, args.map(|arg| arg.0 as usize));
                let [a, b, c, _] = args;
                match self {
                    $(Self::$One => batch::$One::<S>(registers, out, [a, b, c]),)*
                    $(Self::$Name => {
                        // All operands of the table are floats, and are loaded as such.
                        let args = Operands {
                            lanes: args.map(|at| registers[at].as_f32()),
                            same: args.map(|at| same.get(at).copied().unwrap_or_default()),
                        };
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
    /// Hermite's cubic of the fraction of `a`.
    FractSmooth = Mul(Mul(Fract(a), Fract(a)), Sub(B, Mul(C, Fract(a))));
    /// Hermite's cubic, `a² (B - C a)`.
    Smooth = Mul(Mul(a, a), Sub(B, Mul(C, a)));
    /// GLSL's `mix`, `a (C - d) + b d`.
    Mix = Add(Mul(a, Sub(C, d)), Mul(b, d));
    /// One over the length of (`a`, `b`, `c`).
    InverseLength3 = InverseSqrt(Add(Add(Mul(a, a), Mul(b, b)), Mul(c, c)));
    /// One over the length of a vector of (`a`, `b`) and what has the square `C`.
    InverseLength2Same = InverseSqrt(Add(Add(Mul(a, a), Mul(b, b)), C));
    /// The length of (`a`, `b`, `c`).
    Length3 = Sqrt(Add(Add(Mul(a, a), Mul(b, b)), Mul(c, c)));
    /// `a² + b² + c²`.
    Squares3 = Add(Add(Mul(a, a), Mul(b, b)), Mul(c, c));
    /// The length of (`a`, `b`).
    Length2 = Sqrt(Add(Mul(a, a), Mul(b, b)));
    /// `a² - b² + c`.
    SquaresSubAdd = Add(Sub(Mul(a, a), Mul(b, b)), c);
    /// `a B + c D`.
    Dot2Same = Add(Mul(a, B), Mul(c, D));
    /// `a b + c D`.
    Dot2HalfSame = Add(Mul(a, b), Mul(c, D));
    /// `a b + c d`.
    Dot2 = Add(Mul(a, b), Mul(c, d));
    /// `a b - c d`.
    Cross = Sub(Mul(a, b), Mul(c, d));
    /// `(a B + C) a`.
    MulAddMulSelf = Mul(Add(Mul(a, B), C), a);
    /// `(a B + C) d`.
    MulAddMulSame = Mul(Add(Mul(a, B), C), d);
    /// `(a b + c) d`.
    MulAddMul = Mul(Add(Mul(a, b), c), d);
    /// `(a b) c + d`.
    MulMulAdd = Add(Mul(Mul(a, b), c), d);
    /// `(a + b) C + d`.
    AddMulAddSame = Add(Mul(Add(a, b), C), d);
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
    DivAddSame = Add(Div(a, b), C);
    /// The root of `a`, times `B`.
    SqrtMulSame = Mul(Sqrt(a), B);
    /// `a B + C`.
    MulAddSame = Add(Mul(a, B), C);
    /// `a B + c`.
    MulSameAdd = Add(Mul(a, B), c);
    /// `a b + c`, two roundings.
    MulAdd = Add(Mul(a, b), c);
    /// `a B - C`.
    MulSubSame = Sub(Mul(a, B), C);
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
    AddSame = Add(a, B);
    /// `a - B`.
    SubSame = Sub(a, B);
    /// `B - a`.
    SubFromSame = Sub(B, a);
    /// `a B`.
    MulSame = Mul(a, B);
    /// `a / B`.
    DivSame = Div(a, B);
    /// `a`, but at least `B`.
    AtLeastSame = AtLeast(a, B);
    /// GLSL's `mod` of `a` and `B` above 0, whose inverse is `C`.
    ModSame = ModPositive(a, B, C);
} }

impl Compute {
    /// How many operands it has; a tree may look at some of them more than once, or not at all.
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

    /// About how many additions it takes as long as, all and those that follow one another.
    pub fn size(self) -> [u32; 2] {
        match self.as_tree() {
            Ok(tree) => tree.size(),
            Err(op) => [op.cost(), op.cost().min(8)],
        }
    }
}

impl Tree {
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

/// Replaces trees of operations by fused instructions. The code is over virtual registers, each
/// temporary written once.
pub(super) fn run(lowered: &mut Lowered) {
    let mut definitions = Definitions::of(lowered);
    for at in (0..lowered.code.len()).rev() {
        let Inst::Compute { out, .. } = lowered.code[at] else { continue };
        if definitions.taken[at] {
            continue;
        }
        let best = Compute::TREES.iter().find_map(|(what, tree)| {
            let mut found = Match::default();
            let fits = found.node(&lowered.code, &definitions, at, tree);
            (fits && found.is_whole(&lowered.code, &definitions)).then_some((*what, found))
        });
        if let Some((what, found)) = best {
            let first = found.operands.iter().flatten().next().copied().unwrap_or(out);
            let args = found.operands.map(|operand| operand.unwrap_or(first));
            lowered.code[at] = Inst::Compute { what, out, args };
            for inner in found.inner {
                definitions.taken[inner] = true;
            }
        }
    }
    super::allocate::compact(lowered, &definitions.taken);
}

/// Where temporaries are made, and how often they are read.
struct Definitions {
    /// By virtual register.
    of: Vec<Option<usize>>,
    reads: Vec<u32>,
    /// By virtual register: whether it holds the same in all lanes.
    same: Vec<bool>,
    /// By instruction: the number of jumps, and places that are jumped to, before it.
    block: Vec<u32>,
    /// By instruction: whether it has become part of another.
    taken: Vec<bool>,
}

impl Definitions {
    fn of(lowered: &mut Lowered) -> Self {
        let count = lowered.kinds.len();
        let (mut of, mut reads) = (vec![None; count], vec![0; count]);
        let mut block = Vec::with_capacity(lowered.code.len());
        let mut blocks = 0;
        for (at, inst) in lowered.code.iter_mut().enumerate() {
            // Whatever is jumped to stands behind or at one of these.
            blocks += u32::from(inst.is_control());
            block.push(blocks);
            inst.operands(&mut |reg, role| match role {
                Role::Read => reads[reg.0 as usize] += 1,
                Role::Write => {
                    if lowered.kinds[reg.0 as usize] == Kind::Temp {
                        of[reg.0 as usize] = Some(at);
                    }
                }
            });
        }
        let same = lowered.kinds.iter().map(|kind| matches!(kind, Kind::Splat { .. })).collect();
        Self { of, reads, same, block, taken: vec![false; lowered.code.len()] }
    }

    /// The operation of the same straight run of code that makes `reg`.
    fn maker(&self, reg: Reg, reader: usize) -> Option<usize> {
        let at = self.of[reg.0 as usize]?;
        (!self.taken[at] && self.block[at] == self.block[reader]).then_some(at)
    }
}

/// A tree that is being recognized.
#[derive(Clone, Debug, Default)]
struct Match {
    operands: [Option<Reg>; OPERANDS],
    /// The instructions that become part of the one at the root, once for each time they are read.
    inner: Vec<usize>,
}

impl Match {
    /// Whether the instruction at `at` is this tree's root.
    fn node(&mut self, code: &[Inst], definitions: &Definitions, at: usize, tree: &Tree) -> bool {
        let Tree::Node(wanted, trees) = tree else { return false };
        let Inst::Compute { what, args, .. } = &code[at] else { return false };
        if *what != Compute::from(*wanted) {
            return false;
        }
        let before = self.clone();
        if self.all(code, definitions, at, &args[..trees.len()], trees) {
            return true;
        }
        *self = before;
        // Which of two NaN comes out of a sum or product is the only thing their order decides.
        matches!(wanted, Op::Add | Op::Mul)
            && self.all(code, definitions, at, &[args[1], args[0]], trees)
    }

    fn all(
        &mut self,
        code: &[Inst],
        definitions: &Definitions,
        reader: usize,
        args: &[Reg],
        trees: &[Tree],
    ) -> bool {
        args.iter().zip(trees).all(|(&reg, tree)| match tree {
            Tree::Operand(operand, holds) => {
                let fits = *holds == Holds::Lanes || definitions.same[reg.0 as usize];
                fits && *self.operands[*operand].get_or_insert(reg) == reg
            }
            Tree::Node(..) => definitions.maker(reg, reader).is_some_and(|at| {
                let again = self.inner.contains(&at);
                self.inner.push(at);
                let read = self.inner.len();
                let fits = self.node(code, definitions, at, tree);
                if again {
                    self.inner.truncate(read);
                }
                fits
            }),
        })
    }

    /// Whether nothing else reads what the tree takes in.
    fn is_whole(&self, code: &[Inst], definitions: &Definitions) -> bool {
        self.inner.iter().all(|inner| {
            let reads = self.inner.iter().filter(|other| *other == inner).count();
            matches!(code[*inner], Inst::Compute { out, .. }
                if definitions.reads[out.0 as usize] as usize == reads)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ir::{Builder, Input, Interpolation, Output, Stage, Value};
    use crate::shader::Program;
    use crate::shader::tests::check;

    fn build(b: &mut Builder, tree: &Tree) -> Value {
        match tree {
            Tree::Operand(operand, Holds::Lanes) => b.input(Input::Varying(*operand as u16)),
            Tree::Operand(operand, Holds::Same) => b.uniform(*operand as u32, Ty::F32),
            Tree::Node(op, trees) => {
                let args: Vec<Value> = trees.iter().map(|tree| build(b, tree)).collect();
                b.op(*op, &args)
            }
        }
    }

    #[test]
    fn every_tree_is_found_and_gives_what_its_operations_give() {
        for (what, tree) in Compute::TREES {
            let mut b = Builder::new(Stage::Fragment);
            b.module_mut().varyings = vec![Interpolation::Smooth; OPERANDS];
            let value = build(&mut b, tree);
            let red = b.output(Output::Color { target: 0, component: 0 });
            b.store(red, value);
            let module = b.finish();
            let program = Program::new(&module, |_| true);
            assert_eq!(program.code.len(), 1, "{what:?}: {:?}", program.code);
            let corners = [0.0, -0.0, 1.0, -2.5, 3.75, 1e30, -1e-30, f32::INFINITY, f32::NAN];
            let same = [7.0_f32, -1.5, 0.25, 3.0].map(f32::to_bits);
            check(&module, &same, |input, lane| match input {
                Input::Varying(slot) => {
                    let roll = (lane * 7 + 3) * (usize::from(slot) * 5 + 2);
                    match corners.get(roll % 16) {
                        Some(corner) => corner.to_bits(),
                        None => (roll as f32 / 37.0 - 4.0).to_bits(),
                    }
                }
                other => unreachable!("{other:?}"),
            });
        }
    }
}
