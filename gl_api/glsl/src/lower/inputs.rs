//! Inputs of a stage.

use super::Lowerer;
use super::access_chain::VarStorage;
use super::stage::Binding;
use crate::builtins::variable::Incoming;
use crate::hir::Variable;
use crate::interface::VARYING_CLIP_DISTANCE;
use rasterizer::ir::{Input, Interpolation, Op, Output, Ty, Value};

impl Lowerer<'_> {
    /// Storage for inputs that `read` gives, converted to their types.
    pub(super) fn inputs(
        &mut self,
        variable: &Variable,
        types: &[Ty],
        read: impl Fn(&mut Self, u32) -> Value,
    ) -> VarStorage {
        let mut values = Vec::new();
        for (at, &ty) in types.iter().enumerate() {
            let value = read(self, at as u32);
            values.push(self.emit.convert(value, ty));
        }
        self.input_storage(variable, types, values)
    }

    /// The inputs of the geometry stage that begin at a slot: an element for each vertex.
    pub(super) fn vertex_inputs(
        &mut self,
        variable: &Variable,
        types: &[Ty],
        first: u16,
    ) -> VarStorage {
        let vertices = variable.ty.element().and_then(|(_, len)| len).unwrap_or(1);
        let mut values = Vec::new();
        for (vertex, types) in types.chunks((types.len() / vertices as usize).max(1)).enumerate() {
            let mut next = first;
            let mut take = |lowerer: &mut Self| {
                next += 1;
                let output = Output::Varying(next - 1);
                lowerer.emit.input(Input::OfVertex { vertex: vertex as u8, output })
            };
            for &ty in types {
                let value = take(self);
                values.push(match ty {
                    Ty::F32 => value,
                    Ty::I32 | Ty::U32 | Ty::Bool => {
                        let high = take(self);
                        self.joined(value, high, ty)
                    }
                });
            }
        }
        self.input_storage(variable, types, values)
    }

    /// A member of `gl_in`.
    pub(super) fn incoming(
        &mut self,
        variable: &Variable,
        types: &[Ty],
        member: Incoming,
        binding: Option<Binding>,
    ) -> VarStorage {
        let each = variable.ty.element().map_or(1, |(element, _)| element.scalars()).max(1);
        let slot = match binding {
            Some(Binding::Varying(slot)) => slot,
            Some(
                Binding::Attribute(_)
                | Binding::Uniform(_)
                | Binding::Target(_)
                | Binding::SecondColor,
            )
            | None => None,
        };
        let read = |lowerer: &mut Self, at: u32| {
            let component = (at % each) as u16;
            let output = match (member, slot) {
                (Incoming::Position, _) => Output::Position(component as u8),
                (Incoming::PointSize, _) => Output::PointSize,
                (Incoming::ClipDistance, _) => Output::Varying(VARYING_CLIP_DISTANCE + component),
                (Incoming::Varying(first), _)
                | (Incoming::ClipVertex | Incoming::CullDistance, Some(first)) => {
                    Output::Varying(first + component)
                }
                (Incoming::ClipVertex | Incoming::CullDistance, None) => {
                    return lowerer.emit.float(0.0);
                }
            };
            lowerer.emit.input(Input::OfVertex { vertex: (at / each) as u8, output })
        };
        self.inputs(variable, types, read)
    }

    /// The integer whose halves of 16 bits are these floats.
    fn joined(&mut self, low: Value, high: Value, ty: Ty) -> Value {
        let [low, high] = [low, high].map(|part| self.emit.convert(part, Ty::U32));
        let sixteen = self.emit.uint(16);
        let high = self.emit.op(Op::ShiftLeft, &[high, sixteen]);
        let word = self.emit.op(Op::BitOr, &[low, high]);
        self.emit.convert(word, ty)
    }

    /// Storage for these values of inputs.
    fn input_storage(
        &mut self,
        variable: &Variable,
        types: &[Ty],
        values: Vec<Value>,
    ) -> VarStorage {
        if !variable.dynamically_indexed {
            return VarStorage::Values(values.into());
        }
        let slot = self.new_storage(variable, types);
        self.fill(&slot, &values);
        slot
    }

    pub(super) fn varying_input(
        &mut self,
        variable: &Variable,
        types: &[Ty],
        first: u16,
        interpolation: Interpolation,
    ) -> VarStorage {
        let mut next = first;
        let mut take = |lowerer: &mut Self| {
            let varyings = &mut lowerer.emit.builder.module_mut().varyings;
            let len = usize::from(next) + 1;
            if varyings.len() < len {
                varyings.resize(len, Interpolation::Smooth);
            }
            varyings[usize::from(next)] = interpolation;
            if variable.interface_qualifiers.centroid {
                lowerer.emit.builder.module_mut().centroids.push(next);
            }
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
            values.push(self.joined(value, high, ty));
        }
        self.input_storage(variable, types, values)
    }
}
