//! Materials and colour material: GL 2.1, sections 2.14.2 and 2.14.3.

use super::enable::Flag;
use super::params::{Params, parameter_calls, parameter_queries};
use crate::constants::*;
use crate::context::Context;
use crate::draw::immediate::split;
use crate::error::{Result, Table, invalid_value};
use crate::interface::{ATTRIB_COLOR, Side};
use crate::query::table::{Value, float, unit};
use crate::types::*;

const SECTION: &str = "GL 2.1, section 2.14.2";

/// How a side of polygons takes light.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Material {
    pub emission: [f32; 4],
    pub ambient: [f32; 4],
    pub diffuse: [f32; 4],
    pub specular: [f32; 4],
    pub shininess: f32,
}

impl Default for Material {
    fn default() -> Self {
        Self {
            emission: [0.0, 0.0, 0.0, 1.0],
            ambient: [0.2, 0.2, 0.2, 1.0],
            diffuse: [0.8, 0.8, 0.8, 1.0],
            specular: [0.0, 0.0, 0.0, 1.0],
            shininess: 0.0,
        }
    }
}

/// Which sides a call is about.
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

/// The colours of a material that the current colour can stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Tracked {
    Emission,
    Ambient,
    Diffuse,
    Specular,
    AmbientAndDiffuse,
}

impl Tracked {
    /// Whether the ambient colour is among them.
    pub fn ambient(self) -> bool {
        matches!(self, Self::Ambient | Self::AmbientAndDiffuse)
    }

    /// Whether the diffuse colour is among them.
    pub fn diffuse(self) -> bool {
        matches!(self, Self::Diffuse | Self::AmbientAndDiffuse)
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

/// The materials of both sides, and what of them follows the current colour while
/// `GL_COLOR_MATERIAL` is on.
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
    fn side_mut(&mut self, side: Side) -> &mut Material {
        match side {
            Side::Front => &mut self.front,
            Side::Back => &mut self.back,
        }
    }
}

/// Gives the tracked colours of a material another value.
fn track(material: &mut Material, tracked: Tracked, color: [f32; 4]) {
    match tracked {
        Tracked::Emission => material.emission = color,
        Tracked::Ambient => material.ambient = color,
        Tracked::Diffuse => material.diffuse = color,
        Tracked::Specular => material.specular = color,
        Tracked::AmbientAndDiffuse => (material.ambient, material.diffuse) = (color, color),
    }
}

/// A side's material as it is now: tracked colours are the current one.
pub(crate) fn material(context: &Context, side: Side) -> Material {
    let materials = &context.state.materials;
    let mut material = match side {
        Side::Front => materials.front.clone(),
        Side::Back => materials.back.clone(),
    };
    if context.state.enables.has(Flag::ColorMaterial) && materials.faces.has(side) {
        let color = context.state.current[usize::from(ATTRIB_COLOR)];
        track(&mut material, materials.tracked, color);
    }
    material
}

/// Lets what followed the current colour keep it: tracking is about to end or to change.
pub(crate) fn keep_tracked(context: &mut Context) {
    for side in [Side::Front, Side::Back] {
        *context.state.materials.side_mut(side) = material(context, side);
    }
}

pub(crate) fn color_material(context: &mut Context, face: GLenum, mode: GLenum) -> Result<()> {
    let faces = FACES.decode("face", face)?;
    let tracked = TRACKED.decode("mode", mode)?;
    keep_tracked(context);
    context.state.materials.faces = faces;
    context.state.materials.tracked = tracked;
    Ok(())
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Parameter {
    Color(Tracked),
    Shininess,
}

const PARAMETER: Table<Parameter> = Table {
    section: SECTION,
    rows: &[
        (GL_AMBIENT, Parameter::Color(Tracked::Ambient)),
        (GL_DIFFUSE, Parameter::Color(Tracked::Diffuse)),
        (GL_SPECULAR, Parameter::Color(Tracked::Specular)),
        (GL_EMISSION, Parameter::Color(Tracked::Emission)),
        (GL_SHININESS, Parameter::Shininess),
        (GL_AMBIENT_AND_DIFFUSE, Parameter::Color(Tracked::AmbientAndDiffuse)),
    ],
};

/// Tracked colours take no lasting effect: they go on following the current colour.
fn set_material(context: &mut Context, face: GLenum, pname: GLenum, params: &Params) -> Result<()> {
    let faces = FACES.decode("face", face)?;
    let parameter = PARAMETER.decode("pname", pname)?;
    params.need(SECTION, pname, if parameter == Parameter::Shininess { 1 } else { 4 })?;
    let shininess = params.number();
    if parameter == Parameter::Shininess && !(0.0..=128.0).contains(&shininess) {
        return invalid_value(SECTION, format!("GL_SHININESS = {shininess} must be 0 to 128"));
    }
    split(context)?;
    for side in [Side::Front, Side::Back].into_iter().filter(|side| faces.has(*side)) {
        let material = context.state.materials.side_mut(side);
        match parameter {
            Parameter::Color(color) => track(material, color, params.color()),
            Parameter::Shininess => material.shininess = shininess,
        }
    }
    Ok(())
}

parameter_calls!(set_material(face, pname): materialf, materiali, materialfv, materialiv);

fn get_material(context: &Context, face: GLenum, pname: GLenum) -> Result<Value> {
    const SIDE: Table<Side> =
        Table { section: SECTION, rows: &[(GL_FRONT, Side::Front), (GL_BACK, Side::Back)] };
    const QUERIED: Table<Parameter> =
        Table { section: SECTION, rows: PARAMETER.rows.split_at(5).0 };
    let side = SIDE.decode("face", face)?;
    let parameter = QUERIED.decode("pname", pname)?;
    let material = material(context, side);
    match parameter {
        Parameter::Color(Tracked::Emission) => unit(&material.emission),
        Parameter::Color(Tracked::Diffuse) => unit(&material.diffuse),
        Parameter::Color(Tracked::Specular) => unit(&material.specular),
        Parameter::Color(Tracked::Ambient | Tracked::AmbientAndDiffuse) => unit(&material.ambient),
        Parameter::Shininess => float(material.shininess),
    }
}

parameter_queries!(get_material(face, pname): get_materialfv, get_materialiv);
