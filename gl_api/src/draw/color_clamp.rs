//! Whether colours are clamped to [0, 1]: those of vertices, of fragments, and those that are read
//! (`ARB_color_buffer_float`).

use crate::base::clamp::Clamp;
use crate::context::Context;
use crate::draw::completeness::drawn_formats;
use texunit::format::{Encoding, Format};

/// Whether all buffers that are drawn to hold values in [0, 1], so that writing clamps.
pub(crate) fn draws_fractions(context: &Context) -> bool {
    drawn_formats(context).all(|format| format.info().encoding.range() == Some(Encoding::UNIT))
}

/// Whether colours of vertices are clamped now.
pub(crate) fn of_vertices(context: &Context) -> Clamp {
    context.state.clamp.vertex.now(drawn_formats(context))
}

/// Whether colours of fragments are clamped now.
pub(crate) fn of_fragments(context: &Context) -> Clamp {
    context.state.clamp.fragment.now(drawn_formats(context))
}

/// Whether colours of the state are clamped where they are asked for: OpenGL ES answers what was set (3.0, sections
/// 4.1.7 and 4.2.3).
pub(crate) fn of_queries(context: &Context) -> Clamp {
    if context.profile.is_es() { Clamp::Off } else { of_fragments(context) }
}

/// Whether colours that are read from a buffer of this format are clamped. Integers, depths and
/// stencils are no colours.
pub(crate) fn of_reading(context: &Context, format: Format) -> Clamp {
    if format.is_integer() || format.is_depth() {
        return Clamp::Off;
    }
    context.state.clamp.read.now(std::iter::once(format))
}
