//! A checked shader: every name resolved, every expression typed, every conversion written out.

use super::MatrixOrder;
use super::ast::{BinaryOp, Step, StepResult, UnaryOp};
use super::builtins::functions::Row;
use super::builtins::variables::Builtin;
use super::source::Span;
use super::types::Type;
use super::version::Version;
use rasterizer::ir::{Interpolation, Stage};
use std::collections::BTreeSet;
use std::sync::Arc;

/// A checked shader.
#[derive(Clone, Debug)]
pub struct Unit {
    /// Its stage.
    pub stage: Stage,
    /// The version it is written in.
    pub version: Version,
    /// Whether all that it passes on is invariant, by a `#pragma`.
    pub all_invariant: bool,
    /// Its global variables, those of the language that it names among them.
    pub globals: Vec<Variable>,
    /// Its functions, prototypes among them.
    pub functions: Vec<Function>,
    /// The functions that initializers of globals call.
    pub calls: Vec<u32>,
}

/// A variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum VarRef {
    /// Of the unit.
    Global(u32),
    /// Of the function; the parameters come first.
    Local(u32),
}

/// Which way a parameter goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// `in`.
    In,
    /// `out`.
    Out,
    /// `inout`.
    Inout,
}

/// What a variable is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// Read and written.
    Plain,
    /// `const`.
    Const,
    /// A parameter.
    Parameter(Direction),
    /// `uniform`.
    Uniform,
    /// `attribute`, or `in` of the vertex stage.
    Attribute,
    /// `varying` of the vertex stage, or its `out`.
    Output(Interpolation),
    /// `varying` of the fragment stage, or its `in`.
    Input(Interpolation),
    /// `out` of the fragment stage.
    FragmentOutput,
    /// Part of the language.
    Builtin(Builtin),
}

/// The words about how a variable passes between the stages, as written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Passing {
    /// `smooth`, `flat` or `noperspective`.
    pub interpolation: Option<Interpolation>,
    /// `invariant`.
    pub invariant: bool,
    /// `centroid`.
    pub centroid: bool,
    /// `layout(origin_upper_left)`.
    pub origin_upper_left: bool,
    /// `layout(pixel_center_integer)`.
    pub pixel_center_integer: bool,
    /// `layout(location = n)`.
    pub location: Option<u32>,
}

/// How a uniform block lies in its buffer (ARB_uniform_buffer_object, section 4.3.5.2). They lie
/// all as `std140` says; what is `packed` and not named is not there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Packing {
    /// `shared`.
    Shared,
    /// `packed`.
    Packed,
    /// `std140`.
    Std140,
}

/// What makes a uniform that is a structure a uniform block: its members have the names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// The block's name.
    pub name: Arc<str>,
    /// How it lies in its buffer.
    pub packing: Packing,
    /// How the matrices of each member lie.
    pub orders: Vec<MatrixOrder>,
}

/// A variable.
#[derive(Clone, Debug)]
pub struct Variable {
    /// Its name.
    pub name: Arc<str>,
    /// Its type.
    pub ty: Type,
    /// What it is.
    pub storage: Storage,
    /// Where its name is declared.
    pub span: Span,
    /// Where the type stands, if this is the only name declared with it.
    pub type_span: Option<Span>,
    /// Whether anything but its initializer writes it.
    pub written: bool,
    /// Whether it is indexed by what is not constant.
    pub dynamic: bool,
    /// Of an array: one more than the largest constant index.
    pub indexed: u32,
    /// How often it is named.
    pub named: u32,
    /// How often of these it is an array of which a constant names an element.
    pub picked: u32,
    /// The words about how it passes between the stages, as written.
    pub passing: Passing,
    /// Whether the size of the array comes from its largest index alone.
    pub implicit: bool,
    /// What it is as a uniform block.
    pub block: Option<Arc<Block>>,
    /// Its words, if it is a constant.
    pub constant: Option<Arc<[u32]>>,
    /// The initializer of a global.
    pub init: Option<Expr>,
}

impl Variable {
    /// One that nothing is known of but how it is declared, at `span`.
    pub fn new(name: Arc<str>, ty: Type, storage: Storage, span: Span) -> Self {
        Self {
            name,
            ty,
            storage,
            span,
            type_span: None,
            written: false,
            dynamic: false,
            indexed: 0,
            named: 0,
            picked: 0,
            passing: Passing::default(),
            implicit: false,
            block: None,
            constant: None,
            init: None,
        }
    }

    /// Whether its value has effects, so that it is worked out even if nobody names the variable.
    pub fn has_effects(&self) -> bool {
        self.storage == Storage::Plain && self.init.as_ref().is_some_and(Expr::has_effects)
    }

    /// How many elements of an array anything names, from the first one on (GL 2.1, section 2.15.3:
    /// the highest index used, plus one); `None` where all may be.
    pub fn reach(&self) -> Option<u32> {
        (self.named == self.picked).then_some(self.indexed)
    }
}

/// A function.
#[derive(Clone, Debug)]
pub struct Function {
    /// Its name.
    pub name: Arc<str>,
    /// Which way its parameters go; their variables are the first locals.
    pub directions: Vec<Direction>,
    /// What it returns.
    pub result: Type,
    /// Parameters and local variables.
    pub locals: Vec<Variable>,
    /// Its body; `None` for a prototype.
    pub body: Option<Vec<Stmt>>,
    /// Where its name stands.
    pub span: Span,
    /// The functions it calls, with repetitions.
    pub calls: Vec<(u32, Span)>,
    /// The globals it names, each once, in order.
    pub globals: Vec<u32>,
}

impl Function {
    /// Which ways its parameters go, and which are constant.
    pub fn ways(&self) -> impl Iterator<Item = Storage> {
        self.locals.iter().take(self.directions.len()).map(|local| local.storage)
    }

    /// The types of the parameters.
    pub fn parameters(&self) -> impl Iterator<Item = &Type> {
        self.locals[..self.directions.len()].iter().map(|local| &local.ty)
    }

    /// Name and parameter types, which make a function what it is.
    pub fn signature(&self) -> String {
        let types: Vec<String> = self.parameters().map(ToString::to_string).collect();
        format!("{}({})", self.name, types.join(", "))
    }
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// Its type.
    pub ty: Type,
    /// Where it stands.
    pub span: Span,
    /// Whether it is a constant expression (GLSL 1.30 section 4.3.3).
    pub constant: bool,
    /// What it is.
    pub kind: ExprKind,
}

/// What an expression is.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// These words.
    Const(Arc<[u32]>),
    /// A variable.
    Var(VarRef),
    /// Each component as the scalar of the expression's type.
    Convert(Box<Expr>),
    /// An operator with one operand.
    Unary(UnaryOp, Box<Expr>),
    /// An operator with two operands.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// `target = value` or `target op= value`.
    Assign(Option<BinaryOp>, Box<Expr>, Box<Expr>),
    /// `++`, `--`.
    Step(Step, StepResult, Box<Expr>),
    /// `a ? b : c`.
    Conditional(Box<[Expr; 3]>),
    /// All, one after the other; the value of the last.
    Comma(Vec<Expr>),
    /// `a[b]`.
    Index(Box<Expr>, Box<Expr>),
    /// The member of this index of a structure.
    Field(Box<Expr>, u32),
    /// Components of a vector.
    Swizzle(Box<Expr>, Vec<u8>),
    /// A constructor.
    Construct(Vec<Expr>),
    /// A function of the unit.
    Call(u32, Vec<Expr>),
    /// A function of the language.
    Builtin(&'static Row, Vec<Expr>),
    /// What was wrong; the shader does not link.
    Error,
}

impl Expr {
    /// What stands for something wrong.
    pub fn error(span: Span) -> Self {
        Self { ty: Type::Error, span, constant: false, kind: ExprKind::Error }
    }

    /// Whether this was wrong already.
    pub fn is_error(&self) -> bool {
        self.ty == Type::Error
    }

    /// The variable that this is a part of.
    pub fn root(&self) -> Option<VarRef> {
        match &self.kind {
            ExprKind::Var(var) => Some(*var),
            ExprKind::Index(base, _) | ExprKind::Field(base, _) | ExprKind::Swizzle(base, _) => {
                base.root()
            }
            ExprKind::Const(_)
            | ExprKind::Convert(_)
            | ExprKind::Unary(..)
            | ExprKind::Binary(..)
            | ExprKind::Assign(..)
            | ExprKind::Step(..)
            | ExprKind::Conditional(_)
            | ExprKind::Comma(_)
            | ExprKind::Construct(_)
            | ExprKind::Call(..)
            | ExprKind::Builtin(..)
            | ExprKind::Error => None,
        }
    }

    /// Adds the globals of its unit that it names.
    pub fn add_globals(&self, found: &mut BTreeSet<u32>) {
        match &self.kind {
            ExprKind::Var(VarRef::Global(index)) => {
                found.insert(*index);
            }
            ExprKind::Const(_) | ExprKind::Var(VarRef::Local(_)) | ExprKind::Error => {}
            ExprKind::Convert(a)
            | ExprKind::Unary(_, a)
            | ExprKind::Step(_, _, a)
            | ExprKind::Field(a, _)
            | ExprKind::Swizzle(a, _) => a.add_globals(found),
            ExprKind::Binary(_, a, b) | ExprKind::Index(a, b) | ExprKind::Assign(_, a, b) => {
                a.add_globals(found);
                b.add_globals(found);
            }
            ExprKind::Conditional(all) => all.iter().for_each(|part| part.add_globals(found)),
            ExprKind::Comma(all)
            | ExprKind::Construct(all)
            | ExprKind::Call(_, all)
            | ExprKind::Builtin(_, all) => all.iter().for_each(|part| part.add_globals(found)),
        }
    }

    /// Whether evaluating it can be seen otherwise than by its value, or takes long: a call of a
    /// function, or a write.
    pub fn has_effects(&self) -> bool {
        match &self.kind {
            ExprKind::Assign(..) | ExprKind::Step(..) | ExprKind::Call(..) => true,
            ExprKind::Const(_) | ExprKind::Var(_) | ExprKind::Error => false,
            ExprKind::Convert(a)
            | ExprKind::Unary(_, a)
            | ExprKind::Field(a, _)
            | ExprKind::Swizzle(a, _) => a.has_effects(),
            ExprKind::Binary(_, a, b) | ExprKind::Index(a, b) => a.has_effects() || b.has_effects(),
            ExprKind::Conditional(all) => all.iter().any(Self::has_effects),
            ExprKind::Comma(all) | ExprKind::Construct(all) => all.iter().any(Self::has_effects),
            ExprKind::Builtin(row, all) => row.writes() || all.iter().any(Self::has_effects),
        }
    }
}

/// A statement.
#[derive(Clone, Debug)]
pub enum Stmt {
    /// A local variable comes into being.
    Declare(u32, Option<Expr>),
    /// An expression.
    Expr(Expr),
    /// A block.
    Block(Vec<Stmt>),
    /// `if`.
    If(Expr, Vec<Stmt>, Vec<Stmt>),
    /// Any loop.
    Loop(Box<Loop>),
    /// `switch`: the selector and its groups of statements.
    Switch(Expr, Vec<Case>),
    /// `return`.
    Return(Option<Expr>),
    /// `break`.
    Break,
    /// `continue`.
    Continue,
    /// `discard`.
    Discard,
}

/// A loop.
#[derive(Clone, Debug)]
pub struct Loop {
    /// The variable that the condition declares.
    pub declare: Option<u32>,
    /// Tested before each turn.
    pub before: Option<Expr>,
    /// The body.
    pub body: Vec<Stmt>,
    /// Runs after each turn.
    pub step: Option<Expr>,
    /// Tested after each turn.
    pub after: Option<Expr>,
}

/// A label's statements, up to the next label.
#[derive(Clone, Debug)]
pub struct Case {
    /// The values that lead here.
    pub labels: Vec<u32>,
    /// Whether `default` leads here.
    pub default: bool,
    /// The statements.
    pub body: Vec<Stmt>,
}
