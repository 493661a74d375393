//! How long the first mipmap of a 2048×2048 image takes, per format and instruction set.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use std::time::Duration;
use texunit::format::Format;
use texunit::image::{Level, Shape};
use texunit::lanes::Isa;

const SIZE: u32 = 2048;

fn halving(c: &mut Criterion) {
    let cases = [
        (Format::Rgba8, SIZE),
        (Format::Rgba8, SIZE - 1),
        (Format::Srgb8A8, SIZE),
        (Format::Rgba16F, SIZE),
        (Format::Rgba32F, SIZE),
    ];
    for (format, size) in cases {
        let mut level = Level::new(format, size, size).expect("a small level");
        for (i, byte) in level.texels.iter_mut().enumerate() {
            *byte = ((i as u32).wrapping_mul(2_654_435_761) >> 24) as u8;
        }
        let mut group = c.benchmark_group(format!("halve {format:?} {size}"));
        group.throughput(Throughput::Elements(u64::from(size) * u64::from(size)));
        group.sample_size(10);
        group.warm_up_time(Duration::from_millis(300));
        group.measurement_time(Duration::from_secs(1));
        for isa in Isa::available() {
            group.bench_function(isa.name(), |b| {
                b.iter(|| black_box(level.halved(Shape::D2, isa).expect("colours have means")));
            });
        }
        group.finish();
    }
}

criterion_group!(benches, halving);
criterion_main!(benches);
