//! Which lookups repeat the one before.

use crate::ir::{
    Access, Builder, Input, Interpolation, Lod, Op, Output, Sample, Stage, Stmt, Texture,
    TextureDecl, Value,
};
use crate::shader::Program;
use texunit::image::Shape;

/// A lookup in the second texture after one in the first, which is at `s`; gives one of its components.
type Second = fn(&mut Builder, Texture, [Value; 2]) -> Value;

fn at(b: &mut Builder, texture: Texture, coord: Value) -> Value {
    b.sample(texture, [coord; 3], None, Lod::Implicit { bias: None })[1]
}

fn with(b: &mut Builder, texture: Texture, coord: Value, access: Access, lod: Lod) -> Value {
    let coords = [coord; 3];
    b.access(Sample { texture, access, coords, layer: None, reference: None, lod })[0]
}

/// What the second lookup is, how many of the two repeat one, and how it is made.
const TABLE: [(&str, usize, Second); 7] = [
    ("at the same point", 1, |b, texture, [s, _]| at(b, texture, s)),
    ("at another point", 0, |b, texture, [_, t]| at(b, texture, t)),
    ("with a bias", 0, |b, texture, [s, t]| {
        with(b, texture, s, Access::FILTER, Lod::Implicit { bias: Some(t) })
    }),
    ("of a level that is told", 0, |b, texture, [s, t]| {
        with(b, texture, s, Access::FILTER, Lod::Explicit(t))
    }),
    ("texels further", 0, |b, texture, [s, _]| {
        with(b, texture, s, Access::Filter { offset: [1, 0, 0] }, Lod::Implicit { bias: None })
    }),
    ("of its level of detail", 0, |b, texture, [s, _]| {
        with(b, texture, s, Access::Lod, Lod::Implicit { bias: None })
    }),
    ("in some lanes", 0, |b, texture, [s, t]| {
        let found = b.variable("found", crate::ir::Ty::F32);
        let zero = b.float(0.0);
        let condition = b.op(Op::Less, &[t, zero]);
        b.begin();
        let texel = b.sample(texture, [s; 3], None, Lod::Explicit(s))[0];
        b.store(found, texel);
        let accept = b.end();
        b.push(Stmt::If { condition, accept, reject: vec![Stmt::Discard] });
        b.load(found)
    }),
];

#[test]
fn a_lookup_that_asks_for_the_same_as_the_one_before_repeats_it() {
    for (what, repeats, second) in TABLE {
        let mut b = Builder::new(Stage::Fragment);
        b.module_mut().varyings = vec![Interpolation::Smooth; 2];
        let out = b.output(Output::Color { target: 0, component: 0 });
        let textures = [0; 2].map(|_| b.texture(TextureDecl::color(Shape::D2)));
        let varyings = [0, 1].map(|slot| b.input(Input::Varying(slot)));
        let [first, ..] =
            b.sample(textures[0], [varyings[0]; 3], None, Lod::Implicit { bias: None });
        let second = second(&mut b, textures[1], varyings);
        // No product.
        let difference = b.op(Op::Sub, &[first, second]);
        b.store(out, difference);
        let module = b.finish();
        module.validate().unwrap_or_else(|error| panic!("{what}: {error}"));
        assert_eq!(Program::new(&module, |_| true).repeats.len(), repeats, "{what}");
    }
}
