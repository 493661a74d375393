//! Random calls of EGL and OSMesa with live, destroyed and invalid handles, and calls of GL between them, for the
//! fuzz target `handles` and its bounded test. The client frees memory as soon as the driver may not write to it any
//! more; the address sanitizer finds later writes.
#![allow(unsafe_code, reason = "calls C functions")]

use super::random::Random;
use gl_api::*;
use std::ffi::c_void;
use std::ptr::{null_mut, without_provenance_mut};

type Handle = *mut c_void;
/// Lists of EGL attributes, with their terminator.
type List<'a> = Option<&'a [i32; 5]>;

// SAFETY: the prototypes of EGL, GL and OSMesa. Handles are only looked up, and what is safe to call keeps no pointer.
unsafe extern "C" {
    safe fn eglGetDisplay(native: Handle) -> Handle;
    safe fn eglInitialize(dpy: Handle, major: Option<&mut i32>, minor: Option<&mut i32>) -> u32;
    safe fn eglTerminate(dpy: Handle) -> u32;
    safe fn eglBindAPI(api: u32) -> u32;
    safe fn eglGetConfigs(dpy: Handle, out: Option<&mut [Handle; 4]>, n: i32, k: &mut i32) -> u32;
    safe fn eglChooseConfig(
        dpy: Handle,
        list: List<'_>,
        out: Option<&mut [Handle; 4]>,
        n: i32,
        k: &mut i32,
    ) -> u32;
    safe fn eglCreatePbufferSurface(dpy: Handle, config: Handle, list: List<'_>) -> Handle;
    safe fn eglCreateContext(dpy: Handle, config: Handle, share: Handle, list: List<'_>) -> Handle;
    safe fn eglMakeCurrent(dpy: Handle, draw: Handle, read: Handle, context: Handle) -> u32;
    safe fn eglDestroyContext(dpy: Handle, context: Handle) -> u32;
    safe fn eglDestroySurface(dpy: Handle, surface: Handle) -> u32;
    safe fn eglSwapBuffers(dpy: Handle, surface: Handle) -> u32;
    safe fn eglQuerySurface(dpy: Handle, surface: Handle, name: i32, out: Option<&mut i32>) -> u32;
    safe fn eglQueryContext(dpy: Handle, context: Handle, name: i32, out: Option<&mut i32>) -> u32;
    safe fn eglCreateSync(dpy: Handle, ty: u32, list: Option<&[isize; 1]>) -> Handle;
    safe fn eglClientWaitSync(dpy: Handle, sync: Handle, flags: i32, timeout: u64) -> i32;
    safe fn eglDestroySync(dpy: Handle, sync: Handle) -> u32;
    safe fn eglReleaseThread() -> u32;
    safe fn OSMesaCreateContextExt(f: GLenum, d: i32, s: i32, a: i32, share: Handle) -> Handle;
    fn OSMesaMakeCurrent(c: Handle, buffer: *mut c_void, ty: GLenum, w: i32, h: i32) -> u8;
    safe fn OSMesaDestroyContext(context: Handle);
    safe fn OSMesaGetCurrentContext() -> Handle;
    safe fn OSMesaPixelStore(name: i32, value: i32);
    safe fn OSMesaGetDepthBuffer(
        context: Handle,
        width: &mut i32,
        height: &mut i32,
        bytes: &mut i32,
        buffer: &mut *const u8,
    ) -> u8;
    safe fn glClear(mask: u32);
    safe fn glClearColor(r: f32, g: f32, b: f32, a: f32);
    safe fn glRectf(x1: f32, y1: f32, x2: f32, y2: f32);
    safe fn glFinish();
    safe fn glFlush();
    safe fn glEnable(cap: GLenum);
    safe fn glDisable(cap: GLenum);
    safe fn glBindTexture(target: GLenum, name: u32);
    safe fn glDeleteTextures(n: i32, names: &u32);
    safe fn glTexImage2D(
        target: GLenum,
        level: i32,
        internal: i32,
        width: i32,
        height: i32,
        border: i32,
        format: GLenum,
        ty: GLenum,
        pixels: &[u8; 256],
    );
    safe fn glReadPixels(x: i32, y: i32, w: i32, h: i32, f: GLenum, t: GLenum, out: &mut Pixels);
    safe fn glBindBuffer(target: GLenum, name: u32);
    safe fn glBufferData(target: GLenum, size: isize, data: Option<&[f32; 16]>, usage: GLenum);
    safe fn glMapBuffer(target: GLenum, access: GLenum) -> *mut f32;
    safe fn glUnmapBuffer(target: GLenum) -> u8;
    safe fn glDeleteBuffers(n: i32, names: &u32);
    safe fn glEnableClientState(array: GLenum);
    safe fn glDisableClientState(array: GLenum);
    fn glVertexPointer(size: i32, ty: GLenum, stride: i32, pointer: *const c_void);
    safe fn glDrawArrays(mode: GLenum, first: i32, count: i32);
}

const EGL_NONE: i32 = 0x3038;
const EGL_OPENGL_API: u32 = 0x30A2;
const EGL_SYNC_FENCE: u32 = 0x30F9;
const SIDE: usize = 64;
type Pixels = [u8; SIDE * SIDE * 4];

/// A client of one thread.
pub struct Client {
    display: Handle,
    /// Handles of all objects, live and destroyed.
    handles: [Handle; 24],
    /// The memory that OSMesa draws to.
    memory: Vec<u8>,
}

type Call = fn(&mut Client, &mut Random<'_>);

const CALLS: &[Call] = &[
    |c, _| _ = eglInitialize(c.display, None, Some(&mut 0)),
    |c, r| {
        if r.next().is_multiple_of(6) {
            eglTerminate(c.display);
        }
    },
    |c, r| {
        let (mut configs, mut count) = ([null_mut(); 4], 0);
        let list = [r.attribute(), r.small(), r.attribute(), r.small(), EGL_NONE];
        eglChooseConfig(c.display, Some(&list), Some(&mut configs), 4, &mut count);
        eglGetConfigs(c.display, None, r.small(), &mut count);
        c.keep(configs[0], r);
    },
    |c, r| {
        let list = [0x3057, r.side(), 0x3056, r.side(), EGL_NONE];
        let list = Some(&list).filter(|_| r.often());
        let surface = eglCreatePbufferSurface(c.display(r), c.handle(r), list);
        c.keep(surface, r);
    },
    |c, r| {
        eglBindAPI(EGL_OPENGL_API);
        let config = if r.often() { null_mut() } else { c.handle(r) };
        let context = eglCreateContext(c.display(r), config, c.handle(r), None);
        c.keep(context, r);
    },
    |c, r| {
        let draw = c.handle(r);
        let read = if r.often() { draw } else { c.handle(r) };
        eglMakeCurrent(c.display(r), draw, read, c.handle(r));
    },
    |c, _| _ = eglMakeCurrent(c.display, null_mut(), null_mut(), null_mut()),
    |c, r| _ = eglDestroyContext(c.display(r), c.handle(r)),
    |c, r| _ = eglDestroySurface(c.display(r), c.handle(r)),
    |c, r| _ = eglSwapBuffers(c.display(r), c.handle(r)),
    |c, r| {
        let (display, handle, name) = (c.display(r), c.handle(r), r.attribute());
        eglQuerySurface(display, handle, name, Some(&mut 0).filter(|_| r.often()));
        eglQueryContext(display, handle, name, Some(&mut 0).filter(|_| r.often()));
    },
    |c, r| {
        let sync = eglCreateSync(c.display(r), EGL_SYNC_FENCE, None);
        c.keep(sync, r);
    },
    |c, r| _ = eglClientWaitSync(c.display(r), c.handle(r), r.small(), 1000),
    |c, r| _ = eglDestroySync(c.display(r), c.handle(r)),
    |_, r| {
        if r.next().is_multiple_of(4) {
            eglReleaseThread();
        }
    },
    |c, r| {
        let format = r.pick(&[GL_RGBA, GL_RGB, 1, 2, 4, 5]);
        let share = if r.often() { null_mut() } else { c.handle(r) };
        let (depth, stencil) = (r.pick(&[0, 16, 24, 32, 33, -1]), r.pick(&[0, 8]));
        let context = OSMesaCreateContextExt(format, depth, stencil, 0, share);
        c.keep(context, r);
    },
    Client::draw_to_memory,
    Client::draw_to_memory,
    |c, r| OSMesaDestroyContext(c.handle(r)),
    |_, r| OSMesaPixelStore(r.pick(&[0x10, 0x11]), r.pick(&[0, 1, SIDE as i32])),
    |c, r| {
        let context = if r.often() { OSMesaGetCurrentContext() } else { c.handle(r) };
        let (mut width, mut height, mut bytes, mut depths) = (0, 0, 0, std::ptr::null());
        if OSMesaGetDepthBuffer(context, &mut width, &mut height, &mut bytes, &mut depths) == 1 {
            // SAFETY: the memory stays allocated until the context is drawn to again.
            unsafe { depths.add((width * height * bytes) as usize - 1).read() };
        }
    },
    |_, r| {
        glClear(r.pick(&[GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT]));
        glRectf(-1.0, -1.0, r.small() as f32, 1.0);
    },
    |_, r| if r.often() { glFlush() } else { glFinish() },
    |_, r| {
        glBindTexture(GL_TEXTURE_2D, r.name());
        let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA as i32, 8, 8, 0, format, ty, &[r.next() as u8; 256]);
        glEnable(GL_TEXTURE_2D);
    },
    |_, r| glDeleteTextures(1, &r.name()),
    |_, r| {
        let (width, height) = (r.side(), r.side());
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, &mut [0; _]);
    },
    |_, r| {
        glBindBuffer(GL_ARRAY_BUFFER, r.name());
        glBufferData(GL_ARRAY_BUFFER, 64, Some(&[0.5; 16]).filter(|_| r.often()), GL_STATIC_DRAW);
        let mapped = glMapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE);
        if !mapped.is_null() {
            // SAFETY: the buffer has sixteen numbers.
            unsafe { mapped.add(15).write(1.0) };
        }
    },
    |_, _| _ = glUnmapBuffer(GL_ARRAY_BUFFER),
    |_, r| glDeleteBuffers(1, &r.name()),
    Client::draw_vertices,
    Client::draw_vertices,
];

impl Random<'_> {
    fn often(&mut self) -> bool {
        !self.next().is_multiple_of(4)
    }

    fn small(&mut self) -> i32 {
        (self.next() % 10) as i32 - 1
    }

    fn side(&mut self) -> i32 {
        (self.next() % (SIDE as u64 + 1)) as i32
    }

    /// A random attribute of a surface, a config or a context; not the terminator of a list.
    fn attribute(&mut self) -> i32 {
        let name = 0x3020 + (self.next() % 0x80) as i32;
        if name == EGL_NONE { name + 1 } else { name }
    }

    fn name(&mut self) -> u32 {
        (self.next() % 4) as u32
    }
}

impl Client {
    /// A handle of an initialized display.
    pub fn new() -> Self {
        let display = eglGetDisplay(null_mut());
        assert_eq!(eglInitialize(display, None, None), 1);
        Self { display, handles: [null_mut(); 24], memory: Vec::new() }
    }

    /// Makes `count` random calls.
    pub fn make_calls(&mut self, random: &mut Random<'_>, count: usize) {
        for _ in 0..count {
            let call = random.pick(CALLS);
            call(self, random);
        }
    }

    /// Destroys all objects and draws with new ones.
    pub fn still_works(&mut self) {
        eglMakeCurrent(self.display, null_mut(), null_mut(), null_mut());
        self.handles.into_iter().for_each(|handle| OSMesaDestroyContext(handle));
        eglTerminate(self.display);
        assert_eq!(eglInitialize(self.display, None, None), 1);
        let list = [0x3057, SIDE as i32, 0x3056, SIDE as i32, EGL_NONE];
        let (mut config, mut count) = ([null_mut(); 4], 0);
        assert_eq!(eglGetConfigs(self.display, Some(&mut config), 4, &mut count), 1);
        let surface = eglCreatePbufferSurface(self.display, config[0], Some(&list));
        eglBindAPI(EGL_OPENGL_API);
        let context = eglCreateContext(self.display, config[0], null_mut(), None);
        assert_eq!(eglMakeCurrent(self.display, surface, surface, context), 1);
        glClearColor(1.0, 1.0, 1.0, 1.0);
        glClear(GL_COLOR_BUFFER_BIT);
        let mut pixels = [0; _];
        let side = SIDE as i32;
        glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, &mut pixels);
        assert!(pixels.iter().all(|&byte| byte == 255));
        eglMakeCurrent(self.display, null_mut(), null_mut(), null_mut());
        eglTerminate(self.display);
    }

    fn display(&self, random: &mut Random<'_>) -> Handle {
        if random.next().is_multiple_of(20) { self.handle(random) } else { self.display }
    }

    fn handle(&self, random: &mut Random<'_>) -> Handle {
        match random.next() % 12 {
            0 => null_mut(),
            1 => without_provenance_mut((random.next() % 0x2000) as usize),
            _ => random.pick(&self.handles),
        }
    }

    fn keep(&mut self, handle: Handle, random: &mut Random<'_>) {
        let at = random.next() as usize % self.handles.len();
        if !handle.is_null() {
            // Without this, no thread could use them any more.
            OSMesaDestroyContext(self.handles[at]);
            self.handles[at] = handle;
        }
    }

    /// Binds new memory and draws to it, if possible. The picture in the old memory is complete then, and it is freed.
    fn draw_to_memory(&mut self, random: &mut Random<'_>) {
        let ty = random.pick(&[GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT, GL_INT]);
        let (width, height) = (random.side(), random.side());
        // The stride of rows may be the largest.
        let mut memory = vec![0_u8; SIDE * height as usize * 16];
        // SAFETY: the memory has that many pixels and stays allocated until other memory is bound.
        let made = unsafe {
            let context = self.handle(random);
            OSMesaMakeCurrent(context, memory.as_mut_ptr().cast(), ty, width, height)
        };
        if made == 1 {
            drop(std::mem::replace(&mut self.memory, memory));
        }
    }

    /// Draws from client memory that is freed afterwards.
    fn draw_vertices(&mut self, random: &mut Random<'_>) {
        let vertices: Vec<f32> = (0..16).map(|_| random.small() as f32 / 4.0).collect();
        let first = (random.next() % 4) as i32;
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glEnableClientState(GL_VERTEX_ARRAY);
        // SAFETY: there are eight vertices, and nothing is drawn from them later.
        unsafe { glVertexPointer(2, GL_FLOAT, 0, vertices.as_ptr().cast()) };
        glDrawArrays(random.pick(&[GL_TRIANGLES, GL_LINES, GL_POINTS]), first, 8 - first);
        glDisableClientState(GL_VERTEX_ARRAY);
        glDisable(GL_TEXTURE_2D);
    }
}

impl Drop for Client {
    /// Flushes the picture to its memory while that is allocated.
    fn drop(&mut self) {
        eglReleaseThread();
    }
}
