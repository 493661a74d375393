//! Globals that several shaders of a program declare: one size of each array, one type, one value
//! (GLSL 1.30 sections 4.1.9 and 4.3).

use crate::builtins::variable::Builtin;
use crate::hir::{Expr, Storage, Unit, Variable};
use crate::language::stage_name;
use crate::limits::MAX_SCALARS;
use crate::lower;
use crate::text::diagnostics::{Diagnostic, Log};
use crate::types::Type;
use crate::work::Work;
use rasterizer::ir::Stage;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Whether a variable is shared by all stages, and not one in each stage.
fn is_shared(variable: &Variable) -> bool {
    match variable.storage {
        Storage::Uniform | Storage::Output(_) | Storage::Input(_) => true,
        Storage::Plain
        | Storage::Const
        | Storage::Parameter(_)
        | Storage::Attribute
        | Storage::FragmentOutput
        | Storage::Builtin(_) => false,
    }
}

/// Whether a variable of the geometry stage has an element for each vertex.
fn is_per_vertex(variable: &Variable) -> bool {
    matches!(variable.storage, Storage::Input(_) | Storage::Builtin(Builtin::Incoming(_)))
}

/// The inputs of the geometry stage have an element for each vertex of its primitives (GLSL 1.50
/// section 4.3.8.1).
pub fn sized_inputs(units: &[&Unit], log: &mut Log) {
    let input = units.iter().find_map(|unit| unit.geometry.input);
    let Some(vertices) = input.map(|input| u32::from(input.vertices())) else { return };
    for variable in units.iter().flat_map(|unit| &unit.globals).filter(|v| is_per_vertex(v)) {
        let Type::Array(_, Some(len)) = variable.ty else { continue };
        let name = variable.public_name();
        let message = if len != vertices {
            format!("`{name}` has {len} elements, and the primitives have {vertices} vertices")
        } else if variable.min_len > vertices {
            let last = variable.min_len - 1;
            format!(
                "element {last} of `{name}` is read, and the primitives have {vertices} vertices"
            )
        } else {
            continue;
        };
        log.push(Diagnostic::link_error(message).rule("GLSL 1.50 section 4.3.8.1"));
    }
}

/// A variable by its name, and its stage unless both stages share it.
type Key<'a> = (Arc<str>, Option<&'a str>);

/// The units, with implicitly sized arrays as long as the declaration of another shader says, or
/// else as the largest index in any of them needs.
pub fn unify_globals(units: impl Iterator<Item = Arc<Unit>>) -> Vec<Arc<Unit>> {
    let mut units: Vec<Arc<Unit>> = units.collect();
    // Per key: the largest implicit size, and the declared size.
    let mut sizes: BTreeMap<Key<'_>, (u32, Option<u32>)> = BTreeMap::new();
    let key = |unit: &Unit, variable: &Variable| {
        // Blocks have one size in each stage, and must match.
        let per_vertex =
            unit.stage == Stage::Geometry && matches!(variable.storage, Storage::Input(_));
        let apart = !is_shared(variable) || variable.member_of.is_some() || per_vertex;
        (variable.name.clone(), apart.then(|| stage_name(unit.stage)))
    };
    let mut implicit: Vec<(usize, usize, u32)> = Vec::new();
    for (index, unit) in units.iter().enumerate() {
        for (global, variable) in unit.globals.iter().enumerate() {
            let Type::Array(_, Some(len)) = variable.ty else { continue };
            let (longest, declared) = sizes.entry(key(unit, variable)).or_default();
            *longest = len.max(*longest);
            if variable.implicitly_sized {
                implicit.push((index, global, len));
            } else {
                *declared = Some(len);
            }
        }
    }
    let mut lengths = Vec::new();
    let layouts = || units.iter().map(|unit| unit.geometry);
    let input = layouts().find_map(|layout| layout.input);
    for (unit, global, len) in implicit {
        if units[unit].stage == Stage::Geometry
            && is_per_vertex(&units[unit].globals[global])
            && let Some(input) = input
        {
            lengths.push((unit, global, input.vertices().into()));
            continue;
        }
        let known = sizes.get(&key(&units[unit], &units[unit].globals[global]));
        let Some((longest, declared)) = known else { continue };
        lengths.push((unit, global, declared.filter(|size| *size >= len).unwrap_or(*longest)));
    }
    for (unit, global, len) in lengths {
        let variable = &mut Arc::make_mut(&mut units[unit]).globals[global];
        if let Type::Array(element, size) = &mut variable.ty
            && element.scalars().saturating_mul(len) <= MAX_SCALARS
        {
            *size = Some(len);
        }
    }
    unify_inner_sizes(&mut units, key);
    units
}

/// Gives arrays in arrays whose size comes from their largest index one size in all shaders.
fn unify_inner_sizes<'a>(units: &mut [Arc<Unit>], key: impl Fn(&Unit, &Variable) -> Key<'a>) {
    let mut longest: BTreeMap<Key<'_>, u32> = BTreeMap::new();
    let mut implicit: Vec<(usize, usize)> = Vec::new();
    for (index, unit) in units.iter().enumerate() {
        for (global, variable) in unit.globals.iter().enumerate() {
            if variable.inner_implicitly_sized {
                let len = longest.entry(key(unit, variable)).or_default();
                *len = variable.inner_min_len.max(1).max(*len);
                implicit.push((index, global));
            }
        }
    }
    for (unit, global) in implicit {
        let len = longest.get(&key(&units[unit], &units[unit].globals[global])).copied();
        let variable = &mut Arc::make_mut(&mut units[unit]).globals[global];
        let mut longer = variable.ty.clone();
        if let (Some(size), Some(_)) = (longer.inner_size_mut(variable.inner_depth()), len) {
            *size = len;
        }
        if longer.scalars() <= MAX_SCALARS {
            variable.ty = longer;
        }
    }
}

/// Globals of the same name in several shaders of a stage must be declared alike.
pub fn same_globals(units: &[&Unit], stage: &str, log: &mut Log) {
    let mut known: BTreeMap<&str, (&Unit, &Variable)> = BTreeMap::new();
    for (unit, variable) in
        units.iter().flat_map(|unit| unit.globals.iter().map(move |v| (*unit, v)))
    {
        // Blocks are compared over all stages.
        if variable.block.is_some() {
            continue;
        }
        let entry = known.entry(&variable.name).or_insert((unit, variable));
        let (home, other) = *entry;
        let message = if other.ty != variable.ty || other.storage != variable.storage {
            format!("is {} in one {stage} shader and {} in another", other.ty, variable.ty)
        } else if other.interface_qualifiers.invariant != variable.interface_qualifiers.invariant {
            format!("is invariant in one {stage} shader only")
        } else if other.interface_qualifiers.centroid != variable.interface_qualifiers.centroid {
            format!("is centroid in one {stage} shader only")
        } else if let (Some(a), Some(b)) =
            (other.interface_qualifiers.location, variable.interface_qualifiers.location)
            && a != b
        {
            format!("has location {a} in one {stage} shader and {b} in another")
        } else if let (Some(a), Some(b)) = (&other.init, &variable.init)
            && variable.storage != Storage::Uniform
            && !std::ptr::eq(other, variable)
            && !same_value((home, a), (unit, b), &mut log.work)
        {
            format!("has two initial values in the {stage} shaders")
        } else {
            if other.init.is_none() && other.interface_qualifiers.location.is_none() {
                *entry = (unit, variable);
            }
            continue;
        };
        let message = format!("`{}` {message}", variable.name);
        log.push(Diagnostic::link_error(message).rule("GLSL 1.30 section 4.3"));
    }
}

/// If a shader redeclares `gl_FragDepth`, all shaders that write it do, with one layout
/// (ARB_conservative_depth).
pub fn same_depths(units: &[&Unit], log: &mut Log) {
    let all = || units.iter().flat_map(|unit| &unit.globals).filter(|v| &*v.name == "gl_FragDepth");
    let Some(first) = all().find(|variable| variable.redeclared) else { return };
    let fits = |variable: &Variable| match variable.redeclared {
        true => variable.interface_qualifiers.depth == first.interface_qualifiers.depth,
        false => !variable.written,
    };
    if !all().all(fits) {
        let message = "`gl_FragDepth` has one layout in a shader and another, or none, in another";
        log.push(Diagnostic::link_error(message).rule("ARB_conservative_depth"));
    }
}

/// If a shader redeclares `gl_FragCoord`, all shaders that use it do, with one layout (GLSL 1.50
/// section 4.3.8.1).
pub fn same_coordinates(units: &[&Unit], log: &mut Log) {
    let all = || units.iter().flat_map(|unit| &unit.globals).filter(|v| &*v.name == "gl_FragCoord");
    let Some(first) = all().find(|variable| variable.redeclared) else { return };
    let layout = first.interface_qualifiers.coordinates();
    let fits = |variable: &Variable| match variable.redeclared {
        true => variable.interface_qualifiers.coordinates() == layout,
        false => variable.references == 0,
    };
    if !all().all(fits) {
        let message = "`gl_FragCoord` has one layout in a shader and another, or none, in another";
        log.push(Diagnostic::link_error(message).rule("GLSL 1.50 section 4.3.8.1"));
    }
}

/// Whether two initializers give one value. Of several shaders, only constant initializers can
/// (GLSL 1.30 section 4.3).
fn same_value((home, a): (&Unit, &Expr), (away, b): (&Unit, &Expr), work: &mut Work) -> bool {
    if a.has_effects() || b.has_effects() {
        return false;
    }
    let a = lower::constant(a, &home.globals, &[], work);
    a.is_some() && a == lower::constant(b, &away.globals, &[], work)
}
