//! `glCopyTexImage` and `glCopyTexSubImage`: GL 2.1, section 3.8.2.

use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::calls::framebuffer::read;
use crate::calls::texture::specify::{ImageRequest, store_level};
use crate::calls::texture::sub::{checked_area, scratch, write_area};
use crate::context::Context;
use crate::context::window::Region;
use crate::draw::completeness::Readable;
use crate::objects::target::{Dimensions, ImageTarget};
use crate::pixel::formats::{COMPRESSED, UNCOMPRESSED, format_name};
use crate::pixel::storage_error::storage_error;
use crate::pixel::{blocks, convert};
use texunit::format::Format;

const SECTION: &str = "GL 2.1, section 3.8.2";

/// The pixels of a rectangle of the read framebuffer as texels of `format`, or as the colours that
/// are compressed; black where it lies outside.
fn copied(context: &mut Context, region: Region, format: Format) -> Result<Vec<u8>> {
    let what = if format.is_depth() { Readable::Depth } else { Readable::Color };
    let source = read::source(context, what)?;
    if source.format().is_integer() != format.is_integer() {
        return invalid_operation(
            "EXT_texture_integer, section 3.8.2",
            format!(
                "{} is not converted to {}: integers stay integers, and other colours other colours",
                format_name(source.format()),
                format_name(format)
            ),
        );
    }
    if source.format().is_depth() != format.is_depth() {
        return invalid_operation(SECTION, "depth is copied from depth, colours from colours");
    }
    let size = source.format().bytes();
    let mut texels = scratch(source.format(), [region.width, region.height, 1])?;
    let [width, height] = source.size();
    if let Some(visible) = region.within(width, height) {
        for y in visible.y..visible.y + visible.height {
            let row = source.row(visible.x, y, visible.width);
            let at = ((y as i64 - region.y) as usize * region.width
                + (visible.x as i64 - region.x) as usize)
                * size;
            texels[at..at + visible.width * size].copy_from_slice(row);
        }
    }
    let to = if format.block().is_some() { blocks::COLORS } else { format };
    let isa = context.recorder.isa();
    Ok(convert::transcode(isa, source.format(), &texels, to, &context.state.transfer))
}

fn copy_tex_image(
    context: &mut Context,
    (dimensions, target): (Dimensions, GLenum),
    level: GLint,
    internal: GLenum,
    [x, y]: [GLint; 2],
    size: [GLsizei; 3],
    border: GLint,
) -> Result<()> {
    let image = ImageTarget::Bound(dimensions.bound(target)?);
    let format = match COMPRESSED.get(internal) {
        Some(format) => format.stored,
        None => UNCOMPRESSED.decode("internalformat", internal)?.stored,
    };
    let request = ImageRequest::new(image, level, internal, format, size, border)?;
    let Some(target) = request.bound(context)? else { return Ok(()) };
    let [width, height, _] = request.given;
    let texels = copied(context, Region::new(x, y, width as usize, height as usize), format)?;
    if format.block().is_some() {
        let level = blocks::compress(format, request.size, &texels)?;
        return store_level(context, target, request.level, internal, level);
    }
    let mut level = request.storage()?;
    let corner = level.border.map(|side| -(side as i32));
    level
        .write_box(corner, level.stored_size(), &texels)
        .map_err(|error| storage_error(SECTION, &error))?;
    store_level(context, target, request.level, internal, level)
}

fn copy_tex_sub_image(
    context: &mut Context,
    (dimensions, target): (Dimensions, GLenum),
    level: GLint,
    offset: [GLint; 3],
    [x, y]: [GLint; 2],
    [width, height]: [GLsizei; 2],
) -> Result<()> {
    let target = dimensions.bound(target)?;
    let area = checked_area(context, target, level, offset, [width, height, 1])?;
    let region = Region::new(x, y, width as usize, height as usize);
    let texels = copied(context, region, area.format)?;
    if area.format.block().is_some() {
        let level = blocks::compress(area.format, area.size, &texels)?;
        return write_area(context, &area, convert::texels(&level));
    }
    write_area(context, &area, &texels)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn copy_tex_image_1d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    internalformat: GLenum,
    x: GLint,
    y: GLint,
    width: GLsizei,
    border: GLint,
) -> Result<()> {
    let target = (Dimensions::One, target);
    copy_tex_image(context, target, level, internalformat, [x, y], [width, 1, 1], border)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn copy_tex_image_2d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    internalformat: GLenum,
    x: GLint,
    y: GLint,
    width: GLsizei,
    height: GLsizei,
    border: GLint,
) -> Result<()> {
    let target = (Dimensions::Two, target);
    copy_tex_image(context, target, level, internalformat, [x, y], [width, height, 1], border)
}

pub(crate) fn copy_tex_sub_image_1d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    xoffset: GLint,
    x: GLint,
    y: GLint,
    width: GLsizei,
) -> Result<()> {
    let target = (Dimensions::One, target);
    copy_tex_sub_image(context, target, level, [xoffset, 0, 0], [x, y], [width, 1])
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn copy_tex_sub_image_2d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    x: GLint,
    y: GLint,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    let target = (Dimensions::Two, target);
    copy_tex_sub_image(context, target, level, [xoffset, yoffset, 0], [x, y], [width, height])
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn copy_tex_sub_image_3d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    zoffset: GLint,
    x: GLint,
    y: GLint,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    let (target, offset) = ((Dimensions::Three, target), [xoffset, yoffset, zoffset]);
    copy_tex_sub_image(context, target, level, offset, [x, y], [width, height])
}
