//! `layout(binding = n)` of samplers and uniform blocks (ARB_shading_language_420pack, section
//! 4.4.5).

use super::Checker;
use crate::hir::{InterfaceQualifiers, Storage};
use crate::limits::{MAX_COMBINED_TEXTURE_IMAGE_UNITS, MAX_UNIFORM_BUFFER_BINDINGS};
use crate::text::diagnostics::Diagnostic;
use crate::text::source::Span;
use crate::types::Type;

const RULE: &str = "ARB_shading_language_420pack, section 4.4.5";

impl Checker<'_> {
    /// Checks the binding of a variable: only samplers and uniform blocks have one.
    pub(super) fn check_binding(
        &mut self,
        storage: Storage,
        ty: &Type,
        qualifiers: InterfaceQualifiers,
    ) {
        let Some((binding, span)) = qualifiers.binding else { return };
        if storage != Storage::Uniform || !matches!(ty.base(), Type::Sampler(_)) {
            let message = "only samplers and uniform blocks have a binding";
            self.log.push(Diagnostic::error(span, message).rule(RULE));
            return;
        }
        let units = u32::from(MAX_COMBINED_TEXTURE_IMAGE_UNITS);
        self.check_bindings((binding, span), ty.scalars(), units, "texture units");
    }

    /// Checks the binding of a uniform block of this many instances.
    pub(super) fn check_block_binding(&mut self, binding: (u32, Span), instances: u32) {
        let points = MAX_UNIFORM_BUFFER_BINDINGS as u32;
        self.check_bindings(binding, instances, points, "bindings of uniform buffers");
    }

    fn check_bindings(&mut self, (first, span): (u32, Span), count: u32, limit: u32, what: &str) {
        if first.saturating_add(count.max(1)) > limit {
            let message = match count {
                0 | 1 => format!("binding {first}: there are {limit} {what}"),
                _ => format!("{count} bindings from {first} on: there are {limit} {what}"),
            };
            self.log.push(Diagnostic::error(span, message).rule(RULE));
        }
    }
}
