//! A compiled stage, and what of it a draw computes once.

use super::allocate::Layout;
use super::attribute_dependencies::{self, AttributeSet};
use super::inst::{Inst, SampleInst};
use super::native::NativeCodes;
use super::preamble::Preamble;
use super::product::TexelProduct;
use super::repeated_lookups::Repeat;
use super::{FactSources, Facts, SideVaryings};
use super::{
    allocate, constant_outputs, fuse, lower, optimize, repeated_lookups, schedule, shared_axes,
};
use crate::ir::{Block, FunctionTable, GeometryInterface, Input, Module, Output, Stmt};
use std::fmt::Write;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use texunit::lanes::Isa;
use texunit::plan::SamplePlan;
use texunit::sample::Addresses;

/// A compiled stage.
#[derive(Debug)]
pub struct Program {
    /// The identity of the program, unique.
    pub(super) id: u64,
    /// Of the module before and after it was optimized.
    pub(super) statements: [usize; 2],
    pub(super) code: Vec<Inst>,
    /// Machine code of runs of `code`.
    pub(super) native: NativeCodes,
    /// By instruction: its index in the order of the source.
    pub(super) source_order: Vec<u32>,
    pub(super) layout: Layout,
    pub(super) preamble: Preamble,
    pub(super) inputs: Vec<Input>,
    /// And the attribute components that each depends on.
    pub(super) outputs: Vec<(Output, AttributeSet)>,
    /// Those that are 1 in every lane.
    pub(super) ones: Vec<Output>,
    pub(super) textures: Vec<u32>,
    pub(super) slots: u32,
    /// Of a geometry program: its primitives, and what its vertices hold.
    pub(super) geometry: Option<GeometryInterface>,
    pub(super) discards: bool,
    cost_without_textures: u64,
    pub(super) queries_lod: bool,
    pub(super) reads_uniforms: bool,
    /// Whether it matters which lanes execute.
    pub(super) masked: bool,
    /// Whether any of it may run several times.
    pub(super) has_loops: bool,
    /// Register files that one run may fill.
    pub(super) files: usize,
    pub(super) product: Option<TexelProduct>,
    /// The lookups that may reuse texel addresses of the one before.
    pub(super) repeats: Vec<Repeat>,
    /// Whether lookups reuse what others leave in their scratch.
    pub(super) keeps_lookup_scratch: bool,
}

/// The most register files: batches that run together.
pub const MAX_REGISTER_FILES: usize = 4;

/// As many registers as files may have together, so that they stay in the first cache.
const MAX_TOTAL_REGISTERS: usize = 96;

/// The values of a program that are computed once per draw: its uniform words, and every value that depends on
/// nothing else.
#[derive(Debug)]
pub struct Prepared {
    /// The identity of the prepared values, unique.
    pub(super) id: u64,
    /// By word of the preamble.
    pub(super) words: Vec<u32>,
    /// The draw's uniform words, if the program indexes them per lane.
    pub(super) uniforms: Vec<u32>,
    /// The repeated lookups of the program that reuse texel addresses, bit by number.
    pub(super) reused_addresses: u64,
    /// By instruction: the operations of the code before it; empty if the program has no loops.
    pub(super) operations: Vec<u64>,
}

impl Prepared {
    /// The identity of the prepared values, unique.
    pub fn id(&self) -> u64 {
        self.id
    }

    /// The operations of the code from one instruction to another, in additions of 64 lanes.
    #[inline(always)]
    pub(super) fn operations(&self, from: usize, to: usize) -> u64 {
        match (self.operations.get(from), self.operations.get(to)) {
            (Some(from), Some(to)) => to - from,
            (None, _) | (_, None) => 0,
        }
    }

    /// Whether the texel addresses of a lookup are computed or reused.
    #[inline(always)]
    pub(super) fn addresses(&self, sample: &SampleInst) -> Addresses {
        match sample.repeat {
            Some(number) if self.reused_addresses >> number & 1 == 1 => Addresses::Reuse,
            Some(_) | None => Addresses::Compute,
        }
    }

    /// Whether both have equal values for a program.
    pub fn has_values_of(&self, other: &Self) -> bool {
        (&self.words, &self.uniforms, self.reused_addresses)
            == (&other.words, &other.uniforms, other.reused_addresses)
    }
}

/// By which formula lookups with an implicit level of detail have it (GL 2.1, section 3.8.8).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LevelOfDetail {
    /// From the derivatives along x and y.
    Polygons,
    /// Of lines from the derivative along the line, else as of polygons.
    Lines,
    /// Of points, pixel rectangles and bitmaps, whose coordinates are the same everywhere: 1, not what derivatives of 0 give.
    UnitScaleFactor,
}

/// A module that is optimized by itself, and not lowered.
pub(crate) struct OptimizedModule {
    pub module: Module,
    /// How many statements it had before.
    statements_before: usize,
}

impl OptimizedModule {
    /// Optimizes `module`, keeping only the outputs for which `keep` holds. The module has been validated.
    pub fn new(module: &Module, keep: impl Fn(Output) -> bool) -> Self {
        let mut module = module.clone();
        let before = statements(&module);
        module.outputs.retain(|(output, _)| keep(*output));
        retain_emitted(&mut module, keep);
        optimize::optimize(&mut module);
        Self { module, statements_before: before }
    }

    /// Hoists what vertices can compute as well to `vertex`, the module of the vertex stage that this one runs with;
    /// `None` where there is nothing to hoist.
    pub fn hoist_to_vertex(&mut self, vertex: &Module) -> Option<Module> {
        optimize::hoist_to_vertex(vertex, &mut self.module)
    }

    /// Gives its lookups the level of detail.
    pub fn finish(&mut self, lod: LevelOfDetail) {
        optimize::finish(&mut self.module, lod);
    }

    /// Makes one varying of those that it selects by facing. It must be finished.
    pub fn merge_sides(&mut self) -> Vec<SideVaryings> {
        optimize::merge_sides(&mut self.module)
    }

    /// Lowers it, and returns the module that was lowered.
    pub fn lower(self) -> (Program, Module) {
        let left = statements(&self.module);
        let program = Program {
            statements: [self.statements_before, left],
            ..Program::lowered(&self.module, Fusing::On)
        };
        (program, self.module)
    }
}

/// Keeps of what a geometry module emits only the outputs for which `keep` holds.
fn retain_emitted(module: &mut Module, keep: impl Fn(Output) -> bool) {
    fn block(stmts: &mut Block, kept: &[bool]) {
        for stmt in stmts {
            match stmt {
                Stmt::EmitVertex(values) => {
                    let mut kept = kept.iter();
                    values.retain(|_| kept.next() == Some(&true));
                }
                Stmt::If { accept: a, reject: b, .. } | Stmt::Loop { body: a, continuing: b } => {
                    block(a, kept);
                    block(b, kept);
                }
                Stmt::Scope(body) => block(body, kept),
                Stmt::Eval(_)
                | Stmt::Store { .. }
                | Stmt::StoreAt { .. }
                | Stmt::Break
                | Stmt::Continue
                | Stmt::Leave
                | Stmt::Discard
                | Stmt::EndPrimitive => {}
            }
        }
    }
    let Some(interface) = &mut module.geometry else { return };
    let kept: Vec<bool> = interface.outputs.iter().map(|output| keep(*output)).collect();
    interface.outputs.retain(|output| keep(*output));
    block(&mut module.body, &kept);
}

/// How many statements a module has.
fn statements(module: &Module) -> usize {
    let mut count = 0;
    module.body.iter().for_each(|stmt| stmt.walk(&mut |_| count += 1));
    count
}

/// Whether operations are fused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fusing {
    On,
    #[cfg(test)]
    Off,
}

/// Tells programs and draws apart, so that a machine knows what its registers hold. Never 0.
fn identity() -> u64 {
    static NEXT: AtomicU64 = AtomicU64::new(1);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

impl Program {
    /// Optimizes and lowers `module`, keeping only the outputs for which `keep` holds.
    /// The module has been validated.
    pub fn new(module: &Module, keep: impl Fn(Output) -> bool) -> Self {
        let mut module = OptimizedModule::new(module, keep);
        module.finish(LevelOfDetail::Polygons);
        module.lower().0
    }

    /// The values of the module that this program was lowered from of which a draw knows facts.
    pub(crate) fn fact_sources(&self, module: &Module) -> FactSources {
        FactSources::of(module, &self.preamble)
    }

    /// The program of a module that was finished before, by what is known of a draw; `None` where that leaves nothing
    /// out.
    pub(crate) fn specialized(
        &self,
        module: &Module,
        sources: &FactSources,
        facts: &Facts,
    ) -> Option<Self> {
        let mut module = sources.apply(facts, module);
        optimize::specialize(&mut module, facts);
        let program = Self {
            statements: [self.statements[0], statements(&module)],
            ..Self::lowered(&module, Fusing::On)
        };
        let has_tables = program
            .code
            .iter()
            .any(|inst| matches!(inst, Inst::Tabulated { table: FunctionTable::OfByte(_), .. }));
        let is_better =
            program.code.len() < self.code.len() || program.ones != self.ones || has_tables;
        is_better.then_some(program)
    }

    /// The facts of a draw with these prepared values, where the program depends on uniform words, and textures.
    pub(crate) fn facts(
        &self,
        sources: &FactSources,
        prepared: Option<&Prepared>,
        textures: &[Option<Arc<SamplePlan>>],
    ) -> Facts {
        let words = prepared.map_or(&[][..], |prepared| &prepared.words);
        sources.facts(words, &self.textures, textures)
    }

    /// Lowers `module` as it stands.
    pub(super) fn lowered(module: &Module, fusing: Fusing) -> Self {
        let mut lowered = lower::lower(module);
        lowered.source_order = (0..lowered.code.len() as u32).collect();
        if fusing == Fusing::On {
            fuse::run(&mut lowered);
            schedule::run(&mut lowered);
        }
        let mut layout = allocate::allocate(&mut lowered);
        let outputs = lowered.outputs.iter().map(|&(output, _)| output);
        let product = TexelProduct::of(&lowered.code, &mut layout, outputs);
        let repeats = repeated_lookups::find(&mut lowered.code);
        let keeps_axes = shared_axes::mark(&mut lowered.code);
        let cost_without_textures = lowered.code.iter().map(|inst| u64::from(inst.cost(&[]))).sum();
        Self {
            id: identity(),
            statements: [0; 2],
            product,
            masked: lowered.code.iter().any(Inst::uses_mask),
            has_loops: lowered.code.iter().any(Inst::repeats),
            files: files(&lowered.code, &layout),
            code: lowered.code,
            native: NativeCodes::default(),
            source_order: lowered.source_order,
            layout,
            preamble: lowered.preamble,
            inputs: lowered.inputs,
            outputs: attribute_dependencies::of_outputs(module),
            ones: constant_outputs::ones(module),
            textures: lowered.textures,
            slots: lowered.slots,
            geometry: module.geometry.clone(),
            discards: lowered.discards,
            queries_lod: lowered.queries_lod,
            reads_uniforms: lowered.reads_uniforms,
            keeps_lookup_scratch: keeps_axes || !repeats.is_empty(),
            repeats,
            cost_without_textures,
        }
    }

    /// The inputs that the program reads, each once. Their order is that of [`crate::shader::Machine::input_mut`].
    pub fn inputs(&self) -> &[Input] {
        &self.inputs
    }

    /// The outputs that the program writes, each once. Their order is that of [`crate::shader::Machine::output`].
    pub fn outputs(&self) -> impl ExactSizeIterator<Item = Output> {
        self.outputs.iter().map(|&(output, _)| output)
    }

    /// Where this output is among [`Self::outputs`].
    pub fn output(&self, wanted: Output) -> Option<usize> {
        self.outputs().position(|output| output == wanted)
    }

    /// Whether an output is 1 in every lane.
    pub fn is_one(&self, output: Output) -> bool {
        self.ones.contains(&output)
    }

    /// Whether a varying that it writes is the same at every vertex, if those of `arrays` are all the
    /// components of attributes that vertices have for themselves. One that it does not write is.
    pub(crate) fn is_constant(&self, slot: u16, arrays: AttributeSet) -> bool {
        let sources = self.outputs.iter().find(|(output, _)| *output == Output::Varying(slot));
        sources.is_none_or(|(_, sources)| !sources.meet(arrays))
    }

    /// Of a geometry program: its primitives, and what its vertices hold.
    pub fn geometry(&self) -> Option<&GeometryInterface> {
        self.geometry.as_ref()
    }

    /// Whether all of it runs once, whatever lanes hold.
    pub fn is_straight(&self) -> bool {
        self.code.iter().all(Inst::is_straight)
    }

    /// Whether any of it may run several times.
    pub fn has_loops(&self) -> bool {
        self.has_loops
    }

    /// By instruction, and at the end of the code: the operations of the code before it.
    fn operations(&self, textures: &[Option<Arc<SamplePlan>>]) -> Vec<u64> {
        let mut before = 0;
        let sums = self.costs(textures).map(|cost| {
            before += cost;
            before
        });
        std::iter::once(0).chain(sums).collect()
    }

    /// About how many additions of 64 lanes a batch takes as long as, with each loop run once. The textures are those of
    /// the draw.
    pub fn cost(&self, textures: &[Option<Arc<SamplePlan>>]) -> u64 {
        self.costs(textures).sum()
    }

    /// [`Self::cost`] as if no texture were bound; at least 1.
    pub(crate) fn cost_without_textures(&self) -> u64 {
        self.cost_without_textures.max(1)
    }

    /// By instruction.
    fn costs(&self, textures: &[Option<Arc<SamplePlan>>]) -> impl Iterator<Item = u64> {
        self.code.iter().map(|inst| u64::from(inst.cost(textures)))
    }

    /// Whether what it computes depends on uniform words.
    pub fn depends_on_uniforms(&self) -> bool {
        self.reads_uniforms || self.preamble.reads_uniforms()
    }

    /// How many batches may run together, see [`crate::shader::Machine::run_files`].
    pub fn register_files(&self) -> usize {
        self.files
    }

    /// What it is the product of, if it is one.
    pub fn product(&self) -> Option<&TexelProduct> {
        self.product.as_ref()
    }

    /// Whether any lane can be thrown away.
    pub fn discards(&self) -> bool {
        self.discards
    }

    /// Whether it queries levels of detail, which must then be exact even if no texture of the draw needs them.
    pub fn queries_lod(&self) -> bool {
        self.queries_lod
    }

    /// The texture slots that the program samples, ascending.
    pub fn texture_slots(&self) -> &[u32] {
        &self.textures
    }

    /// Whether what it computes in a lane depends on the neighbours in the quad; `needs_lod` says
    /// which texture slots need a level of detail.
    pub fn reads_neighbours(&self, needs_lod: impl Fn(u32) -> bool) -> bool {
        self.code.iter().any(|inst| {
            matches!(inst, Inst::Derivative { .. })
                || matches!(inst, Inst::Sample(sample) if sample.reads_neighbours(&needs_lod))
        })
    }

    /// One line that says what the program became.
    pub fn describe(&self) -> String {
        let mut line = format!(
            "{} statements, {} optimized, {} instructions, {} registers, {} values once per draw",
            self.statements[0],
            self.statements[1],
            self.code.len(),
            self.layout.registers,
            self.preamble.operations(),
        );
        for slot in &self.textures {
            let _ = write!(line, ", samples slot {slot}");
        }
        line
    }

    /// Computes what depends on uniforms only, and decides what depends on textures: those of the runs. Missing words
    /// read as zero.
    pub fn prepare(
        &self,
        isa: Isa,
        uniforms: &[u32],
        textures: &[Option<Arc<SamplePlan>>],
    ) -> Prepared {
        // Scalar steps are the same on every instruction set.
        let _ = isa;
        Prepared {
            reused_addresses: repeated_lookups::reused_addresses(&self.repeats, textures),
            id: identity(),
            words: self.preamble.run(uniforms),
            operations: if self.has_loops() { self.operations(textures) } else { Vec::new() },
            uniforms: if self.reads_uniforms { uniforms.to_vec() } else { Vec::new() },
        }
    }
}

/// How many batches a program may run for together: where instructions depend on which lanes execute, or
/// on what lanes hold, on their own.
fn files(code: &[Inst], layout: &Layout) -> usize {
    match code.iter().all(Inst::is_straight) {
        true => {
            (MAX_TOTAL_REGISTERS / layout.registers.max(1) as usize).clamp(1, MAX_REGISTER_FILES)
        }
        false => 1,
    }
}
