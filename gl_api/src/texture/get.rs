//! Reading textures back: GL 2.1, sections 6.1.3 and 6.1.4.

use super::client::{ClientFormat, Layout, format_and_type};
use super::internal::{Component, component_bits};
use super::{FACE_TARGET, FaceTarget, bound, checked_level, convert};
use crate::constants::*;
use crate::context::Context;
use crate::entry::DataOut;
use crate::error::{Result, Table, invalid_operation};
use crate::framebuffer::Region;
use crate::query::put;
use crate::types::*;
use std::sync::Arc;
use texunit::image::Level;

const SECTION: &str = "GL 2.1, section 6.1.3";

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Width,
    Height,
    DepthOfVolume,
    Border,
    InternalFormat,
    Compressed,
    Bits(Component),
}

const PROPERTY: Table<Property> = Table {
    section: SECTION,
    rows: &[
        (GL_TEXTURE_WIDTH, Property::Width),
        (GL_TEXTURE_HEIGHT, Property::Height),
        (GL_TEXTURE_DEPTH, Property::DepthOfVolume),
        (GL_TEXTURE_BORDER, Property::Border),
        (GL_TEXTURE_INTERNAL_FORMAT, Property::InternalFormat),
        (GL_TEXTURE_COMPRESSED, Property::Compressed),
        (GL_TEXTURE_RED_SIZE, Property::Bits(Component::Red)),
        (GL_TEXTURE_GREEN_SIZE, Property::Bits(Component::Green)),
        (GL_TEXTURE_BLUE_SIZE, Property::Bits(Component::Blue)),
        (GL_TEXTURE_ALPHA_SIZE, Property::Bits(Component::Alpha)),
        (GL_TEXTURE_LUMINANCE_SIZE, Property::Bits(Component::Luminance)),
        (GL_TEXTURE_INTENSITY_SIZE, Property::Bits(Component::Intensity)),
        (GL_TEXTURE_DEPTH_SIZE, Property::Bits(Component::Depth)),
    ],
};

/// A level of the bound texture, if it exists, and the format that was asked for.
fn level(context: &Context, target: FaceTarget, level: usize) -> (Option<Arc<Level>>, GLenum) {
    let texture = bound(context, target.target);
    let face = usize::from(target.face);
    (texture.image.texels().level(face, level).cloned(), texture.requested[face][level])
}

fn property(context: &Context, target: GLenum, number: GLint, pname: GLenum) -> Result<GLint> {
    let target = FACE_TARGET.decode("target", target)?;
    let number = checked_level(SECTION, number)?;
    let property = PROPERTY.decode("pname", pname)?;
    let (level, requested) = level(context, target, number);
    let there = i32::from(level.is_some());
    Ok(match (property, &level) {
        (Property::InternalFormat, Some(_)) => requested as GLint,
        // GL 2.1, table 6.17: the initial value.
        (Property::InternalFormat, None) => 1,
        (Property::Width, level) => level.as_ref().map_or(0, |level| level.width as GLint),
        (Property::Height, level) => level.as_ref().map_or(0, |level| level.height as GLint),
        (Property::DepthOfVolume, _) => there,
        (Property::Border | Property::Compressed, _) => 0,
        (Property::Bits(component), Some(level)) => component_bits(level.format, component),
        (Property::Bits(_), None) => 0,
    })
}

pub(crate) fn get_tex_level_parameteriv(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    put(params, &[property(context, target, level, pname)?])
}

pub(crate) fn get_tex_level_parameterfv(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    pname: GLenum,
    params: &mut [GLfloat],
) -> Result<()> {
    put(params, &[property(context, target, level, pname)? as GLfloat])
}

pub(crate) fn get_tex_image(
    context: &mut Context,
    target: GLenum,
    number: GLint,
    format: GLenum,
    ty: GLenum,
    pixels: DataOut<'_>,
) -> Result<()> {
    const SECTION: &str = "GL 2.1, section 6.1.4";
    let target = FACE_TARGET.decode("target", target)?;
    let number = checked_level(SECTION, number)?;
    let (format, ty) = format_and_type(format, ty)?;
    let image = bound(context, target.target).image.clone();
    crate::draw::settle(context, &image);
    let (Some(level), _) = level(context, target, number) else { return Ok(()) };
    if (format == ClientFormat::Depth) != level.format.is_depth() {
        return invalid_operation(
            SECTION,
            "format GL_DEPTH_COMPONENT reads depth textures, and only those",
        );
    }
    let (width, height) = (level.width as usize, level.height as usize);
    let layout = Layout::new(&context.state.pack, format, ty, width, height)?;
    let bytes = destination(&layout, pixels)?;
    convert::pack(&level, Region::new(0, 0, width, height), &layout, bytes);
    Ok(())
}

/// The client's memory with enough bytes for the layout.
pub(crate) fn destination<'a>(layout: &Layout, pixels: DataOut<'a>) -> Result<&'a mut [u8]> {
    const SECTION: &str = "GL 2.1, section 4.3.2";
    match pixels {
        DataOut::Bytes(bytes) => {
            layout.check_length(bytes.len(), "GL_PACK_ALIGNMENT")?;
            Ok(bytes)
        }
        DataOut::Null if layout.needed == 0 => Ok(&mut []),
        DataOut::Null => invalid_operation(
            SECTION,
            format!("pixels must not be NULL: {} bytes are needed", layout.needed),
        ),
        DataOut::Offset(offset) => invalid_operation(
            SECTION,
            format!("pixels = offset {offset}: DetGL has no pixel buffer objects yet"),
        ),
    }
}
