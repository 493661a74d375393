//! Macro expansion (GLSL 1.30 section 3.3).

use super::macros::Macros;
use crate::language::Version;
use crate::lex::{Token, TokenKind};
use crate::limits::{MAX_EXPANDED_TOKENS, MAX_MACRO_DEPTH};
use crate::text::diagnostics::{Diagnostic, Log, Severity};
use crate::text::source::{Source, Span};
use crate::work::Work;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// A token during the expansion, or the end of a macro's expansion.
enum ExpansionItem {
    Token(Token),
    /// The name of a macro inside its own expansion: never expanded again.
    Painted(Token),
    /// The expansion of this macro ends here.
    EndOf(Arc<str>),
}

/// The context of an expansion.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum ExpansionContext {
    /// The program, or the numbers of `#line`.
    Text,
    /// The condition of `#if` or `#elif`.
    Condition,
}

/// The state of one expansion.
struct Expansion<'a> {
    macros: &'a Macros,
    context: ExpansionContext,
    source: &'a Source,
    version: Version,
    /// The macros that are being expanded.
    active: BTreeSet<Arc<str>>,
    /// By the begin of a macro call: its closing parenthesis.
    ends: BTreeMap<u32, u32>,
    spent: &'a mut Spent,
    log: &'a mut Log,
}

/// What the expansions of a shader have cost so far.
pub struct Spent {
    /// The tokens that macros were replaced by.
    pub produced: usize,
    /// The work.
    pub work: Work,
}

/// Expands every macro in `tokens`. `spent` is that of all expansions of the shader.
pub fn expand(
    macros: &Macros,
    context: ExpansionContext,
    tokens: Vec<Token>,
    source: &Source,
    version: Version,
    spent: &mut Spent,
    log: &mut Log,
) -> Result<Vec<Token>, Box<Diagnostic>> {
    let (active, ends) = (BTreeSet::new(), BTreeMap::new());
    let mut expansion = Expansion { macros, context, source, version, active, ends, spent, log };
    let items = tokens.into_iter().map(ExpansionItem::Token).collect();
    let result = expansion.run(items, None, 0)?;
    let plain = |item| match item {
        ExpansionItem::Token(token) | ExpansionItem::Painted(token) => Some(token),
        ExpansionItem::EndOf(_) => None,
    };
    Ok(result.into_iter().filter_map(plain).collect())
}

impl Expansion<'_> {
    /// Expands tokens. `call` is the span of the outermost macro call, which the result gets.
    fn run(
        &mut self,
        items: Vec<ExpansionItem>,
        call: Option<Span>,
        depth: usize,
    ) -> Result<Vec<ExpansionItem>, Box<Diagnostic>> {
        let mut work: Vec<ExpansionItem> = items.into_iter().rev().collect();
        let mut output = Vec::new();
        while let Some(item) = work.pop() {
            let token = match item {
                ExpansionItem::Token(token) => token,
                ExpansionItem::Painted(token) => {
                    output.push(ExpansionItem::Painted(token));
                    continue;
                }
                ExpansionItem::EndOf(name) => {
                    self.active.remove(&name);
                    continue;
                }
            };
            let at = call.unwrap_or(token.span);
            let Some(name) = token.word().cloned() else {
                output.push(ExpansionItem::Token(token));
                continue;
            };
            if let Some(number) = self.predefined(&name, at) {
                let kind = TokenKind::Number(number.to_string().into());
                output.push(ExpansionItem::Token(Token { kind, span: at }));
                continue;
            }
            if self.context == ExpansionContext::Condition && &*name == "defined" {
                output.push(ExpansionItem::Token(self.defined(&mut work, &token)?));
                continue;
            }
            let Some(found) = self.macros.get(&name) else {
                output.push(ExpansionItem::Token(token));
                continue;
            };
            if self.active.contains(&name) {
                output.push(ExpansionItem::Painted(token));
                continue;
            }
            let body = match &found.parameters {
                None => self.paste(&found.body, &[], &[], &[], token.span)?,
                Some(parameters) => {
                    let next =
                        work.iter().rev().find(|item| !matches!(item, ExpansionItem::EndOf(_)));
                    if !matches!(next, Some(ExpansionItem::Token(next)) if next.is("(")) {
                        output.push(ExpansionItem::Token(token));
                        continue;
                    }
                    if depth >= MAX_MACRO_DEPTH {
                        let message = "macro calls are nested too deeply";
                        return Err(Diagnostic::error(token.span, message).into());
                    }
                    let raw = self.arguments(&mut work, &token)?;
                    let count = if raw.len() == 1 && raw[0].is_empty() && parameters.is_empty() {
                        0
                    } else {
                        raw.len()
                    };
                    if count != parameters.len() {
                        let message = format!(
                            "macro `{name}` takes {} argument(s), not {count}",
                            parameters.len()
                        );
                        return Err(Diagnostic::error(token.span, message).into());
                    }
                    let mut arguments = Vec::new();
                    for argument in &raw {
                        let items = argument.iter().cloned().map(ExpansionItem::Token).collect();
                        self.spent.work.add(self.active.len());
                        let active = self.active.clone();
                        arguments.push(self.run(items, None, depth + 1)?);
                        self.active = active;
                    }
                    self.paste(&found.body, parameters, &raw, &arguments, token.span)?
                }
            };
            self.spent.produced += body.len() + 1;
            if self.spent.produced > MAX_EXPANDED_TOKENS {
                return Err(too_many_tokens(token.span));
            }
            if self.spent.work.is_over() {
                return Err(Diagnostic::too_much_work(token.span).into());
            }
            self.active.insert(name.clone());
            work.push(ExpansionItem::EndOf(name));
            work.extend(body.into_iter().rev());
        }
        Ok(output)
    }

    /// The value of `__LINE__` and the like; in the body of a macro with arguments, that of the line where the call
    /// ends, as in C.
    fn predefined(&self, name: &str, at: Span) -> Option<i64> {
        let place = || self.source.line_of(*self.ends.get(&at.start).unwrap_or(&at.start));
        match name {
            "__LINE__" => Some(place().1),
            "__FILE__" => Some(place().0),
            "__VERSION__" => Some(i64::from(self.version.number())),
            _ => None,
        }
    }

    /// Consumes the operand of `defined`, with its parentheses, if it has some.
    fn defined(
        &mut self,
        work: &mut Vec<ExpansionItem>,
        operator: &Token,
    ) -> Result<Token, Box<Diagnostic>> {
        let mut next = || loop {
            match work.pop() {
                Some(ExpansionItem::Token(token) | ExpansionItem::Painted(token)) => {
                    return Some(token);
                }
                Some(ExpansionItem::EndOf(name)) => drop(self.active.remove(&name)),
                None => return None,
            }
        };
        let (open, name) = match next() {
            Some(open) if open.is("(") => (Some(open), next()),
            name => (None, name),
        };
        if let Some(open) = open
            && !next().is_some_and(|close| close.is(")"))
        {
            let problem = Diagnostic::error(open.span, "`defined(` takes one name and a `)`");
            return Err(problem.rule("GLSL 1.30 section 3.3").into());
        }
        match name.as_ref().map(|name| (name.word(), name.span)) {
            Some((Some(word), _)) => {
                let value = if self.macros.is_defined(word) { "1" } else { "0" };
                Ok(Token { kind: TokenKind::Number(value.into()), span: operator.span })
            }
            other => {
                let at = other.map_or(operator.span, |(_, span)| span);
                Err(Diagnostic::error(at, "`defined` needs a name").into())
            }
        }
    }

    /// Consumes the arguments of a call, with both parentheses.
    fn arguments(
        &mut self,
        work: &mut Vec<ExpansionItem>,
        name: &Token,
    ) -> Result<Vec<Vec<Token>>, Box<Diagnostic>> {
        let mut arguments = vec![Vec::new()];
        let mut depth = 0usize;
        while let Some(item) = work.pop() {
            let token = match item {
                ExpansionItem::Token(token) | ExpansionItem::Painted(token) => token,
                ExpansionItem::EndOf(name) => {
                    self.active.remove(&name);
                    continue;
                }
            };
            if token.is("(") {
                depth += 1;
                if depth == 1 {
                    continue;
                }
            } else if token.is(")") {
                depth -= 1;
                if depth == 0 {
                    let end = self.ends.entry(name.span.start).or_default();
                    *end = token.span.start.max(*end);
                    return Ok(arguments);
                }
            } else if token.is(",") && depth == 1 {
                arguments.push(Vec::new());
                continue;
            }
            if let Some(last) = arguments.last_mut() {
                last.push(token);
            }
        }
        let message = format!("the call of macro {} is not closed by `)`", name.describe());
        Err(Diagnostic::error(name.span, message).into())
    }

    /// The body with arguments in place of parameters and `##` applied (GLSL 1.30 section 3.3).
    /// Operands of `##` are the arguments as written; elsewhere they are `expanded`.
    fn paste(
        &mut self,
        body: &[Token],
        parameters: &[Arc<str>],
        written: &[Vec<Token>],
        expanded: &[Vec<ExpansionItem>],
        at: Span,
    ) -> Result<Vec<ExpansionItem>, Box<Diagnostic>> {
        self.spent.work.add(body.len() * (parameters.len() / 4 + 1));
        let mut output: Vec<ExpansionItem> = Vec::new();
        let mut joining = false;
        // Whether the left operand of `##` gave a token: an empty argument gives none.
        let mut before = false;
        for (index, token) in body.iter().enumerate() {
            if token.is("##") {
                if index == 0 || index + 1 == body.len() {
                    return Err(nothing_to_join(token));
                }
                self.check_version(token)?;
                joining = true;
                continue;
            }
            let parameter = token.word().and_then(|w| parameters.iter().position(|p| p == w));
            let joined = joining || body.get(index + 1).is_some_and(|next| next.is("##"));
            let start = output.len();
            match parameter {
                Some(index) if joined => {
                    output.extend(written[index].iter().cloned().map(ExpansionItem::Token));
                }
                Some(index) => {
                    for item in &expanded[index] {
                        match item {
                            ExpansionItem::Token(t) => output.push(ExpansionItem::Token(t.clone())),
                            ExpansionItem::Painted(t) => {
                                output.push(ExpansionItem::Painted(t.clone()))
                            }
                            ExpansionItem::EndOf(_) => {}
                        }
                    }
                }
                None => {
                    output.push(ExpansionItem::Token(Token { kind: token.kind.clone(), span: at }))
                }
            }
            if self.spent.produced + output.len() > MAX_EXPANDED_TOKENS {
                return Err(too_many_tokens(at));
            }
            let given = start < output.len();
            if joining && before && given {
                join(&mut output, start, at)?;
            }
            before = given || joining && before;
            joining = false;
        }
        Ok(output)
    }
}

impl Expansion<'_> {
    /// Reports a `##` before GLSL 1.30. Every desktop compiler accepts it; compilers of GLSL ES do not.
    fn check_version(&mut self, at: &Token) -> Result<(), Box<Diagnostic>> {
        let message = format!("`##` is not in {}", self.version.title());
        let problem = match self.version {
            Version::V130 | Version::V140 | Version::V150 | Version::V330 => return Ok(()),
            Version::Es100 | Version::Es300 => Diagnostic::error(at.span, message)
                .rule(format!("{} section 3.4: there is no operator `##`", self.version.title())),
            Version::V110 | Version::V120 => {
                Diagnostic::deviation(self.log.strictness, at.span, message)
                    .rule("GLSL 1.30 section 3.3: `##` joins two tokens, from version 130 on")
                    .help("write `#version 130` first; other compilers may refuse this")
            }
        };
        if problem.severity == Severity::Error {
            return Err(problem.into());
        }
        self.log.push(problem);
        Ok(())
    }
}

fn too_many_tokens(at: Span) -> Box<Diagnostic> {
    let message = format!("macros expand to more than {MAX_EXPANDED_TOKENS} tokens");
    Diagnostic::error(at, message).into()
}

/// Joins the tokens at `start - 1` and `start` into one.
fn join(output: &mut Vec<ExpansionItem>, start: usize, at: Span) -> Result<(), Box<Diagnostic>> {
    let text = |item: &ExpansionItem| match item {
        ExpansionItem::Token(token) | ExpansionItem::Painted(token) => match &token.kind {
            TokenKind::Word(text) | TokenKind::Number(text) => text.to_string(),
            TokenKind::Punct(text) => (*text).to_owned(),
            TokenKind::Stray(_) | TokenKind::Newline | TokenKind::End => String::new(),
        },
        ExpansionItem::EndOf(_) => String::new(),
    };
    let joined = format!("{}{}", text(&output[start - 1]), text(&output[start]));
    match &crate::lex::tokens(&joined).tokens[..] {
        [one, _, _] => {
            output[start - 1] = ExpansionItem::Token(Token { kind: one.kind.clone(), span: at });
            output.remove(start);
            Ok(())
        }
        _ => Err(Diagnostic::error(at, format!("`##` gives `{joined}`, which is no token")).into()),
    }
}

/// The error for a `##` without an operand.
pub fn nothing_to_join(at: &Token) -> Box<Diagnostic> {
    Diagnostic::error(at.span, "`##` has nothing to join here")
        .rule("GLSL 1.30 section 3.3: `##` joins two tokens, from version 130 on")
        .into()
}
