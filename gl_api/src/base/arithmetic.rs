//! How the calling thread computes, where `FloatEnv` does not know how to set that. It draws too, and what it computes
//! has to be what other threads do, and other machines: IEEE 754 with rounding to nearest and denormals, as every thread
//! begins.

use std::hint::black_box;

/// What to say of a thread that computes otherwise.
pub(crate) fn warning() -> Option<String> {
    let denormal = black_box(f32::MIN_POSITIVE) * black_box(0.5);
    let one = black_box(1.0_f32);
    // A quarter and three quarters of the way to the next number.
    let [quarter, most] = [0.25, 0.75].map(|part| one + black_box(part * f32::EPSILON));
    let what = if denormal == 0.0 {
        "has its processor flush denormals to zero"
    } else if quarter != one || most == one {
        "has its processor round otherwise than to nearest"
    } else {
        return None;
    };
    Some(format!(
        "this thread {what}: the last bits of pictures may differ from those of other threads and machines \
         (DETERMINISM.md). Programs and libraries linked with -ffast-math do this at their start; \
         fesetenv(FE_DFL_ENV) undoes it, before the first call that draws"
    ))
}

#[cfg(test)]
mod tests {
    #[test]
    fn threads_begin_as_they_should() {
        assert_eq!(crate::base::arithmetic::warning(), None);
    }
}
