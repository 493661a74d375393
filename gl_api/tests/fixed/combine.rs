//! Texture environments: section 3.8.13, tables 3.20 to 3.25, over random states of three units.

use crate::{Random, assert_close, color, context, triangle};
use gl_api::*;

const FORMATS: [(GLenum, GLenum, usize); 6] = [
    (GL_ALPHA8, GL_ALPHA, 1),
    (GL_LUMINANCE8, GL_LUMINANCE, 1),
    (GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA, 2),
    (GL_INTENSITY8, GL_LUMINANCE, 1),
    (GL_RGB8, GL_RGB, 3),
    (GL_RGBA8, GL_RGBA, 4),
];

/// One of two combiners.
#[derive(Clone, Debug)]
struct Combiner {
    function: GLenum,
    sources: [GLenum; 3],
    operands: [GLenum; 3],
    scale: f32,
}

#[derive(Clone, Debug)]
struct Unit {
    internal: GLenum,
    texel: [f64; 4],
    constant: [f32; 4],
    mode: GLenum,
    combiners: [Combiner; 2],
}

/// Table 3.20: what a texture's components are to an environment.
fn texel(internal: GLenum, v: [f64; 4]) -> [f64; 4] {
    match internal {
        GL_ALPHA8 => [0.0, 0.0, 0.0, v[0]],
        GL_LUMINANCE8 => [v[0], v[0], v[0], 1.0],
        GL_LUMINANCE8_ALPHA8 => [v[0], v[0], v[0], v[1]],
        GL_INTENSITY8 => [v[0]; 4],
        GL_RGB8 => [v[0], v[1], v[2], 1.0],
        _ => v,
    }
}

/// Tables 3.22 and 3.23.
fn standard(unit: &Unit, p: [f64; 4]) -> [f64; 4] {
    let (s, c) = (unit.texel, unit.constant.map(f64::from));
    let has_color = unit.internal != GL_ALPHA8;
    let has_alpha = !matches!(unit.internal, GL_LUMINANCE8 | GL_RGB8);
    let intensity = unit.internal == GL_INTENSITY8;
    let rgb = |f: &dyn Fn(usize) -> f64| [0, 1, 2].map(|i| if has_color { f(i) } else { p[i] });
    let (rgb, alpha) = match unit.mode {
        GL_REPLACE => (rgb(&|i| s[i]), s[3]),
        GL_MODULATE => (rgb(&|i| p[i] * s[i]), p[3] * s[3]),
        GL_BLEND => {
            let mix = |i: usize| p[i] * (1.0 - s[i]) + c[i] * s[i];
            (rgb(&mix), if intensity { mix(3) } else { p[3] * s[3] })
        }
        GL_ADD => (rgb(&|i| p[i] + s[i]), if intensity { p[3] + s[3] } else { p[3] * s[3] }),
        _ => match unit.internal {
            GL_RGB8 => ([s[0], s[1], s[2]], p[3]),
            GL_RGBA8 => (rgb(&|i| p[i] * (1.0 - s[3]) + s[i] * s[3]), p[3]),
            _ => ([p[0], p[1], p[2]], p[3]),
        },
    };
    [rgb[0], rgb[1], rgb[2], if has_alpha { alpha } else { p[3] }]
}

/// Tables 3.24 and 3.25.
fn combined(units: &[Unit], at: usize, primary: [f64; 4], previous: [f64; 4]) -> [f64; 4] {
    let unit = &units[at];
    let value = |combiner: &Combiner, i: usize, scale: f32| {
        let argument = |n: usize, i: usize| {
            let source = match combiner.sources[n] {
                GL_TEXTURE => unit.texel,
                GL_CONSTANT => unit.constant.map(f64::from),
                GL_PRIMARY_COLOR => primary,
                GL_PREVIOUS => previous,
                other => units[(other - GL_TEXTURE0) as usize].texel,
            };
            match combiner.operands[n] {
                GL_SRC_COLOR => source[i],
                GL_ONE_MINUS_SRC_COLOR => 1.0 - source[i],
                GL_SRC_ALPHA => source[3],
                _ => 1.0 - source[3],
            }
        };
        let dot =
            || 4.0 * (0..3).map(|i| (argument(0, i) - 0.5) * (argument(1, i) - 0.5)).sum::<f64>();
        let value = match combiner.function {
            GL_REPLACE => argument(0, i),
            GL_MODULATE => argument(0, i) * argument(1, i),
            GL_ADD => argument(0, i) + argument(1, i),
            GL_ADD_SIGNED => argument(0, i) + argument(1, i) - 0.5,
            GL_INTERPOLATE => {
                let weight = argument(2, i);
                argument(0, i) * weight + argument(1, i) * (1.0 - weight)
            }
            GL_SUBTRACT => argument(0, i) - argument(1, i),
            _ => dot(),
        };
        // EXT_texture_env_dot3 leaves the scale out, ARB_texture_env_dot3 does not.
        let is_scaled = ![GL_DOT3_RGB_EXT, GL_DOT3_RGBA_EXT].contains(&combiner.function);
        let scale = if is_scaled { f64::from(scale) } else { 1.0 };
        (value * scale).clamp(0.0, 1.0)
    };
    let [rgb, alpha] = &unit.combiners;
    let is_alpha = [GL_DOT3_RGBA, GL_DOT3_RGBA_EXT].contains(&rgb.function);
    let alpha = value(if is_alpha { rgb } else { alpha }, 3, alpha.scale);
    let [r, g, b] = [0, 1, 2].map(|i| value(rgb, i, rgb.scale));
    [r, g, b, alpha]
}

fn random_unit(random: &mut Random) -> (Unit, Vec<u8>, GLenum) {
    let (internal, format, components) = random.of(&FORMATS);
    let bytes: Vec<u8> = (0..components).map(|_| random.below(256) as u8).collect();
    let mut values = [0.0; 4];
    for (value, byte) in values.iter_mut().zip(&bytes) {
        *value = f64::from(*byte) / 255.0;
    }
    let functions = [
        GL_REPLACE,
        GL_MODULATE,
        GL_ADD,
        GL_ADD_SIGNED,
        GL_INTERPOLATE,
        GL_SUBTRACT,
        GL_DOT3_RGB,
        GL_DOT3_RGBA,
        GL_DOT3_RGB_EXT,
        GL_DOT3_RGBA_EXT,
    ];
    let sources = [
        GL_TEXTURE,
        GL_CONSTANT,
        GL_PRIMARY_COLOR,
        GL_PREVIOUS,
        GL_TEXTURE0,
        GL_TEXTURE1,
        GL_TEXTURE2,
    ];
    let operands = [GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR];
    let mut combiner = |functions: &[GLenum], operands: &[GLenum]| Combiner {
        function: random.of(functions),
        sources: [0; 3].map(|_| random.of(&sources)),
        operands: [0; 3].map(|_| random.of(operands)),
        scale: random.of(&[1.0, 2.0, 4.0]),
    };
    let combiners = [combiner(&functions, &operands), combiner(&functions[..6], &operands[..2])];
    let modes = [GL_REPLACE, GL_MODULATE, GL_DECAL, GL_BLEND, GL_ADD, GL_COMBINE];
    let mode = if random.chance(60) { GL_COMBINE } else { random.of(&modes) };
    let unit = Unit {
        internal,
        texel: texel(internal, values),
        constant: random.color(),
        mode,
        combiners,
    };
    (unit, bytes, format)
}

fn set(c: &mut Context, unit: &Unit) {
    let env = GL_TEXTURE_ENV;
    c.tex_envi(env, GL_TEXTURE_ENV_MODE, unit.mode as GLint);
    c.tex_envfv(env, GL_TEXTURE_ENV_COLOR, &unit.constant);
    let names = [
        [GL_COMBINE_RGB, GL_SRC0_RGB, GL_OPERAND0_RGB, GL_RGB_SCALE],
        [GL_COMBINE_ALPHA, GL_SRC0_ALPHA, GL_OPERAND0_ALPHA, GL_ALPHA_SCALE],
    ];
    for (combiner, [function, source, operand, scale]) in unit.combiners.iter().zip(names) {
        c.tex_envi(env, function, combiner.function as GLint);
        for i in 0..3 {
            c.tex_envi(env, source + i, combiner.sources[i as usize] as GLint);
            c.tex_envf(env, operand + i, combiner.operands[i as usize] as GLfloat);
        }
        c.tex_envf(env, scale, combiner.scale);
    }
}

/// Three units one after the other, of all base formats. Scales multiply what is lost in the units
/// before, at most 4 · 4 of a few units of 2^-24: half a byte is what shows.
#[test]
fn environments_follow_the_tables() {
    let mut c = context();
    for seed in 0..600 {
        let mut random = Random::new(seed);
        let mut units = Vec::new();
        for name in 0..3 {
            let (unit, bytes, format) = random_unit(&mut random);
            c.active_texture(GL_TEXTURE0 + name);
            c.bind_texture(GL_TEXTURE_2D, name + 1);
            c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
            let pixels = Data::Bytes(&bytes);
            let internal = unit.internal as GLint;
            c.pixel_storei(GL_UNPACK_ALIGNMENT, 1);
            c.tex_image_2d(GL_TEXTURE_2D, 0, internal, 1, 1, 0, format, GL_UNSIGNED_BYTE, pixels);
            c.enable(GL_TEXTURE_2D);
            set(&mut c, &unit);
            units.push(unit);
        }
        let given = random.color();
        c.color_4fv(&given);
        triangle(&mut c, 0.0, true);
        let primary = given.map(f64::from);
        let mut expected = primary;
        for (at, unit) in units.iter().enumerate() {
            expected = match unit.mode {
                GL_COMBINE => combined(&units, at, primary, expected),
                _ => standard(unit, expected),
            }
            .map(|value| value.clamp(0.0, 1.0));
        }
        assert_close(color(&mut c), expected, 0.52 / 255.0, &(seed, given, units));
    }
}

#[test]
fn a_source_without_a_texture_switches_its_unit_off() {
    let mut c = context();
    c.bind_texture(GL_TEXTURE_2D, 1);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    let red = Data::Bytes(&[255, 0, 0, 255]);
    c.tex_image_2d(GL_TEXTURE_2D, 0, 4, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, red);
    c.enable(GL_TEXTURE_2D);
    c.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE as GLint);
    c.tex_envi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE as GLint);
    c.color_4f(0.0, 1.0, 0.0, 1.0);
    triangle(&mut c, 0.0, true);
    assert_eq!(color(&mut c), [1.0, 0.0, 0.0, 1.0]);
    c.tex_envi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE5 as GLint);
    triangle(&mut c, 0.0, true);
    assert_eq!(color(&mut c), [0.0, 1.0, 0.0, 1.0]);
}

#[test]
fn four_arguments_are_summed_in_pairs() {
    let mut c = context();
    c.bind_texture(GL_TEXTURE_2D, 1);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    let texel = Data::Bytes(&[51, 102, 153, 204]);
    c.tex_image_2d(GL_TEXTURE_2D, 0, 4, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    c.enable(GL_TEXTURE_2D);
    let env = GL_TEXTURE_ENV;
    c.tex_envi(env, GL_TEXTURE_ENV_MODE, GL_COMBINE4_NV as GLint);
    c.tex_envfv(env, GL_TEXTURE_ENV_COLOR, &[0.5, 0.5, 0.5, 0.25]);
    for (name, value) in [
        (GL_COMBINE_RGB, GL_ADD),
        (GL_SRC0_RGB, GL_TEXTURE),
        (GL_SRC1_RGB, GL_CONSTANT),
        (GL_SRC2_RGB, GL_PRIMARY_COLOR),
        (GL_OPERAND2_RGB, GL_SRC_COLOR),
        (GL_SOURCE3_RGB_NV, GL_TEXTURE),
        (GL_OPERAND3_RGB_NV, GL_SRC_ALPHA),
        // Alpha: a texel's, times one minus zero.
        (GL_COMBINE_ALPHA, GL_ADD),
        (GL_SRC0_ALPHA, GL_TEXTURE),
        (GL_SRC1_ALPHA, GL_ZERO),
        (GL_OPERAND1_ALPHA, GL_ONE_MINUS_SRC_ALPHA),
        (GL_SRC2_ALPHA, GL_ZERO),
    ] {
        c.tex_envi(env, name, value as GLint);
    }
    c.color_4f(0.25, 0.25, 0.25, 1.0);
    triangle(&mut c, 0.0, true);
    let expected = [0.2, 0.4, 0.6].map(|s| s * 0.5 + 0.25 * 0.8);
    let expected = [expected[0], expected[1], expected[2], 0.8];
    assert_close(color(&mut c), expected, 0.51 / 255.0, &"combine4");
}
