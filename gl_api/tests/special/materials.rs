//! `glMaterial` between `glBegin` and `glEnd`: each vertex has the material of its time.

use super::shading::use_program;
use super::{context, fine, pixel};
use gl_api::*;

fn lit() -> Context {
    let mut c = context(2, 1);
    c.enable(GL_LIGHTING);
    c.enable(GL_LIGHT0);
    c.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[1.0; 4]);
    c.lightfv(GL_LIGHT0, GL_AMBIENT, &[0.0; 4]);
    c.lightfv(GL_LIGHT0, GL_DIFFUSE, &[1.0; 4]);
    c.lightfv(GL_LIGHT0, GL_SPECULAR, &[1.0; 4]);
    c.lightfv(GL_LIGHT0, GL_POSITION, &[0.0, 0.0, 1.0, 0.0]);
    for part in [GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION] {
        c.materialfv(GL_FRONT_AND_BACK, part, &[0.0, 0.0, 0.0, 1.0]);
    }
    c
}

/// A strip whose left two vertices have one value of a part, the right two another.
fn strip(c: &mut Context, part: GLenum, left: &[f32], right: &[f32]) {
    c.begin(GL_TRIANGLE_STRIP);
    for (x, value) in [(-1.0, left), (1.0, right)] {
        c.materialfv(GL_FRONT, part, value);
        c.vertex_2f(x, -1.0);
        c.vertex_2f(x, 1.0);
    }
    c.end();
}

const RED: [f32; 4] = [1.0, 0.0, 0.0, 1.0];
const BLUE: [f32; 4] = [0.0, 0.0, 1.0, 1.0];

/// A quarter of the way from one end to the other.
fn mixed(c: &mut Context) {
    let near = |found: [u8; 4], expected: [i32; 4]| {
        let far = found.iter().zip(expected).any(|(a, b)| (i32::from(*a) - b).abs() > 1);
        assert!(!far, "{found:?} is not {expected:?}");
    };
    near(pixel(c, 0, 0), [191, 0, 64, 255]);
    near(pixel(c, 1, 0), [64, 0, 191, 255]);
}

#[test]
fn a_strip_mixes_the_materials_of_its_vertices() {
    for part in [GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE] {
        let mut c = lit();
        if part == GL_AMBIENT_AND_DIFFUSE {
            c.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[0.0; 4]);
        }
        strip(&mut c, part, &RED, &BLUE);
        mixed(&mut c);
        // What came last stays.
        let mut value = [0.0; 4];
        let asked = if part == GL_AMBIENT_AND_DIFFUSE { GL_DIFFUSE } else { part };
        c.get_materialfv(GL_FRONT, asked, &mut value);
        assert_eq!(value, BLUE);
    }
}

#[test]
fn lists_do_the_same_and_inherit_what_they_do_not_set() {
    let mut c = lit();
    c.new_list(1, GL_COMPILE);
    strip(&mut c, GL_EMISSION, &RED, &BLUE);
    c.end_list();
    let mut value = [9.0; 4];
    c.get_materialfv(GL_FRONT, GL_EMISSION, &mut value);
    assert_eq!(value, [0.0, 0.0, 0.0, 1.0], "compiling sets nothing");
    c.call_list(1);
    mixed(&mut c);
    // The first vertices have the material from before the list.
    c.new_list(2, GL_COMPILE);
    c.begin(GL_QUADS);
    c.vertex_2f(-1.0, 1.0);
    c.vertex_2f(-1.0, -1.0);
    c.materialfv(GL_FRONT, GL_EMISSION, &BLUE);
    c.vertex_2f(1.0, -1.0);
    c.vertex_2f(1.0, 1.0);
    c.end();
    c.end_list();
    c.clear(GL_COLOR_BUFFER_BIT);
    c.materialfv(GL_FRONT, GL_EMISSION, &RED);
    c.call_list(2);
    mixed(&mut c);
    // A refused value is told when the list is called.
    c.new_list(3, GL_COMPILE);
    c.materialf(GL_FRONT, GL_SHININESS, 200.0);
    c.materialfv(GL_FRONT, GL_COLOR_INDEXES, &[3.0, 4.0, 5.0]);
    c.end_list();
    fine(&mut c);
    c.call_list(3);
    assert_eq!(c.get_error(), GL_INVALID_VALUE);
    c.get_materialfv(GL_FRONT, GL_COLOR_INDEXES, &mut value);
    assert_eq!(value[..3], [3.0, 4.0, 5.0]);
}

/// GL 2.1, section 2.14.2: with a vertex shader, a change is sure to be seen after `glEnd` only.
#[test]
fn programs_read_the_materials_from_before_the_primitive() {
    let mut c = lit();
    let vertex = "void main() {
        gl_Position = gl_Vertex;
        gl_FrontColor = gl_FrontMaterial.ambient + gl_FrontMaterial.emission; }";
    use_program(&mut c, vertex, "");
    for part in [GL_AMBIENT, GL_EMISSION] {
        for in_a_list in [false, true] {
            let other = if part == GL_AMBIENT { GL_EMISSION } else { GL_AMBIENT };
            c.materialfv(GL_FRONT, other, &[0.0, 0.0, 0.0, 1.0]);
            c.materialfv(GL_FRONT, part, &[0.0, 1.0, 0.0, 1.0]);
            if in_a_list {
                c.new_list(7, GL_COMPILE_AND_EXECUTE);
            }
            strip(&mut c, part, &RED, &BLUE);
            if in_a_list {
                c.end_list();
            }
            assert_eq!(pixel(&mut c, 0, 0), [0, 255, 0, 255]);
            // The next primitive has what came last.
            c.rectf(-1.0, -1.0, 1.0, 1.0);
            assert_eq!(pixel(&mut c, 1, 0), [0, 0, 255, 255]);
            let mut value = [0.0; 4];
            c.get_materialfv(GL_FRONT, part, &mut value);
            assert_eq!(value, BLUE);
        }
    }
    fine(&mut c);
}

#[test]
fn shininess_and_tracked_colours_of_each_vertex() {
    let mut c = lit();
    c.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[0.0; 4]);
    c.materialfv(GL_FRONT, GL_SPECULAR, &[1.0; 4]);
    // The half vector is the axis: cos 60° to the power of 1, then of 2.
    c.normal_3f(0.75_f32.sqrt(), 0.0, 0.5);
    c.shade_model(GL_FLAT);
    c.begin(GL_QUADS);
    for (x, shininess) in [(-1.0, 1.0), (0.0, 2.0)] {
        c.materialf(GL_FRONT, GL_SHININESS, shininess);
        for (dx, y) in [(0.0, -1.0), (1.0, -1.0), (1.0, 1.0), (0.0, 1.0)] {
            c.vertex_2f(x + dx, y);
        }
    }
    c.end();
    let found = [pixel(&mut c, 0, 0)[0], pixel(&mut c, 1, 0)[0]];
    assert!((127..=128).contains(&found[0]) && found[1] == 64, "{found:?}");
    // What the colour stands for is the colour, whatever glMaterial says meanwhile.
    let mut c = lit();
    c.color_material(GL_FRONT, GL_EMISSION);
    c.enable(GL_COLOR_MATERIAL);
    c.color_4fv(&RED);
    strip(&mut c, GL_EMISSION, &BLUE, &BLUE);
    assert_eq!(pixel(&mut c, 0, 0), [255, 0, 0, 255]);
    c.begin(GL_TRIANGLE_STRIP);
    for (x, color) in [(-1.0, RED), (1.0, BLUE)] {
        c.color_4fv(&color);
        c.materialfv(GL_FRONT, GL_EMISSION, &[1.0; 4]);
        c.vertex_2f(x, -1.0);
        c.vertex_2f(x, 1.0);
    }
    c.end();
    mixed(&mut c);
}
