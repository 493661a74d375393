//! Whether colours are clamped to [0, 1].

use crate::base::convert::unit;

/// Whether colours are clamped.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Clamp {
    On,
    Off,
}

impl Clamp {
    /// A component of a colour, clamped if this says so.
    pub fn component(self, value: f32) -> f32 {
        match self {
            Self::On => unit(value.into()) as f32,
            Self::Off => value,
        }
    }

    /// A colour, clamped if this says so.
    pub fn color(self, color: [f32; 4]) -> [f32; 4] {
        color.map(|c| self.component(c))
    }
}
