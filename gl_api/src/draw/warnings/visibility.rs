//! The warning of a picture in which nothing that was drawn is visible, with the reasons.

use crate::context::Context;
use crate::context::warnings::DrawWarning;
use rasterizer::driver::{Drawn, Reason, Reasons, Side, Visibility};

/// Warns, when a picture is taken, if nothing is visible of what was drawn since the one before.
pub(crate) fn picture(context: &mut Context) {
    crate::draw::warnings::stale_depth::picture(context);
    match std::mem::take(&mut context.recorder.sight) {
        Visibility::NothingDrawn | Visibility::Visible => {}
        Visibility::Invisible(reasons) => nothing_visible(context, &reasons),
    }
}

#[cold]
#[inline(never)]
fn nothing_visible(context: &mut Context, reasons: &Reasons) {
    let mut counts: Vec<(Drawn, Reason, u32)> = Vec::new();
    for &(drawn, reason) in reasons {
        match counts.iter_mut().find(|of| (of.0, of.1) == (drawn, reason)) {
            Some((.., count)) => *count += 1,
            None => counts.push((drawn, reason, 1)),
        }
    }
    // The most frequent first; equal counts by the order of the enumerations.
    counts.sort_by_key(|&(drawn, reason, count)| (std::cmp::Reverse(count), drawn, reason));
    let Some(&(_, main, _)) = counts.first() else { return };
    if !context.is_first_warning(DrawWarning::NothingSeen, context.state.bindings.draw_framebuffer)
    {
        return;
    }
    let what = match counts[..] {
        [(drawn, reason, 1)] => format!("the {} {}", name(drawn, 1), verdict(reason, 1)),
        [(drawn, reason, n)] => format!("the first {n} {} {}", name(drawn, n), verdict(reason, n)),
        _ => {
            let each =
                |&(drawn, reason, n)| format!("{n} {} {}", name(drawn, n), verdict(reason, n));
            counts.iter().map(each).collect::<Vec<_>>().join(", ")
        }
    };
    let (fix, section) = fix(main);
    context.debug.warn(format!(
        "draw: nothing that was drawn since the last picture is seen: {what}: {fix} (GL 2.1, section \
         {section})"
    ));
}

fn name(drawn: Drawn, count: u32) -> &'static str {
    match (drawn, count) {
        (Drawn::Point, 1) => "point",
        (Drawn::Point, _) => "points",
        (Drawn::Line, 1) => "line",
        (Drawn::Line, _) => "lines",
        (Drawn::Triangle, 1) => "triangle",
        (Drawn::Triangle, _) => "triangles",
    }
}

/// The predicate for primitives that are not visible: a verb and the reason.
fn verdict(reason: Reason, count: u32) -> String {
    let verb = |one: &'static str, many: &'static str| if count == 1 { one } else { many };
    let (verb, rest) = match reason {
        Reason::NotFinite => (verb("has", "have"), "a coordinate that is infinite or no number"),
        Reason::Outside(side) => (verb("is", "are"), beyond(side)),
        Reason::Cut => (verb("is", "are"), "cut away by clip planes or by the view volume"),
        Reason::Flat => (verb("has", "have"), "no area, as the vertices lie on one line"),
        Reason::Culled => (verb("shows", "show"), "the side that glCullFace leaves out"),
        Reason::Missed => (
            verb("is", "are"),
            "between the centres of pixels, or beside the viewport or the scissor box",
        ),
    };
    format!("{verb} {rest}")
}

fn beyond(side: Side) -> &'static str {
    match side {
        Side::Behind => "behind the eye (w <= 0)",
        Side::Left => "beyond the left side of the view volume (x < -w)",
        Side::Right => "beyond the right side of the view volume (x > w)",
        Side::Bottom => "beyond the bottom of the view volume (y < -w)",
        Side::Top => "beyond the top of the view volume (y > w)",
        Side::Near => "beyond the near side of the view volume (z < -w)",
        Side::Far => "beyond the far side of the view volume (z > w)",
    }
}

/// The advice for a reason, and the section of its rule.
fn fix(reason: Reason) -> (&'static str, &'static str) {
    match reason {
        Reason::NotFinite => (
            "look for a division by zero in the matrices, or in what gl_Position is made of",
            "2.11",
        ),
        // A matrix of zeros gives w = 0.
        Reason::Outside(Side::Behind) => (
            "check the matrices of GL_MODELVIEW and GL_PROJECTION, or gl_Position (a uniform matrix that was \
             never set is zero)",
            "2.12",
        ),
        Reason::Outside(
            Side::Left | Side::Right | Side::Bottom | Side::Top | Side::Near | Side::Far,
        ) => ("check the matrices of GL_MODELVIEW and GL_PROJECTION, or gl_Position", "2.12"),
        Reason::Cut => ("check glClipPlane, or gl_ClipVertex, and the matrices", "2.12"),
        Reason::Flat => {
            ("check size, type and stride of the vertex arrays, and the matrices", "3.5.1")
        }
        Reason::Culled => (
            "turn the order of the vertices around, or call glFrontFace, or glDisable(GL_CULL_FACE)",
            "3.5.1",
        ),
        Reason::Missed => ("check glViewport, glScissor and the size of what is drawn", "3.5.1"),
    }
}
