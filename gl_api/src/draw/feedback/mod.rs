//! A draw in selection and feedback: primitives are assembled (GL 2.1, section 2.6.1), clipped, culled, and drawn as
//! the polygon mode says (section 3.5); what becomes of them is in [`crate::context::feedback`].

pub(crate) mod clip;

use crate::base::error::{ErrorCode, GlError, Result};
use crate::base::memory::out_of_memory;
use crate::context::Context;
use crate::context::feedback::record::PrimitiveToken;
use crate::context::feedback::{Corner, RenderMode};
use crate::context::pending_primitives::vertices_of_primitive;
use crate::context::recorder::elements::Elements;
use crate::context::recorder::vertex_stage::{Outputs, VertexInstance, Vertices};
use crate::draw::assembly_words::has_vertex_program;
use crate::draw::feedback::clip::{DepthPlanes, Vertex};
use crate::draw::pipeline::{depth_clip, front_face, window_transform};
use crate::draw::vertex_stage::shade;
use crate::interface::*;
use crate::state::enable::Flag;
use rasterizer::driver::{
    Cull, FrontFace, PolygonMode, Primitive, Provoking, Topology, VertexBinding, VertexSource,
    primitives,
};
use rasterizer::ir::{Interpolation, Output};
use std::borrow::Cow;
use std::collections::TryReserveError;
use std::ops::Range;
use texunit::lanes::LANES;

const SECTION: &str = "GL 2.1, section 5.2";

/// The vertices of a draw, at most: those of strips are all held at once.
const MAX_VERTICES: u64 = 1 << 24;

/// Vertices of a chunk: whole batches of lanes, and whole primitives of every topology that shares no vertices.
const CHUNK: u32 = 12 * LANES as u32;

/// Carries out a draw.
///
/// # Errors
/// As any draw.
pub(crate) fn draw(
    context: &mut Context,
    topology: Topology,
    vertices: &[VertexBinding],
    elements: &Elements,
) -> Result<()> {
    let (count, instances) = elements.counts();
    let total = u64::from(count) * instances.len() as u64;
    if total > MAX_VERTICES {
        return Err(GlError::new(
            ErrorCode::OutOfMemory,
            SECTION,
            format!("a draw of {total} vertices: at most {MAX_VERTICES} here"),
        ));
    }
    // Primitives that share no vertices go in chunks that stay in the cache.
    let at_once = match vertices_of_primitive(topology) {
        Some(_) => CHUNK,
        None => count.max(1),
    };
    let outputs = match context.feedback.mode {
        RenderMode::Select => Outputs::Positions,
        RenderMode::Feedback | RenderMode::Render => Outputs::Corners,
    };
    for instance in instances {
        for first in (0..count.max(1)).step_by(at_once as usize) {
            let end = count.min(first.saturating_add(at_once));
            let id = |at| VertexInstance { vertex: elements.number(at), instance };
            let mut ids: Vec<VertexInstance> = Vec::new();
            ids.try_reserve_exact((end - first) as usize).map_err(no_memory)?;
            ids.extend((first..end).map(id));
            let shaded = shade(context, vertices, &ids, outputs)?;
            let corners = clip_vertices(context, vertices, &ids, &shaded)?;
            assemble(context, topology, &corners);
        }
    }
    Ok(())
}

fn clip_vertices(
    context: &Context,
    vertices: &[VertexBinding],
    ids: &[VertexInstance],
    shaded: &Vertices,
) -> Result<Vec<Vertex>> {
    let current = |location: u8| context.state.current[usize::from(location)];
    let depth_planes = DepthPlanes::of(depth_clip(context), context.state.clip.control.depth);
    let flags = vertices.iter().find(|binding| binding.location == ATTRIB_EDGE_FLAG);
    let edge = |id: &VertexInstance| match flags.map(|flags| &flags.source) {
        Some(VertexSource::Constant(flag)) => flag[0] != 0.0,
        Some(array @ VertexSource::Array { .. }) => array.read(id.vertex)[0] != 0.0,
        None => true,
    };
    let colors = [VARYING_COLOR, VARYING_BACK_COLOR].map(|first| shaded.varyings(first));
    let coords = shaded.varyings(VARYING_TEX_COORD);
    let [color, coord] = [ATTRIB_COLOR, ATTRIB_TEX_COORD].map(current);
    let position = shaded.position();
    let planes =
        [0, 1, 2, 3, 4, 5, 6, 7].map(|plane| shaded.output_index(Output::ClipDistance(plane)));
    let culls =
        [0, 1, 2, 3, 4, 5, 6, 7].map(|number| shaded.output_index(Output::CullDistance(number)));
    let vertex = |(at, id): (usize, &VertexInstance)| {
        let front = shaded.four(at, colors[0], color);
        let back = shaded.four(at, colors[1], front);
        let values = [front, back, shaded.four(at, coords, coord)];
        let distance = |place: Option<usize>| place.map_or(1.0, |place| shaded.value(at, place));
        let is_culled =
            |place: Option<usize>| place.is_some_and(|place| shaded.value(at, place) < 0.0);
        let culled = (0..).zip(culls).map(|(number, place)| u8::from(is_culled(place)) << number);
        Vertex {
            culled: culled.fold(0, |all, bit| all | bit),
            clip: shaded.four(at, position, [0.0; 4]).map(f64::from),
            distances: planes.map(distance).map(f64::from),
            values: values.map(|value| value.map(f64::from)),
            edge: edge(id),
            depth_planes,
        }
    };
    let mut corners = Vec::new();
    corners.try_reserve_exact(ids.len()).map_err(no_memory)?;
    corners.extend(ids.iter().enumerate().map(vertex));
    Ok(corners)
}

fn no_memory(error: TryReserveError) -> GlError {
    out_of_memory(SECTION, "the vertices")(error)
}

/// Assembles the primitives of a topology.
fn assemble(context: &mut Context, topology: Topology, vertices: &[Vertex]) {
    let count = vertices.len();
    let at = |index: usize| vertices[index];
    let convention = context.state.raster.provoking;
    let provoking = |first, last| &vertices[provoking_vertex(convention, first, last)];
    let line = |context: &mut Context, ends: [usize; 2], kind| {
        emit_line(context, ends.map(at), provoking(ends[0], ends[1]), kind);
    };
    match topology {
        Topology::Points => vertices.iter().for_each(|vertex| point(context, vertex)),
        Topology::Lines => {
            for first in (0..count.saturating_sub(1)).step_by(2) {
                line(context, [first, first + 1], PrimitiveToken::LineReset);
            }
        }
        Topology::LineStrip | Topology::LineLoop => {
            for last in 1..count {
                let kind = if last == 1 { PrimitiveToken::LineReset } else { PrimitiveToken::Line };
                line(context, [last - 1, last], kind);
            }
            if topology == Topology::LineLoop && count > 1 {
                line(context, [count - 1, 0], PrimitiveToken::Line);
            }
        }
        Topology::Triangles => polygons(context, vertices, 3),
        Topology::Quads => polygons(context, vertices, 4),
        Topology::TriangleStrip => {
            for first in 0..count.saturating_sub(2) {
                let [a, b] = if first % 2 == 0 { [0, 1] } else { [1, 0] };
                let corners = [first + a, first + b, first + 2].map(at).map(edged);
                polygon(context, &corners, provoking(first, first + 2));
            }
        }
        Topology::TriangleFan => {
            for last in 2..count {
                let corners = [0, last - 1, last].map(at).map(edged);
                polygon(context, &corners, provoking(last - 1, last));
            }
        }
        Topology::QuadStrip => {
            for first in (0..count.saturating_sub(3)).step_by(2) {
                let corners = [first, first + 1, first + 3, first + 2].map(at).map(edged);
                polygon(context, &corners, provoking(first, first + 3));
            }
        }
        Topology::Polygon if count >= 3 => polygon(context, vertices, &vertices[0]),
        Topology::Polygon => {}
        // The vertices beside them are a geometry shader's.
        Topology::LinesAdjacency
        | Topology::LineStripAdjacency
        | Topology::TrianglesAdjacency
        | Topology::TriangleStripAdjacency => {
            let all = primitives(topology, convention, count as u32);
            for number in 0..all.len {
                let is_first = number == 0 || topology == Topology::LinesAdjacency;
                let kind = if is_first { PrimitiveToken::LineReset } else { PrimitiveToken::Line };
                match all.get(number) {
                    Primitive::Point(_) => {}
                    Primitive::Line(ends, _) => {
                        line(context, ends.map(|index| index as usize), kind);
                    }
                    Primitive::Triangle(corners, provoking, _) => {
                        let corners = corners.map(|index| edged(at(index as usize)));
                        polygon(context, &corners, &corners[usize::from(provoking)]);
                    }
                }
            }
        }
    }
}

/// The provoking vertex of a primitive: its first or its last.
fn provoking_vertex(convention: Provoking, first: usize, last: usize) -> usize {
    match convention {
        Provoking::First => first,
        Provoking::Last => last,
    }
}

/// Strips and fans have no edge flags: all their edges are the polygon's (section 2.6.2).
fn edged(vertex: Vertex) -> Vertex {
    Vertex { edge: true, ..vertex }
}

fn polygons(context: &mut Context, vertices: &[Vertex], corners: usize) {
    let provoking = provoking_vertex(context.state.raster.provoking, 0, corners - 1);
    for corners in vertices.chunks_exact(corners) {
        polygon(context, corners, &corners[provoking]);
    }
}

/// Gives vertices the colours of the provoking one, where shading is flat.
fn shade_flat<'a>(
    context: &Context,
    vertices: &'a [Vertex],
    provoking: &Vertex,
) -> Cow<'a, [Vertex]> {
    if context.state.raster.shade_model != Interpolation::Flat {
        return Cow::Borrowed(vertices);
    }
    let mut vertices = vertices.to_vec();
    for vertex in &mut vertices {
        vertex.values[..2].copy_from_slice(&provoking.values[..2]);
    }
    Cow::Owned(vertices)
}

/// Which of a vertex's colours are used.
#[derive(Clone, Copy)]
enum Facing {
    Front,
    Back,
}

/// The corner in window coordinates (section 2.11.1).
fn corner(context: &Context, vertex: &Vertex, facing: Facing) -> Corner {
    Corner {
        window: window_transform(context).window(vertex.clip),
        clip_w: vertex.clip[3],
        color: match facing {
            Facing::Front => vertex.values[0],
            Facing::Back => vertex.values[1],
        },
        tex_coords: vertex.values[2],
    }
}

fn point(context: &mut Context, vertex: &Vertex) {
    if clip::is_inside(vertex) && !clip::is_culled(&[*vertex]) {
        let corner = corner(context, vertex, Facing::Front);
        context.feedback.primitive(PrimitiveToken::Point, &[corner]);
    }
}

fn emit_line(context: &mut Context, ends: [Vertex; 2], provoking: &Vertex, kind: PrimitiveToken) {
    if clip::is_culled(&ends) {
        return;
    }
    let ends = shade_flat(context, &ends, provoking);
    if let Some(ends) = clip::line([ends[0], ends[1]]) {
        let corners = ends.map(|end| corner(context, &end, Facing::Front));
        context.feedback.primitive(kind, &corners);
    }
}

/// Twice the area of a polygon in the window, positive where it is counterclockwise (section 3.5.1).
fn doubled_area(corners: &[Corner]) -> f64 {
    let edge = |at: usize| {
        let ([x0, y0, _], [x1, y1, _]) =
            (corners[at].window, corners[(at + 1) % corners.len()].window);
        x0 * y1 - x1 * y0
    };
    (Range { start: 0, end: corners.len() }).map(edge).sum()
}

/// Whether polygons have colours of their own on the back (sections 2.14.1 and 2.15.3).
fn is_two_sided(context: &Context) -> bool {
    let enables = &context.state.enables;
    if has_vertex_program(context) {
        return enables.has(Flag::VertexProgramTwoSide);
    }
    enables.has(Flag::Lighting) && context.state.lights.model.two_side
}

fn polygon(context: &mut Context, vertices: &[Vertex], provoking: &Vertex) {
    if clip::is_culled(vertices) {
        return;
    }
    let clipped = clip::polygon(shade_flat(context, vertices, provoking));
    if clipped.len() < 3 {
        return;
    }
    let as_facing = |facing| -> Vec<Corner> {
        clipped.iter().map(|vertex| corner(context, vertex, facing)).collect()
    };
    let mut corners = as_facing(Facing::Front);
    let raster = &context.state.raster;
    let counterclockwise = doubled_area(&corners) > 0.0;
    let is_front = counterclockwise == (front_face(context) == FrontFace::Ccw);
    let culled = match raster.cull {
        Cull::None => false,
        Cull::Front => is_front,
        Cull::Back => !is_front,
        Cull::Both => true,
    };
    if culled && context.state.enables.has(Flag::CullFace) {
        return;
    }
    if !is_front && is_two_sided(context) {
        corners = as_facing(Facing::Back);
    }
    let mode = raster.polygons.mode[usize::from(!is_front)];
    match mode {
        PolygonMode::Fill => context.feedback.primitive(PrimitiveToken::Polygon, &corners),
        PolygonMode::Line => {
            let mut kind = PrimitiveToken::LineReset;
            for at in (0..corners.len()).filter(|&at| clipped[at].edge) {
                let ends = [corners[at], corners[(at + 1) % corners.len()]];
                context.feedback.primitive(kind, &ends);
                kind = PrimitiveToken::Line;
            }
        }
        PolygonMode::Point => {
            for at in (0..corners.len()).filter(|&at| clipped[at].edge) {
                context.feedback.primitive(PrimitiveToken::Point, &corners[at..=at]);
            }
        }
    }
}
