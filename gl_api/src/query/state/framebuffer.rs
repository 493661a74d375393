//! Framebuffer control and the properties of the framebuffer: GL 2.1, tables 6.22 and 6.40;
//! `ARB_framebuffer_object`.

use super::row::Read::*;
use super::row::{Row, doubles, rows};
use crate::base::constants::*;
use crate::base::types::*;
use crate::calls::fragment::clamp::signed_components;
use crate::calls::framebuffer::accumulate::BITS;
use crate::calls::framebuffer::buffers::{drawn_format, selection};
use crate::calls::framebuffer::read::preferred;
use crate::context::Context;
use crate::context::window::format_of;
use crate::draw::color_clamp::of_queries;
use crate::draw::completeness::{Aspect, drawn_formats, read_attachment, samples};
use crate::objects::color_buffers::Selection;
use crate::pixel::component_bits::{Component, component_bits};
use rasterizer::driver::DepthWrite;
use texunit::format::{Encoding, Format};

/// Of the framebuffer that is drawn to.
fn drawn(context: &Context) -> &Selection {
    selection(context, context.state.bindings.draw_framebuffer)
}

fn bits(context: &Context, component: Component) -> i32 {
    drawn_format(context, component).map_or(0, |format| component_bits(format, component))
}

/// The window has an accumulation buffer, framebuffer objects do not.
fn accumulation_bits(context: &Context) -> i32 {
    if context.state.bindings.draw_framebuffer == 0 { BITS } else { 0 }
}

fn sample_count(context: &Context) -> i32 {
    samples(context, context.state.bindings.draw_framebuffer).into()
}

/// Whether the first buffer that is drawn to is there and has such a format.
fn is_drawn(context: &Context, has: fn(Format) -> bool) -> bool {
    drawn_format(context, Component::Red).is_some_and(has)
}

/// The pixels that the colour buffer of the read framebuffer is best read as.
fn preferred_pixels(context: &Context) -> (GLenum, GLenum) {
    let attachment = read_attachment(context, Aspect::Color).ok().flatten();
    attachment.and_then(|found| format_of(&found)).map_or((GL_RGBA, GL_UNSIGNED_BYTE), preferred)
}

pub(super) const ROWS: &[Row] = rows! {
    GL_DRAW_BUFFER: Word(|c| drawn(c).draw[0]);
    GL_DRAW_BUFFER0: Word(|c| drawn(c).draw[0]);
    GL_DRAW_BUFFER1: Word(|c| drawn(c).draw[1]);
    GL_DRAW_BUFFER2: Word(|c| drawn(c).draw[2]);
    GL_DRAW_BUFFER3: Word(|c| drawn(c).draw[3]);
    GL_DRAW_BUFFER4: Word(|c| drawn(c).draw[4]);
    GL_DRAW_BUFFER5: Word(|c| drawn(c).draw[5]);
    GL_DRAW_BUFFER6: Word(|c| drawn(c).draw[6]);
    GL_DRAW_BUFFER7: Word(|c| drawn(c).draw[7]);
    GL_READ_BUFFER: Word(|c| selection(c, c.state.bindings.read_framebuffer).read);
    GL_FRAMEBUFFER_BINDING: Word(|c| c.state.bindings.draw_framebuffer);
    GL_READ_FRAMEBUFFER_BINDING: Word(|c| c.state.bindings.read_framebuffer);
    GL_RENDERBUFFER_BINDING: Word(|c| c.state.bindings.renderbuffer.name());

    // Colour index mode: kept and answered, without effect.
    GL_INDEX_WRITEMASK: Word(|c| c.state.fragment.index_mask);
    GL_COLOR_WRITEMASK: Flags(|c| c.state.fragment.buffers[0].mask);
    GL_DEPTH_WRITEMASK: Flag(|c| c.state.fragment.depth_write == DepthWrite::On);
    GL_COLOR_CLEAR_VALUE:
        Fractions(|c| doubles(&of_queries(c).color(c.state.clear.color.floats())));
    GL_INDEX_CLEAR_VALUE: Float(|c| c.state.clear.index);
    GL_DEPTH_CLEAR_VALUE: Fractions(|c| vec![c.state.clear.depth]);
    GL_STENCIL_CLEAR_VALUE: Integer(|c| c.state.clear.stencil);
    GL_ACCUM_CLEAR_VALUE: Fractions(|c| doubles(&c.state.clear.accumulation));

    GL_RED_BITS: Integer(|c| bits(c, Component::Red));
    GL_GREEN_BITS: Integer(|c| bits(c, Component::Green));
    GL_BLUE_BITS: Integer(|c| bits(c, Component::Blue));
    GL_ALPHA_BITS: Integer(|c| bits(c, Component::Alpha));
    GL_DEPTH_BITS: Integer(|c| bits(c, Component::Depth));
    GL_STENCIL_BITS: Integer(|c| bits(c, Component::Stencil));
    GL_INDEX_BITS: Integer(|_| 0);
    GL_ACCUM_RED_BITS: Integer(accumulation_bits);
    GL_ACCUM_GREEN_BITS: Integer(accumulation_bits);
    GL_ACCUM_BLUE_BITS: Integer(accumulation_bits);
    GL_ACCUM_ALPHA_BITS: Integer(accumulation_bits);
    GL_SAMPLES: Integer(sample_count);
    GL_SAMPLE_BUFFERS: Integer(|c| i32::from(sample_count(c) > 0));
    GL_RGBA_MODE: Flag(|_| true);
    GL_INDEX_MODE: Flag(|_| false);
    GL_DOUBLEBUFFER: Flag(|_| false);
    GL_STEREO: Flag(|_| false);
    GL_AUX_BUFFERS: Integer(|_| 0);
    GL_RGBA_FLOAT_MODE_ARB:
        Flag(|c| drawn_formats(c).any(|format: Format| format.info().encoding == Encoding::Float));
    GL_RGBA_INTEGER_MODE_EXT: Flag(|c| is_drawn(c, Format::is_integer));
    GL_RGBA_SIGNED_COMPONENTS_EXT:
        Flags(|c| drawn_format(c, Component::Red).map_or([false; 4], signed_components));
    GL_FRAMEBUFFER_SRGB_CAPABLE_EXT: Flag(|c| is_drawn(c, Format::is_srgb));
    GL_IMPLEMENTATION_COLOR_READ_FORMAT: Word(|c| preferred_pixels(c).0);
    GL_IMPLEMENTATION_COLOR_READ_TYPE: Word(|c| preferred_pixels(c).1);
};
