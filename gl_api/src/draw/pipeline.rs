//! The pipeline of a draw, viewport and scissor: GL state in the driver's terms.

use crate::base::error::{ErrorCode, GlError, Result};
use crate::context::Context;
use crate::draw::completeness::draw_planes;
use crate::draw::no_effect;
use crate::state::enable::Flag;
use crate::state::stencil::Side;
use crate::state::viewport::WindowTransform;
use rasterizer::driver::{
    ClipControl, ClipOrigin, ColorState, Cull, DepthClip, DepthState, FrontFace, MAX_VIEWPORTS,
    OutputState, PassDesc, Pipeline, PipelineDesc, Rect, ScissoredViewport, ShaderModule,
    SrgbWrite, Topology, Viewport,
};
use std::sync::Arc;

/// When there are this many pipelines, all are dropped.
const MAX_PIPELINES: usize = 1024;

/// The viewport, with its range of depths.
pub(crate) fn viewport(context: &Context) -> Viewport {
    numbered_viewport(context, 0)
}

fn numbered_viewport(context: &Context, number: usize) -> Viewport {
    let viewport = context.state.viewport.get(number);
    let [near, far] = viewport.depth;
    Viewport {
        x: viewport.x,
        y: viewport.y,
        width: viewport.width,
        height: viewport.height,
        near: near as f32,
        far: far as f32,
        depth_clip: depth_clip(context),
        clip_control: context.state.clip.control,
    }
}

/// The whole framebuffer, everything at one depth.
pub(crate) fn rectangle_viewport(pass: &PassDesc, depth: f32) -> Viewport {
    let (width, height) = (pass.width as f32, pass.height as f32);
    Viewport {
        x: 0.0,
        y: 0.0,
        width,
        height,
        near: depth,
        far: depth,
        depth_clip: DepthClip::Cut,
        clip_control: ClipControl::default(),
    }
}

/// The scissor rectangle, if the test is on.
pub(crate) fn scissor(context: &Context) -> Option<Rect> {
    context.state.enables.has(Flag::ScissorTest).then_some(context.state.fragment.scissor.first)
}

/// The viewports from number 1 on, and their scissor rectangles.
pub(crate) fn more_viewports(context: &Context) -> Arc<[ScissoredViewport]> {
    let fragment = &context.state.fragment;
    let numbered = |number: usize| ScissoredViewport {
        viewport: numbered_viewport(context, number),
        scissor: (fragment.scissor_tests >> number & 1 == 1).then(|| fragment.scissor.get(number)),
    };
    (1..MAX_VIEWPORTS).map(numbered).collect()
}

/// The state that a pipeline is made of; what has no effect is left at its default, so that equal
/// draws share one.
pub(crate) fn pipeline_desc(
    context: &Context,
    pass: &PassDesc,
    topology: Topology,
    (vertex, geometry, fragment): (ShaderModule, Option<ShaderModule>, ShaderModule),
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
        blend: if buffer.blend && logic_op.is_none() {
            no_effect::blend(context, buffer.formula)
        } else {
            None
        },
        mask: buffer.mask,
    });
    let two_side = enables.has(Flag::StencilTestTwoSide);
    let back = if two_side { Side::TwoSideBack } else { Side::Back };
    let output = OutputState {
        stencil: (enables.has(Flag::StencilTest) && has.stencil)
            .then(|| state.stencil.to_driver(back)),
        logic_op: logic_op.and_then(|op| no_effect::logic_op(context, op)),
        srgb: srgb_write(context),
    };
    PipelineDesc {
        vertex,
        geometry,
        fragment,
        topology,
        cull: if enables.has(Flag::CullFace) { raster.cull } else { Cull::None },
        front_face: front_face(context),
        provoking: raster.provoking,
        depth,
        colors: colors.collect(),
        output,
    }
}

/// The pipeline of a description, which is compiled the first time.
///
/// # Errors
/// When the driver refuses it.
pub(crate) fn pipeline(context: &mut Context, desc: &PipelineDesc) -> Result<Pipeline> {
    let pipelines = &mut context.recorder.pipelines;
    if let Some(pipeline) = pipelines.get(desc) {
        return Ok(pipeline.clone());
    }
    if pipelines.len() >= MAX_PIPELINES {
        pipelines.clear();
    }
    let pipeline = Pipeline::new(desc.clone()).map_err(|error| {
        GlError::new(ErrorCode::InvalidOperation, "GL 2.1, section 2.15.3", error.to_string())
    })?;
    pipelines.insert(desc.clone(), pipeline.clone());
    Ok(pipeline)
}

/// What is written to attachments of an sRGB format.
pub(crate) fn srgb_write(context: &Context) -> SrgbWrite {
    if context.state.enables.has(Flag::FramebufferSrgb) {
        SrgbWrite::Encode
    } else {
        SrgbWrite::AsIs
    }
}

/// What the near and the far plane do (`ARB_depth_clamp`).
pub(crate) fn depth_clip(context: &Context) -> DepthClip {
    if context.state.enables.has(Flag::DepthClamp) { DepthClip::Clamp } else { DepthClip::Cut }
}

/// The orientation in the window of front faces. An origin above turns the picture upside down, and no face to its other
/// side (`ARB_clip_control`: the sign of the area is negated).
pub(crate) fn front_face(context: &Context) -> FrontFace {
    match (context.state.raster.front_face, context.state.clip.control.origin) {
        (FrontFace::Ccw, ClipOrigin::LowerLeft) | (FrontFace::Cw, ClipOrigin::UpperLeft) => {
            FrontFace::Ccw
        }
        (FrontFace::Cw, ClipOrigin::LowerLeft) | (FrontFace::Ccw, ClipOrigin::UpperLeft) => {
            FrontFace::Cw
        }
    }
}

/// How positions of the current state become window coordinates.
pub(crate) fn window_transform(context: &Context) -> WindowTransform<'_> {
    WindowTransform {
        viewport: &context.state.viewport.first,
        control: context.state.clip.control,
        depth_clip: depth_clip(context),
    }
}
