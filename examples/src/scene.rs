//! Scenes that several programs share.

use crate::matrix::{DMat4, DVec3, dvec3, rotate, translate};
use crate::mesh::Mesh;
use crate::picture::noise::hash;
use crate::shader::initShaders;
use crate::texture::{copy_window, set_filter};
use crate::window::Window;
use gl_api::constants::*;
use gl_api::types::GLuint;
use gl_api::*;

/// A ring, a ball in it, and three blocks over a floor.
pub fn ring_and_blocks() -> Mesh {
    let floor = rotate(-90., DVec3::X) * DMat4::from_scale(DVec3::splat(2.4));
    let mut scene = Mesh::plane().moved(floor).colored([0.86, 0.84, 0.80]);
    let ring = translate(0.1, 1.35, 0.1) * rotate(28., DVec3::X) * rotate(14., DVec3::Z);
    scene.append(Mesh::torus(0.26).moved(ring).colored([0.95, 0.55, 0.15]));
    let ball = translate(0.1, 1.35, 0.1) * DMat4::from_scale(DVec3::splat(0.42));
    scene.append(Mesh::sphere().moved(ball).colored([0.25, 0.50, 0.95]));
    for (x, z, degrees, side, color) in [
        (1.6, 1.2, 20., 0.32, [0.80, 0.25, 0.30]),
        (1.4, -1.4, 50., 0.45, [0.35, 0.75, 0.45]),
        (-1.7, 1.5, 75., 0.36, [0.70, 0.45, 0.85]),
    ] {
        let place = translate(x, side, z) * rotate(degrees, DVec3::Y);
        let block = Mesh::cube().moved(place * DMat4::from_scale(DVec3::splat(side)));
        scene.append(block.colored(color));
    }
    scene
}

/// A ball and a block on a floor.
pub fn ball_and_block() -> Mesh {
    let floor = rotate(-90., DVec3::X) * DMat4::from_scale(DVec3::splat(1.9));
    let mut scene = Mesh::plane().moved(floor).colored([0.9, 0.87, 0.8]);
    let ball = translate(-0.5, 0.5, 0.2) * DMat4::from_scale(DVec3::splat(0.5));
    scene.append(Mesh::sphere().moved(ball).colored([0.9, 0.45, 0.25]));
    let block = translate(0.7, 0.4, -0.5) * rotate(30., DVec3::Y);
    let block = Mesh::cube().moved(block * DMat4::from_scale(DVec3::splat(0.4)));
    scene.append(block.colored([0.35, 0.6, 0.9]));
    scene
}

/// Two walls and a floor that meet in a corner, a ball and a box.
pub fn room_corner() -> Mesh {
    let wide = DMat4::from_scale(DVec3::splat(4.));
    let mut room = Mesh::plane().moved(translate(2., 4., -2.) * wide).colored([0.9, 0.88, 0.85]);
    let floor = translate(2., 0., 2.) * rotate(-90., DVec3::X);
    let left = translate(-2., 4., 2.) * rotate(90., DVec3::Y) * wide;
    room.append(Mesh::plane().moved(left).colored([0.82, 0.86, 0.92]));
    room.append(Mesh::plane().moved(floor * wide).colored([0.72, 0.60, 0.48]));
    let ball = translate(-0.2, 0.6, -0.2) * DMat4::from_scale(DVec3::splat(0.6));
    room.append(Mesh::sphere().moved(ball));
    let box_place = translate(-1.2, 0.45, 0.9) * rotate(28., DVec3::Y);
    room.append(Mesh::cube().moved(box_place * DMat4::from_scale(DVec3::splat(0.45))));
    room
}

/// The room in dim light. Its positions are computed as the lecture's projector computes them, so
/// that a second pass has the same depths.
const ROOM_VERTEX_SHADER: &str = "\
#version 130
uniform mat4 uModelViewMatrix;
uniform mat4 uProjMatrix;
in vec4 aVertex;
in vec3 aNormal;
in vec3 aColor;
out vec3 vColor;

void main(){
    vColor = aColor * (0.17 + 0.17 * max(0.0, dot(aNormal, vec3(0.36, 0.80, 0.48))));
    gl_Position = uProjMatrix * uModelViewMatrix * aVertex;
}
";

const ROOM_FRAGMENT_SHADER: &str = "\
#version 130
in vec3 vColor;
out vec4 fragColor;

void main(){
    fragColor = vec4(vColor, 1.0);
}
";

/// A program that draws [`room_corner`] in dim light.
pub fn dim_room_program(window: &mut Window) -> GLuint {
    initShaders(window, ROOM_VERTEX_SHADER, ROOM_FRAGMENT_SHADER)
}

/// A map of squares, 8 × 4, redder with u and bluer with v, each with the middle of its u and v.
pub fn numbered_map(window: &Window) -> GLuint {
    let side = (window.size * 3 / 4).max(8);
    glViewport(0, 0, side, side);
    glEnable(GL_SCISSOR_TEST);
    for at in 0..32 {
        let (column, row) = (at % 8, at / 8);
        glScissor(column * side / 8, row * side / 4, side / 8 + 1, side / 4 + 1);
        let (u, v) = ((f64::from(column) + 0.5) / 8., (f64::from(row) + 0.5) / 4.);
        let light = 0.85 + 0.15 * f64::from((column + row) % 2);
        glClearColor((0.4 + 0.6 * u) * light, 0.85 * light, (0.4 + 0.6 * v) * light, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    glDisable(GL_SCISSOR_TEST);
    for at in 0..32 {
        let (u, v) = ((f64::from(at % 8) + 0.5) / 8., (f64::from(at / 8) + 0.5) / 4.);
        window.label(2. * u - 1., 2. * v - 1., [0.1, 0.1, 0.2], &format!("{u:.1}\n{v:.1}"));
    }
    let picture = copy_window(side);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
    glGenerateMipmap(GL_TEXTURE_2D);
    set_filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    picture
}

/// The colour of [`carpet`].
pub const WOOL: [f32; 3] = [0.80, 0.30, 0.25];
/// The colour of [`bricks`].
pub const CLAY: [f32; 3] = [0.72, 0.36, 0.26];
/// The colour between [`bricks`].
pub const MORTAR: [f32; 3] = [0.70, 0.68, 0.64];

/// Pyramids of four faces, all of one colour, each leaning its own way.
pub fn carpet() -> Mesh {
    const SIDE: i64 = 72;
    let mut carpet = Mesh::plane().colored(WOOL);
    for at in 0..SIDE * SIDE {
        let (column, row) = (at % SIDE, at / SIDE);
        let lean = |seed: u32| 1.6 * (hash(column, row, seed) - 0.5);
        let middle = |at: i64| (2 * at + 1) as f64 / SIDE as f64 - 1.;
        let step = 1. / SIDE as f64;
        let foot = dvec3(middle(column), middle(row), 0.);
        let tip = foot + dvec3(step * lean(1), step * lean(2), step * (1.6 + lean(3)));
        let corner = |(x, y): (f64, f64)| foot + dvec3(x, y, 0.) * step;
        let around = [(-1., -1.), (1., -1.), (1., 1.), (-1., 1.)].map(corner);
        for side in 0..4 {
            let (a, b) = (around[side], around[(side + 1) % 4]);
            let normal = (b - a).cross(tip - a).normalize();
            carpet.append(Mesh::triangle([a, b, tip], normal).colored(WOOL));
        }
    }
    carpet
}

/// Boxes in courses over a plane of mortar.
pub fn bricks() -> Mesh {
    let mut wall = Mesh::plane().colored(MORTAR);
    for row in 0..12 {
        for column in 0..=6 {
            let tone = 0.75 + 0.4 * hash(column, row, 4) as f32;
            let (left, right) = (column as f64 / 3. - 1.333 + (row % 2) as f64 / 6., 0.305);
            let (left, right) = (left.max(-1.), (left + right).min(1.));
            if right > left {
                let low = row as f64 / 6. - 1.;
                let middle = translate((left + right) / 2., low + 0.083, 0.);
                let size = dvec3((right - left) / 2., 0.07, 0.02 + 0.03 * hash(column, row, 5));
                let brick = Mesh::cube().moved(middle * DMat4::from_scale(size));
                wall.append(brick.colored(CLAY.map(|c| c * tone)));
            }
        }
    }
    wall
}
