//! What the calls for words of several components refuse: `ARB_vertex_type_2_10_10_10_rev`,
//! `EXT_vertex_array_bgra`.

use super::Case;
use gl_api::*;

const ENUM: GLenum = GL_INVALID_ENUM;
const VALUE: GLenum = GL_INVALID_VALUE;
const OPERATION: GLenum = GL_INVALID_OPERATION;
const SIGNED: GLenum = GL_INT_2_10_10_10_REV;
const FLOATS: GLenum = GL_UNSIGNED_INT_10F_11F_11F_REV;
const BGRA: GLint = GL_BGRA as GLint;
const NONE: Data<'static> = Data::Null;

const CASES: &[Case] = &[
    (|c| c.vertex_p2ui(GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.vertex_p2uiv(GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.vertex_p3ui(GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.vertex_p3uiv(GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.vertex_p4ui(GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.vertex_p4uiv(GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.tex_coord_p1ui(GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.tex_coord_p1uiv(GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.tex_coord_p2ui(GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.tex_coord_p2uiv(GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.tex_coord_p3ui(GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.tex_coord_p3uiv(GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.tex_coord_p4ui(GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.tex_coord_p4uiv(GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.multi_tex_coord_p1ui(GL_TEXTURE1, GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.multi_tex_coord_p1uiv(GL_TEXTURE1, GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.multi_tex_coord_p2ui(GL_TEXTURE1, GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.multi_tex_coord_p2uiv(GL_TEXTURE1, GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.multi_tex_coord_p3ui(GL_TEXTURE1, GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.multi_tex_coord_p3uiv(GL_TEXTURE1, GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.multi_tex_coord_p4ui(GL_TEXTURE1, GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.multi_tex_coord_p4uiv(GL_TEXTURE1, GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.normal_p3ui(GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.normal_p3uiv(GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.color_p3ui(GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.color_p3uiv(GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.color_p4ui(GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.color_p4uiv(GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.secondary_color_p3ui(GL_UNSIGNED_INT, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.secondary_color_p3uiv(GL_FLOAT, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.vertex_attrib_p1ui(1, GL_UNSIGNED_INT, true, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.vertex_attrib_p1uiv(1, GL_FLOAT, true, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.vertex_attrib_p2ui(1, GL_UNSIGNED_INT, true, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.vertex_attrib_p2uiv(1, GL_FLOAT, true, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.vertex_attrib_p3ui(1, GL_UNSIGNED_INT, true, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.vertex_attrib_p3uiv(1, GL_FLOAT, true, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.vertex_attrib_p4ui(1, GL_UNSIGNED_INT, true, 0), ENUM, "type = GL_UNSIGNED_INT"),
    (|c| c.vertex_attrib_p4uiv(1, GL_FLOAT, true, &[0]), ENUM, "type = GL_FLOAT"),
    (|c| c.color_p3uiv(SIGNED, &[]), OPERATION, "none of 1 words"),
    (|c| c.vertex_attrib_p1ui(99, SIGNED, true, 0), VALUE, "index = 99"),
    (|c| c.multi_tex_coord_p1ui(GL_TEXTURE0 + 99, SIGNED, 0), ENUM, "texture"),
    (|c| c.vertex_attrib_pointer(0, 3, SIGNED, true, 0, NONE), OPERATION, "size = 3 must be 4"),
    (|c| c.vertex_attrib_pointer(0, 4, FLOATS, false, 0, NONE), OPERATION, "size = 4 must be 3"),
    (|c| c.vertex_attrib_pointer(0, BGRA, FLOATS, true, 0, NONE), OPERATION, "GL_BGRA needs"),
    (|c| c.vertex_attrib_i_pointer(0, 3, FLOATS, 0, NONE), ENUM, "10F_11F_11F"),
    (|c| c.vertex_pointer(3, FLOATS, 0, NONE), ENUM, "10F_11F_11F"),
    (|c| c.vertex_p3ui(FLOATS, 0), ENUM, "10F_11F_11F"),
    (|c| c.vertex_pointer(2, SIGNED, 0, NONE), OPERATION, "size = 2 must be 4"),
    (|c| c.vertex_pointer(BGRA, SIGNED, 0, NONE), VALUE, "must be 2 to 4"),
    (|c| c.color_pointer(BGRA, GL_FLOAT, 0, NONE), OPERATION, "needs type = GL_UNSIGNED_BYTE"),
    (|c| c.color_pointer(2, GL_FLOAT, 0, NONE), VALUE, "3 to 4 or GL_BGRA"),
    (
        |c| c.vertex_attrib_pointer(0, BGRA, GL_UNSIGNED_BYTE, false, 0, NONE),
        OPERATION,
        "normalized = GL_TRUE",
    ),
    (|c| c.vertex_attrib_i_pointer(0, BGRA, GL_UNSIGNED_BYTE, 0, NONE), VALUE, "size ="),
    (|c| c.vertex_attrib_i_pointer(0, 4, SIGNED, 0, NONE), ENUM, "type ="),
    (|c| c.fog_coord_pointer(SIGNED, 0, NONE), ENUM, "type ="),
];

/// Runs the rows.
pub fn run() {
    let rows = CASES.iter().map(|(call, flag, words)| (call, *flag, *words));
    super::table("packed", super::context, rows);
}
