//! State that is switched on at random.

use super::random::Random;
use gl_api::*;

/// Enables one in so many of these.
pub fn enable_some(c: &mut Context, random: &mut Random, caps: &[GLenum], one_in: u64) {
    for &cap in caps {
        if random.below(one_in) == 0 {
            c.enable(cap);
        }
    }
}
