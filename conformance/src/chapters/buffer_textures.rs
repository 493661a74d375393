//! Textures of buffers.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::packing::half;
use crate::probe::{Dialect, ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;

/// Texels of buffers.
pub const FETCH: Check = Check {
    name: "texture-buffer",
    citation: "GL 3.1, 3.8.4, table 3.15; table 3.20",
    what: "texelFetch of random texels of 12 formats of a buffer, and the components that a format lacks",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 24) as f64,
    why: "a code over the largest one, rounded to f32: twice half of its step below 1, as a reciprocal may be rounded, too; floats come as they are",
    run,
};

/// How a component is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stored {
    Byte,
    Short,
    Half,
    Float,
}

const FORMATS: [(u32, usize, Stored); 12] = [
    (GL_R8, 1, Stored::Byte),
    (GL_RG8, 2, Stored::Byte),
    (GL_RGBA8, 4, Stored::Byte),
    (GL_R16, 1, Stored::Short),
    (GL_RG16, 2, Stored::Short),
    (GL_RGBA16, 4, Stored::Short),
    (GL_R16F, 1, Stored::Half),
    (GL_RG16F, 2, Stored::Half),
    (GL_RGBA16F, 4, Stored::Half),
    (GL_R32F, 1, Stored::Float),
    (GL_RG32F, 2, Stored::Float),
    (GL_RGBA32F, 4, Stored::Float),
];

impl Stored {
    fn size(self) -> usize {
        match self {
            Self::Byte => 1,
            Self::Short | Self::Half => 2,
            Self::Float => 4,
        }
    }

    /// The bytes of a component; of floats finite ones of the size of full scale.
    fn bytes(self, rng: &mut Rng) -> Vec<u8> {
        match self {
            Self::Byte => vec![rng.integer(0, 255) as u8],
            Self::Short => (rng.integer(0, 65535) as u16).to_ne_bytes().to_vec(),
            // Up to 1, of both signs, denormals among them.
            Self::Half => {
                let sign = rng.integer(0, 1) as u16;
                (rng.integer(0, 0x3C00) as u16 | sign << 15).to_ne_bytes().to_vec()
            }
            Self::Float => rng.real(-1.0, 1.0).to_ne_bytes().to_vec(),
        }
    }

    fn number(self, bytes: &[u8], variant: Variant) -> f64 {
        let code =
            |most: f64| most + if variant.has(Mutation::UnormOfPowerOfTwo) { 1.0 } else { 0.0 };
        match *bytes {
            [byte] => f64::from(byte) / code(255.0),
            [a, b] if self == Self::Short => f64::from(u16::from_ne_bytes([a, b])) / code(65535.0),
            [a, b] => half(u16::from_ne_bytes([a, b]), variant),
            [a, b, c, d] => f32::from_ne_bytes([a, b, c, d]).into(),
            _ => f64::NAN,
        }
    }
}

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("texture-buffer");
    for (format, components, stored) in FORMATS {
        let count = harness.cases(512).max(64);
        let size = components * stored.size();
        let bytes: Vec<u8> = (0..count * components).flat_map(|_| stored.bytes(&mut rng)).collect();
        // Backwards and with steps, so that no fetch is of the place of the fragment.
        let cases: Vec<usize> = (0..count).map(|at| (count - 1 - at) * 5 % count).collect();
        let expect = |&texel: &usize, variant: Variant| {
            let missing_alpha =
                if variant.has(Mutation::MissingComponentsZero) { 0.0 } else { 1.0 };
            let mut value = [0.0, 0.0, 0.0, missing_alpha];
            let texel = &bytes[texel * size..][..size];
            for (value, bytes) in value.iter_mut().zip(texel.chunks(stored.size())) {
                *value = stored.number(bytes, variant);
            }
            value
        };
        let scene = (format, components, stored);
        harness.compare_with(Dialect::Core, tally, &scene, &cases, expect, |session| {
            bind(session, format, &bytes)?;
            let inputs: Vec<_> =
                cases.iter().map(|&at| [[at as f32, 0.0, 0.0, 0.0], [0.0; 4]]).collect();
            session.float_words(
                "uniform samplerBuffer image;
                 vec4 value(vec4 a, vec4 b) { return texelFetch(image, int(a.x)); }",
                &inputs,
            )
        })?;
    }
    Ok(())
}

fn bind(session: &Session, format: u32, bytes: &[u8]) -> Result<(), ProbeError> {
    let (mut buffer, mut texture) = (0u32, 0u32);
    glGenBuffers(1, &mut buffer);
    glBindBuffer(GL_TEXTURE_BUFFER, buffer);
    glBufferData(GL_TEXTURE_BUFFER, bytes.len(), bytes, GL_STATIC_DRAW);
    glGenTextures(1, &mut texture);
    glBindTexture(GL_TEXTURE_BUFFER, texture);
    glTexBuffer(GL_TEXTURE_BUFFER, format, buffer);
    session.check("specifying a texture of a buffer")
}
