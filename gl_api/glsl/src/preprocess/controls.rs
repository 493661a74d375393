//! The directives that control the compiler: `#extension` and `#pragma`.

use super::Preprocessor;
use crate::language::{Behaviour, Extension};
use crate::lex::{Token, TokenKind};
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::text::spelling::closest;

/// Whether a missing extension is an error.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Required {
    No,
    Yes,
}

impl Preprocessor<'_> {
    /// `#pragma`: one that is not known is ignored. GLSL ES gives `optimize` and `debug` a form (GLSL ES 3.00
    /// section 3.4), and its lines have the characters of the language.
    pub(super) fn pragma(&mut self, span: Span, rest: &[Token]) {
        let is = |(token, word): (&Token, &str)| {
            token.is(word) || token.word().is_some_and(|found| **found == *word)
        };
        let are = |words: &[&str]| {
            rest.len() == words.len() && rest.iter().zip(words.iter().copied()).all(is)
        };
        self.all_invariant |= are(&["STDGL", "invariant", "(", "all", ")"]);
        if !self.language.version.is_es() {
            return;
        }
        let rule = "GLSL ES 1.00 section 3.4";
        let stray = |token: &&Token| matches!(token.kind, TokenKind::Stray(_));
        if let Some(token) = rest.iter().find(stray) {
            let message = format!("{} is not in the character set", token.describe());
            self.log.push(Diagnostic::error(token.span, message).rule(rule));
        }
        let name = rest.first().and_then(Token::word).map_or("", |word| word);
        let known = ["optimize", "debug"].contains(&name);
        if known && !are(&[name, "(", "on", ")"]) && !are(&[name, "(", "off", ")"]) {
            let message = format!("`#pragma {name}` takes `(on)` or `(off)`");
            self.log.push(Diagnostic::error(span, message).rule(rule));
        }
    }

    /// Enables all extensions of the version.
    pub(super) fn set_all(&mut self, behaviour: Behaviour) {
        for (known, _) in Extension::ALL {
            // What a version has removed is asked for by name.
            if known.is_in(self.language.version) && known != Extension::Compatibility {
                self.language.set(known, behaviour);
            }
        }
    }

    pub(super) fn extension(&mut self, span: Span, rest: &[Token]) {
        let [name, colon, behaviour, ..] = rest else {
            self.error(span, "`#extension name : behaviour` is expected");
            return;
        };
        let (Some(extension), true, Some(behaviour_name)) =
            (name.word(), colon.is(":"), behaviour.word())
        else {
            self.error(span, "`#extension name : behaviour` is expected");
            return;
        };
        if let Some(more) = rest.get(3) {
            let message = format!("unexpected {} after the behaviour", more.describe());
            self.error(more.span, message);
        }
        let (name_span, behaviour_span) = (name.span, behaviour.span);
        let (required, behaviour) = match &**behaviour_name {
            "require" => (Required::Yes, Behaviour::Enable),
            "enable" => (Required::No, Behaviour::Enable),
            "warn" => (Required::No, Behaviour::Warn),
            "disable" => (Required::No, Behaviour::Disable),
            other => {
                let names = ["require", "enable", "warn", "disable"];
                let message = format!("`{other}` is no behaviour of an extension");
                let mut problem = Diagnostic::error(behaviour_span, message)
                    .rule("GLSL 1.30 section 3.3: it is `require`, `enable`, `warn` or `disable`");
                if let Some(near) = closest(other, names.into_iter()) {
                    let text = format!("did you mean `{near}`?");
                    problem = problem.fix(text, behaviour_span, near.to_owned());
                }
                self.log.push(problem);
                return;
            }
        };
        if self.program_begun {
            let message = "`#extension` stands behind a part of the program";
            let problem = match self.language.version.is_es() {
                true => Diagnostic::error(span, message).rule("GLSL ES 1.00 section 3.4"),
                false => Diagnostic::deviation(self.log.strictness, span, message),
            };
            self.log.push(problem.help("put it before anything but directives and comments"));
        }
        let version = self.language.version;
        if &**extension == "all" {
            if behaviour == Behaviour::Enable {
                let message = "`all` can only be warned about or disabled";
                let rule = "GLSL 1.30 section 3.3, `#extension`";
                self.log.push(Diagnostic::error(span, message).rule(rule));
                return;
            }
            self.set_all(behaviour);
            return;
        }
        let named = Extension::named(extension);
        match named.filter(|known| self.context.has_extension(*known, version)) {
            Some(known) => self.language.set(known, behaviour),
            None => {
                let message = format!("extension `{extension}` is not supported");
                let mut problem = match required {
                    Required::Yes => Diagnostic::error(name_span, message),
                    Required::No => Diagnostic::warning(name_span, message),
                };
                let names = Extension::ALL.iter().filter(|row| row.0.is_in(version));
                if let Some(near) = closest(extension, names.map(|row| row.1)) {
                    let text = format!("did you mean `{near}`?");
                    problem = problem.fix(text, name_span, near.to_owned());
                }
                self.log.push(problem);
            }
        }
    }
}
