//! What a command buffer must keep to: checked whole before any of it runs.

use super::command::{ClearValue, Command};
use super::image::{AttachmentInfo, PassDesc};
use super::report::SubmitError;
use crate::attachment::is_attachable;
use crate::desc::{MAX_VIEWPORTS, Viewport};

/// Checks the order and the ranges of commands.
pub fn check(commands: &[Command]) -> Result<(), SubmitError> {
    let mut pass: Option<&PassDesc> = None;
    let mut pipeline = false;
    let mut viewport = false;
    for (index, command) in commands.iter().enumerate() {
        let fail = |rule: &str| Err(SubmitError { index, rule: rule.to_owned() });
        if pass.is_none() && !matches!(command, Command::BeginPass(_)) {
            return fail("only BeginPass may stand outside a pass");
        }
        match command {
            Command::BeginPass(desc) => {
                if pass.is_some() {
                    return fail("BeginPass: the pass before it was not ended");
                }
                if let Err(rule) = check_pass(desc) {
                    return fail(&rule);
                }
                (pass, pipeline, viewport) = (Some(desc), false, false);
            }
            Command::EndPass => pass = None,
            Command::Draw { .. } | Command::DrawIndexed { .. } => {
                if !pipeline {
                    return fail("a draw needs BindPipeline before it in the pass");
                }
                if !viewport {
                    return fail("a draw needs SetViewport before it in the pass");
                }
            }
            Command::BindPipeline(_) => pipeline = true,
            Command::SetViewport(v) => {
                if !is_valid(v) {
                    return fail(
                        "SetViewport: numbers must be finite, at most 32768, sizes not negative",
                    );
                }
                viewport = true;
            }
            Command::SetMoreViewports(all) => {
                if all.len() >= MAX_VIEWPORTS || !all.iter().all(|v| is_valid(&v.viewport)) {
                    return fail(
                        "SetMoreViewports: at most 15; numbers must be finite, at most 32768, \
                         sizes not negative",
                    );
                }
            }
            Command::Clear { value, .. } => {
                let nan = match value {
                    ClearValue::Color { .. }
                    | ClearValue::Texel { .. }
                    | ClearValue::Stencil { .. } => false,
                    ClearValue::Depth(depth) => depth.is_nan(),
                };
                if nan {
                    return fail("Clear: the depth is NaN");
                }
            }
            Command::SetRaster(raster) => {
                if let Some(rule) = raster.fault() {
                    return fail(rule);
                }
            }
            Command::BindVertices(_)
            | Command::BindTextures { .. }
            | Command::BindGeometryTextures(_)
            | Command::SetUniforms(_)
            | Command::SetScissor(_)
            | Command::Watch(_)
            | Command::SetCounter(_)
            | Command::SetBudget(_)
            | Command::SetFirstPrimitive(_) => {}
        }
    }
    if pass.is_some() {
        return Err(SubmitError {
            index: commands.len(),
            rule: "the last pass was not ended".into(),
        });
    }
    Ok(())
}

fn is_valid(v: &Viewport) -> bool {
    let all = [v.x, v.y, v.width, v.height, v.near, v.far];
    let fits = |v: f32| v.is_finite() && v.abs() <= 32768.0;
    all.into_iter().all(fits) && v.width >= 0.0 && v.height >= 0.0
}

fn check_pass(desc: &PassDesc) -> Result<(), String> {
    let attachments = desc
        .colors
        .iter()
        .flatten()
        .map(|a| (a, "colour"))
        .chain(desc.depth.iter().map(|a| (a, "depth")));
    let mut all_samples = None;
    let behind = desc.layers.max(1) - 1;
    for (attachment, kind) in attachments {
        if attachment.layer(behind).is_none_or(|last| last.info().is_none()) {
            return Err(format!(
                "BeginPass: the {kind} attachment has no level {} of {} layers from {} on",
                attachment.level, desc.layers, attachment.face
            ));
        }
        let info = attachment.info();
        let Some(AttachmentInfo { format, width, height, samples }) = info else {
            return Err(format!(
                "BeginPass: the {kind} attachment has no level {} of face or slice {}",
                attachment.level, attachment.face
            ));
        };
        if *all_samples.get_or_insert(samples) != samples {
            return Err(format!(
                "BeginPass: the {kind} attachment has {samples} samples, others have another number"
            ));
        }
        if width < desc.width || height < desc.height {
            return Err(format!(
                "BeginPass: the {kind} attachment is {width}×{height}, smaller than the pass's {}×{}",
                desc.width, desc.height
            ));
        }
        if format.is_depth() != (kind == "depth") || !is_attachable(format) {
            return Err(format!("BeginPass: {format:?} is no format of a {kind} attachment"));
        }
    }
    Ok(())
}
