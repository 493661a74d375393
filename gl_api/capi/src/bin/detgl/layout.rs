//! The library under the names that programs and loaders look for, and its vendor file for libglvnd.

use super::Glu;
use std::fs::File;
use std::io;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// The library, as cargo builds it and as it is installed. All other names are links to it: loaded under two
/// names it has to be one library, with one current context.
const LIBRARY: &str = "libdetgl.so";
/// The names that it stands in for: those that programs were linked with, and those that `cc -l`
/// looks for.
const NAMES: [&str; 10] = [
    "libEGL.so.1",
    "libEGL.so",
    "libGL.so.1",
    "libGL.so",
    "libOpenGL.so.0",
    "libOpenGL.so",
    "libGLESv2.so.2",
    "libGLESv2.so",
    "libOSMesa.so.8",
    "libOSMesa.so",
];

/// The names of libGLU, for whoever asks for them: a program with a tessellator or NURBS, which this
/// library does not have, needs the system's.
const GLU_NAMES: [&str; 2] = ["libGLU.so.1", "libGLU.so"];

/// How the system's libEGL finds the library, where a program has loaded that: the file that
/// `__EGL_VENDOR_LIBRARY_FILENAMES` names for libglvnd.
pub const VENDOR_FILE: &str = "egl_vendor.json";

/// The library that was built together with this program: beside it, and where `cargo test` leaves
/// it; whichever is newer.
fn library() -> io::Result<PathBuf> {
    let program = env::current_exe()?.canonicalize()?;
    let folder = program.parent().unwrap_or(Path::new("."));
    let places = [folder.join(LIBRARY), folder.join("deps").join(LIBRARY)];
    let built = |path: &PathBuf| fs::metadata(path).and_then(|data| data.modified()).ok();
    let newest = places.into_iter().filter(|path| path.is_file()).max_by_key(built);
    newest.ok_or_else(|| {
        io::Error::new(
            io::ErrorKind::NotFound,
            format!(
                "there is no {LIBRARY} beside {}: build it with `cargo build --release --workspace`",
                program.display()
            ),
        )
    })
}

/// Copies the library into a folder and links its names to it.
pub fn install(folder: &Path, glu: Glu) -> io::Result<()> {
    lay_out(&library()?, folder, glu)
}

/// What is there already and the same is left alone: programs may be about to load it.
fn lay_out(library: &Path, folder: &Path, glu: Glu) -> io::Result<()> {
    let at = |path: &Path, error: io::Error| {
        io::Error::new(error.kind(), format!("{}: {error}", path.display()))
    };
    fs::create_dir_all(folder).map_err(|error| at(folder, error))?;
    // One at a time, so that a program which loads the library under two names finds the same file behind both
    // although another is started just then. Where files cannot be locked, nobody waits.
    let file = File::open(library).map_err(|error| at(library, error))?;
    let _ = file.lock();
    let target = folder.join(LIBRARY);
    let text = fs::read(library).map_err(|error| at(library, error))?;
    if fs::read(&target).ok().as_ref() != Some(&text) {
        // A program that runs on an older copy keeps it: the new one is another file.
        let fresh = folder.join(format!(".{LIBRARY}.{}", std::process::id()));
        fs::copy(library, &fresh).map_err(|error| at(&fresh, error))?;
        fs::rename(&fresh, &target).map_err(|error| at(&target, error))?;
    }
    let glu_names = match glu {
        Glu::System => &[][..],
        Glu::Own => &GLU_NAMES,
    };
    for name in NAMES.iter().chain(glu_names) {
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
    let path = target.canonicalize().map_err(|error| at(&target, error))?;
    let vendor = folder.join(VENDOR_FILE);
    let text = vendor_file(&path);
    if fs::read(&vendor).is_ok_and(|old| old == text.as_bytes()) {
        return Ok(());
    }
    fs::write(&vendor, text).map_err(|error| at(&vendor, error))
}

/// JSON in which the library's path is a string.
fn vendor_file(library: &Path) -> String {
    let path = library.display().to_string().replace('\\', r"\\").replace('"', "\\\"");
    format!(
        "{{\n    \"file_format_version\": \"1.0.0\",\n    \"ICD\": {{ \"library_path\": \"{path}\" }}\n}}\n"
    )
}

/// A folder for `detgl run`, which nobody else writes to: beside the program.
pub fn private_folder(glu: Glu) -> io::Result<PathBuf> {
    let program = env::current_exe()?.canonicalize()?;
    let name = match glu {
        Glu::System => "detgl-libraries",
        Glu::Own => "detgl-libraries-glu",
    };
    Ok(program.parent().unwrap_or(Path::new(".")).join(name))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::os::unix::fs::MetadataExt;

    #[test]
    fn the_same_library_is_not_replaced() {
        let place = env::temp_dir().join(format!("detgl-layout-{}", std::process::id()));
        let (source, folder) = (place.join(LIBRARY), place.join("libraries"));
        fs::create_dir_all(&place).expect("a folder");
        let laid_out = |text: &str| {
            fs::write(&source, text).expect("written");
            lay_out(&source, &folder, Glu::Own).expect("laid out");
            assert_eq!(fs::read_to_string(folder.join("libGL.so.1")).expect("there"), text);
            let files = [LIBRARY, VENDOR_FILE].map(|name| fs::metadata(folder.join(name)));
            files.map(|file| file.map(|file| (file.ino(), file.mtime_nsec())).expect("there"))
        };
        let first = laid_out("one");
        assert_eq!(laid_out("one"), first);
        assert_ne!(laid_out("two")[0], first[0]);
        fs::remove_dir_all(&place).expect("removed");
    }
}
