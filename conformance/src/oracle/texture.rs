//! Images of RGBA bytes, which both oracle and driver read.

/// One level of an image.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Texels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// RGBA; rows from t = 0 up.
    pub texels: Vec<[u8; 4]>,
}

impl Level {
    /// A level whose texel in column `i` of row `j` is `texel(i, j)`.
    pub fn from_fn(
        width: usize,
        height: usize,
        mut texel: impl FnMut(usize, usize) -> [u8; 4],
    ) -> Self {
        let texels =
            (0..height).flat_map(|j| (0..width).map(move |i| (i, j))).map(|(i, j)| texel(i, j));
        let texels = texels.collect();
        Self { width, height, texels }
    }

    /// The components of a texel, as `c / 255` (section 2.14, table 2.9: unsigned bytes).
    pub fn texel(&self, i: usize, j: usize) -> [f64; 4] {
        self.texels[j * self.width + i].map(|c| f64::from(c) / 255.0)
    }
}

/// The size of level `level` of an image whose level 0 is `size` (section 3.8.8, mipmapping).
pub fn level_size(size: [usize; 2], level: usize) -> [usize; 2] {
    size.map(|n| (n >> level).max(1))
}

/// How many levels an image of this size has.
pub fn level_count(size: [usize; 2]) -> usize {
    size[0].max(size[1]).ilog2() as usize + 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_shrink_to_one_texel() {
        assert_eq!(level_count([256, 64]), 9);
        assert_eq!(level_size([256, 64], 7), [2, 1]);
        assert_eq!(level_count([5, 7]), 3);
        assert_eq!(level_size([5, 7], 1), [2, 3]);
    }

    #[test]
    fn rows_run_up() {
        let level = Level::from_fn(2, 2, |i, j| [i as u8 * 255, j as u8 * 255, 0, 255]);
        assert_eq!(level.texel(1, 0), [1.0, 0.0, 0.0, 1.0]);
        assert_eq!(level.texel(0, 1), [0.0, 1.0, 0.0, 1.0]);
    }
}
