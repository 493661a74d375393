//! Parameters of textures that can only be read.

use crate::base::constants::*;
use crate::base::error::Table;
use crate::base::types::*;
use crate::objects::target::TARGET;
use crate::objects::texture::Texture;

/// A parameter that no call sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ReadOnly {
    Resident,
    /// How many texture units it takes (`OES_EGL_image_external`): texels are never of several planes.
    RequiredUnits,
    /// The target that it was first bound to.
    Target,
    /// Whether it has immutable storage.
    IsImmutable,
    /// How many levels that was made with.
    StorageLevels,
    /// Which part of it the texture shows (GL 4.3, section 8.18).
    FirstLevel,
    Levels,
    FirstLayer,
    Layers,
}

pub(super) const READ_ONLY: Table<ReadOnly> = Table {
    section: "GL 4.3, section 8.18",
    rows: &[
        (GL_TEXTURE_RESIDENT, ReadOnly::Resident),
        (GL_REQUIRED_TEXTURE_IMAGE_UNITS_OES, ReadOnly::RequiredUnits),
        (GL_TEXTURE_TARGET, ReadOnly::Target),
        (GL_TEXTURE_IMMUTABLE_FORMAT, ReadOnly::IsImmutable),
        (GL_TEXTURE_IMMUTABLE_LEVELS, ReadOnly::StorageLevels),
        (GL_TEXTURE_VIEW_MIN_LEVEL, ReadOnly::FirstLevel),
        (GL_TEXTURE_VIEW_NUM_LEVELS, ReadOnly::Levels),
        (GL_TEXTURE_VIEW_MIN_LAYER, ReadOnly::FirstLayer),
        (GL_TEXTURE_VIEW_NUM_LAYERS, ReadOnly::Layers),
    ],
};

impl ReadOnly {
    /// What it is of a texture.
    pub fn of(self, texture: &Texture) -> GLuint {
        // What is not immutable has no levels and layers to show.
        let shown = texture.immutable.unwrap_or_default();
        match self {
            Self::Resident | Self::RequiredUnits => 1,
            Self::Target => TARGET.encode(texture.target),
            Self::IsImmutable => texture.immutable.is_some().into(),
            Self::StorageLevels => shown.storage_levels,
            Self::FirstLevel => shown.first_level,
            Self::Levels => shown.levels,
            Self::FirstLayer => shown.first_layer,
            Self::Layers => shown.layers,
        }
    }
}
