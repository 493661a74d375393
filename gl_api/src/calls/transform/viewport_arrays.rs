//! Viewports, depth ranges and scissor rectangles by number (ARB_viewport_array).

use crate::base::convert::unit;
use crate::base::error::{Result, invalid_value, not_negative};
use crate::base::limits;
use crate::base::types::*;
use crate::context::Context;
use crate::state::viewport::Viewport;
use rasterizer::driver::{MAX_VIEWPORTS, Rect};
use std::ops::Range;

const VIEWPORTS: &str = "ARB_viewport_array, section 2.11.1";
const SCISSORS: &str = "ARB_viewport_array, section 4.1.2";

/// The number of a viewport.
pub(crate) fn viewport_index(argument: &str, index: GLuint) -> Result<usize> {
    match usize::try_from(index) {
        Ok(index) if index < MAX_VIEWPORTS => Ok(index),
        _ => invalid_value(
            VIEWPORTS,
            format!("{argument} = {index} must be below GL_MAX_VIEWPORTS, {MAX_VIEWPORTS}"),
        ),
    }
}

/// The numbers of `count` viewports.
fn viewports(first: GLuint, count: GLsizei) -> Result<Range<usize>> {
    let count = not_negative(VIEWPORTS, "count", count.into())?;
    let first = first as usize;
    match first.checked_add(count) {
        Some(end) if end <= MAX_VIEWPORTS => Ok(first..end),
        _ => invalid_value(
            VIEWPORTS,
            format!(
                "first = {first} and count = {count}: their sum must not be above GL_MAX_VIEWPORTS, \
                 {MAX_VIEWPORTS}"
            ),
        ),
    }
}

/// The `N` values of each viewport.
fn each<const N: usize, T: Copy>(
    argument: &str,
    values: &[T],
    count: usize,
) -> Result<Vec<[T; N]>> {
    let (each, _) = values.as_chunks::<N>();
    match each.get(..count) {
        Some(each) => Ok(each.to_vec()),
        None => {
            let (has, needed) = (values.len(), count * N);
            invalid_value(VIEWPORTS, format!("{argument} has {has} values, of {needed}"))
        }
    }
}

/// Checks the sides of a viewport; gives how they are kept.
fn sides([x, y, width, height]: [GLfloat; 4]) -> Result<[f32; 4]> {
    for (name, size) in [("width", width), ("height", height)] {
        if size < 0.0 {
            let rule = format!("{name} = {size} must not be negative");
            return invalid_value(VIEWPORTS, rule);
        }
    }
    let limit = limits::MAX_VIEWPORT_DIMS as f32;
    // A NaN is 0, which draws nothing.
    let within = |side: f32, low: f32, high: f32| match side.is_nan() {
        true => 0.0,
        false => side.clamp(low, high),
    };
    let place = |side| within(side, -2.0 * limit, 2.0 * limit);
    Ok([place(x), place(y), within(width, 0.0, limit), within(height, 0.0, limit)])
}

fn set_viewport(context: &mut Context, viewport: usize, [x, y, width, height]: [f32; 4]) {
    let set = |own: &mut Viewport| *own = Viewport { x, y, width, height, depth: own.depth };
    context.state.viewport.change(viewport, set);
}

pub(crate) fn viewport_arrayv(
    context: &mut Context,
    first: GLuint,
    count: GLsizei,
    v: &[GLfloat],
) -> Result<()> {
    let range = viewports(first, count)?;
    let all = each("v", v, range.len())?.into_iter().map(sides).collect::<Result<Vec<_>>>()?;
    range.zip(all).for_each(|(viewport, sides)| set_viewport(context, viewport, sides));
    Ok(())
}

pub(crate) fn viewport_indexedf(
    context: &mut Context,
    index: GLuint,
    x: GLfloat,
    y: GLfloat,
    w: GLfloat,
    h: GLfloat,
) -> Result<()> {
    let index = viewport_index("index", index)?;
    let sides = sides([x, y, w, h])?;
    set_viewport(context, index, sides);
    Ok(())
}

pub(crate) fn viewport_indexedfv(
    context: &mut Context,
    index: GLuint,
    v: &[GLfloat],
) -> Result<()> {
    viewport_arrayv(context, viewport_index("index", index)? as GLuint, 1, v)
}

pub(crate) fn depth_range_arrayv(
    context: &mut Context,
    first: GLuint,
    count: GLsizei,
    v: &[GLdouble],
) -> Result<()> {
    let range = viewports(first, count)?;
    let all = each::<2, _>("v", v, range.len())?;
    for (viewport, depths) in range.zip(all) {
        context.state.viewport.change(viewport, |own| own.depth = depths.map(unit));
    }
    Ok(())
}

pub(crate) fn depth_range_indexed(
    context: &mut Context,
    index: GLuint,
    n: GLdouble,
    f: GLdouble,
) -> Result<()> {
    depth_range_arrayv(context, viewport_index("index", index)? as GLuint, 1, &[n, f])
}

/// Checks a scissor rectangle.
fn rectangle([x, y, width, height]: [GLint; 4]) -> Result<Rect> {
    not_negative(SCISSORS, "width", width.into())?;
    not_negative(SCISSORS, "height", height.into())?;
    Ok(Rect { x, y, width: width as u32, height: height as u32 })
}

pub(crate) fn scissor_arrayv(
    context: &mut Context,
    first: GLuint,
    count: GLsizei,
    v: &[GLint],
) -> Result<()> {
    let range = viewports(first, count)?;
    let all = each("v", v, range.len())?.into_iter().map(rectangle).collect::<Result<Vec<_>>>()?;
    for (viewport, area) in range.zip(all) {
        context.state.fragment.scissor.change(viewport, |own| *own = area);
    }
    Ok(())
}

pub(crate) fn scissor_indexed(
    context: &mut Context,
    index: GLuint,
    left: GLint,
    bottom: GLint,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    let first = viewport_index("index", index)? as GLuint;
    scissor_arrayv(context, first, 1, &[left, bottom, width, height])
}

pub(crate) fn scissor_indexedv(context: &mut Context, index: GLuint, v: &[GLint]) -> Result<()> {
    scissor_arrayv(context, viewport_index("index", index)? as GLuint, 1, v)
}
