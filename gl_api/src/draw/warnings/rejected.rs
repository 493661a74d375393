//! Warnings of fragments that all fail the stencil or the alpha test, or that blending leaves without effect.

use crate::base::compare::COMPARE;
use crate::base::constants::*;
use crate::context::Context;
use crate::context::warnings::DrawWarning;
use crate::draw::warnings::constant_color::ConstantColor;
use crate::generate::fixed::fragment::FragmentKey;
use crate::state::blend::FACTOR;
use rasterizer::driver::{BlendEquation, BlendFactor, PipelineDesc, StencilOp};
use texunit::sampler::Compare;

/// Checks the stencil test of a draw.
pub(crate) fn stencil(context: &mut Context, desc: &PipelineDesc) {
    let Some(stencil) = &desc.output.stencil else { return };
    let faces = [&stencil.front, &stencil.back];
    let never = faces.iter().all(|face| {
        face.test == Compare::Never && (face.fail == StencilOp::Keep || face.write_mask == 0)
    });
    if never {
        say(context, DrawWarning::StencilFails, NEVER);
        return;
    }
    if context.state.bindings.draw_framebuffer != 0 {
        return;
    }
    if let Some(stored) = context.window.stencils.draw(faces)
        && context.is_first_warning(DrawWarning::StencilFails, 0)
    {
        let face = faces[0];
        let func = enum_name(COMPARE.encode(face.test));
        context.debug.warn(format!(
            "draw: glStencilFunc({func}, {}, {:#x}) passes nowhere, as every stencil is {stored}: none was drawn since \
             glClear: write them before, with glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE) and glStencilMask(0xff), or \
             call glDisable(GL_STENCIL_TEST) (GL 2.1, section 4.1.5)",
            face.reference, face.read_mask
        ));
    }
}

const NEVER: &str = "draw: GL_STENCIL_TEST is enabled, glStencilFunc has GL_NEVER and glStencilOp keeps what fails, so \
    nothing changes: call glStencilFunc(GL_ALWAYS, 0, 0xff), or glDisable(GL_STENCIL_TEST) (GL 2.1, section 4.1.5)";

#[cold]
#[inline(never)]
fn say(context: &mut Context, warning: DrawWarning, text: &str) {
    if context.is_first_warning(warning, 0) {
        context.debug.warn(text.to_owned());
    }
}

/// Checks the alpha test of a draw. `color` is that of all fragments, if it is known.
pub(crate) fn alpha(context: &mut Context, color: Option<&ConstantColor>) {
    let Some(test) = crate::draw::alpha_test::alpha_test(context) else { return };
    let reference = context.state.fragment.alpha_ref;
    // Alpha is clamped to [0, 1], so it may never be on one side of the reference.
    let (low, high) = match color.and_then(ConstantColor::alpha) {
        Some(alpha) => (alpha, alpha),
        None => (0.0, 1.0),
    };
    let fails = match test {
        Compare::Never => true,
        Compare::Less => low >= reference,
        Compare::LessEqual => low > reference,
        Compare::Greater => high <= reference,
        Compare::GreaterEqual => high < reference,
        Compare::Equal => high < reference || low > reference,
        Compare::NotEqual => low == high && low == reference,
        Compare::Always => false,
    };
    if fails && context.is_first_warning(DrawWarning::AlphaFails, 0) {
        let func = enum_name(COMPARE.encode(test));
        let alpha = match low == high {
            true => format!("every fragment has alpha {low}"),
            false => "alpha is 0 to 1".to_owned(),
        };
        context.debug.warn(format!(
            "draw: GL_ALPHA_TEST is enabled with glAlphaFunc({func}, {reference}), and {alpha}, so every fragment \
             is rejected: call glAlphaFunc with another reference, or glDisable(GL_ALPHA_TEST) (GL 2.1, section \
             4.1.4)"
        ));
    }
}

/// Checks the blending of a draw whose fragments have a constant colour.
pub(crate) fn blending(context: &mut Context, desc: &PipelineDesc, color: &ConstantColor) {
    let Some(blend) = desc.colors.first().and_then(|color| color.blend.as_ref()) else { return };
    let keeps = blend.src[0] == BlendFactor::SrcAlpha
        && matches!(blend.dst[0], BlendFactor::OneMinusSrcAlpha | BlendFactor::One)
        && blend.equation[0] == BlendEquation::Add;
    if keeps && color.has_no_alpha() && context.is_first_warning(DrawWarning::NoAlpha, 0) {
        let src = enum_name(FACTOR.encode(blend.src[0]));
        let dst = enum_name(FACTOR.encode(blend.dst[0]));
        context.debug.warn(format!(
            "draw: GL_BLEND is enabled with glBlendFunc({src}, {dst}), and the current colour has alpha 0, so nothing \
             is seen: call glColor4f with an alpha above 0, such as glColor4f(1, 1, 1, 1), or glDisable(GL_BLEND) (GL \
             2.1, section 4.1.8)"
        ));
    }
}

/// Checks a textured draw of the fixed function whose colour is black.
pub(crate) fn black(
    context: &mut Context,
    desc: &PipelineDesc,
    fragment: &FragmentKey,
    color: &ConstantColor,
) {
    let blends = desc.colors.iter().any(|color| color.blend.is_some());
    if blends || fragment.color_sum || !color.blackens() {
        return;
    }
    let Some(unit) = fragment.units.first().map(|unit| unit.unit) else { return };
    if context.is_first_warning(DrawWarning::BlackModulate, 0) {
        let [r, g, b, _] = color.color;
        context.debug.warn(format!(
            "draw: the current colour is ({r}, {g}, {b}), and GL_TEXTURE_ENV_MODE of unit {unit} is GL_MODULATE, which \
             multiplies the texture by it, so it is black: call glColor3f(1, 1, 1), or glTexEnvi(GL_TEXTURE_ENV, \
             GL_TEXTURE_ENV_MODE, GL_REPLACE) (GL 2.1, section 3.8.13)"
        ));
    }
}
