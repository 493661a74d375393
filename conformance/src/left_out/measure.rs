//! Runs features: plans, pictures and times.

use super::feature::{Feature, Rule};
use super::plan::PlanFound;
use super::scene::SIDE;
use super::timing::Timing;
use crate::probe::{OwnContext, ProbeError};
use cpu_time::ThreadTime;
use gl_api::*;
use rasterizer::driver::{Device, DeviceDesc, Explain, LeaveOut};
use serde::Serialize;
use std::sync::Arc;

/// What was found of a feature.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The feature's name.
    pub name: &'static str,
    /// What is asked for.
    pub what: &'static str,
    /// The times with it and without.
    pub timing: Timing,
    /// The times of other libraries; why there are none.
    pub peers: Vec<Result<Timing, String>>,
    /// How many bytes of the pictures differ, of the first frames and of the third ones.
    pub different: usize,
    /// How far they lie apart at most.
    pub largest: u8,
    /// What the plan says.
    pub plan: PlanFound,
    /// Why the plan may do more.
    pub allowance: Option<&'static str>,
}

impl Row {
    /// Whether pictures are equal and the plan does no more than it may.
    pub fn passes(&self) -> bool {
        let is_left_out = self.plan == PlanFound::SameWork || self.allowance.is_some();
        self.different == 0 && is_left_out
    }
}

/// The work of a stage, in errors.
const AFTER: &str = "a frame of a feature";

/// One scene in a context of its own.
struct Stage {
    context: OwnContext,
    frame: fn(),
}

impl Stage {
    fn new(setup: fn(), frame: fn(), device: &Arc<Device>) -> Result<Self, ProbeError> {
        let mut context = OwnContext::new(device, SIDE)?;
        context.run(AFTER, setup)?;
        Ok(Self { context, frame })
    }

    /// Seconds of the processor for a frame, of which there are `count`. The device has no threads but this one.
    fn seconds(&mut self, count: u32) -> Result<f64, ProbeError> {
        let frame = self.frame;
        self.context.run(AFTER, || {
            let start = ThreadTime::now();
            for _ in 0..count {
                frame();
                glFinish();
            }
            start.elapsed().as_secs_f64() / f64::from(count)
        })
    }

    fn picture(&mut self) -> Result<Vec<u8>, ProbeError> {
        self.context.picture(AFTER, self.frame)
    }
}

/// A device of one thread.
fn device(explain: Explain) -> Result<Arc<Device>, ProbeError> {
    device_of(|desc| DeviceDesc { explain, ..desc })
}

/// A device of one thread that is otherwise described by `change`.
fn device_of(change: impl Fn(DeviceDesc) -> DeviceDesc) -> Result<Arc<Device>, ProbeError> {
    let desc = DeviceDesc::from_env().map(|desc| change(DeviceDesc { threads: 1, ..desc }));
    let device = desc.and_then(Device::new);
    device.map(Arc::new).map_err(|error| ProbeError::Context(error.to_string()))
}

/// The plans of the third frame of a scene: decisions that follow from the frames before have been taken.
fn plans(setup: fn(), frame: fn()) -> Result<Vec<String>, ProbeError> {
    let device = device(Explain::Keep)?;
    let mut stage = Stage::new(setup, frame, &device)?;
    stage.picture()?;
    stage.picture()?;
    device.take_explanations();
    stage.picture()?;
    Ok(device.take_explanations())
}

/// The first frame of a feature's scene, and the third, for which decisions that follow from the frames before have been
/// taken; drawn by a device with this setting.
///
/// # Errors
/// As [`measure`].
pub fn pictures(feature: &Feature, leave_out: LeaveOut) -> Result<[Vec<u8>; 2], ProbeError> {
    let device = device_of(|desc| DeviceDesc { leave_out, ..desc })?;
    let mut stage = Stage::new(feature.asked, feature.asked_frame, &device)?;
    let first = stage.picture()?;
    stage.picture()?;
    Ok([first, stage.picture()?])
}

/// Draws a feature's frames in turns, so many rounds; none only compares plans and pictures.
///
/// # Errors
/// When there is no context, or a call sets the error flag.
pub fn measure(feature: &Feature, rounds: usize) -> Result<Row, ProbeError> {
    let plan = PlanFound::of(
        &plans(feature.plain, feature.plain_frame)?,
        &plans(feature.asked, feature.asked_frame)?,
    );
    let device = device(Explain::Off)?;
    let mut plain = Stage::new(feature.plain, feature.plain_frame, &device)?;
    let mut asked = Stage::new(feature.asked, feature.asked_frame, &device)?;
    // The first frame of a scene, and one for which shaders may have been compiled again.
    let (mut before, mut after) = (plain.picture()?, asked.picture()?);
    for stage in [&mut plain, &mut asked] {
        stage.picture()?;
    }
    before.extend(plain.picture()?);
    after.extend(asked.picture()?);
    let differences = before.iter().zip(&after).map(|(a, b)| a.abs_diff(*b));
    let different = differences.clone().filter(|difference| *difference > 0).count();
    let largest = differences.max().unwrap_or(0);
    let timing = Timing::of(|count| plain.seconds(count), |count| asked.seconds(count), rounds)?;
    Ok(Row {
        name: feature.name,
        what: feature.what,
        timing,
        peers: Vec::new(),
        different,
        largest,
        plan,
        allowance: match feature.rule {
            Rule::SameWork => None,
            Rule::MoreWork(reason) => Some(reason.words()),
        },
    })
}
