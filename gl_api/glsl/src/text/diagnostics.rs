//! Diagnostics, and how an info log shows them.

use crate::limits::{MAX_ERRORS, MAX_WORK};
use crate::text::source::{Source, Span};
use crate::work::Work;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use std::fmt::Write as _;

/// How many bytes of a long line are shown on each side of a span.
const CONTEXT: usize = 100;

/// The severity of a diagnostic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// The shader is rejected.
    Error,
    /// The shader is accepted.
    Warning,
}

/// Whether what a shader's version does not have is accepted, with a warning, where all drivers accept it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Strictness {
    /// It is accepted, and the warning names the version.
    #[default]
    Lenient,
    /// It is an error, as the specification says.
    Strict,
}

/// A replacement of a span of the source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// The span that is replaced.
    pub span: Span,
    /// The new text.
    pub text: String,
}

/// Advice: a fix-it, if it has edits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suggestion {
    /// A sentence that begins with a verb.
    pub text: String,
    /// The edits; empty if the compiler cannot apply it.
    pub edits: Vec<Edit>,
}

/// One error or warning.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Diagnostic {
    /// Its severity.
    pub severity: Severity,
    /// The message.
    pub message: String,
    /// The span; `None` for link errors.
    pub span: Option<Span>,
    /// The label beneath the caret.
    pub label: String,
    /// The rule that is violated, with its section.
    pub rule: Option<String>,
    /// Further notes.
    pub notes: Vec<String>,
    /// Advice.
    pub suggestion: Option<Suggestion>,
}

impl Diagnostic {
    fn new(severity: Severity, span: Option<Span>, message: impl Into<String>) -> Self {
        Self {
            severity,
            message: message.into(),
            span,
            label: String::new(),
            rule: None,
            notes: Vec::new(),
            suggestion: None,
        }
    }

    /// An error at a span.
    pub fn error(span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, Some(span), message)
    }

    /// What the version does not have and all drivers accept: a warning or an error.
    pub fn deviation(strictness: Strictness, span: Span, message: impl Into<String>) -> Self {
        match strictness {
            Strictness::Lenient => Self::warning(span, message),
            Strictness::Strict => Self::error(span, message),
        }
    }

    /// A warning at a span.
    pub fn warning(span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, Some(span), message)
    }

    /// The error where a compilation takes too many steps.
    pub fn too_much_work(span: Span) -> Self {
        Self::error(
            span,
            format!("the shader takes too much work to compile (more than {MAX_WORK} steps)"),
        )
    }

    /// An error of the link.
    pub fn link_error(message: impl Into<String>) -> Self {
        Self::new(Severity::Error, None, message)
    }

    /// A warning of the link.
    pub fn link_warning(message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, None, message)
    }

    /// Adds the label.
    pub fn label(mut self, label: impl Into<String>) -> Self {
        self.label = label.into();
        self
    }

    /// Adds the rule.
    pub fn rule(mut self, rule: impl Into<String>) -> Self {
        self.rule = Some(rule.into());
        self
    }

    /// Adds a note.
    pub fn note(mut self, note: impl Into<String>) -> Self {
        self.notes.push(note.into());
        self
    }

    /// Adds advice.
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.suggestion = Some(Suggestion { text: text.into(), edits: Vec::new() });
        self
    }

    /// Adds a fix-it.
    pub fn fix(mut self, text: impl Into<String>, span: Span, replacement: String) -> Self {
        let edits = vec![Edit { span, text: replacement }];
        self.suggestion = Some(Suggestion { text: text.into(), edits });
        self
    }

    /// Its text in an info log, which ends in a newline.
    pub fn render(&self, source: Option<&Source>) -> String {
        let severity = match self.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        };
        let message = ascii(&self.message);
        let (Some(span), Some(source)) = (self.span, source) else {
            let rule = self.rule.iter().map(|rule| format!(" ({})", ascii(rule)));
            return format!("{severity}: {message}{}\n", rule.collect::<String>());
        };
        let at = source.position(span.start);
        let mut log = format!("{}:{}({}): {severity}: {message}\n", at.string, at.line, at.column);

        let (line, start) = source.line_text(span.start);
        let begin = (span.start - start) as usize;
        let end = ((span.end.max(span.start) - start) as usize).clamp(begin, line.len().max(begin));
        let first = floor_boundary(line, begin.saturating_sub(CONTEXT));
        let last = floor_boundary(line, end.min(begin + CONTEXT) + CONTEXT);
        let excerpt = ascii(&line[first..last]);
        let (begin, end) = (begin - first, (end - first).min(excerpt.len()));
        let begin = begin.min(excerpt.len());
        let snippet =
            Snippet::source(excerpt).line_start(usize::try_from(at.line).unwrap_or(1)).annotation(
                AnnotationKind::Primary
                    .span(begin..end.max(begin))
                    .label((!self.label.is_empty()).then(|| ascii(&self.label))),
            );
        let mut group = Group::with_level(Level::ERROR).element(snippet);
        if let Some(rule) = &self.rule {
            group = group.element(Level::NOTE.with_name("rule").message(ascii(rule)));
        }
        for note in &self.notes {
            group = group.element(Level::NOTE.message(ascii(note)));
        }
        if let Some(suggestion) = &self.suggestion {
            group = group.element(Level::HELP.message(ascii(&suggestion.text)));
        }
        let _ = writeln!(log, "{}", Renderer::plain().render(&[group]));
        log
    }
}

/// The largest character boundary not after `at`.
fn floor_boundary(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// One ASCII byte for each byte, so that offsets stay the same; tabs and control characters become
/// blanks.
fn ascii(text: &str) -> String {
    let show = |byte: u8| match byte {
        b' '..=b'~' => char::from(byte),
        0x80.. => '?',
        0..b' ' | 0x7f => ' ',
    };
    text.bytes().map(show).collect()
}

/// The diagnostics of one compilation or link.
#[derive(Clone, Debug, Default)]
pub struct Log {
    /// In the order found.
    pub items: Vec<Diagnostic>,
    /// How deviations from the version are reported.
    pub strictness: Strictness,
    /// The work so far.
    pub work: Work,
    errors: usize,
}

impl Log {
    /// An empty log.
    pub fn new(strictness: Strictness) -> Self {
        Self { strictness, ..Self::default() }
    }

    /// Adds a diagnostic, unless there are enough or it is a duplicate.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        if self.items.len() >= 2 * MAX_ERRORS || self.is_full() {
            return;
        }
        let same =
            |item: &Diagnostic| item.span == diagnostic.span && item.message == diagnostic.message;
        if self.items.iter().any(same) {
            return;
        }
        if diagnostic.severity == Severity::Error {
            self.errors += 1;
        }
        self.items.push(diagnostic);
    }

    /// Whether there are so many errors that the compiler gives up.
    pub fn is_full(&self) -> bool {
        self.errors >= MAX_ERRORS
    }

    /// Whether there was an error.
    pub fn has_errors(&self) -> bool {
        self.errors > 0
    }

    /// The whole info log.
    pub fn render(&self, source: Option<&Source>) -> String {
        let mut items: Vec<&Diagnostic> = self.items.iter().collect();
        items.sort_by_key(|item| item.span);
        let mut log: String = items.iter().map(|item| item.render(source)).collect();
        if self.is_full() {
            let _ = writeln!(log, "error: too many errors, giving up after {MAX_ERRORS}");
        }
        log
    }
}
