//! The state of the context that shaders read (GLSL 1.30 section 7.4).

use super::variables::Builtin;
use crate::interface::{
    MAX_TEXTURE_UNITS, MatrixForm, Side, StateMatrix, StateVar, TexCoord, TexGenPlane,
};
use crate::language::Since;
use crate::limits::{MAX_CLIP_PLANES, MAX_LIGHTS};
use crate::types::{FLOAT, Struct, Type, vec};
use std::sync::Arc;

/// State with an element for each texture unit, light or clip plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum StateArray {
    /// `gl_TextureMatrix`.
    TextureMatrix(MatrixForm),
    /// `gl_TextureEnvColor`.
    EnvColor,
    /// `gl_EyePlaneS` and the like.
    TexGen(TexGenPlane, TexCoord),
    /// `gl_LightSource`.
    Light,
    /// `gl_FrontLightProduct`, `gl_BackLightProduct`.
    LightProduct(Side),
    /// `gl_ClipPlane`.
    ClipPlane,
}

impl StateArray {
    /// How many elements there are.
    pub fn len(self) -> u8 {
        match self {
            Self::TextureMatrix(_) | Self::EnvColor | Self::TexGen(..) => MAX_TEXTURE_UNITS,
            Self::Light | Self::LightProduct(_) => MAX_LIGHTS,
            Self::ClipPlane => MAX_CLIP_PLANES,
        }
    }

    /// An element.
    pub fn of(self, index: u8) -> StateVar {
        match self {
            Self::TextureMatrix(form) => StateVar::Matrix(StateMatrix::Texture(index), form),
            Self::EnvColor => StateVar::TextureEnvColor(index),
            Self::TexGen(plane, coord) => StateVar::TexGen(plane, coord, index),
            Self::Light => StateVar::Light(index),
            Self::LightProduct(side) => StateVar::LightProduct(side, index),
            Self::ClipPlane => StateVar::ClipPlane(index),
        }
    }
}

/// A structure of the language: runs of members of one type.
fn structure(name: &str, members: &[(Type, &[&str])]) -> Type {
    let fields: Vec<(Arc<str>, Type)> = members
        .iter()
        .flat_map(|(ty, names)| names.iter().map(|&name| (Arc::from(name), ty.clone())))
        .collect();
    let scalars = fields.iter().map(|(_, ty)| ty.scalars()).sum();
    Type::Struct(Arc::new(Struct { name: name.into(), fields, scalars, depth: 1 }))
}

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
const FORMS: [MatrixForm; 4] =
    [MatrixForm::Plain, MatrixForm::Inverse, MatrixForm::Transpose, MatrixForm::InverseTranspose];
const TEXTURE_MATRICES: [&str; 4] = [
    "gl_TextureMatrix",
    "gl_TextureMatrixInverse",
    "gl_TextureMatrixTranspose",
    "gl_TextureMatrixInverseTranspose",
];
const PLANES: [(TexGenPlane, [&str; 4]); 2] = [
    (TexGenPlane::Eye, ["gl_EyePlaneS", "gl_EyePlaneT", "gl_EyePlaneR", "gl_EyePlaneQ"]),
    (
        TexGenPlane::Object,
        ["gl_ObjectPlaneS", "gl_ObjectPlaneT", "gl_ObjectPlaneR", "gl_ObjectPlaneQ"],
    ),
];
const COORDS: [TexCoord; 4] = [TexCoord::S, TexCoord::T, TexCoord::R, TexCoord::Q];

/// Every piece of state: its name, its type, what brings it, what it stands for.
pub fn rows() -> Vec<(&'static str, Type, Since, Builtin)> {
    let mut rows = Vec::new();
    let mut one = |name, ty, var| rows.push((name, ty, Since::V110, Builtin::State(var)));
    for (matrix, names) in MATRICES {
        for (name, form) in names.into_iter().zip(FORMS) {
            one(name, Type::Matrix(4, 4), StateVar::Matrix(matrix, form));
        }
    }
    one("gl_NormalMatrix", Type::Matrix(3, 3), StateVar::NormalMatrix);
    one("gl_NormalScale", FLOAT, StateVar::NormalScale);
    let point = structure(
        "gl_PointParameters",
        &[(
            FLOAT,
            &[
                "size",
                "sizeMin",
                "sizeMax",
                "fadeThresholdSize",
                "distanceConstantAttenuation",
                "distanceLinearAttenuation",
                "distanceQuadraticAttenuation",
            ],
        )],
    );
    one("gl_Point", point, StateVar::Point);
    let material = structure(
        "gl_MaterialParameters",
        &[(vec(4), &["emission", "ambient", "diffuse", "specular"]), (FLOAT, &["shininess"])],
    );
    one("gl_FrontMaterial", material.clone(), StateVar::Material(Side::Front));
    one("gl_BackMaterial", material, StateVar::Material(Side::Back));
    let model = structure("gl_LightModelParameters", &[(vec(4), &["ambient"])]);
    one("gl_LightModel", model, StateVar::LightModel);
    let scene = structure("gl_LightModelProducts", &[(vec(4), &["sceneColor"])]);
    one("gl_FrontLightModelProduct", scene.clone(), StateVar::LightModelProduct(Side::Front));
    one("gl_BackLightModelProduct", scene, StateVar::LightModelProduct(Side::Back));
    let fog = structure(
        "gl_FogParameters",
        &[(vec(4), &["color"]), (FLOAT, &["density", "start", "end", "scale"])],
    );
    one("gl_Fog", fog, StateVar::Fog);

    let mut array = |name, ty, of: StateArray| {
        let ty = Type::Array(Box::new(ty), Some(of.len().into()));
        rows.push((name, ty, Since::V110, Builtin::States(of)));
    };
    for (name, form) in TEXTURE_MATRICES.into_iter().zip(FORMS) {
        array(name, Type::Matrix(4, 4), StateArray::TextureMatrix(form));
    }
    array("gl_TextureEnvColor", vec(4), StateArray::EnvColor);
    array("gl_ClipPlane", vec(4), StateArray::ClipPlane);
    for (plane, names) in PLANES {
        for (name, coord) in names.into_iter().zip(COORDS) {
            array(name, vec(4), StateArray::TexGen(plane, coord));
        }
    }
    let light = structure(
        "gl_LightSourceParameters",
        &[
            (vec(4), &["ambient", "diffuse", "specular", "position", "halfVector"]),
            (vec(3), &["spotDirection"]),
            (
                FLOAT,
                &[
                    "spotExponent",
                    "spotCutoff",
                    "spotCosCutoff",
                    "constantAttenuation",
                    "linearAttenuation",
                    "quadraticAttenuation",
                ],
            ),
        ],
    );
    array("gl_LightSource", light, StateArray::Light);
    let product = structure("gl_LightProducts", &[(vec(4), &["ambient", "diffuse", "specular"])]);
    array("gl_FrontLightProduct", product.clone(), StateArray::LightProduct(Side::Front));
    array("gl_BackLightProduct", product, StateArray::LightProduct(Side::Back));

    let range = structure("gl_DepthRangeParameters", &[(FLOAT, &["near", "far", "diff"])]);
    let depth_range = Builtin::State(StateVar::DepthRange);
    rows.push(("gl_DepthRange", range, Since::ALWAYS, depth_range));
    rows
}
