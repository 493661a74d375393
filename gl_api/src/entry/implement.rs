//! What this crate makes of the rows of the table: a method of [`Context`](crate::Context) and free functions with
//! GL's own names for each, its description, and its call with random arguments.

/// Implements the rows of a chapter; [`table`](super::table) says what a row consists of.
macro_rules! implement {
    ([] $($begin_end:ident in $module:ident {
        $(
            $(#[$doc:meta])+
            $method:ident: $gl:ident $(| $alias:ident)* ($($params:tt)*) $(-> $ret:ty)? $(, $list:ident)?;
        )*
    })*) => {
        $($(
            implement!(@method $begin_end $module $method $gl [$($alias)*] [$(#[$doc])+]
                ($($params)*) [$(-> $ret)?] [$($list)?]);
            implement!(@free $method $gl [$(#[$doc])+] ($($params)*) [$(-> $ret)?]);
            implement!(@aliases $method [$($alias)*] [$(#[$doc])+] ($($params)*) [$(-> $ret)?]);
        )*)*
        /// The rows of this chapter.
        pub(super) const ROWS: &[$crate::entry::description::EntryPoint] = &[$($(
            implement!(@describe $begin_end [$gl $($alias)*] ($($params)*) [$($ret)?] [$($list)?]),
        )*)*];
        /// The calls with random arguments.
        #[cfg(any(test, feature = "exercise"))]
        pub(in $crate::entry) fn exercises() -> Vec<$crate::entry::exercise::Exercise> {
            vec![$($(implement!(@exercise $begin_end $method $gl ($($params)*))),*),*]
        }
    };
    // The rows of attributes.
    ([] $($doc:literal $lead:tt $slot:expr, $convert:ident { $(
        $method:ident: $gl:ident $(| $alias:ident)?,
        $vector:ident: $gl_vector:ident $(| $vector_alias:ident)?,
        $ty:ident $params:tt;
    )* })*) => {
        $($(
            implement_attribute!(@call $doc $lead $slot, $convert, $method $gl [$($alias)?] $ty $params);
            implement_attribute!(@vector $doc $lead $slot, $convert, $vector $gl_vector [$($vector_alias)?] $ty $params);
            implement_attribute!(@free $doc $lead $method $gl [$($alias)?] $ty $params);
            implement_attribute!(@free_vector $doc $lead $vector $gl_vector [$($vector_alias)?] $ty);
        )*)*
        /// The rows of this chapter.
        pub(super) const ROWS: &[$crate::entry::description::EntryPoint] = &[$($(
            implement_attribute!(@describe $lead [$gl $($alias)?] $ty $params),
            implement_attribute!(@describe_vector $lead [$gl_vector $($vector_alias)?] $ty),
        )*)*];
        /// The calls with random arguments.
        #[cfg(any(test, feature = "exercise"))]
        pub(in $crate::entry) fn exercises() -> Vec<$crate::entry::exercise::Exercise> {
            vec![$($(
                implement_attribute!(@exercise $lead $method $gl $ty $params),
                implement_attribute!(@exercise_vector $lead $vector $gl_vector $ty),
            )*)*]
        }
    };
    (@method $begin_end:ident $module:ident $method:ident $gl:ident $aliases:tt [$($doc:tt)+]
        ($($param:ident: $ty:ty),*) [$(-> $ret:ty)?] $list:tt) => {
        impl $crate::context::Context {
            $($doc)+
            #[allow(
                clippy::extra_unused_lifetimes,
                clippy::needless_lifetimes,
                clippy::too_many_arguments,
                reason = "GL's signature; 'a is there for the rows that borrow"
            )]
            pub fn $method<'a>(&mut self $(, $param: $ty)*) $(-> $ret)? {
                implement!(@core self $gl $aliases ($($param: $ty),*));
                implement!(@record self $begin_end $module $method $gl [$($param)*] [$($ret)?] $list);
                implement!(@call $begin_end self $gl |context| $module::$method(context $(, $param)*))
            }
        }
    };
    (@begin_end Allowed) => { $crate::base::begin_end::BeginEnd::Allowed };
    (@begin_end $refused:ident) => { $crate::base::begin_end::BeginEnd::Refused };
    (@call Setter $context:ident $gl:ident $f:expr) => { $context.call_setter(stringify!($gl), $f) };
    (@call Query $context:ident $gl:ident $f:expr) => { $context.call_query(stringify!($gl), $f) };
    (@call $begin_end:ident $context:ident $gl:ident $f:expr) => {
        $context.call(stringify!($gl), implement!(@begin_end $begin_end), $f)
    };
    // In contexts without all of OpenGL, what they lack is refused.
    (@core $context:ident $gl:ident [$($alias:ident)*] ($($param:ident: $ty:ty),*)) => {
        if !$context.profile.is_compatibility() {
            const NAMES: &[&str] = &[stringify!($gl) $(, stringify!($alias))*];
            const IN_CORE: $crate::base::core_profile::InCore = $crate::base::core_profile::InCore::of(NAMES);
            const IN_ES: $crate::base::es_profile::InEs = $crate::base::es_profile::InEs::of(NAMES);
            let arguments: &[$crate::base::core_profile::Argument] = &[$(
                $crate::base::core_profile::Argument {
                    name: stringify!($param),
                    ty: stringify!($ty),
                    value: $crate::record::arguments::RecordArgument::integer(&$param),
                }
            ),*];
            if $context.is_refused(stringify!($gl), IN_CORE, IN_ES, arguments) {
                return $crate::base::refused_result::RefusedResult::refused_result();
            }
        }
    };
    // A call that answers nothing is compiled into a display list, unless its row says `not_compiled`.
    (@record $context:ident $begin_end:ident $module:ident $method:ident $gl:ident
        [$($param:ident)*] [] []) => {
        if $context.compiling.is_some() {
            let integers: &[i64] = &[$($crate::record::arguments::RecordArgument::integer(&$param)),*];
            let name = stringify!($gl);
            if $crate::record::proxy::asks_proxy(name, integers) {
                // Carried out below.
            } else {
                let recorded = $crate::record::arguments::record_all(|| {
                    let _ = (&mut *$context, name, integers);
                    Ok(($($crate::record::arguments::RecordArgument::record(&$param, $context, name, integers)?,)*))
                });
                match recorded {
                    Ok(($($param,)*)) => {
                        let run = move |context: &mut $crate::context::Context| {
                            $module::$method(context $(, $crate::record::arguments::RecordedArgument::argument(&$param))*)
                        };
                        return $context.record(name, implement!(@begin_end $begin_end), Box::new(run));
                    }
                    Err($crate::record::arguments::NotRecorded::NoMemory) => return $context.has_no_memory_to_record(name),
                    Err($crate::record::arguments::NotRecorded::ReturnsData) => {}
                }
            }
        }
    };
    (@record $context:ident $begin_end:ident $module:ident $method:ident $gl:ident
        [$($param:ident)*] [] [not_compiled]) => {};
    (@record $context:ident $begin_end:ident $module:ident $method:ident $gl:ident
        [$($param:ident)*] [$ret:ty] []) => {};
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
    (@aliases $method:ident [$($alias:ident)*] $doc:tt $params:tt $ret:tt) => {
        $(implement!(@free $method $alias $doc $params $ret);)*
    };
    (@describe $begin_end:ident [$($gl:ident)+] ($($param:ident: $ty:ty),*) [$($ret:ty)?] [$($list:ident)?]) => {
        $crate::entry::description::EntryPoint {
            names: &[$($crate::entry::description::Name::of(stringify!($gl))),+],
            parameters: &[$(
                $crate::entry::description::Parameter { name: stringify!($param), ty: stringify!($ty) }
            ),*],
            result: implement!(@result [$($ret)?]),
            begin_end: implement!(@begin_end $begin_end),
            display_list: implement!(@list [$($ret)?] [$($list)?]),
        }
    };
    (@result []) => { None };
    (@result [$ret:ty]) => { Some(stringify!($ret)) };
    (@list [] []) => { $crate::entry::description::DisplayList::Compiled };
    (@list $ret:tt $list:tt) => { $crate::entry::description::DisplayList::NotCompiled };
    (@exercise $begin_end:ident $method:ident $gl:ident ($($param:ident: $ty:ty),*)) => {{
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
            begin_end: implement!(@begin_end $begin_end),
            run: exercise,
        }
    }};
}

/// Implements a row of attributes: a call that takes the components one by one, and one that takes a vector.
macro_rules! implement_attribute {
    (@call $doc:literal [$($lead:ident: $lead_ty:ty)?] $slot:expr, $convert:ident,
        $method:ident $gl:ident $aliases:tt $ty:ident ($($param:ident),+)) => {
        impl $crate::context::Context {
            #[doc = $doc]
            pub fn $method(&mut self $(, $lead: $lead_ty)? $(, $param: $ty)+) {
                implement!(@core self $gl $aliases ());
                let _float_env = <$ty as $crate::base::component::Component>::COMPUTES
                    .then(texunit::lanes::OutlinedFloatEnv::enter);
                self.call_of_attribute(stringify!($gl), $crate::base::begin_end::BeginEnd::Allowed, |context| {
                    let value = [$($crate::base::component::Component::$convert($param)),+];
                    $crate::calls::vertex::immediate::attribute(context, $slot, $crate::base::component::filled(value))
                });
            }
        }
    };
    (@vector $doc:literal [$($lead:ident: $lead_ty:ty)?] $slot:expr, $convert:ident,
        $method:ident $gl:ident $aliases:tt $ty:ident ($($param:ident),+)) => {
        impl $crate::context::Context {
            #[doc = $doc]
            pub fn $method(&mut self $(, $lead: $lead_ty)?, v: &[$ty]) {
                implement!(@core self $gl $aliases ());
                const PARAMETERS: &[&str] = &[$(stringify!($param)),+];
                const NEEDED: usize = PARAMETERS.len();
                let _float_env = <$ty as $crate::base::component::Component>::COMPUTES
                    .then(texunit::lanes::OutlinedFloatEnv::enter);
                self.call_of_attribute(stringify!($gl), $crate::base::begin_end::BeginEnd::Allowed, |context| {
                    match v.first_chunk::<NEEDED>() {
                        Some(v) => {
                            let value = v.map($crate::base::component::Component::$convert);
                            $crate::calls::vertex::immediate::attribute(context, $slot, $crate::base::component::filled(value))
                        }
                        None => $crate::base::error::invalid_operation(
                            "GL 2.1, section 2.7",
                            format!("v has {} of {NEEDED} numbers", v.len()),
                        ),
                    }
                });
            }
        }
    };
    (@free $doc:literal [$($lead:ident: $lead_ty:ty)?] $method:ident $gl:ident [$($alias:ident)?]
        $ty:ident ($($param:ident),+)) => {
        implement!(@free $method $gl [#[doc = $doc]] ($($lead: $lead_ty,)? $($param: $ty),+) []);
        implement!(@aliases $method [$($alias)?] [#[doc = $doc]] ($($lead: $lead_ty,)? $($param: $ty),+) []);
    };
    (@free_vector $doc:literal [$($lead:ident: $lead_ty:ty)?] $method:ident $gl:ident [$($alias:ident)?]
        $ty:ident) => {
        implement!(@free $method $gl [#[doc = $doc]] ($($lead: $lead_ty,)? v: &'a [$ty]) []);
        implement!(@aliases $method [$($alias)?] [#[doc = $doc]] ($($lead: $lead_ty,)? v: &'a [$ty]) []);
    };
    (@describe [$($lead:ident: $lead_ty:ty)?] $names:tt $ty:ident ($($param:ident),+)) => {
        implement!(@describe Allowed $names ($($lead: $lead_ty,)? $($param: $ty),+) [] [])
    };
    (@describe_vector [$($lead:ident: $lead_ty:ty)?] $names:tt $ty:ident) => {
        implement!(@describe Allowed $names ($($lead: $lead_ty,)? v: &'a [$ty]) [] [])
    };
    (@exercise [$($lead:ident: $lead_ty:ty)?] $method:ident $gl:ident $ty:ident ($($param:ident),+)) => {
        implement!(@exercise Allowed $method $gl ($($lead: $lead_ty,)? $($param: $ty),+))
    };
    (@exercise_vector [$($lead:ident: $lead_ty:ty)?] $method:ident $gl:ident $ty:ident) => {
        implement!(@exercise Allowed $method $gl ($($lead: $lead_ty,)? v: &'a [$ty]))
    };
}
