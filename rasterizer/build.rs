//! Passes cargo's `OPT_LEVEL`, which only build scripts see, to the crate.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let level = std::env::var("OPT_LEVEL").expect("cargo sets OPT_LEVEL");
    println!("cargo::rustc-env=RASTERIZER_OPT_LEVEL={level}");
}
