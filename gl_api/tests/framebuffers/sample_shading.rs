//! Fragments that are shaded at each sample, and the samples that a shader keeps (`ARB_sample_shading`).

use super::shading::use_program;
use super::{context, fine, floats, framebuffer, rectangle, renderbuffer};
use gl_api::*;

const FB: GLenum = GL_FRAMEBUFFER;
const AT: GLenum = GL_COLOR_ATTACHMENT0;
const PLANE: GLenum = GL_TEXTURE_2D_MULTISAMPLE;
/// Pixels along each side: several blocks.
const SIZE: i32 = 24;
const ALL: [f32; 4] = [-1.0, -1.0, 1.0, 1.0];
const HEAD: &str = "#version 130\n#extension GL_ARB_sample_shading : require\n";

/// A framebuffer of so many samples or the next possible number, which is returned; bound, its colours floats.
fn target(c: &mut Context, samples: i32) -> i32 {
    let (mut texture, mut depth) = ([0], [0]);
    framebuffer(c);
    c.gen_textures(1, &mut texture);
    c.bind_texture(PLANE, texture[0]);
    c.tex_image_2d_multisample(PLANE, samples, GL_RGBA32F, SIZE, SIZE, true);
    c.framebuffer_texture_2d(FB, AT, PLANE, texture[0], 0);
    c.gen_renderbuffers(1, &mut depth);
    c.bind_renderbuffer(GL_RENDERBUFFER, depth[0]);
    c.renderbuffer_storage_multisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, SIZE, SIZE);
    c.framebuffer_renderbuffer(FB, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth[0]);
    assert_eq!(c.check_framebuffer_status(FB), GL_FRAMEBUFFER_COMPLETE);
    c.clear_color(-1.0, -1.0, -1.0, -1.0);
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    let mut has = [0];
    c.get_integerv(GL_SAMPLES, &mut has);
    has[0]
}

/// The four components of each pixel's sample, row by row; the bound framebuffer stays so.
fn sample(c: &mut Context, sample: i32) -> Vec<[f32; 4]> {
    let mut before = [0];
    c.get_integerv(GL_FRAMEBUFFER_BINDING, &mut before);
    let program = use_program(
        c,
        "",
        "#version 130\n#extension GL_ARB_texture_multisample : require\nuniform sampler2DMS s;
         uniform int n; out vec4 c; void main() { c = texelFetch(s, ivec2(gl_FragCoord.xy), n); }",
    );
    let location = c.get_uniform_location(program, "n");
    c.uniform_1i(location, sample);
    framebuffer(c);
    renderbuffer(c, AT, GL_RGBA32F, SIZE, SIZE);
    c.disable(GL_DEPTH_TEST);
    rectangle(c, ALL, 0.0);
    let values = floats(c, [0, 0, SIZE, SIZE], GL_RGBA, 4);
    c.bind_framebuffer(FB, before[0] as GLuint);
    values.as_chunks().0.to_vec()
}

fn position(c: &mut Context, sample: i32) -> [f32; 2] {
    let mut position = [0.0; 2];
    c.get_multisamplefv(GL_SAMPLE_POSITION, sample as GLuint, &mut position);
    position
}

fn fragment(body: &str) -> String {
    format!("{HEAD}{body}")
}

const NAMES: &str = "out vec4 c;
    void main() { c = vec4(float(gl_SampleID), gl_SamplePosition, float(gl_NumSamples)); }";

#[test]
fn shaders_know_their_sample() {
    for samples in [2, 4] {
        let mut c = context(SIZE as u32, SIZE as u32);
        let samples = target(&mut c, samples);
        use_program(&mut c, "", &fragment(NAMES));
        rectangle(&mut c, ALL, 0.0);
        for i in 0..samples {
            let [x, y] = position(&mut c, i);
            let expected = [i as f32, x, y, samples as f32];
            assert!(sample(&mut c, i).iter().all(|value| *value == expected), "{i} of {samples}");
        }
    }
    let mut c = context(SIZE as u32, SIZE as u32);
    target(&mut c, 4);
    c.disable(GL_MULTISAMPLE);
    use_program(&mut c, "", &fragment(NAMES));
    rectangle(&mut c, ALL, 0.0);
    for i in 0..4 {
        assert_eq!(sample(&mut c, i)[7], [0.0, 0.5, 0.5, 4.0]);
    }
    framebuffer(&mut c);
    renderbuffer(&mut c, AT, GL_RGBA32F, SIZE, SIZE);
    use_program(&mut c, "", &fragment(NAMES));
    rectangle(&mut c, ALL, 0.0);
    assert_eq!(floats(&mut c, [3, 3, 1, 1], GL_RGBA, 4), [0.0, 0.5, 0.5, 1.0]);
}

/// How an input is declared, and whether it is that of the provoking vertex.
const WAYS: [(&str, bool); 4] =
    [("", false), ("noperspective ", false), ("centroid ", false), ("flat ", true)];

/// Values and `gl_FragCoord` are those of the sample, in whole blocks and in scattered quads.
#[test]
fn values_are_those_at_the_sample() {
    for (way, is_flat) in WAYS {
        let vertex = format!(
            "#version 130\n{way}out vec2 at;
             void main() {{ gl_Position = gl_Vertex; at = (gl_Vertex.xy * 0.5 + 0.5) * {SIZE}.0; }}"
        );
        let text = fragment(&format!(
            "{way}in vec2 at; out vec4 c; void main() {{ c = vec4(at, gl_FragCoord.xy); }}"
        ));
        for pieces in [1, 16] {
            let mut c = context(SIZE as u32, SIZE as u32);
            target(&mut c, 4);
            c.enable(GL_SAMPLE_SHADING);
            c.min_sample_shading(1.0);
            use_program(&mut c, &vertex, &text);
            let side = 2.0 / pieces as f32;
            for (x, y) in (0..pieces * pieces).map(|i| (i % pieces, i / pieces)) {
                let [x, y] = [x, y].map(|at| at as f32 * side - 1.0);
                rectangle(&mut c, [x, y, x + side, y + side], 0.5);
            }
            for i in 0..4 {
                let offset = position(&mut c, i);
                for (at, value) in (0..).zip(sample(&mut c, i)) {
                    let pixel = [at % SIZE, at / SIZE];
                    for axis in 0..2 {
                        let place = pixel[axis] as f32 + offset[axis];
                        assert_eq!(value[2 + axis], place, "{way}{pieces} {i} {pixel:?}");
                        assert!(is_flat || (value[axis] - place).abs() < 1e-4, "{way} {value:?}");
                    }
                }
            }
        }
    }
}

/// One invocation is enough for a part of the samples up to one.
#[test]
fn the_least_part_of_the_samples_counts() {
    for (samples, part, enabled, is_each) in [
        (4, 0.25, true, false),
        (4, 0.26, true, true),
        (4, 9.0, true, true),
        (4, 1.0, false, false),
        (4, -1.0, true, false),
    ] {
        let mut c = context(SIZE as u32, SIZE as u32);
        target(&mut c, samples);
        c.min_sample_shading(part);
        if enabled {
            c.enable(GL_SAMPLE_SHADING);
        }
        use_program(&mut c, "", &fragment("out vec4 c; void main() { c = gl_FragCoord.xyxy; }"));
        rectangle(&mut c, ALL, 0.0);
        let values = [0, 1].map(|i| sample(&mut c, i)[0][0]);
        assert_eq!(values[0] != values[1], is_each, "{part} of {samples}: {values:?}");
        assert!(is_each || values == [0.5; 2]);
    }
}

/// What is discarded, or fails its depth test, is so for its sample alone.
#[test]
fn samples_are_discarded_tested_and_counted_by_themselves() {
    let mut c = context(SIZE as u32, SIZE as u32);
    target(&mut c, 4);
    c.enable(GL_DEPTH_TEST);
    use_program(
        &mut c,
        "",
        &fragment(
            "out vec4 c; void main() {
                 if (gl_SampleID == 2) discard;
                 c = vec4(1.0); gl_FragDepth = gl_SampleID == 1 ? 0.75 : 0.25;
             }",
        ),
    );
    let mut query = [0];
    c.gen_queries(1, &mut query);
    let count = |c: &mut Context| {
        c.end_query(GL_SAMPLES_PASSED);
        let mut passed = [0];
        c.get_query_objectuiv(query[0], GL_QUERY_RESULT, &mut passed);
        passed[0]
    };
    let pixels = (SIZE * SIZE) as u32;
    c.begin_query(GL_SAMPLES_PASSED, query[0]);
    rectangle(&mut c, ALL, 0.0);
    assert_eq!(count(&mut c), 3 * pixels);
    use_program(&mut c, "", &fragment("out vec4 c; void main() { c = vec4(gl_SampleID + 5); }"));
    c.begin_query(GL_SAMPLES_PASSED, query[0]);
    rectangle(&mut c, ALL, 0.0);
    assert_eq!(count(&mut c), 2 * pixels);
    let firsts: Vec<f32> = (0..4).map(|i| sample(&mut c, i)[100][0]).collect();
    assert_eq!(firsts, [1.0, 6.0, 7.0, 1.0]);
    fine(&mut c);
}

/// The mask of the shader takes samples away from colours and depths, and so do the state's masks.
#[test]
fn the_shaders_mask_keeps_samples() {
    const MASK: &str = "out vec4 c; out int gl_SampleMask[1];
        void main() { gl_SampleMask[0] = int(gl_FragCoord.x); c = vec4(1.0); }";
    let kept = |set: &dyn Fn(&mut Context), text: &str| -> Vec<u32> {
        let mut c = context(SIZE as u32, SIZE as u32);
        target(&mut c, 4);
        c.enable(GL_DEPTH_TEST);
        use_program(&mut c, "", &fragment(text));
        set(&mut c);
        rectangle(&mut c, ALL, 0.0);
        c.disable(GL_SAMPLE_MASK);
        c.disable(GL_SAMPLE_ALPHA_TO_COVERAGE);
        // What is behind shows where no depth was written.
        use_program(&mut c, "", &fragment("out vec4 c; void main() { c = vec4(0.0); }"));
        rectangle(&mut c, ALL, 0.5);
        let samples: Vec<Vec<[f32; 4]>> = (0..4).map(|i| sample(&mut c, i)).collect();
        (0..SIZE as usize)
            .map(|x| (0..4).fold(0, |mask, i| mask | u32::from(samples[i][x][0] == 1.0) << i))
            .collect()
    };
    let all: Vec<u32> = (0..SIZE as u32).map(|x| x & 15).collect();
    assert_eq!(kept(&|_| {}, MASK), all);
    let some: Vec<u32> = all.iter().map(|mask| mask & 0b0110).collect();
    let masked = |c: &mut Context| {
        c.enable(GL_SAMPLE_MASK);
        c.sample_maski(0, 0b0110);
    };
    assert_eq!(kept(&masked, MASK), some);
    // Half of the alpha leaves the first two samples.
    let half = MASK.replace("vec4(1.0)", "vec4(1.0, 1.0, 1.0, 0.5)");
    let by_alpha = |c: &mut Context| c.enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    let first: Vec<u32> = all.iter().map(|mask| mask & 0b0011).collect();
    assert_eq!(kept(&by_alpha, &half), first);
    // Of each sample its own bit counts.
    let own = "out vec4 c; void main() { gl_SampleMask[0] = 1 << gl_SampleID; c = vec4(1.0); }";
    assert_eq!(kept(&|_| {}, own), vec![15; SIZE as usize]);
    let others = own.replace("1 <<", "~1 <<");
    let higher: Vec<u32> = kept(&|_| {}, &others);
    assert_eq!(higher, vec![0; SIZE as usize]);
    let off = |c: &mut Context| c.disable(GL_MULTISAMPLE);
    assert_eq!(kept(&off, MASK), vec![15; SIZE as usize]);
    // One sample: the mask has no effect.
    let mut c = context(SIZE as u32, SIZE as u32);
    use_program(&mut c, "", &fragment(MASK));
    rectangle(&mut c, ALL, 0.0);
    assert_eq!(floats(&mut c, [0, 0, 1, 1], GL_RED, 1), [1.0]);
}

#[test]
fn state_is_kept_and_answered() {
    let mut c = context(4, 4);
    let value = |c: &mut Context| {
        let mut value = [7.0];
        c.get_floatv(GL_MIN_SAMPLE_SHADING_VALUE, &mut value);
        value[0]
    };
    assert_eq!((value(&mut c), c.is_enabled(GL_SAMPLE_SHADING)), (0.0, false));
    c.push_attrib(GL_MULTISAMPLE_BIT);
    for (set, expected) in [(0.5, 0.5), (-2.0, 0.0), (3.0, 1.0)] {
        c.min_sample_shading(set);
        assert_eq!(value(&mut c), expected);
    }
    c.enable(GL_SAMPLE_SHADING);
    c.pop_attrib();
    assert_eq!((value(&mut c), c.is_enabled(GL_SAMPLE_SHADING)), (0.0, false));
    fine(&mut c);
}

/// What the names may not be used for.
#[test]
fn names_have_their_stage_extension_and_size() {
    for (text, words) in [
        (
            "#version 130\nvoid main() { gl_FragColor = vec4(gl_SampleID); }",
            "GL_ARB_sample_shading",
        ),
        (&*fragment("void main() { gl_SampleMask[1] = 1; }"), "gl_SampleMask"),
        (&*fragment("out int gl_SampleMask[2]; void main() {}"), "gl_SampleMask"),
        (&*fragment("in int gl_SampleMask[1]; void main() {}"), "gl_SampleMask"),
        (&*fragment("void main() { gl_SampleID = 1; }"), "gl_SampleID"),
    ] {
        let mut c = context(4, 4);
        let shader = c.create_shader(GL_FRAGMENT_SHADER);
        c.shader_source(shader, 1, Strings(vec![text]), &[]);
        c.compile_shader(shader);
        let (mut status, mut log) = ([9], String::new());
        c.get_shaderiv(shader, GL_COMPILE_STATUS, &mut status);
        c.get_shader_info_log(shader, 4096, &mut [], TextOut::String(&mut log));
        assert_eq!(status[0], 0, "{text}");
        assert!(log.contains(words), "{log}");
    }
}
