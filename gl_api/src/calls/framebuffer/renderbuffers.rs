//! Renderbuffers: `ARB_framebuffer_object`, section 4.4.2.

use crate::base::constants::*;
use crate::base::error::{
    ErrorCode, GlError, Result, Table, invalid_enum, invalid_operation, invalid_value, not_negative,
};
use crate::base::limits;
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::framebuffer::attach::detach;
use crate::context::Context;
use crate::context::window::texels;
use crate::objects::bound::Bound;
use crate::objects::egl_images::Specified;
use crate::objects::name_table::{Sweep, listed};
use crate::objects::renderbuffers::{RENDERBUFFER_TARGET, Renderbuffer, Resolving};
use crate::pixel::component_bits::{Component, component_bits};
use crate::pixel::formats;
use crate::pixel::formats::{InternalFormat, UNCOMPRESSED};
use rasterizer::driver::{LevelInfo, MultisampleStorage};
use texunit::image::{Image as Texels, Shape};

const SECTION: &str = "ARB_framebuffer_object, section 4.4.2";

pub(crate) fn gen_renderbuffers(
    context: &mut Context,
    n: GLsizei,
    renderbuffers: &mut [GLuint],
) -> Result<()> {
    context.objects.shared.renderbuffers.reserve(SECTION, n, renderbuffers)
}

pub(crate) fn delete_renderbuffers(
    context: &mut Context,
    n: GLsizei,
    renderbuffers: &[GLuint],
) -> Result<()> {
    for &name in listed(SECTION, n, renderbuffers)?.iter().filter(|&&name| name != 0) {
        let gone = context.objects.shared.renderbuffers.hold(name);
        context.state.bindings.renderbuffer.forget(&gone);
        drop(gone);
        if let Some(image) =
            context.objects.shared.renderbuffers.get(name).map(|gone| gone.image.clone())
        {
            detach(context, &image);
        }
        context.objects.shared.renderbuffers.remove(name);
    }
    context.objects.shared.sweep(Sweep::Deleted);
    Ok(())
}

pub(crate) fn bind_renderbuffer(
    context: &mut Context,
    target: GLenum,
    renderbuffer: GLuint,
) -> Result<()> {
    RENDERBUFFER_TARGET.decode("target", target)?;
    if context.profile.is_core() {
        context.objects.shared.renderbuffers.check_given(
            "renderbuffer",
            renderbuffer,
            "glGenRenderbuffers",
        )?;
    }
    let initial = initial_format(context);
    context.objects.shared.renderbuffers.create(renderbuffer, || Renderbuffer::new(initial));
    context.state.bindings.renderbuffer = context.objects.shared.renderbuffers.hold(renderbuffer);
    Ok(())
}

pub(crate) fn is_renderbuffer(context: &mut Context, renderbuffer: GLuint) -> Result<bool> {
    Ok(context.objects.shared.renderbuffers.get(renderbuffer).is_some())
}

/// A renderbuffer that is bound or named.
fn object<'a>(context: &'a mut Context, chosen: &Bound) -> Result<&'a mut Renderbuffer> {
    match context.objects.shared.renderbuffers.bound_mut(chosen) {
        Some(renderbuffer) => Ok(renderbuffer),
        None => invalid_operation(SECTION, "no renderbuffer is bound: call glBindRenderbuffer"),
    }
}

/// The renderbuffer of a name.
///
/// # Errors
/// `GL_INVALID_OPERATION` for a name that no renderbuffer has.
pub(crate) fn named(context: &mut Context, name: GLuint) -> Result<Bound> {
    let renderbuffers = &mut context.objects.shared.renderbuffers;
    match renderbuffers.get(name) {
        Some(_) => Ok(renderbuffers.hold(name)),
        None => invalid_operation(
            "ARB_direct_state_access, section 9.2.4",
            format!(
                "renderbuffer = {name} is no renderbuffer: glCreateRenderbuffers makes some, and so does binding a \
                 name once"
            ),
        ),
    }
}

/// The internal format that a new renderbuffer says it has (OpenGL ES 3.0, table 6.15).
pub(crate) fn initial_format(context: &Context) -> GLenum {
    if context.profile.is_es() { GL_RGBA4 } else { GL_RGBA }
}

/// The row of an internal format that renderbuffers may have.
fn checked_format(internal: GLenum) -> Result<&'static InternalFormat> {
    let format = match formats::find(internal) {
        Some(format) if !format.is_compressed() => format,
        Some(_) | None => UNCOMPRESSED.decode("internalformat", internal)?,
    };
    if !format.is_for_renderbuffers() {
        return invalid_enum(
            SECTION,
            format!(
                "internalformat = {} is of numbers that nothing is drawn to",
                enum_name(internal)
            ),
        );
    }
    Ok(format)
}

pub(crate) fn renderbuffer_storage(
    context: &mut Context,
    target: GLenum,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    renderbuffer_storage_multisample(context, target, 0, internalformat, width, height)
}

/// A checked `glRenderbufferStorage` or `glRenderbufferStorageMultisample`.
struct StorageRequest {
    renderbuffer: Bound,
    resolving: Resolving,
    format: &'static InternalFormat,
    size: [u32; 2],
    samples: u8,
}

impl StorageRequest {
    /// Supported are 1 and 4 samples; a count between them is rounded up to 4.
    fn new(
        context: &mut Context,
        renderbuffer: Bound,
        (samples, resolving): (GLsizei, Resolving),
        internal: GLenum,
        size: [GLsizei; 2],
    ) -> Result<Self> {
        let format = checked_format(internal)?;
        if context.profile.is_es() && !format.is_for_renderbuffers_in_es() {
            let internal = enum_name(internal);
            let rule = format!("internalformat = {internal} is none of renderbuffers of OpenGL ES");
            return invalid_enum("OpenGL ES 3.0, table 3.13", rule);
        }
        for (argument, size) in ["width", "height"].into_iter().zip(size) {
            if not_negative(SECTION, argument, size.into())? > limits::MAX_TEXTURE_SIZE as usize {
                return invalid_value(
                    SECTION,
                    format!("{argument} = {size} must not be above {}", limits::MAX_TEXTURE_SIZE),
                );
            }
        }
        if context.profile.is_es() && format.stored.is_integer() && samples > 0 {
            let rule = format!("samples = {samples} must be 0 with {}", enum_name(internal));
            return invalid_operation("OpenGL ES 3.0, section 4.4.2.1", rule);
        }
        if not_negative(SECTION, "samples", samples.into())? > usize::from(limits::MAX_SAMPLES) {
            // OpenGL ES names no other error of formats than of integers (3.0, section 4.4.2.1).
            if format.stored.is_integer() || context.profile.is_es() {
                return invalid_operation(
                    "ARB_texture_multisample, section 4.4.2",
                    format!(
                        "samples = {samples} of {} must not be above {}",
                        enum_name(internal),
                        limits::MAX_SAMPLES
                    ),
                );
            }
            return invalid_value(
                SECTION,
                format!("samples = {samples} must not be above {}", limits::MAX_SAMPLES),
            );
        }
        object(context, &renderbuffer)?;
        let samples = if samples > 0 { limits::MAX_SAMPLES } else { 1 };
        Ok(Self { renderbuffer, resolving, format, size: size.map(|side| side as u32), samples })
    }

    fn apply(self, context: &mut Context) -> Result<()> {
        let Self { renderbuffer, resolving, format, size: [width, height], samples } = self;
        let texels = if width > 0 && height > 0 {
            texels(format.stored, width, height)
                .map_err(|error| GlError::new(ErrorCode::OutOfMemory, SECTION, error.to_string()))?
        } else {
            Texels::new(Shape::D2)
        };
        let image = object(context, &renderbuffer)?.image.clone();
        // What was recorded draws to the image as it was.
        crate::draw::pass::submit_draws_to(context, &image);
        let renderbuffer = object(context, &renderbuffer)?;
        renderbuffer.siblings.specify(&image, Specified::All);
        image.replace(texels, samples, MultisampleStorage::Resolved);
        renderbuffer.format = format;
        renderbuffer.resolving = resolving;
        Ok(())
    }
}

pub(crate) fn renderbuffer_storage_multisample(
    context: &mut Context,
    target: GLenum,
    samples: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    RENDERBUFFER_TARGET.decode("target", target)?;
    let renderbuffer = context.state.bindings.renderbuffer.clone();
    set_storage(context, renderbuffer, samples, internalformat, [width, height])
}

/// Gives a renderbuffer a format, a size and a number of samples.
pub(crate) fn set_storage(
    context: &mut Context,
    renderbuffer: Bound,
    samples: GLsizei,
    internal: GLenum,
    size: [GLsizei; 2],
) -> Result<()> {
    let samples = (samples, Resolving::ByBlit);
    StorageRequest::new(context, renderbuffer, samples, internal, size)?.apply(context)
}

/// `glRenderbufferStorageMultisampleEXT`: in OpenGL, of `EXT_framebuffer_multisample`; in OpenGL ES, of
/// `EXT_multisampled_render_to_texture`, which reads pixels from it.
pub(crate) fn renderbuffer_storage_multisample_ext(
    context: &mut Context,
    target: GLenum,
    samples: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    const SECTION: &str = "EXT_multisampled_render_to_texture, section 4.4.2.1";
    RENDERBUFFER_TARGET.decode("target", target)?;
    let resolving =
        if context.profile.is_es() { Resolving::WhereItIsRead } else { Resolving::ByBlit };
    if context.profile.is_es() && samples > limits::MAX_SAMPLES.into() {
        let rule = format!("samples = {samples} must not be above {}", limits::MAX_SAMPLES);
        return invalid_value(SECTION, rule);
    }
    let renderbuffer = context.state.bindings.renderbuffer.clone();
    let (samples, size) = ((samples, resolving), [width, height]);
    StorageRequest::new(context, renderbuffer, samples, internalformat, size)?.apply(context)
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Width,
    Height,
    InternalFormat,
    Samples,
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
        (GL_RENDERBUFFER_STENCIL_SIZE, Property::Bits(Component::Stencil)),
    ],
};

pub(crate) fn get_renderbuffer_parameteriv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    RENDERBUFFER_TARGET.decode("target", target)?;
    let renderbuffer = context.state.bindings.renderbuffer.clone();
    parameter(context, &renderbuffer, pname, params)
}

/// Reads what is known of a renderbuffer.
pub(crate) fn parameter(
    context: &mut Context,
    chosen: &Bound,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let property = PROPERTY.decode("pname", pname)?;
    let renderbuffer = object(context, chosen)?;
    let (level, planes) = (renderbuffer.level(), renderbuffer.planes());
    let of_level = |f: &dyn Fn(LevelInfo) -> GLint| level.map_or(0, f);
    let value = match property {
        Property::Width => of_level(&|level| level.size[0] as GLint),
        Property::Height => of_level(&|level| level.size[1] as GLint),
        Property::InternalFormat => renderbuffer.format.name as GLint,
        Property::Samples => {
            of_level(&|level| if level.samples > 1 { level.samples.into() } else { 0 })
        }
        Property::Bits(Component::Depth) if !planes.depth => 0,
        Property::Bits(component) => of_level(&|level| component_bits(level.format, component)),
    };
    put(params, &[value])
}
