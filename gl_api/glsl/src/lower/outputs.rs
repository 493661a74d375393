//! Outputs of a stage; some are copied at the end of `main`.

use super::access_chain::VarStorage;
use super::{LowerResult, Lowerer};
use crate::builtins::expand::geometric::dot_product;
use crate::hir::Variable;
use crate::interface::{StateVar, VARYING_CLIP_DISTANCE};
use crate::limits::MAX_CLIP_PLANES;
use rasterizer::ir::{Op, Output, Stage, Stmt, Ty, Value, Var};

/// A scalar to copy to an output at the end of `main`.
#[derive(Debug)]
pub struct OutputCopy {
    /// The storage of its variable.
    pub storage: VarStorage,
    /// Its index in the variable.
    pub at: u32,
    /// The value to copy.
    pub source: CopySource,
    /// Where it goes.
    pub target: CopyTarget,
}

/// Where a copied scalar goes.
#[derive(Clone, Copy, Debug)]
pub enum CopyTarget {
    /// To the variable of an output, at the end of `main`.
    Var(Var),
    /// To this output of each vertex that is emitted.
    Emitted(Output),
}

/// The value that is copied to an output.
#[derive(Clone, Copy, Debug)]
pub enum CopySource {
    /// The scalar as a float.
    Value,
    /// The low 16 bits.
    LowHalf,
    /// The high 16 bits.
    HighHalf,
    /// The scalar if this user clip plane is enabled, else 0, which clips nothing.
    ClipDistance(u8),
    /// The dot product of the vector that begins at the scalar with this user clip plane, if it is
    /// enabled, else 0.
    ClipVertex(u8),
}

impl Lowerer<'_> {
    /// Makes a variable a varying output.
    pub(super) fn varying_output(
        &mut self,
        storage: &VarStorage,
        types: &[Ty],
        first: u16,
        copies: &mut Vec<OutputCopy>,
    ) {
        let mut next = first;
        for (at, &ty) in types.iter().enumerate() {
            let at = at as u32;
            if ty == Ty::F32 {
                self.output(storage, types, at, Output::Varying(next), copies);
                next += 1;
                continue;
            }
            for source in [CopySource::LowHalf, CopySource::HighHalf] {
                let target = self.copy_target(Output::Varying(next));
                copies.push(OutputCopy { storage: storage.clone(), at, source, target });
                next += 1;
            }
        }
    }

    /// Makes scalar `at` of a variable an output: its own IR variable if the types agree, else a
    /// copy.
    pub(super) fn output(
        &mut self,
        storage: &VarStorage,
        types: &[Ty],
        at: u32,
        output: Output,
        copies: &mut Vec<OutputCopy>,
    ) {
        if self.is_geometry() {
            let target = CopyTarget::Emitted(output);
            copies.push(OutputCopy {
                storage: storage.clone(),
                at,
                source: CopySource::Value,
                target,
            });
            return;
        }
        // The stencil reference is an integer; colours for integer attachments stay integers.
        let own = types[at as usize];
        let ty = match output {
            Output::Color { .. } if matches!(own, Ty::I32 | Ty::U32) => own,
            Output::StencilReference
            | Output::SampleMask
            | Output::Layer
            | Output::PrimitiveId
            | Output::ViewportIndex => Ty::I32,
            Output::Color { .. }
            | Output::SecondColor(_)
            | Output::Position(_)
            | Output::PointSize
            | Output::ClipDistance(_)
            | Output::CullDistance(_)
            | Output::Varying(_)
            | Output::Depth => Ty::F32,
        };
        if let VarStorage::Vars(vars) = storage
            && own == ty
        {
            let var = vars[at as usize];
            self.emit.builder.module_mut().outputs.push((output, var));
            return;
        }
        let var = self.emit.builder.variable(format!("{output:?}"), ty);
        self.emit.builder.module_mut().outputs.push((output, var));
        let target = CopyTarget::Var(var);
        copies.push(OutputCopy { storage: storage.clone(), at, source: CopySource::Value, target });
    }

    /// Whether outputs are those of emitted vertices.
    pub(super) fn is_geometry(&self) -> bool {
        self.emit.builder.module().stage == Stage::Geometry
    }

    /// Where what is copied to an output goes.
    fn copy_target(&mut self, output: Output) -> CopyTarget {
        match self.is_geometry() {
            true => CopyTarget::Emitted(output),
            false => CopyTarget::Var(self.emit.builder.output(output)),
        }
    }

    /// Emits a vertex.
    pub(super) fn emit_vertex(&mut self) -> LowerResult<()> {
        let copies = std::rc::Rc::clone(&self.emitted);
        let mut values = Vec::with_capacity(copies.len());
        for copy in copies.iter() {
            let value = self.copied(copy)?;
            let CopyTarget::Emitted(output) = copy.target else { continue };
            values.push(self.emit.convert(value, output.emitted_ty()));
        }
        self.emit.push(Stmt::EmitVertex(values));
        Ok(())
    }

    pub(super) fn copy(&mut self, copy: &OutputCopy) -> LowerResult<()> {
        let CopyTarget::Var(var) = copy.target else { return Ok(()) };
        let value = self.copied(copy)?;
        let ty = self.emit.builder.module_mut().variables[var.0 as usize].ty;
        let value = self.emit.convert(value, ty);
        self.emit.push(Stmt::Store { var, value });
        Ok(())
    }

    /// The value to copy.
    fn copied(&mut self, copy: &OutputCopy) -> LowerResult<Value> {
        let mut chain = Self::value_chain(Vec::new(), crate::types::FLOAT);
        chain.storage = copy.storage.clone();
        chain.base = copy.at;
        if let CopySource::ClipVertex(_) = copy.source {
            chain.ty = crate::types::vec(4);
        }
        let words = self.load(&chain)?;
        let word = words[0];
        Ok(match copy.source {
            CopySource::Value => word,
            CopySource::LowHalf => {
                let bits = self.emit.convert(word, Ty::U32);
                let mask = self.emit.uint(0xffff);
                self.emit.op(Op::BitAnd, &[bits, mask])
            }
            CopySource::HighHalf => {
                let bits = self.emit.convert(word, Ty::U32);
                let sixteen = self.emit.uint(16);
                self.emit.op(Op::UShiftRight, &[bits, sixteen])
            }
            CopySource::ClipDistance(plane) => self.if_enabled(plane, word),
            CopySource::ClipVertex(plane) => {
                let first = self.words.state(StateVar::ClipPlane(plane));
                let plane_words: Vec<Value> =
                    (0..4).map(|i| self.emit.uniform(first + i, Ty::F32)).collect();
                let distance = dot_product(&mut self.emit, &plane_words, &words);
                self.if_enabled(plane, distance)
            }
        })
    }

    /// A distance if a user clip plane is enabled, else 0.
    fn if_enabled(&mut self, plane: u8, distance: Value) -> Value {
        let word = self.words.state(StateVar::ClipEnables) + u32::from(plane);
        let enabled = self.emit.uniform(word, Ty::F32);
        let enabled = self.emit.convert(enabled, Ty::Bool);
        let zero = self.emit.float(0.0);
        self.emit.select(enabled, distance, zero)
    }

    pub(super) fn clip_vertex(
        &mut self,
        variable: &Variable,
        types: &[Ty],
        copies: &mut Vec<OutputCopy>,
    ) -> VarStorage {
        let storage = self.new_storage(variable, types);
        if variable.written {
            for plane in 0..MAX_CLIP_PLANES {
                let target = self.copy_target(Output::ClipDistance(plane));
                let source = CopySource::ClipVertex(plane);
                copies.push(OutputCopy { storage: storage.clone(), at: 0, source, target });
            }
        }
        storage
    }

    pub(super) fn clip_distances(
        &mut self,
        variable: &Variable,
        types: &[Ty],
        copies: &mut Vec<OutputCopy>,
    ) -> VarStorage {
        let storage = self.new_storage(variable, types);
        if variable.written {
            for plane in 0..types.len() as u8 {
                let (at, source) = (plane.into(), CopySource::ClipDistance(plane));
                let target = self.copy_target(Output::ClipDistance(plane));
                copies.push(OutputCopy { storage: storage.clone(), at, source, target });
            }
            // The linker asks the geometry stage for them, whose vertices hold little.
            if !self.is_geometry() {
                self.varying_output(&storage, types, VARYING_CLIP_DISTANCE, copies);
            }
        }
        storage
    }
}
