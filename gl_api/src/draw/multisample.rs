//! The multisample state of a draw, as the driver has it.

use crate::base::types::*;
use crate::context::Context;
use crate::draw::complete::samples;
use crate::state::enable::Flag;
use crate::state::multisample::Multisample;
use rasterizer::driver::{
    AlphaToCoverage, AlphaToOne, MultisampleState, SampleCoverage, SampleRule,
};

/// What a draw does with the samples of the draw framebuffer, whose coverage follows `rule`: the
/// default where it has one a pixel or `GL_MULTISAMPLE` is off.
pub(crate) fn multisample_state(context: &Context, rule: SampleRule) -> MultisampleState {
    let state = &context.state;
    let has = |flag| state.enables.has(flag);
    if !has(Flag::Multisample) || samples(context, state.bindings.draw_framebuffer) == 0 {
        return MultisampleState::default();
    }
    let Multisample { value, invert, mask } = state.raster.multisample;
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
        mask: if has(Flag::SampleMask) { mask } else { GLbitfield::MAX },
    }
}
