//! A function for each entry point.

#![allow(missing_docs, reason = "they are GL's, and stand in the table of `gl_api`")]

use super::library::{self, CachedAddress};
use super::value::{Answer, Passed};
use gl_api::Arg;
use gl_api::*;

/// The functions of an entry point under each of its names.
macro_rules! function {
    ($method:ident [$($gl:ident)+] $params:tt $ret:tt) => {
        $(function!(@one $gl $params $ret);)+
    };
    (@one $gl:ident ($($param:ident: $ty:ty),*) [$($ret:ty)?]) => {
        #[allow(
            non_snake_case,
            clippy::extra_unused_lifetimes,
            clippy::too_many_arguments,
            reason = "GL's name and signature; 'a is there for the rows that borrow"
        )]
        pub fn $gl<'a>($($param: impl Arg<$ty>),*) $(-> $ret)? {
            let Some(library) = library::chosen() else {
                return gl_api::$gl($($param),*);
            };
            static ADDRESS: CachedAddress = CachedAddress::new();
            let Some(address) = library.cached_address(&ADDRESS, stringify!($gl)) else {
                return Answer::none();
            };
            $(let mut $param = <$ty as Passed<'a>>::hold($param.arg(), stringify!($param));)*
            type Raw<'a> = unsafe extern "C" fn(
                $(<$ty as Passed<'a>>::Raw),*
            ) -> function!(@raw [$($ret)?]);
            // SAFETY: the library gave the address of the function of this name, whose prototype the registry has.
            let function = unsafe { std::mem::transmute::<*const (), Raw<'a>>(address) };
            // SAFETY: as above; what arguments point to lives until `finish`.
            let answer = unsafe { function($(<$ty as Passed<'a>>::raw(&mut $param)),*) };
            $(<$ty as Passed<'a>>::finish($param);)*
            Answer::of(answer)
        }
    };
    (@raw []) => { () };
    (@raw [$ret:ty]) => { <$ret as Answer>::Raw };
}

entry_points!(each_function function);
