//! Checked shaders to IR: vectors become scalars, calls are inlined.

mod access_chain;
mod builtin_variables;
mod call;
mod expr;
mod outputs;
mod stage;
mod stmt;
mod texture;

use crate::builtins::variable::StateArray;
use crate::emit::Emit;
use crate::hir::{Expr, Function, Unit, VarRef, Variable};
use crate::interface::{StateBinding, StateVar};
use crate::limits::{MAX_INLINED_DEPTH, MAX_VALUES, MAX_WORK};
use crate::types::{ComparisonResult, Dim};
use crate::work::Work;
use access_chain::VarStorage;
use outputs::OutputCopy;
use rasterizer::ir::{Stage, Texture, TextureDecl, Ty, Value, Var};
pub use stage::{Binding, StageToLower, lower_stage, named_globals, varying_slots};
use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::Arc;

/// Why a stage cannot be lowered; the linker reports it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LowerError(pub String);

type LowerResult<T> = Result<T, LowerError>;

/// The uniform words of a program, with those of GL state.
#[derive(Clone, Debug, Default)]
pub struct Words {
    /// The next free word.
    pub next: u32,
    /// The GL state that is read.
    pub state: Vec<StateBinding>,
    /// Arrays of GL state whose elements are consecutive, and their first words.
    arrays: Vec<(StateArray, u32)>,
}

impl Words {
    /// The first word of a piece of state.
    pub fn state(&mut self, var: StateVar) -> u32 {
        match self.state.iter().find(|binding| binding.var == var) {
            Some(binding) => binding.word,
            None => self.add(var),
        }
    }

    /// The first word of element 0, the other elements following.
    fn array(&mut self, array: StateArray) -> u32 {
        if let Some(&(_, word)) = self.arrays.iter().find(|(known, _)| *known == array) {
            return word;
        }
        let first = self.next;
        for index in 0..array.len() {
            self.add(array.element(index));
        }
        self.arrays.push((array, first));
        first
    }

    fn add(&mut self, var: StateVar) -> u32 {
        let word = self.next;
        self.state.push(StateBinding { var, word });
        self.next += var.words();
        word
    }
}

/// A construct that `break`, `continue` and `return` may leave.
#[derive(Clone, Copy, Debug)]
enum Region {
    /// The scope of a function.
    Function,
    /// A loop.
    Loop,
    /// A `switch`, which is a scope; jumps out of enclosing constructs set a flag.
    Switch { returned: Option<Var>, continued: Option<Var> },
}

/// A function being inlined.
struct Frame<'a> {
    /// The function; `None` for initializers of globals and `main`.
    function: Option<&'a Function>,
    /// Which unit it is in.
    unit: usize,
    /// Its variables.
    locals: &'a [Variable],
    /// Their storage, once they are declared.
    storages: Vec<Option<VarStorage>>,
    /// The open constructs, outermost first.
    regions: Vec<Region>,
    /// The variables of its result, if it returns early.
    result: Vec<Var>,
    /// Whether a jump to a label may skip declarations, so that each needs an IR variable.
    labelled: bool,
}

/// The state while a stage is lowered.
struct Lowerer<'a> {
    emit: Emit,
    /// The globals of each unit.
    units: Vec<&'a [Variable]>,
    /// By unit and function: what a call of it inlines.
    targets: Vec<Vec<CallTarget<'a>>>,
    /// The storage of the globals, by name.
    globals: BTreeMap<Arc<str>, VarStorage>,
    frames: Vec<Frame<'a>>,
    depth: u32,
    /// How many loops are open.
    loops: u32,
    words: Words,
    textures: BTreeMap<(u32, [u8; 3], ComparisonResult), Texture>,
    /// For each texture slot: the word of its unit, the textures it takes, and the result of its
    /// comparisons.
    samplers: Vec<(Texture, u32, Dim, ComparisonResult)>,
    /// What a vertex that the geometry stage emits holds.
    emitted: Rc<[OutputCopy]>,
}

impl<'a> Lowerer<'a> {
    fn new(stage: Stage, units: Vec<&'a [Variable]>) -> Self {
        Self {
            emit: Emit::new(stage),
            units,
            targets: Vec::new(),
            globals: BTreeMap::new(),
            frames: Vec::new(),
            depth: 0,
            loops: 0,
            words: Words::default(),
            textures: BTreeMap::new(),
            samplers: Vec::new(),
            emitted: Rc::new([]),
        }
    }

    fn frame(&mut self) -> &mut Frame<'a> {
        self.frames.last_mut().expect("a frame is open wherever code is lowered")
    }

    fn open_frame(&mut self, unit: usize, function: Option<&'a Function>, locals: &'a [Variable]) {
        self.emit.work.add(locals.len() + 1);
        let storages = vec![None; locals.len()];
        self.push_frame(unit, function, locals, storages);
    }

    fn push_frame(
        &mut self,
        unit: usize,
        function: Option<&'a Function>,
        locals: &'a [Variable],
        storages: Vec<Option<VarStorage>>,
    ) {
        let (regions, result) = (Vec::new(), Vec::new());
        let labelled = false;
        self.frames.push(Frame { function, unit, locals, storages, regions, result, labelled });
    }

    /// Fails when there are too many values, or there was too much work.
    fn check_size(&self) -> LowerResult<()> {
        if self.emit.work.is_over() {
            return Err(self.too_much_work());
        }
        if self.emit.is_full() {
            return Err(LowerError(format!(
                "function calls and loops expand to too many operations (more than {MAX_VALUES})"
            )));
        }
        Ok(())
    }

    #[cold]
    fn too_much_work(&self) -> LowerError {
        let called = self.frames.iter().find_map(|frame| frame.function);
        let within = called.map_or(String::new(), |function| {
            format!(", at a call of `{}`, which line {} defines", function.name, function.line)
        });
        LowerError(format!(
            "function calls and constants expand to too much work (more than {MAX_WORK} steps){within}"
        ))
    }

    /// Runs `lower` one level deeper.
    fn nested<T>(&mut self, lower: impl FnOnce(&mut Self) -> LowerResult<T>) -> LowerResult<T> {
        self.emit.work.add(1);
        if self.emit.work.is_over() {
            return Err(self.too_much_work());
        }
        if self.depth >= MAX_INLINED_DEPTH {
            let message = "statements, expressions and calls nest too deeply";
            return Err(LowerError(message.to_owned()));
        }
        self.depth += 1;
        let result = lower(self);
        self.depth -= 1;
        result
    }

    /// The declaration of a variable.
    fn variable(&mut self, var: VarRef) -> &'a Variable {
        match var {
            VarRef::Global(index) => {
                let unit = self.frame().unit;
                &self.units[unit][index as usize]
            }
            VarRef::Local(index) => &self.frame().locals[index as usize],
        }
    }

    /// Constant words as values.
    fn constants(&mut self, words: &[u32], types: &[Ty]) -> Vec<Value> {
        words.iter().zip(types).map(|(&word, &ty)| self.emit.constant(word, ty)).collect()
    }
}

/// The words of a constant expression; `None` if it is not constant, or when there was too much work.
pub fn constant(
    expr: &Expr,
    globals: &[Variable],
    locals: &[Variable],
    work: &mut Work,
) -> Option<Vec<u32>> {
    let mut lowerer = Lowerer::new(Stage::Vertex, vec![globals]);
    lowerer.emit.work = *work;
    lowerer.push_frame(0, None, locals, Vec::new());
    let values = lowerer.expr(expr);
    *work = lowerer.emit.work;
    values.ok()?.into_iter().map(|value| lowerer.emit.known(value)).collect()
}

/// What a call of a function inlines.
#[derive(Clone)]
enum CallTarget<'a> {
    /// No shader defines the function of this signature.
    Undefined(String),
    Defined {
        unit: usize,
        function: &'a Function,
        /// Whether a `return` stands anywhere but at its end.
        returns_early: bool,
    },
}

/// The targets of the calls of each unit.
fn call_targets<'a>(units: &[&'a Unit]) -> Vec<Vec<CallTarget<'a>>> {
    let bodies = functions(units);
    let target = |function: &Function| {
        let signature = function.signature();
        match bodies.get(&signature) {
            Some(&(unit, function)) => {
                let returns_early = function.body.as_deref().is_some_and(call::returns_early);
                CallTarget::Defined { unit, function, returns_early }
            }
            None => CallTarget::Undefined(signature),
        }
    };
    units.iter().map(|unit| unit.functions.iter().map(target).collect()).collect()
}

/// The functions with bodies, by signature, each with its unit.
fn functions<'a>(units: &[&'a Unit]) -> BTreeMap<String, (usize, &'a Function)> {
    let mut all = BTreeMap::new();
    for (index, unit) in units.iter().enumerate() {
        for function in unit.functions.iter().filter(|function| function.body.is_some()) {
            all.insert(function.signature(), (index, function));
        }
    }
    all
}

/// The functions that `main` and initializers of globals reach, `main` first, each with its unit.
/// An undefined function is no error here: constant folding may remove its calls.
pub fn reachable<'a>(units: &[&'a Unit]) -> Vec<(usize, &'a Function)> {
    let bodies = functions(units);
    let Some(&main) = bodies.get("main()") else { return Vec::new() };
    let mut seen = vec![main];
    let mut names = std::collections::BTreeSet::from(["main()".to_owned()]);
    let mut add = |seen: &mut Vec<_>, unit: usize, call: u32| {
        let signature = units[unit].functions[call as usize].signature();
        if let Some(&target) = bodies.get(&signature)
            && names.insert(signature)
        {
            seen.push(target);
        }
    };
    for (index, unit) in units.iter().enumerate() {
        unit.calls.iter().for_each(|&call| add(&mut seen, index, call));
    }
    let mut next = 0;
    while next < seen.len() {
        let (unit, function) = seen[next];
        next += 1;
        function.calls.iter().for_each(|&(call, _)| add(&mut seen, unit, call));
    }
    seen
}

/// A texture declaration as a key.
fn texture_key(decl: TextureDecl) -> [u8; 3] {
    let texels = match decl.texels {
        Ty::F32 | Ty::Bool => 0,
        Ty::I32 => 1,
        Ty::U32 => 2,
    };
    [decl.shape as u8, decl.compare.into(), texels]
}
