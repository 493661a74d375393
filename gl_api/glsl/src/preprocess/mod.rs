//! The preprocessor (GLSL 1.30 section 3.3): directives, conditionals, macros. Tokens in, the
//! tokens of the program out.

mod condition;
mod controls;
mod directives;
mod expansion;
mod macros;

use crate::language::{ContextLanguage, Language, Version};
use crate::lex::{Token, TokenKind, spliced_tokens, tokens};
use crate::limits;
use crate::text::diagnostics::{Diagnostic, Log};
use crate::text::source::{Source, Span};
use macros::Macros;

/// The result of preprocessing.
#[derive(Debug)]
pub struct Preprocessed {
    /// The program; the last is [`TokenKind::End`].
    pub tokens: Vec<Token>,
    /// What `#version` and `#extension` asked for.
    pub language: Language,
    /// Whether `#pragma STDGL invariant(all)` stands in it.
    pub all_invariant: bool,
}

/// An `#if` that is open.
#[derive(Debug)]
struct Conditional {
    /// Where it began.
    span: Span,
    /// The state of its current group.
    state: GroupState,
    /// Whether it has had its `#else`.
    after_else: bool,
}

/// The state of a conditional's current group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum GroupState {
    /// Its lines are part of the program.
    Taken,
    /// Skipped; a later group may be taken.
    Waiting,
    /// Skipped, like all later groups.
    Done,
}

/// The state of the preprocessor.
struct Preprocessor<'a> {
    source: &'a mut Source,
    log: &'a mut Log,
    /// What the context offers.
    context: ContextLanguage,
    language: Language,
    all_invariant: bool,
    macros: Macros,
    conditionals: Vec<Conditional>,
    /// Whether a token came before.
    begun: bool,
    /// Whether a token outside of directives came before.
    program_begun: bool,
}

/// Preprocesses a source. `#line` is applied to the source, for the positions in later messages.
pub fn preprocess(source: &mut Source, context: ContextLanguage, log: &mut Log) -> Preprocessed {
    let mut lexed = tokens(source.text());
    // A comment may end in a backslash too.
    if source.text().contains('\\') && begins_es_300(&lexed.tokens) {
        lexed = spliced_tokens(source.text());
    }
    if let Some(span) = lexed.unclosed {
        log.push(Diagnostic::error(span, "comment is not closed by `*/`"));
    }
    if let Some(span) = lexed.terminator {
        let message = "the text ends with U+0000, which is no character of the language";
        let problem = Diagnostic::warning(span, message);
        log.push(problem.help("leave it out of the length that glShaderSource is given"));
    }
    let version = context.default_version();
    let language = Language::new(version, context.default_profile(version));
    let mut preprocessor = Preprocessor {
        source,
        log,
        context,
        language,
        all_invariant: false,
        macros: Macros::new(language, context),
        conditionals: Vec::new(),
        begun: false,
        program_begun: false,
    };
    let mut tokens = preprocessor.run(&lexed.tokens);
    let Preprocessor { language, all_invariant, macros, log, .. } = preprocessor;
    if let Some(span) = lexed.continued
        && language.version != Version::Es300
    {
        let message = format!("a line continued by `\\` is not in {}", language.version.title());
        let problem = Diagnostic::deviation(log.strictness, span, message)
            .rule("GLSL 1.30 section 3.1: the backslash is no character of the language");
        log.push(problem.help("write it in one line; other compilers may refuse this"));
    }
    log.work = macros.work;
    let is_over = log.work.is_over();
    log.work.add(lexed.tokens.len().max(tokens.len()));
    if log.work.is_over() && !is_over {
        // The parser gets no more than the end.
        let first_left_out = tokens.get(limits::MAX_WORK as usize).or(tokens.last());
        log.push(Diagnostic::too_much_work(first_left_out.map_or(Span::default(), |t| t.span)));
        tokens.drain(..tokens.len() - 1);
    }
    Preprocessed { tokens, language, all_invariant }
}

/// Whether a shader begins with `#version 300 es`: there lines are joined before they become tokens (GLSL ES 3.00
/// section 3.1).
fn begins_es_300(tokens: &[Token]) -> bool {
    let mut first = tokens.iter().filter(|token| token.kind != TokenKind::Newline);
    let words = ["version", "300", "es"];
    first.next().is_some_and(|hash| hash.is("#"))
        && first.zip(words).take(3).all(|(token, word)| match &token.kind {
            TokenKind::Word(found) | TokenKind::Number(found) => **found == *word,
            TokenKind::Punct(_) | TokenKind::Stray(_) | TokenKind::Newline | TokenKind::End => {
                false
            }
        })
}

impl Preprocessor<'_> {
    fn run(&mut self, all: &[Token]) -> Vec<Token> {
        let mut output = Vec::new();
        // Lines between directives are expanded together: the arguments of a macro may span lines.
        let mut text: Vec<Token> = Vec::new();
        for line in all.split_inclusive(|token| token.kind == TokenKind::Newline) {
            if self.log.is_full() {
                break;
            }
            let line = match line {
                [line @ .., last] if matches!(last.kind, TokenKind::Newline | TokenKind::End) => {
                    line
                }
                line => line,
            };
            match line {
                [] => {}
                [hash, rest @ ..] if hash.is("#") => {
                    self.flush(&mut text, &mut output);
                    self.directive(hash, rest);
                    self.begun = true;
                }
                _ => {
                    self.begun = true;
                    if self.is_active() {
                        self.program_begun = true;
                        text.extend_from_slice(line);
                    }
                }
            }
        }
        self.flush(&mut text, &mut output);
        for conditional in &self.conditionals {
            let message = "conditional is not closed by `#endif`";
            self.log.push(Diagnostic::error(conditional.span, message));
        }
        let end = self.source.text().len() as u32;
        output.push(Token { kind: TokenKind::End, span: Span { start: end, end } });
        output
    }

    fn flush(&mut self, text: &mut Vec<Token>, output: &mut Vec<Token>) {
        match self.macros.expand(std::mem::take(text), self.source, self.language.version, self.log)
        {
            Ok(expanded) => output.extend(expanded),
            Err(problem) => self.log.push(*problem),
        }
    }

    /// Whether lines are part of the program here.
    fn is_active(&self) -> bool {
        self.conditionals.iter().all(|conditional| conditional.state == GroupState::Taken)
    }

    fn error(&mut self, span: Span, message: impl Into<String>) {
        self.log.push(Diagnostic::error(span, message));
    }
}
