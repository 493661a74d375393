//! From validated state to commands of the driver.

use crate::base::error::{ErrorCode, GlError, Result, invalid_operation};
use crate::context::Context;
use crate::context::feedback::Mode;
use crate::context::recorder::again::Decided;
use crate::context::recorder::elements::{Elements, bit};
use crate::context::recorder::rectangle::Rectangle;
use crate::context::recorder::stages::{Reads, Stages, Textures};
use crate::context::recorder::{Recorder, stages};
use crate::draw::complete::{draw_pass, draw_planes, drawn_formats};
use crate::draw::ended::draw_ended;
use crate::draw::multisample::multisample_state;
use crate::draw::note::{is_watched, watch_draw};
use crate::draw::primitives::{raster_state, smoothness};
use crate::draw::srgb::srgb_write;
use crate::draw::viewport::depth_clip;
use crate::draw::{assembly_words as assembly, begin_pass, hints};
use crate::interface::ATTRIB_EDGE_FLAG;
use crate::state::enable::Flag;
use crate::state::stencil::Side;
use rasterizer::driver::{
    Antialiasing, Buffer, ColorState, Command, Cull, DepthClip, DepthState, FrontFace, OutputState,
    PassDesc, Pipeline, PipelineDesc, PolygonState, Provoking, RasterState, Rect, SampleRule,
    ShaderModule, Topology, VertexBinding, VertexSource, Viewport, same_textures,
};
use std::sync::Arc;
use texunit::format::Format;

/// More pipelines than this are forgotten and made again.
const KEPT: usize = 1024;

/// The attributes whose current values a draw may ask for, bit by location. A list is drawn with whatever
/// program is in use then.
fn constants_read(context: &Context) -> u64 {
    let linked = context.objects.linked_program(context.state.bindings.program.name());
    match linked.filter(|linked| linked.vertex.is_some() && context.compiling.is_none()) {
        Some(linked) => linked.attributes | 1 << ATTRIB_EDGE_FLAG,
        None => u64::MAX,
    }
}

/// Those of them that a draw has to bring: where it may be decided as the one before, what that reads.
pub(crate) fn constants_asked(context: &Context) -> u64 {
    crate::draw::again::attributes(context).unwrap_or_else(|| constants_read(context))
}

/// Adds the current values that a draw has not brought, as it is decided anew.
fn add_constants(context: &Context, vertices: &mut Vec<VertexBinding>) {
    let brought = vertices.iter().fold(0, |all, binding| all | bit(binding.location));
    let missing = constants_read(context) & !brought;
    let before = vertices.len();
    for (location, value) in (0..).zip(&context.state.current) {
        if missing & bit(location) != 0 {
            vertices.push(VertexBinding { location, source: VertexSource::Constant(*value) });
        }
    }
    if vertices.len() > before {
        vertices.sort_unstable_by_key(|binding| binding.location);
    }
}

/// Records a draw.
///
/// # Errors
/// When the framebuffer is incomplete or the program in use is not linked.
pub(crate) fn draw(
    context: &mut Context,
    topology: Topology,
    mut vertices: Vec<VertexBinding>,
    elements: &Elements,
) -> Result<()> {
    draw_ended(context);
    if let Some(words) = crate::draw::again::words(context, topology, &vertices, elements) {
        // Counts primitives; nothing is captured.
        crate::draw::capture::draw(context, topology, &[], elements)?;
        tell_words(&mut context.recorder, words);
        record_vertices(context, vertices, elements);
        return Ok(());
    }
    add_constants(context, &mut vertices);
    let pass = checked_pass(context)?;
    if context.queries.discards() {
        return Ok(());
    }
    crate::draw::capture::draw(context, topology, &vertices, elements)?;
    if !is_rasterized(context, topology, &vertices, elements)? {
        return Ok(());
    }
    let antialiasing = smoothness(context, topology);
    // Choosing may carry out what was recorded, if a texture of this draw was drawn to.
    let Stages { vertex, fragment, reads } =
        crate::draw::stages::choose(context, &vertices, antialiasing)?;
    let viewport = viewport(context);
    let mut raster = raster_state(context, topology, &vertices);
    raster.multisample = multisample_state(context, SampleRule::Each);
    let desc = pipeline_desc(context, &pass, topology, vertex, fragment);
    hints::state::check(context, &pass, &desc, elements);
    record(context, Drawing { pass, desc, raster, viewport, reads }, vertices, elements)
}

/// Records the draw of rectangles of pixels: four vertices of each in clip coordinates of the whole
/// framebuffer.
///
/// # Errors
/// As [`draw`].
pub(crate) fn draw_rectangle(
    context: &mut Context,
    vertices: Vec<VertexBinding>,
    elements: &Elements,
    rectangle: &Rectangle,
) -> Result<()> {
    let topology = Topology::Quads;
    draw_ended(context);
    let pass = checked_pass(context)?;
    if context.queries.discards() || !is_rasterized(context, topology, &vertices, elements)? {
        return Ok(());
    }
    let mut stages = crate::draw::stages::choose(context, &vertices, Antialiasing::Aliased)?;
    rectangle.apply(context, &mut stages).map_err(|error| stages::internal(&error))?;
    let Stages { vertex, fragment, reads } = stages;
    let reads = Reads { keys: None, ..reads };
    let viewport = rectangle_viewport(&pass, rectangle.depth);
    let multisample = multisample_state(context, SampleRule::Center);
    let polygon = PolygonState { stipple: rectangle.stipple(), ..PolygonState::default() };
    let raster = RasterState { polygon, multisample, ..RasterState::default() };
    let desc = PipelineDesc {
        cull: Cull::None,
        front_face: FrontFace::Ccw,
        provoking: Provoking::Last,
        ..pipeline_desc(context, &pass, topology, vertex, fragment)
    };
    record(context, Drawing { pass, desc, raster, viewport, reads }, vertices, elements)
}

/// What is drawn to, if the state can draw to it.
fn checked_pass(context: &mut Context) -> Result<PassDesc> {
    let pass = draw_pass(context)?;
    let program = context.state.bindings.program.name();
    let linked = context.objects.linked_program(program);
    let is_shaded = linked.is_some_and(|linked| linked.fragment.is_some());
    if program != 0 && linked.is_none() {
        return invalid_operation(
            "GL 2.1, section 2.15.3",
            format!("program {program} is in use but not linked: see glGetProgramInfoLog"),
        );
    }
    assembly::check(context)?;
    if !is_shaded {
        no_integers(context)?;
    }
    Ok(pass)
}

/// Refuses to draw to integers without a fragment shader, which alone writes them.
fn no_integers(context: &Context) -> Result<()> {
    if drawn_formats(context).any(Format::is_integer) {
        return invalid_operation(
            "EXT_texture_integer, section 2.6",
            "a colour buffer that is drawn to holds integers, which only a fragment shader writes: \
             call glUseProgram with one",
        );
    }
    Ok(())
}

/// Whether a draw makes fragments. What it makes in other modes is made here.
fn is_rasterized(
    context: &mut Context,
    topology: Topology,
    vertices: &[VertexBinding],
    elements: &Elements,
) -> Result<bool> {
    if context.state.enables.has(Flag::RasterizerDiscard) {
        return Ok(false);
    }
    if context.feedback.mode != Mode::Render {
        crate::draw::feedback::draw(context, topology, vertices, elements)?;
        return Ok(false);
    }
    hints::textures::nothing_enabled(context);
    Ok(true)
}

/// A draw but its vertices.
struct Drawing {
    pass: PassDesc,
    desc: PipelineDesc,
    raster: RasterState,
    viewport: Viewport,
    reads: Reads,
}

fn record(
    context: &mut Context,
    drawing: Drawing,
    vertices: Vec<VertexBinding>,
    elements: &Elements,
) -> Result<()> {
    let Drawing { pass, desc, raster, viewport, reads } = drawing;
    let watched = is_watched(context, &pass);
    begin_pass(context, pass);
    if let Some(note) = reads.note.filter(|_| watched) {
        watch_draw(context, note.drawing(desc.topology));
    }
    let topology = desc.topology;
    tell_pipeline(context, desc)?;
    tell_state(context, raster, viewport);
    tell_words(&mut context.recorder, reads.words);
    let recorder = &mut context.recorder;
    let textures = [reads.vertex_textures, reads.fragment_textures];
    let same = |told: &[Textures; 2]| {
        told.iter().zip(&textures).all(|(told, textures)| same_textures(told, textures))
    };
    if !recorder.told.textures.as_ref().is_some_and(same) {
        let [vertex, fragment] = textures.clone();
        recorder.push(Command::BindTextures { vertex, fragment });
        recorder.told.textures = Some(textures);
    }
    let decided = reads.keys.map(|keys| Decided::new(context, topology, &vertices, keys));
    context.recorder.told.decided = decided;
    record_vertices(context, vertices, elements);
    Ok(())
}

/// Records a draw of which everything else is told.
fn record_vertices(context: &mut Context, mut vertices: Vec<VertexBinding>, elements: &Elements) {
    let read = context.recorder.told.attributes_read();
    vertices.retain(|binding| read & bit(binding.location) != 0);
    hints::arrays::short(context, &vertices, elements);
    let recorder = &mut context.recorder;
    recorder.draws += 1;
    recorder.told.repeat = None;
    let buffers = vertices.iter().filter_map(|binding| binding.source.buffer());
    recorder.held += buffers.map(Buffer::own_bytes).sum::<usize>();
    recorder.push(Command::BindVertices(vertices.drain(..).collect()));
    recorder.bindings = vertices;
    recorder.push_draw(elements);
}

/// Tells the open pass of uniform words, if they are others.
fn tell_words(recorder: &mut Recorder, words: Vec<u32>) {
    if recorder.told.words.as_deref() != Some(&words) {
        let shared: Arc<[u32]> = Arc::from(words.as_slice());
        recorder.push(Command::SetUniforms(Arc::clone(&shared)));
        recorder.told.words = Some(shared);
    }
    recorder.words = words;
}

/// Tells the open pass of its pipeline, if that is another.
fn tell_pipeline(context: &mut Context, desc: PipelineDesc) -> Result<()> {
    if context.recorder.told.pipeline.as_ref() != Some(&desc) {
        let pipeline = pipeline(context, &desc)?;
        context.recorder.told.attributes = pipeline.attributes().fold(0, |all, at| all | bit(at));
        context.recorder.push(Command::BindPipeline(pipeline));
        context.recorder.told.pipeline = Some(desc);
    }
    Ok(())
}

/// Tells the open pass what has changed of the rest of its state.
fn tell_state(context: &mut Context, raster: RasterState, viewport: Viewport) {
    let scissor = scissor(context);
    let recorder = &mut context.recorder;
    let (told, commands) = (&mut recorder.told, &mut recorder.commands);
    if told.raster.as_deref() != Some(&raster) {
        let shared = Arc::new(raster);
        commands.push(Command::SetRaster(Arc::clone(&shared)));
        told.raster = Some(shared);
    }
    if told.viewport.replace(viewport) != Some(viewport) {
        commands.push(Command::SetViewport(viewport));
    }
    if told.scissor.replace(scissor) != Some(scissor) {
        commands.push(Command::SetScissor(scissor));
    }
    if told.counter != recorder.counter {
        commands.push(Command::SetCounter(recorder.counter.clone()));
        told.counter.clone_from(&recorder.counter);
    }
}

pub(crate) fn viewport(context: &Context) -> Viewport {
    let viewport = &context.state.viewport;
    let [near, far] = viewport.depth;
    Viewport {
        x: viewport.x as f32,
        y: viewport.y as f32,
        width: viewport.width as f32,
        height: viewport.height as f32,
        near: near as f32,
        far: far as f32,
        depth_clip: depth_clip(context),
    }
}

/// The whole framebuffer, everything at one depth.
fn rectangle_viewport(pass: &PassDesc, depth: f32) -> Viewport {
    let (width, height) = (pass.width as f32, pass.height as f32);
    let depth_clip = DepthClip::Cut;
    Viewport { x: 0.0, y: 0.0, width, height, near: depth, far: depth, depth_clip }
}

/// The scissor rectangle, if the test is on.
fn scissor(context: &Context) -> Option<Rect> {
    context.state.enables.has(Flag::ScissorTest).then_some(context.state.fragment.scissor)
}

/// The state that a pipeline is made of; what has no effect is left at its default, so that equal
/// draws share one.
fn pipeline_desc(
    context: &Context,
    pass: &PassDesc,
    topology: Topology,
    vertex: ShaderModule,
    fragment: ShaderModule,
) -> PipelineDesc {
    let enables = &context.state.enables;
    let raster = &context.state.raster;
    let state = &context.state.fragment;
    let has = draw_planes(context);
    let depth = (enables.has(Flag::DepthTest) && has.depth)
        .then_some(DepthState { test: state.depth_func, write: state.depth_write });
    // A logical operation switches blending off, also where it does nothing itself (section 4.1.10).
    let logic_op = enables.has(Flag::ColorLogicOp).then_some(state.logic_op);
    let colors = state.buffers.iter().take(pass.colors.len()).map(|buffer| ColorState {
        blend: (buffer.blend && logic_op.is_none())
            .then(|| buffer.formula.to_driver(state.blend_color)),
        mask: buffer.mask,
    });
    let two_side = enables.has(Flag::StencilTestTwoSide);
    let back = if two_side { Side::TwoSideBack } else { Side::Back };
    let output = OutputState {
        stencil: (enables.has(Flag::StencilTest) && has.stencil)
            .then(|| state.stencil.to_driver(back)),
        logic_op,
        srgb: srgb_write(context),
    };
    PipelineDesc {
        vertex,
        fragment,
        topology,
        cull: if enables.has(Flag::CullFace) { raster.cull } else { Cull::None },
        front_face: raster.front_face,
        provoking: raster.provoking,
        depth,
        colors: colors.collect(),
        output,
    }
}

fn pipeline(context: &mut Context, desc: &PipelineDesc) -> Result<Pipeline> {
    let pipelines = &mut context.recorder.pipelines;
    if let Some(pipeline) = pipelines.get(desc) {
        return Ok(pipeline.clone());
    }
    if pipelines.len() >= KEPT {
        pipelines.clear();
    }
    let pipeline = Pipeline::new(desc.clone()).map_err(|error| {
        GlError::new(ErrorCode::InvalidOperation, "GL 2.1, section 2.15.3", error.to_string())
    })?;
    pipelines.insert(desc.clone(), pipeline.clone());
    Ok(pipeline)
}
