//! The table of entry points: one row each, by the chapters of the specification.
//!
//! A row names the method and GL's name (and its aliases), the parameters with C's types, and the type of the result.
//! Rows are grouped: a group says whether its calls are allowed between `glBegin` and `glEnd`
//! ([`BeginEnd`](super::BeginEnd)), and in which module the function is that carries a call out; it has the method's
//! name. Instead of `Refused`, a group may say more: its calls are refused there, and each is a `Setter`, which changes
//! nothing that draws depend on but plain state, or a `Query`, which changes and draws nothing. Then pending vertices
//! need not be drawn before the call. `not_compiled` after a row says that the call is carried out at once while a display list is compiled, or
//! records itself (GL 2.1, section 5.4); calls with a result always are, and say nothing.
//!
//! Each chapter is a macro that applies another to its rows. [`implement!`](super::implement) makes the methods and
//! free functions here; the crate of the C ABI makes its exports of the same rows. What the Khronos registry says of
//! a command (the APIs and extensions it belongs to, the length behind a pointer) is looked up by name when the crates
//! are built.

mod assembly;
mod attributes;
mod debugging;
mod fragments;
mod framebuffers;
mod generics;
mod integers;
mod lighting;
mod lists;
mod named_objects;
mod named_textures;
mod packed;
mod pixels;
mod programs;
mod queries;
mod rasterization;
mod rectangles;
mod robustness;
mod separate_programs;
mod special;
mod textures;
mod transform;
mod transform_feedback;
mod uniform_buffers;
mod vertices;
mod viewport_arrays;

pub use assembly::*;
pub use attributes::*;
pub use debugging::*;
pub use fragments::*;
pub use framebuffers::*;
pub use generics::*;
pub use integers::*;
pub use lighting::*;
pub use lists::*;
pub use named_objects::*;
pub use named_textures::*;
pub use packed::*;
pub use pixels::*;
pub use programs::*;
pub use queries::*;
pub use rasterization::*;
pub use rectangles::*;
pub use robustness::*;
pub use separate_programs::*;
pub use special::*;
pub use textures::*;
pub use transform::*;
pub use transform_feedback::*;
pub use uniform_buffers::*;
pub use vertices::*;
pub use viewport_arrays::*;

use super::description::EntryPoint;
#[cfg(any(test, feature = "exercise"))]
use super::exercise::Exercise;

/// Applies a macro to the rows of every chapter, with arguments of the caller's in brackets before them.
#[doc(hidden)]
#[macro_export]
macro_rules! entry_points {
    ($apply:ident $($arguments:tt)*) => {
        $crate::entry_points_assembly!($apply $($arguments)*);
        $crate::entry_points_attributes!($apply $($arguments)*);
        $crate::entry_points_debugging!($apply $($arguments)*);
        $crate::entry_points_fragments!($apply $($arguments)*);
        $crate::entry_points_framebuffers!($apply $($arguments)*);
        $crate::entry_points_generics!($apply $($arguments)*);
        $crate::entry_points_integers!($apply $($arguments)*);
        $crate::entry_points_lighting!($apply $($arguments)*);
        $crate::entry_points_lists!($apply $($arguments)*);
        $crate::entry_points_named_objects!($apply $($arguments)*);
        $crate::entry_points_named_textures!($apply $($arguments)*);
        $crate::entry_points_packed!($apply $($arguments)*);
        $crate::entry_points_pixels!($apply $($arguments)*);
        $crate::entry_points_programs!($apply $($arguments)*);
        $crate::entry_points_queries!($apply $($arguments)*);
        $crate::entry_points_rasterization!($apply $($arguments)*);
        $crate::entry_points_rectangles!($apply $($arguments)*);
        $crate::entry_points_robustness!($apply $($arguments)*);
        $crate::entry_points_separate_programs!($apply $($arguments)*);
        $crate::entry_points_special!($apply $($arguments)*);
        $crate::entry_points_textures!($apply $($arguments)*);
        $crate::entry_points_transform!($apply $($arguments)*);
        $crate::entry_points_transform_feedback!($apply $($arguments)*);
        $crate::entry_points_uniform_buffers!($apply $($arguments)*);
        $crate::entry_points_vertices!($apply $($arguments)*);
        $crate::entry_points_viewport_arrays!($apply $($arguments)*);
    };
}

/// To be applied to the rows of every chapter: `entry_points!(each_function apply)` gives
/// `apply!(method [glName …] (parameters) [result])` for each function, of a row of attributes for both calls.
#[doc(hidden)]
#[macro_export]
macro_rules! each_function {
    ([$apply:ident] $($begin_end:ident in $module:ident { $(
        $(#[$doc:meta])+
        $method:ident: $gl:ident $(| $alias:ident)* ($($params:tt)*) $(-> $ret:ty)? $(, $list:ident)?;
    )* })*) => {
        $($($apply!($method [$gl $($alias)*] ($($params)*) [$($ret)?]);)*)*
    };
    ([$apply:ident] $($doc:literal $lead:tt $slot:expr, $convert:ident { $(
        $method:ident: $gl:ident $(| $alias:ident)?,
        $vector:ident: $gl_vector:ident $(| $vector_alias:ident)?,
        $ty:ident $params:tt;
    )* })*) => {
        $($($crate::each_function!(@attribute $apply $lead $ty $params
            $method [$gl $($alias)?] $vector [$gl_vector $($vector_alias)?]);)*)*
    };
    (@attribute $apply:ident [$($lead:ident: $lead_ty:ty)?] $ty:ident ($($param:ident),+)
        $method:ident $names:tt $vector:ident $vector_names:tt) => {
        $apply!($method $names ($($lead: $lead_ty,)? $($param: $ty),+) []);
        $apply!($vector $vector_names ($($lead: $lead_ty,)? v: &'a [$ty]) []);
    };
}

/// The rows of every chapter.
#[allow(
    unused_qualifications,
    reason = "the chapters' free functions are imported by globs, and `ROWS` with them"
)]
pub(super) const CHAPTERS: &[&[EntryPoint]] = &[
    assembly::ROWS,
    attributes::ROWS,
    debugging::ROWS,
    fragments::ROWS,
    framebuffers::ROWS,
    generics::ROWS,
    integers::ROWS,
    lighting::ROWS,
    lists::ROWS,
    named_objects::ROWS,
    named_textures::ROWS,
    packed::ROWS,
    pixels::ROWS,
    programs::ROWS,
    queries::ROWS,
    rasterization::ROWS,
    rectangles::ROWS,
    robustness::ROWS,
    separate_programs::ROWS,
    special::ROWS,
    textures::ROWS,
    transform::ROWS,
    transform_feedback::ROWS,
    uniform_buffers::ROWS,
    vertices::ROWS,
    viewport_arrays::ROWS,
];

/// The calls of every chapter with random arguments.
#[cfg(any(test, feature = "exercise"))]
pub(super) fn exercises() -> Vec<Exercise> {
    let chapters: [fn() -> Vec<Exercise>; CHAPTERS.len()] = [
        assembly::exercises,
        attributes::exercises,
        debugging::exercises,
        fragments::exercises,
        framebuffers::exercises,
        generics::exercises,
        integers::exercises,
        lighting::exercises,
        lists::exercises,
        named_objects::exercises,
        named_textures::exercises,
        packed::exercises,
        pixels::exercises,
        programs::exercises,
        queries::exercises,
        rasterization::exercises,
        rectangles::exercises,
        robustness::exercises,
        separate_programs::exercises,
        special::exercises,
        textures::exercises,
        transform::exercises,
        transform_feedback::exercises,
        uniform_buffers::exercises,
        vertices::exercises,
        viewport_arrays::exercises,
    ];
    chapters.into_iter().flat_map(|chapter| chapter()).collect()
}
