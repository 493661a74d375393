//! GLX 1.4 as programs need it that are linked with libGL but draw without windows: its names, of
//! which all but `glXGetProcAddress` say that there is nothing.

use std::ffi::{c_int, c_void};

/// Functions that answer 0: `False`, `None` or a null pointer. They read no argument.
macro_rules! nothing {
    ($($name:ident)*) => { $(
        #[unsafe(no_mangle)]
        #[allow(non_snake_case, reason = "GLX's name")]
        extern "C" fn $name() -> *const c_void {
            std::ptr::null()
        }
    )* };
}

/// Functions that answer an error: `GLX_BAD_SCREEN`. They read no argument.
macro_rules! errors {
    ($($name:ident)*) => { $(
        #[unsafe(no_mangle)]
        #[allow(non_snake_case, reason = "GLX's name")]
        extern "C" fn $name() -> c_int {
            1
        }
    )* };
}

nothing! {
    glXChooseFBConfig glXChooseVisual glXCopyContext glXCreateContext glXCreateContextAttribsARB
    glXCreateGLXPixmap glXCreateNewContext glXCreatePbuffer glXCreatePixmap glXCreateWindow
    glXDestroyContext glXDestroyGLXPixmap glXDestroyPbuffer glXDestroyPixmap glXDestroyWindow
    glXGetClientString glXGetCurrentContext glXGetCurrentDisplay glXGetCurrentDrawable
    glXGetCurrentReadDrawable glXGetFBConfigs glXGetSelectedEvent glXGetVisualFromFBConfig
    glXIsDirect glXMakeContextCurrent glXMakeCurrent glXQueryDrawable glXQueryExtension
    glXQueryExtensionsString glXQueryServerString glXQueryVersion glXSelectEvent glXSwapBuffers
    glXUseXFont glXWaitGL glXWaitX
}

errors! { glXGetConfig glXGetFBConfigAttrib glXQueryContext }
