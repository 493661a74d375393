//! Special functions: GL 2.1, chapter 5. Display lists are in [`super::lists`].

use crate::base::args::DataOut;
use crate::base::types::*;
use crate::calls::evaluate::{coord, grid, map};
use crate::record::render_mode as modes;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_special {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in map {
        /// Sets a map of one parameter by its control points.
        map1f: glMap1f (
            target: GLenum, u1: GLfloat, u2: GLfloat, stride: GLint, order: GLint,
            points: &'a [GLfloat]
        );
        /// Sets a map of one parameter by its control points.
        map1d: glMap1d (
            target: GLenum, u1: GLdouble, u2: GLdouble, stride: GLint, order: GLint,
            points: &'a [GLdouble]
        );
        /// Sets a map of two parameters by its control points.
        map2f: glMap2f (
            target: GLenum, u1: GLfloat, u2: GLfloat, ustride: GLint, uorder: GLint,
            v1: GLfloat, v2: GLfloat, vstride: GLint, vorder: GLint, points: &'a [GLfloat]
        );
        /// Sets a map of two parameters by its control points.
        map2d: glMap2d (
            target: GLenum, u1: GLdouble, u2: GLdouble, ustride: GLint, uorder: GLint,
            v1: GLdouble, v2: GLdouble, vstride: GLint, vorder: GLint, points: &'a [GLdouble]
        );
        /// Reads a map.
        get_mapfv: glGetMapfv (target: GLenum, query: GLenum, v: DataOut<'a>);
        /// Reads a map.
        get_mapdv: glGetMapdv (target: GLenum, query: GLenum, v: DataOut<'a>);
        /// Reads a map.
        get_mapiv: glGetMapiv (target: GLenum, query: GLenum, v: DataOut<'a>);
    }
    Allowed in coord {
        /// Evaluates the maps of one parameter that are on: a vertex and its attributes.
        eval_coord1f: glEvalCoord1f (u: GLfloat);
        /// Evaluates the maps of one parameter that are on: a vertex and its attributes.
        eval_coord1d: glEvalCoord1d (u: GLdouble);
        /// Evaluates the maps of one parameter that are on: a vertex and its attributes.
        eval_coord1fv: glEvalCoord1fv (u: &'a [GLfloat]);
        /// Evaluates the maps of one parameter that are on: a vertex and its attributes.
        eval_coord1dv: glEvalCoord1dv (u: &'a [GLdouble]);
        /// Evaluates the maps of two parameters that are on: a vertex and its attributes.
        eval_coord2f: glEvalCoord2f (u: GLfloat, v: GLfloat);
        /// Evaluates the maps of two parameters that are on: a vertex and its attributes.
        eval_coord2d: glEvalCoord2d (u: GLdouble, v: GLdouble);
        /// Evaluates the maps of two parameters that are on: a vertex and its attributes.
        eval_coord2fv: glEvalCoord2fv (u: &'a [GLfloat]);
        /// Evaluates the maps of two parameters that are on: a vertex and its attributes.
        eval_coord2dv: glEvalCoord2dv (u: &'a [GLdouble]);
    }
    Allowed in grid {
        /// Evaluates the maps at a point of the grid.
        eval_point1: glEvalPoint1 (i: GLint);
        /// Evaluates the maps at a point of the grid.
        eval_point2: glEvalPoint2 (i: GLint, j: GLint);
    }
    Refused in grid {
        /// Sets the grid of one parameter.
        map_grid1f: glMapGrid1f (un: GLint, u1: GLfloat, u2: GLfloat);
        /// Sets the grid of one parameter.
        map_grid1d: glMapGrid1d (un: GLint, u1: GLdouble, u2: GLdouble);
        /// Sets the grid of two parameters.
        map_grid2f: glMapGrid2f (
            un: GLint, u1: GLfloat, u2: GLfloat, vn: GLint, v1: GLfloat, v2: GLfloat
        );
        /// Sets the grid of two parameters.
        map_grid2d: glMapGrid2d (
            un: GLint, u1: GLdouble, u2: GLdouble, vn: GLint, v1: GLdouble, v2: GLdouble
        );
        /// Draws a part of the grid as points or lines.
        eval_mesh1: glEvalMesh1 (mode: GLenum, i1: GLint, i2: GLint);
        /// Draws a part of the grid as points, lines or quads.
        eval_mesh2: glEvalMesh2 (mode: GLenum, i1: GLint, i2: GLint, j1: GLint, j2: GLint);
    }
    Refused in modes {
        /// Begins to draw, select or feed back, and says what the mode before gathered.
        render_mode: glRenderMode (mode: GLenum) -> GLint;
        /// Says where selection writes its hits: in a C program's memory, or with `NULL` to
        /// [`Context::selection`](crate::Context::selection).
        select_buffer: glSelectBuffer (size: GLsizei, buffer: DataOut<'a>), not_compiled;
        /// Says where feedback writes its numbers: in a C program's memory, or with `NULL` to
        /// [`Context::feedback`](crate::Context::feedback).
        feedback_buffer: glFeedbackBuffer (size: GLsizei, ty: GLenum, buffer: DataOut<'a>), not_compiled;
        /// Writes a number of the client's among those of feedback.
        pass_through: glPassThrough (token: GLfloat);
        /// Empties the stack of names.
        init_names: glInitNames ();
        /// Puts a name in the place of the one on top.
        load_name: glLoadName (name: GLuint);
        /// Puts a name on the stack.
        push_name: glPushName (name: GLuint);
        /// Takes a name from the stack.
        pop_name: glPopName ();
    }
    } };
}
entry_points_special!(implement);
