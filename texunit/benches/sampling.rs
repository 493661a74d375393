//! How long 64 samples of a 512×512 RGBA8 image take, per filter and instruction set.
//!
//! A pass samples 64×64 pixels, of an image repeated at an angle and slightly minified; its time
//! over 4096 is the time of a sample.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use std::time::Duration;
use texunit::format::Format;
use texunit::image::{Image, Level, Shape};
use texunit::lanes::{F32s, Isa, lane_x, lane_y};
use texunit::plan::{Lod, SamplePlan};
use texunit::sampler::{Filter, Mipmap, Sampler};

const SIZE: u32 = 512;
const BLOCKS: usize = 8;

fn image() -> Image {
    let texels: Vec<u8> =
        (0..SIZE * SIZE * 4).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
    let mut image = Image::new(Shape::D2);
    let base = Level::from_texels(Format::Rgba8, SIZE, SIZE, &texels).expect("a small level");
    image.set_level(0, 0, base).expect("level 0 of a 2D image");
    image.generate_mipmaps(0, 1000).expect("there is a base level");
    image
}

/// Texture coordinates of a picture of 64×64 pixels, block by block.
fn coordinates() -> Vec<[F32s; 2]> {
    let step = 1.6 / SIZE as f32;
    let place = |x: usize, y: usize| {
        let (x, y) = (x as f32, y as f32);
        [0.9 + (0.8 * x - 0.6 * y) * step, -0.1 + (0.6 * x + 0.8 * y) * step]
    };
    let mut blocks = Vec::new();
    for by in 0..BLOCKS {
        for bx in 0..BLOCKS {
            blocks.push([0, 1].map(|axis| {
                F32s::from_fn(|l| place(bx * 8 + lane_x(l), by * 8 + lane_y(l))[axis])
            }));
        }
    }
    blocks
}

fn sampling(c: &mut Criterion) {
    let image = image();
    let blocks = coordinates();
    let filters = [
        ("nearest", Filter::Nearest, Mipmap::None),
        ("bilinear", Filter::Linear, Mipmap::None),
        ("trilinear", Filter::Linear, Mipmap::Linear),
    ];
    for (name, filter, mipmap) in filters {
        let sampler = Sampler { min: filter, mag: filter, mipmap, ..Sampler::default() };
        let plan = SamplePlan::new(&image, &sampler);
        let mut group = c.benchmark_group(name);
        group.throughput(Throughput::Elements((blocks.len() * 64) as u64));
        group.sample_size(20);
        group.warm_up_time(Duration::from_millis(300));
        group.measurement_time(Duration::from_secs(1));
        for isa in Isa::available() {
            group.bench_function(isa.name(), |b| {
                b.iter_batched_ref(
                    || [F32s::ZERO; 4],
                    |out| {
                        for [s, t] in &blocks {
                            let lod = Lod::Implicit { bias: None };
                            plan.sample(isa, [s, t, &F32s::ZERO], None, lod, out);
                            black_box(&mut *out);
                        }
                    },
                    BatchSize::SmallInput,
                );
            });
        }
        group.finish();
    }
}

criterion_group!(benches, sampling);
criterion_main!(benches);
