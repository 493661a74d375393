//! Says that what draws was compiled without optimization, and what cures it, once in a process.
//!
//! In a debug build of a program that depends on DetGL, profiles are the program's own: those of this workspace do not
//! reach it.

use std::sync::Once;

/// The crates that draw, and the levels of optimization that they are compiled with.
const CRATES: [(&str, &str); 2] =
    [("rasterizer", rasterizer::OPT_LEVEL), ("texunit", texunit::OPT_LEVEL)];

/// What is to be said, if anything.
fn advice(crates: &[(&str, &str)]) -> Option<String> {
    let slow: Vec<_> =
        crates.iter().filter(|(_, level)| *level == "0").map(|(name, _)| *name).collect();
    if slow.is_empty() {
        return None;
    }
    let lines: String = slow.iter().map(|name| format!("\n    {name}.opt-level = 3")).collect();
    Some(format!(
        "{} compiled without optimization, so that frames take many times as long; add to your workspace's \
         Cargo.toml (DETGL_DEBUG=0 hides this):\n    [profile.dev.package]{lines}",
        slow.join(" and ") + if slow.len() == 1 { " is" } else { " are" },
    ))
}

/// Gives the text to `print`, the first time in this process.
pub(super) fn warn_once(print: impl FnOnce(&String)) {
    static WARNED: Once = Once::new();
    WARNED.call_once(|| {
        if let Some(text) = advice(&CRATES) {
            print(&text);
        }
    });
}

#[cfg(test)]
mod tests {
    use super::advice;

    #[test]
    fn only_what_is_not_optimized_is_named() {
        assert_eq!(advice(&[("rasterizer", "3"), ("texunit", "s")]), None);
        let one = advice(&[("rasterizer", "1"), ("texunit", "0")]).expect("a text");
        assert!(one.starts_with("texunit is compiled without"), "{one}");
        assert!(one.ends_with(":\n    [profile.dev.package]\n    texunit.opt-level = 3"), "{one}");
        let both = advice(&[("rasterizer", "0"), ("texunit", "0")]).expect("a text");
        assert!(both.starts_with("rasterizer and texunit are compiled"), "{both}");
        assert!(
            both.ends_with("\n    rasterizer.opt-level = 3\n    texunit.opt-level = 3"),
            "{both}"
        );
    }
}
