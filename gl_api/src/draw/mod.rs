//! Drawing: from calls to commands of the driver.
//!
//! The modules in the order in which vertices pass through them: arrays and immediate mode collect
//! them, the draw calls check them, the stages are chosen, and the translation records commands.

pub(crate) mod area;
pub(crate) mod bitmaps;
pub(crate) mod clamp;
pub(crate) mod material;
mod mirror;
pub(crate) mod multisample;
pub(crate) mod reach;
pub(crate) mod texture_buffer;
pub(crate) mod validate;
pub(crate) mod viewport;
pub(crate) mod zoom;

pub(crate) mod again;
pub(crate) mod array_names;
pub(crate) mod assembly;
pub(crate) mod assembly_words;
pub(crate) mod capture;
pub(crate) mod complete;
pub(crate) mod ended;
pub(crate) mod feedback;
pub(crate) mod fixed_words;
pub(crate) mod hints;
pub(crate) mod keys;
pub(crate) mod note;
pub(crate) mod primitives;
pub(crate) mod rectangle;
pub(crate) mod repeat;
pub(crate) mod srgb;
pub(crate) mod stages;
pub(crate) mod translate;
pub(crate) mod uniform_blocks;
pub(crate) mod vertex_stage;
pub(crate) mod words;

use crate::context::Context;
use rasterizer::driver::{Attachment, Command, Image, PassDesc};

fn same_attachment(a: Option<&Attachment>, b: Option<&Attachment>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a.image.same(&b.image) && a.face == b.face && a.level == b.level,
        (None, None) => true,
        (Some(_), None) | (None, Some(_)) => false,
    }
}

fn same_pass(a: &PassDesc, b: &PassDesc) -> bool {
    (a.width, a.height, a.colors.len()) == (b.width, b.height, b.colors.len())
        && same_attachment(a.depth.as_ref(), b.depth.as_ref())
        && a.colors.iter().zip(&b.colors).all(|(a, b)| same_attachment(a.as_ref(), b.as_ref()))
}

/// Goes on with the open pass if it draws to the same attachments, else opens one.
pub(crate) fn begin_pass(context: &mut Context, pass: PassDesc) {
    let recorder = &mut context.recorder;
    if recorder.is_full() {
        submit(context);
    } else if recorder.pass.as_ref().is_some_and(|open| same_pass(open, &pass)) {
        return;
    }
    let recorder = &mut context.recorder;
    recorder.end_pass();
    for attachment in pass.colors.iter().chain([&pass.depth]).flatten() {
        if !recorder.written.iter().any(|image| image.same(&attachment.image)) {
            recorder.written.push(attachment.image.clone());
        }
    }
    recorder.push(Command::BeginPass(pass.clone()));
    recorder.pass = Some(pass);
}

/// Carries out what was recorded, if it writes to an image that is about to be read or changed.
pub(crate) fn settle(context: &mut Context, image: &Image) {
    if context.recorder.written.iter().any(|written| written.same(image)) {
        submit(context);
    }
}

/// Carries out everything that was recorded.
pub(crate) fn submit(context: &mut Context) {
    ended::draw_ended(context);
    context.recorder.end_pass();
    context.objects.syncs.signal();
    let mut commands = std::mem::take(&mut context.recorder.commands);
    context.recorder.held = 0;
    if commands.commands.is_empty() {
        return;
    }
    context.outdate_mirror();
    let result = context.recorder.device.submit(&commands);
    // Their memory is that of the next.
    commands.commands.clear();
    context.recorder.commands = commands;
    match result {
        Ok(report) => {
            context.recorder.sight.add(report.visibility);
            if !report.over_budget.is_empty() {
                context.debug.warn(
                    "a shader ran so long that its draw was left out: look for a loop that does \
                     not end"
                        .into(),
                );
            }
        }
        Err(error) => context.debug.warn(format!("the driver refused recorded draws: {error}")),
    }
    let written = std::mem::take(&mut context.recorder.written);
    context.objects.images_changed(|image| written.iter().any(|other| other.same(image)));
}
