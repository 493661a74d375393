//! The device: which instruction set, how many threads, and the queue.

use super::command::CommandBuffer;
use super::image::{Attachment, Image};
use super::sight::Sight;
use super::{check, submit};
use crate::attachment::{Part, Put, Storing};
use crate::raster::{ShapeLists, Worker};
use crate::shader::Machine;
use crate::threads::{Crew, Pool, Threads};
use crate::vertex::Geometry;
use parking_lot::Mutex;
use std::collections::BTreeSet;
use std::sync::Arc;
use texunit::image::{Image as Texels, Level};
use texunit::lanes::{Isa, IsaError};
use thiserror::Error;

/// From so many bytes on several threads copy them,
const WORTH_THREADS: usize = 1 << 20;
/// and so many at once.
const COPIED: usize = 1 << 18;

/// What a device is made from.
#[derive(Clone, Copy, Debug)]
pub struct DeviceDesc {
    /// The instruction set of every kernel.
    pub isa: Isa,
    /// How many threads shade tiles, with the one that asks; at least 1.
    pub threads: usize,
    /// How many instructions a batch of a shader may run before its draw is dropped.
    pub budget: u64,
    /// Whether each draw's plan is printed.
    pub explain: Explain,
}

/// Whether each draw's plan is printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Explain {
    /// It is not.
    #[default]
    Off,
    /// Each different plan once, to standard error.
    Print,
    /// Each different plan is kept for [`Device::take_explanations`].
    Keep,
}

impl DeviceDesc {
    /// The default budget.
    pub const BUDGET: u64 = 1 << 26;

    /// From `DETGL_ISA`, `DETGL_THREADS` and `DETGL_EXPLAIN`, else the widest instruction set,
    /// every core, and silence.
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
        let explain = match std::env::var("DETGL_EXPLAIN") {
            Ok(text) if text != "0" => Explain::Print,
            Ok(_) | Err(_) => Explain::Off,
        };
        Ok(Self { isa, threads, budget: Self::BUDGET, explain })
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

impl DeviceError {
    fn pool(error: impl std::error::Error) -> Self {
        Self::Pool(error.to_string())
    }
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
    /// Whether anything of its draws may be seen.
    pub sight: Sight,
}

/// A driver instance.
#[derive(Debug)]
pub struct Device {
    desc: DeviceDesc,
    threads: Threads,
    /// What runs vertex programs.
    pub(crate) machines: Pool<Machine>,
    /// The memory of its results.
    pub(crate) geometries: Pool<Geometry>,
    /// The memory of shapes.
    pub(crate) lists: Pool<ShapeLists>,
    /// What draws tiles.
    pub(crate) workers: Pool<Worker>,
    /// The plans seen so far.
    explained: Mutex<BTreeSet<String>>,
    kept: Mutex<Vec<String>>,
}

impl Device {
    /// Starts a device.
    ///
    /// # Errors
    /// When its threads cannot be started.
    pub fn new(desc: DeviceDesc) -> Result<Self, DeviceError> {
        let threads = Threads::start(desc.threads).map_err(DeviceError::pool)?;
        Ok(Self {
            desc,
            threads,
            machines: Pool::default(),
            geometries: Pool::default(),
            lists: Pool::default(),
            workers: Pool::default(),
            explained: Mutex::default(),
            kept: Mutex::default(),
        })
    }

    /// What it was made from.
    pub fn desc(&self) -> &DeviceDesc {
        &self.desc
    }

    /// Runs commands to their end. The result does not depend on the number of threads.
    ///
    /// # Errors
    /// When a command breaks a rule, or this process was forked from the device's and cannot start
    /// threads; then nothing was run.
    pub fn submit(&self, commands: &CommandBuffer) -> Result<SubmitReport, SubmitError> {
        check::check(&commands.commands)?;
        let crew = self.threads.crew().map_err(DeviceError::pool);
        let crew = crew.map_err(|error| SubmitError { index: 0, rule: error.to_string() })?;
        Ok(submit::run(self, &crew, &commands.commands))
    }

    /// Who stores what was drawn. Without threads the one that asks does it alone.
    fn crew(&self) -> Crew {
        self.threads.crew().unwrap_or(Crew::ALONE)
    }

    /// Copies bytes, by all threads where there are many: a client's go where the system often has yet to find
    /// memory, page by page, which takes longer than to copy them.
    ///
    /// # Panics
    /// When there are not as many.
    pub fn copy(&self, from: &[u8], to: &mut [u8]) {
        if from.len() < WORTH_THREADS {
            return to.copy_from_slice(from);
        }
        assert_eq!(from.len(), to.len());
        let mut pieces: Vec<_> = from.chunks(COPIED).zip(to.chunks_mut(COPIED)).collect();
        self.crew().share(
            &mut pieces,
            1,
            || (),
            |(), pieces| pieces.iter_mut().for_each(|(from, to)| to.copy_from_slice(from)),
        );
    }

    /// [`Image::texels`], faster of large ones.
    pub fn texels(&self, image: &Image) -> Texels {
        image.texels_by(&self.crew())
    }

    /// What an attachment names, as everything submitted leaves it, with one sample a pixel, which
    /// several are resolved to: a level, if it exists, and which slice of it.
    pub fn resolved(&self, attachment: &Attachment) -> Option<(Arc<Level>, usize)> {
        let Attachment { image, face, level } = attachment;
        let storing = Storing { isa: self.desc.isa, crew: &self.crew() };
        image.resolved_by(*face, *level, storing)
    }

    /// Puts a part of what an attachment names, as everything submitted leaves it, where a client has its
    /// rows, with one sample a pixel, which several are resolved to. What was drawn and has not been asked
    /// for since is not stored elsewhere for it. Nothing is put where nothing is attached.
    ///
    /// # Panics
    /// When a row has no room, or the part is not within the picture.
    pub fn read(&self, attachment: &Attachment, part: Part, rows: &mut [&mut [u8]], put: Put<'_>) {
        let Attachment { image, face, level } = attachment;
        let storing = Storing { isa: self.desc.isa, crew: &self.crew() };
        image.read_by((*face, *level), part, rows, put, storing);
    }

    /// Puts back what [`Image::each_sample`] gave, changed. Draws that were recorded earlier keep what
    /// they saw.
    pub fn set_each_sample(&self, attachment: &Attachment, samples: &Level) {
        let Attachment { image, face, level } = attachment;
        image.set_each_sample(*face, *level, samples, self.desc.isa);
    }

    /// The plans kept since the last call, each different one once ([`Explain::Keep`]).
    pub fn take_explanations(&self) -> Vec<String> {
        self.explained.lock().clear();
        std::mem::take(&mut self.kept.lock())
    }

    /// Takes note of a draw's plan.
    pub(crate) fn explain(&self, plan: &dyn Fn() -> String) {
        if self.desc.explain == Explain::Off {
            return;
        }
        let text = plan();
        if !self.explained.lock().insert(text.clone()) {
            return;
        }
        match self.desc.explain {
            Explain::Off => {}
            Explain::Print => eprintln!("draw\n{text}"),
            Explain::Keep => self.kept.lock().push(text),
        }
    }
}
