//! Python: PyOpenGL and MuJoCo, on EGL and on OSMesa.

use super::picture::Picture;
use super::{demon, detgl, folder, python_program, run, skip, source};
use std::path::Path;
use std::process::Command;

/// Whether Python has some modules; says so if not.
pub fn has(test: &str, modules: &str) -> bool {
    let mut command = Command::new(python_program());
    match run(command.arg("-c").arg(format!("import {modules}"))) {
        Ok(_) => true,
        Err(said) => {
            skip(test, &said);
            false
        }
    }
}

#[test]
fn pyopengl_draws_what_our_own_functions_draw() {
    let test = "pyopengl";
    if !has(test, "OpenGL") {
        return;
    }
    let folder = folder(test);
    let image = folder.join("image.raw");
    std::fs::write(&image, demon::image()).expect("the folder is writable");
    let ours = demon::decal_and_shader();
    for platform in ["egl", "osmesa"] {
        let out = folder.join(platform).with_extension("ppm");
        let mut command = detgl();
        // PyOpenGL finds GLU only where libGLU.so is: with a C compiler's files, or here.
        command.args(["run", "--glu", "--"]).arg(python_program()).arg(source("pyopengl.py"));
        command.args([&image, &out]).env("PYOPENGL_PLATFORM", platform);
        run(&mut command).unwrap_or_else(|said| panic!("{said}"));
        let theirs = Picture::read(&out);
        let distance = ours.distance(&theirs);
        assert!(ours == theirs, "{platform}: {distance:?}");
    }
}

/// MuJoCo's scene, drawn by whatever `command` ends with.
fn mujoco(mut command: Command, platform: &str, out: &Path) -> Result<Picture, String> {
    command.arg(source("mujoco_scene.py")).arg(out).args(["320", "240"]);
    run(command.env("MUJOCO_GL", platform))?;
    Ok(Picture::read(out))
}

#[test]
fn mujoco_looks_as_on_mesa() {
    let test = "mujoco";
    if !has(test, "mujoco") {
        return;
    }
    let folder = folder(test);
    let mut before: Option<Picture> = None;
    for platform in ["egl", "osmesa"] {
        let mut command = detgl();
        command.args(["run", "--"]).arg(python_program());
        let ours = mujoco(command, platform, &folder.join(platform).with_extension("ppm"));
        let ours = ours.unwrap_or_else(|said| panic!("{said}"));
        assert!(ours.colors() > 1000);
        if let Some(before) = &before {
            assert!(ours == *before, "EGL and OSMesa differ: {:?}", ours.distance(before));
        }
        let out = folder.join(format!("mesa-{platform}.ppm"));
        match mujoco(Command::new(python_program()), platform, &out) {
            Ok(theirs) => {
                // The two differ in the last bits of shadow maps, where a surface shadows itself.
                let distance = ours.distance(&theirs);
                assert!(distance.mean < 1.0 && distance.visible < 0.03, "{platform}: {distance:?}");
            }
            Err(said) => skip(&format!("{test}: comparison with Mesa's {platform}"), &said),
        }
        before = Some(ours);
    }
}
