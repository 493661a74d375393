//! Expressions (GLSL 1.30 chapter 5).

use super::keywords::{self, WordClass};
use super::{ParseResult, Parser};
use crate::ast::{
    ArraySize, BINARY, BinaryOp, Expr, ExprKind, IncDec, IncDecResult, Name, TypeBase, TypeName,
    UnaryOp,
};
use crate::language::Version;
use crate::lex::{Literal, TokenKind, literal};
use crate::limits::MAX_TREE;
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;

/// The assignment operators.
const ASSIGNMENTS: [(&str, Option<BinaryOp>); 11] = [
    ("=", None),
    ("+=", Some(BinaryOp::Add)),
    ("-=", Some(BinaryOp::Sub)),
    ("*=", Some(BinaryOp::Mul)),
    ("/=", Some(BinaryOp::Div)),
    ("%=", Some(BinaryOp::Rem)),
    ("<<=", Some(BinaryOp::ShiftLeft)),
    (">>=", Some(BinaryOp::ShiftRight)),
    ("&=", Some(BinaryOp::BitAnd)),
    ("|=", Some(BinaryOp::BitOr)),
    ("^=", Some(BinaryOp::BitXor)),
];

impl Parser<'_> {
    /// A node above `children`, unless the tree gets too deep.
    fn node(&mut self, span: Span, children: &[&Expr], kind: ExprKind) -> ParseResult<Expr> {
        let depth = 1 + children.iter().map(|child| child.depth).max().unwrap_or(0);
        self.node_at(span, depth, kind)
    }

    fn node_at(&mut self, span: Span, depth: u32, kind: ExprKind) -> ParseResult<Expr> {
        if depth > MAX_TREE {
            if !self.aborted {
                self.aborted = true;
                let message = format!("expression with more than {MAX_TREE} operations in a row");
                self.log.push(
                    Diagnostic::error(span, message).help("split it into several statements"),
                );
            }
            return Err(super::SyntaxError);
        }
        Ok(Expr { span, depth, kind })
    }

    /// An expression, commas included.
    pub(super) fn expression(&mut self) -> ParseResult<Expr> {
        let first = self.assignment()?;
        if !self.is(",") {
            return Ok(first);
        }
        let mut all = vec![first];
        while self.eat(",") {
            all.push(self.assignment()?);
        }
        let span = all[0].span.to(self.last_span());
        let depth = 1 + all.iter().map(|expr| expr.depth).max().unwrap_or(0);
        self.node_at(span, depth, ExprKind::Comma(all))
    }

    /// An assignment or conditional expression.
    pub(super) fn assignment(&mut self) -> ParseResult<Expr> {
        self.nested(|parser| {
            let target = parser.conditional()?;
            let row = ASSIGNMENTS.iter().find(|row| parser.is(row.0));
            let Some(&(_, operator)) = row else { return Ok(target) };
            parser.bump();
            let value = parser.assignment()?;
            let span = target.span.to(value.span);
            let depth = 1 + target.depth.max(value.depth);
            let kind = ExprKind::Assign(operator, Box::new(target), Box::new(value));
            parser.node_at(span, depth, kind)
        })
    }

    /// `a ? b : c`, or a binary expression.
    pub(super) fn conditional(&mut self) -> ParseResult<Expr> {
        let condition = self.binary(0)?;
        if !self.eat("?") {
            return Ok(condition);
        }
        self.nested(|parser| {
            let accept = parser.expression()?;
            parser.expect(":")?;
            let reject = parser.assignment()?;
            let span = condition.span.to(reject.span);
            let depth = 1 + condition.depth.max(accept.depth).max(reject.depth);
            let kind = ExprKind::Conditional(Box::new([condition, accept, reject]));
            parser.node_at(span, depth, kind)
        })
    }

    fn binary(&mut self, loosest: u8) -> ParseResult<Expr> {
        let mut left = self.unary()?;
        while let TokenKind::Punct(punct) = self.kind() {
            let row = BINARY.iter().find(|row| row.0 == *punct);
            let Some(&(_, operator, binding)) = row.filter(|row| row.2 > loosest) else { break };
            self.bump();
            let right = self.binary(binding)?;
            let span = left.span.to(right.span);
            let depth = 1 + left.depth.max(right.depth);
            let kind = ExprKind::Binary(operator, Box::new(left), Box::new(right));
            left = self.node_at(span, depth, kind)?;
        }
        Ok(left)
    }

    fn unary(&mut self) -> ParseResult<Expr> {
        let start = self.span();
        let TokenKind::Punct(punct) = self.kind() else { return self.postfix() };
        let operator = match *punct {
            "+" => Some(UnaryOp::Plus),
            "-" => Some(UnaryOp::Negate),
            "!" => Some(UnaryOp::Not),
            "~" => Some(UnaryOp::BitNot),
            _ => None,
        };
        let step = match *punct {
            "++" => Some(IncDec::Increment),
            "--" => Some(IncDec::Decrement),
            _ => None,
        };
        if operator.is_none() && step.is_none() {
            return self.postfix();
        }
        self.bump();
        let operand = self.nested(Self::unary)?;
        let span = start.to(operand.span);
        let depth = operand.depth + 1;
        let operand = Box::new(operand);
        let kind = match (operator, step) {
            (Some(operator), _) => ExprKind::Unary(operator, operand),
            (None, Some(step)) => ExprKind::IncDec(step, IncDecResult::After, operand),
            (None, None) => ExprKind::Error,
        };
        self.node_at(span, depth, kind)
    }

    fn postfix(&mut self) -> ParseResult<Expr> {
        let mut expr = self.primary()?;
        loop {
            let start = expr.span;
            if self.is("[") {
                expr = self.brackets(expr)?;
            } else if self.eat(".") {
                let token = self.token();
                let Some(word) = token.word().cloned() else {
                    let found = token.describe();
                    return self.fail(format!("expected a member or a swizzle, found {found}"));
                };
                self.bump();
                let name = Name { text: word, span: token.span };
                let span = start.to(token.span);
                let depth = expr.depth + 1;
                let kind = if self.is("(") && self.ahead(1).is(")") {
                    self.bump();
                    self.bump();
                    ExprKind::Method(Box::new(expr), name)
                } else {
                    ExprKind::Field(Box::new(expr), name)
                };
                expr = self.node_at(span, depth, kind)?;
            } else if self.is("++") || self.is("--") {
                let step = if self.is("++") { IncDec::Increment } else { IncDec::Decrement };
                let span = start.to(self.bump().span);
                let depth = expr.depth + 1;
                let kind = ExprKind::IncDec(step, IncDecResult::Before, Box::new(expr));
                expr = self.node_at(span, depth, kind)?;
            } else {
                return Ok(expr);
            }
        }
    }

    /// `a[b][c]`, or `Structure[n][m](...)`.
    fn brackets(&mut self, base: Expr) -> ParseResult<Expr> {
        let mut array = Vec::new();
        while self.is("[") {
            let open = self.bump().span;
            let size = if self.is("]") { None } else { Some(Box::new(self.expression()?)) };
            self.expect("]")?;
            array.push(ArraySize { span: open.to(self.last_span()), size });
        }
        if self.is("(")
            && let ExprKind::Name(name) = &base.kind
        {
            if let [_, second, ..] = &array[..] {
                self.has_arrays_of_arrays(second.span)?;
            }
            let base_ty = TypeBase::Named(name.clone());
            return self.construct(TypeName { span: base.span, base: base_ty, array });
        }
        let mut expr = base;
        for ArraySize { span, size } in array {
            let Some(index) = size else {
                self.log.push(Diagnostic::error(span, "an index is missing"));
                return Err(super::SyntaxError);
            };
            let span = expr.span.to(span);
            let depth = 1 + expr.depth.max(index.depth);
            expr = self.node_at(span, depth, ExprKind::Index(Box::new(expr), index))?;
        }
        Ok(expr)
    }

    fn construct(&mut self, ty: TypeName) -> ParseResult<Expr> {
        let arguments = self.arguments()?;
        let span = ty.span.to(self.last_span());
        let depth = 1 + arguments.iter().map(|expr| expr.depth).max().unwrap_or(0);
        self.node_at(span, depth, ExprKind::Construct(ty, arguments))
    }

    /// The value of a declaration: an expression or a list (ARB_shading_language_420pack).
    pub(super) fn initializer(&mut self) -> ParseResult<Expr> {
        if !self.is("{") || !keywords::is_relaxed(self.language) {
            return self.assignment();
        }
        self.nested(Self::list)
    }

    fn list(&mut self) -> ParseResult<Expr> {
        let start = self.span();
        self.bump();
        let mut items = Vec::new();
        while !self.is("}") {
            items.push(self.initializer()?);
            if !self.eat(",") {
                break;
            }
        }
        self.expect("}")?;
        let depth = 1 + items.iter().map(|item| item.depth).max().unwrap_or(0);
        self.node_at(start.to(self.last_span()), depth, ExprKind::List(items))
    }

    /// `(a, b, ...)`.
    fn arguments(&mut self) -> ParseResult<Vec<Expr>> {
        self.expect("(")?;
        let mut arguments = Vec::new();
        if self.is_word("void") && self.ahead(1).is(")") {
            self.bump();
        }
        while !self.is(")") {
            if !arguments.is_empty() && !self.eat(",") {
                let found = self.token().describe();
                return self.fail(format!("expected `,` or `)` after the argument, found {found}"));
            }
            arguments.push(self.assignment()?);
        }
        self.expect(")")?;
        Ok(arguments)
    }

    fn primary(&mut self) -> ParseResult<Expr> {
        let token = self.token();
        let span = token.span;
        match &token.kind {
            TokenKind::Number(text) => {
                let text = text.clone();
                self.bump();
                let kind = self.number(&text, span);
                self.node(span, &[], kind)
            }
            TokenKind::Punct("(") => {
                self.bump();
                let inner = self.expression()?;
                self.expect(")")?;
                let span = span.to(self.last_span());
                Ok(Expr { span, ..inner })
            }
            TokenKind::Word(word) => match keywords::classify(word, self.language) {
                WordClass::Type => {
                    let ty = self.type_name()?;
                    if !self.is("(") {
                        return self.fail(format!("expected `(` after the type `{word}`"));
                    }
                    self.construct(ty)
                }
                WordClass::Name => {
                    self.bump();
                    let name = Name { text: word.clone(), span };
                    if !self.is("(") {
                        return self.node(span, &[], ExprKind::Name(word.clone()));
                    }
                    let arguments = self.arguments()?;
                    let span = span.to(self.last_span());
                    let depth = 1 + arguments.iter().map(|expr| expr.depth).max().unwrap_or(0);
                    self.node_at(span, depth, ExprKind::Call(name, arguments))
                }
                WordClass::Keyword if &**word == "true" || &**word == "false" => {
                    self.bump();
                    self.node(span, &[], ExprKind::Bool(&**word == "true"))
                }
                WordClass::Keyword => self.fail(format!("expected an expression, found `{word}`")),
                WordClass::Reserved
                    if &**word == "unsigned" && keywords::has_unsigned_int(self.language) =>
                {
                    let ty = self.type_name()?;
                    self.construct(ty)
                }
                WordClass::Reserved => {
                    self.fail(format!("`{word}` is reserved for later versions"))
                }
            },
            TokenKind::Punct(_) | TokenKind::Stray(_) | TokenKind::Newline | TokenKind::End => {
                self.fail(format!("expected an expression, found {}", token.describe()))
            }
        }
    }

    pub(super) fn number(&mut self, text: &str, span: Span) -> ExprKind {
        let suffix = text.ends_with(['f', 'F']) && !text.starts_with("0x");
        match literal(text) {
            Ok(Literal::Int(value)) => ExprKind::Int(value),
            Ok(Literal::Uint(_)) if !keywords::has_unsigned(self.language) => {
                let message = "unsigned numbers are not in this version";
                let problem = Diagnostic::error(span, message).help("write `#version 130` first");
                self.log.push(problem);
                ExprKind::Error
            }
            Ok(Literal::Float(value)) if suffix && self.version < Version::V120 => {
                let message = format!("the suffix `f` is not in {}", self.version.title());
                let plain = text.trim_end_matches(['f', 'F']).to_owned();
                let problem = match self.version {
                    // Every desktop compiler accepts it.
                    Version::V110 => Diagnostic::deviation(self.log.strictness, span, message),
                    Version::Es100
                    | Version::V120
                    | Version::V130
                    | Version::V140
                    | Version::V150
                    | Version::V330
                    | Version::Es300 => Diagnostic::error(span, message),
                };
                self.log.push(problem.fix(format!("write `{plain}`"), span, plain));
                ExprKind::Float(value)
            }
            Ok(Literal::Uint(value)) => ExprKind::Uint(value),
            Ok(Literal::Float(value)) => ExprKind::Float(value),
            Err(problem) => {
                let short: String = text.chars().take(40).collect();
                self.log.push(Diagnostic::error(span, format!("`{short}` is {problem}")));
                ExprKind::Error
            }
        }
    }
}
