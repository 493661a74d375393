//! Attaching images to framebuffer objects: `ARB_framebuffer_object`, sections 4.4.2 to 4.4.4.

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum, invalid_operation, invalid_value};
use crate::base::limits;
use crate::base::types::*;
use crate::calls::framebuffer::names::bound;
use crate::context::Context;
use crate::draw::completeness::{completeness, missing_buffer_warning};
use crate::objects::framebuffers::{
    Attached, AttachedLayers, AttachmentPoint, FRAMEBUFFER_TARGET, Source, attachment_point,
};
use crate::objects::renderbuffers::RENDERBUFFER_TARGET;
use crate::objects::target::{FaceTarget, TARGET, TextureTarget, attachable_target};
use crate::objects::texture::Texture;
use rasterizer::driver::{AttachmentSamples, Image};
use texunit::image::FACES;

const SECTION: &str = "ARB_framebuffer_object, section 4.4.2";

/// The framebuffer and the attachment point that a call names.
#[derive(Clone, Copy)]
pub(crate) struct Destination {
    framebuffer: GLuint,
    point: AttachmentPoint,
}

impl Destination {
    fn decode(context: &Context, target: GLenum, attachment: GLenum) -> Result<Self> {
        let binding = FRAMEBUFFER_TARGET.decode("target", target)?;
        Self::of(bound(context, binding), attachment)
    }

    /// A point of a framebuffer that need not be bound.
    pub fn of(framebuffer: GLuint, attachment: GLenum) -> Result<Self> {
        Ok(Self { framebuffer, point: attachment_point(attachment)? })
    }

    /// Attaches an image that was checked, or nothing.
    ///
    /// # Errors
    /// Where the default framebuffer is bound.
    fn attach(self, context: &mut Context, attached: Option<Attached>) -> Result<()> {
        let Some(object) = context.objects.framebuffers.get_mut(self.framebuffer) else {
            return invalid_operation(
                SECTION,
                "the default framebuffer is bound, which takes no attachments: call glBindFramebuffer",
            );
        };
        match self.point {
            AttachmentPoint::Color(index) => object.colors[index] = attached,
            AttachmentPoint::Depth => object.depth = attached,
            AttachmentPoint::Stencil => object.stencil = attached,
            AttachmentPoint::DepthStencil => {
                object.depth.clone_from(&attached);
                object.stencil = attached;
            }
        }
        Ok(())
    }
}

/// A slice of a level of a texture, as a call names it.
struct Slice {
    texture: GLuint,
    level: GLint,
    /// The layer or slice, and the argument's name.
    slice: (GLint, &'static str),
}

impl Slice {
    fn texture<'a>(&self, context: &'a Context) -> Result<&'a Texture> {
        match context.objects.shared.textures.get(self.texture) {
            Some(texture) => Ok(texture),
            None => invalid_operation(
                SECTION,
                format!("texture = {} is no texture that was bound", self.texture),
            ),
        }
    }

    /// Checks that the level and slice can be there.
    fn checked(&self, of: FaceTarget) -> Result<Source> {
        let &Self { texture: name, level, slice: (slice, argument) } = self;
        let level = crate::objects::target::checked_level(SECTION, of.target, level)?;
        let most = match of.target {
            TextureTarget::D3 => limits::MAX_3D_TEXTURE_SIZE,
            TextureTarget::D1Array
            | TextureTarget::D2Array
            | TextureTarget::CubeArray
            | TextureTarget::D2MultisampleArray => limits::MAX_ARRAY_TEXTURE_LAYERS,
            TextureTarget::D1
            | TextureTarget::D2
            | TextureTarget::Rect
            | TextureTarget::External
            | TextureTarget::Cube
            | TextureTarget::D2Multisample
            | TextureTarget::Buffer => 1,
        };
        let slice = match u16::try_from(slice) {
            Ok(slice) if u32::from(slice) < most => slice,
            Ok(_) | Err(_) => {
                return invalid_value(
                    SECTION,
                    format!("{argument} = {slice} must be 0 to {}", most - 1),
                );
            }
        };
        Ok(Source::Texture { name, target: of, level, slice, layers: AttachedLayers::One })
    }
}

/// `glFramebufferTexture1D`, `2D` and `3D`: the targets of a call with so many dimensions.
fn framebuffer_texture_slice(
    context: &mut Context,
    (target, attachment): (GLenum, GLenum),
    (axes, textarget): (usize, GLenum),
    (slice, samples): (&Slice, AttachmentSamples),
) -> Result<()> {
    let destination = Destination::decode(context, target, attachment)?;
    if slice.texture == 0 {
        return destination.attach(context, None);
    }
    let face = attachable_target(axes, textarget)?;
    let texture = slice.texture(context)?;
    if texture.target != face.target {
        return invalid_operation(
            SECTION,
            format!(
                "texture {} is a {}, textarget = {} does not fit",
                slice.texture,
                enum_name(TARGET.encode(texture.target)),
                enum_name(textarget)
            ),
        );
    }
    let (source, image) = (slice.checked(face)?, texture.image.clone());
    let planes = texture.planes();
    destination.attach(context, Some(Attached { source, image, planes, samples }))
}

pub(crate) fn framebuffer_texture_1d(
    context: &mut Context,
    target: GLenum,
    attachment: GLenum,
    textarget: GLenum,
    texture: GLuint,
    level: GLint,
) -> Result<()> {
    let slice = Slice { texture, level, slice: (0, "layer") };
    framebuffer_texture_slice(
        context,
        (target, attachment),
        (1, textarget),
        (&slice, AttachmentSamples::OfImage),
    )
}

pub(crate) fn framebuffer_texture_2d(
    context: &mut Context,
    target: GLenum,
    attachment: GLenum,
    textarget: GLenum,
    texture: GLuint,
    level: GLint,
) -> Result<()> {
    let slice = Slice { texture, level, slice: (0, "layer") };
    framebuffer_texture_slice(
        context,
        (target, attachment),
        (2, textarget),
        (&slice, AttachmentSamples::OfImage),
    )
}

/// `EXT_multisampled_render_to_texture`: as [`framebuffer_texture_2d`], with samples that the texture has while it is
/// drawn to through this attachment. They are resolved where something else reads it.
pub(crate) fn framebuffer_texture_2d_multisample(
    context: &mut Context,
    target: GLenum,
    attachment: GLenum,
    textarget: GLenum,
    texture: GLuint,
    level: GLint,
    samples: GLsizei,
) -> Result<()> {
    const SECTION: &str = "EXT_multisampled_render_to_texture, section 4.4.2.4";
    check_in_es(context, SECTION)?;
    FRAMEBUFFER_TARGET.decode("target", target)?;
    if attachment != GL_COLOR_ATTACHMENT0 {
        let attachment = enum_name(attachment);
        let rule = format!("attachment = {attachment} must be GL_COLOR_ATTACHMENT0");
        return invalid_enum(SECTION, rule);
    }
    let samples = match u8::try_from(samples) {
        Ok(0) => AttachmentSamples::OfImage,
        Ok(samples) if samples <= limits::MAX_SAMPLES => {
            AttachmentSamples::Implicit(limits::MAX_SAMPLES)
        }
        Ok(_) | Err(_) => {
            let rule = format!("samples = {samples} must be 0 to {}", limits::MAX_SAMPLES);
            return invalid_value(SECTION, rule);
        }
    };
    let slice = Slice { texture, level, slice: (0, "layer") };
    framebuffer_texture_slice(context, (target, attachment), (2, textarget), (&slice, samples))
}

/// Refuses a command that OpenGL ES alone has.
pub(crate) fn check_in_es(context: &Context, section: &'static str) -> Result<()> {
    if context.profile.is_es() {
        return Ok(());
    }
    invalid_operation(
        section,
        "is a command of OpenGL ES: attach a renderbuffer with several samples and call glBlitFramebuffer",
    )
}

pub(crate) fn framebuffer_texture_3d(
    context: &mut Context,
    target: GLenum,
    attachment: GLenum,
    textarget: GLenum,
    texture: GLuint,
    level: GLint,
    zoffset: GLint,
) -> Result<()> {
    let slice = Slice { texture, level, slice: (zoffset, "zoffset") };
    framebuffer_texture_slice(
        context,
        (target, attachment),
        (3, textarget),
        (&slice, AttachmentSamples::OfImage),
    )
}

pub(crate) fn framebuffer_texture_layer(
    context: &mut Context,
    target: GLenum,
    attachment: GLenum,
    texture: GLuint,
    level: GLint,
    layer: GLint,
) -> Result<()> {
    let destination = Destination::decode(context, target, attachment)?;
    attach_layer(context, destination, texture, level, layer)
}

/// Attaches a layer of a level of a texture.
pub(crate) fn attach_layer(
    context: &mut Context,
    destination: Destination,
    texture: GLuint,
    level: GLint,
    layer: GLint,
) -> Result<()> {
    if texture == 0 {
        return destination.attach(context, None);
    }
    let slice = Slice { texture, level, slice: (layer, "layer") };
    let object = slice.texture(context)?;
    let of = FaceTarget { target: object.target, face: 0 };
    let (of, slice) = match of.target {
        TextureTarget::Cube if context.profile.is_es() => {
            return invalid_operation(
                "OpenGL ES 3.0, section 4.4.2.4",
                format!(
                    "texture {texture} is a GL_TEXTURE_CUBE_MAP, which has no layers; attach a face with \
                     glFramebufferTexture2D"
                ),
            );
        }
        // Its faces are layers (GL 4.5, section 9.2.8), as Mesa has them in every version.
        TextureTarget::Cube => match u8::try_from(layer) {
            Ok(face) if usize::from(face) < FACES => {
                (FaceTarget { face, ..of }, Slice { slice: (0, "layer"), ..slice })
            }
            Ok(_) | Err(_) => {
                let rule = format!("layer = {layer} must be 0 to 5, a face of the cube map");
                return invalid_value("GL 4.5, section 9.2.8", rule);
            }
        },
        TextureTarget::D3
        | TextureTarget::D1Array
        | TextureTarget::D2Array
        | TextureTarget::CubeArray
        | TextureTarget::D2MultisampleArray => (of, slice),
        TextureTarget::D1
        | TextureTarget::D2
        | TextureTarget::Rect
        | TextureTarget::External
        | TextureTarget::D2Multisample
        | TextureTarget::Buffer => {
            return invalid_operation(
                SECTION,
                format!(
                    "texture {texture} is a {}, which has no layers",
                    enum_name(TARGET.encode(of.target))
                ),
            );
        }
    };
    let (source, image) = (slice.checked(of)?, object.image.clone());
    let planes = object.planes();
    destination.attach(
        context,
        Some(Attached { source, image, planes, samples: AttachmentSamples::OfImage }),
    )
}

pub(crate) fn framebuffer_texture(
    context: &mut Context,
    target: GLenum,
    attachment: GLenum,
    texture: GLuint,
    level: GLint,
) -> Result<()> {
    let destination = Destination::decode(context, target, attachment)?;
    attach_level(context, destination, texture, level)
}

/// Attaches all layers of a level of a texture, or its only one.
pub(crate) fn attach_level(
    context: &mut Context,
    destination: Destination,
    texture: GLuint,
    level: GLint,
) -> Result<()> {
    const SECTION: &str = "GL 3.2, section 4.4.2";
    if texture == 0 {
        return destination.attach(context, None);
    }
    let Some(object) = context.objects.shared.textures.get(texture) else {
        return invalid_value(SECTION, format!("texture = {texture} is no texture that was bound"));
    };
    let of = FaceTarget { target: object.target, face: 0 };
    let layers = match of.target {
        TextureTarget::D3
        | TextureTarget::D1Array
        | TextureTarget::D2Array
        | TextureTarget::Cube
        | TextureTarget::CubeArray
        | TextureTarget::D2MultisampleArray => AttachedLayers::All,
        TextureTarget::D1
        | TextureTarget::D2
        | TextureTarget::Rect
        | TextureTarget::External
        | TextureTarget::D2Multisample => AttachedLayers::One,
        TextureTarget::Buffer => {
            return invalid_operation(
                SECTION,
                format!("texture {texture} is a GL_TEXTURE_BUFFER, which is not drawn to"),
            );
        }
    };
    let (image, planes) = (object.image.clone(), object.planes());
    let level = crate::objects::target::checked_level(SECTION, of.target, level)?;
    let source = Source::Texture { name: texture, target: of, level, slice: 0, layers };
    destination.attach(
        context,
        Some(Attached { source, image, planes, samples: AttachmentSamples::OfImage }),
    )
}

pub(crate) fn framebuffer_renderbuffer(
    context: &mut Context,
    target: GLenum,
    attachment: GLenum,
    renderbuffertarget: GLenum,
    renderbuffer: GLuint,
) -> Result<()> {
    let destination = Destination::decode(context, target, attachment)?;
    attach_renderbuffer(context, destination, renderbuffertarget, renderbuffer)
}

/// Attaches a renderbuffer.
pub(crate) fn attach_renderbuffer(
    context: &mut Context,
    destination: Destination,
    renderbuffertarget: GLenum,
    renderbuffer: GLuint,
) -> Result<()> {
    RENDERBUFFER_TARGET.decode("renderbuffertarget", renderbuffertarget)?;
    if renderbuffer == 0 {
        return destination.attach(context, None);
    }
    let Some(object) = context.objects.shared.renderbuffers.get(renderbuffer) else {
        return invalid_operation(
            SECTION,
            format!("renderbuffer = {renderbuffer} is no renderbuffer that was bound"),
        );
    };
    let attached = Attached {
        source: Source::Renderbuffer(renderbuffer),
        image: object.image.clone(),
        planes: object.planes(),
        samples: AttachmentSamples::OfImage,
    };
    destination.attach(context, Some(attached))
}

pub(crate) fn check_framebuffer_status(context: &mut Context, target: GLenum) -> Result<GLenum> {
    let name = bound(context, FRAMEBUFFER_TARGET.decode("target", target)?);
    Ok(status(context, name))
}

/// Whether a framebuffer is complete. Says why not, as a message.
pub(crate) fn status(context: &mut Context, name: GLuint) -> GLenum {
    match completeness(context, name) {
        Ok(()) => {
            let object = context.objects.framebuffers.get(name);
            if let Some(reason) = object.and_then(missing_buffer_warning) {
                context.debug.warn(format!("glCheckFramebufferStatus: {reason}"));
            }
            GL_FRAMEBUFFER_COMPLETE
        }
        // That there is no surface is what programs ask for that make do without: MuJoCo.
        Err(incomplete) if incomplete.status == GL_FRAMEBUFFER_UNDEFINED => incomplete.status,
        Err(incomplete) => {
            context
                .debug
                .warn_each_time(format!("glCheckFramebufferStatus: {}", incomplete.rule(name)));
            incomplete.status
        }
    }
}

/// Takes a deleted image from the bound framebuffers. Its name is not asked for: an image that was deleted
/// before may have had the same one.
pub(crate) fn detach(context: &mut Context, gone: &Image) {
    let bindings = &context.state.bindings;
    for name in [bindings.draw_framebuffer, bindings.read_framebuffer] {
        if let Some(object) = context.objects.framebuffers.get_mut(name) {
            for point in object.points_mut() {
                point.take_if(|attached| attached.image.is_same_image(gone));
            }
        }
    }
}
