//! Display lists: which are called, and what they hold.

use super::pictures::{Pictures, Pixel, all, random_colors, window};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;
use gl_api::types::GLenum;

/// Names of lists.
pub const CALLS: Check = Check {
    name: "call-lists",
    citation: "GL 2.1, 5.4: glListBase and the types of glCallLists: GL_2_BYTES to GL_4_BYTES have the highest byte first; \
               names without a list call nothing; a list that calls others",
    what: "how often each of 200 lists is called by random offsets of all ten types, from random bases, in lists and outside",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "calls are counted in 64ths, which f32 adds exactly",
    run: calls,
};

/// What lists hold.
pub const MEMORY: Check = Check {
    name: "list-memory",
    citation: "GL 2.1, 5.4: commands of a list have the client's memory and state of the time when it is compiled",
    what: "every pixel of images and of arrays of points that a list holds, whose memory, pointers and row lengths were changed before it is called",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "floats are copied",
    run: memory,
};

const PICTURE: Pixel = [20, 10];

/// What one call adds to the red of its pixel.
const STEP: f64 = 1.0 / 64.0;

/// The types of offsets, and the least and largest that each is given.
const TYPES: [(GLenum, [i64; 2]); 10] = [
    (GL_BYTE, [-128, 127]),
    (GL_UNSIGNED_BYTE, [0, 255]),
    (GL_SHORT, [-300, 300]),
    (GL_UNSIGNED_SHORT, [0, 300]),
    (GL_INT, [-300, 300]),
    (GL_UNSIGNED_INT, [0, 300]),
    (GL_FLOAT, [-300, 300]),
    (GL_2_BYTES, [0, 300]),
    (GL_3_BYTES, [0, 300]),
    (GL_4_BYTES, [0, 300]),
];

/// An offset in the bytes of a type.
fn encoded(ty: GLenum, offset: i64) -> Vec<u8> {
    let high_first = |bytes: usize| offset.to_be_bytes()[8 - bytes..].to_vec();
    match ty {
        GL_BYTE | GL_UNSIGNED_BYTE => vec![offset as u8],
        GL_SHORT | GL_UNSIGNED_SHORT => (offset as u16).to_ne_bytes().into(),
        GL_INT | GL_UNSIGNED_INT => (offset as u32).to_ne_bytes().into(),
        GL_FLOAT => (offset as f32).to_ne_bytes().into(),
        GL_2_BYTES => high_first(2),
        GL_3_BYTES => high_first(3),
        _ => high_first(4),
    }
}

/// The offset that a call has of what [`encoded`] gives.
fn decoded(ty: GLenum, offset: i64, variant: Variant) -> i64 {
    let bytes = offset.to_be_bytes();
    let low_first = |count: usize| {
        bytes[8 - count..].iter().rev().fold(0, |sum, &byte| sum * 256 + i64::from(byte))
    };
    match ty {
        GL_2_BYTES if variant.has(Mutation::LowByteFirst) => low_first(2),
        GL_3_BYTES if variant.has(Mutation::LowByteFirst) => low_first(3),
        GL_4_BYTES if variant.has(Mutation::LowByteFirst) => low_first(4),
        GL_BYTE if variant.has(Mutation::OffsetUnsigned) => offset & 0xFF,
        _ => offset,
    }
}

fn calls(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("call-lists");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(60).max(20) {
        let (ty, [least, largest]) = TYPES[round % TYPES.len()];
        let is_nested = round / TYPES.len() % 2 == 1;
        // List `first + n` draws to pixel n.
        let first = rng.integer(1, 400);
        let base = (first + rng.integer(-100, 200)).max(0);
        let offsets: Vec<i64> = (0..300).map(|_| rng.integer(least, largest)).collect();
        let expect = |[x, y]: Pixel, variant: Variant| {
            let list = first + (y * PICTURE[0] + x) as i64;
            let base = if variant.has(Mutation::ListBaseIgnored) { 0 } else { base };
            let calls_it = |offset: &&i64| base + decoded(ty, **offset, variant) == list;
            Some([offsets.iter().filter(calls_it).count() as f64 * STEP, 0.0, 0.0, 0.0])
        };
        pictures.compare(&(enum_name(ty), first, base, is_nested), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE);
            glColor4f(STEP as f32, 0, 0, 0);
            for [x, y] in all(PICTURE) {
                glNewList(first as u32 + (y * PICTURE[0] + x) as u32, GL_COMPILE);
                glRecti(x as i32, y as i32, x as i32 + 1, y as i32 + 1);
                glEndList();
            }
            let bytes: Vec<u8> = offsets.iter().flat_map(|&offset| encoded(ty, offset)).collect();
            let outer = 5000;
            if is_nested {
                // The base is the server's state.
                glNewList(outer, GL_COMPILE);
                glCallLists(offsets.len() as i32, ty, &bytes[..]);
                glEndList();
                glListBase(base as u32);
                glCallList(outer);
            } else {
                glListBase(base as u32);
                glCallLists(offsets.len() as i32, ty, &bytes[..]);
            }
            let picture = session.read_floats(PICTURE);
            glDeleteLists(first as u32, (PICTURE[0] * PICTURE[1]) as i32);
            glDeleteLists(outer, 1);
            picture
        })?;
    }
    pictures.finish(100, 20);
    Ok(())
}

/// How a list draws a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Drawn {
    /// As an image.
    Image,
    /// As an array of points.
    Array,
}

fn memory(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("list-memory");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(24).max(8) {
        let drawn = [Drawn::Image, Drawn::Array][round % 2];
        let then = random_colors(&mut rng, PICTURE, [0.0, 1.0]);
        let later = random_colors(&mut rng, PICTURE, [0.0, 1.0]);
        let expect = |[x, y]: Pixel, variant: Variant| {
            let colors = if variant.has(Mutation::MemoryReadByCall) { &later } else { &then };
            Some(colors[y * PICTURE[0] + x].map(f64::from))
        };
        pictures.compare(&(drawn, round), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            window(PICTURE);
            let [width, height] = PICTURE.map(|size| size as i32);
            let places: Vec<[f32; 2]> =
                all(PICTURE).map(|place| place.map(|c| c as f32 + 0.5)).collect();
            let mut memory = then.clone();
            glRasterPos2i(0, 0);
            glNewList(7, GL_COMPILE);
            match drawn {
                Drawn::Image => {
                    glDrawPixels(width, height, GL_RGBA, GL_FLOAT, memory.as_flattened());
                }
                Drawn::Array => {
                    glEnableClientState(GL_VERTEX_ARRAY);
                    glEnableClientState(GL_COLOR_ARRAY);
                    glVertexPointer(2, GL_FLOAT, 0, places.as_flattened());
                    glColorPointer(4, GL_FLOAT, 0, memory.as_flattened());
                    glDrawArrays(GL_POINTS, 0, width * height);
                    glDisableClientState(GL_VERTEX_ARRAY);
                    glDisableClientState(GL_COLOR_ARRAY);
                }
            }
            glEndList();
            memory.copy_from_slice(&later);
            glPixelStorei(GL_UNPACK_ROW_LENGTH, 3);
            glPixelStorei(GL_UNPACK_SKIP_PIXELS, 5);
            glCallList(7);
            let picture = session.read_floats(PICTURE);
            glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
            glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
            glDeleteLists(7, 1);
            picture
        })?;
    }
    pictures.finish(100, 90);
    Ok(())
}
