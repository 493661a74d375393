//! What Python programs draw with: vispy, Panda3D, pyglet, Kivy, pygame, ModernGL. Each draws a picture
//! with what is its own, on DetGL and on Mesa's llvmpipe, and the two are compared.

use super::picture::Picture;
use super::python::has;
use super::{detgl, folder, python_program, run, skip, source};
use std::path::Path;
use std::process::Command;

/// A script of `frameworks/` and how far its picture may be from Mesa's.
struct Client {
    script: &'static str,
    /// What must be installed, as Python imports it.
    modules: &'static str,
    /// Colours there must be at least: not every picture with the right background is one.
    colors: usize,
    /// The mean difference of a component, in 255ths.
    mean: f64,
    /// The share of pixels that may differ visibly.
    visible: f64,
}

/// Runs the script by whatever `command` ends with.
fn draw(command: &mut Command, script: &str, out: &Path) -> Result<Picture, String> {
    command.arg(source("frameworks").join(script)).arg(out);
    command.env("PYTHONDONTWRITEBYTECODE", "1");
    run(command)?;
    Ok(Picture::read(out))
}

fn looks_as_on_mesa(client: &Client) {
    let Client { script, modules, colors, mean, visible } = *client;
    if !has(script, modules) {
        return;
    }
    let folder = folder(script);
    let mut command = detgl();
    command.args(["run", "--glu", "--"]).arg(python_program());
    let ours = draw(&mut command, script, &folder.join("detgl.ppm"));
    let ours = ours.unwrap_or_else(|said| panic!("{said}"));
    assert!(ours.colors() >= colors, "{} colours", ours.colors());
    let mut command = Command::new(python_program());
    command.env("EGL_PLATFORM", "surfaceless").env("LIBGL_ALWAYS_SOFTWARE", "1");
    match draw(command.env("PYOPENGL_PLATFORM", "egl"), script, &folder.join("mesa.ppm")) {
        Ok(theirs) => {
            let distance = ours.distance(&theirs);
            assert!(distance.mean < mean && distance.visible < visible, "{distance:?}");
        }
        Err(said) => skip(&format!("{script}: comparison with Mesa"), &said),
    }
}

#[test]
fn vispy() {
    looks_as_on_mesa(&Client {
        script: "vispy_scenes.py",
        modules: "vispy, OpenGL",
        colors: 1000,
        mean: 0.1,
        visible: 0.001,
    });
}

#[test]
fn panda3d() {
    // Fog far away differs: llvmpipe's is that of vertices.
    looks_as_on_mesa(&Client {
        script: "panda3d_scene.py",
        modules: "panda3d.core",
        colors: 10_000,
        mean: 1.0,
        visible: 0.002,
    });
}

#[test]
fn pyglet() {
    // Mesa gives it a configuration of 16 bits.
    looks_as_on_mesa(&Client {
        script: "pyglet_batch.py",
        modules: "pyglet; assert pyglet.version < '2'",
        colors: 100,
        mean: 3.0,
        visible: 0.001,
    });
}

#[test]
fn kivy() {
    looks_as_on_mesa(&Client {
        script: "kivy_window.py",
        modules: "kivy",
        colors: 100,
        mean: 0.3,
        visible: 0.005,
    });
}

#[test]
fn pygame() {
    looks_as_on_mesa(&Client {
        script: "pygame_sphere.py",
        modules: "pygame, OpenGL",
        colors: 100,
        mean: 0.5,
        visible: 0.001,
    });
}

#[test]
fn moderngl() {
    looks_as_on_mesa(&Client {
        script: "moderngl_particles.py",
        modules: "moderngl, glcontext",
        colors: 100,
        mean: 0.1,
        visible: 0.001,
    });
}
