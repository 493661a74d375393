//! What programs draw with: vispy, Panda3D, pyglet, Kivy, pygame, ModernGL, pyrender, VTK, PyVista, Arcade, LÖVE,
//! SDL with OpenGL ES, raylib, PyBullet, wgpu, Skia, Dear ImGui, Open3D, Weston.
//! Each draws a picture with what is its own, on DetGL and on Mesa's llvmpipe, and the two are compared.

use super::picture::Picture;
use super::python::has;
use super::{detgl, folder, python_program, run, skip, source};
use std::ffi::OsString;
use std::path::Path;
use std::process::Command;

/// What must be true of a picture, and how far it may be from Mesa's.
struct Limits {
    /// Colours there must be at least: not every picture with the right background is one.
    colors: usize,
    /// The mean difference of a component, in 255ths.
    mean: f64,
    /// The share of pixels that may differ visibly.
    visible: f64,
}

/// Runs a program, which is told where to write its picture.
fn draw(command: &mut Command, out: &Path) -> Result<Picture, String> {
    // Without a window and without sound, whatever it would like to have.
    command.envs([("SDL_VIDEODRIVER", "offscreen"), ("SDL_AUDIODRIVER", "dummy")]);
    run(command.arg(out).env("PYTHONDONTWRITEBYTECODE", "1"))?;
    Ok(Picture::read(out))
}

/// `program` with its arguments, as it is run on any driver.
fn looks_as_on_mesa(test: &str, program: &[OsString], limits: &Limits) {
    let folder = folder(test);
    let mut command = detgl();
    command.args(["run", "--glu", "--"]).args(program);
    let ours = draw(&mut command, &folder.join("detgl.ppm"));
    let ours = ours.unwrap_or_else(|said| panic!("{said}"));
    assert!(ours.colors() >= limits.colors, "{} colours", ours.colors());
    let mut command = Command::new(&program[0]);
    command.args(&program[1..]).env("PYOPENGL_PLATFORM", "egl");
    command.env("EGL_PLATFORM", "surfaceless").env("LIBGL_ALWAYS_SOFTWARE", "1");
    match draw(&mut command, &folder.join("mesa.ppm")) {
        Ok(theirs) => {
            let distance = ours.distance(&theirs);
            let is_near = distance.mean < limits.mean && distance.visible < limits.visible;
            assert!(is_near, "{distance:?}");
        }
        Err(said) => skip(&format!("{test}: comparison with Mesa"), &said),
    }
}

/// A script of `frameworks/`, which needs some modules, as Python imports them.
fn script_looks_as_on_mesa(script: &str, modules: &str, limits: &Limits) {
    if has(script, modules) {
        let program = [python_program(), source("frameworks").join(script).into()];
        looks_as_on_mesa(script, &program, limits);
    }
}

#[test]
fn vispy() {
    let limits = Limits { colors: 1000, mean: 0.1, visible: 0.001 };
    script_looks_as_on_mesa("vispy_scenes.py", "vispy, OpenGL", &limits);
}

#[test]
fn panda3d() {
    // llvmpipe's fog is that of vertices, ours that of fragments.
    let limits = Limits { colors: 10_000, mean: 1.0, visible: 0.002 };
    script_looks_as_on_mesa("panda3d_scene.py", "panda3d.core", &limits);
}

#[test]
fn pyglet() {
    // Mesa gives it a configuration of 16 bits.
    let limits = Limits { colors: 100, mean: 3.0, visible: 0.001 };
    let modules = "pyglet; assert pyglet.version < '2', 'pyglet 1.5 is the last for OpenGL 2'";
    script_looks_as_on_mesa("pyglet_batch.py", modules, &limits);
}

#[test]
fn kivy() {
    let limits = Limits { colors: 100, mean: 0.3, visible: 0.005 };
    script_looks_as_on_mesa("kivy_window.py", "kivy", &limits);
}

#[test]
fn pygame() {
    let limits = Limits { colors: 100, mean: 0.5, visible: 0.001 };
    script_looks_as_on_mesa("pygame_sphere.py", "pygame, OpenGL", &limits);
}

/// OpenGL ES 3.0. Random blocks of ETC2 differ where the two choose another texel.
#[test]
fn sdl_of_opengl_es() {
    let limits = Limits { colors: 10_000, mean: 0.8, visible: 0.002 };
    script_looks_as_on_mesa("sdl_es.py", "sdl2, OpenGL.GLES3", &limits);
}

#[test]
fn moderngl() {
    let limits = Limits { colors: 100, mean: 0.1, visible: 0.001 };
    script_looks_as_on_mesa("moderngl_particles.py", "moderngl, glcontext", &limits);
}

#[test]
fn moderngl_of_3_3() {
    let limits = Limits { colors: 1000, mean: 0.1, visible: 0.001 };
    script_looks_as_on_mesa("moderngl_core.py", "moderngl, glcontext", &limits);
}

/// What ModernGL's examples show, in the window without a screen that they can ask for.
#[test]
fn moderngl_window() {
    let limits = Limits { colors: 1000, mean: 0.3, visible: 0.001 };
    script_looks_as_on_mesa("moderngl_window_scene.py", "moderngl_window, numpy", &limits);
}

#[test]
fn pyrender() {
    let limits = Limits { colors: 100, mean: 0.1, visible: 0.001 };
    script_looks_as_on_mesa("pyrender_shadows.py", "pyrender, trimesh", &limits);
}

#[test]
fn vtk() {
    // The colour of its background lies where the two round apart.
    let limits = Limits { colors: 1000, mean: 0.6, visible: 0.001 };
    let modules = "vtk; assert hasattr(vtk, 'vtkEGLRenderWindow'), 'this vtk has no EGL window'";
    script_looks_as_on_mesa("vtk_scene.py", modules, &limits);
}

#[test]
fn pyvista() {
    let limits = Limits { colors: 500, mean: 0.5, visible: 0.001 };
    script_looks_as_on_mesa("pyvista_ssao.py", "pyvista", &limits);
}

/// Without a display its legacy visualizer draws by EGL.
#[test]
fn open3d() {
    let limits = Limits { colors: 1000, mean: 0.5, visible: 0.001 };
    script_looks_as_on_mesa("open3d_legacy.py", "open3d", &limits);
}

#[test]
fn pyglet_2() {
    // Mesa gives it a configuration of 16 bits.
    let limits = Limits { colors: 5, mean: 1.0, visible: 0.001 };
    let modules = "pyglet; assert pyglet.version >= '2', 'pyglet 2 is the first for OpenGL 3.3'";
    script_looks_as_on_mesa("pyglet2_batch.py", modules, &limits);
}

#[test]
fn arcade() {
    // Mesa gives it a configuration of 16 bits.
    let limits = Limits { colors: 5, mean: 1.0, visible: 0.003 };
    script_looks_as_on_mesa("arcade_shapes.py", "arcade", &limits);
}

#[test]
fn panda3d_of_3_2() {
    let limits = Limits { colors: 10, mean: 0.5, visible: 0.002 };
    script_looks_as_on_mesa("panda3d_core.py", "panda3d.core", &limits);
}

/// Its window is of GLFW's null platform. Texels that are taken half-way between two differ in the small picture.
#[test]
fn raylib() {
    let limits = Limits { colors: 1000, mean: 0.2, visible: 0.002 };
    script_looks_as_on_mesa("raylib_window.py", "raylib", &limits);
}

/// Mesa 22.3.6 loses what is drawn to a depth texture after `glGenerateMipmap`, as PyBullet does: the shadows differ.
#[test]
fn pybullet() {
    let limits = Limits { colors: 400, mean: 0.6, visible: 0.02 };
    let modules = "pybullet, importlib.util; assert importlib.util.find_spec('eglRenderer'), 'no eglRenderer'";
    script_looks_as_on_mesa("pybullet_camera.py", modules, &limits);
}

/// Its backend of OpenGL ES.
#[test]
fn wgpu() {
    let limits = Limits { colors: 5000, mean: 0.3, visible: 0.001 };
    script_looks_as_on_mesa("wgpu_gl.py", "wgpu", &limits);
}

#[test]
fn skia() {
    let limits = Limits { colors: 3000, mean: 0.2, visible: 0.001 };
    script_looks_as_on_mesa("skia_surface.py", "skia, moderngl, glcontext", &limits);
}

#[test]
fn imgui() {
    let limits = Limits { colors: 500, mean: 0.5, visible: 0.001 };
    script_looks_as_on_mesa("imgui_windows.py", "imgui, moderngl, glcontext, OpenGL", &limits);
}

/// A compositor: its GL renderer on OpenGL ES, and a client that it shows.
#[test]
fn weston() {
    if let Err(said) = run(Command::new("weston").arg("--version")) {
        return skip("weston", &said);
    }
    let limits = Limits { colors: 1000, mean: 0.1, visible: 0.001 };
    let program = [python_program(), source("frameworks").join("weston_desktop.py").into()];
    looks_as_on_mesa("weston", &program, &limits);
}

#[test]
fn love() {
    if let Err(said) = run(Command::new("love").arg("--version")) {
        return skip("love", &said);
    }
    let limits = Limits { colors: 1000, mean: 0.5, visible: 0.001 };
    let program = ["love".into(), source("love").into()];
    looks_as_on_mesa("love", &program, &limits);
}
