//! What programs load in the place of DetGL or of another driver, and why: the first thing of a report of a bug.

use super::layout::{self, NAMES};
use super::{Glu, run};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io};

/// Variables that decide about what is loaded, or how DetGL works.
const VARIABLES: [&str; 8] =
    ["DETGL_", "EGL_", "__EGL_", "LIBGL_", "GALLIUM_", "MESA_", "PYOPENGL_", "MUJOCO_"];
const NAMES_OF_VARIABLES: [&str; 6] = [
    "LD_LIBRARY_PATH",
    "LD_PRELOAD",
    "DISPLAY",
    "WAYLAND_DISPLAY",
    "SDL_VIDEODRIVER",
    "VIRTUAL_ENV",
];

/// Where the loader looks last, if no cache has the name.
const LAST_FOLDERS: [&str; 4] = ["/lib64", "/usr/lib64", "/lib", "/usr/lib"];

/// Where libglvnd's libEGL finds drivers.
const VENDOR_FOLDERS: [&str; 2] = ["/etc/glvnd/egl_vendor.d", "/usr/share/glvnd/egl_vendor.d"];

/// Prints everything.
pub fn report() -> io::Result<()> {
    println!("DetGL: {}", detgl::info().trim_end().replace('\n', ", "));
    println!("libraries: {}", layout::folder_for_programs()?.display());
    environment();
    order();
    vendors();
    let program = env::current_exe()?;
    let child = |task| {
        let mut command = Command::new(&program);
        command.arg(task);
        command
    };
    println!("\na program that is started as it is loads");
    show(child("probe"))?;
    println!("\na program that `detgl run` starts loads");
    let mut command = child("probe");
    run::prepare(&mut command, Glu::System)?;
    show(command)
}

/// What a process prints, if it survives.
fn show(mut command: Command) -> io::Result<()> {
    let output = command.output()?;
    print!("{}", String::from_utf8_lossy(&output.stdout));
    if !output.status.success() {
        println!("  the driver ended the process: {}", output.status);
    }
    for line in String::from_utf8_lossy(&output.stderr).lines() {
        println!("  it says: {line}");
    }
    Ok(())
}

fn environment() {
    println!("\nenvironment");
    let mut found: Vec<_> = env::vars_os()
        .filter_map(|(name, value)| {
            let name = name.into_string().ok()?;
            let is_of = VARIABLES.iter().any(|prefix| name.starts_with(prefix))
                || NAMES_OF_VARIABLES.contains(&name.as_str());
            is_of.then(|| format!("  {name}={}", value.display()))
        })
        .collect();
    found.sort();
    if found.is_empty() {
        found.push("  no variable that matters is set".to_owned());
    }
    println!("{}", found.join("\n"));
}

/// Prints every file that the loader could take for a name, in its order: the first shadows the others.
fn order() {
    println!("\nthe loader's order, after LD_PRELOAD and a program's own RPATH or RUNPATH");
    let cache = cache();
    for name in NAMES.map(|name| name.versioned) {
        let mut seen = BTreeSet::new();
        let mut place = 0;
        for (path, whence) in candidates(name, &cache) {
            let file = path.canonicalize().unwrap_or_else(|_| path.clone());
            if path.exists() && seen.insert(file) {
                place += 1;
                let shadowed = if place > 1 { ", shadowed" } else { "" };
                println!("  {name:<15} {place}. {} ({whence}{shadowed})", path.display());
            }
        }
        if place == 0 {
            println!("  {name:<15} in no folder");
        }
    }
}

fn candidates(name: &str, cache: &[(String, PathBuf)]) -> Vec<(PathBuf, &'static str)> {
    let listed = env::var_os("LD_LIBRARY_PATH").unwrap_or_default();
    let folders = env::split_paths(&listed).filter(|path| !path.as_os_str().is_empty());
    let mut found: Vec<_> = folders.map(|folder| (folder.join(name), "LD_LIBRARY_PATH")).collect();
    let cached = cache.iter().filter(|(known, _)| known == name);
    found.extend(cached.map(|(_, path)| (path.clone(), "ld.so.cache")));
    let last = LAST_FOLDERS.iter().map(|folder| Path::new(folder).join(name));
    found.extend(last.map(|path| (path, "the system's folders")));
    found
}

/// Names and files of `/etc/ld.so.cache`, of programs of this kind.
fn cache() -> Vec<(String, PathBuf)> {
    let tools = ["/sbin/ldconfig", "/usr/sbin/ldconfig", "ldconfig"];
    let output = tools.iter().find_map(|tool| Command::new(tool).arg("-p").output().ok());
    let Some(output) = output else { return Vec::new() };
    let is_wide = cfg!(target_pointer_width = "64");
    let text = String::from_utf8_lossy(&output.stdout);
    let lines = text.lines().filter_map(|line| {
        let (name, path) = line.trim().split_once(" => ")?;
        let (name, kind) = name.split_once(' ')?;
        let is_64 = kind.contains("64");
        (is_64 == is_wide).then(|| (name.to_owned(), PathBuf::from(path)))
    });
    lines.collect()
}

/// Prints the vendor files of libglvnd.
fn vendors() {
    println!("\ndrivers that a libEGL of libglvnd knows");
    let named = env::var_os("__EGL_VENDOR_LIBRARY_FILENAMES");
    let mut files: Vec<PathBuf> = match &named {
        Some(named) => env::split_paths(named).collect(),
        None => VENDOR_FOLDERS
            .iter()
            .filter_map(|folder| fs::read_dir(folder).ok())
            .flat_map(|entries| entries.filter_map(|entry| Some(entry.ok()?.path())))
            .collect(),
    };
    files.sort_by_key(|path| path.file_name().map(ToOwned::to_owned));
    for file in &files {
        let text = fs::read_to_string(file).unwrap_or_else(|error| error.to_string());
        let library = text.split("\"library_path\"").nth(1).and_then(|rest| rest.split('"').nth(1));
        println!("  {}: {}", file.display(), library.unwrap_or("not readable"));
    }
    if files.is_empty() {
        println!("  none");
    }
}
