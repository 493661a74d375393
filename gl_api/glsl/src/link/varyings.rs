//! Varyings: from a stage to the next one (GLSL 1.30 sections 4.3.6 and 4.3.7).

use super::stage::{BindingMap, StageUnits};
use super::{Matching, packing};
use crate::builtins::variable::Builtin;
use crate::hir::{InterfaceBlock, Storage, Variable};
use crate::interface::VARYING_USER;
use crate::language::{Version, stage_name};
use crate::limits::{MAX_STAGE_COMPONENTS, MAX_VARYING_FLOATS};
use crate::lower::{Binding, varying_slots};
use crate::text::diagnostics::{Diagnostic, Log};
use crate::text::spelling::closest;
use crate::types::Type;
use rasterizer::ir::{Interpolation, Stage};
use std::collections::{BTreeMap, BTreeSet};

/// Matches the outputs of a stage with the inputs of the next one; gives the first free slot.
pub fn varyings(
    (writer, reader): (Option<&StageUnits<'_>>, Option<&StageUnits<'_>>),
    [in_writer, in_reader]: [&mut BindingMap; 2],
    matching: Matching,
    log: &mut Log,
) -> u16 {
    let outputs = Outputs::of(writer);
    for (variable, _) in &outputs.all {
        in_writer.insert(variable.name.clone(), Binding::Varying(None));
    }
    let (mut next, mut scalars) = (VARYING_USER, 0u32);
    let mut passed: Vec<&Type> = Vec::new();
    let (Some(writer), Some(reader)) = (writer, reader) else {
        // A fixed-function vertex stage writes no user varying: it is undefined, here zero.
        for input in reader.iter().flat_map(|reader| reader.with(is_input)) {
            in_reader.insert(input.name.clone(), Binding::Varying(None));
        }
        return next;
    };
    let [from, to] = [writer, reader].map(|stage| stage_name(stage.stage));
    let mut inputs: BTreeSet<&str> = BTreeSet::new();
    for input in reader.declared().filter(|variable| is_input(variable.storage)) {
        if matching != Matching::Pipeline
            && let Some((output, _)) = outputs.matching(input)
            && inputs.insert(&input.name)
        {
            check_alike(output, input, (writer, reader), log);
        }
    }
    let limit = match writer.units.iter().all(|unit| unit.version < Version::V150) {
        true => MAX_VARYING_FLOATS,
        false => MAX_STAGE_COMPONENTS,
    };
    for input in reader.with(is_input) {
        let found = match matching {
            Matching::Whole | Matching::Part => outputs.matching(input),
            Matching::Pipeline => match outputs.of_other_program(input, reader) {
                Some(found) => Some(found),
                None => {
                    in_reader.insert(input.name.clone(), Binding::Varying(None));
                    continue;
                }
            },
        };
        let name = input.public_name();
        let Some((output, written)) = found else {
            let near = closest(name, outputs.all.iter().map(|(output, _)| output.public_name()));
            let near = near.map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
            let message =
                format!("the {to} shader reads `{name}`, which no {from} shader writes{near}");
            log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 4.3.6"));
            continue;
        };
        // In GLSL ES it is undefined, without an error.
        let must_write = |version| matches!(version, Version::V110 | Version::V120);
        if !written
            && matching != Matching::Pipeline
            && reader.units.iter().all(|unit| must_write(unit.version))
        {
            let message =
                format!("the {to} shader reads `{name}`, which the {from} shader never writes");
            log.push(Diagnostic::link_error(message).rule("GLSL 1.20 section 4.3.6"));
        }
        scalars += output.ty.scalars();
        if scalars > u32::from(limit) {
            let message = format!("more than {limit} components pass between the stages");
            log.push(Diagnostic::link_error(message));
            return next;
        }
        passed.push(&output.ty);
        // Inputs of other programs may share an output.
        let first = match in_writer.get(&output.name) {
            Some(Binding::Varying(Some(first))) => *first,
            _ => next,
        };
        in_writer.insert(output.name.clone(), Binding::Varying(Some(first)));
        in_reader.insert(input.name.clone(), Binding::Varying(Some(first)));
        if first == next {
            next += varying_slots(&output.ty.flat());
        }
    }
    let is_es = reader.units.iter().any(|unit| unit.version.is_es());
    let rows = u32::from(MAX_VARYING_FLOATS / 4);
    if is_es && !packing::fit(&passed, rows) {
        let message = format!("the varyings do not fit into {rows} vectors of four components");
        let rule = "GLSL ES 1.00 appendix A, section 7";
        log.push(Diagnostic::link_error(message).rule(rule));
    }
    next
}

/// The outputs of a stage.
struct Outputs<'a> {
    /// The first declaration of each, in order, and whether the stage writes it.
    all: Vec<(&'a Variable, bool)>,
    /// Their indices.
    named: BTreeMap<&'a str, usize>,
}

impl<'a> Outputs<'a> {
    fn of(writer: Option<&StageUnits<'a>>) -> Self {
        let mut outputs = Self { all: Vec::new(), named: BTreeMap::new() };
        for variable in writer.iter().flat_map(|stage| stage.declared()) {
            if matches!(variable.storage, Storage::Output(_)) {
                let at = *outputs.named.entry(&variable.name).or_insert(outputs.all.len());
                if at == outputs.all.len() {
                    outputs.all.push((variable, false));
                }
                outputs.all[at].1 |= variable.written;
            }
        }
        outputs
    }

    /// The output of an input of the same program: by location, if it has one, or else by name.
    fn matching(&self, input: &Variable) -> Option<(&'a Variable, bool)> {
        match input.interface_qualifiers.location {
            Some(location) => self.located(location),
            None => self.named.get(input.passed_name()).map(|&at| self.all[at]),
        }
    }

    fn located(&self, location: u32) -> Option<(&'a Variable, bool)> {
        let is_there = |(output, _): &&(&Variable, bool)| {
            output.interface_qualifiers.location == Some(location)
        };
        self.all.iter().find(is_there).copied()
    }

    /// The output of an input that may be of another program: one of the same location, of which a vector may be
    /// longer; or of the same name; or else the one at the same place among those without location, as values that
    /// match nothing are undefined (ARB_separate_shader_objects, section 2.14.PPO).
    fn of_other_program(
        &self,
        input: &Variable,
        reader: &StageUnits<'_>,
    ) -> Option<(&'a Variable, bool)> {
        let ty = match &input.ty {
            // The geometry stage has an element for each vertex.
            Type::Array(element, _) if reader.stage == Stage::Geometry => element,
            ty => ty,
        };
        if let Some(location) = input.interface_qualifiers.location {
            return self.located(location).filter(|(output, _)| begins_with(&output.ty, ty));
        }
        let free = |variable: &Variable| variable.interface_qualifiers.location.is_none();
        let fits = |(output, _): &(&Variable, bool)| free(output) && output.ty == *ty;
        let named = self.named.get(input.passed_name()).map(|&at| self.all[at]);
        if let Some(named) = named {
            return Some(named).filter(fits);
        }
        let mut names: Vec<&str> = Vec::new();
        for other in reader.declared().filter(|v| is_input(v.storage) && free(v)) {
            if !names.contains(&&*other.name) {
                names.push(&other.name);
            }
        }
        let place = names.iter().position(|name| **name == *input.name)?;
        self.all.iter().filter(|(output, _)| free(output)).nth(place).copied().filter(fits)
    }
}

/// Whether an output of one type has an input of another in its first components.
fn begins_with(output: &Type, input: &Type) -> bool {
    match (output, input) {
        (Type::Vector(a, length), Type::Vector(b, needed)) => a == b && needed <= length,
        (output, input) => output == input,
    }
}

/// What the fragment stage reads is invariant only if what it is made of is (GLSL ES 1.00 section 4.6.4).
pub fn invariant_coordinates(
    vertex: Option<&StageUnits<'_>>,
    fragment: Option<&StageUnits<'_>>,
    log: &mut Log,
) {
    let (Some(vertex), Some(fragment)) = (vertex, fragment) else { return };
    let is_invariant = |stage: &StageUnits<'_>, name: &str| {
        let mut declared = stage.units.iter().flat_map(|unit| &unit.globals);
        let named = |v: &Variable| &*v.name == name && v.interface_qualifiers.invariant;
        stage.units.iter().any(|unit| unit.all_invariant) || declared.any(named)
    };
    let is_es = fragment.units.iter().any(|unit| unit.version == Version::Es100);
    for (read, of) in [("gl_FragCoord", "gl_Position"), ("gl_PointCoord", "gl_PointSize")] {
        let named = |v: &Variable| &*v.name == read && v.interface_qualifiers.invariant;
        let declared = fragment.units.iter().flat_map(|unit| &unit.globals).any(named);
        if is_es && declared && !is_invariant(vertex, of) {
            let message = format!("`{read}` is invariant, and `{of}` is not");
            let problem = Diagnostic::link_error(message).rule("GLSL ES 1.00 section 4.6.4");
            log.push(problem.help(format!("write `invariant {of};` in the vertex shader")));
        }
    }
}

/// The slots of the varyings that the fragment stage reads: first, how many, name.
pub fn slots(fragment: Option<&StageUnits<'_>>, locations: &BindingMap) -> Vec<(u16, u16, String)> {
    let passes = |storage: Storage| {
        let built_in = Storage::Builtin;
        is_input(storage)
            || [Builtin::Layer, Builtin::ViewportIndex].map(built_in).contains(&storage)
    };
    let inputs = fragment.iter().flat_map(|stage| stage.with(passes));
    inputs
        .filter_map(|input| match locations.get(&input.name) {
            Some(Binding::Varying(Some(first))) => {
                Some((*first, varying_slots(&input.ty.flat()), input.public_name().to_owned()))
            }
            _ => None,
        })
        .collect()
}

fn is_input(storage: Storage) -> bool {
    matches!(storage, Storage::Input(_))
}

/// Reports a varying that the stages declare differently, whether it is read or not.
fn check_alike(
    output: &Variable,
    input: &Variable,
    (writer, reader): (&StageUnits<'_>, &StageUnits<'_>),
    log: &mut Log,
) {
    let geometry = reader.stage == Stage::Geometry;
    // The geometry stage has an element for each vertex.
    let input_ty = match &input.ty {
        Type::Array(element, _) if geometry => element,
        ty => ty,
    };
    if input.interface_qualifiers.location.is_none()
        && let (Some(written), Some(read)) = (&output.member_of, &input.member_of)
        && let Some(difference) = different_blocks(written, read, reader.stage)
    {
        let message = format!("the block `{}` {difference}", written.name);
        log.push(Diagnostic::link_error(message).rule("GLSL 1.50 section 4.3.7"));
        return;
    }
    let (a, b, rule) = if output.ty != *input_ty {
        (output.ty.to_string(), input_ty.to_string(), "GLSL 1.30 section 4.3.6")
    } else if let Some((a, b)) = mismatch(output, input, reader) {
        (a.to_owned(), b.to_owned(), "GLSL 1.30 section 4.3.7")
    } else if output.interface_qualifiers.invariant != input.interface_qualifiers.invariant
        && !writer.units.iter().any(|unit| unit.all_invariant || unit.version == Version::Es300)
    {
        let [a, b] =
            [output, input].map(|variable| match variable.interface_qualifiers.invariant {
                true => "invariant".to_owned(),
                false => "not invariant".to_owned(),
            });
        (a, b, "GLSL 1.20 section 4.6.1")
    } else {
        return;
    };
    let name = output.public_name();
    let [from, to] = [writer, reader].map(|stage| stage_name(stage.stage));
    let message = format!("`{name}` is {a} in the {from} shader and {b} in the {to} shader");
    log.push(Diagnostic::link_error(message).rule(rule));
}

/// How the declarations of a block in two stages differ.
fn different_blocks(
    written: &InterfaceBlock,
    read: &InterfaceBlock,
    reader: Stage,
) -> Option<&'static str> {
    let dimensions = match reader {
        // One is that of the vertices.
        Stage::Geometry => read.dimensions.saturating_sub(1),
        Stage::Vertex | Stage::Fragment => read.dimensions,
    };
    if written.members != read.members {
        Some("has other members, or in another order, in the next stage")
    } else if written.dimensions != dimensions {
        Some(match written.dimensions == 0 || dimensions == 0 {
            true => "is an array of instances in one stage only",
            false => "is an array of instances of other dimensions in the next stage",
        })
    } else {
        None
    }
}

/// The qualifiers in which two declarations of a varying differ.
fn mismatch(
    output: &Variable,
    input: &Variable,
    reader: &StageUnits<'_>,
) -> Option<(&'static str, &'static str)> {
    if let (Storage::Output(a), Storage::Input(b)) = (output.storage, input.storage)
        && a != b
    {
        return Some((word(a), word(b)));
    }
    let words = |one: bool, word, without| if one { word } else { without };
    let (a, b) = (output.interface_qualifiers, input.interface_qualifiers);
    // GLSL ES 3.00 section 4.3.9: the words of interpolation match; `centroid` is that of the fragment stage.
    let is_es = reader.units.iter().any(|unit| unit.version == Version::Es300);
    if a.centroid != b.centroid && !is_es {
        let of = |centroid| words(centroid, "centroid", "not centroid");
        return Some((of(a.centroid), of(b.centroid)));
    }
    None
}

/// The keyword of an interpolation.
fn word(interpolation: Interpolation) -> &'static str {
    match interpolation {
        Interpolation::Smooth => "smooth",
        Interpolation::NoPerspective => "noperspective",
        Interpolation::Flat => "flat",
    }
}

/// The inputs of the fragment stage for a colour, and the outputs of the vertex stage.
const COLORS: [[&str; 3]; 2] = [
    ["gl_Color", "gl_FrontColor", "gl_BackColor"],
    ["gl_SecondaryColor", "gl_FrontSecondaryColor", "gl_BackSecondaryColor"],
];

/// The interpolation of the colour and the secondary colour, if a shader declares it: all of the
/// built-in variables of one colour must agree (GLSL 1.30 section 4.3.7).
pub fn colors(
    vertex: Option<&StageUnits<'_>>,
    fragment: Option<&StageUnits<'_>>,
    matching: Matching,
    log: &mut Log,
) -> [Option<Interpolation>; 2] {
    COLORS.map(|names| {
        let used = |stage: Option<&StageUnits<'_>>, name: &str| {
            stage.and_then(|stage| {
                let found = stage.used.iter().find(|variable| *variable.name == *name);
                found.map(|variable| variable.interface_qualifiers.interpolation)
            })
        };
        let [input, front, back] = names;
        let all = [
            (input, used(fragment, input)),
            (front, used(vertex, front)),
            (back, used(vertex, back)),
        ];
        let mut declared = all
            .into_iter()
            .filter_map(|(name, declared)| declared.map(|declared| (name, declared)));
        let (first, interpolation) = declared.next()?;
        if matching != Matching::Pipeline
            && let Some((other, different)) = declared.find(|(_, other)| *other != interpolation)
        {
            let text = |declared: Option<Interpolation>| declared.map_or("not qualified", word);
            let message = format!(
                "`{first}` is {} and `{other}` is {}",
                text(interpolation),
                text(different)
            );
            log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 4.3.7"));
        }
        interpolation
    })
}
