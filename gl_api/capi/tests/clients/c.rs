//! C: untouched lecture code, GLU's quadrics, fork, threads, exit and unloading.

use super::picture::Picture;
use super::{demon, detgl, folder, run, skip, source};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Whose libraries a program is linked with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Against {
    Ours,
    Systems,
}

/// Compiles a program with the system's headers; says why it cannot be.
fn compile(
    test: &str,
    folder: &Path,
    name: &str,
    against: Against,
    libraries: &[&str],
) -> Option<PathBuf> {
    let libs = folder.join("lib");
    run(detgl().arg("install").arg(&libs)).expect("the library was built beside detgl");
    let program = folder.join(name);
    let mut compiler = Command::new("cc");
    compiler.arg(source(&format!("{name}.c"))).arg("-o").arg(&program);
    compiler.arg("-std=c99").arg("-D_GNU_SOURCE").arg("-I").arg(folder);
    if against == Against::Ours {
        compiler.arg("-L").arg(&libs);
    }
    // A library that a library needs is found when the program runs.
    compiler.args(libraries).args(["-lm", "-Wl,--allow-shlib-undefined"]);
    match run(&mut compiler) {
        Ok(_) => Some(program),
        Err(said) => {
            let missing = ["No such file or directory", "cannot find -l", "unable to find library"];
            let missing = said.lines().find(|line| missing.iter().any(|text| line.contains(text)));
            let missing = missing.unwrap_or_else(|| panic!("{said}"));
            skip(test, missing);
            None
        }
    }
}

/// The lecture's header, with texels for it.
fn write_lecture(folder: &Path) {
    let mut text = String::new();
    for row in demon::image().chunks(16) {
        row.iter().for_each(|texel| write!(text, "{texel},").expect("a String takes all"));
        text.push('\n');
    }
    std::fs::write(folder.join("demon_image.h"), text).expect("the folder is writable");
}

/// The picture of a program that takes a file as its argument.
fn picture(program: &Path, options: &[&str]) -> Picture {
    let out = program.with_extension("ppm");
    let mut command = detgl();
    command.arg("run").args(options).arg("--").arg(program).arg(&out);
    run(&mut command).unwrap_or_else(|said| panic!("{said}"));
    Picture::read(&out)
}

#[test]
fn lecture_code_as_printed_draws_what_our_own_functions_draw() {
    let test = "lecture_code_as_printed";
    let folder = folder(test);
    write_lecture(&folder);
    let Some(program) = compile(test, &folder, "demon", Against::Ours, &["-lGLU", "-lGL", "-lEGL"])
    else {
        return;
    };
    let ours = demon::lecture();
    assert!(ours.colors() > 100);
    // With the system's libGLU on top, and with ours.
    for options in [&[][..], &["--glu"]] {
        let theirs = picture(&program, options);
        let distance = ours.distance(&theirs);
        assert!(ours == theirs, "{options:?}: {distance:?}");
    }
}

#[test]
fn quadrics_look_as_libglu_draws_them() {
    let test = "quadrics";
    let folder = folder(test);
    let Some(program) =
        compile(test, &folder, "quadrics", Against::Ours, &["-lGLU", "-lGL", "-lEGL"])
    else {
        return;
    };
    let (theirs, ours) = (picture(&program, &[]), picture(&program, &["--glu"]));
    assert!(ours.colors() > 100);
    // libGLU computes angles in f32: edges, and texels at them, move by a pixel.
    let distance = ours.distance(&theirs);
    assert!(distance.mean < 0.2 && distance.visible < 0.004, "{distance:?}");
}

fn lives(test: &str, how: &str) {
    let folder = folder(test);
    let Some(program) =
        compile(test, &folder, "lifetimes", Against::Ours, &["-lGL", "-lEGL", "-lpthread"])
    else {
        return;
    };
    let mut command = detgl();
    command.args(["run", "--"]).arg(&program).arg(how).env("DETGL_THREADS", "4");
    run(&mut command).unwrap_or_else(|said| panic!("{said}"));
}

#[test]
fn a_forked_process_draws_on() {
    lives("fork", "fork");
}

#[test]
fn a_program_may_exit_with_a_context_current() {
    lives("exit", "exit");
}

#[test]
fn what_runs_after_main_may_draw() {
    lives("atexit", "atexit");
}

#[test]
fn a_context_is_one_threads() {
    lives("thread", "thread");
}

#[test]
fn variables_of_gls_names_are_the_programs_own() {
    let test = "pointers";
    let folder = folder(test);
    if let Some(program) = compile(test, &folder, "pointers", Against::Ours, &["-lGL", "-lEGL"]) {
        let mut command = detgl();
        run(command.args(["run", "--"]).arg(&program)).unwrap_or_else(|said| panic!("{said}"));
    }
}

#[test]
fn a_linked_program_needs_the_names_that_other_drivers_have() {
    let test = "sonames";
    let folder = folder(test);
    if let Some(program) = compile(test, &folder, "pointers", Against::Ours, &["-lGL", "-lEGL"]) {
        let bytes = std::fs::read(program).expect("it was written");
        let has = |text: &[u8]| bytes.windows(text.len()).any(|window| window == text);
        for (name, is_there) in
            [(&b"\0libGL.so.1\0"[..], true), (b"\0libEGL.so.1\0", true), (b"libdetgl", false)]
        {
            assert_eq!(has(name), is_there, "{}", String::from_utf8_lossy(name));
        }
    }
}

#[test]
fn the_systems_libegl_finds_the_library_as_a_vendor() {
    let test = "vendor";
    let folder = folder(test);
    write_lecture(&folder);
    let Some(program) =
        compile(test, &folder, "demon", Against::Systems, &["-lGLU", "-lGL", "-lEGL"])
    else {
        return;
    };
    let out = folder.join("vendor.ppm");
    let mut command = Command::new(&program);
    command.arg(&out).env("__EGL_VENDOR_LIBRARY_FILENAMES", folder.join("lib/egl_vendor.json"));
    match run(command.env_remove("LD_LIBRARY_PATH")) {
        Ok(_) => assert!(Picture::read(&out) == demon::lecture()),
        Err(said) if said.contains("cannot open shared object file") => skip(test, &said),
        Err(said) => panic!("{said}"),
    }
}

#[test]
fn the_library_may_be_unloaded_while_its_context_is_current() {
    let test = "unload";
    let folder = folder(test);
    if let Some(program) = compile(test, &folder, "unload", Against::Ours, &["-ldl"]) {
        let mut command = detgl();
        run(command.args(["run", "--"]).arg(&program)).unwrap_or_else(|said| panic!("{said}"));
    }
}
