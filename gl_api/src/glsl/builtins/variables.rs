//! The built-in variables and constants (GLSL 1.30 chapter 7).

use crate::glsl::hir::{Storage, Variable};
use crate::glsl::source::Span;
use crate::glsl::types::{BOOL, FLOAT, INT, Struct, Type, vec};
use crate::glsl::version::{Stages, Version};
use crate::interface::{
    ATTRIB_COLOR, ATTRIB_FOG_COORD, ATTRIB_NORMAL, ATTRIB_SECONDARY_COLOR, ATTRIB_TEX_COORD,
    ATTRIB_VERTEX, MAX_TEXTURE_UNITS, MAX_VERTEX_ATTRIBS, MatrixForm, StateMatrix, StateVar,
    VARYING_BACK_COLOR, VARYING_COLOR, VARYING_FOG, VARYING_SECONDARY_COLOR, VARYING_TEX_COORD,
};
use rasterizer::ir::Stage;
use std::sync::{Arc, LazyLock};

/// How many render targets `gl_FragData` has.
pub const MAX_DRAW_BUFFERS: u8 = 8;
/// How many scalars may be handed from stage to stage.
pub const MAX_VARYING_FLOATS: u16 = 64;

/// State with an element for each texture unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PerUnit {
    /// `gl_TextureMatrix`.
    Matrix(MatrixForm),
    /// `gl_TextureEnvColor`.
    EnvColor,
}

impl PerUnit {
    /// The state of one unit.
    pub fn of(self, unit: u8) -> StateVar {
        match self {
            Self::Matrix(form) => StateVar::Matrix(StateMatrix::Texture(unit), form),
            Self::EnvColor => StateVar::TextureEnvColor(unit),
        }
    }
}

/// What a built-in variable stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Builtin {
    /// `gl_Position`.
    Position,
    /// `gl_PointSize`.
    PointSize,
    /// `gl_ClipVertex`: accepted and, without user clip planes, without effect.
    ClipVertex,
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
    /// `gl_FragColor`.
    FragColor,
    /// `gl_FragData`.
    FragData,
    /// `gl_FragDepth`.
    FragDepth,
    /// State of the context.
    State(StateVar),
    /// State of each texture unit.
    Units(PerUnit),
    /// An implementation limit.
    Limit(i32),
}

/// Who may write a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Access {
    ReadOnly,
    ReadWrite,
}

struct Row {
    name: &'static str,
    ty: Type,
    stages: Stages,
    since: Version,
    access: Access,
    builtin: Builtin,
}

/// The built-in variable of that name, as a global of a shader.
pub fn find(name: &str, stage: Stage, version: Version) -> Option<Variable> {
    if !name.starts_with("gl_") {
        return None;
    }
    let row = ROWS
        .iter()
        .find(|row| row.name == name && row.stages.has(stage) && row.since <= version)?;
    let constant =
        if let Builtin::Limit(value) = row.builtin { Some([value as u32].into()) } else { None };
    Some(Variable {
        name: row.name.into(),
        ty: row.ty.clone(),
        storage: Storage::Builtin(row.builtin),
        span: Span::default(),
        type_span: None,
        written: false,
        dynamic: false,
        indexed: 0,
        used: true,
        constant,
        init: None,
    })
}

/// The names that a stage has.
pub fn names(stage: Stage, version: Version) -> impl Iterator<Item = &'static str> {
    ROWS.iter().filter(move |row| row.stages.has(stage) && row.since <= version).map(|row| row.name)
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
    use Version::{V110, V120, V130};
    let mut rows = Vec::new();
    let mut row = |name, ty, stages, since, access, builtin| {
        rows.push(Row { name, ty, stages, since, access, builtin });
    };
    let units = u32::from(MAX_TEXTURE_UNITS);
    let array = |ty, len| Type::Array(Box::new(ty), Some(len));

    row("gl_Position", vec(4), Vertex, V110, ReadWrite, Builtin::Position);
    row("gl_PointSize", FLOAT, Vertex, V110, ReadWrite, Builtin::PointSize);
    row("gl_ClipVertex", vec(4), Vertex, V110, ReadWrite, Builtin::ClipVertex);
    row("gl_VertexID", INT, Vertex, V130, ReadOnly, Builtin::VertexId);

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

    row("gl_FragCoord", vec(4), Fragment, V110, ReadOnly, Builtin::FragCoord);
    row("gl_FrontFacing", BOOL, Fragment, V110, ReadOnly, Builtin::FrontFacing);
    row("gl_PointCoord", vec(2), Fragment, V120, ReadOnly, Builtin::PointCoord);
    row("gl_FragColor", vec(4), Fragment, V110, ReadWrite, Builtin::FragColor);
    let targets = array(vec(4), u32::from(MAX_DRAW_BUFFERS));
    row("gl_FragData", targets, Fragment, V110, ReadWrite, Builtin::FragData);
    row("gl_FragDepth", FLOAT, Fragment, V110, ReadWrite, Builtin::FragDepth);

    let mut state = |name, ty, state| row(name, ty, Any, V110, ReadOnly, Builtin::State(state));
    const MATRICES: [(StateMatrix, [&str; 4]); 3] = [
        (
            StateMatrix::ModelView,
            [
                "gl_ModelViewMatrix",
                "gl_ModelViewMatrixInverse",
                "gl_ModelViewMatrixTranspose",
                "gl_ModelViewMatrixInverseTranspose",
            ],
        ),
        (
            StateMatrix::Projection,
            [
                "gl_ProjectionMatrix",
                "gl_ProjectionMatrixInverse",
                "gl_ProjectionMatrixTranspose",
                "gl_ProjectionMatrixInverseTranspose",
            ],
        ),
        (
            StateMatrix::ModelViewProjection,
            [
                "gl_ModelViewProjectionMatrix",
                "gl_ModelViewProjectionMatrixInverse",
                "gl_ModelViewProjectionMatrixTranspose",
                "gl_ModelViewProjectionMatrixInverseTranspose",
            ],
        ),
    ];
    const FORMS: [MatrixForm; 4] = [
        MatrixForm::Plain,
        MatrixForm::Inverse,
        MatrixForm::Transpose,
        MatrixForm::InverseTranspose,
    ];
    for (matrix, names) in MATRICES {
        for (name, form) in names.into_iter().zip(FORMS) {
            state(name, Type::Matrix(4, 4), StateVar::Matrix(matrix, form));
        }
    }
    state("gl_NormalMatrix", Type::Matrix(3, 3), StateVar::NormalMatrix);
    let depth_range = Struct {
        name: "gl_DepthRangeParameters".into(),
        fields: ["near", "far", "diff"].map(|name| (name.into(), FLOAT)).into(),
        scalars: 3,
        depth: 1,
    };
    state("gl_DepthRange", Type::Struct(Arc::new(depth_range)), StateVar::DepthRange);
    let mut unit = |name, ty, per| {
        row(name, array(ty, units), Any, V110, ReadOnly, Builtin::Units(per));
    };
    const TEXTURE_MATRICES: [&str; 4] = [
        "gl_TextureMatrix",
        "gl_TextureMatrixInverse",
        "gl_TextureMatrixTranspose",
        "gl_TextureMatrixInverseTranspose",
    ];
    for (name, form) in TEXTURE_MATRICES.into_iter().zip(FORMS) {
        unit(name, Type::Matrix(4, 4), PerUnit::Matrix(form));
    }
    unit("gl_TextureEnvColor", vec(4), PerUnit::EnvColor);

    let per_unit = i32::from(MAX_TEXTURE_UNITS);
    let limits: [(&str, i32, Version); 15] = [
        ("gl_MaxLights", 8, V110),
        ("gl_MaxClipPlanes", 6, V110),
        ("gl_MaxTextureUnits", per_unit, V110),
        ("gl_MaxTextureCoords", per_unit, V110),
        ("gl_MaxVertexAttribs", i32::from(MAX_VERTEX_ATTRIBS), V110),
        ("gl_MaxVertexUniformComponents", 4096, V110),
        ("gl_MaxVaryingFloats", i32::from(MAX_VARYING_FLOATS), V110),
        ("gl_MaxVertexTextureImageUnits", per_unit, V110),
        ("gl_MaxCombinedTextureImageUnits", per_unit, V110),
        ("gl_MaxTextureImageUnits", per_unit, V110),
        ("gl_MaxFragmentUniformComponents", 4096, V110),
        ("gl_MaxDrawBuffers", i32::from(MAX_DRAW_BUFFERS), V110),
        ("gl_MaxVaryingComponents", i32::from(MAX_VARYING_FLOATS), V130),
        ("gl_MaxClipDistances", 6, V130),
        ("gl_MaxFragmentUniformVectors", 1024, V130),
    ];
    for (name, value, since) in limits {
        row(name, INT, Any, since, ReadOnly, Builtin::Limit(value));
    }
    rows
}
