//! Pixel maps, the look-up tables of pixel transfer: `glPixelMap` and `glGetPixelMap` (GL 2.1, sections 3.6.3
//! and 6.1.3, table 3.3).

use crate::base::convert::unit;

/// The largest size of a map (`GL_MAX_PIXEL_MAP_TABLE`).
pub(crate) const MAX_PIXEL_MAP_TABLE: usize = 256;

/// A pixel map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PixelMap {
    pub size: u16,
    pub entries: [f32; MAX_PIXEL_MAP_TABLE],
}

impl Default for PixelMap {
    /// One entry, 0.
    fn default() -> Self {
        Self { size: 1, entries: [0.0; MAX_PIXEL_MAP_TABLE] }
    }
}

impl PixelMap {
    pub(crate) fn entries(&self) -> &[f32] {
        &self.entries[..usize::from(self.size)]
    }

    /// The entry of a component: clamped, then the nearest.
    pub fn at_fraction(&self, value: f64) -> f32 {
        let last = f64::from(self.size - 1);
        self.entries[(unit(value) * last).round_ties_even() as usize]
    }

    /// The entry of an index modulo the size, which is a power of two.
    pub fn at_index(&self, index: i64) -> f32 {
        self.entries[(index & i64::from(self.size - 1)) as usize]
    }
}

/// The name of a map, which is its index in [`PixelMaps`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PixelMapName {
    IToI,
    SToS,
    IToR,
    IToG,
    IToB,
    IToA,
    RToR,
    GToG,
    BToB,
    AToA,
}

impl PixelMapName {
    /// Whether its input is an index, so that its size is a power of two.
    pub(crate) fn is_indexed(self) -> bool {
        match self {
            Self::IToI | Self::SToS | Self::IToR | Self::IToG | Self::IToB | Self::IToA => true,
            Self::RToR | Self::GToG | Self::BToB | Self::AToA => false,
        }
    }

    /// Whether its entries are indices, not components of colours.
    pub(crate) fn has_indices(self) -> bool {
        match self {
            Self::IToI | Self::SToS => true,
            Self::IToR | Self::IToG | Self::IToB | Self::IToA => false,
            Self::RToR | Self::GToG | Self::BToB | Self::AToA => false,
        }
    }
}

/// All maps, by [`PixelMapName`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PixelMaps(pub(crate) [PixelMap; 10]);

impl PixelMaps {
    pub(crate) fn map(&self, name: PixelMapName) -> &PixelMap {
        &self.0[name as usize]
    }

    /// The tables from R, G, B, A to themselves.
    pub fn colors(&self) -> [&PixelMap; 4] {
        [PixelMapName::RToR, PixelMapName::GToG, PixelMapName::BToB, PixelMapName::AToA]
            .map(|name| self.map(name))
    }

    /// The tables from indices to R, G, B, A.
    pub fn of_indices(&self) -> [&PixelMap; 4] {
        [PixelMapName::IToR, PixelMapName::IToG, PixelMapName::IToB, PixelMapName::IToA]
            .map(|name| self.map(name))
    }

    /// The table from stencils to stencils.
    pub fn stencil(&self) -> &PixelMap {
        self.map(PixelMapName::SToS)
    }
}
