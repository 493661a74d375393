//! The library under the names that programs and loaders look for, and its vendor file for libglvnd.

use super::facade::{self, Facade};
use super::{Glu, Links};
use std::fs::File;
use std::io;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// The library, as cargo builds it and as it is installed. All other names are facades of it: loaded under two
/// names it has to be one library, with one current context.
const LIBRARY: &str = facade::NEEDED;

/// A library that it stands in for.
pub struct Name {
    /// That programs were linked with, and load: its SONAME.
    pub versioned: &'static str,
    /// That `cc -l` looks for, and some programs load.
    pub plain: &'static str,
    /// How the names of its functions begin.
    prefixes: &'static [&'static str],
}

/// All but libGLU.
pub const NAMES: [Name; 5] = [
    Name { versioned: "libEGL.so.1", plain: "libEGL.so", prefixes: &["egl"] },
    Name { versioned: "libGL.so.1", plain: "libGL.so", prefixes: &["gl", "glX"] },
    Name { versioned: "libOpenGL.so.0", plain: "libOpenGL.so", prefixes: &["gl"] },
    Name { versioned: "libGLESv2.so.2", plain: "libGLESv2.so", prefixes: &["gl"] },
    Name { versioned: "libOSMesa.so.8", plain: "libOSMesa.so", prefixes: &["OSMesa", "gl"] },
];

/// libGLU, for programs that ask for it by `--glu`: one with a tessellator or NURBS, which this library does not have, needs the
/// system's. In a folder of its own below the others.
const GLU: Name = Name { versioned: "libGLU.so.1", plain: "libGLU.so", prefixes: &["glu"] };
const GLU_FOLDER: &str = "glu";

/// How the system's libEGL finds the library, where a program has loaded that: the file that
/// `__EGL_VENDOR_LIBRARY_FILENAMES` names for libglvnd.
pub const VENDOR_FILE: &str = "egl_vendor.json";

/// How names begin; `glXWaitX` is not one of `gl`.
const PREFIXES: [&str; 5] = ["OSMesa", "egl", "glX", "glu", "gl"];

impl Name {
    /// Whether a function is one of this library.
    fn has(&self, function: &str) -> bool {
        let is_of = |prefix: &&&str| {
            let rest = function.strip_prefix(**prefix);
            rest.is_some_and(|rest| rest.starts_with(|first: char| first.is_ascii_uppercase()))
        };
        PREFIXES.iter().find(is_of).is_some_and(|prefix| self.prefixes.contains(prefix))
    }
}

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

/// Copies a library into a folder, the one beside this program if none is named, and its facades.
pub fn install(folder: &Path, glu: Glu, links: Links, named: Option<&Path>) -> io::Result<()> {
    let found;
    let library = match named {
        Some(named) => named,
        None => {
            found = library()?;
            &found
        }
    };
    lay_out(library, folder, glu, links)
}

/// An error with the path that it is about.
fn at(path: &Path, error: io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("{}: {error}", path.display()))
}

/// What is there already and the same is left alone: programs may be about to load it.
fn lay_out(library: &Path, folder: &Path, glu: Glu, links: Links) -> io::Result<()> {
    // One at a time, so that a program which loads the library under two names finds the same file behind both
    // although another is started just then. Where files cannot be locked, nobody waits.
    let file = File::open(library).map_err(|error| at(library, error))?;
    let _ = file.lock();
    let bytes = fs::read(library).map_err(|error| at(library, error))?;
    let functions = facade::exports(&bytes).map_err(|error| at(library, error))?;
    let target = folder.join(LIBRARY);
    let below = folder.join(GLU_FOLDER);
    for folder in [folder, &below] {
        fs::create_dir_all(folder).map_err(|error| at(folder, error))?;
    }
    replace(&target, &bytes)?;
    for name in &NAMES {
        stand_in(name, folder, links, &bytes, &functions)?;
    }
    stand_in(&GLU, &below, links, &bytes, &functions)?;
    if glu == Glu::Own {
        stand_in(&GLU, folder, links, &bytes, &functions)?;
    }
    let library = match links {
        Links::Symbolic => target.canonicalize().map_err(|error| at(&target, error))?,
        // The folder is to be elsewhere, in LD_LIBRARY_PATH.
        Links::None => LIBRARY.into(),
    };
    replace(&folder.join(VENDOR_FILE), vendor_file(&library).as_bytes())
}

/// The facades of a library in a folder.
fn stand_in(
    name: &Name,
    folder: &Path,
    links: Links,
    library: &[u8],
    functions: &[&str],
) -> io::Result<()> {
    let functions: Vec<&str> = functions.iter().copied().filter(|f| name.has(f)).collect();
    let write = |soname: &str, functions: &[&str]| {
        let path = folder.join(soname);
        let text = facade::write(&Facade { soname, functions }, library)?;
        check_ours(&path)?;
        replace(&path, &text)
    };
    write(name.versioned, &functions)?;
    match links {
        Links::Symbolic => {
            let link = folder.join(name.plain);
            if fs::read_link(&link).is_ok_and(|path| path == Path::new(name.versioned)) {
                return Ok(());
            }
            check_ours(&link)?;
            let fresh = fresh(&link);
            symlink(name.versioned, &fresh).map_err(|error| at(&fresh, error))?;
            fs::rename(&fresh, &link).map_err(|error| at(&link, error))
        }
        // Not for linking, which a SONAME without a version would be wrong for.
        Links::None => write(name.plain, &[]),
    }
}

/// Refuses what is another's library.
fn check_ours(path: &Path) -> io::Result<()> {
    let is_link = fs::read_link(path).is_ok_and(|target| target == Path::new(LIBRARY));
    let Ok(old) = fs::read(path) else { return Ok(()) };
    if is_link || old.windows(LIBRARY.len()).any(|text| text == LIBRARY.as_bytes()) {
        return Ok(());
    }
    Err(at(path, io::Error::new(io::ErrorKind::AlreadyExists, "is there and is not DetGL's")))
}

/// A name for a file that takes the place of another when it is complete.
fn fresh(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.{}", std::process::id()))
}

/// Writes a file, if it is not there with the same bytes. A program that runs on an older one keeps it: the new one is
/// another file.
fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let is_link = fs::symlink_metadata(path).is_ok_and(|data| data.is_symlink());
    if !is_link && fs::read(path).is_ok_and(|old| old == bytes) {
        return Ok(());
    }
    let fresh = fresh(path);
    fs::write(&fresh, bytes).map_err(|error| at(&fresh, error))?;
    fs::rename(&fresh, path).map_err(|error| at(path, error))
}

/// JSON in which the library's path is a string.
fn vendor_file(library: &Path) -> String {
    let path = library.display().to_string().replace('\\', r"\\").replace('"', "\\\"");
    format!(
        "{{\n    \"file_format_version\": \"1.0.0\",\n    \"ICD\": {{ \"library_path\": \"{path}\" }}\n}}\n"
    )
}

/// The folder that `detgl run` has programs load from: where this program was installed with the libraries, and where it
/// was built one beside it, which nobody else writes to.
pub fn folder_for_programs() -> io::Result<PathBuf> {
    let program = env::current_exe()?.canonicalize()?;
    let beside = program.parent().unwrap_or(Path::new("."));
    for folder in [beside, &beside.join("../lib")] {
        if [LIBRARY, NAMES[0].versioned].iter().all(|name| folder.join(name).is_file()) {
            return folder.canonicalize();
        }
    }
    let folder = beside.join("detgl-libraries");
    install(&folder, Glu::System, Links::Symbolic, None)?;
    Ok(folder)
}

/// The folders for LD_LIBRARY_PATH, of one in which the libraries are.
pub fn search_path(folder: &Path, glu: Glu) -> Vec<PathBuf> {
    match glu {
        Glu::System => vec![folder.to_owned()],
        Glu::Own => vec![folder.join(GLU_FOLDER), folder.to_owned()],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::os::unix::fs::MetadataExt;

    /// A library that has what the table of names looks for.
    fn library(functions: &[&str]) -> Vec<u8> {
        let model = fs::read(env::current_exe().expect("this program")).expect("an ELF file");
        facade::write(&Facade { soname: LIBRARY, functions }, &model).expect("written")
    }

    #[test]
    fn the_same_library_is_not_replaced() {
        let place = env::temp_dir().join(format!("detgl-layout-{}", std::process::id()));
        let (source, folder) = (place.join(LIBRARY), place.join("libraries"));
        fs::create_dir_all(&place).expect("a folder");
        let laid_out = |functions: &[&str]| {
            let bytes = library(functions);
            fs::write(&source, &bytes).expect("written");
            lay_out(&source, &folder, Glu::Own, Links::Symbolic).expect("laid out");
            assert_eq!(fs::read(folder.join(LIBRARY)).expect("there"), bytes);
            let files =
                [LIBRARY, "libGL.so", VENDOR_FILE].map(|name| fs::metadata(folder.join(name)));
            files.map(|file| file.map(|file| (file.ino(), file.mtime_nsec())).expect("there"))
        };
        let first = laid_out(&["glOne"]);
        assert_eq!(laid_out(&["glOne"]), first);
        assert_ne!(laid_out(&["glOne", "glTwo"])[0], first[0]);
        fs::write(folder.join("libGL.so.1"), "another's").expect("written");
        let refused = lay_out(&source, &folder, Glu::Own, Links::Symbolic).expect_err("refused");
        assert!(
            refused.to_string().contains("libGL.so.1: is there and is not DetGL's"),
            "{refused}"
        );
        fs::remove_dir_all(&place).expect("removed");
    }

    #[test]
    fn each_facade_has_the_functions_of_its_library() {
        let functions = ["OSMesaMakeCurrent", "eglBindAPI", "glEnable", "glXWaitX", "gluSphere"];
        let library = library(&functions);
        let exports = facade::exports(&library).expect("readable");
        assert_eq!(exports, functions);
        let of = |name: &Name| -> Vec<&str> {
            exports.iter().copied().filter(|f| name.has(f)).collect()
        };
        let all = NAMES.iter().chain([&GLU]).map(of).collect::<Vec<_>>();
        assert_eq!(
            all,
            [
                vec!["eglBindAPI"],
                vec!["glEnable", "glXWaitX"],
                vec!["glEnable"],
                vec!["glEnable"],
                vec!["OSMesaMakeCurrent", "glEnable"],
                vec!["gluSphere"],
            ]
        );
    }
}
