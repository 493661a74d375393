//! `glCopyTexImage` and `glCopyTexSubImage`: GL 2.1, section 3.8.2.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::calls::framebuffer::read::ReadBuffer;
use crate::calls::texture::bound::ChosenImage;
use crate::calls::texture::level_request::{ImageRequest, LevelDesc, LevelRequest};
use crate::calls::texture::sub::BoxRequest;
use crate::context::Context;
use crate::context::window::Region;
use crate::draw::completeness::Aspect;
use crate::objects::target::{Dimensions, ImageTarget};
use crate::pixel::component_bits::{Component, component_bits};
use crate::pixel::es_texels;
use crate::pixel::formats::{self, COMPRESSED, FormatClass, UNCOMPRESSED, format_name};
use crate::pixel::storage_error::storage_error;
use crate::pixel::{blocks, convert};
use texunit::format::{BaseFormat, Encoding, Format};

const SECTION: &str = "GL 2.1, section 3.8.2";

/// A region of the read framebuffer that is copied to texels of a format.
struct CopySource {
    buffer: ReadBuffer,
    region: Region,
    to: Format,
    /// What of the framebuffer is copied.
    aspect: Aspect,
}

impl CopySource {
    fn new(context: &Context, region: Region, to: Format, internal: GLenum) -> Result<Self> {
        let aspect = match to.is_depth() {
            true if formats::is_of_stencils(internal) => Aspect::Stencil,
            true => Aspect::Depth,
            false => Aspect::Color,
        };
        let buffer = ReadBuffer::new(context, aspect)?;
        let from = buffer.format;
        if aspect == Aspect::Stencil {
            return Ok(Self { buffer, region, to, aspect });
        }
        if from.is_integer() != to.is_integer() {
            return invalid_operation(
                "EXT_texture_integer, section 3.8.2",
                format!(
                    "{} is not converted to {}: integers stay integers, and other colours other colours",
                    format_name(from),
                    format_name(to)
                ),
            );
        }
        if from.is_depth() != to.is_depth() {
            return invalid_operation(SECTION, "depth is copied from depth, colours from colours");
        }
        if context.profile.is_es() {
            check_es(from, to)?;
        }
        Ok(Self { buffer, region, to, aspect })
    }

    /// The texels, or the colours that are compressed; zeros where the region lies outside.
    fn texels(&self, context: &mut Context) -> Result<Vec<u8>> {
        let from = self.buffer.pixels(context)?;
        let to = if self.to.block().is_some() { blocks::COLORS } else { self.to };
        let (isa, transfer) = (context.recorder.isa(), &context.state.transfer);
        let transcode = match self.aspect {
            Aspect::Stencil => convert::transcode_stencils,
            Aspect::Color | Aspect::Depth => convert::transcode,
        };
        transcode(isa, from.format(), &from.region(self.region)?, to, transfer)
    }
}

/// Checks that OpenGL ES copies colours of one format to texels of another: no channel is made up, and numbers stay what
/// they are (3.0, table 3.15).
fn check_es(from: Format, to: Format) -> Result<()> {
    const SECTION: &str = "OpenGL ES 3.0, table 3.15";
    let has = |format: Format| match format.base() {
        BaseFormat::Red | BaseFormat::Luminance => [true, false, false, false],
        BaseFormat::Rg => [true, true, false, false],
        BaseFormat::Rgb => [true, true, true, false],
        BaseFormat::Rgba | BaseFormat::Intensity => [true; 4],
        BaseFormat::Alpha => [false, false, false, true],
        BaseFormat::LuminanceAlpha => [true, false, false, true],
        BaseFormat::Depth => [false; 4],
    };
    let kinds: [fn(Format) -> bool; 3] = [
        |format| format.info().encoding == Encoding::Float,
        |format| format.info().encoding == Encoding::Uint,
        |format| format.info().encoding == Encoding::Snorm,
    ];
    let kinds_differ = kinds.iter().any(|is| is(from) != is(to));
    let made_up = has(from).into_iter().zip(has(to)).any(|(from, to)| to && !from);
    if to.is_depth() || made_up || kinds_differ || to.block().is_some() || to == Format::Rgb9E5 {
        let [from, to] = [from, to].map(format_name);
        return invalid_operation(SECTION, format!("{from} is not copied to texels of {to}"));
    }
    Ok(())
}

/// Checks that OpenGL ES makes an image of an internal format from a buffer: both are sRGB or none is, components that
/// both have are of one size, and an unsized format names no buffer of ten bits (3.0, section 3.8.5).
fn check_es_image(internal: GLenum, from: Format, to: Format) -> Result<()> {
    const SECTION: &str = "OpenGL ES 3.0, section 3.8.5";
    let sized = formats::find(internal).is_some_and(|row| row.class == FormatClass::Sized);
    let sizes_differ = COLORS.into_iter().any(|component| {
        let [from, to] = [from, to].map(|format| component_bits(format, component));
        from > 0 && to > 0 && from != to
    });
    let rule = if from.is_srgb() != to.is_srgb() {
        "sRGB is copied from sRGB alone"
    } else if sized && sizes_differ {
        "components keep their sizes"
    } else if !sized && from == Format::Rgb10A2 {
        "there is no unsized format of ten bits: name GL_RGB10_A2"
    } else {
        return Ok(());
    };
    let [from, internal] = [format_name(from), enum_name(internal)];
    invalid_operation(SECTION, format!("internalformat = {internal}, but {from} is read: {rule}"))
}

/// The components of colours.
const COLORS: [Component; 4] =
    [Component::Red, Component::Green, Component::Blue, Component::Alpha];

/// A checked `glCopyTexImage`.
struct CopyTexImageRequest {
    level: LevelRequest,
    source: CopySource,
}

impl CopyTexImageRequest {
    fn apply(self, context: &mut Context) -> Result<()> {
        let Self { level: request, source } = self;
        let texels = source.texels(context)?;
        if source.to.block().is_some() {
            let level = blocks::compress(source.to, request.desc.size, &texels)?;
            return request.apply(context, level);
        }
        let mut level = request.storage()?;
        let corner = level.border.map(|side| -(side as i32));
        level
            .write_box(corner, level.stored_size(), &texels)
            .map_err(|error| storage_error(SECTION, &error))?;
        request.apply(context, level)
    }
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
        Some(_) if context.profile.is_es() => {
            let rule = format!("internalformat = {} takes blocks alone", enum_name(internal));
            return invalid_operation(SECTION, rule);
        }
        Some(format) => format.stored,
        None => UNCOMPRESSED.decode("internalformat", internal)?.stored,
    };
    context.lists.charge_image(size);
    let desc = LevelDesc::new(image, level, internal, format, size, border)?;
    match desc.request(context)? {
        ImageRequest::Texture(level) => {
            let [width, height, _] = level.desc.given.map(|side| side as usize);
            let source =
                CopySource::new(context, Region::new(x, y, width, height), format, internal)?;
            if context.profile.is_es() {
                check_es_image(internal, source.buffer.format, format)?;
            }
            CopyTexImageRequest { level, source }.apply(context)
        }
        ImageRequest::Proxy(proxy) => {
            proxy.apply(context);
            Ok(())
        }
    }
}

fn copy_tex_sub_image(
    context: &mut Context,
    (dimensions, target): (Dimensions, GLenum),
    level: GLint,
    offset: [GLint; 3],
    corner: [GLint; 2],
    size: [GLsizei; 2],
) -> Result<()> {
    let image = ChosenImage::bound(context, dimensions.bound(target)?);
    copy_to(context, image, level, offset, corner, size)
}

/// Replaces a rectangle of a level by one of the read framebuffer.
pub(crate) fn copy_to(
    context: &mut Context,
    image: ChosenImage,
    level: GLint,
    offset: [GLint; 3],
    [x, y]: [GLint; 2],
    [width, height]: [GLsizei; 2],
) -> Result<()> {
    let area = BoxRequest::new(context, image, level, offset, [width, height, 1])?;
    context.lists.charge_image([width, height, 1]);
    let region = Region::new(x, y, width as usize, height as usize);
    let requested = area.internal(context);
    if context.profile.is_es() {
        es_texels::check_copied(requested)?;
    }
    let source = CopySource::new(context, region, area.format, requested)?;
    area.check_blocks()?;
    let texels = source.texels(context)?;
    area.apply_converted(context, &texels)
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
