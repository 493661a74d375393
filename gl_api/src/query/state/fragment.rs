//! Per-fragment operations: GL 2.1, table 6.21.

use super::row::Read::*;
use super::row::{Row, doubles, rows};
use crate::base::compare::COMPARE;
use crate::base::constants::*;
use crate::base::types::*;
use crate::calls::fragment::clamp::WHEN;
use crate::calls::framebuffer::buffers::drawn_format;
use crate::context::Context;
use crate::draw::color_clamp::{of_fragments, of_queries};
use crate::pixel::component_bits::{Component, component_bits};
use crate::state::draw_buffers::LOGIC_OP;
use crate::state::stencil::{ACTIVE_FACE, Face, STENCIL_OP, Side};

/// Of the face that `EXT_stencil_two_side` has made active; else of front faces.
fn front(context: &Context) -> &Face {
    context.state.fragment.stencil.active()
}

fn back(context: &Context) -> &Face {
    &context.state.fragment.stencil.faces[Side::Back as usize]
}

/// The reference of the stencil test: kept as it was given, and clamped to the bits of the buffer where it is
/// compared and where it is asked for (section 4.1.4).
fn reference(context: &Context, face: &Face) -> i32 {
    let format = drawn_format(context, Component::Stencil);
    let bits = format.map_or(0, |format| component_bits(format, Component::Stencil));
    face.reference.clamp(0, (1 << bits) - 1)
}

/// A part of the blend formula of the first draw buffer.
fn formula(context: &Context, pname: GLenum) -> GLenum {
    context.state.fragment.buffers[0].formula.get(pname).unwrap_or_default()
}

pub(super) const ROWS: &[Row] = rows! {
    GL_SCISSOR_TEST: Enabled;
    GL_SCISSOR_BOX: Integers(|c| {
        let area = c.state.fragment.scissor.first;
        vec![area.x, area.y, area.width as i32, area.height as i32]
    });
    GL_ALPHA_TEST: Enabled;
    GL_ALPHA_TEST_FUNC: Word(|c| COMPARE.encode(c.state.fragment.alpha_func));
    GL_ALPHA_TEST_REF:
        Fractions(|c| doubles(&[of_fragments(c).component(c.state.fragment.alpha_ref)]));

    GL_STENCIL_TEST: Enabled;
    GL_STENCIL_FUNC: Word(|c| COMPARE.encode(front(c).func));
    GL_STENCIL_REF: Integer(|c| reference(c, front(c)));
    GL_STENCIL_VALUE_MASK: Word(|c| front(c).value_mask);
    GL_STENCIL_FAIL: Word(|c| STENCIL_OP.encode(front(c).fail));
    GL_STENCIL_PASS_DEPTH_FAIL: Word(|c| STENCIL_OP.encode(front(c).depth_fail));
    GL_STENCIL_PASS_DEPTH_PASS: Word(|c| STENCIL_OP.encode(front(c).pass));
    GL_STENCIL_BACK_FUNC: Word(|c| COMPARE.encode(back(c).func));
    GL_STENCIL_BACK_REF: Integer(|c| reference(c, back(c)));
    GL_STENCIL_BACK_VALUE_MASK: Word(|c| back(c).value_mask);
    GL_STENCIL_BACK_FAIL: Word(|c| STENCIL_OP.encode(back(c).fail));
    GL_STENCIL_BACK_PASS_DEPTH_FAIL: Word(|c| STENCIL_OP.encode(back(c).depth_fail));
    GL_STENCIL_BACK_PASS_DEPTH_PASS: Word(|c| STENCIL_OP.encode(back(c).pass));
    GL_STENCIL_TEST_TWO_SIDE_EXT: Enabled;
    GL_ACTIVE_STENCIL_FACE_EXT: Word(|c| ACTIVE_FACE.encode(c.state.fragment.stencil.active));
    GL_STENCIL_WRITEMASK: Word(|c| front(c).write_mask);
    GL_STENCIL_BACK_WRITEMASK: Word(|c| back(c).write_mask);

    GL_DEPTH_TEST: Enabled;
    GL_DEPTH_FUNC: Word(|c| COMPARE.encode(c.state.fragment.depth_func));

    GL_BLEND: Enabled;
    GL_BLEND_SRC: Word(|c| formula(c, GL_BLEND_SRC));
    GL_BLEND_SRC_RGB: Word(|c| formula(c, GL_BLEND_SRC_RGB));
    GL_BLEND_SRC_ALPHA: Word(|c| formula(c, GL_BLEND_SRC_ALPHA));
    GL_BLEND_DST: Word(|c| formula(c, GL_BLEND_DST));
    GL_BLEND_DST_RGB: Word(|c| formula(c, GL_BLEND_DST_RGB));
    GL_BLEND_DST_ALPHA: Word(|c| formula(c, GL_BLEND_DST_ALPHA));
    // The same name as GL_BLEND_EQUATION_RGB.
    GL_BLEND_EQUATION: Word(|c| formula(c, GL_BLEND_EQUATION));
    GL_BLEND_EQUATION_ALPHA: Word(|c| formula(c, GL_BLEND_EQUATION_ALPHA));
    GL_BLEND_COLOR: Fractions(|c| doubles(&of_queries(c).color(c.state.fragment.blend_color)));
    GL_FRAMEBUFFER_SRGB: Enabled;
    GL_DITHER: Enabled;
    GL_INDEX_LOGIC_OP: Enabled;
    GL_COLOR_LOGIC_OP: Enabled;
    GL_LOGIC_OP_MODE: Word(|c| LOGIC_OP.encode(c.state.fragment.logic_op));
    GL_CLAMP_FRAGMENT_COLOR: Word(|c| WHEN.encode(c.state.clamp.fragment));
    GL_CLAMP_READ_COLOR: Word(|c| WHEN.encode(c.state.clamp.read));
};
