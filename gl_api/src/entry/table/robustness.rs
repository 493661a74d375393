//! Graphics resets, and reads whose destination has a size: `KHR_robustness`,
//! `EXT_robustness`.

use crate::base::args::DataOut;
use crate::base::types::*;
use crate::calls::robustness;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_robustness {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in robustness {
        /// Whether a draw was stopped since the last call (`ContextDesc::reset_notification`).
        get_graphics_reset_status: glGetGraphicsResetStatus | glGetGraphicsResetStatusKHR | glGetGraphicsResetStatusEXT () -> GLenum;
        /// Reads a rectangle of the read framebuffer into at most so many bytes; row 0 is the lowest.
        readn_pixels: glReadnPixels | glReadnPixelsKHR | glReadnPixelsEXT (
            x: GLint, y: GLint, width: GLsizei, height: GLsizei, format: GLenum, ty: GLenum,
            buf_size: GLsizei, data: DataOut<'a>
        );
        /// Reads a uniform into at most so many bytes.
        getn_uniformfv: glGetnUniformfv | glGetnUniformfvKHR | glGetnUniformfvEXT
            (program: GLuint, location: GLint, buf_size: GLsizei, params: &'a mut [GLfloat]);
        /// Reads a uniform into at most so many bytes.
        getn_uniformiv: glGetnUniformiv | glGetnUniformivKHR | glGetnUniformivEXT
            (program: GLuint, location: GLint, buf_size: GLsizei, params: &'a mut [GLint]);
        /// Reads a uniform into at most so many bytes.
        getn_uniformuiv: glGetnUniformuiv | glGetnUniformuivKHR
            (program: GLuint, location: GLint, buf_size: GLsizei, params: &'a mut [GLuint]);
    }
    } };
}
entry_points_robustness!(implement);
