//! From the structured IR to flat instructions over virtual registers.
//!
//! Each value gets a virtual register; so does each element of a variable, those of one variable
//! in a row. [`super::allocate`] gives them real ones. The recursion is over the nesting of
//! blocks, which validation limits.

mod flow;

use super::compute::{Compute, OPERANDS};
use super::inst::{Inst, Reg, SampleInst, SampleLod, Slot, Target};
use super::maskless_stores::MasklessStores;
use super::preamble::Preamble;
use super::uniformity::Uniformity;
use crate::ir::{Access, Expr, Input, Lod, Module, Output, Sample, Stage, Ty, Value, Var};
use flow::{LoopPosition, OpenLoop, OpenScope};
use texunit::sample::AxisTexels;

/// What a virtual register holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum RegisterContent {
    /// A value; written once, in all lanes.
    Temp,
    /// A word of the preamble, the same in every lane and batch.
    Splat { word: u32 },
    /// An input of the program.
    Input { index: u32 },
    /// An element of a variable.
    Variable { var: Var },
}

/// A program over virtual registers.
#[derive(Debug, Default)]
pub(super) struct Lowered {
    pub code: Vec<Inst>,
    /// By instruction: its index in the order of the source.
    pub source_order: Vec<u32>,
    /// By virtual register.
    pub contents: Vec<RegisterContent>,
    pub preamble: Preamble,
    pub inputs: Vec<Input>,
    pub outputs: Vec<(Output, Reg)>,
    /// Every variable that is used: its first register and its length.
    pub variables: Vec<(Reg, u32)>,
    pub slots: u32,
    pub textures: Vec<u32>,
    pub discards: bool,
    pub queries_lod: bool,
    pub reads_uniforms: bool,
}

/// Lowers a valid module.
pub(super) fn lower(module: &Module) -> Lowered {
    let mut lowering = Lowering {
        module,
        out: Lowered::default(),
        values: vec![None; module.values.len()],
        samples: vec![None; module.values.len()],
        variables: vec![None; module.variables.len()],
        words: Vec::new(),
        joins: vec![Vec::new()],
        loops: Vec::new(),
        scopes: Vec::new(),
        slots: 0,
        nesting: 0,
        straight: true,
        maskless_stores: MasklessStores::of(module),
        outermost: 0,
        loop_position: None,
        uniformity: Uniformity::of(module),
        next_loop: 0,
        next_scope: 0,
    };
    for &(output, var) in &module.outputs {
        let reg = lowering.variable(var);
        lowering.out.outputs.push((output, reg));
    }
    lowering.block(&module.body);
    lowering.join();
    let mut out = lowering.out;
    out.textures.sort_unstable();
    out.textures.dedup();
    out
}

struct Lowering<'a> {
    module: &'a Module,
    out: Lowered,
    /// By value.
    values: Vec<Option<Reg>>,
    /// By value: the registers of a sample's components.
    samples: Vec<Option<[Reg; 4]>>,
    /// By variable: its first register.
    variables: Vec<Option<Reg>>,
    /// By word of the preamble.
    words: Vec<Option<Reg>>,
    /// By open block: the jumps that go to where its lanes join again.
    joins: Vec<Vec<usize>>,
    loops: Vec<OpenLoop>,
    scopes: Vec<OpenScope>,
    slots: u32,
    /// The number of enclosing blocks that only some lanes may execute.
    nesting: u32,
    /// Whether every lane of the run still executes, as far as the code shows.
    straight: bool,
    maskless_stores: MasklessStores,
    /// How many outermost loops were begun.
    outermost: u32,
    /// In an outermost loop without `continue`: the position of its statements.
    loop_position: Option<LoopPosition>,
    uniformity: Uniformity,
    next_loop: usize,
    next_scope: usize,
}

impl Lowering<'_> {
    fn register(&mut self, content: RegisterContent) -> Reg {
        self.out.contents.push(content);
        Reg(self.out.contents.len() as u32 - 1)
    }

    fn variable(&mut self, var: Var) -> Reg {
        if let Some(reg) = self.variables[var.0 as usize] {
            return reg;
        }
        let len = self.module.variable(var).len;
        let first = self.register(RegisterContent::Variable { var });
        for _ in 1..len {
            self.register(RegisterContent::Variable { var });
        }
        self.variables[var.0 as usize] = Some(first);
        self.out.variables.push((first, len));
        first
    }

    /// The register that holds a value.
    fn value(&mut self, value: Value) -> Reg {
        if let Some(reg) = self.values[value.0 as usize] {
            return reg;
        }
        let reg = if let Some(word) = self.out.preamble.word(self.module, value) {
            self.splat(word)
        } else if let Expr::Input(input) = self.module.expr(value) {
            self.input(*input)
        } else {
            self.register(RegisterContent::Temp)
        };
        self.values[value.0 as usize] = Some(reg);
        reg
    }

    fn splat(&mut self, word: u32) -> Reg {
        let at = word as usize;
        if self.words.len() <= at {
            self.words.resize(at + 1, None);
        }
        if let Some(reg) = self.words[at] {
            return reg;
        }
        let reg = self.register(RegisterContent::Splat { word });
        self.words[at] = Some(reg);
        reg
    }

    fn input(&mut self, input: Input) -> Reg {
        let found = self.out.inputs.iter().position(|other| *other == input);
        let index = found.unwrap_or_else(|| {
            self.out.inputs.push(input);
            self.out.inputs.len() - 1
        }) as u32;
        self.register(RegisterContent::Input { index })
    }

    fn emit(&mut self, inst: Inst) -> usize {
        self.out.code.push(inst);
        self.out.code.len() - 1
    }

    fn here(&self) -> Target {
        Target(self.out.code.len() as u32)
    }

    /// Points a jump at the next instruction.
    fn land(&mut self, jump: usize) {
        let here = self.here();
        if let Some(target) = self.out.code[jump].target_mut() {
            *target = here;
        }
    }

    /// Here the lanes of the innermost open block join again.
    fn join(&mut self) {
        for jump in self.joins.pop().unwrap_or_default() {
            self.land(jump);
        }
    }

    fn slot(&mut self) -> Slot {
        self.slots += 1;
        self.out.slots = self.out.slots.max(self.slots);
        Slot(self.slots - 1)
    }

    fn store(&mut self, out: Reg, from: Reg) {
        // Lanes that the run did not begin with may hold anything.
        if self.straight && self.nesting == 0 {
            self.emit(Inst::Move { out, from });
        } else {
            self.emit(Inst::Store { out, from });
        }
    }

    /// The element that a constant index reaches.
    fn constant_element(&mut self, var: Var, index: Value) -> Option<Reg> {
        let element = self.module.constant(index)?.min(self.module.variable(var).len - 1);
        Some(Reg(self.variable(var).0 + element))
    }

    fn store_at(&mut self, var: Var, index: Value, value: Value) {
        let from = self.value(value);
        if let Some(out) = self.constant_element(var, index) {
            return self.store(out, from);
        }
        let (base, len) = (self.variable(var), self.module.variable(var).len);
        let index = self.value(index);
        self.emit(Inst::StoreAt { base, len, index, from });
    }

    fn eval(&mut self, value: Value) {
        if self.out.preamble.word(self.module, value).is_some() {
            return;
        }
        match self.module.expr(value) {
            Expr::Const { .. } | Expr::Uniform { .. } | Expr::Input(_) => {}
            Expr::UniformAt { base, len, index, .. } => {
                self.out.reads_uniforms = true;
                let (index, out) = (self.value(*index), self.value(value));
                self.emit(Inst::UniformAt { out, base: *base, len: *len, index });
            }
            Expr::Load(var) => {
                let (from, out) = (self.variable(*var), self.value(value));
                self.emit(Inst::Move { out, from });
            }
            Expr::LoadAt { var, index } => {
                if let Some(from) = self.constant_element(*var, *index) {
                    let out = self.value(value);
                    self.emit(Inst::Move { out, from });
                    return;
                }
                let (base, len) = (self.variable(*var), self.module.variable(*var).len);
                let (index, out) = (self.value(*index), self.value(value));
                self.emit(Inst::LoadAt { out, base, len, index });
            }
            Expr::Op { op, args } => {
                let mut regs = [self.value(args[0]); OPERANDS];
                for i in 1..op.args().len() {
                    regs[i] = self.value(args[i]);
                }
                let out = self.value(value);
                self.emit(Inst::Compute { what: Compute::from(*op), out, args: regs });
            }
            Expr::Derivative { axis, value: of } => {
                let (from, out) = (self.value(*of), self.value(value));
                self.emit(Inst::Derivative { axis: *axis, out, from });
            }
            Expr::Tabulated { value: of, table } => {
                let (from, out) = (self.value(*of), self.value(value));
                self.emit(Inst::Tabulated { out, from, table: table.clone() });
            }
            Expr::Sample(sample) => self.sample(value, sample),
            Expr::Component { sample, component } => {
                let regs = self.samples[sample.0 as usize];
                self.values[value.0 as usize] = regs.map(|regs| regs[usize::from(*component)]);
            }
        }
    }

    fn sample(&mut self, value: Value, sample: &Sample) {
        let coords = sample.coords.map(|coord| self.value(coord));
        let layer = sample.layer.map(|layer| self.value(layer));
        let reference = sample.reference.map(|reference| self.value(reference));
        let lod = match (sample.lod, self.module.stage) {
            (Lod::Implicit { bias }, Stage::Fragment) => {
                SampleLod::Implicit { bias: bias.map(|bias| self.value(bias)) }
            }
            // A vertex has no neighbours: the base level plus the bias.
            (Lod::Implicit { bias: Some(bias) }, Stage::Vertex | Stage::Geometry) => {
                SampleLod::Explicit(self.value(bias))
            }
            (Lod::Implicit { bias: None }, Stage::Vertex | Stage::Geometry) => {
                let zero = self.out.preamble.constant(0);
                SampleLod::Explicit(self.splat(zero))
            }
            (Lod::Explicit(lod), Stage::Vertex | Stage::Geometry | Stage::Fragment) => {
                SampleLod::Explicit(self.value(lod))
            }
            (Lod::Gradient { dx, dy, bias }, Stage::Vertex | Stage::Geometry | Stage::Fragment) => {
                SampleLod::Gradient {
                    dx: dx.map(|value| self.value(value)),
                    dy: dy.map(|value| self.value(value)),
                    bias: bias.map(|value| self.value(value)),
                }
            }
        };
        let out = [0; 4].map(|_| self.register(RegisterContent::Temp));
        self.samples[value.0 as usize] = Some(out);
        self.out.textures.push(sample.texture.0);
        self.out.queries_lod |= sample.access == Access::Lod;
        let (texture, access, out) = (sample.texture.0, sample.access, out.map(Some));
        let one = match (access, self.module.component_ty(sample)) {
            (Access::Size | Access::Lod | Access::Gather { .. }, _) => 0,
            (Access::Filter { .. } | Access::Fetch { .. }, Ty::F32) => 1f32.to_bits(),
            (Access::Filter { .. } | Access::Fetch { .. }, Ty::I32 | Ty::U32 | Ty::Bool) => 1,
        };
        let repeat = None;
        let axes = [AxisTexels::Compute; 2];
        let inst =
            SampleInst { texture, access, coords, layer, reference, lod, one, out, repeat, axes };
        self.emit(Inst::Sample(Box::new(inst)));
    }
}
