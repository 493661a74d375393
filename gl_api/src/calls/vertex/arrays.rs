//! The calls that specify vertex arrays (GL 2.1, section 2.8): `glVertexPointer` and its kin, and which generic arrays
//! are enabled.
//!
//! A slice is copied when the pointer call is made, since it cannot be kept: later writes to it are
//! not seen. Buffer objects, and pointers of C programs, are read when the draw is made.

use crate::base::args::Data;
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value, not_negative};
use crate::base::memory::{copied, out_of_memory};
use crate::base::types::*;
use crate::calls::vertex::array_objects::{ChosenArrays, require_vertex_array};
use crate::calls::vertex::bindings::{vertex_attrib_binding, vertex_binding_divisor};
use crate::context::Context;
use crate::draw::array_names::refuse_client_memory;
use crate::interface::*;
use crate::objects::arrays::{ALL_TYPES, ANY_TYPE, ES_TYPE, PACKED, Source, generic};
use crate::pixel::es_texels::plain_type;
use rasterizer::driver::{Buffer, VertexFormat, VertexType};

const SECTION: &str = "GL 2.1, section 2.8";

/// GL 3.0, table 2.5: of texture coordinates and vertices.
const COORDINATE_TYPE: Table<VertexType> =
    Table { section: "GL 3.0, table 2.5", rows: ALL_TYPES.split_at(7).0 };
/// Of normals.
const NORMAL_TYPE: Table<VertexType> =
    Table { section: "GL 3.0, table 2.5", rows: ALL_TYPES.split_at(8).0 };
/// Of fog coordinates.
const FOG_TYPE: Table<VertexType> =
    Table { section: "GL 3.0, table 2.5", rows: ALL_TYPES.split_at(7).0.split_at(4).1 };
/// Of colours.
const COLOR_TYPE: Table<VertexType> =
    Table { section: "GL 3.0, table 2.5", rows: ALL_TYPES.split_at(11).0 };

/// Of colour indices.
const INDEX_TYPE: Table<VertexType> = Table {
    section: "GL 3.0, table 2.5",
    rows: &[
        (GL_UNSIGNED_BYTE, VertexType::U8),
        (GL_SHORT, VertexType::I16),
        (GL_INT, VertexType::I32),
        (GL_FLOAT, VertexType::F32),
        (GL_DOUBLE, VertexType::F64),
    ],
};

/// Of generic attributes that stay integers.
pub(crate) const INTEGER_TYPE: Table<VertexType> = Table {
    section: "EXT_gpu_shader4, section 2.8",
    rows: &[
        (GL_BYTE, VertexType::I8),
        (GL_UNSIGNED_BYTE, VertexType::U8),
        (GL_SHORT, VertexType::I16),
        (GL_UNSIGNED_SHORT, VertexType::U16),
        (GL_INT, VertexType::I32),
        (GL_UNSIGNED_INT, VertexType::U32),
    ],
};

/// Whether `GL_BGRA` is a size: four components in that order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Bgra {
    Refused,
    Taken,
}

/// Which sizes an array can have, and how its integers are read.
pub(crate) struct Rules {
    sizes: std::ops::RangeInclusive<GLint>,
    bgra: Bgra,
    types: Table<VertexType>,
    format: VertexFormat,
}

impl Rules {
    pub(crate) fn new(
        sizes: std::ops::RangeInclusive<GLint>,
        types: Table<VertexType>,
        format: VertexFormat,
    ) -> Self {
        Self { sizes, bgra: Bgra::Refused, types, format }
    }

    pub(crate) fn or_bgra(self) -> Self {
        Self { bgra: Bgra::Taken, ..self }
    }

    /// How many components there are, their type and how they are read.
    ///
    /// # Errors
    /// As GL 3.3, section 2.8, says which sizes and types go together.
    pub(crate) fn check(&self, size: GLint, ty: GLenum) -> Result<(u8, VertexType, VertexFormat)> {
        let is_bgra = size == GL_BGRA as GLint && self.bgra == Bgra::Taken;
        if !is_bgra && !self.sizes.contains(&size) {
            let (least, most) = (self.sizes.start(), self.sizes.end());
            let or = match self.bgra {
                Bgra::Refused => "",
                Bgra::Taken => " or GL_BGRA",
            };
            return invalid_value(SECTION, format!("size = {size} must be {least} to {most}{or}"));
        }
        let ty = self.types.decode("type", ty)?;
        if is_bgra {
            return self.check_bgra(ty);
        }
        if ty == VertexType::F111110 && size != 3 {
            return invalid_operation(
                "ARB_vertex_type_10f_11f_11f_rev, section 2.8",
                format!("size = {size} must be 3: GL_UNSIGNED_INT_10F_11F_11F_REV has so many"),
            );
        }
        // Normals have three components, whatever they are in.
        if PACKED.encode(ty) != GL_NONE && size != 4 && self.sizes != (3..=3) {
            return invalid_operation(
                PACKED.section,
                format!("size = {size} must be 4: {} has so many", enum_name(PACKED.encode(ty))),
            );
        }
        Ok((size as u8, ty, self.format))
    }

    fn check_bgra(&self, ty: VertexType) -> Result<(u8, VertexType, VertexFormat)> {
        const SECTION: &str = "EXT_vertex_array_bgra, section 2.8";
        if self.format != VertexFormat::Normalized {
            return invalid_operation(SECTION, "size = GL_BGRA needs normalized = GL_TRUE");
        }
        if ty != VertexType::U8 && PACKED.encode(ty) == GL_NONE {
            return invalid_operation(
                SECTION,
                format!("size = GL_BGRA needs type = GL_UNSIGNED_BYTE or {}", PACKED.list()),
            );
        }
        Ok((4, ty, VertexFormat::NormalizedBgra))
    }
}

fn set(
    context: &mut Context,
    location: u8,
    rules: &Rules,
    size: GLint,
    ty: GLenum,
    stride: GLsizei,
    pointer: Data<'_>,
) -> Result<()> {
    let (components, ty, format) = rules.check(size, ty)?;
    let stride = not_negative(SECTION, "stride", stride.into())?;
    require_vertex_array(context)?;
    refuse_client_memory(context, &pointer)?;
    let buffer = context.state.bindings.array_buffer.clone();
    let name = buffer.name();
    let source = match pointer {
        Data::Bytes(_) if name != 0 => {
            return invalid_operation(
                SECTION,
                format!(
                    "pointer is memory, but buffer {name} is bound to GL_ARRAY_BUFFER: pass \
                     BUFFER_OFFSET(n), or call glBindBuffer(GL_ARRAY_BUFFER, 0)"
                ),
            );
        }
        Data::Bytes(bytes) => {
            context.recorder.hold(bytes.len());
            let bytes = copied(bytes).map_err(out_of_memory(SECTION, "a copy of the array"))?;
            Source::Client(Buffer::new(bytes))
        }
        Data::Client(pointer) if name != 0 => Source::Object { buffer, offset: pointer.offset() },
        Data::Client(pointer) if pointer.is_null() => Source::Client(Buffer::default()),
        Data::Client(pointer) => Source::Pointer(pointer.kept()),
        Data::Null if name == 0 => Source::Client(Buffer::default()),
        Data::Offset(0) if name == 0 => Source::Client(Buffer::default()),
        Data::Null => Source::Object { buffer, offset: 0 },
        Data::Offset(offset) if name != 0 => Source::Object { buffer, offset },
        Data::Offset(offset) => {
            return invalid_operation(
                SECTION,
                format!(
                    "pointer = offset {offset}, but no buffer is bound to GL_ARRAY_BUFFER: pass a \
                     slice, or call glBindBuffer"
                ),
            );
        }
    };
    let arrays = &mut context.state.arrays;
    let is_generic = arrays.attributes.get(usize::from(location)).is_some();
    let array = &mut arrays.by_location[usize::from(location)];
    let before = (array.components, array.ty, array.format, array.stride, array.count);
    let is_same_source = match (&array.source, &source) {
        (Source::Object { buffer, offset }, Source::Object { buffer: other, offset: at }) => {
            (buffer, offset) == (other, at)
        }
        (Source::Object { .. } | Source::Client(_) | Source::Pointer(_), _) => false,
    };
    if is_same_source && !is_generic && before == (components, ty, format, stride, 0) {
        context.state_changes.no_change();
        return Ok(());
    }
    array.components = components;
    array.ty = ty;
    array.format = format;
    array.stride = stride;
    array.step = if stride > 0 { stride } else { array.size() };
    array.source = source;
    array.count = 0;
    context.state.arrays.pointer_given(location.into());
    context.state_changes.values_only();
    Ok(())
}

/// The location of the texture coordinates of the client's active unit.
pub(crate) fn tex_coord_location(context: &Context) -> u8 {
    ATTRIB_TEX_COORD + context.state.units.client_active
}

pub(crate) fn vertex_pointer(
    context: &mut Context,
    size: GLint,
    ty: GLenum,
    stride: GLsizei,
    pointer: Data<'_>,
) -> Result<()> {
    let rules = Rules::new(2..=4, COORDINATE_TYPE, VertexFormat::Plain);
    set(context, ATTRIB_VERTEX, &rules, size, ty, stride, pointer)
}

pub(crate) fn normal_pointer(
    context: &mut Context,
    ty: GLenum,
    stride: GLsizei,
    pointer: Data<'_>,
) -> Result<()> {
    let rules = Rules::new(3..=3, NORMAL_TYPE, VertexFormat::Normalized);
    set(context, ATTRIB_NORMAL, &rules, 3, ty, stride, pointer)
}

pub(crate) fn color_pointer(
    context: &mut Context,
    size: GLint,
    ty: GLenum,
    stride: GLsizei,
    pointer: Data<'_>,
) -> Result<()> {
    let rules = Rules::new(3..=4, COLOR_TYPE, VertexFormat::Normalized).or_bgra();
    set(context, ATTRIB_COLOR, &rules, size, ty, stride, pointer)
}

pub(crate) fn secondary_color_pointer(
    context: &mut Context,
    size: GLint,
    ty: GLenum,
    stride: GLsizei,
    pointer: Data<'_>,
) -> Result<()> {
    let rules = Rules::new(3..=3, COLOR_TYPE, VertexFormat::Normalized).or_bgra();
    set(context, ATTRIB_SECONDARY_COLOR, &rules, size, ty, stride, pointer)
}

pub(crate) fn fog_coord_pointer(
    context: &mut Context,
    ty: GLenum,
    stride: GLsizei,
    pointer: Data<'_>,
) -> Result<()> {
    let rules = Rules::new(1..=1, FOG_TYPE, VertexFormat::Plain);
    set(context, ATTRIB_FOG_COORD, &rules, 1, ty, stride, pointer)
}

pub(crate) fn index_pointer(
    context: &mut Context,
    ty: GLenum,
    stride: GLsizei,
    pointer: Data<'_>,
) -> Result<()> {
    let rules = Rules::new(1..=1, INDEX_TYPE, VertexFormat::Plain);
    set(context, ATTRIB_INDEX, &rules, 1, ty, stride, pointer)
}

pub(crate) fn edge_flag_pointer(
    context: &mut Context,
    stride: GLsizei,
    pointer: Data<'_>,
) -> Result<()> {
    let rules = Rules::new(1..=1, COLOR_TYPE, VertexFormat::Plain);
    set(context, ATTRIB_EDGE_FLAG, &rules, 1, GL_UNSIGNED_BYTE, stride, pointer)
}

pub(crate) fn tex_coord_pointer(
    context: &mut Context,
    size: GLint,
    ty: GLenum,
    stride: GLsizei,
    pointer: Data<'_>,
) -> Result<()> {
    let rules = Rules::new(1..=4, COORDINATE_TYPE, VertexFormat::Plain);
    let location = tex_coord_location(context);
    set(context, location, &rules, size, ty, stride, pointer)
}

pub(crate) fn vertex_attrib_pointer(
    context: &mut Context,
    index: GLuint,
    size: GLint,
    ty: GLenum,
    normalized: bool,
    stride: GLsizei,
    pointer: Data<'_>,
) -> Result<()> {
    let (ty, types) =
        if context.profile.is_es() { (plain_type(ty), ES_TYPE) } else { (ty, ANY_TYPE) };
    // OpenGL ES 3.0 has one equation for all signed fractions (2.2), OpenGL 3.3 one of its own for attributes.
    let format = match (normalized, context.profile.is_es()) {
        (true, true) => VertexFormat::NormalizedSymmetric,
        (true, false) => VertexFormat::Normalized,
        (false, _) => VertexFormat::Plain,
    };
    let rules = Rules::new(1..=4, types, format).or_bgra();
    set(context, generic(index)?, &rules, size, ty, stride, pointer)
}

pub(crate) fn vertex_attrib_i_pointer(
    context: &mut Context,
    index: GLuint,
    size: GLint,
    ty: GLenum,
    stride: GLsizei,
    pointer: Data<'_>,
) -> Result<()> {
    let rules = Rules::new(1..=4, INTEGER_TYPE, VertexFormat::Integer);
    set(context, generic(index)?, &rules, size, ty, stride, pointer)
}

pub(crate) fn vertex_attrib_divisor(
    context: &mut Context,
    index: GLuint,
    divisor: GLuint,
) -> Result<()> {
    vertex_attrib_binding(context, index, index)?;
    vertex_binding_divisor(context, index, divisor)
}

pub(crate) fn enable_vertex_attrib_array(context: &mut Context, index: GLuint) -> Result<()> {
    enable_array(context, ChosenArrays::Bound, index, Enabled::Yes)
}

pub(crate) fn disable_vertex_attrib_array(context: &mut Context, index: GLuint) -> Result<()> {
    enable_array(context, ChosenArrays::Bound, index, Enabled::No)
}

/// Whether an array is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Enabled {
    Yes,
    No,
}

/// Enables or disables a generic array.
pub(crate) fn enable_array(
    context: &mut Context,
    chosen: ChosenArrays,
    index: GLuint,
    enabled: Enabled,
) -> Result<()> {
    chosen.require(context)?;
    let array = &mut chosen.arrays_mut(context).by_location[usize::from(generic(index)?)];
    array.enabled = enabled == Enabled::Yes;
    context.state_changes.values_only();
    Ok(())
}
