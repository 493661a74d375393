//! Built-in functions and operators of extreme numbers: a call has the same bits when it is folded, when it is
//! uniform over the draw, and per lane, in every instruction set; and the value is that of `f64`.

use gl_api::glsl::{Bindings, Options, Stage, compile, link};
use rasterizer::ir::{Input, Module, Output};
use rasterizer::shader::{Invocation, Machine, Program};
use texunit::lanes::{Isa, LANES};

/// Zeros, subnormals, limits of domains, neighbours of integers, numbers whose squares overflow.
const VALUES: [f32; 40] = [
    0.0,
    -0.0,
    1.0e-45,
    -1.0e-45,
    1.0e-40,
    f32::MIN_POSITIVE,
    -f32::MIN_POSITIVE,
    3.0e-23,
    1.0e-10,
    -1.0e-10,
    0.25,
    0.499_999_97,
    0.5,
    -0.5,
    0.999_999_94,
    -0.999_999_94,
    1.0,
    -1.0,
    1.000_000_1,
    -1.000_000_1,
    1.5,
    -2.0,
    2.5,
    -2.5,
    3.0,
    std::f32::consts::PI,
    -100.5,
    88.722_84,
    -103.972_08,
    128.0,
    8_388_607.5,
    -8_388_609.0,
    4_294_967_296.0,
    3.0e9,
    1.0e19,
    -1.0e30,
    f32::MAX,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
];

type Exact = fn(f64, f64) -> f64;

/// An expression of `a`, `b` and `c`; the allowed error in units of the last place, and the exact function.
struct Row(&'static str, f64, Option<Exact>);

const fn same(expression: &'static str) -> Row {
    Row(expression, 0.0, None)
}

const fn near(expression: &'static str, ulps: f64, exact: Exact) -> Row {
    Row(expression, ulps, Some(exact))
}

/// An angle, reduced by whole turns if it is large, because the sine of `std` depends on the platform.
fn reduced_angle(angle: f64) -> f64 {
    const LARGE: [(f32, f64); 3] = [
        (1e19, 0.616_395_631_128_473),
        (1e30, -2.228_883_718_032_495_4),
        (f32::MAX, -0.549_049_329_957_454_3),
    ];
    let found = LARGE.into_iter().find(|(large, _)| f64::from(*large) == angle.abs());
    found.map_or(angle, |(_, rest)| rest * angle.signum())
}

const TABLE: &[Row] = &[
    near("radians(a)", 2.0, |a, _| a.to_radians()),
    near("degrees(a)", 2.0, |a, _| a.to_degrees()),
    near("sin(a)", 0.6, |a, _| reduced_angle(a).sin()),
    near("cos(a)", 0.6, |a, _| reduced_angle(a).cos()),
    near("tan(a)", 0.6, |a, _| reduced_angle(a).tan()),
    near("asin(a)", 0.6, |a, _| a.asin()),
    near("acos(a)", 0.6, |a, _| a.acos()),
    near("atan(a)", 0.6, |a, _| a.atan()),
    near("atan(a, b)", 0.6, f64::atan2),
    near("sinh(a)", 0.6, |a, _| a.sinh()),
    near("cosh(a)", 0.6, |a, _| a.cosh()),
    near("tanh(a)", 0.6, |a, _| a.tanh()),
    near("asinh(a)", 0.6, |a, _| a.abs().asinh().copysign(a)),
    near("acosh(a)", 0.6, |a, _| a.acosh()),
    near("atanh(a)", 0.6, |a, _| a.atanh()),
    near("pow(a, b)", 0.7, f64::powf),
    near("exp(a)", 0.6, |a, _| a.exp()),
    near("exp2(a)", 0.6, |a, _| a.exp2()),
    near("log(a)", 0.6, |a, _| a.ln()),
    near("log2(a)", 0.6, |a, _| a.log2()),
    near("sqrt(a)", 0.5, |a, _| a.sqrt()),
    near("inversesqrt(a)", 1.5, |a, _| 1.0 / a.sqrt()),
    near("abs(a)", 0.0, |a, _| a.abs()),
    near("floor(a)", 0.0, |a, _| a.floor()),
    near("ceil(a)", 0.0, |a, _| a.ceil()),
    near("trunc(a)", 0.0, |a, _| a.trunc()),
    near("roundEven(a)", 0.0, |a, _| a.round_ties_even()),
    near("fract(a)", 0.5, |a, _| a - a.floor()),
    near("a + b", 0.5, |a, b| a + b),
    near("a - b", 0.5, |a, b| a - b),
    near("a * b", 0.5, |a, b| a * b),
    near("a / b", 0.5, |a, b| a / b),
    same("round(a)"),
    same("sign(a)"),
    same("mod(a, b)"),
    same("min(a, b)"),
    same("max(a, b)"),
    same("clamp(a, b, c)"),
    same("mix(a, b, c)"),
    same("mix(a, b, c > 0.0)"),
    same("step(a, b)"),
    same("smoothstep(a, b, c)"),
    same("float(isnan(a))"),
    same("float(isinf(a))"),
    same("length(a)"),
    same("length(vec2(a, b))"),
    same("length(vec3(a, b, c))"),
    same("distance(a, b)"),
    same("distance(vec3(a, b, c), vec3(b, c, a))"),
    same("dot(vec2(a, b), vec2(c, a))"),
    same("dot(vec4(a, b, c, a), vec4(c, b, b, a))"),
    same("cross(vec3(a, b, c), vec3(c, c, b)).x"),
    same("cross(vec3(a, b, c), vec3(c, c, b)).y"),
    same("normalize(a)"),
    same("normalize(vec2(a, b)).y"),
    same("normalize(vec3(a, b, c)).x"),
    same("faceforward(a, b, c)"),
    same("faceforward(vec2(a, b), vec2(b, c), vec2(c, a)).x"),
    same("reflect(a, b)"),
    same("reflect(vec3(a, b, c), vec3(b, a, c)).z"),
    same("refract(a, b, c)"),
    same("refract(vec2(a, b), vec2(b, c), c).y"),
    same("outerProduct(vec2(a, b), vec2(c, a))[1].x"),
    same("(mat2(a, b, c, a) * vec2(b, c)).x"),
    same("(mat2(a, b, c, a) * mat2(c, b, b, a))[1].y"),
    same("-a"),
    same("a + 0.0"),
    same("0.0 + a"),
    same("a - 0.0"),
    same("0.0 - a"),
    same("a - a"),
    same("a / a"),
    same("a * 1.0"),
    same("a / 1.0"),
    same("1.0 / a"),
    same("a * -1.0"),
    same("a * 2.0"),
    same("a / 2.0"),
    same("a / 3.0"),
    same("a + a"),
    same("-(-a)"),
    same("-(a - b)"),
    same("-(a * b)"),
    same("-a * b"),
    same("-a + b"),
    same("a + -b"),
    same("a - -b"),
    same("a * b + c"),
    same("a * b - c"),
    same("c - a * b"),
    same("(a + b) * c"),
    same("a * b * c"),
    same("a + b + c"),
    same("min(max(a, 0.0), 1.0)"),
    same("max(min(a, 1.0), 0.0)"),
    same("clamp(a, 0.0, 1.0)"),
    same("clamp(a, 1.0, 0.0)"),
    same("min(a, 0.0)"),
    same("max(a, 0.0)"),
    same("max(0.0, a)"),
    same("max(-0.0, a)"),
    same("min(a, a)"),
    same("abs(-a)"),
    same("abs(abs(a))"),
    same("floor(floor(a))"),
    same("fract(-a)"),
    same("mod(a, 1.0)"),
    same("mod(a, -0.7)"),
    same("mod(a, 1e-39)"),
    same("mod(a, 1e38)"),
    same("mod(1.0, a)"),
    same("pow(a, 2.0)"),
    same("pow(a, 0.5)"),
    same("pow(a, 0.0)"),
    same("pow(a, 1.0)"),
    same("pow(a, -1.0)"),
    same("pow(a, 3.0)"),
    same("pow(2.0, a)"),
    same("pow(1.0, a)"),
    same("pow(0.0, a)"),
    same("exp(log(a))"),
    same("sqrt(a * a)"),
    same("1.0 / sqrt(a)"),
    same("mix(a, a, c)"),
    same("step(0.0, a)"),
    same("smoothstep(0.0, 1.0, a)"),
    same("smoothstep(a, a, b)"),
    same("a == a ? 1.0 : 0.0"),
    same("a < b ? a : b"),
    same("a > b ? a : b"),
    same("a <= b ? b : a"),
    same("!(a < b) ? a : b"),
    same("(a < b) == (b > a) ? 1.0 : 2.0"),
    same("a != b && a >= c ? a : c"),
    same("float(bool(a))"),
    same("float(int(a))"),
    same("float(uint(a))"),
    same("float(int(a) / int(b))"),
    same("float(int(a) % int(b))"),
    same("float(uint(a) / uint(b))"),
    same("float(uint(a) % uint(b))"),
    same("float(int(a) / 3)"),
    same("float(int(a) % 8)"),
    same("float(uint(a) / 10u)"),
    same("float(int(a) << int(b))"),
    same("float(int(a) >> 33)"),
    same("float(uint(a) >> uint(b))"),
    same("float(abs(int(a)))"),
    same("float(sign(int(a)))"),
    same("float(-int(a))"),
    same("float(int(a) * int(b))"),
    same("float(uint(a) - uint(b))"),
    same("intBitsToFloat(floatBitsToInt(a))"),
    same("float(floatBitsToInt(a))"),
    same("float(floatBitsToUint(a))"),
    same("uintBitsToFloat(floatBitsToUint(a) ^ 0x80000000u)"),
];

/// Products with a constant zero, in which constants are computed otherwise than what is not constant.
const ZEROS: &[Row] =
    &[same("a * 0.0"), same("0.0 * a"), same("mix(a, b, 0.0)"), same("mix(a, b, 1.0)")];

/// A product with a zero that is constant, also with NaN and infinities, and with one that is not.
#[test]
fn products_with_a_constant_zero_are_zero() {
    const ZERO: f64 = 0.0;
    type Row = (&'static str, fn([f64; 3]) -> f64);
    let rows: [Row; 10] = [
        ("a * 0.0", |_| ZERO),
        ("a * -0.0", |_| ZERO),
        ("0.0 * a", |_| ZERO),
        ("a * (2.0 - 2.0)", |_| ZERO),
        ("a * float(0)", |_| ZERO),
        ("(vec3(a, b, c) * vec3(1.0, 0.0, 2.0)).y", |_| ZERO),
        ("(vec3(a, b, c) * vec3(1.0, 0.0, 2.0)).z", |[_, _, c]| f64::from((2.0 * c) as f32)),
        ("(mat2(0.0, 1.0, 0.0, 0.0) * vec2(a, b)).x", |_| ZERO),
        ("dot(vec3(a, b, c), vec3(0.0, 1.0, 0.0))", |[_, b, _]| b + ZERO),
        ("a * b", |[a, b, _]| f64::from((a * b) as f32)),
    ];
    for (expression, want) in rows {
        let (varying, ..) = module(expression, OperandSource::Attributes);
        for lanes in batches() {
            for isa in Isa::executions() {
                let found = run(isa, &varying, &[], &lanes);
                for (values, found) in lanes.iter().zip(found) {
                    let want = (want(values.map(f64::from)) as f32).to_bits();
                    let found = f32::from_bits(found);
                    assert!(agree(found.to_bits(), want), "{expression} of {values:?}: {found:?}");
                }
            }
        }
    }
}

/// Three numbers for each lane.
type Lanes = [[f32; 3]; LANES];

/// Where the operands of an expression come from.
#[derive(Clone, Copy)]
enum OperandSource {
    Constants([f32; 3]),
    Uniforms,
    Attributes,
}

fn source(expression: &str, from: OperandSource) -> String {
    let declared = match from {
        OperandSource::Constants(values) => {
            ["a", "b", "c"].iter().zip(values).fold(String::new(), |all, (name, value)| {
                format!("{all}const float {name} = uintBitsToFloat({}u);\n", value.to_bits())
            })
        }
        OperandSource::Uniforms => "uniform float a, b, c;".to_owned(),
        OperandSource::Attributes => "in vec4 at; float a = at.x, b = at.y, c = at.z;".to_owned(),
    };
    format!(
        "#version 130\n#extension GL_ARB_shader_bit_encoding : require\n{declared}\n\
         void main() {{ gl_Position = vec4({expression}); }}"
    )
}

/// The vertex stage, and the words of its uniforms.
fn module(expression: &str, from: OperandSource) -> (Module, Vec<(String, u32)>, u32) {
    let source = source(expression, from);
    let compiled = compile(Stage::Vertex, &source, &Options::default());
    let shader = compiled.shader.unwrap_or_else(|| panic!("{source}\n{}", compiled.log));
    let linked = link(&[&shader], &Bindings::default());
    let program = linked.program.unwrap_or_else(|| panic!("{source}\n{}", linked.log));
    let places =
        program.uniforms.iter().map(|uniform| (uniform.name.clone(), uniform.word)).collect();
    (program.vertex.expect("linked"), places, program.words)
}

/// The bits of the expression in every lane.
fn run(isa: Isa, module: &Module, words: &[u32], lanes: &Lanes) -> [u32; LANES] {
    let program = &Program::new(module, |output| output == Output::Position(0));
    let prepared = program.prepare(isa, words, &[]);
    let mut machine = Machine::default();
    machine.begin(program);
    for (index, input) in program.inputs().iter().enumerate() {
        let Input::Attribute { component, .. } = input else { panic!("{input:?} is no attribute") };
        let register = machine.input_mut(index);
        for lane in 0..LANES {
            register[lane] = lanes[lane][usize::from(*component)].to_bits();
        }
    }
    let run = Invocation {
        isa,
        program,
        prepared: &prepared,
        textures: &[],
        active: !0,
        budget: 1_000_000,
    };
    machine.run(run).expect("the shaders end");
    std::array::from_fn(|lane| machine.output(0)[lane])
}

/// Three batches of triples: each number in each position, combined with a few others.
fn batches() -> [Lanes; 3] {
    std::array::from_fn(|batch| {
        std::array::from_fn(|lane| {
            let at = batch * LANES + lane;
            let value = |at: usize| VALUES[at % VALUES.len()];
            [value(at), value(at * 7 + at / 40), value(at * 11 + 3 + at / 40 * 5)]
        })
    })
}

/// Whether two results are the same; all NaNs are equal.
fn agree(a: u32, b: u32) -> bool {
    a == b || (f32::from_bits(a).is_nan() && f32::from_bits(b).is_nan())
}

#[test]
fn extremes_are_the_same_however_they_are_computed() {
    let mut wrong = std::thread::scope(|scope| {
        let halves = TABLE.chunks(TABLE.len().div_ceil(2));
        let halves: Vec<_> = halves.map(|half| scope.spawn(|| differences(half))).collect();
        halves.into_iter().flat_map(|half| half.join().expect("no panic")).collect::<Vec<_>>()
    });
    wrong.extend(differences(ZEROS).into_iter().filter(|line| !line.contains("folded")));
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
}

/// The expressions whose results depend on how they are computed.
fn differences(table: &[Row]) -> Vec<String> {
    let mut wrong = Vec::new();
    let isas: Vec<Isa> = Isa::executions();
    for Row(expression, ..) in table {
        let (varying, ..) = module(expression, OperandSource::Attributes);
        let (uniform, places, words) = module(expression, OperandSource::Uniforms);
        for lanes in batches() {
            let found = run(isas[0], &varying, &[], &lanes);
            let mut say = |how: &str, lane: usize, other: u32| {
                let [a, b] = [found[lane], other].map(f32::from_bits);
                wrong.push(format!("{expression} of {:?}: {a:?}, {how} {b:?}", lanes[lane]));
            };
            for &isa in &isas[1..] {
                let other = run(isa, &varying, &[], &lanes);
                if let Some(lane) = (0..LANES).find(|&lane| !agree(found[lane], other[lane])) {
                    say(&format!("{isa:?}"), lane, other[lane]);
                }
            }
            for lane in 0..LANES {
                let values = lanes[lane];
                let isa = isas[lane % isas.len()];
                // In a batch whose lanes agree.
                let other = run(isa, &varying, &[], &[values; LANES])[lane];
                if !agree(found[lane], other) {
                    say("alone", lane, other);
                }
                let mut block = vec![0; words as usize];
                for (name, word) in &places {
                    let at = ["a", "b", "c"].iter().position(|known| known == name).expect("known");
                    block[*word as usize] = values[at].to_bits();
                }
                let other = run(isa, &uniform, &block, &lanes)[lane];
                if !agree(found[lane], other) {
                    say("of uniforms", lane, other);
                }
                let (constant, ..) = module(expression, OperandSource::Constants(values));
                let other = run(isa, &constant, &[], &lanes)[lane];
                if !agree(found[lane], other) {
                    say("folded", lane, other);
                }
            }
        }
    }
    wrong
}

/// The error in units of the last place of the exact result.
fn ulps(got: f32, want: f64) -> f64 {
    let rounded = want as f32;
    if rounded.is_nan() || got.is_nan() {
        return if rounded.is_nan() && got.is_nan() { 0.0 } else { f64::INFINITY };
    }
    if rounded.is_infinite() || got.is_infinite() || want == 0.0 {
        return if got == rounded { 0.0 } else { f64::INFINITY };
    }
    let exponent = (want.abs().to_bits() >> 52) as i32 - 1023;
    (f64::from(got) - want).abs() / 2f64.powi(exponent.max(-126) - 23)
}

#[test]
fn extremes_have_the_values_of_f64() {
    for Row(expression, bound, exact) in TABLE {
        let Some(exact) = exact else { continue };
        let (varying, ..) = module(expression, OperandSource::Attributes);
        for lanes in batches() {
            let found = run(Isa::available()[0], &varying, &[], &lanes);
            for ([a, b, _], found) in lanes.iter().zip(found.map(f32::from_bits)) {
                let want = exact((*a).into(), (*b).into());
                let error = ulps(found, want);
                assert!(
                    error <= *bound,
                    "{expression} of {a:?}, {b:?} is {found:?}, not {want:?}: {error} ULP"
                );
            }
        }
    }
}
