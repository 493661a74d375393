//! Generic attributes of integer types that have a vector form only, and reading them: GL 2.1,
//! sections 2.7 and 6.1.14.

use crate::base::types::*;
use crate::calls::program::generic_attributes;
use crate::query::attributes;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_generics {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Refused in attributes {
        /// Reads what is known of a generic attribute.
        get_vertex_attribdv: glGetVertexAttribdv | glGetVertexAttribdvARB
            (index: GLuint, pname: GLenum, params: &'a mut [GLdouble]);
        /// Reads what is known of a generic attribute, its value as integers (`EXT_gpu_shader4`).
        get_vertex_attrib_i_iv: glGetVertexAttribIiv | glGetVertexAttribIivEXT
            (index: GLuint, pname: GLenum, params: &'a mut [GLint]);
        /// Reads what is known of a generic attribute, its value as integers (`EXT_gpu_shader4`).
        get_vertex_attrib_i_uiv: glGetVertexAttribIuiv | glGetVertexAttribIuivEXT
            (index: GLuint, pname: GLenum, params: &'a mut [GLuint]);
    }
    Allowed in generic_attributes {
        /// Sets a generic attribute, integers as they are; attribute 0 ends the vertex.
        vertex_attrib_4bv: glVertexAttrib4bv | glVertexAttrib4bvARB
            (index: GLuint, v: &'a [GLbyte]), not_compiled;
        /// Sets a generic attribute, integers as they are; attribute 0 ends the vertex.
        vertex_attrib_4iv: glVertexAttrib4iv | glVertexAttrib4ivARB
            (index: GLuint, v: &'a [GLint]), not_compiled;
        /// Sets a generic attribute, integers as they are; attribute 0 ends the vertex.
        vertex_attrib_4ubv: glVertexAttrib4ubv | glVertexAttrib4ubvARB
            (index: GLuint, v: &'a [GLubyte]), not_compiled;
        /// Sets a generic attribute, integers as they are; attribute 0 ends the vertex.
        vertex_attrib_4usv: glVertexAttrib4usv | glVertexAttrib4usvARB
            (index: GLuint, v: &'a [GLushort]), not_compiled;
        /// Sets a generic attribute, integers as they are; attribute 0 ends the vertex.
        vertex_attrib_4uiv: glVertexAttrib4uiv | glVertexAttrib4uivARB
            (index: GLuint, v: &'a [GLuint]), not_compiled;
        /// Sets a generic attribute, integers scaled to [0, 1] or [-1, 1]; attribute 0 ends the vertex.
        vertex_attrib_4nbv: glVertexAttrib4Nbv | glVertexAttrib4NbvARB
            (index: GLuint, v: &'a [GLbyte]), not_compiled;
        /// Sets a generic attribute, integers scaled to [0, 1] or [-1, 1]; attribute 0 ends the vertex.
        vertex_attrib_4nsv: glVertexAttrib4Nsv | glVertexAttrib4NsvARB
            (index: GLuint, v: &'a [GLshort]), not_compiled;
        /// Sets a generic attribute, integers scaled to [0, 1] or [-1, 1]; attribute 0 ends the vertex.
        vertex_attrib_4niv: glVertexAttrib4Niv | glVertexAttrib4NivARB
            (index: GLuint, v: &'a [GLint]), not_compiled;
        /// Sets a generic attribute, integers scaled to [0, 1] or [-1, 1]; attribute 0 ends the vertex.
        vertex_attrib_4nusv: glVertexAttrib4Nusv | glVertexAttrib4NusvARB
            (index: GLuint, v: &'a [GLushort]), not_compiled;
        /// Sets a generic attribute, integers scaled to [0, 1] or [-1, 1]; attribute 0 ends the vertex.
        vertex_attrib_4nuiv: glVertexAttrib4Nuiv | glVertexAttrib4NuivARB
            (index: GLuint, v: &'a [GLuint]), not_compiled;
    }
    } };
}
entry_points_generics!(implement);
