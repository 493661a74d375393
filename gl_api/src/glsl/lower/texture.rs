//! Texture lookups (GLSL 1.30 section 8.7).

use super::place::{Place, Slot};
use super::{Failure, Lowered, Lowerer, texture_key};
use crate::glsl::builtins::functions::{LodForm, Projection};
use crate::glsl::hir::Expr;
use crate::glsl::limits::MAX_DYNAMIC_SAMPLERS;
use crate::glsl::types::{Sampler, Type};
use rasterizer::ir::{Lod, Op, Texture, TextureDecl, Ty, Value};
use texunit::image::Shape;

/// A lookup, but for the texture.
struct Lookup {
    coords: [Value; 3],
    reference: Option<Value>,
    lod: Lod,
}

impl Lowerer<'_> {
    pub(super) fn texture(
        &mut self,
        projection: Projection,
        lod: LodForm,
        arguments: &[Expr],
        result: &Type,
    ) -> Lowered<Vec<Value>> {
        let [sampler, coords, rest @ ..] = arguments else {
            return Err(Failure("a texture lookup without coordinates".to_owned()));
        };
        let decl = match sampler.ty {
            Type::Sampler(Sampler::D2) => TextureDecl { shape: Shape::D2, compare: false },
            Type::Sampler(Sampler::D2Shadow) => TextureDecl { shape: Shape::D2, compare: true },
            Type::Sampler(Sampler::Cube) => TextureDecl { shape: Shape::Cube, compare: false },
            _ => return Err(Failure(format!("{} is not supported by DetGL yet", sampler.ty))),
        };
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
        let reference = decl.compare.then(|| coords.get(2).copied().unwrap_or(zero));
        let used = match decl.shape {
            Shape::D2 => 2,
            Shape::Cube => 3,
        };
        let three = |values: &[Value]| {
            [0, 1, 2].map(|i| if i < used { values.get(i).copied().unwrap_or(zero) } else { zero })
        };
        let coords = three(&coords);
        let mut rest = rest.iter().map(|expr| self.expr(expr)).collect::<Lowered<Vec<_>>>()?;
        let lod = match lod {
            LodForm::Implicit => Lod::Implicit { bias: None },
            LodForm::Bias => Lod::Implicit { bias: rest.pop().map(|bias| bias[0]) },
            LodForm::Explicit => Lod::Explicit(rest.pop().map_or(zero, |level| level[0])),
            LodForm::Gradient => {
                let dy = rest.pop().unwrap_or_default();
                let dx = rest.pop().unwrap_or_default();
                Lod::Gradient { dx: three(&dx), dy: three(&dy) }
            }
        };
        let lookup = Lookup { coords, reference, lod };
        let mut values = self.look_up(&place, decl, &lookup)?;
        values.truncate(result.scalars() as usize);
        Ok(values)
    }

    fn look_up(
        &mut self,
        place: &Place,
        decl: TextureDecl,
        lookup: &Lookup,
    ) -> Lowered<Vec<Value>> {
        let Slot::Uniform(word, types) = &place.slot else {
            return Err(Failure("a sampler that is no uniform".to_owned()));
        };
        let (first, types) = (word + place.base, types.clone());
        let Some(dynamic) = place.dynamic else {
            return Ok(self.sample(first, decl, lookup).to_vec());
        };
        // There is no texture by number in the IR: sample all, choose one.
        let count = types.len() as u32 - place.base;
        if count > MAX_DYNAMIC_SAMPLERS || types.iter().any(|&ty| ty != Ty::I32) {
            let message =
                "a sampler in a structure or large array, indexed by what is not constant";
            return Err(Failure(format!("{message}, is not supported by DetGL yet")));
        }
        let mut chosen = self.sample(first, decl, lookup);
        for index in 1..count {
            let other = self.sample(first + index, decl, lookup);
            let number = self.emit.uint(index);
            let here = self.emit.equal(dynamic, number);
            for (chosen, other) in chosen.iter_mut().zip(other) {
                *chosen = self.emit.select(here, other, *chosen);
            }
        }
        Ok(chosen.to_vec())
    }

    fn sample(&mut self, word: u32, decl: TextureDecl, lookup: &Lookup) -> [Value; 4] {
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
        self.emit.sample(texture, lookup.coords, lookup.reference, lookup.lod)
    }
}
