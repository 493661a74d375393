//! Captions in pictures: a line of text on a dark box, drawn with `glBitmap`.

use crate::font;
use gl_api::constants::*;
use gl_api::types::GLint;
use gl_api::*;

/// A rectangle of the window: left, bottom, width, height.
pub(crate) type Area = [i32; 4];

/// Text, and the area in whose lower left corner it stands.
#[derive(Clone, Debug)]
pub(crate) struct Caption {
    pub(crate) area: Area,
    pub(crate) text: String,
}

/// The dots of one line: rows from the bottom up, eight dots a byte, as `glBitmap` reads them.
struct Line {
    width: i32,
    height: i32,
    bytes: Vec<u8>,
}

/// Draws captions into the window; `dot` is the side of a letter's dot in pixels.
pub(crate) fn draw(captions: &[Caption], dot: i32) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glUseProgram(0);
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    for unit in 0..4 {
        glActiveTexture(GL_TEXTURE0 + unit);
        for target in [GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP] {
            glDisable(target);
        }
    }
    for capability in [GL_DEPTH_TEST, GL_BLEND, GL_ALPHA_TEST, GL_STENCIL_TEST, GL_FOG] {
        glDisable(capability);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glEnable(GL_SCISSOR_TEST);
    for Caption { area: [left, bottom, width, _], text } in captions {
        let fits = (width / dot - 3) / (font::COLUMNS as i32 + 1);
        let lines = wrap(text, fits.max(1) as usize);
        let step = (font::ROWS as i32 + 2) * dot;
        for (above, line) in (0..).zip(lines.iter().rev()) {
            let line = bitmap(line, dot);
            let [x, y] = [left + dot, bottom + dot + above * step];
            glScissor(x, y, (line.width + 2 * dot).min(width - 2 * dot), step);
            glClearColor(0.04, 0.05, 0.08, 1);
            glClear(GL_COLOR_BUFFER_BIT);
            glColor4f(0.96, 0.97, 1.0, 1);
            glWindowPos2i(x + dot, y + dot);
            glBitmap(line.width, line.height, 0, 0, 0, 0, &line.bytes);
        }
    }
    glPopAttrib();
}

/// Lines of at most so many letters, broken between words.
fn wrap(text: &str, letters: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for line in text.split('\n') {
        let mut line_now = String::new();
        for word in line.split(' ') {
            let together = line_now.chars().count() + 1 + word.chars().count();
            if !line_now.is_empty() && together > letters {
                lines.push(std::mem::take(&mut line_now));
            } else if !line_now.is_empty() {
                line_now.push(' ');
            }
            line_now.push_str(word);
        }
        lines.push(line_now);
    }
    lines
}

fn bitmap(text: &str, dot: i32) -> Line {
    let letters: Vec<[u8; font::COLUMNS]> = text.chars().map(font::dots).collect();
    let columns: Vec<u8> = letters
        .iter()
        .flat_map(|letter| letter.iter().copied().chain([0]))
        .flat_map(|column| std::iter::repeat_n(column, dot as usize))
        .collect();
    let (width, height) = (columns.len() as GLint, font::ROWS as i32 * dot);
    let mut bytes = Vec::new();
    for y in 0..height {
        let row = font::ROWS as i32 - 1 - y / dot;
        for eight in columns.chunks(8) {
            let bit = |(at, column): (usize, &u8)| (column >> row & 1) << (7 - at);
            bytes.push(eight.iter().enumerate().map(bit).sum());
        }
    }
    Line { width, height, bytes }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::programs;

    #[test]
    fn lines_are_broken_between_words() {
        assert_eq!(wrap("one two three", 7), ["one two", "three"]);
        assert_eq!(wrap("unbreakable", 3), ["unbreakable"]);
    }

    #[test]
    fn every_caption_has_letters_that_there_are() {
        for program in programs::ALL {
            for letter in program.panels.iter().flat_map(|panel| panel.chars()) {
                assert!(font::has(letter), "{}: no letter {letter:?}", program.name);
            }
        }
    }

    #[test]
    fn a_letter_stands_upright() {
        let line = bitmap("L", 1);
        assert_eq!((line.width, line.height), (6, 8));
        // From the bottom up: the row below the line, the foot, the stem.
        assert_eq!(line.bytes[..3], [0b0000_0000, 0b1111_1000, 0b1000_0000]);
    }
}
