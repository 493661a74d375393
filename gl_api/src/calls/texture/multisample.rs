//! Textures with several samples a texel: `glTexImage2DMultisample`, `3D` and those with immutable storage
//! (`ARB_texture_multisample`, section 3.8.X; `ARB_texture_storage_multisample`).
//!
//! An image is stored as layers, one for each sample, which is how shaders fetch them. What is arguments
//! for is a least number of samples: every image has the most that there are.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum, invalid_operation, invalid_value};
use crate::base::limits;
use crate::base::types::*;
use crate::calls::texture::level_request::{
    Destination, ImageRequest, LevelDesc, LevelRequest, ProxyRequest,
};
use crate::context::Context;
use crate::objects::target::{IMAGE_2D_MULTISAMPLE, IMAGE_3D_MULTISAMPLE, ImageTarget};
use crate::objects::texture::Samples;
use crate::pixel::formats::{UNCOMPRESSED, sized_format};
use crate::pixel::storage_error::storage_error;
use rasterizer::driver::MultisampleStorage;
use texunit::format::Format;
use texunit::image::Image as Texels;

const SECTION: &str = "ARB_texture_multisample, section 3.8.X";
const STORAGE: &str = "ARB_texture_storage_multisample, section 3.8.X";

/// Whether other images may follow.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Lifetime {
    Replaceable,
    Immutable,
}

/// The arguments of a call behind its target.
pub(crate) struct Arguments {
    pub samples: GLsizei,
    pub internal: GLenum,
    pub size: [GLsizei; 3],
    pub fixed_locations: bool,
}

/// A format that is drawn to, as nothing else fills such an image.
fn checked_format(internal: GLenum, lifetime: Lifetime) -> Result<Format> {
    let (format, how, section) = match lifetime {
        Lifetime::Replaceable => (UNCOMPRESSED.get(internal), "drawn to", SECTION),
        Lifetime::Immutable => (sized_format(internal), "sized and drawn to", STORAGE),
    };
    match format {
        Some(format) if format.is_for_multisampling() => Ok(format.stored),
        Some(_) | None => invalid_enum(
            section,
            format!(
                "internalformat = {} must be one that is {how}, as GL_RGBA8 or \
                 GL_DEPTH_COMPONENT24",
                enum_name(internal)
            ),
        ),
    }
}

/// What immutable storage needs besides (`ARB_texture_storage`, section 3.8.X).
fn checked_storage(destination: &Destination, size: [GLsizei; 3]) -> Result<()> {
    if size.iter().any(|side| *side < 1) {
        let [width, height, depth] = size;
        let rule = format!("the size {width}×{height}×{depth} must be at least 1");
        return invalid_value(STORAGE, rule);
    }
    match destination {
        Destination::Texture(texture) if texture.name() == 0 => {
            invalid_operation(STORAGE, "texture 0 is the default one: bind another")
        }
        Destination::Texture(_) | Destination::Proxy(_) => Ok(()),
    }
}

/// Checks a call. A proxy refuses more samples than there are by having no image.
fn request(
    context: &Context,
    destination: &Destination,
    arguments: &Arguments,
    lifetime: Lifetime,
) -> Result<ImageRequest> {
    let &Arguments { samples, internal, size, fixed_locations } = arguments;
    let format = checked_format(internal, lifetime)?;
    if samples < 1 {
        return invalid_value(SECTION, format!("samples = {samples} must be at least 1"));
    }
    if lifetime == Lifetime::Immutable {
        checked_storage(destination, size)?;
    }
    let mut desc = LevelDesc::new(destination.image(), 0, internal, format, size, 0)?;
    if samples > limits::MAX_SAMPLES.into() {
        return match destination {
            &Destination::Proxy(target) => {
                Ok(ImageRequest::Proxy(ProxyRequest { target, level: 0, image: None }))
            }
            Destination::Texture(_) => invalid_operation(
                SECTION,
                format!("samples = {samples} must not be above {}", limits::MAX_SAMPLES),
            ),
        };
    }
    desc.samples = Some(Samples { count: limits::MAX_SAMPLES, fixed_locations });
    desc.request_of(context, destination)
}

fn specify(
    context: &mut Context,
    table: &Table<ImageTarget>,
    target: GLenum,
    arguments: &Arguments,
    lifetime: Lifetime,
) -> Result<()> {
    let destination = Destination::new(context, table.decode("target", target)?);
    specify_of(context, &destination, arguments, lifetime)
}

/// The same for a texture that may not be bound.
pub(crate) fn specify_of(
    context: &mut Context,
    destination: &Destination,
    arguments: &Arguments,
    lifetime: Lifetime,
) -> Result<()> {
    match request(context, destination, arguments, lifetime)? {
        ImageRequest::Texture(request) => store(context, &request, lifetime),
        ImageRequest::Proxy(request) => {
            request.apply(context);
            Ok(())
        }
    }
}

/// Puts an image of zeros in place of the texture's.
fn store(context: &mut Context, request: &LevelRequest, lifetime: Lifetime) -> Result<()> {
    let target = request.texture.target;
    let mut texels = Texels::new(target.shape());
    texels.set_level(0, 0, request.storage()?).map_err(|error| storage_error(SECTION, &error))?;
    let image = request.texture.get(context).image.clone();
    // What was recorded draws to the image as it was.
    crate::draw::pass::submit_draws_to(context, &image);
    image.replace(texels, limits::MAX_SAMPLES, MultisampleStorage::EachSample);
    let texture = request.texture.get_mut(context);
    texture.samples = request.desc.samples;
    texture.requested[0][0] = request.desc.internal;
    match lifetime {
        Lifetime::Replaceable => {}
        Lifetime::Immutable => texture.make_immutable(1),
    }
    texture.changed();
    Ok(())
}

pub(crate) fn tex_image_2d_multisample(
    context: &mut Context,
    target: GLenum,
    samples: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
    fixedsamplelocations: bool,
) -> Result<()> {
    let (size, fixed_locations) = ([width, height, 1], fixedsamplelocations);
    let arguments = Arguments { samples, internal: internalformat, size, fixed_locations };
    specify(context, &IMAGE_2D_MULTISAMPLE, target, &arguments, Lifetime::Replaceable)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn tex_image_3d_multisample(
    context: &mut Context,
    target: GLenum,
    samples: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
    fixedsamplelocations: bool,
) -> Result<()> {
    let (size, fixed_locations) = ([width, height, depth], fixedsamplelocations);
    let arguments = Arguments { samples, internal: internalformat, size, fixed_locations };
    specify(context, &IMAGE_3D_MULTISAMPLE, target, &arguments, Lifetime::Replaceable)
}

pub(crate) fn tex_storage_2d_multisample(
    context: &mut Context,
    target: GLenum,
    samples: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
    fixedsamplelocations: bool,
) -> Result<()> {
    let (size, fixed_locations) = ([width, height, 1], fixedsamplelocations);
    let arguments = Arguments { samples, internal: internalformat, size, fixed_locations };
    specify(context, &IMAGE_2D_MULTISAMPLE, target, &arguments, Lifetime::Immutable)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn tex_storage_3d_multisample(
    context: &mut Context,
    target: GLenum,
    samples: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
    fixedsamplelocations: bool,
) -> Result<()> {
    let (size, fixed_locations) = ([width, height, depth], fixedsamplelocations);
    let arguments = Arguments { samples, internal: internalformat, size, fixed_locations };
    specify(context, &IMAGE_3D_MULTISAMPLE, target, &arguments, Lifetime::Immutable)
}
