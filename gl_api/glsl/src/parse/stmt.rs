//! Statements (GLSL 1.30 chapter 6).

use super::keywords::{self, WordClass};
use super::{ParseResult, Parser, SyntaxError};
use crate::ast::{Condition, Expr, QualifiedType, Stmt, StmtKind};
use crate::language::Version;
use crate::lex::TokenKind;
use crate::text::diagnostics::Diagnostic;

impl Parser<'_> {
    /// `{ ... }`; a statement with a syntax error is reported and left out.
    pub(super) fn block(&mut self) -> ParseResult<Vec<Stmt>> {
        let open = self.span();
        self.expect("{")?;
        let mut statements = Vec::new();
        while !self.is("}") {
            if self.kind() == &TokenKind::End || self.aborted || self.log.is_full() {
                if !self.aborted && !self.log.is_full() {
                    let message = "this `{` is not closed by `}`";
                    self.log.push(Diagnostic::error(open, message));
                }
                return Err(SyntaxError);
            }
            match self.statement() {
                Ok(statement) => statements.push(statement),
                Err(SyntaxError) => self.skip_statement(),
            }
        }
        self.expect("}")?;
        Ok(statements)
    }

    fn statement(&mut self) -> ParseResult<Stmt> {
        let start = self.span();
        let kind = self.nested(Self::statement_kind)?;
        Ok(Stmt { span: start.to(self.last_span()), kind })
    }

    fn statement_kind(&mut self) -> ParseResult<StmtKind> {
        if self.is("{") {
            return self.block().map(StmtKind::Block);
        }
        if self.eat(";") {
            return Ok(StmtKind::Empty);
        }
        let word = self.token().word().map_or("", |word| word);
        match word {
            "if" => self.if_statement(),
            "for" => self.for_statement(),
            "while" => {
                self.bump();
                self.expect("(")?;
                let condition = self.condition()?;
                self.expect(")")?;
                Ok(StmtKind::While(condition, Box::new(self.statement()?)))
            }
            "do" => {
                self.bump();
                let body = Box::new(self.statement()?);
                if !self.eat_word("while") {
                    return self.fail("expected `while` after the body of `do`");
                }
                self.expect("(")?;
                let condition = self.expression()?;
                self.expect(")")?;
                self.expect(";")?;
                Ok(StmtKind::DoWhile(body, condition))
            }
            "switch" if self.version >= Version::V130 => {
                self.bump();
                self.expect("(")?;
                let selector = self.expression()?;
                self.expect(")")?;
                Ok(StmtKind::Switch(selector, self.block()?))
            }
            "case" if self.version >= Version::V130 => {
                self.bump();
                let label = self.expression()?;
                self.expect(":")?;
                Ok(StmtKind::Case(label))
            }
            "default" if self.version >= Version::V130 => {
                self.bump();
                self.expect(":")?;
                Ok(StmtKind::Default)
            }
            "return" => {
                self.bump();
                let value = if self.is(";") { None } else { Some(self.expression()?) };
                self.expect(";")?;
                Ok(StmtKind::Return(value))
            }
            "break" => self.jump(StmtKind::Break),
            "continue" => self.jump(StmtKind::Continue),
            "discard" => self.jump(StmtKind::Discard),
            "else" => self.fail("`else` without `if`"),
            _ => self.simple(),
        }
    }

    fn jump(&mut self, kind: StmtKind) -> ParseResult<StmtKind> {
        self.bump();
        self.expect(";")?;
        Ok(kind)
    }

    fn if_statement(&mut self) -> ParseResult<StmtKind> {
        self.bump();
        self.expect("(")?;
        let condition = self.expression()?;
        self.expect(")")?;
        let accept = Box::new(self.statement()?);
        let reject = if self.eat_word("else") { Some(Box::new(self.statement()?)) } else { None };
        Ok(StmtKind::If(condition, accept, reject))
    }

    fn for_statement(&mut self) -> ParseResult<StmtKind> {
        self.bump();
        self.expect("(")?;
        let start = self.span();
        let init = if self.eat(";") {
            None
        } else {
            let kind = self.simple()?;
            Some(Box::new(Stmt { span: start.to(self.last_span()), kind }))
        };
        let condition = if self.is(";") { None } else { Some(self.condition()?) };
        self.expect(";")?;
        let step = if self.is(")") { None } else { Some(self.expression()?) };
        self.expect(")")?;
        Ok(StmtKind::For(init, condition, step, Box::new(self.statement()?)))
    }

    fn condition(&mut self) -> ParseResult<Condition> {
        if self.is_declaration() {
            let ty = self.qualified_type()?;
            return Ok(Condition::Declaration(Box::new(self.declarators(ty)?)));
        }
        self.expression().map(Condition::Expr)
    }

    /// A declaration or an expression, with its `;`.
    fn simple(&mut self) -> ParseResult<StmtKind> {
        let kind = if self.is_word("precision") && keywords::has_precision(self.language) {
            return self
                .default_precision()
                .map(|(precision, ty)| StmtKind::Precision(precision, ty));
        } else if self.is_declaration() {
            let ty = self.qualified_type()?;
            if self.token().word().is_some() && self.ahead(1).is("(") {
                return self.prototype(ty);
            }
            StmtKind::Declaration(self.declarators(ty)?)
        } else {
            let expr: Expr = self.expression()?;
            StmtKind::Expr(expr)
        };
        self.expect(";")?;
        Ok(kind)
    }

    /// A prototype among statements, which GLSL 1.10 alone has.
    fn prototype(&mut self, ty: QualifiedType) -> ParseResult<StmtKind> {
        if self.version != Version::V110 {
            return self.fail("a function cannot be declared inside another");
        }
        let function = self.function(ty)?;
        if function.body.is_some() {
            let message = "a function cannot be defined inside another";
            self.log.push(Diagnostic::error(function.name.span, message));
            return Ok(StmtKind::Empty);
        }
        Ok(StmtKind::Prototype(function))
    }

    /// Whether a declaration begins here: a qualifier, or a type without a `(` after it.
    fn is_declaration(&self) -> bool {
        let Some(word) = self.token().word() else { return false };
        if &**word == "struct" || keywords::qualifier(word, self.language).is_some() {
            return true;
        }
        if &**word == "unsigned" && keywords::has_unsigned_int(self.language) {
            return true;
        }
        match keywords::classify(word, self.language) {
            WordClass::Type => !self.after_brackets().is("("),
            WordClass::Name => self.after_brackets().word().is_some(),
            WordClass::Keyword | WordClass::Reserved => false,
        }
    }

    /// The token after this word and the `[...]` that may follow it.
    fn after_brackets(&self) -> &crate::lex::Token {
        let mut distance = 1;
        let mut depth = 0usize;
        loop {
            let token = self.ahead(distance);
            if token.is("[") {
                depth += 1;
            } else if token.is("]") && depth > 0 {
                depth -= 1;
            } else if depth == 0
                || matches!(token.kind, TokenKind::End | TokenKind::Punct(";" | "{" | "}"))
            {
                return token;
            }
            distance += 1;
        }
    }
}
