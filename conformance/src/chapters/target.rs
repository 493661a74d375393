//! Every shape of texture: wrap, filter, border, layer, offset, projection and single texels.

use crate::check::{Check, Harness, Tally, Unit};
use crate::mutation::{Mutation, Variant};
use crate::oracle::lod::Filter;
use crate::oracle::mipmap::Volume;
use crate::oracle::target::{Target, Texture};
use crate::oracle::wrap::Wrap;
use crate::probe::ProbeError;
use crate::rng::Rng;

const WHY: &str = "f32: u up to 32 carries 2^-20 of a texel per axis, and a few roundings of 2^-24";
const TOLERANCE: f64 = 1.0 / (1 << 17) as f64;

/// Filtered samples.
pub const FILTERED: Check = Check {
    name: "target-filter",
    citation: "GL 2.1, 3.8.7 and 3.8.8; ARB_texture_rectangle, EXT_texture_array",
    what: "nearest and linear samples of 1D, 2D, 3D, rectangle and array textures, with and \
           without border, under random wrap modes",
    unit: Unit::FullScale,
    tolerance: 10.0 / (1 << 24) as f64,
    why: "f32: u up to 16 carries 2^-21 of a texel in the worst axis; three mixes add 2^-24",
    run: |harness, tally| run(harness, tally, LookupForm::Plain),
};

/// Offsets.
pub const OFFSET: Check = Check {
    name: "target-offset",
    citation: "GLSL 1.30, 8.7: textureOffset",
    what: "constant offsets of -8 to 7 texels on every target",
    unit: Unit::FullScale,
    tolerance: 1.5 / (1 << 20) as f64,
    why: "f32: u up to 32 carries 2^-20 of a texel in the worst axis; three mixes add 2^-24 each",
    run: |harness, tally| run(harness, tally, LookupForm::Offset),
};

/// Projection.
pub const PROJECTED: Check = Check {
    name: "target-proj",
    citation: "GLSL 1.30, 8.7: textureProj",
    what: "division by the last coordinate on 1D, 2D, 3D and rectangle textures",
    unit: Unit::FullScale,
    tolerance: 9.0 / (1 << 24) as f64,
    why: "f32: as without projection, at most 8 texels, and the division: half an ulp of s, 2^-24 of 8 texels",
    run: |harness, tally| run(harness, tally, LookupForm::Projected),
};

/// Single texels.
pub const FETCH: Check = Check {
    name: "texel-fetch",
    citation: "GLSL 1.30, 8.7: texelFetch, texelFetchOffset",
    what: "texels by number on every target, some of them outside, where DetGL gives 0",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "texels are floats and come back as they are",
    run: |harness, tally| run(harness, tally, LookupForm::Fetch),
};

/// The form of a texture lookup.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LookupForm {
    Plain,
    Offset,
    Projected,
    Fetch,
}

/// Coordinates; the last is the divisor of a projective lookup.
type Case = [f32; 4];

fn run(harness: &Harness, tally: &mut Tally, form: LookupForm) -> Result<(), ProbeError> {
    let mut rng = Rng::named("target");
    for target in Target::ALL {
        if form == LookupForm::Projected && target.has_layers() {
            continue;
        }
        for round in 0..8 {
            let texture = texture(&mut rng, target, round, form);
            let offset = match form {
                LookupForm::Offset => [0; 3].map(|_: i32| rng.integer(-8, 7)),
                LookupForm::Fetch if round % 2 == 1 => [0; 3].map(|_: i32| rng.integer(-2, 2)),
                LookupForm::Plain | LookupForm::Projected | LookupForm::Fetch => [0; 3],
            };
            let offset = std::array::from_fn(|i| if i < target.axes() { offset[i] } else { 0 });
            let cases: Vec<Case> =
                (0..harness.cases(1024)).map(|_| case(&mut rng, &texture, form)).collect();
            let expect = |case: &Case, variant: Variant| {
                let [s, t, r, q] = case.map(f64::from);
                match form {
                    LookupForm::Fetch => {
                        texture.fetch([s, t, r].map(|c| c as i64), offset, variant)
                    }
                    LookupForm::Projected if variant.has(Mutation::MissingDivide) => {
                        texture.sample([s, t, r], offset, variant)
                    }
                    LookupForm::Plain | LookupForm::Offset | LookupForm::Projected => {
                        texture.sample([s / q, t / q, r / q], offset, variant)
                    }
                }
            };
            let scene =
                (target, texture.size, texture.border, texture.wrap, texture.filter, offset);
            harness.compare(tally, &scene, &cases, expect, |session| {
                session.target_texture(&texture)?;
                let inputs: Vec<_> = cases.iter().map(|&c| [c, [0.0; 4], [0.0; 4]]).collect();
                session.field(&body(target, form, offset), 4, &inputs)
            })?;
        }
    }
    Ok(())
}

/// A random texture; every other one has a border, if the target supports it.
fn texture(rng: &mut Rng, target: Target, round: usize, form: LookupForm) -> Texture {
    let used = target.axes() + usize::from(target.has_layers());
    let mut size = [1; 3];
    for side in &mut size[..used] {
        *side = rng.pick(&[1, 2, 4, 5, 7, 8, 16]);
    }
    let bordered = match target {
        Target::D1 | Target::D2 | Target::D3 => form == LookupForm::Plain && round % 2 == 1,
        Target::Rect | Target::D1Array | Target::D2Array => false,
    };
    let border = usize::from(bordered);
    let stored = std::array::from_fn(|i| size[i] + if i < target.axes() { 2 * border } else { 0 });
    let count = stored.iter().product();
    let texels = (0..count).map(|_| [0; 4].map(|_: i32| f64::from(rng.real(0.0, 1.0)))).collect();
    let wraps: &[Wrap] = match target {
        Target::Rect => &[Wrap::Clamp, Wrap::ClampToEdge, Wrap::ClampToBorder],
        Target::D1 | Target::D2 | Target::D3 | Target::D1Array | Target::D2Array => &Wrap::ALL,
    };
    Texture {
        target,
        size,
        border,
        texels: Volume { size: stored, texels },
        wrap: [0; 3].map(|_: i32| rng.pick(wraps)),
        border_color: [0.25, 0.5, 0.75, 1.0],
        filter: if round % 4 < 2 { Filter::Linear } else { Filter::Nearest },
    }
}

/// Coordinates inside and outside, for a nearest filter not near a texel's edge, and layers not
/// near the middle between two.
fn case(rng: &mut Rng, texture: &Texture, form: LookupForm) -> Case {
    if form == LookupForm::Fetch {
        let at = |n: usize, rng: &mut Rng| rng.integer(-1, n as i64) as f32;
        let [w, h, d] = texture.size;
        let axes = texture.target.axes() + usize::from(texture.target.has_layers());
        let all = [at(w, rng), at(h, rng), at(d, rng)];
        let c: [f32; 3] = std::array::from_fn(|i| if i < axes { all[i] } else { 0.0 });
        return [c[0], c[1], c[2], 1.0];
    }
    let q = match form {
        LookupForm::Projected => rng.pick(&[-2.0, 0.5, 1.0, 4.0]),
        LookupForm::Plain | LookupForm::Offset | LookupForm::Fetch => 1.0,
    };
    let mut c = [0.0, 0.0, 0.0, q];
    for (axis, c) in c.iter_mut().enumerate().take(3) {
        let n = texture.size[axis] as f64;
        *c = loop {
            let is_layer = axis == texture.target.axes() && texture.target.has_layers();
            let texels = f64::from(rng.real(-1.5 * n, 2.5 * n));
            let scale = if is_layer || texture.target == Target::Rect { 1.0 } else { n };
            let x = (texels / scale) as f32;
            let from_edge =
                (f64::from(x) * scale + if is_layer { 0.5 } else { 0.0 }).rem_euclid(1.0);
            let free = texture.filter == Filter::Linear && !is_layer;
            if free || (0.001..0.999).contains(&from_edge) {
                break x * q;
            }
        };
    }
    c
}

/// The GLSL of a lookup.
fn body(target: Target, form: LookupForm, offset: [i64; 3]) -> String {
    let (sampler, size) = match target {
        Target::D1 => ("sampler1D", 1),
        Target::D2 => ("sampler2D", 2),
        Target::D3 => ("sampler3D", 3),
        Target::Rect => ("sampler2DRect", 2),
        Target::D1Array => ("sampler1DArray", 2),
        Target::D2Array => ("sampler2DArray", 3),
    };
    let coordinates = ["a.x", "a.xy", "a.xyz"][size - 1];
    let (ty, ints) = (["float", "vec2", "vec3"][size - 1], ["int", "ivec2", "ivec3"][size - 1]);
    let parts: Vec<String> = offset[..target.axes()].iter().map(i64::to_string).collect();
    let shift = format!("{}({})", ["int", "ivec2", "ivec3"][target.axes() - 1], parts.join(", "));
    // Rectangles have no levels.
    let level = if target == Target::Rect { "" } else { ", 0" };
    let call = match form {
        LookupForm::Plain => format!("texture(image, {ty}({coordinates}))"),
        LookupForm::Offset => format!("textureOffset(image, {coordinates}, {shift})"),
        LookupForm::Projected => {
            let c = ["vec2(a.x, a.w)", "vec3(a.xy, a.w)", "a"][size - 1];
            format!("textureProj(image, {c})")
        }
        LookupForm::Fetch if offset == [0; 3] => {
            format!("texelFetch(image, {ints}({coordinates}){level})")
        }
        LookupForm::Fetch => {
            format!("texelFetchOffset(image, {ints}({coordinates}){level}, {shift})")
        }
    };
    format!("uniform {sampler} image; vec4 value() {{ return {call}; }}")
}
