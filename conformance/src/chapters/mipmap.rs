//! Derived levels: `glGenerateMipmap`, `GL_GENERATE_MIPMAP` and GLU's.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::Variant;
use crate::oracle::mipmap::{Storage, Volume, closest_power};
use crate::probe::{MipmapRequest, ProbeError};
use crate::rng::Rng;
use gl_api::constants::*;

/// Mipmaps derived by GL.
pub const GENERATED: Check = Check {
    name: "mipmap-generate",
    citation: "GL 2.1, 3.8.8, automatic mipmap generation; EXT_texture_sRGB",
    what: "every texel of every derived level, 1D, 2D and 3D, even and odd sizes, bytes and sRGB",
    unit: Unit::Bytes,
    tolerance: 255.0 / (1 << 25) as f64,
    why: "the mean of bytes is exact and rounded once, halves up; a byte as f32 is off by 2^-25",
    run: |harness, tally| run(harness, tally, Generator::Gl),
};

/// Mipmaps of float textures.
pub const FLOATS: Check = Check {
    name: "mipmap-float",
    citation: "GL 2.1, 3.8.8; ARB_texture_float",
    what: "every texel of every derived level of float textures",
    unit: Unit::Ulp,
    tolerance: 1.0,
    why: "sums in f64, one rounding a level of what one rounding made of the level before",
    run: floats,
};

/// Mipmaps derived by GLU.
pub const GLU: Check = Check {
    name: "glu-mipmaps",
    citation: "GLU 1.3, 3.2: gluBuild1DMipmaps, gluBuild2DMipmaps, gluBuild3DMipmaps",
    what: "size and texels of every level: scaled to the closest powers of two, then halved",
    unit: Unit::Bytes,
    tolerance: 255.0 / (1 << 25) as f64,
    why: "the area mean of bytes is exact and rounded once, halves up; a byte as f32 is off by 2^-25",
    run: |harness, tally| run(harness, tally, Generator::Glu),
};

/// The library that derives the levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Generator {
    Gl,
    Glu,
}

const GL_SIZES: [(u32, [usize; 3]); 8] = [
    (GL_TEXTURE_2D, [16, 16, 1]),
    (GL_TEXTURE_2D, [32, 4, 1]),
    (GL_TEXTURE_2D, [7, 5, 1]),
    (GL_TEXTURE_2D, [33, 20, 1]),
    (GL_TEXTURE_2D, [1, 13, 1]),
    (GL_TEXTURE_1D, [37, 1, 1]),
    (GL_TEXTURE_3D, [8, 4, 8]),
    (GL_TEXTURE_3D, [7, 6, 5]),
];

const GLU_SIZES: [(u32, [usize; 3]); 9] = [
    (GL_TEXTURE_2D, [16, 8, 1]),
    (GL_TEXTURE_2D, [5, 7, 1]),
    (GL_TEXTURE_2D, [33, 20, 1]),
    (GL_TEXTURE_2D, [6, 1, 1]),
    (GL_TEXTURE_2D, [3, 11, 1]),
    (GL_TEXTURE_1D, [37, 1, 1]),
    (GL_TEXTURE_1D, [12, 1, 1]),
    (GL_TEXTURE_3D, [8, 4, 2]),
    (GL_TEXTURE_3D, [5, 6, 3]),
];

/// A texel of a level.
#[derive(Clone, Copy, Debug)]
struct Case {
    level: usize,
    texel: usize,
}

fn random(rng: &mut Rng, size: [usize; 3]) -> Volume {
    let count = size.iter().product();
    let texels = (0..count).map(|_| [0; 4].map(|_: i32| f64::from(rng.byte()) / 255.0)).collect();
    Volume { size, texels }
}

fn run(harness: &Harness, tally: &mut Tally, generator: Generator) -> Result<(), ProbeError> {
    let mut rng = Rng::named("mipmap");
    let (sizes, storages): (&[_], &[_]) = match generator {
        Generator::Gl => (&GL_SIZES, &[Storage::Bytes, Storage::SrgbBytes]),
        Generator::Glu => (&GLU_SIZES, &[Storage::Bytes]),
    };
    for (&(target, size), &storage) in
        sizes.iter().flat_map(|s| storages.iter().map(move |k| (s, k)))
    {
        let image = random(&mut rng, size);
        compare(harness, tally, generator, target, image, (storage, GL_RGBA))?;
    }
    if generator == Generator::Glu {
        // Fewer components, of the sizes that are halved without being scaled before, and of others.
        for (target, size) in [(GL_TEXTURE_2D, [16, 8, 1]), (GL_TEXTURE_2D, [5, 7, 1])] {
            for format in [GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB] {
                let mut image = random(&mut rng, size);
                for [r, g, b, a] in &mut image.texels {
                    if format != GL_RGB {
                        (*g, *b) = (*r, *r);
                    }
                    if format != GL_LUMINANCE_ALPHA {
                        *a = 1.0;
                    }
                }
                compare(harness, tally, generator, target, image, (Storage::Bytes, format))?;
            }
        }
    }
    Ok(())
}

fn floats(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("mipmap-float");
    for (target, size) in GL_SIZES {
        let mut image = random(&mut rng, size);
        for texel in &mut image.texels {
            *texel = [0; 4].map(|_: i32| f64::from(rng.real(0.0, 1000.0)));
        }
        compare(harness, tally, Generator::Gl, target, image, (Storage::Floats, GL_RGBA))?;
    }
    Ok(())
}

fn compare(
    harness: &Harness,
    tally: &mut Tally,
    generator: Generator,
    target: u32,
    image: Volume,
    (storage, format): (Storage, u32),
) -> Result<(), ProbeError> {
    let levels = |variant: Variant| match generator {
        Generator::Gl => image.chain(storage, variant),
        Generator::Glu => {
            let base =
                image.scaled(image.size.map(|n| closest_power(n, variant)), storage, variant);
            let rest = base.chain(storage, variant);
            [vec![base], rest].concat()
        }
    };
    let first = match generator {
        Generator::Gl => 1,
        Generator::Glu => 0,
    };
    let expected = levels(harness.variant);
    let truth = levels(Variant::CORRECT);
    let cases: Vec<Case> = truth
        .iter()
        .zip(first..)
        .flat_map(|(level, number)| {
            (0..level.texels.len()).map(move |texel| Case { level: number, texel })
        })
        .collect();
    let expect = |case: &Case, variant: Variant| {
        let all = if variant == Variant::CORRECT { &truth } else { &expected };
        let level = all.get(case.level - first);
        level.and_then(|level| level.texels.get(case.texel)).copied().unwrap_or([f64::NAN; 4])
    };
    harness.compare(
        tally,
        &(enum_name(target), image.size, storage, enum_name(format)),
        &cases,
        expect,
        |session| {
            let internal = match storage {
                Storage::Bytes => GL_RGBA8,
                Storage::Shorts => GL_RGBA16,
                Storage::SrgbBytes => GL_SRGB8_ALPHA8,
                Storage::Floats => GL_RGBA32F,
            };
            let request = MipmapRequest { target, internal, format, image: &image };
            match generator {
                Generator::Gl => session.generate_mipmaps(&request)?,
                Generator::Glu => session.glu_mipmaps(&request)?,
            }
            let mut values = Vec::new();
            for (level, number) in truth.iter().zip(first..) {
                values.extend(session.level_texels(target, number, level.size)?);
            }
            Ok(values)
        },
    )
}
