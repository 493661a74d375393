//! The entry points: one table row each.
//!
//! A row gives GL's name (and its aliases), the parameters with C's types, and the function that
//! does the work; `entry_points!` makes of it a method on [`Context`] and free functions with GL's
//! own names over the thread's current context. What a parameter accepts is in [`Arg`].
//!
//! The tables follow the chapters of the specification.

/// The table of a chapter; see the module's documentation.
macro_rules! entry_points {
    ($table:ident; $($place:ident in $module:ident {
        $(
            $(#[$doc:meta])+
            $method:ident: $gl:ident $(| $alias:ident)* ($($params:tt)*) $(-> $ret:ty)?;
        )*
    })*) => {
        $($(entry_points!(@row $place $module $method [$(#[$doc])+]
            $gl [$($alias)*] ($($params)*) [$(-> $ret)?]);)*)*
        /// Name, number of parameters, and C function.
        pub(super) const $table: &[&[$crate::entry::Row]] = &[$($(
            entry_points!(@entries [$gl $($alias)*] ($($params)*)),
        )*)*];
        /// The calls with random arguments.
        #[cfg(any(test, feature = "exercise"))]
        pub(super) fn exercises() -> Vec<$crate::entry::exercise::Exercise> {
            vec![$($(entry_points!(@exercise $place $method $gl ($($params)*))),*),*]
        }
    };
    (@exercise $place:ident $method:ident $gl:ident ($($param:ident: $ty:ty),*)) => {{
        #[allow(clippy::extra_unused_lifetimes, reason = "for the rows that borrow")]
        fn exercise<'a>(
            context: &mut $crate::context::Context,
            random: &mut $crate::entry::exercise::Random<'_>,
        ) {
            // Calls without arguments draw no numbers.
            let _ = &random;
            #[allow(
                clippy::extra_unused_lifetimes,
                clippy::too_many_arguments,
                reason = "GL's signature; 'a is there for the rows that borrow"
            )]
            fn run<'a>(
                context: &mut $crate::context::Context,
                $($param: &'a mut <$ty as $crate::entry::exercise::Exercised<'a>>::Held),*
            ) {
                let _ = context.$method(
                    $(<$ty as $crate::entry::exercise::Exercised<'a>>::lend($param)),*
                );
            }
            $(
                let mut $param = <$ty as $crate::entry::exercise::Exercised<'a>>::held(
                    random,
                    stringify!($param),
                    stringify!($ty),
                );
            )*
            run(context, $(&mut $param),*);
        }
        $crate::entry::exercise::Exercise {
            name: stringify!($gl),
            #[cfg(test)]
            place: $crate::entry::Place::$place,
            run: exercise,
        }
    }};
    (@row $place:ident $module:ident $method:ident $doc:tt $gl:ident [$($alias:ident)*]
        $params:tt $ret:tt) => {
        entry_points!(@method $place $module $method $gl $doc $params $ret);
        entry_points!(@free $method $gl $doc $params $ret);
        $(entry_points!(@free $method $alias $doc $params $ret);)*
        entry_points!(@export $method $gl $params $ret);
        $(entry_points!(@export $method $alias $params $ret);)*
    };
    (@method $place:ident $module:ident $method:ident $gl:ident [$($doc:tt)+]
        ($($param:ident: $ty:ty),*) [$(-> $ret:ty)?]) => {
        impl $crate::context::Context {
            $($doc)+
            #[allow(
                clippy::extra_unused_lifetimes,
                clippy::needless_lifetimes,
                clippy::too_many_arguments,
                reason = "GL's signature; 'a is there for the rows that borrow"
            )]
            pub fn $method<'a>(&mut self $(, $param: $ty)*) $(-> $ret)? {
                entry_points!(@record self $place $module $method $gl [$($param)*] [$($ret)?]);
                self.call(stringify!($gl), $crate::entry::Place::$place, |context| {
                    $module::$method(context $(, $param)*)
                })
            }
        }
    };
    // A call that answers nothing may be part of a display list.
    (@record $context:ident $place:ident $module:ident $method:ident $gl:ident
        [$($param:ident)*] []) => {
        if $context.compiling.is_some() {
            let integers: &[i64] = &[$($crate::list::Keep::integer(&$param)),*];
            let name = stringify!($gl);
            if !$context.records(name, integers) {
                // Carried out below.
            } else if let (Some(()), $(Some($param),)*) =
                (Some(()), $($crate::list::Keep::keep(&$param, $context, name, integers),)*)
            {
                let run = move |context: &mut $crate::context::Context| {
                    $module::$method(context $(, $crate::list::Lend::lend(&$param))*)
                };
                return $context.record(name, $crate::entry::Place::$place, Box::new(run));
            }
        }
    };
    (@record $context:ident $place:ident $module:ident $method:ident $gl:ident
        [$($param:ident)*] [$ret:ty]) => {};
    (@free $method:ident $gl:ident [$($doc:tt)+]
        ($($param:ident: $ty:ty),*) [$(-> $ret:ty)?]) => {
        $($doc)+
        #[allow(
            non_snake_case,
            clippy::extra_unused_lifetimes,
            clippy::too_many_arguments,
            reason = "GL's name and signature; 'a is there for the rows that borrow"
        )]
        pub fn $gl<'a>($($param: impl $crate::entry::Arg<$ty>),*) $(-> $ret)? {
            $crate::entry::current::call(stringify!($gl), |context| {
                context.$method($($param.arg()),*)
            })
        }
    };
    (@export $method:ident $gl:ident $params:tt [$($ret:tt)*]) => {
        $crate::abi::c_export!($method $gl $params $($ret)*);
    };
    (@entries [$($gl:ident)+] ($($param:ident: $ty:ty),*)) => {{
        const PARAMETERS: &[&str] = &[$(stringify!($param)),*];
        &[$((stringify!($gl), PARAMETERS.len(), $crate::abi::Exports::$gl as *const ())),+]
    }};
}

mod args;
mod assembly;
mod current;
#[cfg(any(test, feature = "exercise"))]
pub mod exercise;

mod attributes;
mod debugging;
mod fragments;
mod framebuffers;
mod generics;
mod integers;
mod lighting;
mod lists;
mod packed;
mod pixels;
mod programs;
mod queries;
mod rasterization;
mod rectangles;
mod special;
mod textures;
mod transform;
mod transform_feedback;
mod uniform_buffers;
mod vertices;

pub use args::{
    Arg, BUFFER_OFFSET, Data, DataOut, NULL, Names, Null, Offset, Pointers, Strings, TextOut,
};
pub(crate) use args::{Located, LocatedOut};
pub use current::{Current, set_current, with_current};
pub(crate) use current::{Fallback, call, swap_current};

pub use assembly::*;
pub use attributes::*;
pub(crate) use attributes::{Component, filled};
pub use debugging::*;
pub use fragments::*;
pub use framebuffers::*;
pub use generics::*;
pub use integers::*;
pub use lighting::*;
pub use lists::*;
pub use packed::*;
pub use pixels::*;
pub use programs::*;
pub use queries::*;
pub use rasterization::*;
pub use rectangles::*;
pub use special::*;
pub use textures::*;
pub use transform::*;
pub use transform_feedback::*;
pub use uniform_buffers::*;
pub use vertices::*;

/// Whether a call may stand between `glBegin` and `glEnd` (GL 2.1, section 2.6.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// It may.
    Anywhere,
    /// It may not.
    Outside,
}

/// An entry point: its name, the number of its parameters, and its C function.
pub(crate) type Row = (&'static str, usize, *const ());

/// Every entry point by name, with the number of its parameters.
pub fn implemented() -> impl Iterator<Item = (&'static str, usize)> {
    rows().map(|(name, parameters, _)| (name, parameters))
}

/// Every entry point once, by the name that its messages have.
pub fn canonical() -> impl Iterator<Item = &'static str> {
    groups().filter_map(|names| names.first()).map(|(name, ..)| *name)
}

/// Every entry point.
pub(crate) fn rows() -> impl Iterator<Item = Row> {
    groups().flat_map(|names| names.iter().copied())
}

/// The names of each entry point.
fn groups() -> impl Iterator<Item = &'static [Row]> {
    [
        ASSEMBLY,
        ATTRIBUTES,
        DEBUGGING,
        FRAMEBUFFERS,
        FRAGMENTS,
        GENERICS,
        INTEGERS,
        LIGHTING,
        LISTS,
        PACKED,
        PIXELS,
        PROGRAMS,
        QUERIES,
        RASTERIZATION,
        RECTANGLES,
        SPECIAL,
        TEXTURES,
        TRANSFORM,
        TRANSFORM_FEEDBACK,
        UNIFORM_BUFFERS,
        VERTICES,
    ]
    .into_iter()
    .flatten()
    .copied()
}
