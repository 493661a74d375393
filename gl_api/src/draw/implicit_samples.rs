//! Samples that are resolved without a blit (`EXT_multisampled_render_to_texture`): those of textures that were attached
//! with `glFramebufferTexture2DMultisampleEXT`, and in OpenGL ES those of `glRenderbufferStorageMultisampleEXT`.

use crate::base::types::GLuint;
use crate::context::Context;
use crate::draw::completeness::{Aspect, read_samples};
use crate::objects::color_buffers::attachment_index;
use crate::objects::framebuffers::{Attached, Source};
use crate::objects::renderbuffers::Resolving;
use rasterizer::driver::AttachmentSamples;

/// Whether what is read from an attachment are pixels, whatever samples it has.
fn is_implicit(context: &Context, attached: &Attached) -> bool {
    match (attached.samples, attached.source) {
        (AttachmentSamples::Implicit(_), _) => true,
        (AttachmentSamples::OfImage, Source::Texture { .. }) => false,
        (AttachmentSamples::OfImage, Source::Renderbuffer(name)) => {
            let buffer = context.objects.shared.renderbuffers.get(name);
            let buffer = buffer.filter(|buffer| buffer.image.is_same_image(&attached.image));
            buffer.is_some_and(|buffer| buffer.resolving == Resolving::WhereItIsRead)
        }
    }
}

/// How many samples of an aspect of a framebuffer only `glBlitFramebuffer` resolves: 0 where pixels are read from it.
pub(crate) fn samples_to_resolve(context: &Context, name: GLuint, aspect: Aspect) -> u8 {
    let object = context.objects.framebuffers.get(name);
    let attached = object.and_then(|object| match aspect {
        Aspect::Color => object.colors[attachment_index(object.selection.read)?].as_ref(),
        Aspect::Depth => object.depth.as_ref(),
        Aspect::Stencil => object.stencil.as_ref(),
    });
    match attached {
        Some(attached) if is_implicit(context, attached) => 0,
        Some(_) | None => read_samples(context, name),
    }
}
