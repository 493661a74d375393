//! Drawing: from calls to commands of the driver.
//!
//! The modules in the order in which vertices pass through them: arrays and immediate mode collect
//! them, the draw calls check them, the stages are chosen, and the translation records commands.

pub(crate) mod again;
pub(crate) mod depths;
pub(crate) mod elements;
pub(crate) mod fixed_words;
pub(crate) mod keys;
pub(crate) mod rectangle;
pub(crate) mod repeat;
pub(crate) mod stages;
pub(crate) mod vertex_stage;

use crate::context::debug::Output;
use crate::context::recorder::fixed_words::FixedWords;
use crate::context::recorder::keys::UnitsSeen;
use crate::context::recorder::rectangle::RectangleModules;
use crate::context::recorder::stages::Textures;
use crate::context::recorder::vertex_stage::{Outputs, Single};
use crate::generate::fixed::FixedModules;
use crate::objects::buffers::WaitingDraws;
use rasterizer::driver::{
    Command, CommandBuffer, Counter, Device, Image, PassDesc, Pipeline, PipelineDesc, RasterState,
    Rect, ShaderModule, VertexBinding, Viewport, Visibility,
};
use std::collections::HashMap;
use std::sync::Arc;
use texunit::lanes::Isa;

/// A command buffer of this many commands is submitted.
const MAX_COMMANDS: usize = 1 << 14;
/// So is one that holds so many bytes of textures and vertices that are new with it: they may be
/// deleted or replaced already, and then nothing but the waiting draws needs them.
const MAX_HELD: usize = 1 << 26;

/// What has been recorded and not submitted, and what was compiled for it.
#[derive(Debug)]
pub(crate) struct Recorder {
    pub device: Arc<Device>,
    pub commands: CommandBuffer,
    /// The pass that is open.
    pub pass: Option<PassDesc>,
    /// What the recorded passes write to.
    pub written: Vec<Image>,
    /// How many draws were ever recorded.
    pub draws: u64,
    /// The bytes that the recorded commands hold, of those that came since the last submission.
    pub held: usize,
    /// What the open pass was last told.
    pub told: Told,
    pub pipelines: HashMap<PipelineDesc, Pipeline>,
    pub fixed: FixedModules,
    pub fixed_words: FixedWords,
    /// What stages without textures have.
    pub no_textures: Textures,
    pub units_seen: UnitsSeen,
    /// The version of the units, and where messages went, when it was last looked whether a texture
    /// is bound though nothing is switched on.
    pub nothing_enabled: Option<(u64, Output)>,
    /// The memory of a draw's uniform words.
    pub words: Vec<u32>,
    /// The memory of a draw's bindings.
    pub bindings: Vec<VertexBinding>,
    pub variants: HashMap<stages::VariantKey, ShaderModule>,
    pub vertex_variants: HashMap<stages::VertexVariantKey, ShaderModule>,
    /// Stages of assembly programs, by what their uniform words are moved by.
    pub moved: Vec<(ShaderModule, u32, ShaderModule)>,
    /// Whether anything is seen of what was submitted since the last picture was taken.
    pub sight: Visibility,
    /// What counts the samples of draws.
    pub counter: Option<Counter>,
    pub rectangles: RectangleModules,
    /// Vertex stages that were compiled for what is not drawn.
    single: HashMap<(ShaderModule, Outputs), Arc<Single>>,
}

/// More vertex stages of what is not drawn than this are forgotten and compiled again.
const KEPT_SINGLE: usize = 64;

/// State that holds until the end of a pass and need not be recorded again.
#[derive(Debug, Default)]
pub(crate) struct Told {
    pub pipeline: Option<PipelineDesc>,
    /// The attributes that the pipeline reads, bit by location.
    pub attributes: u64,
    pub words: Option<Arc<[u32]>>,
    /// Of the vertex and of the fragment stage.
    pub textures: Option<[Textures; 2]>,
    pub raster: Option<Arc<RasterState>>,
    pub viewport: Option<Viewport>,
    pub scissor: Option<Option<Rect>>,
    pub counter: Option<Counter>,
    /// The draw before, which others may repeat.
    pub repeat: Option<repeat::Repeat>,
    pub decided: Option<again::Decided>,
}

impl WaitingDraws for Recorder {
    fn hold(&mut self, bytes: usize) {
        self.hold(bytes);
    }

    fn draws(&self) -> u64 {
        self.draws
    }
}

impl Recorder {
    pub fn new(device: Arc<Device>) -> Self {
        Self {
            device,
            commands: CommandBuffer::new(),
            pass: None,
            written: Vec::new(),
            draws: 0,
            held: 0,
            told: Told::default(),
            pipelines: HashMap::new(),
            fixed: FixedModules::default(),
            fixed_words: FixedWords::default(),
            no_textures: Arc::new([]),
            units_seen: UnitsSeen::default(),
            nothing_enabled: None,
            words: Vec::new(),
            bindings: Vec::new(),
            variants: HashMap::new(),
            vertex_variants: HashMap::new(),
            moved: Vec::new(),
            sight: Visibility::default(),
            counter: None,
            rectangles: RectangleModules::default(),
            single: HashMap::new(),
        }
    }

    /// A vertex stage with some of its outputs, to run it for what is not drawn.
    pub fn single_vertex(&mut self, module: &ShaderModule, outputs: Outputs) -> Arc<Single> {
        if self.single.len() >= KEPT_SINGLE {
            self.single.clear();
        }
        let stage = self.single.entry((module.clone(), outputs));
        Arc::clone(stage.or_insert_with(|| Arc::new(Single::new(module, outputs))))
    }

    /// The device that commands are submitted to.
    pub fn device(&self) -> Arc<Device> {
        Arc::clone(&self.device)
    }

    /// [`Device::copy`].
    pub fn copy(&self, from: &[u8], to: &mut [u8]) {
        self.device.copy(from, to);
    }

    /// The instruction set that the device's kernels are run with, and the context's own.
    pub fn isa(&self) -> Isa {
        self.device.desc().isa
    }

    /// Notes that what is recorded next holds so many bytes that nothing recorded before it does.
    pub fn hold(&mut self, bytes: usize) {
        self.held = self.held.saturating_add(bytes);
    }

    /// Whether anything is recorded and not submitted.
    #[cfg(test)]
    pub fn is_waiting(&self) -> bool {
        !self.commands.commands.is_empty()
    }

    /// Whether what waits is enough.
    pub(crate) fn is_full(&self) -> bool {
        self.commands.commands.len() >= MAX_COMMANDS || self.held >= MAX_HELD
    }

    /// The memory of uniform words, without any in it.
    pub(crate) fn no_words(&mut self) -> Vec<u32> {
        let mut words = std::mem::take(&mut self.words);
        words.clear();
        words
    }

    /// The memory of bindings, without any in it.
    pub(crate) fn no_bindings(&mut self) -> Vec<VertexBinding> {
        let mut bindings = std::mem::take(&mut self.bindings);
        bindings.clear();
        bindings
    }

    /// Records a command into the open pass.
    pub fn push(&mut self, command: Command) {
        self.commands.push(command);
    }

    pub(crate) fn end_pass(&mut self) {
        if self.pass.take().is_some() {
            self.commands.push(Command::EndPass);
        }
        self.told = Told::default();
    }
}
