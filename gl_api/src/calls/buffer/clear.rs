//! `glClearBufferData` and `glClearBufferSubData`: one value all over a buffer (`ARB_clear_buffer_object`).

use crate::base::args::Data;
use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum, invalid_operation, invalid_value};
use crate::base::types::*;
use crate::calls::buffer::data::binding;
use crate::calls::texture::specify::kinds_match;
use crate::context::Context;
use crate::objects::bound::Bound;
use crate::objects::buffers::{BUFFER_TARGET, range};
use crate::pixel::client::Pixel;
use crate::pixel::formats;
use crate::pixel::one_texel::one_texel;

const SECTION: &str = "ARB_clear_buffer_object, section 2.9.X";

/// The buffer that is bound to a target.
fn bound(context: &mut Context, target: GLenum) -> Result<Bound> {
    let bound = binding(context, BUFFER_TARGET.decode("target", target)?).clone();
    match context.objects.shared.buffers.bound(&bound) {
        Some(_) => Ok(bound),
        None => invalid_value(
            SECTION,
            format!("no buffer is bound to {}: call glBindBuffer", enum_name(target)),
        ),
    }
}

/// Clears a range, or the whole buffer.
pub(crate) fn clear(
    context: &mut Context,
    (bound, internal): (&Bound, GLenum),
    part: Option<(GLintptr, GLsizeiptr)>,
    (format, ty): (GLenum, GLenum),
    data: Data<'_>,
) -> Result<()> {
    let isa = context.recorder.isa();
    let (recorder, shared) = (&mut context.recorder, &mut context.objects.shared);
    let Some(object) = shared.buffers.bound_mut(bound) else { return Ok(()) };
    let row = formats::find(internal).filter(|format| format.is_for_texel_buffers());
    let Some(stored) = row.map(|format| format.stored) else {
        let internal = enum_name(internal);
        return invalid_enum(
            SECTION,
            format!("internalformat = {internal} must be one of buffer textures, as GL_RGBA8"),
        );
    };
    let range = match part {
        None => 0..object.len(),
        Some((offset, size)) => range(object, offset, size)?,
    };
    let mapped = object.map.as_ref().filter(|map| !map.is_persistent());
    let mapped = mapped.map(|map| map.range.clone());
    if let Some(mapped) = mapped
        .filter(|mapped| part.is_none() || range.start < mapped.end && mapped.start < range.end)
    {
        return invalid_operation(
            SECTION,
            format!("bytes {range:?} are cleared, and {mapped:?} are mapped: call glUnmapBuffer"),
        );
    }
    let bytes = stored.bytes();
    if !range.start.is_multiple_of(bytes) || !range.len().is_multiple_of(bytes) {
        let (offset, size) = (range.start, range.len());
        return invalid_value(
            SECTION,
            format!(
                "offset = {offset} and size = {size} must be multiples of the texel's {bytes} bytes"
            ),
        );
    }
    let pixel = Pixel::new(format, ty)?;
    kinds_match(pixel, stored, GL_NONE)?;
    let texel = one_texel(isa, SECTION, stored, pixel, data)?;
    let fill = |to: &mut [u8]| {
        to.chunks_exact_mut(bytes).for_each(|to| to.copy_from_slice(&texel));
    };
    match &mut object.map {
        Some(map) if !map.is_persistent() => fill(&mut map.bytes[range]),
        Some(_) | None => return object.write(recorder, range, fill),
    }
    Ok(())
}

pub(crate) fn clear_buffer_data(
    context: &mut Context,
    target: GLenum,
    internalformat: GLenum,
    format: GLenum,
    ty: GLenum,
    data: Data<'_>,
) -> Result<()> {
    let buffer = bound(context, target)?;
    clear(context, (&buffer, internalformat), None, (format, ty), data)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn clear_buffer_sub_data(
    context: &mut Context,
    target: GLenum,
    internalformat: GLenum,
    offset: GLintptr,
    size: GLsizeiptr,
    format: GLenum,
    ty: GLenum,
    data: Data<'_>,
) -> Result<()> {
    let buffer = bound(context, target)?;
    clear(context, (&buffer, internalformat), Some((offset, size)), (format, ty), data)
}
