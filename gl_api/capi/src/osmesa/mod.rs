//! OSMesa: a context that draws into the memory of its client.
//!
//! Handles and what is current are EGL's ([`super::egl`]): an OSMesa context is one of a display
//! that EGL does not know, with a surface of its own. The client's memory is a copy of the surface,
//! made at `glFlush`, `glFinish` and when the context stops being current ([`mirror`]). Memory that
//! another replaces, or whose context is destroyed, is not touched any more.

mod functions;
mod mirror;

pub(crate) use functions::FUNCTIONS;

use super::egl::raw::{Id, handle};
use super::egl::registry::{ContextEntry, OSMESA, Settings, SurfaceEntry, registry};
use super::egl::thread::{Binding, thread};
use super::egl::{self, current};
use gl_api::constants::*;
use gl_api::host::{self, Alpha, DebugOutput, FirstRow, Pixels, Surface, limits};
use gl_api::{Api, ContextDesc, SurfaceColor, SurfaceDesc, with_current};
use gl_api::{GLenum, GLint};
use mirror::Mirror;
use std::collections::BTreeMap;
use std::ffi::c_void;
use std::sync::{Mutex, MutexGuard, PoisonError};

const OSMESA_RGB: GLenum = GL_RGB;
const OSMESA_RGBA: GLenum = GL_RGBA;
const OSMESA_BGRA: GLenum = 1;
const OSMESA_ARGB: GLenum = 2;
const OSMESA_BGR: GLenum = 4;
const OSMESA_RGB_565: GLenum = 5;
const OSMESA_ROW_LENGTH: GLint = 0x10;
const OSMESA_Y_UP: GLint = 0x11;
const OSMESA_WIDTH: GLint = 0x20;
const OSMESA_HEIGHT: GLint = 0x21;
const OSMESA_FORMAT: GLint = 0x22;
const OSMESA_TYPE: GLint = 0x23;
const OSMESA_MAX_WIDTH: GLint = 0x24;
const OSMESA_MAX_HEIGHT: GLint = 0x25;
const OSMESA_DEPTH_BITS: GLint = 0x30;
const OSMESA_STENCIL_BITS: GLint = 0x31;
const OSMESA_ACCUM_BITS: GLint = 0x32;
const OSMESA_PROFILE: GLint = 0x33;
const OSMESA_CORE_PROFILE: GLint = 0x34;
const OSMESA_COMPAT_PROFILE: GLint = 0x35;
const OSMESA_CONTEXT_MAJOR_VERSION: GLint = 0x36;
const OSMESA_CONTEXT_MINOR_VERSION: GLint = 0x37;

/// What a context was made with.
#[derive(Clone, Copy, Debug)]
struct Request {
    api: Api,
    format: GLenum,
    depth: u8,
    stencil: u8,
}

/// The client's memory, as `OSMesaMakeCurrent` was given it.
#[derive(Clone, Copy, Debug)]
struct Target {
    /// The address of its first byte.
    memory: usize,
    ty: GLenum,
    width: u32,
    height: u32,
}

/// What OSMesa knows of a context beyond EGL's registry.
#[derive(Debug)]
struct Entry {
    request: Request,
    target: Option<Target>,
    surface: Option<Id>,
    row_length: usize,
    first: FirstRow,
    /// What `OSMesaGetDepthBuffer` gave last.
    depths: Vec<u32>,
}

impl Entry {
    /// Takes note of what is drawn to; how rows lie in it.
    fn draw_to(&mut self, target: Target, surface: Id) -> (usize, FirstRow) {
        (self.target, self.surface) = (Some(target), Some(surface));
        (self.row_length, self.first)
    }

    /// The copy of what is drawn to; `None` before there is memory for it.
    fn mirror(&self) -> Option<Mirror> {
        let target = self.target?;
        let pixels = pixels(self.request.format, target.ty)?;
        Some(Mirror {
            memory: target.memory,
            pixels,
            row_length: self.row_length,
            first: self.first,
        })
    }
}

static ENTRIES: Mutex<BTreeMap<Id, Entry>> = Mutex::new(BTreeMap::new());

/// Locks what OSMesa knows. Nothing is drawn, and the registry is not locked, while it is.
fn entries() -> MutexGuard<'static, BTreeMap<Id, Entry>> {
    ENTRIES.lock().unwrap_or_else(PoisonError::into_inner)
}

/// How a format and type lie in memory; `None` for those that OSMesa does not have.
fn pixels(format: GLenum, ty: GLenum) -> Option<Pixels> {
    let plain = |gl: GLenum| {
        let known = [GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT].contains(&ty);
        known.then_some(Pixels { gl: (gl, ty), alpha: Alpha::AsFormat })
    };
    match format {
        OSMESA_RGBA => plain(GL_RGBA),
        OSMESA_BGRA => plain(GL_BGRA),
        OSMESA_RGB => plain(GL_RGB),
        OSMESA_BGR => plain(GL_BGR),
        OSMESA_ARGB if ty == GL_UNSIGNED_BYTE => {
            // Blue is the highest byte of a word, alpha the lowest.
            let bytes = if cfg!(target_endian = "little") {
                GL_UNSIGNED_INT_8_8_8_8
            } else {
                GL_UNSIGNED_INT_8_8_8_8_REV
            };
            Some(Pixels { gl: (GL_BGRA, bytes), alpha: Alpha::AsFormat })
        }
        OSMESA_ARGB => plain(GL_RGBA).map(|pixels| Pixels { alpha: Alpha::First, ..pixels }),
        OSMESA_RGB_565 if ty == GL_UNSIGNED_SHORT_5_6_5 => {
            Some(Pixels { gl: (GL_RGB, ty), alpha: Alpha::AsFormat })
        }
        _ => None,
    }
}

impl Request {
    /// The buffers that memory of this type is a copy of.
    fn surface(&self, ty: GLenum) -> SurfaceDesc {
        let color = match (self.format, ty) {
            (OSMESA_RGB_565, _) => SurfaceColor::Rgb565,
            (_, GL_FLOAT) => SurfaceColor::Rgba32F,
            (_, GL_UNSIGNED_SHORT) => SurfaceColor::Rgba16,
            (OSMESA_RGB | OSMESA_BGR, _) => SurfaceColor::Rgb8,
            (_, _) => SurfaceColor::Rgba8,
        };
        SurfaceDesc { color, depth_bits: self.depth, stencil_bits: self.stencil, samples: 0 }
    }
}

/// The handle of a new context, or null.
fn create(request: Request, share: Id) -> *mut c_void {
    let known = pixels(request.format, GL_UNSIGNED_BYTE).is_some();
    if !known && request.format != OSMESA_RGB_565 {
        return std::ptr::null_mut();
    }
    let desc = ContextDesc { api: request.api, width: 1, height: 1, ..ContextDesc::default() };
    let shared = match share {
        0 => None,
        share => match egl::shared_by(
            OSMESA,
            egl::thread::Api::OpenGl,
            handle(share),
            desc.reset_notification,
        ) {
            Ok(shared) => Some(shared),
            Err(_) => return std::ptr::null_mut(),
        },
    };
    let Ok(context) = host::new_context(desc, shared, DebugOutput::Off) else {
        return std::ptr::null_mut();
    };
    let id = {
        let mut registry = registry();
        let id = registry.new_id();
        registry
            .contexts
            .insert(id, ContextEntry::new(OSMESA, egl::thread::Api::OpenGl, None, context));
        id
    };
    let entry = Entry {
        request,
        target: None,
        surface: None,
        row_length: 0,
        first: FirstRow::Bottom,
        depths: Vec::new(),
    };
    entries().insert(id, entry);
    handle(id)
}

/// The attributes of `OSMesaCreateContextAttribs`; `None` where they ask for what there is not.
fn attributes(pairs: &[(GLint, GLint)]) -> Option<Request> {
    let mut request =
        Request { api: Api::Compatibility, format: OSMESA_RGBA, depth: 0, stencil: 0 };
    let (mut version, mut profile) = ((1, 0), OSMESA_COMPAT_PROFILE);
    for &(name, value) in pairs {
        match name {
            OSMESA_FORMAT => request.format = value as GLenum,
            OSMESA_DEPTH_BITS => request.depth = bits(value, 32)?,
            OSMESA_STENCIL_BITS => request.stencil = bits(value, 8)?,
            OSMESA_ACCUM_BITS if value >= 0 => {}
            OSMESA_PROFILE => profile = value,
            OSMESA_CONTEXT_MAJOR_VERSION => version.0 = value,
            OSMESA_CONTEXT_MINOR_VERSION => version.1 = value,
            _ => return None,
        }
    }
    request.api = match profile {
        OSMESA_COMPAT_PROFILE => Api::Compatibility,
        // Before 3.2 there are no profiles.
        OSMESA_CORE_PROFILE if version < (3, 2) => Api::Compatibility,
        OSMESA_CORE_PROFILE => Api::Core,
        _ => return None,
    };
    let most = limits::version();
    (version <= (most.major.into(), most.minor.into())).then_some(request)
}

/// Bits of depth or stencil, as many as there can be.
fn bits(value: GLint, most: u8) -> Option<u8> {
    Some(u8::try_from(value.max(0).min(most.into())).unwrap_or(most)).filter(|_| value >= 0)
}

fn destroy(id: Id) {
    if current_id() == Some(id) {
        forget_memory();
        release();
    }
    let Some(entry) = entries().remove(&id) else { return };
    let mut registry = registry();
    registry.doom_context(id);
    if let Some(surface) = entry.surface {
        registry.doom_surface(surface);
    }
}

/// The context that is current on this thread, if it is OSMesa's.
fn current_id() -> Option<Id> {
    let binding = thread(|thread| thread.binding.get());
    binding.filter(|binding| binding.display == OSMESA).map(|binding| binding.context)
}

/// Lets go of the current context's memory, which the client may have freed.
fn forget_memory() {
    with_current(|context| host::set_mirror(context, None));
}

/// Ends being current, with the picture in the client's memory.
fn release() {
    if current_id().is_some_and(|id| !entries().contains_key(&id)) {
        // Another thread has destroyed it.
        forget_memory();
    }
    thread(current::release);
}

/// Makes a context draw to the client's memory; whether that is possible.
fn make_current(id: Id, target: Target) -> bool {
    let found = entries().get(&id).map(|entry| (entry.request, entry.target, entry.surface));
    let Some((request, old, used)) = found else { return false };
    let Some(pixels) = pixels(request.format, target.ty) else { return false };
    let limit = limits::MAX_VIEWPORT_DIMS;
    if !(1..=limit).contains(&target.width) || !(1..=limit).contains(&target.height) {
        return false;
    }
    let same = old.is_some_and(|old| {
        (old.ty, old.width, old.height) == (target.ty, target.width, target.height)
    });
    let surface = match used.filter(|_| same) {
        Some(surface) => surface,
        None => match new_surface(request, target) {
            Some(surface) => surface,
            None => return false,
        },
    };
    if current_id() == Some(id) && !(same && old.map(|old| old.memory) == Some(target.memory)) {
        // The picture goes on in the new memory.
        forget_memory();
    }
    release();
    let binding = Binding { display: OSMESA, context: id, surface: Some(surface), read: None };
    let bound = thread(|thread| current::bind(thread, binding)).is_ok();
    let stored = if bound {
        entries().get_mut(&id).map(|entry| entry.draw_to(target, surface))
    } else {
        None
    };
    let Some((row_length, first)) = stored else {
        // Current on another thread, or destroyed by one.
        if used != Some(surface) {
            registry().doom_surface(surface);
        }
        return false;
    };
    if let Some(used) = used.filter(|&used| used != surface) {
        registry().doom_surface(used);
    }
    let mirror = Box::new(Mirror { memory: target.memory, pixels, row_length, first });
    with_current(|context| host::set_mirror(context, Some(mirror))).is_some()
}

/// Buffers for a client's memory.
fn new_surface(request: Request, target: Target) -> Option<Id> {
    let Target { ty, width, height, .. } = target;
    let buffers = Surface::new(width, height, request.surface(ty))?;
    let mut registry = registry();
    let surface = registry.new_id();
    let entry = SurfaceEntry {
        display: OSMESA,
        config: None,
        width,
        height,
        largest: false,
        settings: Settings::default(),
        buffers: Some(buffers),
        thread: None,
        doomed: false,
    };
    registry.surfaces.insert(surface, entry);
    Some(surface)
}

/// `OSMesaPixelStore` on the current context.
fn pixel_store(name: GLint, value: GLint) {
    let Some(id) = current_id() else { return };
    let mut entries = entries();
    let Some(entry) = entries.get_mut(&id) else { return };
    match name {
        OSMESA_ROW_LENGTH => entry.row_length = usize::try_from(value).unwrap_or(0),
        OSMESA_Y_UP => entry.first = if value != 0 { FirstRow::Bottom } else { FirstRow::Top },
        _ => return,
    }
    let Some(mirror) = entry.mirror() else { return };
    with_current(|context| host::replace_mirror(context, Box::new(mirror)));
}

/// `OSMesaColorClamp` on the current context: when colours of fragments are clamped.
fn color_clamp(clamp: GLenum) {
    with_current(|context| context.clamp_color(GL_CLAMP_FRAGMENT_COLOR, clamp));
}

/// `OSMesaGetIntegerv` on the current context.
fn get(name: GLint) -> Option<GLint> {
    let entries = entries();
    let entry = entries.get(&current_id()?)?;
    let target = entry.target?;
    Some(match name {
        OSMESA_WIDTH => target.width as GLint,
        OSMESA_HEIGHT => target.height as GLint,
        OSMESA_FORMAT => entry.request.format as GLint,
        OSMESA_TYPE => target.ty as GLint,
        OSMESA_ROW_LENGTH => entry.row_length as GLint,
        OSMESA_Y_UP => GLint::from(entry.first == FirstRow::Bottom),
        OSMESA_MAX_WIDTH | OSMESA_MAX_HEIGHT => limits::MAX_VIEWPORT_DIMS as GLint,
        _ => return None,
    })
}

/// Width, height, bytes of a value, and the values of the depth buffer of a context that is current
/// here.
fn depths(id: Id) -> Option<(GLint, GLint, GLint, *mut c_void)> {
    if current_id() != Some(id) {
        return None;
    }
    let (depth, first) = entries().get(&id).map(|entry| (entry.request.depth, entry.first))?;
    let bits = match depth {
        0 => return None,
        1..=16 => 16,
        17..=24 => 24,
        _ => 32,
    };
    let depths = with_current(|context| {
        context.flush();
        host::depths(context, first, bits)
    });
    let mut depths = depths??;
    let bytes = if bits == 16 {
        // Two to a word, so that the memory stays aligned and the context's own.
        depths = depths.chunks(2).map(|pair| pair[0] | pair.get(1).unwrap_or(&0) << 16).collect();
        2
    } else {
        4
    };
    let mut entries = entries();
    let entry = entries.get_mut(&id)?;
    let target = entry.target?;
    entry.depths = depths;
    let size = (target.width as GLint, target.height as GLint);
    Some((size.0, size.1, bytes, entry.depths.as_mut_ptr().cast()))
}
