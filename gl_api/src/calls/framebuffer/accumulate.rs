//! `glAccum`: the accumulation buffer of the default framebuffer (GL 2.1, section 4.2.4). Its components are
//! `f32`; its memory is allocated when it is first used.

use crate::base::constants::*;
use crate::base::error::{ErrorCode, GlError, Result, Table, invalid_operation};
use crate::base::types::*;
use crate::calls::framebuffer::blit::update_attachment_texels;
use crate::calls::framebuffer::read::ReadBuffer;
use crate::context::Context;
use crate::context::feedback::RenderMode;
use crate::draw::completeness::{Aspect, draw_pass};
use crate::draw::pass::drawn_area;
use crate::pixel::convert::Conversion;
use rasterizer::driver::{Rect, SrgbWrite};
use texunit::lanes::LANES;

const SECTION: &str = "GL 2.1, section 4.2.4";

/// Bits of a component.
pub(crate) const BITS: i32 = 32;

/// What `glAccum` does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Operation {
    Accumulate,
    Load,
    Return,
    Multiply,
    Add,
}

const OPERATION: Table<Operation> = Table {
    section: SECTION,
    rows: &[
        (GL_ACCUM, Operation::Accumulate),
        (GL_LOAD, Operation::Load),
        (GL_RETURN, Operation::Return),
        (GL_MULT, Operation::Multiply),
        (GL_ADD, Operation::Add),
    ],
};

pub(crate) fn clear_accum(
    context: &mut Context,
    red: GLfloat,
    green: GLfloat,
    blue: GLfloat,
    alpha: GLfloat,
) -> Result<()> {
    context.state.clear.accumulation =
        [red, green, blue, alpha].map(|c| if c.is_nan() { 0.0 } else { c.clamp(-1.0, 1.0) });
    Ok(())
}

/// The sums of all pixels, row by row, which have memory from here on.
///
/// # Errors
/// If there is none.
fn all(context: &mut Context) -> Result<&mut Vec<[f32; 4]>> {
    let window = &mut context.window;
    let pixels = window.width as usize * window.height as usize;
    let sums = &mut window.accumulation.0;
    sums.try_reserve_exact(pixels.saturating_sub(sums.len())).map_err(|_| {
        let rule = format!("there is no memory for the sums of {pixels} pixels");
        GlError::new(ErrorCode::OutOfMemory, SECTION, rule)
    })?;
    sums.resize(pixels, [0.0; 4]);
    Ok(sums)
}

/// Changes the sums of the pixels of an area.
fn each(context: &mut Context, area: Rect, change: impl Fn(&mut [f32; 4])) -> Result<()> {
    let width = context.window.width as usize;
    let sums = all(context)?;
    for (y, x, count) in runs(area) {
        sums[y * width + x..][..count].iter_mut().for_each(&change);
    }
    Ok(())
}

/// Fills the buffer with its clear value, through the scissor rectangle; a framebuffer object has
/// none.
pub(crate) fn clear(context: &mut Context, area: Rect) -> Result<()> {
    if context.state.bindings.draw_framebuffer == 0 {
        let value = context.state.clear.accumulation;
        each(context, area, |sum| *sum = value)?;
    }
    Ok(())
}

pub(crate) fn accum(context: &mut Context, op: GLenum, value: GLfloat) -> Result<()> {
    let operation = OPERATION.decode("op", op)?;
    let pass = draw_pass(context)?;
    let bindings = &context.state.bindings;
    if bindings.draw_framebuffer != 0 || bindings.read_framebuffer != 0 {
        return invalid_operation(
            SECTION,
            "framebuffer objects have no accumulation buffer: call glBindFramebuffer(GL_FRAMEBUFFER, 0)",
        );
    }
    let area = drawn_area(context, &pass);
    if context.feedback.mode != RenderMode::Render || context.queries.discards() {
        return Ok(());
    }
    context.lists.charge_pixels(u64::from(area.width) * u64::from(area.height));
    match operation {
        Operation::Accumulate => colors(context, area, value, |sum, color| *sum += color),
        Operation::Load => colors(context, area, value, |sum, color| *sum = color),
        Operation::Multiply => each(context, area, |sum| *sum = sum.map(|c| c * value)),
        Operation::Add => each(context, area, |sum| *sum = sum.map(|c| c + value)),
        Operation::Return => return_sums(context, area, value),
    }
}

/// The rows of an area, in runs of up to 64 pixels: row, first column, and how many.
fn runs(area: Rect) -> impl Iterator<Item = (usize, usize, usize)> {
    let [x, y] = [area.x, area.y].map(|first| first as usize);
    let [width, height] = [area.width, area.height].map(|size| size as usize);
    let run = move |at: usize| (x + at, LANES.min(width - at));
    (y..y + height)
        .flat_map(move |y| (0..width).step_by(LANES).map(move |at| (y, run(at).0, run(at).1)))
}

/// Changes the sums of an area by its colours, which are read and taken times a factor.
fn colors(
    context: &mut Context,
    area: Rect,
    factor: f32,
    change: impl Fn(&mut f32, f32),
) -> Result<()> {
    let from = ReadBuffer::new(context, Aspect::Color)?.pixels(context)?;
    let isa = context.recorder.isa();
    let conversion = Conversion::blit(isa, from.format(), from.format(), SrgbWrite::AsIs);
    let width = context.window.width as usize;
    let sums = all(context)?;
    for (y, x, count) in runs(area) {
        let rgba = conversion.read(from.row(x, y, count));
        let sums = &mut sums[y * width + x..][..count];
        for (channel, numbers) in rgba.iter().enumerate() {
            for (sum, &number) in sums.iter_mut().zip(&numbers.0) {
                change(&mut sum[channel], number as f32 * factor);
            }
        }
    }
    Ok(())
}

/// Writes the sums times a factor to the colour buffer that is drawn to, clamped, through the mask.
fn return_sums(context: &mut Context, area: Rect, factor: f32) -> Result<()> {
    let pass = draw_pass(context)?;
    let mask = context.state.fragment.buffers[0].mask;
    let (isa, width) = (context.recorder.isa(), context.window.width as usize);
    let sums = std::mem::take(all(context)?);
    let result = pass.colors.iter().flatten().try_for_each(|attachment| {
        update_attachment_texels(context, attachment, |level, first, _| {
            let (format, size, row) = (level.format, level.format.bytes(), level.row_bytes());
            let conversion = Conversion::blit(isa, format, format, SrgbWrite::AsIs);
            for (y, x, count) in runs(area) {
                let texels = &mut level.texels[first + y * row + x * size..][..count * size];
                let mut rgba = conversion.read(texels);
                let sums = &sums[y * width + x..][..count];
                for (channel, numbers) in rgba.iter_mut().enumerate().filter(|(i, _)| mask[*i]) {
                    for (number, sum) in numbers.0.iter_mut().zip(sums) {
                        *number = f64::from(sum[channel] * factor).clamp(0.0, 1.0);
                    }
                }
                conversion.write(&rgba, texels);
            }
        })
    });
    context.window.accumulation.0 = sums;
    result
}
