//! Parameters of framebuffers: `ARB_framebuffer_no_attachments`, and what OpenGL 4.5 reads beside them (table 23.73).

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value};
use crate::base::limits::{MAX_ARRAY_TEXTURE_LAYERS, MAX_SAMPLES, MAX_VIEWPORT_DIMS};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::framebuffer::names::bound;
use crate::calls::framebuffer::read::preferred;
use crate::context::Context;
use crate::context::window::format_of;
use crate::draw::completeness::{Aspect, read_attachment_of, samples};
use crate::objects::framebuffers::{FRAMEBUFFER_TARGET, WithoutAttachments};

const SECTION: &str = "ARB_framebuffer_no_attachments, section 9.2.1";

/// A parameter of a framebuffer object without attachments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum DefaultParameter {
    Width,
    Height,
    Layers,
    Samples,
    FixedLocations,
}

const DEFAULT: Table<DefaultParameter> = Table {
    section: SECTION,
    rows: &[
        (GL_FRAMEBUFFER_DEFAULT_WIDTH, DefaultParameter::Width),
        (GL_FRAMEBUFFER_DEFAULT_HEIGHT, DefaultParameter::Height),
        (GL_FRAMEBUFFER_DEFAULT_LAYERS, DefaultParameter::Layers),
        (GL_FRAMEBUFFER_DEFAULT_SAMPLES, DefaultParameter::Samples),
        (GL_FRAMEBUFFER_DEFAULT_FIXED_SAMPLE_LOCATIONS, DefaultParameter::FixedLocations),
    ],
};

/// What is known of every framebuffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Known {
    DoubleBuffer,
    Stereo,
    Samples,
    SampleBuffers,
    ReadFormat,
    ReadType,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Parameter {
    Default(DefaultParameter),
    Known(Known),
}

const PARAMETER: Table<Parameter> = Table {
    section: "GL 4.5, section 9.2.3",
    rows: &[
        (GL_FRAMEBUFFER_DEFAULT_WIDTH, Parameter::Default(DefaultParameter::Width)),
        (GL_FRAMEBUFFER_DEFAULT_HEIGHT, Parameter::Default(DefaultParameter::Height)),
        (GL_FRAMEBUFFER_DEFAULT_LAYERS, Parameter::Default(DefaultParameter::Layers)),
        (GL_FRAMEBUFFER_DEFAULT_SAMPLES, Parameter::Default(DefaultParameter::Samples)),
        (
            GL_FRAMEBUFFER_DEFAULT_FIXED_SAMPLE_LOCATIONS,
            Parameter::Default(DefaultParameter::FixedLocations),
        ),
        (GL_DOUBLEBUFFER, Parameter::Known(Known::DoubleBuffer)),
        (GL_STEREO, Parameter::Known(Known::Stereo)),
        (GL_SAMPLES, Parameter::Known(Known::Samples)),
        (GL_SAMPLE_BUFFERS, Parameter::Known(Known::SampleBuffers)),
        (GL_IMPLEMENTATION_COLOR_READ_FORMAT, Parameter::Known(Known::ReadFormat)),
        (GL_IMPLEMENTATION_COLOR_READ_TYPE, Parameter::Known(Known::ReadType)),
    ],
};

/// The framebuffer object that is bound to a target.
fn bound_object(context: &Context, target: GLenum) -> Result<GLuint> {
    Ok(bound(context, FRAMEBUFFER_TARGET.decode("target", target)?))
}

pub(crate) fn framebuffer_parameteri(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    param: GLint,
) -> Result<()> {
    let name = bound_object(context, target)?;
    set_parameter(context, name, pname, param)
}

/// Sets a parameter of a framebuffer, 0 the default one, which has none.
pub(crate) fn set_parameter(
    context: &mut Context,
    name: GLuint,
    pname: GLenum,
    param: GLint,
) -> Result<()> {
    let parameter = DEFAULT.decode("pname", pname)?;
    let most = match parameter {
        DefaultParameter::Width | DefaultParameter::Height => MAX_VIEWPORT_DIMS,
        DefaultParameter::Layers => MAX_ARRAY_TEXTURE_LAYERS,
        DefaultParameter::Samples => MAX_SAMPLES.into(),
        DefaultParameter::FixedLocations => u32::MAX,
    };
    let value = match (parameter, u32::try_from(param)) {
        (DefaultParameter::FixedLocations, _) => u32::from(param != 0),
        (_, Ok(value)) if value <= most => value,
        (_, _) => {
            return invalid_value(
                SECTION,
                format!("param = {param} must be 0 to {most} for {}", enum_name(pname)),
            );
        }
    };
    let Some(object) = context.objects.framebuffers.get_mut(name) else {
        return no_object();
    };
    let defaults = &mut object.without_attachments;
    match parameter {
        DefaultParameter::Width => defaults.width = value,
        DefaultParameter::Height => defaults.height = value,
        DefaultParameter::Layers => defaults.layers = value as u16,
        DefaultParameter::Samples => defaults.samples = value as u8,
        DefaultParameter::FixedLocations => defaults.fixed_locations = value != 0,
    }
    Ok(())
}

fn no_object<T>() -> Result<T> {
    invalid_operation(
        SECTION,
        "the default framebuffer has no such parameter: bind a framebuffer object",
    )
}

pub(crate) fn get_framebuffer_parameteriv(
    context: &mut Context,
    target: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let name = bound_object(context, target)?;
    parameter(context, name, pname, params)
}

/// Reads a parameter of a framebuffer, 0 the default one.
pub(crate) fn parameter(
    context: &Context,
    name: GLuint,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let pixels = || {
        let attachment = read_attachment_of(context, name, Aspect::Color).ok().flatten();
        let format = attachment.and_then(|found| format_of(&found));
        format.map_or((GL_RGBA, GL_UNSIGNED_BYTE), preferred)
    };
    let samples = || GLint::from(samples(context, name));
    let value = match PARAMETER.decode("pname", pname)? {
        Parameter::Default(parameter) => {
            let Some(object) = context.objects.framebuffers.get(name) else {
                return no_object();
            };
            let WithoutAttachments { width, height, layers, samples, fixed_locations } =
                object.without_attachments;
            match parameter {
                DefaultParameter::Width => width as GLint,
                DefaultParameter::Height => height as GLint,
                DefaultParameter::Layers => layers.into(),
                DefaultParameter::Samples => samples.into(),
                DefaultParameter::FixedLocations => fixed_locations.into(),
            }
        }
        Parameter::Known(Known::DoubleBuffer | Known::Stereo) => 0,
        Parameter::Known(Known::Samples) => samples(),
        Parameter::Known(Known::SampleBuffers) => i32::from(samples() > 0),
        Parameter::Known(Known::ReadFormat) => pixels().0 as GLint,
        Parameter::Known(Known::ReadType) => pixels().1 as GLint,
    };
    put(params, &[value])
}
