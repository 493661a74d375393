//! Generates `gl.rs`, the typed function pointers that the peer comparison loads a driver through,
//! from the Khronos registry.

use gl_generator::{Api, Fallbacks, Profile, Registry, StructGenerator};
use std::fs::File;
use std::path::Path;

/// Beyond GL 2.1: textures as render targets, and `glGenerateMipmapEXT`.
const EXTENSIONS: [&str; 1] = ["GL_EXT_framebuffer_object"];

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let directory = std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR");
    let mut file = File::create(Path::new(&directory).join("gl.rs")).expect("OUT_DIR is writable");
    Registry::new(Api::Gl, (2, 1), Profile::Compatibility, Fallbacks::None, EXTENSIONS)
        .write_bindings(StructGenerator, &mut file)
        .expect("OUT_DIR is writable");
}
