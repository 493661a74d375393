//! Texture lookups (GLSL 1.30 section 8.7).

use super::place::{Place, Slot};
use super::{Failure, Lowered, Lowerer, texture_key};
use crate::glsl::Scalar;
use crate::glsl::builtins::lookups::{LodForm, Lookup, Projection, Shift};
use crate::glsl::hir::Expr;
use crate::glsl::limits::MAX_DYNAMIC_SAMPLERS;
use crate::glsl::types::{Comparison, Dim, Sampler, Type};
use rasterizer::ir::{Lod, Op, Texture, TextureDecl, Ty, Value};
use texunit::image::Shape;

/// A lookup, but for the texture.
struct Access {
    coords: [Value; 3],
    reference: Option<Value>,
    lod: Lod,
}

/// The shape of texture that a sampler takes, if there are such textures.
fn shape(dim: Dim) -> Option<Shape> {
    match dim {
        Dim::D2 => Some(Shape::D2),
        Dim::Cube => Some(Shape::Cube),
        Dim::D1 | Dim::D3 | Dim::Rect | Dim::D1Array | Dim::D2Array => None,
    }
}

/// Why a lookup cannot be carried out.
pub fn unsupported(sampler: Sampler, lookup: Lookup) -> Option<String> {
    let ty = Type::Sampler(sampler);
    if shape(sampler.dim).is_none() || sampler.scalar != Scalar::Float {
        return Some(format!("there are no textures for {ty}"));
    }
    match lookup {
        Lookup::Sample(_, _, Shift::None) => None,
        Lookup::Sample(_, _, Shift::Texels) => Some("offsets are not applied".to_owned()),
        Lookup::Fetch(_) => Some("single texels cannot be fetched".to_owned()),
        Lookup::Size => Some("the size of a texture is not known to shaders".to_owned()),
    }
}

impl Lowerer<'_> {
    pub(super) fn texture(
        &mut self,
        lookup: Lookup,
        arguments: &[Expr],
        result: &Type,
    ) -> Lowered<Vec<Value>> {
        let [sampler, coords, rest @ ..] = arguments else {
            return Err(Failure("a texture lookup without coordinates".to_owned()));
        };
        let Type::Sampler(kind) = sampler.ty else {
            return Err(Failure(format!("{} is no sampler", sampler.ty)));
        };
        let (Some(shape), Lookup::Sample(projection, form, _)) = (shape(kind.dim), lookup) else {
            return Err(Failure(unsupported(kind, lookup).unwrap_or_default()));
        };
        let decl = TextureDecl { shape, compare: kind.comparison == Comparison::Yes };
        let place = self
            .place(sampler)?
            .ok_or_else(|| Failure("a sampler that is no uniform".to_owned()))?;

        let mut coords = self.expr(coords)?;
        if projection == Projection::Divide
            && let Some(q) = coords.pop()
        {
            coords = coords.iter().map(|&c| self.emit.op(Op::Div, &[c, q])).collect();
        }
        let zero = self.emit.float(0.0);
        let used = kind.dim.coords();
        // The reference is the third component, or the one after the coordinates.
        let reference = decl.compare.then(|| coords.get(used.max(2)).copied().unwrap_or(zero));
        let three = |values: &[Value]| {
            [0, 1, 2].map(|i| if i < used { values.get(i).copied().unwrap_or(zero) } else { zero })
        };
        let coords = three(&coords);
        let rest = rest.iter().map(|expr| self.expr(expr)).collect::<Lowered<Vec<_>>>()?;
        let scalar = |values: Option<&Vec<Value>>| values.and_then(|v| v.first()).copied();
        let lod = match form {
            LodForm::Implicit => Lod::Implicit { bias: None },
            LodForm::Bias => Lod::Implicit { bias: scalar(rest.last()) },
            LodForm::Explicit => Lod::Explicit(scalar(rest.first()).unwrap_or(zero)),
            LodForm::Gradient => {
                let derivative = |at: usize| three(rest.get(at).map_or(&[], |v| &v[..]));
                Lod::Gradient { dx: derivative(0), dy: derivative(1) }
            }
        };
        let access = Access { coords, reference, lod };
        let mut values = self.look_up(&place, decl, &access)?;
        values.truncate(result.scalars() as usize);
        Ok(values)
    }

    fn look_up(
        &mut self,
        place: &Place,
        decl: TextureDecl,
        access: &Access,
    ) -> Lowered<Vec<Value>> {
        let Slot::Uniform(word, types) = &place.slot else {
            return Err(Failure("a sampler that is no uniform".to_owned()));
        };
        let (first, types) = (word + place.base, types.clone());
        let Some(dynamic) = place.dynamic else {
            return Ok(self.sample(first, decl, access).to_vec());
        };
        // There is no texture by number in the IR: sample all, choose one.
        let count = types.len() as u32 - place.base;
        if count > MAX_DYNAMIC_SAMPLERS || types.iter().any(|&ty| ty != Ty::I32) {
            let message =
                "a sampler in a structure or large array, indexed by what is not constant";
            return Err(Failure(format!("{message}, is not supported by DetGL yet")));
        }
        let mut chosen = self.sample(first, decl, access);
        for index in 1..count {
            let other = self.sample(first + index, decl, access);
            let number = self.emit.uint(index);
            let here = self.emit.equal(dynamic, number);
            for (chosen, other) in chosen.iter_mut().zip(other) {
                *chosen = self.emit.select(here, other, *chosen);
            }
        }
        Ok(chosen.to_vec())
    }

    fn sample(&mut self, word: u32, decl: TextureDecl, access: &Access) -> [Value; 4] {
        let key = (word, texture_key(decl));
        let texture: Texture = match self.textures.get(&key) {
            Some(&texture) => texture,
            None => {
                let texture = self.emit.texture(decl);
                self.textures.insert(key, texture);
                self.samplers.push((texture, word));
                texture
            }
        };
        self.emit.sample(texture, access.coords, access.reference, access.lod)
    }
}
