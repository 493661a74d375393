//! The types of variables that pass between stages (GLSL 1.30 sections 4.3.4 to 4.3.6).

use super::Checker;
use crate::hir::Storage;
use crate::language::{Availability, Version};
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::types::{Scalar, Type};
use rasterizer::ir::{Interpolation, Stage};

impl Checker<'_> {
    /// The types that may pass between the stages (GLSL 1.30 sections 4.3.4 to 4.3.6).
    pub(super) fn check_interface_type(&mut self, storage: Storage, ty: &Type, span: Span) {
        let integer =
            |ty: &Type| ty.any(&|part| matches!(part, Type::Vector(Scalar::Int | Scalar::Uint, _)));
        let boolean = ty.any(&|part| matches!(part, Type::Vector(Scalar::Bool, _)));
        let structure = ty.any(&|part| matches!(part, Type::Struct(_)));
        let old = !self.language.has(Availability::INTEGERS);
        let wrong = match storage {
            Storage::Attribute => {
                let array = ty.has_array() && !self.language.has(Availability::V150);
                if boolean || structure || array || (old && integer(ty)) {
                    Some("a vertex attribute is a float, a vector or a matrix of floats")
                } else {
                    None
                }
            }
            Storage::Output(interpolation) | Storage::Input(interpolation) => {
                let has_structures =
                    self.language.has(Availability::V150) || self.version == Version::Es300;
                let structure = structure && !has_structures;
                let nested = self.version == Version::Es300 && is_nested(ty);
                let read = matches!(storage, Storage::Input(_)) && self.stage == Stage::Fragment;
                // GLSL ES 3.00 section 4.3.6: of outputs too.
                let read = read || self.version == Version::Es300;
                if boolean || structure || (old && integer(ty)) {
                    Some("what passes between the stages is made of floats")
                } else if nested {
                    Some(
                        "no arrays of structures, nor structures with arrays or structures, pass between the stages",
                    )
                } else if integer(ty) && interpolation != Interpolation::Flat && read {
                    Some("integers that pass between the stages are `flat`")
                } else {
                    None
                }
            }
            Storage::FragmentOutput => {
                let element = ty.base();
                let fits = *element == Type::Error
                    || matches!(element, Type::Vector(scalar, _) if *scalar != Scalar::Bool);
                (!fits).then_some("an output of the fragment stage is a scalar or a vector")
            }
            Storage::Plain
            | Storage::Const
            | Storage::Uniform
            | Storage::Parameter(_)
            | Storage::Builtin(_) => None,
        };
        if let Some(message) = wrong {
            let rule = format!("{} section 4.3", self.version.title());
            self.log.push(Diagnostic::error(span, format!("{message}; this is {ty}")).rule(rule));
        }
    }
}

/// Whether a type is an array of structures, or a structure with an array or a structure in it (GLSL ES 3.00 sections
/// 4.3.4 and 4.3.6).
fn is_nested(ty: &Type) -> bool {
    match ty {
        Type::Array(element, _) => matches!(**element, Type::Struct(_)),
        Type::Struct(structure) => structure
            .fields
            .iter()
            .any(|(_, field)| matches!(field, Type::Array(..) | Type::Struct(_))),
        Type::Void | Type::Vector(..) | Type::Matrix(..) | Type::Sampler(_) | Type::Error => false,
    }
}
