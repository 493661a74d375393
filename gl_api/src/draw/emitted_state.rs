//! Emits a draw to the open pass: what differs from the state that was emitted last, and the vertices.
//! `context/recorder/emitted_state.rs` has that state.

use crate::base::error::Result;
use crate::context::Context;
use crate::context::recorder::Recorder;
use crate::context::recorder::elements::{Elements, bit};
use crate::context::recorder::emitted_state::DrawDecisions;
use crate::context::recorder::stages::{Reads, Textures};
use crate::draw::pass::begin_pass;
use crate::draw::pipeline::{more_viewports, pipeline, scissor};
use crate::draw::warnings;
use crate::draw::watched_pixel::{is_watched, watch_draw};
use rasterizer::driver::{
    Buffer, Command, PassDesc, PipelineDesc, RasterState, VertexBinding, Viewport, same_textures,
};
use std::sync::Arc;

/// Everything of a draw but its vertices.
pub(crate) struct PreparedDraw {
    pub pass: PassDesc,
    pub desc: PipelineDesc,
    pub raster: RasterState,
    pub viewport: Viewport,
    pub reads: Reads,
}

/// Emits a draw.
///
/// # Errors
/// When the driver refuses the pipeline.
pub(crate) fn emit(
    context: &mut Context,
    draw: PreparedDraw,
    vertices: Vec<VertexBinding>,
    elements: &Elements,
) -> Result<()> {
    let PreparedDraw { pass, desc, raster, viewport, reads } = draw;
    let watched = is_watched(context, &pass);
    begin_pass(context, pass);
    context.recorder.emitted.pass_call = Some(context.state_changes.calls);
    if let Some(note) = reads.note.filter(|_| watched) {
        watch_draw(context, note.drawing(desc.topology));
    }
    let topology = desc.topology;
    emit_pipeline(context, desc)?;
    emit_state(context, raster, viewport);
    emit_words(&mut context.recorder, reads.words);
    let recorder = &mut context.recorder;
    let textures = [reads.vertex_textures, reads.geometry_textures, reads.fragment_textures];
    emit_textures(recorder, textures);
    let decisions = reads.keys.map(|keys| DrawDecisions::new(context, topology, &vertices, keys));
    context.recorder.emitted.decisions = decisions;
    emit_vertices(context, vertices, elements);
    Ok(())
}

/// Emits the vertices and the draw command; everything else is emitted already.
pub(crate) fn emit_vertices(
    context: &mut Context,
    mut vertices: Vec<VertexBinding>,
    elements: &Elements,
) {
    let read = context.recorder.emitted.attributes_read();
    vertices.retain(|binding| read & bit(binding.location) != 0);
    warnings::arrays::short(context, &vertices, elements);
    let recorder = &mut context.recorder;
    recorder.draws += 1;
    recorder.emitted.last_draw = None;
    let buffers = vertices.iter().filter_map(|binding| binding.source.buffer());
    recorder.held += buffers.map(Buffer::own_bytes).sum::<usize>();
    recorder.push(Command::BindVertices(vertices.drain(..).collect()));
    recorder.bindings = vertices;
    recorder.push_draw(elements);
}

/// Emits uniform words, if they differ.
pub(crate) fn emit_words(recorder: &mut Recorder, words: Vec<u32>) {
    if recorder.emitted.words.as_deref() != Some(&words) {
        let shared: Arc<[u32]> = Arc::from(words.as_slice());
        recorder.push(Command::SetUniforms(Arc::clone(&shared)));
        recorder.emitted.words = Some(shared);
    }
    recorder.words = words;
}

/// Emits the textures of the vertex, the geometry and the fragment stage, if they differ.
pub(crate) fn emit_textures(recorder: &mut Recorder, textures: [Textures; 3]) {
    let same = |emitted: &[Textures; 3]| {
        emitted.iter().zip(&textures).all(|(emitted, textures)| same_textures(emitted, textures))
    };
    if recorder.emitted.textures.as_ref().is_some_and(same) {
        return;
    }
    let [vertex, geometry, fragment] = textures.clone();
    let before = recorder.emitted.textures.as_ref();
    if !before.map_or(geometry.is_empty(), |[_, before, _]| same_textures(before, &geometry)) {
        recorder.push(Command::BindGeometryTextures(geometry));
    }
    recorder.push(Command::BindTextures { vertex, fragment });
    recorder.emitted.textures = Some(textures);
}

/// Emits the pipeline, if it differs.
fn emit_pipeline(context: &mut Context, desc: PipelineDesc) -> Result<()> {
    if context.recorder.emitted.pipeline.as_ref() != Some(&desc) {
        let pipeline = pipeline(context, &desc)?;
        context.recorder.emitted.attributes =
            pipeline.attributes().fold(0, |all, at| all | bit(at));
        context.recorder.emitted.chooses_viewports = pipeline.chooses_viewports();
        context.recorder.push(Command::BindPipeline(pipeline));
        context.recorder.emitted.pipeline = Some(desc);
    }
    Ok(())
}

/// Emits what differs of the rasterizer's state, viewport, scissor and counter.
fn emit_state(context: &mut Context, raster: RasterState, viewport: Viewport) {
    let scissor = scissor(context);
    if context.recorder.emitted.chooses_viewports {
        let more = more_viewports(context);
        let emitted = &mut context.recorder.emitted;
        if emitted.more_viewports.as_ref() != Some(&more) {
            emitted.more_viewports = Some(more.clone());
            context.recorder.push(Command::SetMoreViewports(more));
        }
    }
    let recorder = &mut context.recorder;
    let (emitted, commands) = (&mut recorder.emitted, &mut recorder.commands);
    if emitted.raster.as_deref() != Some(&raster) {
        let shared = Arc::new(raster);
        commands.push(Command::SetRaster(Arc::clone(&shared)));
        emitted.raster = Some(shared);
    }
    if emitted.viewport.replace(viewport) != Some(viewport) {
        commands.push(Command::SetViewport(viewport));
    }
    if emitted.scissor.replace(scissor) != Some(scissor) {
        commands.push(Command::SetScissor(scissor));
    }
    if emitted.counter != recorder.counter {
        commands.push(Command::SetCounter(recorder.counter.clone()));
        emitted.counter.clone_from(&recorder.counter);
    }
}
