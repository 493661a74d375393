//! Which images can be sampled, and what is said about those that cannot.

use crate::scene;
use texunit::format::Format;
use texunit::image::{Image, Level, Levels, Shape};
use texunit::lanes::{F32s, Isa};
use texunit::plan::{Lod, SamplePlan};
use texunit::sampler::{Filter, Mipmap, Sampler};

fn level(format: Format, width: u32, height: u32) -> Level {
    Level::new(format, width, height).unwrap()
}

fn complete(shape: Shape) -> Image {
    scene::image(shape, Format::Rgba8, 16, 16, 1)
}

fn trilinear() -> Sampler {
    Sampler { min: Filter::Linear, ..Sampler::default() }
}

fn without_mipmaps() -> Sampler {
    Sampler { mipmap: Mipmap::None, ..Sampler::default() }
}

/// The reason, having seen that every sample is opaque black.
fn reason(image: &Image, sampler: &Sampler) -> String {
    let plan = SamplePlan::new(image, sampler);
    let mut out = [F32s::splat(0.5); 4];
    let zero = F32s::ZERO;
    plan.sample(Isa::best(), [&zero; 3], None, Lod::Implicit { bias: None }, &mut out);
    assert_eq!(out.map(|c| c[7]), [0.0, 0.0, 0.0, 1.0]);
    plan.incomplete().expect("an incomplete image").to_string()
}

#[test]
fn a_full_pyramid_is_complete_and_bounded_by_the_largest_level() {
    let image = complete(Shape::D2);
    assert_eq!(image.completeness(&trilinear()), Ok(Levels { base: 0, last: 4 }));
    let two = Sampler { base_level: 1, max_level: 2, ..trilinear() };
    assert_eq!(image.completeness(&two), Ok(Levels { base: 1, last: 2 }));
    assert_eq!(complete(Shape::Cube).completeness(&trilinear()), Ok(Levels { base: 0, last: 4 }));
}

#[test]
fn each_defect_has_its_message() {
    let mut missing = complete(Shape::D2);
    missing.remove(0, 3);
    assert_eq!(
        reason(&missing, &trilinear()),
        "level 3 is missing: the minification filter GL_LINEAR_MIPMAP_LINEAR needs levels 0 to 4; \
         call glGenerateMipmap, gluBuild2DMipmaps, or set GL_TEXTURE_MIN_FILTER to GL_LINEAR"
    );
    assert!(missing.completeness(&without_mipmaps()).is_ok());

    assert!(reason(&Image::new(Shape::D2), &without_mipmaps()).starts_with("level 0 has no image"));

    let mut empty = Image::new(Shape::D2);
    empty.set_level(0, 0, level(Format::L8, 0, 4)).unwrap();
    assert!(reason(&empty, &without_mipmaps()).contains("size of 0"));

    let reversed = Sampler { base_level: 2, max_level: 1, ..trilinear() };
    assert!(reason(&complete(Shape::D2), &reversed).contains("above GL_TEXTURE_MAX_LEVEL 1"));

    let mut wrong = complete(Shape::D2);
    wrong.set_level(0, 1, level(Format::Rgba8, 8, 7)).unwrap();
    assert!(reason(&wrong, &trilinear()).starts_with("level 1 is 8×7, but"));

    let mut mixed = complete(Shape::D2);
    mixed.set_level(0, 2, level(Format::Rgb8, 4, 4)).unwrap();
    assert!(reason(&mixed, &trilinear()).starts_with("level 2 is stored as Rgb8"));

    let mut oblong = complete(Shape::Cube);
    oblong.set_level(2, 0, level(Format::Rgba8, 16, 8)).unwrap();
    assert!(reason(&oblong, &without_mipmaps()).contains("face +Y is 16×8, but the faces"));

    let mut unequal = complete(Shape::Cube);
    unequal.set_level(5, 0, level(Format::Rgba8, 8, 8)).unwrap();
    assert!(reason(&unequal, &without_mipmaps()).contains("the face +X is 16×16"));

    let mut faceless = complete(Shape::Cube);
    faceless.remove(4, 0);
    assert!(reason(&faceless, &without_mipmaps()).contains("level 0 of the face +Z has no image"));
}
