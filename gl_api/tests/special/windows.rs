//! Windows with 2 and 4 samples a pixel: GL 2.1, section 3.2.1.

use super::{draw, fine, pixel};
use gl_api::*;

fn window(samples: u8) -> Context {
    let surface = SurfaceDesc { samples, ..SurfaceDesc::default() };
    let desc = ContextDesc { width: 4, height: 4, surface, ..ContextDesc::default() };
    Context::new(desc).expect("such a window")
}

/// The left part of the window, up to a third of the second column.
const PART: [[f32; 3]; 4] =
    [[-1.0, -1.0, 0.0], [-0.35, -1.0, 0.0], [-0.35, 1.0, 0.0], [-1.0, 1.0, 0.0]];

#[test]
fn an_edge_is_covered_in_steps_of_a_sample() {
    for samples in [2, 4] {
        let mut c = window(samples);
        let mut answers = [0; 2];
        c.get_integerv(GL_SAMPLES, &mut answers[..1]);
        c.get_integerv(GL_SAMPLE_BUFFERS, &mut answers[1..]);
        assert_eq!(answers, [i32::from(samples), 1]);
        // An edge that is not upright: every pixel on it is covered in part.
        c.begin(GL_TRIANGLES);
        c.vertex_2f(-1.0, -1.0);
        c.vertex_2f(1.0, -1.0);
        c.vertex_2f(-1.0, 1.0);
        c.end();
        let step = 255.0 / f32::from(samples);
        let mut partial = 0;
        for (x, y) in [(0, 3), (1, 2), (2, 1), (3, 0)] {
            let red = f32::from(pixel(&mut c, x, y)[0]);
            let steps = (red / step).round();
            assert!((red - steps * step).abs() <= 1.0, "{samples} samples: {red}");
            partial += i32::from(steps > 0.0 && steps < f32::from(samples));
        }
        assert!(partial > 0, "{samples} samples");
        assert_eq!(pixel(&mut c, 0, 0), [255; 4]);
        assert_eq!(pixel(&mut c, 3, 3), [0; 4]);
    }
}

#[test]
fn without_multisampling_a_pixel_is_all_or_nothing() {
    for samples in [1, 2, 4] {
        let mut c = window(samples);
        c.disable(GL_MULTISAMPLE);
        draw(&mut c, GL_QUADS, &PART);
        for x in 0..4 {
            let found = pixel(&mut c, x, 1);
            assert!(found == [0; 4] || found == [255; 4], "{samples} samples: {found:?}");
        }
    }
}

#[test]
fn a_window_resolves_to_a_framebuffer_by_blit() {
    for samples in [2, 4] {
        let mut c = window(samples);
        draw(&mut c, GL_TRIANGLES, &[[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [-1.0, 1.0, 0.0]]);
        let expected = pixel(&mut c, 1, 2);
        c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 1);
        c.bind_renderbuffer(GL_RENDERBUFFER, 1);
        c.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, 4, 4);
        let point = GL_COLOR_ATTACHMENT0;
        c.framebuffer_renderbuffer(GL_DRAW_FRAMEBUFFER, point, GL_RENDERBUFFER, 1);
        c.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        c.bind_framebuffer(GL_READ_FRAMEBUFFER, 1);
        assert_eq!(pixel(&mut c, 1, 2), expected);
        fine(&mut c);
    }
}

/// A window has the samples that it was asked for, at as many places, or it is refused.
#[test]
fn a_window_has_one_sample_two_or_four() {
    for samples in 0..=9 {
        let surface = SurfaceDesc { samples, ..SurfaceDesc::default() };
        let desc = ContextDesc { width: 4, height: 4, surface, ..ContextDesc::default() };
        let made = Context::new(desc);
        if ![0, 1, 2, 4].contains(&samples) {
            let text = made.expect_err("it is refused").to_string();
            assert!(text.contains(&format!("samples: {samples}")), "{text}");
            assert!(text.contains("1, 2 or 4 samples"), "{text}");
            continue;
        }
        let mut c = made.expect("a context");
        let mut value = [0];
        c.get_integerv(GL_SAMPLES, &mut value);
        let count = if samples < 2 { 0 } else { samples };
        assert_eq!(value, [count.into()]);
        let is_place = |index: u8| {
            c.get_multisamplefv(GL_SAMPLE_POSITION, index.into(), &mut [0.0; 2]);
            c.get_error() == GL_NO_ERROR
        };
        assert_eq!([0, 1, 2, 3, 4].map(is_place), [0, 1, 2, 3, 4].map(|index| index < count));
    }
}
