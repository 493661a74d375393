//! What is said when a picture is taken: that nothing which was drawn is visible in it, with the reasons, and that there
//! are messages which nobody has read.

use crate::context::Context;
use crate::context::warnings::DrawWarning;
use crate::draw::pending_primitives::draw_pending;
use crate::draw::warnings::picture;
use rasterizer::driver::{
    InvisibleReason, InvisibleReasons, PrimitiveKind, ViewVolumeSide, Visibility,
};

/// Warns, when a picture is taken, if nothing is visible of what was drawn since the one before.
pub(crate) fn picture(context: &mut Context) {
    crate::draw::warnings::depth::picture(context);
    if picture::may_be_empty(context) {
        draw_pending(context);
        picture::empty(context);
    }
    picture::begin(context);
    match std::mem::take(&mut context.recorder.visibility) {
        Visibility::NothingDrawn | Visibility::Visible => {}
        Visibility::Invisible(reasons) => nothing_visible(context, &reasons),
    }
    context.debug.end_of_frame();
}

#[cold]
#[inline(never)]
fn nothing_visible(context: &mut Context, reasons: &InvisibleReasons) {
    let mut counts: Vec<(PrimitiveKind, InvisibleReason, u32)> = Vec::new();
    for &(kind, reason) in reasons {
        match counts.iter_mut().find(|of| (of.0, of.1) == (kind, reason)) {
            Some((.., count)) => *count += 1,
            None => counts.push((kind, reason, 1)),
        }
    }
    // The most frequent first; equal counts by the order of the enumerations.
    counts.sort_by_key(|&(kind, reason, count)| (std::cmp::Reverse(count), kind, reason));
    let Some(&(_, main, _)) = counts.first() else { return };
    if !context.is_first_warning(DrawWarning::NothingSeen, context.state.bindings.draw_framebuffer)
    {
        return;
    }
    let what = match counts[..] {
        [(kind, reason, 1)] => format!("the {} {}", name(kind, 1), verdict(reason, 1)),
        [(kind, reason, n)] => format!("the first {n} {} {}", name(kind, n), verdict(reason, n)),
        _ => {
            let each = |&(kind, reason, n)| format!("{n} {} {}", name(kind, n), verdict(reason, n));
            counts.iter().map(each).collect::<Vec<_>>().join(", ")
        }
    };
    let (fix, section) = fix(main);
    context.debug.warn(format!(
        "draw: nothing that was drawn since the last picture is seen: {what}: {fix} (GL 2.1, section \
         {section})"
    ));
}

fn name(kind: PrimitiveKind, count: u32) -> &'static str {
    match (kind, count) {
        (PrimitiveKind::Point, 1) => "point",
        (PrimitiveKind::Point, _) => "points",
        (PrimitiveKind::Line, 1) => "line",
        (PrimitiveKind::Line, _) => "lines",
        (PrimitiveKind::Triangle, 1) => "triangle",
        (PrimitiveKind::Triangle, _) => "triangles",
    }
}

/// The predicate for primitives that are not visible: a verb and the reason.
fn verdict(reason: InvisibleReason, count: u32) -> String {
    let verb = |one: &'static str, many: &'static str| if count == 1 { one } else { many };
    let (verb, rest) = match reason {
        InvisibleReason::NotFinite => {
            (verb("has", "have"), "a coordinate that is infinite or no number")
        }
        InvisibleReason::Outside(side) => (verb("is", "are"), beyond(side)),
        InvisibleReason::Cut => {
            (verb("is", "are"), "cut away by clip planes or by the view volume")
        }
        InvisibleReason::Flat => (verb("has", "have"), "no area, as the vertices lie on one line"),
        InvisibleReason::Culled => (verb("shows", "show"), "the side that glCullFace leaves out"),
        InvisibleReason::Missed => (
            verb("is", "are"),
            "between the centres of pixels, or beside the viewport or the scissor box",
        ),
    };
    format!("{verb} {rest}")
}

fn beyond(side: ViewVolumeSide) -> &'static str {
    match side {
        ViewVolumeSide::Behind => "behind the eye (w <= 0)",
        ViewVolumeSide::Left => "beyond the left side of the view volume (x < -w)",
        ViewVolumeSide::Right => "beyond the right side of the view volume (x > w)",
        ViewVolumeSide::Bottom => "beyond the bottom of the view volume (y < -w)",
        ViewVolumeSide::Top => "beyond the top of the view volume (y > w)",
        ViewVolumeSide::Near => "beyond the near side of the view volume (z < -w)",
        ViewVolumeSide::Far => "beyond the far side of the view volume (z > w)",
    }
}

/// The advice for a reason, and the section of its rule.
fn fix(reason: InvisibleReason) -> (&'static str, &'static str) {
    match reason {
        InvisibleReason::NotFinite => (
            "look for a division by zero in the matrices, or in what gl_Position is made of",
            "2.11",
        ),
        // A matrix of zeros gives w = 0.
        InvisibleReason::Outside(ViewVolumeSide::Behind) => (
            "check the matrices of GL_MODELVIEW and GL_PROJECTION, or gl_Position (a uniform matrix that was \
             never set is zero)",
            "2.12",
        ),
        InvisibleReason::Outside(
            ViewVolumeSide::Left
            | ViewVolumeSide::Right
            | ViewVolumeSide::Bottom
            | ViewVolumeSide::Top
            | ViewVolumeSide::Near
            | ViewVolumeSide::Far,
        ) => ("check the matrices of GL_MODELVIEW and GL_PROJECTION, or gl_Position", "2.12"),
        InvisibleReason::Cut => ("check glClipPlane, or gl_ClipVertex, and the matrices", "2.12"),
        InvisibleReason::Flat => {
            ("check size, type and stride of the vertex arrays, and the matrices", "3.5.1")
        }
        InvisibleReason::Culled => (
            "turn the order of the vertices around, or call glFrontFace, or glDisable(GL_CULL_FACE)",
            "3.5.1",
        ),
        InvisibleReason::Missed => {
            ("check glViewport, glScissor and the size of what is drawn", "3.5.1")
        }
    }
}
