//! Systems whose loaders do not look for OpenGL by Linux's names.

use super::{Glu, Links};
use std::env::consts::{DLL_PREFIX, DLL_SUFFIX, OS};
use std::ffi::OsString;
use std::io;
use std::path::Path;

pub fn install(_: &Path, _: Glu, _: Links, _: Option<&Path>) -> io::Result<()> {
    Err(not_here())
}

pub fn run(_: &[OsString], _: Glu) -> io::Result<()> {
    Err(not_here())
}

pub fn report() -> io::Result<()> {
    Err(not_here())
}

pub fn probe() -> io::Result<()> {
    Err(not_here())
}

/// Nothing is printed that a reader could leave.
pub fn end_with_reader() {}

fn not_here() -> io::Error {
    io::Error::new(
        io::ErrorKind::Unsupported,
        format!(
            "no program finds DetGL by itself on {OS}: only the names of Linux's libraries are stood in for. Depend \
             on the crate gl_api, or load {DLL_PREFIX}detgl{DLL_SUFFIX} and ask its eglGetProcAddress"
        ),
    )
}
