//! State that is enabled and has no effect on a draw. It is left at its default: nothing is done for it, and draws with
//! and without it share shaders and pipelines.

use crate::base::clamp::Clamp;
use crate::context::Context;
use crate::draw::color_clamp::{draws_fractions, of_fragments};
use crate::interface::ATTRIB_SECONDARY_COLOR;
use crate::state::blend::Formula;
use crate::state::enable::Flag;
use crate::state::fog::FogMode;
use crate::state::light::Light;
use rasterizer::driver::{Blend, Cull, LeaveOut, LogicOp, Stipple, VertexBinding, VertexSource};
use texunit::sampler::Compare;

/// Whether what has no effect is left out: unless the device leaves out nothing.
pub(crate) fn leaves_out(context: &Context) -> bool {
    context.recorder.leave_out() == LeaveOut::WithoutEffect
}

/// The blending by a formula, unless it gives the source: `1·s + 0·d`, also by an alpha that is 1. Buffers of floats and
/// of signed numbers keep it: zero times infinity is no number, and a sum with zero is no negative zero.
pub(crate) fn blend(context: &Context, formula: Formula) -> Option<Blend> {
    let blend = formula.to_driver(context.state.fragment.blend_color);
    let replaces =
        formula == Formula::REPLACE || context.recorder.is_opaque && blend.replaces_where_opaque();
    let is_off = leaves_out(context) && replaces && draws_fractions(context);
    (!is_off).then_some(blend)
}

/// The logical operation, unless it gives the source.
pub(crate) fn logic_op(context: &Context, op: LogicOp) -> Option<LogicOp> {
    (op != LogicOp::Copy || !leaves_out(context)).then_some(op)
}

/// The stipple of polygons, unless it leaves every fragment.
pub(crate) fn stipple(context: &Context) -> Option<Stipple> {
    let pattern = context.state.raster.polygons.stipple;
    let is_off = leaves_out(context) && pattern.iter().all(|row| *row == u32::MAX);
    (!is_off).then_some(Stipple::Pattern(pattern))
}

/// Whether a draw may show back faces, which may have colours of their own.
pub(crate) fn shows_back_faces(context: &Context) -> bool {
    let culls = context.state.enables.has(Flag::CullFace);
    let is_culled = match context.state.raster.cull {
        Cull::Back | Cull::Both => culls,
        Cull::None | Cull::Front => false,
    };
    !is_culled || !leaves_out(context)
}

/// Whether the fixed function gives back faces, which a draw may show, colours of their own (GL 2.1, section 2.14.1).
pub(crate) fn lights_two_sides(context: &Context) -> bool {
    let state = &context.state;
    state.enables.has(Flag::Lighting) && state.lights.model.two_side && shows_back_faces(context)
}

/// Whether fog leaves every colour: its factor is `exp(0)` at any distance.
pub(crate) fn fog(context: &Context) -> bool {
    let fog = &context.state.fog;
    leaves_out(context)
        && fog.density == 0.0
        && match fog.mode {
            FogMode::Exp | FogMode::Exp2 => true,
            FogMode::Linear => false,
        }
}

/// Whether a light adds nothing to any material: all its colours are black.
pub(crate) fn light(context: &Context, light: &Light) -> bool {
    let colors = [light.ambient, light.diffuse, light.specular];
    leaves_out(context)
        && colors.into_iter().all(|[red, green, blue, _]| is_black([red, green, blue]))
}

/// Whether the secondary colour of a draw adds nothing: it is black at all vertices. Buffers of floats and of signed
/// numbers show the sum with zero: it is no negative zero.
pub(crate) fn color_sum(context: &Context, vertices: &[VertexBinding]) -> bool {
    let is_black = |binding: &VertexBinding| match binding.source {
        VertexSource::Constant([red, green, blue, _]) => is_black([red, green, blue]),
        VertexSource::Array { .. } => false,
    };
    let mut bindings = vertices.iter();
    let secondary = bindings.find(|binding| binding.location == ATTRIB_SECONDARY_COLOR);
    leaves_out(context) && secondary.is_some_and(is_black) && draws_fractions(context)
}

/// Whether a colour is black.
pub(crate) fn is_black(color: [f32; 3]) -> bool {
    color == [0.0; 3]
}

/// Whether an alpha test passes for every fragment. Clamped alpha is a number in [0, 1], also where the shader gave
/// none (GL 2.1, section 4.1.4; the clamp makes it 0).
pub(crate) fn passes_all(context: &Context, compare: Compare) -> bool {
    let reference = context.state.fragment.alpha_ref;
    let is_clamped = || leaves_out(context) && of_fragments(context) == Clamp::On;
    match compare {
        Compare::Always => leaves_out(context),
        Compare::GreaterEqual => reference <= 0.0 && is_clamped(),
        Compare::LessEqual => reference >= 1.0 && is_clamped(),
        Compare::Never | Compare::Less | Compare::Equal | Compare::Greater | Compare::NotEqual => {
            false
        }
    }
}
