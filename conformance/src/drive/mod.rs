//! The driver's side: GL contexts, draws of thousands of cases at once, exact read-back.
//!
//! One case is one 2×2 cell of the picture, drawn as a quad whose vertices all carry the same
//! three vectors; the fragment shader computes the value in question from them, and the lower left
//! pixel of the cell is read. Where neither derivatives nor vertices matter, a case is one pixel of
//! a *field*, and its inputs are float texels. Values come back as bytes, or exactly: [`pack`]
//! spreads a float over the four bytes of a pixel.

mod blend;
mod extreme;
mod field;
mod fixed;
mod fragment;
mod mipmaps;
pub mod pack;
mod pixels;
mod points;
mod pyramid;
mod session;
pub mod shader;
mod target;
mod texels;
mod texture;

pub use blend::{BlendState, BlendedCell};
pub use extreme::{DepthBuffer, MatrixStep};
pub use fixed::FixedCell;
pub use mipmaps::MipmapRequest;
pub use pixels::{ClientPixels, StoredBox};
pub use points::GlTexGen;
pub use pyramid::{GREY, IntegerRow};
pub use session::{Session, Vertex};
pub use shader::{Precision, Program};
pub use texels::TexelRow;
pub use texture::{DepthTexture, Storage};

/// Pixels across and up of the picture that cells and triangles are drawn to.
pub const SIZE: usize = 128;

/// Pixels across and up of the picture of a field of values, one a pixel.
pub const FIELD: usize = 256;

/// Cells in a row of the picture.
const CELLS: usize = SIZE / 2;

/// The values of the cells of a picture, row by row from the lowest.
fn cell_values(picture: &[[f64; 4]]) -> impl Iterator<Item = [f64; 4]> + '_ {
    (0..CELLS * CELLS).map(|k| picture[(k / CELLS) * 2 * SIZE + (k % CELLS) * 2])
}

/// Normalized device coordinates of the corners of cell `k`, counter-clockwise; exact.
fn cell_corners(k: usize) -> [[f32; 2]; 4] {
    let edge = |n: usize| 2.0 * n as f32 / CELLS as f32 - 1.0;
    let (x, y) = (k % CELLS, k / CELLS);
    [[edge(x), edge(y)], [edge(x + 1), edge(y)], [edge(x + 1), edge(y + 1)], [edge(x), edge(y + 1)]]
}

/// What keeps a check from being measured.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DriveError {
    /// There is no context.
    #[error("no context: {0}")]
    Context(String),
    /// A GL call set the error flag.
    #[error("GL error {code:#06x} after {after}: {message}")]
    Gl {
        /// What was being done.
        after: &'static str,
        /// What `glGetError` answered.
        code: u32,
        /// What the context says about it.
        message: String,
    },
    /// A shader did not compile, or a program not link.
    #[error("{stage} was rejected: {log}")]
    Shader {
        /// Which.
        stage: &'static str,
        /// The info log.
        log: String,
    },
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
