//! The geometry stage of a program: its layout, and the built-in variables that it reads and writes
//! (GLSL 1.50 sections 4.3.8 and 7.1).

use super::Matching;
use super::stage::{BindingMap, StageUnits};
use crate::builtins::variable::{Builtin, Incoming};
use crate::hir::Storage;
use crate::interface::VARYING_CLIP_DISTANCE;
use crate::lower::Binding;
use crate::text::diagnostics::{Diagnostic, Log};
use rasterizer::ir::GeometryInterface;

const RULE: &str = "GLSL 1.50 section 4.3.8";

/// The interface that the shaders of the stage declare together, without its outputs.
pub fn interface(
    geometry: &StageUnits<'_>,
    vertex: Option<&StageUnits<'_>>,
    matching: Matching,
    log: &mut Log,
) -> Option<GeometryInterface> {
    let mut fail = |message: &str, rule: &str| {
        log.push(Diagnostic::link_error(message).rule(rule));
    };
    if vertex.is_none() && matching == Matching::Whole {
        fail("there is a geometry shader and no vertex shader", "GL 3.2 section 2.12");
    }
    let layouts = || geometry.units.iter().map(|unit| unit.geometry);
    let input = layouts().find_map(|layout| layout.input);
    let output = layouts().find_map(|layout| layout.output);
    let max_vertices = layouts().find_map(|layout| layout.max_vertices);
    let differ = layouts().any(|layout| {
        layout.input.is_some_and(|own| Some(own) != input)
            || layout.output.is_some_and(|own| Some(own) != output)
            || layout.max_vertices.is_some_and(|own| Some(own) != max_vertices)
    });
    if differ {
        fail("the geometry shaders have different layouts", RULE);
    }
    if input.is_none() {
        fail(
            "no geometry shader has the layout of the inputs, such as `layout(triangles) in;`",
            RULE,
        );
    }
    if output.is_none() {
        fail(
            "no geometry shader has the primitive of the outputs, such as \
             `layout(triangle_strip, max_vertices = 3) out;`",
            RULE,
        );
    }
    if max_vertices.is_none() {
        fail(
            "no geometry shader says how many vertices it emits: `layout(max_vertices = 3) out;`",
            RULE,
        );
    }
    Some(GeometryInterface {
        input: input?,
        output: output?,
        max_vertices: max_vertices?,
        outputs: Vec::new(),
    })
}

/// Gives `gl_ClipVertex` and `gl_CullDistance` slots from `next` on if the geometry stage reads them, and lets its vertices
/// hold what the fragment stage reads of `gl_ClipDistance`.
pub fn built_in(
    geometry: &StageUnits<'_>,
    fragment: Option<&StageUnits<'_>>,
    mut next: u16,
    [in_vertex, in_geometry]: [&mut BindingMap; 2],
) {
    let is = |builtin: Builtin| move |storage| storage == Storage::Builtin(builtin);
    if !geometry.with(is(Builtin::Incoming(Incoming::ClipVertex))).is_empty() {
        in_vertex.insert("gl_ClipVertex".into(), Binding::Varying(Some(next)));
        in_geometry.insert("gl_in.gl_ClipVertex".into(), Binding::Varying(Some(next)));
        next += 4;
    }
    if !geometry.with(is(Builtin::Incoming(Incoming::CullDistance))).is_empty() {
        in_vertex.insert("gl_CullDistance".into(), Binding::Varying(Some(next)));
        in_geometry.insert("gl_in.gl_CullDistance".into(), Binding::Varying(Some(next)));
    }
    let distances = is(Builtin::ClipDistance);
    if fragment.is_some_and(|fragment| !fragment.with(distances).is_empty()) {
        let slots = Binding::Varying(Some(VARYING_CLIP_DISTANCE));
        in_geometry.insert("gl_ClipDistance".into(), slots);
    }
}
