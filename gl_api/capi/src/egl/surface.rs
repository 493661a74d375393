//! Pbuffers (EGL 1.5, section 3.5); of windows and pixmaps only the refusals.

use super::config::Config;
use super::constants::*;
use super::error::{Code, Result, fail, name_of};
use super::raw::{Attrib, Handle, Id, Int, handle, int_attributes, put};
use super::registry::{Registry, Settings, SurfaceEntry, SwapBehavior, registry};
use super::thread::thread;
use gl_api::host::limits::MAX_VIEWPORT_DIMS;
use gl_api::host::{self, Surface};

impl Registry {
    /// Removes a surface, now or when it is current no more.
    pub fn doom_surface(&mut self, id: Id) {
        if let Some(entry) = self.surfaces.get_mut(&id) {
            entry.doomed = true;
            if entry.thread.is_none() {
                self.surfaces.remove(&id);
            }
        }
    }
}

/// What the attributes of a pbuffer ask for.
#[derive(Default)]
struct Request {
    width: u32,
    height: u32,
    largest: bool,
}

/// The refusal of a value that an attribute never has.
fn no_value<T>(attribute: Int, value: Int) -> Result<T> {
    fail(Code::BadAttribute, format!("attribute {} has no value {value:#x}", name_of(attribute)))
}

fn request(attributes: &[(Int, Attrib)]) -> Result<Request> {
    let mut request = Request::default();
    let side = |name: &str, value: Attrib| match u32::try_from(value) {
        Ok(side) => Ok(side),
        Err(_) => fail(Code::BadParameter, format!("{name} = {value} must not be negative")),
    };
    for &(name, value) in attributes {
        match name {
            EGL_WIDTH => request.width = side("EGL_WIDTH", value)?,
            EGL_HEIGHT => request.height = side("EGL_HEIGHT", value)?,
            EGL_LARGEST_PBUFFER => request.largest = value != 0,
            EGL_TEXTURE_FORMAT | EGL_TEXTURE_TARGET => match (name, value as Int) {
                (_, EGL_NO_TEXTURE) => {}
                (EGL_TEXTURE_FORMAT, EGL_TEXTURE_RGB | EGL_TEXTURE_RGBA)
                | (EGL_TEXTURE_TARGET, EGL_TEXTURE_2D) => {
                    return fail(Code::BadMatch, "no config binds pbuffers to textures");
                }
                (_, value) => return no_value(name, value),
            },
            // Of OpenGL ES and OpenVG: accepted and without effect.
            EGL_MIPMAP_TEXTURE | EGL_VG_ALPHA_FORMAT | EGL_VG_COLORSPACE => {}
            EGL_GL_COLORSPACE => match value as Int {
                EGL_GL_COLORSPACE_LINEAR => {}
                EGL_GL_COLORSPACE_SRGB => {
                    let rule = "EGL_GL_COLORSPACE must be EGL_GL_COLORSPACE_LINEAR";
                    return fail(Code::BadMatch, rule);
                }
                value => return no_value(name, value),
            },
            _ => {
                return fail(
                    Code::BadAttribute,
                    format!("attrib_list: no attribute {}", name_of(name)),
                );
            }
        }
    }
    if request.largest {
        request.width = request.width.min(MAX_VIEWPORT_DIMS);
        request.height = request.height.min(MAX_VIEWPORT_DIMS);
    }
    Ok(request)
}

pub(super) unsafe fn create_pbuffer(
    dpy: Handle,
    config: Handle,
    list: *const Int,
) -> Result<Handle> {
    let mut registry = registry();
    let display = registry.display(dpy)?;
    let config = Config::find(config)?;
    // SAFETY: the client's, as C's prototype says.
    let Request { width, height, largest } = request(&unsafe { int_attributes(list) })?;
    if width > MAX_VIEWPORT_DIMS || height > MAX_VIEWPORT_DIMS {
        return fail(
            Code::BadAlloc,
            format!("{width}×{height}: sides must not be above {MAX_VIEWPORT_DIMS}"),
        );
    }
    // A pbuffer may be empty, an image may not.
    let buffers = Surface::new(width.max(1), height.max(1), config.surface());
    if buffers.is_none() {
        return fail(Code::BadAlloc, format!("no memory for {width}×{height} pixels"));
    }
    let id = registry.new_id();
    let entry = SurfaceEntry {
        display,
        config: Some(config),
        width,
        height,
        largest,
        settings: Settings::default(),
        buffers,
        thread: None,
        doomed: false,
    };
    registry.surfaces.insert(id, entry);
    Ok(handle(id))
}

pub(super) fn destroy(dpy: Handle, surface: Handle) -> Result<u32> {
    let mut registry = registry();
    let display = registry.display(dpy)?;
    let (id, _) = registry.surface(display, surface)?;
    registry.doom_surface(id);
    Ok(1)
}

pub(super) unsafe fn query(
    dpy: Handle,
    surface: Handle,
    attribute: Int,
    value: *mut Int,
) -> Result<u32> {
    let mut registry = registry();
    let display = registry.display(dpy)?;
    let (_, entry) = registry.surface(display, surface)?;
    let found = match attribute {
        EGL_WIDTH => entry.width as Int,
        EGL_HEIGHT => entry.height as Int,
        EGL_CONFIG_ID => entry.config.map_or(0, |config| config.id),
        EGL_LARGEST_PBUFFER => entry.largest.into(),
        EGL_RENDER_BUFFER => EGL_BACK_BUFFER,
        EGL_SWAP_BEHAVIOR => match entry.settings.swap {
            SwapBehavior::Preserved => EGL_BUFFER_PRESERVED,
            SwapBehavior::Destroyed => EGL_BUFFER_DESTROYED,
        },
        EGL_MULTISAMPLE_RESOLVE => EGL_MULTISAMPLE_RESOLVE_DEFAULT,
        EGL_GL_COLORSPACE => EGL_GL_COLORSPACE_LINEAR,
        EGL_VG_COLORSPACE => EGL_VG_COLORSPACE_sRGB,
        EGL_VG_ALPHA_FORMAT => EGL_VG_ALPHA_FORMAT_NONPRE,
        EGL_TEXTURE_FORMAT | EGL_TEXTURE_TARGET => EGL_NO_TEXTURE,
        EGL_MIPMAP_LEVEL => entry.settings.mipmap_level,
        EGL_MIPMAP_TEXTURE => 0,
        EGL_HORIZONTAL_RESOLUTION | EGL_VERTICAL_RESOLUTION | EGL_PIXEL_ASPECT_RATIO => EGL_UNKNOWN,
        _ => {
            let rule = format!("attribute = {} is none of surfaces", name_of(attribute));
            return fail(Code::BadAttribute, rule);
        }
    };
    if value.is_null() {
        return fail(Code::BadParameter, "value must not be NULL");
    }
    // SAFETY: not null, and the client's.
    unsafe { put(value, found) };
    Ok(1)
}

pub(super) fn set_attrib(dpy: Handle, surface: Handle, attribute: Int, value: Int) -> Result<u32> {
    let mut registry = registry();
    let display = registry.display(dpy)?;
    let (_, SurfaceEntry { settings, .. }) = registry.surface(display, surface)?;
    match (attribute, value) {
        (EGL_MIPMAP_LEVEL, level) => settings.mipmap_level = level,
        (EGL_MULTISAMPLE_RESOLVE, EGL_MULTISAMPLE_RESOLVE_DEFAULT) => {}
        (EGL_SWAP_BEHAVIOR, EGL_BUFFER_PRESERVED) => settings.swap = SwapBehavior::Preserved,
        (EGL_SWAP_BEHAVIOR, EGL_BUFFER_DESTROYED) => settings.swap = SwapBehavior::Destroyed,
        (EGL_MULTISAMPLE_RESOLVE, EGL_MULTISAMPLE_RESOLVE_BOX) => {
            let rule = format!("no config has {value:#x} for attribute {}", name_of(attribute));
            return fail(Code::BadMatch, rule);
        }
        (EGL_MULTISAMPLE_RESOLVE | EGL_SWAP_BEHAVIOR, _) => return no_value(attribute, value),
        _ => {
            let rule = format!("attribute = {} cannot be set", name_of(attribute));
            return fail(Code::BadAttribute, rule);
        }
    }
    Ok(1)
}

/// `eglBindTexImage` and `eglReleaseTexImage`: no surface was made for it.
pub(super) fn tex_image(dpy: Handle, surface: Handle) -> Result<u32> {
    let mut registry = registry();
    let display = registry.display(dpy)?;
    registry.surface(display, surface)?;
    fail(Code::BadMatch, "surface was made with EGL_TEXTURE_FORMAT EGL_NO_TEXTURE")
}

/// `eglSwapBuffers`: a pbuffer has one buffer, and nothing is swapped.
pub(super) fn swap(dpy: Handle, surface: Handle) -> Result<u32> {
    let mut registry = registry();
    let display = registry.display(dpy)?;
    let (id, _) = registry.surface(display, surface)?;
    drop(registry);
    if thread(|thread| thread.binding.get()).and_then(|binding| binding.surface) != Some(id) {
        return fail(
            Code::BadSurface,
            "surface is not what the current context draws to: call eglMakeCurrent with it before",
        );
    }
    gl_api::with_current(|context| {
        context.flush();
        host::shows_picture(context);
    });
    Ok(1)
}

/// `eglCopyBuffers`: there is nothing to copy to.
pub(super) fn copy(dpy: Handle, surface: Handle) -> Result<u32> {
    let mut registry = registry();
    let display = registry.display(dpy)?;
    registry.surface(display, surface)?;
    fail(Code::BadNativePixmap, "target is no pixmap: DetGL has none")
}

/// `eglCreateWindowSurface` and its kin.
pub(super) fn refused(dpy: Handle, config: Handle, code: Code, what: &str) -> Result<Handle> {
    registry().display(dpy)?;
    Config::find(config)?;
    fail(code, format!("DetGL draws into memory: no {what}, use eglCreatePbufferSurface"))
}
