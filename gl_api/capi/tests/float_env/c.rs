//! The C functions that the scenes call, and the floating-point state of this thread.

use gl_api::constants::*;
use std::arch::asm;
use std::ffi::{c_char, c_void};
use std::ptr::{null, null_mut};

type Handle = *mut c_void;

/// Declares C functions: those without pointers can be called by anybody.
macro_rules! c_functions {
    ($(fn $name:ident($($ty:ty),*) $(-> $result:ty)?;)*) => {
        unsafe extern "C" {
            $(pub(crate) safe fn $name($(_: $ty),*) $(-> $result)?;)*
        }
    };
}

c_functions! {
    fn feclearexcept(i32) -> i32;
    fn feenableexcept(i32) -> i32;
    fn feraiseexcept(i32) -> i32;
    fn fesetround(i32) -> i32;
    fn eglBindAPI(u32) -> u32;
    fn glBegin(GLenum);
    fn glBindFramebuffer(GLenum, u32);
    fn glBindRenderbuffer(GLenum, u32);
    fn glBindTexture(GLenum, u32);
    fn glBlendFunc(GLenum, GLenum);
    fn glBlitFramebuffer(i32, i32, i32, i32, i32, i32, i32, i32, u32, GLenum);
    fn glClear(u32);
    fn glClearColor(f32, f32, f32, f32);
    fn glColor3f(f32, f32, f32);
    fn glColor4d(f64, f64, f64, f64);
    fn glColor4f(f32, f32, f32, f32);
    fn glColor4us(u16, u16, u16, u16);
    fn glDisable(GLenum);
    fn glEnable(GLenum);
    fn glEnd();
    fn glEvalCoord1d(f64);
    fn glFinish();
    fn glFramebufferRenderbuffer(GLenum, GLenum, GLenum, u32);
    fn glFramebufferTexture2D(GLenum, GLenum, GLenum, u32, i32);
    fn glFrustum(f64, f64, f64, f64, f64, f64);
    fn glGenerateMipmap(GLenum);
    fn glGetError() -> GLenum;
    fn glCheckFramebufferStatus(GLenum) -> GLenum;
    fn glLightf(GLenum, GLenum, f32);
    fn glLineStipple(i32, u16);
    fn glLineWidth(f32);
    fn glLoadIdentity();
    fn glMaterialf(GLenum, GLenum, f32);
    fn glMatrixMode(GLenum);
    fn glNormal3f(f32, f32, f32);
    fn glPixelTransferf(GLenum, f32);
    fn glPixelZoom(f32, f32);
    fn glPopAttrib();
    fn glPushAttrib(u32);
    fn glRasterPos2f(f32, f32);
    fn glRenderbufferStorageMultisample(GLenum, i32, GLenum, i32, i32);
    fn glRotated(f64, f64, f64, f64);
    fn glRotatef(f32, f32, f32, f32);
    fn glScaled(f64, f64, f64);
    fn glTexCoord2f(f32, f32);
    fn glTexParameteri(GLenum, GLenum, i32);
    fn glTranslated(f64, f64, f64);
    fn glUseProgram(u32);
    fn glVertex2d(f64, f64);
    fn glVertex2f(f32, f32);
    fn glVertex3d(f64, f64, f64);
    fn glVertex3f(f32, f32, f32);
    fn glViewport(i32, i32, i32, i32);
    fn glCreateProgram() -> u32;
    fn glCreateShader(GLenum) -> u32;
    fn glCompileShader(u32);
    fn glAttachShader(u32, u32);
    fn glLinkProgram(u32);
    fn glUniform1f(i32, f32);
    fn gluLookAt(f64, f64, f64, f64, f64, f64, f64, f64, f64);
    fn gluOrtho2D(f64, f64, f64, f64);
    fn gluPerspective(f64, f64, f64, f64);
    fn gluNewQuadric() -> Handle;
}

unsafe extern "C" {
    fn fesetenv(env: *const c_void) -> i32;
    fn eglGetDisplay(native: Handle) -> Handle;
    fn eglInitialize(dpy: Handle, major: *mut i32, minor: *mut i32) -> u32;
    fn eglCreateContext(dpy: Handle, config: Handle, share: Handle, list: *const i32) -> Handle;
    fn eglMakeCurrent(dpy: Handle, draw: Handle, read: Handle, context: Handle) -> u32;
    fn glDrawPixels(w: i32, h: i32, format: GLenum, ty: GLenum, pixels: *const c_void);
    fn glGetFloatv(pname: GLenum, out: *mut f32);
    fn glGetTexImage(target: GLenum, level: i32, format: GLenum, ty: GLenum, out: *mut c_void);
    fn glGetUniformLocation(program: u32, name: *const c_char) -> i32;
    fn glLightfv(light: GLenum, pname: GLenum, values: *const f32);
    fn glMap1f(target: GLenum, from: f32, to: f32, stride: i32, order: i32, points: *const f32);
    fn glReadPixels(x: i32, y: i32, w: i32, h: i32, f: GLenum, t: GLenum, out: *mut c_void);
    fn glShaderSource(s: u32, n: i32, strings: *const *const c_char, lengths: *const i32);
    fn glTexImage2D(
        target: GLenum,
        level: i32,
        internal: i32,
        width: i32,
        height: i32,
        border: i32,
        format: GLenum,
        ty: GLenum,
        pixels: *const c_void,
    );
    fn glDebugMessageCallback(callback: DebugCallback, user: *const c_void);
    fn gluBuild2DMipmaps(
        target: GLenum,
        internal: i32,
        width: i32,
        height: i32,
        format: GLenum,
        ty: GLenum,
        pixels: *const c_void,
    ) -> i32;
    fn gluCylinder(quad: Handle, base: f64, top: f64, height: f64, slices: i32, stacks: i32);
    fn gluPartialDisk(q: Handle, inner: f64, outer: f64, n: i32, m: i32, start: f64, sweep: f64);
    fn gluProject(
        x: f64,
        y: f64,
        z: f64,
        model: *const f64,
        projection: *const f64,
        viewport: *const i32,
        out_x: *mut f64,
        out_y: *mut f64,
        out_z: *mut f64,
    ) -> i32;
    fn gluQuadricCallback(quad: Handle, which: GLenum, callback: extern "C" fn(GLenum));
    fn gluQuadricTexture(quad: Handle, texture: u8);
    fn gluSphere(quad: Handle, radius: f64, slices: i32, stacks: i32);
}

pub(crate) type DebugCallback =
    extern "C" fn(GLenum, GLenum, u32, GLenum, i32, *const c_char, *const c_void);

pub(crate) type GLenum = u32;

/// Sides of every picture: tiles for more than one thread.
pub(crate) const SIDE: usize = 160;

/// Makes a context without buffers of its own current.
pub(crate) fn make_context() {
    // SAFETY: handles are only looked up, null lists are empty.
    unsafe {
        let dpy = eglGetDisplay(null_mut());
        assert_eq!(eglInitialize(dpy, null_mut(), null_mut()), 1);
        assert_eq!(eglBindAPI(0x30A2), 1);
        let context = eglCreateContext(dpy, null_mut(), null_mut(), null());
        assert_eq!(eglMakeCurrent(dpy, null_mut(), null_mut(), context), 1);
    }
}

/// Colours of the framebuffer, to the bit.
pub(crate) fn colors() -> Vec<u32> {
    let mut out = vec![0_u32; SIDE * SIDE * 4];
    let side = SIDE as i32;
    // SAFETY: four floats for each pixel.
    unsafe { glReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, out.as_mut_ptr().cast()) };
    out
}

/// Depths of the framebuffer, to the bit.
pub(crate) fn depths() -> Vec<u32> {
    let mut out = vec![0_u32; SIDE * SIDE];
    let side = SIDE as i32;
    // SAFETY: a float for each pixel.
    unsafe {
        glReadPixels(0, 0, side, side, GL_DEPTH_COMPONENT, GL_FLOAT, out.as_mut_ptr().cast());
    }
    out
}

/// A level of the texture that is bound, which has so many pixels.
pub(crate) fn texels(level: i32, pixels: usize) -> Vec<u32> {
    let mut out = vec![0_u32; pixels * 4];
    // SAFETY: four floats for each pixel.
    unsafe { glGetTexImage(GL_TEXTURE_2D, level, GL_RGBA, GL_FLOAT, out.as_mut_ptr().cast()) };
    out
}

pub(crate) fn matrix(pname: GLenum) -> Vec<u32> {
    let mut out = vec![0_u32; 16];
    // SAFETY: a matrix has sixteen floats.
    unsafe { glGetFloatv(pname, out.as_mut_ptr().cast()) };
    out
}

/// A square texture.
pub(crate) fn image<T>(internal: GLenum, side: i32, ty: GLenum, pixels: &[T]) {
    let bytes = if ty == GL_FLOAT { 16 } else { 4 };
    assert!(size_of_val(pixels) >= (side * side) as usize * bytes);
    let (target, format, pixels) = (GL_TEXTURE_2D, GL_RGBA, pixels.as_ptr().cast());
    // SAFETY: there are as many bytes as it reads.
    unsafe { glTexImage2D(target, 0, internal as i32, side, side, 0, format, ty, pixels) };
}

/// A texture without texels.
pub(crate) fn blank(internal: GLenum, format: GLenum) {
    let (target, side, ty) = (GL_TEXTURE_2D, SIDE as i32, GL_FLOAT);
    // SAFETY: nothing is read.
    unsafe { glTexImage2D(target, 0, internal as i32, side, side, 0, format, ty, null()) };
}

pub(crate) fn mipmaps_of_glu(side: i32, bytes: &[u8]) {
    assert!(bytes.len() >= (side * side * 4) as usize);
    let (target, internal, pixels) = (GL_TEXTURE_2D, GL_RGBA32F as i32, bytes.as_ptr().cast());
    // SAFETY: there are as many bytes as it reads.
    unsafe { gluBuild2DMipmaps(target, internal, side, side, GL_RGBA, GL_UNSIGNED_BYTE, pixels) };
}

pub(crate) fn draw_pixels(side: i32, bytes: &[u8]) {
    assert!(bytes.len() >= (side * side * 4) as usize);
    // SAFETY: there are as many bytes as it reads.
    unsafe { glDrawPixels(side, side, GL_RGBA, GL_UNSIGNED_BYTE, bytes.as_ptr().cast()) };
}

pub(crate) fn light(pname: GLenum, values: &[f32; 4]) {
    // SAFETY: four numbers, the most that are read.
    unsafe { glLightfv(GL_LIGHT0, pname, values.as_ptr()) };
}

/// A curve of four points.
pub(crate) fn curve(points: &[[f32; 3]; 4]) {
    // SAFETY: four points of three numbers.
    unsafe { glMap1f(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 4, points.as_ptr().cast()) };
}

/// Uses a program of two shaders.
pub(crate) fn program(vertex: &str, fragment: &str) -> u32 {
    let program = glCreateProgram();
    for (ty, source) in [(GL_VERTEX_SHADER, vertex), (GL_FRAGMENT_SHADER, fragment)] {
        let shader = glCreateShader(ty);
        let (text, length) = (source.as_ptr().cast::<c_char>(), source.len() as i32);
        // SAFETY: a string with its length.
        unsafe { glShaderSource(shader, 1, &raw const text, &raw const length) };
        glCompileShader(shader);
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    glUseProgram(program);
    program
}

pub(crate) fn uniform(program: u32, name: &std::ffi::CStr, value: f32) {
    // SAFETY: a string that a zero ends.
    glUniform1f(unsafe { glGetUniformLocation(program, name.as_ptr()) }, value);
}

pub(crate) fn textured_quadric() -> Handle {
    let quad = gluNewQuadric();
    // SAFETY: a quadric.
    unsafe { gluQuadricTexture(quad, 1) };
    quad
}

pub(crate) fn sphere(radius: f64) {
    // SAFETY: a quadric.
    unsafe { gluSphere(textured_quadric(), radius, 9, 7) };
}

pub(crate) fn cylinder_and_disk() {
    // SAFETY: quadrics.
    unsafe {
        gluCylinder(textured_quadric(), 0.3, 0.7, 0.9, 7, 3);
        gluPartialDisk(textured_quadric(), 0.1, 0.9, 7, 3, 33.0, 210.0);
    }
}

/// Window coordinates of a point, as bits.
pub(crate) fn projected(model: &[f64; 16], projection: &[f64; 16]) -> Vec<u32> {
    let mut out = [0.0; 3];
    let [x, y, z] = &mut out;
    let (model, projection) = (model.as_ptr(), projection.as_ptr());
    // SAFETY: two matrices, a viewport, room for three numbers.
    unsafe { gluProject(0.1, 0.2, 0.3, model, projection, [0, 0, 7, 9].as_ptr(), x, y, z) };
    out.into_iter()
        .flat_map(|value| [value.to_bits() as u32, (value.to_bits() >> 32) as u32])
        .collect()
}

/// Has both callbacks called, which there are: of messages, and of errors of quadrics.
pub(crate) fn call_back(message: DebugCallback, error: extern "C" fn(GLenum)) {
    let quad = gluNewQuadric();
    // SAFETY: functions that read nothing, a quadric.
    unsafe {
        glDebugMessageCallback(message, null());
        gluQuadricCallback(quad, 100_103, error);
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_RGBA);
        gluSphere(quad, -1.0, 9, 9);
        glDisable(GL_DEBUG_OUTPUT);
    }
    assert_eq!(glGetError(), GL_INVALID_ENUM);
}

/// What a thread begins with.
pub(crate) fn set_default() {
    // SAFETY: `FE_DFL_ENV`.
    assert_eq!(unsafe { fesetenv(std::ptr::without_provenance(usize::MAX)) }, 0);
}

#[cfg(target_arch = "x86_64")]
mod arch {
    use super::*;

    pub(crate) const TONEAREST: i32 = 0;
    pub(crate) const DOWNWARD: i32 = 0x400;
    pub(crate) const UPWARD: i32 = 0x800;
    pub(crate) const TOWARDZERO: i32 = 0xC00;
    pub(crate) const INVALID: i32 = 1;
    pub(crate) const DIVBYZERO: i32 = 4;
    pub(crate) const OVERFLOW: i32 = 8;
    pub(crate) const ALL: i32 = 0x3D;

    /// The control word and the sticky flags.
    pub(crate) fn state() -> (u64, u64) {
        let mut word = 0_u32;
        // SAFETY: writes four bytes.
        unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut word, options(nostack)) };
        (u64::from(word & !0x3F), u64::from(word & 0x3F))
    }

    pub(crate) fn flush_denormals() {
        let word = state().0 as u32 | 0x8040;
        // SAFETY: the tests' own arithmetic has no denormals.
        unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const word, options(nostack)) };
    }
}

#[cfg(target_arch = "aarch64")]
mod arch {
    use super::*;

    pub(crate) const TONEAREST: i32 = 0;
    pub(crate) const UPWARD: i32 = 0x40_0000;
    pub(crate) const DOWNWARD: i32 = 0x80_0000;
    pub(crate) const TOWARDZERO: i32 = 0xC0_0000;
    pub(crate) const INVALID: i32 = 1;
    pub(crate) const DIVBYZERO: i32 = 2;
    pub(crate) const OVERFLOW: i32 = 4;
    pub(crate) const ALL: i32 = 0x1F;

    /// The control word and the sticky flags.
    pub(crate) fn state() -> (u64, u64) {
        let (control, flags): (u64, u64);
        // SAFETY: reads two registers.
        unsafe { asm!("mrs {}, fpcr", "mrs {}, fpsr", out(reg) control, out(reg) flags) };
        (control, flags)
    }

    pub(crate) fn flush_denormals() {
        let control = state().0 | 1 << 24;
        // SAFETY: the tests' own arithmetic has no denormals.
        unsafe { asm!("msr fpcr, {}", in(reg) control) };
    }
}

pub(crate) use arch::*;
