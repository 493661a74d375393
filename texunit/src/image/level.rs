//! One face of one level: its size, its border, and its texels.

use super::limits::{MAX_LAYERS, MAX_LEVEL_BYTES, MAX_SIZE, PADDING};
use super::{ImageError, Memory, TexelSource};
use crate::format::{Format, block, convert};
use std::sync::Arc;

/// One face of one level. Rows run from t = 0 up and slices from r = 0 up, tightly packed.
///
/// Sizes are those of the image without its border. The border's texels are stored where they
/// lie: with a border along an axis, indices -1 and `size` are texels too. A compressed level is
/// rows of blocks of 4×4 texels, those at the edges in full, and has no border.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Level {
    /// How its texels are stored.
    pub format: Format,
    /// Texels in a row.
    pub width: u32,
    /// Rows of a slice.
    pub height: u32,
    /// Slices of a three-dimensional level, layers of an array, otherwise 1.
    pub depth: u32,
    /// Texels of border on either side along s, t and r, 0 or 1 each ([`super::Shape::border`]).
    pub border: [u32; 3],
    /// The texels, and then [`PADDING`] bytes so that a gather of the last texel stays inside.
    pub texels: Memory,
}

impl Level {
    /// The bytes that the texels of a level without border take, padding aside, or none where it
    /// is larger than any level may be. Allocates nothing: for proxy textures.
    pub fn required_bytes(format: Format, width: u32, height: u32, depth: u32) -> Option<usize> {
        Self::bytes_with_border(format, [width, height, depth], [0; 3])
    }

    fn bytes_with_border(format: Format, size: [u32; 3], border: [u32; 3]) -> Option<usize> {
        let limits = [MAX_SIZE, MAX_SIZE, MAX_LAYERS];
        if size.iter().zip(limits).any(|(&side, limit)| side > limit) {
            return None;
        }
        // At most (2^14 + 2)² · (2^11 + 2) · 16: far from overflow.
        let count = |axis: usize| u64::from(size[axis] + 2 * border[axis]);
        let side = u64::from(format.block_side());
        let blocks = count(0).div_ceil(side) * count(1).div_ceil(side) * count(2);
        let bytes = blocks * format.bytes() as u64;
        usize::try_from(bytes).ok().filter(|&bytes| bytes <= MAX_LEVEL_BYTES)
    }

    /// A copy.
    ///
    /// # Errors
    /// If there is no memory for it.
    pub fn copied(&self) -> Result<Self, ImageError> {
        let Self { format, width, height, depth, border, ref texels } = *self;
        let error = ImageError::OutOfMemory { bytes: texels.len() };
        let texels = texels.copied().ok_or(error)?;
        Ok(Self { format, width, height, depth, border, texels })
    }

    /// A two-dimensional level without border whose bytes are all 0.
    ///
    /// # Errors
    /// When it is too large or there is no memory.
    pub fn new(format: Format, width: u32, height: u32) -> Result<Self, ImageError> {
        Self::with_size(format, [width, height, 1], [0; 3])
    }

    /// A level of this width, height and depth, and border along s, t, r, whose bytes are all 0.
    ///
    /// # Errors
    /// When it is too large, the border is wider than 1 (or the format compressed), or there is no
    /// memory.
    pub fn with_size(format: Format, size: [u32; 3], border: [u32; 3]) -> Result<Self, ImageError> {
        let [width, height, depth] = size;
        let widest = if format.block().is_some() { 0 } else { 1 };
        if border.iter().any(|&side| side > widest) {
            return Err(ImageError::WrongBorder { border });
        }
        let bytes = Self::bytes_with_border(format, size, border).ok_or(ImageError::TooLarge {
            width,
            height,
            depth,
        })? + PADDING;
        let texels = Memory::zeroed(bytes).ok_or(ImageError::OutOfMemory { bytes })?;
        Ok(Self { format, width, height, depth, border, texels })
    }

    /// A two-dimensional level without border of four bytes a texel, whose texels are stored elsewhere.
    ///
    /// # Errors
    /// When it is too large.
    pub fn stored_elsewhere(
        format: Format,
        [width, height]: [u32; 2],
        source: Arc<dyn TexelSource>,
    ) -> Result<Self, ImageError> {
        let too_large = ImageError::TooLarge { width, height, depth: 1 };
        Self::required_bytes(format, width, height, 1).ok_or(too_large)?;
        debug_assert_eq!((format.bytes(), format.block()), (4, None));
        let texels = Memory::elsewhere(source);
        Ok(Self { format, width, height, depth: 1, border: [0; 3], texels })
    }

    /// A two-dimensional level of these texels, rows from t = 0 up, tightly packed. Bytes beyond
    /// are ignored.
    ///
    /// # Errors
    /// As [`Level::new`], and when `texels` is too short.
    pub fn from_texels(
        format: Format,
        width: u32,
        height: u32,
        texels: &[u8],
    ) -> Result<Self, ImageError> {
        let mut level = Self::new(format, width, height)?;
        level.write(0, 0, width, height, texels)?;
        Ok(level)
    }

    /// The level of a buffer texture: one dimension, as many whole texels as `bytes` has, at most `max_texels`, which
    /// may be more than an image may have. Texels beyond the reach of a gather are left out.
    ///
    /// # Errors
    /// When there is no memory.
    pub fn of_buffer_texture(
        format: Format,
        bytes: &[u8],
        max_texels: u32,
    ) -> Result<Self, ImageError> {
        let size = format.bytes();
        let count = (bytes.len().min(MAX_LEVEL_BYTES) / size).min(max_texels as usize);
        // What lies outside is read at the first texel, so there always is one.
        let padded = count.max(1) * size + PADDING;
        let mut memory = Memory::zeroed(padded).ok_or(ImageError::OutOfMemory { bytes: padded })?;
        memory[..count * size].copy_from_slice(&bytes[..count * size]);
        let (width, height, depth, border) = (count as u32, 1, 1, [0; 3]);
        Ok(Self { format, width, height, depth, border, texels: memory })
    }

    /// Width, height and depth, without border.
    pub fn size(&self) -> [u32; 3] {
        [self.width, self.height, self.depth]
    }

    /// Width, height and depth as stored: with the border on both sides.
    #[inline(always)]
    pub fn stored_size(&self) -> [u32; 3] {
        // Not `map`, which is not inlined into kernels.
        let [s, t, r] = self.border;
        [self.width + 2 * s, self.height + 2 * t, self.depth + 2 * r]
    }

    /// The number of texels or blocks along a side of `texels`. A shift, as it is computed for every sample.
    #[inline(always)]
    fn units(&self, texels: u32) -> usize {
        let side = self.format.block_side();
        ((texels + side - 1) >> side.trailing_zeros()) as usize
    }

    /// Bytes of a row of texels, border included, or of a row of blocks.
    #[inline(always)]
    pub fn row_bytes(&self) -> usize {
        self.units(self.stored_size()[0]) * self.format.bytes()
    }

    /// Bytes of a slice or layer, border included.
    #[inline(always)]
    pub fn slice_bytes(&self) -> usize {
        self.row_bytes() * self.units(self.stored_size()[1])
    }

    /// Where the bytes of texel (0, 0, 0) begin: after those of the border before it. The texel
    /// at (x, y, z) begins `z · slice_bytes + y · row_bytes + x · bytes` further (of a compressed
    /// level its block, with `⌊y / 4⌋` and `⌊x / 4⌋`).
    #[inline(always)]
    pub fn origin(&self) -> usize {
        let [s, t, r] = self.border;
        let rows = t as usize * self.row_bytes() + s as usize * self.format.bytes();
        r as usize * self.slice_bytes() + rows
    }

    /// The bytes of this many texels of a row, from column, row and slice on, of a level that is not
    /// compressed.
    ///
    /// # Panics
    /// When they are not within the level.
    pub fn row_span(&self, [x, y, slice]: [usize; 3], width: usize) -> &[u8] {
        let size = self.format.bytes();
        let row = self.origin() + slice * self.slice_bytes() + y * self.row_bytes();
        &self.texels[row + x * size..][..width * size]
    }

    /// The bytes of one texel of the first slice, or none outside the level.
    pub fn texel(&self, x: u32, y: u32) -> &[u8] {
        match (i32::try_from(x), i32::try_from(y)) {
            (Ok(x), Ok(y)) if x as u32 != self.width && y as u32 != self.height => {
                self.texel_at([x, y, 0])
            }
            _ => &[],
        }
    }

    /// The bytes of one texel, of the border too (index -1 or the size), or none outside. Of a
    /// compressed level, those of the texel's block.
    pub fn texel_at(&self, at: [i32; 3]) -> &[u8] {
        match self.offset(at) {
            Some(offset) => &self.texels[offset..offset + self.format.bytes()],
            None => &[],
        }
    }

    /// The stored channels of one texel, of the border too; unused ones are 0.
    pub fn channels_at(&self, at: [i32; 3]) -> Option<[f32; 4]> {
        let bytes = self.texel_at(at);
        if bytes.is_empty() {
            return None;
        }
        match self.format.block() {
            Some(_) => {
                let words = convert::words_of(self.format, bytes);
                Some(block::decode_channels(self.format, words, within(at)))
            }
            None => Some(convert::decode_channels(self.format, bytes)),
        }
    }

    /// The colour of one texel, of the border too, as a sample returns it; depth as luminance.
    pub fn color_at(&self, at: [i32; 3]) -> Option<[f32; 4]> {
        self.channels_at(at).map(|channels| convert::expand(self.format.base(), channels))
    }

    /// Where a texel (or its block) begins, if it is one of the level or its border.
    fn offset(&self, at: [i32; 3]) -> Option<usize> {
        let stored = self.stored_size();
        let mut from_corner = [0; 3];
        for axis in 0..3 {
            let index = i64::from(at[axis]) + i64::from(self.border[axis]);
            if index < 0 || index >= i64::from(stored[axis]) {
                return None;
            }
            from_corner[axis] = index as usize;
        }
        let [x, y, z] = from_corner;
        let side = self.format.block_side() as usize;
        let (x, y) = (x / side, y / side);
        Some(z * self.slice_bytes() + y * self.row_bytes() + x * self.format.bytes())
    }

    /// Writes one colour of the first slice, converted as [`convert::encode`] does. Outside the
    /// level: nothing.
    pub fn put(&mut self, x: u32, y: u32, rgba: [f32; 4]) {
        if x < self.width && y < self.height {
            self.put_at([x as i32, y as i32, 0], rgba);
        }
    }

    /// Writes one colour, of the border too, converted as [`convert::encode`] does. Outside:
    /// nothing. A block of a compressed level is compressed anew; use [`Level::fill`] for many.
    pub fn put_at(&mut self, at: [i32; 3], rgba: [f32; 4]) {
        let Some(offset) = self.offset(at) else { return };
        let format = self.format;
        let bytes = format.bytes();
        let texel = match format.block() {
            Some(_) => {
                let old = &self.texels[offset..offset + bytes];
                let mut colors: [[f32; 4]; 16] =
                    std::array::from_fn(|i| block::decode(format, old, i as u32));
                colors[within(at) as usize] = rgba;
                block::encode(format, &colors)
            }
            None => convert::encode(format, rgba),
        };
        self.texels[offset..offset + bytes].copy_from_slice(&texel[..bytes]);
    }

    /// Writes every texel, the border's too, from its place: compresses where the format is
    /// compressed, else converts as [`convert::encode`] does.
    pub fn fill(&mut self, mut color: impl FnMut([i32; 3]) -> [f32; 4]) {
        let side = self.format.block_side() as usize;
        let border = self.border.map(|side| side as i32);
        let end = [0, 1, 2].map(|axis| self.size()[axis] as i32 + border[axis]);
        for z in -border[2]..end[2] {
            for y in (-border[1]..end[1]).step_by(side) {
                for x in (-border[0]..end[0]).step_by(side) {
                    if self.format.block().is_none() {
                        self.put_at([x, y, z], color([x, y, z]));
                        continue;
                    }
                    // Beyond the edge, a block repeats it.
                    let colors: [[f32; 4]; 16] = std::array::from_fn(|i| {
                        let (right, up) = (x + i as i32 % 4, y + i as i32 / 4);
                        color([right.min(end[0] - 1), up.min(end[1] - 1), z])
                    });
                    if let Some(offset) = self.offset([x, y, z]) {
                        let bytes = self.format.bytes();
                        let block = block::encode(self.format, &colors);
                        self.texels[offset..offset + bytes].copy_from_slice(&block[..bytes]);
                    }
                }
            }
        }
    }

    /// Writes a rectangle of texels of the first slice in this level's format, rows upward,
    /// tightly packed.
    ///
    /// # Errors
    /// As [`Level::write_box`].
    pub fn write(
        &mut self,
        x: u32,
        y: u32,
        width: u32,
        height: u32,
        texels: &[u8],
    ) -> Result<(), ImageError> {
        let clamped = [x, y, 0].map(|side| i32::try_from(side).unwrap_or(i32::MAX));
        self.write_box(clamped, [width, height, 1], texels)
    }

    /// Writes a box of texels in this level's format, rows upward, then slices, tightly packed.
    /// `at` is its lowest corner; -1 is the border, where there is one. Of a compressed level,
    /// rows of blocks.
    ///
    /// # Errors
    /// When the box reaches outside or cuts blocks, or `texels` is too short; nothing is written
    /// then.
    pub fn write_box(
        &mut self,
        at: [i32; 3],
        size: [u32; 3],
        texels: &[u8],
    ) -> Result<(), ImageError> {
        for axis in 0..3 {
            let border = i64::from(self.border[axis]);
            let end = i64::from(at[axis]) + i64::from(size[axis]);
            if i64::from(at[axis]) < -border || end > i64::from(self.size()[axis]) + border {
                return Err(ImageError::Outside { at, size, level: self.size() });
            }
        }
        let side = self.format.block_side();
        let cut = (0..2).any(|axis| {
            let reaches_edge =
                at[axis] as i64 + i64::from(size[axis]) >= i64::from(self.size()[axis]);
            at[axis].rem_euclid(side as i32) != 0
                || !size[axis].is_multiple_of(side) && !reaches_edge
        });
        if cut {
            return Err(ImageError::CutsBlocks { at, size });
        }
        let [width, height, depth] = size;
        let run = width.div_ceil(side) as usize * self.format.bytes();
        let rows = height.div_ceil(side) as usize;
        let needed = run * rows * depth as usize;
        if texels.len() < needed {
            let got = texels.len();
            return Err(ImageError::TooShort { width, height, depth, needed, got });
        }
        if needed == 0 {
            return Ok(());
        }
        let (row_bytes, slice_bytes) = (self.row_bytes(), self.slice_bytes());
        let Some(corner) = self.offset(at) else { return Ok(()) };
        for (number, from) in texels[..needed].chunks_exact(run).enumerate() {
            let (row, slice) = (number % rows, number / rows);
            let to = corner + slice * slice_bytes + row * row_bytes;
            self.texels[to..to + run].copy_from_slice(from);
        }
        Ok(())
    }
}

/// Which texel of its block: column plus 4 times row.
fn within([x, y, _]: [i32; 3]) -> u32 {
    ((x & 3) + 4 * (y & 3)) as u32
}
