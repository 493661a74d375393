//! GL's functions as safe methods.

use super::bindings;
use super::error::ClientError;
use crate::oracle::matrix::Matrix;
use crate::oracle::texture::Level;
use gl_api::constants::*;
use std::ffi::{CStr, c_void};

/// The functions of a driver whose context is current on this thread.
pub struct Gl {
    pub(super) raw: bindings::Gl,
}

impl std::fmt::Debug for Gl {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Gl")
    }
}

/// Defines methods whose arguments are numbers.
macro_rules! of_numbers {
    ($($(#[$doc:meta])* $method:ident = $function:ident($($argument:ident: $ty:ty),*);)*) => {
        impl Gl {
            $($(#[$doc])* pub fn $method(&self, $($argument: $ty),*) {
                // SAFETY: no argument is memory, and the context is current.
                unsafe { self.raw.$function($($argument),*) }
            })*
        }
    };
}

of_numbers! {
    /// `glActiveTexture`
    active_texture = ActiveTexture(unit: u32);
    /// `glBindFramebufferEXT`
    bind_framebuffer = BindFramebufferEXT(target: u32, name: u32);
    /// `glBindTexture`
    bind_texture = BindTexture(target: u32, name: u32);
    /// `glBlendFunc`
    blend_func = BlendFunc(source: u32, destination: u32);
    /// `glClear`
    clear = Clear(mask: u32);
    /// `glClearColor`
    clear_color = ClearColor(red: f32, green: f32, blue: f32, alpha: f32);
    /// `glDisable`
    disable = Disable(capability: u32);
    /// `glDrawBuffer`
    draw_buffer = DrawBuffer(buffer: u32);
    /// `glEnable`
    enable = Enable(capability: u32);
    /// `glFinish`
    finish = Finish();
    /// `glFogf`
    fog_f = Fogf(name: u32, value: f32);
    /// `glFogi`
    fog_i = Fogi(name: u32, value: i32);
    /// `glFramebufferTexture2DEXT`
    framebuffer_texture =
        FramebufferTexture2DEXT(target: u32, attachment: u32, of: u32, texture: u32, level: i32);
    /// `glGenerateMipmapEXT`
    generate_mipmap = GenerateMipmapEXT(target: u32);
    /// `glMatrixMode`
    matrix_mode = MatrixMode(mode: u32);
    /// `glReadBuffer`
    read_buffer = ReadBuffer(buffer: u32);
    /// `glTexGeni`
    tex_gen_i = TexGeni(coordinate: u32, name: u32, value: i32);
    /// `glTexParameterf`
    tex_parameter_f = TexParameterf(target: u32, name: u32, value: f32);
    /// `glTexParameteri`
    tex_parameter_i = TexParameteri(target: u32, name: u32, value: i32);
    /// `glUniform1i`
    uniform = Uniform1i(location: i32, value: i32);
    /// `glUseProgram`
    use_program = UseProgram(program: u32);
    /// `glViewport`
    viewport = Viewport(x: i32, y: i32, width: i32, height: i32);
}

impl Gl {
    /// Loads the functions through `address`.
    pub(super) fn load(address: impl Fn(&str) -> *const c_void) -> Self {
        Self { raw: bindings::Gl::load_with(address) }
    }

    /// Checks the error flag.
    ///
    /// # Errors
    /// When it is set.
    pub fn check(&self, after: &'static str) -> Result<(), ClientError> {
        // SAFETY: there are no arguments.
        match unsafe { self.raw.GetError() } {
            GL_NO_ERROR => Ok(()),
            code => Err(ClientError::Gl { after, code }),
        }
    }

    /// `glGetString`
    pub fn string(&self, name: u32) -> String {
        // SAFETY: there is no memory among the arguments.
        let text = unsafe { self.raw.GetString(name) };
        if text.is_null() {
            return String::new();
        }
        // SAFETY: it is a static string that ends with a zero (section 6.1.11).
        unsafe { CStr::from_ptr(text.cast()) }.to_string_lossy().into_owned()
    }

    /// `glLoadMatrixf`
    pub fn load_matrix(&self, m: &Matrix) {
        let columns: [f32; 16] = std::array::from_fn(|k| m[k % 4][k / 4] as f32);
        // SAFETY: there are sixteen numbers.
        unsafe { self.raw.LoadMatrixf(columns.as_ptr()) }
    }

    /// `glLightfv` of a parameter of four numbers.
    pub fn light(&self, light: u32, name: u32, values: [f32; 4]) {
        // SAFETY: no parameter of a light has more than four numbers.
        unsafe { self.raw.Lightfv(light, name, values.as_ptr()) }
    }

    /// `glLightModelfv`
    pub fn light_model(&self, name: u32, values: [f32; 4]) {
        // SAFETY: no parameter of the light model has more than four numbers.
        unsafe { self.raw.LightModelfv(name, values.as_ptr()) }
    }

    /// `glMaterialfv` of the front.
    pub fn material(&self, name: u32, values: [f32; 4]) {
        // SAFETY: no parameter of a material has more than four numbers.
        unsafe { self.raw.Materialfv(GL_FRONT_AND_BACK, name, values.as_ptr()) }
    }

    /// `glFogfv` with `GL_FOG_COLOR`.
    pub fn fog_color(&self, color: [f32; 4]) {
        // SAFETY: a colour has four numbers.
        unsafe { self.raw.Fogfv(GL_FOG_COLOR, color.as_ptr()) }
    }

    /// The name of a new texture.
    pub fn gen_texture(&self) -> u32 {
        let mut name = 0;
        // SAFETY: there is room for one name.
        unsafe { self.raw.GenTextures(1, &mut name) };
        name
    }

    /// The name of a new framebuffer.
    pub fn gen_framebuffer(&self) -> u32 {
        let mut name = 0;
        // SAFETY: there is room for one name.
        unsafe { self.raw.GenFramebuffersEXT(1, &mut name) };
        name
    }

    /// `glTexGenfv` with `GL_OBJECT_PLANE`.
    pub fn object_plane(&self, coordinate: u32, plane: [f32; 4]) {
        // SAFETY: a plane has four numbers.
        unsafe { self.raw.TexGenfv(coordinate, GL_OBJECT_PLANE, plane.as_ptr()) }
    }

    /// `glTexImage2D` of a level of a texture that is bound, or of a face of a cube map, as RGBA8.
    pub fn tex_image(&self, target: u32, number: usize, level: &Level) {
        let (width, height) = (level.width as i32, level.height as i32);
        let texels = checked(level).cast();
        // SAFETY: the rows are RGBA bytes without gaps, as many as the size says.
        unsafe {
            self.raw.TexImage2D(
                target,
                number as i32,
                GL_RGBA8 as i32,
                width,
                height,
                0,
                GL_RGBA,
                GL_UNSIGNED_BYTE,
                texels,
            );
        }
    }

    /// `glTexSubImage2D` of all of level 0 of the texture that is bound to `GL_TEXTURE_2D`.
    pub fn tex_sub_image(&self, level: &Level) {
        let (width, height) = (level.width as i32, level.height as i32);
        let texels = checked(level).cast();
        // SAFETY: as in `tex_image`.
        unsafe {
            self.raw.TexSubImage2D(
                GL_TEXTURE_2D,
                0,
                0,
                0,
                width,
                height,
                GL_RGBA,
                GL_UNSIGNED_BYTE,
                texels,
            );
        }
    }

    /// `glTexImage2D` of a depth texture without texels.
    pub fn depth_image(&self, side: usize) {
        let side = side as i32;
        // SAFETY: a null pointer gives no texels (section 3.8.1).
        unsafe {
            self.raw.TexImage2D(
                GL_TEXTURE_2D,
                0,
                GL_DEPTH_COMPONENT24 as i32,
                side,
                side,
                0,
                GL_DEPTH_COMPONENT,
                GL_UNSIGNED_INT,
                std::ptr::null(),
            );
        }
    }

    /// The lower left `side` × `side` pixels as RGBA bytes, into `to`.
    pub fn read_pixels(&self, side: usize, to: &mut Vec<u8>) {
        to.resize(side * side * 4, 0);
        let size = side as i32;
        // SAFETY: there is room for four bytes a pixel, and rows of them have no gaps.
        unsafe {
            self.raw.ReadPixels(
                0,
                0,
                size,
                size,
                GL_RGBA,
                GL_UNSIGNED_BYTE,
                to.as_mut_ptr().cast(),
            );
        }
    }

    /// A program of a vertex and a fragment shader.
    ///
    /// # Errors
    /// When one does not compile, or both do not link.
    pub fn program(&self, vertex: &str, fragment: &str) -> Result<u32, ClientError> {
        let vertex = self.shader(GL_VERTEX_SHADER, "vertex shader", vertex)?;
        let fragment = self.shader(GL_FRAGMENT_SHADER, "fragment shader", fragment)?;
        let mut linked = 0;
        // SAFETY: names are numbers, and there is room for one answer.
        let program = unsafe {
            let program = self.raw.CreateProgram();
            self.raw.AttachShader(program, vertex);
            self.raw.AttachShader(program, fragment);
            self.raw.LinkProgram(program);
            self.raw.GetProgramiv(program, GL_LINK_STATUS, &mut linked);
            program
        };
        if linked != 0 {
            return Ok(program);
        }
        let (mut log, mut length) = (vec![0u8; 4096], 0);
        // SAFETY: GL writes no more than the size it is told.
        unsafe {
            self.raw.GetProgramInfoLog(program, 4096, &mut length, log.as_mut_ptr().cast());
        }
        log.truncate(length.max(0) as usize);
        let log = String::from_utf8_lossy(&log).into_owned();
        Err(ClientError::Shader { stage: "program", log })
    }

    fn shader(&self, kind: u32, stage: &'static str, source: &str) -> Result<u32, ClientError> {
        let (text, size, mut compiled) = (source.as_ptr().cast(), source.len() as i32, 0);
        // SAFETY: one string of this length, and room for one answer.
        let shader = unsafe {
            let shader = self.raw.CreateShader(kind);
            self.raw.ShaderSource(shader, 1, &text, &size);
            self.raw.CompileShader(shader);
            self.raw.GetShaderiv(shader, GL_COMPILE_STATUS, &mut compiled);
            shader
        };
        if compiled != 0 {
            return Ok(shader);
        }
        let (mut log, mut length) = (vec![0u8; 4096], 0);
        // SAFETY: GL writes no more than the size it is told.
        unsafe { self.raw.GetShaderInfoLog(shader, 4096, &mut length, log.as_mut_ptr().cast()) };
        log.truncate(length.max(0) as usize);
        Err(ClientError::Shader { stage, log: String::from_utf8_lossy(&log).into_owned() })
    }

    /// Sets a sampler of the current program to a unit; a name that the program does not have is
    /// ignored.
    pub fn sampler(&self, program: u32, name: &CStr, unit: i32) {
        // SAFETY: the name ends with a zero.
        let location = unsafe { self.raw.GetUniformLocation(program, name.as_ptr()) };
        self.uniform(location, unit);
    }
}

/// The texels of a level, of which there are as many as its size says.
fn checked(level: &Level) -> *const u8 {
    assert_eq!(level.texels.len(), level.width * level.height, "the texels of a level");
    level.texels.as_ptr().cast()
}
