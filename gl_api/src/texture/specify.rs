//! `glTexImage2D` and `glTexSubImage2D`: GL 2.1, sections 3.8.1 and 3.8.2.

use super::client::{ClientFormat, Layout, format_and_type};
use super::internal::{INTERNAL_FORMAT, texture_format};
use super::{FACE_TARGET, FaceTarget, TextureTarget, bound, bound_mut, checked_level, convert};
use crate::constants::*;
use crate::context::{Context, limits};
use crate::entry::Data;
use crate::error::{Result, invalid_operation, invalid_value, not_negative};
use crate::types::*;
use texunit::format::Format;
use texunit::image::Level;

const SECTION: &str = "GL 2.1, section 3.8.1";
const SUB_SECTION: &str = "GL 2.1, section 3.8.2";

/// The format that a texture image was asked to have.
pub(super) fn checked_internal(internal: GLenum) -> Result<Format> {
    match texture_format(internal) {
        Some(format) => Ok(format),
        None => invalid_value(
            SECTION,
            format!(
                "internalformat = {} must be 1 to 4, {}",
                enum_name(internal),
                INTERNAL_FORMAT.list()
            ),
        ),
    }
}

/// Checks the size of a level, and that cube maps are square.
pub(super) fn checked_size(
    target: FaceTarget,
    level: usize,
    width: GLsizei,
    height: GLsizei,
    border: GLint,
) -> Result<(u32, u32)> {
    let limit = (limits::MAX_TEXTURE_SIZE >> level) as usize;
    for (argument, size) in [("width", width), ("height", height)] {
        if not_negative(SECTION, argument, size.into())? > limit {
            return invalid_value(
                SECTION,
                format!("{argument} = {size} must not be above {limit} at level {level}"),
            );
        }
    }
    if target.target == TextureTarget::Cube && width != height {
        return invalid_value(
            SECTION,
            format!("width = {width} and height = {height} of a cube map's face must be equal"),
        );
    }
    if border != 0 {
        return invalid_value(
            SECTION,
            format!("border = {border} must be 0: DetGL has no textures with border texels"),
        );
    }
    Ok((width as u32, height as u32))
}

/// Depth pixels go to depth textures, and colours to the others.
fn kinds_match(format: ClientFormat, stored: Format) -> Result<()> {
    if (format == ClientFormat::Depth) == stored.is_depth() {
        return Ok(());
    }
    invalid_operation(
        SECTION,
        "format GL_DEPTH_COMPONENT and a depth internalformat go together, and not with colours",
    )
}

/// The client's memory with enough bytes for the layout, or `None` for a null pointer.
fn source<'a>(layout: &Layout, pixels: Data<'a>) -> Result<Option<&'a [u8]>> {
    match pixels {
        Data::Null => Ok(None),
        Data::Bytes(bytes) => {
            layout.check_length(bytes.len(), "GL_UNPACK_ALIGNMENT")?;
            Ok(Some(bytes))
        }
        Data::Offset(offset) => invalid_operation(
            "GL 2.1, section 4.3.2",
            format!("pixels = offset {offset}: DetGL has no pixel buffer objects yet"),
        ),
    }
}

/// Puts a level in place and lets everything that depends on it know.
pub(super) fn store_level(
    context: &mut Context,
    target: FaceTarget,
    level: usize,
    internal: GLenum,
    texels: Level,
) -> Result<()> {
    let image = bound(context, target.target).image.clone();
    crate::draw::settle(context, &image);
    let texture = bound_mut(context, target.target);
    let face = usize::from(target.face);
    texture
        .image
        .update(|image| image.set_level(face, level, texels))
        .map_err(|error| super::storage_error(SECTION, &error))?;
    texture.requested[face][level] = internal;
    texture.changed();
    super::mipmap::base_level_changed(texture, level)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn tex_image_2d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    internalformat: GLint,
    width: GLsizei,
    height: GLsizei,
    border: GLint,
    format: GLenum,
    ty: GLenum,
    pixels: Data<'_>,
) -> Result<()> {
    let target = FACE_TARGET.decode("target", target)?;
    let level = checked_level(SECTION, level)?;
    let stored = checked_internal(internalformat as GLenum)?;
    let (width, height) = checked_size(target, level, width, height, border)?;
    let (client, ty) = format_and_type(format, ty)?;
    kinds_match(client, stored)?;
    let layout = Layout::new(&context.state.unpack, client, ty, width as usize, height as usize)?;
    let error = |error| super::storage_error(SECTION, &error);
    let texels = match source(&layout, pixels)? {
        Some(bytes) => {
            let texels = convert::unpack(&layout, bytes, stored);
            Level::from_texels(stored, width, height, &texels).map_err(error)?
        }
        None => Level::new(stored, width, height).map_err(error)?,
    };
    store_level(context, target, level, internalformat as GLenum, texels)
}

/// Checks that a rectangle lies inside a level that exists; gives the level's format and the
/// rectangle.
pub(super) fn checked_area(
    context: &Context,
    target: FaceTarget,
    level: usize,
    [x, y]: [GLint; 2],
    [width, height]: [GLsizei; 2],
) -> Result<(Format, [u32; 4])> {
    not_negative(SUB_SECTION, "width", width.into())?;
    not_negative(SUB_SECTION, "height", height.into())?;
    let image = bound(context, target.target).image.texels();
    let Some(texels) = image.level(target.face.into(), level) else {
        return invalid_operation(
            SUB_SECTION,
            format!("level {level} has no image yet: call glTexImage2D first"),
        );
    };
    for (offset, at, argument, size, limit) in [
        ("xoffset", x, "width", width, texels.width),
        ("yoffset", y, "height", height, texels.height),
    ] {
        if at < 0 || i64::from(at) + i64::from(size) > i64::from(limit) {
            return invalid_value(
                SUB_SECTION,
                format!("{offset} = {at} and {argument} = {size} reach outside 0 to {limit}"),
            );
        }
    }
    Ok((texels.format, [x as u32, y as u32, width as u32, height as u32]))
}

/// Overwrites a rectangle that [`checked_area`] accepted.
pub(super) fn write_area(
    context: &mut Context,
    target: FaceTarget,
    level: usize,
    [x, y, width, height]: [u32; 4],
    texels: &[u8],
) -> Result<()> {
    let image = bound(context, target.target).image.clone();
    crate::draw::settle(context, &image);
    let texture = bound_mut(context, target.target);
    let written = texture.image.update(|image| {
        image
            .level_mut(target.face.into(), level)
            .map_or(Ok(()), |level| level.write(x, y, width, height, texels))
    });
    written.map_err(|error| super::storage_error(SUB_SECTION, &error))?;
    texture.changed();
    super::mipmap::base_level_changed(texture, level)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn tex_sub_image_2d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    width: GLsizei,
    height: GLsizei,
    format: GLenum,
    ty: GLenum,
    pixels: Data<'_>,
) -> Result<()> {
    let target = FACE_TARGET.decode("target", target)?;
    let level = checked_level(SUB_SECTION, level)?;
    let (stored, area) = checked_area(context, target, level, [xoffset, yoffset], [width, height])?;
    let (client, ty) = format_and_type(format, ty)?;
    kinds_match(client, stored)?;
    let layout = Layout::new(&context.state.unpack, client, ty, width as usize, height as usize)?;
    if layout.needed == 0 {
        return Ok(());
    }
    match source(&layout, pixels)? {
        Some(bytes) => {
            let texels = convert::unpack(&layout, bytes, stored);
            write_area(context, target, level, area, &texels)
        }
        None => invalid_operation(
            SUB_SECTION,
            format!("pixels must not be NULL: {} bytes are needed", layout.needed),
        ),
    }
}
