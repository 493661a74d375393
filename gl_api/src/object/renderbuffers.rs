//! Renderbuffers: `ARB_framebuffer_object`, section 4.4.2.

use super::doomed;
use crate::constants::*;
use crate::context::{Context, limits};
use crate::error::{
    ErrorCode, GlError, Result, Table, invalid_enum, invalid_operation, invalid_value, not_negative,
};
use crate::framebuffer::surface;
use crate::query::put;
use crate::texture::internal::{Component, INTERNAL_FORMAT, component_bits};
use crate::texture::texel::is_renderable;
use crate::types::*;
use rasterizer::driver::Image;
use texunit::format::{BaseFormat, Encoding, Format};

const SECTION: &str = "ARB_framebuffer_object, section 4.4.2";

/// A renderbuffer object.
#[derive(Clone, Debug)]
pub(crate) struct Renderbuffer {
    pub width: u32,
    pub height: u32,
    pub requested: GLenum,
    /// What it stores; `None` until it has a size.
    pub storage: Option<(Format, Image)>,
}

impl Renderbuffer {
    fn new() -> Self {
        Self { width: 0, height: 0, requested: GL_RGBA, storage: None }
    }
}

const RENDERBUFFER_TARGET: Table<()> = Table { section: SECTION, rows: &[(GL_RENDERBUFFER, ())] };

pub(crate) fn gen_renderbuffers(
    context: &mut Context,
    n: GLsizei,
    renderbuffers: &mut [GLuint],
) -> Result<()> {
    context.objects.renderbuffers.reserve(SECTION, n, renderbuffers)
}

pub(crate) fn delete_renderbuffers(
    context: &mut Context,
    n: GLsizei,
    renderbuffers: &[GLuint],
) -> Result<()> {
    for &name in doomed(SECTION, n, renderbuffers)?.iter().filter(|&&name| name != 0) {
        if context.state.bindings.renderbuffer == name {
            context.state.bindings.renderbuffer = 0;
        }
        crate::framebuffer::attach::detach_renderbuffer(context, name);
        context.objects.renderbuffers.remove(name);
    }
    Ok(())
}

pub(crate) fn bind_renderbuffer(
    context: &mut Context,
    target: GLenum,
    renderbuffer: GLuint,
) -> Result<()> {
    RENDERBUFFER_TARGET.decode("target", target)?;
    context.objects.renderbuffers.create(renderbuffer, Renderbuffer::new);
    context.state.bindings.renderbuffer = renderbuffer;
    Ok(())
}

pub(crate) fn is_renderbuffer(context: &mut Context, renderbuffer: GLuint) -> Result<bool> {
    Ok(context.objects.renderbuffers.get(renderbuffer).is_some())
}

/// The bound renderbuffer.
fn bound(context: &mut Context) -> Result<&mut Renderbuffer> {
    match context.objects.renderbuffers.get_mut(context.state.bindings.renderbuffer) {
        Some(renderbuffer) => Ok(renderbuffer),
        None => invalid_operation(SECTION, "no renderbuffer is bound: call glBindRenderbuffer"),
    }
}

pub(crate) fn renderbuffer_storage(
    context: &mut Context,
    target: GLenum,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    RENDERBUFFER_TARGET.decode("target", target)?;
    let format = drawn(INTERNAL_FORMAT.decode("internalformat", internalformat)?);
    if !is_renderable(format) {
        return invalid_enum(
            SECTION,
            format!(
                "internalformat = {} is of numbers that nothing is drawn to",
                enum_name(internalformat)
            ),
        );
    }
    for (argument, size) in [("width", width), ("height", height)] {
        if not_negative(SECTION, argument, size.into())? > limits::MAX_TEXTURE_SIZE as usize {
            return invalid_value(
                SECTION,
                format!("{argument} = {size} must not be above {}", limits::MAX_TEXTURE_SIZE),
            );
        }
    }
    bound(context)?;
    let (width, height) = (width as u32, height as u32);
    let image = surface(format, width, height).map_err(|error| GlError {
        code: ErrorCode::OutOfMemory,
        rule: error.to_string(),
        section: SECTION,
    })?;
    *bound(context)? = Renderbuffer {
        width,
        height,
        requested: internalformat,
        storage: (width > 0 && height > 0).then_some((format, image)),
    };
    Ok(())
}

/// What a renderbuffer of fractions stores: a byte each.
fn drawn(format: Format) -> Format {
    match (format.info().encoding, format.base()) {
        (Encoding::Unorm, BaseFormat::Red) => Format::R8,
        (Encoding::Unorm, BaseFormat::Rg) => Format::Rg8,
        (Encoding::Unorm, BaseFormat::Rgb) => Format::Rgb8,
        (Encoding::Unorm, BaseFormat::Rgba) => Format::Rgba8,
        (_, _) => format,
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Width,
    Height,
    InternalFormat,
    Samples,
    StencilBits,
    Bits(Component),
}

const PROPERTY: Table<Property> = Table {
    section: SECTION,
    rows: &[
        (GL_RENDERBUFFER_WIDTH, Property::Width),
        (GL_RENDERBUFFER_HEIGHT, Property::Height),
        (GL_RENDERBUFFER_INTERNAL_FORMAT, Property::InternalFormat),
        (GL_RENDERBUFFER_SAMPLES, Property::Samples),
        (GL_RENDERBUFFER_RED_SIZE, Property::Bits(Component::Red)),
        (GL_RENDERBUFFER_GREEN_SIZE, Property::Bits(Component::Green)),
        (GL_RENDERBUFFER_BLUE_SIZE, Property::Bits(Component::Blue)),
        (GL_RENDERBUFFER_ALPHA_SIZE, Property::Bits(Component::Alpha)),
        (GL_RENDERBUFFER_DEPTH_SIZE, Property::Bits(Component::Depth)),
        (GL_RENDERBUFFER_STENCIL_SIZE, Property::StencilBits),
    ],
};

pub(crate) fn get_renderbuffer_parameteriv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    RENDERBUFFER_TARGET.decode("target", target)?;
    let property = PROPERTY.decode("pname", pname)?;
    let renderbuffer = bound(context)?;
    let value = match property {
        Property::Width => renderbuffer.width as GLint,
        Property::Height => renderbuffer.height as GLint,
        Property::InternalFormat => renderbuffer.requested as GLint,
        Property::Samples | Property::StencilBits => 0,
        Property::Bits(component) => renderbuffer
            .storage
            .as_ref()
            .map_or(0, |(format, _)| component_bits(*format, component)),
    };
    put(params, &[value])
}
