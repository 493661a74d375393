//! Client pixels: every format with every type, byte order, pixel store and pixel transfer.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::{Mutation, Variant};
use crate::oracle::pixel::{Components, Element, Store};
use crate::probe::{ClientPixels, ProbeError, StoredBox};
use crate::rng::Rng;
use gl_api::constants::*;

/// Unpacking.
pub const UNPACK: Check = Check {
    name: "client-unpack",
    citation: "GL 2.1, 3.6.4, tables 2.9 and 3.5 to 3.11",
    what: "random pixels of every client format and type, swapped or not, stored as floats",
    unit: Unit::Ulp,
    tolerance: 0.5,
    why: "one rounding of the exact fraction to f32",
    run: unpack,
};

/// Packing.
pub const PACK: Check = Check {
    name: "client-pack",
    citation: "GL 2.1, 4.3.2 and 6.1.4, tables 4.7 and 6.1",
    what: "integers that glGetTexImage writes for every client format and type, swapped or not",
    unit: Unit::Codes,
    tolerance: 0.5,
    why: "the nearest integer to a product in f64",
    run: pack,
};

/// Pixel store parameters.
pub const STORE: Check = Check {
    name: "pixel-store",
    citation: "GL 2.1, 3.6.4: k = (a/s)·ceil(s·n·l/a)",
    what: "3D images under random alignment, row length, image height and skips, both ways",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "bytes are copied",
    run: store,
};

/// Pixel transfer with scale and bias.
pub const TRANSFER: Check = Check {
    name: "pixel-transfer",
    citation: "GL 2.1, 3.6.5: scale and bias, then final clamp",
    what: "random scales and biases of R, G, B, A on the way into GL_RGBA8",
    unit: Unit::Bytes,
    tolerance: 0.5 + 1.0 / (1 << 14) as f64,
    why: "8-bit texels: half a step; f32: a product and a sum of up to 4 are rounded by 2^-23 each, which is 2^-14 of 255",
    run: transfer,
};

const FORMATS: [(u32, Components); 11] = [
    (GL_RED, Components::Colors(&[0])),
    (GL_GREEN, Components::Colors(&[1])),
    (GL_BLUE, Components::Colors(&[2])),
    (GL_ALPHA, Components::Colors(&[3])),
    (GL_RG, Components::Colors(&[0, 1])),
    (GL_RGB, Components::Colors(&[0, 1, 2])),
    (GL_BGR, Components::Colors(&[2, 1, 0])),
    (GL_RGBA, Components::Colors(&[0, 1, 2, 3])),
    (GL_BGRA, Components::Colors(&[2, 1, 0, 3])),
    (GL_LUMINANCE, Components::Luminance),
    (GL_LUMINANCE_ALPHA, Components::LuminanceAlpha),
];

const TYPES: [(u32, Element); 20] = [
    (GL_UNSIGNED_BYTE, Element::Unsigned(8)),
    (GL_BYTE, Element::Signed(8)),
    (GL_UNSIGNED_SHORT, Element::Unsigned(16)),
    (GL_SHORT, Element::Signed(16)),
    (GL_UNSIGNED_INT, Element::Unsigned(32)),
    (GL_INT, Element::Signed(32)),
    (GL_HALF_FLOAT, Element::Half),
    (GL_FLOAT, Element::Single),
    (GL_UNSIGNED_BYTE_3_3_2, Element::Packed(1, &[3, 3, 2])),
    (GL_UNSIGNED_BYTE_2_3_3_REV, Element::Reversed(1, &[3, 3, 2])),
    (GL_UNSIGNED_SHORT_5_6_5, Element::Packed(2, &[5, 6, 5])),
    (GL_UNSIGNED_SHORT_5_6_5_REV, Element::Reversed(2, &[5, 6, 5])),
    (GL_UNSIGNED_SHORT_4_4_4_4, Element::Packed(2, &[4, 4, 4, 4])),
    (GL_UNSIGNED_SHORT_4_4_4_4_REV, Element::Reversed(2, &[4, 4, 4, 4])),
    (GL_UNSIGNED_SHORT_5_5_5_1, Element::Packed(2, &[5, 5, 5, 1])),
    (GL_UNSIGNED_SHORT_1_5_5_5_REV, Element::Reversed(2, &[5, 5, 5, 1])),
    (GL_UNSIGNED_INT_8_8_8_8, Element::Packed(4, &[8, 8, 8, 8])),
    (GL_UNSIGNED_INT_8_8_8_8_REV, Element::Reversed(4, &[8, 8, 8, 8])),
    (GL_UNSIGNED_INT_10_10_10_2, Element::Packed(4, &[10, 10, 10, 2])),
    (GL_UNSIGNED_INT_2_10_10_10_REV, Element::Reversed(4, &[10, 10, 10, 2])),
];

/// Every pair of format and type that go together, with bytes in both orders.
fn pairs() -> impl Iterator<Item = (ClientPixels, Components, Element)> {
    FORMATS.into_iter().flat_map(|(format, components)| {
        let fitting = TYPES.into_iter().filter(move |(_, element)| element.fits(components));
        fitting.flat_map(move |(ty, element)| {
            [false, true].map(|swapped| (ClientPixels { format, ty, swapped }, components, element))
        })
    })
}

fn unpack(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("client-unpack");
    for (pixels, components, element) in pairs() {
        let size = element.pixel_bytes(components);
        let cases: Vec<Vec<u8>> = (0..harness.cases(64))
            .map(|_| pixel(&mut rng, element, size, pixels.swapped))
            .collect();
        let expect = |case: &Vec<u8>, variant: Variant| {
            components.expand(element.unpack(case, pixels.swapped, variant), variant)
        };
        harness.compare(tally, &pixels, &cases, expect, |session| {
            session.unpacked(pixels, cases.len(), &cases.concat())
        })?;
    }
    Ok(())
}

/// Random bytes, floats no NaN and of moderate size.
fn pixel(rng: &mut Rng, element: Element, size: usize, swapped: bool) -> Vec<u8> {
    let mut bytes: Vec<u8> = (0..size).map(|_| rng.byte()).collect();
    for word in bytes.chunks_exact_mut(element.size()) {
        match element {
            Element::Single => word.copy_from_slice(&rng.real(-2.0, 2.0).to_ne_bytes()),
            Element::Half => {
                let bits = u16::from(rng.byte()) | (rng.integer(0, 0x3b) as u16) << 8;
                word.copy_from_slice(&bits.to_ne_bytes());
            }
            Element::Unsigned(_) | Element::Signed(_) => continue,
            Element::Packed(..) | Element::Reversed(..) => continue,
        }
        if swapped {
            word.reverse();
        }
    }
    bytes
}

fn pack(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("client-pack");
    let integers =
        pairs().filter(|(_, _, element)| !matches!(element, Element::Half | Element::Single));
    for (pixels, components, element) in integers {
        let cases: Vec<[f32; 4]> =
            (0..harness.cases(64)).map(|_| [0; 4].map(|_: i32| rng.real(-0.25, 1.25))).collect();
        let size = element.pixel_bytes(components);
        let expect = |case: &[f32; 4], variant: Variant| {
            let c = components.select(case.map(f64::from), variant);
            let mut codes = element.ideal_codes(c, components.count());
            if variant.has(Mutation::BgrAsRgb) && pixels.format == GL_BGRA {
                codes.swap(0, 2);
            }
            codes
        };
        harness.compare(tally, &pixels, &cases, expect, |session| {
            let bytes = session.packed(pixels, &cases, size)?;
            Ok(bytes.chunks_exact(size).map(|p| element.codes(p, pixels.swapped)).collect())
        })?;
    }
    Ok(())
}

/// A texel of an image.
type TexelPosition = [usize; 3];

fn store(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("pixel-store");
    for round in 0..harness.cases(64) {
        let size = [0; 3].map(|_: i32| rng.integer(1, 5) as usize);
        let store = Store {
            alignment: rng.pick(&[1, 2, 4, 8]),
            row_length: rng.pick(&[0, size[0] + 1, size[0] + 4]),
            image_height: rng.pick(&[0, size[1] + 2]),
            skip: [0; 3].map(|_: i32| rng.integer(0, 3) as usize),
        };
        let (format, ty, element, pixel) = rng.pick(&[
            (GL_RGB, GL_UNSIGNED_BYTE, 1, 3),
            (GL_RED, GL_UNSIGNED_SHORT, 2, 2),
            (GL_RGBA, GL_UNSIGNED_BYTE, 1, 4),
        ]);
        let place = |at: TexelPosition, variant| {
            store.place(at, [size[0], size[1]], element, pixel, variant)
        };
        // With a mistake built in, an index may lie beyond the last pixel.
        let last = place(size.map(|n| n - 1), Variant::CORRECT) + pixel;
        let memory: Vec<u8> = (0..last + 4096).map(|_| rng.byte()).collect();
        let cases: Vec<TexelPosition> = (0..size[2])
            .flat_map(|z| (0..size[1]).flat_map(move |y| (0..size[0]).map(move |x| [x, y, z])))
            .collect();
        let expect = |&at: &TexelPosition, variant: Variant| {
            let mut out = [0.0; 4];
            for (out, &byte) in out.iter_mut().zip(&memory[place(at, variant)..][..pixel]) {
                *out = f64::from(byte);
            }
            out
        };
        let pixels = ClientPixels { format, ty, swapped: false };
        let request = StoredBox { pixels, size, store, pixel };
        harness.compare(tally, &request, &cases, expect, |session| {
            let found = if round % 2 == 0 {
                session.unpacked_box(&request, &memory[..last])?
            } else {
                let tight: Vec<u8> = cases
                    .iter()
                    .flat_map(|&at| memory[place(at, Variant::CORRECT)..][..pixel].to_vec())
                    .collect();
                let written = session.packed_box(&request, &tight, last)?;
                cases
                    .iter()
                    .flat_map(|&at| written[place(at, Variant::CORRECT)..][..pixel].to_vec())
                    .collect()
            };
            let value = |p: &[u8]| std::array::from_fn(|i| p.get(i).map_or(0.0, |&c| c.into()));
            Ok(found.chunks_exact(pixel).map(value).collect())
        })?;
    }
    Ok(())
}

fn transfer(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("pixel-transfer");
    for _ in 0..8 {
        let scale = [0; 4].map(|_: i32| rng.real(-2.0, 2.0));
        let bias = [0; 4].map(|_: i32| rng.real(-0.5, 1.0));
        let cases: Vec<[u8; 4]> =
            (0..harness.cases(256)).map(|_| [0; 4].map(|_: i32| rng.byte())).collect();
        let expect = |case: &[u8; 4], variant: Variant| {
            std::array::from_fn(|i| {
                let (c, scale, bias) =
                    (f64::from(case[i]) / 255.0, f64::from(scale[i]), f64::from(bias[i]));
                if variant.has(Mutation::BiasBeforeScale) {
                    ((c + bias) * scale).clamp(0.0, 1.0)
                } else {
                    (c * scale + bias).clamp(0.0, 1.0)
                }
            })
        };
        harness.compare(tally, &(scale, bias), &cases, expect, |session| {
            session.transferred(scale, bias, &cases)
        })?;
    }
    Ok(())
}
