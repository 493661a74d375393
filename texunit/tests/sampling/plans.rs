//! What a plan leaves out, and that it says so.

use crate::scene;
use texunit::format::Format;
use texunit::image::Shape;
use texunit::plan::SamplePlan;
use texunit::sampler::{Compare, Filter, Mipmap, Sampler, Wrap};

#[test]
fn lod_is_left_out_where_it_decides_nothing() {
    let linear = Sampler { min: Filter::Linear, mipmap: Mipmap::None, ..Sampler::default() };
    let cases = [
        (linear.clone(), false),
        (Sampler { min: Filter::Nearest, ..linear.clone() }, true),
        (Sampler { mipmap: Mipmap::Linear, ..linear.clone() }, true),
        (Sampler { mipmap: Mipmap::Linear, max_level: 0, ..linear.clone() }, false),
        (Sampler { mipmap: Mipmap::Linear, max_lod: 0.0, ..linear.clone() }, false),
        // Magnified up to one half.
        (Sampler { mipmap: Mipmap::Linear, max_lod: 0.5, ..Sampler::default() }, false),
    ];
    let image = scene::image(Shape::D2, Format::Rgba8, 8, 8, 1);
    for (sampler, needed) in cases {
        assert_eq!(SamplePlan::new(&image, &sampler).needs_lod(), needed, "{sampler:?}");
    }
}

#[test]
fn a_plan_says_in_one_line_what_it_decided() {
    let image = scene::image(Shape::D2, Format::Rgba8, 8, 4, 1);
    let linear = Sampler { min: Filter::Linear, mipmap: Mipmap::None, ..Sampler::default() };
    assert_eq!(
        SamplePlan::new(&image, &linear).describe(),
        "D2 Rgba8 8x4, wrap Repeat Repeat, Linear of level 0 (from the base), no LOD: both filters \
         are alike and without mipmaps"
    );
    let depth = scene::image(Shape::D2, Format::D24, 8, 4, 1);
    let shadow = Sampler { compare: Some(Compare::LessEqual), max_lod: 1.5, ..Sampler::default() };
    assert_eq!(
        SamplePlan::new(&depth, &shadow).describe(),
        "D2 D24 8x4, wrap Repeat Repeat, depth compare LessEqual before the filter, min Nearest \
         mipmap Linear of levels 0 to 2 (from the base), mag Linear up to lambda 0.5, LOD per lane"
    );
}

#[test]
fn a_plan_says_which_kernel_samples_and_why_the_general_one() {
    let kernel = |shape: Shape, format: Format, sampler: Sampler| {
        let plan = SamplePlan::new(&scene::image(shape, format, 8, 8, 2), &sampler);
        assert!(plan.incomplete().is_none());
        plan.describe_kernel()
    };
    let linear = Sampler {
        min: Filter::Linear,
        mipmap: Mipmap::None,
        wrap: [Wrap::ClampToEdge; 3],
        ..Sampler::default()
    };
    let compared = Sampler { compare: Some(Compare::Less), ..linear.clone() };
    let bordered = Sampler { wrap: [Wrap::ClampToBorder; 3], ..linear.clone() };
    let anisotropic = Sampler { mipmap: Mipmap::Linear, max_anisotropy: 4.0, ..linear.clone() };
    let (uniform, scattered) = ("kernel of uniform levels", "kernel of scattered lanes");
    for (shape, format, sampler, want) in [
        (Shape::D2, Format::Rgba8, &linear, uniform),
        (Shape::D2, Format::D24, &compared, uniform),
        (Shape::Cube, Format::Rgb8, &linear, scattered),
        (Shape::Cube, Format::D24, &compared, scattered),
        (Shape::CubeArray, Format::Rgba16F, &linear, scattered),
        (Shape::D2Array, Format::D24, &compared, scattered),
        (Shape::D2, Format::Rgba8, &anisotropic, "kernel of row scans"),
        (
            Shape::Cube,
            Format::Rgba8,
            &anisotropic,
            "general kernel: because anisotropic footprints of this shape or wrap mode take several probes",
        ),
        (
            Shape::D3,
            Format::Rgba8,
            &linear,
            "general kernel: because the image has one axis, or three",
        ),
        (Shape::Cube, Format::Dxt1Rgb, &linear, "general kernel: because texels are compressed"),
        (
            Shape::Cube,
            Format::Rgba8,
            &bordered,
            "general kernel: because faces or layers have a wrap mode that reads the border or mirrors once",
        ),
    ] {
        assert_eq!(kernel(shape, format, sampler.clone()), want, "{shape:?} {format:?}");
    }
}
