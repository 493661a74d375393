//! The chain of spaces: texture, object, world, camera, image; one point of the texture goes through all.
//!
//! *eScience*, slides 7 and 8. From left to right: the point's texel in the array (s, t); on the object, a bent sheet,
//! at (u, v), whose (x, y, z) are the object's; in the world, where the object stands and a camera looks at it;
//! in the camera's frame, whose origin is the eye; and its pixel in the image. Texture scanning follows the arrows
//! to the right, a texel at a time; inverse scanning goes from a pixel to the left.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use examples::wire::{draw_axes, draw_frustum, draw_ground, through};
use gl_api::glu::angle::sin_cos_degrees;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "spaces",
    lecture: "eScience: slides 7 and 8, texture, object and image space",
    source: include_str!("spaces.rs"),
    halves: [10, 2],
    panels: &["texture space", "object space", "world space", "camera space", "image space"],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// The point, as texture coordinates.
const POINT: [f64; 2] = [0.72, 0.65];
const IMAGE: GLsizei = 24;
const INK: [f32; 3] = [0.08, 0.10, 0.25];
const GREEN: [f32; 3] = [0.10, 0.95, 0.30];

/// The bent sheet: a third of a cylinder.
fn sheet(s: f64, t: f64) -> (DVec3, DVec3) {
    let (sin, cos) = sin_cos_degrees(120. * (s - 0.5));
    (dvec3(sin, 2. * t - 1., cos - 0.7), dvec3(sin, 0., cos))
}

fn draw(window: &mut Window) {
    let texture = load_texture(0, window.picture("demon_image.h"), GL_CLAMP_TO_EDGE);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    let object = Mesh::surface(32, 1, sheet).upload();
    let (point, _) = sheet(POINT[0], POINT[1]);
    let model = translate(0.6, 1.1, -0.4) * rotate(-35., DVec3::Y);
    let camera = look_at(dvec3(-0.6, 2.0, 4.2), dvec3(0.5, 1.0, 0.));
    let projection = perspective(38., 1., 1.6, 6.5);

    // The image, of few pixels.
    glClearColor(0.55, 0.68, 0.85, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glViewport(0, 0, IMAGE, IMAGE);
    draw_object(&object, &(projection * camera * model));
    let image = copy_window(IMAGE);

    glClearColor(0.95, 0.95, 0.91, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    show_square(window, 0, texture, [2. * POINT[0] - 1., 2. * POINT[1] - 1.]);
    say(window, &format!("s, t = {:.2}, {:.2}", POINT[0], POINT[1]));

    glBindTexture(GL_TEXTURE_2D, texture);
    let far = |eye: DVec3, middle: DVec3| perspective(40., 1., 0.1, 40.) * look_at(eye, middle);
    let in_world = model.transform_point3(point);
    let in_camera = camera.transform_point3(in_world);
    let over = far(dvec3(-6.5, 5.0, 5.0), dvec3(0.2, 0.9, 1.4));
    let beside = far(dvec3(-6.5, 3.0, 3.5), dvec3(0., -0.2, -2.3));
    let frustum = projection.inverse();
    for (panel, view, place, at, lines) in [
        (1, far(dvec3(-2.2, 1.9, 4.0), DVec3::ZERO), DMat4::IDENTITY, point, None),
        (2, over, model, in_world, Some(camera.inverse() * frustum)),
        (3, beside, camera * model, in_camera, Some(frustum)),
    ] {
        window.panel(5, 1, panel);
        if panel == 2 {
            draw_ground(&view);
        }
        draw_object(&object, &(view * place));
        if let Some(frustum) = lines {
            draw_frustum(&(view * frustum));
        }
        draw_axes(&view);
        mark(window, &view, at);
        say(window, &format!("x, y, z = {:.1}, {:.1}, {:.1}", at.x, at.y, at.z));
    }

    let seen = projection.project_point3(in_camera);
    show_square(window, 4, image, [seen.x, seen.y]);
    let pixel = |x: f64| ((x + 1.) / 2. * f64::from(IMAGE)) as i32;
    say(window, &format!("pixel {}, {}", pixel(seen.x), pixel(seen.y)));
    glViewport(0, 0, window.width, window.height);
    for (at, step) in (-2..3).zip(["surface (u, v)", "model", "view", "projection"]) {
        let x = 0.4 * f64::from(at) + 0.2;
        window.label(x, 0.93, INK, &format!("← {step} →"));
    }
}

/// A texture with the point on it, in the upper part of a panel.
fn show_square(window: &mut Window, panel: i32, texture: GLuint, [x, y]: [f64; 2]) {
    window.panel(5, 1, panel);
    let side = window.height;
    glViewport(panel * side + side / 8, side / 5, side * 3 / 4, side * 3 / 4);
    show_flat(texture);
    mark(window, &DMat4::IDENTITY, dvec3(0.92 * x, 0.92 * y, 0.));
    window.panel(5, 1, panel);
}

fn say(window: &Window, text: &str) {
    window.label(0., -0.76, [0.05, 0.40, 0.15], text);
}

fn draw_object(object: &Model, matrix: &DMat4) {
    through(matrix, [1.; 3]);
    glEnable(GL_TEXTURE_2D);
    object.draw_fixed();
}

fn mark(window: &Window, view: &DMat4, at: DVec3) {
    glDisable(GL_DEPTH_TEST);
    for (size, color) in [(window.height / 46, INK), (window.height / 80, GREEN)] {
        through(view, color);
        glPointSize(size.max(1));
        glBegin(GL_POINTS);
        glVertex3d(at.x, at.y, at.z);
        glEnd();
    }
    glEnable(GL_DEPTH_TEST);
}
