//! Materials and colour material: GL 2.1, sections 2.14.2 and 2.14.3.

use crate::base::constants::*;
use crate::base::error::Table;
use crate::interface::{ATTRIB_MATERIAL, Side};

const SECTION: &str = "GL 2.1, section 2.14.2";

/// The material of one side of polygons.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Material {
    pub emission: [f32; 4],
    pub ambient: [f32; 4],
    pub diffuse: [f32; 4],
    pub specular: [f32; 4],
    pub shininess: f32,
    /// Ambient, diffuse and specular index of colour index mode; kept, not used.
    pub indexes: [f32; 3],
}

impl Default for Material {
    fn default() -> Self {
        Self {
            emission: [0.0, 0.0, 0.0, 1.0],
            ambient: [0.2, 0.2, 0.2, 1.0],
            diffuse: [0.8, 0.8, 0.8, 1.0],
            specular: [0.0, 0.0, 0.0, 1.0],
            shininess: 0.0,
            indexes: [0.0, 1.0, 1.0],
        }
    }
}

/// A material parameter that can change per vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MaterialParameter {
    Emission,
    Ambient,
    Diffuse,
    Specular,
    Shininess,
}

impl MaterialParameter {
    pub(crate) const ALL: [Self; 5] =
        [Self::Emission, Self::Ambient, Self::Diffuse, Self::Specular, Self::Shininess];
}

/// The number of per-vertex material parameters of both sides.
pub(crate) const MATERIAL_COLUMNS: usize = 2 * MaterialParameter::ALL.len();

/// The attribute location of a per-vertex material parameter of a side.
pub(crate) fn column(side: Side, part: MaterialParameter) -> u8 {
    let side = match side {
        Side::Front => 0,
        Side::Back => MaterialParameter::ALL.len() as u8,
    };
    ATTRIB_MATERIAL + side + part as u8
}

/// The sides that a call names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Sides {
    Front,
    Back,
    Both,
}

impl Sides {
    /// Whether a side is among them.
    pub fn has(self, side: Side) -> bool {
        match self {
            Self::Front => side == Side::Front,
            Self::Back => side == Side::Back,
            Self::Both => true,
        }
    }
}

pub(crate) const FACES: Table<Sides> = Table {
    section: SECTION,
    rows: &[(GL_FRONT, Sides::Front), (GL_BACK, Sides::Back), (GL_FRONT_AND_BACK, Sides::Both)],
};

/// The material parameters that `glColorMaterial` can track.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Tracked {
    Emission,
    Ambient,
    Diffuse,
    Specular,
    AmbientAndDiffuse,
}

impl Tracked {
    /// Whether a parameter is among them.
    pub fn has(self, part: MaterialParameter) -> bool {
        match self {
            Self::Emission => part == MaterialParameter::Emission,
            Self::Ambient => part == MaterialParameter::Ambient,
            Self::Diffuse => part == MaterialParameter::Diffuse,
            Self::Specular => part == MaterialParameter::Specular,
            Self::AmbientAndDiffuse => {
                matches!(part, MaterialParameter::Ambient | MaterialParameter::Diffuse)
            }
        }
    }
}

pub(crate) const TRACKED: Table<Tracked> = Table {
    section: "GL 2.1, section 2.14.3",
    rows: &[
        (GL_EMISSION, Tracked::Emission),
        (GL_AMBIENT, Tracked::Ambient),
        (GL_DIFFUSE, Tracked::Diffuse),
        (GL_SPECULAR, Tracked::Specular),
        (GL_AMBIENT_AND_DIFFUSE, Tracked::AmbientAndDiffuse),
    ],
};

/// The materials of both sides, and the parameters that track the current colour while `GL_COLOR_MATERIAL` is enabled.
#[derive(Clone, Debug)]
pub(crate) struct Materials {
    front: Material,
    back: Material,
    pub faces: Sides,
    pub tracked: Tracked,
}

impl Default for Materials {
    fn default() -> Self {
        Self {
            front: Material::default(),
            back: Material::default(),
            faces: Sides::Both,
            tracked: Tracked::AmbientAndDiffuse,
        }
    }
}

impl Materials {
    pub(crate) fn side(&self, side: Side) -> &Material {
        match side {
            Side::Front => &self.front,
            Side::Back => &self.back,
        }
    }

    pub(crate) fn side_mut(&mut self, side: Side) -> &mut Material {
        match side {
            Side::Front => &mut self.front,
            Side::Back => &mut self.back,
        }
    }
}

/// The side and parameter of a location.
fn column_at(location: usize) -> (Side, MaterialParameter) {
    let place = (location - usize::from(ATTRIB_MATERIAL)) % MATERIAL_COLUMNS;
    let side = if place < MaterialParameter::ALL.len() { Side::Front } else { Side::Back };
    (side, MaterialParameter::ALL[place % MaterialParameter::ALL.len()])
}

impl Materials {
    /// The value at a location, whether tracked or not.
    pub fn column(&self, location: usize) -> [f32; 4] {
        let (side, part) = column_at(location);
        let material = self.side(side);
        match part {
            MaterialParameter::Emission => material.emission,
            MaterialParameter::Ambient => material.ambient,
            MaterialParameter::Diffuse => material.diffuse,
            MaterialParameter::Specular => material.specular,
            MaterialParameter::Shininess => [material.shininess, 0.0, 0.0, 1.0],
        }
    }

    /// Sets the value at a location.
    pub fn set_column(&mut self, location: usize, value: [f32; 4]) {
        let (side, part) = column_at(location);
        let material = self.side_mut(side);
        match part {
            MaterialParameter::Emission => material.emission = value,
            MaterialParameter::Ambient => material.ambient = value,
            MaterialParameter::Diffuse => material.diffuse = value,
            MaterialParameter::Specular => material.specular = value,
            MaterialParameter::Shininess => material.shininess = value[0],
        }
    }
}
