//! Uniform blocks (ARB_uniform_buffer_object, section 4.3.5.1).

use super::keywords;
use super::{ParseResult, Parser};
use crate::ast::{BlockDecl, Item, Qualifier, TypeBase};
use crate::language::Availability;
use crate::lex::TokenKind;
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;

const SECTION: &str = "ARB_uniform_buffer_object, section 4.3.5.1";

impl Parser<'_> {
    /// Parses `uniform name { ... };` or `layout(std140) uniform;`; `None` if these qualifiers
    /// begin a declaration of variables.
    pub(super) fn block_item(&mut self, words: &[(Qualifier, Span)]) -> ParseResult<Option<Item>> {
        let uniform = matches!(words.last(), Some((Qualifier::Uniform, _)));
        if uniform && words.len() > 1 && self.is(";") {
            self.bump();
            return Ok(Some(Item::BlockDefaults(words.to_vec())));
        }
        let begins = self.token().word().is_some() && self.ahead(1).is("{");
        if !begins || !uniform || self.is_word("struct") {
            return Ok(None);
        }
        if !keywords::has_blocks(self.language) {
            let message = format!("uniform blocks are not in {}", self.version.title());
            let mut problem = Diagnostic::error(self.span(), message);
            if let Some(advice) = self.language.advice(Availability::UNIFORM_BLOCKS) {
                problem = problem.help(advice);
            }
            self.log.push(problem);
            return Err(super::SyntaxError);
        }
        self.uniform_block(words.to_vec()).map(|block| Some(Item::Block(block)))
    }

    fn uniform_block(&mut self, qualifiers: Vec<(Qualifier, Span)>) -> ParseResult<BlockDecl> {
        let name = self.name()?;
        self.expect("{")?;
        let mut members = Vec::new();
        while !self.is("}") {
            if self.kind() == &TokenKind::End {
                return self.fail("the uniform block is not closed by `}`");
            }
            let ty = self.qualified_type()?;
            if let TypeBase::Struct(_) = ty.ty.base {
                // The specification forbids it, but Mesa accepts it and programs rely on that.
                let message = "a structure is not defined inside of a uniform block";
                let problem = Diagnostic::deviation(self.log.strictness, ty.ty.span, message);
                let problem = problem.rule(SECTION);
                self.log.push(problem.help("define it before the block, and name it here"));
            }
            members.push(self.declarators(ty)?);
            self.expect(";")?;
        }
        self.expect("}")?;
        if self.token().word().is_some() {
            let message = "a uniform block has no name behind it: its members are named directly";
            self.log.push(Diagnostic::error(self.span(), message).rule(SECTION));
            return Err(super::SyntaxError);
        }
        self.expect(";")?;
        Ok(BlockDecl { qualifiers, name, members })
    }
}
