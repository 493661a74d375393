//! The expressions of `#if` and `#elif` (GLSL 1.30 section 3.3).

use super::macros::Macros;
use crate::language::Version;
use crate::lex::{Literal, Token, TokenKind, literal};
use crate::limits::MAX_CONDITION_DEPTH;
use crate::text::diagnostics::{Diagnostic, Log};
use crate::text::source::{Source, Span};

/// Evaluates a condition.
pub fn evaluate(
    span: Span,
    line: &[Token],
    macros: &mut Macros,
    source: &Source,
    version: Version,
    log: &mut Log,
) -> Result<i64, Box<Diagnostic>> {
    let tokens = macros.expand_condition(line.to_vec(), source, version, log)?;
    let mut parser = Parser { tokens: &tokens, at: 0, end: span, depth: 0, version, log };
    let value = parser.binary(0, Operand::Evaluated)?;
    match parser.tokens.get(parser.at) {
        None => Ok(value),
        Some(token) => {
            Err(Diagnostic::error(token.span, format!("unexpected {}", token.describe())).into())
        }
    }
}

/// The values of a sequence of constant expressions, macros already expanded.
pub fn values(
    span: Span,
    tokens: &[Token],
    version: Version,
    log: &mut Log,
) -> Result<Vec<i64>, Box<Diagnostic>> {
    let mut parser = Parser { tokens, at: 0, end: span, depth: 0, version, log };
    let mut values = Vec::new();
    while parser.at < tokens.len() {
        values.push(parser.binary(0, Operand::Evaluated)?);
    }
    Ok(values)
}

/// Whether an operand is evaluated: what `0 &&` and `1 ||` skip may be undefined.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Operand {
    Evaluated,
    ShortCircuited,
}

struct Parser<'a> {
    tokens: &'a [Token],
    at: usize,
    end: Span,
    depth: usize,
    version: Version,
    log: &'a mut Log,
}

/// Binary operators and their precedence.
const OPERATORS: [(&str, u8); 18] = [
    ("||", 1),
    ("&&", 2),
    ("|", 3),
    ("^", 4),
    ("&", 5),
    ("==", 6),
    ("!=", 6),
    ("<", 7),
    (">", 7),
    ("<=", 7),
    (">=", 7),
    ("<<", 8),
    (">>", 8),
    ("+", 9),
    ("-", 9),
    ("*", 10),
    ("/", 10),
    ("%", 10),
];

impl Parser<'_> {
    fn binary(&mut self, loosest: u8, operand: Operand) -> Result<i64, Box<Diagnostic>> {
        let mut left = self.unary(operand)?;
        while let Some(token) = self.tokens.get(self.at) {
            let row = OPERATORS.iter().find(|(name, _)| token.is(name));
            let Some(&(operator, binding)) = row.filter(|row| row.1 > loosest) else { break };
            let span = token.span;
            self.at += 1;
            let decided = operator == "||" && left != 0 || operator == "&&" && left == 0;
            let operand = if decided { Operand::ShortCircuited } else { operand };
            let right = self.binary(binding, operand)?;
            if matches!(operator, "/" | "%") && right == 0 {
                if operand == Operand::Evaluated {
                    return Err(Diagnostic::error(span, "division by zero in the condition").into());
                }
                continue;
            }
            left = apply(operator, left, right);
        }
        Ok(left)
    }

    fn unary(&mut self, operand: Operand) -> Result<i64, Box<Diagnostic>> {
        let Some(token) = self.tokens.get(self.at) else {
            return Err(Diagnostic::error(self.end, "the condition is not complete").into());
        };
        self.at += 1;
        self.depth += 1;
        if self.depth > MAX_CONDITION_DEPTH {
            return Err(Diagnostic::error(token.span, "the condition is nested too deeply").into());
        }
        let value = match &token.kind {
            TokenKind::Punct("-") => self.unary(operand)?.wrapping_neg(),
            TokenKind::Punct("+") => self.unary(operand)?,
            TokenKind::Punct("!") => i64::from(self.unary(operand)? == 0),
            TokenKind::Punct("~") => !self.unary(operand)?,
            TokenKind::Punct("(") => {
                let value = self.binary(0, operand)?;
                match self.tokens.get(self.at) {
                    Some(close) if close.is(")") => self.at += 1,
                    _ => return Err(Diagnostic::error(token.span, "`(` is not closed").into()),
                }
                value
            }
            TokenKind::Number(text) => match literal(text) {
                Ok(Literal::Int(value)) => i64::from(value),
                Ok(Literal::Uint(value)) => i64::from(value),
                Ok(Literal::Float(_)) | Err(_) => {
                    let message = format!("{} is not an integer", token.describe());
                    return Err(Diagnostic::error(token.span, message).into());
                }
            },
            TokenKind::Word(name) if operand == Operand::Evaluated => {
                self.undefined(name, token.span)?;
                0
            }
            TokenKind::Word(_) => 0,
            TokenKind::Punct(_) | TokenKind::Stray(_) | TokenKind::Newline | TokenKind::End => {
                let message = format!("unexpected {}", token.describe());
                return Err(Diagnostic::error(token.span, message).into());
            }
        };
        self.depth -= 1;
        Ok(value)
    }
}

impl Parser<'_> {
    /// A name that is no macro. Up to GLSL 1.30 this is an error (section 3.3), from 4.30 on it
    /// counts as 0, as in every desktop compiler; GLSL ES rejects it.
    fn undefined(&mut self, name: &str, span: Span) -> Result<(), Box<Diagnostic>> {
        let help = format!("test it with `defined({name})`");
        if self.version.is_es() {
            return Err(Diagnostic::error(span, format!("`{name}` is not defined"))
                .rule("GLSL ES 1.00 section 3.4: undefined names do not count as 0")
                .help(help)
                .into());
        }
        let message = format!("`{name}` is not defined and counts as 0");
        self.log.push(
            Diagnostic::deviation(self.log.strictness, span, message)
                .rule("GLSL 1.30 section 3.3: other compilers may refuse this")
                .help(help),
        );
        Ok(())
    }
}

fn apply(operator: &str, a: i64, b: i64) -> i64 {
    match operator {
        "||" => i64::from(a != 0 || b != 0),
        "&&" => i64::from(a != 0 && b != 0),
        "|" => a | b,
        "^" => a ^ b,
        "&" => a & b,
        "==" => i64::from(a == b),
        "!=" => i64::from(a != b),
        "<" => i64::from(a < b),
        ">" => i64::from(a > b),
        "<=" => i64::from(a <= b),
        ">=" => i64::from(a >= b),
        "<<" => a.wrapping_shl(b as u32),
        ">>" => a.wrapping_shr(b as u32),
        "+" => a.wrapping_add(b),
        "-" => a.wrapping_sub(b),
        "*" => a.wrapping_mul(b),
        "/" => a.wrapping_div(b),
        _ => a.wrapping_rem(b),
    }
}
