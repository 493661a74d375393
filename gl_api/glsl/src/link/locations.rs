//! Locations of attributes and fragment outputs, which the application can choose (GL 2.1 section
//! 2.15.3, GLSL 1.30 section 7.2).

use super::stage::{BindingMap, StageUnits};
use crate::builtins::variable::Builtin;
use crate::hir::{Storage, Variable};
use crate::interface::ATTRIB_VERTEX;
use crate::language::Version;
use crate::limits::{MAX_DRAW_BUFFERS, MAX_DUAL_SOURCE_DRAW_BUFFERS, MAX_VERTEX_ATTRIBS};
use crate::lower::Binding;
use crate::program::{Attribute, Bindings, FragmentColor, FragmentOutput};
use crate::text::diagnostics::{Diagnostic, Log};
use crate::types::Type;

/// Gives attributes their locations: first those with an explicit or bound location, then the
/// others in order.
pub fn attributes(
    vertex: &StageUnits<'_>,
    bindings: &Bindings,
    locations: &mut BindingMap,
    log: &mut Log,
) -> Vec<Attribute> {
    let used = vertex.with(|storage| storage == Storage::Attribute);
    let columns = |variable: &Variable| {
        let base = variable.ty.base();
        let elements = variable.ty.scalars() / base.scalars().max(1);
        elements.saturating_mul(base.columns().unwrap_or(1).into()) as usize
    };
    let conventional = conventional(vertex);
    // Generic attribute 0 is gl_Vertex.
    let position = conventional.iter().any(|attribute| attribute.location == ATTRIB_VERTEX);
    let mut taken = [false; MAX_VERTEX_ATTRIBS as usize];
    taken[0] = position;
    let is_es_300 = vertex.units.iter().any(|unit| unit.version == Version::Es300);
    let mut found: Vec<Option<u8>> = Vec::new();
    for variable in &used {
        // `layout(location = n)` overrides `glBindAttribLocation`.
        let explicit = variable
            .interface_qualifiers
            .location
            .map(|explicit| u8::try_from(explicit).unwrap_or(u8::MAX));
        let bound = explicit.or_else(|| bindings.attributes.get(&*variable.name).copied());
        found.push(bound);
        if position && bound == Some(0) {
            let message = format!(
                "attribute `{}` is bound to location 0, which is gl_Vertex, and the shader reads \
                 both",
                variable.name
            );
            log.push(Diagnostic::link_error(message).rule("GL 2.1 section 2.15.3"));
        }
        if let Some(first) = bound {
            let end = usize::from(first) + columns(variable);
            match taken.get_mut(usize::from(first)..end) {
                // Only shaders of GLSL ES 1.00 may give several attributes the same location.
                Some(range) if is_es_300 && range.contains(&true) => {
                    let message = format!(
                        "the location of attribute `{}`, {first}, is that of another one",
                        variable.name
                    );
                    let rule = match explicit {
                        Some(_) => "GLSL ES 3.00 section 4.3.8.1",
                        None => "OpenGL ES 3.0 section 2.11.5, `glBindAttribLocation`",
                    };
                    log.push(Diagnostic::link_error(message).rule(rule));
                }
                Some(range) => range.fill(true),
                None => {
                    let message = format!(
                        "attribute `{}` is bound to location {first} and does not fit below {}",
                        variable.name, MAX_VERTEX_ATTRIBS
                    );
                    log.push(Diagnostic::link_error(message).rule("GL 2.1 section 2.15.3"));
                }
            }
        }
    }
    let mut attributes = Vec::new();
    for (variable, bound) in used.iter().zip(found) {
        let count = columns(variable);
        let location = bound.or_else(|| {
            let free = taken.windows(count).position(|range| !range.contains(&true))?;
            taken[free..free + count].fill(true);
            Some(free as u8)
        });
        let Some(location) = location else {
            let message = format!(
                "attribute `{}` finds no location: there are {MAX_VERTEX_ATTRIBS}",
                variable.name
            );
            log.push(Diagnostic::link_error(message).rule("GL 2.1 section 2.15.3"));
            continue;
        };
        locations.insert(variable.name.clone(), Binding::Attribute(location));
        if let Some(ty) = variable.ty.base().data_type() {
            let array = if let Type::Array(_, len) = variable.ty { len } else { None };
            attributes.push(Attribute { name: variable.name.to_string(), ty, array, location });
        }
    }
    attributes.extend(conventional);
    attributes
}

/// The conventional attributes that the stage reads.
fn conventional(vertex: &StageUnits<'_>) -> Vec<Attribute> {
    let attribute = |variable: &&Variable| {
        let Storage::Builtin(Builtin::Attribute(location)) = variable.storage else { return None };
        let ty = variable.ty.data_type()?;
        Some(Attribute { name: variable.name.to_string(), ty, array: None, location })
    };
    vertex.used.iter().filter_map(attribute).collect()
}

/// The names of the integers that the stage reads and no array holds.
pub fn vertex_numbers(vertex: &StageUnits<'_>) -> Vec<String> {
    let is_number = |variable: &&&Variable| {
        [Builtin::VertexId, Builtin::InstanceId].map(Storage::Builtin).contains(&variable.storage)
    };
    vertex.used.iter().filter(is_number).map(|variable| variable.name.to_string()).collect()
}

/// Gives the outputs of the fragment stage their colour attachments: name and attachment of each.
pub fn targets(
    fragment: &StageUnits<'_>,
    bindings: &Bindings,
    locations: &mut BindingMap,
    log: &mut Log,
) -> Vec<FragmentOutput> {
    let outputs = fragment.with(|storage| storage == Storage::FragmentOutput);
    let builtin =
        ["gl_FragColor", "gl_FragData", "gl_SecondaryFragColorEXT", "gl_SecondaryFragDataEXT"];
    let old = fragment.used.iter().find(|v| v.written && builtin.contains(&&*v.name));
    if let (Some(old), Some(new)) = (old, outputs.first()) {
        let message = format!("both `{}` and the output `{}` are written", old.name, new.name);
        log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 7.2"));
    }
    // By index of the colour.
    let mut taken = [[false; MAX_DRAW_BUFFERS as usize]; 2];
    // An array takes an attachment for each element.
    let colors = |variable: &Variable| {
        (variable.ty.scalars() / variable.ty.base().scalars().max(1)) as usize
    };
    let bound = |variable: &Variable| {
        let qualifiers = &variable.interface_qualifiers;
        let explicit = qualifiers.location.map(|location| FragmentColor {
            location: u8::try_from(location).unwrap_or(u8::MAX),
            index: u8::from(qualifiers.index == Some(1)),
        });
        explicit.or_else(|| bindings.frag_data.get(&*variable.name).copied())
    };
    // What no function uses is checked as well: the shader's interface has it.
    let unused = fragment.declared().filter(|variable| {
        variable.storage == Storage::FragmentOutput
            && outputs.iter().all(|output| output.name != variable.name)
    });
    for output in unused {
        let qualifiers = &output.interface_qualifiers;
        let Some(location) = qualifiers.location else { continue };
        let limit = match qualifiers.index {
            Some(1) => MAX_DUAL_SOURCE_DRAW_BUFFERS,
            Some(_) | None => MAX_DRAW_BUFFERS,
        };
        if location as usize + colors(output) > usize::from(limit) {
            let message = format!(
                "output `{}` is bound to colour {location}; there are {limit}",
                output.name
            );
            log.push(Diagnostic::link_error(message).rule("GL 3.3 section 3.9.2"));
        }
    }
    for output in &outputs {
        let Some(FragmentColor { location, index }) = bound(output) else { continue };
        let first = usize::from(location);
        let (limit, binding) = match index {
            0 => (MAX_DRAW_BUFFERS, Binding::Target(location)),
            _ => (MAX_DUAL_SOURCE_DRAW_BUFFERS, Binding::SecondColor),
        };
        let taken = &mut taken[usize::from(index.min(1))][..usize::from(limit)];
        match taken.get_mut(first..first + colors(output)) {
            Some(taken) if !taken.contains(&true) => taken.fill(true),
            Some(_) => {
                let of = if index == 0 { "" } else { " of index 1" };
                let message = format!("two outputs are bound to colour {location}{of}");
                log.push(Diagnostic::link_error(message));
            }
            None if index == 0 => {
                let message = format!(
                    "output `{}` is bound to colour {location}; there are {MAX_DRAW_BUFFERS}",
                    output.name
                );
                log.push(Diagnostic::link_error(message));
            }
            None => {
                let message = format!(
                    "output `{}` is bound to colour {location} of index 1; of these there are \
                     {MAX_DUAL_SOURCE_DRAW_BUFFERS} (GL_MAX_DUAL_SOURCE_DRAW_BUFFERS)",
                    output.name
                );
                log.push(Diagnostic::link_error(message).rule("GL 3.3 section 3.9.2"));
            }
        }
        locations.insert(output.name.clone(), binding);
    }
    for output in &outputs {
        if bound(output).is_some() {
            continue;
        }
        let (count, taken) = (colors(output), &mut taken[0]);
        match taken.windows(count).position(|range| !range.contains(&true)) {
            Some(free) => {
                taken[free..free + count].fill(true);
                locations.insert(output.name.clone(), Binding::Target(free as u8));
            }
            None => {
                let message = format!("more than {MAX_DRAW_BUFFERS} outputs");
                log.push(Diagnostic::link_error(message));
            }
        }
    }
    let color = |output: &&Variable| {
        let (color, index) = match locations.get(&output.name)? {
            Binding::Target(color) => (*color, 0),
            Binding::SecondColor => (0, 1),
            Binding::Attribute(_) | Binding::Uniform(_) | Binding::Varying(_) => return None,
        };
        Some(FragmentOutput { name: output.name.to_string(), color, index })
    };
    outputs.iter().filter_map(color).collect()
}
