//! Placeholder while the crates below it come up.
fn main() {}
