//! What OpenGL ES refuses of `glBlitFramebuffer` (3.0, section 4.3.3).

use crate::base::error::{Result, invalid_operation};
use crate::calls::framebuffer::blit::Sides;
use crate::context::Context;
use crate::context::window::format_of;
use crate::draw::completeness::{Aspect, samples};
use crate::draw::implicit_samples::samples_to_resolve;
use crate::pixel::formats::format_name;
use rasterizer::driver::Attachment;

const SECTION: &str = "OpenGL ES 3.0, section 4.3.3";

/// Checks the samples of an aspect of both framebuffers; `stays` says of each axis whether pixels go to where they were.
pub(super) fn check_samples(
    context: &Context,
    sides: Sides,
    (aspect, stays): (Aspect, [bool; 2]),
) -> Result<()> {
    let name = sides.draw;
    let drawn = samples(context, name);
    if drawn > 0 {
        let rule = format!(
            "framebuffer {name} has {drawn} samples a pixel: copy to one that has a single sample"
        );
        return invalid_operation(SECTION, rule);
    }
    if samples_to_resolve(context, sides.read, aspect) > 0 && stays != [true; 2] {
        let rule = "several samples a pixel are resolved in place: make both rectangles the same";
        return invalid_operation(SECTION, rule);
    }
    Ok(())
}

/// Checks the images that pixels go from and to: not the same one, and of one format where samples are resolved.
pub(super) fn check_images(
    context: &Context,
    sides: Sides,
    (aspect, from): (Aspect, &Attachment),
    to: &[Attachment],
) -> Result<()> {
    for to in to {
        let is_same =
            from.image.is_same_image(&to.image) && (from.face, from.level) == (to.face, to.level);
        if is_same {
            return invalid_operation(SECTION, "pixels are copied within one image: use another");
        }
        let (Some(from), Some(to)) = (format_of(from), format_of(to)) else { continue };
        if samples_to_resolve(context, sides.read, aspect) > 0 && from != to {
            let [from, to] = [from, to].map(format_name);
            let rule = format!("samples of {from} are not resolved to pixels of {to}");
            return invalid_operation(SECTION, rule);
        }
    }
    Ok(())
}
