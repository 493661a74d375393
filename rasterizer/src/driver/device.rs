//! The device: which instruction set, how many threads, and the queue.

use super::command::CommandBuffer;
use super::image::{Attachment, Image};
use super::report::{DeviceError, FrameSpending, SubmitError, SubmitReport};
use super::resources::{DeviceDesc, Resources};
use super::{check, submit};
use crate::attachment::{RowSpan, RowWriter, StoreContext};
use crate::threads::{ForkAwarePool, ThreadPool};
use std::sync::Arc;
use texunit::image::{Image as Texels, ImageError, Level};
use texunit::lanes::FloatEnv;

/// Copies of at least this many bytes use several threads,
const WORTH_THREADS: usize = 1 << 20;
/// each of which copies this many at a time.
const COPIED: usize = 1 << 18;

/// A driver instance.
#[derive(Debug)]
pub struct Device {
    threads: ForkAwarePool,
    resources: Resources,
}

impl Device {
    /// Starts a device.
    ///
    /// # Errors
    /// When its threads cannot be started.
    pub fn new(desc: DeviceDesc) -> Result<Self, DeviceError> {
        let threads = ForkAwarePool::start(desc.threads).map_err(DeviceError::pool)?;
        Ok(Self { threads, resources: Resources::new(desc) })
    }

    /// What it was made from.
    pub fn desc(&self) -> &DeviceDesc {
        &self.resources.desc
    }

    /// Runs commands to their end. The result does not depend on the number of threads.
    ///
    /// # Errors
    /// When a command breaks a rule, or this process was forked from the device's and cannot start
    /// threads; then nothing was run.
    pub fn submit(&self, commands: &CommandBuffer) -> Result<SubmitReport, SubmitError> {
        self.submit_in_frame(commands, FrameSpending::default())
    }

    /// As [`Self::submit`], in a frame whose earlier submissions have spent `spent`: [`SubmitReport::spent`] of the last.
    ///
    /// # Errors
    /// As [`Self::submit`].
    pub fn submit_in_frame(
        &self,
        commands: &CommandBuffer,
        spent: FrameSpending,
    ) -> Result<SubmitReport, SubmitError> {
        let _float_env = FloatEnv::enter();
        check::check(&commands.commands)?;
        let thread_pool = self.threads.thread_pool().map_err(DeviceError::pool);
        let thread_pool =
            thread_pool.map_err(|error| SubmitError { index: 0, rule: error.to_string() })?;
        Ok(submit::run(&self.resources, &thread_pool, &commands.commands, spent))
    }

    /// The thread pool that stores tiles; without threads the caller does it alone.
    fn thread_pool(&self) -> ThreadPool {
        self.threads.thread_pool().unwrap_or(ThreadPool::CALLER_ONLY)
    }

    /// Copies bytes, by all threads where there are many: a client's go where the system often has yet to find
    /// memory, page by page, which takes longer than to copy them.
    ///
    /// # Panics
    /// When the slices differ in length.
    pub fn copy(&self, from: &[u8], to: &mut [u8]) {
        if from.len() < WORTH_THREADS {
            return to.copy_from_slice(from);
        }
        assert_eq!(from.len(), to.len());
        let mut pieces: Vec<_> = from.chunks(COPIED).zip(to.chunks_mut(COPIED)).collect();
        self.thread_pool().for_each_chunk(
            &mut pieces,
            1,
            || (),
            |(), pieces| pieces.iter_mut().for_each(|(from, to)| to.copy_from_slice(from)),
        );
    }

    /// [`Image::texels`], faster of large ones.
    pub fn texels(&self, image: &Image) -> Texels {
        image.texels_with(&self.thread_pool())
    }

    /// [`Device::texels`] for lookups that compare depths and read one level: those of a large image that was drawn to are
    /// not stored in rows first, but gathered from the tiles of the attachment. While they are kept, a pass that draws to
    /// the image copies its tiles.
    pub fn compared_texels(&self, image: &Image) -> Texels {
        image.compared_texels_with(self.resources.desc.isa, &self.thread_pool())
    }

    /// What an attachment names, as everything submitted leaves it, with one sample a pixel, which
    /// several are resolved to: a level, and which slice of it.
    ///
    /// # Errors
    /// If it does not exist, or there is no memory for it.
    pub fn resolved(&self, attachment: &Attachment) -> Result<(Arc<Level>, usize), ImageError> {
        let _float_env = FloatEnv::enter();
        let context =
            StoreContext { isa: self.resources.desc.isa, thread_pool: &self.thread_pool() };
        attachment.image.resolved_with(attachment, context)
    }

    /// Writes a region of what an attachment names, as everything submitted leaves it, into the rows of a
    /// client, samples resolved. What was drawn and has not been asked
    /// for since is not stored elsewhere for it. Nothing is written where nothing is attached.
    ///
    /// # Panics
    /// When a row is too short, or the region is not within the image.
    pub fn read(
        &self,
        attachment: &Attachment,
        span: RowSpan,
        rows: &mut [&mut [u8]],
        writer: RowWriter<'_>,
    ) {
        let _float_env = FloatEnv::enter();
        let context =
            StoreContext { isa: self.resources.desc.isa, thread_pool: &self.thread_pool() };
        attachment.image.read_with(attachment, span, rows, writer, context);
    }

    /// Puts back what [`Attachment::each_sample`] gave, changed. Draws that were recorded earlier keep what
    /// they saw.
    pub fn set_each_sample(&self, attachment: &Attachment, samples: &Level) {
        let _float_env = FloatEnv::enter();
        attachment.image.set_each_sample(attachment, samples, self.resources.desc.isa);
    }

    /// The plans recorded since the last call, without duplicates ([`crate::driver::Explain::Keep`]).
    pub fn take_explanations(&self) -> Vec<String> {
        self.resources.take_explanations()
    }
}
