//! The table of EGL's functions: C's name and parameters, and what does the work.

use super::error::{Code, call};
use super::raw::{Attrib, Handle, Int, attributes, int_attributes};
use super::{choose, constants, context, current, display, image, surface, sync, thread};
use std::ffi::c_char;

macro_rules! functions {
    ($($name:ident $params:tt -> $ret:ty => $body:expr;)*) => {
        $(functions!(@function $name $params -> $ret => $body);)*
        /// Names and addresses.
        pub(crate) const FUNCTIONS: &[(&str, *const ())] = &[
            ("eglGetError", eglGetError as *const ()),
            $((stringify!($name), $name as *const ()),)*
        ];
    };
    (@function $name:ident ($($param:ident: $ty:ty),*) -> $ret:ty => $body:expr) => {
        #[cfg_attr(feature = "c-names", unsafe(no_mangle))]
        #[allow(non_snake_case, clippy::too_many_arguments, reason = "EGL's name and signature")]
        unsafe extern "C" fn $name($($param: $ty),*) -> $ret {
            call(stringify!($name), || {
                // SAFETY: pointers are what EGL's prototype says they are.
                unsafe { $crate::guard::trust(|| $body) }
            })
        }
    };
}

functions! {
    eglGetDisplay(native: Handle) -> Handle => display::get_display(native);
    eglGetPlatformDisplay(platform: u32, native: Handle, list: *const Attrib) -> Handle
        => display::get_platform_display(platform, native, &attributes(list));
    eglGetPlatformDisplayEXT(platform: u32, native: Handle, list: *const Int) -> Handle
        => display::get_platform_display(platform, native, &int_attributes(list));
    eglInitialize(dpy: Handle, major: *mut Int, minor: *mut Int) -> u32
        => display::initialize(dpy, major, minor);
    eglTerminate(dpy: Handle) -> u32 => display::terminate(dpy);
    eglQueryString(dpy: Handle, name: Int) -> *const c_char => display::query_string(dpy, name);
    eglQueryDevicesEXT(max: Int, devices: *mut Handle, number: *mut Int) -> u32
        => display::query_devices(max, devices, number);
    eglQueryDeviceStringEXT(device: Handle, name: Int) -> *const c_char
        => display::query_device_string(device, name);
    eglQueryDeviceAttribEXT(device: Handle, attribute: Int, _value: *mut Attrib) -> u32
        => display::query_device_attrib(device, attribute);
    eglQueryDisplayAttribEXT(dpy: Handle, attribute: Int, value: *mut Attrib) -> u32
        => display::query_display_attrib(dpy, attribute, value);

    eglGetConfigs(dpy: Handle, configs: *mut Handle, size: Int, number: *mut Int) -> u32
        => choose::get_configs(dpy, configs, size, number);
    eglChooseConfig(
        dpy: Handle, list: *const Int, configs: *mut Handle, size: Int, number: *mut Int
    ) -> u32 => choose::choose_config(dpy, list, configs, size, number);
    eglGetConfigAttrib(dpy: Handle, config: Handle, attribute: Int, value: *mut Int) -> u32
        => choose::get_config_attrib(dpy, config, attribute, value);

    eglCreatePbufferSurface(dpy: Handle, config: Handle, list: *const Int) -> Handle
        => surface::create_pbuffer(dpy, config, list);
    eglCreatePbufferFromClientBuffer(
        dpy: Handle, _ty: u32, _buffer: Handle, config: Handle, _list: *const Int
    ) -> Handle => surface::refused(dpy, config, Code::BadParameter, "client buffers");
    eglCreateWindowSurface(dpy: Handle, config: Handle, _window: Handle, _list: *const Int)
        -> Handle => surface::refused(dpy, config, Code::BadMatch, "windows");
    eglCreatePlatformWindowSurface(
        dpy: Handle, config: Handle, _window: Handle, _list: *const Attrib
    ) -> Handle => surface::refused(dpy, config, Code::BadNativeWindow, "windows");
    eglCreatePlatformWindowSurfaceEXT(
        dpy: Handle, config: Handle, _window: Handle, _list: *const Int
    ) -> Handle => surface::refused(dpy, config, Code::BadNativeWindow, "windows");
    eglCreatePixmapSurface(dpy: Handle, config: Handle, _pixmap: Handle, _list: *const Int)
        -> Handle => surface::refused(dpy, config, Code::BadMatch, "pixmaps");
    eglCreatePlatformPixmapSurface(
        dpy: Handle, config: Handle, _pixmap: Handle, _list: *const Attrib
    ) -> Handle => surface::refused(dpy, config, Code::BadNativePixmap, "pixmaps");
    eglCreatePlatformPixmapSurfaceEXT(
        dpy: Handle, config: Handle, _pixmap: Handle, _list: *const Int
    ) -> Handle => surface::refused(dpy, config, Code::BadNativePixmap, "pixmaps");
    eglDestroySurface(dpy: Handle, surface: Handle) -> u32 => surface::destroy(dpy, surface);
    eglQuerySurface(dpy: Handle, surface: Handle, attribute: Int, value: *mut Int) -> u32
        => surface::query(dpy, surface, attribute, value);
    eglSurfaceAttrib(dpy: Handle, surface: Handle, attribute: Int, value: Int) -> u32
        => surface::set_attrib(dpy, surface, attribute, value);
    eglBindTexImage(dpy: Handle, surface: Handle, _buffer: Int) -> u32
        => surface::tex_image(dpy, surface);
    eglReleaseTexImage(dpy: Handle, surface: Handle, _buffer: Int) -> u32
        => surface::tex_image(dpy, surface);
    eglSwapBuffers(dpy: Handle, surface: Handle) -> u32 => surface::swap(dpy, surface);
    eglCopyBuffers(dpy: Handle, surface: Handle, _target: Handle) -> u32
        => surface::copy(dpy, surface);
    eglSwapInterval(dpy: Handle, _interval: Int) -> u32 => current::swap_interval(dpy);

    eglBindAPI(api: u32) -> u32 => context::bind_api(api);
    eglQueryAPI() -> u32 => context::query_api();
    eglCreateContext(dpy: Handle, config: Handle, share: Handle, list: *const Int) -> Handle
        => context::create(dpy, config, share, &int_attributes(list));
    eglDestroyContext(dpy: Handle, context: Handle) -> u32 => context::destroy(dpy, context);
    eglQueryContext(dpy: Handle, context: Handle, attribute: Int, value: *mut Int) -> u32
        => context::query(dpy, context, attribute, value);

    eglMakeCurrent(dpy: Handle, draw: Handle, read: Handle, context: Handle) -> u32
        => current::make(dpy, draw, read, context);
    eglGetCurrentContext() -> Handle => current::current_context();
    eglGetCurrentDisplay() -> Handle => current::current_display();
    eglGetCurrentSurface(which: Int) -> Handle => current::current_surface(which);
    eglReleaseThread() -> u32 => current::release_thread();
    eglWaitClient() -> u32 => current::wait();
    eglWaitGL() -> u32 => current::wait();
    eglWaitNative(engine: Int) -> u32 => current::wait_native(engine);

    eglCreateSync(dpy: Handle, ty: u32, list: *const Attrib) -> Handle
        => sync::create(dpy, ty, &attributes(list), Code::BadParameter);
    eglCreateSyncKHR(dpy: Handle, ty: u32, list: *const Int) -> Handle
        => sync::create(dpy, ty, &int_attributes(list), Code::BadAttribute);
    eglDestroySync(dpy: Handle, sync: Handle) -> u32
        => sync::destroy(dpy, sync);
    eglDestroySyncKHR(dpy: Handle, sync: Handle) -> u32
        => sync::destroy(dpy, sync);
    eglClientWaitSync(dpy: Handle, sync: Handle, _flags: Int, _timeout: u64)
        -> u32 => sync::client_wait(dpy, sync);
    eglClientWaitSyncKHR(dpy: Handle, sync: Handle, _flags: Int, _timeout: u64)
        -> u32 => sync::client_wait(dpy, sync);
    eglWaitSync(dpy: Handle, sync: Handle, flags: Int) -> u32
        => sync::server_wait(dpy, sync, flags);
    eglWaitSyncKHR(dpy: Handle, sync: Handle, flags: Int) -> u32
        => sync::server_wait(dpy, sync, flags);
    eglGetSyncAttrib(dpy: Handle, sync: Handle, attribute: Int, value: *mut Attrib) -> u32
        => sync::get_attrib(dpy, sync, attribute, value.cast::<AttribOut>());
    eglGetSyncAttribKHR(dpy: Handle, sync: Handle, attribute: Int, value: *mut Int) -> u32
        => sync::get_attrib(dpy, sync, attribute, value);

    eglCreateImage(dpy: Handle, context: Handle, target: u32, buffer: Handle, list: *const Attrib)
        -> Handle => image::create(dpy, context, target, buffer, &attributes(list));
    eglCreateImageKHR(dpy: Handle, context: Handle, target: u32, buffer: Handle, list: *const Int)
        -> Handle => image::create(dpy, context, target, buffer, &int_attributes(list));
    eglDestroyImage(dpy: Handle, image: Handle) -> u32 => image::destroy(dpy, image);
    eglDestroyImageKHR(dpy: Handle, image: Handle) -> u32 => image::destroy(dpy, image);
}

/// `EGLAttrib`, as what an `EGLint` fits into.
#[repr(transparent)]
struct AttribOut(Attrib);

impl From<Int> for AttribOut {
    fn from(value: Int) -> Self {
        Self(value as Attrib)
    }
}

#[cfg_attr(feature = "c-names", unsafe(no_mangle))]
#[allow(non_snake_case, reason = "EGL's name")]
extern "C" fn eglGetError() -> Int {
    thread::thread(|thread| thread.error.replace(constants::EGL_SUCCESS))
}
