//! Checked shader to IR: every vector taken apart into scalars, every call inlined.

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

/// Why a stage cannot be lowered; ends up in the link log.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LowerError(pub String);

type LowerResult<T> = Result<T, LowerError>;

/// The uniform words of a program, and the state among them.
#[derive(Clone, Debug, Default)]
pub struct Words {
    /// The next free word.
    pub next: u32,
    /// State that is read.
    pub state: Vec<StateBinding>,
    /// State of all elements in a row, and its first word: a handful.
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
    /// A `switch`, which is a scope; what jumps out farther sets a flag.
    Switch { returned: Option<Var>, continued: Option<Var> },
}

/// A function being inlined.
struct Frame<'a> {
    /// Which unit it is in.
    unit: usize,
    /// Its variables.
    locals: &'a [Variable],
    /// Where they live, once they are declared.
    storages: Vec<Option<VarStorage>>,
    /// What is open in it, outermost first.
    regions: Vec<Region>,
    /// Where its result goes, if it can return early.
    result: Vec<Var>,
    /// Whether declarations may be skipped by a jump to a label, so that each needs a variable.
    labelled: bool,
}

/// A stage on its way to IR.
struct Lowerer<'a> {
    emit: Emit,
    /// The globals of each unit.
    units: Vec<&'a [Variable]>,
    /// The functions with bodies, by signature.
    functions: BTreeMap<String, (usize, &'a Function)>,
    /// The functions of each unit.
    unit_functions: Vec<&'a [Function]>,
    /// Where the globals live, by name.
    globals: BTreeMap<Arc<str>, VarStorage>,
    frames: Vec<Frame<'a>>,
    depth: u32,
    /// How many loops are open.
    loops: u32,
    words: Words,
    textures: BTreeMap<(u32, [u8; 3], ComparisonResult), Texture>,
    /// The slots, the words that hold their units, what textures they take, and what comes of
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

/// The words of a constant expression, if it is one.
pub fn constant(expr: &Expr, globals: &[Variable], locals: &[Variable]) -> Option<Vec<u32>> {
    let mut lowerer = Lowerer::new(Stage::Vertex, vec![globals]);
    lowerer.open_frame(0, locals);
    let values = lowerer.expr(expr).ok()?;
    values.into_iter().map(|value| lowerer.emit.known(value)).collect()
}

/// The functions of some units, by signature, and every unit's.
fn functions<'a>(units: &[&'a Unit]) -> BTreeMap<String, (usize, &'a Function)> {
    let mut all = BTreeMap::new();
    for (index, unit) in units.iter().enumerate() {
        for function in unit.functions.iter().filter(|function| function.body.is_some()) {
            all.insert(function.signature(), (index, function));
        }
    }
    all
}

/// The functions that `main` reaches, `main` first, and those that initializers of globals reach, each
/// with its unit. One that nobody defines is no mistake as long as the calls of it fold away.
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
