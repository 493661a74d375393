//! The built-in variables and constants (GLSL 1.30 chapter 7), but for the state of the context.

use super::state::{self, StateArray};
use crate::interface::{
    ATTRIB_COLOR, ATTRIB_FOG_COORD, ATTRIB_NORMAL, ATTRIB_SECONDARY_COLOR, ATTRIB_TEX_COORD,
    ATTRIB_VERTEX, MAX_COMBINED_TEXTURE_IMAGE_UNITS, MAX_TEXTURE_IMAGE_UNITS, MAX_TEXTURE_UNITS,
    StateVar, VARYING_BACK_COLOR, VARYING_COLOR, VARYING_FOG, VARYING_SECONDARY_COLOR,
    VARYING_TEX_COORD,
};
use crate::language::{Extension, Language, Since, Stages};
use crate::limits::{
    MAX_CLIP_DISTANCES, MAX_CLIP_PLANES, MAX_DRAW_BUFFERS, MAX_LIGHTS, MAX_UNIFORM_COMPONENTS,
    MAX_VARYING_FLOATS, MAX_VERTEX_ATTRIBS, TEXEL_OFFSETS,
};
use crate::types::{BOOL, FLOAT, INT, Type, vec};
use rasterizer::ir::Stage;
use std::sync::LazyLock;

/// What a built-in variable stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Builtin {
    /// `gl_Position`.
    Position,
    /// `gl_PointSize`.
    PointSize,
    /// `gl_ClipVertex`: what user clip planes are applied to.
    ClipVertex,
    /// `gl_ClipDistance`.
    ClipDistance,
    /// `gl_InstanceID`.
    InstanceId,
    /// `gl_VertexID`.
    VertexId,
    /// A conventional attribute, by location.
    Attribute(u8),
    /// A built-in varying, by slot: written by the vertex stage, read by the fragment stage.
    Varying(u16),
    /// `gl_FragCoord`.
    FragCoord,
    /// `gl_FrontFacing`.
    FrontFacing,
    /// `gl_PointCoord`.
    PointCoord,
    /// `gl_PrimitiveID`, of the fragment stage.
    PrimitiveId,
    /// `gl_FragColor`.
    FragColor,
    /// `gl_FragData`.
    FragData,
    /// `gl_FragDepth`.
    FragDepth,
    /// `gl_FragStencilRefARB`.
    FragStencilRef,
    /// State of the context.
    State(StateVar),
    /// State of each texture unit, light or plane.
    States(StateArray),
    /// An implementation limit.
    Limit(i32),
}

/// Who may write a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Access {
    ReadOnly,
    ReadWrite,
}

/// A built-in variable.
pub struct Row {
    /// Its name.
    pub name: &'static str,
    /// Its type.
    pub ty: Type,
    stages: Stages,
    since: Since,
    access: Access,
    /// What it stands for.
    pub builtin: Builtin,
}

/// The built-in variable of that name.
pub fn find(name: &str, stage: Stage, language: Language) -> Option<&'static Row> {
    if !name.starts_with("gl_") {
        return None;
    }
    ROWS.iter().find(|row| row.name == name && row.stages.has(stage) && language.has(row.since))
}

/// The structure of that name that a built-in variable has.
pub fn structure(name: &str, language: Language) -> Option<Type> {
    let named = |ty: &Type| matches!(ty, Type::Struct(structure) if *structure.name == *name);
    let rows = ROWS.iter().filter(|row| language.has(row.since));
    rows.map(|row| row.ty.base()).find(|ty| named(ty)).cloned()
}

/// What brings a variable that a stage has in some version.
pub fn since(name: &str, stage: Stage) -> Option<Since> {
    ROWS.iter().find(|row| row.name == name && row.stages.has(stage)).map(|row| row.since)
}

/// The names that a stage has.
pub fn names(stage: Stage, language: Language) -> impl Iterator<Item = &'static str> {
    ROWS.iter()
        .filter(move |row| row.stages.has(stage) && language.has(row.since))
        .map(|row| row.name)
}

/// Whether a shader may declare it again: with a size, with words about its interpolation, or with
/// a layout (GLSL 1.30 sections 7.1 and 7.6, ARB_fragment_coord_conventions).
pub fn is_redeclarable(builtin: Builtin) -> bool {
    match builtin {
        Builtin::Varying(_) | Builtin::ClipDistance | Builtin::FragCoord => true,
        Builtin::Position
        | Builtin::PointSize
        | Builtin::ClipVertex
        | Builtin::VertexId
        | Builtin::InstanceId
        | Builtin::Attribute(_)
        | Builtin::PointCoord
        | Builtin::PrimitiveId
        | Builtin::FrontFacing
        | Builtin::FragColor
        | Builtin::FragData
        | Builtin::FragDepth
        | Builtin::FragStencilRef
        | Builtin::State(_)
        | Builtin::States(_)
        | Builtin::Limit(_) => false,
    }
}

/// Whether a stage may write it.
pub fn is_writable(builtin: Builtin, stage: Stage) -> bool {
    let access = ROWS.iter().find(|row| row.builtin == builtin && row.stages.has(stage));
    access.is_some_and(|row| row.access == Access::ReadWrite)
}

/// Every built-in variable, in both stages.
static ROWS: LazyLock<Vec<Row>> = LazyLock::new(rows);

fn rows() -> Vec<Row> {
    use Access::{ReadOnly, ReadWrite};
    use Stages::{Any, Fragment, Vertex};
    const ALWAYS: Since = Since::ALWAYS;
    const V110: Since = Since::V110;
    const V130: Since = Since::V130;
    let mut rows = Vec::new();
    let units = u32::from(MAX_TEXTURE_UNITS);
    let array = |ty, len| Type::Array(Box::new(ty), Some(len));
    let mut row = |name, ty, stages, since, access, builtin| {
        rows.push(Row { name, ty, stages, since, access, builtin });
    };

    row("gl_Position", vec(4), Vertex, ALWAYS, ReadWrite, Builtin::Position);
    row("gl_PointSize", FLOAT, Vertex, ALWAYS, ReadWrite, Builtin::PointSize);
    row("gl_ClipVertex", vec(4), Vertex, V110, ReadWrite, Builtin::ClipVertex);
    row("gl_VertexID", INT, Vertex, V130.or(Extension::GpuShader4), ReadOnly, Builtin::VertexId);
    let draw_instanced = Since::only(Extension::DrawInstanced);
    for (name, since) in [
        ("gl_InstanceIDARB", draw_instanced),
        ("gl_InstanceID", Since::V140.or(Extension::DrawInstanced).or(Extension::GpuShader4)),
    ] {
        row(name, INT, Vertex, since, ReadOnly, Builtin::InstanceId);
    }
    // Without a size: the largest index or a redeclaration brings it (GLSL 1.30 section 7.1).
    let distances = Type::Array(Box::new(FLOAT), None);
    let distance = Builtin::ClipDistance;
    row("gl_ClipDistance", distances.clone(), Vertex, V130, ReadWrite, distance);
    row("gl_ClipDistance", distances, Fragment, V130, ReadOnly, distance);

    let attribute = Builtin::Attribute;
    row("gl_Vertex", vec(4), Vertex, V110, ReadOnly, attribute(ATTRIB_VERTEX));
    row("gl_Normal", vec(3), Vertex, V110, ReadOnly, attribute(ATTRIB_NORMAL));
    row("gl_Color", vec(4), Vertex, V110, ReadOnly, attribute(ATTRIB_COLOR));
    row("gl_SecondaryColor", vec(4), Vertex, V110, ReadOnly, attribute(ATTRIB_SECONDARY_COLOR));
    row("gl_FogCoord", FLOAT, Vertex, V110, ReadOnly, attribute(ATTRIB_FOG_COORD));
    const TEX_COORDS: [&str; 8] = [
        "gl_MultiTexCoord0",
        "gl_MultiTexCoord1",
        "gl_MultiTexCoord2",
        "gl_MultiTexCoord3",
        "gl_MultiTexCoord4",
        "gl_MultiTexCoord5",
        "gl_MultiTexCoord6",
        "gl_MultiTexCoord7",
    ];
    for (name, unit) in TEX_COORDS.into_iter().zip(0..MAX_TEXTURE_UNITS) {
        row(name, vec(4), Vertex, V110, ReadOnly, attribute(ATTRIB_TEX_COORD + unit));
    }

    let varying = Builtin::Varying;
    row("gl_FrontColor", vec(4), Vertex, V110, ReadWrite, varying(VARYING_COLOR));
    row("gl_BackColor", vec(4), Vertex, V110, ReadWrite, varying(VARYING_BACK_COLOR));
    let secondary = varying(VARYING_SECONDARY_COLOR);
    row("gl_FrontSecondaryColor", vec(4), Vertex, V110, ReadWrite, secondary);
    let back = varying(VARYING_BACK_COLOR + 4);
    row("gl_BackSecondaryColor", vec(4), Vertex, V110, ReadWrite, back);
    row("gl_TexCoord", array(vec(4), units), Vertex, V110, ReadWrite, varying(VARYING_TEX_COORD));
    row("gl_FogFragCoord", FLOAT, Vertex, V110, ReadWrite, varying(VARYING_FOG));
    row("gl_Color", vec(4), Fragment, V110, ReadOnly, varying(VARYING_COLOR));
    row("gl_SecondaryColor", vec(4), Fragment, V110, ReadOnly, secondary);
    row("gl_TexCoord", array(vec(4), units), Fragment, V110, ReadOnly, varying(VARYING_TEX_COORD));
    row("gl_FogFragCoord", FLOAT, Fragment, V110, ReadOnly, varying(VARYING_FOG));

    row("gl_FragCoord", vec(4), Fragment, ALWAYS, ReadOnly, Builtin::FragCoord);
    let gpu_shader4 = Since::only(Extension::GpuShader4);
    row("gl_PrimitiveID", INT, Fragment, gpu_shader4, ReadOnly, Builtin::PrimitiveId);
    row("gl_FrontFacing", BOOL, Fragment, ALWAYS, ReadOnly, Builtin::FrontFacing);
    row("gl_PointCoord", vec(2), Fragment, Since::V120.and_es(), ReadOnly, Builtin::PointCoord);
    row("gl_FragColor", vec(4), Fragment, ALWAYS, ReadWrite, Builtin::FragColor);
    let targets = array(vec(4), u32::from(MAX_DRAW_BUFFERS));
    row("gl_FragData", targets, Fragment, ALWAYS, ReadWrite, Builtin::FragData);
    row("gl_FragDepth", FLOAT, Fragment, V110, ReadWrite, Builtin::FragDepth);
    let since = Since::only(Extension::ShaderStencilExport);
    row("gl_FragStencilRefARB", INT, Fragment, since, ReadWrite, Builtin::FragStencilRef);

    for (name, ty, since, builtin) in state::rows() {
        row(name, ty, Any, since, ReadOnly, builtin);
    }

    let per_unit = i32::from(MAX_TEXTURE_UNITS);
    let floats = i32::from(MAX_VARYING_FLOATS);
    let es = Since::ES;
    let limits: [(&str, i32, Since); 19] = [
        ("gl_MaxLights", MAX_LIGHTS.into(), V110),
        ("gl_MaxClipPlanes", MAX_CLIP_PLANES.into(), V110),
        ("gl_MaxTextureUnits", per_unit, V110),
        ("gl_MaxTextureCoords", per_unit, V110),
        ("gl_MaxVertexAttribs", MAX_VERTEX_ATTRIBS.into(), ALWAYS),
        ("gl_MaxVertexUniformComponents", MAX_UNIFORM_COMPONENTS, V110),
        ("gl_MaxVaryingFloats", floats, V110),
        ("gl_MaxVertexTextureImageUnits", MAX_TEXTURE_IMAGE_UNITS.into(), ALWAYS),
        ("gl_MaxCombinedTextureImageUnits", MAX_COMBINED_TEXTURE_IMAGE_UNITS.into(), ALWAYS),
        ("gl_MaxTextureImageUnits", MAX_TEXTURE_IMAGE_UNITS.into(), ALWAYS),
        ("gl_MaxFragmentUniformComponents", MAX_UNIFORM_COMPONENTS, V110),
        ("gl_MaxDrawBuffers", MAX_DRAW_BUFFERS.into(), ALWAYS),
        ("gl_MaxVaryingComponents", floats, V130),
        ("gl_MaxClipDistances", MAX_CLIP_DISTANCES.into(), V130),
        ("gl_MaxVertexUniformVectors", MAX_UNIFORM_COMPONENTS / 4, es),
        ("gl_MaxFragmentUniformVectors", MAX_UNIFORM_COMPONENTS / 4, es),
        ("gl_MaxVaryingVectors", floats / 4, es),
        ("gl_MinProgramTexelOffset", *TEXEL_OFFSETS.start(), V130),
        ("gl_MaxProgramTexelOffset", *TEXEL_OFFSETS.end(), V130),
    ];
    for (name, value, since) in limits {
        row(name, INT, Any, since, ReadOnly, Builtin::Limit(value));
    }
    rows
}
