//! The directives: `#define`, `#if`, `#version`, `#extension`, `#line`, `#error`, `#pragma`.

use super::condition;
use super::macros::{Macro, Macros};
use super::{Conditional, GroupState, Preprocessor};
use crate::language::{Behaviour, Language, Profile, Version};
use crate::lex::{Token, TokenKind};
use crate::limits::MAX_CONDITIONALS;
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::text::spelling::closest;

/// The names of the directives.
const NAMES: [&str; 13] = [
    "define",
    "undef",
    "if",
    "ifdef",
    "ifndef",
    "else",
    "elif",
    "endif",
    "error",
    "pragma",
    "extension",
    "version",
    "line",
];

/// The value of a decimal number; one that begins with 0 is octal.
fn number(token: &Token) -> Option<i64> {
    let TokenKind::Number(number) = &token.kind else { return None };
    if number.len() > 1 && number.starts_with('0') {
        return None;
    }
    number.parse::<u32>().ok().map(i64::from)
}

impl Preprocessor<'_> {
    pub(super) fn directive(&mut self, hash: &Token, line: &[Token]) {
        let Some((first, rest)) = line.split_first() else { return };
        let span = hash.span.to(first.span);
        let name = first.word().map_or("", |word| word);
        match name {
            "if" | "ifdef" | "ifndef" => self.if_directive(name, span, rest),
            "elif" => self.elif_directive(span, rest),
            "else" => self.else_directive(span, rest),
            "endif" => match self.conditionals.pop() {
                Some(_) if !self.is_active() => {}
                Some(_) => self.expect_line_end(rest),
                None => self.error(span, "`#endif` without `#if`"),
            },
            _ if !self.is_active() => {}
            "define" => self.define(span, rest),
            "undef" => self.undef(span, rest),
            "error" => {
                let text = rest.first().zip(rest.last());
                let text = text.map(|(a, b)| self.source.slice(a.span.to(b.span)).to_owned());
                let message = format!("#error {}", text.unwrap_or_default());
                self.error(span, message.trim_end());
            }
            "pragma" => self.pragma(span, rest),
            "version" => self.version(span, rest),
            "extension" => self.extension(span, rest),
            "line" => self.line(span, rest),
            _ => {
                let mut problem = Diagnostic::error(
                    first.span,
                    format!("unknown directive {}", first.describe()),
                )
                .rule("GLSL 1.30 section 3.3 lists the directives");
                if let Some(near) = closest(name, NAMES.into_iter()) {
                    problem = problem.fix(
                        format!("did you mean `#{near}`?"),
                        first.span,
                        near.to_owned(),
                    );
                }
                self.log.push(problem);
            }
        }
    }

    fn expect_line_end(&mut self, rest: &[Token]) {
        if let Some(token) = rest.first() {
            let message = format!("unexpected {} after the directive", token.describe());
            // Compilers of GLSL ES refuse it.
            let problem = match self.language.version.is_es() {
                true => Diagnostic::error(token.span, message),
                false => Diagnostic::warning(token.span, message),
            };
            self.log.push(problem);
        }
    }

    /// The macro name of a directive.
    fn name<'t>(&mut self, span: Span, rest: &'t [Token]) -> Option<(&'t str, &'t [Token])> {
        match rest {
            [Token { kind: TokenKind::Word(name), .. }, more @ ..] => Some((name, more)),
            _ => {
                self.error(rest.first().map_or(span, |token| token.span), "a name is expected");
                None
            }
        }
    }

    fn if_directive(&mut self, kind: &str, span: Span, rest: &[Token]) {
        if self.conditionals.len() >= MAX_CONDITIONALS {
            self.error(span, "conditionals are nested too deeply");
            return;
        }
        let state = if !self.is_active() {
            GroupState::Done
        } else {
            let holds = match kind {
                "if" => self.condition(span, rest),
                _ => self.name(span, rest).is_some_and(|(name, more)| {
                    self.expect_line_end(more);
                    self.macros.is_defined(name) == (kind == "ifdef")
                }),
            };
            if holds { GroupState::Taken } else { GroupState::Waiting }
        };
        self.conditionals.push(Conditional { span, state, after_else: false });
    }

    fn condition(&mut self, span: Span, rest: &[Token]) -> bool {
        let version = self.language.version;
        let value =
            condition::evaluate(span, rest, &mut self.macros, self.source, version, self.log);
        match value {
            Ok(value) => value != 0,
            Err(problem) => {
                self.log.push(*problem);
                false
            }
        }
    }

    fn elif_directive(&mut self, span: Span, rest: &[Token]) {
        let Some(last) = self.conditionals.last() else {
            self.error(span, "`#elif` without `#if`");
            return;
        };
        let (state, after_else) = (last.state, last.after_else);
        if after_else {
            self.error(span, "`#elif` after `#else`");
        }
        let state = match state {
            GroupState::Taken | GroupState::Done => GroupState::Done,
            GroupState::Waiting if self.condition(span, rest) => GroupState::Taken,
            GroupState::Waiting => GroupState::Waiting,
        };
        if let Some(last) = self.conditionals.last_mut() {
            last.state = state;
        }
    }

    fn else_directive(&mut self, span: Span, rest: &[Token]) {
        // In a group that is skipped, the lines of inner conditionals are not read further.
        let (_, outer) = self.conditionals.split_last().unzip();
        if outer.is_none_or(|outer| outer.iter().all(|one| one.state == GroupState::Taken)) {
            self.expect_line_end(rest);
        }
        let Some(last) = self.conditionals.last_mut() else {
            self.error(span, "`#else` without `#if`");
            return;
        };
        last.state = match last.state {
            GroupState::Taken | GroupState::Done => GroupState::Done,
            GroupState::Waiting => GroupState::Taken,
        };
        if std::mem::replace(&mut last.after_else, true) {
            self.error(span, "a second `#else` for the same `#if`");
        }
    }

    fn define(&mut self, span: Span, rest: &[Token]) {
        let Some((name, more)) = self.name(span, rest) else { return };
        let at = rest[0].span;
        let protected = ["defined", "__LINE__", "__FILE__", "__VERSION__"].contains(&name);
        if protected || name.starts_with("GL_") {
            let message = format!("`{name}` cannot be defined");
            let rule = "GLSL 1.30 section 3.3: predefined names and names that begin with \
                        GL_ are reserved";
            self.log.push(Diagnostic::error(at, message).rule(rule));
            return;
        }
        if name.contains("__") {
            let message = format!("`{name}` holds two underscores in a row, which is reserved");
            self.log.push(Diagnostic::warning(at, message));
        }
        match Macro::parse(at, more, self.language.version) {
            Ok(new) => {
                if !self.macros.define(name, new) {
                    let message = format!("`{name}` is already defined differently");
                    self.log.push(
                        Diagnostic::error(at, message).help(format!("write `#undef {name}` first")),
                    );
                }
            }
            Err(problem) => self.log.push(*problem),
        }
    }

    fn undef(&mut self, span: Span, rest: &[Token]) {
        let Some((name, more)) = self.name(span, rest) else { return };
        self.expect_line_end(more);
        if name.starts_with("__") || name.starts_with("GL_") {
            self.error(rest[0].span, format!("`{name}` cannot be undefined"));
        } else {
            self.macros.undefine(name);
        }
    }

    fn version(&mut self, span: Span, rest: &[Token]) {
        let rule =
            "GLSL 1.30 section 3.3: `#version` comes before anything but comments and blanks";
        if self.begun {
            let message = "`#version` is not at the beginning";
            self.log.push(Diagnostic::error(span, message).rule(rule));
            return;
        }
        let number = rest.first().and_then(number);
        let at = rest.first().map_or(span, |token| token.span);
        let Some(number) = number else {
            self.error(at, "a version number is expected");
            return;
        };
        let known = Version::ALL.into_iter().find(|known| i64::from(known.number()) == number);
        let es = rest.get(1).is_some_and(|token| token.word().is_some_and(|word| &**word == "es"));
        // Of GLSL ES 3.00, `es` is a part of the number (section 3.3).
        let known = known.filter(|known| *known != Version::Es300 || es);
        // A shader in an unknown version is checked like one in the newest version with all
        // extensions: most of the language is the same, and its other errors are worth reporting.
        let version = known.unwrap_or(Version::NEWEST);
        let offered = known.is_some_and(|known| self.context.has(known));
        if !offered {
            self.log.push(
                Diagnostic::error(at, format!("GLSL version {number} is not supported"))
                    .help(format!("this context knows the versions {}", self.context.versions())),
            );
        }
        let named = match known {
            Some(Version::Es300) => {
                if let Some(unexpected) = rest.get(2) {
                    let message = format!("unexpected {} after the version", unexpected.describe());
                    self.log.push(Diagnostic::error(unexpected.span, message));
                }
                None
            }
            Some(_) => self.profile(version, &rest[1..]),
            None => None,
        };
        let profile = named.unwrap_or_else(|| self.context.default_profile(version));
        self.language = Language::new(version, profile);
        self.macros = Macros::new(self.language, self.context);
        if known.is_none() {
            self.set_all(Behaviour::Enable);
        }
    }

    /// The profile that follows a version number, from 1.50 on.
    fn profile(&mut self, version: Version, rest: &[Token]) -> Option<Profile> {
        let (first, more) = rest.split_first()?;
        let rule = match version >= Version::V150 {
            true => "GLSL 1.50 section 3.3: `#version number profile`",
            false => "GLSL 1.30 section 3.3: `#version number`",
        };
        let profile = match first.word().map(|word| &**word) {
            Some("core") => Some(Profile::Core),
            Some("compatibility") => Some(Profile::Compatibility),
            _ => None,
        };
        let unexpected = if version < Version::V150 { Some(first) } else { more.first() };
        if let Some(unexpected) = unexpected {
            let message = format!("unexpected {} after the version", unexpected.describe());
            self.log.push(Diagnostic::error(unexpected.span, message).rule(rule));
            return profile.filter(|_| version >= Version::V150);
        }
        match profile {
            None => {
                let message = format!("{} is no profile", first.describe());
                let problem = Diagnostic::error(first.span, message).rule(rule);
                let es = first.word().is_some_and(|word| &**word == "es");
                self.log.push(problem.help(match es {
                    true => {
                        "the versions of GLSL ES are 100, which is written without `es`, and 300"
                    }
                    false => "it is `core` or `compatibility`",
                }));
            }
            Some(profile) if !self.context.has_profile(profile) => {
                let message = "this context has no compatibility profile";
                let problem = Diagnostic::error(first.span, message).rule(rule);
                self.log.push(problem.help("write `core`, or make a context of that profile"));
            }
            Some(_) => {}
        }
        profile
    }

    fn line(&mut self, span: Span, rest: &[Token]) {
        let version = self.language.version;
        let expanded = match self.macros.expand(rest.to_vec(), self.source, version, self.log) {
            Ok(expanded) => expanded,
            Err(problem) => {
                self.log.push(*problem);
                return;
            }
        };
        // Versions of OpenGL before 3.30 number the line of the directive itself, so that the next one is
        // `line + 1` (GLSL 1.30 section 3.3). In OpenGL ES it is `line` (GLSL ES 3.00 section 3.4).
        let after = i64::from(version < Version::V330 && !version.is_es());
        match self.numbers(span, &expanded).as_deref() {
            Some([line]) => self.source.renumber(span.start, line + after, None),
            Some([line, string]) => self.source.renumber(span.start, line + after, Some(*string)),
            _ => self.error(span, "`#line line` or `#line line string` is expected"),
        }
    }

    /// The numbers after `#line`, which may be expressions.
    fn numbers(&mut self, span: Span, tokens: &[Token]) -> Option<Vec<i64>> {
        let plain: Option<Vec<i64>> = tokens.iter().map(number).collect();
        if plain.is_some() || tokens.iter().any(|token| token.word().is_some()) {
            return plain;
        }
        let all = condition::values(span, tokens, self.language.version, self.log).ok()?;
        all.iter().all(|value| u32::try_from(*value).is_ok()).then_some(all)
    }
}
