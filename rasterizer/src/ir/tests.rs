//! What validation refuses, and what listings look like.

use super::*;
use texunit::image::Shape;

/// A fragment builder with varyings, and the red output.
fn fragment() -> (Builder, Var) {
    let mut b = Builder::new(Stage::Fragment);
    b.module_mut().varyings = vec![Interpolation::Smooth; 4];
    let red = b.output(Output::Color { target: 0, component: 0 });
    (b, red)
}

/// The handle does not matter.
fn ignore<T>(_: T) {}

#[test]
fn modules_that_break_a_rule_are_refused_with_the_rule() {
    type Breaker = fn(&mut Builder, Var, Value);
    let cases: &[(&str, Breaker)] = &[
        ("is F32, not I32", |b, _, s| ignore(b.op(Op::INeg, &[s]))),
        ("has not been evaluated", |b, out, s| {
            let value = b.op(Op::Neg, &[s]);
            b.begin();
            b.store(out, value);
            let store = b.end();
            let mut module = std::mem::replace(b, Builder::new(Stage::Fragment)).finish();
            module.body.splice(0..0, store);
            *b = refill(module);
        }),
        ("has ended", |b, out, s| {
            b.begin();
            let value = b.op(Op::Neg, &[s]);
            let block = b.end();
            b.push(Stmt::Scope(block));
            b.store(out, value);
        }),
        ("twice", |b, _, s| {
            let value = b.op(Op::Neg, &[s]);
            b.push(Stmt::Eval(value));
        }),
        ("break outside", |b, _, _| b.push(Stmt::Break)),
        ("continue outside", |b, _, _| {
            b.push(Stmt::Loop { body: vec![], continuing: vec![Stmt::Continue] });
        }),
        ("leave outside", |b, _, _| b.push(Stmt::Leave)),
        ("there is no v", |b, _, s| b.store(Var(99), s)),
        ("no elements", |b, _, _| ignore(b.array("none", Ty::F32, 0))),
        ("more than", |b, _, _| ignore(b.array("huge", Ty::F32, u32::MAX))),
        ("is an array", |b, _, s| {
            let array = b.array("a", Ty::F32, 2);
            b.store(array, s);
        }),
        ("no texture slot", |b, _, s| {
            ignore(b.sample(Texture(7), [s; 3], None, Lod::Implicit { bias: None }));
        }),
        ("compares and needs", |b, _, s| {
            let slot = b.texture(TextureDecl { compare: true, ..TextureDecl::color(Shape::D2) });
            ignore(b.sample(slot, [s; 3], None, Lod::Explicit(s)));
        }),
        ("needs a layer", |b, _, s| {
            let slot = b.texture(TextureDecl::color(Shape::CubeArray));
            ignore(b.sample(slot, [s; 3], None, Lod::Explicit(s)));
        }),
        ("has no layer", |b, _, s| {
            let texture = b.texture(TextureDecl::color(Shape::D2Array));
            let (access, coords, lod) = (Access::FILTER, [s; 3], Lod::Explicit(s));
            let (layer, reference) = (Some(s), None);
            ignore(b.access(Sample { texture, access, coords, layer, reference, lod }));
        }),
        ("whole sample", |b, out, s| {
            let texture = b.texture(TextureDecl::color(Shape::D2));
            let lod = Lod::Explicit(s);
            let (access, coords) = (Access::FILTER, [s; 3]);
            let sample = Sample { texture, access, coords, layer: None, reference: None, lod };
            let sample = b.value(Expr::Sample(Box::new(sample)));
            b.store(out, sample);
        }),
        ("in a Fragment module", |b, _, _| ignore(b.input(Input::VertexId))),
        ("is not declared", |b, _, _| ignore(b.input(Input::Varying(4)))),
        ("in a Fragment module", |b, _, _| ignore(b.output(Output::Position(0)))),
        ("no such component", |b, _, _| {
            ignore(b.output(Output::Color { target: 0, component: 4 }));
        }),
        ("twice", |b, _, _| ignore(b.output(Output::Color { target: 0, component: 0 }))),
        ("uniform word", |b, _, _| ignore(b.value(Expr::Uniform { word: 9, ty: Ty::F32 }))),
        ("bool 0x2", |b, _, _| ignore(b.constant(2, Ty::Bool))),
    ];
    for (rule, break_it) in cases {
        let (mut b, out) = fragment();
        let s = b.input(Input::Varying(0));
        break_it(&mut b, out, s);
        let error = b.finish().validate().expect_err(rule);
        assert!(error.0.contains(rule), "{error}, not {rule}");
    }
}

/// A builder that appends to a module.
fn refill(module: Module) -> Builder {
    let mut b = Builder::new(module.stage);
    let body = module.body.clone();
    *b.module_mut() = module;
    body.into_iter().for_each(|stmt| b.push(stmt));
    b
}

/// `while (true) { if (s <= red) break; red += 1 }`
fn count_up() -> Module {
    let (mut b, out) = fragment();
    let s = b.input(Input::Varying(0));
    let one = b.float(1.0);
    b.begin();
    let i = b.load(out);
    let over = b.op(Op::LessEqual, &[s, i]);
    b.push(Stmt::If { condition: over, accept: vec![Stmt::Break], reject: vec![] });
    let next = b.op(Op::Add, &[i, one]);
    b.store(out, next);
    let body = b.end();
    b.push(Stmt::Loop { body, continuing: vec![] });
    b.finish()
}

#[test]
fn listings_read_like_code() {
    let want = "\
Fragment
  v0: F32 // Color { target: 0, component: 0 }
  loop {
    %2 = v0
    %3 = less_equal Varying(0), %2
    if %3 {
      break
    }
    %4 = add %2, 1.0
    v0 = %4
  }
  Color { target: 0, component: 0 } = v0
";
    assert_eq!(count_up().to_string(), want);
}
