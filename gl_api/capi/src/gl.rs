//! The C functions of GL's entry points, one for each name in the table of [`gl_api`].

use gl_api::*;

/// The C function of an entry point under each of its names: `c_function!(method [glName …] (parameters) -> result)`.
macro_rules! c_function {
    ($method:ident [$($gl:ident)+] $params:tt $ret:tt) => {
        c_function!(@named $method [$($gl)+] [$($gl)+] $params $ret);
    };
    (@named $method:ident [$first:ident $($alias:ident)*] [$($gl:ident)+] $params:tt $ret:tt) => {
        $(c_function!(@one $method $first $gl $params $ret);)+
    };
    (@one $method:ident $first:ident $gl:ident ($($param:ident: $ty:ty),*) [$($ret:ty)?]) => {
        #[cfg_attr(feature = "c-names", unsafe(no_mangle))]
        #[allow(
            non_snake_case,
            clippy::extra_unused_lifetimes,
            clippy::too_many_arguments,
            reason = "GL's name and signature; 'a is there for the rows that borrow"
        )]
        unsafe extern "C" fn $gl<'a>(
            $($param: <$ty as $crate::param::Param<'a>>::Raw),*
        ) $(-> <$ret as $crate::param::Return>::Raw)? {
            #[allow(clippy::extra_unused_lifetimes, reason = "for the rows that borrow")]
            fn run<'a>(
                $($param: &'a mut <$ty as $crate::param::Param<'a>>::Held),*
            ) $(-> $ret)? {
                host::call(stringify!($gl), |context| {
                    context.$method($(<$ty as $crate::param::Param<'a>>::lend($param)),*)
                })
            }
            let result = $crate::guard::guard_method(stringify!($gl), || {
                let rules = const {
                    $crate::lengths::rules(
                        stringify!($first),
                        stringify!($gl),
                        [$(<$ty as $crate::param::Param<'a>>::COUNTED),*],
                    )
                };
                let _arguments: &[isize] =
                    &[$(<$ty as $crate::param::Param<'a>>::number($param)),*];
                // Only of what is written it matters where other arguments lie.
                let extents;
                let writes_one_of_several = const {
                    $crate::param::writes_one_of_several(&[$((
                        <$ty as $crate::param::Param<'a>>::ELEMENT,
                        <$ty as $crate::param::Param<'a>>::WRITTEN,
                    )),*])
                };
                let extents: &[usize] = if writes_one_of_several {
                    let sizes = const { &[$(<$ty as $crate::param::Param<'a>>::ELEMENT),*] };
                    extents = $crate::lengths::extents(&rules, sizes, _arguments);
                    &extents
                } else {
                    &[]
                };
                let _call = $crate::param::Arguments { numbers: _arguments, extents };
                let mut _rules = rules.iter();
                $(
                    let rule = _rules.next();
                    let length = match <$ty as $crate::param::Param<'a>>::COUNTED {
                        $crate::param::Counted::No => 0,
                        $crate::param::Counted::Elements | $crate::param::Counted::Text => {
                            rule.map_or(0, |rule| rule.length(_arguments))
                        }
                    };
                    // SAFETY: the caller vouches for its pointers, as C's prototypes cannot.
                    let mut $param = unsafe {
                        <$ty as $crate::param::Param<'a>>::hold($param, length, &_call)
                    };
                )*
                run($(&mut $param),*)
            });
            $crate::param::Return::to_c(result)
        }
    };
}

entry_points!(each_function c_function);

/// The name and address of each function.
pub(crate) fn functions() -> Vec<(&'static str, *const ())> {
    let mut all = Vec::new();
    macro_rules! add {
        ($method:ident [$($gl:ident)+] $params:tt $ret:tt) => {
            all.extend([$((stringify!($gl), $gl as *const ())),+]);
        };
    }
    entry_points!(each_function add);
    all
}

#[cfg(all(test, target_os = "linux"))]
mod storm;
