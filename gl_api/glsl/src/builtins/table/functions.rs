//! The functions but for texture lookups (GLSL 1.40 sections 8.1 to 8.6, 8.8 and 8.9): result,
//! parameters, availability, lowering. Rows of one name are its overloads.

use crate::builtins::expand::{angle, common, derivative, geometric, matrix, noise, relational};
use crate::builtins::function::Lowering::{
    Derivative, Expand, ExpandAtRunTime, Ftransform, Modf, PerComponent,
};
use crate::builtins::function::{FunctionRow, Lowering, Pattern};
use crate::language::{Availability, Extension, Stages};
use crate::types::Scalar;
use rasterizer::ir::{Axis, Op};
use std::borrow::Cow;

const ALL: Availability = Availability::ALL;
const V110: Availability = Availability::V110;
const V120: Availability = Availability::V120;
const V130: Availability = Availability::V130;
const V140: Availability = Availability::V140;
/// Not in the core profile.
const COMPATIBILITY: Availability = V110.in_compatibility();
/// What came with integers.
const INTEGER: Availability = V130.or(Extension::GpuShader4);
const GPU_SHADER4: Availability = Availability::extension(Extension::GpuShader4);
/// The bits of numbers.
const BITS: Availability = Availability::extension(Extension::ShaderBitEncoding);
const DERIVATIVES: Availability = V110.or(Extension::StandardDerivatives);

const F: Pattern = Pattern::Gen(Scalar::Float);
const I: Pattern = Pattern::Gen(Scalar::Int);
const U: Pattern = Pattern::Gen(Scalar::Uint);
const B: Pattern = Pattern::Gen(Scalar::Bool);
const F1: Pattern = Pattern::Fixed(Scalar::Float, 1);
const F2: Pattern = Pattern::Fixed(Scalar::Float, 2);
const F3: Pattern = Pattern::Fixed(Scalar::Float, 3);
const F4: Pattern = Pattern::Fixed(Scalar::Float, 4);
const I1: Pattern = Pattern::Fixed(Scalar::Int, 1);
const U1: Pattern = Pattern::Fixed(Scalar::Uint, 1);
const B1: Pattern = Pattern::Fixed(Scalar::Bool, 1);
const VF: Pattern = Pattern::Vec(Scalar::Float);
const VI: Pattern = Pattern::Vec(Scalar::Int);
const VU: Pattern = Pattern::Vec(Scalar::Uint);
const VB: Pattern = Pattern::Vec(Scalar::Bool);
const MAT: Pattern = Pattern::Mat;
const MAT_T: Pattern = Pattern::MatTransposed;
const SQUARE: Pattern = Pattern::MatSquare;
const COLUMN: Pattern = Pattern::MatColumn;
const OUT: Pattern = Pattern::OutGen;

/// A function of both stages.
const fn row(
    name: &'static str,
    result: Pattern,
    parameters: &'static [Pattern],
    availability: Availability,
    lowering: Lowering,
) -> FunctionRow {
    of_stages(Stages::Any, name, result, parameters, availability, lowering)
}

/// A function of these stages.
const fn of_stages(
    stages: Stages,
    name: &'static str,
    result: Pattern,
    parameters: &'static [Pattern],
    availability: Availability,
    lowering: Lowering,
) -> FunctionRow {
    let (name, parameters) = (Cow::Borrowed(name), Cow::Borrowed(parameters));
    FunctionRow { name, result, parameters, availability, stages, lowering }
}

/// Every function but the texture lookups.
pub static FUNCTIONS: [FunctionRow; 110] = [
    // 8.1 Angle and trigonometry
    row("radians", F, &[F], ALL, Expand(angle::radians)),
    row("degrees", F, &[F], ALL, Expand(angle::degrees)),
    row("sin", F, &[F], ALL, PerComponent(Op::Sin)),
    row("cos", F, &[F], ALL, PerComponent(Op::Cos)),
    row("tan", F, &[F], ALL, PerComponent(Op::Tan)),
    row("asin", F, &[F], ALL, PerComponent(Op::Asin)),
    row("acos", F, &[F], ALL, PerComponent(Op::Acos)),
    row("atan", F, &[F, F], ALL, PerComponent(Op::Atan2)),
    row("atan", F, &[F], ALL, PerComponent(Op::Atan)),
    row("sinh", F, &[F], V130, PerComponent(Op::Sinh)),
    row("cosh", F, &[F], V130, PerComponent(Op::Cosh)),
    row("tanh", F, &[F], V130, PerComponent(Op::Tanh)),
    row("asinh", F, &[F], V130, PerComponent(Op::Asinh)),
    row("acosh", F, &[F], V130, PerComponent(Op::Acosh)),
    row("atanh", F, &[F], V130, PerComponent(Op::Atanh)),
    // 8.2 Exponential
    row("pow", F, &[F, F], ALL, PerComponent(Op::Pow)),
    row("exp", F, &[F], ALL, PerComponent(Op::Exp)),
    row("log", F, &[F], ALL, PerComponent(Op::Log)),
    row("exp2", F, &[F], ALL, PerComponent(Op::Exp2)),
    row("log2", F, &[F], ALL, PerComponent(Op::Log2)),
    row("sqrt", F, &[F], ALL, PerComponent(Op::Sqrt)),
    row("inversesqrt", F, &[F], ALL, PerComponent(Op::InverseSqrt)),
    // 8.3 Common
    row("abs", F, &[F], ALL, PerComponent(Op::Abs)),
    row("abs", I, &[I], INTEGER, PerComponent(Op::IAbs)),
    row("sign", F, &[F], ALL, PerComponent(Op::Sign)),
    row("sign", I, &[I], INTEGER, PerComponent(Op::ISign)),
    row("floor", F, &[F], ALL, PerComponent(Op::Floor)),
    row("trunc", F, &[F], V130, PerComponent(Op::Trunc)),
    row("truncate", F, &[F], GPU_SHADER4, PerComponent(Op::Trunc)),
    row("round", F, &[F], INTEGER, PerComponent(Op::RoundEven)),
    row("roundEven", F, &[F], V130, PerComponent(Op::RoundEven)),
    row("ceil", F, &[F], ALL, PerComponent(Op::Ceil)),
    row("fract", F, &[F], ALL, PerComponent(Op::Fract)),
    row("mod", F, &[F, F1], ALL, Expand(common::modulo)),
    row("mod", F, &[F, F], ALL, Expand(common::modulo)),
    row("modf", F, &[F, OUT], V130, Modf),
    row("min", F, &[F, F], ALL, Expand(common::min)),
    row("min", F, &[F, F1], ALL, Expand(common::min)),
    row("min", I, &[I, I], INTEGER, PerComponent(Op::IMin)),
    row("min", I, &[I, I1], INTEGER, PerComponent(Op::IMin)),
    row("min", U, &[U, U], INTEGER, PerComponent(Op::UMin)),
    row("min", U, &[U, U1], INTEGER, PerComponent(Op::UMin)),
    row("max", F, &[F, F], ALL, Expand(common::max)),
    row("max", F, &[F, F1], ALL, Expand(common::max)),
    row("max", I, &[I, I], INTEGER, PerComponent(Op::IMax)),
    row("max", I, &[I, I1], INTEGER, PerComponent(Op::IMax)),
    row("max", U, &[U, U], INTEGER, PerComponent(Op::UMax)),
    row("max", U, &[U, U1], INTEGER, PerComponent(Op::UMax)),
    row("clamp", F, &[F, F, F], ALL, Expand(common::clamp)),
    row("clamp", F, &[F, F1, F1], ALL, Expand(common::clamp)),
    row("clamp", I, &[I, I, I], INTEGER, Expand(common::clamp_int)),
    row("clamp", I, &[I, I1, I1], INTEGER, Expand(common::clamp_int)),
    row("clamp", U, &[U, U, U], INTEGER, Expand(common::clamp_uint)),
    row("clamp", U, &[U, U1, U1], INTEGER, Expand(common::clamp_uint)),
    row("mix", F, &[F, F, F], ALL, Expand(common::mix)),
    row("mix", F, &[F, F, F1], ALL, Expand(common::mix)),
    row("mix", F, &[F, F, B], V130, Expand(common::mix_select)),
    row("step", F, &[F, F], ALL, Expand(common::step)),
    row("step", F, &[F1, F], ALL, Expand(common::step)),
    row("smoothstep", F, &[F, F, F], ALL, Expand(common::smoothstep)),
    row("smoothstep", F, &[F1, F1, F], ALL, Expand(common::smoothstep)),
    row("isnan", B, &[F], V130, Expand(common::isnan)),
    row("isinf", B, &[F], V130, Expand(common::isinf)),
    row("floatBitsToInt", I, &[F], BITS, Expand(common::float_bits_to_int)),
    row("floatBitsToUint", U, &[F], BITS, Expand(common::float_bits_to_uint)),
    row("intBitsToFloat", F, &[I], BITS, Expand(common::int_bits_to_float)),
    row("uintBitsToFloat", F, &[U], BITS, PerComponent(Op::BitsFloat)),
    // 8.4 Geometric
    row("length", F1, &[F], ALL, Expand(geometric::length)),
    row("distance", F1, &[F, F], ALL, Expand(geometric::distance)),
    row("dot", F1, &[F, F], ALL, Expand(geometric::dot)),
    row("cross", F3, &[F3, F3], ALL, Expand(geometric::cross)),
    row("normalize", F, &[F], ALL, Expand(geometric::normalize)),
    of_stages(Stages::Vertex, "ftransform", F4, &[], COMPATIBILITY, Ftransform),
    row("faceforward", F, &[F, F, F], ALL, Expand(geometric::faceforward)),
    row("reflect", F, &[F, F], ALL, Expand(geometric::reflect)),
    row("refract", F, &[F, F, F1], ALL, Expand(geometric::refract)),
    // 8.5 Matrix
    row("matrixCompMult", MAT, &[MAT, MAT], ALL, PerComponent(Op::Mul)),
    row("outerProduct", MAT, &[COLUMN, VF], V120, Expand(matrix::outer_product)),
    row("transpose", MAT_T, &[MAT], V120, Expand(matrix::transpose)),
    row("inverse", SQUARE, &[SQUARE], V140, Expand(matrix::inverse)),
    // 8.6 Vector relational
    row("lessThan", VB, &[VF, VF], ALL, PerComponent(Op::Less)),
    row("lessThan", VB, &[VI, VI], ALL, PerComponent(Op::ILess)),
    row("lessThan", VB, &[VU, VU], INTEGER, PerComponent(Op::ULess)),
    row("lessThanEqual", VB, &[VF, VF], ALL, PerComponent(Op::LessEqual)),
    row("lessThanEqual", VB, &[VI, VI], ALL, PerComponent(Op::ILessEqual)),
    row("lessThanEqual", VB, &[VU, VU], INTEGER, PerComponent(Op::ULessEqual)),
    row("greaterThan", VB, &[VF, VF], ALL, Expand(relational::greater)),
    row("greaterThan", VB, &[VI, VI], ALL, Expand(relational::greater_int)),
    row("greaterThan", VB, &[VU, VU], INTEGER, Expand(relational::greater_uint)),
    row("greaterThanEqual", VB, &[VF, VF], ALL, Expand(relational::greater_equal)),
    row("greaterThanEqual", VB, &[VI, VI], ALL, Expand(relational::greater_equal_int)),
    row("greaterThanEqual", VB, &[VU, VU], INTEGER, Expand(relational::greater_equal_uint)),
    row("equal", VB, &[VF, VF], ALL, Expand(relational::equal)),
    row("equal", VB, &[VI, VI], ALL, Expand(relational::equal)),
    row("equal", VB, &[VU, VU], INTEGER, Expand(relational::equal)),
    row("equal", VB, &[VB, VB], ALL, Expand(relational::equal)),
    row("notEqual", VB, &[VF, VF], ALL, Expand(relational::not_equal)),
    row("notEqual", VB, &[VI, VI], ALL, Expand(relational::not_equal)),
    row("notEqual", VB, &[VU, VU], INTEGER, Expand(relational::not_equal)),
    row("notEqual", VB, &[VB, VB], ALL, Expand(relational::not_equal)),
    row("any", B1, &[VB], ALL, Expand(relational::any)),
    row("all", B1, &[VB], ALL, Expand(relational::all)),
    row("not", VB, &[VB], ALL, PerComponent(Op::Not)),
    // 8.8 Fragment processing
    of_stages(Stages::Fragment, "dFdx", F, &[F], DERIVATIVES, Derivative(Axis::X)),
    of_stages(Stages::Fragment, "dFdy", F, &[F], DERIVATIVES, Derivative(Axis::Y)),
    of_stages(Stages::Fragment, "fwidth", F, &[F], DERIVATIVES, Expand(derivative::fwidth)),
    // 8.9 Noise
    row("noise1", F1, &[F], V110, ExpandAtRunTime(noise::noise1)),
    row("noise2", F2, &[F], V110, ExpandAtRunTime(noise::noise2)),
    row("noise3", F3, &[F], V110, ExpandAtRunTime(noise::noise3)),
    row("noise4", F4, &[F], V110, ExpandAtRunTime(noise::noise4)),
];
