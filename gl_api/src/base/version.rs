//! The version that contexts report.

use super::availability::Version;
use std::sync::LazyLock;

/// What OpenGL has: no later version can be reported.
const LATEST: Version = Version::new(4, 6);

/// The version that DetGL implements.
pub const IMPLEMENTED: Version = Version::new(3, 3);

/// The version of OpenGL ES that contexts of it have; one of 2.0 is one of 3.0, which has all of that.
pub const IMPLEMENTED_ES: Version = Version::new(3, 0);

/// The latest version that contexts can be asked for, and that all of them report: [`IMPLEMENTED`], or a later one that
/// the environment variable `DETGL_GL_VERSION` has, for programs that ask for a version of which they use nothing.
pub fn reported() -> Version {
    static REPORTED: LazyLock<Version> =
        LazyLock::new(|| std::env::var("DETGL_GL_VERSION").map_or(IMPLEMENTED, |text| of(&text)));
    *REPORTED
}

/// The version that a text asks for; what is none, or earlier than what is implemented, has no effect.
fn of(text: &str) -> Version {
    let parts = text.split_once('.');
    let numbers = parts.and_then(|(major, minor)| Some((major.parse().ok()?, minor.parse().ok()?)));
    match numbers {
        Some((major, minor)) => Version::new(major, minor).clamp(IMPLEMENTED, LATEST),
        None => IMPLEMENTED,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_later_versions_that_exist_are_reported() {
        assert_eq!(of("4.1"), Version::new(4, 1));
        assert_eq!(of("2.1"), IMPLEMENTED);
        assert_eq!(of("9.0"), LATEST);
        assert_eq!(of("four"), IMPLEMENTED);
        assert_eq!(of(""), IMPLEMENTED);
    }
}
