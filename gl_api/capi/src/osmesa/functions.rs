//! OSMesa's functions under their C names.

use super::{
    Request, Target, attributes, bits, color_clamp, create, current_id, depths, destroy, entries,
    get, make_current, pixel_store, release,
};
use crate::egl::raw::handle;
use crate::guard::c_functions;
use gl_api::constants::{GL_FIXED_ONLY, GL_TRUE};
use gl_api::{Api, GLboolean, GLenum, GLint, GLsizei};
use std::ffi::{c_char, c_void};

/// Writes a result where the client wants one.
///
/// # Safety
/// A pointer that is not null can be written to.
unsafe fn put<T>(out: *mut T, value: T) {
    if !out.is_null() {
        // SAFETY: promised by the caller.
        unsafe { out.write_unaligned(value) };
    }
}

c_functions! {
    OSMesaCreateContext(format: GLenum, share: *mut c_void) -> *mut c_void {
        create(Request { api: Api::Compatibility, format, depth: 24, stencil: 8 }, share.addr())
    }

    OSMesaCreateContextExt(
        format: GLenum, depth: GLint, stencil: GLint, _accum: GLint, share: *mut c_void
    ) -> *mut c_void {
        match (bits(depth, 32), bits(stencil, 8)) {
            (Some(depth), Some(stencil)) => {
                create(Request { api: Api::Compatibility, format, depth, stencil }, share.addr())
            }
            (_, _) => std::ptr::null_mut(),
        }
    }

    OSMesaCreateContextAttribs(list: *const GLint, share: *mut c_void) -> *mut c_void {
        let mut pairs = Vec::new();
        let mut at = list;
        while !at.is_null() && at.read_unaligned() != 0 {
            pairs.push((at.read_unaligned(), at.add(1).read_unaligned()));
            at = at.add(2);
        }
        match attributes(&pairs) {
            Some(request) => create(request, share.addr()),
            None => std::ptr::null_mut(),
        }
    }

    OSMesaDestroyContext(context: *mut c_void) {
        destroy(context.addr());
    }

    OSMesaMakeCurrent(
        context: *mut c_void, buffer: *mut c_void, ty: GLenum, width: GLsizei, height: GLsizei
    ) -> GLboolean {
        if context.is_null() {
            release();
            return u8::from(buffer.is_null() && width == 0 && height == 0);
        }
        let size = (u32::try_from(width), u32::try_from(height));
        let (Ok(width), Ok(height), false) = (size.0, size.1, buffer.is_null()) else { return 0 };
        // The client's until another replaces it, as OSMesa says.
        let memory = buffer.expose_provenance();
        make_current(context.addr(), Target { memory, ty, width, height }).into()
    }

    OSMesaGetCurrentContext() -> *mut c_void {
        handle(current_id().unwrap_or(0))
    }

    OSMesaPixelStore(name: GLint, value: GLint) {
        pixel_store(name, value);
    }

    OSMesaGetIntegerv(name: GLint, value: *mut GLint) {
        if let Some(found) = get(name) {
            put(value, found);
        }
    }

    OSMesaGetDepthBuffer(
        context: *mut c_void, width: *mut GLint, height: *mut GLint, bytes: *mut GLint,
        buffer: *mut *mut c_void
    ) -> GLboolean {
        let found = depths(context.addr());
        let (w, h, size, memory) = found.unwrap_or((0, 0, 0, std::ptr::null_mut()));
        put(width, w);
        put(height, h);
        put(bytes, size);
        put(buffer, memory);
        found.is_some().into()
    }

    OSMesaGetColorBuffer(
        context: *mut c_void, width: *mut GLint, height: *mut GLint, format: *mut GLint,
        buffer: *mut *mut c_void
    ) -> GLboolean {
        let entries = entries();
        let found = entries.get(&context.addr()).and_then(|entry| Some((entry, entry.target?)));
        let (w, h, layout, memory) = match found {
            Some((entry, target)) => {
                (target.width, target.height, entry.request.format, target.memory)
            }
            None => (0, 0, 0, 0),
        };
        put(width, w as GLint);
        put(height, h as GLint);
        put(format, layout as GLint);
        put(buffer, std::ptr::with_exposed_provenance_mut(memory));
        found.is_some().into()
    }

    OSMesaColorClamp(enable: GLboolean) {
        color_clamp(if enable != 0 { GL_TRUE } else { GL_FIXED_ONLY });
    }

    // There are no filters.
    OSMesaPostprocess(_context: *mut c_void, _filter: *const c_char, _value: u32) {}
}
