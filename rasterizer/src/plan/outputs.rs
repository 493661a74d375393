//! What a draw does with the attachments: tests, and which colours are written how.

use super::{LeaveOut, Pipeline};
use crate::attachment::{DepthFormat, component_bits};
use crate::desc::{Blend, DepthState, DepthWrite};
use crate::ir::Output;
use crate::output::{ColorPlan, DepthPlan, OpaqueBlocks, StencilPlan, Tests};
use texunit::format::{Encoding, Format};
use texunit::sampler::Compare;

/// The tests that a draw has to make.
pub(super) fn tests(pipeline: &Pipeline, format: Option<Format>, leave_out: LeaveOut) -> Tests {
    let desc = &pipeline.compiled().desc;
    let Some((stored, format)) = format.and_then(|f| Some((f, DepthFormat::of(f)?))) else {
        return Tests::default();
    };
    let matters = |state: &DepthState| {
        leave_out == LeaveOut::Nothing
            || state.test != Compare::Always
            || state.write == DepthWrite::On
    };
    let depth = desc.depth.filter(matters).map(|state| DepthPlan {
        format,
        test: state.test,
        write: state.write,
    });
    let stencil = desc.output.stencil.filter(|_| stored.has_stencil());
    let stencil = stencil.and_then(|state| match leave_out {
        LeaveOut::WithoutEffect => StencilPlan::new(&state),
        LeaveOut::Nothing => Some(StencilPlan { front: state.front, back: state.back }),
    });
    Tests { stencil, depth }
}

/// The attachments that a draw writes colours to.
pub(super) fn colors(
    pipeline: &Pipeline,
    formats: &[Option<Format>],
    leave_out: LeaveOut,
) -> Vec<ColorPlan> {
    let compiled = pipeline.compiled();
    let (desc, fragment) = (&compiled.desc, &compiled.fragment);
    let mut colors = Vec::new();
    for (target, state) in desc.colors.iter().enumerate() {
        let Some(format) = formats.get(target).copied().flatten() else { continue };
        let outputs = [0, 1, 2, 3]
            .map(|component| fragment.output(Output::Color { target: target as u8, component }));
        // Only target 0 has a second colour.
        let second = match target {
            0 => [0, 1, 2, 3].map(|component| fragment.output(Output::SecondColor(component))),
            _ => [None; 4],
        };
        let format = desc.output.srgb.format(format);
        let write = component_bits(format, state.mask);
        // A target that the shader never mentions is not written.
        let mentioned = desc.fragment.module().outputs.iter().any(
            |(o, _)| matches!(o, Output::Color { target: t, .. } if usize::from(*t) == target),
        );
        let is_opaque = leave_out == LeaveOut::WithoutEffect
            && fragment.is_one(Output::Color { target: target as u8, component: 3 })
            // Numbers of other formats show `1·s + 0·d`: it is no negative zero, and no number where `d` is infinite.
            && matches!(format.info().encoding, Encoding::Unorm | Encoding::Srgb);
        let replaces = |blend: &Blend| is_opaque && blend.replaces_where_opaque();
        let leaves_nothing = state.blend.is_some_and(|blend| blend.replaces_where_opaque());
        let opaque = match leave_out {
            LeaveOut::WithoutEffect if leaves_nothing => OpaqueBlocks::Replaced,
            LeaveOut::WithoutEffect | LeaveOut::Nothing => OpaqueBlocks::Blended,
        };
        if write != [0; 4] && mentioned {
            let logic_op = desc.output.logic_op;
            let blend = state.blend.filter(|blend| !replaces(blend));
            let plan = ColorPlan::new(target, [outputs, second], format, write, blend, logic_op);
            colors.push(ColorPlan { opaque, ..plan });
        }
    }
    colors
}
