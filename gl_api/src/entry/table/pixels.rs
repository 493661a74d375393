//! Pixel rectangles: GL 2.1, sections 3.6.1 and 4.3.2.

use crate::base::args::{Data, DataOut};
use crate::base::types::*;
use crate::calls::framebuffer::read;
use crate::calls::pixels::{map as pixel_map, store as pixel_store, transfer};

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_pixels {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in pixel_store {
        /// Sets how pixels lie in the client's memory.
        pixel_storei: glPixelStorei (pname: GLenum, param: GLint), not_compiled;
        /// Sets how pixels lie in the client's memory.
        pixel_storef: glPixelStoref (pname: GLenum, param: GLfloat), not_compiled;
    }
    Refused in transfer {
        /// Sets the scale or bias of a component of every pixel on its way in or out.
        pixel_transferf: glPixelTransferf (pname: GLenum, param: GLfloat);
        /// Sets the scale or bias of a component of every pixel on its way in or out.
        pixel_transferi: glPixelTransferi (pname: GLenum, param: GLint);
    }
    Refused in pixel_map {
        /// Sets a look-up table of pixel transfer.
        pixel_mapfv: glPixelMapfv (map: GLenum, mapsize: GLsizei, values: Data<'a>);
        /// Sets a look-up table of pixel transfer; of colours, the largest number is 1.
        pixel_mapuiv: glPixelMapuiv (map: GLenum, mapsize: GLsizei, values: Data<'a>);
        /// Sets a look-up table of pixel transfer; of colours, the largest number is 1.
        pixel_mapusv: glPixelMapusv (map: GLenum, mapsize: GLsizei, values: Data<'a>);
        /// Reads a look-up table.
        get_pixel_mapfv: glGetPixelMapfv (map: GLenum, values: DataOut<'a>);
        /// Reads a look-up table; of colours, 1 as the largest number.
        get_pixel_mapuiv: glGetPixelMapuiv (map: GLenum, values: DataOut<'a>);
        /// Reads a look-up table; of colours, 1 as the largest number.
        get_pixel_mapusv: glGetPixelMapusv (map: GLenum, values: DataOut<'a>);
    }
    Refused in read {
        /// Reads a rectangle of the read framebuffer; row 0 is the lowest.
        read_pixels: glReadPixels (
            x: GLint, y: GLint, width: GLsizei, height: GLsizei, format: GLenum, ty: GLenum,
            pixels: DataOut<'a>
        );
    }
    } };
}
entry_points_pixels!(implement);
