//! Texture completeness.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::probe::{Dialect, ProbeError, Session};
use crate::rng::Rng;
use gl_api::constants::*;

/// Complete and incomplete textures.
pub const MIPMAPS: Check = Check {
    name: "completeness",
    citation: "GL 2.1, 3.8.10; GL 3.1, 3.8.10 and 2.11.4: (0, 0, 0, 1)",
    what: "random sets of levels, some missing, of other sizes or formats, with base and maximum level, with a mipmap filter and without",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "texels are floats, and a level has one colour",
    run,
};

/// Levels of a complete texture of [`SIZE`].
const LEVELS: usize = 5;
const SIZE: [usize; 2] = [16, 4];

/// A level as it is specified.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Level {
    size: [usize; 2],
    internal: u32,
}

/// A texture and its sampler.
#[derive(Clone, Debug)]
struct Image {
    levels: [Option<Level>; LEVELS],
    base: usize,
    max: usize,
    min_filter: u32,
}

impl Image {
    fn random(rng: &mut Rng) -> Self {
        // Most have one fault at most, so that many are complete.
        let faulty = rng.integer(-2, LEVELS as i64 - 1);
        let levels = std::array::from_fn(|number| {
            let right =
                Level { size: SIZE.map(|size| (size >> number).max(1)), internal: GL_RGBA32F };
            match rng.integer(0, 2) {
                _ if faulty != number as i64 => Some(right),
                0 => None,
                1 => Some(Level { size: [right.size[0], right.size[1] + 1], ..right }),
                _ => Some(Level { internal: GL_RGBA16F, ..right }),
            }
        });
        let base = rng.pick(&[0, 0, 1, 2]);
        let max = rng.pick(&[base, base + 1, LEVELS - 1, 1000]);
        let min_filter = rng.pick(&[
            GL_NEAREST,
            GL_LINEAR,
            GL_NEAREST_MIPMAP_NEAREST,
            GL_LINEAR_MIPMAP_LINEAR,
            GL_NEAREST_MIPMAP_LINEAR,
        ]);
        Self { levels, base, max, min_filter }
    }

    /// Whether it is complete.
    fn is_complete(&self, variant: Variant) -> bool {
        let first = if variant.has(Mutation::BaseLevelIgnored) { 0 } else { self.base };
        let Some(base) = self.levels[first] else { return false };
        if matches!(self.min_filter, GL_NEAREST | GL_LINEAR) {
            return true;
        }
        let largest = base.size[0].max(base.size[1]);
        let smallest_level = first + largest.ilog2() as usize;
        let last = match variant.has(Mutation::MaxLevelIgnored) {
            true => smallest_level,
            false => smallest_level.min(self.max),
        };
        (first + 1..=last).all(|number| {
            let size = base.size.map(|size| (size >> (number - first)).max(1));
            self.levels.get(number).copied().flatten().is_some_and(|level| {
                (level.size == size || variant.has(Mutation::LevelSizesIgnored))
                    && (level.internal == base.internal
                        || variant.has(Mutation::LevelFormatsIgnored))
            })
        })
    }

    fn expected(&self, variant: Variant) -> [f64; 4] {
        match self.is_complete(variant) {
            true => color(self.base).map(f64::from),
            false => [0.0, 0.0, 0.0, 1.0],
        }
    }

    fn bind(&self, session: &Session) -> Result<(), ProbeError> {
        let (target, mut name) = (GL_TEXTURE_2D, 0u32);
        glGenTextures(1, &mut name);
        glBindTexture(target, name);
        for (number, level) in self.levels.iter().enumerate() {
            let Some(Level { size: [width, height], internal }) = *level else { continue };
            let texels = color(number).repeat(width * height);
            glTexImage2D(
                target,
                number as i32,
                internal,
                width,
                height,
                0,
                GL_RGBA,
                GL_FLOAT,
                &texels,
            );
        }
        glTexParameteri(target, GL_TEXTURE_MIN_FILTER, self.min_filter);
        glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(target, GL_TEXTURE_BASE_LEVEL, self.base as i32);
        glTexParameteri(target, GL_TEXTURE_MAX_LEVEL, self.max as i32);
        session.check("specifying a texture of some levels")
    }
}

/// The colour of a level; halves hold it, too.
fn color(level: usize) -> [f32; 4] {
    [0.25 + level as f32 / 16.0, 0.5, 1.0 - level as f32 / 32.0, 0.125]
}

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("completeness");
    let (mut complete, mut incomplete) = (0, 0);
    let count = harness.cases(400).max(60);
    for _ in 0..count {
        let image = Image::random(&mut rng);
        match image.is_complete(Variant::CORRECT) {
            true => complete += 1,
            false => incomplete += 1,
        }
        let expect = |(): &(), variant: Variant| image.expected(variant);
        harness.compare_with(Dialect::Core, tally, &image, &[()], expect, |session| {
            image.bind(session)?;
            session.float_words(
                "uniform sampler2D image;
                 vec4 value(vec4 a, vec4 b) { return textureLod(image, a.xy, 0.0); }",
                &[[[0.5, 0.5, 0.0, 0.0], [0.0; 4]]],
            )
        })?;
    }
    tally.reach("complete", complete, count / 4);
    tally.reach("incomplete", incomplete, count / 8);
    Ok(())
}
