//! Declarations, functions and types (GLSL 1.30 chapters 4 and 6).

use super::keywords::{self, WordClass};
use super::{ParseResult, Parser};
use crate::ast::{
    ArraySize, Declaration, Declarator, ExprKind, Function, Item, Name, Parameter, Precision,
    QualifiedType, Qualifier, StructDecl, TypeBase, TypeName,
};
use crate::language::{Availability, Extension, Version};
use crate::lex::TokenKind;
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use std::sync::Arc;

impl Parser<'_> {
    /// One item; `None` for an empty declaration.
    pub(super) fn item(&mut self) -> ParseResult<Option<Item>> {
        if self.eat(";") {
            return Ok(None);
        }
        if self.is_word("precision") && keywords::has_precision(self.language) {
            return self
                .default_precision()
                .map(|(precision, ty)| Some(Item::Precision(precision, ty)));
        }
        if self.is_word("invariant")
            && keywords::qualifier("invariant", self.language).is_some()
            && (self.ahead(2).is(";") || self.ahead(2).is(","))
        {
            self.bump();
            let mut names = vec![self.name()?];
            while self.eat(",") {
                names.push(self.name()?);
            }
            self.expect(";")?;
            return Ok(Some(Item::Invariant(names)));
        }
        let qualifiers = self.qualifiers()?;
        if let Some(item) = self.block_item(&qualifiers)? {
            return Ok(Some(item));
        }
        let ty = QualifiedType { qualifiers, ty: self.type_name()? };
        if self.ahead(1).is("(") && self.token().word().is_some() {
            return self.function(ty).map(|function| Some(Item::Function(function)));
        }
        let declaration = self.declarators(ty)?;
        self.expect(";")?;
        Ok(Some(Item::Declaration(declaration)))
    }

    /// `precision highp float;`
    pub(super) fn default_precision(&mut self) -> ParseResult<(Precision, TypeName)> {
        self.bump();
        let word = self.token().word().and_then(|word| keywords::qualifier(word, self.language));
        let Some(Qualifier::Precision(precision)) = word else {
            return self.fail("expected `lowp`, `mediump` or `highp`");
        };
        self.bump();
        let ty = self.type_name()?;
        self.expect(";")?;
        Ok((precision, ty))
    }

    /// Qualifiers and a type.
    pub(super) fn qualified_type(&mut self) -> ParseResult<QualifiedType> {
        Ok(QualifiedType { qualifiers: self.qualifiers()?, ty: self.type_name()? })
    }

    fn qualifiers(&mut self) -> ParseResult<Vec<(Qualifier, Span)>> {
        let mut qualifiers = Vec::new();
        let mut layouts = 0;
        while let Some(word) = self.token().word() {
            let span = self.span();
            if &**word == "layout" && keywords::has_layout(self.language) {
                layouts += 1;
                if layouts == 2 && !keywords::is_relaxed(self.language) {
                    let message = "a declaration has one `layout(...)` before GLSL 4.20";
                    let problem = Diagnostic::error(span, message);
                    self.log.push(problem.help("write all layouts in one, with commas between"));
                }
                self.layout(&mut qualifiers)?;
                continue;
            }
            match keywords::qualifier(word, self.language) {
                Some(qualifier) => {
                    let ways = [Qualifier::In, Qualifier::Out, Qualifier::Inout];
                    let kind = if ways.contains(&qualifier) { &ways[..] } else { &[qualifier] };
                    let is_second = |before: &Qualifier| match (before, qualifier) {
                        (Qualifier::Precision(_), Qualifier::Precision(_)) => true,
                        (before, _) => kind.contains(before),
                    };
                    if qualifiers.iter().any(|(before, _)| is_second(before)) {
                        let message = if matches!(qualifier, Qualifier::Precision(_)) {
                            "a declaration has one precision".to_owned()
                        } else if ways.contains(&qualifier) {
                            "one of `in`, `out` and `inout` is enough".to_owned()
                        } else {
                            format!("`{word}` stands here twice")
                        };
                        let rule = format!("{} chapter 9", self.version.title());
                        self.log.push(Diagnostic::error(span, message).rule(rule));
                    }
                    self.bump();
                    qualifiers.push((qualifier, span));
                }
                None => {
                    let missing = keywords::missing_qualifier(word, self.language);
                    let Some(since) = missing.filter(|_| self.ahead(1).word().is_some()) else {
                        break;
                    };
                    let message = format!("`{word}` is not in {}", self.version.title());
                    let mut problem = Diagnostic::error(span, message);
                    if let Some(advice) = self.language.advice(since) {
                        problem = problem.help(advice);
                    }
                    self.log.push(problem);
                    self.bump();
                }
            }
        }
        Ok(qualifiers)
    }

    /// `layout(origin_upper_left, pixel_center_integer)` (ARB_fragment_coord_conventions),
    /// `layout(location = 3)` (ARB_explicit_attrib_location) or `layout(std140)`
    /// (ARB_uniform_buffer_object).
    fn layout(&mut self, qualifiers: &mut Vec<(Qualifier, Span)>) -> ParseResult<()> {
        self.bump();
        self.expect("(")?;
        loop {
            // `packed` is a reserved word elsewhere.
            let span = self.span();
            // The words are not case sensitive before GLSL 4.20 (GLSL 1.50 section 4.3.8), but in OpenGL ES they are
            // (GLSL ES 3.00 section 4.3.8).
            let is_es = self.version.is_es();
            let folded = |word: &str| match is_es {
                true => word.to_owned(),
                false => word.to_ascii_lowercase(),
            };
            let word = self.token().word().map(|word| folded(word));
            let layout = word.as_deref().and_then(|word| {
                let block = keywords::block_layout(word, self.language).map(Qualifier::Block);
                let depth = || keywords::depth_layout(word, self.language).map(Qualifier::Depth);
                block.or_else(depth).or_else(|| {
                    keywords::primitive_layout(word, self.language).map(Qualifier::Primitive)
                })
            });
            if let Some(layout) = layout {
                self.bump();
                qualifiers.push((layout, span));
                if !self.eat(",") {
                    return self.expect(")");
                }
                continue;
            }
            let name = self.name()?;
            let conventions = self.language.has(Availability::FRAGMENT_COORD_CONVENTIONS);
            let locations = self.language.has(Availability::EXPLICIT_LOCATIONS);
            let has_index =
                !self.version.is_es() || self.language.enabled(Extension::EsBlendFuncExtended);
            let geometry = self.language.has(Availability::V150);
            let qualifier = match &*folded(&name.text) {
                "origin_upper_left" if conventions => Some(Qualifier::OriginUpperLeft),
                "pixel_center_integer" if conventions => Some(Qualifier::PixelCenterInteger),
                "location" if locations => self.layout_number()?.map(Qualifier::Location),
                "index" if locations && has_index => self.layout_number()?.map(Qualifier::Index),
                "binding" if keywords::is_relaxed(self.language) => {
                    self.layout_number()?.map(Qualifier::Binding)
                }
                "max_vertices" if geometry => self.layout_number()?.map(Qualifier::MaxVertices),
                other => {
                    let message = format!("`{other}` is no layout");
                    let blocks = keywords::has_blocks(self.language);
                    let known = [
                        (conventions, "`origin_upper_left`, `pixel_center_integer`"),
                        (locations, "`location = n`"),
                        (geometry, "`triangles` and the other primitives, `max_vertices = n`"),
                        (blocks, "`shared`, `packed`, `std140`, `row_major`, `column_major`"),
                    ];
                    let known: Vec<&str> =
                        known.iter().filter(|(here, _)| *here).map(|(_, words)| *words).collect();
                    let known = match other {
                        "location" => "enable GL_ARB_explicit_attrib_location".into(),
                        _ => format!("layouts here: {}", known.join(", ")),
                    };
                    self.log.push(Diagnostic::error(name.span, message).help(known));
                    if self.eat("=") {
                        self.bump();
                    }
                    None
                }
            };
            qualifiers.extend(qualifier.map(|qualifier| (qualifier, name.span)));
            if !self.eat(",") {
                return self.expect(")");
            }
        }
    }

    /// `= 3` of a location and the like: an integer literal.
    fn layout_number(&mut self) -> ParseResult<Option<u32>> {
        self.expect("=")?;
        let token = self.token();
        let TokenKind::Number(text) = &token.kind else {
            let found = token.describe();
            return self.fail(format!("expected the number of this layout, found {found}"));
        };
        self.bump();
        let number = self.number(text, token.span);
        if let ExprKind::Int(value) = number
            && let Ok(value) = u32::try_from(value)
        {
            return Ok(Some(value));
        }
        if let ExprKind::Uint(value) = number {
            return Ok(Some(value));
        }
        let message = "the number of a layout is a whole number";
        let rule = "ARB_explicit_attrib_location";
        self.log.push(Diagnostic::error(token.span, message).rule(rule));
        Ok(None)
    }

    /// A type, with the size of an array of it.
    pub(super) fn type_name(&mut self) -> ParseResult<TypeName> {
        let span = self.span();
        let base = if self.is_word("struct") {
            TypeBase::Struct(Arc::new(self.nested(Self::structure)?))
        } else if keywords::has_unsigned_int(self.language) && self.eat_word("unsigned") {
            self.eat_word("int");
            TypeBase::Named("uint".into())
        } else {
            let token = self.token();
            let Some(word) = token.word() else {
                return self.fail(format!("expected a type, found {}", token.describe()));
            };
            match keywords::classify(word, self.language) {
                WordClass::Type | WordClass::Name => {
                    self.bump();
                    TypeBase::Named(word.clone())
                }
                WordClass::Keyword => return self.fail(format!("expected a type, found `{word}`")),
                WordClass::Reserved => {
                    return self.fail(format!("`{word}` is reserved for later versions"));
                }
            }
        };
        let span = span.to(self.last_span());
        let array = self.array_sizes()?;
        if let Some(array) = array.first()
            && self.version < Version::V120
        {
            let message = "the size of an array stands after the name";
            let problem = match self.version.is_es() {
                // Compilers of GLSL ES accept it.
                true => Diagnostic::deviation(self.log.strictness, array.span, message),
                false => Diagnostic::error(array.span, message),
            };
            let rule = format!("{} section 4.1.9", self.version.title());
            let later = if self.version.is_es() { "300 es" } else { "120" };
            let help = format!("write `#version {later}` for sizes after the type");
            self.log.push(problem.rule(rule).help(help));
        }
        Ok(TypeName { span, base, array })
    }

    /// As many `[]` and `[size]` as follow.
    pub(super) fn array_sizes(&mut self) -> ParseResult<Vec<ArraySize>> {
        let mut sizes = Vec::new();
        loop {
            let span = self.span();
            if !self.eat("[") {
                return Ok(sizes);
            }
            if !sizes.is_empty() {
                self.has_arrays_of_arrays(span)?;
            }
            let size =
                if self.is("]") { None } else { Some(Box::new(self.nested(Self::conditional)?)) };
            self.expect("]")?;
            sizes.push(ArraySize { span: span.to(self.last_span()), size });
        }
    }

    /// Whether an array may have the second size that begins here; reports it if not.
    pub(super) fn has_arrays_of_arrays(&mut self, span: Span) -> ParseResult<()> {
        if self.language.enabled(Extension::ArraysOfArrays) {
            return Ok(());
        }
        let message = "arrays of arrays are not in this version";
        let problem = Diagnostic::error(span, message)
            .rule(format!("{} section 4.1.9", self.version.title()));
        self.log.push(problem.help("write one array of all elements, or of structures"));
        Err(super::SyntaxError)
    }

    fn structure(&mut self) -> ParseResult<StructDecl> {
        self.bump();
        let name = if self.is("{") { None } else { Some(self.name()?) };
        self.expect("{")?;
        let mut fields = Vec::new();
        while !self.is("}") {
            if self.kind() == &TokenKind::End {
                return self.fail("the structure is not closed by `}`");
            }
            let ty = self.qualified_type()?;
            for (qualifier, span) in &ty.qualifiers {
                if !matches!(qualifier, Qualifier::Precision(_)) {
                    let message = "members of a structure take no qualifiers";
                    self.log
                        .push(Diagnostic::error(*span, message).rule("GLSL 1.30 section 4.1.8"));
                }
            }
            loop {
                let name = self.name()?;
                let array = self.array_sizes()?;
                fields.push((ty.clone(), name, array));
                if !self.eat(",") {
                    break;
                }
            }
            self.expect(";")?;
        }
        self.expect("}")?;
        Ok(StructDecl { name, fields })
    }

    /// The names of a declaration, up to the `;`.
    pub(super) fn declarators(&mut self, ty: QualifiedType) -> ParseResult<Declaration> {
        let mut names = Vec::new();
        if self.is(";") {
            return Ok(Declaration { ty, names });
        }
        // The grammar allows an empty declarator before the others: `float, a;` (chapter 9).
        self.eat(",");
        loop {
            let name = self.declared_name(&ty)?;
            let array = self.array_sizes()?;
            let init = if self.eat("=") { Some(self.initializer()?) } else { None };
            names.push(Declarator { name, array, init });
            if !self.eat(",") {
                return Ok(Declaration { ty, names });
            }
        }
    }

    /// The name after a type; if it is missing, the word before is likely a misspelt qualifier or
    /// type.
    fn declared_name(&mut self, ty: &QualifiedType) -> ParseResult<Name> {
        let misplaced = match &ty.ty.base {
            TypeBase::Named(word) if self.token().word().is_some() => {
                let unknown = keywords::classify(word, self.language) == WordClass::Name;
                let next = self
                    .token()
                    .word()
                    .map_or(WordClass::Name, |next| keywords::classify(next, self.language));
                let broken = unknown && matches!(next, WordClass::Type | WordClass::Keyword);
                broken.then(|| word.clone())
            }
            TypeBase::Named(_) | TypeBase::Struct(_) => None,
        };
        let Some(word) = misplaced else { return self.name() };
        let mut problem = Diagnostic::error(ty.ty.span, format!("unknown word `{word}`"));
        if let Some(near) = self.near_keyword(&word) {
            let text = format!("did you mean `{near}`?");
            problem = problem.fix(text, ty.ty.span, near.to_owned());
        }
        self.log.push(problem);
        Err(super::SyntaxError)
    }

    pub(super) fn function(&mut self, ty: QualifiedType) -> ParseResult<Function> {
        let name = self.name()?;
        self.expect("(")?;
        let mut parameters = Vec::new();
        if self.is_word("void") && self.ahead(1).is(")") {
            self.bump();
        }
        while !self.is(")") {
            if !parameters.is_empty() {
                self.expect(",")?;
            }
            let ty = self.qualified_type()?;
            let name = if self.token().word().is_some() { Some(self.name()?) } else { None };
            let array = self.array_sizes()?;
            parameters.push(Parameter { ty, name, array });
        }
        self.expect(")")?;
        let body = if self.eat(";") {
            None
        } else if self.is("{") {
            Some(self.nested(Self::block)?)
        } else {
            let found = self.token().describe();
            return self
                .fail(format!("expected `;` or `{{` after the function's head, found {found}"));
        };
        Ok(Function { ty, name, parameters, body })
    }
}
