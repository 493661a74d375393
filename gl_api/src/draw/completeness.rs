//! Framebuffer completeness (`ARB_framebuffer_object`, section 4.4.4): whether a framebuffer can be used, the pass that
//! a draw framebuffer is drawn in, and what is read from a read framebuffer.

use crate::base::constants::*;
use crate::base::error::{ErrorCode, GlError, Result};
use crate::base::types::*;
use crate::context::Context;
use crate::context::window::{Presence, base_level_attachment};
use crate::draw::es_completeness;
use crate::objects::color_buffers::attachment_index;
use crate::objects::framebuffers::{
    Attached, AttachedLayers, Framebuffer, Planes, Source, WithoutAttachments,
};
use crate::objects::target::TextureTarget;
use crate::pixel::formats::format_name;
use crate::pixel::texel::is_renderable;
use rasterizer::driver::{Attachment, LevelInfo, PassDesc, possible_samples};
use texunit::format::Format;

const SECTION: &str = "ARB_framebuffer_object, section 4.4.4";

/// Why a framebuffer cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Incomplete {
    /// What `glCheckFramebufferStatus` answers.
    pub status: GLenum,
    pub reason: String,
}

impl Incomplete {
    /// The reason, with the name of the framebuffer.
    pub fn rule(&self, name: GLuint) -> String {
        match name {
            0 => self.reason.clone(),
            _ => format!("framebuffer {name} is incomplete: {}", self.reason),
        }
    }
}

/// The image of an attachment, with its properties.
pub(crate) struct AttachedImage {
    pub format: Format,
    pub width: u32,
    pub height: u32,
    pub samples: u8,
    /// How many layers are attached, from that of the attachment on.
    pub layers: u16,
    pub attachment: Attachment,
}

/// The level that is attached, if there is one.
fn level_info(attached: &Attached) -> Option<LevelInfo> {
    match attached.source {
        Source::Texture { target, level, .. } => attached.image.level(target.face.into(), level),
        Source::Renderbuffer(_) => attached.image.level(0, 0),
    }
}

/// The format of what is attached, if it has one.
pub(crate) fn attached_format(attached: &Attached) -> Option<Format> {
    level_info(attached).map(|info| info.format)
}

/// The image behind an attachment, or what is missing.
fn find(attached: &Attached) -> std::result::Result<AttachedImage, String> {
    let info = level_info(attached).filter(|info| !info.size.contains(&0));
    let image = attached.image.clone();
    let found = |info: LevelInfo, attachment| AttachedImage {
        format: info.format,
        width: info.size[0],
        height: info.size[1],
        samples: info.samples,
        layers: 1,
        attachment,
    };
    match (attached.source, info) {
        (Source::Texture { name, level, .. }, None) => Err(format!(
            "texture {name} has no image at level {level}: call glTexImage2D with a size"
        )),
        (Source::Texture { name, level, .. }, Some(info)) if info.border != [0; 3] => {
            Err(format!("texture {name} has a border at level {level}, which cannot be drawn to"))
        }
        (Source::Texture { name, level, slice, .. }, Some(info))
            if u32::from(slice) >= info.size[2] =>
        {
            Err(format!(
                "texture {name} has {} slices or layers at level {level}, number {slice} is none",
                info.size[2]
            ))
        }
        (Source::Texture { target, level, slice, .. }, Some(info)) => {
            let face = match target.target {
                TextureTarget::Cube => target.face.into(),
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
                | TextureTarget::Buffer => slice,
            };
            let samples = attached.samples;
            let attachment = Attachment { image, face, level: level as u8, samples };
            let (layers, samples) = (layer_count(attached, info)?, attachment.sample_count());
            Ok(AttachedImage { layers, samples, ..found(info, attachment) })
        }
        (Source::Renderbuffer(name), None) => {
            Err(format!("renderbuffer {name} has no image: call glRenderbufferStorage with a size"))
        }
        (Source::Renderbuffer(_), Some(info)) => Ok(found(info, base_level_attachment(&image))),
    }
}

/// How many layers of an image are attached, or why not all of a cube map can be.
fn layer_count(attached: &Attached, info: LevelInfo) -> std::result::Result<u16, String> {
    let Source::Texture { target, level, layers: AttachedLayers::All, name, .. } = attached.source
    else {
        return Ok(1);
    };
    if target.target != TextureTarget::Cube {
        return Ok(info.size[2].min(u16::MAX.into()) as u16);
    }
    let is_alike = |face| {
        attached
            .image
            .level(face, level)
            .is_some_and(|other| (other.format, other.size) == (info.format, info.size))
    };
    if (1..6).all(is_alike) {
        return Ok(6);
    }
    Err(format!("the faces of texture {name} differ at level {level}, and all are attached"))
}

/// Whether an attachment is layered, and the target of its texture.
fn layered(attached: &Attached) -> (AttachedLayers, Option<TextureTarget>) {
    match attached.source {
        Source::Texture { layers, target, .. } => (layers, Some(target.target)),
        Source::Renderbuffer(_) => (AttachedLayers::One, None),
    }
}

/// Why the layers of attachments do not fit each other, if so (GL 3.2, section 4.4.4.2).
fn layers_differ(object: &Framebuffer) -> Option<&'static str> {
    let mut all = object.attached().map(layered);
    let (first, _) = all.next()?;
    if all.any(|(layers, _)| layers != first) {
        return Some("some attachments are layered (glFramebufferTexture), others are not");
    }
    let mut targets = object.colors.iter().flatten().map(|attached| layered(attached).1);
    let target = targets.next()?;
    (first == AttachedLayers::All && targets.any(|other| other != target))
        .then_some("the layered colour attachments are of textures of different targets")
}

/// `GL_TEXTURE_FIXED_SAMPLE_LOCATIONS` of an attachment, which is true for renderbuffers; `None` for a texture that was
/// deleted.
fn fixed_locations(context: &Context, attached: &Attached) -> Option<bool> {
    match attached.source {
        Source::Renderbuffer(_) => Some(true),
        Source::Texture { name, .. } => {
            let texture = context.objects.shared.textures.get(name);
            let texture = texture.filter(|texture| texture.image.is_same_image(&attached.image))?;
            Some(texture.samples.is_none_or(|samples| samples.fixed_locations))
        }
    }
}

/// The aspects of a framebuffer: what an attachment point holds, and what is read, copied or drawn to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Aspect {
    Color,
    Depth,
    Stencil,
}

/// Why an image cannot be at a point, if so.
fn unsuitable(attached: &Attached, aspect: Aspect, found: &AttachedImage) -> Option<String> {
    let format = found.format;
    if !is_renderable(format) {
        return Some(format!("nothing is drawn to images of {}", format_name(format)));
    }
    match aspect {
        Aspect::Color if format.is_depth() => Some("a depth format cannot be a colour".to_owned()),
        Aspect::Depth if !(format.is_depth() && attached.planes.depth) => {
            Some("its format has no depth".to_owned())
        }
        Aspect::Stencil if !(format.has_stencil() && attached.planes.stencil) => {
            Some("its format has no stencil".to_owned())
        }
        Aspect::Color | Aspect::Depth | Aspect::Stencil => None,
    }
}

/// Whether a framebuffer (0 is the default one, which is complete) can be used.
pub(crate) fn completeness(context: &Context, name: GLuint) -> std::result::Result<(), Incomplete> {
    let incomplete = |status, reason: String| Err(Incomplete { status, reason });
    let Some(object) = context.objects.framebuffers.get(name) else {
        return match context.window.presence {
            Presence::Present => Ok(()),
            Presence::Absent => incomplete(
                GL_FRAMEBUFFER_UNDEFINED,
                "the context is current without a surface: bind a framebuffer object".into(),
            ),
        };
    };
    let (mut samples, mut locations) = (None, None);
    let colors =
        object.colors.iter().enumerate().map(|(index, attached)| (attached, Aspect::Color, index));
    let others = [(&object.depth, Aspect::Depth, 0), (&object.stencil, Aspect::Stencil, 0)];
    for (attached, aspect, index) in colors.chain(others) {
        let Some(attached) = attached else { continue };
        let point = || match aspect {
            Aspect::Color => format!("GL_COLOR_ATTACHMENT{index}"),
            Aspect::Depth => "GL_DEPTH_ATTACHMENT".to_owned(),
            Aspect::Stencil => "GL_STENCIL_ATTACHMENT".to_owned(),
        };
        let reason = match find(attached) {
            Ok(found) => {
                let first = *samples.get_or_insert(found.samples);
                if first != found.samples {
                    return incomplete(
                        GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE,
                        format!(
                            "{} has {} samples a pixel, the attachments before have {first}",
                            point(),
                            found.samples
                        ),
                    );
                }
                if let Some(fixed) = fixed_locations(context, attached)
                    && *locations.get_or_insert(fixed) != fixed
                {
                    return incomplete(
                        GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE,
                        format!(
                            "{}: fixedsamplelocations differs from that of others (renderbuffers \
                             have GL_TRUE)",
                            point()
                        ),
                    );
                }
                let in_es = || es_completeness::unsuitable(context, attached, aspect);
                unsuitable(attached, aspect, &found)
                    .or_else(|| if context.profile.is_es() { in_es() } else { None })
            }
            Err(reason) => Some(reason),
        };
        if let Some(reason) = reason {
            // An image with a border is a complete attachment by EXT_framebuffer_object, section 4.4.4.1.
            let has_border = level_info(attached).is_some_and(|info| info.border != [0; 3]);
            let status = match has_border {
                true => GL_FRAMEBUFFER_UNSUPPORTED,
                false => GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT,
            };
            return incomplete(status, format!("{}: {reason}", point()));
        }
    }
    if samples.is_none() {
        let WithoutAttachments { width, height, .. } = object.without_attachments;
        if width > 0 && height > 0 {
            return Ok(());
        }
        return incomplete(
            GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT,
            "nothing is attached: call glFramebufferTexture2D or glFramebufferRenderbuffer".into(),
        );
    }
    if let Some(reason) = layers_differ(object) {
        return incomplete(GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS, reason.into());
    }
    if let (Some(depth), Some(stencil)) = (&object.depth, &object.stencil)
        && !depth.same(stencil)
    {
        return incomplete(
            GL_FRAMEBUFFER_UNSUPPORTED,
            "depth and stencil must be one image, of GL_DEPTH24_STENCIL8 or \
             GL_DEPTH32F_STENCIL8: attach it to GL_DEPTH_STENCIL_ATTACHMENT"
                .to_owned(),
        );
    }
    Ok(())
}

/// The draw or read buffer that is selected but has no attachment, if there is one. Such a framebuffer is complete by
/// OpenGL 4.1, and in drivers of all versions; what is drawn there is dropped. `ARB_framebuffer_object` calls it
/// incomplete.
pub(crate) fn missing_buffer_warning(object: &Framebuffer) -> Option<String> {
    let absent = |buffer: GLenum| {
        attachment_index(buffer).is_some_and(|index| object.colors[index].is_none())
    };
    if let Some(&buffer) = object.selection.draw.iter().find(|&&buffer| absent(buffer)) {
        return Some(format!(
            "{} is drawn to, but nothing is attached there; without colours call \
             glDrawBuffer(GL_NONE)",
            enum_name(buffer)
        ));
    }
    absent(object.selection.read).then(|| {
        format!(
            "{} is read from, but nothing is attached there; without colours call \
             glReadBuffer(GL_NONE)",
            enum_name(object.selection.read)
        )
    })
}

/// [`completeness`] as the error of a call that needs it.
pub(crate) fn checked_complete(context: &Context, name: GLuint) -> Result<()> {
    completeness(context, name).map_err(|incomplete| {
        GlError::new(ErrorCode::InvalidFramebufferOperation, SECTION, incomplete.rule(name))
    })
}

/// Checks that the draw framebuffer can be drawn to, for calls that need no [`draw_pass`].
///
/// # Errors
/// `GL_INVALID_FRAMEBUFFER_OPERATION` where it is incomplete.
pub(crate) fn checked_drawable(context: &Context) -> Result<()> {
    checked_complete(context, context.state.bindings.draw_framebuffer)
}

/// Which of depth and stencil the draw framebuffer has.
pub(crate) fn draw_planes(context: &Context) -> Planes {
    draw_planes_of(context, context.state.bindings.draw_framebuffer)
}

/// Which of depth and stencil a framebuffer has.
pub(crate) fn draw_planes_of(context: &Context, name: GLuint) -> Planes {
    match context.objects.framebuffers.get(name) {
        Some(object) => Planes { depth: object.depth.is_some(), stencil: object.stencil.is_some() },
        None => context.window.planes,
    }
}

/// The formats of all colour buffers that are drawn to.
pub(crate) fn drawn_formats(context: &Context) -> impl Iterator<Item = Format> {
    let object = context.objects.framebuffers.get(context.state.bindings.draw_framebuffer);
    let attached = object.into_iter().flat_map(|object| {
        let indices = object.selection.draw.iter().filter_map(|&buffer| attachment_index(buffer));
        indices.filter_map(|index| attached_format(object.colors[index].as_ref()?))
    });
    let window = &context.window;
    let draws = object.is_none() && window.selection.draw[0] != GL_NONE;
    attached.chain(draws.then_some(window.format))
}

/// Whether the first colour that is drawn to is of integers.
pub(crate) fn draws_integers(context: &Context) -> bool {
    let object = context.objects.framebuffers.get(context.state.bindings.draw_framebuffer);
    let format = object.and_then(|object| {
        let index = attachment_index(object.selection.draw[0])?;
        attached_format(object.colors[index].as_ref()?)
    });
    format.is_some_and(Format::is_integer)
}

/// The pass that the draw framebuffer is drawn in; colours by fragment output. Whether depth and
/// stencil are there is said by [`draw_planes`].
///
/// # Errors
/// `GL_INVALID_FRAMEBUFFER_OPERATION` where it is incomplete.
pub(crate) fn draw_pass(context: &Context) -> Result<PassDesc> {
    draw_pass_of(context, context.state.bindings.draw_framebuffer)
}

/// [`draw_pass`] of a framebuffer that need not be bound.
pub(crate) fn draw_pass_of(context: &Context, name: GLuint) -> Result<PassDesc> {
    checked_complete(context, name)?;
    let Some(object) = context.objects.framebuffers.get(name) else {
        let window = &context.window;
        let color =
            (window.selection.draw[0] != GL_NONE).then(|| base_level_attachment(&window.color));
        return Ok(PassDesc {
            colors: vec![color],
            depth: window.depth.as_ref().map(base_level_attachment),
            width: window.width,
            height: window.height,
            layers: 1,
            samples: 1,
        });
    };
    if object.attached().next().is_none() {
        let WithoutAttachments { width, height, layers, samples, .. } = object.without_attachments;
        let (colors, depth, layers) = (Vec::new(), None, layers.max(1));
        return Ok(PassDesc { colors, depth, width, height, layers, samples });
    }
    // Of attachments of different sizes, the pixels that all have are drawn to.
    let (mut width, mut height, mut layers) = (u32::MAX, u32::MAX, u16::MAX);
    for found in object.attached().filter_map(|attached| find(attached).ok()) {
        width = width.min(found.width);
        height = height.min(found.height);
        layers = layers.min(found.layers);
    }
    let found = |attached: &Option<Attached>| Some(find(attached.as_ref()?).ok()?.attachment);
    let mut colors: Vec<_> = object
        .selection
        .draw
        .iter()
        .map(|&buffer| attachment_index(buffer).and_then(|index| found(&object.colors[index])))
        .collect();
    let used = colors.iter().rposition(Option::is_some).map_or(0, |last| last + 1);
    colors.truncate(used);
    let depth = found(&object.depth).or_else(|| found(&object.stencil));
    Ok(PassDesc { colors, depth, width, height, layers, samples: samples(context, name) })
}

/// The image that is read from, if there is one.
pub(crate) fn read_attachment(context: &Context, aspect: Aspect) -> Result<Option<Attachment>> {
    read_attachment_of(context, context.state.bindings.read_framebuffer, aspect)
}

/// [`read_attachment`] of a framebuffer that need not be bound.
pub(crate) fn read_attachment_of(
    context: &Context,
    name: GLuint,
    aspect: Aspect,
) -> Result<Option<Attachment>> {
    checked_complete(context, name)?;
    let Some(object) = context.objects.framebuffers.get(name) else {
        let window = context.read_window();
        let depth =
            |there: bool| window.depth.as_ref().filter(|_| there).map(base_level_attachment);
        return Ok(match aspect {
            Aspect::Color => (context.window.selection.read != GL_NONE)
                .then(|| base_level_attachment(&window.color)),
            Aspect::Depth => depth(window.planes.depth),
            Aspect::Stencil => depth(window.planes.stencil),
        });
    };
    let attached = match aspect {
        Aspect::Color => {
            attachment_index(object.selection.read).and_then(|index| object.colors[index].as_ref())
        }
        Aspect::Depth => object.depth.as_ref(),
        Aspect::Stencil => object.stencil.as_ref(),
    };
    Ok(attached.and_then(|attached| find(attached).ok()).map(|found| found.attachment))
}

/// The number of samples of a framebuffer, 0 if it is not multisampled or incomplete.
pub(crate) fn samples(context: &Context, name: GLuint) -> u8 {
    let samples = match context.objects.framebuffers.get(name) {
        Some(object) => match object.attached().next() {
            Some(attached) => find(attached).map_or(1, |found| found.samples),
            None => possible_samples(object.without_attachments.samples),
        },
        None => context.window.color.samples(),
    };
    if samples > 1 { samples } else { 0 }
}

/// [`samples`] of a framebuffer that is read from.
pub(crate) fn read_samples(context: &Context, name: GLuint) -> u8 {
    match (name, &context.read_window) {
        (0, Some(window)) if window.color.samples() > 1 => window.color.samples(),
        (0, Some(_)) => 0,
        (name, _) => samples(context, name),
    }
}
