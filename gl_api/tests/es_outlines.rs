//! Lines and points at the sides of the view volume: OpenGL clips them there (GL 2.1, section 2.12), OpenGL ES by the near
//! and the far plane alone (3.0, section 2.17).

#[path = "common/shading.rs"]
mod shading;

use gl_api::*;
use shading::use_program;

const SIDE: GLsizei = 32;

fn context(api: Api) -> Context {
    let version = Version::new(3, 0);
    let (width, height) = (SIDE as u32, SIDE as u32);
    let desc = ContextDesc { api, version, width, height, ..ContextDesc::default() };
    Context::new(desc).expect("a device")
}

/// Draws, with points of 8 pixels, and says which pixels are covered.
fn covered(c: &mut Context, mode: GLenum, vertices: &[[f32; 4]]) -> Vec<[i32; 2]> {
    let (version, attribute) = match c.get_string(GL_VERSION).starts_with("OpenGL ES") {
        true => ("#version 300 es\nprecision highp float;\n", "in vec4 at;"),
        false => ("#version 130\n", "in vec4 at;"),
    };
    let vertex =
        format!("{version}{attribute} void main() {{ gl_Position = at; gl_PointSize = 8.0; }}");
    let fragment = format!("{version}out vec4 color; void main() {{ color = vec4(1.0); }}");
    let program = use_program(c, &vertex, &fragment);
    let at = c.get_attrib_location(program, "at") as GLuint;
    c.vertex_attrib_pointer(at, 4, GL_FLOAT, false, 0, vertices.as_flattened().arg());
    c.enable_vertex_attrib_array(at);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.draw_arrays(mode, 0, vertices.len() as GLsizei);
    let mut pixels = vec![0_u8; (SIDE * SIDE * 4) as usize];
    c.read_pixels(0, 0, SIDE, SIDE, GL_RGBA, GL_UNSIGNED_BYTE, pixels.as_mut_slice().arg());
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    let is_covered = |at: &usize| pixels[4 * at] == 255;
    let place = |at: usize| [at as i32 % SIDE, at as i32 / SIDE];
    (0..pixels.len() / 4).filter(is_covered).map(place).collect()
}

/// What covers no pixel outside a viewport of 16×16 pixels about the middle.
fn is_inside(pixels: &[[i32; 2]]) -> bool {
    pixels.iter().flatten().all(|v| (8..24).contains(v))
}

#[test]
fn points_about_a_side_are_drawn_in_the_viewport() {
    let mut c = context(Api::Es2);
    c.viewport(8, 8, 16, 16);
    // The centre is 2 pixels outside on the right, inside, and so far outside that nothing is left.
    let outside = covered(&mut c, GL_POINTS, &[[1.25, 0.0, 0.0, 1.0]]);
    assert_eq!(outside.len(), 2 * 8);
    assert!(is_inside(&outside), "{outside:?}");
    let inside = covered(&mut c, GL_POINTS, &[[0.75, 0.0, 0.0, 1.0]]);
    assert_eq!(inside.len(), 6 * 8);
    assert!(is_inside(&inside), "{inside:?}");
    assert!(covered(&mut c, GL_POINTS, &[[1.5, 0.0, 0.0, 1.0]]).is_empty());
    // Beyond near and far plane.
    for z in [-1.01, 1.01] {
        assert!(covered(&mut c, GL_POINTS, &[[0.0, 0.0, z, 1.0]]).is_empty(), "z = {z}");
    }
}

#[test]
fn lines_along_a_side_are_drawn_in_the_viewport() {
    let mut c = context(Api::Es2);
    c.viewport(8, 8, 16, 16);
    c.line_width(6.0);
    // A pixel above the upper side, from the left one to the right one: two of six rows are inside.
    let above = covered(&mut c, GL_LINES, &[[-3.0, 1.125, 0.0, 1.0], [3.0, 1.125, 0.0, 1.0]]);
    assert_eq!(above.len(), 2 * 16);
    assert!(is_inside(&above), "{above:?}");
    // Steep, through the upper left corner: on the part that is outside by its middle, half of it is inside.
    let steep = covered(&mut c, GL_LINES, &[[-0.75, -1.0, 0.0, 1.0], [-1.25, 1.0, 0.0, 1.0]]);
    assert!(is_inside(&steep), "{steep:?}");
    assert!(steep.contains(&[8, 23]), "{steep:?}");
    let near = covered(&mut c, GL_LINES, &[[-1.0, 0.0, -1.5, 1.0], [1.0, 0.0, -1.5, 1.0]]);
    assert!(near.is_empty(), "{near:?}");
}

#[test]
fn samples_of_lines_are_bounded_as_well() {
    let mut c = context(Api::Es2);
    let mut names = [0];
    c.gen_renderbuffers(1, &mut names);
    c.bind_renderbuffer(GL_RENDERBUFFER, names[0]);
    c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 4, GL_RGBA8, SIDE, SIDE);
    let mut framebuffer = [0];
    c.gen_framebuffers(1, &mut framebuffer);
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, framebuffer[0]);
    let (target, attachment) = (GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0);
    c.framebuffer_renderbuffer(target, attachment, GL_RENDERBUFFER, names[0]);
    c.viewport(8, 8, 16, 16);
    c.line_width(6.0);
    covered(&mut c, GL_LINES, &[[-3.0, 1.125, 0.0, 1.0], [3.0, 1.125, 0.0, 1.0]]);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, framebuffer[0]);
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
    let (from, to) = ((0, 0, SIDE, SIDE), (0, 0, SIDE, SIDE));
    let (mask, filter) = (GL_COLOR_BUFFER_BIT, GL_NEAREST);
    c.blit_framebuffer(from.0, from.1, from.2, from.3, to.0, to.1, to.2, to.3, mask, filter);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, 0);
    let mut pixels = vec![0_u8; (SIDE * SIDE * 4) as usize];
    c.read_pixels(0, 0, SIDE, SIDE, GL_RGBA, GL_UNSIGNED_BYTE, pixels.as_mut_slice().arg());
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    for (at, pixel) in pixels.chunks(4).enumerate() {
        let [x, y] = [at as i32 % SIDE, at as i32 / SIDE];
        let is_drawn = (8..24).contains(&x) && (22..24).contains(&y);
        assert_eq!(pixel[0], if is_drawn { 255 } else { 0 }, "{x}, {y}");
    }
}

/// As before: a point is drawn whole or not at all, and a line is as wide outside.
#[test]
fn opengl_clips_by_the_sides() {
    let mut c = context(Api::Compatibility);
    c.enable(GL_VERTEX_PROGRAM_POINT_SIZE);
    c.viewport(8, 8, 16, 16);
    assert!(covered(&mut c, GL_POINTS, &[[1.25, 0.0, 0.0, 1.0]]).is_empty());
    assert_eq!(covered(&mut c, GL_POINTS, &[[0.75, 0.0, 0.0, 1.0]]).len(), 8 * 8);
    c.line_width(6.0);
    let above = [[-3.0, 1.125, 0.0, 1.0], [3.0, 1.125, 0.0, 1.0]];
    assert!(covered(&mut c, GL_LINES, &above).is_empty());
    let below = [[-3.0, 0.875, 0.0, 1.0], [3.0, 0.875, 0.0, 1.0]];
    assert_eq!(covered(&mut c, GL_LINES, &below).len(), 6 * 16);
}
