//! What a plan leaves out, and that it says so.

use crate::scene;
use texunit::format::Format;
use texunit::image::Shape;
use texunit::plan::SamplePlan;
use texunit::sampler::{Compare, Filter, Mipmap, Sampler};

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
