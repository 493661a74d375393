//! Blocks of uniforms, inputs and outputs (GLSL 1.50 section 4.3.7).

use super::{ParseResult, Parser};
use crate::ast::{BlockDecl, InstanceName, Item, Qualifier, TypeBase};
use crate::language::Availability;
use crate::lex::TokenKind;
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;

const SECTION: &str = "ARB_uniform_buffer_object, section 4.3.5.1";

/// What a block is of.
#[derive(Clone, Copy, PartialEq, Eq)]
enum BlockOf {
    Uniforms,
    InputsOrOutputs,
}

impl Parser<'_> {
    /// Parses `uniform name { ... };`, `out name { ... } instance[2];` or `layout(std140) uniform;`;
    /// `None` if these qualifiers begin a declaration of variables.
    pub(super) fn block_item(&mut self, words: &[(Qualifier, Span)]) -> ParseResult<Option<Item>> {
        let of = match words.last() {
            Some((Qualifier::Uniform, _)) => BlockOf::Uniforms,
            Some((Qualifier::In | Qualifier::Out, _)) => BlockOf::InputsOrOutputs,
            Some(_) | None => return Ok(None),
        };
        if words.len() > 1 && self.is(";") && words.iter().any(|(word, _)| word.is_layout()) {
            self.bump();
            return Ok(Some(Item::LayoutDefaults(words.to_vec())));
        }
        let begins = self.token().word().is_some() && self.ahead(1).is("{");
        if !begins || self.is_word("struct") {
            return Ok(None);
        }
        let (availability, what) = match of {
            BlockOf::Uniforms => (Availability::UNIFORM_BLOCKS, "uniform blocks are"),
            BlockOf::InputsOrOutputs => (Availability::V150, "blocks of inputs and outputs are"),
        };
        if !self.language.has(availability) {
            let message = format!("{what} not in {}", self.version.title());
            let mut problem = Diagnostic::error(self.span(), message);
            if let Some(advice) = self.language.advice(availability) {
                problem = problem.help(advice);
            }
            self.log.push(problem);
            return Err(super::SyntaxError);
        }
        self.block_declaration(words.to_vec(), of).map(|block| Some(Item::Block(block)))
    }

    fn block_declaration(
        &mut self,
        qualifiers: Vec<(Qualifier, Span)>,
        of: BlockOf,
    ) -> ParseResult<BlockDecl> {
        let name = self.name()?;
        self.expect("{")?;
        let mut members = Vec::new();
        while !self.is("}") {
            if self.kind() == &TokenKind::End {
                return self.fail("the block is not closed by `}`");
            }
            let ty = self.qualified_type()?;
            if let TypeBase::Struct(_) = ty.ty.base {
                // The specification forbids it, but Mesa accepts it in uniform blocks, and programs
                // rely on that.
                let problem = match of {
                    BlockOf::Uniforms if self.version.is_es() => {
                        let message = "a structure is not defined inside of a uniform block";
                        Diagnostic::error(ty.ty.span, message).rule("GLSL ES 3.00 section 4.3.7")
                    }
                    BlockOf::Uniforms => {
                        let message = "a structure is not defined inside of a uniform block";
                        Diagnostic::deviation(self.log.strictness, ty.ty.span, message)
                            .rule(SECTION)
                    }
                    BlockOf::InputsOrOutputs => {
                        let message = "a structure is not defined inside of a block";
                        Diagnostic::error(ty.ty.span, message).rule("GLSL 1.50 section 4.3.7")
                    }
                };
                self.log.push(problem.help("define it before the block, and name it here"));
            }
            if self.is(",") {
                return self.fail("expected the name of a member, found `,`");
            }
            members.push(self.declarators(ty)?);
            self.expect(";")?;
        }
        self.expect("}")?;
        let instance = match self.token().word().is_some() {
            true => Some(self.instance_name()?),
            false => None,
        };
        self.expect(";")?;
        Ok(BlockDecl { qualifiers, name, members, instance })
    }

    fn instance_name(&mut self) -> ParseResult<InstanceName> {
        if !self.language.has(Availability::INSTANCE_NAMES) {
            let message = format!("a block has no name behind it in {}", self.version.title());
            let problem = Diagnostic::error(self.span(), message).rule(SECTION);
            let help =
                "leave it out: the members are named directly; or write `#version 150` first";
            self.log.push(problem.help(help));
            return Err(super::SyntaxError);
        }
        let name = self.name()?;
        Ok(InstanceName { name, array: self.array_sizes()? })
    }
}
