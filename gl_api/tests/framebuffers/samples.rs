//! Drawing to several samples a pixel, resolved by a blit (GL 2.1, sections 3.2.1 and 4.1.3).

use super::shading::use_program;
use super::{bytes, context, framebuffer, rectangle};
use gl_api::*;

/// A framebuffer of 4×4 pixels with four samples, cleared to black, bound.
fn multisampled(c: &mut Context) -> GLuint {
    let object = framebuffer(c);
    let mut name = [0];
    c.gen_renderbuffers(1, &mut name);
    c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
    c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 4, GL_RGBA8, 4, 4);
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, name[0]);
    c.disable(GL_CULL_FACE);
    c.clear_color(0.0, 0.0, 0.0, 0.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    object
}

/// The lower row of what the samples resolve to, red only.
fn resolved(c: &mut Context, object: GLuint) -> Vec<u8> {
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
    c.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    let row = bytes(c, [0, 0, 4, 1], GL_RGBA, 4);
    c.bind_framebuffer(GL_FRAMEBUFFER, object);
    row.chunks(4).map(|texel| texel[0]).collect()
}

/// Fills the part of the target left of `x` pixels with white of this alpha.
fn fill(c: &mut Context, x: f32, alpha: f32) {
    let right = x / 2.0 - 1.0;
    c.clear(GL_COLOR_BUFFER_BIT);
    c.color_4f(1.0, 1.0, 1.0, alpha);
    rectangle(c, [-1.0, -1.0, right, 1.0], 0.0);
}

#[test]
fn edges_cover_the_samples_left_of_them() {
    let mut c = context(4, 4);
    let object = multisampled(&mut c);
    let mut value = [0];
    c.get_integerv(GL_SAMPLES, &mut value);
    assert_eq!(value, [4]);
    c.get_integerv(GL_SAMPLE_BUFFERS, &mut value);
    assert_eq!(value, [1]);
    for (x, second) in [(1.0, 0), (1.25, 64), (1.5, 128), (1.75, 191), (2.0, 255)] {
        fill(&mut c, x, 1.0);
        assert_eq!(resolved(&mut c, object), [255, second, 0, 0], "{x}");
    }
    c.disable(GL_MULTISAMPLE);
    for (x, second) in [(1.25, 0), (1.75, 255)] {
        fill(&mut c, x, 1.0);
        assert_eq!(resolved(&mut c, object), [255, second, 0, 0], "{x}");
    }
}

#[test]
fn alpha_and_the_coverage_value_choose_samples() {
    let mut c = context(4, 4);
    let object = multisampled(&mut c);
    c.enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    for (alpha, red) in [(0.0, 0), (0.25, 64), (0.5, 128), (0.75, 191), (1.0, 255)] {
        fill(&mut c, 4.0, alpha);
        assert_eq!(resolved(&mut c, object), [red; 4], "{alpha}");
    }
    c.disable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    c.sample_coverage(0.25, true);
    fill(&mut c, 4.0, 0.5);
    assert_eq!(resolved(&mut c, object), [255; 4]);
    c.enable(GL_SAMPLE_COVERAGE);
    fill(&mut c, 4.0, 0.5);
    assert_eq!(resolved(&mut c, object), [191; 4]);
    c.disable(GL_MULTISAMPLE);
    fill(&mut c, 4.0, 0.5);
    assert_eq!(resolved(&mut c, object), [255; 4]);
}

#[test]
fn the_mask_keeps_the_samples_that_its_bits_name() {
    let mut c = context(4, 4);
    let object = multisampled(&mut c);
    c.enable(GL_SAMPLE_MASK);
    for (mask, red) in [(0, 0), (0b1000, 64), (0b0101, 128), (0xF0, 0), (0b1110, 191), (!0, 255)] {
        c.sample_maski(0, mask);
        fill(&mut c, 4.0, 1.0);
        assert_eq!(resolved(&mut c, object), [red; 4], "{mask:#b}");
    }
    // The coverage value leaves two other samples, of which the mask takes one.
    c.sample_maski(0, 0b0110);
    c.enable(GL_SAMPLE_COVERAGE);
    c.sample_coverage(0.5, false);
    fill(&mut c, 4.0, 1.0);
    assert_eq!(resolved(&mut c, object), [64; 4]);
    c.disable(GL_SAMPLE_COVERAGE);
    // Clears do not look at it, and nothing does where there is one sample.
    c.clear_color(1.0, 0.0, 0.0, 0.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    assert_eq!(resolved(&mut c, object), [255; 4]);
    c.clear_color(0.0, 0.0, 0.0, 0.0);
    c.disable(GL_MULTISAMPLE);
    fill(&mut c, 4.0, 1.0);
    assert_eq!(resolved(&mut c, object), [255; 4]);
    c.enable(GL_MULTISAMPLE);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    c.sample_maski(0, 0);
    fill(&mut c, 4.0, 1.0);
    assert_eq!(bytes(&mut c, [0, 0, 1, 1], GL_RED, 1), [255]);
}

#[test]
fn the_state_of_samples_is_kept_and_answered() {
    let mut c = context(4, 4);
    let mut value = [0.0];
    c.get_floatv(GL_SAMPLE_COVERAGE_VALUE, &mut value);
    assert_eq!(value, [1.0]);
    let mask = |c: &mut Context| {
        let mut value = [7];
        c.get_integeri_v(GL_SAMPLE_MASK_VALUE, 0, &mut value);
        value[0]
    };
    assert_eq!(mask(&mut c), -1);
    c.push_attrib(GL_MULTISAMPLE_BIT);
    c.enable(GL_SAMPLE_ALPHA_TO_ONE);
    c.enable(GL_SAMPLE_MASK);
    c.sample_maski(0, 0x8000_0005);
    assert_eq!(mask(&mut c) as u32, 0x8000_0005);
    c.sample_coverage(7.0, false);
    c.get_floatv(GL_SAMPLE_COVERAGE_VALUE, &mut value);
    assert_eq!(value, [1.0]);
    c.sample_coverage(0.5, true);
    c.get_floatv(GL_SAMPLE_COVERAGE_VALUE, &mut value);
    assert_eq!(value, [0.5]);
    c.get_floatv(GL_SAMPLE_COVERAGE_INVERT, &mut value);
    assert_eq!(value, [1.0]);
    assert!(c.is_enabled(GL_SAMPLE_ALPHA_TO_ONE));
    c.pop_attrib();
    c.get_floatv(GL_SAMPLE_COVERAGE_INVERT, &mut value);
    assert_eq!(value, [0.0]);
    assert!(!c.is_enabled(GL_SAMPLE_ALPHA_TO_ONE));
    assert!(!c.is_enabled(GL_SAMPLE_MASK));
    assert_eq!(mask(&mut c), -1);
    assert_eq!(c.get_error(), GL_NO_ERROR);
}

/// The bytes of the middle pixel after a point of a size that covers it is drawn with an alpha of 204.
fn alpha_of_point(c: &mut Context, object: GLuint, size: f32) -> u8 {
    c.clear(GL_COLOR_BUFFER_BIT);
    c.point_size(size);
    c.color_4f(1.0, 1.0, 1.0, 0.8);
    c.begin(GL_POINTS);
    c.vertex_2f(0.25, 0.25);
    c.end();
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
    c.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    let pixel = bytes(c, [2, 2, 1, 1], GL_RGBA, 4);
    c.bind_framebuffer(GL_FRAMEBUFFER, object);
    assert_eq!(pixel[0], 255, "size {size}");
    pixel[3]
}

#[test]
fn points_below_the_threshold_fade_with_the_square_of_their_size() {
    let mut c = context(4, 4);
    let object = multisampled(&mut c);
    c.point_parameterf(GL_POINT_FADE_THRESHOLD_SIZE, 4.0);
    for (size, alpha) in [(8.0, 204), (4.0, 204), (2.0, 51), (1.0, 13)] {
        assert_eq!(alpha_of_point(&mut c, object, size), alpha, "size {size}");
    }
    // The derived size counts: 8 / 4 = 2.
    c.point_parameterfv(GL_POINT_DISTANCE_ATTENUATION, &[16.0, 0.0, 0.0]);
    assert_eq!(alpha_of_point(&mut c, object, 8.0), 51);
    c.point_parameterf(GL_POINT_SIZE_MIN, 4.0);
    assert_eq!(alpha_of_point(&mut c, object, 8.0), 204);
    c.point_parameterf(GL_POINT_SIZE_MIN, 0.0);
    // The alpha test comes after it.
    c.enable(GL_ALPHA_TEST);
    c.alpha_func(GL_LESS, 0.5);
    assert_eq!(alpha_of_point(&mut c, object, 8.0), 51);
    c.disable(GL_ALPHA_TEST);
    // Nothing fades without multisampling.
    c.disable(GL_MULTISAMPLE);
    assert_eq!(alpha_of_point(&mut c, object, 8.0), 204);
    assert_eq!(c.get_error(), GL_NO_ERROR);
}

/// GL 3.0, section 4.1.3: where draw buffer zero holds integers, alpha chooses no samples and stays as it is, in the other
/// buffers too.
#[test]
fn alpha_chooses_no_samples_where_the_first_buffer_has_integers() {
    for (first, red, alpha) in [(GL_RGBA8, 128, 128), (GL_RGBA8I, 255, 128)] {
        let mut c = context(4, 4);
        let object = framebuffer(&mut c);
        for (point, format) in [(GL_COLOR_ATTACHMENT0, first), (GL_COLOR_ATTACHMENT1, GL_RGBA8)] {
            let mut name = [0];
            c.gen_renderbuffers(1, &mut name);
            c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
            c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 4, format, 4, 4);
            c.framebuffer_renderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name[0]);
        }
        let output = if first == GL_RGBA8 { "vec4" } else { "ivec4" };
        let fragment = format!(
            "#version 330 compatibility
            layout(location = 0) out {output} a; layout(location = 1) out vec4 b;
            void main() {{ a = {output}(vec4(1.0, 1.0, 1.0, 0.5)); b = vec4(1.0, 1.0, 1.0, 0.5); }}"
        );
        use_program(&mut c, "void main() { gl_Position = gl_Vertex; }", &fragment);
        c.draw_buffers(2, &[GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1]);
        c.read_buffer(GL_COLOR_ATTACHMENT1);
        c.clear_bufferfv(GL_COLOR, 1, &[0.0; 4]);
        c.enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
        rectangle(&mut c, super::ALL, 0.0);
        assert_eq!(resolved(&mut c, object), [red; 4], "{output}");
        c.disable(GL_SAMPLE_ALPHA_TO_COVERAGE);
        c.enable(GL_SAMPLE_ALPHA_TO_ONE);
        rectangle(&mut c, super::ALL, 0.0);
        c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
        c.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        c.bind_framebuffer(GL_FRAMEBUFFER, 0);
        let want = if first == GL_RGBA8 { 255 } else { alpha };
        assert_eq!(bytes(&mut c, [0, 0, 1, 1], GL_ALPHA, 1), [want], "{output}");
    }
}
