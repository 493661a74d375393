//! Texture lookups (GLSL 1.30 section 8.7).

use super::access_chain::{AccessChain, VarStorage};
use super::{LowerError, LowerResult, Lowerer, texture_key};
use crate::builtins::texture_lookup::{LodSource, Lookup, Projection, TexelOffset};
use crate::hir::Expr;
use crate::limits::MAX_DYNAMIC_SAMPLERS;
use crate::types::{Comparison, ComparisonResult, Dim, Sampler, Scalar, Type};
use rasterizer::driver::MAX_SAMPLES;
use rasterizer::ir::{self, Lod, Op, Texture, TextureDecl, Ty, Value};
use texunit::image::Shape;

/// The operands of a lookup, without the texture.
struct LookupOperands {
    access: ir::Access,
    coords: [Value; 3],
    layer: Option<Value>,
    reference: Option<Value>,
    lod: Lod,
    comparison_result: ComparisonResult,
}

/// The shape of texture that a sampler takes; the samples of a multisample texture are layers.
fn shape(dim: Dim) -> Shape {
    match dim {
        Dim::D1 | Dim::Buffer => Shape::D1,
        Dim::D2 | Dim::External => Shape::D2,
        Dim::D3 => Shape::D3,
        Dim::Cube => Shape::Cube,
        Dim::Rect => Shape::Rect,
        Dim::D1Array => Shape::D1Array,
        Dim::D2Array | Dim::D2Multisample | Dim::D2MultisampleArray => Shape::D2Array,
        Dim::CubeArray => Shape::CubeArray,
    }
}

/// The declaration of the texture slot that a sampler needs.
fn texture_decl(sampler: Sampler) -> TextureDecl {
    let texels = match sampler.scalar {
        Scalar::Float | Scalar::Bool => Ty::F32,
        Scalar::Int => Ty::I32,
        Scalar::Uint => Ty::U32,
    };
    let compare = sampler.comparison == Comparison::Yes;
    TextureDecl { shape: shape(sampler.dim), compare, texels }
}

/// For dynamic indices, each with the words from an element to the next and the number of elements:
/// the offset in words of element `number` in the order of all combinations.
fn offset_of(mut number: u32, index_strides: &[(u32, u32)]) -> u32 {
    let mut offset = 0;
    for (stride, len) in index_strides {
        offset += number % len * stride;
        number /= len;
    }
    offset
}

/// The arguments of a lookup after the sampler.
struct LookupArguments<'a> {
    kind: Sampler,
    values: &'a [Vec<Value>],
    /// 0 and 0.0.
    zeros: [Value; 2],
    /// The result of a comparison.
    comparison_result: ComparisonResult,
}

impl LookupArguments<'_> {
    fn scalar(&self, at: Option<usize>) -> Option<Value> {
        self.values.get(at?).and_then(|values| values.first()).copied()
    }

    /// The first components, as many as the texture has coordinates; the others are `zero`.
    fn three(&self, values: &[Value], zero: Value) -> [Value; 3] {
        let used = self.kind.dim.coords();
        [0, 1, 2].map(|i| if i < used { values.get(i).copied().unwrap_or(zero) } else { zero })
    }
}

impl Lowerer<'_> {
    pub(super) fn texture(
        &mut self,
        lookup: Lookup,
        arguments: &[Expr],
        result: &Type,
    ) -> LowerResult<Vec<Value>> {
        let [sampler, rest @ ..] = arguments else {
            return Err(LowerError("a texture lookup without a sampler".to_owned()));
        };
        let Type::Sampler(kind) = sampler.ty else {
            return Err(LowerError(format!("{} is no sampler", sampler.ty)));
        };
        let chain = self
            .access_chain(sampler)?
            .ok_or_else(|| LowerError("a sampler that is no uniform".to_owned()))?;
        let values = rest.iter().map(|expr| self.expr(expr)).collect::<LowerResult<Vec<_>>>()?;
        let zeros = [self.emit.constant(0, Ty::I32), self.emit.float(0.0)];
        let comparison_result = match (kind.comparison, result.scalars()) {
            (Comparison::Yes, 1) => ComparisonResult::Scalar,
            (Comparison::Yes | Comparison::No, _) => ComparisonResult::DepthTextureMode,
        };
        let arguments = LookupArguments { kind, values: &values, zeros, comparison_result };
        let access = match lookup {
            Lookup::Sample(projection, form, shift) => {
                self.sample_access(&arguments, projection, form, shift)
            }
            Lookup::Gather(shift) => {
                let at = (shift == TexelOffset::Constant).then_some(1);
                let [s, t, _] = self.texel_offset(&arguments, at);
                let (projection, form) = (Projection::None, LodSource::Implicit);
                let sample = self.sample_access(&arguments, projection, form, TexelOffset::None);
                LookupOperands { access: ir::Access::Gather { offset: [s, t] }, ..sample }
            }
            Lookup::Fetch(shift) => self.fetch_access(&arguments, shift),
            Lookup::Size | Lookup::QueryLevels => {
                let [zero, _] = zeros;
                let lod = Lod::Explicit(arguments.scalar(Some(0)).unwrap_or(zero));
                let comparison_result = ComparisonResult::DepthTextureMode;
                LookupOperands {
                    access: ir::Access::Size,
                    coords: [zero; 3],
                    layer: None,
                    reference: None,
                    lod,
                    comparison_result,
                }
            }
            Lookup::QueryLod => {
                let [_, zero] = zeros;
                let coords = arguments.three(values.first().map_or(&[], |v| &v[..]), zero);
                let lod = Lod::Implicit { bias: None };
                let (layer, reference, comparison_result) =
                    (None, None, ComparisonResult::DepthTextureMode);
                LookupOperands {
                    access: ir::Access::Lod,
                    coords,
                    layer,
                    reference,
                    lod,
                    comparison_result,
                }
            }
        };
        let mut values = self.select_sampler(&chain, kind, &access)?;
        if (lookup, kind.dim) == (Lookup::Size, Dim::D2MultisampleArray) {
            let samples = self.emit.constant(MAX_SAMPLES as u32, Ty::I32);
            values[2] = self.emit.op(Op::IDiv, &[values[2], samples]);
        }
        if lookup == Lookup::QueryLevels {
            values = vec![values[3]];
        }
        values.truncate(result.scalars() as usize);
        Ok(values)
    }

    fn sample_access(
        &mut self,
        arguments: &LookupArguments<'_>,
        projection: Projection,
        form: LodSource,
        shift: TexelOffset,
    ) -> LookupOperands {
        let LookupArguments { kind, values, zeros: [_, zero], comparison_result } = *arguments;
        let mut coords = values.first().cloned().unwrap_or_default();
        if projection == Projection::Divide
            && let Some(q) = coords.pop()
        {
            coords = coords.iter().map(|&c| self.emit.op(Op::Div, &[c, q])).collect();
        }
        let compares = kind.comparison == Comparison::Yes;
        let layer = match kind.dim {
            Dim::CubeArray => Some(coords.get(3).copied().unwrap_or(zero)),
            Dim::D1
            | Dim::D2
            | Dim::D3
            | Dim::Cube
            | Dim::Rect
            | Dim::D1Array
            | Dim::D2Array
            | Dim::D2Multisample
            | Dim::D2MultisampleArray
            | Dim::Buffer
            | Dim::External => None,
        };
        if compares && layer.is_some() {
            // The coordinates have four components: the reference is an argument of its own.
            coords.extend(arguments.scalar(Some(1)));
        }
        // The reference is the third component, or the one after the coordinates.
        let behind = kind.dim.coords().max(2);
        let reference = compares.then(|| coords.get(behind).copied().unwrap_or(zero));
        let last = values.len().checked_sub(1);
        // The offset comes before the bias.
        let bias = if form == LodSource::Bias { last } else { None };
        let offset = match (shift, bias) {
            (TexelOffset::None, _) => None,
            (TexelOffset::Constant, None) => last,
            (TexelOffset::Constant, Some(bias)) => bias.checked_sub(1),
        };
        let lod = match form {
            LodSource::Implicit | LodSource::Bias => Lod::Implicit { bias: arguments.scalar(bias) },
            LodSource::Explicit => Lod::Explicit(arguments.scalar(Some(1)).unwrap_or(zero)),
            LodSource::Gradient => {
                let derivative =
                    |at: usize| arguments.three(values.get(at).map_or(&[], |v| &v[..]), zero);
                Lod::Gradient { dx: derivative(1), dy: derivative(2), bias: None }
            }
        };
        let access = ir::Access::Filter { offset: self.texel_offset(arguments, offset) };
        LookupOperands {
            access,
            coords: arguments.three(&coords, zero),
            layer,
            reference,
            lod,
            comparison_result,
        }
    }

    fn fetch_access(
        &mut self,
        arguments: &LookupArguments<'_>,
        shift: TexelOffset,
    ) -> LookupOperands {
        let LookupArguments { kind, values, zeros: [zero, _], comparison_result } = *arguments;
        let coords = arguments.three(values.first().map_or(&[], |v| &v[..]), zero);
        if let Dim::D2Multisample | Dim::D2MultisampleArray = kind.dim {
            let number = arguments.scalar(Some(1)).unwrap_or(zero);
            return self.sample_fetch(coords, number, zero);
        }
        let (level, offset) = match (kind.dim, shift) {
            (Dim::Rect | Dim::Buffer, TexelOffset::None) => (None, None),
            (Dim::Rect, TexelOffset::Constant) => (None, Some(1)),
            (_, TexelOffset::None) => (Some(1), None),
            (_, TexelOffset::Constant) => (Some(1), Some(2)),
        };
        let lod = Lod::Explicit(arguments.scalar(level).unwrap_or(zero));
        let access = ir::Access::Fetch { offset: self.texel_offset(arguments, offset) };
        LookupOperands { access, coords, layer: None, reference: None, lod, comparison_result }
    }

    /// A fetch of a sample: the samples of a layer are consecutive layers.
    fn sample_fetch(
        &mut self,
        [x, y, layer]: [Value; 3],
        number: Value,
        zero: Value,
    ) -> LookupOperands {
        let samples = self.emit.constant(MAX_SAMPLES as u32, Ty::I32);
        let first = self.emit.op(Op::IMul, &[layer, samples]);
        let coords = [x, y, self.emit.op(Op::IAdd, &[first, number])];
        let (access, lod) = (ir::Access::Fetch { offset: [0; 3] }, Lod::Explicit(zero));
        let comparison_result = ComparisonResult::DepthTextureMode;
        LookupOperands { access, coords, layer: None, reference: None, lod, comparison_result }
    }

    /// A constant offset, which the checker has evaluated; 0 if there is none.
    fn texel_offset(&self, arguments: &LookupArguments<'_>, at: Option<usize>) -> [i32; 3] {
        let mut offset = [0; 3];
        let values = at.and_then(|at| arguments.values.get(at)).into_iter().flatten();
        for (offset, value) in offset.iter_mut().zip(values) {
            *offset = self.emit.known(*value).unwrap_or(0) as i32;
        }
        offset
    }

    fn select_sampler(
        &mut self,
        chain: &AccessChain,
        kind: Sampler,
        access: &LookupOperands,
    ) -> LowerResult<Vec<Value>> {
        let VarStorage::Uniform(word, _) = &chain.storage else {
            return Err(LowerError("a sampler that is no uniform".to_owned()));
        };
        let first = word + chain.base;
        let Some(dynamic_offset) = chain.dynamic_offset else {
            return Ok(self.sample(first, kind, access).to_vec());
        };
        // The IR has no dynamic texture index: sample all, select one.
        let count =
            chain.index_strides.iter().fold(1, |count: u32, (_, len)| count.saturating_mul(*len));
        if count > MAX_DYNAMIC_SAMPLERS {
            return Err(LowerError(format!(
                "one of {count} samplers, indexed by what is not constant, is not supported by \
                 DetGL yet: {MAX_DYNAMIC_SAMPLERS} are the most"
            )));
        }
        let mut chosen = self.sample(first, kind, access);
        for index in 1..count {
            let offset = offset_of(index, &chain.index_strides);
            let other = self.sample(first + offset, kind, access);
            let number = self.emit.uint(offset);
            let here = self.emit.equal(dynamic_offset, number);
            for (chosen, other) in chosen.iter_mut().zip(other) {
                *chosen = self.emit.select(here, other, *chosen);
            }
        }
        Ok(chosen.to_vec())
    }

    fn sample(&mut self, word: u32, kind: Sampler, access: &LookupOperands) -> [Value; 4] {
        let decl = texture_decl(kind);
        let key = (word, texture_key(decl), access.comparison_result);
        let texture: Texture = match self.textures.get(&key) {
            Some(&texture) => texture,
            None => {
                let texture = self.emit.texture(decl);
                self.textures.insert(key, texture);
                self.samplers.push((texture, word, kind.dim, access.comparison_result));
                texture
            }
        };
        let LookupOperands { access, coords, layer, reference, lod, .. } = *access;
        self.emit.access(ir::Sample { texture, access, coords, layer, reference, lod })
    }
}
