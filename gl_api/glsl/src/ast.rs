//! The syntax tree, as written; nothing in it is checked yet.

use super::source::Span;
use std::sync::Arc;

/// A name and where it stands.
#[derive(Clone, Debug)]
pub struct Name {
    /// The name.
    pub text: Arc<str>,
    /// Where.
    pub span: Span,
}

/// An operator with one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnaryOp {
    /// `+a`.
    Plus,
    /// `-a`.
    Negate,
    /// `!a`.
    Not,
    /// `~a`.
    BitNot,
}

/// An operator with two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOp {
    /// `a + b`.
    Add,
    /// `a - b`.
    Sub,
    /// `a * b`.
    Mul,
    /// `a / b`.
    Div,
    /// `a % b`.
    Rem,
    /// `a << b`.
    ShiftLeft,
    /// `a >> b`.
    ShiftRight,
    /// `a & b`.
    BitAnd,
    /// `a | b`.
    BitOr,
    /// `a ^ b`.
    BitXor,
    /// `a < b`.
    Less,
    /// `a > b`.
    Greater,
    /// `a <= b`.
    LessEqual,
    /// `a >= b`.
    GreaterEqual,
    /// `a == b`.
    Equal,
    /// `a != b`.
    NotEqual,
    /// `a && b`.
    And,
    /// `a || b`.
    Or,
    /// `a ^^ b`.
    Xor,
}

/// Every binary operator: how it is written, and how tightly it binds (GLSL 1.30 section 5.1).
pub const BINARY: [(&str, BinaryOp, u8); 19] = [
    ("||", BinaryOp::Or, 1),
    ("^^", BinaryOp::Xor, 2),
    ("&&", BinaryOp::And, 3),
    ("|", BinaryOp::BitOr, 4),
    ("^", BinaryOp::BitXor, 5),
    ("&", BinaryOp::BitAnd, 6),
    ("==", BinaryOp::Equal, 7),
    ("!=", BinaryOp::NotEqual, 7),
    ("<", BinaryOp::Less, 8),
    (">", BinaryOp::Greater, 8),
    ("<=", BinaryOp::LessEqual, 8),
    (">=", BinaryOp::GreaterEqual, 8),
    ("<<", BinaryOp::ShiftLeft, 9),
    (">>", BinaryOp::ShiftRight, 9),
    ("+", BinaryOp::Add, 10),
    ("-", BinaryOp::Sub, 10),
    ("*", BinaryOp::Mul, 11),
    ("/", BinaryOp::Div, 11),
    ("%", BinaryOp::Rem, 11),
];

impl BinaryOp {
    /// The function that compares vectors as it compares scalars (section 8.6).
    pub fn vector_function(self) -> Option<&'static str> {
        match self {
            Self::Less => Some("lessThan"),
            Self::Greater => Some("greaterThan"),
            Self::LessEqual => Some("lessThanEqual"),
            Self::GreaterEqual => Some("greaterThanEqual"),
            Self::Equal
            | Self::NotEqual
            | Self::Add
            | Self::Sub
            | Self::Mul
            | Self::Div
            | Self::Rem
            | Self::ShiftLeft
            | Self::ShiftRight
            | Self::BitAnd
            | Self::BitOr
            | Self::BitXor
            | Self::And
            | Self::Or
            | Self::Xor => None,
        }
    }

    /// Whether it is for integers only, and so came with GLSL 1.30.
    pub fn is_integer(self) -> bool {
        matches!(
            self,
            Self::Rem
                | Self::BitAnd
                | Self::BitOr
                | Self::BitXor
                | Self::ShiftLeft
                | Self::ShiftRight
        )
    }

    /// As it is written.
    pub fn text(self) -> &'static str {
        BINARY.iter().find(|row| row.1 == self).map_or("", |row| row.0)
    }
}

/// `++` or `--`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// `++`.
    Increment,
    /// `--`.
    Decrement,
}

/// Which value a step has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepResult {
    /// The new one (`++a`).
    After,
    /// The old one (`a++`).
    Before,
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Expr {
    /// Where.
    pub span: Span,
    /// How many expressions stand inside one another in it.
    pub depth: u32,
    /// What.
    pub kind: ExprKind,
}

/// What an expression is.
#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A number without point.
    Int(i32),
    /// A number with the suffix `u`.
    Uint(u32),
    /// A number with point, exponent or suffix `f`.
    Float(f32),
    /// `true` or `false`.
    Bool(bool),
    /// A name.
    Name(Arc<str>),
    /// An operator with one operand.
    Unary(UnaryOp, Box<Expr>),
    /// An operator with two operands.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// `target = value` or, with an operator, `target op= value`.
    Assign(Option<BinaryOp>, Box<Expr>, Box<Expr>),
    /// `++`, `--`.
    Step(Step, StepResult, Box<Expr>),
    /// `a ? b : c`.
    Conditional(Box<[Expr; 3]>),
    /// `a, b, c`.
    Comma(Vec<Expr>),
    /// `a[b]`.
    Index(Box<Expr>, Box<Expr>),
    /// `a.b`: a member or a swizzle.
    Field(Box<Expr>, Name),
    /// `a.length()`.
    Method(Box<Expr>, Name),
    /// `name(arguments)`: a function or a structure.
    Call(Name, Vec<Expr>),
    /// `type(arguments)`.
    Construct(TypeName, Vec<Expr>),
    /// What could not be parsed; reported already.
    Error,
}

/// A type as written.
#[derive(Clone, Debug)]
pub struct TypeName {
    /// Where.
    pub span: Span,
    /// Its base.
    pub base: TypeBase,
    /// `[n]` or `[]` after the base (from version 120 on), the outermost first.
    pub array: Vec<ArraySize>,
}

/// The base of a type.
#[derive(Clone, Debug)]
pub enum TypeBase {
    /// A keyword or the name of a structure.
    Named(Arc<str>),
    /// `struct name { ... }`.
    Struct(Arc<StructDecl>),
}

/// A structure as written.
#[derive(Clone, Debug)]
pub struct StructDecl {
    /// Its name, if it has one.
    pub name: Option<Name>,
    /// Its members.
    pub fields: Vec<(TypeName, Name, Vec<ArraySize>)>,
}

/// `[]` or `[size]`.
#[derive(Clone, Debug)]
pub struct ArraySize {
    /// Where.
    pub span: Span,
    /// The size.
    pub size: Option<Box<Expr>>,
}

/// A word before the type in a declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Qualifier {
    /// `const`.
    Const,
    /// `attribute`.
    Attribute,
    /// `varying`.
    Varying,
    /// `uniform`.
    Uniform,
    /// `in`.
    In,
    /// `out`.
    Out,
    /// `inout`.
    Inout,
    /// `centroid`.
    Centroid,
    /// `invariant`.
    Invariant,
    /// `smooth`.
    Smooth,
    /// `flat`.
    Flat,
    /// `noperspective`.
    NoPerspective,
    /// `lowp`, `mediump` or `highp`.
    Precision,
    /// `layout(origin_upper_left)` of `gl_FragCoord`.
    OriginUpperLeft,
    /// `layout(pixel_center_integer)` of `gl_FragCoord`.
    PixelCenterInteger,
    /// `layout(location = n)`.
    Location(u32),
    /// `layout(std140)` and the like, of uniform blocks.
    Block(BlockLayout),
}

/// A word about how a uniform block lies in its buffer (ARB_uniform_buffer_object, section 4.3.5.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockLayout {
    /// `shared`.
    Shared,
    /// `packed`.
    Packed,
    /// `std140`.
    Std140,
    /// `row_major`.
    RowMajor,
    /// `column_major`.
    ColumnMajor,
}

impl Qualifier {
    /// Where it stands among others (GLSL 1.30 section 4.7): invariance, interpolation, storage,
    /// precision.
    pub fn rank(self) -> u8 {
        match self {
            Self::OriginUpperLeft
            | Self::PixelCenterInteger
            | Self::Location(_)
            | Self::Block(_)
            | Self::Invariant => 0,
            Self::Smooth | Self::Flat | Self::NoPerspective => 1,
            Self::Centroid | Self::Const => 2,
            Self::Attribute
            | Self::Varying
            | Self::Uniform
            | Self::In
            | Self::Out
            | Self::Inout => 3,
            Self::Precision => 4,
        }
    }
}

/// A qualified type.
#[derive(Clone, Debug)]
pub struct QualifiedType {
    /// Its qualifiers, in order.
    pub qualifiers: Vec<(Qualifier, Span)>,
    /// The type.
    pub ty: TypeName,
}

/// A declared name.
#[derive(Clone, Debug)]
pub struct Declarator {
    /// The name.
    pub name: Name,
    /// `[n]` after it, the outermost first.
    pub array: Vec<ArraySize>,
    /// `= value`.
    pub init: Option<Expr>,
}

/// A declaration of variables, or of nothing but a structure.
#[derive(Clone, Debug)]
pub struct Declaration {
    /// The type.
    pub ty: QualifiedType,
    /// The names.
    pub names: Vec<Declarator>,
}

/// A parameter.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its type.
    pub ty: QualifiedType,
    /// Its name, if it has one.
    pub name: Option<Name>,
    /// `[n]` after the name, the outermost first.
    pub array: Vec<ArraySize>,
}

/// A function.
#[derive(Clone, Debug)]
pub struct Function {
    /// What it returns.
    pub ty: QualifiedType,
    /// Its name.
    pub name: Name,
    /// Its parameters.
    pub parameters: Vec<Parameter>,
    /// Its body; `None` for a prototype.
    pub body: Option<Vec<Stmt>>,
}

/// A uniform block.
#[derive(Clone, Debug)]
pub struct BlockDecl {
    /// The words before its name.
    pub qualifiers: Vec<(Qualifier, Span)>,
    /// Its name.
    pub name: Name,
    /// What stands in it.
    pub members: Vec<Declaration>,
}

/// What stands outside of functions.
#[derive(Clone, Debug)]
pub enum Item {
    /// Variables.
    Declaration(Declaration),
    /// A function.
    Function(Function),
    /// A uniform block.
    Block(BlockDecl),
    /// `layout(std140) uniform;`: what the blocks after it begin with.
    BlockDefaults(Vec<(Qualifier, Span)>),
    /// `invariant a, b;`.
    Invariant(Vec<Name>),
    /// `precision highp float;`, with the type.
    Precision(TypeName),
}

/// A statement.
#[derive(Clone, Debug)]
pub struct Stmt {
    /// Where.
    pub span: Span,
    /// What.
    pub kind: StmtKind,
}

/// What a statement is.
#[derive(Clone, Debug)]
pub enum StmtKind {
    /// `;`.
    Empty,
    /// `precision highp float;`, with the type.
    Precision(TypeName),
    /// Variables.
    Declaration(Declaration),
    /// A function that is defined elsewhere.
    Prototype(Function),
    /// An expression.
    Expr(Expr),
    /// `{ ... }`.
    Block(Vec<Stmt>),
    /// `if`.
    If(Expr, Box<Stmt>, Option<Box<Stmt>>),
    /// `for`: start, condition, step, body.
    For(Option<Box<Stmt>>, Option<Condition>, Option<Expr>, Box<Stmt>),
    /// `while`.
    While(Condition, Box<Stmt>),
    /// `do ... while`.
    DoWhile(Box<Stmt>, Expr),
    /// `switch`.
    Switch(Expr, Vec<Stmt>),
    /// `case value:`.
    Case(Expr),
    /// `default:`.
    Default,
    /// `return`.
    Return(Option<Expr>),
    /// `break`.
    Break,
    /// `continue`.
    Continue,
    /// `discard`.
    Discard,
}

/// The condition of a loop.
#[derive(Clone, Debug)]
pub enum Condition {
    /// An expression.
    Expr(Expr),
    /// `bool name = value`.
    Declaration(Box<Declaration>),
}
