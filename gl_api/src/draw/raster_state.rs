//! The rasterizer's state of a draw: points, lines, polygons, and samples. What has no effect on the primitives is left
//! at its default, so that draws that are equal but for that emit it once.

use crate::base::types::*;
use crate::context::Context;
use crate::draw::assembly_words::has_vertex_program;
use crate::draw::completeness::{draws_integers, samples};
use crate::draw::no_effect;
use crate::interface::{ATTRIB_EDGE_FLAG, VARYING_TEX_COORD};
use crate::state::enable::Flag;
use crate::state::multisample::Multisample;
use rasterizer::driver::{
    AlphaToCoverage, AlphaToOne, Antialiasing, LineState, LineStipple, MultisampleState, PointSize,
    PointState, PolygonMode, PolygonOffset, PolygonState, PolygonSubject, RasterState,
    SampleCoverage, SampleRule, SampleShading, Topology, VertexBinding, VertexSource, ViewSides,
};

/// What the primitives of a draw are rasterized as.
#[derive(Clone, Copy, Debug)]
struct RasterizedAs {
    points: bool,
    lines: bool,
    polygons: bool,
}

fn rasterized_as(context: &Context, topology: Topology) -> RasterizedAs {
    match topology {
        Topology::Points => RasterizedAs { points: true, lines: false, polygons: false },
        Topology::Lines
        | Topology::LineStrip
        | Topology::LineLoop
        | Topology::LinesAdjacency
        | Topology::LineStripAdjacency => {
            RasterizedAs { points: false, lines: true, polygons: false }
        }
        Topology::Triangles
        | Topology::TrianglesAdjacency
        | Topology::TriangleStripAdjacency
        | Topology::TriangleStrip
        | Topology::TriangleFan
        | Topology::Quads
        | Topology::QuadStrip
        | Topology::Polygon => {
            let mode = &context.state.raster.polygons.mode;
            RasterizedAs {
                points: mode.contains(&PolygonMode::Point),
                lines: mode.contains(&PolygonMode::Line),
                polygons: true,
            }
        }
    }
}

/// Smooth where its flag is on.
fn antialiasing(context: &Context, flag: Flag) -> Antialiasing {
    if context.state.enables.has(flag) { Antialiasing::Smooth } else { Antialiasing::Aliased }
}

/// Whether any primitive of the topology has a smooth edge, so that its coverage changes alpha (GL
/// 2.1, section 3.12), or is a point that may fade (section 3.13).
pub(crate) fn smoothness(context: &Context, topology: Topology) -> Antialiasing {
    let RasterizedAs { points, lines, polygons } = rasterized_as(context, topology);
    let enables = &context.state.enables;
    let sprites = enables.has(Flag::PointSprite);
    let smooth = points && !sprites && enables.has(Flag::PointSmooth)
        || lines && enables.has(Flag::LineSmooth)
        || polygons && enables.has(Flag::PolygonSmooth)
        || points && fade(context).is_some();
    if smooth { Antialiasing::Smooth } else { Antialiasing::Aliased }
}

/// How the primitives of a draw become fragments.
pub(crate) fn raster_state(
    context: &Context,
    topology: Topology,
    vertices: &[VertexBinding],
) -> RasterState {
    let RasterizedAs { points, lines, polygons } = rasterized_as(context, topology);
    let mut state = RasterState::default();
    if context.profile.is_es() {
        state.sides = ViewSides::Bound;
    }
    if polygons {
        state.polygon = polygon_state(context, vertices);
    }
    if lines {
        let raster = &context.state.raster;
        let stipple =
            LineStipple { factor: raster.stipple_factor, pattern: raster.stipple_pattern };
        state.line = LineState {
            width: raster.line_width,
            antialiasing: antialiasing(context, Flag::LineSmooth),
            stipple: context.state.enables.has(Flag::LineStipple).then_some(stipple),
        };
    }
    if points {
        state.point = point_state(context);
    }
    state
}

fn polygon_state(context: &Context, vertices: &[VertexBinding]) -> PolygonState {
    let (enables, polygons) = (&context.state.enables, &context.state.raster.polygons);
    let offset = PolygonOffset {
        factor: polygons.offset_factor,
        units: polygons.offset_units,
        clamp: polygons.offset_clamp,
    };
    let has_stipple = enables.has(Flag::PolygonStipple);
    let stipple = has_stipple.then(|| no_effect::stipple(context)).flatten();
    let flags = [Flag::PolygonOffsetPoint, Flag::PolygonOffsetLine, Flag::PolygonOffsetFill];
    // Edge flags that are all set change nothing, nor do they where the inside is filled.
    let flagged = polygons.mode != [PolygonMode::Fill; 2]
        && vertices.iter().any(|binding| {
            binding.location == ATTRIB_EDGE_FLAG
                && !matches!(binding.source, VertexSource::Constant([flag, ..]) if flag != 0.0)
        });
    PolygonState {
        subject: PolygonSubject::Polygons,
        mode: polygons.mode,
        offset: flags.map(|flag| enables.has(flag).then_some(offset)),
        antialiasing: antialiasing(context, Flag::PolygonSmooth),
        stipple,
        edge_flag: flagged.then_some(ATTRIB_EDGE_FLAG),
    }
}

/// Whether the vertex stage gives points their sizes (GL 2.1, section 3.3): a program where that is enabled, else the
/// fixed-function stage, which attenuates them.
fn has_own_sizes(context: &Context) -> bool {
    match has_vertex_program(context) {
        true => context.state.enables.has(Flag::VertexProgramPointSize),
        false => context.state.raster.points.attenuates(),
    }
}

/// The size below which points fade (GL 2.1, section 3.3), where there are samples and a point may be as small. OpenGL
/// ES has no such size, and integers have no alpha.
fn fade(context: &Context) -> Option<f32> {
    let points = &context.state.raster.points;
    let has_samples = context.state.enables.has(Flag::Multisample)
        && samples(context, context.state.bindings.draw_framebuffer) > 0;
    let may_be_smaller = || has_own_sizes(context) || points.derived_size() < points.fade;
    let fades = has_samples && may_be_smaller() && !context.profile.is_es();
    (fades && !draws_integers(context)).then_some(points.fade)
}

fn point_state(context: &Context) -> PointState {
    let (enables, points) = (&context.state.enables, &context.state.raster.points);
    let sprite = enables.has(Flag::PointSprite).then(|| {
        let units =
            (0..).zip(context.state.units.units.iter()).filter(|(_, unit)| unit.coord_replace);
        units.map(|(unit, _)| VARYING_TEX_COORD + 4 * unit).collect()
    });
    PointState {
        size: points.derived_size(),
        source: if has_own_sizes(context) { PointSize::Vertex } else { PointSize::State },
        antialiasing: antialiasing(context, Flag::PointSmooth),
        sprite,
        origin: points.origin,
        fade: fade(context),
    }
}

/// What a draw does with the samples of the draw framebuffer, whose coverage follows `rule`: the
/// default where it has one a pixel or `GL_MULTISAMPLE` is off.
pub(crate) fn multisample_state(context: &Context, rule: SampleRule) -> MultisampleState {
    let state = &context.state;
    let has = |flag| state.enables.has(flag);
    if !has(Flag::Multisample) || samples(context, state.bindings.draw_framebuffer) == 0 {
        return MultisampleState::default();
    }
    let Multisample { value, invert, mask, shaded } = state.raster.multisample;
    let samples = samples(context, state.bindings.draw_framebuffer);
    // At least max(⌈value · samples⌉, 1) of them are shaded (ARB_sample_shading, section 3.3.1): one, or each.
    let is_each = has(Flag::SampleShading) && shaded * f32::from(samples) > 1.0;
    let coverage = match invert {
        false => SampleCoverage::Part(value),
        true => SampleCoverage::AllBut(value),
    };
    // Where draw buffer zero holds integers, both are skipped, for the other buffers too (GL 3.0, section 4.1.3).
    let has_alpha = !draws_integers(context);
    MultisampleState {
        rule,
        alpha_to_coverage: match has_alpha && has(Flag::SampleAlphaToCoverage) {
            false => AlphaToCoverage::Off,
            true => AlphaToCoverage::On,
        },
        alpha_to_one: match has_alpha && has(Flag::SampleAlphaToOne) {
            false => AlphaToOne::Off,
            true => AlphaToOne::On,
        },
        coverage: has(Flag::SampleCoverage).then_some(coverage),
        mask: if has(Flag::SampleMask) { mask } else { GLbitfield::MAX },
        shading: if is_each { SampleShading::Each } else { SampleShading::Once },
    }
}
