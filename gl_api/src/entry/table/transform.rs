//! Coordinate transformations: GL 2.1, section 2.11.

use crate::base::types::*;
use crate::calls::transform::{matrix, viewport};

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_transform {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Setter in matrix {
        /// Selects the stack that matrix calls work on.
        matrix_mode: glMatrixMode (mode: GLenum);
        /// Replaces the current matrix by the identity.
        load_identity: glLoadIdentity ();
        /// Replaces the current matrix by 16 numbers, column by column.
        load_matrixf: glLoadMatrixf (m: &'a [GLfloat]);
        /// Replaces the current matrix by 16 numbers, column by column.
        load_matrixd: glLoadMatrixd (m: &'a [GLdouble]);
        /// Replaces the current matrix by 16 numbers, row by row.
        load_transpose_matrixf: glLoadTransposeMatrixf | glLoadTransposeMatrixfARB (m: &'a [GLfloat]);
        /// Replaces the current matrix by 16 numbers, row by row.
        load_transpose_matrixd: glLoadTransposeMatrixd | glLoadTransposeMatrixdARB (m: &'a [GLdouble]);
        /// Multiplies the current matrix by 16 numbers, column by column.
        mult_matrixf: glMultMatrixf (m: &'a [GLfloat]);
        /// Multiplies the current matrix by 16 numbers, column by column.
        mult_matrixd: glMultMatrixd (m: &'a [GLdouble]);
        /// Multiplies the current matrix by 16 numbers, row by row.
        mult_transpose_matrixf: glMultTransposeMatrixf | glMultTransposeMatrixfARB (m: &'a [GLfloat]);
        /// Multiplies the current matrix by 16 numbers, row by row.
        mult_transpose_matrixd: glMultTransposeMatrixd | glMultTransposeMatrixdARB (m: &'a [GLdouble]);
        /// Copies the current matrix to the top of its stack.
        push_matrix: glPushMatrix ();
        /// Goes back to the matrix of the last push.
        pop_matrix: glPopMatrix ();
        /// Turns by an angle in degrees about an axis.
        rotatef: glRotatef (angle: GLfloat, x: GLfloat, y: GLfloat, z: GLfloat);
        /// Turns by an angle in degrees about an axis.
        rotated: glRotated (angle: GLdouble, x: GLdouble, y: GLdouble, z: GLdouble);
        /// Moves.
        translatef: glTranslatef (x: GLfloat, y: GLfloat, z: GLfloat);
        /// Moves.
        translated: glTranslated (x: GLdouble, y: GLdouble, z: GLdouble);
        /// Stretches.
        scalef: glScalef (x: GLfloat, y: GLfloat, z: GLfloat);
        /// Stretches.
        scaled: glScaled (x: GLdouble, y: GLdouble, z: GLdouble);
        /// Multiplies by a perspective projection.
        frustum: glFrustum (
            left: GLdouble, right: GLdouble, bottom: GLdouble, top: GLdouble, near: GLdouble,
            far: GLdouble
        );
        /// Multiplies by a parallel projection.
        ortho: glOrtho (
            left: GLdouble, right: GLdouble, bottom: GLdouble, top: GLdouble, near: GLdouble,
            far: GLdouble
        );
    }
    Setter in viewport {
        /// Sets where in the window normalized device coordinates lie.
        viewport: glViewport (x: GLint, y: GLint, width: GLsizei, height: GLsizei);
        /// Sets the window depth of the near and far planes.
        depth_range: glDepthRange (near: GLclampd, far: GLclampd);
        /// Sets the window depth of the near and far planes.
        depth_rangef: glDepthRangef (near: GLclampf, far: GLclampf);
    }
    Refused in viewport {
        /// Sets where y = -w is in the viewport, and the depths between the near and the far plane.
        clip_control: glClipControl | glClipControlEXT (origin: GLenum, depth: GLenum);
    }
    } };
}
entry_points_transform!(implement);
