//! The pass that draws are recorded into: when another one begins, when what is recorded is submitted, and which pixels
//! of its attachments draws reach.

use crate::context::Context;
use crate::context::reset::{ResetNotification, ResetStatus};
use crate::context::window::Region;
use crate::draw::completeness::draw_pass;
use crate::draw::pending_primitives::draw_pending;
use crate::state::enable::Flag;
use rasterizer::driver::{Attachment, Command, FrameSpending, Image, LevelInfo, PassDesc, Rect};
use texunit::image::Level;

fn same_attachment(a: Option<&Attachment>, b: Option<&Attachment>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => {
            a.image.is_same_image(&b.image)
                && (a.face, a.level, a.samples) == (b.face, b.level, b.samples)
        }
        (None, None) => true,
        (Some(_), None) | (None, Some(_)) => false,
    }
}

fn same_pass(a: &PassDesc, b: &PassDesc) -> bool {
    (a.width, a.height, a.layers, a.colors.len()) == (b.width, b.height, b.layers, b.colors.len())
        && same_attachment(a.depth.as_ref(), b.depth.as_ref())
        && a.colors.iter().zip(&b.colors).all(|(a, b)| same_attachment(a.as_ref(), b.as_ref()))
}

/// Keeps the open pass if it draws to the same attachments, else begins one.
pub(crate) fn begin_pass(context: &mut Context, pass: PassDesc) {
    let recorder = &mut context.recorder;
    if recorder.is_full() {
        submit(context);
    } else if recorder.pass.as_ref().is_some_and(|open| same_pass(open, &pass)) {
        return;
    }
    submit_readers_of_tiles(context, &pass);
    let recorder = &mut context.recorder;
    recorder.end_pass();
    let attached = std::mem::take(&mut recorder.attached);
    recorder.hold(attached);
    for attachment in pass.colors.iter().chain([&pass.depth]).flatten() {
        if !recorder.written.iter().any(|image| image.shares_texels(&attachment.image)) {
            recorder.attached = recorder.attached.saturating_add(bytes_of(attachment));
            recorder.written.push(attachment.image.clone());
        }
    }
    recorder.push(Command::BeginPass(pass.clone()));
    if let Some(budget) = recorder.draw_budget {
        recorder.push(Command::SetBudget(budget));
    }
    recorder.pass = Some(pass);
}

/// The bytes of the level that is drawn to, all its layers and samples.
fn bytes_of(attachment: &Attachment) -> usize {
    let level = attachment.image.level(attachment.face.into(), attachment.level.into());
    level.map_or(0, |LevelInfo { format, size: [width, height, depth], .. }| {
        let samples = usize::from(attachment.sample_count().max(1));
        Level::required_bytes(format, width, height, depth).unwrap_or(0).saturating_mul(samples)
    })
}

/// Submits what was recorded and drops the texture's plan, if either reads the tiles of the depth attachment of a new pass:
/// the pass would have to copy them.
fn submit_readers_of_tiles(context: &mut Context, pass: &PassDesc) {
    if let Some(Attachment { image, .. }) =
        pass.depth.as_ref().filter(|of| of.image.has_readers_of_tiles())
    {
        submit(context);
        context.objects.images_changed(|changed| changed.shares_texels(image));
    }
}

/// Charges work on the whole framebuffer that is drawn to, where a list runs that is charged.
pub(crate) fn charge_surface(context: &mut Context) {
    if context.lists.is_charged()
        && let Ok(pass) = draw_pass(context)
    {
        context.lists.charge_pixels(u64::from(pass.width) * u64::from(pass.height));
    }
}

/// Submits what was recorded, if it writes to an image that is about to be read or changed.
pub(crate) fn submit_draws_to(context: &mut Context, image: &Image) {
    if context.recorder.written.iter().any(|written| written.shares_texels(image)) {
        submit(context);
    }
}

/// Draws what is pending and submits everything that was recorded.
pub(crate) fn submit(context: &mut Context) {
    draw_pending(context);
    execute(context);
}

/// As [`submit`], at the end of a call: other contexts can use the share group's objects meanwhile.
pub(crate) fn submit_unlocked(context: &mut Context) {
    draw_pending(context);
    context.objects.shared.release();
    execute(context);
}

fn execute(context: &mut Context) {
    context.recorder.end_pass();
    let mut commands = std::mem::take(&mut context.recorder.commands);
    (context.recorder.held, context.recorder.attached) = (0, 0);
    if commands.commands.is_empty() {
        context.recorder.fences.signal();
        return;
    }
    context.outdate_mirror();
    let result = context.recorder.device.submit_in_frame(&commands, context.recorder.spent);
    // Their memory is used again.
    commands.commands.clear();
    context.recorder.commands = commands;
    match result {
        Ok(report) => {
            context.recorder.visibility.add(report.visibility);
            context.recorder.spent = report.spent;
            context.lists.charge_batches(report.batches);
            if !report.over_budget.is_empty() {
                stopped(context);
            }
        }
        Err(error) => context.debug.warn(format!("the driver refused recorded draws: {error}")),
    }
    let written = std::mem::take(&mut context.recorder.written);
    context.objects.images_changed(|image| written.iter().any(|other| other.shares_texels(image)));
    // Last: a context that waited finds the textures noted as changed.
    context.recorder.fences.signal();
}

/// The client waits for what was drawn, so that draws have a budget anew. One that asked to be told of resets has to look
/// at one first: until then its context counts as lost (`KHR_robustness`).
pub(crate) fn end_of_frame(context: &mut Context) {
    match context.resets.status {
        ResetStatus::NoError => context.recorder.spent = FrameSpending::default(),
        ResetStatus::Guilty => {}
    }
}

/// Reports that a draw was stopped.
#[cold]
#[inline(never)]
pub(crate) fn stopped(context: &mut Context) {
    const STOPPED: &str = "a shader ran so long that the rest of its draw was left out: look for a loop that does \
                           not end, a number of instances or vertices far too large, or raise DETGL_DRAW_BUDGET";
    context.resets.draw_was_stopped();
    match context.resets.notification {
        ResetNotification::Never => context.debug.warn_unasked(STOPPED),
        ResetNotification::LoseContextOnReset => context.debug.warn(STOPPED.to_owned()),
    }
}

/// The pixels that fragments reach: the attachments' area within the scissor rectangle.
pub(crate) fn drawn_area(context: &Context, pass: &PassDesc) -> Rect {
    let all = Rect { x: 0, y: 0, width: pass.width, height: pass.height };
    if !context.state.enables.has(Flag::ScissorTest) {
        return all;
    }
    let scissor = context.state.fragment.scissor.first;
    let region = Region::new(scissor.x, scissor.y, scissor.width as usize, scissor.height as usize);
    match region.within(pass.width, pass.height) {
        Some(visible) => Rect {
            x: visible.x as i32,
            y: visible.y as i32,
            width: visible.width as u32,
            height: visible.height as u32,
        },
        None => Rect { x: 0, y: 0, width: 0, height: 0 },
    }
}
