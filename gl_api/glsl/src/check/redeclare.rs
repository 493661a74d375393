//! Redeclarations: arrays that get a size, and built-in variables with a size, an interpolation
//! qualifier or a layout (GLSL 1.30 sections 4.1.9, 4.3.7, 7.1 and 7.6).

use super::Checker;
use super::scope::Symbol;
use crate::ast;
use crate::builtins::variable::{Builtin, PER_VERTEX};
use crate::hir::{InterfaceQualifiers, Storage, VarRef, Variable};
use crate::language::{Availability, Extension, stage_name};
use crate::limits::MAX_CLIP_DISTANCES;
use crate::text::diagnostics::Diagnostic;
use crate::types::Type;
use rasterizer::ir::Stage;

impl Checker<'_> {
    /// Checks the redeclaration of a built-in variable; false if the name is not built in.
    pub(super) fn redeclares_builtin(
        &mut self,
        declared: &ast::Declarator,
        ty: &Type,
        storage: Storage,
        interface_qualifiers: InterfaceQualifiers,
    ) -> bool {
        let name = &declared.name;
        if !name.text.starts_with("gl_") {
            return false;
        }
        let known = match self.scopes.find_global(&name.text) {
            Some(symbol) => symbol.variable(),
            None => None,
        };
        let Some(var) = known.or_else(|| self.builtin_variable(&name.text)) else { return false };
        let variable = self.variable(var);
        let Storage::Builtin(builtin) = variable.storage else { return false };
        let (known, min_len) = (variable.ty.clone(), variable.min_len);
        let fits = self.resizes(&known, ty, min_len);
        let is_output = matches!(builtin, Builtin::FragDepth | Builtin::SampleMask);
        let passes = match self.stage {
            Stage::Vertex | Stage::Geometry => matches!(storage, Storage::Output(_)),
            Stage::Fragment if is_output => storage == Storage::FragmentOutput,
            Stage::Fragment => matches!(storage, Storage::Input(_)),
        };
        let is_depth = builtin == Builtin::FragDepth;
        let depths = self.language.has(Availability::CONSERVATIVE_DEPTH);
        let used = variable.references > 0;
        let (before, redeclared) = (variable.interface_qualifiers, variable.redeclared);
        // ARB_separate_shader_objects, section 7.7.
        let is_located_output = self.language.enabled(Extension::SeparateShaderObjects)
            && matches!(builtin, Builtin::Position | Builtin::PointSize | Builtin::ClipVertex);
        let in_block = self.unit.per_vertex.outputs.is_some() && PER_VERTEX.contains(&&*name.text);
        if *ty == Type::Error {
            return true;
        }
        if in_block {
            let message = format!("`{}` is in the redeclared `gl_PerVertex`", name.text);
            let problem = Diagnostic::error(name.span, message).rule(self.rule("7.1"));
            self.log.push(problem.help("declare it in that block alone"));
        } else if !(builtin.is_redeclarable() || is_located_output)
            || is_depth && !depths
            || builtin == Builtin::FragCoord && self.version.is_es()
        {
            let message = format!("`{}` is part of the language", name.text);
            let problem = Diagnostic::error(name.span, message).rule(self.rule("3.7"));
            self.log.push(problem.help("leave the declaration out"));
        } else if !fits {
            let message = format!("`{}` is {known}, not {ty}", name.text);
            let problem = Diagnostic::error(name.span, message).rule(self.rule("7.6"));
            self.log.push(problem.help("redeclare it as it is, or with another size that fits"));
        } else if !passes {
            let stage = stage_name(self.stage);
            let is_input = self.stage == Stage::Fragment && !is_output;
            let way = if is_input { "in" } else { "out" };
            let message = format!("`{}` is an `{way}` of the {stage} stage", name.text);
            self.log.push(Diagnostic::error(name.span, message).rule(self.rule("7.6")));
        } else {
            let before = redeclared.then_some(before);
            self.check_redeclared_layout(builtin, name, used, (before, interface_qualifiers));
            let variable = self.variable_mut(var);
            variable.redeclared = true;
            let invariant =
                variable.interface_qualifiers.invariant || interface_qualifiers.invariant;
            variable.interface_qualifiers =
                InterfaceQualifiers { invariant, ..interface_qualifiers };
            if matches!(ty, Type::Array(_, Some(_))) {
                variable.ty = ty.clone();
            }
        }
        true
    }

    /// `gl_FragCoord` and `gl_FragDepth` are redeclared before they are used, and always with the
    /// same layout. `before` are the qualifiers of the redeclaration before.
    fn check_redeclared_layout(
        &mut self,
        builtin: Builtin,
        name: &ast::Name,
        used: bool,
        (before, now): (Option<InterfaceQualifiers>, InterfaceQualifiers),
    ) {
        let (rule, same) = if builtin == Builtin::FragCoord {
            let same = before.is_none_or(|before| before.coordinates() == now.coordinates());
            ("ARB_fragment_coord_conventions", same)
        } else if builtin == Builtin::FragDepth {
            ("ARB_conservative_depth", before.is_none_or(|before| before.depth == now.depth))
        } else {
            self.check_layout(name, now);
            return;
        };
        let message = if !same {
            format!("`{}` has another layout in the declaration before", name.text)
        } else if used && before.is_none() {
            format!("`{}` is used before it is redeclared", name.text)
        } else {
            return;
        };
        self.log.push(Diagnostic::error(name.span, message).rule(rule));
    }

    /// Whether a built-in variable of type `known`, of which `min_len` elements are used, can be
    /// declared with type `ty`.
    pub(super) fn resizes(&self, known: &Type, ty: &Type, min_len: u32) -> bool {
        match (known, ty) {
            (Type::Array(a, limit), Type::Array(b, len)) => {
                let limit = limit.unwrap_or(MAX_CLIP_DISTANCES.into());
                a == b && len.is_none_or(|len| (min_len..=limit).contains(&len))
            }
            (known, ty) => known == ty,
        }
    }

    /// Only `gl_FragCoord` and `gl_FragDepth` have a layout.
    pub(super) fn check_layout(
        &mut self,
        name: &ast::Name,
        interface_qualifiers: InterfaceQualifiers,
    ) {
        if interface_qualifiers.depth.is_some() {
            let message = format!("`{}` has no such layout: only gl_FragDepth has one", name.text);
            self.log.push(Diagnostic::error(name.span, message).rule("ARB_conservative_depth"));
        }
        if interface_qualifiers.origin_upper_left || interface_qualifiers.pixel_center_integer {
            let message = format!("`{}` has no layout: only gl_FragCoord has one", name.text);
            let rule = "ARB_fragment_coord_conventions";
            self.log.push(Diagnostic::error(name.span, message).rule(rule));
        }
    }

    /// The unsized array that a redeclaration gives a size.
    pub(super) fn completes_array(
        &mut self,
        declared: &ast::Declarator,
        ty: &Type,
    ) -> Option<VarRef> {
        let Some(Symbol::Variable(var)) = self.scopes.find_innermost(&declared.name.text) else {
            return None;
        };
        let var = *var;
        let variable = self.variable(var);
        let (Type::Array(old, None), Type::Array(new, Some(len))) = (&variable.ty, ty) else {
            return None;
        };
        if old != new {
            return None;
        }
        if *len < variable.min_len {
            let (last, name) = (variable.min_len - 1, &declared.name);
            let message = format!("element {last} of `{}` is used already", name.text);
            self.error(name.span, "4.1.9", message);
        }
        self.variable_mut(var).ty = ty.clone();
        Some(var)
    }

    /// Counts an access with a constant index to an array, which has at least `len` elements.
    pub(super) fn note_constant_index(&mut self, var: VarRef, len: u32) {
        let variable = self.variable_mut(var);
        variable.constant_index_references += 1;
        variable.min_len = variable.min_len.max(len);
    }
}

/// Gives unsized arrays the size that their largest index needs. The linker enlarges a global if
/// another shader of the program needs more.
pub(super) fn settle_arrays(variables: &mut [Variable]) {
    for variable in variables {
        if let Type::Array(element, None) = &variable.ty {
            variable.ty = Type::Array(element.clone(), Some(variable.min_len.max(1)));
            variable.implicitly_sized = true;
        }
        let (inner_len, depth) = (variable.inner_min_len.max(1), variable.inner_depth());
        if let Some(len @ None) = variable.ty.inner_size_mut(depth) {
            *len = Some(inner_len);
            variable.inner_implicitly_sized = true;
        }
    }
}
