//! Whether the calling thread rounds and flushes as DetGL expects, on processors whose floating-point state `FloatEnv`
//! does not set: results are the same on all threads and machines only with IEEE 754 rounding to nearest and with
//! denormals, which is how every thread starts.

use std::hint::black_box;

/// The warning about a thread with another floating-point environment.
pub(crate) fn warning() -> Option<String> {
    let denormal = black_box(f32::MIN_POSITIVE) * black_box(0.5);
    let one = black_box(1.0_f32);
    // A quarter and three quarters of a unit in the last place.
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
        assert_eq!(crate::base::float_environment::warning(), None);
    }
}
