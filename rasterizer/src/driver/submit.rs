//! The queue: runs a checked command buffer pass by pass.

use super::command::Command;
use super::pass::Pass;
use super::report::{FrameSpending, SubmitReport};
use super::resources::Resources;
use crate::threads::ThreadPool;

/// Runs checked commands.
pub fn run(
    resources: &Resources,
    thread_pool: &ThreadPool,
    commands: &[Command],
    spent: FrameSpending,
) -> SubmitReport {
    let mut report = SubmitReport { spent, ..SubmitReport::default() };
    let mut pass = None;
    for (index, command) in commands.iter().enumerate() {
        match command {
            Command::BeginPass(desc) => pass = Pass::begin(resources, thread_pool, desc),
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::desc::Rect;
    use crate::driver::command::ClearValue;
    use crate::driver::image::{Attachment, Image, PassDesc};
    use crate::driver::resources::DeviceDesc;
    use texunit::format::Format;
    use texunit::lanes::Isa;

    /// As where another context gives an image a smaller size after the commands were checked.
    #[test]
    fn a_pass_to_what_has_become_smaller_is_left_out() {
        let desc = DeviceDesc::new(Isa::BASELINE, 1);
        let images = [(200, 200), (70, 300), (8, 8)]
            .map(|(width, height)| Image::blank(Format::Rgba8, width, height, 1).expect("small"));
        let attachment = |image: &Image| Attachment::new(image.clone(), 0, 0);
        let clear = |target| Command::Clear {
            value: ClearValue::Color { target, value: [1.0; 4], mask: [true; 4] },
            area: Rect { x: 0, y: 0, width: 200, height: 200 },
        };
        for other in [1, 2] {
            let pass = PassDesc {
                colors: [0, other].map(|at| Some(attachment(&images[at]))).into(),
                depth: None,
                width: 200,
                height: 200,
                layers: 1,
                samples: 1,
            };
            let commands = [Command::BeginPass(pass), clear(0), clear(1), Command::EndPass];
            let resources = Resources::new(desc);
            run(&resources, &ThreadPool::CALLER_ONLY, &commands, FrameSpending::default());
        }
        for image in &images {
            let texels = image.texels();
            let level = texels.level(0, 0).expect("it exists");
            assert!(level.row_span([0, 0, 0], 8).iter().all(|&byte| byte == 0));
        }
    }
}
