//! Instruction sets and threads: the same bits, other times.

use super::super::draw::{corners, draw_corners, set_texture};
use super::super::stage::{Clock, Frame, Stage, device, one_thread};
use super::{Alternative, Alternatives, Choice, Cost, everywhere};
use crate::probe::ProbeError;
use gl_api::constants::*;
use gl_api::*;
use rasterizer::driver::{Device, DeviceDesc};
use std::sync::Arc;
use texunit::lanes::Isa;

/// Instruction sets.
pub const INSTRUCTION_SETS: Choice = Choice {
    name: "instruction-sets",
    what: "a trilinear floor at 70° by each instruction set, one thread; error against the picture of the first",
    cost: Cost::Time,
    alternatives: |side| {
        let mut devices = Vec::new();
        for isa in Isa::executions() {
            devices.push((
                isa.name().to_owned(),
                device(|desc| DeviceDesc { isa, threads: 1, ..desc })?,
            ));
        }
        by_devices(devices, Clock::Processor, side)
    },
};

/// Threads.
pub const THREADS: Choice = Choice {
    name: "threads",
    what: "a trilinear floor at 70° of twice the side by 1 to 4 threads, time that passes; error against the picture of one",
    cost: Cost::Time,
    alternatives: |side| {
        let mut devices = vec![("1 thread".to_owned(), one_thread()?)];
        for threads in [2, 4] {
            devices.push((
                format!("{threads} threads"),
                device(|desc| DeviceDesc { threads, ..desc })?,
            ));
        }
        by_devices(devices, Clock::Wall, 2 * side)
    },
};

fn by_devices(
    devices: Vec<(String, Arc<Device>)>,
    clock: Clock,
    side: usize,
) -> Result<Alternatives, ProbeError> {
    let scene = super::scene("floor-70", side)?;
    let mut all = Vec::new();
    for (name, device) in devices {
        let stage = Stage::new(&device, clock, side, || {
            set_texture(&scene, GL_LINEAR_MIPMAP_LINEAR, 1);
            glEnable(GL_TEXTURE_2D);
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
            let corners = corners(&scene);
            Frame::new(move || draw_corners(&corners))
        })?;
        all.push(Alternative::new(name, stage));
    }
    let reference = all[0].stage.picture(1)?;
    Ok(Alternatives { side, reference, counts: everywhere, all })
}
