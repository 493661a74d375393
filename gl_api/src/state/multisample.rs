//! Several samples a pixel: GL 2.1, sections 3.2.1 and 4.1.3.

use crate::context::Context;
use crate::error::Result;
use crate::framebuffer::complete::samples;
use crate::state::enable::Flag;
use crate::types::*;
use rasterizer::driver::{
    AlphaToCoverage, AlphaToOne, MultisampleState, SampleCoverage, SampleRule,
};

/// What `glSampleCoverage` sets.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Multisample {
    /// The part of the samples that is kept, from 0 to 1.
    pub value: f32,
    /// Whether the others are kept instead.
    pub invert: bool,
}

impl Default for Multisample {
    fn default() -> Self {
        Self { value: 1.0, invert: false }
    }
}

pub(crate) fn sample_coverage(context: &mut Context, value: GLclampf, invert: bool) -> Result<()> {
    let value = texunit::lanes::math::clamp(value, 0.0, 1.0);
    context.state.raster.multisample = Multisample { value, invert };
    Ok(())
}

/// What a draw does with the samples of the draw framebuffer, whose coverage follows `rule`: the
/// default where it has one a pixel or `GL_MULTISAMPLE` is off.
pub(crate) fn multisample_state(context: &Context, rule: SampleRule) -> MultisampleState {
    let state = &context.state;
    let has = |flag| state.enables.has(flag);
    if !has(Flag::Multisample) || samples(context, state.bindings.draw_framebuffer) == 0 {
        return MultisampleState::default();
    }
    let Multisample { value, invert } = state.raster.multisample;
    let coverage = match invert {
        false => SampleCoverage::Part(value),
        true => SampleCoverage::AllBut(value),
    };
    MultisampleState {
        rule,
        alpha_to_coverage: match has(Flag::SampleAlphaToCoverage) {
            false => AlphaToCoverage::Off,
            true => AlphaToCoverage::On,
        },
        alpha_to_one: match has(Flag::SampleAlphaToOne) {
            false => AlphaToOne::Off,
            true => AlphaToOne::On,
        },
        coverage: has(Flag::SampleCoverage).then_some(coverage),
    }
}
