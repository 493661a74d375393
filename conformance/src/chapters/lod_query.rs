//! `textureQueryLOD`: the level of detail before and after the clamp.

use super::pictures::{Pictures, Pixel};
use super::texture_pictures::{Given, Map, PICTURE, image, mipmapped, repeating};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::lod::{Derivatives, Filter, LodState, Mipmap};
use crate::oracle::sample;
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Queries.
pub const QUERY: Check = Check {
    name: "lod-query",
    citation: "ARB_texture_query_lod: x is the level that would be accessed, y is λ' relative to the base level",
    what: "both at every pixel of turned squares, under clamps and biases, of trilinear textures",
    unit: Unit::Levels,
    tolerance: 1.0 / (1 << 21) as f64,
    why: "f32: λ below 8 is rounded by 2^-22 by the logarithm and by the bias",
    run: query,
};

fn query(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("lod-query");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    let filters = mipmapped(Filter::Linear, Mipmap::Linear);
    for round in 0..harness.cases(32).max(8) {
        let size = [[64, 64], [256, 16], [33, 65]][round % 3];
        let image = image(&mut rng, size, filters);
        let mut sampler = repeating(&image, filters);
        let low = f64::from(rng.dyadic(-1.0, 2.0, 0.25));
        sampler.lod = LodState {
            object_bias: f64::from(rng.dyadic(-1.0, 2.0, 0.25)),
            min_lod: low,
            max_lod: low + f64::from(rng.dyadic(0.0, 3.0, 0.25)),
            ..LodState::default()
        };
        let lambda = f64::from(rng.real(-2.0, 5.0));
        let map = Map::random(&mut rng, size, lambda);
        let d = Derivatives { dx: map.dx, dy: map.dy };
        let last = (image.len() - 1) as f64;
        let expect = |_: Pixel, variant: Variant| {
            let clamped = sample::lambda(&image, &sampler, &d, variant);
            let free = sample::Sampler {
                lod: LodState { min_lod: f64::MIN, max_lod: f64::MAX, ..sampler.lod },
                ..sampler.clone()
            };
            let unclamped = sample::lambda(&image, &free, &d, variant);
            // A picture of floats keeps negative numbers.
            Some([clamped.clamp(0.0, last), unclamped, 0.0, 1.0])
        };
        pictures.compare(&(size, sampler.lod, lambda), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            session.texture_2d(&image, &sampler)?;
            glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
            session.fragment_only(
                "#version 130
                #extension GL_ARB_texture_query_lod : require
                uniform sampler2D image;
                void main() {
                    gl_FragColor = vec4(textureQueryLOD(image, gl_TexCoord[0].xy), 0.0, 1.0);
                }",
            )?;
            map.draw(Given::Immediate);
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 100);
    Ok(())
}
