//! The library under the names that programs and loaders look for.

use std::io;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// What cargo calls the library.
const BUILT: &str = "libgl_api.so";
/// What it is called where it is installed. All other names are links to it: loaded under two
/// names it has to be one library, with one current context.
const LIBRARY: &str = "libdetgl.so";
/// The names that it stands in for: those that programs were linked with, and those that `cc -l`
/// looks for.
const NAMES: [&str; 8] = [
    "libEGL.so.1",
    "libEGL.so",
    "libGL.so.1",
    "libGL.so",
    "libOpenGL.so.0",
    "libOpenGL.so",
    "libOSMesa.so.8",
    "libOSMesa.so",
];

/// The library that was built together with this program.
fn library() -> io::Result<PathBuf> {
    let program = env::current_exe()?.canonicalize()?;
    let folder = program.parent().unwrap_or(Path::new("."));
    [LIBRARY, BUILT]
        .into_iter()
        .map(|name| folder.join(name))
        .find(|path| path.is_file())
        .ok_or_else(|| {
            io::Error::new(
                io::ErrorKind::NotFound,
                format!(
                    "there is no {BUILT} beside {}: build it with `cargo build --release \
                     --workspace`",
                    program.display()
                ),
            )
        })
}

/// Copies the library into a folder and links its names to it.
pub fn install(folder: &Path) -> io::Result<()> {
    let at = |path: &Path, error: io::Error| {
        io::Error::new(error.kind(), format!("{}: {error}", path.display()))
    };
    let library = library()?;
    fs::create_dir_all(folder).map_err(|error| at(folder, error))?;
    let target = folder.join(LIBRARY);
    // A program that runs on an older copy keeps it: the new one is another file.
    let fresh = folder.join(format!(".{LIBRARY}.{}", std::process::id()));
    fs::copy(&library, &fresh).map_err(|error| at(&fresh, error))?;
    fs::rename(&fresh, &target).map_err(|error| at(&target, error))?;
    for name in NAMES {
        let link = folder.join(name);
        match symlink(LIBRARY, &link) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                if fs::read_link(&link).is_ok_and(|path| path == Path::new(LIBRARY)) {
                    continue;
                }
                return Err(at(&link, io::Error::other("is there and is not DetGL's")));
            }
            result => result.map_err(|error| at(&link, error))?,
        }
    }
    Ok(())
}

/// A folder for `detgl run`, which nobody else writes to: beside the program.
pub fn private_folder() -> io::Result<PathBuf> {
    let program = env::current_exe()?.canonicalize()?;
    Ok(program.parent().unwrap_or(Path::new(".")).join("detgl-libraries"))
}
