//! Platforms, devices and displays (EGL 1.5, sections 3.2 and 3.3).

use super::constants::*;
use super::error::{Code, Result, fail, name_of};
use super::raw::{Attrib, Handle, Int, handle, put};
use super::registry::{DEVICE, Platform, display, registry};
use std::ffi::{CStr, c_char};

/// Extensions that belong to no display.
const CLIENT_EXTENSIONS: &CStr = c"EGL_EXT_client_extensions EGL_EXT_device_base \
    EGL_EXT_device_enumeration EGL_EXT_device_query EGL_EXT_platform_base \
    EGL_EXT_platform_device EGL_KHR_client_get_all_proc_addresses EGL_MESA_platform_surfaceless";
/// Extensions of every display.
const EXTENSIONS: &CStr = c"EGL_EXT_create_context_robustness EGL_KHR_config_attribs \
    EGL_KHR_create_context EGL_KHR_create_context_no_error EGL_KHR_fence_sync \
    EGL_KHR_get_all_proc_addresses EGL_KHR_gl_renderbuffer_image EGL_KHR_gl_texture_2D_image \
    EGL_KHR_gl_texture_3D_image EGL_KHR_gl_texture_cubemap_image EGL_KHR_image_base \
    EGL_KHR_no_config_context EGL_KHR_surfaceless_context EGL_KHR_wait_sync";
/// `EGL_EXT_device_query_name`, which the registry does not have yet.
const EGL_RENDERER_EXT: Int = 0x335F;
/// Extensions of the device.
const DEVICE_EXTENSIONS: &CStr = c"EGL_MESA_device_software EGL_EXT_device_query_name";

pub(crate) fn get_display(native: Handle) -> Result<Handle> {
    if native.is_null() {
        return Ok(handle(Platform::Default.display()));
    }
    fail(
        Code::BadParameter,
        "display_id must be EGL_DEFAULT_DISPLAY: DetGL draws into memory, not into windows",
    )
}

pub(crate) fn get_platform_display(
    platform: u32,
    native: Handle,
    attributes: &[(Int, Attrib)],
) -> Result<Handle> {
    let platform = match platform as Int {
        EGL_PLATFORM_SURFACELESS_MESA if native.is_null() => Platform::Surfaceless,
        EGL_PLATFORM_DEVICE_EXT if native.addr() == DEVICE => Platform::Device,
        EGL_PLATFORM_SURFACELESS_MESA => {
            return fail(Code::BadParameter, "native_display must be EGL_DEFAULT_DISPLAY");
        }
        EGL_PLATFORM_DEVICE_EXT => {
            return fail(Code::BadParameter, "native_display is no device: see eglQueryDevicesEXT");
        }
        other => {
            return fail(
                Code::BadParameter,
                format!(
                    "platform = {} must be EGL_PLATFORM_SURFACELESS_MESA or \
                     EGL_PLATFORM_DEVICE_EXT",
                    name_of(other)
                ),
            );
        }
    };
    match attributes.first() {
        None => Ok(handle(platform.display())),
        Some((name, _)) => {
            fail(Code::BadAttribute, format!("attrib_list: no attribute {}", name_of(*name)))
        }
    }
}

pub(super) unsafe fn initialize(dpy: Handle, major: *mut Int, minor: *mut Int) -> Result<u32> {
    let id = display(dpy)?;
    let mut registry = registry();
    if !registry.initialized.contains(&id) {
        registry.initialized.push(id);
    }
    // SAFETY: the client's, as C's prototype says.
    unsafe {
        put(major, 1);
        put(minor, 5);
    }
    Ok(1)
}

/// Everything of the display goes; what is current when it is current no more.
pub(super) fn terminate(dpy: Handle) -> Result<u32> {
    let id = display(dpy)?;
    let mut registry = registry();
    registry.initialized.retain(|&other| other != id);
    registry.syncs.retain(|_, display| *display != id);
    registry.images.retain(|_, (display, _)| *display != id);
    let contexts: Vec<_> = registry.contexts.iter().filter(|row| row.1.display == id).collect();
    let contexts: Vec<_> = contexts.into_iter().map(|row| *row.0).collect();
    for context in contexts {
        registry.doom_context(context);
    }
    let surfaces: Vec<_> = registry.surfaces.iter().filter(|row| row.1.display == id).collect();
    let surfaces: Vec<_> = surfaces.into_iter().map(|row| *row.0).collect();
    for surface in surfaces {
        registry.doom_surface(surface);
    }
    Ok(1)
}

pub(super) fn query_string(dpy: Handle, name: Int) -> Result<*const c_char> {
    if dpy.is_null() {
        return match name {
            EGL_EXTENSIONS => Ok(CLIENT_EXTENSIONS.as_ptr()),
            EGL_VERSION => Ok(c"1.5".as_ptr()),
            _ => fail(Code::BadDisplay, "dpy must not be EGL_NO_DISPLAY for this name"),
        };
    }
    registry().display(dpy)?;
    Ok(match name {
        EGL_CLIENT_APIS => c"OpenGL OpenGL_ES".as_ptr(),
        EGL_EXTENSIONS => EXTENSIONS.as_ptr(),
        EGL_VENDOR => c"DetGL".as_ptr(),
        EGL_VERSION => c"1.5 DetGL".as_ptr(),
        _ => {
            return fail(
                Code::BadParameter,
                format!(
                    "name = {} must be EGL_CLIENT_APIS, EGL_EXTENSIONS, EGL_VENDOR or \
                     EGL_VERSION",
                    name_of(name)
                ),
            );
        }
    })
}

pub(super) unsafe fn query_devices(
    max: Int,
    devices: *mut Handle,
    number: *mut Int,
) -> Result<u32> {
    if number.is_null() || (!devices.is_null() && max <= 0) {
        return fail(
            Code::BadParameter,
            "num_devices must not be NULL, nor max_devices below 1 where devices is not",
        );
    }
    // SAFETY: the client's, as C's prototype says; there is room for one.
    unsafe {
        put(devices, handle(DEVICE));
        put(number, 1);
    }
    Ok(1)
}

/// The one device.
fn device(handle: Handle) -> Result<()> {
    if handle.addr() == DEVICE {
        return Ok(());
    }
    fail(Code::BadDevice, "device is none that eglQueryDevicesEXT gave")
}

pub(super) fn query_device_string(handle: Handle, name: Int) -> Result<*const c_char> {
    device(handle)?;
    match name {
        EGL_EXTENSIONS => Ok(DEVICE_EXTENSIONS.as_ptr()),
        EGL_VENDOR | EGL_RENDERER_EXT => Ok(c"DetGL".as_ptr()),
        _ => fail(Code::BadParameter, format!("name = {} is none of devices", name_of(name))),
    }
}

pub(super) fn query_device_attrib(handle: Handle, attribute: Int) -> Result<u32> {
    device(handle)?;
    fail(Code::BadAttribute, format!("attribute = {} is none of devices", name_of(attribute)))
}

pub(super) unsafe fn query_display_attrib(
    dpy: Handle,
    name: Int,
    value: *mut Attrib,
) -> Result<u32> {
    registry().display(dpy)?;
    if name != EGL_DEVICE_EXT {
        return fail(
            Code::BadAttribute,
            format!("attribute = {} is none of displays", name_of(name)),
        );
    }
    if value.is_null() {
        return fail(Code::BadParameter, "value must not be NULL");
    }
    // SAFETY: not null, and the client's.
    unsafe { put(value, DEVICE as Attrib) };
    Ok(1)
}
