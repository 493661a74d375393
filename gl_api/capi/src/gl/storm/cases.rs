//! Each C function with arguments of its types, made from the table of entry points.

use super::arguments::Argument;
use super::lengths::{Counts, elements, is_count};
use super::memory::Slot;
use super::random::{HOSTILE, Random, number};
use crate::gl;
use crate::lengths::rules;
use crate::param::Param;
use gl_api::*;

/// Pointers of a call, at most.
pub(super) const SLOTS: usize = 12;

/// A C function with arguments of its types.
pub(super) struct Case {
    pub(super) name: &'static str,
    /// The numbers of the parameters that are counts.
    pub(super) counts: Vec<usize>,
    pub(super) run: fn(&[Slot; SLOTS], &Random, Counts),
}

/// All names of all rows.
pub(super) fn cases() -> Vec<Case> {
    let mut all = Vec::new();
    macro_rules! add {
        ($method:ident [$first:ident $($alias:ident)*] $params:tt $ret:tt) => {
            add!(@one $first $first $params);
            $(add!(@one $first $alias $params);)*
        };
        (@one $first:ident $gl:ident ($($param:ident: $ty:ty),*)) => {
            let parameters: &[(&str, &str)] = &[$((stringify!($param), stringify!($ty))),*];
            let counts = parameters.iter().enumerate().filter(|(_, (name, ty))| is_count(name, ty));
            all.push(Case {
                name: stringify!($gl),
                counts: counts.map(|(at, _)| at).collect(),
                run: {
                    #[allow(clippy::extra_unused_lifetimes, reason = "for the rows that borrow")]
                    fn run<'a>(slots: &[Slot; SLOTS], random: &Random, counts: Counts) {
                        let rules = const {
                            rules(stringify!($first), stringify!($gl), [$(<$ty as Param<'a>>::COUNTED),*])
                        };
                        let mut _at = 0;
                        let mut next = |name: &str, ty: &str| {
                            let number = match counts {
                                Counts::Hostile(at) if at == _at => random.pick(HOSTILE),
                                Counts::Hostile(_) | Counts::Honest => number(random, name, ty),
                            };
                            _at += 1;
                            number
                        };
                        let _ = &mut next;
                        $(let $param = <$ty as Argument<'a>>::number(next(stringify!($param), stringify!($ty)));)*
                        let _numbers: &[isize] = &[$($param.map_or(0, <$ty as Param<'a>>::number)),*];
                        let mut _slots = slots.iter();
                        let mut _rules = rules.iter();
                        $(
                            let (slot, rule) = (_slots.next(), _rules.next());
                            let $param = match ($param, slot) {
                                (Some(number), _) => number,
                                (None, Some(slot)) => {
                                    let length = elements(rule, stringify!($gl), _numbers, counts);
                                    <$ty as Argument<'a>>::memory(*slot, length, random)
                                }
                                (None, None) => unreachable!("there are more slots than parameters"),
                            };
                        )*
                        // SAFETY: what the test is about.
                        let _ = unsafe { gl::$gl($($param),*) };
                    }
                    run
                },
            });
        };
    }
    entry_points!(each_function add);
    all
}
