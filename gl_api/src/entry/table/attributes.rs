//! Attributes of immediate mode: GL 2.1, section 2.7; a row for each type, with its vector form.
//!
//! A group has its documentation, a parameter before the components, the attribute it sets, and how its components
//! are converted; a row the method, GL's name and an alias of the call, the same of its vector form, the type of a
//! component, and the components.

use crate::base::types::{GLenum, GLuint};
use crate::context::immediate::Slot;
use crate::interface::*;

#[doc(hidden)]
#[macro_export]
macro_rules! entry_points_attributes {
    ($apply:ident $($arguments:tt)*) => { $apply! { [$($arguments)*]
    "Ends a vertex at a position."
    [] Slot::Vertex, plain {
        vertex_2s: glVertex2s, vertex_2sv: glVertex2sv, i16 (x, y);
        vertex_2i: glVertex2i, vertex_2iv: glVertex2iv, i32 (x, y);
        vertex_2f: glVertex2f, vertex_2fv: glVertex2fv, f32 (x, y);
        vertex_2d: glVertex2d, vertex_2dv: glVertex2dv, f64 (x, y);
        vertex_3s: glVertex3s, vertex_3sv: glVertex3sv, i16 (x, y, z);
        vertex_3i: glVertex3i, vertex_3iv: glVertex3iv, i32 (x, y, z);
        vertex_3f: glVertex3f, vertex_3fv: glVertex3fv, f32 (x, y, z);
        vertex_3d: glVertex3d, vertex_3dv: glVertex3dv, f64 (x, y, z);
        vertex_4s: glVertex4s, vertex_4sv: glVertex4sv, i16 (x, y, z, w);
        vertex_4i: glVertex4i, vertex_4iv: glVertex4iv, i32 (x, y, z, w);
        vertex_4f: glVertex4f, vertex_4fv: glVertex4fv, f32 (x, y, z, w);
        vertex_4d: glVertex4d, vertex_4dv: glVertex4dv, f64 (x, y, z, w);
    }
    "Sets the current colour; integers are scaled to [0, 1] or [-1, 1]."
    [] Slot::Location(ATTRIB_COLOR), normalized {
        color_3b: glColor3b, color_3bv: glColor3bv, i8 (red, green, blue);
        color_3s: glColor3s, color_3sv: glColor3sv, i16 (red, green, blue);
        color_3i: glColor3i, color_3iv: glColor3iv, i32 (red, green, blue);
        color_3f: glColor3f, color_3fv: glColor3fv, f32 (red, green, blue);
        color_3d: glColor3d, color_3dv: glColor3dv, f64 (red, green, blue);
        color_3ub: glColor3ub, color_3ubv: glColor3ubv, u8 (red, green, blue);
        color_3us: glColor3us, color_3usv: glColor3usv, u16 (red, green, blue);
        color_3ui: glColor3ui, color_3uiv: glColor3uiv, u32 (red, green, blue);
        color_4b: glColor4b, color_4bv: glColor4bv, i8 (red, green, blue, alpha);
        color_4s: glColor4s, color_4sv: glColor4sv, i16 (red, green, blue, alpha);
        color_4i: glColor4i, color_4iv: glColor4iv, i32 (red, green, blue, alpha);
        color_4f: glColor4f, color_4fv: glColor4fv, f32 (red, green, blue, alpha);
        color_4d: glColor4d, color_4dv: glColor4dv, f64 (red, green, blue, alpha);
        color_4ub: glColor4ub, color_4ubv: glColor4ubv, u8 (red, green, blue, alpha);
        color_4us: glColor4us, color_4usv: glColor4usv, u16 (red, green, blue, alpha);
        color_4ui: glColor4ui, color_4uiv: glColor4uiv, u32 (red, green, blue, alpha);
    }
    "Sets the current secondary colour; integers are scaled to [0, 1] or [-1, 1]."
    [] Slot::Location(ATTRIB_SECONDARY_COLOR), normalized {
        secondary_color_3b: glSecondaryColor3b | glSecondaryColor3bEXT, secondary_color_3bv: glSecondaryColor3bv | glSecondaryColor3bvEXT, i8 (red, green, blue);
        secondary_color_3s: glSecondaryColor3s | glSecondaryColor3sEXT, secondary_color_3sv: glSecondaryColor3sv | glSecondaryColor3svEXT, i16 (red, green, blue);
        secondary_color_3i: glSecondaryColor3i | glSecondaryColor3iEXT, secondary_color_3iv: glSecondaryColor3iv | glSecondaryColor3ivEXT, i32 (red, green, blue);
        secondary_color_3f: glSecondaryColor3f | glSecondaryColor3fEXT, secondary_color_3fv: glSecondaryColor3fv | glSecondaryColor3fvEXT, f32 (red, green, blue);
        secondary_color_3d: glSecondaryColor3d | glSecondaryColor3dEXT, secondary_color_3dv: glSecondaryColor3dv | glSecondaryColor3dvEXT, f64 (red, green, blue);
        secondary_color_3ub: glSecondaryColor3ub | glSecondaryColor3ubEXT, secondary_color_3ubv: glSecondaryColor3ubv | glSecondaryColor3ubvEXT, u8 (red, green, blue);
        secondary_color_3us: glSecondaryColor3us | glSecondaryColor3usEXT, secondary_color_3usv: glSecondaryColor3usv | glSecondaryColor3usvEXT, u16 (red, green, blue);
        secondary_color_3ui: glSecondaryColor3ui | glSecondaryColor3uiEXT, secondary_color_3uiv: glSecondaryColor3uiv | glSecondaryColor3uivEXT, u32 (red, green, blue);
    }
    "Sets the current normal; integers are scaled to [-1, 1]."
    [] Slot::Location(ATTRIB_NORMAL), normalized {
        normal_3b: glNormal3b, normal_3bv: glNormal3bv, i8 (x, y, z);
        normal_3s: glNormal3s, normal_3sv: glNormal3sv, i16 (x, y, z);
        normal_3i: glNormal3i, normal_3iv: glNormal3iv, i32 (x, y, z);
        normal_3f: glNormal3f, normal_3fv: glNormal3fv, f32 (x, y, z);
        normal_3d: glNormal3d, normal_3dv: glNormal3dv, f64 (x, y, z);
    }
    "Sets the current colour index, which changes no picture in RGBA mode."
    [] Slot::Location(ATTRIB_INDEX), plain {
        indexs: glIndexs, indexsv: glIndexsv, i16 (c);
        indexi: glIndexi, indexiv: glIndexiv, i32 (c);
        indexf: glIndexf, indexfv: glIndexfv, f32 (c);
        indexd: glIndexd, indexdv: glIndexdv, f64 (c);
        indexub: glIndexub, indexubv: glIndexubv, u8 (c);
    }
    "Sets the current fog coordinate."
    [] Slot::Location(ATTRIB_FOG_COORD), plain {
        fog_coordf: glFogCoordf | glFogCoordfEXT, fog_coordfv: glFogCoordfv | glFogCoordfvEXT, f32 (coord);
        fog_coordd: glFogCoordd | glFogCoorddEXT, fog_coorddv: glFogCoorddv | glFogCoorddvEXT, f64 (coord);
    }
    "Sets the current texture coordinates of unit 0."
    [] Slot::Location(ATTRIB_TEX_COORD), plain {
        tex_coord_1s: glTexCoord1s, tex_coord_1sv: glTexCoord1sv, i16 (s);
        tex_coord_1i: glTexCoord1i, tex_coord_1iv: glTexCoord1iv, i32 (s);
        tex_coord_1f: glTexCoord1f, tex_coord_1fv: glTexCoord1fv, f32 (s);
        tex_coord_1d: glTexCoord1d, tex_coord_1dv: glTexCoord1dv, f64 (s);
        tex_coord_2s: glTexCoord2s, tex_coord_2sv: glTexCoord2sv, i16 (s, t);
        tex_coord_2i: glTexCoord2i, tex_coord_2iv: glTexCoord2iv, i32 (s, t);
        tex_coord_2f: glTexCoord2f, tex_coord_2fv: glTexCoord2fv, f32 (s, t);
        tex_coord_2d: glTexCoord2d, tex_coord_2dv: glTexCoord2dv, f64 (s, t);
        tex_coord_3s: glTexCoord3s, tex_coord_3sv: glTexCoord3sv, i16 (s, t, r);
        tex_coord_3i: glTexCoord3i, tex_coord_3iv: glTexCoord3iv, i32 (s, t, r);
        tex_coord_3f: glTexCoord3f, tex_coord_3fv: glTexCoord3fv, f32 (s, t, r);
        tex_coord_3d: glTexCoord3d, tex_coord_3dv: glTexCoord3dv, f64 (s, t, r);
        tex_coord_4s: glTexCoord4s, tex_coord_4sv: glTexCoord4sv, i16 (s, t, r, q);
        tex_coord_4i: glTexCoord4i, tex_coord_4iv: glTexCoord4iv, i32 (s, t, r, q);
        tex_coord_4f: glTexCoord4f, tex_coord_4fv: glTexCoord4fv, f32 (s, t, r, q);
        tex_coord_4d: glTexCoord4d, tex_coord_4dv: glTexCoord4dv, f64 (s, t, r, q);
    }
    "Sets the current texture coordinates of a unit."
    [target: GLenum] Slot::TexCoord(target), plain {
        multi_tex_coord_1s: glMultiTexCoord1s | glMultiTexCoord1sARB, multi_tex_coord_1sv: glMultiTexCoord1sv | glMultiTexCoord1svARB, i16 (s);
        multi_tex_coord_1i: glMultiTexCoord1i | glMultiTexCoord1iARB, multi_tex_coord_1iv: glMultiTexCoord1iv | glMultiTexCoord1ivARB, i32 (s);
        multi_tex_coord_1f: glMultiTexCoord1f | glMultiTexCoord1fARB, multi_tex_coord_1fv: glMultiTexCoord1fv | glMultiTexCoord1fvARB, f32 (s);
        multi_tex_coord_1d: glMultiTexCoord1d | glMultiTexCoord1dARB, multi_tex_coord_1dv: glMultiTexCoord1dv | glMultiTexCoord1dvARB, f64 (s);
        multi_tex_coord_2s: glMultiTexCoord2s | glMultiTexCoord2sARB, multi_tex_coord_2sv: glMultiTexCoord2sv | glMultiTexCoord2svARB, i16 (s, t);
        multi_tex_coord_2i: glMultiTexCoord2i | glMultiTexCoord2iARB, multi_tex_coord_2iv: glMultiTexCoord2iv | glMultiTexCoord2ivARB, i32 (s, t);
        multi_tex_coord_2f: glMultiTexCoord2f | glMultiTexCoord2fARB, multi_tex_coord_2fv: glMultiTexCoord2fv | glMultiTexCoord2fvARB, f32 (s, t);
        multi_tex_coord_2d: glMultiTexCoord2d | glMultiTexCoord2dARB, multi_tex_coord_2dv: glMultiTexCoord2dv | glMultiTexCoord2dvARB, f64 (s, t);
        multi_tex_coord_3s: glMultiTexCoord3s | glMultiTexCoord3sARB, multi_tex_coord_3sv: glMultiTexCoord3sv | glMultiTexCoord3svARB, i16 (s, t, r);
        multi_tex_coord_3i: glMultiTexCoord3i | glMultiTexCoord3iARB, multi_tex_coord_3iv: glMultiTexCoord3iv | glMultiTexCoord3ivARB, i32 (s, t, r);
        multi_tex_coord_3f: glMultiTexCoord3f | glMultiTexCoord3fARB, multi_tex_coord_3fv: glMultiTexCoord3fv | glMultiTexCoord3fvARB, f32 (s, t, r);
        multi_tex_coord_3d: glMultiTexCoord3d | glMultiTexCoord3dARB, multi_tex_coord_3dv: glMultiTexCoord3dv | glMultiTexCoord3dvARB, f64 (s, t, r);
        multi_tex_coord_4s: glMultiTexCoord4s | glMultiTexCoord4sARB, multi_tex_coord_4sv: glMultiTexCoord4sv | glMultiTexCoord4svARB, i16 (s, t, r, q);
        multi_tex_coord_4i: glMultiTexCoord4i | glMultiTexCoord4iARB, multi_tex_coord_4iv: glMultiTexCoord4iv | glMultiTexCoord4ivARB, i32 (s, t, r, q);
        multi_tex_coord_4f: glMultiTexCoord4f | glMultiTexCoord4fARB, multi_tex_coord_4fv: glMultiTexCoord4fv | glMultiTexCoord4fvARB, f32 (s, t, r, q);
        multi_tex_coord_4d: glMultiTexCoord4d | glMultiTexCoord4dARB, multi_tex_coord_4dv: glMultiTexCoord4dv | glMultiTexCoord4dvARB, f64 (s, t, r, q);
    }
    "Sets a generic attribute; attribute 0 is the position and ends the vertex."
    [index: GLuint] Slot::Generic(index), plain {
        vertex_attrib_1s: glVertexAttrib1s | glVertexAttrib1sARB, vertex_attrib_1sv: glVertexAttrib1sv | glVertexAttrib1svARB, i16 (x);
        vertex_attrib_1f: glVertexAttrib1f | glVertexAttrib1fARB, vertex_attrib_1fv: glVertexAttrib1fv | glVertexAttrib1fvARB, f32 (x);
        vertex_attrib_1d: glVertexAttrib1d | glVertexAttrib1dARB, vertex_attrib_1dv: glVertexAttrib1dv | glVertexAttrib1dvARB, f64 (x);
        vertex_attrib_2s: glVertexAttrib2s | glVertexAttrib2sARB, vertex_attrib_2sv: glVertexAttrib2sv | glVertexAttrib2svARB, i16 (x, y);
        vertex_attrib_2f: glVertexAttrib2f | glVertexAttrib2fARB, vertex_attrib_2fv: glVertexAttrib2fv | glVertexAttrib2fvARB, f32 (x, y);
        vertex_attrib_2d: glVertexAttrib2d | glVertexAttrib2dARB, vertex_attrib_2dv: glVertexAttrib2dv | glVertexAttrib2dvARB, f64 (x, y);
        vertex_attrib_3s: glVertexAttrib3s | glVertexAttrib3sARB, vertex_attrib_3sv: glVertexAttrib3sv | glVertexAttrib3svARB, i16 (x, y, z);
        vertex_attrib_3f: glVertexAttrib3f | glVertexAttrib3fARB, vertex_attrib_3fv: glVertexAttrib3fv | glVertexAttrib3fvARB, f32 (x, y, z);
        vertex_attrib_3d: glVertexAttrib3d | glVertexAttrib3dARB, vertex_attrib_3dv: glVertexAttrib3dv | glVertexAttrib3dvARB, f64 (x, y, z);
        vertex_attrib_4s: glVertexAttrib4s | glVertexAttrib4sARB, vertex_attrib_4sv: glVertexAttrib4sv | glVertexAttrib4svARB, i16 (x, y, z, w);
        vertex_attrib_4f: glVertexAttrib4f | glVertexAttrib4fARB, vertex_attrib_4fv: glVertexAttrib4fv | glVertexAttrib4fvARB, f32 (x, y, z, w);
        vertex_attrib_4d: glVertexAttrib4d | glVertexAttrib4dARB, vertex_attrib_4dv: glVertexAttrib4dv | glVertexAttrib4dvARB, f64 (x, y, z, w);
    }
    "Sets a generic attribute, integers scaled to [0, 1]; attribute 0 ends the vertex."
    [index: GLuint] Slot::Generic(index), normalized {
        vertex_attrib_4nub: glVertexAttrib4Nub | glVertexAttrib4NubARB, vertex_attrib_4nubv: glVertexAttrib4Nubv | glVertexAttrib4NubvARB, u8 (x, y, z, w);
    }
    } };
}
entry_points_attributes!(implement);
