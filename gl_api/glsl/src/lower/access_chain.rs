//! Storage of variables, and access chains: loads and stores of elements, members and components.

use super::expr::not_a_variable;
use super::{LowerError, LowerResult, Lowerer};
use crate::builtins::variable::StateArray;
use crate::hir::{Expr, ExprKind, VarRef, Variable};
use crate::types::Type;
use rasterizer::ir::{Expr as IrExpr, Op, Stmt, Ty, Value, Var};
use std::rc::Rc;

/// Where the scalars of a variable are stored.
#[derive(Clone, Debug)]
pub enum VarStorage {
    /// Values that never change.
    Values(Rc<[Value]>),
    /// An IR variable for each scalar.
    Vars(Rc<[Var]>),
    /// IR arrays, one for each type of scalar, each as long as the variable.
    Arrays(Rc<Arrays>),
    /// Consecutive uniform words, from this one on.
    Uniform(u32, Rc<[Ty]>),
    /// State of each unit, light or plane: words per element, and the types of all scalars.
    States(StateArray, u32, Rc<[Ty]>),
    /// Part of another variable.
    Alias(Rc<AccessChain>),
}

/// The IR arrays of a variable that is dynamically indexed.
#[derive(Clone, Debug)]
pub struct Arrays {
    /// The type of each scalar.
    types: Rc<[Ty]>,
    /// The array of each type.
    vars: Vec<(Ty, Var)>,
}

/// A path from a variable to an element, member or components of it.
#[derive(Clone, Debug)]
pub struct AccessChain {
    /// The storage of the whole variable.
    pub storage: VarStorage,
    /// How many scalars the whole variable has.
    total: u32,
    /// The first scalar, without `dynamic_offset`.
    pub base: u32,
    /// A `u32` to add to it, below the total.
    pub dynamic_offset: Option<Value>,
    /// For each dynamic index: scalars from an element to the next, and the number of elements.
    pub index_strides: Vec<(u32, u32)>,
    /// The components of a swizzle.
    components: Option<Vec<u8>>,
    /// The type of what the path leads to.
    pub ty: Type,
}

/// The steps of a new IR variable, which has a name.
const VARIABLE: usize = 3;

impl AccessChain {
    /// The scalars that the path leads to, without `dynamic_offset`.
    fn offsets(&self) -> Vec<u32> {
        match &self.components {
            Some(components) => components.iter().map(|&c| self.base + u32::from(c)).collect(),
            None => (self.base..self.base + self.ty.scalars()).collect(),
        }
    }
}

impl Lowerer<'_> {
    /// New storage for a variable of these scalars: arrays if it is dynamically indexed.
    pub(super) fn new_storage(&mut self, variable: &Variable, types: &[Ty]) -> VarStorage {
        if variable.dynamically_indexed {
            VarStorage::Arrays(Rc::new(self.new_arrays(&variable.name, types)))
        } else {
            self.new_vars(&variable.name, types)
        }
    }

    /// New IR variables for scalars of these types.
    pub(super) fn new_vars(&mut self, name: &str, types: &[Ty]) -> VarStorage {
        self.emit.work.add(VARIABLE * types.len());
        let builder = &mut self.emit.builder;
        VarStorage::Vars(types.iter().map(|&ty| builder.variable(name, ty)).collect())
    }

    /// New IR arrays for scalars of these types.
    fn new_arrays(&mut self, name: &str, types: &[Ty]) -> Arrays {
        self.emit.work.add(types.len());
        let mut vars: Vec<(Ty, Var)> = Vec::new();
        for &ty in types {
            if !vars.iter().any(|(known, _)| *known == ty) {
                vars.push((ty, self.emit.builder.array(name, ty, types.len() as u32)));
            }
        }
        Arrays { types: types.into(), vars }
    }

    /// Writes every scalar of a variable.
    pub(super) fn fill(&mut self, storage: &VarStorage, values: &[Value]) {
        match storage {
            VarStorage::Vars(vars) => {
                for (&var, &value) in vars.iter().zip(values) {
                    self.emit.push(Stmt::Store { var, value });
                }
            }
            VarStorage::Arrays(arrays) => self.fill_arrays(arrays, values),
            VarStorage::Values(_)
            | VarStorage::Uniform(..)
            | VarStorage::States(..)
            | VarStorage::Alias(_) => {}
        }
    }

    fn fill_arrays(&mut self, arrays: &Arrays, values: &[Value]) {
        for (index, &value) in values.iter().enumerate() {
            self.store_element(arrays, index as u32, None, value);
        }
    }

    fn store_element(
        &mut self,
        arrays: &Arrays,
        at: u32,
        dynamic_offset: Option<Value>,
        value: Value,
    ) {
        let ty = arrays.types[at as usize];
        let found = arrays.vars.iter().find(|(known, _)| *known == ty);
        let Some(&(_, var)) = found else { return };
        let index = self.index(at, dynamic_offset);
        if arrays.types.len() == 1 {
            self.emit.push(Stmt::Store { var, value });
        } else {
            self.emit.push(Stmt::StoreAt { var, index, value });
        }
    }

    /// `at + dynamic` as a `u32`.
    fn index(&mut self, at: u32, dynamic_offset: Option<Value>) -> Value {
        let constant = self.emit.uint(at);
        match dynamic_offset {
            None => constant,
            Some(dynamic_offset) if at == 0 => dynamic_offset,
            Some(dynamic_offset) => self.emit.op(Op::UAdd, &[dynamic_offset, constant]),
        }
    }

    /// The storage of a variable.
    pub(super) fn storage(&mut self, var: VarRef) -> LowerResult<VarStorage> {
        let variable = self.variable(var);
        let known = match var {
            VarRef::Global(_) => self.globals.get(&variable.name).cloned(),
            // While a constant is folded, no local has storage.
            VarRef::Local(index) => self.frame().storages.get(index as usize).cloned().flatten(),
        };
        if let Some(storage) = known {
            return Ok(storage);
        }
        match &variable.constant {
            Some(words) => {
                let types = variable.ty.flat();
                Ok(VarStorage::Values(self.constants(words, &types).into()))
            }
            None => Err(LowerError(format!("`{}` has no storage here", variable.name))),
        }
    }

    /// The access chain of an expression; `None` if its root is no variable.
    pub(super) fn access_chain(&mut self, expr: &Expr) -> LowerResult<Option<AccessChain>> {
        if expr.root().is_none() {
            return Ok(None);
        }
        self.nested(|lowerer| lowerer.build_chain(expr)).map(Some)
    }

    fn build_chain(&mut self, expr: &Expr) -> LowerResult<AccessChain> {
        match &expr.kind {
            ExprKind::Var(var) => {
                let storage = self.storage(*var)?;
                let ty = self.variable(*var).ty.clone();
                Ok(match storage {
                    VarStorage::Alias(chain) => (*chain).clone(),
                    storage => AccessChain {
                        storage,
                        total: ty.scalars(),
                        base: 0,
                        dynamic_offset: None,
                        index_strides: Vec::new(),
                        components: None,
                        ty,
                    },
                })
            }
            ExprKind::Field(base, index) => {
                let mut chain = self.build_chain(base)?;
                if let Type::Struct(structure) = &base.ty {
                    let before = &structure.fields[..*index as usize];
                    chain.base += before.iter().map(|(_, ty)| ty.scalars()).sum::<u32>();
                }
                chain.ty = expr.ty.clone();
                Ok(chain)
            }
            ExprKind::Swizzle(base, components) => {
                let mut chain = self.build_chain(base)?;
                let inner = chain.components.take();
                let through = |&c: &u8| inner.as_ref().map_or(c, |inner| inner[usize::from(c)]);
                chain.components = Some(components.iter().map(through).collect());
                chain.ty = expr.ty.clone();
                Ok(chain)
            }
            ExprKind::Index(base, index) => {
                let chain = self.build_chain(base)?;
                let index = self.expr(index)?[0];
                // An unsized array in an array has its size from all indices, which the expression's type has not.
                let ty = match &chain.ty {
                    Type::Array(element, _) if expr.ty.is_unsized() => (**element).clone(),
                    Type::Array(..)
                    | Type::Void
                    | Type::Vector(..)
                    | Type::Matrix(..)
                    | Type::Struct(_)
                    | Type::Sampler(_)
                    | Type::Error => expr.ty.clone(),
                };
                self.element(chain, index, &ty)
            }
            ExprKind::Const(_)
            | ExprKind::Convert(_)
            | ExprKind::Unary(..)
            | ExprKind::Binary(..)
            | ExprKind::Assign(..)
            | ExprKind::IncDec(..)
            | ExprKind::Conditional(_)
            | ExprKind::Comma(_)
            | ExprKind::Construct(_)
            | ExprKind::Call(..)
            | ExprKind::Builtin(..)
            | ExprKind::Error => Err(not_a_variable()),
        }
    }

    /// Adds an index to a chain; an index out of range selects the last element.
    pub(super) fn element(
        &mut self,
        chain: AccessChain,
        index: Value,
        ty: &Type,
    ) -> LowerResult<AccessChain> {
        let stride = ty.scalars().max(1);
        let len = (chain.ty.scalars() / stride).max(1);
        let index = self.emit.convert(index, Ty::U32);
        let last = self.emit.uint(len - 1);
        let index = self.emit.op(Op::UMin, &[index, last]);
        let mut chain = chain;
        if let Some(known) = self.emit.known(index) {
            match &chain.components {
                Some(components) => chain.base += u32::from(components[known as usize]),
                None => chain.base += known * stride,
            }
            chain.components = None;
        } else {
            let offset = match chain.components.take() {
                Some(components) => self.swizzled(&components, index),
                None => {
                    chain.index_strides.push((stride, len));
                    let stride = self.emit.uint(stride);
                    self.emit.op(Op::UMul, &[index, stride])
                }
            };
            chain.dynamic_offset = Some(match chain.dynamic_offset {
                Some(other) => self.emit.op(Op::UAdd, &[other, offset]),
                None => offset,
            });
        }
        chain.ty = ty.clone();
        Ok(chain)
    }

    /// The component that element `index` of a swizzle selects.
    fn swizzled(&mut self, components: &[u8], index: Value) -> Value {
        let mut chosen = self.emit.uint(0);
        for (at, &component) in components.iter().enumerate() {
            let (at, component) = (self.emit.uint(at as u32), self.emit.uint(component.into()));
            let here = self.emit.equal(index, at);
            chosen = self.emit.select(here, component, chosen);
        }
        chosen
    }

    /// A chain to these values.
    pub(super) fn value_chain(values: Vec<Value>, ty: Type) -> AccessChain {
        let total = values.len() as u32;
        let storage = VarStorage::Values(values.into());
        let (dynamic_offset, index_strides) = (None, Vec::new());
        AccessChain { storage, total, base: 0, dynamic_offset, index_strides, components: None, ty }
    }

    /// Loads what a chain leads to.
    pub(super) fn load(&mut self, chain: &AccessChain) -> LowerResult<Vec<Value>> {
        let offsets = chain.offsets();
        self.emit.work.add(offsets.len());
        let storage = chain.storage.clone();
        match (&storage, chain.dynamic_offset) {
            (VarStorage::Values(values), None) => {
                Ok(offsets.iter().map(|&at| values[at as usize]).collect())
            }
            (VarStorage::Vars(vars), None) => {
                Ok(offsets.iter().map(|&at| self.emit.load(vars[at as usize])).collect())
            }
            (VarStorage::Values(values), Some(dynamic_offset)) => {
                let spilt = self.spill(values);
                Ok(self.load_elements(&spilt, &offsets, Some(dynamic_offset)))
            }
            (VarStorage::Vars(vars), Some(dynamic_offset)) => {
                let values: Vec<Value> = vars.iter().map(|&var| self.emit.load(var)).collect();
                let spilt = self.spill(&values);
                Ok(self.load_elements(&spilt, &offsets, Some(dynamic_offset)))
            }
            (VarStorage::Arrays(arrays), dynamic_offset) => {
                let arrays = arrays.clone();
                Ok(self.load_elements(&arrays, &offsets, dynamic_offset))
            }
            (VarStorage::Uniform(word, types), None) => {
                let load = |&at: &u32| self.emit.uniform(word + at, types[at as usize]);
                Ok(offsets.iter().map(load).collect())
            }
            (VarStorage::Uniform(word, types), Some(index)) => {
                let load = |&at: &u32| {
                    let (base, len, ty) = (word + at, chain.total - at, types[at as usize]);
                    let uniforms = &mut self.emit.builder.module_mut().uniform_words;
                    *uniforms = (*uniforms).max(word + chain.total);
                    self.emit.value(IrExpr::UniformAt { base, len, index, ty }, ty)
                };
                Ok(offsets.iter().map(load).collect())
            }
            (VarStorage::States(array, stride, types), None) => {
                let load = |&at: &u32| {
                    let word = self.words.state(array.element((at / stride) as u8));
                    self.emit.uniform(word + at % stride, types[at as usize])
                };
                Ok(offsets.iter().map(load).collect())
            }
            (VarStorage::States(array, _, types), Some(_)) => {
                let storage = VarStorage::Uniform(self.words.array(*array), types.clone());
                self.load(&AccessChain { storage, ..chain.clone() })
            }
            (VarStorage::Alias(_), _) => Err(LowerError("an alias of an alias".to_owned())),
        }
    }

    fn load_elements(
        &mut self,
        arrays: &Arrays,
        offsets: &[u32],
        dynamic_offset: Option<Value>,
    ) -> Vec<Value> {
        let mut values = Vec::with_capacity(offsets.len());
        for &at in offsets {
            let ty = arrays.types[at as usize];
            let found = arrays.vars.iter().find(|(known, _)| *known == ty);
            let Some(&(_, var)) = found else { continue };
            let index = self.index(at, dynamic_offset);
            values.push(if arrays.types.len() == 1 {
                self.emit.load(var)
            } else {
                self.emit.load_at(var, index)
            });
        }
        values
    }

    /// Copies values into IR arrays, for a dynamic index.
    fn spill(&mut self, values: &[Value]) -> Arrays {
        let types: Vec<Ty> = values.iter().map(|&value| self.emit.ty(value)).collect();
        let arrays = self.new_arrays("spilt", &types);
        self.fill_arrays(&arrays, values);
        arrays
    }

    /// Stores to what a chain leads to.
    pub(super) fn store(&mut self, chain: &AccessChain, values: &[Value]) -> LowerResult<()> {
        let offsets = chain.offsets();
        match (&chain.storage, chain.dynamic_offset) {
            (VarStorage::Vars(vars), None) => {
                for (&at, &value) in offsets.iter().zip(values) {
                    self.emit.push(Stmt::Store { var: vars[at as usize], value });
                }
                Ok(())
            }
            (VarStorage::Arrays(arrays), dynamic_offset) => {
                let arrays = arrays.clone();
                for (&at, &value) in offsets.iter().zip(values) {
                    self.store_element(&arrays, at, dynamic_offset, value);
                }
                Ok(())
            }
            (VarStorage::Vars(_), Some(_))
            | (
                VarStorage::Values(_)
                | VarStorage::Uniform(..)
                | VarStorage::States(..)
                | VarStorage::Alias(_),
                _,
            ) => Err(not_a_variable()),
        }
    }
}
