//! The functions but for texture lookups (GLSL 1.40 sections 8.1 to 8.6, 8.8 and 8.9): result,
//! parameters, availability, lowering. Rows of one name are its overloads.

use crate::builtins::expand::{
    angle, common, derivative, geometric, matrix, noise, pack, relational,
};
use crate::builtins::function::Lowering::{
    Derivative, EmitVertex, EndPrimitive, Expand, ExpandAtRunTime, Ftransform, Modf, PerComponent,
};
use crate::builtins::function::{FunctionRow, Lowering, Pattern};
use crate::language::{Availability, EsVersions, Extension, Stages};
use crate::types::Scalar;
use rasterizer::ir::{Axis, Op};
use std::borrow::Cow;

const DESKTOP_AND_ES: Availability = Availability::DESKTOP_AND_ES;
const DESKTOP: Availability = Availability::DESKTOP;
const V120: Availability = Availability::V120.and_es(EsVersions::From300);
const V130: Availability = Availability::V130.and_es(EsVersions::From300);
const V140: Availability = Availability::V140.and_es(EsVersions::From300);
const V150: Availability = Availability::V150.and_es(EsVersions::From300);
/// Not in the core profile.
const COMPATIBILITY: Availability = DESKTOP.in_compatibility();
const INTEGERS: Availability = Availability::INTEGERS;
const GPU_SHADER4: Availability = Availability::extension(Extension::GpuShader4);
/// The bits of numbers.
const BITS: Availability =
    Availability::V330.or(Extension::ShaderBitEncoding).and_es(EsVersions::From300);
/// Fractions and half floats as integers.
const PACKING: Availability = Availability::extension(Extension::ShadingLanguagePacking);
const PACKING_16: Availability = PACKING.and_es(EsVersions::From300);
const DERIVATIVES: Availability =
    DESKTOP.or(Extension::StandardDerivatives).and_es(EsVersions::From300);

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
pub static FUNCTIONS: &[FunctionRow] = &[
    // 8.1 Angle and trigonometry
    row("radians", F, &[F], DESKTOP_AND_ES, Expand(angle::radians)),
    row("degrees", F, &[F], DESKTOP_AND_ES, Expand(angle::degrees)),
    row("sin", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Sin)),
    row("cos", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Cos)),
    row("tan", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Tan)),
    row("asin", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Asin)),
    row("acos", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Acos)),
    row("atan", F, &[F, F], DESKTOP_AND_ES, PerComponent(Op::Atan2)),
    row("atan", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Atan)),
    row("sinh", F, &[F], V130, PerComponent(Op::Sinh)),
    row("cosh", F, &[F], V130, PerComponent(Op::Cosh)),
    row("tanh", F, &[F], V130, PerComponent(Op::Tanh)),
    row("asinh", F, &[F], V130, PerComponent(Op::Asinh)),
    row("acosh", F, &[F], V130, PerComponent(Op::Acosh)),
    row("atanh", F, &[F], V130, PerComponent(Op::Atanh)),
    // 8.2 Exponential
    row("pow", F, &[F, F], DESKTOP_AND_ES, PerComponent(Op::Pow)),
    row("exp", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Exp)),
    row("log", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Log)),
    row("exp2", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Exp2)),
    row("log2", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Log2)),
    row("sqrt", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Sqrt)),
    row("inversesqrt", F, &[F], DESKTOP_AND_ES, PerComponent(Op::InverseSqrt)),
    // 8.3 Common
    row("abs", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Abs)),
    row("abs", I, &[I], INTEGERS, PerComponent(Op::IAbs)),
    row("sign", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Sign)),
    row("sign", I, &[I], INTEGERS, PerComponent(Op::ISign)),
    row("floor", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Floor)),
    row("trunc", F, &[F], V130, PerComponent(Op::Trunc)),
    row("truncate", F, &[F], GPU_SHADER4, PerComponent(Op::Trunc)),
    row("round", F, &[F], INTEGERS, PerComponent(Op::RoundEven)),
    row("roundEven", F, &[F], V130, PerComponent(Op::RoundEven)),
    row("ceil", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Ceil)),
    row("fract", F, &[F], DESKTOP_AND_ES, PerComponent(Op::Fract)),
    row("mod", F, &[F, F1], DESKTOP_AND_ES, Expand(common::modulo)),
    row("mod", F, &[F, F], DESKTOP_AND_ES, Expand(common::modulo)),
    row("modf", F, &[F, OUT], V130, Modf),
    row("min", F, &[F, F], DESKTOP_AND_ES, Expand(common::min)),
    row("min", F, &[F, F1], DESKTOP_AND_ES, Expand(common::min)),
    row("min", I, &[I, I], INTEGERS, PerComponent(Op::IMin)),
    row("min", I, &[I, I1], INTEGERS, PerComponent(Op::IMin)),
    row("min", U, &[U, U], INTEGERS, PerComponent(Op::UMin)),
    row("min", U, &[U, U1], INTEGERS, PerComponent(Op::UMin)),
    row("max", F, &[F, F], DESKTOP_AND_ES, Expand(common::max)),
    row("max", F, &[F, F1], DESKTOP_AND_ES, Expand(common::max)),
    row("max", I, &[I, I], INTEGERS, PerComponent(Op::IMax)),
    row("max", I, &[I, I1], INTEGERS, PerComponent(Op::IMax)),
    row("max", U, &[U, U], INTEGERS, PerComponent(Op::UMax)),
    row("max", U, &[U, U1], INTEGERS, PerComponent(Op::UMax)),
    row("clamp", F, &[F, F, F], DESKTOP_AND_ES, Expand(common::clamp)),
    row("clamp", F, &[F, F1, F1], DESKTOP_AND_ES, Expand(common::clamp)),
    row("clamp", I, &[I, I, I], INTEGERS, Expand(common::clamp_int)),
    row("clamp", I, &[I, I1, I1], INTEGERS, Expand(common::clamp_int)),
    row("clamp", U, &[U, U, U], INTEGERS, Expand(common::clamp_uint)),
    row("clamp", U, &[U, U1, U1], INTEGERS, Expand(common::clamp_uint)),
    row("mix", F, &[F, F, F], DESKTOP_AND_ES, Expand(common::mix)),
    row("mix", F, &[F, F, F1], DESKTOP_AND_ES, Expand(common::mix)),
    row("mix", F, &[F, F, B], V130, Expand(common::mix_select)),
    row("step", F, &[F, F], DESKTOP_AND_ES, Expand(common::step)),
    row("step", F, &[F1, F], DESKTOP_AND_ES, Expand(common::step)),
    row("smoothstep", F, &[F, F, F], DESKTOP_AND_ES, Expand(common::smoothstep)),
    row("smoothstep", F, &[F1, F1, F], DESKTOP_AND_ES, Expand(common::smoothstep)),
    row("isnan", B, &[F], V130, Expand(common::isnan)),
    row("isinf", B, &[F], V130, Expand(common::isinf)),
    row("floatBitsToInt", I, &[F], BITS, Expand(common::float_bits_to_int)),
    row("floatBitsToUint", U, &[F], BITS, Expand(common::float_bits_to_uint)),
    row("intBitsToFloat", F, &[I], BITS, Expand(common::int_bits_to_float)),
    row("uintBitsToFloat", F, &[U], BITS, PerComponent(Op::BitsFloat)),
    row("packUnorm2x16", U1, &[F2], PACKING_16, Expand(pack::pack_unorm_2x16)),
    row("packSnorm2x16", U1, &[F2], PACKING_16, Expand(pack::pack_snorm_2x16)),
    row("packHalf2x16", U1, &[F2], PACKING_16, Expand(pack::pack_half_2x16)),
    row("packUnorm4x8", U1, &[F4], PACKING, Expand(pack::pack_unorm_4x8)),
    row("packSnorm4x8", U1, &[F4], PACKING, Expand(pack::pack_snorm_4x8)),
    row("unpackUnorm2x16", F2, &[U1], PACKING_16, Expand(pack::unpack_unorm_2x16)),
    row("unpackSnorm2x16", F2, &[U1], PACKING_16, Expand(pack::unpack_snorm_2x16)),
    row("unpackHalf2x16", F2, &[U1], PACKING_16, Expand(pack::unpack_half_2x16)),
    row("unpackUnorm4x8", F4, &[U1], PACKING, Expand(pack::unpack_unorm_4x8)),
    row("unpackSnorm4x8", F4, &[U1], PACKING, Expand(pack::unpack_snorm_4x8)),
    // 8.4 Geometric
    row("length", F1, &[F], DESKTOP_AND_ES, Expand(geometric::length)),
    row("distance", F1, &[F, F], DESKTOP_AND_ES, Expand(geometric::distance)),
    row("dot", F1, &[F, F], DESKTOP_AND_ES, Expand(geometric::dot)),
    row("cross", F3, &[F3, F3], DESKTOP_AND_ES, Expand(geometric::cross)),
    row("normalize", F, &[F], DESKTOP_AND_ES, Expand(geometric::normalize)),
    of_stages(Stages::Vertex, "ftransform", F4, &[], COMPATIBILITY, Ftransform),
    row("faceforward", F, &[F, F, F], DESKTOP_AND_ES, Expand(geometric::faceforward)),
    row("reflect", F, &[F, F], DESKTOP_AND_ES, Expand(geometric::reflect)),
    row("refract", F, &[F, F, F1], DESKTOP_AND_ES, Expand(geometric::refract)),
    // 8.5 Matrix
    row("matrixCompMult", MAT, &[MAT, MAT], DESKTOP_AND_ES, PerComponent(Op::Mul)),
    row("outerProduct", MAT, &[COLUMN, VF], V120, Expand(matrix::outer_product)),
    row("transpose", MAT_T, &[MAT], V120, Expand(matrix::transpose)),
    row("determinant", F1, &[SQUARE], V150, Expand(matrix::determinant)),
    row("inverse", SQUARE, &[SQUARE], V140, Expand(matrix::inverse)),
    // 8.6 Vector relational
    row("lessThan", VB, &[VF, VF], DESKTOP_AND_ES, PerComponent(Op::Less)),
    row("lessThan", VB, &[VI, VI], DESKTOP_AND_ES, PerComponent(Op::ILess)),
    row("lessThan", VB, &[VU, VU], INTEGERS, PerComponent(Op::ULess)),
    row("lessThanEqual", VB, &[VF, VF], DESKTOP_AND_ES, PerComponent(Op::LessEqual)),
    row("lessThanEqual", VB, &[VI, VI], DESKTOP_AND_ES, PerComponent(Op::ILessEqual)),
    row("lessThanEqual", VB, &[VU, VU], INTEGERS, PerComponent(Op::ULessEqual)),
    row("greaterThan", VB, &[VF, VF], DESKTOP_AND_ES, Expand(relational::greater)),
    row("greaterThan", VB, &[VI, VI], DESKTOP_AND_ES, Expand(relational::greater_int)),
    row("greaterThan", VB, &[VU, VU], INTEGERS, Expand(relational::greater_uint)),
    row("greaterThanEqual", VB, &[VF, VF], DESKTOP_AND_ES, Expand(relational::greater_equal)),
    row("greaterThanEqual", VB, &[VI, VI], DESKTOP_AND_ES, Expand(relational::greater_equal_int)),
    row("greaterThanEqual", VB, &[VU, VU], INTEGERS, Expand(relational::greater_equal_uint)),
    row("equal", VB, &[VF, VF], DESKTOP_AND_ES, Expand(relational::equal)),
    row("equal", VB, &[VI, VI], DESKTOP_AND_ES, Expand(relational::equal)),
    row("equal", VB, &[VU, VU], INTEGERS, Expand(relational::equal)),
    row("equal", VB, &[VB, VB], DESKTOP_AND_ES, Expand(relational::equal)),
    row("notEqual", VB, &[VF, VF], DESKTOP_AND_ES, Expand(relational::not_equal)),
    row("notEqual", VB, &[VI, VI], DESKTOP_AND_ES, Expand(relational::not_equal)),
    row("notEqual", VB, &[VU, VU], INTEGERS, Expand(relational::not_equal)),
    row("notEqual", VB, &[VB, VB], DESKTOP_AND_ES, Expand(relational::not_equal)),
    row("any", B1, &[VB], DESKTOP_AND_ES, Expand(relational::any)),
    row("all", B1, &[VB], DESKTOP_AND_ES, Expand(relational::all)),
    row("not", VB, &[VB], DESKTOP_AND_ES, PerComponent(Op::Not)),
    // 8.8 Fragment processing
    of_stages(Stages::Fragment, "dFdx", F, &[F], DERIVATIVES, Derivative(Axis::X)),
    of_stages(Stages::Fragment, "dFdy", F, &[F], DERIVATIVES, Derivative(Axis::Y)),
    of_stages(Stages::Fragment, "fwidth", F, &[F], DERIVATIVES, Expand(derivative::fwidth)),
    // 8.10 Geometry shader
    of_stages(Stages::Geometry, "EmitVertex", Pattern::Void, &[], DESKTOP, EmitVertex),
    of_stages(Stages::Geometry, "EndPrimitive", Pattern::Void, &[], DESKTOP, EndPrimitive),
    // 8.9 Noise
    row("noise1", F1, &[F], DESKTOP, ExpandAtRunTime(noise::noise1)),
    row("noise2", F2, &[F], DESKTOP, ExpandAtRunTime(noise::noise2)),
    row("noise3", F3, &[F], DESKTOP, ExpandAtRunTime(noise::noise3)),
    row("noise4", F4, &[F], DESKTOP, ExpandAtRunTime(noise::noise4)),
];
