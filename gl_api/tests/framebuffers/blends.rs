//! Each draw buffer is blended by a formula of its own (`ARB_draw_buffers_blend`).

use super::shading::use_program;
use super::*;

const C0: GLenum = GL_COLOR_ATTACHMENT0;

/// Framebuffers of this many colours, all (0.5, 0.25, 0.125, 0.75), and a program that draws
/// (0.25, 0.5, 0.75, 0.5) to each.
fn target(count: u32) -> Context {
    let mut c = context(2, 2);
    framebuffer(&mut c);
    for index in 0..count {
        renderbuffer(&mut c, C0 + index, GL_RGBA32F, 2, 2);
    }
    let buffers: Vec<GLenum> = (0..count).map(|index| C0 + index).collect();
    c.draw_buffers(count as i32, &buffers);
    c.clear_color(0.5, 0.25, 0.125, 0.75);
    c.clear(GL_COLOR_BUFFER_BIT);
    let writes: String =
        (0..count).map(|i| format!("gl_FragData[{i}] = vec4(0.25, 0.5, 0.75, 0.5);")).collect();
    let vertex = "void main() { gl_Position = gl_Vertex; }";
    use_program(&mut c, vertex, &format!("void main() {{ {writes} }}"));
    c.blend_color(0.5, 0.5, 0.5, 0.25);
    c.enable(GL_BLEND);
    fine(&mut c);
    c
}

/// What each buffer holds after a rectangle over all of it.
fn drawn(c: &mut Context, count: u32) -> Vec<Vec<f32>> {
    c.rectf(-1.0, -1.0, 1.0, 1.0);
    fine(c);
    let read = |index| {
        c.read_buffer(C0 + index);
        floats(c, [1, 1, 1, 1], GL_RGBA, 4)
    };
    (0..count).map(read).collect()
}

#[test]
fn each_buffer_has_factors_and_equations_of_its_own() {
    let mut c = target(8);
    // For all, then for one each.
    c.blend_func(GL_ONE, GL_ONE);
    c.blend_equation(GL_FUNC_ADD);
    c.blend_funci(1, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    c.blend_func_separatei(2, GL_ONE, GL_ZERO, GL_ZERO, GL_ONE);
    c.blend_equationi(3, GL_FUNC_SUBTRACT);
    c.blend_equation_separatei(4, GL_MIN, GL_MAX);
    c.blend_equation_separatei(5, GL_FUNC_REVERSE_SUBTRACT, GL_FUNC_ADD);
    c.blend_func_separatei(6, GL_CONSTANT_COLOR, GL_ZERO, GL_CONSTANT_ALPHA, GL_ZERO);
    c.disablei(GL_BLEND, 7);
    let want = [
        [0.75, 0.75, 0.875, 1.25],
        [0.375, 0.375, 0.4375, 0.625],
        [0.25, 0.5, 0.75, 0.75],
        [-0.25, 0.25, 0.625, -0.25],
        [0.25, 0.25, 0.125, 0.75],
        [0.25, -0.25, -0.625, 1.25],
        [0.125, 0.25, 0.375, 0.125],
        [0.25, 0.5, 0.75, 0.5],
    ];
    assert_eq!(drawn(&mut c, 8), want);
    // A call for all takes every one back.
    c.blend_func(GL_ZERO, GL_ONE);
    c.blend_equation(GL_FUNC_ADD);
    let mut kept = want;
    kept[7] = [0.25, 0.5, 0.75, 0.5];
    assert_eq!(drawn(&mut c, 8), kept);
}

fn asked(c: &mut Context, pname: GLenum, index: GLuint) -> GLenum {
    let mut value = [0];
    c.get_integeri_v(pname, index, &mut value);
    value[0] as GLenum
}

const PARTS: [GLenum; 6] = [
    GL_BLEND_SRC_RGB,
    GL_BLEND_DST_RGB,
    GL_BLEND_SRC_ALPHA,
    GL_BLEND_DST_ALPHA,
    GL_BLEND_EQUATION_RGB,
    GL_BLEND_EQUATION_ALPHA,
];

#[test]
fn formulas_are_asked_for_and_stacked() {
    let mut c = target(1);
    let initial = [GL_ONE, GL_ZERO, GL_ONE, GL_ZERO, GL_FUNC_ADD, GL_FUNC_ADD];
    let other = [GL_DST_COLOR, GL_SRC_COLOR, GL_DST_ALPHA, GL_SRC_ALPHA, GL_MIN, GL_MAX];
    let all = |c: &mut Context, index| PARTS.map(|pname| asked(c, pname, index));
    c.push_attrib(GL_COLOR_BUFFER_BIT);
    c.blend_func_separatei(5, other[0], other[1], other[2], other[3]);
    c.blend_equation_separatei(5, other[4], other[5]);
    assert_eq!(all(&mut c, 5), other);
    assert_eq!(all(&mut c, 4), initial);
    // What has no number is the first buffer's.
    c.blend_funci(0, GL_ZERO, GL_ONE);
    let mut first = [0];
    c.get_integerv(GL_BLEND_SRC, &mut first);
    assert_eq!(first, [GL_ZERO as i32]);
    let mut truth = [9];
    c.get_booleani_v(GL_BLEND_SRC_RGB, 0, &mut truth);
    assert_eq!(truth, [0]);
    c.pop_attrib();
    assert_eq!(all(&mut c, 5), initial);
    assert_eq!(all(&mut c, 0), initial);
    // Switches are a group of their own.
    c.push_attrib(GL_ENABLE_BIT);
    c.blend_equationi(3, GL_MAX);
    c.disablei(GL_BLEND, 3);
    c.pop_attrib();
    assert!(c.is_enabledi(GL_BLEND, 3));
    assert_eq!(asked(&mut c, GL_BLEND_EQUATION_RGB, 3), GL_MAX);
    fine(&mut c);
}
