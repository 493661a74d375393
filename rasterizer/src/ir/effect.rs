//! What is known of the picture of a stage before it runs: that it draws nothing, or what its colour is multiplied by.
//! For clients that warn of black pictures; nothing that is drawn depends on it.

use super::{Block, Expr, Module, Op, Output, Stage, Stmt, Value, Var};

/// How many words of uniforms a colour is known to be multiplied by.
const FACTORS: usize = 4;

/// Of modules of more values nothing is said: the search takes as long as they are deep.
const LARGE: usize = 1 << 14;

/// What is known of the picture of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effect {
    /// Whether it draws nothing: fragments that are all discarded, or no vertex that is emitted.
    pub draws_nothing: bool,
    /// Whether a component of the first colour is no number everywhere.
    pub is_not_a_number: bool,
    /// What red, green and blue of the first colour are multiplied by.
    pub factors: [Factors; 3],
}

/// Words of the draw's uniform words; a number is 0 if one of them is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Factors {
    words: [u32; FACTORS],
    count: u8,
}

impl Factors {
    const NONE: Self = Self { words: [0; FACTORS], count: 0 };

    /// The words; some are left out where there are many.
    pub fn words(&self) -> &[u32] {
        &self.words[..usize::from(self.count)]
    }

    fn with(mut self, word: u32) -> Self {
        if usize::from(self.count) < FACTORS && !self.words().contains(&word) {
            self.words[usize::from(self.count)] = word;
            self.count += 1;
        }
        self
    }
}

/// When a value is 0.
#[derive(Clone, Copy)]
enum Zero {
    Always,
    /// If a word is, as far as it is known.
    With(Factors),
}

impl Zero {
    const UNKNOWN: Self = Self::With(Factors::NONE);

    /// That of a product.
    fn or(self, other: Self) -> Self {
        match (self, other) {
            (Self::Always, _) | (_, Self::Always) => Self::Always,
            (Self::With(a), Self::With(b)) => {
                Self::With(b.words().iter().fold(a, |all, &word| all.with(word)))
            }
        }
    }

    /// That of a sum, whose operands must all be 0.
    fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Always, other) | (other, Self::Always) => other,
            (Self::With(a), Self::With(b)) => {
                let both = a.words().iter().filter(|word| b.words().contains(word));
                Self::With(both.fold(Factors::NONE, |all, &word| all.with(word)))
            }
        }
    }
}

impl Effect {
    pub(crate) fn of(module: &Module) -> Self {
        let unknown =
            Self { draws_nothing: false, is_not_a_number: false, factors: [Factors::NONE; 3] };
        match module.stage {
            Stage::Vertex => unknown,
            Stage::Geometry | Stage::Fragment if module.values.len() > LARGE => unknown,
            Stage::Geometry => {
                let mut emits = false;
                let mut visit = |stmt: &Stmt| emits |= matches!(stmt, Stmt::EmitVertex(_));
                module.body.iter().for_each(|stmt| stmt.walk(&mut visit));
                Self { draws_nothing: !emits, ..unknown }
            }
            Stage::Fragment => {
                let stores = Stores::new(module);
                let zeros = Zeros::of(module);
                let color = |component: u8| {
                    let output = Output::Color { target: 0, component };
                    module.outputs.iter().find(|(of, _)| *of == output).map(|(_, var)| *var)
                };
                let is_nan = |value: &Value| {
                    let expr = module.values.get(value.0 as usize);
                    matches!(expr, Some(&Expr::Const { bits, .. }) if f32::from_bits(bits).is_nan())
                };
                let all_nan = |var: Var| {
                    let stored = stores.of(var);
                    !stored.is_empty() && stored.iter().all(is_nan)
                };
                let factors = |component: u8| match color(component)
                    .map(|var| zeros.variables[var.0 as usize])
                {
                    Some(Zero::With(factors)) => factors,
                    Some(Zero::Always) | None => Factors::NONE,
                };
                Self {
                    draws_nothing: discards_all(&module.body),
                    is_not_a_number: (0..3).filter_map(color).any(all_nan),
                    factors: [factors(0), factors(1), factors(2)],
                }
            }
        }
    }
}

/// Whether a block discards every fragment that enters it.
fn discards_all(block: &Block) -> bool {
    for stmt in block {
        match stmt {
            Stmt::Discard => return true,
            Stmt::Scope(body) if discards_all(body) => return true,
            Stmt::If { accept, reject, .. } if discards_all(accept) && discards_all(reject) => {
                return true;
            }
            Stmt::If { .. } | Stmt::Loop { .. } | Stmt::Scope(_) => {
                let mut leaves = false;
                stmt.walk(&mut |inner| {
                    leaves |= matches!(inner, Stmt::Leave | Stmt::Break | Stmt::Continue);
                });
                if leaves {
                    return false;
                }
            }
            Stmt::Break | Stmt::Continue | Stmt::Leave => return false,
            Stmt::Eval(_)
            | Stmt::Store { .. }
            | Stmt::StoreAt { .. }
            | Stmt::EmitVertex(_)
            | Stmt::EndPrimitive => {}
        }
    }
    false
}

/// The values that each variable of length 1 is given.
struct Stores(Vec<Vec<Value>>);

impl Stores {
    fn new(module: &Module) -> Self {
        let mut all = vec![Vec::new(); module.variables.len()];
        let mut visit = |stmt: &Stmt| {
            if let Stmt::Store { var, value } = stmt {
                all[var.0 as usize].push(*value);
            }
        };
        module.body.iter().for_each(|stmt| stmt.walk(&mut visit));
        Self(all)
    }

    fn of(&self, var: Var) -> &[Value] {
        &self.0[var.0 as usize]
    }
}

/// Whether a statement runs for all fragments, once.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Runs {
    Always,
    /// For some, or again and again.
    Perhaps,
}

/// When values and variables are 0, as far as a module was read.
struct Zeros<'a> {
    module: &'a Module,
    values: Vec<Zero>,
    variables: Vec<Zero>,
}

impl<'a> Zeros<'a> {
    /// At the end of a module.
    fn of(module: &'a Module) -> Self {
        let everywhere = |expr: &Expr| match expr {
            Expr::Const { bits, .. } if bits << 1 == 0 => Zero::Always,
            Expr::Uniform { word, .. } => Zero::With(Factors::NONE.with(*word)),
            Expr::Const { .. }
            | Expr::Input(_)
            | Expr::UniformAt { .. }
            | Expr::Load(_)
            | Expr::LoadAt { .. }
            | Expr::Op { .. }
            | Expr::Derivative { .. }
            | Expr::Tabulated { .. }
            | Expr::Sample(_)
            | Expr::Component { .. } => Zero::UNKNOWN,
        };
        let values = module.values.iter().map(everywhere).collect();
        // Variables begin as 0.
        let variables = vec![Zero::Always; module.variables.len()];
        let mut all = Self { module, values, variables };
        all.block(&module.body, Runs::Always);
        all
    }

    fn value(&self, value: Value) -> Zero {
        self.values[value.0 as usize]
    }

    fn evaluate(&mut self, value: Value) {
        let zero = match &self.module.values[value.0 as usize] {
            Expr::Load(var) => self.variables[var.0 as usize],
            Expr::Op { op: Op::Mul, args } => self.value(args[0]).or(self.value(args[1])),
            Expr::Op { op: Op::Add | Op::Sub | Op::Min | Op::Max, args } => {
                self.value(args[0]).and(self.value(args[1]))
            }
            Expr::Op { op: Op::Neg, args } => self.value(args[0]),
            Expr::Const { .. }
            | Expr::Uniform { .. }
            | Expr::Input(_)
            | Expr::UniformAt { .. }
            | Expr::LoadAt { .. }
            | Expr::Op { .. }
            | Expr::Derivative { .. }
            | Expr::Tabulated { .. }
            | Expr::Sample(_)
            | Expr::Component { .. } => return,
        };
        self.values[value.0 as usize] = zero;
    }

    /// Forgets what is known of the variables that a statement writes.
    fn forget(&mut self, stmt: &Stmt) {
        stmt.walk(&mut |inner| {
            if let Stmt::Store { var, .. } | Stmt::StoreAt { var, .. } = inner {
                self.variables[var.0 as usize] = Zero::UNKNOWN;
            }
        });
    }

    fn block(&mut self, block: &Block, mut runs: Runs) {
        for stmt in block {
            match stmt {
                Stmt::Eval(value) => self.evaluate(*value),
                Stmt::Store { var, value } => {
                    let (value, var) = (self.value(*value), &mut self.variables[var.0 as usize]);
                    *var = match runs {
                        Runs::Always => value,
                        Runs::Perhaps => value.and(*var),
                    };
                }
                Stmt::StoreAt { .. } => self.forget(stmt),
                Stmt::If { accept, reject, .. } => {
                    self.block(accept, Runs::Perhaps);
                    self.block(reject, Runs::Perhaps);
                }
                // What it reads may have been written by the iteration before.
                Stmt::Loop { body, continuing } => {
                    self.forget(stmt);
                    self.block(body, Runs::Perhaps);
                    self.block(continuing, Runs::Perhaps);
                }
                Stmt::Scope(body) => self.block(body, runs),
                Stmt::Break
                | Stmt::Continue
                | Stmt::Leave
                | Stmt::Discard
                | Stmt::EmitVertex(_)
                | Stmt::EndPrimitive => {}
            }
            stmt.walk(&mut |inner| {
                if inner.is_jump() {
                    runs = Runs::Perhaps;
                }
            });
        }
    }
}
