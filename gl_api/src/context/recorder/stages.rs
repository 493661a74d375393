//! The stages of a draw and what they read; `draw/stages.rs` chooses them.

use crate::base::clamp::Clamp;
use crate::base::error::{ErrorCode, GlError};
use crate::context::recorder::fixed_function::StageKeys;
use crate::context::watched_pixel::DrawNote;
use rasterizer::driver::{Antialiasing, ShaderModule};
use rasterizer::ir::{Interpolation, IrError};
use std::sync::Arc;
use texunit::plan::SamplePlan;
use texunit::sampler::Compare;

/// The texture of each slot of a stage.
pub(crate) type Textures = Arc<[Option<Arc<SamplePlan>>]>;

/// The stages of a draw, and what they read.
pub(crate) struct Stages {
    pub vertex: ShaderModule,
    pub geometry: Option<ShaderModule>,
    pub fragment: ShaderModule,
    pub reads: Reads,
}

/// What stages read besides vertices.
pub(crate) struct Reads {
    pub words: Vec<u32>,
    pub vertex_textures: Textures,
    pub geometry_textures: Textures,
    pub fragment_textures: Textures,
    /// What the words are made by, if they can be made again by it alone.
    pub keys: Option<StageKeys>,
    /// Names for the explanation of a watched pixel, if there is one.
    pub note: Option<DrawNote>,
}

/// The key of a program's fragment stage with GL state compiled in.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct VariantKey {
    pub module: ShaderModule,
    pub shade_model: Interpolation,
    /// The interpolation of colours that the shaders declare.
    pub color_interpolation: [Option<Interpolation>; 2],
    /// The alpha test and the word of its reference.
    pub alpha: Option<(Compare, u32)>,
    pub sides: Sides,
    pub antialiasing: Antialiasing,
    /// Whether its colours are clamped.
    pub clamp: Clamp,
}

/// The key of a program's vertex stage with user clip planes compiled in.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct VertexVariantKey {
    pub module: ShaderModule,
    /// The user clip planes that cut, bit by plane.
    pub planes: u8,
    /// The first word of the fixed function.
    pub base: u32,
}

/// Whether the back of a polygon has colours of its own (GL 2.1, section 2.15.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Sides {
    One,
    Two,
}

/// A generated module that the IR refuses: a bug, reported as an error of the call.
pub(crate) fn internal(error: &IrError) -> GlError {
    GlError::new(
        ErrorCode::InvalidOperation,
        "GL 2.1, section 2.15",
        format!("a generated shader breaks a rule of the IR, which is DetGL's mistake: {error}"),
    )
}
