//! `glGetFramebufferAttachmentParameteriv`: `ARB_framebuffer_object`, section 6.1.13.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum, invalid_operation};
use crate::base::query_value::put;
use crate::base::types::*;
use crate::calls::framebuffer::names::bound;
use crate::context::Context;
use crate::draw::completeness::attached_format;
use crate::objects::framebuffers::{
    Attached, AttachedLayers, AttachmentPoint, FRAMEBUFFER_TARGET, Framebuffer, Source,
    attachment_point,
};
use crate::objects::target::{FACE_TARGET, TextureTarget};
use crate::pixel::component_bits::{Component, component_bits};
use rasterizer::driver::AttachmentSamples;
use texunit::format::{Block, Encoding, Format};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    ObjectType,
    ObjectName,
    Level,
    Face,
    Layer,
    Layered,
    /// Of `EXT_multisampled_render_to_texture`, in OpenGL ES.
    TextureSamples,
    Bits(Component),
    ComponentType,
    ColorEncoding,
}

const PROPERTY: Table<Property> = Table {
    section: "ARB_framebuffer_object, section 6.1.13",
    rows: &[
        (GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, Property::ObjectType),
        (GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, Property::ObjectName),
        (GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL, Property::Level),
        (GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE, Property::Face),
        (GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER, Property::Layer),
        (GL_FRAMEBUFFER_ATTACHMENT_LAYERED, Property::Layered),
        (GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_SAMPLES_EXT, Property::TextureSamples),
        (GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, Property::Bits(Component::Red)),
        (GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE, Property::Bits(Component::Green)),
        (GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE, Property::Bits(Component::Blue)),
        (GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE, Property::Bits(Component::Alpha)),
        (GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, Property::Bits(Component::Depth)),
        (GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE, Property::Bits(Component::Stencil)),
        (GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, Property::ComponentType),
        (GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING, Property::ColorEncoding),
    ],
};

const SECTION: &str = PROPERTY.section;

/// What is at a point of a framebuffer object; both points of depth and stencil must have the
/// same.
fn at(object: &Framebuffer, point: AttachmentPoint) -> Result<Option<&Attached>> {
    Ok(match point {
        AttachmentPoint::Color(index) => object.colors[index].as_ref(),
        AttachmentPoint::Depth => object.depth.as_ref(),
        AttachmentPoint::Stencil => object.stencil.as_ref(),
        AttachmentPoint::DepthStencil => match (&object.depth, &object.stencil) {
            (Some(depth), Some(stencil)) if depth.same(stencil) => Some(depth),
            (None, None) => None,
            (_, _) => {
                return invalid_operation(
                    SECTION,
                    "attachment = GL_DEPTH_STENCIL_ATTACHMENT, but depth and stencil are not the \
                     same image: ask for them one by one",
                );
            }
        },
    })
}

/// The component type of a format, as far as a point shows it.
fn component_type(context: &Context, format: Format, point: AttachmentPoint) -> GLenum {
    if point == AttachmentPoint::Stencil {
        // Which the stencil of a depth format is, too. OpenGL ES has no indices (3.0, section 6.1.13).
        return if context.profile.is_es() { GL_UNSIGNED_INT } else { GL_INDEX };
    }
    match format.info().encoding {
        Encoding::Float | Encoding::SharedExponent => GL_FLOAT,
        Encoding::Snorm => GL_SIGNED_NORMALIZED,
        Encoding::Uint => GL_UNSIGNED_INT,
        Encoding::Sint => GL_INT,
        Encoding::Block(Block::BptcUnsignedFloat | Block::BptcSignedFloat) => GL_FLOAT,
        Encoding::Unorm | Encoding::Srgb | Encoding::Block(_) | Encoding::SrgbBlock(_) => {
            GL_UNSIGNED_NORMALIZED
        }
    }
}

/// What every kind of attachment answers.
fn of_format(
    context: &Context,
    format: Format,
    point: AttachmentPoint,
    property: Property,
) -> Option<GLint> {
    match property {
        Property::Bits(component) => Some(component_bits(format, component)),
        Property::ComponentType => Some(component_type(context, format, point) as GLint),
        Property::ColorEncoding if format.is_srgb() => Some(GL_SRGB as GLint),
        Property::ColorEncoding => Some(GL_LINEAR as GLint),
        Property::ObjectType
        | Property::ObjectName
        | Property::Level
        | Property::Face
        | Property::Layer
        | Property::Layered
        | Property::TextureSamples => None,
    }
}

fn of_attached(
    context: &Context,
    attached: &Attached,
    point: AttachmentPoint,
    property: Property,
) -> Option<GLint> {
    match (property, attached.source) {
        (Property::ObjectType, Source::Texture { .. }) => Some(GL_TEXTURE as GLint),
        (Property::ObjectType, Source::Renderbuffer(_)) => Some(GL_RENDERBUFFER as GLint),
        (Property::ObjectName, Source::Texture { name, .. } | Source::Renderbuffer(name)) => {
            Some(name as GLint)
        }
        (Property::Level, Source::Texture { level, .. }) => Some(level as GLint),
        (Property::Layer, Source::Texture { slice, .. }) => Some(slice.into()),
        (Property::Layered, Source::Texture { layers, .. }) => {
            Some((layers == AttachedLayers::All).into())
        }
        (Property::TextureSamples, Source::Texture { .. }) => Some(match attached.samples {
            AttachmentSamples::Implicit(samples) => samples.into(),
            AttachmentSamples::OfImage => 0,
        }),
        (Property::Face, Source::Texture { target, .. }) => Some(match target.target {
            TextureTarget::Cube => FACE_TARGET.encode(target) as GLint,
            TextureTarget::D1
            | TextureTarget::D2
            | TextureTarget::D3
            | TextureTarget::Rect
            | TextureTarget::External
            | TextureTarget::D1Array
            | TextureTarget::D2Array
            | TextureTarget::CubeArray
            | TextureTarget::D2Multisample
            | TextureTarget::D2MultisampleArray
            | TextureTarget::Buffer => 0,
        }),
        (
            Property::Level
            | Property::Layer
            | Property::Layered
            | Property::TextureSamples
            | Property::Face,
            Source::Renderbuffer(_),
        ) => None,
        (Property::Bits(component), _) => {
            let hidden = match component {
                Component::Depth => !attached.planes.depth,
                Component::Stencil => !attached.planes.stencil,
                Component::Red
                | Component::Green
                | Component::Blue
                | Component::Alpha
                | Component::Luminance
                | Component::Intensity => false,
            };
            let format = attached_format(attached).filter(|_| !hidden);
            Some(format.map_or(0, |format| component_bits(format, component)))
        }
        (Property::ComponentType | Property::ColorEncoding, _) => match attached_format(attached) {
            Some(format) => of_format(context, format, point, property),
            // There is no image yet.
            None if property == Property::ComponentType => Some(GL_NONE as GLint),
            None => Some(GL_LINEAR as GLint),
        },
    }
}

/// What the default framebuffer answers for one of its buffers.
fn of_window(context: &Context, attachment: GLenum, property: Property) -> Result<Option<GLint>> {
    let window = &context.window;
    let planes = window.planes;
    let is_es = context.profile.is_es();
    let (there, format, point) = match attachment {
        // OpenGL ES 3.0, section 6.1.13, has one name of the colours.
        GL_FRONT | GL_LEFT | GL_FRONT_LEFT | GL_BACK_LEFT | GL_FRONT_RIGHT | GL_BACK_RIGHT
        | GL_RIGHT
            if is_es =>
        {
            let attachment = enum_name(attachment);
            let rule = format!("attachment = {attachment} must be GL_BACK, GL_DEPTH or GL_STENCIL");
            return invalid_enum("OpenGL ES 3.0, section 6.1.13", rule);
        }
        GL_FRONT | GL_BACK | GL_LEFT | GL_FRONT_LEFT | GL_BACK_LEFT => {
            (true, Some(window.format), AttachmentPoint::Color(0))
        }
        GL_FRONT_RIGHT | GL_BACK_RIGHT | GL_RIGHT => (false, None, AttachmentPoint::Color(0)),
        GL_DEPTH => (planes.depth, window.depth_format(), AttachmentPoint::Depth),
        GL_STENCIL => (planes.stencil, window.depth_format(), AttachmentPoint::Stencil),
        _ => {
            return invalid_enum(
                SECTION,
                format!(
                    "attachment = {} must be GL_FRONT_LEFT, GL_BACK_LEFT, GL_DEPTH or GL_STENCIL \
                     of the default framebuffer",
                    enum_name(attachment)
                ),
            );
        }
    };
    Ok(match (property, format) {
        (Property::ObjectType, _) if there => Some(GL_FRAMEBUFFER_DEFAULT as GLint),
        (Property::ObjectType, _) => Some(GL_NONE as GLint),
        (Property::ObjectName, _) if is_es => None,
        (Property::ObjectName, _) => Some(0),
        (_, Some(format)) => of_format(context, format, point, property),
        (_, None) => None,
    })
}

pub(crate) fn get_framebuffer_attachment_parameteriv(
    context: &mut Context,
    target: GLenum,
    attachment: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let name = bound(context, FRAMEBUFFER_TARGET.decode("target", target)?);
    attachment_parameter(context, name, attachment, pname, params)
}

/// Reads what is known of an attachment of a framebuffer.
pub(crate) fn attachment_parameter(
    context: &mut Context,
    name: GLuint,
    attachment: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    let property = PROPERTY.decode("pname", pname)?;
    if property == Property::TextureSamples && !context.profile.is_es() {
        return invalid_enum(SECTION, format!("pname = {} is of OpenGL ES", enum_name(pname)));
    }
    let value = match context.objects.framebuffers.get(name) {
        None => of_window(context, attachment, property)?,
        Some(object) => {
            let point = attachment_point(attachment)?;
            if point == AttachmentPoint::DepthStencil && property == Property::ComponentType {
                return invalid_operation(
                    SECTION,
                    "depth and stencil have no component type in common: ask for them one by one",
                );
            }
            match at(object, point)? {
                Some(attached) => of_attached(context, attached, point, property),
                None => match property {
                    Property::ObjectType => Some(GL_NONE as GLint),
                    Property::ObjectName => Some(0),
                    Property::Level
                    | Property::Face
                    | Property::Layer
                    | Property::Layered
                    | Property::TextureSamples
                    | Property::Bits(_)
                    | Property::ComponentType
                    | Property::ColorEncoding => {
                        return invalid_operation(
                            SECTION,
                            format!(
                                "nothing is attached to {}: {} cannot be asked for",
                                enum_name(attachment),
                                enum_name(pname)
                            ),
                        );
                    }
                },
            }
        }
    };
    match value {
        Some(value) => put(params, &[value]),
        None => invalid_enum(
            SECTION,
            format!("{} cannot be asked of what is attached", enum_name(pname)),
        ),
    }
}
