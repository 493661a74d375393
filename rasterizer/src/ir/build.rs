//! Making modules: a builder that appends values and statements and keeps the nesting of blocks.

use super::{
    Access, Axis, Block, Expr, Input, Lod, Module, Op, Output, Sample, Stage, Stmt, Texture,
    TextureDecl, Ty, Value, Var, Variable,
};

/// Appends to a [`Module`].
///
/// ```
/// use rasterizer::ir::{Builder, Input, Interpolation, Op, Output, Stage};
/// let mut b = Builder::new(Stage::Fragment);
/// b.module_mut().varyings.push(Interpolation::Smooth);
/// let half = b.float(0.5);
/// let s = b.input(Input::Varying(0));
/// let red = b.op(Op::Mul, &[s, half]);
/// let out = b.output(Output::Color { target: 0, component: 0 });
/// b.store(out, red);
/// let module = b.finish();
/// assert!(module.validate().is_ok());
/// ```
#[derive(Debug)]
pub struct Builder {
    module: Module,
    /// The open blocks, outermost first; statements are appended to the last.
    open: Vec<Block>,
}

impl Builder {
    /// A builder of an empty module.
    pub fn new(stage: Stage) -> Self {
        Self { module: Module::new(stage), open: vec![Vec::new()] }
    }

    /// A builder that appends to a module.
    pub fn resume(mut module: Module) -> Self {
        let body = std::mem::take(&mut module.body);
        Self { module, open: vec![body] }
    }

    /// The module so far, without the blocks that are still open.
    pub fn module(&self) -> &Module {
        &self.module
    }

    /// Declarations (textures, uniform words, varyings) can be set directly.
    pub fn module_mut(&mut self) -> &mut Module {
        &mut self.module
    }

    /// Ends the building.
    ///
    /// # Panics
    /// When a block is still open.
    pub fn finish(mut self) -> Module {
        assert_eq!(self.open.len(), 1, "a block is still open");
        self.module.body = self.open.remove(0);
        self.module
    }

    /// Adds an expression and, unless it is the same everywhere, evaluates it here.
    pub fn value(&mut self, expr: Expr) -> Value {
        let everywhere = expr.is_everywhere();
        let value = Value(self.module.values.len() as u32);
        self.module.values.push(expr);
        if !everywhere {
            self.push(Stmt::Eval(value));
        }
        value
    }

    /// Appends a statement to the innermost open block.
    pub fn push(&mut self, stmt: Stmt) {
        self.open.last_mut().expect("the body is open until `finish`").push(stmt);
    }

    /// Opens a block; statements are appended to it until [`Builder::end`].
    pub fn begin(&mut self) {
        self.open.push(Vec::new());
    }

    /// Closes the innermost block and returns it, as a block of a statement.
    ///
    /// # Panics
    /// When no block was opened.
    pub fn end(&mut self) -> Block {
        assert!(self.open.len() > 1, "no block is open");
        self.open.pop().expect("checked above")
    }

    /// A constant `f32`.
    pub fn float(&mut self, value: f32) -> Value {
        self.constant(value.to_bits(), Ty::F32)
    }

    /// A constant `i32`.
    pub fn int(&mut self, value: i32) -> Value {
        self.constant(value as u32, Ty::I32)
    }

    /// A constant `u32`.
    pub fn uint(&mut self, value: u32) -> Value {
        self.constant(value, Ty::U32)
    }

    /// A constant `bool`.
    pub fn boolean(&mut self, value: bool) -> Value {
        self.constant(if value { super::TRUE } else { 0 }, Ty::Bool)
    }

    /// A constant of any type.
    pub fn constant(&mut self, bits: u32, ty: Ty) -> Value {
        self.value(Expr::Const { bits, ty })
    }

    /// An input.
    pub fn input(&mut self, input: Input) -> Value {
        self.value(Expr::Input(input))
    }

    /// A uniform word; the module's `uniform_words` grows to hold it.
    pub fn uniform(&mut self, word: u32, ty: Ty) -> Value {
        self.module.uniform_words = self.module.uniform_words.max(word + 1);
        self.value(Expr::Uniform { word, ty })
    }

    /// An operation.
    ///
    /// # Panics
    /// When the number of operands is not the operation's arity.
    pub fn op(&mut self, op: Op, args: &[Value]) -> Value {
        assert_eq!(args.len(), op.args().len(), "operands of {}", op.name());
        let mut all = [Value(0); 3];
        all[..args.len()].copy_from_slice(args);
        self.value(Expr::Op { op, args: all })
    }

    /// A derivative.
    pub fn derivative(&mut self, axis: Axis, value: Value) -> Value {
        self.value(Expr::Derivative { axis, value })
    }

    /// A texture slot.
    pub fn texture(&mut self, decl: TextureDecl) -> Texture {
        self.module.textures.push(decl);
        Texture(self.module.textures.len() as u32 - 1)
    }

    /// A filtered sample, as its four components.
    pub fn sample(
        &mut self,
        texture: Texture,
        coords: [Value; 3],
        reference: Option<Value>,
        lod: Lod,
    ) -> [Value; 4] {
        let access = Access::FILTER;
        self.access(Sample { texture, access, coords, layer: None, reference, lod })
    }

    /// A texture access of any kind, as its four components.
    pub fn access(&mut self, sample: Sample) -> [Value; 4] {
        let sample = self.value(Expr::Sample(Box::new(sample)));
        [0, 1, 2, 3].map(|component| self.value(Expr::Component { sample, component }))
    }

    /// A new variable of one element; starts as zero.
    pub fn variable(&mut self, name: impl Into<String>, ty: Ty) -> Var {
        self.array(name, ty, 1)
    }

    /// A new variable of `len` elements; starts as zero.
    pub fn array(&mut self, name: impl Into<String>, ty: Ty, len: u32) -> Var {
        self.module.variables.push(Variable { ty, len, name: name.into() });
        Var(self.module.variables.len() as u32 - 1)
    }

    /// A new variable that holds an output.
    pub fn output(&mut self, output: Output) -> Var {
        let var = self.variable(format!("{output:?}"), Ty::F32);
        self.module.outputs.push((output, var));
        var
    }

    /// Emits a vertex: the current values of variables of one element, in the order of
    /// [`super::GeometryInterface::outputs`].
    pub fn emit_vertex(&mut self, outputs: &[Var]) {
        let values = outputs.iter().map(|var| self.load(*var)).collect();
        self.push(Stmt::EmitVertex(values));
    }

    /// The current value of a variable of one element.
    pub fn load(&mut self, var: Var) -> Value {
        self.value(Expr::Load(var))
    }

    /// Writes a variable of one element.
    pub fn store(&mut self, var: Var, value: Value) {
        self.push(Stmt::Store { var, value });
    }
}
