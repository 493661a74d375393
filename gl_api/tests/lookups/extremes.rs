//! The ends of every range: coordinates, q, levels, borders, texels and sizes.

use super::textures::{Kind, Texels};
use super::{Stage, context, drawn, program, run};
use gl_api::*;

const FLAT: Texels = Texels { target: GL_TEXTURE_2D, size: [8, 4, 1], kind: Kind::Float };

/// A lookup in a 2D texture of 8×4 texels with nearest filters, clamped to its edge.
fn at(preamble: &str, body: &str) -> [u8; 4] {
    run(Stage::Fragment, preamble, "sampler2D", body, FLAT).unwrap_or_else(|log| panic!("{log}"))
}

#[test]
fn coordinates_of_any_size_find_a_texel() {
    let _current = context();
    for (call, want) in [
        ("texture2D(s, vec2(1e7, -1e7))", [7, 0, 0, 0]),
        ("texture2D(s, vec2(-1e38, 1e38))", [0, 3, 0, 0]),
        ("texture2D(s, vec2(1.0, 0.0) / 0.0)", [7, 0, 0, 0]),
        ("texture2D(s, vec2(-1.0, 1.0) / vec2(0.0))", [0, 3, 0, 0]),
        ("texture2D(s, vec2(1e-45, 1e-40))", [0, 0, 0, 0]),
        // q: negative, tiny, 0 of both signs.
        ("texture2DProj(s, vec3(-0.6, -1.2, -2.0))", [2, 2, 0, 0]),
        ("texture2DProj(s, vec3(0.3, -0.6, 1e-30))", [7, 0, 0, 0]),
        ("texture2DProj(s, vec3(0.3, -0.6, -1e-42))", [0, 3, 0, 0]),
        ("texture2DProj(s, vec3(0.3, -0.6, 0.0))", [7, 0, 0, 0]),
        ("texture2DProj(s, vec4(0.6, 1.2, 5.0, 2.0))", [2, 2, 0, 0]),
        // NaN counts as 0.
        ("texture2DProj(s, vec3(0.0, 0.0, 0.0))", [0, 0, 0, 0]),
    ] {
        assert_eq!(at("", &format!("r = {call};")), want, "{call}");
    }
}

#[test]
fn levels_of_any_size_find_a_level() {
    let _current = context();
    for (call, level) in [
        ("textureLod(s, vec2(0.5), 1.0 / 0.0)", 3),
        ("textureLod(s, vec2(0.5), -1.0 / 0.0)", 0),
        ("textureLod(s, vec2(0.5), 0.0 / 0.0)", 0),
        ("textureLod(s, vec2(0.5), 1e30)", 3),
        ("textureGrad(s, vec2(0.5), vec2(1e30, 0.0), vec2(0.0))", 3),
        ("textureGrad(s, vec2(0.5), vec2(0.0), vec2(0.0))", 0),
        ("textureGrad(s, vec2(0.5), vec2(0.0, 1000.0), vec2(0.0))", 3),
        ("texture(s, vec2(0.5), 100.0)", 0),
        // λ 0 and a bias, which is held at 16.
        ("texture(s, vec2(0.5 + d / 8.0, 0.5), 100.0)", 3),
        ("texture(s, vec2(0.5 + d / 8.0, 0.5), -100.0)", 0),
    ] {
        let got = at("#version 130", &format!("r = {call};"));
        assert_eq!(got[3], level, "{call}");
    }
    // What is not there gives 0 everywhere.
    for call in [
        "texelFetch(s, ivec2(8, 0), 0)",
        "texelFetch(s, ivec2(-1, 0), 0)",
        "texelFetch(s, ivec2(0, 0), 4)",
        "texelFetch(s, ivec2(0, 0), -1)",
        "texelFetch(s, ivec2(2147483647), 2147483647)",
        "vec4(textureSize(s, 77), 0, 0)",
    ] {
        assert_eq!(at("#version 130", &format!("r = {call};")), [0; 4], "{call}");
    }
}

/// The colour of a quad under a texture as the closure leaves it, by `texture2D` at one point.
fn with(state: impl Fn(GLenum), point: &str) -> [u8; 4] {
    FLAT.bind();
    state(GL_TEXTURE_2D);
    assert_eq!(glGetError(), GL_NO_ERROR);
    let fragment = format!(
        "uniform sampler2D s; void main() {{ gl_FragColor = texture2D(s, {point}) / 4.0; }}"
    );
    let program = program("void main() { gl_Position = gl_Vertex; }", &fragment).unwrap();
    let pixel = drawn(program);
    glUseProgram(0);
    glDeleteProgram(program);
    pixel
}

#[test]
fn ranges_the_wrong_way_round() {
    let _current = context();
    // Least above most: the level is one of the two.
    let pixel = with(
        |t| {
            glTexParameterf(t, GL_TEXTURE_MIN_LOD, 3.0);
            glTexParameterf(t, GL_TEXTURE_MAX_LOD, 1.0);
        },
        "vec2(0.5)",
    );
    assert!(pixel[3] <= 1, "{pixel:?}");
    // Base above most: incomplete with mipmaps, alright without.
    let levels = |t| {
        glTexParameteri(t, GL_TEXTURE_BASE_LEVEL, 2);
        glTexParameteri(t, GL_TEXTURE_MAX_LEVEL, 1);
    };
    assert_eq!(with(levels, "vec2(0.5)"), [0, 0, 0, 64]);
    let plain = |t| {
        levels(t);
        glTexParameteri(t, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        let pixels = [200_u8; 8];
        glTexImage2D(t, 2, GL_RGBA8, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, &pixels);
    };
    assert_eq!(with(plain, "vec2(0.5)"), [50; 4]);
}

#[test]
fn borders_outside_of_0_to_1() {
    let _current = context();
    let border = |t| {
        glTexParameteri(t, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
        glTexParameterfv(t, GL_TEXTURE_BORDER_COLOR, &[2.0_f32, -1.0, 0.4, 8.0]);
    };
    assert_eq!(with(border, "vec2(-3.0, 0.5)"), [64, 0, 26, 64]);
    let wide = |t| {
        glTexParameteri(t, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexImage2D(t, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, &[0.0_f32; 4]);
        border(t);
    };
    assert_eq!(with(wide, "vec2(-3.0, 0.5)"), [128, 0, 26, 255]);
}

#[test]
fn texels_that_are_no_numbers() {
    let _current = context();
    glBindTexture(GL_TEXTURE_2D, 1);
    let texels = [f32::INFINITY, f32::NEG_INFINITY, f32::NAN, f32::MAX];
    let fragment = "#version 130
uniform sampler2D s; void main() {
    vec4 t = texture(s, vec2(0.5));
    gl_FragColor = vec4(isinf(t.x) && t.x > 0.0, isinf(t.y) && t.y < 0.0, isnan(t.z), t.w > 3e38);
}";
    let program = program("void main() { gl_Position = gl_Vertex; }", fragment).unwrap();
    for filter in [GL_NEAREST, GL_LINEAR] {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, &texels);
        let pixel = drawn(program);
        // The mean of inf and itself is NaN in the filter's a + (b - a) t.
        let want = if filter == GL_NEAREST { [255; 4] } else { [pixel[0], pixel[1], 255, 255] };
        assert_eq!(pixel, want, "{}", enum_name(filter));
    }
}

#[test]
fn the_longest_texture_and_the_largest() {
    let _current = context();
    let t = GL_TEXTURE_2D;
    let row: Vec<u8> = (0..8192_u32).map(|x| (x / 32) as u8).collect();
    let fragment =
        "uniform sampler2D s; uniform vec2 p; void main() { gl_FragColor = texture2D(s, p); }";
    let program = program("void main() { gl_Position = gl_Vertex; }", fragment).unwrap();
    let place = glGetUniformLocation(program, "p");
    for (width, height) in [(8192, 1), (1, 8192)] {
        glBindTexture(t, 1);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTexParameteri(t, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        let (l, byte) = (GL_LUMINANCE, GL_UNSIGNED_BYTE);
        glTexImage2D(t, 0, GL_LUMINANCE8, width, height, 0, l, byte, &row);
        for x in [0, 1, 31, 32, 4095, 8191] {
            glUseProgram(program);
            let s = (x as f32 + 0.5) / 8192.0;
            if width == 1 {
                glUniform2f(place, 0.5, s)
            } else {
                glUniform2f(place, s, 0.5)
            }
            glTexParameteri(t, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
            assert_eq!(drawn(program)[0], row[x], "{width}×{height} {x}");
        }
        // ±1e7 are whole numbers of repetitions.
        glUniform2f(place, 1e7, -1e7);
        assert_eq!(drawn(program)[0], 0);
    }
    assert_eq!(glGetError(), GL_NO_ERROR);
}

/// Target, proxy, internal format, size; the proxy's width and what specifying it says.
type Size = (GLenum, GLenum, GLenum, [i32; 3], i32, GLenum);

/// What cannot be stored is a proxy's 0 or `GL_OUT_OF_MEMORY`, and leaves what was there.
#[test]
fn more_than_there_is_memory_for() {
    let _current = context();
    let rows: &[Size] = &[
        (GL_TEXTURE_2D, GL_PROXY_TEXTURE_2D, GL_RGBA8, [8192, 8192, 1], 8192, GL_NO_ERROR),
        (GL_TEXTURE_2D, GL_PROXY_TEXTURE_2D, GL_RGBA8, [8193, 1, 1], 0, GL_INVALID_VALUE),
        (GL_TEXTURE_3D, GL_PROXY_TEXTURE_3D, GL_R8, [512, 512, 512], 512, GL_NO_ERROR),
        (GL_TEXTURE_3D, GL_PROXY_TEXTURE_3D, GL_RGBA32F, [512, 512, 512], 0, GL_OUT_OF_MEMORY),
        (GL_TEXTURE_3D, GL_PROXY_TEXTURE_3D, GL_R8, [513, 1, 1], 0, GL_INVALID_VALUE),
        (
            GL_TEXTURE_2D_ARRAY,
            GL_PROXY_TEXTURE_2D_ARRAY,
            GL_RGBA8,
            [8192, 8192, 2048],
            0,
            GL_OUT_OF_MEMORY,
        ),
        (GL_TEXTURE_2D_ARRAY, GL_PROXY_TEXTURE_2D_ARRAY, GL_R8, [1, 1, 2048], 1, GL_NO_ERROR),
        (
            GL_TEXTURE_CUBE_MAP_ARRAY,
            GL_PROXY_TEXTURE_CUBE_MAP_ARRAY,
            GL_RGBA8,
            [8192, 8192, 2046],
            0,
            GL_OUT_OF_MEMORY,
        ),
        (
            GL_TEXTURE_CUBE_MAP_ARRAY,
            GL_PROXY_TEXTURE_CUBE_MAP_ARRAY,
            GL_R8,
            [1, 1, 2052],
            0,
            GL_INVALID_VALUE,
        ),
        (
            GL_TEXTURE_CUBE_MAP_ARRAY,
            GL_PROXY_TEXTURE_CUBE_MAP_ARRAY,
            GL_R8,
            [1, 1, 2046],
            1,
            GL_NO_ERROR,
        ),
    ];
    for &(target, proxy, internal, [w, h, d], width, flag) in rows {
        let specify = |target| match target {
            GL_TEXTURE_2D | GL_PROXY_TEXTURE_2D => {
                glTexImage2D(target, 0, internal, w, h, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
            }
            _ => glTexImage3D(target, 0, internal, w, h, d, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL),
        };
        specify(proxy);
        assert_eq!(glGetError(), GL_NO_ERROR);
        let mut got = -1;
        glGetTexLevelParameteriv(proxy, 0, GL_TEXTURE_WIDTH, &mut got);
        assert_eq!(got, width, "{} {w}×{h}×{d}", enum_name(target));
        // The large ones that fit are left to the proxy: a test need not take their memory.
        if flag != GL_NO_ERROR {
            specify(target);
            assert_eq!(glGetError(), flag, "{} {w}×{h}×{d}", enum_name(target));
        }
    }
}
