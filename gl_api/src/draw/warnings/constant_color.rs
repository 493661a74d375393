//! The colour of a draw of the fixed function, where all vertices have the same.

use crate::context::Context;
use crate::context::recorder::fixed_function::StageKeys;
use crate::generate::fixed::environment::Environment;
use crate::generate::fixed::fragment::UnitKey;
use crate::interface::ATTRIB_COLOR;
use crate::state::enable::Flag;
use crate::state::texture_units::Standard;
use rasterizer::driver::{VertexBinding, VertexSource};
use texunit::format::BaseFormat;

/// The current colour of a draw without lighting, and what textures make of it.
pub(crate) struct ConstantColor {
    pub color: [f32; 4],
    textures: Textures,
}

/// What the texture units do with the colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Textures {
    /// No unit is enabled.
    Off,
    /// All units multiply by it; whether all of them have colours.
    Modulate { colored: bool },
    /// Something else.
    Other,
}

impl Textures {
    fn new(units: &[UnitKey]) -> Self {
        let modulates =
            |unit: &UnitKey| unit.environment == Environment::Standard(Standard::Modulate);
        match units {
            [] => Self::Off,
            units if units.iter().all(modulates) => {
                Self::Modulate { colored: units.iter().all(|unit| unit.base != BaseFormat::Alpha) }
            }
            _ => Self::Other,
        }
    }
}

impl ConstantColor {
    /// `None` where the colour varies, or a program or lighting makes it.
    pub fn new(context: &Context, vertices: &[VertexBinding], keys: &StageKeys) -> Option<Self> {
        let (Some(_), Some(fragment)) = (&keys.vertex, &keys.fragment) else { return None };
        if context.state.enables.has(Flag::Lighting) {
            return None;
        }
        let mut sources = vertices.iter().filter(|binding| binding.location == ATTRIB_COLOR);
        match sources.next().map(|binding| &binding.source) {
            Some(VertexSource::Constant(color)) => {
                Some(Self { color: *color, textures: Textures::new(&fragment.units) })
            }
            Some(VertexSource::Array { .. }) | None => None,
        }
    }

    /// The alpha of all fragments, if textures leave it as it is.
    pub fn alpha(&self) -> Option<f32> {
        (self.textures == Textures::Off).then_some(self.color[3].clamp(0.0, 1.0))
    }

    /// Whether all fragments have alpha 0.
    pub fn has_no_alpha(&self) -> bool {
        self.color[3] <= 0.0 && self.textures != Textures::Other
    }

    /// Whether textures that have colours are multiplied by black.
    pub fn blackens(&self) -> bool {
        self.color[..3].iter().all(|component| *component <= 0.0)
            && self.textures == Textures::Modulate { colored: true }
    }
}
