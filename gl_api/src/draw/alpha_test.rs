//! The alpha test of a draw.

use crate::context::Context;
use crate::draw::completeness::draws_integers;
use crate::draw::no_effect::passes_all;
use crate::state::enable::Flag;
use texunit::sampler::Compare;

/// The alpha test, unless it lets everything through; colours of integers are not tested
/// (`EXT_texture_integer`, section 4.1.4).
pub(crate) fn alpha_test(context: &Context) -> Option<Compare> {
    let compare = context.state.fragment.alpha_func;
    let tests = context.state.enables.has(Flag::AlphaTest) && !passes_all(context, compare);
    (tests && !draws_integers(context)).then_some(compare)
}
