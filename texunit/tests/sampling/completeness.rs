//! Which images can be sampled, and what is said about those that cannot.

use crate::scene;
use texunit::format::Format;
use texunit::image::{Image, Level, Levels, Shape};
use texunit::lanes::{F32s, Isa};
use texunit::plan::SamplePlan;
use texunit::sample::Lod;
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
    assert!(
        reason(&mixed, &trilinear())
            .starts_with("level 2 and the base level differ in their format")
    );

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

/// Shape, base level, the levels above it, and words of the reason.
type Pyramid = (Shape, [u32; 3], &'static [[u32; 3]], &'static str);

/// A pyramid of each shape; then one level of it is of another size, or of other layers.
#[test]
fn every_shape_needs_its_own_sizes() {
    let rows: &[Pyramid] = &[
        (Shape::D1, [8, 1, 1], &[[4, 1, 1], [2, 1, 1], [1, 1, 1]], ""),
        (Shape::D1, [5, 1, 1], &[[2, 1, 1], [1, 1, 1]], ""),
        (Shape::D1, [8, 1, 1], &[[3, 1, 1]], "level 1 is 3, but must be 4"),
        (Shape::D3, [4, 2, 8], &[[2, 1, 4], [1, 1, 2], [1, 1, 1]], ""),
        (Shape::D3, [1, 1, 8], &[[1, 1, 4], [1, 1, 2], [1, 1, 1]], ""),
        (Shape::D3, [4, 2, 8], &[[2, 1, 8]], "level 1 is 2×1×8, but must be 2×1×4"),
        (Shape::D3, [4, 2, 8], &[[2, 1, 4], [1, 1, 2]], "level 3 is missing"),
        (Shape::D1Array, [4, 1, 8], &[[2, 1, 8], [1, 1, 8]], ""),
        (Shape::D1Array, [4, 1, 8], &[[2, 1, 4]], "2 in 4 layers, but must be 2 in 8 layers"),
        (Shape::D2Array, [4, 4, 16], &[[2, 2, 16], [1, 1, 16]], ""),
        (Shape::D2Array, [4, 4, 2], &[[2, 2, 1]], "2×2 in 1 layers, but must be 2×2 in 2 layers"),
        (Shape::CubeArray, [4, 4, 12], &[[2, 2, 12], [1, 1, 12]], ""),
        (Shape::CubeArray, [4, 4, 12], &[[2, 2, 6]], "2×2 in 6 layers, but must be 2×2 in 12"),
        (Shape::D2, [8, 2, 1], &[[4, 1, 1], [2, 1, 1], [1, 1, 1]], ""),
    ];
    for (shape, base, smaller, words) in rows {
        let mut image = Image::new(*shape);
        for (number, size) in std::iter::once(base).chain(*smaller).enumerate() {
            let level = Level::with_size(Format::R8, *size, [0; 3]).unwrap();
            image.set_level(0, number, level).unwrap();
        }
        let said = image.completeness(&trilinear()).err().map(|reason| reason.to_string());
        let said = said.unwrap_or_default();
        assert_eq!(said.is_empty(), words.is_empty(), "{shape:?} {base:?}: {said}");
        assert!(said.contains(words), "{shape:?} {base:?}: {said}");
        assert!(image.completeness(&without_mipmaps()).is_ok());
    }
}

#[test]
fn integers_are_complete_with_nearest_filters_only() {
    let image = scene::image(Shape::D2, Format::Rgba8UI, 4, 4, 1);
    use Filter::{Linear, Nearest};
    for (mag, min, mipmap, complete) in [
        (Nearest, Nearest, Mipmap::None, true),
        (Nearest, Nearest, Mipmap::Nearest, true),
        (Nearest, Nearest, Mipmap::Linear, false),
        (Nearest, Linear, Mipmap::None, false),
        (Nearest, Linear, Mipmap::Nearest, false),
        (Linear, Nearest, Mipmap::None, false),
    ] {
        let sampler = Sampler { mag, min, mipmap, ..Sampler::default() };
        let said = image.completeness(&sampler).err().map(|reason| reason.to_string());
        assert_eq!(said.is_none(), complete, "{mag:?} {min:?} {mipmap:?}: {said:?}");
        assert!(said.is_none_or(|said| said.contains("GL_TEXTURE_MAG_FILTER")));
    }
}

#[test]
fn borders_of_all_levels_are_alike() {
    let mut image = Image::new(Shape::D2);
    for (number, side) in [4, 2, 1].into_iter().enumerate() {
        let border = if number == 1 { [0; 3] } else { [1, 1, 0] };
        let level = Level::with_size(Format::L8, [side, side, 1], border).unwrap();
        image.set_level(0, number, level).unwrap();
    }
    assert!(reason(&image, &trilinear()).starts_with("level 1 and the base level differ in"));
}
