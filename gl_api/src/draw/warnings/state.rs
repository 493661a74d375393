//! Warnings of state with which a draw changes nothing, or everything is black.

use crate::context::Context;
use crate::context::recorder::elements::Elements;
use crate::context::recorder::fixed_function::StageKeys;
use crate::context::recorder::stages::Reads;
use crate::context::warnings::DrawWarning;
use crate::draw::assembly_words::has_vertex_program;
use crate::draw::material::material;
use crate::draw::warnings::constant_color::ConstantColor;
use crate::draw::warnings::{depth, effect, inputs, picture, rejected, textures};
use crate::interface::Side;
use crate::objects::queries::{GENERATED, WRITTEN};
use crate::state::enable::Flag;
use crate::state::stencil::Face;
use rasterizer::driver::{
    BlendEquation, BlendFactor, ColorState, DepthWrite, LogicOp, PassDesc, PipelineDesc,
    PolygonMode, Topology, VertexBinding,
};
use rasterizer::ir::{Output, Stage};
use texunit::sampler::Compare;

/// Checks the state of a draw.
pub(crate) fn check(
    context: &mut Context,
    pass: &PassDesc,
    desc: &PipelineDesc,
    reads: &Reads,
    (vertices, elements): (&[VertexBinding], &Elements),
) {
    let state = &context.state;
    let enables = &state.enables;
    let lights = enables.has(Flag::Lighting).then_some(&state.lights);
    let no_light = lights.is_some_and(|lights| lights.enabled == 0);
    let viewport = [state.viewport.first.width, state.viewport.first.height];
    let scissor = state.fragment.scissor.first;
    let no_scissor = enables.has(Flag::ScissorTest) && [scissor.width, scissor.height] == [0, 0];
    let no_depth = enables.has(Flag::DepthTest)
        && desc.depth.is_none()
        && state.fragment.depth_func != Compare::Always
        && !is_pass_of_a_program(context, desc.topology, elements);
    let no_stencil = enables.has(Flag::StencilTest)
        && desc.output.stencil.is_none()
        && state.fragment.stencil.faces.iter().any(|face: &Face| face.func != Compare::Always);
    if viewport.contains(&0.0) {
        no_viewport(context, viewport);
    }
    if no_scissor {
        say(context, DrawWarning::NoScissor, NO_SCISSOR);
    }
    if no_light {
        without_light(context);
    }
    if no_depth {
        missing(context, DrawWarning::NoDepth, ["GL_DEPTH_TEST", "depth", "EGL_DEPTH_SIZE"]);
    }
    if no_stencil {
        missing(
            context,
            DrawWarning::NoStencil,
            ["GL_STENCIL_TEST", "stencil", "EGL_STENCIL_SIZE"],
        );
    }
    if let Some(remainder) = remainder(desc.topology, elements) {
        left_out(context, remainder);
    }
    colors(context, pass, desc);
    effect::check(context, desc);
    stipple(context, desc);
    depth::check(context, desc);
    rejected::stencil(context, desc);
    inputs::link(context);
    let color = reads.keys.as_ref().and_then(|keys| ConstantColor::new(context, vertices, keys));
    rejected::alpha(context, color.as_ref());
    if let Some(color) = &color {
        rejected::blending(context, desc, color);
    }
    let Some(StageKeys { vertex: Some(_), fragment: Some(fragment), .. }) = &reads.keys else {
        return;
    };
    picture::note_lights(context, vertices);
    inputs::texture_coordinates(context, desc.topology, vertices, fragment);
    textures::unit_off(context, vertices, fragment);
    if let Some(color) = &color {
        rejected::black(context, desc, fragment, color);
    }
}

const NO_SCISSOR: &str = "draw: GL_SCISSOR_TEST is enabled and the scissor box is 0×0, so nothing is \
    drawn: call glScissor, or glDisable(GL_SCISSOR_TEST) (GL 2.1, section 4.1.2)";
const NO_LIGHT: &str = "draw: GL_LIGHTING is enabled and no light is, so nearly everything is black: \
    call glEnable(GL_LIGHT0), or glDisable(GL_LIGHTING) (GL 2.1, section 2.14.1)";
const MASKED: &str = "draw: glColorMask lets no colour through, and neither depth nor stencil is \
    written, so nothing changes: call glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE) (GL 2.1, \
    section 4.2.2)";
const NO_COLOR_BUFFER: &str = "draw: no colour buffer is drawn to, as glDrawBuffer has GL_NONE or a \
    point where nothing is attached, and neither depth nor stencil is written, so nothing changes: \
    call glDrawBuffer (GL 3.0, section 4.2.1)";

const NOOP: &str = "draw: GL_COLOR_LOGIC_OP is enabled with glLogicOp(GL_NOOP), so no colour changes: call \
    glLogicOp(GL_COPY), or glDisable(GL_COLOR_LOGIC_OP) (GL 2.1, section 4.1.10)";
const BLENDED_AWAY: &str = "draw: GL_BLEND is enabled with glBlendFunc(GL_ZERO, GL_ONE), which keeps the colours that are \
    there, so nothing changes: call glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), or glDisable(GL_BLEND) (GL 2.1, \
    section 4.1.8)";
const NO_STIPPLE: &str = "draw: GL_POLYGON_STIPPLE is enabled and no bit of the pattern is set, so no fragment is drawn: \
    call glPolygonStipple with another one, or glDisable(GL_POLYGON_STIPPLE) (GL 2.1, section 3.5.2)";
const DISCARDED: &str = "draw: GL_RASTERIZER_DISCARD is enabled, and no transform feedback or query of primitives is \
    active, so nothing is drawn: call glDisable(GL_RASTERIZER_DISCARD) (GL 3.0, section 3.1)";

#[cold]
#[inline(never)]
fn say(context: &mut Context, warning: DrawWarning, text: &str) {
    if context.is_first_warning(warning, 0) {
        context.debug.warn(text.to_owned());
    }
}

#[cold]
#[inline(never)]
fn no_viewport(context: &mut Context, [width, height]: [f32; 2]) {
    if context.is_first_warning(DrawWarning::NoViewport, 0) {
        context.debug.warn(format!(
            "draw: the viewport is {width}×{height}, so nothing is drawn: call glViewport (it is 0×0 \
             at first where a context has no surface) (GL 2.1, section 2.11.1)"
        ));
    }
}

/// Warns of lighting without lights, unless materials emit light or the ambient colour of the scene was set.
#[cold]
#[inline(never)]
fn without_light(context: &mut Context) {
    let ambient = context.state.lights.model.ambient;
    let emission = material(context, Side::Front).emission;
    let shines = ambient != [0.2, 0.2, 0.2, 1.0] || emission[..3] != [0.0; 3];
    if !shines && !has_vertex_program(context) {
        say(context, DrawWarning::NoLight, NO_LIGHT);
    }
}

/// Warns of a test without a buffer for it, once for all framebuffers: it is legal, and usual in post-processing.
#[cold]
#[inline(never)]
fn missing(context: &mut Context, warning: DrawWarning, [test, buffer, size]: [&str; 3]) {
    if !context.is_first_warning(warning, 0) {
        return;
    }
    let (place, fix) = match context.state.bindings.draw_framebuffer {
        0 => ("the default framebuffer".to_owned(), format!("choose a config with {size}")),
        name => (format!("framebuffer {name}"), "attach one".to_owned()),
    };
    context.debug.warn(format!(
        "draw: {test} is enabled, but {place} has no {buffer} buffer, so every fragment passes: if it \
         should not, {fix} (GL 2.1, section 4.1)"
    ));
}

/// Whether vertices make polygons. What a geometry program makes of them is not asked.
fn draws_polygons(topology: Topology) -> bool {
    match topology {
        Topology::Triangles
        | Topology::TriangleStrip
        | Topology::TriangleFan
        | Topology::Quads
        | Topology::QuadStrip
        | Topology::Polygon => true,
        Topology::Points
        | Topology::Lines
        | Topology::LineStrip
        | Topology::LineLoop
        | Topology::LinesAdjacency
        | Topology::LineStripAdjacency
        | Topology::TrianglesAdjacency
        | Topology::TriangleStripAdjacency => false,
    }
}

/// Whether a program draws one triangle or one rectangle, as passes over a whole picture do: nothing of it hides the rest.
fn is_pass_of_a_program(context: &Context, topology: Topology, elements: &Elements) -> bool {
    let most = match topology {
        Topology::Triangles => 6,
        Topology::TriangleStrip | Topology::TriangleFan | Topology::Quads => 4,
        Topology::QuadStrip
        | Topology::Polygon
        | Topology::Points
        | Topology::Lines
        | Topology::LineStrip
        | Topology::LineLoop
        | Topology::LinesAdjacency
        | Topology::LineStripAdjacency
        | Topology::TrianglesAdjacency
        | Topology::TriangleStripAdjacency => return false,
    };
    let (count, instances) = elements.counts();
    context.has_program() && count <= most && instances.len() == 1
}

/// Vertices that are left over by whole primitives.
struct Remainder {
    mode: &'static str,
    each: u32,
    count: u32,
}

/// The vertices of a draw that are left over; of topologies whose primitives share no vertices.
fn remainder(topology: Topology, elements: &Elements) -> Option<Remainder> {
    let (mode, each) = match topology {
        Topology::Lines => ("GL_LINES", 2),
        Topology::Triangles => ("GL_TRIANGLES", 3),
        Topology::Quads => ("GL_QUADS", 4),
        Topology::LinesAdjacency => ("GL_LINES_ADJACENCY", 4),
        Topology::TrianglesAdjacency => ("GL_TRIANGLES_ADJACENCY", 6),
        Topology::Points
        | Topology::LineStrip
        | Topology::LineLoop
        | Topology::TriangleStrip
        | Topology::TriangleFan
        | Topology::QuadStrip
        | Topology::Polygon
        | Topology::LineStripAdjacency
        | Topology::TriangleStripAdjacency => return None,
    };
    let (count, _) = elements.counts();
    (!count.is_multiple_of(each)).then_some(Remainder { mode, each, count })
}

#[cold]
#[inline(never)]
fn left_out(context: &mut Context, Remainder { mode, each, count }: Remainder) {
    if context.is_first_warning(DrawWarning::Remainder, each) {
        let rest = count % each;
        context.debug.warn(format!(
            "draw: {mode} takes {each} vertices each, so of {count} the last {rest} are left out (GL \
             2.1, section 2.6.1)"
        ));
    }
}

/// Warns of a draw that writes neither colours nor anything else.
fn colors(context: &mut Context, pass: &PassDesc, desc: &PipelineDesc) {
    let writes_depth = desc.depth.as_ref().is_some_and(|depth| depth.write == DepthWrite::On);
    let counts = context.recorder.counter.is_some();
    if writes_depth
        || desc.output.stencil.is_some()
        || counts
        || context.transform_feedback.is_active()
    {
        return;
    }
    let written = || {
        let attached = pass.colors.iter().zip(&desc.colors);
        attached.filter(|(color, state)| color.is_some() && state.mask.contains(&true))
    };
    if written().next().is_none() {
        let masked = pass.colors.iter().any(Option::is_some);
        let (warning, text) = match masked {
            true => (DrawWarning::NoColor, MASKED),
            false => (DrawWarning::NoColorBuffer, NO_COLOR_BUFFER),
        };
        say(context, warning, text);
        return;
    }
    if desc.output.logic_op == Some(LogicOp::Noop) {
        say(context, DrawWarning::KeptColors, NOOP);
    } else if desc.output.logic_op.is_none() && written().all(|(_, state)| keeps(state)) {
        say(context, DrawWarning::KeptColors, BLENDED_AWAY);
    }
    let outputs = &desc.fragment.module().outputs;
    let targets = outputs.iter().filter_map(|(output, _)| match output {
        Output::Color { target, .. } => Some(*target),
        Output::Position(_)
        | Output::PointSize
        | Output::ClipDistance(_)
        | Output::CullDistance(_)
        | Output::Varying(_)
        | Output::SecondColor(_)
        | Output::Depth
        | Output::Layer
        | Output::PrimitiveId
        | Output::ViewportIndex
        | Output::SampleMask
        | Output::StencilReference => None,
    });
    let is_drawn = |target: u8| {
        let at = usize::from(target);
        pass.colors.get(at).is_some_and(Option::is_some)
            && desc.colors.get(at).is_some_and(|state| state.mask.contains(&true))
    };
    match targets.clone().next() {
        None => without_color(context),
        Some(target) if !targets.clone().any(is_drawn) => other_location(context, target),
        Some(_) => {}
    }
}

/// Warns of a fragment stage whose colours all go to draw buffers that are none.
#[cold]
#[inline(never)]
fn other_location(context: &mut Context, target: u8) {
    let program = context.program_of(Stage::Fragment);
    if program != 0 && context.is_first_warning(DrawWarning::OtherLocation, program) {
        context.debug.warn(format!(
            "draw: the fragment stage of program {program} writes its colour to location {target}, and draw buffer {target} \
             is GL_NONE or masked, so what is drawn elsewhere is undefined: declare layout(location = 0), call \
             glBindFragDataLocation(program, 0, name) before glLinkProgram, or glDrawBuffers with {} buffers (GL 3.3, \
             section 4.2.1)",
            target + 1
        ));
    }
}

/// Whether blending leaves the colours as they are.
fn keeps(state: &ColorState) -> bool {
    state.blend.as_ref().is_some_and(|blend| {
        blend.src == [BlendFactor::Zero; 2]
            && blend.dst == [BlendFactor::One; 2]
            && blend.equation == [BlendEquation::Add; 2]
    })
}

/// Warns of a stipple without a bit, of a draw of polygons alone.
fn stipple(context: &mut Context, desc: &PipelineDesc) {
    let is_empty = context.state.enables.has(Flag::PolygonStipple)
        && draws_polygons(desc.topology)
        && context.state.raster.polygons.mode == [PolygonMode::Fill; 2]
        && context.state.raster.polygons.stipple == [0; 32];
    if is_empty {
        say(context, DrawWarning::NoStipple, NO_STIPPLE);
    }
}

/// Warns of a draw that makes no fragments, and nothing else either.
#[cold]
#[inline(never)]
pub(crate) fn discarded(context: &mut Context) {
    let counts = [GENERATED, WRITTEN].iter().any(|&query| context.queries.names[query] != 0);
    if !context.transform_feedback.is_active() && !counts {
        say(context, DrawWarning::NothingRasterized, DISCARDED);
    }
}

#[cold]
#[inline(never)]
fn without_color(context: &mut Context) {
    let program = context.program_of(Stage::Fragment);
    if context.is_first_warning(DrawWarning::NoColorOfShader, program) {
        context.debug.warn(format!(
            "draw: the fragment stage of program {program} writes no colour, so that of what is drawn \
             is undefined: write gl_FragColor, or an out variable (GLSL 1.30, section 7.2)"
        ));
    }
}
