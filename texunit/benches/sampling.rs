//! Nanoseconds per sample: filter × format class × coherence, as the table of `RESULTS.md`.
//!
//! All cells are measured in turn, round after round, and the least time of each is kept, so that
//! what disturbs the machine falls on all of them alike. `cargo bench -p texunit --bench sampling`
//! prints every row; words after `--` pick rows that hold one of them. `DETGL_ISA` picks the
//! instruction set.

use std::hint::black_box;
use std::time::Instant;
use texunit::format::Format;
use texunit::image::{Image, Level, Shape};
use texunit::lanes::{F32s, Isa, LANES, QUADS, lane_x, lane_y};
use texunit::plan::SamplePlan;
use texunit::sample::{Addresses, Lod, LookupScratch, Points};
use texunit::sampler::{Filter, Mipmap, Sampler, Seamless, Wrap};

/// Texels of a side.
const SIZE: u32 = 512;
/// Blocks of 8×8 pixels of a side of the picture that is sampled.
const BLOCKS: usize = 8;
/// How often each cell is measured, and how many pictures a measurement takes.
const ROUNDS: usize = 25;
const PICTURES: usize = 8;

struct FilterRow {
    name: &'static str,
    min: Filter,
    mipmap: Mipmap,
    anisotropy: f32,
}

const FILTERS: [FilterRow; 5] = {
    const fn row(name: &'static str, min: Filter, mipmap: Mipmap, anisotropy: f32) -> FilterRow {
        FilterRow { name, min, mipmap, anisotropy }
    }
    [
        row("nearest", Filter::Nearest, Mipmap::None, 1.0),
        row("bilinear", Filter::Linear, Mipmap::None, 1.0),
        row("trilinear", Filter::Linear, Mipmap::Linear, 1.0),
        row("anisotropic 4:1", Filter::Linear, Mipmap::Linear, 4.0),
        row("anisotropic 16:1", Filter::Linear, Mipmap::Linear, 16.0),
    ]
};

const FORMATS: [(&str, Format); 9] = [
    ("RGBA8", Format::Rgba8),
    ("RGB8", Format::Rgb8),
    ("L8", Format::L8),
    ("SRGB8_ALPHA8", Format::Srgb8A8),
    ("RGBA16F", Format::Rgba16F),
    ("RGBA32F", Format::Rgba32F),
    ("DXT1", Format::Dxt1Rgb),
    ("DXT5", Format::Dxt5),
    ("RGTC1", Format::Rgtc1),
];

/// How far apart the pixels of the picture are.
#[derive(Clone, Copy)]
enum Coherence {
    /// Texels per pixel, of a picture at an angle.
    Even(f32),
    /// A texel per pixel within a quad, every quad somewhere else.
    Random,
}

const COHERENCES: [(&str, Coherence); 4] = [
    ("magnified", Coherence::Even(0.1)),
    ("1:1", Coherence::Even(1.0)),
    ("minified", Coherence::Even(2.7)),
    ("random", Coherence::Random),
];

fn image(shape: Shape, format: Format) -> Image {
    let mut image = Image::new(shape);
    let mut seed = 1_u32;
    for (number, face) in (0..=SIZE.ilog2()).flat_map(|n| (0..shape.faces()).map(move |f| (n, f))) {
        let mut level = Level::new(format, SIZE >> number, SIZE >> number).expect("a small level");
        level.fill(|_| {
            [0; 4].map(|_| {
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                (seed >> 8) as f32 / 16_777_216.0
            })
        });
        image.set_level(face, number as usize, level).expect("a level of this shape");
    }
    image
}

/// Texture coordinates of a picture of 64×64 pixels, block by block. Anisotropic footprints are
/// `stretch` times as long as wide.
fn coordinates(coherence: Coherence, stretch: f32) -> Vec<[F32s; 2]> {
    let mut seed = 7_u32;
    let mut random = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (seed >> 8) as f32 / 16_777_216.0
    };
    let mut blocks = Vec::new();
    for block in 0..BLOCKS * BLOCKS {
        let starts: [[f32; 2]; QUADS] = [[0.0; 2]; QUADS].map(|_| [random(), random()]);
        let place = |lane: usize| {
            let (corner, texels, x, y) = match coherence {
                Coherence::Even(texels) => {
                    let x = block % BLOCKS * 8 + lane_x(lane);
                    let y = block / BLOCKS * 8 + lane_y(lane);
                    ([0.13, 0.29], texels, x, y)
                }
                Coherence::Random => {
                    (starts[lane % QUADS], 1.0, lane_x(lane) % 2, lane_y(lane) % 2)
                }
            };
            let unit = texels / SIZE as f32;
            let (x, y) = (x as f32 * unit, y as f32 * unit * stretch);
            [corner[0] + 0.8 * x - 0.6 * y, corner[1] + 0.6 * x + 0.8 * y]
        };
        blocks.push([0, 1].map(|axis| F32s::from_fn(|lane| place(lane)[axis])));
    }
    blocks
}

/// The directions of (s, t) on a cube's face +X; where quads are anywhere, on any face.
fn directions(blocks: Vec<[F32s; 2]>, coherence: Coherence) -> Vec<[F32s; 3]> {
    let direction = |[s, t]: [F32s; 2]| {
        let of = |lane: usize| {
            let on_x = [1.0, 1.0 - 2.0 * t[lane], 1.0 - 2.0 * s[lane]];
            let quad = match coherence {
                Coherence::Even(_) => 0,
                Coherence::Random => lane % QUADS,
            };
            let sign = if quad % 2 == 0 { 1.0 } else { -1.0 };
            [0, 1, 2].map(|axis| sign * on_x[(axis + quad) % 3])
        };
        [0, 1, 2].map(|axis| F32s::from_fn(|lane| of(lane)[axis]))
    };
    blocks.into_iter().map(direction).collect()
}

struct Cell {
    plan: SamplePlan,
    blocks: Vec<[F32s; 3]>,
    least: f64,
}

impl Cell {
    fn measure(&mut self, isa: Isa) {
        let mut room = LookupScratch::default();
        let start = Instant::now();
        for _ in 0..PICTURES {
            for block in &self.blocks {
                let lod = Lod::Implicit { bias: None };
                let points = Points { coords: block.each_ref(), layer: None, reference: None };
                self.plan.sample_offset(isa, points, [0; 3], lod, Addresses::Compute, &mut room);
                black_box(&mut room);
            }
        }
        let samples = (PICTURES * self.blocks.len() * LANES) as f64;
        self.least = self.least.min(start.elapsed().as_secs_f64() * 1e9 / samples);
    }
}

fn main() {
    let isa = Isa::from_env().expect("an instruction set of this machine");
    let words: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    let mut rows = Vec::new();
    for (format_name, format) in FORMATS {
        let [plane, cube] = [Shape::D2, Shape::Cube].map(|shape| image(shape, format));
        for filter in &FILTERS {
            for (place, wrap) in [
                ("repeat", Wrap::Repeat),
                ("edge", Wrap::ClampToEdge),
                ("cube", Wrap::ClampToEdge),
                ("seamless cube", Wrap::ClampToEdge),
            ] {
                let is_cube = place.contains("cube");
                let extra = format != Format::Rgba8 || filter.anisotropy > 1.0;
                if extra && place == "edge" {
                    continue;
                }
                let name = format!("{format_name}, {}, {place}", filter.name);
                if !words.is_empty() && !words.iter().any(|word| name.contains(word.as_str())) {
                    continue;
                }
                let sampler = Sampler {
                    wrap: [wrap; 3],
                    min: filter.min,
                    mag: filter.min,
                    mipmap: filter.mipmap,
                    max_anisotropy: filter.anisotropy,
                    seamless: if place == "seamless cube" { Seamless::On } else { Seamless::Off },
                    ..Sampler::default()
                };
                let cells = COHERENCES.map(|(_, coherence)| {
                    let points = coordinates(coherence, filter.anisotropy);
                    let blocks = match is_cube {
                        true => directions(points, coherence),
                        false => points.into_iter().map(|[s, t]| [s, t, F32s::ZERO]).collect(),
                    };
                    let plan = SamplePlan::new(if is_cube { &cube } else { &plane }, &sampler);
                    Cell { plan, blocks, least: f64::INFINITY }
                });
                rows.push((name, cells));
            }
        }
    }
    for _ in 0..ROUNDS {
        rows.iter_mut().flat_map(|(_, cells)| cells).for_each(|cell| cell.measure(isa));
    }
    let heads = COHERENCES.map(|(name, _)| name).join(" | ");
    println!("| {} | {heads} |\n|---|---|---|---|---|", isa.name());
    for (name, cells) in rows {
        let times = cells.map(|cell| format!("{:.1}", cell.least)).join(" | ");
        println!("| {name} | {times} |");
    }
}
