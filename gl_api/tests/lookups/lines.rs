//! The level of detail of textured lines: GL 2.1, section 3.8.8, the formula for lines. It is the derivative of the
//! texel coordinates along the line, so that neither the angle nor the width of a line matters.

use super::program;
use gl_api::*;

/// Side of the window.
const SIZE: i32 = 64;
/// Side of the base level; level l is l everywhere.
const SIDE: i32 = 256;

fn context() -> Current {
    let desc = ContextDesc { width: 8, height: 8, ..ContextDesc::default() };
    let current = Context::new(desc).expect("a device").make_current();
    glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
    glClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
    glBindRenderbuffer(GL_RENDERBUFFER, 1);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, SIZE, SIZE);
    glBindFramebuffer(GL_FRAMEBUFFER, 1);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 1);
    glViewport(0, 0, SIZE, SIZE);
    let t = GL_TEXTURE_2D;
    glBindTexture(t, 1);
    glTexParameteri(t, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    for (level, side) in (0..).zip((0..=SIDE.ilog2()).map(|level| SIDE >> level)) {
        let texels = vec![level as f32; (side * side) as usize];
        glTexImage2D(t, level, GL_R32F, side, side, 0, GL_RED, GL_FLOAT, &texels);
    }
    glEnable(t);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    current
}

/// A line, in window coordinates, with the `w` and the texture coordinates of its ends.
#[derive(Clone, Copy, Debug)]
struct Line {
    ends: [[f64; 2]; 2],
    w: [f64; 2],
    coordinates: [[f64; 2]; 2],
}

impl Line {
    /// A line of 50 pixels around the centre.
    fn at(degrees: f64) -> Self {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let end = |along: f64| [32.1 + along * cos, 31.9 + along * sin];
        let coordinates = [[0.125, 0.25], [0.875, 0.5]];
        Self { ends: [end(-25.0), end(25.0)], w: [1.0; 2], coordinates }
    }

    fn vertex(&self, end: usize) {
        let [s, t] = self.coordinates[end].map(|c| c as f32);
        let [x, y] = self.ends[end].map(|at| (2.0 * at / f64::from(SIZE) - 1.0) * self.w[end]);
        glTexCoord2f(s, t);
        glVertex4f(x as f32, y as f32, 0.0, self.w[end] as f32);
    }

    fn draw(&self) {
        glBegin(GL_LINES);
        self.vertex(0);
        self.vertex(1);
        glEnd();
    }

    /// λ at a point of the window: the derivative along the line of the coordinates, which are those of the nearest
    /// point of it.
    fn lambda(&self, point: [f64; 2]) -> f64 {
        let [from, to] = self.ends;
        let along = [to[0] - from[0], to[1] - from[1]];
        let length = along[0].hypot(along[1]);
        let at = |step: f64| {
            let by = [point[0] - from[0], point[1] - from[1]];
            let part = (by[0] * along[0] + by[1] * along[1]) / (length * length) + step / length;
            // GL 2.1, equation 3.6.
            let weights = [(1.0 - part) / self.w[0], part / self.w[1]];
            [0, 1].map(|axis| {
                let sum =
                    weights[0] * self.coordinates[0][axis] + weights[1] * self.coordinates[1][axis];
                f64::from(SIDE) * sum / (weights[0] + weights[1])
            })
        };
        let step = 1e-4;
        let [before, after] = [at(-step), at(step)];
        let [du, dv] = [0, 1].map(|axis| (after[axis] - before[axis]) / (2.0 * step));
        du.hypot(dv).log2()
    }
}

/// The window: its pixels that something was drawn to, and the level there.
fn levels(draw: impl FnOnce()) -> Vec<([f64; 2], f64)> {
    glClearColor(-1, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    draw();
    let mut pixels = vec![0.0_f32; (SIZE * SIZE) as usize];
    glReadPixels(0, 0, SIZE, SIZE, GL_RED, GL_FLOAT, &mut pixels);
    assert_eq!(glGetError(), GL_NO_ERROR);
    let place = |at: i32| [f64::from(at % SIZE) + 0.5, f64::from(at / SIZE) + 0.5];
    let drawn = (0..).zip(pixels).filter(|(_, level)| *level >= 0.0);
    drawn.map(|(at, level)| (place(at), f64::from(level))).collect()
}

#[track_caller]
fn check(line: Line, bound: f64, draw: impl FnOnce()) {
    let levels = levels(draw);
    assert!(levels.len() > 30, "{line:?}: {} pixels", levels.len());
    for (place, level) in levels {
        let want = line.lambda(place);
        assert!((level - want).abs() <= bound, "{line:?} at {place:?}: {level}, not {want}");
    }
}

#[test]
fn the_angle_and_the_width_of_a_line_do_not_matter() {
    let _current = context();
    for degrees in (0..360).step_by(15).chain([1, 44, 89, 123]) {
        let line = Line::at(f64::from(degrees));
        for width in [1.0, 2.0, 5.0] {
            glLineWidth(width);
            check(line, 1e-5, || line.draw());
            glEnable(GL_LINE_SMOOTH);
            check(line, 1e-5, || line.draw());
            glDisable(GL_LINE_SMOOTH);
        }
    }
}

/// Equation 3.6. Columns of a wide line have the value of their middle, which is off the line's nearest point.
#[test]
fn lines_in_perspective_have_it_at_each_pixel() {
    let _current = context();
    for degrees in (0..180).step_by(15) {
        let line = Line { w: [1.0, 3.0], ..Line::at(f64::from(degrees)) };
        check(line, 1e-4, || line.draw());
    }
}

/// Shaders, whose coordinates are varyings and functions of them, and edges of polygons.
#[test]
fn all_that_is_drawn_as_lines_has_it() {
    let _current = context();
    let vertex =
        "varying vec2 c; void main() { gl_Position = gl_Vertex; c = gl_MultiTexCoord0.st; }";
    let fragments = [
        "uniform sampler2D s; varying vec2 c; void main() { gl_FragColor = texture2D(s, c); }",
        "uniform sampler2D s; varying vec2 c;
         void main() { gl_FragColor = texture2D(s, c * 2.0 - c); }",
        // Not made of what can be differentiated.
        "uniform sampler2D s; varying vec2 c;
         void main() { gl_FragColor = texture2D(s, sqrt(c * c)); }",
        // With a bias that is taken away again.
        "uniform sampler2D s; varying vec2 c;
         void main() { gl_FragColor = texture2D(s, c, 1.5) - 1.5; }",
    ];
    for (number, fragment) in fragments.into_iter().enumerate() {
        glUseProgram(program(vertex, fragment).unwrap());
        for degrees in (0..180).step_by(15) {
            for width in [1.0, 4.0] {
                glLineWidth(width);
                let line = Line::at(f64::from(degrees));
                check(line, if number == 2 { 1e-3 } else { 1e-5 }, || line.draw());
            }
        }
    }
    glUseProgram(0);
    glLineWidth(1);
    // One edge of a triangle.
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    for degrees in (5..180).step_by(15) {
        let line = Line::at(f64::from(degrees));
        check(line, 1e-4, || {
            glBegin(GL_TRIANGLES);
            line.vertex(0);
            glEdgeFlag(false);
            line.vertex(1);
            glTexCoord2f(0.0, 1.0);
            glVertex2f(0.9, 0.0);
            glEdgeFlag(true);
            glEnd();
        });
    }
}

/// Derivatives and gradients that a shader asks for, and polygons, are what they were.
#[test]
fn what_is_no_implicit_level_of_a_line_stays() {
    let _current = context();
    let vertex =
        "varying vec2 c; void main() { gl_Position = gl_Vertex; c = gl_MultiTexCoord0.st; }";
    let fragment = "varying vec2 c;
        void main() { gl_FragColor = vec4(log2(256.0 * max(length(dFdx(c)), length(dFdy(c))))); }";
    glUseProgram(program(vertex, fragment).unwrap());
    let line = Line::at(45.0);
    for (place, level) in levels(|| line.draw()) {
        assert!((level - (line.lambda(place) - 0.5)).abs() < 1e-3, "{level}");
    }
    glUseProgram(0);
    // Filled triangles in a draw whose back faces are drawn as lines.
    let triangle = || {
        glBegin(GL_TRIANGLES);
        for [x, y] in [[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]] {
            glTexCoord2f(x * 0.7 + y * 0.1, y * 0.3 - x * 0.4);
            glVertex2f(x, y);
        }
        glEnd();
    };
    let want = levels(triangle);
    glPolygonMode(GL_BACK, GL_LINE);
    assert_eq!(levels(triangle), want);
}
