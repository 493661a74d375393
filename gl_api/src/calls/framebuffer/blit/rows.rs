//! The conversion of a row of texels of a blit to the format of the destination.

use crate::calls::framebuffer::read::Pixels;
use crate::draw::completeness::Aspect;
use crate::pixel::convert::Conversion;
use crate::pixel::texel;
use rasterizer::driver::{DepthWrite, SrgbWrite};
use texunit::format::Format;
use texunit::lanes::{F64s, Isa, LANES};
use texunit::pixel;
use texunit::pixel::Tap;
use texunit::sampler::Filter;

/// R, G, B and A of a row of texels.
type Colors = Vec<[f64; 4]>;

/// How a row of texels is converted.
pub(crate) enum RowConversion<'a> {
    /// As they are.
    Same,
    /// As those of another format.
    Convert(Conversion<'a>),
    /// As means of four.
    Filter {
        isa: Isa,
        conversion: Conversion<'a>,
        /// The rows of the source that were read last, with their numbers.
        read: Vec<(usize, Colors)>,
    },
    /// The depths or the stencils alone, where there are both.
    Merge { formats: [Format; 2], depth: DepthWrite, bits: u8 },
}

impl RowConversion<'_> {
    /// How a blit copies an aspect from one format to another.
    pub fn new(
        isa: Isa,
        (aspect, filter): (Aspect, Filter),
        [from, to]: [Format; 2],
        srgb: SrgbWrite,
    ) -> Self {
        let conversion = || Conversion::blit(isa, from, to, srgb);
        match (aspect, filter) {
            (Aspect::Color, Filter::Nearest) if from == to => Self::Same,
            (Aspect::Color, Filter::Nearest) => Self::Convert(conversion()),
            (Aspect::Color, Filter::Linear) => {
                Self::Filter { isa, conversion: conversion(), read: Vec::new() }
            }
            (Aspect::Depth, _) => {
                Self::Merge { formats: [from, to], depth: DepthWrite::On, bits: 0 }
            }
            (Aspect::Stencil, _) => {
                Self::Merge { formats: [from, to], depth: DepthWrite::Off, bits: !0 }
            }
        }
    }

    /// Writes a row of texels, made of these columns and rows of the source.
    pub fn write(&mut self, from: &Pixels, columns: &[Tap], row: Tap, texels: &mut [u8]) {
        let nearest = || gathered(from, columns, row.pixels[0]);
        match self {
            Self::Same => texels.copy_from_slice(&nearest()),
            Self::Convert(conversion) => conversion.run(&nearest(), texels),
            Self::Filter { isa, conversion, read } => {
                read.retain(|(y, _)| row.pixels.contains(y));
                for y in row.pixels {
                    if !read.iter().any(|(at, _)| *at == y) {
                        read.push((y, colors(conversion, from, y)));
                    }
                }
                let of = |y: usize| read.iter().find(|(at, _)| *at == y).map(|(_, row)| &row[..]);
                let [Some(low), Some(high)] = row.pixels.map(of) else { return };
                filter(*isa, conversion, [low, high], columns, row.weight, texels);
            }
            Self::Merge { formats: [from, to], depth, bits } => {
                texel::merge(*to, *depth, *bits, &texel::relaid(*from, *to, &nearest()), texels);
            }
        }
    }
}

/// The texels of a row that columns are nearest to.
fn gathered(from: &Pixels, columns: &[Tap], y: usize) -> Vec<u8> {
    let (size, [width, _]) = (from.format().bytes(), from.size());
    let row = from.row(0, y, width as usize);
    let mut out = Vec::with_capacity(columns.len() * size);
    for run in columns.chunk_by(|a, b| a.pixels[0] + 1 == b.pixels[0]) {
        out.extend_from_slice(&row[run[0].pixels[0] * size..][..run.len() * size]);
    }
    out
}

/// The numbers of a row of the source.
fn colors(conversion: &Conversion<'_>, from: &Pixels, y: usize) -> Colors {
    let [width, _] = from.size().map(|side| side as usize);
    let mut out = Vec::with_capacity(width);
    for x in (0..width).step_by(LANES) {
        let count = LANES.min(width - x);
        pixel::interleave(&conversion.read(from.row(x, y, count)), count, &mut out);
    }
    out
}

/// A row of means.
fn filter(
    isa: Isa,
    conversion: &Conversion<'_>,
    rows: [&[[f64; 4]]; 2],
    columns: &[Tap],
    weight: f64,
    texels: &mut [u8],
) {
    let Some(size) = texels.len().checked_div(columns.len()) else { return };
    let mut rgba = [F64s::ZERO; 4];
    for (taps, texels) in columns.chunks(LANES).zip(texels.chunks_mut(LANES * size)) {
        pixel::means(isa, rows, taps, weight, &mut rgba);
        conversion.write(&rgba, texels);
    }
}
