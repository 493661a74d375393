//! OSMesa: the picture in the client's memory.

use super::*;
use gl_api::{GL_COLOR_BUFFER_BIT, GL_FLOAT, GL_RGBA, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT};
use std::sync::mpsc::channel;
use std::time::Duration;

/// The first pixel of a picture cleared to (1, 0.5, 0, 1), as bytes.
fn osmesa(format: GLenum, ty: GLenum, bytes: usize) -> Option<Vec<u8>> {
    let mut memory = vec![0_u8; bytes * 4 * 4];
    // SAFETY: the memory has 4×4 pixels of so many bytes, and stays until the context is gone.
    unsafe {
        let context = OSMesaCreateContextExt(format, 24, 8, 0, null_mut());
        if context.is_null() {
            return None;
        }
        assert_eq!(OSMesaMakeCurrent(context, memory.as_mut_ptr().cast(), ty, 4, 4), 1);
        glClearColor(1.0, 0.5, 0.0, 1.0);
        glClear(GL_COLOR_BUFFER_BIT);
        glFinish();
        OSMesaMakeCurrent(null_mut(), null_mut(), 0, 0, 0);
        OSMesaDestroyContext(context);
    }
    assert!(memory.chunks_exact(bytes).all(|pixel| *pixel == memory[..bytes]));
    Some(memory[..bytes].to_vec())
}

#[test]
fn osmesa_fills_the_clients_memory_in_every_format() {
    for (format, ty, pixel) in [
        (GL_RGBA, GL_UNSIGNED_BYTE, vec![255, 128, 0, 255]),
        (1, GL_UNSIGNED_BYTE, vec![0, 128, 255, 255]),
        (2, GL_UNSIGNED_BYTE, vec![255, 255, 128, 0]),
        (gl_api::GL_RGB, GL_UNSIGNED_BYTE, vec![255, 128, 0]),
        (4, GL_UNSIGNED_BYTE, vec![0, 128, 255]),
        (5, gl_api::GL_UNSIGNED_SHORT_5_6_5, 0xFC00_u16.to_le_bytes().to_vec()),
        (
            GL_RGBA,
            GL_UNSIGNED_SHORT,
            [65535_u16, 32768, 0, 65535].iter().flat_map(|v| v.to_le_bytes()).collect(),
        ),
        (
            GL_RGBA,
            GL_FLOAT,
            [1.0_f32, 0.5, 0.0, 1.0].iter().flat_map(|v| v.to_le_bytes()).collect(),
        ),
        (2, GL_FLOAT, [1.0_f32, 1.0, 0.5, 0.0].iter().flat_map(|v| v.to_le_bytes()).collect()),
    ] {
        assert_eq!(osmesa(format, ty, pixel.len()), Some(pixel), "{format:#x} {ty:#x}");
    }
    assert_eq!(osmesa(gl_api::GL_COLOR_INDEX, GL_UNSIGNED_BYTE, 1), None);
}

/// Each pixel where its row and its format have it; what lies between rows stays.
#[test]
fn rows_go_up_or_down_and_may_lie_apart() {
    const WIDTH: usize = 70;
    const HEIGHT: usize = 67;
    // Format, type, bytes of a component, and which component of the picture each of a pixel is.
    let formats: [(GLenum, GLenum, usize, &[usize]); 7] = [
        (GL_RGBA, GL_UNSIGNED_BYTE, 1, &[0, 1, 2, 3]),
        (1, GL_UNSIGNED_BYTE, 1, &[2, 1, 0, 3]),
        (2, GL_UNSIGNED_BYTE, 1, &[3, 0, 1, 2]),
        (gl_api::GL_RGB, GL_UNSIGNED_BYTE, 1, &[0, 1, 2]),
        (4, GL_UNSIGNED_BYTE, 1, &[2, 1, 0]),
        (2, GL_UNSIGNED_SHORT, 2, &[3, 0, 1, 2]),
        (GL_RGBA, GL_FLOAT, 4, &[0, 1, 2, 3]),
    ];
    for (format, ty, size, components) in formats {
        for (up, length) in [(1, 0), (0, 0), (1, 75), (0, 75), (0, 10)] {
            let bytes = size * components.len();
            let stride = if length == 0 { WIDTH } else { length } * bytes;
            let mut memory = vec![0xA5_u8; (HEIGHT - 1) * stride + WIDTH * bytes];
            let mut want = memory.clone();
            let mut picture = vec![0_u8; WIDTH * HEIGHT * 4 * size];
            // SAFETY: both have as many pixels as are written, and stay until the context is gone.
            unsafe {
                let context = OSMesaCreateContextExt(format, 24, 8, 0, null_mut());
                let [width, height] = [WIDTH, HEIGHT].map(|side| side as i32);
                assert_eq!(
                    OSMesaMakeCurrent(context, memory.as_mut_ptr().cast(), ty, width, height),
                    1
                );
                OSMesaPixelStore(0x10, length as i32);
                OSMesaPixelStore(0x11, up);
                glEnable(gl_api::GL_SCISSOR_TEST);
                for at in 0..60 {
                    glScissor(at, at + 5, 9, 9);
                    let shade = at as f32 / 64.0;
                    glClearColor(shade, 1.0 - shade, 0.25, 0.5);
                    glClear(GL_COLOR_BUFFER_BIT);
                }
                glFinish();
                glReadPixels(0, 0, width, height, GL_RGBA, ty, picture.as_mut_ptr().cast());
                OSMesaMakeCurrent(null_mut(), null_mut(), 0, 0, 0);
                OSMesaDestroyContext(context);
            }
            for (y, row) in picture.chunks_exact(WIDTH * 4 * size).enumerate() {
                let at = if up == 1 { y } else { HEIGHT - 1 - y } * stride;
                let out = want[at..][..WIDTH * bytes].chunks_exact_mut(bytes);
                for (out, pixel) in out.zip(row.chunks_exact(4 * size)) {
                    for (out, &from) in out.chunks_exact_mut(size).zip(components) {
                        out.copy_from_slice(&pixel[from * size..][..size]);
                    }
                }
            }
            assert!(memory == want, "{format:#x} {ty:#x}, up {up}, length {length}");
        }
    }
}

#[test]
fn contexts_and_memory_that_are_not_there_are_refused() {
    let made_up = std::ptr::without_provenance_mut::<c_void>(0xDEAD_BEE1);
    let mut memory = [0_u8; 4 * 4 * 4];
    let memory: *mut c_void = memory.as_mut_ptr().cast();
    // SAFETY: handles are only looked up; the memory has 4×4 pixels.
    unsafe {
        let context = OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, null_mut());
        for (what, context, memory, ty, width, there) in [
            ("made up", made_up, memory, GL_UNSIGNED_BYTE, 4, 0),
            ("null", context, null_mut(), GL_UNSIGNED_BYTE, 4, 0),
            ("type", context, memory, gl_api::GL_INT, 4, 0),
            ("width 0", context, memory, GL_UNSIGNED_BYTE, 0, 0),
            ("width below 0", context, memory, GL_UNSIGNED_BYTE, -4, 0),
            ("too wide", context, memory, GL_UNSIGNED_BYTE, 1 << 20, 0),
            ("good", context, memory, GL_UNSIGNED_BYTE, 4, 1),
        ] {
            assert_eq!(OSMesaMakeCurrent(context, memory, ty, width, 4), there, "{what}");
        }
        // Destroyed while it is current, it is current no more.
        OSMesaDestroyContext(context);
        assert!(OSMesaGetCurrentContext().is_null());
        glClear(GL_COLOR_BUFFER_BIT);
        glFinish();
        assert_eq!(OSMesaMakeCurrent(null_mut(), null_mut(), 0, 0, 0), 1);
        assert_eq!(OSMesaMakeCurrent(context, memory, GL_UNSIGNED_BYTE, 4, 4), 0);
        OSMesaDestroyContext(context);
        OSMesaDestroyContext(made_up);
        OSMesaDestroyContext(null_mut());
        assert!(OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, made_up).is_null());
    }
}

#[test]
fn contexts_are_made_on_one_thread_and_become_current_on_another() {
    let (done, both) = channel();
    let threads = [0, 20].map(|times| {
        let done = done.clone();
        std::thread::spawn(move || {
            let mut memory = [0_u8; 4 * 4 * 4];
            let memory: *mut c_void = memory.as_mut_ptr().cast();
            for _ in 0..3000 {
                // SAFETY: the memory has 4×4 pixels, and stays until the context is gone.
                unsafe {
                    let context = OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, null_mut());
                    for _ in 0..times {
                        OSMesaMakeCurrent(context, memory, GL_UNSIGNED_BYTE, 4, 4);
                    }
                    OSMesaMakeCurrent(null_mut(), null_mut(), 0, 0, 0);
                    OSMesaDestroyContext(context);
                }
            }
            done.send(()).expect("the test waits");
        })
    });
    for _ in &threads {
        both.recv_timeout(Duration::from_secs(60)).expect("neither thread waits for the other");
    }
    for thread in threads {
        thread.join().expect("no panic");
    }
}

/// Memory of 8×8 pixels, whose bytes are 7. Client memory that must not be touched any more is read
/// instead of freed: a byte that is still 7 was not written to.
struct Memory([u8; 8 * 8 * 4]);

impl Memory {
    const UNTOUCHED: u8 = 7;

    fn new() -> Self {
        Self([Self::UNTOUCHED; 8 * 8 * 4])
    }

    fn at(&mut self) -> *mut c_void {
        self.0.as_mut_ptr().cast()
    }

    fn reset(&mut self) {
        self.0.fill(Self::UNTOUCHED);
    }
}

#[test]
fn memory_that_the_client_may_have_freed_is_not_written_to() {
    let [mut first, mut second] = [(); 2].map(|()| Memory::new());
    let byte = GL_UNSIGNED_BYTE;
    // SAFETY: the memory has up to 8×8 pixels, and stays.
    unsafe {
        let [one, other] = [(); 2].map(|()| OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, null_mut()));
        // What is drawn is there when the context stops being current.
        assert_eq!(OSMesaMakeCurrent(one, first.at(), byte, 4, 4), 1);
        fill([1.0, 0.0, 0.0]);
        assert_eq!(OSMesaMakeCurrent(other, second.at(), byte, 4, 4), 1);
        assert_eq!(first.0[..4], [255, 0, 0, 255]);
        // Nothing was drawn since it was copied: the client may be done with its memory.
        fill([0.0, 1.0, 0.0]);
        glFinish();
        assert_eq!(second.0[..4], [0, 255, 0, 255]);
        second.reset();
        assert_eq!(OSMesaMakeCurrent(one, first.at(), byte, 4, 4), 1);
        assert_eq!(second.0[0], Memory::UNTOUCHED);
        // Other memory for the same context, of the same and of another size.
        for size in [4, 8] {
            fill([0.0, 0.0, 1.0]);
            first.reset();
            assert_eq!(OSMesaMakeCurrent(one, second.at(), byte, size, size), 1);
            assert_eq!(first.0[0], Memory::UNTOUCHED, "{size}");
            fill([0.0, 0.0, 1.0]);
            glFinish();
            assert_eq!(second.0[..4], [0, 0, 255, 255], "{size}");
            assert_eq!(OSMesaMakeCurrent(one, first.at(), byte, 4, 4), 1);
        }
        // The same memory again.
        fill([1.0, 0.0, 0.0]);
        assert_eq!(OSMesaMakeCurrent(one, first.at(), byte, 4, 4), 1);
        assert_eq!(first.0[..4], [255, 0, 0, 255]);
        // A context that is destroyed while it is current.
        fill([1.0, 1.0, 0.0]);
        first.reset();
        OSMesaDestroyContext(one);
        assert_eq!(OSMesaMakeCurrent(other, second.at(), byte, 8, 8), 1);
        assert_eq!(first.0[0], Memory::UNTOUCHED);
        assert_eq!(OSMesaMakeCurrent(null_mut(), null_mut(), 0, 0, 0), 1);
        OSMesaDestroyContext(other);
    }
}

/// The buffers of a context go on in other memory of the same type and size, whose own bytes are not read; those of
/// another type or size are new.
#[test]
fn other_memory_gets_the_picture_of_the_memory_before() {
    let [mut first, mut second] = [(); 2].map(|()| Memory::new());
    let byte = GL_UNSIGNED_BYTE;
    let pixel = |memory: &Memory, at: usize| memory.0[4 * at..4 * at + 4].to_vec();
    let [red, green, blue] = [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255]];
    // SAFETY: the memory has up to 8×8 pixels, and stays.
    unsafe {
        let context = OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, null_mut());
        assert_eq!(OSMesaMakeCurrent(context, first.at(), byte, 4, 4), 1);
        fill([1.0, 0.0, 0.0]);
        glFinish();
        assert!((0..16).all(|at| pixel(&first, at) == red));
        // A pixel that is drawn, and not flushed.
        glEnable(gl_api::GL_SCISSOR_TEST);
        glScissor(0, 0, 1, 1);
        fill([0.0, 1.0, 0.0]);
        glDisable(gl_api::GL_SCISSOR_TEST);
        assert_eq!(OSMesaMakeCurrent(context, second.at(), byte, 4, 4), 1);
        assert_eq!(pixel(&second, 0), [Memory::UNTOUCHED; 4], "nothing is copied before a flush");
        let mut read = [0_u8; 4];
        glReadPixels(1, 1, 1, 1, GL_RGBA, byte, read.as_mut_ptr().cast());
        assert_eq!(read, red, "the memory is not read");
        glFinish();
        assert_eq!((pixel(&first, 0), pixel(&second, 0)), (red.to_vec(), green.to_vec()));
        assert!((1..16).all(|at| pixel(&second, at) == red));
        // Back in the first memory: what was drawn meanwhile is there.
        glEnable(gl_api::GL_SCISSOR_TEST);
        glScissor(1, 0, 1, 1);
        fill([0.0, 0.0, 1.0]);
        glDisable(gl_api::GL_SCISSOR_TEST);
        assert_eq!(OSMesaMakeCurrent(context, first.at(), byte, 4, 4), 1);
        glFinish();
        assert_eq!([0, 1, 2].map(|at| pixel(&first, at)), [green, blue, red].map(|p| p.to_vec()));
        assert_eq!(pixel(&second, 1), red, "memory that another replaced is not touched");
        // Another size, and another type: zero.
        assert_eq!(OSMesaMakeCurrent(context, second.at(), byte, 8, 8), 1);
        glFinish();
        assert!(second.0.iter().all(|&byte| byte == 0));
        let mut floats = [7.0_f32; 8 * 8 * 4];
        assert_eq!(OSMesaMakeCurrent(context, floats.as_mut_ptr().cast(), GL_FLOAT, 8, 8), 1);
        glFinish();
        assert_eq!(floats, [0.0; 8 * 8 * 4]);
        assert_eq!(OSMesaMakeCurrent(null_mut(), null_mut(), 0, 0, 0), 1);
        OSMesaDestroyContext(context);
    }
}

unsafe extern "C" {
    fn OSMesaCreateContextAttribs(list: *const i32, share: Handle) -> Handle;
}

#[test]
fn contexts_have_the_profile_and_version_that_their_attributes_ask_for() {
    const DEPTH: i32 = 0x30;
    const PROFILE: i32 = 0x33;
    const CORE: i32 = 0x34;
    const COMPAT: i32 = 0x35;
    const MAJOR: i32 = 0x36;
    const MINOR: i32 = 0x37;
    // The bit of GL_CONTEXT_PROFILE_MASK, if there is such a context.
    let rows: [(&[i32], Option<i32>); 9] = [
        (&[], Some(2)),
        (&[DEPTH, 24, PROFILE, COMPAT], Some(2)),
        (&[PROFILE, CORE, MAJOR, 3, MINOR, 3], Some(1)),
        (&[PROFILE, CORE, MAJOR, 3, MINOR, 1], Some(2)),
        (&[PROFILE, COMPAT, MAJOR, 3, MINOR, 3], Some(2)),
        (&[MAJOR, 4, MINOR, 6], None),
        (&[PROFILE, 7], None),
        (&[DEPTH, -1], None),
        (&[0x77, 1], None),
    ];
    let mut memory = vec![0_u8; 4 * 4 * 4];
    for (list, profile) in rows {
        let ended = [list, &[0]].concat();
        // SAFETY: the list ends with 0; the memory has 4×4 pixels, and stays until the context is gone.
        unsafe {
            let context = OSMesaCreateContextAttribs(ended.as_ptr(), null_mut());
            assert_eq!(!context.is_null(), profile.is_some(), "{list:?}");
            let Some(profile) = profile else { continue };
            let to = memory.as_mut_ptr().cast();
            assert_eq!(OSMesaMakeCurrent(context, to, GL_UNSIGNED_BYTE, 4, 4), 1);
            let mut mask = -1;
            glGetIntegerv(gl_api::GL_CONTEXT_PROFILE_MASK, &mut mask);
            assert_eq!(mask, profile, "{list:?}");
            OSMesaMakeCurrent(null_mut(), null_mut(), 0, 0, 0);
            OSMesaDestroyContext(context);
        }
    }
}
