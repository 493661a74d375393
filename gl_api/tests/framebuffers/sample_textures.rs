//! Textures with several samples a texel (`ARB_texture_multisample`): drawn to sample by sample,
//! fetched by shaders, resolved and copied.

use super::shading::use_program;
use super::{bytes, context, fine, floats, framebuffer, rectangle, renderbuffer};
use gl_api::*;

const FB: GLenum = GL_FRAMEBUFFER;
const AT: GLenum = GL_COLOR_ATTACHMENT0;
const PLANE: GLenum = GL_TEXTURE_2D_MULTISAMPLE;
const ARRAY: GLenum = GL_TEXTURE_2D_MULTISAMPLE_ARRAY;
const SAMPLES: usize = 4;
/// Pixels along each side of everything here.
const SIZE: i32 = 4;
const ALL: [f32; 4] = [-1.0, -1.0, 1.0, 1.0];

/// A texture of `layers` layers, bound.
fn texture(c: &mut Context, target: GLenum, internal: GLenum, layers: i32) -> GLuint {
    let mut name = [0];
    c.gen_textures(1, &mut name);
    c.bind_texture(target, name[0]);
    if target == PLANE {
        c.tex_image_2d_multisample(target, 4, internal, SIZE, SIZE, true);
    } else {
        c.tex_image_3d_multisample(target, 4, internal, SIZE, SIZE, layers, true);
    }
    fine(c);
    name[0]
}

fn attach(c: &mut Context, point: GLenum, target: GLenum, name: GLuint, layer: i32) {
    if target == PLANE {
        c.framebuffer_texture_2d(FB, point, target, name, 0);
    } else {
        c.framebuffer_texture_layer(FB, point, name, 0, layer);
    }
    assert_eq!(c.check_framebuffer_status(FB), GL_FRAMEBUFFER_COMPLETE, "{:?}", c.messages());
}

/// Lets only one sample be drawn to.
fn only(c: &mut Context, sample: usize) {
    c.enable(GL_SAMPLE_MASK);
    c.sample_maski(0, 1 << sample);
}

/// A program that writes `color`, in use; samplers of texels of its kind begin with `kind`.
fn writing(c: &mut Context, kind: &str) -> GLint {
    let text = format!(
        "#version 130\nuniform {kind}vec4 color; out {kind}vec4 c; void main() {{ c = color; }}"
    );
    let program = use_program(c, "", &text);
    c.get_uniform_location(program, "color")
}

fn write(c: &mut Context, kind: &str, color: GLint, value: [u32; 4]) {
    match kind {
        "i" => c.uniform_4iv(color, 1, &value.map(|v| v as i32)),
        "u" => c.uniform_4uiv(color, 1, &value),
        _ => {
            let [r, g, b, a] = value.map(|v| v as f32 / 255.0);
            c.uniform_4f(color, r, g, b, a);
        }
    }
    rectangle(c, ALL, 0.0);
}

/// What a fetch of every pixel of a sample gives, as words. The texture is bound to `target`.
fn fetched(c: &mut Context, kind: &str, target: GLenum, layer: i32, sample: usize) -> Vec<u32> {
    let (sampler, at) = match target {
        PLANE => ("sampler2DMS", "p"),
        _ => ("sampler2DMSArray", "ivec3(p, layer)"),
    };
    let text = format!(
        "#version 130\n#extension GL_ARB_texture_multisample : require\nuniform {kind}{sampler} s; \
         uniform int layer, n; out {kind}vec4 c; void main() {{ ivec2 p = ivec2(gl_FragCoord.xy) + 0 * \
         layer; c = texelFetch(s, {at}, n); }}"
    );
    let program = use_program(c, "", &text);
    for (name, value) in [("s", 0), ("layer", layer), ("n", sample as i32)] {
        let location = c.get_uniform_location(program, name);
        c.uniform_1i(location, value);
    }
    let mut before = [0];
    c.get_integerv(GL_FRAMEBUFFER_BINDING, &mut before);
    framebuffer(c);
    let (internal, format, ty) = match kind {
        "i" => (GL_RGBA32I, GL_RGBA_INTEGER, GL_INT),
        "u" => (GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT),
        _ => (GL_RGBA32F, GL_RGBA, GL_FLOAT),
    };
    renderbuffer(c, AT, internal, SIZE, SIZE);
    rectangle(c, ALL, 0.0);
    let mut words = vec![0_u32; (4 * SIZE * SIZE) as usize];
    let out = DataOut::Bytes(super::bytes_of(&mut words));
    c.read_pixels(0, 0, SIZE, SIZE, format, ty, out);
    fine(c);
    c.bind_framebuffer(FB, before[0] as GLuint);
    c.use_program(0);
    words
}

/// What is drawn to a sample: no two are alike.
fn value(layer: i32, sample: usize) -> [u32; 4] {
    [10 * layer as u32 + 1, sample as u32 + 3, 255, 17 * (sample as u32 + 1)]
}

/// The words that a fetch of a value gives.
fn words(kind: &str, value: [u32; 4]) -> [u32; 4] {
    if kind.is_empty() { value.map(|v| (v as f32 / 255.0).to_bits()) } else { value }
}

#[test]
fn every_sample_of_every_layer_keeps_what_was_drawn_to_it() {
    for (internal, kind) in
        [(GL_RGBA8, ""), (GL_RGBA32F, ""), (GL_RGBA16I, "i"), (GL_RGBA8UI, "u"), (GL_RGBA32UI, "u")]
    {
        for (target, layers) in [(PLANE, 1), (ARRAY, 3)] {
            let mut c = context(SIZE as u32, SIZE as u32);
            let name = texture(&mut c, target, internal, layers);
            framebuffer(&mut c);
            attach(&mut c, AT, target, name, 0);
            let color = writing(&mut c, kind);
            // From layer to layer and back: what one holds does not depend on the others.
            for sample in 0..SAMPLES {
                only(&mut c, sample);
                for layer in (0..layers).rev() {
                    attach(&mut c, AT, target, name, layer);
                    write(&mut c, kind, color, value(layer, sample));
                }
            }
            c.disable(GL_SAMPLE_MASK);
            for layer in 0..layers {
                for sample in 0..SAMPLES {
                    let got = fetched(&mut c, kind, target, layer, sample);
                    let want = words(kind, value(layer, sample)).repeat((SIZE * SIZE) as usize);
                    assert_eq!(got, want, "{} {layer} {sample}", enum_name(internal));
                }
            }
        }
    }
}

#[test]
fn depths_are_fetched_by_sample_too() {
    let mut c = context(SIZE as u32, SIZE as u32);
    let name = texture(&mut c, PLANE, GL_DEPTH_COMPONENT32F, 1);
    framebuffer(&mut c);
    attach(&mut c, GL_DEPTH_ATTACHMENT, PLANE, name, 0);
    c.draw_buffer(GL_NONE);
    c.read_buffer(GL_NONE);
    c.enable(GL_DEPTH_TEST);
    c.depth_func(GL_ALWAYS);
    for sample in 0..SAMPLES {
        only(&mut c, sample);
        rectangle(&mut c, ALL, sample as f32 / 4.0);
    }
    c.disable(GL_SAMPLE_MASK);
    c.disable(GL_DEPTH_TEST);
    for sample in 0..SAMPLES {
        let got = fetched(&mut c, "", PLANE, 0, sample);
        let depth = 0.5 + sample as f32 / 8.0;
        assert!(got.iter().step_by(4).all(|word| *word == depth.to_bits()), "{sample}");
    }
}

#[test]
fn a_sample_is_covered_where_it_lies() {
    let mut c = context(SIZE as u32, SIZE as u32);
    let name = texture(&mut c, PLANE, GL_RGBA8, 1);
    let object = framebuffer(&mut c);
    attach(&mut c, AT, PLANE, name, 0);
    let mut places = [[0.0; 2]; SAMPLES];
    for (index, place) in places.iter_mut().enumerate() {
        c.get_multisamplefv(GL_SAMPLE_POSITION, index as GLuint, place);
    }
    fine(&mut c);
    let mut covered = 0;
    for axis in 0..2 {
        for sixteenth in (1..16).step_by(2) {
            // Up to somewhere in the second pixel along the axis; no sample lies on the edge.
            let part = sixteenth as f32 / 16.0;
            let end = (1.0 + part) / 2.0 - 1.0;
            let mut area = ALL;
            area[2 + axis] = end;
            c.bind_framebuffer(FB, object);
            c.clear(GL_COLOR_BUFFER_BIT);
            c.color_4f(1.0, 1.0, 1.0, 1.0);
            rectangle(&mut c, area, 0.0);
            let pixel = [1, SIZE as usize][axis];
            for (sample, place) in places.iter().enumerate() {
                let got = fetched(&mut c, "", PLANE, 0, sample)[4 * pixel];
                let want = f32::from(u8::from(place[axis] < part));
                assert_eq!(f32::from_bits(got), want, "{axis} {part} {place:?}");
                covered += usize::from(want == 1.0);
            }
        }
    }
    // Each sample has a row and a column of quarters of its own, so half of all are covered.
    assert_eq!(covered, 2 * 8 * SAMPLES / 2);
}

/// Draws to every sample of what is attached, each its value of a layer that it might be.
fn draw_values(c: &mut Context, layer: i32) {
    let color = writing(c, "");
    for sample in 0..SAMPLES {
        only(c, sample);
        write(c, "", color, value(layer, sample));
    }
    c.disable(GL_SAMPLE_MASK);
    c.use_program(0);
}

#[test]
fn a_blit_copies_samples_to_samples() {
    let mut c = context(SIZE as u32, SIZE as u32);
    // From an array's layer to a part of a renderbuffer, and from there to a texture.
    let from = texture(&mut c, ARRAY, GL_RGBA8, 2);
    let source = framebuffer(&mut c);
    attach(&mut c, AT, ARRAY, from, 1);
    draw_values(&mut c, 1);
    let middle = framebuffer(&mut c);
    let mut name = [0];
    c.gen_renderbuffers(1, &mut name);
    c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
    c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 4, GL_RGBA8, SIZE, SIZE);
    c.framebuffer_renderbuffer(FB, AT, GL_RENDERBUFFER, name[0]);
    draw_values(&mut c, 2);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, source);
    c.blit_framebuffer(0, 0, 2, 3, 1, 1, 3, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    let to = texture(&mut c, PLANE, GL_RGBA8, 1);
    framebuffer(&mut c);
    attach(&mut c, AT, PLANE, to, 0);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, middle);
    c.blit_framebuffer(0, 0, SIZE, SIZE, 0, 0, SIZE, SIZE, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    fine(&mut c);
    for sample in 0..SAMPLES {
        let got = fetched(&mut c, "", PLANE, 0, sample);
        for (pixel, got) in got.chunks(4).enumerate() {
            let (x, y) = (pixel as i32 % SIZE, pixel as i32 / SIZE);
            let inside = (1..3).contains(&x) && (1..4).contains(&y);
            let want = words("", value(if inside { 1 } else { 2 }, sample));
            assert_eq!(got, want, "{x} {y} {sample}");
        }
    }
}

#[test]
fn a_blit_resolves_and_spreads_samples() {
    let mut c = context(SIZE as u32, SIZE as u32);
    let name = texture(&mut c, ARRAY, GL_RGBA32F, 2);
    let several = framebuffer(&mut c);
    attach(&mut c, AT, ARRAY, name, 1);
    draw_values(&mut c, 0);
    let one = framebuffer(&mut c);
    renderbuffer(&mut c, AT, GL_RGBA32F, SIZE, SIZE);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, several);
    c.blit_framebuffer(0, 0, SIZE, SIZE, 0, 0, SIZE, SIZE, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, one);
    let got = floats(&mut c, [3, 3, 1, 1], GL_RGBA, 4);
    for (channel, got) in got.iter().enumerate() {
        let sum: u32 = (0..SAMPLES).map(|sample| value(0, sample)[channel]).sum();
        assert!((got - sum as f32 / 4.0 / 255.0).abs() < 1e-6, "{channel}: {got}");
    }
    // And back: all samples are alike.
    c.clear_color(0.25, 0.5, 0.75, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, several);
    c.blit_framebuffer(0, 0, SIZE, SIZE, 0, 0, SIZE, SIZE, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    fine(&mut c);
    for sample in 0..SAMPLES {
        let got = fetched(&mut c, "", ARRAY, 1, sample);
        assert_eq!(got[..4], [0.25_f32, 0.5, 0.75, 1.0].map(f32::to_bits), "{sample}");
        // The other layer was never drawn to.
        assert_eq!(fetched(&mut c, "", ARRAY, 0, sample)[..4], [0; 4], "{sample}");
    }
}

#[test]
fn attachments_have_the_same_samples_at_the_same_places() {
    let status = |first: (GLsizei, bool), second: Option<(GLsizei, bool)>| {
        let mut c = context(4, 4);
        framebuffer(&mut c);
        let (samples, fixed) = first;
        c.bind_texture(PLANE, 7);
        c.tex_image_2d_multisample(PLANE, samples, GL_RGBA8, 4, 4, fixed);
        c.framebuffer_texture_2d(FB, AT, PLANE, 7, 0);
        let one = c.check_framebuffer_status(FB);
        assert_eq!(one, GL_FRAMEBUFFER_COMPLETE);
        if let Some((samples, fixed)) = second {
            c.bind_texture(ARRAY, 8);
            c.tex_image_3d_multisample(ARRAY, samples, GL_RGBA16F, 4, 4, 2, fixed);
            c.framebuffer_texture_layer(FB, AT + 1, 8, 0, 1);
        } else {
            c.bind_renderbuffer(GL_RENDERBUFFER, 9);
            c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 4, GL_RGBA8, 4, 4);
            c.framebuffer_renderbuffer(FB, AT + 1, GL_RENDERBUFFER, 9);
        }
        c.check_framebuffer_status(FB)
    };
    let (complete, mixed) = (GL_FRAMEBUFFER_COMPLETE, GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE);
    // What is asked for is a least number, and every image has four.
    assert_eq!(status((1, true), Some((4, true))), complete);
    assert_eq!(status((2, false), Some((3, false))), complete);
    assert_eq!(status((4, true), Some((4, false))), mixed);
    assert_eq!(status((4, false), Some((4, true))), mixed);
    assert_eq!(status((4, true), None), complete);
    assert_eq!(status((4, false), None), mixed);
    // One sample beside several.
    let mut c = context(4, 4);
    let name = texture(&mut c, PLANE, GL_RGBA8, 1);
    framebuffer(&mut c);
    attach(&mut c, AT, PLANE, name, 0);
    renderbuffer(&mut c, AT + 1, GL_RGBA8, 4, 4);
    assert_eq!(c.check_framebuffer_status(FB), mixed);
}

#[test]
fn levels_and_proxies_say_how_many_samples_they_have() {
    const PROXY: GLenum = GL_PROXY_TEXTURE_2D_MULTISAMPLE_ARRAY;
    let known = |c: &mut Context, target: GLenum| {
        let names = [
            GL_TEXTURE_WIDTH,
            GL_TEXTURE_HEIGHT,
            GL_TEXTURE_DEPTH,
            GL_TEXTURE_SAMPLES,
            GL_TEXTURE_FIXED_SAMPLE_LOCATIONS,
            GL_TEXTURE_INTERNAL_FORMAT,
        ];
        names.map(|name| {
            let mut value = [-1];
            c.get_tex_level_parameteriv(target, 0, name, &mut value);
            value[0]
        })
    };
    let mut c = context(4, 4);
    assert_eq!(known(&mut c, ARRAY), [0, 0, 0, 0, 1, 1]);
    assert_eq!(known(&mut c, GL_TEXTURE_2D), [0, 0, 0, 0, 1, 1]);
    c.tex_image_3d_multisample(ARRAY, 3, GL_RGB8, 5, 6, 7, false);
    assert_eq!(known(&mut c, ARRAY), [5, 6, 7, 4, 0, GL_RGB8 as i32]);
    c.tex_image_2d_multisample(PLANE, 1, GL_DEPTH24_STENCIL8, 9, 2, true);
    assert_eq!(known(&mut c, PLANE), [9, 2, 1, 4, 1, GL_DEPTH24_STENCIL8 as i32]);
    c.tex_image_3d_multisample(PROXY, 4, GL_RGBA8, 8, 8, 2048, false);
    assert_eq!(known(&mut c, PROXY), [8, 8, 2048, 4, 0, GL_RGBA8 as i32]);
    // Too many layers, bytes or samples: the proxy says so, and nothing is refused.
    for (samples, internal, size) in
        [(4, GL_RGBA8, [8, 8, 2049]), (4, GL_RGBA32F, [8192, 8192, 1]), (5, GL_RGBA8, [8, 8, 1])]
    {
        let [width, height, depth] = size;
        c.tex_image_3d_multisample(PROXY, 4, GL_RGBA8, 8, 8, 1, true);
        assert_eq!(known(&mut c, PROXY)[0], 8);
        c.tex_image_3d_multisample(PROXY, samples, internal, width, height, depth, true);
        assert_eq!(known(&mut c, PROXY), [0; 6], "{samples} {size:?}");
    }
    c.tex_storage_2d_multisample(GL_PROXY_TEXTURE_2D_MULTISAMPLE, 2, GL_R8, 3, 3, true);
    assert_eq!(known(&mut c, GL_PROXY_TEXTURE_2D_MULTISAMPLE), [3, 3, 1, 4, 1, GL_R8 as i32]);
    c.bind_texture(ARRAY, 5);
    c.tex_storage_3d_multisample(ARRAY, 4, GL_R32F, 3, 2, 1, true);
    assert_eq!(known(&mut c, ARRAY), [3, 2, 1, 4, 1, GL_R32F as i32]);
    let mut immutable = [0];
    c.get_tex_parameteriv(ARRAY, GL_TEXTURE_IMMUTABLE_FORMAT, &mut immutable);
    assert_eq!(immutable, [1]);
    fine(&mut c);
}

#[test]
fn shaders_know_sizes_and_programs_the_types_of_samplers() {
    let mut c = context(SIZE as u32, SIZE as u32);
    c.tex_image_2d_multisample(PLANE, 4, GL_RGBA8, 40, 50, true);
    c.tex_image_3d_multisample(ARRAY, 4, GL_RGBA8UI, 60, 70, 80, true);
    let program = use_program(
        &mut c,
        "",
        "#version 130\n#extension GL_ARB_texture_multisample : enable\n\
         #ifndef GL_ARB_texture_multisample\n#error it has no macro\n#endif\n\
         uniform sampler2DMS plane; uniform usampler2DMSArray array; out vec4 c;\n\
         void main() { ivec3 size = textureSize(array); \
         c = vec4(ivec4(textureSize(plane), size.x + size.y, size.z)) / 255.0; }",
    );
    let array = c.get_uniform_location(program, "array");
    c.uniform_1i(array, 1);
    rectangle(&mut c, ALL, 0.0);
    assert_eq!(bytes(&mut c, [0, 0, 1, 1], GL_RGBA, 4), [40, 50, 130, 80]);
    let mut types = Vec::new();
    for index in 0..2 {
        let (mut size, mut ty) = ([0], [0]);
        let name = TextOut::Null;
        c.get_active_uniform(program, index, 0, &mut [0], &mut size, &mut ty, name);
        types.push(ty[0]);
    }
    types.sort_unstable();
    let mut want = [GL_SAMPLER_2D_MULTISAMPLE, GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY];
    want.sort_unstable();
    assert_eq!(types, want);
}

#[test]
fn a_unit_has_its_own_texture_for_samples_and_no_sampler_object_for_it() {
    let mut c = context(SIZE as u32, SIZE as u32);
    let name = texture(&mut c, PLANE, GL_RGBA32I, 1);
    framebuffer(&mut c);
    attach(&mut c, AT, PLANE, name, 0);
    c.clear_bufferiv(GL_COLOR, 0, &[-1, 2, -3, 4]);
    // A filter with mipmaps would leave another texture incomplete.
    let mut sampler = [0];
    c.gen_samplers(1, &mut sampler);
    c.bind_sampler(0, sampler[0]);
    c.sampler_parameteri(sampler[0], GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR as i32);
    let got = fetched(&mut c, "i", PLANE, 0, 3);
    assert_eq!(got[..4], [-1, 2, -3, 4].map(|v: i32| v as u32));
    // An array's layers are stored alike, but are not the same.
    use_program(
        &mut c,
        "",
        "#version 130\n#extension GL_ARB_texture_multisample : enable\n\
         uniform isampler2DMS a; uniform isampler2DArray b; out ivec4 c;\n\
         void main() { c = texelFetch(a, ivec2(0), 0) + texelFetch(b, ivec3(0), 0); }",
    );
    rectangle(&mut c, ALL, 0.0);
    assert_eq!(c.get_error(), GL_INVALID_OPERATION, "both samplers name unit 0");
}

#[test]
fn no_hint_asks_to_switch_on_what_is_for_shaders_alone() {
    let mut c = context(SIZE as u32, SIZE as u32);
    let told = |c: &mut Context| {
        rectangle(c, ALL, 0.0);
        assert_eq!(c.get_error(), GL_NO_ERROR);
        c.messages().iter().filter(|m| m.text.contains("texturing is off")).count()
    };
    texture(&mut c, PLANE, GL_RGBA8, 1);
    texture(&mut c, ARRAY, GL_RGBA8, 1);
    assert_eq!(told(&mut c), 0);
    c.bind_texture(GL_TEXTURE_2D, 77);
    assert_eq!(told(&mut c), 1);
}
