//! Texels from tiles to rows: those of a level, or of a client that reads a region of a picture.

use super::{
    BlockTexels, Level, Slices, StoreContext, Surface, WORTH_THREADS, WordPlane, attachment_words,
    is_attachable, row_of,
};
use crate::attachment::resolve::resolve_tile;
use crate::attachment::words::texel_of;
use crate::sizes::TILE;
use bytemuck::Pod;
use std::iter::once;
use texunit::format::Format;
use texunit::lanes::Isa;

/// The first pixel and the width of a region of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RowSpan {
    /// The first column.
    pub x: u32,
    /// The first row.
    pub y: u32,
    /// Pixels across.
    pub width: u32,
}

/// Writes rows of texels to the memory of a client.
#[derive(Clone, Copy)]
pub enum RowWriter<'a> {
    /// Copies them as they are stored.
    Copy,
    /// Converts them by this function of the texels and the row of the client.
    Convert(&'a (dyn Fn(&[u8], &mut [u8]) + Sync)),
}

impl RowWriter<'_> {
    /// Writes a row of texels.
    pub(crate) fn row(self, texels: &[u8], to: &mut [u8]) {
        match self {
            RowWriter::Copy => to[..texels.len()].copy_from_slice(texels),
            RowWriter::Convert(convert) => convert(texels, to),
        }
    }
}

/// Which samples of a pixel are written to a texel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SampleSelection {
    /// All samples, resolved.
    All,
    /// This sample.
    One(usize),
}

impl Surface {
    /// Writes the tiles back into slices of the level they came from.
    pub fn store(&self, level: &mut Level, slices: Slices, context: StoreContext<'_>) {
        self.store_tiles(&vec![true; self.tiles.len()], level, slices, context);
    }

    /// Writes those tiles for which `stored` is true into slices of the level that they came from.
    pub(super) fn store_tiles(
        &self,
        stored: &[bool],
        level: &mut Level,
        slices: Slices,
        context: StoreContext<'_>,
    ) {
        debug_assert_eq!((self.width, self.height), (level.width, level.height));
        if !is_attachable(self.format) {
            return;
        }
        let StoreContext { isa, thread_pool } = context;
        let row_bytes = level.row_bytes().max(1);
        let count = stored.iter().filter(|stored| **stored).count();
        for (samples, slice) in self.selections(slices) {
            let first = level.origin() + slice * level.slice_bytes();
            let texels = &mut level.texels[first..first + self.height as usize * row_bytes];
            // A band is what lies in one row of tiles.
            let texels = texels.chunks_mut(TILE as usize * row_bytes);
            let rows_of_tiles = texels.zip(stored.chunks(self.tiles_across().max(1) as usize));
            let mut bands: Vec<_> = (0..)
                .step_by(TILE as usize)
                .zip(rows_of_tiles)
                .filter(|(_, (_, stored))| stored.contains(&true))
                .collect();
            let least = if count >= WORTH_THREADS { 1 } else { bands.len() };
            thread_pool.for_each_chunk(
                &mut bands,
                least,
                || (),
                |(), bands| {
                    for (y, (texels, stored)) in bands {
                        let mut rows: Vec<_> = texels.chunks_mut(row_bytes).collect();
                        self.store_runs(isa, samples, *y, stored, &mut rows);
                    }
                },
            );
        }
    }

    /// Writes tiles of the row of tiles that begins at row `y`, neighbours together, into whole rows of a level.
    fn store_runs(
        &self,
        isa: Isa,
        samples: SampleSelection,
        y: u32,
        stored: &[bool],
        rows: &mut [&mut [u8]],
    ) {
        let mut end = 0;
        for run in stored.chunk_by(|a, b| a == b) {
            let x = end;
            end = (x + run.len() as u32 * TILE).min(self.width);
            if run[0] {
                let first = x as usize * self.format.bytes();
                let mut rows: Vec<_> = rows.iter_mut().map(|row| &mut row[first..]).collect();
                let span = RowSpan { x, y, width: end - x };
                self.store_band(isa, samples, span, &mut rows, RowWriter::Copy);
            }
        }
    }

    /// Which samples go to which slice of a level.
    fn selections(&self, slices: Slices) -> Vec<(SampleSelection, usize)> {
        match slices {
            Slices::One(slice) => vec![(SampleSelection::All, slice)],
            Slices::Each(first) => {
                let samples = 0..self.samples.into();
                samples.map(|sample| (SampleSelection::One(sample), first + sample)).collect()
            }
        }
    }

    /// Writes the texels of a region, samples resolved, into the rows of a client.
    pub fn read(
        &self,
        span: RowSpan,
        rows: &mut [&mut [u8]],
        writer: RowWriter<'_>,
        context: StoreContext<'_>,
    ) {
        self.store_region(SampleSelection::All, span, rows, writer, context);
    }

    fn store_region(
        &self,
        samples: SampleSelection,
        span: RowSpan,
        rows: &mut [&mut [u8]],
        writer: RowWriter<'_>,
        context: StoreContext<'_>,
    ) {
        if !is_attachable(self.format) || rows.is_empty() {
            return;
        }
        let pixels = rows.len() * span.width as usize;
        // A band is what lies in one row of tiles.
        let second = (span.y / TILE + 1) * TILE;
        let (first, rest) = rows.split_at_mut(rows.len().min((second - span.y) as usize));
        let rest = (second..).step_by(TILE as usize).zip(rest.chunks_mut(TILE as usize));
        let mut bands: Vec<_> = once((span.y, first)).chain(rest).collect();
        let is_large = pixels >= WORTH_THREADS * (TILE * TILE) as usize;
        let least = if is_large { 1 } else { bands.len() };
        let isa = context.isa;
        context.thread_pool.for_each_chunk(
            &mut bands,
            least,
            || (),
            |(), bands| {
                for (y, rows) in bands {
                    self.store_band(isa, samples, RowSpan { y: *y, ..span }, rows, writer);
                }
            },
        );
    }

    /// Writes rows that lie in one row of tiles.
    fn store_band(
        &self,
        isa: Isa,
        samples: SampleSelection,
        span: RowSpan,
        rows: &mut [&mut [u8]],
        writer: RowWriter<'_>,
    ) {
        let (size, words) = (self.format.bytes(), attachment_words(self.format));
        let row_of_tiles = (span.y / TILE * self.tiles_across()) as usize;
        let (from, to) = (span.x / TILE, (span.x + span.width).div_ceil(TILE));
        let tiles = &self.tiles[row_of_tiles + from as usize..row_of_tiles + to as usize];
        let [x, y, width] = [span.x % TILE, span.y % TILE, span.width].map(|at| at as usize);
        let resolved: Vec<Vec<WordPlane>>;
        let planes: Vec<&[WordPlane]> = match samples {
            SampleSelection::All if self.samples > 1 => {
                let blocks = y / 8..(y + rows.len()).div_ceil(8);
                let resolve = |tile: &Vec<WordPlane>| {
                    resolve_tile(isa, self.format, self.samples, tile, blocks.clone())
                };
                resolved = tiles.iter().map(resolve).collect();
                resolved.iter().map(Vec::as_slice).collect()
            }
            SampleSelection::All => tiles.iter().map(Vec::as_slice).collect(),
            SampleSelection::One(sample) => {
                tiles.iter().map(|tile| &tile[sample * words..][..words]).collect()
            }
        };
        // What is stored begins at a column of eight.
        let skipped = x % 8;
        let mut texels = Vec::new();
        for (y, row) in (y..).zip(rows) {
            let from = RowStart { column: x / 8, y };
            match writer {
                RowWriter::Copy if skipped == 0 => {
                    store_tiles(self.format, &planes, from, &mut row[..width * size]);
                }
                RowWriter::Copy | RowWriter::Convert(_) => {
                    texels.resize((skipped + width) * size, 0);
                    store_tiles(self.format, &planes, from, &mut texels);
                    writer.row(&texels[skipped * size..], row);
                }
            }
        }
    }
}

/// A row of tiles side by side into the texels of one row, from a place in the first on.
fn store_tiles(format: Format, tiles: &[&[WordPlane]], from: RowStart, row: &mut [u8]) {
    let tile_bytes = TILE as usize * format.bytes();
    let left = tile_bytes - from.column * 8 * format.bytes();
    let (first, rest) = row.split_at_mut(left.min(row.len()));
    let rest = rest.chunks_mut(tile_bytes).map(|row| (RowStart { column: 0, ..from }, row));
    for (planes, (from, row)) in tiles.iter().zip(once((from, first)).chain(rest)) {
        store_row(format, planes, from, row);
    }
}

/// From where on a row of a tile is stored.
#[derive(Clone, Copy)]
struct RowStart {
    /// Columns of eight pixels before it.
    column: usize,
    y: usize,
}

impl RowStart {
    /// The words of a column of eight from here on.
    #[inline(always)]
    fn words(self, plane: &WordPlane, column: usize) -> [u32; 8] {
        let block = self.y / 8 * 8 + self.column + column;
        match plane.texels(block) {
            BlockTexels::Words(words) => row_of(words, self.y % 8),
            BlockTexels::Uniform(word) => [word; 8],
            BlockTexels::Depth(depths) => depths.row(block, self.y % 8),
        }
    }
}

/// A row of a tile into the texels of one row.
fn store_row(format: Format, planes: &[WordPlane], from: RowStart, row: &mut [u8]) {
    let size = format.bytes();
    // Texels whose bytes are those of their words.
    let done = match (planes, size) {
        ([a], 1) => write_columns(row, |column| from.words(a, column).map(|word| word as u8)),
        ([a], 2) => {
            write_columns(row, |column| from.words(a, column).map(|word| (word as u16).to_le()))
        }
        ([a], 3) => write_columns(row, |column| from.words(a, column).map(first_three)),
        ([a], 4) => write_columns(row, |column| from.words(a, column).map(u32::to_le)),
        // Depth and stencil.
        ([a, b], 4) => write_columns(row, |column| {
            let (depths, stencils) = (from.words(a, column), from.words(b, column));
            std::array::from_fn(|x| (depths[x] << 8 | stencils[x] & 0xFF).to_le())
        }),
        ([a, b], 8) => {
            write_columns(row, |column| interleave([from.words(a, column), from.words(b, column)]))
        }
        // Not `map`, which stays a call for each.
        ([a, b, c, d], 16) => write_columns(row, |column| {
            let [a, b] = [from.words(a, column), from.words(b, column)];
            interleave([a, b, from.words(c, column), from.words(d, column)])
        }),
        _ => 0,
    };
    for (column, texels) in row.chunks_mut(8 * size).enumerate().skip(done) {
        let mut all = [[0; 8]; 4];
        for (to, plane) in all.iter_mut().zip(planes) {
            *to = from.words(plane, column);
        }
        for (x, texel) in texels.chunks_exact_mut(size).enumerate() {
            texel_of(format, all.map(|words| words[x]), texel);
        }
    }
}

/// The bytes of a texel that has three.
#[inline(always)]
fn first_three(word: u32) -> [u8; 3] {
    let [r, g, b, _] = word.to_le_bytes();
    [r, g, b]
}

/// The texels of eight pixels from their words, plane by plane.
#[inline(always)]
fn interleave<const WORDS: usize>(planes: [[u32; 8]; WORDS]) -> [[u32; WORDS]; 8] {
    let mut texels = [[0; WORDS]; 8];
    for (x, texel) in texels.iter_mut().enumerate() {
        for (word, plane) in texel.iter_mut().zip(&planes) {
            *word = plane[x].to_le();
        }
    }
    texels
}

/// Writes whole columns of eight texels into a row. Says how many there are.
#[inline(always)]
fn write_columns<T: Pod>(row: &mut [u8], column: impl Fn(usize) -> [T; 8]) -> usize {
    let columns = row.chunks_exact_mut(size_of::<[T; 8]>());
    let count = columns.len();
    for (number, texels) in columns.enumerate() {
        texels.copy_from_slice(bytemuck::bytes_of(&column(number)));
    }
    count
}
