//! Attaching images to framebuffer objects: `ARB_framebuffer_object`, sections 4.4.2 to 4.4.4.

use super::buffers::attachment_index;
use super::complete::{bits, completeness};
use crate::constants::*;
use crate::context::{Context, limits};
use crate::error::{Result, Table, invalid_enum, invalid_operation, invalid_value};
use crate::object::framebuffers::{Attached, FRAMEBUFFER_TARGET, Framebuffer, bound};
use crate::query::put;
use crate::texture::internal::Component;
use crate::texture::{FACE_TARGET, TARGET};
use crate::types::*;

const SECTION: &str = "ARB_framebuffer_object, section 4.4.2";

/// A place where an image can be attached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Point {
    Color(usize),
    Depth,
}

fn point(attachment: GLenum) -> Result<Point> {
    match attachment {
        GL_DEPTH_ATTACHMENT => Ok(Point::Depth),
        _ => match attachment_index(attachment) {
            Some(index) => Ok(Point::Color(index)),
            None => invalid_enum(
                SECTION,
                format!(
                    "attachment = {} must be GL_COLOR_ATTACHMENT0 to {}, or GL_DEPTH_ATTACHMENT",
                    enum_name(attachment),
                    limits::MAX_COLOR_ATTACHMENTS - 1
                ),
            ),
        },
    }
}

/// The bound framebuffer object.
fn object(context: &mut Context, target: GLenum) -> Result<&mut Framebuffer> {
    let name = bound(context, FRAMEBUFFER_TARGET.decode("target", target)?);
    match context.objects.framebuffers.get_mut(name) {
        Some(object) => Ok(object),
        None => invalid_operation(
            SECTION,
            "the default framebuffer is bound, which takes no attachments: call glBindFramebuffer",
        ),
    }
}

fn attach(
    context: &mut Context,
    target: GLenum,
    point: Point,
    attached: Option<Attached>,
) -> Result<()> {
    let object = object(context, target)?;
    match point {
        Point::Color(index) => object.colors[index] = attached,
        Point::Depth => object.depth = attached,
    }
    Ok(())
}

pub(crate) fn framebuffer_texture_2d(
    context: &mut Context,
    target: GLenum,
    attachment: GLenum,
    textarget: GLenum,
    texture: GLuint,
    level: GLint,
) -> Result<()> {
    FRAMEBUFFER_TARGET.decode("target", target)?;
    let point = point(attachment)?;
    if texture == 0 {
        return attach(context, target, point, None);
    }
    let face = FACE_TARGET.decode("textarget", textarget)?;
    let Some(object) = context.objects.textures.get(texture) else {
        return invalid_operation(
            SECTION,
            format!("texture = {texture} is no texture that was bound"),
        );
    };
    if object.target != face.target {
        return invalid_operation(
            SECTION,
            format!(
                "texture {texture} is a {}, textarget = {} does not fit",
                enum_name(TARGET.encode(object.target)),
                enum_name(textarget)
            ),
        );
    }
    let level = match usize::try_from(level) {
        Ok(level) if level < limits::MAX_TEXTURE_LEVELS => level,
        _ => {
            return invalid_value(
                SECTION,
                format!("level = {level} must be 0 to {}", limits::MAX_TEXTURE_LEVELS - 1),
            );
        }
    };
    let attached = Attached::Texture { name: texture, target: face, level };
    attach(context, target, point, Some(attached))
}

pub(crate) fn framebuffer_renderbuffer(
    context: &mut Context,
    target: GLenum,
    attachment: GLenum,
    renderbuffertarget: GLenum,
    renderbuffer: GLuint,
) -> Result<()> {
    const KIND: Table<()> = Table { section: SECTION, rows: &[(GL_RENDERBUFFER, ())] };
    FRAMEBUFFER_TARGET.decode("target", target)?;
    let point = point(attachment)?;
    KIND.decode("renderbuffertarget", renderbuffertarget)?;
    if renderbuffer == 0 {
        return attach(context, target, point, None);
    }
    if context.objects.renderbuffers.get(renderbuffer).is_none() {
        return invalid_operation(
            SECTION,
            format!("renderbuffer = {renderbuffer} is no renderbuffer that was bound"),
        );
    }
    attach(context, target, point, Some(Attached::Renderbuffer(renderbuffer)))
}

/// Says why a framebuffer is incomplete, as a message.
pub(crate) fn check_framebuffer_status(context: &mut Context, target: GLenum) -> Result<GLenum> {
    let name = bound(context, FRAMEBUFFER_TARGET.decode("target", target)?);
    Ok(match completeness(context, name) {
        Ok(()) => GL_FRAMEBUFFER_COMPLETE,
        Err(incomplete) => {
            context.debug.warn(format!("glCheckFramebufferStatus: {}", incomplete.reason));
            incomplete.status
        }
    })
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    ObjectType,
    ObjectName,
    Level,
    Face,
    Layer,
    Bits(Component),
    StencilBits,
}

const PROPERTY: Table<Property> = Table {
    section: "ARB_framebuffer_object, section 6.1.13",
    rows: &[
        (GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, Property::ObjectType),
        (GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, Property::ObjectName),
        (GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL, Property::Level),
        (GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE, Property::Face),
        (GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER, Property::Layer),
        (GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, Property::Bits(Component::Red)),
        (GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE, Property::Bits(Component::Green)),
        (GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE, Property::Bits(Component::Blue)),
        (GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE, Property::Bits(Component::Alpha)),
        (GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, Property::Bits(Component::Depth)),
        (GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE, Property::StencilBits),
    ],
};

pub(crate) fn get_framebuffer_attachment_parameteriv(
    context: &mut Context,
    target: GLenum,
    attachment: GLenum,
    pname: GLenum,
    params: &mut [GLint],
) -> Result<()> {
    const SECTION: &str = PROPERTY.section;
    FRAMEBUFFER_TARGET.decode("target", target)?;
    let point = point(attachment)?;
    let property = PROPERTY.decode("pname", pname)?;
    let object = object(context, target)?;
    let attached = match point {
        Point::Color(index) => object.colors[index],
        Point::Depth => object.depth,
    };
    let value = match (property, attached) {
        (Property::ObjectType, None) => GL_NONE as GLint,
        (Property::ObjectType, Some(Attached::Texture { .. })) => GL_TEXTURE as GLint,
        (Property::ObjectType, Some(Attached::Renderbuffer(_))) => GL_RENDERBUFFER as GLint,
        (Property::ObjectName, None) => 0,
        (
            Property::ObjectName,
            Some(Attached::Texture { name, .. } | Attached::Renderbuffer(name)),
        ) => name as GLint,
        (Property::Level, Some(Attached::Texture { level, .. })) => level as GLint,
        (Property::Layer, Some(Attached::Texture { .. })) => 0,
        (Property::Face, Some(Attached::Texture { target, .. })) => {
            if TARGET.encode(target.target) == GL_TEXTURE_CUBE_MAP {
                FACE_TARGET.encode(target) as GLint
            } else {
                0
            }
        }
        (Property::Bits(component), Some(attached)) => bits(context, attached, component),
        (Property::StencilBits, Some(_)) => 0,
        (
            Property::Level
            | Property::Face
            | Property::Layer
            | Property::Bits(_)
            | Property::StencilBits,
            None | Some(Attached::Renderbuffer(_)),
        ) => {
            return invalid_enum(
                SECTION,
                format!("{} cannot be asked of what is attached", enum_name(pname)),
            );
        }
    };
    put(params, &[value])
}

/// Takes a deleted image from the bound framebuffers.
fn detach(context: &mut Context, gone: impl Fn(Attached) -> bool) {
    let bindings = &context.state.bindings;
    for name in [bindings.draw_framebuffer, bindings.read_framebuffer] {
        if let Some(object) = context.objects.framebuffers.get_mut(name) {
            for point in object.points() {
                if point.is_some_and(&gone) {
                    *point = None;
                }
            }
        }
    }
}

/// Takes a deleted texture from the bound framebuffers.
pub(crate) fn detach_texture(context: &mut Context, texture: GLuint) {
    detach(
        context,
        |attached| matches!(attached, Attached::Texture { name, .. } if name == texture),
    );
}

/// Takes a deleted renderbuffer from the bound framebuffers.
pub(crate) fn detach_renderbuffer(context: &mut Context, renderbuffer: GLuint) {
    detach(context, |attached| attached == Attached::Renderbuffer(renderbuffer));
}
