//! Labels at points of a picture: the letters of captions, a quad for each run of dots.

use crate::font;
use crate::window::Window;
use gl_api::constants::*;
use gl_api::types::GLint;
use gl_api::*;

/// Dots from one letter to the next, and from one line to the next.
const ADVANCE: [i32; 2] = [font::COLUMNS as i32 + 1, font::ROWS as i32 + 2];

const ROWS: i32 = font::ROWS as i32;

impl Window {
    /// Pixels a dot.
    fn dot(&self) -> i32 {
        (self.size / 256).max(1)
    }

    /// Text with its middle at a point of the current viewport, whose sides are -1 and 1.
    pub fn label(&self, x: f64, y: f64, color: [f32; 3], text: &str) {
        let [left, bottom, width, height] = viewport();
        let dot = self.dot();
        let at =
            |from: i32, size: i32, place: f64| from + (f64::from(size) * (place + 1.) / 2.) as i32;
        self.overlay([left, bottom, width, height], |window| {
            glColor3fv(&color);
            let lines = text.lines().count() as i32;
            let top = at(bottom, height, y) + dot * (ADVANCE[1] * lines - 2) / 2;
            for (line, text) in (0..).zip(text.lines()) {
                let x = at(left, width, x) - window.text_width(text) / 2;
                window.write(x, top - dot * (7 + line * ADVANCE[1]), text);
            }
        });
    }

    /// Draws in the window's pixels with the fixed function, within a rectangle; all state is put back.
    fn overlay(&self, [x, y, width, height]: [i32; 4], draw: impl Fn(&Self)) {
        let mut program: GLint = 0;
        glGetIntegerv(GL_CURRENT_PROGRAM, &mut program);
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        glUseProgram(0);
        for unit in [GL_TEXTURE2, GL_TEXTURE1, GL_TEXTURE0] {
            glActiveTexture(unit);
            for target in [GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP] {
                glDisable(target);
            }
        }
        for test in [GL_DEPTH_TEST, GL_LIGHTING, GL_CULL_FACE, GL_ALPHA_TEST, GL_POLYGON_SMOOTH] {
            glDisable(test);
        }
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
        glEnable(GL_SCISSOR_TEST);
        glScissor(x, y, width, height);
        glViewport(0, 0, self.width, self.height);
        for mode in [GL_PROJECTION, GL_MODELVIEW] {
            glMatrixMode(mode);
            glPushMatrix();
            glLoadIdentity();
        }
        glOrtho(0, self.width, 0, self.height, -1, 1);
        glBegin(GL_QUADS);
        draw(self);
        glEnd();
        for mode in [GL_PROJECTION, GL_MODELVIEW] {
            glMatrixMode(mode);
            glPopMatrix();
        }
        glPopAttrib();
        glUseProgram(program as u32);
    }

    fn text_width(&self, text: &str) -> i32 {
        self.dot() * (ADVANCE[0] * text.chars().count() as i32 - 1)
    }

    /// A line of text whose foot is at `y`.
    fn write(&self, x: i32, y: i32, text: &str) {
        let dot = self.dot();
        for (at, character) in (0..).zip(text.chars()) {
            for (column, bits) in (0..).zip(font::dots(character)) {
                let left = x + dot * (ADVANCE[0] * at + column);
                for (from, to) in runs(bits) {
                    // Bit 0 is the highest row, and bit 7 below the foot.
                    let [low, high] = [to, from].map(|row| y + dot * (ROWS - 1 - row));
                    quad(left, low, left + dot, high);
                }
            }
        }
    }
}

fn viewport() -> [GLint; 4] {
    let mut viewport: [GLint; 4] = [0; 4];
    glGetIntegerv(GL_VIEWPORT, &mut viewport);
    viewport
}

fn quad(left: i32, bottom: i32, right: i32, top: i32) {
    for (x, y) in [(left, bottom), (right, bottom), (right, top), (left, top)] {
        glVertex2i(x, y);
    }
}

/// The runs of ones in a column, each from its first row to the one after its last.
fn runs(bits: u8) -> impl Iterator<Item = (i32, i32)> {
    let is_set = move |row: i32| (0..ROWS).contains(&row) && bits >> row & 1 == 1;
    (0..ROWS).filter(move |row| is_set(*row) && !is_set(row - 1)).map(move |from| {
        let to = (from..ROWS).find(|row| !is_set(*row));
        (from, to.unwrap_or(ROWS))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_of_a_column_are_found() {
        assert_eq!(runs(0).count(), 0);
        assert_eq!(runs(0b1100_1011).collect::<Vec<_>>(), [(0, 2), (3, 4), (6, 8)]);
    }
}
