//! Captions and labels, drawn in the picture: glyphs of 5 × 8 dots, a quad for each run of dots.

use crate::window::Window;
use gl_api::constants::*;
use gl_api::entry::*;
use gl_api::types::GLint;

/// Dots from one glyph to the next, and from one line to the next.
const ADVANCE: [i32; 2] = [6, 10];

/// Rows of a glyph; the last is below the line.
const ROWS: i32 = 8;

/// The colour of captions.
const PAPER: [f32; 3] = [1.0, 1.0, 0.92];

impl Window {
    /// Pixels a dot.
    fn dot(&self) -> i32 {
        (self.size / 256).max(1)
    }

    /// Text on a dark strip at the bottom of the current viewport, each of its lines in the middle.
    pub fn caption(&self, text: &str) {
        let [left, bottom, width, _] = viewport();
        let (dot, lines) = (self.dot(), text.lines().count() as i32);
        let height = dot * (ADVANCE[1] * lines + 2);
        self.overlay([left, bottom, width, height], |window| {
            glColor4f(0.03, 0.04, 0.07, 0.85);
            quad(left, bottom, left + width, bottom + height);
            glColor3fv(&PAPER);
            for (line, text) in (1..).zip(text.lines()) {
                let x = left + (width - window.text_width(text)) / 2;
                window.write(x.max(left + dot), bottom + height - line * ADVANCE[1] * dot, text);
            }
        });
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
            let columns = glyph(character).to_be_bytes();
            for (column, bits) in (0..).zip(&columns[3..]) {
                let left = x + dot * (ADVANCE[0] * at + column);
                for (from, to) in runs(*bits) {
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

/// A glyph: five columns from the left, a byte each, bit 0 its highest row. A character that is not
/// there is a box.
fn glyph(character: char) -> u64 {
    match character {
        '×' => 0x22_14_08_14_22,
        '°' => 0x00_06_09_09_06,
        '²' => 0x00_09_0d_0a_00,
        'π' => 0x44_3c_04_7c_44,
        'φ' => 0x18_24_7e_24_18,
        'θ' => 0x3e_49_49_49_3e,
        'λ' => 0x41_22_1c_20_40,
        'ρ' => 0xf8_24_24_24_18,
        '→' => 0x08_08_2a_1c_08,
        '−' => 0x08_08_08_08_08,
        ' '..='~' => ASCII[character as usize - 0x20],
        _ => 0x7f_41_41_41_7f,
    }
}

/// From the space to the tilde.
#[rustfmt::skip]
const ASCII: [u64; 95] = [
    0x0000000000, 0x00005f0000, 0x0007000700, 0x147f147f14, 0x242a7f2a12, 0x2313086462,
    0x3649562050, 0x0008070300, 0x001c224100, 0x0041221c00, 0x2a1c7f1c2a, 0x08083e0808,
    0x0080703000, 0x0808080808, 0x0000606000, 0x2010080402, 0x3e5149453e, 0x00427f4000,
    0x7249494946, 0x2141494d33, 0x1814127f10, 0x2745454539, 0x3c4a494931, 0x4121110907,
    0x3649494936, 0x464949291e, 0x0000140000, 0x0040340000, 0x0008142241, 0x1414141414,
    0x0041221408, 0x0201590906, 0x3e415d594e, 0x7c1211127c, 0x7f49494936, 0x3e41414122,
    0x7f4141413e, 0x7f49494941, 0x7f09090901, 0x3e41415173, 0x7f0808087f, 0x00417f4100,
    0x2040413f01, 0x7f08142241, 0x7f40404040, 0x7f021c027f, 0x7f0408107f, 0x3e4141413e,
    0x7f09090906, 0x3e4151215e, 0x7f09192946, 0x2649494932, 0x03017f0103, 0x3f4040403f,
    0x1f2040201f, 0x3f4038403f, 0x6314081463, 0x0304780403, 0x6159494d43, 0x007f414141,
    0x0204081020, 0x004141417f, 0x0402010204, 0x4040404040, 0x0003070800, 0x2054547840,
    0x7f28444438, 0x3844444428, 0x384444287f, 0x3854545418, 0x00087e0902, 0x18a4a49c78,
    0x7f08040478, 0x00447d4000, 0x2040403d00, 0x7f10284400, 0x00417f4000, 0x7c04780478,
    0x7c08040478, 0x3844444438, 0xfc18242418, 0x18242418fc, 0x7c08040408, 0x4854545424,
    0x04043f4424, 0x3c4040207c, 0x1c2040201c, 0x3c4030403c, 0x4428102844, 0x4c9090907c,
    0x4464544c44, 0x0008364100, 0x0000770000, 0x0041360800, 0x0201020402,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_of_a_column_are_found() {
        assert_eq!(runs(0).count(), 0);
        assert_eq!(runs(0b1100_1011).collect::<Vec<_>>(), [(0, 2), (3, 4), (6, 8)]);
    }

    #[test]
    fn every_printable_character_has_a_glyph_of_its_own() {
        let glyphs: std::collections::BTreeSet<u64> = (' '..='~').map(glyph).collect();
        assert_eq!(glyphs.len(), 95);
    }
}
