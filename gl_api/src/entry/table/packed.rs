//! Attributes whose components share a word: `ARB_vertex_type_2_10_10_10_rev`.

use crate::base::types::*;
use crate::calls::vertex::packed;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_packed {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    Allowed in packed {
        /// Ends a vertex at a position whose components share a word.
        vertex_p2ui: glVertexP2ui
            (ty: GLenum, value: GLuint);
        /// Ends a vertex at a position whose components share a word.
        vertex_p2uiv: glVertexP2uiv
            (ty: GLenum, value: &'a [GLuint]);
        /// Ends a vertex at a position whose components share a word.
        vertex_p3ui: glVertexP3ui
            (ty: GLenum, value: GLuint);
        /// Ends a vertex at a position whose components share a word.
        vertex_p3uiv: glVertexP3uiv
            (ty: GLenum, value: &'a [GLuint]);
        /// Ends a vertex at a position whose components share a word.
        vertex_p4ui: glVertexP4ui
            (ty: GLenum, value: GLuint);
        /// Ends a vertex at a position whose components share a word.
        vertex_p4uiv: glVertexP4uiv
            (ty: GLenum, value: &'a [GLuint]);
        /// Sets the texture coordinates of unit 0 from a word.
        tex_coord_p1ui: glTexCoordP1ui
            (ty: GLenum, coords: GLuint);
        /// Sets the texture coordinates of unit 0 from a word.
        tex_coord_p1uiv: glTexCoordP1uiv
            (ty: GLenum, coords: &'a [GLuint]);
        /// Sets the texture coordinates of unit 0 from a word.
        tex_coord_p2ui: glTexCoordP2ui
            (ty: GLenum, coords: GLuint);
        /// Sets the texture coordinates of unit 0 from a word.
        tex_coord_p2uiv: glTexCoordP2uiv
            (ty: GLenum, coords: &'a [GLuint]);
        /// Sets the texture coordinates of unit 0 from a word.
        tex_coord_p3ui: glTexCoordP3ui
            (ty: GLenum, coords: GLuint);
        /// Sets the texture coordinates of unit 0 from a word.
        tex_coord_p3uiv: glTexCoordP3uiv
            (ty: GLenum, coords: &'a [GLuint]);
        /// Sets the texture coordinates of unit 0 from a word.
        tex_coord_p4ui: glTexCoordP4ui
            (ty: GLenum, coords: GLuint);
        /// Sets the texture coordinates of unit 0 from a word.
        tex_coord_p4uiv: glTexCoordP4uiv
            (ty: GLenum, coords: &'a [GLuint]);
        /// Sets the texture coordinates of a unit from a word.
        multi_tex_coord_p1ui: glMultiTexCoordP1ui
            (texture: GLenum, ty: GLenum, coords: GLuint);
        /// Sets the texture coordinates of a unit from a word.
        multi_tex_coord_p1uiv: glMultiTexCoordP1uiv
            (texture: GLenum, ty: GLenum, coords: &'a [GLuint]);
        /// Sets the texture coordinates of a unit from a word.
        multi_tex_coord_p2ui: glMultiTexCoordP2ui
            (texture: GLenum, ty: GLenum, coords: GLuint);
        /// Sets the texture coordinates of a unit from a word.
        multi_tex_coord_p2uiv: glMultiTexCoordP2uiv
            (texture: GLenum, ty: GLenum, coords: &'a [GLuint]);
        /// Sets the texture coordinates of a unit from a word.
        multi_tex_coord_p3ui: glMultiTexCoordP3ui
            (texture: GLenum, ty: GLenum, coords: GLuint);
        /// Sets the texture coordinates of a unit from a word.
        multi_tex_coord_p3uiv: glMultiTexCoordP3uiv
            (texture: GLenum, ty: GLenum, coords: &'a [GLuint]);
        /// Sets the texture coordinates of a unit from a word.
        multi_tex_coord_p4ui: glMultiTexCoordP4ui
            (texture: GLenum, ty: GLenum, coords: GLuint);
        /// Sets the texture coordinates of a unit from a word.
        multi_tex_coord_p4uiv: glMultiTexCoordP4uiv
            (texture: GLenum, ty: GLenum, coords: &'a [GLuint]);
        /// Sets the normal from a word.
        normal_p3ui: glNormalP3ui
            (ty: GLenum, coords: GLuint);
        /// Sets the normal from a word.
        normal_p3uiv: glNormalP3uiv
            (ty: GLenum, coords: &'a [GLuint]);
        /// Sets the colour from a word.
        color_p3ui: glColorP3ui
            (ty: GLenum, color: GLuint);
        /// Sets the colour from a word.
        color_p3uiv: glColorP3uiv
            (ty: GLenum, color: &'a [GLuint]);
        /// Sets the colour from a word.
        color_p4ui: glColorP4ui
            (ty: GLenum, color: GLuint);
        /// Sets the colour from a word.
        color_p4uiv: glColorP4uiv
            (ty: GLenum, color: &'a [GLuint]);
        /// Sets the secondary colour from a word.
        secondary_color_p3ui: glSecondaryColorP3ui
            (ty: GLenum, color: GLuint);
        /// Sets the secondary colour from a word.
        secondary_color_p3uiv: glSecondaryColorP3uiv
            (ty: GLenum, color: &'a [GLuint]);
        /// Sets a generic attribute from a word; attribute 0 ends the vertex.
        vertex_attrib_p1ui: glVertexAttribP1ui
            (index: GLuint, ty: GLenum, normalized: bool, value: GLuint);
        /// Sets a generic attribute from a word; attribute 0 ends the vertex.
        vertex_attrib_p1uiv: glVertexAttribP1uiv
            (index: GLuint, ty: GLenum, normalized: bool, value: &'a [GLuint]);
        /// Sets a generic attribute from a word; attribute 0 ends the vertex.
        vertex_attrib_p2ui: glVertexAttribP2ui
            (index: GLuint, ty: GLenum, normalized: bool, value: GLuint);
        /// Sets a generic attribute from a word; attribute 0 ends the vertex.
        vertex_attrib_p2uiv: glVertexAttribP2uiv
            (index: GLuint, ty: GLenum, normalized: bool, value: &'a [GLuint]);
        /// Sets a generic attribute from a word; attribute 0 ends the vertex.
        vertex_attrib_p3ui: glVertexAttribP3ui
            (index: GLuint, ty: GLenum, normalized: bool, value: GLuint);
        /// Sets a generic attribute from a word; attribute 0 ends the vertex.
        vertex_attrib_p3uiv: glVertexAttribP3uiv
            (index: GLuint, ty: GLenum, normalized: bool, value: &'a [GLuint]);
        /// Sets a generic attribute from a word; attribute 0 ends the vertex.
        vertex_attrib_p4ui: glVertexAttribP4ui
            (index: GLuint, ty: GLenum, normalized: bool, value: GLuint);
        /// Sets a generic attribute from a word; attribute 0 ends the vertex.
        vertex_attrib_p4uiv: glVertexAttribP4uiv
            (index: GLuint, ty: GLenum, normalized: bool, value: &'a [GLuint]);
    }
    } };
}
entry_points_packed!(implement);
