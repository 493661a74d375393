//! The IR as its documentation reads, one lane at a time, by plain recursion.

use crate::ir::{Block, Expr, FunctionTable, Input, Module, Op, Stmt, Value, Var};

/// How a lane ended.
#[derive(Debug, PartialEq)]
pub enum Outcome {
    /// By output; then what was emitted.
    Done(Vec<u32>),
    Discarded,
    /// Took too many steps.
    Endless,
}

enum Flow {
    Next,
    Break,
    Continue,
    Leave,
    Discard,
    Endless,
}

struct Lane<'a, F> {
    module: &'a Module,
    uniforms: &'a [u32],
    input: F,
    values: Vec<u32>,
    variables: Vec<Vec<u32>>,
    steps: u32,
    /// By emitted vertex: whether it begins a strip, and its scalars.
    emitted: Vec<Vec<u32>>,
    begins: bool,
}

/// Runs one lane. Modules with derivatives or samples have no meaning here.
pub fn run(module: &Module, uniforms: &[u32], steps: u32, input: impl Fn(Input) -> u32) -> Outcome {
    let mut lane = Lane {
        module,
        uniforms,
        input,
        values: vec![0; module.values.len()],
        variables: module.variables.iter().map(|var| vec![0; var.len as usize]).collect(),
        steps,
        emitted: Vec::new(),
        begins: true,
    };
    match lane.block(&module.body) {
        Flow::Discard => Outcome::Discarded,
        Flow::Endless => Outcome::Endless,
        Flow::Next | Flow::Break | Flow::Continue | Flow::Leave => Outcome::Done(
            module
                .outputs
                .iter()
                .map(|(_, var)| super::any_nan(lane.variables[var.0 as usize][0]))
                .chain(lane.emitted.concat())
                .collect(),
        ),
    }
}

impl<F: Fn(Input) -> u32> Lane<'_, F> {
    fn get(&self, value: Value) -> u32 {
        match self.module.expr(value) {
            Expr::Const { bits, .. } => *bits,
            Expr::Input(input) => (self.input)(*input),
            Expr::Uniform { word, .. } => self.uniforms.get(*word as usize).copied().unwrap_or(0),
            _ => self.values[value.0 as usize],
        }
    }

    fn element(&self, var: Var, index: Value) -> usize {
        (self.get(index) as usize).min(self.variables[var.0 as usize].len() - 1)
    }

    fn eval(&mut self, value: Value) {
        let word = match self.module.expr(value) {
            Expr::Const { .. } | Expr::Input(_) | Expr::Uniform { .. } => return,
            Expr::UniformAt { base, len, index, .. } => {
                let word = base + self.get(*index).min(len - 1);
                self.uniforms.get(word as usize).copied().unwrap_or(0)
            }
            Expr::Load(var) => self.variables[var.0 as usize][0],
            Expr::LoadAt { var, index } => {
                self.variables[var.0 as usize][self.element(*var, *index)]
            }
            Expr::Op { op, args } => {
                let mut words = [0; 3];
                for (word, arg) in words.iter_mut().zip(&args[..op.args().len()]) {
                    *word = self.get(*arg);
                }
                let exponent = self.module.constant(args[1]);
                let power = exponent.filter(|_| *op == Op::Pow).and_then(FunctionTable::power);
                power.map_or(op.eval(words), |power| power.word(f32::from_bits(words[0])))
            }
            Expr::Tabulated { value, table } => table.word(f32::from_bits(self.get(*value))),
            Expr::Derivative { .. } | Expr::Sample(_) | Expr::Component { .. } => {
                unreachable!("a lane has no neighbours here")
            }
        };
        self.values[value.0 as usize] = word;
    }

    fn block(&mut self, block: &Block) -> Flow {
        for stmt in block {
            if self.steps == 0 {
                return Flow::Endless;
            }
            self.steps -= 1;
            let flow = match stmt {
                Stmt::Eval(value) => {
                    self.eval(*value);
                    Flow::Next
                }
                Stmt::Store { var, value } => {
                    self.variables[var.0 as usize][0] = self.get(*value);
                    Flow::Next
                }
                Stmt::StoreAt { var, index, value } => {
                    let at = self.element(*var, *index);
                    self.variables[var.0 as usize][at] = self.get(*value);
                    Flow::Next
                }
                Stmt::If { condition, accept, reject } => {
                    let taken = if self.get(*condition) != 0 { accept } else { reject };
                    self.block(taken)
                }
                Stmt::Loop { body, continuing } => self.repeat(body, continuing),
                Stmt::Scope(body) => match self.block(body) {
                    Flow::Leave => Flow::Next,
                    flow => flow,
                },
                Stmt::Break => Flow::Break,
                Stmt::Continue => Flow::Continue,
                Stmt::Leave => Flow::Leave,
                Stmt::Discard => Flow::Discard,
                Stmt::EmitVertex(values) => {
                    let most = self.module.geometry.as_ref().map_or(0, |own| own.max_vertices);
                    if (self.emitted.len() as u32) < most {
                        let begins = u32::from(std::mem::take(&mut self.begins));
                        let words = values.iter().map(|value| super::any_nan(self.get(*value)));
                        let vertex = std::iter::once(begins).chain(words).collect();
                        self.emitted.push(vertex);
                    }
                    Flow::Next
                }
                Stmt::EndPrimitive => {
                    self.begins = true;
                    Flow::Next
                }
            };
            match flow {
                Flow::Next => {}
                flow => return flow,
            }
        }
        Flow::Next
    }

    fn repeat(&mut self, body: &Block, continuing: &Block) -> Flow {
        loop {
            if self.steps == 0 {
                return Flow::Endless;
            }
            self.steps -= 1;
            for block in [body, continuing] {
                match self.block(block) {
                    Flow::Next | Flow::Continue => {}
                    Flow::Break => return Flow::Next,
                    flow => return flow,
                }
            }
        }
    }
}
