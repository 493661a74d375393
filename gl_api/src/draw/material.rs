//! The material of a draw, of which parts may follow the current colour (GL 2.1, section 2.14.3).

use crate::context::Context;
use crate::interface::{ATTRIB_COLOR, Side};
use crate::state::enable::Flag;
use crate::state::material::{Material, Tracked};

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
    let mut material = materials.side(side).clone();
    if context.state.enables.has(Flag::ColorMaterial) && materials.faces.has(side) {
        let color = context.state.current[usize::from(ATTRIB_COLOR)];
        track(&mut material, materials.tracked, color);
    }
    material
}
