//! Tokens to the syntax tree: recursive descent with bounded depth and error recovery.

mod block;
mod decl;
mod expr;
mod keywords;
mod stmt;

use crate::ast::{Item, Name};
use crate::language::{Language, Version};
use crate::lex::{Token, TokenKind};
use crate::limits::MAX_NESTING;
use crate::text::diagnostics::{Diagnostic, Log};
use crate::text::source::Span;
use crate::text::spelling::closest;
use keywords::WordClass;

/// An error that has been reported: the caller unwinds to where parsing can go on.
#[derive(Clone, Copy, Debug)]
struct SyntaxError;

type ParseResult<T> = Result<T, SyntaxError>;

/// The state of the parser.
struct Parser<'a> {
    tokens: &'a [Token],
    at: usize,
    language: Language,
    version: Version,
    log: &'a mut Log,
    depth: u32,
    /// Whether parsing stops at this error: nesting is too deep.
    aborted: bool,
}

/// Parses a shader; errors are in the log.
pub fn parse(tokens: &[Token], language: Language, log: &mut Log) -> Vec<Item> {
    let version = language.version;
    let mut parser = Parser { tokens, at: 0, language, version, log, depth: 0, aborted: false };
    let mut items = Vec::new();
    // An error of the preprocessor ends the text.
    if version.is_es() && parser.kind() == &TokenKind::End && !parser.log.has_errors() {
        let problem = Diagnostic::error(parser.span(), "the shader declares nothing");
        let rule = format!("{} chapter 9, `translation_unit`", version.title());
        parser.log.push(problem.rule(rule).help("write at least `void main() {}`"));
    }
    while parser.kind() != &TokenKind::End && !parser.log.is_full() && !parser.aborted {
        let start = parser.at;
        match parser.item() {
            Ok(Some(item)) => items.push(item),
            Ok(None) => {}
            Err(SyntaxError) => parser.skip_item(start),
        }
    }
    items
}

impl<'a> Parser<'a> {
    fn token(&self) -> &'a Token {
        &self.tokens[self.at.min(self.tokens.len() - 1)]
    }

    fn ahead(&self, distance: usize) -> &'a Token {
        &self.tokens[(self.at + distance).min(self.tokens.len() - 1)]
    }

    fn kind(&self) -> &'a TokenKind {
        &self.token().kind
    }

    fn span(&self) -> Span {
        self.token().span
    }

    /// The span of the token before.
    fn last_span(&self) -> Span {
        self.tokens[self.at.saturating_sub(1).min(self.tokens.len() - 1)].span
    }

    fn bump(&mut self) -> &'a Token {
        let token = self.token();
        if token.kind != TokenKind::End {
            self.at += 1;
        }
        token
    }

    fn is(&self, punct: &str) -> bool {
        self.token().is(punct)
    }

    fn eat(&mut self, punct: &str) -> bool {
        let found = self.is(punct);
        if found {
            self.bump();
        }
        found
    }

    fn is_word(&self, word: &str) -> bool {
        self.token().word().is_some_and(|found| &**found == word)
    }

    fn eat_word(&mut self, word: &str) -> bool {
        let found = self.is_word(word);
        if found {
            self.bump();
        }
        found
    }

    /// Consumes a token that must be there. A missing `;` is reported where it should stand.
    fn expect(&mut self, punct: &str) -> ParseResult<()> {
        if self.eat(punct) {
            return Ok(());
        }
        let message = format!("expected `{punct}`, found {}", self.token().describe());
        let mut problem = Diagnostic::error(self.span(), message);
        if punct == ";" && self.at > 0 {
            let end = self.last_span().end;
            problem = problem.fix("add `;` before it", Span { start: end, end }, ";".to_owned());
        }
        self.log.push(problem);
        Err(SyntaxError)
    }

    fn fail<T>(&mut self, message: impl Into<String>) -> ParseResult<T> {
        self.log.push(Diagnostic::error(self.span(), message));
        Err(SyntaxError)
    }

    /// A name that is no keyword.
    fn name(&mut self) -> ParseResult<Name> {
        let token = self.token();
        let Some(word) = token.word() else {
            return self.fail(format!("expected a name, found {}", token.describe()));
        };
        match keywords::classify(word, self.language) {
            WordClass::Name => {
                self.bump();
                Ok(Name { text: word.clone(), span: token.span })
            }
            WordClass::Keyword | WordClass::Type => {
                let message = format!("`{word}` is a keyword and cannot be a name");
                self.log.push(
                    Diagnostic::error(token.span, message)
                        .rule(format!("{} section 3.6", self.version.title())),
                );
                Err(SyntaxError)
            }
            WordClass::Reserved => {
                let message = format!("`{word}` is reserved for later versions");
                self.log.push(
                    Diagnostic::error(token.span, message)
                        .rule(format!("{} section 3.6", self.version.title())),
                );
                Err(SyntaxError)
            }
        }
    }

    /// Runs `parse` one level deeper, or reports that the nesting is too deep.
    fn nested<T>(&mut self, parse: impl FnOnce(&mut Self) -> ParseResult<T>) -> ParseResult<T> {
        if self.depth >= MAX_NESTING {
            return self.too_deep();
        }
        self.depth += 1;
        let result = parse(self);
        self.depth -= 1;
        result
    }

    fn too_deep<T>(&mut self) -> ParseResult<T> {
        if !self.aborted {
            self.aborted = true;
            let message = format!("nested more than {MAX_NESTING} levels deep");
            self.log.push(Diagnostic::error(self.span(), message));
        }
        Err(SyntaxError)
    }

    /// Error recovery: skips past the `;` or the balanced `}` that ends the statement, or up to the
    /// `}` that closes the block around it.
    fn skip_statement(&mut self) {
        let mut depth = 0usize;
        loop {
            match self.kind() {
                TokenKind::End => return,
                TokenKind::Punct(";") if depth == 0 => {
                    self.bump();
                    return;
                }
                TokenKind::Punct("{") => depth += 1,
                TokenKind::Punct("}") if depth == 0 => return,
                TokenKind::Punct("}") => {
                    depth -= 1;
                    if depth == 0 {
                        self.bump();
                        return;
                    }
                }
                TokenKind::Word(_)
                | TokenKind::Number(_)
                | TokenKind::Punct(_)
                | TokenKind::Stray(_)
                | TokenKind::Newline => {}
            }
            self.bump();
        }
    }

    /// As [`Parser::skip_statement`], outside of functions.
    fn skip_item(&mut self, start: usize) {
        self.skip_statement();
        if self.is("}") || self.at == start {
            self.bump();
        }
    }

    /// The keyword that a misspelt word is closest to.
    fn near_keyword(&self, word: &str) -> Option<&'static str> {
        closest(word, keywords::known(self.language))
    }
}
