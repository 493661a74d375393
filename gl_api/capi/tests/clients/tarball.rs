//! The tarball, as somebody gets it who writes C: unpacked in any folder, found by pkg-config and by CMake.

use super::wheel::root;
use super::{folder, python_program, run, skip, source};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Unpacks a tarball of this library; says why there is none.
fn unpacked(folder: &Path) -> Result<PathBuf, String> {
    let built = Path::new(env!("CARGO_BIN_EXE_detgl")).parent().expect("a folder");
    run(Command::new(python_program()).arg("--version"))?;
    let mut build = Command::new(python_program());
    build.arg(root().join("package/build_tarball.py")).arg("--prebuilt").arg(built);
    build.arg("--compress=1").arg("--out").arg(folder).env("PYTHONDONTWRITEBYTECODE", "1");
    run(&mut build).unwrap_or_else(|said| panic!("{said}"));
    let mut files = std::fs::read_dir(folder).expect("it is there");
    let file = files.next().expect("a tarball").expect("readable").path();
    let place = folder.join("any where");
    std::fs::create_dir(&place).expect("the folder is writable");
    run(Command::new("tar").arg("-xf").arg(file).arg("-C").arg(&place))?;
    Ok(place.join("detgl"))
}

/// What the program says with the tarball's libraries.
fn draws(program: &Path, tree: &Path) {
    let mut command = Command::new(program);
    let output = run(command.env("LD_LIBRARY_PATH", tree.join("lib")));
    let output = output.unwrap_or_else(|said| panic!("{said}"));
    assert_eq!(String::from_utf8_lossy(&output.stdout), "DetGL 255 0 0 255\n");
    let by_command = run(Command::new(tree.join("bin/detgl")).args(["run", "--"]).arg(program));
    assert_eq!(by_command.map(|by_command| by_command.stdout), Ok(output.stdout));
}

#[test]
fn a_program_in_c_is_built_with_the_tarball() {
    let test = "tarball";
    let folder = folder(test);
    let tree = match unpacked(&folder) {
        Ok(tree) => tree,
        Err(said) => return skip(test, &said),
    };
    with_pkg_config(&format!("{test}: pkg-config"), &folder, &tree);
    with_cmake(&format!("{test}: CMake"), &folder, &tree);
}

fn with_pkg_config(test: &str, folder: &Path, tree: &Path) {
    let program = folder.join("draw");
    // pkg-config escapes the space of the folder for a shell.
    let script = r#"eval "cc -Wall -Wextra -pedantic -Werror -std=c99 '$1' -o '$2' $(pkg-config --cflags --libs osmesa)""#;
    let mut command = Command::new("sh");
    command.args(["-c", script, "sh"]).arg(source("osmesa.c")).arg(&program);
    command.env("PKG_CONFIG_PATH", tree.join("lib/pkgconfig"));
    for tool in ["cc", "pkg-config"] {
        if let Err(said) = run(Command::new(tool).arg("--version")) {
            return skip(test, &said);
        }
    }
    run(&mut command).unwrap_or_else(|said| panic!("{said}"));
    draws(&program, tree);
}

/// The packages that projects ask for, and how they are told where the tarball is.
fn with_cmake(test: &str, folder: &Path, tree: &Path) {
    if let Err(said) = run(Command::new("cmake").arg("--version")) {
        return skip(test, &said);
    }
    let opengl = "find_package(OpenGL REQUIRED COMPONENTS EGL OSMesa)";
    let packages = format!("find_package(OSMesa REQUIRED)\nfind_package(DetGL REQUIRED)\n{opengl}");
    let by_packages = ("packages", packages.as_str(), "CMAKE_PREFIX_PATH", "");
    let by_module = ("module", opengl, "CMAKE_MODULE_PATH", "lib/cmake/modules");
    for (name, packages, variable, below) in [by_packages, by_module] {
        let project = folder.join(name);
        std::fs::create_dir(&project).expect("the folder is writable");
        let text = format!(
            "cmake_minimum_required(VERSION 3.13)\nproject(draw C)\n{packages}\n\
             if(NOT OPENGL_egl_LIBRARY MATCHES \"any where\")\n  message(FATAL_ERROR ${{OPENGL_egl_LIBRARY}})\nendif()\n\
             add_executable(draw \"{}\")\ntarget_link_libraries(draw OpenGL::OSMesa)\n",
            source("osmesa.c").display()
        );
        std::fs::write(project.join("CMakeLists.txt"), text).expect("the folder is writable");
        let mut told = std::ffi::OsString::from(format!("-D{variable}="));
        told.push(tree.join(below));
        let build = project.join("build");
        let mut configure = Command::new("cmake");
        configure.arg("-S").arg(&project).arg("-B").arg(&build).arg(told);
        run(&mut configure).unwrap_or_else(|said| panic!("{said}"));
        run(Command::new("cmake").arg("--build").arg(&build))
            .unwrap_or_else(|said| panic!("{said}"));
        draws(&build.join("draw"), tree);
    }
}
