//! The conversion of a row of texels of a blit to the format of the destination.

use crate::calls::framebuffer::read::Pixels;
use crate::draw::completeness::Aspect;
use crate::pixel::convert::Conversion;
use crate::pixel::texel;
use rasterizer::driver::{DepthWrite, SrgbWrite};
use std::collections::TryReserveError;
use texunit::format::Format;
use texunit::lanes::{F64s, Isa, LANES};
use texunit::pixel;
use texunit::pixel::Tap;
use texunit::sampler::Filter;

/// Pixels that are converted at once.
const RUN: usize = 1024;

/// R, G, B and A of a row of texels.
type Colors = Vec<[f64; 4]>;

/// A row of the source, as numbers.
pub(crate) struct SourceRow {
    /// Which one; `None` before the first.
    y: Option<usize>,
    colors: Colors,
}

/// How a row of texels is converted. Has the memory that it needs.
pub(crate) enum RowConversion<'a> {
    /// As they are.
    Same,
    /// As those of another format.
    Convert { conversion: Conversion<'a>, gathered: Vec<u8> },
    /// As means of four.
    Filter {
        isa: Isa,
        conversion: Conversion<'a>,
        /// The rows of the source that were read last.
        read: [SourceRow; 2],
    },
    /// The depths or the stencils alone, where there are both.
    Merge { formats: [Format; 2], depth: DepthWrite, bits: u8, gathered: Vec<u8> },
}

impl RowConversion<'_> {
    /// How a blit copies an aspect to another format.
    ///
    /// # Errors
    /// When there is no memory for rows of the source.
    pub fn new(
        isa: Isa,
        (aspect, filter): (Aspect, Filter),
        source: &Pixels,
        to: Format,
        srgb: SrgbWrite,
    ) -> Result<Self, TryReserveError> {
        let from = source.format();
        let conversion = || Conversion::blit(isa, from, to, srgb);
        let gathered = || reserved(RUN * from.bytes());
        let merge = |depth, bits| {
            Ok(Self::Merge { formats: [from, to], depth, bits, gathered: gathered()? })
        };
        let row =
            || reserved(source.size()[0] as usize).map(|colors| SourceRow { y: None, colors });
        match (aspect, filter) {
            (Aspect::Color, Filter::Nearest) if from == to => Ok(Self::Same),
            (Aspect::Color, Filter::Nearest) => {
                Ok(Self::Convert { conversion: conversion(), gathered: gathered()? })
            }
            (Aspect::Color, Filter::Linear) => {
                Ok(Self::Filter { isa, conversion: conversion(), read: [row()?, row()?] })
            }
            (Aspect::Depth, _) => merge(DepthWrite::On, 0),
            (Aspect::Stencil, _) => merge(DepthWrite::Off, !0),
        }
    }

    /// Before the rows of a sample: those that were read are another sample's.
    pub fn begin(&mut self) {
        if let Self::Filter { read, .. } = self {
            read.iter_mut().for_each(|row| row.y = None);
        }
    }

    /// Writes a row of texels, made of these columns and rows of the source.
    pub fn write(&mut self, from: &Pixels, columns: &[Tap], row: Tap, texels: &mut [u8]) {
        let Some(size) = texels.len().checked_div(columns.len()) else { return };
        let nearest = row.pixels[0];
        let runs = columns.chunks(RUN).zip(texels.chunks_mut((RUN * size).max(1)));
        match self {
            Self::Same => {
                let mut at = 0;
                for run in runs_of(from, columns, nearest) {
                    texels[at..at + run.len()].copy_from_slice(run);
                    at += run.len();
                }
            }
            Self::Convert { conversion, gathered } => {
                for (columns, texels) in runs {
                    conversion.run(self::gathered(from, columns, nearest, gathered), texels);
                }
            }
            Self::Filter { isa, conversion, read } => {
                for y in row.pixels {
                    if read.iter().all(|read| read.y != Some(y)) {
                        let is_free = |read: &&mut SourceRow| {
                            read.y.is_none_or(|kept| !row.pixels.contains(&kept))
                        };
                        let Some(free) = read.iter_mut().find(is_free) else { return };
                        free.read(conversion, from, y);
                    }
                }
                let of = |y: usize| read.iter().find(|read| read.y == Some(y));
                let [Some(low), Some(high)] = row.pixels.map(of) else { return };
                let rows = [&low.colors[..], &high.colors[..]];
                filter(*isa, conversion, rows, columns, row.weight, texels);
            }
            Self::Merge { formats: [from_format, to], depth, bits, gathered } => {
                for (columns, texels) in runs {
                    let gathered = self::gathered(from, columns, nearest, gathered);
                    let relaid = texel::relaid(*from_format, *to, gathered);
                    texel::merge(*to, *depth, *bits, &relaid, texels);
                }
            }
        }
    }
}

/// An empty vector with memory for so many elements.
pub(crate) fn reserved<T>(count: usize) -> Result<Vec<T>, TryReserveError> {
    let mut all = Vec::new();
    all.try_reserve_exact(count)?;
    Ok(all)
}

/// The texels of a row that columns are nearest to, those together that lie together.
fn runs_of<'a>(from: &'a Pixels, columns: &'a [Tap], y: usize) -> impl Iterator<Item = &'a [u8]> {
    let (size, [width, _]) = (from.format().bytes(), from.size());
    let row = from.row(0, y, width as usize);
    let runs = columns.chunk_by(|a, b| a.pixels[0] + 1 == b.pixels[0]);
    runs.map(move |run| &row[run[0].pixels[0] * size..][..run.len() * size])
}

/// The same, one after the other.
fn gathered<'a>(
    from: &'a Pixels,
    columns: &'a [Tap],
    y: usize,
    gathered: &'a mut Vec<u8>,
) -> &'a [u8] {
    let mut runs = runs_of(from, columns, y);
    let Some(first) = runs.next() else { return &[] };
    if first.len() == columns.len() * from.format().bytes() {
        return first;
    }
    gathered.clear();
    std::iter::once(first).chain(runs).for_each(|run| gathered.extend_from_slice(run));
    gathered
}

impl SourceRow {
    /// Reads a row of the source.
    fn read(&mut self, conversion: &Conversion<'_>, from: &Pixels, y: usize) {
        let [width, _] = from.size().map(|side| side as usize);
        self.y = Some(y);
        self.colors.clear();
        for x in (0..width).step_by(LANES) {
            let count = LANES.min(width - x);
            let numbers = conversion.read(from.row(x, y, count));
            pixel::interleave(&numbers, count, &mut self.colors);
        }
    }
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
