//! The rules of a module, checked once, so that all later passes can rely on them.
//!
//! One pass in program order, linear in the size of the module. Blocks may nest [`MAX_NESTING`]
//! deep, so that a pass over a valid module may recurse over its blocks.

use super::{
    Access, Block, Expr, GeometryInterface, Input, Lod, Module, Op, Output, Sample, Stage, Stmt,
    TRUE, Ty, Value, Var,
};
use std::fmt;
use texunit::image::Shape;
use thiserror::Error;

/// How deep blocks may nest.
pub const MAX_NESTING: usize = 256;
/// How many values a module may have.
pub const MAX_VALUES: usize = 1 << 18;
/// How many elements all variables of a module may have together.
pub const MAX_VARIABLE_WORDS: u64 = 1 << 16;

/// A module that breaks a rule of the IR.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{0}")]
pub struct IrError(pub String);

type Checked = Result<(), IrError>;

macro_rules! rule {
    ($holds:expr, $($text:tt)*) => {
        if !$holds {
            return Err(IrError(format!($($text)*)));
        }
    };
}

mod declarations;

impl Module {
    /// Checks the rules that the module documentation of [`super`] states.
    ///
    /// # Errors
    /// The first rule that is broken, naming the value or statement.
    pub fn validate(&self) -> Result<(), IrError> {
        self.declarations()?;
        self.outputs()?;
        let mut body = Body {
            module: self,
            state: vec![State::Waiting; self.values.len()],
            visible: Vec::new(),
            nesting: 0,
        };
        for (at, expr) in self.values.iter().enumerate() {
            body.everywhere(Value(at as u32), expr)?;
        }
        body.block(&self.body, Enclosing { in_loop: Jumps::None, in_scope: false })
    }
}

/// The state of a value during validation.
#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    /// Not evaluated yet.
    Waiting,
    /// Can be used.
    Visible,
    /// The block that evaluated it has ended.
    Gone,
    /// Needs no evaluation.
    Everywhere,
}

/// Which jumps to the innermost loop are allowed.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Jumps {
    None,
    Break,
    BreakAndContinue,
}

#[derive(Clone, Copy)]
struct Enclosing {
    in_loop: Jumps,
    in_scope: bool,
}

/// What uses a value or a variable, as errors name it.
#[derive(Clone, Copy)]
enum User {
    Value(Value),
    Store,
    If,
    Emit,
}

impl fmt::Display for User {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Value(value) => write!(f, "%{}", value.0),
            Self::Store => f.write_str("store"),
            Self::If => f.write_str("if"),
            Self::Emit => f.write_str("emit"),
        }
    }
}

struct Body<'a> {
    module: &'a Module,
    /// By value.
    state: Vec<State>,
    /// The visible values, outermost block first.
    visible: Vec<Value>,
    nesting: usize,
}

impl Body<'_> {
    /// Checks a value that needs no evaluation.
    fn everywhere(&mut self, value: Value, expr: &Expr) -> Checked {
        let at = value.0;
        match expr {
            Expr::Const { bits, ty } => {
                rule!(*ty != Ty::Bool || *bits == 0 || *bits == TRUE, "%{at}: bool {bits:#x}");
            }
            Expr::Input(input) => self.input(at, *input)?,
            Expr::Uniform { word, .. } => {
                let words = self.module.uniform_words;
                rule!(*word < words, "%{at}: uniform word {word} of {words}");
            }
            Expr::UniformAt { .. }
            | Expr::Load(_)
            | Expr::LoadAt { .. }
            | Expr::Op { .. }
            | Expr::Derivative { .. }
            | Expr::Tabulated { .. }
            | Expr::Sample(_)
            | Expr::Component { .. } => return Ok(()),
        }
        self.state[at as usize] = State::Everywhere;
        Ok(())
    }

    fn input(&self, at: u32, input: Input) -> Checked {
        let (stage, in_range) = match input {
            Input::Attribute { component, .. } => (Stage::Vertex, component < 4),
            Input::VertexId | Input::InstanceId => (Stage::Vertex, true),
            Input::OfVertex { vertex, output } => {
                let written = match output {
                    Output::Position(component) => component < 4,
                    Output::ClipDistance(plane) => plane < 8,
                    Output::PointSize | Output::Varying(_) => true,
                    Output::CullDistance(_)
                    | Output::Color { .. }
                    | Output::SecondColor(_)
                    | Output::Depth
                    | Output::StencilReference
                    | Output::SampleMask
                    | Output::Layer
                    | Output::PrimitiveId
                    | Output::ViewportIndex => false,
                };
                let interface = self.module.geometry.as_ref();
                let exists = interface.is_some_and(|geometry| vertex < geometry.input.vertices());
                (Stage::Geometry, written && exists)
            }
            Input::PrimitiveId => (Stage::Geometry, true),
            Input::Varying(slot) | Input::Gradient { slot, .. } => {
                (Stage::Fragment, usize::from(slot) < self.module.varyings.len())
            }
            Input::FragCoord(component) => (Stage::Fragment, component < 4),
            Input::FrontFacing
            | Input::Coverage
            | Input::SampleId
            | Input::SamplePosition(_)
            | Input::LineDirection(_) => (Stage::Fragment, true),
            Input::PointCoord(component) => (Stage::Fragment, component < 2),
        };
        rule!(stage == self.module.stage, "%{at}: {input:?} in a {:?} module", self.module.stage);
        rule!(in_range, "%{at}: {input:?} is not declared or has no such component");
        Ok(())
    }

    fn block(&mut self, block: &Block, around: Enclosing) -> Checked {
        self.nesting += 1;
        rule!(self.nesting <= MAX_NESTING, "blocks nest deeper than {MAX_NESTING}");
        let outside = self.visible.len();
        for stmt in block {
            self.stmt(stmt, around)?;
        }
        for value in self.visible.drain(outside..) {
            self.state[value.0 as usize] = State::Gone;
        }
        self.nesting -= 1;
        Ok(())
    }

    fn stmt(&mut self, stmt: &Stmt, around: Enclosing) -> Checked {
        match stmt {
            Stmt::Eval(value) => self.eval(*value),
            Stmt::Store { var, value } => {
                let ty = self.scalar(*var, User::Store)?;
                self.operand(*value, ty, User::Store)
            }
            Stmt::StoreAt { var, index, value } => {
                let ty = self.array(*var, User::Store)?;
                self.index(*index, User::Store)?;
                self.operand(*value, ty, User::Store)
            }
            Stmt::If { condition, accept, reject } => {
                self.operand(*condition, Ty::Bool, User::If)?;
                self.block(accept, around)?;
                self.block(reject, around)
            }
            Stmt::Loop { body, continuing } => {
                self.block(body, Enclosing { in_loop: Jumps::BreakAndContinue, ..around })?;
                self.block(continuing, Enclosing { in_loop: Jumps::Break, ..around })
            }
            Stmt::Scope(body) => self.block(body, Enclosing { in_scope: true, ..around }),
            Stmt::Break => {
                rule!(around.in_loop != Jumps::None, "break outside a loop");
                Ok(())
            }
            Stmt::Continue => {
                let allowed = around.in_loop == Jumps::BreakAndContinue;
                rule!(allowed, "continue outside the body of a loop");
                Ok(())
            }
            Stmt::Leave => {
                rule!(around.in_scope, "leave outside a scope");
                Ok(())
            }
            Stmt::Discard => self.fragment_only("discard"),
            Stmt::EmitVertex(values) => self.emit_vertex(values),
            Stmt::EndPrimitive => self.geometry_only("end primitive").map(|_| ()),
        }
    }

    fn emit_vertex(&self, values: &[Value]) -> Checked {
        let outputs = &self.geometry_only("emit")?.outputs;
        let (count, wanted) = (values.len(), outputs.len());
        rule!(count == wanted, "emit: {count} values for {wanted} outputs");
        for (value, output) in values.iter().zip(outputs) {
            self.operand(*value, output.emitted_ty(), User::Emit)?;
        }
        Ok(())
    }

    fn geometry_only(&self, what: &str) -> Result<&GeometryInterface, IrError> {
        let interface = self.module.geometry.as_ref();
        interface.ok_or_else(|| IrError(format!("{what} outside a geometry module")))
    }

    fn fragment_only(&self, what: &str) -> Checked {
        rule!(self.module.stage == Stage::Fragment, "{what} outside a fragment module");
        Ok(())
    }

    fn eval(&mut self, value: Value) -> Checked {
        let module = self.module;
        let Some(expr) = module.values.get(value.0 as usize) else {
            return Err(IrError(format!("eval: there is no %{}", value.0)));
        };
        let state = self.state[value.0 as usize];
        if state == State::Everywhere {
            return Ok(());
        }
        let user = User::Value(value);
        rule!(state == State::Waiting, "{user} is evaluated twice");
        match expr {
            Expr::Const { .. } | Expr::Input(_) | Expr::Uniform { .. } => {}
            Expr::UniformAt { base, len, index, .. } => {
                let (end, words) = (u64::from(*base) + u64::from(*len), module.uniform_words);
                rule!(*len >= 1, "{user}: no uniform words to index");
                rule!(end <= u64::from(words), "{user}: uniform words up to {end} of {words}");
                self.index(*index, user)?;
            }
            Expr::Load(var) => {
                self.scalar(*var, user)?;
            }
            Expr::LoadAt { var, index } => {
                self.array(*var, user)?;
                self.index(*index, user)?;
            }
            Expr::Op { op, args } => self.op(*op, args, user)?,
            Expr::Derivative { value, .. } => {
                self.fragment_only("derivative")?;
                self.operand(*value, Ty::F32, user)?;
            }
            Expr::Tabulated { value, .. } => self.operand(*value, Ty::F32, user)?,
            Expr::Sample(sample) => self.sample(sample, user)?,
            Expr::Component { sample, component } => {
                self.visible(*sample, user)?;
                let sampled = matches!(module.expr(*sample), Expr::Sample(_));
                rule!(sampled, "{user}: %{} is not a sample", sample.0);
                rule!(*component < 4, "{user}: component {component}");
            }
        }
        self.state[value.0 as usize] = State::Visible;
        self.visible.push(value);
        Ok(())
    }

    fn op(&self, op: Op, args: &[Value; 3], user: User) -> Checked {
        for (arg, ty) in args.iter().zip(op.args()) {
            self.operand(*arg, *ty, user)?;
        }
        Ok(())
    }

    fn sample(&self, sample: &Sample, user: User) -> Checked {
        let slot = sample.texture.0;
        let Some(decl) = self.module.textures.get(slot as usize) else {
            return Err(IrError(format!("{user}: there is no texture slot {slot}")));
        };
        rule!(
            decl.texels == Ty::F32 || decl.texels != Ty::Bool && !decl.compare,
            "{user}: texture slot {slot} gives {:?}",
            decl.texels
        );
        let layered = decl.shape == Shape::CubeArray
            && matches!(sample.access, Access::Filter { .. } | Access::Gather { .. });
        rule!(
            layered == sample.layer.is_some(),
            "{user}: texture slot {slot} {} layer apart from its coordinates",
            if layered { "needs a" } else { "has no" }
        );
        let ty = match sample.access {
            Access::Filter { .. } => {
                rule!(
                    decl.compare == sample.reference.is_some(),
                    "{user}: texture slot {slot} {} a reference",
                    if decl.compare { "compares and needs" } else { "does not compare but has" }
                );
                Ty::F32
            }
            Access::Gather { .. } => {
                rule!(
                    decl.shape.axes() == 2
                        && sample.reference.is_none()
                        && sample.lod == Lod::Implicit { bias: None },
                    "{user}: a gather takes a texture of two axes, no level, no bias and no reference"
                );
                Ty::F32
            }
            Access::Lod => {
                rule!(
                    self.module.stage == Stage::Fragment
                        && sample.reference.is_none()
                        && !matches!(sample.lod, Lod::Explicit(_)),
                    "{user}: a query of the level takes no level and no reference, and is of the \
                     fragment stage"
                );
                Ty::F32
            }
            Access::Fetch { .. } | Access::Size => {
                rule!(
                    sample.reference.is_none() && matches!(sample.lod, Lod::Explicit(_)),
                    "{user}: a fetch and a size take a level and no reference"
                );
                Ty::I32
            }
        };
        let (lod, gradient): (Option<Value>, _) = match sample.lod {
            Lod::Implicit { bias } => (bias, None),
            Lod::Explicit(lod) => (Some(lod), None),
            Lod::Gradient { dx, dy, bias } => (bias, Some([dx, dy])),
        };
        let gradient = gradient.iter().flatten().flatten();
        let own = sample.coords.iter().chain(&sample.layer).chain(&sample.reference);
        for value in own.chain(&lod).chain(gradient) {
            self.operand(*value, ty, user)?;
        }
        Ok(())
    }

    fn visible(&self, value: Value, user: User) -> Checked {
        let at = value.0;
        match self.state.get(at as usize) {
            Some(State::Visible | State::Everywhere) => Ok(()),
            Some(State::Waiting) => {
                Err(IrError(format!("{user}: %{at} has not been evaluated before")))
            }
            Some(State::Gone) => {
                Err(IrError(format!("{user}: the block that evaluated %{at} has ended")))
            }
            None => Err(IrError(format!("{user}: there is no %{at}"))),
        }
    }

    fn operand(&self, value: Value, ty: Ty, user: User) -> Checked {
        self.visible(value, user)?;
        let whole_sample = matches!(self.module.expr(value), Expr::Sample(_));
        rule!(!whole_sample, "{user}: %{} is a whole sample, not a component", value.0);
        let found = self.module.ty(value);
        rule!(found == ty, "{user}: %{} is {found:?}, not {ty:?}", value.0);
        Ok(())
    }

    fn index(&self, value: Value, user: User) -> Checked {
        self.visible(value, user)?;
        let ty = self.module.ty(value);
        rule!(matches!(ty, Ty::I32 | Ty::U32), "{user}: the index %{} is {ty:?}", value.0);
        Ok(())
    }

    fn array(&self, var: Var, user: User) -> Result<Ty, IrError> {
        let variable = self.module.variables.get(var.0 as usize);
        variable
            .map(|variable| variable.ty)
            .ok_or_else(|| IrError(format!("{user}: there is no v{}", var.0)))
    }

    fn scalar(&self, var: Var, user: User) -> Result<Ty, IrError> {
        let ty = self.array(var, user)?;
        rule!(self.module.variable(var).len == 1, "{user}: v{} is an array", var.0);
        Ok(ty)
    }
}
