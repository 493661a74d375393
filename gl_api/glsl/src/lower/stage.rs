//! One stage: its inputs, outputs and uniforms, then its `main`.

use super::access_chain::VarStorage;
use super::call::{returns_early, without_last_return};
use super::outputs::{CopyTarget, OutputCopy};
use super::{LowerError, LowerResult, Lowerer, Words, call_targets};
use crate::builtins::variable::Builtin;
use crate::hir::{Function, Storage, Unit, Variable};
use crate::types::{ComparisonResult, Dim};
use crate::work::Work;
use rasterizer::ir::{
    GeometryInterface, Input, Interpolation, MAX_GEOMETRY_COMPONENTS, Module, Op, Output, Stage,
    Texture, Ty,
};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// What the linker assigned to a variable of the interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Binding {
    /// An attribute's location.
    Attribute(u8),
    /// A uniform's first word.
    Uniform(u32),
    /// A varying's first slot; `None` if the other stage does not read it.
    Varying(Option<u16>),
    /// The render target of a fragment output.
    Target(u8),
    /// The second colour for render target 0.
    SecondColor,
}

/// The number of varying slots of scalars of these types: varyings are floats, and an integer takes
/// two of 16 bits each, which is exact.
pub fn varying_slots(types: &[Ty]) -> u16 {
    let storages: usize = types.iter().map(|ty| if *ty == Ty::F32 { 1 } else { 2 }).sum();
    u16::try_from(storages).unwrap_or(u16::MAX)
}

/// A lowered stage.
#[derive(Debug)]
pub struct LoweredStage {
    /// The module.
    pub module: Module,
    /// Each texture slot, the word that holds its unit, and what textures it takes.
    pub samplers: Vec<(Texture, u32, Dim, ComparisonResult)>,
    /// The words, with the GL state of this stage.
    pub words: Words,
}

/// The stage to lower; the interface of the geometry stage is without its outputs.
#[derive(Clone, Debug)]
pub enum StageToLower {
    /// The vertex stage.
    Vertex,
    /// The geometry stage.
    Geometry(GeometryInterface),
    /// The fragment stage.
    Fragment,
}

impl StageToLower {
    fn stage(&self) -> Stage {
        match self {
            Self::Vertex => Stage::Vertex,
            Self::Geometry(_) => Stage::Geometry,
            Self::Fragment => Stage::Fragment,
        }
    }
}

/// Lowers a stage of some units. `reachable` are the functions that `main` reaches.
pub fn lower_stage(
    stage: StageToLower,
    units: &[&Unit],
    reachable: &[(usize, &Function)],
    bindings: &BTreeMap<Arc<str>, Binding>,
    words: Words,
    work: &mut Work,
) -> Result<LoweredStage, LowerError> {
    let mut lowerer =
        Lowerer::new(stage.stage(), units.iter().map(|unit| &unit.globals[..]).collect());
    lowerer.targets = call_targets(units);
    lowerer.emit.work = *work;
    lowerer.words = words;
    let mut copies = Vec::new();
    let mut globals = used_globals(units, reachable, bindings);
    // Called functions may reference any global, so all storage exists before the first initializer
    // is lowered.
    let mut values = Vec::new();
    if units.iter().any(|unit| !unit.calls.is_empty()) {
        for (unit, global) in &mut globals {
            if let (Storage::Plain, Some(init)) = (global.storage, global.init.take()) {
                values.push((*unit, global.name.clone(), init));
            }
        }
    }
    for (unit, global) in &globals {
        let slot =
            lowerer.in_unit(*unit, |lowerer| lowerer.global(global, bindings, &mut copies))?;
        lowerer.globals.insert(global.name.clone(), slot);
    }
    if let StageToLower::Geometry(interface) = stage {
        lowerer.begin_geometry(interface, std::mem::take(&mut copies))?;
    }
    for (unit, name, init) in &values {
        lowerer.in_unit(*unit, |lowerer| {
            let values = lowerer.expr(init)?;
            if let Some(slot) = lowerer.globals.get(name).cloned() {
                lowerer.fill(&slot, &values);
            }
            Ok(())
        })?;
    }
    let Some(&(unit, main)) = reachable.first() else {
        return Err(LowerError("there is no function `main`".to_owned()));
    };
    let Some(body) = &main.body else {
        return Err(LowerError("there is no function `main`".to_owned()));
    };
    lowerer.open_frame(unit, None, &main.locals);
    if returns_early(body) {
        lowerer.scope(body)?;
    } else {
        lowerer.statements(without_last_return(body))?;
    }
    lowerer.frames.pop();
    for copy in copies {
        lowerer.copy(&copy)?;
    }
    lowerer.check_size()?;
    *work = lowerer.emit.work;
    let Lowerer { emit, samplers, words, .. } = lowerer;
    Ok(LoweredStage { module: emit.builder.finish(), samplers, words })
}

/// The globals that the functions reference, those whose initializers have effects, and those that
/// initializers reference: unit and index, in order.
pub fn named_globals(units: &[&Unit], reachable: &[(usize, &Function)]) -> Vec<(usize, u32)> {
    let mut named: Vec<BTreeSet<u32>> = vec![BTreeSet::new(); units.len()];
    for (unit, function) in reachable {
        named[*unit].extend(&function.globals);
    }
    for (declared, named) in units.iter().zip(&mut named) {
        let all = declared.globals.iter().zip(0..);
        named.extend(all.filter(|(global, _)| global.has_effects()).map(|(_, index)| index));
    }
    // A global of one shader may have its initializer in another.
    let mut open: Vec<(usize, u32)> = Vec::new();
    let with = |named: &[BTreeSet<u32>]| -> Vec<(usize, u32)> {
        let all = named.iter().enumerate();
        all.flat_map(|(unit, set)| set.iter().map(move |&global| (unit, global))).collect()
    };
    let mut initialized: BTreeMap<&str, Vec<(usize, u32)>> = BTreeMap::new();
    for (unit, declared) in units.iter().enumerate() {
        let all = declared.globals.iter().zip(0..);
        for (variable, global) in all.filter(|(variable, _)| variable.init.is_some()) {
            initialized.entry(&variable.name).or_default().push((unit, global));
        }
    }
    for (unit, global) in with(&named) {
        let name = &*units[unit].globals[global as usize].name;
        open.extend(initialized.get(name).into_iter().flatten());
    }
    while let Some((unit, global)) = open.pop() {
        named[unit].insert(global);
        let Some(init) = &units[unit].globals[global as usize].init else { continue };
        let mut found = BTreeSet::new();
        init.add_globals(&mut found);
        open.extend(
            found.into_iter().filter(|found| !named[unit].contains(found)).map(|g| (unit, g)),
        );
    }
    with(&named)
}

/// The referenced globals, each once by name, with the uses in all units merged.
fn used_globals(
    units: &[&Unit],
    reachable: &[(usize, &Function)],
    bindings: &BTreeMap<Arc<str>, Binding>,
) -> Vec<(usize, Variable)> {
    let mut order = named_globals(units, reachable);
    // Inputs of the other stage exist as outputs, zero if this one never references them.
    for (unit, declared) in units.iter().enumerate() {
        for (global, variable) in declared.globals.iter().enumerate() {
            let read = matches!(bindings.get(&variable.name), Some(Binding::Varying(Some(_))));
            if read && matches!(variable.storage, Storage::Output(_)) {
                order.push((unit, global as u32));
            }
        }
    }
    order.sort_unstable();
    order.dedup();
    let mut merged: Vec<(usize, Variable)> = Vec::new();
    let mut names: BTreeMap<&str, usize> = BTreeMap::new();
    for (unit, global) in order {
        let variable = &units[unit].globals[global as usize];
        match names.get(&*variable.name) {
            Some(&index) => {
                let known: &mut Variable = &mut merged[index].1;
                known.written |= variable.written;
                known.dynamically_indexed |= variable.dynamically_indexed;
                if known.init.is_none() && variable.init.is_some() {
                    // Its initializer may reference globals that only its own unit declares before
                    // it.
                    let known = merged.remove(index);
                    names.values_mut().for_each(|at| *at -= usize::from(*at > index));
                    names.insert(&variable.name, merged.len());
                    merged.push((unit, Variable { init: variable.init.clone(), ..known.1 }));
                }
            }
            None => {
                names.insert(&variable.name, merged.len());
                merged.push((unit, variable.clone()));
            }
        }
    }
    merged
}

impl Lowerer<'_> {
    /// Runs `lower` in a frame for the globals of a unit.
    fn in_unit<T>(
        &mut self,
        unit: usize,
        lower: impl FnOnce(&mut Self) -> LowerResult<T>,
    ) -> LowerResult<T> {
        self.open_frame(unit, None, &[]);
        let result = lower(self);
        self.frames.pop();
        result
    }

    /// The interface of the geometry stage, with what its vertices hold.
    fn begin_geometry(
        &mut self,
        interface: GeometryInterface,
        copies: Vec<OutputCopy>,
    ) -> LowerResult<()> {
        let output = |copy: &OutputCopy| match copy.target {
            CopyTarget::Emitted(output) => Some(output),
            CopyTarget::Var(_) => None,
        };
        let outputs: Vec<Output> = copies.iter().filter_map(output).collect();
        let count = (outputs.len() as u32).saturating_mul(interface.max_vertices);
        if count > MAX_GEOMETRY_COMPONENTS {
            return Err(LowerError(format!(
                "{} vertices of {} components are {count}: \
                 gl_MaxGeometryTotalOutputComponents is {MAX_GEOMETRY_COMPONENTS}",
                interface.max_vertices,
                outputs.len()
            )));
        }
        self.emit.builder.module_mut().geometry = Some(GeometryInterface { outputs, ..interface });
        self.emitted = copies.into();
        Ok(())
    }

    /// The storage of a global; copies to outputs are appended.
    fn global(
        &mut self,
        variable: &Variable,
        bindings: &BTreeMap<Arc<str>, Binding>,
        copies: &mut Vec<OutputCopy>,
    ) -> LowerResult<VarStorage> {
        let types = variable.ty.flat();
        let binding = bindings.get(&variable.name).copied();
        match (variable.storage, binding) {
            (Storage::Plain | Storage::Const | Storage::Parameter(_), _) => {
                self.plain_global(variable, &types)
            }
            (Storage::Uniform, Some(Binding::Uniform(word))) => {
                Ok(VarStorage::Uniform(word, types.into()))
            }
            (Storage::Attribute, Some(Binding::Attribute(location))) => {
                let base = variable.ty.base();
                let columns = base.rows().map_or(base.scalars().max(1), u32::from);
                let read = |lowerer: &mut Self, at: u32| {
                    let location = location + (at / columns) as u8;
                    let component = (at % columns) as u8;
                    let value = lowerer.emit.input(Input::Attribute { location, component });
                    match types[at as usize] {
                        Ty::F32 => value,
                        Ty::I32 | Ty::U32 | Ty::Bool => lowerer.emit.op(Op::FloatBits, &[value]),
                    }
                };
                Ok(self.inputs(variable, &types, read))
            }
            (Storage::Input(_), Some(Binding::Varying(Some(slot)))) if self.is_geometry() => {
                Ok(self.vertex_inputs(variable, &types, slot))
            }
            (Storage::Builtin(Builtin::Incoming(member)), binding) => {
                Ok(self.incoming(variable, &types, member, binding))
            }
            (Storage::Input(interpolation), Some(Binding::Varying(Some(slot)))) => {
                Ok(self.varying_input(variable, &types, slot, interpolation))
            }
            // No stage writes it: undefined, here zero.
            (Storage::Input(_), Some(Binding::Varying(None))) => {
                let zero =
                    |lowerer: &mut Self, at: u32| lowerer.emit.constant(0, types[at as usize]);
                Ok(self.inputs(variable, &types, zero))
            }
            (Storage::Output(_), Some(Binding::Varying(slot))) => {
                let storage = self.new_storage(variable, &types);
                if let Some(first) = slot {
                    self.varying_output(&storage, &types, first, copies);
                }
                Ok(storage)
            }
            (Storage::FragmentOutput, Some(Binding::SecondColor)) => {
                let storage = self.new_storage(variable, &types);
                for at in 0..types.len() as u8 {
                    self.output(&storage, &types, at.into(), Output::SecondColor(at), copies);
                }
                Ok(storage)
            }
            (Storage::FragmentOutput, Some(Binding::Target(target))) => {
                let storage = self.new_storage(variable, &types);
                let each = variable.ty.base().scalars();
                for at in 0..types.len() as u32 {
                    let (target, component) = (target + (at / each) as u8, (at % each) as u8);
                    let output = Output::Color { target, component };
                    self.output(&storage, &types, at, output, copies);
                }
                Ok(storage)
            }
            (Storage::Builtin(Builtin::CullDistance), Some(Binding::Varying(Some(slot))))
                if self.emit.builder.module().stage == Stage::Fragment =>
            {
                Ok(self.varying_input(variable, &types, slot, Interpolation::Smooth))
            }
            (
                Storage::Builtin(Builtin::Layer | Builtin::ViewportIndex),
                Some(Binding::Varying(Some(slot))),
            ) if self.emit.builder.module().stage == Stage::Fragment => {
                Ok(self.varying_input(variable, &types, slot, Interpolation::Flat))
            }
            (Storage::Builtin(builtin), binding) => {
                let storage = self.builtin_global(variable, &types, builtin, copies)?;
                // Transform feedback captures it.
                if let Some(Binding::Varying(Some(first))) = binding {
                    self.varying_output(&storage, &types, first, copies);
                }
                Ok(storage)
            }
            (
                Storage::Uniform
                | Storage::Attribute
                | Storage::Input(_)
                | Storage::Output(_)
                | Storage::FragmentOutput,
                _,
            ) => Err(LowerError(format!("`{}` was not linked", variable.name))),
        }
    }

    pub(super) fn plain_global(
        &mut self,
        variable: &Variable,
        types: &[Ty],
    ) -> LowerResult<VarStorage> {
        let values = match (&variable.constant, &variable.init) {
            (Some(words), _) => Some(self.constants(words, types)),
            (None, Some(init)) => Some(self.expr(init)?),
            (None, None) => None,
        };
        match values {
            Some(values) if !variable.written && !variable.dynamically_indexed => {
                Ok(VarStorage::Values(values.into()))
            }
            values => {
                let slot = self.new_storage(variable, types);
                if let Some(values) = values {
                    self.fill(&slot, &values);
                }
                Ok(slot)
            }
        }
    }
}
