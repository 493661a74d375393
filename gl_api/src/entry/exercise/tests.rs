//! The whole table of entry points with random arguments, bounded.

use super::*;
use crate::base::args::DataOut;
use crate::base::begin_end::BeginEnd;
use crate::base::types::GLenum;
use crate::context::ContextDesc;
use rasterizer::driver::{Device, DeviceDesc};
use std::sync::Arc;
use std::time::{Duration, Instant};
use texunit::lanes::Isa;

/// A small context, whose shaders are stopped soon.
fn context() -> Context {
    let desc = DeviceDesc { budget: 20_000, ..DeviceDesc::new(Isa::best(), 2) };
    let device = Some(Arc::new(Device::new(desc).expect("threads start")));
    Context::new(ContextDesc { width: 16, height: 8, device, ..ContextDesc::default() })
        .expect("a small context")
}

fn clear_errors(c: &mut Context) {
    c.end();
    while c.get_error() != GL_NO_ERROR {}
    c.messages();
}

/// A white clear of the default framebuffer, read back.
fn still_works(c: &mut Context) {
    c.end();
    c.end_list();
    c.render_mode(GL_RENDER);
    c.end_conditional_render();
    c.use_program(0);
    c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    c.bind_buffer(GL_PIXEL_PACK_BUFFER, 0);
    c.draw_buffer(GL_BACK);
    c.read_buffer(GL_BACK);
    c.push_attrib(GL_ALL_ATTRIB_BITS);
    c.pop_attrib();
    c.color_mask(true, true, true, true);
    c.disable(GL_SCISSOR_TEST);
    c.disable(GL_FRAMEBUFFER_SRGB);
    c.end_transform_feedback();
    c.disable(GL_RASTERIZER_DISCARD);
    clear_errors(c);
    c.clear_color(1.0, 1.0, 1.0, 1.0);
    c.clear(GL_COLOR_BUFFER_BIT);
    let said = c.messages();
    for name in [GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_SWAP_BYTES] {
        c.pixel_storei(name, 0);
    }
    for name in [GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE] {
        c.pixel_transferf(name, 1.0);
    }
    for name in [GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_MAP_COLOR] {
        c.pixel_transferf(name, 0.0);
    }
    clear_errors(c);
    let mut out = [0_u8; 16 * 8 * 4];
    c.read_pixels(0, 0, 16, 8, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut out));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    assert!(out.iter().all(|&byte| byte == 255), "{out:?}\n{said:?}");
}

#[test]
fn the_whole_table_with_random_arguments_never_panics_and_leaves_a_context_that_works() {
    let start = Instant::now();
    let all = exercises();
    for seed in 0..400 {
        let (mut c, mut random) = (context(), Random::new(seed, &[]));
        for number in 0..2 * all.len() {
            // What begins a primitive or a list would otherwise swallow most of the rest.
            if number % 16 == 0 {
                c.end();
                c.end_list();
            }
            let exercise = &all[random.below(all.len())];
            // Counts from random bytes are of billions of vertices, which take all memory where arrays are of instances
            // and have no end: other tests make these calls.
            if exercise.name.ends_with("Indirect") {
                continue;
            }
            let before = Instant::now();
            (exercise.run)(&mut c, &mut random);
            let took = before.elapsed();
            assert!(!c.objects.shared.is_locked(), "{} keeps the group locked", exercise.name);
            assert!(took < Duration::from_secs(10), "{} took {took:?}", exercise.name);
        }
        still_works(&mut c);
        // A slow machine tries fewer.
        if start.elapsed() > Duration::from_secs(6) {
            break;
        }
    }
}

#[test]
fn every_call_is_made_by_itself_in_a_fresh_context() {
    let mut random = Random::new(7, &[]);
    let mut c = context();
    for exercise in exercises() {
        for _ in 0..3 {
            (exercise.run)(&mut c, &mut random);
        }
        if exercise.begin_end != BeginEnd::Allowed {
            clear_errors(&mut c);
        }
    }
    still_works(&mut c);
}

#[test]
fn between_begin_and_end_every_other_call_is_refused_and_changes_nothing() {
    let mut random = Random::new(1, &[]);
    for exercise in exercises() {
        if exercise.begin_end == BeginEnd::Allowed {
            continue;
        }
        let mut c = context();
        c.begin(GL_TRIANGLES);
        let before = format!("{:?}", c.state);
        (exercise.run)(&mut c, &mut random);
        let after = format!("{:?}", c.state);
        assert!(before == after, "{}", exercise.name);
        c.immediate = None;
        let refused: GLenum = c.get_error();
        assert_eq!(refused, GL_INVALID_OPERATION, "{}", exercise.name);
        let text: String = c.messages().iter().map(ToString::to_string).collect();
        assert!(
            text.starts_with(&format!("error: {}: ", exercise.name))
                && text.contains("must not be called between glBegin and glEnd"),
            "{text}"
        );
    }
}

#[test]
fn every_row_of_the_table_is_exercised() {
    let names: Vec<&str> = exercises().iter().map(|exercise| exercise.name).collect();
    for name in crate::entry::canonical() {
        assert!(names.contains(&name), "{name}");
    }
}
