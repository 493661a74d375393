//! The operators (GLSL 1.30 section 5.1).

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

/// Every binary operator: its text, and its precedence (GLSL 1.30 section 5.1).
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
    /// The function that compares vectors (section 8.6).
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

    /// Whether it takes only integers, and so came with GLSL 1.30.
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
pub enum IncDec {
    /// `++`.
    Increment,
    /// `--`.
    Decrement,
}

/// Which value `++` or `--` has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum IncDecResult {
    /// The new one (`++a`).
    After,
    /// The old one (`a++`).
    Before,
}
