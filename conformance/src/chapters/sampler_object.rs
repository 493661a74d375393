//! Sampler objects, whose state stands for that of textures.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::lod::Filter;
use crate::oracle::mipmap::Volume;
use crate::oracle::target::{Target, Texture};
use crate::oracle::wrap::Wrap;
use crate::probe::{ProbeError, Session, filter_enum, wrap_enum};
use crate::rng::Rng;
use gl_api::constants::*;

/// Precedence.
pub const PRECEDENCE: Check = Check {
    name: "sampler-object",
    citation: "GL 3.3, 3.8.2: a sampler object's state is used in the place of the texture's",
    what: "samples of textures whose filter, wrap modes and border colour are others than those of the \
           sampler object that is bound, or was bound and is no more",
    unit: Unit::FullScale,
    tolerance: 7.0 / (1 << 24) as f64,
    why: "f32: a mirrored coordinate is rounded by 2^-25, times 8 texels and a difference of texels of 1/2, 2^-23 for \
          each axis; twelve roundings of sums and products below 1, 2^-25 each: twice the root of the sum of squares is \
          6.6 · 2^-24",
    run,
};

/// Whether the sampler object is bound when the texture is sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Binding {
    Bound,
    UnboundAgain,
}

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("sampler-object");
    let rounds = harness.cases(32).max(8);
    let mut outside = 0;
    for round in 0..rounds {
        let of_texture = random(&mut rng, [Filter::Nearest, Filter::Linear][round % 2]);
        // Both states filter in the same way where coordinates may lie on a texel's edge.
        let sampler = Texture {
            texels: of_texture.texels.clone(),
            size: of_texture.size,
            ..random(&mut rng, [Filter::Linear, Filter::Nearest][round % 2])
        };
        let binding = if round % 4 < 3 { Binding::Bound } else { Binding::UnboundAgain };
        let cases: Vec<[f32; 4]> = (0..harness.cases(512)).map(|_| case(&mut rng)).collect();
        outside += cases.iter().filter(|c| c[0].abs() > 1.0 || c[1].abs() > 1.0).count();
        let expect = |case: &[f32; 4], variant: Variant| {
            let used = binding == Binding::Bound && !variant.has(Mutation::SamplerObjectIgnored);
            let texture = if used { &sampler } else { &of_texture };
            texture.sample([case[0].into(), case[1].into(), 0.0], [0; 3], variant)
        };
        let scene = (of_texture.wrap, sampler.wrap, sampler.filter, binding);
        harness.compare(tally, &scene, &cases, expect, |session| {
            session.target_texture(&of_texture)?;
            bind(session, &sampler, binding)?;
            let inputs: Vec<_> = cases.iter().map(|&c| [c, [0.0; 4], [0.0; 4]]).collect();
            let body = "uniform sampler2D image; vec4 value() { return texture(image, a.xy); }";
            session.field(body, 4, &inputs)
        })?;
    }
    tally.reach("coordinates beyond [-1, 1]", outside, rounds * harness.cases(512) / 4);
    Ok(())
}

fn random(rng: &mut Rng, filter: Filter) -> Texture {
    let size = [8, 8, 1];
    let texels = (0..64).map(|_| [0; 4].map(|_: i32| f64::from(rng.real(0.0, 1.0)))).collect();
    Texture {
        target: Target::D2,
        size,
        border: 0,
        texels: Volume { size, texels },
        wrap: [0; 3].map(|_: i32| rng.pick(&Wrap::ALL)),
        border_color: [0; 4].map(|_: i32| f64::from(rng.real(0.0, 1.0))),
        filter,
    }
}

/// Away from the edges of texels.
fn case(rng: &mut Rng) -> [f32; 4] {
    let mut coordinate = || {
        let texel = rng.integer(-16, 23) as f64;
        ((texel + f64::from(rng.real(0.01, 0.99))) / 8.0) as f32
    };
    [coordinate(), coordinate(), 0.0, 1.0]
}

fn bind(session: &Session, sampler: &Texture, binding: Binding) -> Result<(), ProbeError> {
    let mut name = 0u32;
    glGenSamplers(1, &mut name);
    let filter = filter_enum(sampler.filter);
    for (parameter, value) in [
        (GL_TEXTURE_MIN_FILTER, filter),
        (GL_TEXTURE_MAG_FILTER, filter),
        (GL_TEXTURE_WRAP_S, wrap_enum(sampler.wrap[0])),
        (GL_TEXTURE_WRAP_T, wrap_enum(sampler.wrap[1])),
    ] {
        glSamplerParameteri(name, parameter, value);
    }
    let color = sampler.border_color.map(|c| c as f32);
    glSamplerParameterfv(name, GL_TEXTURE_BORDER_COLOR, &color);
    glBindSampler(0, name);
    match binding {
        Binding::Bound => {}
        Binding::UnboundAgain => glBindSampler(0, 0),
    }
    session.check("binding a sampler object")
}
