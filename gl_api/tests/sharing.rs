//! Contexts of one share group on several threads: GL 3.1, appendix D; `ARB_sync`, GL 3.2, section 5.3.

#[path = "common/shading.rs"]
mod shading;

use gl_api::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

const SIZE: u32 = 256;
/// A timeout that only a failed test waits for.
const LONG: u64 = 60_000_000_000;

fn context() -> Context {
    let desc = ContextDesc { width: SIZE, height: SIZE, ..ContextDesc::default() };
    Context::new(desc).expect("a device")
}

fn sharing(c: &Context) -> Context {
    let desc = ContextDesc { width: SIZE, height: SIZE, ..ContextDesc::default() };
    c.new_shared(desc).expect("a context")
}

#[track_caller]
fn fine(c: &mut Context) {
    let messages = c.messages();
    assert_eq!(c.get_error(), GL_NO_ERROR, "{messages:?}");
}

fn status(c: &mut Context, fence: GLsync) -> GLenum {
    let mut value = [0];
    c.get_synciv(fence, GL_SYNC_STATUS, 1, &mut [0], &mut value);
    value[0] as GLenum
}

#[test]
fn the_flush_of_another_context_does_not_signal_a_fence() {
    let mut a = context();
    let mut b = sharing(&a);
    a.clear(GL_COLOR_BUFFER_BIT);
    let fence = a.fence_sync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    b.clear(GL_COLOR_BUFFER_BIT);
    b.finish();
    assert_eq!(status(&mut b, fence), GL_UNSIGNALED);
    assert_eq!(b.client_wait_sync(fence, 0, 0), GL_TIMEOUT_EXPIRED);
    let begin = Instant::now();
    assert_eq!(b.client_wait_sync(fence, 0, 20_000_000), GL_TIMEOUT_EXPIRED);
    assert!(begin.elapsed() >= Duration::from_millis(20));
    a.flush();
    assert_eq!(status(&mut b, fence), GL_SIGNALED);
    assert_eq!(b.client_wait_sync(fence, 0, LONG), GL_ALREADY_SIGNALED);
    fine(&mut a);
    fine(&mut b);
}

#[test]
fn a_fence_orders_an_upload_before_a_draw_on_another_thread() {
    let mut loader = context();
    let mut c = sharing(&loader);
    let mut name = [0];
    loader.gen_textures(1, &mut name);
    let fence = loader.fence_sync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    let handle = fence.addr();
    let waits = std::thread::spawn(move || {
        let fence = std::ptr::without_provenance_mut(handle);
        let waited = c.client_wait_sync(fence, 0, LONG);
        assert!(matches!(waited, GL_CONDITION_SATISFIED | GL_ALREADY_SIGNALED), "{waited:#x}");
        c.wait_sync(fence, 0, GL_TIMEOUT_IGNORED);
        c.bind_texture(GL_TEXTURE_2D, name[0]);
        c.tex_envi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE as GLint);
        c.enable(GL_TEXTURE_2D);
        c.rectf(-1.0, -1.0, 1.0, 1.0);
        let mut pixel = [0; 4];
        c.read_pixels(3, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
        fine(&mut c);
        pixel
    });
    loader.bind_texture(GL_TEXTURE_2D, name[0]);
    loader.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    let texel = Data::Bytes(&[1, 2, 3, 4]);
    let internal = GL_RGBA8 as GLint;
    loader.tex_image_2d(GL_TEXTURE_2D, 0, internal, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    loader.flush();
    assert_eq!(waits.join().expect("no panic"), [1, 2, 3, 4]);
    fine(&mut loader);
}

#[test]
fn a_server_wait_for_a_context_that_never_flushes_ends_with_a_warning() {
    let mut a = context();
    let mut b = sharing(&a);
    a.clear(GL_COLOR_BUFFER_BIT);
    let fence = a.fence_sync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    b.wait_sync(fence, 0, GL_TIMEOUT_IGNORED);
    let messages = b.messages();
    assert!(messages.iter().any(|message| message.text.contains("has not called glFlush")));
    // With the context that made it, its commands end.
    drop(a);
    assert_eq!(status(&mut b, fence), GL_SIGNALED);
    fine(&mut b);
}

/// A fragment shader that runs for tenths of a second.
const SLOW: &str = "void main() {
    vec4 sum = gl_FragCoord;
    for (int i = 0; i < 2000; i++) sum = sin(sum * 1.7) + 0.3;
    gl_FragColor = sum;
}";

#[test]
fn calls_of_one_context_end_while_another_draws() {
    let mut draws = context();
    let mut calls = sharing(&draws);
    shading::use_program(&mut draws, "", SLOW);
    draws.rectf(-1.0, -1.0, 1.0, 1.0);
    let (begun, ended) = (AtomicBool::new(false), AtomicBool::new(false));
    let ended_meanwhile = std::thread::scope(|scope| {
        scope.spawn(|| {
            begun.store(true, Ordering::SeqCst);
            draws.flush();
            ended.store(true, Ordering::SeqCst);
        });
        while !begun.load(Ordering::SeqCst) {
            std::hint::spin_loop();
        }
        let mut count = 0;
        let mut name = [0];
        while !ended.load(Ordering::SeqCst) {
            calls.gen_textures(1, &mut name);
            calls.bind_texture(GL_TEXTURE_2D, name[0]);
            calls.delete_textures(1, &name);
            count += 1;
        }
        count
    });
    // Without the draw's time there would be one or two.
    assert!(ended_meanwhile > 20, "{ended_meanwhile} rounds of calls");
    fine(&mut draws);
    fine(&mut calls);
}

/// How often a buffer is written between draws is counted in the draws of whoever writes.
#[test]
fn a_context_that_has_drawn_less_draws_what_another_rewrites() {
    let mut a = context();
    let mut b = sharing(&a);
    let corners = [-1.0_f32, -1.0, 3.0, -1.0, -1.0, 3.0].map(f32::to_le_bytes).concat();
    let bind = |c: &mut Context| {
        c.bind_buffer(GL_ARRAY_BUFFER, 1);
        c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
        c.enable_client_state(GL_VERTEX_ARRAY);
    };
    bind(&mut a);
    a.buffer_data(GL_ARRAY_BUFFER, 1 << 16, Data::Null, GL_DYNAMIC_DRAW);
    for _ in 0..5 {
        // What is recorded keeps the bytes that are replaced.
        a.buffer_sub_data(GL_ARRAY_BUFFER, 0, 24, Data::Bytes(&corners));
        a.draw_arrays(GL_TRIANGLES, 0, 3);
    }
    a.finish();
    bind(&mut b);
    b.color_3f(0.0, 1.0, 0.0);
    b.draw_arrays(GL_TRIANGLES, 0, 3);
    let mut pixel = [0; 4];
    b.read_pixels(3, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!(pixel, [0, 255, 0, 255]);
    fine(&mut a);
    fine(&mut b);
}
