//! Macros and their expansion, with a bounded result.

use super::expansion::{self, ExpansionContext, Spent, nothing_to_join};
use crate::language::{ContextLanguage, Extension, Language, Profile, Version};
use crate::lex::{Token, TokenKind};
use crate::text::diagnostics::{Diagnostic, Log};
use crate::text::source::{Source, Span};
use crate::work::Work;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The macros of GLSL ES: section 3.4, and that the fragment stage has `highp` (section 4.5.4).
const ES: [&str; 2] = ["GL_ES", HIGH];
/// GLSL 1.30 defines it too, section 4.5.3.
const HIGH: &str = "GL_FRAGMENT_PRECISION_HIGH";
/// The profiles, GLSL 1.50 section 3.3.
const CORE: &str = "GL_core_profile";
const COMPATIBILITY: &str = "GL_compatibility_profile";

/// A macro.
#[derive(Clone, Debug)]
pub struct Macro {
    /// The parameters; `None` for an object-like macro.
    pub parameters: Option<Vec<Arc<str>>>,
    /// The tokens that replace it.
    pub body: Vec<Token>,
}

impl Macro {
    /// Parses what follows the name `at` in a `#define`.
    pub fn parse(at: Span, rest: &[Token], version: Version) -> Result<Self, Box<Diagnostic>> {
        // The `(` of the parameters follows the name without a blank.
        let [open, more @ ..] = rest else {
            return Ok(Self { parameters: None, body: Vec::new() });
        };
        if let Some(hash) = rest.iter().find(|token| token.is("#")) {
            let problem = Diagnostic::error(hash.span, "`#` makes no strings: there are none");
            return Err(problem.rule("GLSL 1.30 section 3.3").into());
        }
        if !(open.is("(") && open.span.start == at.end) {
            return Ok(Self { parameters: None, body: body(rest, version)? });
        }
        let Some(close) = more.iter().position(|token| token.is(")")) else {
            return Err(
                Diagnostic::error(open.span, "macro parameters are not closed by `)`").into()
            );
        };
        let mut parameters: Vec<Arc<str>> = Vec::new();
        for (index, token) in more[..close].iter().enumerate() {
            match token.word() {
                Some(name) if index % 2 == 0 && !parameters.contains(name) => {
                    parameters.push(name.clone());
                }
                None if index % 2 == 1 && token.is(",") && index + 1 < close => {}
                _ => {
                    let message = "a list of distinct macro parameters is expected";
                    return Err(Diagnostic::error(token.span, message).into());
                }
            }
        }
        Ok(Self { parameters: Some(parameters), body: body(&more[close + 1..], version)? })
    }

    /// Whether a second definition is the same: blanks stand between the same tokens, of any length.
    fn same(&self, other: &Self) -> bool {
        let blanks = |body: &[Token]| -> Vec<bool> {
            body.windows(2).map(|pair| pair[0].span.end < pair[1].span.start).collect()
        };
        self.parameters == other.parameters
            && self.body.len() == other.body.len()
            && self.body.iter().zip(&other.body).all(|(a, b)| a.kind == b.kind)
            && blanks(&self.body) == blanks(&other.body)
    }
}

/// The body of a macro: `##` has a token on both sides. Before GLSL 1.30, which added `##`, this
/// is checked where the macro is used.
fn body(tokens: &[Token], version: Version) -> Result<Vec<Token>, Box<Diagnostic>> {
    let ends = [tokens.first(), tokens.last()];
    match ends.into_iter().flatten().find(|token| token.is("##")) {
        Some(end) if version >= Version::V130 => Err(nothing_to_join(end)),
        Some(_) | None => Ok(tokens.to_vec()),
    }
}

/// All macros.
#[derive(Debug)]
pub struct Macros {
    table: BTreeMap<Arc<str>, Macro>,
    produced: usize,
    /// The work of all expansions.
    pub work: Work,
}

impl Macros {
    /// The macros that a version defines: its extensions, its profile, and [`ES`] and [`HIGH`].
    pub fn new(language: Language, context: ContextLanguage) -> Self {
        let version = language.version;
        let one = Token { kind: TokenKind::Number("1".into()), span: Span::default() };
        let row = |name: &str| (name.into(), Macro { parameters: None, body: vec![one.clone()] });
        let extensions =
            Extension::ALL.iter().filter(|known| context.has_extension(known.0, version));
        let names = extensions.map(|known| known.1);
        let table = match version {
            Version::Es100 | Version::Es300 => names.chain(ES).map(row).collect(),
            Version::V130 | Version::V140 => names.chain([HIGH]).map(row).collect(),
            Version::V150 | Version::V330 => {
                let profile = match language.profile() {
                    Profile::Core => CORE,
                    Profile::Compatibility => COMPATIBILITY,
                };
                names.chain([HIGH, profile]).map(row).collect()
            }
            Version::V110 | Version::V120 => names.map(row).collect(),
        };
        Self { table, produced: 0, work: Work::default() }
    }

    /// Adds a macro; false if there is a different one.
    pub fn define(&mut self, name: &str, new: Macro) -> bool {
        if let Some(old) = self.table.get(name) {
            return old.same(&new);
        }
        self.table.insert(name.into(), new);
        true
    }

    /// The macro of a name.
    pub fn get(&self, name: &str) -> Option<&Macro> {
        self.table.get(name)
    }

    /// Removes a macro.
    pub fn undefine(&mut self, name: &str) {
        self.table.remove(name);
    }

    /// Whether a name is a macro.
    pub fn is_defined(&self, name: &str) -> bool {
        self.table.contains_key(name) || ["__LINE__", "__FILE__", "__VERSION__"].contains(&name)
    }

    /// Expands every macro in `tokens`.
    pub fn expand(
        &mut self,
        tokens: Vec<Token>,
        source: &Source,
        version: Version,
        log: &mut Log,
    ) -> Result<Vec<Token>, Box<Diagnostic>> {
        self.expand_in(ExpansionContext::Text, tokens, source, version, log)
    }

    /// Expands every macro in a condition, and replaces `defined X` and `defined(X)` by 1 or 0,
    /// also in the result of a macro.
    pub fn expand_condition(
        &mut self,
        tokens: Vec<Token>,
        source: &Source,
        version: Version,
        log: &mut Log,
    ) -> Result<Vec<Token>, Box<Diagnostic>> {
        self.expand_in(ExpansionContext::Condition, tokens, source, version, log)
    }

    fn expand_in(
        &mut self,
        context: ExpansionContext,
        tokens: Vec<Token>,
        source: &Source,
        version: Version,
        log: &mut Log,
    ) -> Result<Vec<Token>, Box<Diagnostic>> {
        let mut spent = Spent { produced: self.produced, work: self.work };
        let result = expansion::expand(self, context, tokens, source, version, &mut spent, log);
        (self.produced, self.work) = (spent.produced, spent.work);
        result
    }
}
