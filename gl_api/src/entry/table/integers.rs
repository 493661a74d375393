//! Integers that reach shaders as they are: EXT_gpu_shader4, sections 2.7 and 6.1.

use crate::base::types::*;
use crate::calls::program::{integer_attributes, uniform_values};

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_integers {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in uniform_values {
        /// Reads a uniform.
        get_uniformuiv: glGetUniformuiv | glGetUniformuivEXT
            (program: GLuint, location: GLint, params: &'a mut [GLuint]);
    }
    Allowed in integer_attributes {
        /// Sets a generic attribute to an integer.
        vertex_attrib_i_1i: glVertexAttribI1i | glVertexAttribI1iEXT
            (index: GLuint, x: GLint), not_compiled;
        /// Sets a generic attribute to an integer of a slice.
        vertex_attrib_i_1iv: glVertexAttribI1iv | glVertexAttribI1ivEXT
            (index: GLuint, v: &'a [GLint]), not_compiled;
        /// Sets a generic attribute to an integer.
        vertex_attrib_i_1ui: glVertexAttribI1ui | glVertexAttribI1uiEXT
            (index: GLuint, x: GLuint), not_compiled;
        /// Sets a generic attribute to an integer of a slice.
        vertex_attrib_i_1uiv: glVertexAttribI1uiv | glVertexAttribI1uivEXT
            (index: GLuint, v: &'a [GLuint]), not_compiled;
        /// Sets a generic attribute to integers.
        vertex_attrib_i_2i: glVertexAttribI2i | glVertexAttribI2iEXT
            (index: GLuint, x: GLint, y: GLint), not_compiled;
        /// Sets a generic attribute to integers of a slice.
        vertex_attrib_i_2iv: glVertexAttribI2iv | glVertexAttribI2ivEXT
            (index: GLuint, v: &'a [GLint]), not_compiled;
        /// Sets a generic attribute to integers.
        vertex_attrib_i_2ui: glVertexAttribI2ui | glVertexAttribI2uiEXT
            (index: GLuint, x: GLuint, y: GLuint), not_compiled;
        /// Sets a generic attribute to integers of a slice.
        vertex_attrib_i_2uiv: glVertexAttribI2uiv | glVertexAttribI2uivEXT
            (index: GLuint, v: &'a [GLuint]), not_compiled;
        /// Sets a generic attribute to integers.
        vertex_attrib_i_3i: glVertexAttribI3i | glVertexAttribI3iEXT
            (index: GLuint, x: GLint, y: GLint, z: GLint), not_compiled;
        /// Sets a generic attribute to integers of a slice.
        vertex_attrib_i_3iv: glVertexAttribI3iv | glVertexAttribI3ivEXT
            (index: GLuint, v: &'a [GLint]), not_compiled;
        /// Sets a generic attribute to integers.
        vertex_attrib_i_3ui: glVertexAttribI3ui | glVertexAttribI3uiEXT
            (index: GLuint, x: GLuint, y: GLuint, z: GLuint), not_compiled;
        /// Sets a generic attribute to integers of a slice.
        vertex_attrib_i_3uiv: glVertexAttribI3uiv | glVertexAttribI3uivEXT
            (index: GLuint, v: &'a [GLuint]), not_compiled;
        /// Sets a generic attribute to integers.
        vertex_attrib_i_4i: glVertexAttribI4i | glVertexAttribI4iEXT
            (index: GLuint, x: GLint, y: GLint, z: GLint, w: GLint), not_compiled;
        /// Sets a generic attribute to integers of a slice.
        vertex_attrib_i_4iv: glVertexAttribI4iv | glVertexAttribI4ivEXT
            (index: GLuint, v: &'a [GLint]), not_compiled;
        /// Sets a generic attribute to integers.
        vertex_attrib_i_4ui: glVertexAttribI4ui | glVertexAttribI4uiEXT
            (index: GLuint, x: GLuint, y: GLuint, z: GLuint, w: GLuint), not_compiled;
        /// Sets a generic attribute to integers of a slice.
        vertex_attrib_i_4uiv: glVertexAttribI4uiv | glVertexAttribI4uivEXT
            (index: GLuint, v: &'a [GLuint]), not_compiled;
        /// Sets a generic attribute to integers of a slice.
        vertex_attrib_i_4bv: glVertexAttribI4bv | glVertexAttribI4bvEXT
            (index: GLuint, v: &'a [GLbyte]), not_compiled;
        /// Sets a generic attribute to integers of a slice.
        vertex_attrib_i_4sv: glVertexAttribI4sv | glVertexAttribI4svEXT
            (index: GLuint, v: &'a [GLshort]), not_compiled;
        /// Sets a generic attribute to integers of a slice.
        vertex_attrib_i_4ubv: glVertexAttribI4ubv | glVertexAttribI4ubvEXT
            (index: GLuint, v: &'a [GLubyte]), not_compiled;
        /// Sets a generic attribute to integers of a slice.
        vertex_attrib_i_4usv: glVertexAttribI4usv | glVertexAttribI4usvEXT
            (index: GLuint, v: &'a [GLushort]), not_compiled;
    }
    } };
}
entry_points_integers!(implement);
