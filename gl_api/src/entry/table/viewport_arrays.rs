//! Viewports by number: ARB_viewport_array.

use crate::base::types::*;
use crate::calls::transform::viewport_arrays;
use crate::query::indexed;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_viewport_arrays {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in viewport_arrays {
        /// Sets several viewports from a number on: x, y, width and height of each.
        viewport_arrayv: glViewportArrayv (first: GLuint, count: GLsizei, v: &'a [GLfloat]);
        /// Sets the viewport of a number.
        viewport_indexedf: glViewportIndexedf
            (index: GLuint, x: GLfloat, y: GLfloat, w: GLfloat, h: GLfloat);
        /// Sets the viewport of a number.
        viewport_indexedfv: glViewportIndexedfv (index: GLuint, v: &'a [GLfloat]);
        /// Sets the scissor rectangles of several viewports from a number on.
        scissor_arrayv: glScissorArrayv (first: GLuint, count: GLsizei, v: &'a [GLint]);
        /// Sets the scissor rectangle of a viewport.
        scissor_indexed: glScissorIndexed
            (index: GLuint, left: GLint, bottom: GLint, width: GLsizei, height: GLsizei);
        /// Sets the scissor rectangle of a viewport.
        scissor_indexedv: glScissorIndexedv (index: GLuint, v: &'a [GLint]);
        /// Sets the window depths of the near and far planes of several viewports from a number on.
        depth_range_arrayv: glDepthRangeArrayv (first: GLuint, count: GLsizei, v: &'a [GLdouble]);
        /// Sets the window depths of the near and far planes of a viewport.
        depth_range_indexed: glDepthRangeIndexed (index: GLuint, n: GLdouble, f: GLdouble);
    }
    Refused in indexed {
        /// Reads state with a number as floats.
        get_floati_v: glGetFloati_v (target: GLenum, index: GLuint, data: &'a mut [GLfloat]);
        /// Reads state with a number in double precision.
        get_doublei_v: glGetDoublei_v (target: GLenum, index: GLuint, data: &'a mut [GLdouble]);
    }
    } };
}
entry_points_viewport_arrays!(implement);
