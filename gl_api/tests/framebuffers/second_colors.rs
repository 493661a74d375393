//! Blending by the second colour of the fragment stage (GL 3.3, section 4.1.7; `ARB_blend_func_extended`).

use super::shading::use_program;
use super::*;

const C0: GLenum = GL_COLOR_ATTACHMENT0;
const VERTEX: &str = "#version 330 compatibility\nvoid main() { gl_Position = gl_Vertex; }";
/// As text of subpixels: the ink, and how much of red, green and blue it covers.
const TEXT: &str = "#version 330 compatibility
layout(location = 0, index = 0) out vec4 ink; layout(location = 0, index = 1) out vec4 coverage;
void main() { ink = vec4(1.0, 0.5, 0.25, 1.0); coverage = vec4(0.25, 0.5, 1.0, 0.75); }";
const INK: [f64; 4] = [1.0, 0.5, 0.25, 1.0];
const COVERAGE: [f64; 4] = [0.25, 0.5, 1.0, 0.75];
const PAPER: [f64; 4] = [0.5, 0.25, 0.125, 0.75];

/// A framebuffer of floats, all of the paper's colour, and text that is blended.
fn target(vertex: &str, fragment: &str) -> Context {
    let mut c = context(2, 2);
    framebuffer(&mut c);
    renderbuffer(&mut c, C0, GL_RGBA32F, 2, 2);
    let [r, g, b, a] = PAPER.map(|channel| channel as f32);
    c.clear_color(r, g, b, a);
    use_program(&mut c, vertex, fragment);
    c.enable(GL_BLEND);
    fine(&mut c);
    c
}

/// The pixel after a rectangle over the paper.
fn drawn(c: &mut Context) -> [f64; 4] {
    c.clear(GL_COLOR_BUFFER_BIT);
    c.rectf(-1.0, -1.0, 1.0, 1.0);
    fine(c);
    let pixel = floats(c, [1, 1, 1, 1], GL_RGBA, 4);
    std::array::from_fn(|i| pixel[i].into())
}

/// A factor of a channel (GL 3.3, table 4.2).
fn factor(of: GLenum, i: usize) -> f64 {
    match of {
        GL_ZERO => 0.0,
        GL_ONE => 1.0,
        GL_SRC1_COLOR => COVERAGE[i],
        GL_ONE_MINUS_SRC1_COLOR => 1.0 - COVERAGE[i],
        GL_SRC1_ALPHA => COVERAGE[3],
        GL_ONE_MINUS_SRC1_ALPHA => 1.0 - COVERAGE[3],
        GL_SRC_ALPHA_SATURATE if i == 3 => 1.0,
        GL_SRC_ALPHA_SATURATE => INK[3].min(1.0 - PAPER[3]),
        other => panic!("{other:#x} is not in this table"),
    }
}

const FACTORS: [GLenum; 7] = [
    GL_ZERO,
    GL_ONE,
    GL_SRC1_COLOR,
    GL_ONE_MINUS_SRC1_COLOR,
    GL_SRC1_ALPHA,
    GL_ONE_MINUS_SRC1_ALPHA,
    GL_SRC_ALPHA_SATURATE,
];

/// All numbers here are exact.
#[test]
fn every_pair_of_factors_is_what_the_table_says() {
    let mut c = target(VERTEX, TEXT);
    for src in FACTORS {
        for dst in FACTORS {
            // Alpha the other way round.
            c.blend_func_separate(src, dst, dst, src);
            let want: [f64; 4] = std::array::from_fn(|i| {
                let [s, d] = if i == 3 { [dst, src] } else { [src, dst] };
                INK[i] * factor(s, i) + PAPER[i] * factor(d, i)
            });
            assert_eq!(drawn(&mut c), want, "{src:#x} {dst:#x}");
            let mut asked = [0; 1];
            c.get_integerv(GL_BLEND_SRC_RGB, &mut asked);
            assert_eq!(asked[0] as GLenum, src);
            c.get_integerv(GL_BLEND_DST_RGB, &mut asked);
            assert_eq!(asked[0] as GLenum, dst);
        }
    }
}

#[test]
fn text_of_subpixels_covers_each_channel_of_a_window() {
    for samples in [0, 4] {
        let mut c = context(2, 2);
        framebuffer(&mut c);
        let mut name = [0];
        c.gen_renderbuffers(1, &mut name);
        c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
        c.renderbuffer_storage_multisample(GL_RENDERBUFFER, samples, GL_RGBA8, 2, 2);
        c.framebuffer_renderbuffer(GL_FRAMEBUFFER, C0, GL_RENDERBUFFER, name[0]);
        c.clear_color(1.0, 0.0, 0.2, 1.0);
        c.clear(GL_COLOR_BUFFER_BIT);
        use_program(&mut c, VERTEX, TEXT);
        c.enable(GL_BLEND);
        c.blend_func(GL_SRC1_COLOR, GL_ONE_MINUS_SRC1_COLOR);
        c.rectf(-1.0, -1.0, 1.0, 1.0);
        c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
        c.blit_framebuffer(0, 0, 2, 2, 0, 0, 2, 2, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        c.bind_framebuffer(GL_READ_FRAMEBUFFER, 0);
        // 255 (0.25 + 0.75), 255 · 0.25, 255 · 0.25, 255.
        assert_eq!(bytes(&mut c, [1, 1, 1, 1], GL_RGBA, 4), [255, 64, 64, 255], "{samples}");
    }
}

#[test]
fn lists_and_attribute_stacks_keep_the_factors() {
    let mut c = target(VERTEX, TEXT);
    c.new_list(1, GL_COMPILE);
    c.blend_func(GL_SRC1_COLOR, GL_ONE_MINUS_SRC1_COLOR);
    c.end_list();
    let want: [f64; 4] =
        std::array::from_fn(|i| INK[i] * COVERAGE[i] + PAPER[i] * (1.0 - COVERAGE[i]));
    assert_eq!(drawn(&mut c), INK);
    c.call_list(1);
    assert_eq!(drawn(&mut c), want);
    c.push_attrib(GL_COLOR_BUFFER_BIT);
    c.blend_func(GL_ONE, GL_ZERO);
    assert_eq!(drawn(&mut c), INK);
    c.pop_attrib();
    assert_eq!(drawn(&mut c), want);
}

#[test]
fn the_alpha_test_and_clamped_colours_know_two_colours() {
    let bright = TEXT.replace("vec4(0.25, 0.5, 1.0, 0.75)", "vec4(2.0, -1.0, 0.5, 0.25)");
    let mut c = target(VERTEX, &bright);
    c.blend_func(GL_SRC1_COLOR, GL_ZERO);
    // The first colour's alpha is 1, the second's is 0.25.
    c.enable(GL_ALPHA_TEST);
    c.alpha_func(GL_GREATER, 0.5);
    assert_eq!(drawn(&mut c), [2.0, -0.5, 0.125, 0.25]);
    c.clamp_color(GL_CLAMP_FRAGMENT_COLOR, GL_TRUE);
    assert_eq!(drawn(&mut c), [1.0, 0.0, 0.125, 0.25]);
    c.alpha_func(GL_LESS, 0.5);
    assert_eq!(drawn(&mut c), PAPER);
}

#[test]
fn what_writes_no_second_colour_has_zeros() {
    let mut c = target("", "");
    c.blend_func(GL_ONE_MINUS_SRC1_COLOR, GL_SRC1_ALPHA);
    c.color_4f(0.5, 0.25, 0.75, 1.0);
    assert_eq!(drawn(&mut c), [0.5, 0.25, 0.75, 1.0]);
    use_program(&mut c, "", "void main() { gl_FragColor = vec4(0.25); }");
    assert_eq!(drawn(&mut c), [0.25; 4]);
}

#[test]
fn outputs_get_an_index_before_the_link() {
    let plain = "#version 330 compatibility\nout vec4 ink; out vec4 coverage;
        void main() { ink = vec4(1.0, 0.5, 0.25, 1.0); coverage = vec4(0.25, 0.5, 1.0, 0.75); }";
    let mut c = target(VERTEX, plain);
    let mut program = [0];
    c.get_integerv(GL_CURRENT_PROGRAM, &mut program);
    let program = program[0] as GLuint;
    let of = |c: &mut Context| {
        ["ink", "coverage", "none"].map(|name| {
            (c.get_frag_data_location(program, name), c.get_frag_data_index(program, name))
        })
    };
    assert_eq!(of(&mut c), [(0, 0), (1, 0), (-1, -1)]);
    c.bind_frag_data_location_indexed(program, 0, 1, "coverage");
    assert_eq!(of(&mut c), [(0, 0), (1, 0), (-1, -1)], "before the link");
    c.link_program(program);
    assert_eq!(of(&mut c), [(0, 0), (0, 1), (-1, -1)]);
    c.blend_func(GL_ZERO, GL_SRC1_COLOR);
    let want: [f64; 4] = std::array::from_fn(|i| PAPER[i] * COVERAGE[i]);
    assert_eq!(drawn(&mut c), want);
    // The unindexed call takes the index back.
    c.bind_frag_data_location(program, 3, "coverage");
    c.link_program(program);
    assert_eq!(of(&mut c), [(0, 0), (3, 0), (-1, -1)]);
    fine(&mut c);
    let mut limit = [0];
    c.get_integerv(GL_MAX_DUAL_SOURCE_DRAW_BUFFERS, &mut limit);
    assert_eq!(limit, [1]);
}

#[test]
fn draws_to_more_buffers_than_have_a_second_colour_are_refused() {
    for factor in &FACTORS[2..6] {
        let mut c = target(VERTEX, TEXT);
        renderbuffer(&mut c, C0 + 1, GL_RGBA32F, 2, 2);
        c.blend_func_separatei(1, GL_ONE, GL_ZERO, GL_ONE, *factor);
        // One buffer is drawn to.
        c.draw_buffers(1, &[C0]);
        assert_eq!(drawn(&mut c), INK);
        c.draw_buffers(2, &[GL_NONE, C0 + 1]);
        c.rectf(-1.0, -1.0, 1.0, 1.0);
        fine(&mut c);
        c.draw_buffers(2, &[C0, C0 + 1]);
        c.clear(GL_COLOR_BUFFER_BIT);
        c.rectf(-1.0, -1.0, 1.0, 1.0);
        let said = c.messages();
        assert_eq!(c.get_error(), GL_INVALID_OPERATION);
        let last = said.last().expect("a message").to_string();
        assert!(last.contains("draw buffer 1") && last.contains("GL_MAX_DUAL_SOURCE"), "{last}");
        let pixel = floats(&mut c, [1, 1, 1, 1], GL_RGBA, 4);
        assert_eq!(pixel, PAPER.map(|channel| channel as f32), "nothing is drawn");
        c.blend_func(GL_ONE, GL_ZERO);
        assert_eq!(drawn(&mut c), INK);
    }
}

/// OpenGL ES has them by EXT_blend_func_extended.
#[test]
fn core_contexts_and_opengl_es_have_the_factors() {
    for api in [Api::Core, Api::Es2] {
        let version = if api == Api::Core { Version::new(3, 3) } else { Version::new(3, 0) };
        let desc = ContextDesc { api, version, width: 2, height: 2, ..ContextDesc::default() };
        let mut c = Context::new(desc).expect("a device");
        for factor in &FACTORS[2..6] {
            c.blend_func(*factor, GL_ZERO);
            assert_eq!(c.get_error(), GL_NO_ERROR, "{factor:#x}");
            c.blend_func(GL_ONE, *factor);
            assert_eq!(c.get_error(), GL_NO_ERROR, "{factor:#x}");
        }
    }
}
