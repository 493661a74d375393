//! Warnings of a whole picture that is empty: of draws that were none, lights that shine on no face, and a framebuffer that
//! is read in place of the one that was drawn to.

use crate::context::Context;
use crate::context::recorder::picture::{LeftOut, LightsSeen};
use crate::context::warnings::DrawWarning;
use crate::draw::material::material;
use crate::interface::{ATTRIB_NORMAL, Side};
use crate::state::enable::Flag;
use glam::{DVec3, DVec4};
use rasterizer::driver::{Attachment, VertexBinding, VertexSource};

/// Red, green and blue below this are black to the eye.
const NEARLY_BLACK: f32 = 0.05;

/// Notes a draw of no vertices or no instances.
pub(crate) fn note_empty(context: &mut Context, name: &'static str, [count, instances]: [u64; 2]) {
    if (count == 0 || instances == 0) && context.compiling.is_none() {
        context.recorder.picture.left_out = Some(LeftOut::Empty(name));
    }
}

/// Notes a draw that a condition left out.
pub(crate) fn note_condition(context: &mut Context) {
    context.recorder.picture.left_out = Some(LeftOut::Condition);
}

/// Notes whether a lit draw of the fixed function may get light. Once one did, no other is looked at.
pub(crate) fn note_lights(context: &mut Context, vertices: &[VertexBinding]) {
    if context.recorder.picture.lights == LightsSeen::Shine
        || !context.state.enables.has(Flag::Lighting)
    {
        return;
    }
    context.recorder.picture.lights = match unlit_normal(context, vertices) {
        Some(normal) => LightsSeen::Behind(normal),
        None => LightsSeen::Shine,
    };
}

/// The same, of a draw with the state of the one before and perhaps another normal.
pub(crate) fn note_lights_again(context: &mut Context, vertices: &[VertexBinding]) {
    if let LightsSeen::Behind(normal) = context.recorder.picture.lights {
        let is_same = context.state.current[usize::from(ATTRIB_NORMAL)][..3] == normal
            && vertices.iter().all(|binding| binding.location != ATTRIB_NORMAL);
        if !is_same {
            context.recorder.picture.lights = LightsSeen::Shine;
        }
    }
}

/// The normal of all vertices, if it is one, all lights are behind it, and nothing else is bright.
fn unlit_normal(context: &Context, vertices: &[VertexBinding]) -> Option<[f32; 3]> {
    let mut found = vertices.iter().filter(|binding| binding.location == ATTRIB_NORMAL);
    let &VertexSource::Constant([x, y, z, _]) = &found.next()?.source else { return None };
    let (lights, normal) = (&context.state.lights, DVec3::new(x.into(), y.into(), z.into()));
    // The inverse of the model-view matrix takes the direction of a light to where normals are (GL 2.1, section 2.11.3).
    let inverse = context.state.matrices.modelview.top.inverse();
    let front = material(context, Side::Front);
    let mut dark =
        [0, 1, 2].map(|at| front.emission[at] + lights.model.ambient[at] * front.ambient[at]);
    for (index, light) in lights.lights.iter().enumerate() {
        if lights.enabled >> index & 1 == 0 {
            continue;
        }
        let DVec4 { x, y, z, w } = light.position;
        let towards = inverse * DVec4::new(x, y, z, 0.0);
        if w != 0.0 || normal.dot(towards.truncate()) > 0.0 {
            return None;
        }
        for (sum, at) in dark.iter_mut().zip(0..) {
            let at: usize = at;
            *sum += light.ambient[at] * front.ambient[at];
        }
    }
    let is_black = dark.iter().all(|component| *component <= NEARLY_BLACK);
    (lights.enabled != 0 && !lights.model.two_side && is_black).then_some([x, y, z])
}

/// Whether [`empty`] may have something to say of the picture that is taken.
pub(crate) fn may_be_empty(context: &Context) -> bool {
    let picture = &context.recorder.picture;
    picture.left_out.is_some() || matches!(picture.lights, LightsSeen::Behind(_))
}

/// Begins the next picture.
pub(crate) fn begin(context: &mut Context) {
    context.recorder.picture.draws_before = context.recorder.draws;
}

/// Warns, when a picture is taken, of what left it empty; no draw is pending.
#[cold]
#[inline(never)]
pub(crate) fn empty(context: &mut Context) {
    let (draws, picture) = (context.recorder.draws, &mut context.recorder.picture);
    let before = picture.draws_before;
    if let LightsSeen::Behind(normal) = picture.lights {
        picture.lights = LightsSeen::None;
        lights_behind(context, normal);
    }
    let text = match context.recorder.picture.left_out.take() {
        Some(LeftOut::Empty(name)) if draws == 0 => format!(
            "draw: nothing was drawn: {name} was called with 0 vertices or instances: check count, and whether what it \
             comes from was loaded (GL 2.1, section 2.8)"
        ),
        Some(LeftOut::Condition) if draws == before => {
            "draw: nothing was drawn since the last picture: the query of glBeginConditionalRender counted no samples, \
             so draws were left out: draw what it counts between glBeginQuery and glEndQuery, in view and not hidden, or \
             leave glBeginConditionalRender out (GL 3.0, section 2.14)"
                .to_owned()
        }
        Some(LeftOut::Empty(_) | LeftOut::Condition) | None => return,
    };
    if context.is_first_warning(DrawWarning::NothingDrawn, 0) {
        context.debug.warn(text);
    }
}

fn lights_behind(context: &mut Context, [x, y, z]: [f32; 3]) {
    if context.is_first_warning(DrawWarning::LightsBehind, 0) {
        context.debug.warn(format!(
            "draw: all that was drawn with GL_LIGHTING since the last picture is black: the normal is ({x}, {y}, {z}), and \
             every enabled light shines from behind it: call glNormal3f({}, {}, {}), glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, \
             GL_TRUE), or glLightfv(GL_LIGHT0, GL_POSITION, ...) (GL 2.1, section 2.14.1)",
            0.0 - x,
            0.0 - y,
            0.0 - z
        ));
    }
}

/// Checks what is read: a framebuffer that nobody ever drew to, where draws went to another one.
pub(crate) fn read(context: &mut Context, from: &Attachment) {
    let read = context.state.bindings.read_framebuffer;
    if let Some(drawn) = context.recorder.picture.framebuffer
        && drawn != read
        && from.image.is_untouched()
        && context.is_first_warning(DrawWarning::OtherFramebuffer, read)
    {
        context.debug.warn(format!(
            "glReadPixels: framebuffer {read} is read, to which nothing was ever drawn, cleared or copied, and what was \
             drawn went to framebuffer {drawn}: call glBindFramebuffer(GL_READ_FRAMEBUFFER, {drawn}), or \
             glBlitFramebuffer before (GL 3.0, section 4.4.1)"
        ));
    }
}
