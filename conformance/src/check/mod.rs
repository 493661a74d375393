//! What is compared with what: one file a check.
//!
//! A check makes its cases (the same ones every time), asks oracle and driver about each, and
//! keeps the largest difference. [`CHAPTERS`] is the list, in the order of the pipeline.
//!
//! To add one: write the formula as an [`oracle`](crate::oracle), with a unit test from values
//! computed by hand; write a file here that makes cases and calls [`Bench::compare`]; add it to
//! [`CHAPTERS`]; and add the mistakes that it must notice to
//! [`MUTATIONS`](crate::mutation::MUTATIONS), which a test then tries one by one.

mod anisotropy;
mod bench;
mod blend;
mod builtin;
mod combine;
mod compressed;
mod coverage;
mod cube;
mod cube_array;
mod depth_test;
mod env;
mod filter;
mod format;
mod fragment;
mod integer;
mod interpolation;
mod lecture;
mod level;
mod lod;
mod lookup;
mod mipmap;
mod outcome;
mod pixel;
mod projection;
mod pyramid;
mod seamless;
mod shadow;
mod shadow_array;
mod srgb;
mod target;
mod texel_mode;
mod vertex;
mod wrap;

pub use bench::{Bench, Effort, Shown, Subject, Tally};
pub use outcome::{Outcome, Unit, Verdict};

use crate::drive::DriveError;
use std::time::Instant;

/// A check: what it is about, how exact the driver has to be and why, and how it is run.
#[derive(Clone, Copy, Debug)]
pub struct Check {
    /// Short name, for `--only` and for the list of mutations.
    pub name: &'static str,
    /// Where the formula stands.
    pub citation: &'static str,
    /// What is checked, in words.
    pub what: &'static str,
    /// What errors are measured in.
    pub unit: Unit,
    /// The largest error that passes.
    pub tolerance: f64,
    /// Why the tolerance is what it is.
    pub why: &'static str,
    /// Makes the cases and compares them.
    pub run: fn(&Bench, &mut Tally) -> Result<(), DriveError>,
}

/// What belongs together, under a heading.
pub type Chapter = (&'static str, &'static [Check]);

/// Every check, chapter by chapter, in the order in which a fragment meets what they are about.
pub const CHAPTERS: &[Chapter] = &[
    ("The client's pixels", &[pixel::UNPACK, pixel::PACK, pixel::STORE, pixel::TRANSFER]),
    (
        "Texel formats",
        &[
            format::SAMPLED,
            format::QUERIED,
            format::INTEGERS,
            integer::SAMPLED,
            compressed::COMPRESSED,
            srgb::DECODE,
            texel_mode::DEPTH_MODE,
            texel_mode::SWIZZLE,
        ],
    ),
    ("Mipmaps", &[mipmap::GENERATED, mipmap::FLOATS, mipmap::GLU]),
    (
        "Rasterization",
        &[
            coverage::COVERAGE,
            coverage::SHARED_EDGES,
            interpolation::PERSPECTIVE,
            interpolation::DEPTH,
        ],
    ),
    (
        "Sampling",
        &[
            projection::PROJECTIVE,
            cube::FACE,
            cube::FILTER,
            seamless::SEAMLESS,
            cube_array::FILTER,
            lod::LOD,
            lod::BIAS_CLAMP,
            lookup::LOD,
            lookup::GRAD,
            pyramid::LAMBDA,
            pyramid::CUBE_GRAD,
            level::LEVEL,
            wrap::NEAREST,
            wrap::LINEAR,
            target::FILTERED,
            target::OFFSET,
            target::PROJECTED,
            target::FETCH,
            pyramid::SIZE,
            filter::NEAREST,
            filter::BILINEAR,
            anisotropy::ANISOTROPY,
            shadow::COMPARE,
            texel_mode::COMPARE_LINEAR,
            shadow_array::COMPARE,
        ],
    ),
    ("Vertices", &[vertex::TEXGEN, vertex::LIGHTING]),
    (
        "Fragments",
        &[
            env::ENVIRONMENT,
            combine::COMBINE,
            combine::FOG,
            fragment::ALPHA,
            fragment::STENCIL,
            depth_test::TEST,
            blend::BLEND,
            fragment::LOGIC,
        ],
    ),
    ("The lectures", &[lecture::LECTURES]),
    ("Built-in functions", &builtin::ULP),
    ("Where built-in functions end", &[builtin::EXTREMES]),
];

/// Every check.
pub fn checks() -> impl Iterator<Item = &'static Check> + Clone {
    CHAPTERS.iter().flat_map(|(_, checks)| checks.iter())
}

impl Check {
    /// Runs it.
    pub fn run(&self, bench: &Bench) -> Outcome {
        let start = Instant::now();
        let mut tally = Tally::new(self.unit);
        let result = (self.run)(bench, &mut tally);
        let verdict = match result {
            Err(error) => Verdict::Broken(error.to_string()),
            Ok(()) if tally.cases() == 0 => Verdict::Broken("no cases".to_owned()),
            Ok(()) if tally.largest() <= self.tolerance => Verdict::Pass,
            Ok(()) => Verdict::Fail,
        };
        let (cases, largest_error) = (tally.cases(), tally.largest());
        let (worst, shown) = tally.into_worst();
        Outcome {
            name: self.name,
            citation: self.citation,
            what: self.what,
            cases,
            largest_error,
            unit: self.unit,
            tolerance: self.tolerance,
            why: self.why,
            worst,
            seconds: start.elapsed().as_secs_f64(),
            verdict,
            shown,
        }
    }
}
