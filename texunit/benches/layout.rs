//! Whether tiled texels would pay: the fetch of 2×2 texels of four bytes from rows, as levels are
//! stored, and from tiles of 4×4 texels, a cache line each; nanoseconds per sample.
//!
//! Rows take two gathers of eight bytes, since a row's two texels lie side by side; in tiles they
//! may lie in two, so that four of four bytes are needed.

use std::hint::black_box;
use std::time::Instant;
use texunit::lanes::{Isa, Kernel, LANES, Simd, U32s, lane_x, lane_y};

/// Blocks of a measurement, and how often it is repeated.
const BLOCKS: usize = 4096;
const ROUNDS: usize = 9;

#[derive(Clone, Copy)]
enum Layout {
    Rows,
    Tiles,
}

struct Fetch<'a> {
    layout: Layout,
    texels: &'a [u8],
    size: u32,
    x: &'a U32s,
    y: &'a U32s,
}

#[inline(always)]
fn in_tiles(x: u32, y: u32, size: u32) -> u32 {
    ((y >> 2) * (size >> 2) + (x >> 2)) * 64 + (y & 3) * 16 + (x & 3) * 4
}

impl Kernel for Fetch<'_> {
    type Output = U32s;

    #[inline(always)]
    fn run<S: Simd>(self) -> U32s {
        let Self { layout, texels, size, x, y } = self;
        let mut sum = U32s::ZERO;
        for row in 0..2 {
            let (mut left, mut right) = (U32s::ZERO, U32s::ZERO);
            for lane in 0..LANES {
                let (x, y) = (x[lane], y[lane] + row);
                left[lane] = match layout {
                    Layout::Rows => (y * size + x) * 4,
                    Layout::Tiles => in_tiles(x, y, size),
                };
                right[lane] = in_tiles(x + 1, y, size);
            }
            let [first, second] = match layout {
                Layout::Rows => S::gather_pairs(texels, &left),
                Layout::Tiles => [S::gather(texels, &left), S::gather(texels, &right)],
            };
            for lane in 0..LANES {
                sum[lane] = sum[lane].wrapping_add(first[lane] ^ second[lane]);
            }
        }
        sum
    }
}

/// Texel coordinates of one block of pixels: along rows, along columns, or anywhere.
fn place(pattern: &str, block: usize, size: u32) -> [U32s; 2] {
    let across = size as usize / 8 - 1;
    let corner = [(block % across * 8) as u32, (block / across * 8) as u32 % (size - 16)];
    let noise = |lane: usize, salt: usize| {
        let mixed = (block * 64 + lane).wrapping_mul(0x9E37_79B9 + salt * 2) as u32;
        (mixed ^ mixed >> 15).wrapping_mul(0x85EB_CA6B) >> 7
    };
    let [s, t] = [0, 1].map(|axis| {
        U32s::from_fn(|lane| match pattern {
            "random" => noise(lane % 16, axis) % (size - 2),
            _ => corner[axis] + [lane_x(lane), lane_y(lane)][axis] as u32,
        })
    });
    if pattern == "columns" { [t, s] } else { [s, t] }
}

fn main() {
    let isa = Isa::from_env().expect("an instruction set of this machine");
    println!("| {} | rows | tiles |\n|---|---|---|", isa.name());
    for size in [512, 4096] {
        let texels: Vec<u8> = (0..size * size * 4 + 8).map(|i| i as u8).collect();
        for pattern in ["rows", "columns", "random"] {
            let blocks: Vec<_> = (0..BLOCKS).map(|block| place(pattern, block, size)).collect();
            let mut least = [f64::INFINITY; 2];
            for _ in 0..ROUNDS {
                for (layout, least) in [Layout::Rows, Layout::Tiles].into_iter().zip(&mut least) {
                    let start = Instant::now();
                    for [x, y] in &blocks {
                        black_box(isa.run(Fetch { layout, texels: &texels, size, x, y }));
                    }
                    let samples = (BLOCKS * LANES) as f64;
                    *least = least.min(start.elapsed().as_secs_f64() * 1e9 / samples);
                }
            }
            println!("| {size}², along {pattern} | {:.2} | {:.2} |", least[0], least[1]);
        }
    }
}
