//! Drawing: from calls to commands of the driver.
//!
//! The modules in the order in which vertices pass through them: arrays and immediate mode collect
//! them, the draw calls check them, the stages are chosen, and the translation records commands.

mod again;
mod array_names;
pub(crate) mod arrays;
mod assembly;
pub(crate) mod calls;
pub(crate) mod counted;
pub(crate) mod ended;
pub(crate) mod fixed_words;
pub(crate) mod hints;
pub(crate) mod immediate;
mod indices;
pub(crate) mod interleaved;
mod keys;
pub(crate) mod locked;
pub(crate) mod packed;
mod primitives;
mod reach;
pub(crate) mod rect;
pub(crate) mod repeat;
pub(crate) mod restart;
pub(crate) mod runs;
pub(crate) mod stages;
pub(crate) mod translate;
mod words;

use crate::context::Context;
use crate::context::debug::Output;
use crate::feedback::shade::{Outputs, Single};
use crate::fixed::FixedModules;
use crate::pixels::rectangle::RectangleModules;
use fixed_words::FixedWords;
use keys::UnitsSeen;
use rasterizer::driver::{
    Attachment, Command, CommandBuffer, Counter, Device, Image, PassDesc, Pipeline, PipelineDesc,
    RasterState, Rect, ShaderModule, VertexBinding, Viewport, Visibility,
};
use stages::Textures;
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
    device: Arc<Device>,
    commands: CommandBuffer,
    /// The pass that is open.
    pass: Option<PassDesc>,
    /// What the recorded passes write to.
    written: Vec<Image>,
    /// How many draws were ever recorded.
    pub draws: u64,
    /// The bytes that the recorded commands hold, of those that came since the last submission.
    held: usize,
    /// What the open pass was last told.
    told: Told,
    pipelines: HashMap<PipelineDesc, Pipeline>,
    pub fixed: FixedModules,
    fixed_words: FixedWords,
    /// What stages without textures have.
    no_textures: Textures,
    units_seen: UnitsSeen,
    /// The version of the units, and where messages went, when it was last looked whether a texture
    /// is bound though nothing is switched on.
    nothing_enabled: Option<(u64, Output)>,
    /// The memory of a draw's uniform words.
    words: Vec<u32>,
    /// The memory of a draw's bindings.
    bindings: Vec<VertexBinding>,
    variants: HashMap<stages::VariantKey, ShaderModule>,
    vertex_variants: HashMap<stages::VertexVariantKey, ShaderModule>,
    /// Stages of assembly programs, by what their uniform words are moved by.
    moved: Vec<(ShaderModule, u32, ShaderModule)>,
    /// Whether anything is seen of what was submitted since the last picture was taken.
    sight: Visibility,
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
struct Told {
    pipeline: Option<PipelineDesc>,
    /// The attributes that the pipeline reads, bit by location.
    attributes: u64,
    words: Option<Arc<[u32]>>,
    /// Of the vertex and of the fragment stage.
    textures: Option<[Textures; 2]>,
    raster: Option<Arc<RasterState>>,
    viewport: Option<Viewport>,
    scissor: Option<Option<Rect>>,
    counter: Option<Counter>,
    /// The draw before, which others may repeat.
    repeat: Option<repeat::Repeat>,
    decided: Option<again::Decided>,
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
    fn is_full(&self) -> bool {
        self.commands.commands.len() >= MAX_COMMANDS || self.held >= MAX_HELD
    }

    /// The memory of uniform words, without any in it.
    fn no_words(&mut self) -> Vec<u32> {
        let mut words = std::mem::take(&mut self.words);
        words.clear();
        words
    }

    /// The memory of bindings, without any in it.
    fn no_bindings(&mut self) -> Vec<VertexBinding> {
        let mut bindings = std::mem::take(&mut self.bindings);
        bindings.clear();
        bindings
    }

    /// Records a command into the open pass.
    pub fn push(&mut self, command: Command) {
        self.commands.push(command);
    }

    fn end_pass(&mut self) {
        if self.pass.take().is_some() {
            self.commands.push(Command::EndPass);
        }
        self.told = Told::default();
    }
}

fn same_attachment(a: Option<&Attachment>, b: Option<&Attachment>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a.image.same(&b.image) && a.face == b.face && a.level == b.level,
        (None, None) => true,
        (Some(_), None) | (None, Some(_)) => false,
    }
}

fn same_pass(a: &PassDesc, b: &PassDesc) -> bool {
    (a.width, a.height, a.colors.len()) == (b.width, b.height, b.colors.len())
        && same_attachment(a.depth.as_ref(), b.depth.as_ref())
        && a.colors.iter().zip(&b.colors).all(|(a, b)| same_attachment(a.as_ref(), b.as_ref()))
}

/// Goes on with the open pass if it draws to the same attachments, else opens one.
pub(crate) fn begin_pass(context: &mut Context, pass: PassDesc) {
    let recorder = &mut context.recorder;
    if recorder.is_full() {
        submit(context);
    } else if recorder.pass.as_ref().is_some_and(|open| same_pass(open, &pass)) {
        return;
    }
    let recorder = &mut context.recorder;
    recorder.end_pass();
    for attachment in pass.colors.iter().chain([&pass.depth]).flatten() {
        if !recorder.written.iter().any(|image| image.same(&attachment.image)) {
            recorder.written.push(attachment.image.clone());
        }
    }
    recorder.push(Command::BeginPass(pass.clone()));
    recorder.pass = Some(pass);
}

/// Carries out what was recorded, if it writes to an image that is about to be read or changed.
pub(crate) fn settle(context: &mut Context, image: &Image) {
    if context.recorder.written.iter().any(|written| written.same(image)) {
        submit(context);
    }
}

/// Carries out everything that was recorded.
pub(crate) fn submit(context: &mut Context) {
    ended::draw_ended(context);
    context.recorder.end_pass();
    context.objects.syncs.signal();
    let mut commands = std::mem::take(&mut context.recorder.commands);
    context.recorder.held = 0;
    if commands.commands.is_empty() {
        return;
    }
    context.outdate_mirror();
    let result = context.recorder.device.submit(&commands);
    // Their memory is that of the next.
    commands.commands.clear();
    context.recorder.commands = commands;
    match result {
        Ok(report) => {
            context.recorder.sight.add(report.visibility);
            if !report.over_budget.is_empty() {
                context.debug.warn(
                    "a shader ran so long that its draw was left out: look for a loop that does \
                     not end"
                        .into(),
                );
            }
        }
        Err(error) => context.debug.warn(format!("the driver refused recorded draws: {error}")),
    }
    let written = std::mem::take(&mut context.recorder.written);
    context.objects.images_changed(|image| written.iter().any(|other| other.same(image)));
}
