//! The built-in functions (GLSL 1.30 chapter 8): signatures, versions, and what they become.

use super::math::{self, Args};
use crate::glsl::Scalar;
use crate::glsl::lower::emit::Emit;
use crate::glsl::types::{Sampler, Type, vec};
use crate::glsl::version::{Stages, Version};
use Version::{V110, V120, V130};
use rasterizer::ir::{Axis, Op, Stage, Value};

/// A type in a signature, which may leave sizes open: `n` and `m` are the same all over it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum P {
    /// Scalar or vector of `n` components: `genType`, `genIType`, …
    Gen(Scalar),
    /// Vector of `n` (2 to 4) components.
    Vec(Scalar),
    /// This many components.
    Fixed(Scalar, u8),
    /// Matrix of `n` columns, `m` rows.
    Mat,
    /// Matrix of `m` columns, `n` rows.
    MatTransposed,
    /// Vector of `m` components.
    Column,
    /// `out genType`.
    Out,
    /// A sampler.
    Sampler(Sampler),
}

/// Where a lookup's level of detail comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LodForm {
    /// From the quad.
    Implicit,
    /// From the quad, and the last argument is added.
    Bias,
    /// The last argument.
    Explicit,
    /// The last two arguments.
    Gradient,
}

/// Whether the coordinates are divided by their last component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Projection {
    /// No.
    None,
    /// Yes.
    Divide,
}

/// What a call becomes.
#[derive(Clone, Copy, Debug)]
pub enum Lower {
    /// The operation on each component; a scalar goes with all components.
    Map(Op),
    /// The derivative of each component.
    Derivative(Axis),
    /// This.
    With(fn(&mut Emit, Args<'_>) -> Vec<Value>),
    /// A texture lookup.
    Texture(Projection, LodForm),
    /// `modf`.
    Modf,
    /// `ftransform`.
    Ftransform,
    /// An error that says so.
    Unsupported,
}

/// A function, for all the sizes its signature leaves open.
#[derive(Debug)]
pub struct Row {
    /// Its name.
    pub name: &'static str,
    /// What it returns.
    pub result: P,
    /// Its parameters.
    pub parameters: &'static [P],
    /// The first version that has it.
    pub since: Version,
    /// The stages that have it.
    pub stages: Stages,
    /// What it becomes.
    pub lower: Lower,
}

impl Row {
    /// Whether it writes an argument.
    pub fn writes(&self) -> bool {
        self.parameters.contains(&P::Out)
    }

    /// Whether a call with constant arguments is constant.
    pub fn folds(&self) -> bool {
        match self.lower {
            Lower::Map(_) | Lower::With(_) => true,
            Lower::Derivative(_)
            | Lower::Texture(..)
            | Lower::Modf
            | Lower::Ftransform
            | Lower::Unsupported => false,
        }
    }

    /// Every signature: the parameters and the result.
    pub fn signatures(&self) -> Vec<(Vec<Type>, Type)> {
        let mut all: Vec<(Vec<Type>, Type)> = Vec::new();
        for n in 1..=4 {
            for m in 2..=4 {
                let parameters: Option<Vec<Type>> =
                    self.parameters.iter().map(|p| p.instance(n, m)).collect();
                if let (Some(parameters), Some(result)) = (parameters, self.result.instance(n, m))
                    && !all.iter().any(|known| known.0 == parameters)
                {
                    all.push((parameters, result));
                }
            }
        }
        all
    }
}

impl P {
    fn instance(self, n: u8, m: u8) -> Option<Type> {
        match self {
            Self::Gen(scalar) => Some(Type::Vector(scalar, n)),
            Self::Vec(scalar) => (n >= 2).then_some(Type::Vector(scalar, n)),
            Self::Fixed(scalar, size) => Some(Type::Vector(scalar, size)),
            Self::Mat => (n >= 2).then_some(Type::Matrix(n, m)),
            Self::MatTransposed => (n >= 2).then_some(Type::Matrix(m, n)),
            Self::Column => Some(vec(m)),
            Self::Out => Some(vec(n)),
            Self::Sampler(sampler) => Some(Type::Sampler(sampler)),
        }
    }
}

/// The rows of a name that a shader has.
pub fn find(name: &str, stage: Stage, version: Version) -> impl Iterator<Item = &'static Row> {
    rows().filter(move |row| row.name == name && row.stages.has(stage) && row.since <= version)
}

/// The names that a shader has.
pub fn names(stage: Stage, version: Version) -> impl Iterator<Item = &'static str> {
    rows().filter(move |row| row.stages.has(stage) && row.since <= version).map(|row| row.name)
}

fn rows() -> impl Iterator<Item = &'static Row> {
    FUNCTIONS.iter().chain(&TEXTURES)
}

const F: P = P::Gen(Scalar::Float);
const I: P = P::Gen(Scalar::Int);
const U: P = P::Gen(Scalar::Uint);
const B: P = P::Gen(Scalar::Bool);
const F1: P = P::Fixed(Scalar::Float, 1);
const F2: P = P::Fixed(Scalar::Float, 2);
const F3: P = P::Fixed(Scalar::Float, 3);
const F4: P = P::Fixed(Scalar::Float, 4);
const I1: P = P::Fixed(Scalar::Int, 1);
const I2: P = P::Fixed(Scalar::Int, 2);
const U1: P = P::Fixed(Scalar::Uint, 1);
const B1: P = P::Fixed(Scalar::Bool, 1);
const VF: P = P::Vec(Scalar::Float);
const VI: P = P::Vec(Scalar::Int);
const VU: P = P::Vec(Scalar::Uint);
const VB: P = P::Vec(Scalar::Bool);

/// A row for both stages.
const fn any(
    name: &'static str,
    result: P,
    parameters: &'static [P],
    since: Version,
    lower: Lower,
) -> Row {
    Row { name, result, parameters, since, stages: Stages::Any, lower }
}

/// A row for the fragment stage.
const fn frag(name: &'static str, result: P, parameters: &'static [P], lower: Lower) -> Row {
    Row { name, result, parameters, since: V110, stages: Stages::Fragment, lower }
}

/// Everything but texture lookups.
static FUNCTIONS: [Row; 119] = {
    use Lower::{Derivative, Ftransform, Map, Modf, Unsupported, With};
    [
        // 8.1 Angle and trigonometry
        any("radians", F, &[F], V110, With(math::radians)),
        any("degrees", F, &[F], V110, With(math::degrees)),
        any("sin", F, &[F], V110, Map(Op::Sin)),
        any("cos", F, &[F], V110, Map(Op::Cos)),
        any("tan", F, &[F], V110, Map(Op::Tan)),
        any("asin", F, &[F], V110, Map(Op::Asin)),
        any("acos", F, &[F], V110, Map(Op::Acos)),
        any("atan", F, &[F, F], V110, Map(Op::Atan2)),
        any("atan", F, &[F], V110, Map(Op::Atan)),
        any("sinh", F, &[F], V130, With(math::sinh)),
        any("cosh", F, &[F], V130, With(math::cosh)),
        any("tanh", F, &[F], V130, With(math::tanh)),
        any("asinh", F, &[F], V130, With(math::asinh)),
        any("acosh", F, &[F], V130, With(math::acosh)),
        any("atanh", F, &[F], V130, With(math::atanh)),
        // 8.2 Exponential
        any("pow", F, &[F, F], V110, Map(Op::Pow)),
        any("exp", F, &[F], V110, Map(Op::Exp)),
        any("log", F, &[F], V110, Map(Op::Log)),
        any("exp2", F, &[F], V110, Map(Op::Exp2)),
        any("log2", F, &[F], V110, Map(Op::Log2)),
        any("sqrt", F, &[F], V110, Map(Op::Sqrt)),
        any("inversesqrt", F, &[F], V110, Map(Op::InverseSqrt)),
        // 8.3 Common
        any("abs", F, &[F], V110, Map(Op::Abs)),
        any("abs", I, &[I], V130, Map(Op::IAbs)),
        any("sign", F, &[F], V110, Map(Op::Sign)),
        any("sign", I, &[I], V130, Map(Op::ISign)),
        any("floor", F, &[F], V110, Map(Op::Floor)),
        any("trunc", F, &[F], V130, Map(Op::Trunc)),
        any("round", F, &[F], V130, Map(Op::RoundEven)),
        any("roundEven", F, &[F], V130, Map(Op::RoundEven)),
        any("ceil", F, &[F], V110, Map(Op::Ceil)),
        any("fract", F, &[F], V110, Map(Op::Fract)),
        any("mod", F, &[F, F1], V110, With(math::modulo)),
        any("mod", F, &[F, F], V110, With(math::modulo)),
        any("modf", F, &[F, P::Out], V130, Modf),
        any("min", F, &[F, F], V110, Map(Op::Min)),
        any("min", F, &[F, F1], V110, Map(Op::Min)),
        any("min", I, &[I, I], V130, Map(Op::IMin)),
        any("min", I, &[I, I1], V130, Map(Op::IMin)),
        any("min", U, &[U, U], V130, Map(Op::UMin)),
        any("min", U, &[U, U1], V130, Map(Op::UMin)),
        any("max", F, &[F, F], V110, Map(Op::Max)),
        any("max", F, &[F, F1], V110, Map(Op::Max)),
        any("max", I, &[I, I], V130, Map(Op::IMax)),
        any("max", I, &[I, I1], V130, Map(Op::IMax)),
        any("max", U, &[U, U], V130, Map(Op::UMax)),
        any("max", U, &[U, U1], V130, Map(Op::UMax)),
        any("clamp", F, &[F, F, F], V110, With(math::clamp)),
        any("clamp", F, &[F, F1, F1], V110, With(math::clamp)),
        any("clamp", I, &[I, I, I], V130, With(math::clamp_int)),
        any("clamp", I, &[I, I1, I1], V130, With(math::clamp_int)),
        any("clamp", U, &[U, U, U], V130, With(math::clamp_uint)),
        any("clamp", U, &[U, U1, U1], V130, With(math::clamp_uint)),
        any("mix", F, &[F, F, F], V110, With(math::mix)),
        any("mix", F, &[F, F, F1], V110, With(math::mix)),
        any("mix", F, &[F, F, B], V130, With(math::mix_select)),
        any("step", F, &[F, F], V110, With(math::step)),
        any("step", F, &[F1, F], V110, With(math::step)),
        any("smoothstep", F, &[F, F, F], V110, With(math::smoothstep)),
        any("smoothstep", F, &[F1, F1, F], V110, With(math::smoothstep)),
        any("isnan", B, &[F], V130, With(math::isnan)),
        any("isinf", B, &[F], V130, With(math::isinf)),
        // 8.4 Geometric
        any("length", F1, &[F], V110, With(math::length)),
        any("distance", F1, &[F, F], V110, With(math::distance)),
        any("dot", F1, &[F, F], V110, With(math::dot)),
        any("cross", F3, &[F3, F3], V110, With(math::cross)),
        any("normalize", F, &[F], V110, With(math::normalize)),
        Row {
            name: "ftransform",
            result: F4,
            parameters: &[],
            since: V110,
            stages: Stages::Vertex,
            lower: Ftransform,
        },
        any("faceforward", F, &[F, F, F], V110, With(math::faceforward)),
        any("reflect", F, &[F, F], V110, With(math::reflect)),
        any("refract", F, &[F, F, F1], V110, With(math::refract)),
        // 8.5 Matrix
        any("matrixCompMult", P::Mat, &[P::Mat, P::Mat], V110, Map(Op::Mul)),
        any("outerProduct", P::Mat, &[P::Column, VF], V120, With(math::outer_product)),
        any("transpose", P::MatTransposed, &[P::Mat], V120, With(math::transpose)),
        // 8.6 Vector relational
        any("lessThan", VB, &[VF, VF], V110, Map(Op::Less)),
        any("lessThan", VB, &[VI, VI], V110, Map(Op::ILess)),
        any("lessThan", VB, &[VU, VU], V130, Map(Op::ULess)),
        any("lessThanEqual", VB, &[VF, VF], V110, Map(Op::LessEqual)),
        any("lessThanEqual", VB, &[VI, VI], V110, Map(Op::ILessEqual)),
        any("lessThanEqual", VB, &[VU, VU], V130, Map(Op::ULessEqual)),
        any("greaterThan", VB, &[VF, VF], V110, With(math::greater)),
        any("greaterThan", VB, &[VI, VI], V110, With(math::greater_int)),
        any("greaterThan", VB, &[VU, VU], V130, With(math::greater_uint)),
        any("greaterThanEqual", VB, &[VF, VF], V110, With(math::greater_equal)),
        any("greaterThanEqual", VB, &[VI, VI], V110, With(math::greater_equal_int)),
        any("greaterThanEqual", VB, &[VU, VU], V130, With(math::greater_equal_uint)),
        any("equal", VB, &[VF, VF], V110, With(math::equal)),
        any("equal", VB, &[VI, VI], V110, With(math::equal)),
        any("equal", VB, &[VU, VU], V130, With(math::equal)),
        any("equal", VB, &[VB, VB], V110, With(math::equal)),
        any("notEqual", VB, &[VF, VF], V110, With(math::not_equal)),
        any("notEqual", VB, &[VI, VI], V110, With(math::not_equal)),
        any("notEqual", VB, &[VU, VU], V130, With(math::not_equal)),
        any("notEqual", VB, &[VB, VB], V110, With(math::not_equal)),
        any("any", B1, &[VB], V110, With(math::any)),
        any("all", B1, &[VB], V110, With(math::all)),
        any("not", VB, &[VB], V110, Map(Op::Not)),
        // 8.8 Fragment processing
        frag("dFdx", F, &[F], Derivative(Axis::X)),
        frag("dFdy", F, &[F], Derivative(Axis::Y)),
        frag("fwidth", F, &[F], With(math::fwidth)),
        // 8.9 Noise
        any("noise1", F1, &[F], V110, Unsupported),
        any("noise2", F2, &[F], V110, Unsupported),
        any("noise3", F3, &[F], V110, Unsupported),
        any("noise4", F4, &[F], V110, Unsupported),
        // 8.7 Lookups of shapes that texunit does not have
        any("texture1D", F4, &[S1, F1], V110, Unsupported),
        any("texture1D", F4, &[S1, F1, F1], V110, Unsupported),
        any("texture1DProj", F4, &[S1, F2], V110, Unsupported),
        any("texture1DProj", F4, &[S1, F4], V110, Unsupported),
        any("texture1DLod", F4, &[S1, F1, F1], V110, Unsupported),
        any("texture3D", F4, &[S3, F3], V110, Unsupported),
        any("texture3D", F4, &[S3, F3, F1], V110, Unsupported),
        any("texture3DProj", F4, &[S3, F4], V110, Unsupported),
        any("texture3DLod", F4, &[S3, F3, F1], V110, Unsupported),
        any("shadow1D", F4, &[S1S, F3], V110, Unsupported),
        any("shadow1D", F4, &[S1S, F3, F1], V110, Unsupported),
        any("shadow1DProj", F4, &[S1S, F4], V110, Unsupported),
        any("texture", F4, &[S1, F1], V130, Unsupported),
        any("texture", F4, &[S3, F3], V130, Unsupported),
        any("texture", F1, &[S1S, F3], V130, Unsupported),
    ]
};

const S1: P = P::Sampler(Sampler::D1);
const S2: P = P::Sampler(Sampler::D2);
const S3: P = P::Sampler(Sampler::D3);
const SC: P = P::Sampler(Sampler::Cube);
const S1S: P = P::Sampler(Sampler::D1Shadow);
const S2S: P = P::Sampler(Sampler::D2Shadow);

/// A lookup for both stages.
const fn look(
    name: &'static str,
    result: P,
    parameters: &'static [P],
    since: Version,
    projection: Projection,
    lod: LodForm,
) -> Row {
    any(name, result, parameters, since, Lower::Texture(projection, lod))
}

/// A lookup with a bias, which only the fragment stage has.
const fn bias(
    name: &'static str,
    result: P,
    parameters: &'static [P],
    since: Version,
    projection: Projection,
) -> Row {
    let lower = Lower::Texture(projection, LodForm::Bias);
    Row { name, result, parameters, since, stages: Stages::Fragment, lower }
}

/// Texture lookups (8.7), and those of GL_ARB_shader_texture_lod.
static TEXTURES: [Row; 58] = {
    use LodForm::{Explicit, Gradient, Implicit};
    use Projection::{Divide, None};
    [
        look("texture2D", F4, &[S2, F2], V110, None, Implicit),
        bias("texture2D", F4, &[S2, F2, F1], V110, None),
        look("texture2DProj", F4, &[S2, F3], V110, Divide, Implicit),
        look("texture2DProj", F4, &[S2, F4], V110, Divide, Implicit),
        bias("texture2DProj", F4, &[S2, F3, F1], V110, Divide),
        bias("texture2DProj", F4, &[S2, F4, F1], V110, Divide),
        look("texture2DLod", F4, &[S2, F2, F1], V110, None, Explicit),
        look("texture2DProjLod", F4, &[S2, F3, F1], V110, Divide, Explicit),
        look("texture2DProjLod", F4, &[S2, F4, F1], V110, Divide, Explicit),
        look("texture2DGradARB", F4, &[S2, F2, F2, F2], V110, None, Gradient),
        look("texture2DProjGradARB", F4, &[S2, F3, F2, F2], V110, Divide, Gradient),
        look("texture2DProjGradARB", F4, &[S2, F4, F2, F2], V110, Divide, Gradient),
        look("textureCube", F4, &[SC, F3], V110, None, Implicit),
        bias("textureCube", F4, &[SC, F3, F1], V110, None),
        look("textureCubeLod", F4, &[SC, F3, F1], V110, None, Explicit),
        look("textureCubeGradARB", F4, &[SC, F3, F3, F3], V110, None, Gradient),
        look("shadow2D", F4, &[S2S, F3], V110, None, Implicit),
        bias("shadow2D", F4, &[S2S, F3, F1], V110, None),
        look("shadow2DProj", F4, &[S2S, F4], V110, Divide, Implicit),
        bias("shadow2DProj", F4, &[S2S, F4, F1], V110, Divide),
        look("shadow2DLod", F4, &[S2S, F3, F1], V110, None, Explicit),
        look("shadow2DProjLod", F4, &[S2S, F4, F1], V110, Divide, Explicit),
        look("shadow2DGradARB", F4, &[S2S, F3, F2, F2], V110, None, Gradient),
        look("shadow2DProjGradARB", F4, &[S2S, F4, F2, F2], V110, Divide, Gradient),
        look("texture", F4, &[S2, F2], V130, None, Implicit),
        bias("texture", F4, &[S2, F2, F1], V130, None),
        look("texture", F4, &[SC, F3], V130, None, Implicit),
        bias("texture", F4, &[SC, F3, F1], V130, None),
        look("texture", F1, &[S2S, F3], V130, None, Implicit),
        bias("texture", F1, &[S2S, F3, F1], V130, None),
        look("textureProj", F4, &[S2, F3], V130, Divide, Implicit),
        bias("textureProj", F4, &[S2, F3, F1], V130, Divide),
        look("textureProj", F4, &[S2, F4], V130, Divide, Implicit),
        bias("textureProj", F4, &[S2, F4, F1], V130, Divide),
        look("textureProj", F1, &[S2S, F4], V130, Divide, Implicit),
        bias("textureProj", F1, &[S2S, F4, F1], V130, Divide),
        look("textureLod", F4, &[S2, F2, F1], V130, None, Explicit),
        look("textureLod", F4, &[SC, F3, F1], V130, None, Explicit),
        look("textureLod", F1, &[S2S, F3, F1], V130, None, Explicit),
        look("textureProjLod", F4, &[S2, F3, F1], V130, Divide, Explicit),
        look("textureProjLod", F4, &[S2, F4, F1], V130, Divide, Explicit),
        look("textureProjLod", F1, &[S2S, F4, F1], V130, Divide, Explicit),
        look("textureGrad", F4, &[S2, F2, F2, F2], V130, None, Gradient),
        look("textureGrad", F4, &[SC, F3, F3, F3], V130, None, Gradient),
        look("textureGrad", F1, &[S2S, F3, F2, F2], V130, None, Gradient),
        look("textureProjGrad", F4, &[S2, F3, F2, F2], V130, Divide, Gradient),
        look("textureProjGrad", F4, &[S2, F4, F2, F2], V130, Divide, Gradient),
        look("textureProjGrad", F1, &[S2S, F4, F2, F2], V130, Divide, Gradient),
        // These need the size of the texture, which the IR does not tell.
        any("textureSize", I2, &[S2, I1], V130, Lower::Unsupported),
        any("textureSize", I2, &[SC, I1], V130, Lower::Unsupported),
        any("textureSize", I2, &[S2S, I1], V130, Lower::Unsupported),
        any("texelFetch", F4, &[S2, I2, I1], V130, Lower::Unsupported),
        any("textureOffset", F4, &[S2, F2, I2], V130, Lower::Unsupported),
        any("textureOffset", F4, &[S2, F2, I2, F1], V130, Lower::Unsupported),
        any("textureOffset", F1, &[S2S, F3, I2], V130, Lower::Unsupported),
        any("textureLodOffset", F4, &[S2, F2, F1, I2], V130, Lower::Unsupported),
        any("textureGradOffset", F4, &[S2, F2, F2, F2, I2], V130, Lower::Unsupported),
        any("textureProjOffset", F4, &[S2, F3, I2], V130, Lower::Unsupported),
    ]
};
