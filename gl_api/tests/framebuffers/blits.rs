//! `glBlitFramebuffer` against its definition.

use super::{bytes, context, fine, framebuffer, renderbuffer};
use gl_api::*;

/// A framebuffer of 8 × 6 whose red is the column and green the row, times 20.
fn source(c: &mut Context) -> GLuint {
    let name = framebuffer(c);
    renderbuffer(c, GL_COLOR_ATTACHMENT0, GL_RGBA8, 8, 6);
    renderbuffer(c, GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8, 8, 6);
    c.enable(GL_SCISSOR_TEST);
    for y in 0..6 {
        for x in 0..8 {
            c.scissor(x, y, 1, 1);
            c.clear_color(x as f32 * 20.0 / 255.0, y as f32 * 20.0 / 255.0, 0.0, 1.0);
            c.clear_stencil(x + 10 * y);
            c.clear_depth(f64::from(x) / 8.0);
            c.clear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        }
    }
    c.disable(GL_SCISSOR_TEST);
    name
}

/// The default framebuffer of 20 × 20, cleared to 255, after a blit.
fn blit(c: &mut Context, src: [i32; 4], dst: [i32; 4], mask: GLenum, filter: GLenum) {
    let [x0, y0, x1, y1] = src;
    let [u0, v0, u1, v1] = dst;
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
    c.clear_color(1.0, 1.0, 1.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.blit_framebuffer(x0, y0, x1, y1, u0, v0, u1, v1, mask, filter);
    fine(c);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, 0);
}

#[test]
fn nearest_takes_the_texel_under_the_centre_whichever_way_round() {
    for (src, dst) in [
        ([0, 0, 8, 6], [0, 0, 8, 6]),
        ([0, 0, 8, 6], [2, 1, 18, 13]),
        ([0, 0, 8, 6], [18, 1, 2, 13]),
        ([7, 5, 1, 1], [2, 3, 11, 17]),
        ([0, 0, 8, 6], [0, 12, 5, 0]),
        ([-3, -2, 12, 9], [0, 0, 20, 20]),
    ] {
        let mut c = context(20, 20);
        source(&mut c);
        blit(&mut c, src, dst, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        let got = bytes(&mut c, [0, 0, 20, 20], GL_RGB, 3);
        for y in 0..20 {
            for x in 0..20 {
                let at = |pixel: i32, axis: usize| {
                    let (s0, s1) = (f64::from(src[axis]), f64::from(src[axis + 2]));
                    let (d0, d1) = (f64::from(dst[axis]), f64::from(dst[axis + 2]));
                    let along = (f64::from(pixel) + 0.5 - d0) / (d1 - d0);
                    (0.0..1.0).contains(&along).then(|| (s0 + along * (s1 - s0)).floor())
                };
                let texel = at(x, 0).zip(at(y, 1));
                let texel = texel.filter(|(u, v)| (0.0..8.0).contains(u) && (0.0..6.0).contains(v));
                let want = texel.map_or([255; 3], |(u, v)| [u as u8 * 20, v as u8 * 20, 0]);
                let at = (y * 20 + x) as usize * 3;
                assert_eq!(got[at..at + 3], want, "{src:?} to {dst:?} at {x}, {y}");
            }
        }
    }
}

#[test]
fn linear_weighs_four_texels_and_clamps_at_the_edge() {
    let mut c = context(20, 20);
    source(&mut c);
    blit(&mut c, [0, 0, 8, 6], [0, 0, 16, 18], GL_COLOR_BUFFER_BIT, GL_LINEAR);
    let got = bytes(&mut c, [0, 0, 20, 20], GL_RG, 2);
    for y in 0..18 {
        for x in 0..16 {
            let u = ((f64::from(x) + 0.5) / 2.0 - 0.5).clamp(0.0, 7.0) * 20.0;
            let v = ((f64::from(y) + 0.5) / 3.0 - 0.5).clamp(0.0, 5.0) * 20.0;
            let at = (y * 20 + x) as usize * 2;
            assert!((f64::from(got[at]) - u).abs() <= 0.5, "{x}, {y}");
            assert!((f64::from(got[at + 1]) - v).abs() <= 0.5001, "{x}, {y}");
        }
    }
}

#[test]
fn depth_and_stencil_are_copied_each_for_itself() {
    let mut c = context(20, 20);
    source(&mut c);
    c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
    c.clear_depth(1.0);
    c.clear_stencil(99);
    c.clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    c.enable(GL_SCISSOR_TEST);
    c.scissor(0, 0, 6, 20);
    c.blit_framebuffer(0, 0, 8, 6, 0, 0, 8, 6, GL_STENCIL_BUFFER_BIT, GL_NEAREST);
    c.disable(GL_SCISSOR_TEST);
    fine(&mut c);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    let got = bytes(&mut c, [0, 0, 8, 6], GL_STENCIL_INDEX, 1);
    for (i, got) in got.into_iter().enumerate() {
        let (x, y) = (i % 8, i / 8);
        assert_eq!(usize::from(got), if x < 6 { x + 10 * y } else { 99 });
    }
    let depth = super::floats(&mut c, [0, 0, 8, 6], GL_DEPTH_COMPONENT, 1);
    assert!(depth.iter().all(|&depth| depth == 1.0));
}

#[test]
fn formats_are_converted() {
    let mut c = context(20, 20);
    let read = source(&mut c);
    let draw = framebuffer(&mut c);
    renderbuffer(&mut c, GL_COLOR_ATTACHMENT0, GL_RGBA32F, 8, 6);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, read);
    c.blit_framebuffer(0, 0, 8, 6, 0, 0, 8, 6, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, draw);
    let got = super::floats(&mut c, [7, 5, 1, 1], GL_RGBA, 4);
    assert_eq!(got, [(140.0_f64 / 255.0) as f32, (100.0_f64 / 255.0) as f32, 0.0, 1.0]);
}

/// Of one that is infinite, too, which has no part in means.
#[test]
fn linear_means_of_one_texel_are_that_texel() {
    let mut c = context(20, 20);
    let [read, draw] = [0, 1].map(|_| {
        let name = framebuffer(&mut c);
        renderbuffer(&mut c, GL_COLOR_ATTACHMENT0, GL_RGBA32F, 8, 6);
        name
    });
    c.bind_framebuffer(GL_FRAMEBUFFER, read);
    c.clear_color(f32::INFINITY, -2.5, 0.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    for dst in [[0, 0, 8, 6], [8, 6, 0, 0]] {
        c.bind_framebuffer(GL_FRAMEBUFFER, draw);
        c.clear_color(0.0, 0.0, 0.0, 0.0);
        c.clear(GL_COLOR_BUFFER_BIT);
        c.bind_framebuffer(GL_READ_FRAMEBUFFER, read);
        let [x0, y0, x1, y1] = dst;
        c.blit_framebuffer(0, 0, 8, 6, x0, y0, x1, y1, GL_COLOR_BUFFER_BIT, GL_LINEAR);
        c.bind_framebuffer(GL_READ_FRAMEBUFFER, draw);
        let got = super::floats(&mut c, [0, 0, 8, 6], GL_RGBA, 4);
        assert_eq!(got, [f32::INFINITY, -2.5, 0.0, 1.0].repeat(48));
    }
}

/// Depths go between formats that store them alike, with a stencil beside them or not, which stays.
#[test]
fn depths_go_to_formats_that_have_a_stencil_too() {
    let pairs = [
        (GL_DEPTH_COMPONENT24, GL_DEPTH24_STENCIL8),
        (GL_DEPTH_COMPONENT32F, GL_DEPTH32F_STENCIL8),
    ];
    for (plain, packed) in pairs {
        let depth_point = |format| {
            if format == plain { GL_DEPTH_ATTACHMENT } else { GL_DEPTH_STENCIL_ATTACHMENT }
        };
        for [from, to] in [[plain, packed], [packed, plain]] {
            let mut c = context(4, 4);
            let mut objects = [0; 2];
            for (object, format) in objects.iter_mut().zip([from, to]) {
                *object = framebuffer(&mut c);
                renderbuffer(&mut c, depth_point(format), format, 4, 4);
                c.draw_buffer(GL_NONE);
                c.read_buffer(GL_NONE);
                c.clear_depth(if format == from { 0.3 } else { 0.9 });
                c.clear_stencil(77);
                c.clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
            }
            c.bind_framebuffer(GL_READ_FRAMEBUFFER, objects[0]);
            c.blit_framebuffer(0, 0, 4, 2, 0, 0, 4, 2, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
            fine(&mut c);
            let depths = |c: &mut Context, object| {
                c.bind_framebuffer(GL_READ_FRAMEBUFFER, object);
                super::floats(c, [0, 0, 4, 4], GL_DEPTH_COMPONENT, 1)
            };
            let [want, got] = objects.map(|object| depths(&mut c, object));
            assert_eq!(got[..8], want[..8]);
            assert!(got[8..].iter().all(|depth| (depth - 0.9).abs() < 1e-6), "{got:?}");
            if to == packed {
                let stencils = bytes(&mut c, [0, 0, 4, 4], GL_STENCIL_INDEX, 1);
                assert_eq!(stencils, [77; 16]);
            }
        }
    }
}

/// `EXT_framebuffer_multisample_blit_scaled`: as if the samples were resolved first, and that were filtered.
#[test]
fn samples_are_resolved_and_scaled_at_once() {
    let mut c = context(16, 16);
    let several = framebuffer(&mut c);
    let mut name = [0];
    c.gen_renderbuffers(1, &mut name);
    c.bind_renderbuffer(GL_RENDERBUFFER, name[0]);
    c.renderbuffer_storage_multisample(GL_RENDERBUFFER, 4, GL_RGBA8, 6, 6);
    c.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, name[0]);
    c.clear(GL_COLOR_BUFFER_BIT);
    c.viewport(0, 0, 6, 6);
    c.begin(GL_TRIANGLES);
    for [x, y] in [[-0.9, -0.8], [0.9, -0.3], [-0.1, 0.95]] {
        c.vertex_2f(x, y);
    }
    c.end();
    let resolved = framebuffer(&mut c);
    renderbuffer(&mut c, GL_COLOR_ATTACHMENT0, GL_RGBA8, 6, 6);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, several);
    c.blit_framebuffer(0, 0, 6, 6, 0, 0, 6, 6, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    let (src, dst) = ([1, 0, 6, 5], [15, 2, 2, 16]);
    c.bind_framebuffer(GL_READ_FRAMEBUFFER, resolved);
    blit(&mut c, src, dst, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    let want = bytes(&mut c, [0, 0, 16, 16], GL_RGBA, 4);
    for filter in [GL_SCALED_RESOLVE_FASTEST_EXT, GL_SCALED_RESOLVE_NICEST_EXT] {
        c.bind_framebuffer(GL_READ_FRAMEBUFFER, several);
        blit(&mut c, src, dst, GL_COLOR_BUFFER_BIT, filter);
        assert_eq!(bytes(&mut c, [0, 0, 16, 16], GL_RGBA, 4), want);
    }
}
