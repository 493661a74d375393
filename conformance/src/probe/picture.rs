//! The pictures that values are drawn to, and their cells of 2×2 pixels.

/// Pixels across and up of the picture that cells and triangles are drawn to.
pub const SIZE: usize = 128;

/// Pixels across and up of the picture of a field of values, one a pixel.
pub const FIELD: usize = 256;

/// Cells in a row of the picture.
pub(super) const CELLS: usize = SIZE / 2;

/// The values of the cells of a picture, row by row from the lowest.
pub(super) fn cell_values(picture: &[[f64; 4]]) -> impl Iterator<Item = [f64; 4]> + '_ {
    (0..CELLS * CELLS).map(|k| picture[(k / CELLS) * 2 * SIZE + (k % CELLS) * 2])
}

/// Normalized device coordinates of the corners of cell `k`, counter-clockwise; exact.
pub(super) fn cell_corners(k: usize) -> [[f32; 2]; 4] {
    let edge = |n: usize| 2.0 * n as f32 / CELLS as f32 - 1.0;
    let (x, y) = (k % CELLS, k / CELLS);
    [[edge(x), edge(y)], [edge(x + 1), edge(y)], [edge(x + 1), edge(y + 1)], [edge(x), edge(y + 1)]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_tile_the_picture() {
        assert_eq!(cell_corners(0)[0], [-1.0, -1.0]);
        assert_eq!(cell_corners(CELLS * CELLS - 1)[2], [1.0, 1.0]);
        let picture: Vec<[f64; 4]> = (0..SIZE * SIZE).map(|p| [p as f64; 4]).collect();
        let second_row = cell_values(&picture).nth(CELLS + 1);
        assert_eq!(second_row, Some([(2 * SIZE + 2) as f64; 4]));
    }
}
