//! Built-in variables as inputs, outputs and uniform words.

use super::access_chain::VarStorage;
use super::outputs::OutputCopy;
use super::{LowerError, LowerResult, Lowerer};
use crate::builtins::variable::Builtin;
use crate::hir::{InterfaceQualifiers, Variable};
use crate::interface::{StateVar, VARYING_BACK_COLOR, VARYING_CLIP_DISTANCE, VARYING_PRIMITIVE_ID};
use crate::limits::MAX_DRAW_BUFFERS;
use rasterizer::ir::{Axis, Input, Interpolation, Op, Output, Stage, Ty, Value};

impl Lowerer<'_> {
    /// A component of `gl_FragCoord` in its layout (ARB_fragment_coord_conventions).
    fn frag_coord(&mut self, interface_qualifiers: InterfaceQualifiers, at: u8) -> Value {
        let mut value = self.emit.input(Input::FragCoord(at));
        if at == 1 && interface_qualifiers.origin_upper_left {
            let word = self.words.state(StateVar::FramebufferHeight);
            let height = self.emit.uniform(word, Ty::F32);
            value = self.emit.op(Op::Sub, &[height, value]);
        }
        if at < 2 && interface_qualifiers.pixel_center_integer {
            let half = self.emit.float(0.5);
            value = self.emit.op(Op::Sub, &[value, half]);
        }
        value
    }

    pub(super) fn builtin_global(
        &mut self,
        variable: &Variable,
        types: &[Ty],
        builtin: Builtin,
        copies: &mut Vec<OutputCopy>,
    ) -> LowerResult<VarStorage> {
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
                let interface_qualifiers = variable.interface_qualifiers;
                let read = |lowerer: &mut Self, at: u32| {
                    lowerer.frag_coord(interface_qualifiers, at as u8)
                };
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
            Builtin::SampleId => {
                let read = |lowerer: &mut Self, _| lowerer.emit.input(Input::SampleId);
                return Ok(self.inputs(variable, types, read));
            }
            Builtin::SamplePosition => {
                let read = |lowerer: &mut Self, at: u32| {
                    let axis = if at == 0 { Axis::X } else { Axis::Y };
                    lowerer.emit.input(Input::SamplePosition(axis))
                };
                return Ok(self.inputs(variable, types, read));
            }
            Builtin::SampleCount => {
                let word = self.words.state(StateVar::SampleCount);
                return Ok(VarStorage::Uniform(word, types.into()));
            }
            Builtin::PrimitiveIdIn => {
                let read = |lowerer: &mut Self, _| lowerer.emit.input(Input::PrimitiveId);
                return Ok(self.inputs(variable, types, read));
            }
            Builtin::Incoming(_) => {
                return Err(LowerError(format!("`{}` was not linked", variable.name)));
            }
            Builtin::Layer | Builtin::ViewportIndex if stage == Stage::Fragment => {
                // The linker gives them slots where the stage before writes them.
                let zero = |lowerer: &mut Self, _| lowerer.emit.constant(0, Ty::I32);
                return Ok(self.inputs(variable, types, zero));
            }
            Builtin::Layer => |_| vec![Output::Layer],
            Builtin::ViewportIndex => |_| vec![Output::ViewportIndex],
            Builtin::PrimitiveId if stage == Stage::Geometry => |_| vec![Output::PrimitiveId],
            Builtin::PrimitiveId => {
                let first = VARYING_PRIMITIVE_ID;
                self.emit.builder.module_mut().primitive_id = Some(first);
                return Ok(self.varying_input(variable, types, first, Interpolation::Flat));
            }
            Builtin::Varying(slot) => {
                if stage == Stage::Fragment {
                    let declared = variable.interface_qualifiers.interpolation;
                    let interpolation = declared.unwrap_or(Interpolation::Smooth);
                    return Ok(self.varying_input(variable, types, slot, interpolation));
                }
                let storage = self.new_storage(variable, types);
                if variable.written {
                    self.varying_output(&storage, types, slot, copies);
                }
                debug_assert!(slot < VARYING_BACK_COLOR + 8);
                return Ok(storage);
            }
            Builtin::State(state) => {
                let word = self.words.state(state);
                return Ok(VarStorage::Uniform(word, types.into()));
            }
            Builtin::States(array) => {
                return Ok(VarStorage::States(array, array.element(0).words(), types.into()));
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
            Builtin::CullDistance if stage == Stage::Fragment => {
                // The linker gives them slots where a stage before writes them.
                let zero = |lowerer: &mut Self, _| lowerer.emit.float(0.0);
                return Ok(self.inputs(variable, types, zero));
            }
            Builtin::CullDistance => |at| vec![Output::CullDistance(at as u8)],
            Builtin::Position => |at| vec![Output::Position(at as u8)],
            Builtin::PointSize => |_| vec![Output::PointSize],
            Builtin::FragDepth => |_| vec![Output::Depth],
            Builtin::FragStencilRef => |_| vec![Output::StencilReference],
            // Samples have one word.
            Builtin::SampleMask => |_| vec![Output::SampleMask],
            Builtin::FragColor => |at| {
                let component = at as u8;
                (0..MAX_DRAW_BUFFERS).map(|target| Output::Color { target, component }).collect()
            },
            // One draw buffer has a second colour.
            Builtin::SecondaryFragColor | Builtin::SecondaryFragData => {
                |at| vec![Output::SecondColor(at as u8)]
            }
            Builtin::FragData => |at| {
                let (target, component) = ((at / 4) as u8, (at % 4) as u8);
                debug_assert!(target < MAX_DRAW_BUFFERS);
                vec![Output::Color { target, component }]
            },
        };
        let storage = self.new_storage(variable, types);
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
