//! What is shown on a terminal beside tables.

use super::layout::NARROW;
use indicatif::{ProgressBar, ProgressStyle};

/// A bar on the terminal; on anything else it draws nothing.
pub fn bar(length: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}");
    let bar = ProgressBar::new(length as u64);
    match style {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

/// Names in lines of [`NARROW`] columns.
pub fn listed(names: &[&str]) -> String {
    let mut text = String::from(" ");
    let mut columns = 1;
    for name in names {
        let length = name.chars().count() + 2;
        if columns + length > NARROW.into() {
            text.push_str("\n ");
            columns = 1;
        }
        text.push_str(&format!(" {name},"));
        columns += length;
    }
    text.trim_end_matches(',').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_fit() {
        let text = listed(&["a-name-of-some-length"; 20]);
        assert!(text.lines().count() > 4);
        assert!(text.lines().all(|line| line.chars().count() <= NARROW.into()), "{text}");
        assert!(text.ends_with("length"));
    }
}
