//! Every operation of the IR, once: name, types, meaning over one lane.
//!
//! The table gives the enum, its listing names, the constant folder ([`Op::eval`]) and the lane
//! kernel ([`batch`]) from one body, so that they cannot differ. All bodies are branch-free
//! scalar code that LLVM vectorizes over the 64 lanes. A row may say `where a: rare(a) => far(a, …)`: a
//! piece of the operation that is computed lane by lane, when a lane of the batch needs it. With `unless r: good(r)
//! => far(a, …)` the result says so. No operation that computes several at once (`shader/compute.rs`) may have such a row.

use super::types::Ty;
use super::word::{LONG, Scalar, agree, div_i32, div_u32, rem_i32, rem_u32, select};
use texunit::lanes::{Baseline, LANES, Simd, U32s, math};

macro_rules! operations {
    (@operands $registers:ident $args:ident $a:ident $(, $b:ident $(, $c:ident)?)?) => {
        let $a = &$registers[$args[0]];
        $(let $b = &$registers[$args[1]]; $(let $c = &$registers[$args[2]];)?)?
    };
    (@lane $lane:ident $a:ident: $A:ty $(, $b:ident: $B:ty $(, $c:ident: $C:ty)?)?) => {
        let $a = <$A>::of_lane($a, $lane);
        $(let $b = <$B>::of_lane($b, $lane); $(let $c = <$C>::of_lane($c, $lane);)?)?
    };
    (@agree $a:ident $(, $b:ident $(, $c:ident)?)?) => {
        agree($a) $(&& agree($b) $(&& agree($c))?)?
    };
    (@words $at:tt $a:ident) => { [$a[$at], 0, 0] };
    (@words $at:tt $a:ident, $b:ident) => { [$a[$at], $b[$at], 0] };
    (@words $at:tt $a:ident, $b:ident, $c:ident) => { [$a[$at], $b[$at], $c[$at]] };
    (@rare [$($far:tt)*] $out:ident $($operand:ident),*;) => {};
    (@rare [$($far:tt)*] $out:ident $($operand:ident),*; $of:ident $rare:expr) => {
        let mut any = false;
        for lane in 0..LANES {
            let $of = f32::from_word($of[lane]);
            any |= $rare;
        }
        if any {
            for lane in 0..LANES {
                let words = operations!(@words lane $($operand),*);
                let $of = f32::from_word($of[lane]);
                if $rare {
                    $out[lane] = $($far)*(words);
                }
            }
        }
    };
    (@mend [$($far:tt)*] $out:ident $($operand:ident),*;) => {};
    (@mend [$($far:tt)*] $out:ident $($operand:ident),*; $result:ident $good:expr) => {
        let mut any = false;
        for lane in 0..LANES {
            let $result = f32::from_word($out[lane]);
            any |= !$good;
        }
        if any {
            for lane in 0..LANES {
                let $result = f32::from_word($out[lane]);
                if !$good {
                    $out[lane] = $($far)*(operations!(@words lane $($operand),*));
                }
            }
        }
    };
    ($d:tt $(
        $(#[doc = $doc:literal])+
        $Name:ident $name:literal ($a:ident: $A:ty $(, $b:ident: $B:ty $(, $c:ident: $C:ty)?)?) -> $R:ty = $body:expr
        $(, where $of:ident: $rare:expr => $far:expr)?
        $(, unless $found:ident: $good:expr => $mended:expr)?;
    )*) => {
        /// An operation on scalars.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Op {
            $($(#[doc = $doc])+ $Name,)*
        }

        /// Every operation inside a kernel, in its own types; of operands that are not rare.
        #[allow(non_snake_case, unused_imports, reason = "called as in the table")]
        #[allow(clippy::extra_unused_type_parameters, reason = "not every body asks")]
        pub mod scalar {
            use super::*;
            $(
                $(#[doc = $doc])+
                #[inline(always)]
                pub fn $Name<S: Simd>($a: $A $(, $b: $B $(, $c: $C)?)?) -> $R {
                    $body
                }
            )*
        }

        impl Op {
            /// Every operation, in the order of the table.
            pub const ALL: &'static [Self] = &[$(Self::$Name),*];

            /// The name in listings.
            pub fn name(self) -> &'static str {
                match self { $(Self::$Name => $name,)* }
            }

            /// The types of the operands; its length is the arity.
            pub fn args(self) -> &'static [Ty] {
                match self {
                    $(Self::$Name => &[<$A>::TY $(, <$B>::TY $(, <$C>::TY)?)?],)*
                }
            }

            /// The type of the result.
            pub fn result(self) -> Ty {
                match self { $(Self::$Name => <$R>::TY,)* }
            }

            /// The operation on one lane. Operands beyond the arity are not looked at.
            pub fn eval(self, args: [u32; 3]) -> u32 {
                self.lane::<Baseline>(args)
            }

            /// [`Self::eval`] inside a kernel.
            #[inline(always)]
            pub fn lane<S: Simd>(self, args: [u32; 3]) -> u32 {
                match self {
                    $(Self::$Name => {
                        let $a = <$A>::from_word(args[0]);
                        $(let $b = <$B>::from_word(args[1]);
                        $(let $c = <$C>::from_word(args[2]);)?)?
                        $(if $rare {
                            let result: $R = $far;
                            return result.to_word();
                        })?
                        let result = scalar::$Name::<S>($a $(, $b $(, $c)?)?);
                        $(
                            let $found = result;
                            let result: $R = if $good { result } else { $mended };
                        )?
                        result.to_word()
                    })*
                }
            }
        }

        /// Every operation on 64 lanes of a register file: from the registers `args` to `out`, which may be
        /// one of them. Operands beyond the arity are not looked at.
        #[allow(non_snake_case, unused_variables, reason = "called as in the table")]
        pub mod batch {
            use super::*;
            $(
                $(#[doc = $doc])+
                #[inline(always)]
                pub fn $Name<S: Simd>(registers: &mut [U32s], out: usize, args: [usize; 3]) {
                    // By itself, so that the compiler knows that no operand is written.
                    let mut result = U32s::ZERO;
                    operations!(@operands registers args $a $(, $b $(, $c)?)?);
                    if Op::$Name.cost() >= LONG {
                        if operations!(@agree $a $(, $b $(, $c)?)?) {
                            let word = Op::$Name.lane::<S>(operations!(@words 0 $a $(, $b $(, $c)?)?));
                            registers[out] = U32s::splat(word);
                            return;
                        }
                    }
                    for lane in 0..LANES {
                        operations!(@lane lane $a: $A $(, $b: $B $(, $c: $C)?)?);
                        result[lane] = scalar::$Name::<S>($a $(, $b $(, $c)?)?).to_word();
                    }
                    operations!(@rare [Op::$Name.lane::<S>] result $a $(, $b $(, $c)?)?; $($of $rare)?);
                    operations!(@mend [Op::$Name.lane::<S>] result $a $(, $b $(, $c)?)?; $($found $good)?);
                    registers[out] = result;
                }
            )*
        }

        /// Calls a macro with the names of all operations in brackets, before what else it is given.
        macro_rules! with_operations {
            ($d then:ident! { $d($d rest:tt)* }) => { $d then! { [$($Name)*] $d($d rest)* } };
        }
        pub(crate) use with_operations;
    };
}

// The dollar sign is for the macro that this one defines.
operations! { $
    /// `a + b`.
    Add "add" (a: f32, b: f32) -> f32 = a + b;
    /// `a - b`.
    Sub "sub" (a: f32, b: f32) -> f32 = a - b;
    /// `a · b`.
    Mul "mul" (a: f32, b: f32) -> f32 = a * b;
    /// `a / b`, IEEE.
    Div "div" (a: f32, b: f32) -> f32 = a / b;
    /// The sign bit flipped.
    Neg "neg" (a: f32) -> f32 = -a;
    /// The sign bit cleared.
    Abs "abs" (a: f32) -> f32 = a.abs();
    /// -1, 0 or 1 (0 for NaN).
    Sign "sign" (a: f32) -> f32 = if a > 0.0 { 1.0 } else if a < 0.0 { -1.0 } else { 0.0 };
    /// The smaller; the other if one is NaN.
    Min "min" (a: f32, b: f32) -> f32 = math::min_number(a, b);
    /// The larger; the other if one is NaN.
    Max "max" (a: f32, b: f32) -> f32 = math::max_number(a, b);
    /// `Self::Min` of `a` and an operand that is known not to be NaN, in one step; `b` if `a` is NaN.
    AtMost "at_most" (a: f32, b: f32) -> f32 = math::min(a, b);
    /// `Self::Max` of `a` and an operand that is known not to be NaN, in one step; `b` if `a` is NaN.
    AtLeast "at_least" (a: f32, b: f32) -> f32 = math::max(a, b);
    /// The largest integer not above.
    Floor "floor" (a: f32) -> f32 = S::floor(a);
    /// The smallest integer not below.
    Ceil "ceil" (a: f32) -> f32 = S::ceil(a);
    /// The integer part toward zero.
    Trunc "trunc" (a: f32) -> f32 = S::trunc(a);
    /// The nearest integer, halves to even.
    RoundEven "round_even" (a: f32) -> f32 = S::round_even(a);
    /// `a - floor(a)`.
    Fract "fract" (a: f32) -> f32 = a - S::floor(a);
    /// GLSL's `mod` of `a` and `b`, whose inverse is `c`, see [`math::modulo`].
    Mod "mod" (a: f32, b: f32, c: f32) -> f32 = math::modulo(a, b, c, S::round_even(a * c)),
        where c: c.is_infinite() => a - b * S::floor(a / b);
    /// The same where the inverse is known to be finite.
    ModNear "mod_near" (a: f32, b: f32, c: f32) -> f32 =
        math::modulo(a, b, c, S::round_even(a * c));
    /// The same where `b` is known to be above 0 too.
    ModPositive "mod_positive" (a: f32, b: f32, c: f32) -> f32 =
        math::modulo_positive(a, b, S::round_even(a * c));
    /// IEEE square root.
    Sqrt "sqrt" (a: f32) -> f32 = a.sqrt();
    /// `1 / sqrt(a)`, two roundings.
    InverseSqrt "inverse_sqrt" (a: f32) -> f32 = 1.0 / a.sqrt();

    /// `sqrt((a² + b²) + c²)`; where that is so small or large that a square left the range of floats, by
    /// [`math::norm_far`].
    Norm "norm" (a: f32, b: f32, c: f32) -> f32 = (a * a + b * b + c * c).sqrt(),
        unless r: (r > math::LEAST_NORM) & (r < math::LARGEST_NORM) => math::norm_far(a, b, c);
    /// `1 / sqrt((a² + b²) + c²)`, three more roundings, likewise.
    InverseNorm "inverse_norm" (a: f32, b: f32, c: f32) -> f32 =
        1.0 / (a * a + b * b + c * c).sqrt(),
        unless r: (r > 1.0 / math::LARGEST_NORM) & (r < 1.0 / math::LEAST_NORM) =>
            math::inverse_norm_far(a, b, c);

    /// Sine of an angle in radians; bounds of this and the next are those of [`math`].
    Sin "sin" (a: f32) -> f32 = math::sin_near(a),
        where a: math::is_far(a) => math::sin_far(a);
    /// Cosine.
    Cos "cos" (a: f32) -> f32 = math::cos_near(a),
        where a: math::is_far(a) => math::cos_far(a);
    /// Tangent.
    Tan "tan" (a: f32) -> f32 = math::tan_near(a),
        where a: math::is_far(a) => math::tan_far(a);
    /// The angle of this sine.
    Asin "asin" (a: f32) -> f32 = math::asin(a);
    /// The angle of this cosine.
    Acos "acos" (a: f32) -> f32 = math::acos(a);
    /// The angle of this tangent.
    Atan "atan" (a: f32) -> f32 = math::atan(a);
    /// The angle of the point (`b`, `a`).
    Atan2 "atan2" (a: f32, b: f32) -> f32 = math::atan2(a, b);
    /// Hyperbolic sine.
    Sinh "sinh" (a: f32) -> f32 = math::sinh(a);
    /// Hyperbolic cosine.
    Cosh "cosh" (a: f32) -> f32 = math::cosh(a);
    /// Hyperbolic tangent.
    Tanh "tanh" (a: f32) -> f32 = math::tanh(a);
    /// Inverse hyperbolic sine.
    Asinh "asinh" (a: f32) -> f32 = math::asinh(a);
    /// Inverse hyperbolic cosine.
    Acosh "acosh" (a: f32) -> f32 = math::acosh(a);
    /// Inverse hyperbolic tangent.
    Atanh "atanh" (a: f32) -> f32 = math::atanh(a);
    /// `e^a`.
    Exp "exp" (a: f32) -> f32 = math::exp(a);
    /// `2^a`.
    Exp2 "exp2" (a: f32) -> f32 = math::exp2(a);
    /// Natural logarithm.
    Log "log" (a: f32) -> f32 = math::log(a);
    /// Logarithm to base 2.
    Log2 "log2" (a: f32) -> f32 = math::log2(a);
    /// `a^b` as C has it, see [`math::pow`].
    Pow "pow" (a: f32, b: f32) -> f32 = math::pow_positive(a, b),
        where a: a.is_sign_negative() => math::pow_negative(a, b);

    /// `a < b`.
    Less "less" (a: f32, b: f32) -> bool = a < b;
    /// `a <= b`.
    LessEqual "less_equal" (a: f32, b: f32) -> bool = a <= b;
    /// `a == b`.
    Equal "equal" (a: f32, b: f32) -> bool = a == b;
    /// `a != b` (true for NaN).
    NotEqual "not_equal" (a: f32, b: f32) -> bool = a != b;

    /// Wrapping sum; serves `u32` too through a change of type.
    IAdd "iadd" (a: i32, b: i32) -> i32 = a.wrapping_add(b);
    /// Wrapping difference.
    ISub "isub" (a: i32, b: i32) -> i32 = a.wrapping_sub(b);
    /// Wrapping product.
    IMul "imul" (a: i32, b: i32) -> i32 = a.wrapping_mul(b);
    /// Quotient toward zero; -1 for a zero divisor.
    IDiv "idiv" (a: i32, b: i32) -> i32 = div_i32(a, b);
    /// Remainder with the sign of `a`; -1 for a zero divisor.
    IRem "irem" (a: i32, b: i32) -> i32 = rem_i32(a, b);
    /// Wrapping negation.
    INeg "ineg" (a: i32) -> i32 = a.wrapping_neg();
    /// Wrapping magnitude.
    IAbs "iabs" (a: i32) -> i32 = a.wrapping_abs();
    /// -1, 0 or 1.
    ISign "isign" (a: i32) -> i32 = i32::from(a > 0) - i32::from(a < 0);
    /// The smaller.
    IMin "imin" (a: i32, b: i32) -> i32 = if a < b { a } else { b };
    /// The larger.
    IMax "imax" (a: i32, b: i32) -> i32 = if a > b { a } else { b };
    /// `a < b`.
    ILess "iless" (a: i32, b: i32) -> bool = a < b;
    /// `a <= b`.
    ILessEqual "iless_equal" (a: i32, b: i32) -> bool = a <= b;
    /// `a == b`.
    IEqual "iequal" (a: i32, b: i32) -> bool = a == b;
    /// `a != b`.
    INotEqual "inot_equal" (a: i32, b: i32) -> bool = a != b;
    /// Shift right, filling with the sign; the count modulo 32.
    IShiftRight "ishift_right" (a: i32, b: u32) -> i32 = a >> (b & 31);

    /// Wrapping sum.
    UAdd "uadd" (a: u32, b: u32) -> u32 = a.wrapping_add(b);
    /// Wrapping difference.
    USub "usub" (a: u32, b: u32) -> u32 = a.wrapping_sub(b);
    /// Wrapping product.
    UMul "umul" (a: u32, b: u32) -> u32 = a.wrapping_mul(b);
    /// Quotient; all ones for a zero divisor.
    UDiv "udiv" (a: u32, b: u32) -> u32 = div_u32(a, b);
    /// Remainder; all ones for a zero divisor.
    URem "urem" (a: u32, b: u32) -> u32 = rem_u32(a, b);
    /// The smaller.
    UMin "umin" (a: u32, b: u32) -> u32 = if a < b { a } else { b };
    /// The larger.
    UMax "umax" (a: u32, b: u32) -> u32 = if a > b { a } else { b };
    /// `a < b`.
    ULess "uless" (a: u32, b: u32) -> bool = a < b;
    /// `a <= b`.
    ULessEqual "uless_equal" (a: u32, b: u32) -> bool = a <= b;
    /// The bits of a float, as those of an integer attribute.
    FloatBits "float_bits" (a: f32) -> u32 = a.to_bits();
    /// The float of these bits.
    BitsFloat "bits_float" (a: u32) -> f32 = f32::from_bits(a);
    /// Bits of both.
    BitAnd "bit_and" (a: u32, b: u32) -> u32 = a & b;
    /// Bits of either.
    BitOr "bit_or" (a: u32, b: u32) -> u32 = a | b;
    /// Bits of one.
    BitXor "bit_xor" (a: u32, b: u32) -> u32 = a ^ b;
    /// Every bit flipped.
    BitNot "bit_not" (a: u32) -> u32 = !a;
    /// Shift left; the count modulo 32.
    ShiftLeft "shift_left" (a: u32, b: u32) -> u32 = a << (b & 31);
    /// Shift right, filling with zeros; the count modulo 32.
    UShiftRight "ushift_right" (a: u32, b: u32) -> u32 = a >> (b & 31);

    /// Both.
    And "and" (a: bool, b: bool) -> bool = a & b;
    /// Either.
    Or "or" (a: bool, b: bool) -> bool = a | b;
    /// Exactly one.
    Xor "xor" (a: bool, b: bool) -> bool = a ^ b;
    /// The opposite.
    Not "not" (a: bool) -> bool = !a;

    /// `b` where `a` is true, else `c`.
    SelectF "select_f32" (a: bool, b: f32, c: f32) -> f32 = select(a, b, c);
    /// `b` where `a` is true, else `c`.
    SelectI "select_i32" (a: bool, b: i32, c: i32) -> i32 = select(a, b, c);
    /// `b` where `a` is true, else `c`.
    SelectU "select_u32" (a: bool, b: u32, c: u32) -> u32 = select(a, b, c);
    /// `b` where `a` is true, else `c`.
    SelectB "select_bool" (a: bool, b: bool, c: bool) -> bool = select(a, b, c);

    /// The integer part toward zero; out of range clamps, NaN gives the smallest.
    FloatToInt "float_to_int" (a: f32) -> i32 = math::to_i32(a);
    /// The integer part toward zero; negative gives 0, too large clamps, NaN gives 0.
    FloatToUint "float_to_uint" (a: f32) -> u32 = math::to_u32(a);
    /// The nearest `f32`.
    IntToFloat "int_to_float" (a: i32) -> f32 = a as f32;
    /// The nearest `f32`.
    UintToFloat "uint_to_float" (a: u32) -> f32 = a as f32;
    /// The same bits.
    IntToUint "int_to_uint" (a: i32) -> u32 = a as u32;
    /// The same bits.
    UintToInt "uint_to_int" (a: u32) -> i32 = a as i32;
    /// 1.0 or 0.0.
    BoolToFloat "bool_to_float" (a: bool) -> f32 = if a { 1.0 } else { 0.0 };
    /// 1 or 0.
    BoolToInt "bool_to_int" (a: bool) -> i32 = i32::from(a);
    /// 1 or 0.
    BoolToUint "bool_to_uint" (a: bool) -> u32 = u32::from(a);
}

impl Op {
    /// The approximate cost of the operation, in additions.
    #[inline(always)]
    pub const fn cost(self) -> u32 {
        match self {
            Self::Div | Self::Sqrt | Self::InverseSqrt => 8,
            Self::Norm | Self::InverseNorm => 12,
            Self::Mod | Self::ModNear | Self::ModPositive => 8,
            Self::Sin | Self::Cos | Self::Tan => LONG,
            Self::Asin | Self::Acos | Self::Atan | Self::Atan2 => LONG,
            Self::Sinh | Self::Cosh | Self::Tanh | Self::Asinh | Self::Acosh | Self::Atanh => LONG,
            Self::Exp | Self::Exp2 | Self::Log | Self::Log2 | Self::Pow => LONG,
            Self::IDiv | Self::IRem | Self::UDiv | Self::URem => LONG,
            _ => 1,
        }
    }
}
