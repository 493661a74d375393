//! The recorder: the commands that are recorded and not submitted, and what draws keep for those that follow.
//!
//! These are the data; [`crate::draw`] has what works on them, in modules of the same names.

pub(crate) mod batching;
pub(crate) mod elements;
pub(crate) mod emitted_state;
pub(crate) mod fixed_function;
pub(crate) mod geometry_stage;
pub(crate) mod picture;
pub(crate) mod pixel_rectangle;
pub(crate) mod stages;
pub(crate) mod vertex_facts;
pub(crate) mod vertex_stage;

use crate::context::debug::Output;
use crate::context::recorder::emitted_state::EmittedState;
use crate::context::recorder::fixed_function::{FixedWords, UnitSummary};
use crate::context::recorder::picture::PictureDraws;
use crate::context::recorder::pixel_rectangle::PixelRectangleModules;
use crate::context::recorder::stages::Textures;
use crate::context::recorder::vertex_facts::VertexFacts;
use crate::context::recorder::vertex_stage::{Outputs, StandaloneStage};
use crate::generate::fixed::FixedModules;
use crate::objects::buffers::WaitingDraws;
use crate::objects::syncs::PendingFences;
use rasterizer::driver::{
    Command, CommandBuffer, Counter, Device, FrameSpending, Image, LeaveOut, PassDesc, Pipeline,
    PipelineDesc, ShaderModule, VertexBinding, Visibility,
};
use std::collections::HashMap;
use std::sync::Arc;
use texunit::lanes::Isa;

/// A command buffer of this many commands is submitted.
const MAX_COMMANDS: usize = 1 << 14;
/// So is one that holds this many bytes of textures and vertices that are new since the last submission: they may be
/// deleted or replaced already, and are kept for the recorded draws alone.
const MAX_HELD: usize = 1 << 26;

/// What has been recorded and not submitted, and what was compiled for it.
#[derive(Debug)]
pub(crate) struct Recorder {
    pub device: Arc<Device>,
    /// How long the shaders of a draw may run, if not as long as the device lets them.
    pub draw_budget: Option<u64>,
    /// What stopped draws have run in this frame.
    pub spent: FrameSpending,
    /// The number of the first primitive of the draws to come: not 0 after a primitive restart.
    pub first_primitive: u32,
    pub commands: CommandBuffer,
    /// The fences among the recorded commands.
    pub fences: PendingFences,
    /// The pass that is open.
    pub pass: Option<PassDesc>,
    /// What the recorded passes write to.
    pub written: Vec<Image>,
    /// How many draws were ever recorded.
    pub draws: u64,
    /// What is known of the vertices of the draw that is being recorded, or was last.
    pub facts: VertexFacts,
    /// Whether the alpha of its fragments is 1.
    pub is_opaque: bool,
    /// The bytes that the recorded commands hold, of those that came since the last submission.
    pub held: usize,
    /// The bytes of the attachments of the open pass that no recorded pass before it writes to. Once another pass begins,
    /// they are held for the recorded commands alone, as far as anyone can tell.
    pub attached: usize,
    /// The state that was last emitted to the open pass.
    pub emitted: EmittedState,
    pub pipelines: HashMap<PipelineDesc, Pipeline>,
    pub fixed: FixedModules,
    pub fixed_words: FixedWords,
    /// The textures of a stage that samples none.
    pub no_textures: Textures,
    pub unit_summary: UnitSummary,
    /// The version of the units, and whether messages were logged, at the last check for textures that are bound while
    /// no unit is enabled.
    pub nothing_enabled: Option<(u64, Output)>,
    /// The uniform words of the last draw, whose memory is used again.
    pub words: Vec<u32>,
    /// Empty; the memory of the last draw's bindings, which is used again.
    pub bindings: Vec<VertexBinding>,
    pub variants: HashMap<stages::VariantKey, ShaderModule>,
    pub vertex_variants: HashMap<stages::VertexVariantKey, ShaderModule>,
    /// Relocated stages of assembly programs: the module, its first uniform word, and the relocated module.
    pub moved: Vec<(ShaderModule, u32, ShaderModule)>,
    /// Whether anything is visible of what was submitted since the last picture was taken.
    pub visibility: Visibility,
    /// The draws since the last picture.
    pub picture: PictureDraws,
    /// The counter of the active occlusion query.
    pub counter: Option<Counter>,
    pub rectangles: PixelRectangleModules,
    /// Vertex stages that were compiled to run by themselves.
    standalone: HashMap<(ShaderModule, Outputs), Arc<StandaloneStage>>,
}

/// When there are this many stages that run by themselves, all are dropped.
const MAX_STANDALONE: usize = 64;

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
            draw_budget: None,
            spent: FrameSpending::default(),
            first_primitive: 0,
            commands: CommandBuffer::new(),
            fences: PendingFences::default(),
            pass: None,
            written: Vec::new(),
            draws: 0,
            facts: VertexFacts::default(),
            is_opaque: false,
            held: 0,
            attached: 0,
            emitted: EmittedState::default(),
            pipelines: HashMap::new(),
            fixed: FixedModules::default(),
            fixed_words: FixedWords::default(),
            no_textures: Arc::new([]),
            unit_summary: UnitSummary::default(),
            nothing_enabled: None,
            words: Vec::new(),
            bindings: Vec::new(),
            variants: HashMap::new(),
            vertex_variants: HashMap::new(),
            moved: Vec::new(),
            visibility: Visibility::default(),
            picture: PictureDraws::default(),
            counter: None,
            rectangles: PixelRectangleModules::default(),
            standalone: HashMap::new(),
        }
    }

    /// A vertex stage with some of its outputs, to be run by itself.
    pub fn standalone_stage(
        &mut self,
        module: &ShaderModule,
        outputs: Outputs,
    ) -> Arc<StandaloneStage> {
        if self.standalone.len() >= MAX_STANDALONE {
            self.standalone.clear();
        }
        let stage = self.standalone.entry((module.clone(), outputs));
        Arc::clone(stage.or_insert_with(|| Arc::new(StandaloneStage::new(module, outputs))))
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

    /// What draws leave out.
    pub fn leave_out(&self) -> LeaveOut {
        self.device.desc().leave_out
    }

    /// Adds to the bytes that recorded commands hold, which none recorded before does.
    pub fn hold(&mut self, bytes: usize) {
        self.held = self.held.saturating_add(bytes);
    }

    /// Whether anything is recorded and not submitted.
    #[cfg(test)]
    pub fn is_waiting(&self) -> bool {
        !self.commands.commands.is_empty()
    }

    /// Whether so much is recorded that it is to be submitted.
    pub(crate) fn is_full(&self) -> bool {
        self.commands.commands.len() >= MAX_COMMANDS || self.held >= MAX_HELD
    }

    /// An empty vector for uniform words, with memory of the last one.
    pub(crate) fn empty_words(&mut self) -> Vec<u32> {
        let mut words = std::mem::take(&mut self.words);
        words.clear();
        words
    }

    /// An empty vector for bindings, with memory of the last one.
    pub(crate) fn empty_bindings(&mut self) -> Vec<VertexBinding> {
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
        self.emitted = EmittedState::default();
    }
}
