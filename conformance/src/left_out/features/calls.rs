//! Calls that change nothing, between small draws.

use crate::left_out::feature::Feature;
use crate::left_out::scene::{gouraud, lit};
use crate::left_out::small_draws::*;

macro_rules! calls {
    ($($name:literal $what:literal $setup:ident $plain:ident $frame:ident;)*) => {
        &[$(Feature::calls($name, $what, $setup, $plain, $frame)),*]
    };
}

pub(super) const LIST: &[Feature] = calls! {
    "enables" "flags that are switched on and off again" gouraud draw_small draw_small_with_enables;
    "same-state" "state that is set to what it is" gouraud draw_small draw_small_with_same_state;
    "bindings" "bindings that are there already" gouraud draw_small draw_small_with_bindings;
    "matrices" "identities that are loaded again" gouraud draw_small draw_small_with_matrices;
    "texture-matrices" "texture matrices that are loaded again" gouraud draw_small draw_small_with_texture_matrices;
    "moves" "moves to and fro" gouraud draw_small draw_small_with_moves;
    "stacks" "stacks that are pushed and popped" gouraud draw_small draw_small_with_stacks;
    "push-all" "all attributes, pushed and popped" gouraud draw_small draw_small_with_all_attributes;
    "queries" "questions about state and errors" gouraud draw_small draw_small_with_queries;
    "viewports" "viewport, scissor and depth range, set to what they are" gouraud draw_small draw_small_with_viewports;
    "hints" "hints" gouraud draw_small draw_small_with_hints;
    "environments" "environments that are set again" gouraud draw_small draw_small_with_environments;
    "lights" "lights and materials that are set again" lit draw_small draw_small_with_lights;
    "arrays-matrices" "identities that are loaded again between draws of arrays" small_arrays draw_arrays draw_arrays_with_matrices;
    "arrays-pointers" "arrays that are set again between draws of arrays" small_arrays draw_arrays draw_arrays_with_pointers;
    "arrays-bindings" "bindings that are there already between draws of arrays" small_arrays draw_arrays draw_arrays_with_bindings;
    "arrays-enables" "flags that are set again between draws of arrays" small_arrays draw_arrays draw_arrays_with_enables;
};
