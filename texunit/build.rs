//! Tells the crate how it is optimized: only a build script is told.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let level = std::env::var("OPT_LEVEL").expect("cargo sets OPT_LEVEL");
    println!("cargo::rustc-env=TEXUNIT_OPT_LEVEL={level}");
}
