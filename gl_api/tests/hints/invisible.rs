//! Warnings of pictures in which nothing that was drawn is visible, or depths are those of an earlier picture.

use super::scene::{WHITE, context};
use super::shading::use_program;
use super::texts;
use gl_api::*;

/// Name, what is drawn before a picture is taken, and the warning.
type Case = (&'static str, fn(&mut Context), &'static str);

/// A triangle with these corners.
fn triangle(c: &mut Context, corners: [[f32; 4]; 3]) {
    c.begin(GL_TRIANGLES);
    for [x, y, z, w] in corners {
        c.vertex_4f(x, y, z, w);
    }
    c.end();
}

/// A triangle over the whole picture, at a depth.
fn at(c: &mut Context, z: f32) {
    triangle(c, [[-1.0, -1.0, z, 1.0], [3.0, -1.0, z, 1.0], [-1.0, 3.0, z, 1.0]]);
}

const ROWS: &[Case] = &[
    (
        "no projection for what lies five units ahead",
        |c| at(c, -5.0),
        "draw: nothing that was drawn since the last picture is seen: the triangle is beyond the near \
         side of the view volume (z < -w): check the matrices of GL_MODELVIEW and GL_PROJECTION, or \
         gl_Position (GL 2.1, section 2.12)",
    ),
    (
        "the eye looks the other way",
        |c| {
            c.matrix_mode(GL_PROJECTION);
            c.frustum(-1.0, 1.0, -1.0, 1.0, 1.0, 10.0);
            (0..4).for_each(|_| at(c, 5.0));
        },
        "the first 4 triangles are behind the eye (w <= 0): check the matrices",
    ),
    (
        "the other side is culled",
        |c| {
            c.enable(GL_CULL_FACE);
            c.front_face(GL_CW);
            at(c, 0.0);
        },
        "the triangle shows the side that glCullFace leaves out: turn the order of the vertices around, \
         or call glFrontFace, or glDisable(GL_CULL_FACE) (GL 2.1, section 3.5.1)",
    ),
    (
        "each for a reason of its own",
        |c| {
            let nan = f32::NAN;
            triangle(c, [[0.0, 0.0, 0.0, 1.0], [1.0, 1.0, 0.0, 1.0], [0.5, 0.5, 0.0, 1.0]]);
            triangle(c, [[nan, 0.0, 0.0, 1.0], [1.0, 1.0, 0.0, 1.0], [0.5, 0.0, 0.0, 1.0]]);
            triangle(c, [[0.1, 0.1, 0.0, 1.0], [0.101, 0.1, 0.0, 1.0], [0.1, 0.101, 0.0, 1.0]]);
            (0..2).for_each(|_| triangle(c, [[2.0, 0.0, 0.0, 1.0]; 3]));
        },
        "seen: 2 triangles are beyond the right side of the view volume (x > w), 1 triangle has a coordinate \
         that is infinite or no number, 1 triangle has no area, as the vertices lie on one line, 1 triangle is \
         between the centres of pixels, or beside the viewport or the scissor box: check the matrices",
    ),
    (
        "a clip plane",
        |c| {
            c.clip_plane(GL_CLIP_PLANE0, &[0.0, 0.0, 1.0, -0.5]);
            c.enable(GL_CLIP_PLANE0);
            at(c, 0.0);
        },
        "the triangle is cut away by clip planes or by the view volume: check glClipPlane",
    ),
    (
        "lines",
        |c| {
            c.begin(GL_LINES);
            (2_u16..400).for_each(|y| c.vertex_2f(0.0, y.into()));
            c.end();
        },
        "the first 64 lines are beyond the top of the view volume (y > w)",
    ),
    (
        "points beside the scissor box",
        |c| {
            c.enable(GL_SCISSOR_TEST);
            c.scissor(0, 0, 4, 4);
            c.begin(GL_POINTS);
            c.vertex_2f(0.5, 0.5);
            c.end();
        },
        "the point is between the centres of pixels, or beside the viewport or the scissor box: check \
         glViewport, glScissor and the size of what is drawn",
    ),
    (
        "a matrix that was not set",
        |c| {
            use_program(
                c,
                "#version 120\nuniform mat4 m; void main() { gl_Position = m * gl_Vertex; }",
                WHITE,
            );
            at(c, 0.0);
        },
        "the triangle is behind the eye (w <= 0): check the matrices of GL_MODELVIEW and GL_PROJECTION, or \
         gl_Position (a uniform matrix that was never set is zero) (GL 2.1, section 2.12)",
    ),
];

/// Takes a picture, and gives the messages.
fn picture(c: &mut Context) -> Vec<String> {
    let mut pixel = [0_u8; 4];
    c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    texts(c)
}

#[test]
fn a_picture_of_nothing_says_why() {
    for (name, draw, words) in ROWS {
        let mut c = context();
        draw(&mut c);
        let said = picture(&mut c);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{name}");
        assert!(
            matches!(&said[..], [one] if one.contains(words)),
            "{name}: {words:?} in {said:#?}"
        );
        draw(&mut c);
        assert_eq!(picture(&mut c), [""; 0], "{name}: once");
    }
}

/// 40 points beyond the left side of the view volume, then 40 beyond the right.
fn points(c: &mut Context, between: fn(&mut Context)) {
    for x in [-2.0, 2.0] {
        c.begin(GL_POINTS);
        (0..40).for_each(|_| c.vertex_2f(x, 0.0));
        c.end();
        between(c);
    }
}

#[test]
fn the_warning_does_not_depend_on_when_draws_are_submitted() {
    let ways: [fn(&mut Context); 3] = [|_| {}, Context::flush, Context::finish];
    for between in ways {
        let mut c = context();
        points(&mut c, between);
        let said = picture(&mut c);
        assert!(said[0].contains("40 points are beyond the left side"), "{said:?}");
        assert!(said[0].contains("24 points are beyond the right side"), "{said:?}");
    }
}

#[test]
fn a_picture_where_something_is_visible_gets_no_warning() {
    let mut c = context();
    for before in [false, true] {
        for (name, draw, _) in ROWS {
            c.push_attrib(GL_ALL_ATTRIB_BITS);
            if before {
                at(&mut c, 0.0);
            }
            draw(&mut c);
            c.use_program(0);
            c.pop_attrib();
            c.matrix_mode(GL_PROJECTION);
            c.load_identity();
            if !before {
                c.finish();
                at(&mut c, 0.0);
            }
            assert_eq!(picture(&mut c), [""; 0], "{name}");
        }
    }
    // Nor where nothing was drawn.
    assert_eq!(picture(&mut c), [""; 0]);
    c.begin(GL_TRIANGLES);
    c.end();
    assert_eq!(picture(&mut c), [""; 0]);
    assert_eq!(c.get_error(), GL_NO_ERROR);
}

const OLD_DEPTHS: &str =
    "draw: glClear cleared the colours since the last picture, but not the depths";

/// Three pictures, each begun with `begin`.
fn pictures(begin: fn(&mut Context), depth_func: GLenum) -> Vec<String> {
    let mut c = context();
    c.enable(GL_DEPTH_TEST);
    c.depth_func(depth_func);
    c.clear(GL_DEPTH_BUFFER_BIT);
    let mut said = Vec::new();
    for _ in 0..3 {
        begin(&mut c);
        at(&mut c, 0.0);
        said.extend(picture(&mut c));
    }
    assert_eq!(c.get_error(), GL_NO_ERROR);
    said
}

#[test]
fn depths_of_the_picture_before_are_noticed() {
    type Begin = fn(&mut Context);
    let wrong: [(&str, Begin); 3] = [
        ("the colours alone", |c| c.clear(GL_COLOR_BUFFER_BIT)),
        ("a mask in the way", |c| {
            c.depth_mask(false);
            c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            c.depth_mask(true);
        }),
        ("by buffer", |c| c.clear_bufferfv(GL_COLOR, 0, &[0.0; 4])),
    ];
    for (name, begin) in wrong {
        let said = pictures(begin, GL_LESS);
        assert!(matches!(&said[..], [one] if one.contains(OLD_DEPTHS)), "{name}: {said:#?}");
        assert_eq!(pictures(begin, GL_ALWAYS), [""; 0], "{name}, not compared");
    }
    let right: [(&str, Begin); 5] = [
        ("both", |c| c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)),
        ("one after the other", |c| {
            c.clear(GL_COLOR_BUFFER_BIT);
            c.disable(GL_DEPTH_TEST);
            at(c, 0.0);
            c.enable(GL_DEPTH_TEST);
            c.clear_bufferfv(GL_DEPTH, 0, &[1.0]);
        }),
        ("none: the picture goes on", |_| {}),
        ("depths that nobody wrote", |c| {
            c.depth_mask(false);
            c.clear(GL_COLOR_BUFFER_BIT);
        }),
        ("a background at the far end", |c| {
            c.clear(GL_COLOR_BUFFER_BIT);
            c.depth_func(GL_ALWAYS);
            at(c, 1.0);
            c.depth_func(GL_LESS);
        }),
    ];
    for (name, begin) in right {
        assert_eq!(pictures(begin, GL_LESS), [""; 0], "{name}");
    }
}
