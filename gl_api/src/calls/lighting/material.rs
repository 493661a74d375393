//! `glMaterial` and `glColorMaterial`: GL 2.1, sections 2.14.2 and 2.14.3.

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_value};
use crate::base::params::Params;
use crate::base::query_value::{QueryValue, float, floats, unit};
use crate::base::types::*;
use crate::calls::parameter_forms::{parameter_calls, parameter_queries};
use crate::calls::vertex::immediate::attribute;
use crate::context::Context;
use crate::context::immediate::Slot;
use crate::draw::material::material;
use crate::interface::Side;
use crate::state::material::{FACES, MaterialParameter, Sides, TRACKED, column};

const SECTION: &str = "GL 2.1, section 2.14.2";

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
    Parts(&'static [MaterialParameter]),
    Indexes,
}

const SHININESS: &[MaterialParameter] = &[MaterialParameter::Shininess];

const PARAMETER: Table<Parameter> = Table {
    section: SECTION,
    rows: &[
        (GL_AMBIENT, Parameter::Parts(&[MaterialParameter::Ambient])),
        (GL_DIFFUSE, Parameter::Parts(&[MaterialParameter::Diffuse])),
        (GL_SPECULAR, Parameter::Parts(&[MaterialParameter::Specular])),
        (GL_EMISSION, Parameter::Parts(&[MaterialParameter::Emission])),
        (GL_SHININESS, Parameter::Parts(SHININESS)),
        (GL_COLOR_INDEXES, Parameter::Indexes),
        (
            GL_AMBIENT_AND_DIFFUSE,
            Parameter::Parts(&[MaterialParameter::Ambient, MaterialParameter::Diffuse]),
        ),
    ],
};

/// A checked change of a material.
enum Change {
    /// A part of one or both sides, and its value: columns of the primitive that is begun.
    Parts(&'static [MaterialParameter], [f32; 4]),
    Indexes([f32; 3]),
}

fn checked(face: GLenum, pname: GLenum, params: &Params) -> Result<(Sides, Change)> {
    let faces = FACES.decode("face", face)?;
    let parameter = PARAMETER.decode("pname", pname)?;
    let count = match parameter {
        Parameter::Parts(SHININESS) => 1,
        Parameter::Parts(_) => 4,
        Parameter::Indexes => 3,
    };
    params.need(SECTION, pname, count)?;
    let change = match parameter {
        Parameter::Parts(SHININESS) => {
            let shininess = params.number();
            if !(0.0..=128.0).contains(&shininess) {
                return invalid_value(
                    SECTION,
                    format!("GL_SHININESS = {shininess} must be 0 to 128"),
                );
            }
            Change::Parts(SHININESS, [shininess, 0.0, 0.0, 1.0])
        }
        Parameter::Parts(parts) => Change::Parts(parts, params.color()),
        Parameter::Indexes => {
            let [ambient, diffuse, specular, _] = params.point().map(|index| index as f32);
            Change::Indexes([ambient, diffuse, specular])
        }
    };
    Ok((faces, change))
}

/// Parts that track the current colour take no lasting effect. In a list, and between `glBegin` and
/// `glEnd`, a part is an attribute of the vertices that follow.
fn set_material(context: &mut Context, face: GLenum, pname: GLenum, params: &Params) -> Result<()> {
    let (faces, change) = match checked(face, pname, params) {
        Ok(checked) => checked,
        Err(error) => {
            return context.run_or_record("glMaterial", move |_| Err(error.clone()));
        }
    };
    match change {
        Change::Parts(parts, value) => {
            for side in [Side::Front, Side::Back].into_iter().filter(|side| faces.has(*side)) {
                for &part in parts {
                    attribute(context, Slot::Location(column(side, part)), value)?;
                }
            }
        }
        Change::Indexes(indexes) => {
            let set = move |context: &mut Context| {
                for side in [Side::Front, Side::Back].into_iter().filter(|side| faces.has(*side)) {
                    context.state.materials.side_mut(side).indexes = indexes;
                }
                Ok(())
            };
            return context.run_or_record("glMaterial", set);
        }
    }
    Ok(())
}

parameter_calls!(set_material(face, pname): materialf, materiali, materialfv, materialiv);

fn get_material(context: &Context, face: GLenum, pname: GLenum) -> Result<QueryValue> {
    const SIDE: Table<Side> =
        Table { section: SECTION, rows: &[(GL_FRONT, Side::Front), (GL_BACK, Side::Back)] };
    const QUERIED: Table<Parameter> =
        Table { section: SECTION, rows: PARAMETER.rows.split_at(6).0 };
    let side = SIDE.decode("face", face)?;
    let parameter = QUERIED.decode("pname", pname)?;
    let material = material(context, side);
    match parameter {
        Parameter::Indexes => floats(&material.indexes),
        Parameter::Parts([MaterialParameter::Emission, ..]) => unit(&material.emission),
        Parameter::Parts([MaterialParameter::Ambient, ..]) => unit(&material.ambient),
        Parameter::Parts([MaterialParameter::Diffuse, ..]) => unit(&material.diffuse),
        Parameter::Parts([MaterialParameter::Specular, ..]) => unit(&material.specular),
        Parameter::Parts([MaterialParameter::Shininess, ..] | []) => float(material.shininess),
    }
}

parameter_queries!(get_material(face, pname): get_materialfv, get_materialiv);
