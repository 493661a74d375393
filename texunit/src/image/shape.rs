//! The shapes of images, and the sizes and borders that each may have.

use super::limits::{FACES, MAX_LAYERS, MAX_SIZE, MAX_SIZE_3D};
use super::{ImageError, Level};

/// The shape of an image, and of the coordinates that address it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shape {
    /// One coordinate, one row.
    D1,
    /// Two coordinates, one face.
    D2,
    /// Three coordinates, slices one above the other.
    D3,
    /// Two coordinates in texels, one level (`ARB_texture_rectangle`).
    Rect,
    /// A direction, six faces in the order +X, -X, +Y, -Y, +Z, -Z.
    Cube,
    /// One coordinate and a layer (`EXT_texture_array`).
    D1Array,
    /// Two coordinates and a layer (`EXT_texture_array`).
    D2Array,
    /// A direction and a layer (`ARB_texture_cube_map_array`). Its layers are stored as those of
    /// [`Self::D2Array`], the six faces of a cube one after the other.
    CubeArray,
}

impl Shape {
    /// Every shape.
    pub const ALL: [Self; 8] = [
        Self::D1,
        Self::D2,
        Self::D3,
        Self::Rect,
        Self::Cube,
        Self::D1Array,
        Self::D2Array,
        Self::CubeArray,
    ];

    /// How many faces an image of this shape has that are levels of their own.
    pub const fn faces(self) -> usize {
        match self {
            Self::D1
            | Self::D2
            | Self::D3
            | Self::Rect
            | Self::D1Array
            | Self::D2Array
            | Self::CubeArray => 1,
            Self::Cube => FACES,
        }
    }

    /// Whether its first three coordinates are a direction, which meets one of six faces.
    pub const fn is_cube(self) -> bool {
        match self {
            Self::Cube | Self::CubeArray => true,
            Self::D1 | Self::D2 | Self::D3 | Self::Rect | Self::D1Array | Self::D2Array => false,
        }
    }

    /// How many axes are filtered along, and halved from level to level: 1, 2 or 3. Layers and
    /// faces are not among them.
    pub const fn axes(self) -> usize {
        match self {
            Self::D1 | Self::D1Array => 1,
            Self::D2 | Self::Rect | Self::Cube | Self::D2Array | Self::CubeArray => 2,
            Self::D3 => 3,
        }
    }

    /// What a coordinate is multiplied by to count texels along a side of so many: rectangles take
    /// coordinates that count them already.
    #[inline(always)]
    pub const fn scale(self, side: u32) -> f32 {
        match self {
            Self::Rect => 1.0,
            Self::D1
            | Self::D2
            | Self::D3
            | Self::Cube
            | Self::D1Array
            | Self::D2Array
            | Self::CubeArray => side as f32,
        }
    }

    /// The largest width, height and depth (of an array: layers, of cubes' faces) of a level.
    pub const fn max_size(self) -> [u32; 3] {
        match self {
            Self::D1 => [MAX_SIZE, 1, 1],
            Self::D2 | Self::Rect | Self::Cube => [MAX_SIZE, MAX_SIZE, 1],
            Self::D3 => [MAX_SIZE_3D; 3],
            Self::D1Array => [MAX_SIZE, 1, MAX_LAYERS],
            Self::D2Array | Self::CubeArray => [MAX_SIZE, MAX_SIZE, MAX_LAYERS],
        }
    }

    /// The border of a level along s, t, r where GL was given `border`, 0 or 1: as wide along
    /// every axis that is filtered along (GL 2.1, section 3.8.1). Rectangles have none.
    pub const fn border(self, border: u32) -> [u32; 3] {
        match (self, self.axes()) {
            (Self::Rect, _) => [0; 3],
            (_, 1) => [border, 0, 0],
            (_, 2) => [border, border, 0],
            (_, _) => [border; 3],
        }
    }

    /// The size of the level below one of `size`: filtered axes are halved, rounded down, at
    /// least 1; layers stay.
    pub fn halved(self, size: [u32; 3]) -> [u32; 3] {
        let mut half = size;
        for side in &mut half[..self.axes()] {
            *side = (*side / 2).max(1);
        }
        half
    }

    /// Whether an image of this shape may have this level.
    pub(super) fn check(self, level: &Level) -> Result<(), ImageError> {
        let size @ [width, height, depth] = level.size();
        if size.iter().zip(self.max_size()).any(|(&side, most)| side > most) {
            return Err(ImageError::TooLarge { width, height, depth });
        }
        if self == Self::CubeArray && (width != height || !(depth as usize).is_multiple_of(FACES)) {
            return Err(ImageError::NotCubes { width, height, depth });
        }
        if level.border != [0; 3] && level.border != self.border(1) {
            return Err(ImageError::WrongBorder { border: level.border });
        }
        Ok(())
    }
}
