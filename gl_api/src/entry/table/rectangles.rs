//! Pixel rectangles as fragments: GL 2.1, sections 2.13, 3.6.4, 3.7 and 4.3.3.

use crate::base::args::Data;
use crate::base::types::*;
use crate::calls::pixels::{bitmap, copy, draw, position, zoom};

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_rectangles {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in position {
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_2s: glRasterPos2s (x: GLshort, y: GLshort);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_2sv: glRasterPos2sv (v: &'a [GLshort]);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_2i: glRasterPos2i (x: GLint, y: GLint);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_2iv: glRasterPos2iv (v: &'a [GLint]);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_2f: glRasterPos2f (x: GLfloat, y: GLfloat);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_2fv: glRasterPos2fv (v: &'a [GLfloat]);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_2d: glRasterPos2d (x: GLdouble, y: GLdouble);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_2dv: glRasterPos2dv (v: &'a [GLdouble]);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_3s: glRasterPos3s (x: GLshort, y: GLshort, z: GLshort);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_3sv: glRasterPos3sv (v: &'a [GLshort]);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_3i: glRasterPos3i (x: GLint, y: GLint, z: GLint);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_3iv: glRasterPos3iv (v: &'a [GLint]);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_3f: glRasterPos3f (x: GLfloat, y: GLfloat, z: GLfloat);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_3fv: glRasterPos3fv (v: &'a [GLfloat]);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_3d: glRasterPos3d (x: GLdouble, y: GLdouble, z: GLdouble);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_3dv: glRasterPos3dv (v: &'a [GLdouble]);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_4s: glRasterPos4s (x: GLshort, y: GLshort, z: GLshort, w: GLshort);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_4sv: glRasterPos4sv (v: &'a [GLshort]);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_4i: glRasterPos4i (x: GLint, y: GLint, z: GLint, w: GLint);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_4iv: glRasterPos4iv (v: &'a [GLint]);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_4f: glRasterPos4f (x: GLfloat, y: GLfloat, z: GLfloat, w: GLfloat);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_4fv: glRasterPos4fv (v: &'a [GLfloat]);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_4d: glRasterPos4d (x: GLdouble, y: GLdouble, z: GLdouble, w: GLdouble);
        /// Sets the raster position: a vertex through the vertex stage.
        raster_pos_4dv: glRasterPos4dv (v: &'a [GLdouble]);
        /// Sets the raster position in window coordinates.
        window_pos_2s: glWindowPos2s | glWindowPos2sARB | glWindowPos2sMESA (x: GLshort, y: GLshort);
        /// Sets the raster position in window coordinates.
        window_pos_2sv: glWindowPos2sv | glWindowPos2svARB | glWindowPos2svMESA (v: &'a [GLshort]);
        /// Sets the raster position in window coordinates.
        window_pos_2i: glWindowPos2i | glWindowPos2iARB | glWindowPos2iMESA (x: GLint, y: GLint);
        /// Sets the raster position in window coordinates.
        window_pos_2iv: glWindowPos2iv | glWindowPos2ivARB | glWindowPos2ivMESA (v: &'a [GLint]);
        /// Sets the raster position in window coordinates.
        window_pos_2f: glWindowPos2f | glWindowPos2fARB | glWindowPos2fMESA (x: GLfloat, y: GLfloat);
        /// Sets the raster position in window coordinates.
        window_pos_2fv: glWindowPos2fv | glWindowPos2fvARB | glWindowPos2fvMESA (v: &'a [GLfloat]);
        /// Sets the raster position in window coordinates.
        window_pos_2d: glWindowPos2d | glWindowPos2dARB | glWindowPos2dMESA (x: GLdouble, y: GLdouble);
        /// Sets the raster position in window coordinates.
        window_pos_2dv: glWindowPos2dv | glWindowPos2dvARB | glWindowPos2dvMESA (v: &'a [GLdouble]);
        /// Sets the raster position in window coordinates.
        window_pos_3s: glWindowPos3s | glWindowPos3sARB | glWindowPos3sMESA
            (x: GLshort, y: GLshort, z: GLshort);
        /// Sets the raster position in window coordinates.
        window_pos_3sv: glWindowPos3sv | glWindowPos3svARB | glWindowPos3svMESA (v: &'a [GLshort]);
        /// Sets the raster position in window coordinates.
        window_pos_3i: glWindowPos3i | glWindowPos3iARB | glWindowPos3iMESA
            (x: GLint, y: GLint, z: GLint);
        /// Sets the raster position in window coordinates.
        window_pos_3iv: glWindowPos3iv | glWindowPos3ivARB | glWindowPos3ivMESA (v: &'a [GLint]);
        /// Sets the raster position in window coordinates.
        window_pos_3f: glWindowPos3f | glWindowPos3fARB | glWindowPos3fMESA
            (x: GLfloat, y: GLfloat, z: GLfloat);
        /// Sets the raster position in window coordinates.
        window_pos_3fv: glWindowPos3fv | glWindowPos3fvARB | glWindowPos3fvMESA (v: &'a [GLfloat]);
        /// Sets the raster position in window coordinates.
        window_pos_3d: glWindowPos3d | glWindowPos3dARB | glWindowPos3dMESA
            (x: GLdouble, y: GLdouble, z: GLdouble);
        /// Sets the raster position in window coordinates.
        window_pos_3dv: glWindowPos3dv | glWindowPos3dvARB | glWindowPos3dvMESA (v: &'a [GLdouble]);
        /// Sets the raster position in window coordinates, and its `w`.
        window_pos_4s: glWindowPos4sMESA (x: GLshort, y: GLshort, z: GLshort, w: GLshort);
        /// Sets the raster position in window coordinates, and its `w`.
        window_pos_4sv: glWindowPos4svMESA (v: &'a [GLshort]);
        /// Sets the raster position in window coordinates, and its `w`.
        window_pos_4i: glWindowPos4iMESA (x: GLint, y: GLint, z: GLint, w: GLint);
        /// Sets the raster position in window coordinates, and its `w`.
        window_pos_4iv: glWindowPos4ivMESA (v: &'a [GLint]);
        /// Sets the raster position in window coordinates, and its `w`.
        window_pos_4f: glWindowPos4fMESA (x: GLfloat, y: GLfloat, z: GLfloat, w: GLfloat);
        /// Sets the raster position in window coordinates, and its `w`.
        window_pos_4fv: glWindowPos4fvMESA (v: &'a [GLfloat]);
        /// Sets the raster position in window coordinates, and its `w`.
        window_pos_4d: glWindowPos4dMESA (x: GLdouble, y: GLdouble, z: GLdouble, w: GLdouble);
        /// Sets the raster position in window coordinates, and its `w`.
        window_pos_4dv: glWindowPos4dvMESA (v: &'a [GLdouble]);
    }
    Refused in zoom {
        /// Sets how many pixels of the window a pixel of a rectangle takes.
        pixel_zoom: glPixelZoom (xfactor: GLfloat, yfactor: GLfloat);
    }
    Refused in draw {
        /// Draws a rectangle of pixels at the raster position.
        draw_pixels: glDrawPixels
            (width: GLsizei, height: GLsizei, format: GLenum, ty: GLenum, pixels: Data<'a>);
    }
    Refused in copy {
        /// Draws a rectangle of the read framebuffer at the raster position.
        copy_pixels: glCopyPixels
            (x: GLint, y: GLint, width: GLsizei, height: GLsizei, ty: GLenum);
    }
    Refused in bitmap {
        /// Draws a fragment for each bit that is set, and moves the raster position.
        bitmap: glBitmap (
            width: GLsizei, height: GLsizei, xorig: GLfloat, yorig: GLfloat, xmove: GLfloat,
            ymove: GLfloat, bitmap: Data<'a>
        );
    }
    } };
}
entry_points_rectangles!(implement);
