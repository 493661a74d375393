//! `glCopyTexImage2D` and `glCopyTexSubImage2D`: GL 2.1, section 3.8.2.

use super::internal::INTERNAL_FORMAT;
use super::specify::{checked_area, checked_size, store_level, write_area};
use super::{FACE_TARGET, checked_level, convert, storage_error};
use crate::context::Context;
use crate::error::{Result, invalid_operation};
use crate::framebuffer::{Region, read};
use crate::types::*;
use texunit::format::Format;
use texunit::image::Level;

const SECTION: &str = "GL 2.1, section 3.8.2";

/// The pixels of a rectangle of the read framebuffer as texels of `format`; black where it lies
/// outside.
fn copied(context: &mut Context, region: Region, format: Format) -> Result<Vec<u8>> {
    let source =
        if format.is_depth() { read::depth_source(context)? } else { read::color_source(context)? };
    if source.format.is_depth() != format.is_depth() {
        return invalid_operation(SECTION, "depth is copied from depth, colours from colours");
    }
    let size = source.format.bytes();
    let mut texels = vec![0; region.width * region.height * size];
    if let Some(visible) = region.within(source.width, source.height) {
        for y in visible.y..visible.y + visible.height {
            let row = &source.texels[y * source.row_bytes()..][visible.x * size..];
            let at = ((y as i64 - region.y) as usize * region.width
                + (visible.x as i64 - region.x) as usize)
                * size;
            texels[at..at + visible.width * size].copy_from_slice(&row[..visible.width * size]);
        }
    }
    Ok(convert::transcode(source.format, &texels, format))
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
    let target = FACE_TARGET.decode("target", target)?;
    let level = checked_level(SECTION, level)?;
    let format = INTERNAL_FORMAT.decode("internalformat", internalformat)?;
    let (width, height) = checked_size(target, level, width, height, border)?;
    let region = Region::new(x, y, width as usize, height as usize);
    let texels = copied(context, region, format)?;
    let texels = Level::from_texels(format, width, height, &texels)
        .map_err(|error| storage_error(SECTION, &error))?;
    store_level(context, target, level, internalformat, texels)
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
    let target = FACE_TARGET.decode("target", target)?;
    let level = checked_level(SECTION, level)?;
    let (format, area) = checked_area(context, target, level, [xoffset, yoffset], [width, height])?;
    let region = Region::new(x, y, width as usize, height as usize);
    let texels = copied(context, region, format)?;
    write_area(context, target, level, area, &texels)
}
