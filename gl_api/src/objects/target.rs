//! Texture targets, and the images that `target` parameters name.

mod images;

pub(crate) use images::{
    Dimensions, FACE_TARGET, FaceTarget, IMAGE_2D_MULTISAMPLE, IMAGE_3D_MULTISAMPLE, ImageTarget,
    any_bound, any_known, attachable_target,
};

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_value};
use crate::base::limits;
use crate::base::types::*;
use crate::glsl::Dim;
use texunit::image::Shape;

/// The target of a texture, also its index in per-target arrays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TextureTarget {
    D1Array,
    D2Array,
    CubeArray,
    D1,
    D2,
    Rect,
    D3,
    Cube,
    D2Multisample,
    D2MultisampleArray,
    Buffer,
    External,
}

impl TextureTarget {
    /// All targets. Of several that are enabled, the last one applies (section 3.8.15; `ARB_texture_rectangle`). Array,
    /// multisample and buffer textures are for shaders only.
    pub const ALL: [Self; 12] = [
        Self::D1Array,
        Self::D2Array,
        Self::CubeArray,
        Self::D1,
        Self::D2,
        Self::Rect,
        Self::D3,
        Self::Cube,
        Self::D2Multisample,
        Self::D2MultisampleArray,
        Self::Buffer,
        Self::External,
    ];
    /// How many there are.
    pub const COUNT: usize = Self::ALL.len();

    /// The shape of its images; every sample of a texture with several is a layer, a buffer a row.
    pub fn shape(self) -> Shape {
        match self {
            Self::D1 | Self::Buffer => Shape::D1,
            Self::D2 | Self::External => Shape::D2,
            Self::D3 => Shape::D3,
            Self::Rect => Shape::Rect,
            Self::Cube => Shape::Cube,
            Self::D1Array => Shape::D1Array,
            Self::D2Array | Self::D2Multisample | Self::D2MultisampleArray => Shape::D2Array,
            Self::CubeArray => Shape::CubeArray,
        }
    }

    /// The target of textures of this shape with one sample per texel.
    pub fn of(shape: Shape) -> Self {
        match shape {
            Shape::D1 => Self::D1,
            Shape::D2 => Self::D2,
            Shape::D3 => Self::D3,
            Shape::Rect => Self::Rect,
            Shape::Cube => Self::Cube,
            Shape::D1Array => Self::D1Array,
            Shape::D2Array => Self::D2Array,
            Shape::CubeArray => Self::CubeArray,
        }
    }

    /// The target that a sampler uniform reads.
    pub fn of_sampler(dim: Dim) -> Self {
        match dim {
            Dim::D1 => Self::D1,
            Dim::D2 => Self::D2,
            Dim::D3 => Self::D3,
            Dim::Rect => Self::Rect,
            Dim::Cube => Self::Cube,
            Dim::D1Array => Self::D1Array,
            Dim::D2Array => Self::D2Array,
            Dim::CubeArray => Self::CubeArray,
            Dim::D2Multisample => Self::D2Multisample,
            Dim::D2MultisampleArray => Self::D2MultisampleArray,
            Dim::Buffer => Self::Buffer,
            Dim::External => Self::External,
        }
    }

    /// Whether its textures have several samples a texel.
    pub fn is_multisample(self) -> bool {
        match self {
            Self::D2Multisample | Self::D2MultisampleArray => true,
            Self::D1
            | Self::D2
            | Self::D3
            | Self::Rect
            | Self::Cube
            | Self::D1Array
            | Self::D2Array
            | Self::CubeArray
            | Self::Buffer
            | Self::External => false,
        }
    }

    /// The largest width, height and depth that a call may give, border aside: the layers of a
    /// one-dimensional array are its height.
    pub fn limits(self) -> [u32; 3] {
        let (side, layers) = (limits::MAX_TEXTURE_SIZE, limits::MAX_ARRAY_TEXTURE_LAYERS);
        match self {
            Self::D1 => [side, 1, 1],
            Self::D2 | Self::Rect | Self::Cube | Self::D2Multisample | Self::External => {
                [side, side, 1]
            }
            Self::D3 => [limits::MAX_3D_TEXTURE_SIZE; 3],
            Self::D1Array => [side, layers, 1],
            Self::Buffer => [limits::MAX_TEXTURE_BUFFER_SIZE, 1, 1],
            Self::D2Array | Self::CubeArray | Self::D2MultisampleArray => [side, side, layers],
        }
    }

    /// How many levels its textures can have.
    pub fn levels(self) -> usize {
        match self {
            Self::Rect
            | Self::D2Multisample
            | Self::D2MultisampleArray
            | Self::Buffer
            | Self::External => 1,
            Self::D1
            | Self::D2
            | Self::D3
            | Self::Cube
            | Self::D1Array
            | Self::D2Array
            | Self::CubeArray => self.limits()[0].ilog2() as usize + 1,
        }
    }

    /// Width, height and depth of a call as those of a level: the layers of an array come last.
    pub fn level_box<T: Copy>(self, [width, height, depth]: [T; 3]) -> [T; 3] {
        match self {
            Self::D1Array => [width, depth, height],
            Self::D1
            | Self::D2
            | Self::D3
            | Self::Rect
            | Self::Cube
            | Self::D2Array
            | Self::CubeArray
            | Self::D2Multisample
            | Self::D2MultisampleArray
            | Self::Buffer
            | Self::External => [width, height, depth],
        }
    }
}

/// The names of targets, those of OpenGL ES alone last.
pub(crate) const TARGET: Table<TextureTarget> =
    Table { section: "GL 2.1, section 3.8.12", rows: ALL_TARGETS };

const ALL_TARGETS: &[(GLenum, TextureTarget)] = &[
    (GL_TEXTURE_1D, TextureTarget::D1),
    (GL_TEXTURE_2D, TextureTarget::D2),
    (GL_TEXTURE_3D, TextureTarget::D3),
    (GL_TEXTURE_CUBE_MAP, TextureTarget::Cube),
    (GL_TEXTURE_RECTANGLE, TextureTarget::Rect),
    (GL_TEXTURE_1D_ARRAY, TextureTarget::D1Array),
    (GL_TEXTURE_2D_ARRAY, TextureTarget::D2Array),
    (GL_TEXTURE_CUBE_MAP_ARRAY, TextureTarget::CubeArray),
    (GL_TEXTURE_2D_MULTISAMPLE, TextureTarget::D2Multisample),
    (GL_TEXTURE_2D_MULTISAMPLE_ARRAY, TextureTarget::D2MultisampleArray),
    (GL_TEXTURE_BUFFER, TextureTarget::Buffer),
    (GL_TEXTURE_EXTERNAL_OES, TextureTarget::External),
];

/// The targets of `glBindTexture`.
pub(crate) const TARGET_OF_DESKTOP: Table<TextureTarget> =
    Table { section: TARGET.section, rows: ALL_TARGETS.split_at(11).0 };

/// Those of contexts of OpenGL ES, whose external textures are EGL images (`OES_EGL_image_external`).
pub(crate) const TARGET_OF_ES: Table<TextureTarget> = Table {
    section: "OpenGL ES 3.0, section 3.8.1, and OES_EGL_image_external",
    rows: &[
        (GL_TEXTURE_2D, TextureTarget::D2),
        (GL_TEXTURE_3D, TextureTarget::D3),
        (GL_TEXTURE_CUBE_MAP, TextureTarget::Cube),
        (GL_TEXTURE_2D_ARRAY, TextureTarget::D2Array),
        (GL_TEXTURE_EXTERNAL_OES, TextureTarget::External),
    ],
};

/// A level number that a texture of this target can have.
pub(crate) fn checked_level(
    section: &'static str,
    target: TextureTarget,
    level: GLint,
) -> Result<usize> {
    let levels = target.levels();
    match usize::try_from(level) {
        Ok(level) if level < levels => Ok(level),
        _ if levels == 1 => invalid_value(
            section,
            format!("level = {level} of {} must be 0", enum_name(TARGET.encode(target))),
        ),
        _ => invalid_value(section, format!("level = {level} must be 0 to {}", levels - 1)),
    }
}
