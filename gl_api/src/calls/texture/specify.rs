//! `glTexImage1D`, `glTexImage2D` and `glTexImage3D` (GL 2.1, section 3.8.1). [`ImageRequest`] is what the calls that
//! specify a level have checked before they store it.

use crate::base::args::Data;
use crate::base::constants::*;
use crate::base::error::{Result, invalid_operation, invalid_value, must_be, not_negative};
use crate::base::types::*;
use crate::calls::pixels::memory::pixel_source;
use crate::calls::texture::bound::{bound, bound_mut};
use crate::calls::texture::sub::scratch;
use crate::context::Context;
use crate::objects::target::{Dimensions, FaceTarget, ImageTarget, TextureTarget, checked_level};
use crate::objects::texture::{Proxy, Samples};
use crate::pixel::client::Pixel;
use crate::pixel::client::format::{ClientFormat, Numbers};
use crate::pixel::formats::{UNCOMPRESSED, texture_format};
use crate::pixel::layout::{Extent, Layout};
use crate::pixel::{blocks, convert};
use texunit::format::Format;
use texunit::image::{FACES, Level};

const SECTION: &str = "GL 2.1, section 3.8.1";

/// The format that a texture image was asked to have.
pub(crate) fn checked_internal(internal: GLenum) -> Result<Format> {
    match texture_format(internal) {
        Some(format) => Ok(format),
        None => invalid_value(
            SECTION,
            match internal {
                0..=9 => format!("internalformat = {internal} must be 1 to 4, or a format's name"),
                _ => format!(
                    "internalformat = {} {}",
                    enum_name(internal),
                    must_be(internal, &UNCOMPRESSED.values())
                ),
            },
        ),
    }
}

/// A level that a call asks for.
pub(crate) struct ImageRequest {
    pub image: ImageTarget,
    pub level: usize,
    pub internal: GLenum,
    pub format: Format,
    /// Width, height and depth as the call has them: with the border, layers of a one-dimensional
    /// array as height.
    pub given: [u32; 3],
    /// Width, height and depth of the level, without border.
    pub size: [u32; 3],
    pub border: u32,
    /// Of an image with several a texel.
    pub samples: Option<Samples>,
    /// The first side that is too large, if one is.
    too_large: Option<String>,
}

impl ImageRequest {
    /// Checks everything but the pixels.
    pub fn new(
        image: ImageTarget,
        level: GLint,
        internal: GLenum,
        format: Format,
        given: [GLsizei; 3],
        border: GLint,
    ) -> Result<Self> {
        let target = image.target();
        let level = checked_level(SECTION, target, level)?;
        let border = checked_border(target, border)?;
        if target == TextureTarget::D3 && format.is_depth() {
            return invalid_operation(SECTION, "three-dimensional textures have no depth formats");
        }
        if format.block().is_some() {
            checked_blocks(target, border)?;
        }
        let borders = target.level_box(target.shape().border(border));
        let (limits, axes) = (target.limits(), target.shape().axes());
        let mut sides = [0; 3];
        let mut too_large = None;
        for (axis, argument) in ["width", "height", "depth"].into_iter().enumerate() {
            let side = not_negative(SECTION, argument, given[axis].into())? as u32;
            let Some(inside) = side.checked_sub(2 * borders[axis]) else {
                return invalid_value(
                    SECTION,
                    format!("{argument} = {side} must be at least 2, as border = 1"),
                );
            };
            let limit = if axis < axes { limits[axis] >> level } else { limits[axis] };
            if inside > limit && too_large.is_none() {
                too_large = Some(format!(
                    "{argument} = {side} must not be above {} at level {level}",
                    limit + 2 * borders[axis]
                ));
            }
            sides[axis] = inside;
        }
        if target.shape().is_cube() && given[0] != given[1] {
            let [width, height, _] = given;
            return invalid_value(
                SECTION,
                format!("width = {width} and height = {height} of a cube map's face must be equal"),
            );
        }
        if target == TextureTarget::CubeArray && !(given[2] as usize).is_multiple_of(FACES) {
            let depth = given[2];
            return invalid_value(
                "ARB_texture_cube_map_array, section 3.9.1",
                format!(
                    "depth = {depth} must be a multiple of 6: it counts the faces of all cubes"
                ),
            );
        }
        let given = given.map(|side| side as u32);
        let size = target.level_box(sides);
        let samples = None;
        Ok(Self { image, level, internal, format, given, size, border, samples, too_large })
    }

    /// The image to put the level into; a proxy is answered, and then there is none.
    pub fn bound(&self, context: &mut Context) -> Result<Option<FaceTarget>> {
        match (self.image, &self.too_large) {
            (ImageTarget::Bound(_), Some(rule)) => invalid_value(SECTION, rule.clone()),
            (ImageTarget::Bound(target), None)
                if bound(context, target.target).immutable.is_some() =>
            {
                invalid_operation(
                    "ARB_texture_storage, section 3.8.X",
                    "the texture's levels were given for good by glTexStorage: fill them with \
                     glTexSubImage",
                )
            }
            (ImageTarget::Bound(target), None) => Ok(Some(target)),
            (ImageTarget::Proxy(target), too_large) => {
                let Self { size, border, internal, format, samples, .. } = *self;
                let [width, height, depth] = target.shape().border(border).map(|side| 2 * side);
                let bytes = Level::required_bytes(
                    format,
                    size[0] + width,
                    size[1] + height,
                    self.slices() + depth,
                );
                let fits = too_large.is_none() && bytes.is_some();
                context.state.proxies[target as usize][self.level] =
                    fits.then_some(Proxy { size, border, internal, format, samples });
                Ok(None)
            }
        }
    }

    /// The slices of the level: every sample of a layer has one.
    fn slices(&self) -> u32 {
        self.size[2] * self.samples.map_or(1, |samples| samples.count.into())
    }

    /// A level as asked for, its bytes all 0.
    pub fn storage(&self) -> Result<Level> {
        let border = self.image.target().shape().border(self.border);
        let [width, height, _] = self.size;
        Level::with_size(self.format, [width, height, self.slices()], border)
            .map_err(|error| crate::pixel::storage_error::storage_error(SECTION, &error))
    }
}

/// Blocks are of two dimensions and have no border.
fn checked_blocks(target: TextureTarget, border: u32) -> Result<()> {
    const SECTION: &str = "EXT_texture_compression_s3tc, section 3.8.3";
    match target {
        TextureTarget::D2
        | TextureTarget::Cube
        | TextureTarget::D2Array
        | TextureTarget::CubeArray => match border {
            0 => Ok(()),
            _ => invalid_operation(SECTION, "compressed images have no border"),
        },
        TextureTarget::D1
        | TextureTarget::D3
        | TextureTarget::Rect
        | TextureTarget::D1Array
        | TextureTarget::D2Multisample
        | TextureTarget::D2MultisampleArray
        | TextureTarget::Buffer => {
            invalid_operation(SECTION, "this target takes no compressed internalformat")
        }
    }
}

fn checked_border(target: TextureTarget, border: GLint) -> Result<u32> {
    match (target, border) {
        (_, 0) => Ok(0),
        (TextureTarget::Rect, _) => {
            invalid_value(SECTION, format!("border = {border} of a rectangle must be 0"))
        }
        (
            TextureTarget::D1
            | TextureTarget::D2
            | TextureTarget::D3
            | TextureTarget::Cube
            | TextureTarget::D1Array
            | TextureTarget::D2Array
            | TextureTarget::CubeArray
            | TextureTarget::D2Multisample
            | TextureTarget::D2MultisampleArray
            | TextureTarget::Buffer,
            1,
        ) => Ok(1),
        (_, _) => invalid_value(SECTION, format!("border = {border} must be 0 or 1")),
    }
}

/// Depth pixels go to depth textures, integers to integer textures, colours to the others.
pub(crate) fn kinds_match(pixel: Pixel, stored: Format) -> Result<()> {
    if pixel.format == ClientFormat::Stencil {
        return invalid_operation(SECTION, "format GL_STENCIL_INDEX is for framebuffers alone");
    }
    if pixel.format.is_depth() != stored.is_depth() {
        return invalid_operation(
            SECTION,
            "format GL_DEPTH_COMPONENT and a depth internalformat go together, and not with colours",
        );
    }
    if (pixel.numbers == Numbers::Integer) != stored.is_integer() {
        return invalid_operation(
            "EXT_texture_integer, section 3.8.1",
            "formats of integers (GL_RGBA_INTEGER) and integer internalformats go together, and \
             not with others",
        );
    }
    Ok(())
}

/// Puts a level in place and lets everything that depends on it know.
pub(crate) fn store_level(
    context: &mut Context,
    target: FaceTarget,
    level: usize,
    internal: GLenum,
    texels: Level,
) -> Result<()> {
    let image = bound(context, target.target).image.clone();
    crate::draw::pass::settle(context, &image);
    let isa = context.recorder.isa();
    let texture = bound_mut(context, target.target);
    let face = usize::from(target.face);
    texture
        .image
        .update(|image| image.set_level(face, level, texels))
        .map_err(|error| crate::pixel::storage_error::storage_error(SECTION, &error))?;
    texture.requested[face][level] = internal;
    texture.texels_changed();
    crate::calls::texture::mipmap::base_level_changed(isa, texture, face, level)
}

/// A call's format, type and pixels.
struct Pixels<'a> {
    format: GLenum,
    ty: GLenum,
    data: Data<'a>,
}

fn tex_image(
    context: &mut Context,
    (dimensions, target): (Dimensions, GLenum),
    level: GLint,
    internal: GLint,
    given: [GLsizei; 3],
    border: GLint,
    pixels: Pixels<'_>,
) -> Result<()> {
    let image = dimensions.image(target)?;
    let internal = internal as GLenum;
    let format = checked_internal(internal)?;
    let request = ImageRequest::new(image, level, internal, format, given, border)?;
    let pixel = Pixel::new(pixels.format, pixels.ty)?;
    kinds_match(pixel, format)?;
    let Some(target) = request.bound(context)? else { return Ok(()) };
    let extent = extent(dimensions);
    let size = request.given.map(|side| side as usize);
    // Before its pixels: of a level that is too large there may be more than memory has addresses.
    let mut texels = request.storage()?;
    let layout = Layout::new(&context.state.unpack, pixel, size, extent)?;
    let source = pixel_source(context, "glTexImage", &layout, pixels.data)?;
    let (isa, transfer) = (context.recorder.isa(), &context.state.transfer);
    let texels = match (source, format.block()) {
        (None, _) => texels,
        (Some(source), None) => {
            let room = texels.texels.len() - texunit::image::PADDING;
            let out = &mut texels.texels[..room];
            convert::unpack(isa, &layout, source.bytes(), format, transfer, out);
            texels
        }
        (Some(source), Some(_)) => {
            let mut colors = scratch(blocks::COLORS, size)?;
            convert::unpack(isa, &layout, source.bytes(), blocks::COLORS, transfer, &mut colors);
            blocks::compress(format, request.size, &colors)?
        }
    };
    store_level(context, target, request.level, internal, texels)
}

/// Which parts of the pixel store count for a call of so many dimensions.
pub(crate) fn extent(dimensions: Dimensions) -> Extent {
    match dimensions {
        Dimensions::One | Dimensions::Two => Extent::Flat,
        Dimensions::Three => Extent::Volume,
    }
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn tex_image_1d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    internalformat: GLint,
    width: GLsizei,
    border: GLint,
    format: GLenum,
    ty: GLenum,
    data: Data<'_>,
) -> Result<()> {
    let pixels = Pixels { format, ty, data };
    let target = (Dimensions::One, target);
    tex_image(context, target, level, internalformat, [width, 1, 1], border, pixels)
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
    data: Data<'_>,
) -> Result<()> {
    let pixels = Pixels { format, ty, data };
    let target = (Dimensions::Two, target);
    tex_image(context, target, level, internalformat, [width, height, 1], border, pixels)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn tex_image_3d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    internalformat: GLint,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
    border: GLint,
    format: GLenum,
    ty: GLenum,
    data: Data<'_>,
) -> Result<()> {
    let pixels = Pixels { format, ty, data };
    let target = (Dimensions::Three, target);
    tex_image(context, target, level, internalformat, [width, height, depth], border, pixels)
}
