//! One edge and its picture: uniform steps in the image are not uniform along the edge.
//!
//! *eScience*, slides 18 to 22, "Looking at One Edge". Above, in the plane of the edge, the eye at the left and the
//! image one unit before it: steps of t = 1/8 in the image meet the edge at s = t z1 / (z2 + t (z1 − z2)); and
//! steps of s = 1/8 on the edge crowd in the image, toward its far end. Below, stripes of texture between the
//! same two ends as the eye sees them: s taken for t, which is wrong, and by the formula.
#![allow(non_snake_case, non_upper_case_globals, reason = "the lecture's names")]

use examples::lecture::*;
use std::process::ExitCode;

/// This program, for the gallery.
pub const PROGRAM: Program = Program {
    name: "one_edge",
    lecture: "eScience: slides 18 to 22, \"Looking at One Edge\"",
    source: include_str!("one_edge.rs"),
    halves: [4, 4],
    panels: &[
        "uniform in the image",
        "uniform along the edge",
        "s = t: wrong",
        "s = t z1 / (z2 + t (z1 − z2))",
    ],
    draw,
};

/// Draws it alone.
pub fn main() -> ExitCode {
    examples::window::main(&PROGRAM)
}

/// The ends of the edge: distance from the eye, and height.
const NEAR: [f64; 2] = [1.6, 1.0];
const FAR: [f64; 2] = [6.4, -1.9];
const STEPS: i32 = 8;

/// Where the ray through the place t between the pictures of the ends meets the edge.
fn s_of(t: f64) -> f64 {
    let (z1, z2) = (NEAR[0], FAR[0]);
    t * z1 / (z2 + t * (z1 - z2))
}

/// The inverse: where the point at s is seen.
fn t_of(s: f64) -> f64 {
    let (z1, z2) = (NEAR[0], FAR[0]);
    s * z2 / (z1 + s * (z2 - z1))
}

fn on_edge(s: f64) -> [f64; 2] {
    [NEAR[0] + s * (FAR[0] - NEAR[0]), NEAR[1] + s * (FAR[1] - NEAR[1])]
}

/// The picture of a point, one unit from the eye.
fn seen([z, y]: [f64; 2]) -> [f64; 2] {
    [1., y / z]
}

fn draw(window: &mut Window) {
    glClearColor(0.96, 0.96, 0.93, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    let uniform = || (0..=STEPS).map(|step| f64::from(step) / f64::from(STEPS));
    window.panel(2, 2, 0);
    rays(window, &uniform().map(s_of).collect::<Vec<_>>());
    window.panel(2, 2, 1);
    rays(window, &uniform().collect::<Vec<_>>());
    window.panel(2, 2, 2);
    stripes(&uniform().collect::<Vec<_>>());
    ends(window);
    window.panel(2, 2, 3);
    stripes(&uniform().map(t_of).collect::<Vec<_>>());
    ends(window);
}

const INK: [f32; 3] = [0.10, 0.12, 0.25];
const RED: [f32; 3] = [0.80, 0.15, 0.10];
const GREY: [f32; 3] = [0.62, 0.66, 0.74];

/// The eye, the image, the edge, and the rays to points of the edge.
fn rays(window: &Window, points: &[f64]) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(-0.6, 7.2, -2.5, 1.7);
    for s in points {
        let point = on_edge(*s);
        line(GREY, 1., [0., 0.], point);
        dot(RED, point);
        dot(INK, seen(point));
    }
    line(INK, 2., seen([1., 0.9]), seen([1., -0.7]));
    line(RED, 2., NEAR, FAR);
    dot(INK, [0., 0.]);
    for ([z, y], color, text) in [
        ([-0.1, 0.25], INK, "eye"),
        ([1., 1.15], INK, "image"),
        ([NEAR[0] + 0.9, NEAR[1] + 0.2], RED, "z1, s = 0"),
        ([FAR[0] - 0.4, FAR[1] - 0.25], RED, "z2, s = 1"),
    ] {
        window.label((z + 0.6) / 3.9 - 1., (y + 2.5) / 2.1 - 1., color, text);
    }
    if points[1] < 0.1 {
        let text: Vec<_> = points.iter().map(|s| format!("{s:.2}")).collect();
        let lines: Vec<_> = text.chunks(3).map(|line| line.join(" ")).collect();
        window.label(-0.4, -0.5, RED, &format!("s =\n{}", lines.join("\n")));
    }
}

fn ends(window: &Window) {
    window.label(-0.8, 0.85, INK, "near");
    window.label(0.8, 0.85, INK, "far");
}

/// Stripes between places t of the image, dark and light in turn.
fn stripes(places: &[f64]) {
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluOrtho2D(-0.08, 1.08, 0, 1);
    for (at, pair) in places.windows(2).enumerate() {
        glColor3fv(if at % 2 == 0 { &RED } else { &GREY });
        // What is nearer is seen larger.
        let height = |t: f64| 0.62 * NEAR[0] / on_edge(s_of(t))[0];
        glBegin(GL_QUADS);
        for (t, side) in [(pair[0], -1.), (pair[1], -1.), (pair[1], 1.), (pair[0], 1.)] {
            glVertex2d(t, 0.52 + side * height(t) / 2.);
        }
        glEnd();
    }
}

fn line(color: [f32; 3], width: f64, from: [f64; 2], to: [f64; 2]) {
    glColor3fv(&color);
    glLineWidth(width);
    glBegin(GL_LINES);
    glVertex2d(from[0], from[1]);
    glVertex2d(to[0], to[1]);
    glEnd();
}

fn dot(color: [f32; 3], [x, y]: [f64; 2]) {
    glColor3fv(&color);
    glPointSize(5);
    glBegin(GL_POINTS);
    glVertex2d(x, y);
    glEnd();
}
