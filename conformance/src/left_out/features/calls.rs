//! Calls that change nothing, between small draws.

use crate::left_out::feature::Feature;
use crate::left_out::scene::*;

macro_rules! calls {
    ($($name:literal $what:literal $frame:ident;)*) => {
        &[$(Feature::calls($name, $what, gouraud, draw_small, $frame)),*]
    };
}

pub(super) const LIST: &[Feature] = calls! {
    "enables" "flags that are switched on and off again" draw_small_with_enables;
    "same-state" "state that is set to what it is" draw_small_with_same_state;
    "bindings" "bindings that are there already" draw_small_with_bindings;
    "matrices" "identities that are loaded again" draw_small_with_matrices;
    "stacks" "stacks that are pushed and popped" draw_small_with_stacks;
    "queries" "questions about state and errors" draw_small_with_queries;
    "viewports" "viewport, scissor and depth range, set to what they are" draw_small_with_viewports;
};
