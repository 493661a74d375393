//! Texture units: bindings, environments, and generation of coordinates (GL 2.1, sections 2.7, 3.8.12 and 3.8.13).

pub(crate) mod combine;
pub(crate) mod texgen;

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation};
use crate::interface::{MAX_COMBINED_TEXTURE_IMAGE_UNITS, MAX_TEXTURE_UNITS};
use crate::objects::bound::Bound;
use crate::objects::target::TextureTarget;
use crate::state::texture_units::combine::{Arguments, Combiner};
use crate::state::texture_units::texgen::Generate;
use crate::state::versioned::Versioned;
use std::sync::Arc;

const SECTION: &str = "GL 2.1, section 3.8.13";

/// A texture environment function other than `GL_COMBINE`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Standard {
    Replace,
    Modulate,
    Decal,
    Blend,
    Add,
}

/// The texture environment mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    Standard(Standard),
    /// As the unit's combiners say.
    Combine(Arguments),
}

pub(crate) const MODE: Table<Mode> = Table {
    section: SECTION,
    rows: &[
        (GL_REPLACE, Mode::Standard(Standard::Replace)),
        (GL_MODULATE, Mode::Standard(Standard::Modulate)),
        (GL_DECAL, Mode::Standard(Standard::Decal)),
        (GL_BLEND, Mode::Standard(Standard::Blend)),
        (GL_ADD, Mode::Standard(Standard::Add)),
        (GL_COMBINE, Mode::Combine(Arguments::Two)),
        (GL_COMBINE4_NV, Mode::Combine(Arguments::Four)),
    ],
};

/// One texture unit.
#[derive(Clone, Debug)]
pub(crate) struct Unit {
    /// By [`TextureTarget`]; of several, the last in its list wins (section 3.8.15).
    pub enabled: [bool; TextureTarget::COUNT],
    /// Textures, by target.
    pub bound: [Bound; TextureTarget::COUNT],
    /// The sampler object, if any, whose state replaces that of the textures.
    pub sampler: Bound,
    pub mode: Mode,
    pub color: [f32; 4],
    pub lod_bias: f32,
    /// Of colour and of alpha.
    pub combiners: [Combiner; 2],
    /// Generation of s, t, r and q.
    pub generate: [Generate; 4],
    /// Whether point sprites replace the coordinates (section 3.3).
    pub coord_replace: bool,
}

impl Unit {
    /// The enabled targets and generated coordinates.
    pub fn switches(&self) -> ([bool; TextureTarget::COUNT], [bool; 4]) {
        (self.enabled, self.generate.each_ref().map(|generate| generate.enabled))
    }

    /// The reverse of [`Self::switches`].
    pub fn switch(&mut self, (enabled, generate): ([bool; TextureTarget::COUNT], [bool; 4])) {
        self.enabled = enabled;
        for (coord, enabled) in self.generate.iter_mut().zip(generate) {
            coord.enabled = enabled;
        }
    }
}

/// All units, and the active one.
#[derive(Clone, Debug)]
pub(crate) struct Units {
    /// ShareHandle with the attribute stack until one is changed ([`Self::unit_mut`]). Draws examine them only after a
    /// change of version.
    pub units: Versioned<[Arc<Unit>; MAX_COMBINED_TEXTURE_IMAGE_UNITS as usize]>,
    pub active: u8,
    pub client_active: u8,
}

impl Default for Units {
    fn default() -> Self {
        let unit = Unit {
            enabled: [false; TextureTarget::COUNT],
            bound: Default::default(),
            sampler: Bound::default(),
            mode: Mode::Standard(Standard::Modulate),
            color: [0.0; 4],
            lod_bias: 0.0,
            combiners: Combiner::initial(),
            generate: Generate::initial(),
            coord_replace: false,
        };
        let unit = Arc::new(unit);
        let units = std::array::from_fn(|_| Arc::clone(&unit));
        Self { units: Versioned::new(units), active: 0, client_active: 0 }
    }
}

impl Units {
    pub fn active(&self) -> &Unit {
        &self.units[usize::from(self.active)]
    }

    pub fn active_mut(&mut self) -> &mut Unit {
        self.unit_mut(self.active.into())
    }

    /// A unit, to be changed.
    pub fn unit_mut(&mut self, unit: usize) -> &mut Unit {
        Arc::make_mut(&mut self.units[unit])
    }

    /// The units whose coordinates point sprites replace, bit by unit.
    pub fn coord_replace(&self) -> u64 {
        let bits = (0..).zip(self.units.iter());
        bits.fold(0, |bits, (at, unit)| bits | u64::from(unit.coord_replace) << at)
    }

    /// The active unit as the index of a set of texture coordinates.
    ///
    /// # Errors
    /// `GL_INVALID_OPERATION` where the unit is for images alone (GL 2.1, section 2.11.2).
    pub fn active_coordinates(&self, section: &'static str) -> Result<usize> {
        if self.active < MAX_TEXTURE_UNITS {
            return Ok(self.active.into());
        }
        invalid_operation(
            section,
            format!(
                "the active unit GL_TEXTURE{} is for images alone: coordinates and matrices are of \
                 GL_TEXTURE0 to GL_TEXTURE{}",
                self.active,
                MAX_TEXTURE_UNITS - 1
            ),
        )
    }
}
