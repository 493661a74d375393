//! The imaging subset of GL 1.2, which is optional and not there: its names.
//!
//! libGL and libOpenGL have them by Linux's ABI for OpenGL, and a program that mentions one does not
//! start without it, whether it calls it or not. No function by name (`eglGetProcAddress`) is any of
//! these.

use crate::guard::guard;
use gl_api::host;
use gl_api::with_current;

/// Functions that are refused. They read no argument and answer nothing.
macro_rules! absent {
    ($($name:ident)*) => { $(
        #[unsafe(no_mangle)]
        #[allow(non_snake_case, reason = "GL's name")]
        extern "C" fn $name() {
            refuse(stringify!($name));
        }
    )* };
}

absent! {
    glColorSubTable glColorTable glColorTableParameterfv glColorTableParameteriv
    glConvolutionFilter1D glConvolutionFilter2D glConvolutionParameterf glConvolutionParameterfv
    glConvolutionParameteri glConvolutionParameteriv glCopyColorSubTable glCopyColorTable
    glCopyConvolutionFilter1D glCopyConvolutionFilter2D glGetColorTable
    glGetColorTableParameterfv glGetColorTableParameteriv glGetConvolutionFilter
    glGetConvolutionParameterfv glGetConvolutionParameteriv glGetHistogram
    glGetHistogramParameterfv glGetHistogramParameteriv glGetMinmax glGetMinmaxParameterfv
    glGetMinmaxParameteriv glGetSeparableFilter glHistogram glMinmax glResetHistogram
    glResetMinmax glSeparableFilter2D
}

#[cold]
#[inline(never)]
fn refuse(name: &'static str) {
    guard(name, || {
        with_current(|context| {
            host::refuse(
                context,
                name,
                "GL 2.1, section 3.6.2",
                "the imaging subset is optional, and DetGL does not have it: ask \
                 glGetString(GL_EXTENSIONS) for GL_ARB_imaging before",
            );
        });
    });
}
