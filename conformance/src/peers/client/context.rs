//! A context that draws into a pbuffer.

use super::error::ClientError;
use super::gl::Gl;
use khronos_egl as egl;
use std::ffi::c_void;
use std::path::Path;

/// A driver with a current context. It is never closed: the process that measures a driver ends
/// with it.
#[derive(Debug)]
pub struct Client {
    /// The driver's functions.
    pub gl: Gl,
}

impl Client {
    /// Opens libEGL and makes a context current that draws into a pbuffer of `side` × `side`
    /// pixels: RGBA8 with 24 bits of depth.
    ///
    /// # Errors
    /// When the library or one of its functions is missing, or EGL refuses.
    pub fn open(library: &Path, side: usize) -> Result<Self, ClientError> {
        // SAFETY: running a library's initializers is what opening a GL driver means; whoever
        // names the library trusts it.
        let opened =
            unsafe { egl::DynamicInstance::<egl::EGL1_4>::load_required_from_filename(library) };
        let egl = opened.map_err(|error| ClientError::Library {
            library: library.display().to_string(),
            reason: error.to_string(),
        })?;
        // Unloading a driver while its threads run is not what is measured here.
        let egl: &'static _ = Box::leak(Box::new(egl));
        let failed =
            |call| move |error: egl::Error| ClientError::Egl { call, reason: error.to_string() };
        let none = |call| ClientError::Egl { call, reason: "none fits".to_owned() };
        // SAFETY: EGL_DEFAULT_DISPLAY is not dereferenced.
        let display = unsafe { egl.get_display(egl::DEFAULT_DISPLAY) };
        let display = display.ok_or_else(|| none("eglGetDisplay"))?;
        egl.initialize(display).map_err(failed("eglInitialize"))?;
        egl.bind_api(egl::OPENGL_API).map_err(failed("eglBindAPI"))?;
        #[rustfmt::skip]
        let selected = [
            egl::SURFACE_TYPE, egl::PBUFFER_BIT,
            egl::RENDERABLE_TYPE, egl::OPENGL_BIT,
            egl::RED_SIZE, 8, egl::GREEN_SIZE, 8, egl::BLUE_SIZE, 8, egl::ALPHA_SIZE, 8,
            egl::DEPTH_SIZE, 24,
            egl::NONE,
        ];
        let config =
            egl.choose_first_config(display, &selected).map_err(failed("eglChooseConfig"))?;
        let config = config.ok_or_else(|| none("eglChooseConfig"))?;
        let size = [egl::WIDTH, side as i32, egl::HEIGHT, side as i32, egl::NONE];
        let surface = egl
            .create_pbuffer_surface(display, config, &size)
            .map_err(failed("eglCreatePbufferSurface"))?;
        let context = egl
            .create_context(display, config, None, &[egl::NONE])
            .map_err(failed("eglCreateContext"))?;
        egl.make_current(display, Some(surface), Some(surface), Some(context))
            .map_err(failed("eglMakeCurrent"))?;
        let address = |name: &str| -> *const c_void {
            egl.get_proc_address(name).map_or(std::ptr::null(), |pointer| pointer as *const c_void)
        };
        Ok(Self { gl: Gl::load(address) })
    }
}
