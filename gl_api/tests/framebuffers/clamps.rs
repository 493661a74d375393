//! `glClampColor`: colours of vertices, of fragments and of what is read, each clamped to [0, 1]
//! always, never, or where the buffers are of fixed-point numbers (`ARB_color_buffer_float`).

use super::shading::{use_program, use_stages};
use super::*;

/// A framebuffer of one pixel with a buffer of this format.
fn target(internal: GLenum) -> Context {
    let mut c = context(1, 1);
    framebuffer(&mut c);
    renderbuffer(&mut c, GL_COLOR_ATTACHMENT0, internal, 1, 1);
    // What is read is looked at as it is.
    c.clamp_color(GL_CLAMP_READ_COLOR, GL_FALSE);
    c
}

/// The pixel.
#[track_caller]
fn pixel(c: &mut Context) -> Vec<f32> {
    floats(c, [0, 0, 1, 1], GL_RGBA, 4)
}

const WIDE: [f32; 4] = [2.0, -1.0, 0.5, 3.0];
const CLAMPED: [f32; 4] = [1.0, 0.0, 0.5, 1.0];

fn current_color(c: &mut Context) {
    c.color_4f(WIDE[0], WIDE[1], WIDE[2], WIDE[3]);
}

#[test]
fn colours_of_vertices_are_clamped_as_the_state_says() {
    const VERTEX: &str = "void main() {
        gl_Position = gl_Vertex; gl_FrontColor = gl_Color; gl_FrontSecondaryColor = gl_Color; }";
    const FRAGMENT: &str = "void main() { gl_FragColor = gl_Color; }";
    let programs = [("", ""), (VERTEX, ""), ("", FRAGMENT), (VERTEX, FRAGMENT)];
    for (vertex, fragment) in programs {
        for (mode, want) in [(GL_TRUE, CLAMPED), (GL_FALSE, WIDE), (GL_FIXED_ONLY, WIDE)] {
            let mut c = target(GL_RGBA32F);
            c.clamp_color(GL_CLAMP_VERTEX_COLOR, mode);
            if !vertex.is_empty() || !fragment.is_empty() {
                use_program(&mut c, vertex, fragment);
            }
            current_color(&mut c);
            rectangle(&mut c, ALL, 0.0);
            assert_eq!(pixel(&mut c), want, "{vertex} {fragment} {mode}");
            c.raster_pos_2f(0.0, 0.0);
            let mut color = [0.0; 4];
            c.get_floatv(GL_CURRENT_RASTER_COLOR, &mut color);
            assert_eq!(color, want, "the raster position's, {vertex} {fragment} {mode}");
        }
    }
}

#[test]
fn lit_colours_are_clamped_as_the_state_says() {
    for (mode, want) in [(GL_TRUE, 1.0), (GL_FALSE, 3.0)] {
        let mut c = target(GL_RGBA32F);
        c.clamp_color(GL_CLAMP_VERTEX_COLOR, mode);
        c.enable(GL_LIGHTING);
        c.materialfv(GL_FRONT, GL_EMISSION, &[3.0; 4]);
        c.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[0.0; 4]);
        rectangle(&mut c, ALL, 0.0);
        assert_eq!(pixel(&mut c)[..3], [want; 3]);
    }
}

/// State of the fixed function that gives fragments a colour beyond 1, and that colour.
type Wide = (&'static str, fn(&mut Context), [f32; 3]);

const WIDE_FRAGMENTS: &[Wide] = &[
    ("vertex colour", |c| c.color_4f(2.0, 3.0, 4.0, 1.0), [2.0, 3.0, 4.0]),
    (
        "colour sum",
        |c| {
            c.color_3f(1.0, 0.5, 0.25);
            c.secondary_color_3f(1.0, 1.0, 1.0);
            c.enable(GL_COLOR_SUM);
        },
        [2.0, 1.5, 1.25],
    ),
    (
        "fog",
        |c| {
            c.enable(GL_FOG);
            c.fogi(GL_FOG_COORD_SRC, GL_FOG_COORD as i32);
            c.fogi(GL_FOG_MODE, GL_LINEAR as i32);
            c.fog_coordf(1.0);
            c.fogfv(GL_FOG_COLOR, &[2.0, 3.0, 4.0, 1.0]);
        },
        [2.0, 3.0, 4.0],
    ),
    (
        "a texture of floats",
        |c| {
            texture(c, &[2.0, 3.0, 4.0, 1.0]);
            env(c, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        },
        [2.0, 3.0, 4.0],
    ),
    (
        "a sum with a texture",
        |c| {
            texture(c, &[1.0; 4]);
            env(c, GL_TEXTURE_ENV_MODE, GL_ADD);
        },
        [2.0; 3],
    ),
    (
        "a combiner's scale",
        |c| {
            texture(c, &[1.0, 0.5, 0.75, 1.0]);
            env(c, GL_TEXTURE_ENV_MODE, GL_COMBINE);
            env(c, GL_COMBINE_RGB, GL_REPLACE);
            c.tex_envf(GL_TEXTURE_ENV, GL_RGB_SCALE, 4.0);
        },
        [4.0, 2.0, 3.0],
    ),
    (
        "an environment's colour",
        |c| {
            texture(c, &[0.0; 4]);
            env(c, GL_TEXTURE_ENV_MODE, GL_COMBINE);
            env(c, GL_COMBINE_RGB, GL_REPLACE);
            env(c, GL_SOURCE0_RGB, GL_CONSTANT);
            c.tex_envfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &[2.0, 3.0, 4.0, 1.0]);
        },
        [2.0, 3.0, 4.0],
    ),
    (
        "a program",
        |c| {
            use_program(c, "", "void main() { gl_FragColor = vec4(2.0, 3.0, 4.0, 1.0); }");
        },
        [2.0, 3.0, 4.0],
    ),
    (
        "a program of several buffers",
        |c| {
            use_program(c, "", "void main() { gl_FragData[0] = vec4(2.0, 3.0, 4.0, 1.0); }");
        },
        [2.0, 3.0, 4.0],
    ),
];

fn env(c: &mut Context, pname: GLenum, value: GLenum) {
    c.tex_envi(GL_TEXTURE_ENV, pname, value as i32);
}

/// A texture of floats of this colour.
fn texture(c: &mut Context, color: &[f32; 4]) {
    c.enable(GL_TEXTURE_2D);
    let pixels = Data::Bytes(bytemuck::bytes_of(color));
    c.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA32F as i32, 1, 1, 0, GL_RGBA, GL_FLOAT, pixels);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32);
}

#[test]
fn colours_of_fragments_are_clamped_as_the_state_says() {
    for (name, state, wide) in WIDE_FRAGMENTS {
        for (internal, mode, clamps) in [
            (GL_RGBA32F, GL_FIXED_ONLY, false),
            (GL_RGBA32F, GL_FALSE, false),
            (GL_RGBA32F, GL_TRUE, true),
            (GL_RGBA8, GL_FIXED_ONLY, true),
            (GL_RGBA8, GL_FALSE, true),
        ] {
            let mut c = target(internal);
            c.clamp_color(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
            c.clamp_color(GL_CLAMP_FRAGMENT_COLOR, mode);
            state(&mut c);
            rectangle(&mut c, ALL, 0.0);
            let got = pixel(&mut c);
            let want = if clamps { wide.map(|c| c.min(1.0)) } else { *wide };
            assert_eq!(got[..3], want, "{name}, {}, {mode}", enum_name(internal));
        }
    }
}

/// What a unit passes on is clamped, not what it reads: 4 · 0.25 is 1.
#[test]
fn texels_are_not_clamped() {
    for mode in [GL_FALSE, GL_TRUE] {
        let mut c = target(GL_RGBA32F);
        c.clamp_color(GL_CLAMP_FRAGMENT_COLOR, mode);
        c.color_4f(0.25, 0.25, 0.25, 0.25);
        texture(&mut c, &[4.0; 4]);
        rectangle(&mut c, ALL, 0.0);
        assert_eq!(pixel(&mut c), [1.0; 4]);
    }
}

#[test]
fn the_alpha_test_compares_what_is_clamped() {
    let programs = ["", "void main() { gl_FragColor = vec4(1.0, 1.0, 1.0, 2.0); }"];
    for program in programs {
        for (internal, mode, alpha) in [
            (GL_RGBA8, GL_FIXED_ONLY, 1.0),
            (GL_RGBA32F, GL_TRUE, 1.0),
            (GL_RGBA32F, GL_FIXED_ONLY, 2.0),
            (GL_RGBA32F, GL_FALSE, 2.0),
        ] {
            // The reference is clamped where the alpha is, so 3 is 1 there.
            for (func, reference, passes) in [
                (GL_EQUAL, 1.0, alpha == 1.0),
                (GL_EQUAL, 2.0, true),
                (GL_EQUAL, 3.0, alpha == 1.0),
                (GL_LESS, 3.0, alpha == 2.0),
                (GL_GREATER, 1.0, alpha == 2.0),
            ] {
                let mut c = target(internal);
                c.clamp_color(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
                c.clamp_color(GL_CLAMP_FRAGMENT_COLOR, mode);
                if !program.is_empty() {
                    use_program(&mut c, "", program);
                }
                c.clear(GL_COLOR_BUFFER_BIT);
                c.enable(GL_ALPHA_TEST);
                c.alpha_func(func, reference);
                c.color_4f(1.0, 1.0, 1.0, 2.0);
                rectangle(&mut c, ALL, 0.0);
                let name =
                    format!("{program} {} {mode} {func:#x} {reference}", enum_name(internal));
                assert_eq!(pixel(&mut c)[0] == 1.0, passes, "{name}");
            }
        }
    }
}

#[test]
fn what_is_read_is_clamped_as_the_state_says() {
    for (internal, mode, scale, want) in [
        (GL_RGBA32F, GL_FIXED_ONLY, 1.0, WIDE),
        (GL_RGBA32F, GL_FALSE, 1.0, WIDE),
        (GL_RGBA32F, GL_TRUE, 1.0, CLAMPED),
        (GL_RGBA16F, GL_TRUE, 1.0, CLAMPED),
        (GL_RGBA16F, GL_FIXED_ONLY, 2.0, [4.0, -2.0, 1.0, 6.0]),
        (GL_RGBA16F, GL_TRUE, 2.0, [1.0, 0.0, 1.0, 1.0]),
        (GL_RGBA8, GL_FIXED_ONLY, 2.0, [1.0, 0.0, 1.0, 1.0]),
        (GL_RGBA8, GL_FALSE, 2.0, [2.0, 0.0, 256.0 / 255.0, 2.0]),
    ] {
        let mut c = target(internal);
        c.clear_color(WIDE[0], WIDE[1], WIDE[2], WIDE[3]);
        c.clear(GL_COLOR_BUFFER_BIT);
        c.clamp_color(GL_CLAMP_READ_COLOR, mode);
        for pname in [GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE] {
            c.pixel_transferf(pname, scale);
        }
        assert_eq!(pixel(&mut c), want, "{} {mode} {scale}", enum_name(internal));
    }
}

#[test]
fn depths_and_integers_are_no_colours() {
    let mut c = context(1, 1);
    framebuffer(&mut c);
    renderbuffer(&mut c, GL_COLOR_ATTACHMENT0, GL_RGBA8I, 1, 1);
    c.clamp_color(GL_CLAMP_READ_COLOR, GL_TRUE);
    c.clear_color_ii_ext(-5, 7, 100, -100);
    c.clear(GL_COLOR_BUFFER_BIT);
    let mut out = [0_i32; 4];
    let bytes = DataOut::Bytes(bytes_of(&mut out));
    c.read_pixels(0, 0, 1, 1, GL_RGBA_INTEGER, GL_INT, bytes);
    fine(&mut c);
    assert_eq!(out, [-5, 7, 100, -100]);
}

/// Colours of the state that are kept unclamped, and answered clamped where fragments are.
#[test]
fn colours_of_the_state_are_asked_for_as_fragments_are_clamped() {
    let mut c = context(1, 1);
    c.fogfv(GL_FOG_COLOR, &WIDE);
    c.blend_color(WIDE[0], WIDE[1], WIDE[2], WIDE[3]);
    c.clear_color(WIDE[0], WIDE[1], WIDE[2], WIDE[3]);
    c.tex_envfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &WIDE);
    c.tex_parameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &WIDE);
    c.gen_samplers(1, &mut [0]);
    c.sampler_parameterfv(1, GL_TEXTURE_BORDER_COLOR, &WIDE);
    c.alpha_func(GL_LESS, 3.0);
    for (mode, want) in [(GL_FALSE, WIDE), (GL_FIXED_ONLY, CLAMPED), (GL_TRUE, CLAMPED)] {
        c.clamp_color(GL_CLAMP_FRAGMENT_COLOR, mode);
        let mut got = [[0.0; 4]; 7];
        let [fog, blend, clear, env, border, sampler, alpha] = &mut got;
        c.get_floatv(GL_FOG_COLOR, fog);
        c.get_floatv(GL_BLEND_COLOR, blend);
        c.get_floatv(GL_COLOR_CLEAR_VALUE, clear);
        c.get_tex_envfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, env);
        c.get_tex_parameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
        c.get_sampler_parameterfv(1, GL_TEXTURE_BORDER_COLOR, sampler);
        c.get_floatv(GL_ALPHA_TEST_REF, alpha);
        fine(&mut c);
        assert_eq!(got[..6], [want; 6], "{mode}");
        assert_eq!(got[6][0], want[3], "{mode}");
    }
}

#[test]
fn what_is_clamped_belongs_to_what_is_enabled() {
    let mut c = context(1, 1);
    let targets = [GL_CLAMP_VERTEX_COLOR, GL_CLAMP_FRAGMENT_COLOR, GL_CLAMP_READ_COLOR];
    c.push_attrib(GL_ENABLE_BIT);
    for target in targets {
        c.clamp_color(target, GL_FALSE);
    }
    c.pop_attrib();
    let mut got = [9; 3];
    for (target, got) in targets.into_iter().zip(&mut got) {
        c.get_integerv(target, std::slice::from_mut(got));
    }
    fine(&mut c);
    assert_eq!(got.map(|mode| mode as GLenum), [GL_TRUE, GL_FIXED_ONLY, GL_FIXED_ONLY]);
}

#[test]
fn signed_components_are_asked_for() {
    for (internal, want) in [
        (GL_RGBA8, [0; 4]),
        (GL_RGBA16F, [1; 4]),
        (GL_RGB32F, [1, 1, 1, 0]),
        (GL_R11F_G11F_B10F, [0; 4]),
        (GL_RG8_SNORM, [1, 1, 0, 0]),
        (GL_LUMINANCE16F_ARB, [1, 1, 1, 0]),
        (GL_RGBA8I, [1; 4]),
        (GL_RGBA8UI, [0; 4]),
    ] {
        let mut c = target(internal);
        let mut signed = [9; 4];
        c.get_integerv(GL_RGBA_SIGNED_COMPONENTS_EXT, &mut signed);
        fine(&mut c);
        assert_eq!(signed, want, "{}", enum_name(internal));
    }
    // It is about the first draw buffer, which has nothing here.
    let mut c = context(4, 4);
    framebuffer(&mut c);
    c.draw_buffers(2, &[GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1]);
    renderbuffer(&mut c, GL_COLOR_ATTACHMENT1, GL_RGBA16F, 4, 4);
    let mut signed = [9; 4];
    c.get_integerv(GL_RGBA_SIGNED_COMPONENTS_EXT, &mut signed);
    fine(&mut c);
    assert_eq!(signed, [0; 4]);
}

/// What has the base format of colours has storage; whether anything is drawn to it, completeness
/// says.
#[test]
fn shared_exponents_have_storage_and_nothing_is_drawn_to_them() {
    let mut c = context(4, 4);
    framebuffer(&mut c);
    renderbuffer(&mut c, GL_COLOR_ATTACHMENT0, GL_RGB9_E5, 4, 4);
    fine(&mut c);
    let mut bits = [0];
    c.get_renderbuffer_parameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_GREEN_SIZE, &mut bits);
    assert_eq!(bits, [9]);
    let status = c.check_framebuffer_status(GL_FRAMEBUFFER);
    assert_eq!(status, GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
}

#[test]
fn whether_buffers_are_of_floats_is_asked_for() {
    for (internal, want) in [(GL_RGBA8, 0), (GL_RGBA16F, 1), (GL_RGBA32F, 1), (GL_RGBA8I, 0)] {
        let mut c = target(internal);
        let mut mode = [9];
        c.get_integerv(GL_RGBA_FLOAT_MODE_ARB, &mut mode);
        fine(&mut c);
        assert_eq!(mode, [want], "{}", enum_name(internal));
    }
}

/// GL 3.2, compatibility, section 2.20: of two stages before the rasterizer, the last one's.
#[test]
fn colours_of_geometry_stages_are_clamped_as_the_state_says() {
    const VERTEX: &str = "#version 150 compatibility
        out vec4 passed;
        void main() { gl_Position = gl_Vertex; gl_FrontColor = gl_Color; passed = gl_Color; }";
    const GEOMETRY: &str = "#version 150 compatibility
        layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;
        in vec4 passed[];
        void main() {
            for (int i = 0; i < 3; i++) {
                gl_Position = gl_in[i].gl_Position;
                // What the vertex stage wrote is not clamped yet.
                gl_FrontColor = passed[i] == gl_in[i].gl_FrontColor ? passed[i] : vec4(9.0);
                if (passed[i].x > 0.0) { EmitVertex(); }
            }
        }";
    const FRAGMENT: &str = "#version 150 compatibility\nvoid main() { gl_FragColor = gl_Color; }";
    for (mode, want) in [(GL_TRUE, CLAMPED), (GL_FALSE, WIDE), (GL_FIXED_ONLY, WIDE)] {
        let mut c = target(GL_RGBA32F);
        c.clamp_color(GL_CLAMP_VERTEX_COLOR, mode);
        use_stages(
            &mut c,
            &[
                (GL_VERTEX_SHADER, VERTEX),
                (GL_GEOMETRY_SHADER, GEOMETRY),
                (GL_FRAGMENT_SHADER, FRAGMENT),
            ],
        );
        c.begin(GL_TRIANGLES);
        current_color(&mut c);
        for [x, y] in [[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]] {
            c.vertex_2f(x, y);
        }
        c.end();
        assert_eq!(pixel(&mut c), want, "{mode}");
    }
}
