//! The attachment layout of a level: tiles, blocks, lanes.
//!
//! While an image is drawn to, its texels are words in tiles of 64×64 pixels, each of 64 blocks of
//! 8×8 pixels, each in lane order. A batch then reads and writes whole vectors, a tile's words stay
//! in the cache of the thread that owns it, and tiles can be handed to threads as values. Going
//! back to rows (to sample or to read back) is a transition of layout, as in Vulkan, and exact.
//!
//! A colour word is red, green, blue, alpha from its lowest byte up, whatever the format holds of
//! them; a depth word is the integer of D16 or D24, or the bits of D32F. (Depth is never negative,
//! so the bits of two floats compare as the floats do.)

use rayon::prelude::*;
use texunit::format::{BaseFormat, Format};
use texunit::image::Level;
use texunit::lanes::{LANES, U32s, lane_x, lane_y};

/// Pixels along a side of a tile.
pub const TILE: u32 = 64;
/// Blocks of 8×8 pixels in a tile.
pub const BLOCKS: usize = 64;

/// One tile of one attachment.
#[derive(Clone, Debug)]
pub enum Plane {
    /// The same word everywhere: a clear that nothing has drawn over.
    Cleared(u32),
    /// [`BLOCKS`] blocks, row by row, each in lane order.
    Words(Vec<U32s>),
}

impl Plane {
    /// The blocks, for writing.
    pub fn blocks_mut(&mut self) -> &mut [U32s] {
        if let Self::Cleared(word) = *self {
            *self = Self::Words(vec![U32s::splat(word); BLOCKS]);
        }
        match self {
            Self::Words(words) => words,
            Self::Cleared(_) => unreachable!("became words above"),
        }
    }
}

/// A level in the attachment layout.
#[derive(Clone, Debug)]
pub struct Surface {
    /// The format of the level.
    pub format: Format,
    /// Pixels across.
    pub width: u32,
    /// Pixels up.
    pub height: u32,
    /// The tiles, row by row.
    pub planes: Vec<Plane>,
}

/// Lane of each pixel of a block's row.
const LANE_AT: [[u8; 8]; 8] = {
    let mut table = [[0; 8]; 8];
    let mut lane = 0;
    while lane < LANES {
        table[lane_y(lane)][lane_x(lane)] = lane as u8;
        lane += 1;
    }
    table
};

impl Surface {
    /// Tiles across.
    pub fn tiles_across(&self) -> u32 {
        self.width.div_ceil(TILE)
    }

    /// The texels of a level, in tiles.
    pub fn from_level(level: &Level) -> Self {
        let across = level.width.div_ceil(TILE);
        let up = level.height.div_ceil(TILE);
        let size = level.format.bytes();
        let row_bytes = level.width as usize * size;
        let planes = (0..across * up)
            .into_par_iter()
            .map(|tile| {
                let (x0, y0) = (tile % across * TILE, tile / across * TILE);
                let mut words = vec![U32s::ZERO; BLOCKS];
                for y in 0..TILE.min(level.height - y0) {
                    let row = &level.texels[(y0 + y) as usize * row_bytes..][..row_bytes];
                    for x in 0..TILE.min(level.width - x0) {
                        let texel = &row[(x0 + x) as usize * size..][..size];
                        let block = (y / 8 * 8 + x / 8) as usize;
                        let lane = LANE_AT[(y % 8) as usize][(x % 8) as usize];
                        words[block][lane as usize] = word_of(level.format, texel);
                    }
                }
                Plane::Words(words)
            })
            .collect();
        Self { format: level.format, width: level.width, height: level.height, planes }
    }

    /// Writes the tiles back into the rows of the level they came from.
    pub fn store(&self, level: &mut Level) {
        debug_assert_eq!((self.width, self.height), (level.width, level.height));
        let size = self.format.bytes();
        let row_bytes = self.width as usize * size;
        let across = self.tiles_across() as usize;
        let used = row_bytes * self.height as usize;
        for (y, row) in level.texels[..used].chunks_exact_mut(row_bytes).enumerate() {
            let planes = &self.planes[y / TILE as usize * across..][..across];
            for (texels, plane) in row.chunks_mut(TILE as usize * size).zip(planes) {
                store_row(self.format, plane, y % TILE as usize, texels);
            }
        }
    }
}

/// Row `y` of a tile into the texels of one row.
fn store_row(format: Format, plane: &Plane, y: usize, row: &mut [u8]) {
    let size = format.bytes();
    for (column, texels) in row.chunks_mut(8 * size).enumerate() {
        let words = match plane {
            Plane::Cleared(word) => [*word; 8],
            Plane::Words(words) => {
                let block = &words[y / 8 * 8 + column];
                LANE_AT[y % 8].map(|lane| block[usize::from(lane)])
            }
        };
        // Words of four bytes are the texels themselves.
        if size == 4 {
            texels.copy_from_slice(&bytemuck::bytes_of(&words.map(u32::to_le))[..texels.len()]);
        } else {
            for (texel, word) in texels.chunks_exact_mut(size).zip(words) {
                texel_of(format, word, texel);
            }
        }
    }
}

/// A texel as a word of the attachment layout. Components that the format lacks are 0, alpha 1.
#[inline]
fn word_of(format: Format, t: &[u8]) -> u32 {
    let rgba = |r, g, b, a| u32::from_le_bytes([r, g, b, a]);
    match format {
        Format::A8 => rgba(0, 0, 0, t[0]),
        Format::L8 | Format::Sl8 | Format::R8 => rgba(t[0], 0, 0, 255),
        Format::I8 => rgba(t[0], 0, 0, t[0]),
        Format::La8 | Format::Sl8A8 => rgba(t[0], 0, 0, t[1]),
        Format::Rg8 => rgba(t[0], t[1], 0, 255),
        Format::Rgb8 | Format::Srgb8 => rgba(t[0], t[1], t[2], 255),
        Format::Rgba8 | Format::Srgb8A8 => rgba(t[0], t[1], t[2], t[3]),
        Format::D16 => u32::from(u16::from_le_bytes([t[0], t[1]])),
        Format::D24 | Format::D32F => u32::from_le_bytes([t[0], t[1], t[2], t[3]]),
    }
}

/// A word of the attachment layout as a texel. Luminance and intensity take red (GL 2.1, table 3.15).
#[inline]
fn texel_of(format: Format, word: u32, t: &mut [u8]) {
    let b = word.to_le_bytes();
    match format {
        Format::A8 => t[0] = b[3],
        Format::L8 | Format::Sl8 | Format::R8 | Format::I8 => t[0] = b[0],
        Format::La8 | Format::Sl8A8 => t.copy_from_slice(&[b[0], b[3]]),
        Format::Rg8 | Format::D16 => t.copy_from_slice(&b[..2]),
        Format::Rgb8 | Format::Srgb8 => t.copy_from_slice(&b[..3]),
        Format::Rgba8 | Format::Srgb8A8 | Format::D24 | Format::D32F => t.copy_from_slice(&b),
    }
}

/// Which components of a colour word a format holds.
pub(crate) fn stored_components(format: Format) -> [bool; 4] {
    match format.base() {
        BaseFormat::Alpha => [false, false, false, true],
        BaseFormat::Luminance | BaseFormat::Red | BaseFormat::Intensity => {
            [true, false, false, false]
        }
        BaseFormat::LuminanceAlpha => [true, false, false, true],
        BaseFormat::Rg => [true, true, false, false],
        BaseFormat::Rgb => [true, true, true, false],
        BaseFormat::Rgba => [true; 4],
        BaseFormat::Depth => [false; 4],
    }
}
