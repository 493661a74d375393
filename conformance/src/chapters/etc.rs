//! ETC1, ETC2 and EAC: random blocks of every mode, each of their 16 texels sampled.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::eac::{self, Numbers};
use crate::oracle::etc::{Alpha, Block, Mode};
use crate::oracle::srgb;
use crate::probe::{Dialect, ProbeError};
use crate::rng::Rng;
use gl_api::constants::*;

const WHY: &str = "one rounding of the exact fraction to f32; the table of sRGB is of constants that are rounded once";

/// Colours.
pub const RGB: Check = Check {
    name: "etc2-rgb",
    citation: "OpenGL ES 3.0, C.1.1 and C.1.2; OES_compressed_ETC1_RGB8_texture",
    what: "each texel of blocks of the individual, differential, T, H and planar modes",
    unit: Unit::Ulp,
    tolerance: 0.5,
    why: WHY,
    run: |harness, tally| run(harness, tally, &FORMATS[..3]),
};

/// Colours with one bit of alpha.
pub const PUNCHTHROUGH: Check = Check {
    name: "etc2-punchthrough",
    citation: "OpenGL ES 3.0, C.1.9 and C.1.10: RGB8A1",
    what: "each texel of blocks of the differential, T, H and planar modes, opaque or not",
    unit: Unit::Ulp,
    tolerance: 0.5,
    why: WHY,
    run: |harness, tally| run(harness, tally, &FORMATS[3..5]),
};

/// Colours with alpha.
pub const RGBA: Check = Check {
    name: "etc2-eac-alpha",
    citation: "OpenGL ES 3.0, C.1.3 and C.1.4: RGBA8 with EAC alpha",
    what: "each texel of blocks of alpha with every table and multiplier, before blocks of colour",
    unit: Unit::Ulp,
    tolerance: 0.5,
    why: WHY,
    run: |harness, tally| run(harness, tally, &FORMATS[5..7]),
};

/// Channels of 11 bits.
pub const EAC: Check = Check {
    name: "eac-11-bits",
    citation: "OpenGL ES 3.0, C.1.5 to C.1.8: R11 and RG11 EAC, unsigned and signed",
    what: "each texel of blocks with every table and multiplier, 0 among them",
    unit: Unit::Ulp,
    tolerance: 0.5,
    why: WHY,
    run: |harness, tally| run(harness, tally, &FORMATS[7..]),
};

/// What a block consists of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Coding {
    /// Colours of the individual and the differential mode: ETC1 leaves open what the others are.
    Etc1,
    Colors(Alpha),
    AlphaThenColors,
    Channels(Numbers, usize),
}

/// How colours are encoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Curve {
    Linear,
    Srgb,
}

const FORMATS: [(u32, Coding, Curve); 11] = [
    (GL_ETC1_RGB8_OES, Coding::Etc1, Curve::Linear),
    (GL_COMPRESSED_RGB8_ETC2, Coding::Colors(Alpha::None), Curve::Linear),
    (GL_COMPRESSED_SRGB8_ETC2, Coding::Colors(Alpha::None), Curve::Srgb),
    (
        GL_COMPRESSED_RGB8_PUNCHTHROUGH_ALPHA1_ETC2,
        Coding::Colors(Alpha::Punchthrough),
        Curve::Linear,
    ),
    (
        GL_COMPRESSED_SRGB8_PUNCHTHROUGH_ALPHA1_ETC2,
        Coding::Colors(Alpha::Punchthrough),
        Curve::Srgb,
    ),
    (GL_COMPRESSED_RGBA8_ETC2_EAC, Coding::AlphaThenColors, Curve::Linear),
    (GL_COMPRESSED_SRGB8_ALPHA8_ETC2_EAC, Coding::AlphaThenColors, Curve::Srgb),
    (GL_COMPRESSED_R11_EAC, Coding::Channels(Numbers::Unsigned11, 1), Curve::Linear),
    (GL_COMPRESSED_SIGNED_R11_EAC, Coding::Channels(Numbers::Signed11, 1), Curve::Linear),
    (GL_COMPRESSED_RG11_EAC, Coding::Channels(Numbers::Unsigned11, 2), Curve::Linear),
    (GL_COMPRESSED_SIGNED_RG11_EAC, Coding::Channels(Numbers::Signed11, 2), Curve::Linear),
];

impl Coding {
    fn bytes(self) -> usize {
        match self {
            Self::Etc1 | Self::Colors(_) | Self::Channels(_, 1) => 8,
            Self::AlphaThenColors | Self::Channels(..) => 16,
        }
    }

    /// The modes that its blocks of colours have, and where in the block they begin.
    fn modes(self) -> (&'static [Mode], Alpha, usize) {
        match self {
            Self::Etc1 => (&Mode::ALL[..2], Alpha::None, 0),
            Self::Colors(Alpha::None) => (&Mode::ALL, Alpha::None, 0),
            Self::Colors(Alpha::Punchthrough) => (&Mode::ALL[1..], Alpha::Punchthrough, 0),
            Self::AlphaThenColors => (&Mode::ALL, Alpha::None, 8),
            Self::Channels(..) => (&[], Alpha::None, 0),
        }
    }

    fn texel(self, block: &[u8], at: [usize; 2], variant: Variant) -> [f64; 4] {
        let colors = |alpha, block| {
            Block::new(block).decode(alpha, at, variant).map(|c| f64::from(c) / 255.0)
        };
        match self {
            Self::Etc1 => colors(Alpha::None, block),
            Self::Colors(alpha) => colors(alpha, block),
            Self::AlphaThenColors => {
                let [r, g, b, _] = colors(Alpha::None, &block[8..]);
                [r, g, b, eac::decode(Numbers::Alpha8, block, at, variant)]
            }
            Self::Channels(numbers, 1) => [eac::decode(numbers, block, at, variant), 0.0, 0.0, 1.0],
            Self::Channels(numbers, _) => {
                let channel = |block: &[u8]| eac::decode(numbers, block, at, variant);
                [channel(block), channel(&block[8..]), 0.0, 1.0]
            }
        }
    }
}

/// Blocks in a row of the texture.
const ACROSS: usize = 16;

fn run(
    harness: &Harness,
    tally: &mut Tally,
    formats: &[(u32, Coding, Curve)],
) -> Result<(), ProbeError> {
    let mut rng = Rng::named("etc");
    for &(internal, coding, curve) in formats {
        let rows = harness.cases(32);
        let size = [4 * ACROSS, 4 * rows];
        let bytes = blocks(&mut rng, coding, ACROSS * rows);
        count(tally, internal, coding, &bytes);
        let cases: Vec<[usize; 2]> =
            (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| [x, y])).collect();
        let expect = |&[x, y]: &[usize; 2], variant: Variant| {
            let number = y / 4 * ACROSS + x / 4;
            let block = &bytes[number * coding.bytes()..][..coding.bytes()];
            let texel = coding.texel(block, [x % 4, y % 4], variant);
            match curve {
                Curve::Linear => texel,
                Curve::Srgb => srgb::decode_texel(texel, variant),
            }
        };
        harness.compare_with(
            Dialect::Es,
            tally,
            &enum_name(internal),
            &cases,
            expect,
            |session| {
                session.compressed_texture(internal, size, &bytes)?;
                let texel = |c: usize| f32::from_bits(c as u32);
                let inputs: Vec<_> = cases
                    .iter()
                    .map(|&[x, y]| [[texel(x), texel(y), 0.0, 0.0], [0.0; 4]])
                    .collect();
                let body = "uniform sampler2D image;
                 vec4 value(vec4 a, vec4 b) {
                     return texelFetch(image, floatBitsToInt(a.xy), 0);
                 }";
                session.float_words(body, &inputs)
            },
        )?;
    }
    Ok(())
}

/// Random blocks. Of random colours nearly a half are of the T mode, as red comes first: every mode gets as many.
fn blocks(rng: &mut Rng, coding: Coding, count: usize) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(count * coding.bytes());
    for number in 0..count {
        match coding {
            Coding::Etc1 | Coding::Colors(_) => bytes.extend(colors(rng, coding, number)),
            Coding::AlphaThenColors => {
                bytes.extend(numbers(rng, number));
                bytes.extend(colors(rng, coding, number));
            }
            Coding::Channels(_, channels) => {
                for _ in 0..channels {
                    bytes.extend(numbers(rng, number));
                }
            }
        }
    }
    bytes
}

fn colors(rng: &mut Rng, coding: Coding, number: usize) -> [u8; 8] {
    let (modes, alpha, _) = coding.modes();
    let wanted = modes[number % modes.len()];
    loop {
        let mut block = [0; 8].map(|_: u8| rng.byte());
        if wanted == Mode::Planar {
            // A plane has no transparent texels: the bit that says so is set.
            block[3] |= 2;
        }
        if Block::new(&block).mode(alpha, Variant::CORRECT) == wanted {
            return block;
        }
    }
}

fn numbers(rng: &mut Rng, number: usize) -> [u8; 8] {
    let mut block = [0; 8].map(|_: u8| rng.byte());
    // Multipliers and bases at their ends more often than by chance.
    match number % 8 {
        0 => block[1] &= 0x0f,
        1 => block[0] = 0x80,
        2 => block[0] = rng.pick(&[0, 0x7f, 0x81, 0xff]),
        _ => {}
    }
    block
}

/// Counts the blocks of each mode, and those whose multiplier is 0 or base -128.
fn count(tally: &mut Tally, internal: u32, coding: Coding, bytes: &[u8]) {
    let name = enum_name(internal);
    let blocks = || bytes.chunks_exact(coding.bytes());
    let part = blocks().len() / 10;
    let (modes, alpha, first) = coding.modes();
    for mode in modes {
        let of = |block: &&[u8]| Block::new(&block[first..]).mode(alpha, Variant::CORRECT) == *mode;
        tally.reach(format!("{name}, {mode:?}"), blocks().filter(of).count(), part);
    }
    match coding {
        Coding::Etc1 | Coding::Colors(_) => {}
        Coding::AlphaThenColors | Coding::Channels(..) => {
            let zero = blocks().filter(|block| block[1] >> 4 == 0).count();
            tally.reach(format!("{name}, multiplier 0"), zero, part);
            let least = blocks().filter(|block| block[0] == 0x80).count();
            tally.reach(format!("{name}, base -128"), least, part);
        }
    }
}
