//! The vendor interface of libglvnd (`glvnd/libeglabi.h`, version 0): a program that has loaded the
//! system's libEGL gets DetGL through it, where `__EGL_VENDOR_LIBRARY_FILENAMES` names the file that
//! `detgl install` writes. Extension functions of displays are not dispatched.

use crate::egl::constants::*;
use crate::egl::display;
use crate::egl::error::call;
use crate::egl::raw::{Attrib, Handle, Int, attributes};
use crate::guard::guard;
use crate::proc_address;
use std::ffi::{c_char, c_int, c_void};

/// The part of `__EGLapiImports` that a vendor must fill in; what follows is optional.
#[repr(C)]
struct Imports {
    get_platform_display: unsafe extern "C" fn(u32, Handle, *const Attrib) -> Handle,
    supports_api: extern "C" fn(u32) -> u32,
    vendor_string: extern "C" fn(c_int) -> *const c_char,
    proc_address: unsafe extern "C" fn(*const c_char) -> *const c_void,
    dispatch_address: extern "C" fn(*const c_char) -> *const c_void,
    set_dispatch_index: extern "C" fn(*const c_char, c_int),
}

unsafe extern "C" fn get_platform_display(
    platform: u32,
    native: Handle,
    list: *const Attrib,
) -> Handle {
    call("eglGetPlatformDisplay", || {
        if platform as Int == EGL_NONE {
            return display::get_display(native);
        }
        // SAFETY: libEGL passes on what its client promised.
        display::get_platform_display(platform, native, &unsafe { attributes(list) })
    })
}

extern "C" fn supports_api(api: u32) -> u32 {
    u32::from([EGL_OPENGL_API, EGL_OPENGL_ES_API].contains(&(api as Int)))
}

extern "C" fn vendor_string(name: c_int) -> *const c_char {
    const PLATFORM_EXTENSIONS: c_int = 0;
    if name == PLATFORM_EXTENSIONS {
        return c"EGL_EXT_platform_device EGL_MESA_platform_surfaceless".as_ptr();
    }
    std::ptr::null()
}

unsafe extern "C" fn by_name(name: *const c_char) -> *const c_void {
    // SAFETY: C's prototype promises the same.
    guard("getProcAddress", || unsafe { proc_address::named(name) })
}

extern "C" fn no_dispatch(_name: *const c_char) -> *const c_void {
    std::ptr::null()
}

extern "C" fn no_index(_name: *const c_char, _index: c_int) {}

/// What libEGL calls first: fills in the table, if it is of the version that is known here.
#[unsafe(no_mangle)]
#[allow(non_snake_case, reason = "libglvnd's name")]
unsafe extern "C" fn __egl_Main(
    version: u32,
    _exports: *const c_void,
    _vendor: *mut c_void,
    imports: *mut Imports,
) -> u32 {
    let major = version >> 16;
    if major != 0 || imports.is_null() {
        return 0;
    }
    let table = Imports {
        get_platform_display,
        supports_api,
        vendor_string,
        proc_address: by_name,
        dispatch_address: no_dispatch,
        set_dispatch_index: no_index,
    };
    // SAFETY: libEGL's own table, which begins with these fields.
    unsafe { imports.write(table) };
    1
}
