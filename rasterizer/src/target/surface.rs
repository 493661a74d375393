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

use crate::output::DepthFormat;
use rayon::prelude::*;
use texunit::format::{BaseFormat, Encoding, Format};
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

    /// The texels of a level, in tiles. Only of its first slice, without border; zeros where the
    /// format has no attachment layout, which a command buffer with such an attachment is refused
    /// for.
    pub fn from_level(level: &Level) -> Self {
        let across = level.width.div_ceil(TILE);
        let up = level.height.div_ceil(TILE);
        let size = level.format.bytes();
        let (row_bytes, origin) = (level.row_bytes(), level.origin());
        let attachable = is_attachable(level.format);
        let planes = (0..across * up)
            .into_par_iter()
            .map(|tile| {
                if !attachable {
                    return Plane::Cleared(0);
                }
                let (x0, y0) = (tile % across * TILE, tile / across * TILE);
                let mut words = vec![U32s::ZERO; BLOCKS];
                for y in 0..TILE.min(level.height - y0) {
                    let row = &level.texels[origin + (y0 + y) as usize * row_bytes..];
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
        if !is_attachable(self.format) {
            return;
        }
        let size = self.format.bytes();
        let (row_bytes, origin) = (level.row_bytes(), level.origin());
        let across = self.tiles_across() as usize;
        for y in 0..self.height as usize {
            let row = &mut level.texels[origin + y * row_bytes..][..self.width as usize * size];
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

/// Whether levels of this format have an attachment layout: colour channels that are bytes, sRGB
/// or not, and depth that is one word.
pub(crate) fn is_attachable(format: Format) -> bool {
    if format.is_depth() {
        return DepthFormat::of(format).is_some();
    }
    format.bytes() == format.channels()
        && matches!(format.info().encoding, Encoding::Unorm | Encoding::Srgb)
}

/// A texel of an attachable format as a word of the attachment layout. Components that the format
/// lacks are 0, alpha 1.
#[inline]
fn word_of(format: Format, t: &[u8]) -> u32 {
    let rgba = |r, g, b, a| u32::from_le_bytes([r, g, b, a]);
    match format.base() {
        BaseFormat::Alpha => rgba(0, 0, 0, t[0]),
        BaseFormat::Luminance | BaseFormat::Red => rgba(t[0], 0, 0, 255),
        BaseFormat::Intensity => rgba(t[0], 0, 0, t[0]),
        BaseFormat::LuminanceAlpha => rgba(t[0], 0, 0, t[1]),
        BaseFormat::Rg => rgba(t[0], t[1], 0, 255),
        BaseFormat::Rgb => rgba(t[0], t[1], t[2], 255),
        BaseFormat::Rgba => rgba(t[0], t[1], t[2], t[3]),
        BaseFormat::Depth if t.len() == 2 => u32::from(u16::from_le_bytes([t[0], t[1]])),
        BaseFormat::Depth => rgba(t[0], t[1], t[2], t[3]),
    }
}

/// A word of the attachment layout as a texel of an attachable format. Luminance and intensity
/// take red (GL 2.1, table 3.15).
#[inline]
fn texel_of(format: Format, word: u32, t: &mut [u8]) {
    let b = word.to_le_bytes();
    match format.base() {
        BaseFormat::Alpha => t[0] = b[3],
        BaseFormat::Luminance | BaseFormat::Red | BaseFormat::Intensity => t[0] = b[0],
        BaseFormat::LuminanceAlpha => t.copy_from_slice(&[b[0], b[3]]),
        BaseFormat::Rg => t.copy_from_slice(&b[..2]),
        BaseFormat::Rgb => t.copy_from_slice(&b[..3]),
        BaseFormat::Rgba => t.copy_from_slice(&b),
        BaseFormat::Depth => t.copy_from_slice(&b[..t.len()]),
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
