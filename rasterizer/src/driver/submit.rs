//! The queue: runs a checked command buffer pass by pass.

use super::command::Command;
use super::pass::Pass;
use super::report::SubmitReport;
use super::resources::Resources;
use crate::threads::ThreadPool;

/// Runs checked commands.
pub fn run(resources: &Resources, thread_pool: &ThreadPool, commands: &[Command]) -> SubmitReport {
    let mut report = SubmitReport::default();
    let mut pass = None;
    for (index, command) in commands.iter().enumerate() {
        match command {
            Command::BeginPass(desc) => pass = Some(Pass::begin(resources, thread_pool, desc)),
            Command::EndPass => {
                if let Some(pass) = pass.take() {
                    pass.end(&mut report);
                }
            }
            Command::Clear { .. }
            | Command::BindPipeline(_)
            | Command::BindVertices(_)
            | Command::BindTextures { .. }
            | Command::BindGeometryTextures(_)
            | Command::SetUniforms(_)
            | Command::SetRaster(_)
            | Command::SetViewport(_)
            | Command::SetScissor(_)
            | Command::SetMoreViewports(_)
            | Command::Watch(_)
            | Command::SetCounter(_)
            | Command::SetBudget(_)
            | Command::SetFirstPrimitive(_)
            | Command::Draw { .. }
            | Command::DrawIndexed { .. } => {
                if let Some(pass) = pass.as_mut() {
                    pass.command(index, command, &mut report);
                }
            }
        }
    }
    report
}
