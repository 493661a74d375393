//! Attributes of immediate mode whose components share a word: `ARB_vertex_type_2_10_10_10_rev`.

use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::calls::vertex::immediate::attribute;
use crate::context::Context;
use crate::context::immediate::Slot;
use crate::interface::*;
use crate::objects::arrays::{PACKED, PACKED_GENERIC};
use rasterizer::driver::{Buffer, VertexFormat, VertexSource, VertexType};

/// Sets an attribute to what an array of this one word would give.
fn set(
    context: &mut Context,
    slot: Slot,
    ty: VertexType,
    components: u8,
    format: VertexFormat,
    word: GLuint,
) -> Result<()> {
    let source = VertexSource::Array {
        buffer: Buffer::new(word.to_le_bytes().to_vec()),
        first: 0,
        offset: 0,
        stride: 4,
        ty,
        // Three floats are all that a word has of them.
        components: if ty == VertexType::F111110 { components.min(3) } else { components },
        format,
        divisor: 0,
    };
    attribute(context, slot, source.read(0))
}

/// The word of a vector form.
fn first(words: &[GLuint]) -> Result<GLuint> {
    match words.first() {
        Some(&word) => Ok(word),
        None => invalid_operation(PACKED.section, "the memory has none of 1 words"),
    }
}

fn format(normalized: bool) -> VertexFormat {
    if normalized { VertexFormat::Normalized } else { VertexFormat::Plain }
}

/// A row: the call and its vector form, what comes before the type, the slot, what comes after the
/// type, how many components there are, and how they are read.
macro_rules! packed {
    ($($one:ident, $vector:ident: [$($before:ident: $before_ty:ty)?] $slot:expr,
        [$($after:ident: $after_ty:ty)?] $components:literal, $format:expr;)*) => { $(
        pub(crate) fn $one(
            context: &mut Context,
            $($before: $before_ty,)?
            ty: GLenum,
            $($after: $after_ty,)?
            word: GLuint,
        ) -> Result<()> {
            let slot = $slot;
            let types = match slot {
                Slot::Generic(_) => PACKED_GENERIC,
                Slot::Vertex | Slot::Location(_) | Slot::TexCoord(_) => PACKED,
            };
            set(context, slot, types.decode("type", ty)?, $components, $format, word)
        }

        pub(crate) fn $vector(
            context: &mut Context,
            $($before: $before_ty,)?
            ty: GLenum,
            $($after: $after_ty,)?
            words: &[GLuint],
        ) -> Result<()> {
            $one(context, $($before,)? ty, $($after,)? first(words)?)
        }
    )* };
}

packed! {
    vertex_p2ui, vertex_p2uiv: [] Slot::Vertex, [] 2, VertexFormat::Plain;
    vertex_p3ui, vertex_p3uiv: [] Slot::Vertex, [] 3, VertexFormat::Plain;
    vertex_p4ui, vertex_p4uiv: [] Slot::Vertex, [] 4, VertexFormat::Plain;
    tex_coord_p1ui, tex_coord_p1uiv: [] Slot::Location(ATTRIB_TEX_COORD), [] 1, VertexFormat::Plain;
    tex_coord_p2ui, tex_coord_p2uiv: [] Slot::Location(ATTRIB_TEX_COORD), [] 2, VertexFormat::Plain;
    tex_coord_p3ui, tex_coord_p3uiv: [] Slot::Location(ATTRIB_TEX_COORD), [] 3, VertexFormat::Plain;
    tex_coord_p4ui, tex_coord_p4uiv: [] Slot::Location(ATTRIB_TEX_COORD), [] 4, VertexFormat::Plain;
    multi_tex_coord_p1ui, multi_tex_coord_p1uiv: [texture: GLenum] Slot::TexCoord(texture), [] 1, VertexFormat::Plain;
    multi_tex_coord_p2ui, multi_tex_coord_p2uiv: [texture: GLenum] Slot::TexCoord(texture), [] 2, VertexFormat::Plain;
    multi_tex_coord_p3ui, multi_tex_coord_p3uiv: [texture: GLenum] Slot::TexCoord(texture), [] 3, VertexFormat::Plain;
    multi_tex_coord_p4ui, multi_tex_coord_p4uiv: [texture: GLenum] Slot::TexCoord(texture), [] 4, VertexFormat::Plain;
    normal_p3ui, normal_p3uiv: [] Slot::Location(ATTRIB_NORMAL), [] 3, VertexFormat::Normalized;
    color_p3ui, color_p3uiv: [] Slot::Location(ATTRIB_COLOR), [] 3, VertexFormat::Normalized;
    color_p4ui, color_p4uiv: [] Slot::Location(ATTRIB_COLOR), [] 4, VertexFormat::Normalized;
    secondary_color_p3ui, secondary_color_p3uiv: [] Slot::Location(ATTRIB_SECONDARY_COLOR), [] 3, VertexFormat::Normalized;
    vertex_attrib_p1ui, vertex_attrib_p1uiv: [index: GLuint] Slot::Generic(index), [normalized: bool] 1, format(normalized);
    vertex_attrib_p2ui, vertex_attrib_p2uiv: [index: GLuint] Slot::Generic(index), [normalized: bool] 2, format(normalized);
    vertex_attrib_p3ui, vertex_attrib_p3uiv: [index: GLuint] Slot::Generic(index), [normalized: bool] 3, format(normalized);
    vertex_attrib_p4ui, vertex_attrib_p4uiv: [index: GLuint] Slot::Generic(index), [normalized: bool] 4, format(normalized);
}
