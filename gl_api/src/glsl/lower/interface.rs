//! A stage's inputs, outputs and uniforms as IR, around its `main`.

use super::call::{returns_early, without_last_return};
use super::place::Slot;
use super::{Failure, Lowered, Lowerer, Words, functions};
use crate::glsl::builtins::math::dot_product;
use crate::glsl::builtins::variables::Builtin;
use crate::glsl::hir::{Function, Storage, Unit, Variable};
use crate::glsl::limits::{MAX_CLIP_PLANES, MAX_DRAW_BUFFERS};
use crate::interface::{StateVar, VARYING_BACK_COLOR, VARYING_CLIP_DISTANCE};
use rasterizer::ir::{
    Input, Interpolation, Module, Op, Output, Stage, Stmt, Texture, Ty, Value, Var,
};
use std::collections::BTreeMap;
use std::sync::Arc;

/// How many targets `gl_FragColor` is written to.
const BROADCAST_TARGETS: u8 = 4;

/// Where the linker put a variable that is not of the stage alone.
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
}

/// How many varying slots scalars of these types take: the IR hands on floats, and an integer goes
/// as two of 16 bits each, exactly.
pub fn varying_slots(types: &[Ty]) -> u16 {
    let slots: usize = types.iter().map(|ty| if *ty == Ty::F32 { 1 } else { 2 }).sum();
    u16::try_from(slots).unwrap_or(u16::MAX)
}

/// A lowered stage.
#[derive(Debug)]
pub struct LoweredStage {
    /// The module.
    pub module: Module,
    /// Each texture slot and the word that holds its unit.
    pub samplers: Vec<(Texture, u32)>,
    /// The words, with the state that this stage reads.
    pub words: Words,
}

/// Scalars to copy to outputs when `main` has ended.
struct Copy {
    slot: Slot,
    at: u32,
    part: Part,
    var: Var,
}

/// What of a scalar is copied.
#[derive(Clone, Copy)]
enum Part {
    /// Its value as a float.
    Whole,
    /// The low 16 bits.
    Low,
    /// The high 16 bits.
    High,
    /// Its value if this user clip plane is enabled, else 0, which cuts nothing away.
    ClipDistance(u8),
    /// The vector that begins there times this user clip plane, if it is enabled.
    ClipVertex(u8),
}

/// Lowers a stage of some units. `reachable` are the functions that `main` reaches.
pub fn lower_stage(
    stage: Stage,
    units: &[&Unit],
    reachable: &[(usize, &Function)],
    bindings: &BTreeMap<Arc<str>, Binding>,
    words: Words,
) -> Result<LoweredStage, Failure> {
    let mut lowerer = Lowerer::new(stage, units.iter().map(|unit| &unit.globals[..]).collect());
    lowerer.functions = functions(units);
    lowerer.unit_functions = units.iter().map(|unit| &unit.functions[..]).collect();
    lowerer.words = words;
    let mut copies = Vec::new();
    for variable in used_globals(units, reachable, bindings) {
        let unit = variable.0;
        lowerer.open_frame(unit, &[]);
        let slot = lowerer.global(&variable.1, bindings, &mut copies);
        lowerer.frames.pop();
        let slot = slot?;
        lowerer.globals.insert(variable.1.name.clone(), slot);
    }
    let Some(&(unit, main)) = reachable.first() else {
        return Err(Failure("there is no function `main`".to_owned()));
    };
    let Some(body) = &main.body else {
        return Err(Failure("there is no function `main`".to_owned()));
    };
    lowerer.open_frame(unit, &main.locals);
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
    let Lowerer { emit, samplers, words, .. } = lowerer;
    Ok(LoweredStage { module: emit.builder.finish(), samplers, words })
}

/// The globals that the functions name, each once by name, with what all units do to it.
fn used_globals(
    units: &[&Unit],
    reachable: &[(usize, &Function)],
    bindings: &BTreeMap<Arc<str>, Binding>,
) -> Vec<(usize, Variable)> {
    let mut order: Vec<(usize, u32)> = Vec::new();
    for (unit, function) in reachable {
        order.extend(function.globals.iter().map(|&global| (*unit, global)));
    }
    // What the other stage reads exists, as zeros, even if this one never names it.
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
                known.dynamic |= variable.dynamic;
                if known.init.is_none() {
                    known.init = variable.init.clone();
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
    /// Where a global lives; copies to outputs are noted.
    fn global(
        &mut self,
        variable: &Variable,
        bindings: &BTreeMap<Arc<str>, Binding>,
        copies: &mut Vec<Copy>,
    ) -> Lowered<Slot> {
        let types = variable.ty.flat();
        let binding = bindings.get(&variable.name).copied();
        match (variable.storage, binding) {
            (Storage::Plain | Storage::Const | Storage::Parameter(_), _) => {
                self.plain_global(variable, &types)
            }
            (Storage::Uniform, Some(Binding::Uniform(word))) => {
                Ok(Slot::Uniform(word, types.into()))
            }
            (Storage::Attribute, Some(Binding::Attribute(location))) => {
                let columns = variable.ty.rows().map_or(4, u32::from);
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
            (Storage::Input(interpolation), Some(Binding::Varying(Some(slot)))) => {
                Ok(self.varying_input(variable, &types, slot, interpolation))
            }
            (Storage::Output(_), Some(Binding::Varying(slot))) => {
                let storage = self.new_slot(&variable.name, &types, variable.dynamic);
                if let Some(first) = slot {
                    self.varying_output(&storage, &types, first, copies);
                }
                Ok(storage)
            }
            (Storage::FragmentOutput, Some(Binding::Target(target))) => {
                let storage = self.new_slot(&variable.name, &types, variable.dynamic);
                for at in 0..types.len() as u32 {
                    let output = Output::Color { target, component: at as u8 };
                    self.output(&storage, &types, at, output, copies);
                }
                Ok(storage)
            }
            (Storage::Builtin(builtin), _) => {
                self.builtin_global(variable, &types, builtin, copies)
            }
            (
                Storage::Uniform
                | Storage::Attribute
                | Storage::Input(_)
                | Storage::Output(_)
                | Storage::FragmentOutput,
                _,
            ) => Err(Failure(format!("`{}` was not linked", variable.name))),
        }
    }

    fn plain_global(&mut self, variable: &Variable, types: &[Ty]) -> Lowered<Slot> {
        let values = match (&variable.constant, &variable.init) {
            (Some(words), _) => Some(self.constants(words, types)),
            (None, Some(init)) => Some(self.expr(init)?),
            (None, None) => None,
        };
        match values {
            Some(values) if !variable.written && !variable.dynamic => {
                Ok(Slot::Values(values.into()))
            }
            values => {
                let slot = self.new_slot(&variable.name, types, variable.dynamic);
                if let Some(values) = values {
                    self.fill(&slot, &values);
                }
                Ok(slot)
            }
        }
    }

    /// Inputs that `read` gives, converted to their types.
    fn inputs(
        &mut self,
        variable: &Variable,
        types: &[Ty],
        read: impl Fn(&mut Self, u32) -> Value,
    ) -> Slot {
        let mut values = Vec::new();
        for (at, &ty) in types.iter().enumerate() {
            let value = read(self, at as u32);
            values.push(self.emit.convert(value, ty));
        }
        if !variable.dynamic {
            return Slot::Values(values.into());
        }
        let slot = self.new_slot(&variable.name, types, true);
        self.fill(&slot, &values);
        slot
    }

    fn varying_input(
        &mut self,
        variable: &Variable,
        types: &[Ty],
        first: u16,
        interpolation: Interpolation,
    ) -> Slot {
        let mut next = first;
        let mut take = |lowerer: &mut Self| {
            let varyings = &mut lowerer.emit.builder.module_mut().varyings;
            let len = usize::from(next) + 1;
            if varyings.len() < len {
                varyings.resize(len, Interpolation::Smooth);
            }
            varyings[usize::from(next)] = interpolation;
            next += 1;
            lowerer.emit.input(Input::Varying(next - 1))
        };
        let mut values = Vec::new();
        for &ty in types {
            let value = take(self);
            if ty == Ty::F32 {
                values.push(value);
                continue;
            }
            let high = take(self);
            let [low, high] = [value, high].map(|part| self.emit.convert(part, Ty::U32));
            let sixteen = self.emit.uint(16);
            let high = self.emit.op(Op::ShiftLeft, &[high, sixteen]);
            let word = self.emit.op(Op::BitOr, &[low, high]);
            values.push(self.emit.convert(word, ty));
        }
        if !variable.dynamic {
            return Slot::Values(values.into());
        }
        let slot = self.new_slot(&variable.name, types, true);
        self.fill(&slot, &values);
        slot
    }

    fn varying_output(&mut self, slot: &Slot, types: &[Ty], first: u16, copies: &mut Vec<Copy>) {
        let mut next = first;
        for (at, &ty) in types.iter().enumerate() {
            let at = at as u32;
            if ty == Ty::F32 {
                self.output(slot, types, at, Output::Varying(next), copies);
                next += 1;
                continue;
            }
            for part in [Part::Low, Part::High] {
                let var = self.emit.builder.output(Output::Varying(next));
                copies.push(Copy { slot: slot.clone(), at, part, var });
                next += 1;
            }
        }
    }

    /// Makes scalar `at` of a variable an output: the variable itself where it fits, else a copy.
    fn output(
        &mut self,
        slot: &Slot,
        types: &[Ty],
        at: u32,
        output: Output,
        copies: &mut Vec<Copy>,
    ) {
        if let (Slot::Vars(vars), Ty::F32) = (slot, types[at as usize]) {
            let var = vars[at as usize];
            self.emit.builder.module_mut().outputs.push((output, var));
            return;
        }
        let var = self.emit.builder.output(output);
        copies.push(Copy { slot: slot.clone(), at, part: Part::Whole, var });
    }

    fn copy(&mut self, copy: &Copy) -> Lowered<()> {
        let mut place = Self::value_place(Vec::new(), crate::glsl::types::FLOAT);
        place.slot = copy.slot.clone();
        place.base = copy.at;
        if let Part::ClipVertex(_) = copy.part {
            place.ty = crate::glsl::types::vec(4);
        }
        let words = self.load(&place)?;
        let word = words[0];
        let value = match copy.part {
            Part::Whole => word,
            Part::Low => {
                let bits = self.emit.convert(word, Ty::U32);
                let mask = self.emit.uint(0xffff);
                self.emit.op(Op::BitAnd, &[bits, mask])
            }
            Part::High => {
                let bits = self.emit.convert(word, Ty::U32);
                let sixteen = self.emit.uint(16);
                self.emit.op(Op::UShiftRight, &[bits, sixteen])
            }
            Part::ClipDistance(plane) => self.if_enabled(plane, word),
            Part::ClipVertex(plane) => {
                let first = self.words.state(StateVar::ClipPlane(plane));
                let plane_words: Vec<Value> =
                    (0..4).map(|i| self.emit.uniform(first + i, Ty::F32)).collect();
                let distance = dot_product(&mut self.emit, &plane_words, &words);
                self.if_enabled(plane, distance)
            }
        };
        let value = self.emit.convert(value, Ty::F32);
        self.emit.push(Stmt::Store { var: copy.var, value });
        Ok(())
    }

    /// A distance if a user clip plane is enabled, else 0.
    fn if_enabled(&mut self, plane: u8, distance: Value) -> Value {
        let word = self.words.state(StateVar::ClipEnables) + u32::from(plane);
        let enabled = self.emit.uniform(word, Ty::F32);
        let enabled = self.emit.convert(enabled, Ty::Bool);
        let zero = self.emit.float(0.0);
        self.emit.select(enabled, distance, zero)
    }

    fn clip_vertex(&mut self, variable: &Variable, types: &[Ty], copies: &mut Vec<Copy>) -> Slot {
        let slot = self.new_slot(&variable.name, types, variable.dynamic);
        if variable.written {
            for plane in 0..MAX_CLIP_PLANES {
                let var = self.emit.builder.output(Output::ClipDistance(plane));
                let part = Part::ClipVertex(plane);
                copies.push(Copy { slot: slot.clone(), at: 0, part, var });
            }
        }
        slot
    }

    fn clip_distances(
        &mut self,
        variable: &Variable,
        types: &[Ty],
        copies: &mut Vec<Copy>,
    ) -> Slot {
        let slot = self.new_slot(&variable.name, types, variable.dynamic);
        if variable.written {
            for plane in 0..types.len() as u8 {
                let (at, part) = (plane.into(), Part::ClipDistance(plane));
                let var = self.emit.builder.output(Output::ClipDistance(plane));
                copies.push(Copy { slot: slot.clone(), at, part, var });
            }
            self.varying_output(&slot, types, VARYING_CLIP_DISTANCE, copies);
        }
        slot
    }

    fn builtin_global(
        &mut self,
        variable: &Variable,
        types: &[Ty],
        builtin: Builtin,
        copies: &mut Vec<Copy>,
    ) -> Lowered<Slot> {
        let stage = self.emit.builder.module().stage;
        let single: fn(u32) -> Vec<Output> = match builtin {
            Builtin::VertexId => {
                let read = |lowerer: &mut Self, _| lowerer.emit.input(Input::VertexId);
                return Ok(self.inputs(variable, types, read));
            }
            Builtin::InstanceId => {
                let read = |lowerer: &mut Self, _| lowerer.emit.input(Input::InstanceId);
                return Ok(self.inputs(variable, types, read));
            }
            Builtin::Attribute(location) => {
                let read = |lowerer: &mut Self, at: u32| {
                    lowerer.emit.input(Input::Attribute { location, component: at as u8 })
                };
                return Ok(self.inputs(variable, types, read));
            }
            Builtin::FragCoord => {
                let read =
                    |lowerer: &mut Self, at: u32| lowerer.emit.input(Input::FragCoord(at as u8));
                return Ok(self.inputs(variable, types, read));
            }
            Builtin::PointCoord => {
                let read =
                    |lowerer: &mut Self, at: u32| lowerer.emit.input(Input::PointCoord(at as u8));
                return Ok(self.inputs(variable, types, read));
            }
            Builtin::FrontFacing => {
                let read = |lowerer: &mut Self, _| lowerer.emit.input(Input::FrontFacing);
                return Ok(self.inputs(variable, types, read));
            }
            Builtin::Varying(slot) => {
                if stage == Stage::Fragment {
                    return Ok(self.varying_input(variable, types, slot, Interpolation::Smooth));
                }
                let storage = self.new_slot(&variable.name, types, variable.dynamic);
                if variable.written {
                    self.varying_output(&storage, types, slot, copies);
                }
                debug_assert!(slot < VARYING_BACK_COLOR + 8);
                return Ok(storage);
            }
            Builtin::State(state) => {
                let word = self.words.state(state);
                return Ok(Slot::Uniform(word, types.into()));
            }
            Builtin::States(array) => {
                return Ok(Slot::States(array, array.of(0).words(), types.into()));
            }
            Builtin::Limit(_) => return self.plain_global(variable, types),
            Builtin::ClipVertex => return Ok(self.clip_vertex(variable, types, copies)),
            Builtin::ClipDistance => {
                let first = VARYING_CLIP_DISTANCE;
                if stage == Stage::Fragment {
                    let smooth = Interpolation::Smooth;
                    return Ok(self.varying_input(variable, types, first, smooth));
                }
                return Ok(self.clip_distances(variable, types, copies));
            }
            Builtin::Position => |at| vec![Output::Position(at as u8)],
            Builtin::PointSize => |_| vec![Output::PointSize],
            Builtin::FragDepth => |_| vec![Output::Depth],
            Builtin::FragColor => |at| {
                let component = at as u8;
                (0..BROADCAST_TARGETS).map(|target| Output::Color { target, component }).collect()
            },
            Builtin::FragData => |at| {
                let (target, component) = ((at / 4) as u8, (at % 4) as u8);
                debug_assert!(target < MAX_DRAW_BUFFERS);
                vec![Output::Color { target, component }]
            },
        };
        let storage = self.new_slot(&variable.name, types, variable.dynamic);
        if variable.written {
            for at in 0..types.len() as u32 {
                for output in single(at) {
                    self.output(&storage, types, at, output, copies);
                }
            }
        }
        Ok(storage)
    }
}
