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
use crate::limits::{MAX_INLINED_DEPTH, MAX_VALUES};
use crate::types::{ComparisonResult, Dim};
use access_chain::VarStorage;
use rasterizer::ir::{Stage, Texture, TextureDecl, Ty, Value, Var};
pub use stage::{Binding, lower_stage, named_globals, varying_slots};
use std::collections::BTreeMap;
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
    /// The functions with bodies, by signature.
    functions: BTreeMap<String, (usize, &'a Function)>,
    /// The functions of each unit.
    unit_functions: Vec<&'a [Function]>,
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
}

impl<'a> Lowerer<'a> {
    fn new(stage: Stage, units: Vec<&'a [Variable]>) -> Self {
        Self {
            emit: Emit::new(stage),
            units,
            functions: BTreeMap::new(),
            unit_functions: Vec::new(),
            globals: BTreeMap::new(),
            frames: Vec::new(),
            depth: 0,
            loops: 0,
            words: Words::default(),
            textures: BTreeMap::new(),
            samplers: Vec::new(),
        }
    }

    fn frame(&mut self) -> &mut Frame<'a> {
        self.frames.last_mut().expect("a frame is open wherever code is lowered")
    }

    fn open_frame(&mut self, unit: usize, locals: &'a [Variable]) {
        let storages = vec![None; locals.len()];
        let (regions, result) = (Vec::new(), Vec::new());
        let labelled = false;
        self.frames.push(Frame { unit, locals, storages, regions, result, labelled });
    }

    /// Fails when there are too many values.
    fn check_size(&self) -> LowerResult<()> {
        if self.emit.is_full() {
            return Err(LowerError(format!(
                "function calls and loops expand to too many operations (more than {MAX_VALUES})"
            )));
        }
        Ok(())
    }

    /// Runs `lower` one level deeper.
    fn nested<T>(&mut self, lower: impl FnOnce(&mut Self) -> LowerResult<T>) -> LowerResult<T> {
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

/// The words of a constant expression; `None` if it is not constant.
pub fn constant(expr: &Expr, globals: &[Variable], locals: &[Variable]) -> Option<Vec<u32>> {
    let mut lowerer = Lowerer::new(Stage::Vertex, vec![globals]);
    lowerer.open_frame(0, locals);
    let values = lowerer.expr(expr).ok()?;
    values.into_iter().map(|value| lowerer.emit.known(value)).collect()
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
