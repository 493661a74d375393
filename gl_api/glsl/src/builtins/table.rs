//! The built-in functions but for texture lookups (GLSL 1.40 sections 8.1 to 8.6, 8.8 and 8.9), one
//! row for all sizes of a signature.

use super::functions::{Lower, P, Row};
use super::{math, matrix, noise};
use crate::language::{Extension, Since, Stages};
use crate::types::Scalar;
use rasterizer::ir::{Axis, Op};

const ALWAYS: Since = Since::ALWAYS;
const V110: Since = Since::V110;
const V120: Since = Since::V120;
const V130: Since = Since::V130;
/// What came with integers.
const INTEGER: Since = Since::V130.or(Extension::GpuShader4);

/// What gives the bits of numbers.
const BITS: Since = Since::only(Extension::ShaderBitEncoding);

const F: P = P::Gen(Scalar::Float);
const I: P = P::Gen(Scalar::Int);
const U: P = P::Gen(Scalar::Uint);
const B: P = P::Gen(Scalar::Bool);
const F1: P = P::Fixed(Scalar::Float, 1);
const F2: P = P::Fixed(Scalar::Float, 2);
const F3: P = P::Fixed(Scalar::Float, 3);
const F4: P = P::Fixed(Scalar::Float, 4);
const I1: P = P::Fixed(Scalar::Int, 1);
const U1: P = P::Fixed(Scalar::Uint, 1);
const B1: P = P::Fixed(Scalar::Bool, 1);
const VF: P = P::Vec(Scalar::Float);
const VI: P = P::Vec(Scalar::Int);
const VU: P = P::Vec(Scalar::Uint);
const VB: P = P::Vec(Scalar::Bool);

/// A row for both stages.
fn any(name: &str, result: P, parameters: &[P], since: Since, lower: Lower) -> Row {
    let (name, parameters, stages) = (name.to_owned(), parameters.to_vec(), Stages::Any);
    Row { name, result, parameters, since, stages, lower }
}

/// A derivative: a row for the fragment stage.
fn derivative(name: &str, lower: Lower) -> Row {
    let since = V110.or(Extension::StandardDerivatives);
    let (name, parameters, stages) = (name.to_owned(), vec![F], Stages::Fragment);
    Row { name, result: F, parameters, since, stages, lower }
}

/// Everything but texture lookups.
pub fn rows() -> Vec<Row> {
    use Lower::{Derivative, Ftransform, Map, Modf, With};
    vec![
        // 8.1 Angle and trigonometry
        any("radians", F, &[F], ALWAYS, With(math::radians)),
        any("degrees", F, &[F], ALWAYS, With(math::degrees)),
        any("sin", F, &[F], ALWAYS, Map(Op::Sin)),
        any("cos", F, &[F], ALWAYS, Map(Op::Cos)),
        any("tan", F, &[F], ALWAYS, Map(Op::Tan)),
        any("asin", F, &[F], ALWAYS, Map(Op::Asin)),
        any("acos", F, &[F], ALWAYS, Map(Op::Acos)),
        any("atan", F, &[F, F], ALWAYS, Map(Op::Atan2)),
        any("atan", F, &[F], ALWAYS, Map(Op::Atan)),
        any("sinh", F, &[F], V130, Map(Op::Sinh)),
        any("cosh", F, &[F], V130, Map(Op::Cosh)),
        any("tanh", F, &[F], V130, Map(Op::Tanh)),
        any("asinh", F, &[F], V130, Map(Op::Asinh)),
        any("acosh", F, &[F], V130, Map(Op::Acosh)),
        any("atanh", F, &[F], V130, Map(Op::Atanh)),
        // 8.2 Exponential
        any("pow", F, &[F, F], ALWAYS, Map(Op::Pow)),
        any("exp", F, &[F], ALWAYS, Map(Op::Exp)),
        any("log", F, &[F], ALWAYS, Map(Op::Log)),
        any("exp2", F, &[F], ALWAYS, Map(Op::Exp2)),
        any("log2", F, &[F], ALWAYS, Map(Op::Log2)),
        any("sqrt", F, &[F], ALWAYS, Map(Op::Sqrt)),
        any("inversesqrt", F, &[F], ALWAYS, Map(Op::InverseSqrt)),
        // 8.3 Common
        any("abs", F, &[F], ALWAYS, Map(Op::Abs)),
        any("abs", I, &[I], INTEGER, Map(Op::IAbs)),
        any("sign", F, &[F], ALWAYS, Map(Op::Sign)),
        any("sign", I, &[I], INTEGER, Map(Op::ISign)),
        any("floor", F, &[F], ALWAYS, Map(Op::Floor)),
        any("trunc", F, &[F], V130, Map(Op::Trunc)),
        any("truncate", F, &[F], Since::only(Extension::GpuShader4), Map(Op::Trunc)),
        any("round", F, &[F], INTEGER, Map(Op::RoundEven)),
        any("roundEven", F, &[F], V130, Map(Op::RoundEven)),
        any("ceil", F, &[F], ALWAYS, Map(Op::Ceil)),
        any("fract", F, &[F], ALWAYS, Map(Op::Fract)),
        any("mod", F, &[F, F1], ALWAYS, With(math::modulo)),
        any("mod", F, &[F, F], ALWAYS, With(math::modulo)),
        any("modf", F, &[F, P::Out], V130, Modf),
        any("min", F, &[F, F], ALWAYS, With(math::min)),
        any("min", F, &[F, F1], ALWAYS, With(math::min)),
        any("min", I, &[I, I], INTEGER, Map(Op::IMin)),
        any("min", I, &[I, I1], INTEGER, Map(Op::IMin)),
        any("min", U, &[U, U], INTEGER, Map(Op::UMin)),
        any("min", U, &[U, U1], INTEGER, Map(Op::UMin)),
        any("max", F, &[F, F], ALWAYS, With(math::max)),
        any("max", F, &[F, F1], ALWAYS, With(math::max)),
        any("max", I, &[I, I], INTEGER, Map(Op::IMax)),
        any("max", I, &[I, I1], INTEGER, Map(Op::IMax)),
        any("max", U, &[U, U], INTEGER, Map(Op::UMax)),
        any("max", U, &[U, U1], INTEGER, Map(Op::UMax)),
        any("clamp", F, &[F, F, F], ALWAYS, With(math::clamp)),
        any("clamp", F, &[F, F1, F1], ALWAYS, With(math::clamp)),
        any("clamp", I, &[I, I, I], INTEGER, With(math::clamp_int)),
        any("clamp", I, &[I, I1, I1], INTEGER, With(math::clamp_int)),
        any("clamp", U, &[U, U, U], INTEGER, With(math::clamp_uint)),
        any("clamp", U, &[U, U1, U1], INTEGER, With(math::clamp_uint)),
        any("mix", F, &[F, F, F], ALWAYS, With(math::mix)),
        any("mix", F, &[F, F, F1], ALWAYS, With(math::mix)),
        any("mix", F, &[F, F, B], V130, With(math::mix_select)),
        any("step", F, &[F, F], ALWAYS, With(math::step)),
        any("step", F, &[F1, F], ALWAYS, With(math::step)),
        any("smoothstep", F, &[F, F, F], ALWAYS, With(math::smoothstep)),
        any("smoothstep", F, &[F1, F1, F], ALWAYS, With(math::smoothstep)),
        any("isnan", B, &[F], V130, With(math::isnan)),
        any("isinf", B, &[F], V130, With(math::isinf)),
        any("floatBitsToInt", I, &[F], BITS, With(math::float_bits_to_int)),
        any("floatBitsToUint", U, &[F], BITS, With(math::float_bits_to_uint)),
        any("intBitsToFloat", F, &[I], BITS, With(math::int_bits_to_float)),
        any("uintBitsToFloat", F, &[U], BITS, Map(Op::BitsFloat)),
        // 8.4 Geometric
        any("length", F1, &[F], ALWAYS, With(math::length)),
        any("distance", F1, &[F, F], ALWAYS, With(math::distance)),
        any("dot", F1, &[F, F], ALWAYS, With(math::dot)),
        any("cross", F3, &[F3, F3], ALWAYS, With(math::cross)),
        any("normalize", F, &[F], ALWAYS, With(math::normalize)),
        Row {
            name: "ftransform".to_owned(),
            result: F4,
            parameters: Vec::new(),
            since: V110,
            stages: Stages::Vertex,
            lower: Ftransform,
        },
        any("faceforward", F, &[F, F, F], ALWAYS, With(math::faceforward)),
        any("reflect", F, &[F, F], ALWAYS, With(math::reflect)),
        any("refract", F, &[F, F, F1], ALWAYS, With(math::refract)),
        // 8.5 Matrix
        any("matrixCompMult", P::Mat, &[P::Mat, P::Mat], ALWAYS, Map(Op::Mul)),
        any("outerProduct", P::Mat, &[P::Column, VF], V120, With(math::outer_product)),
        any("transpose", P::MatTransposed, &[P::Mat], V120, With(math::transpose)),
        any("inverse", P::Square, &[P::Square], Since::V140, With(matrix::inverse)),
        // 8.6 Vector relational
        any("lessThan", VB, &[VF, VF], ALWAYS, Map(Op::Less)),
        any("lessThan", VB, &[VI, VI], ALWAYS, Map(Op::ILess)),
        any("lessThan", VB, &[VU, VU], INTEGER, Map(Op::ULess)),
        any("lessThanEqual", VB, &[VF, VF], ALWAYS, Map(Op::LessEqual)),
        any("lessThanEqual", VB, &[VI, VI], ALWAYS, Map(Op::ILessEqual)),
        any("lessThanEqual", VB, &[VU, VU], INTEGER, Map(Op::ULessEqual)),
        any("greaterThan", VB, &[VF, VF], ALWAYS, With(math::greater)),
        any("greaterThan", VB, &[VI, VI], ALWAYS, With(math::greater_int)),
        any("greaterThan", VB, &[VU, VU], INTEGER, With(math::greater_uint)),
        any("greaterThanEqual", VB, &[VF, VF], ALWAYS, With(math::greater_equal)),
        any("greaterThanEqual", VB, &[VI, VI], ALWAYS, With(math::greater_equal_int)),
        any("greaterThanEqual", VB, &[VU, VU], INTEGER, With(math::greater_equal_uint)),
        any("equal", VB, &[VF, VF], ALWAYS, With(math::equal)),
        any("equal", VB, &[VI, VI], ALWAYS, With(math::equal)),
        any("equal", VB, &[VU, VU], INTEGER, With(math::equal)),
        any("equal", VB, &[VB, VB], ALWAYS, With(math::equal)),
        any("notEqual", VB, &[VF, VF], ALWAYS, With(math::not_equal)),
        any("notEqual", VB, &[VI, VI], ALWAYS, With(math::not_equal)),
        any("notEqual", VB, &[VU, VU], INTEGER, With(math::not_equal)),
        any("notEqual", VB, &[VB, VB], ALWAYS, With(math::not_equal)),
        any("any", B1, &[VB], ALWAYS, With(math::any)),
        any("all", B1, &[VB], ALWAYS, With(math::all)),
        any("not", VB, &[VB], ALWAYS, Map(Op::Not)),
        // 8.8 Fragment processing
        derivative("dFdx", Derivative(Axis::X)),
        derivative("dFdy", Derivative(Axis::Y)),
        derivative("fwidth", With(math::fwidth)),
        // 8.9 Noise
        any("noise1", F1, &[F], V110, With(noise::noise1)),
        any("noise2", F2, &[F], V110, With(noise::noise2)),
        any("noise3", F3, &[F], V110, With(noise::noise3)),
        any("noise4", F4, &[F], V110, With(noise::noise4)),
    ]
}
