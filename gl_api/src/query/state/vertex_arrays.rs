//! Vertex arrays and what is bound for them: GL 2.1, tables 6.6 to 6.9, and GL 3.1, table 6.4.

use super::row::Read::*;
use super::row::{Row, fixed_function, rows, saturated};
use crate::base::availability::{Availability, Version};
use crate::base::constants::*;
use crate::context::Context;
use crate::interface::*;
use crate::objects::arrays::{ANY_TYPE, Array};
use crate::query::arrays::buffer;

/// A conventional array; of texture coordinates, the client's active unit's.
fn array(context: &Context, location: u8) -> &Array {
    let unit = if location == ATTRIB_TEX_COORD { context.state.units.client_active } else { 0 };
    &context.state.arrays.by_location[usize::from(location + unit)]
}

/// The registry has the name of vertex array objects for labels too.
const VERTEX_ARRAY: Availability = fixed_function(Version::new(1, 1), Some(Version::new(1, 0)));

pub(super) const ROWS: &[Row] = rows! {
    GL_CLIENT_ACTIVE_TEXTURE: Word(|c| GL_TEXTURE0 + u32::from(c.state.units.client_active));
    GL_VERTEX_ARRAY: Enabled, VERTEX_ARRAY;
    GL_VERTEX_ARRAY_SIZE: Word(|c| array(c, ATTRIB_VERTEX).given_size());
    GL_VERTEX_ARRAY_TYPE: Word(|c| ANY_TYPE.encode(array(c, ATTRIB_VERTEX).ty));
    GL_VERTEX_ARRAY_STRIDE: Integer(|c| saturated(array(c, ATTRIB_VERTEX).stride));
    GL_VERTEX_ARRAY_BUFFER_BINDING: Word(|c| buffer(array(c, ATTRIB_VERTEX)));
    GL_VERTEX_ARRAY_COUNT_EXT: Integer(|c| saturated(array(c, ATTRIB_VERTEX).count));

    GL_NORMAL_ARRAY: Enabled;
    GL_NORMAL_ARRAY_TYPE: Word(|c| ANY_TYPE.encode(array(c, ATTRIB_NORMAL).ty));
    GL_NORMAL_ARRAY_STRIDE: Integer(|c| saturated(array(c, ATTRIB_NORMAL).stride));
    GL_NORMAL_ARRAY_BUFFER_BINDING: Word(|c| buffer(array(c, ATTRIB_NORMAL)));
    GL_NORMAL_ARRAY_COUNT_EXT: Integer(|c| saturated(array(c, ATTRIB_NORMAL).count));

    GL_COLOR_ARRAY: Enabled;
    GL_COLOR_ARRAY_SIZE: Word(|c| array(c, ATTRIB_COLOR).given_size());
    GL_COLOR_ARRAY_TYPE: Word(|c| ANY_TYPE.encode(array(c, ATTRIB_COLOR).ty));
    GL_COLOR_ARRAY_STRIDE: Integer(|c| saturated(array(c, ATTRIB_COLOR).stride));
    GL_COLOR_ARRAY_BUFFER_BINDING: Word(|c| buffer(array(c, ATTRIB_COLOR)));
    GL_COLOR_ARRAY_COUNT_EXT: Integer(|c| saturated(array(c, ATTRIB_COLOR).count));

    GL_SECONDARY_COLOR_ARRAY: Enabled;
    GL_SECONDARY_COLOR_ARRAY_SIZE: Word(|c| array(c, ATTRIB_SECONDARY_COLOR).given_size());
    GL_SECONDARY_COLOR_ARRAY_TYPE: Word(|c| ANY_TYPE.encode(array(c, ATTRIB_SECONDARY_COLOR).ty));
    GL_SECONDARY_COLOR_ARRAY_STRIDE:
        Integer(|c| saturated(array(c, ATTRIB_SECONDARY_COLOR).stride));
    GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING: Word(|c| buffer(array(c, ATTRIB_SECONDARY_COLOR)));

    GL_INDEX_ARRAY: Enabled;
    GL_INDEX_ARRAY_TYPE: Word(|c| ANY_TYPE.encode(array(c, ATTRIB_INDEX).ty));
    GL_INDEX_ARRAY_STRIDE: Integer(|c| saturated(array(c, ATTRIB_INDEX).stride));
    GL_INDEX_ARRAY_BUFFER_BINDING: Word(|c| buffer(array(c, ATTRIB_INDEX)));
    GL_INDEX_ARRAY_COUNT_EXT: Integer(|c| saturated(array(c, ATTRIB_INDEX).count));

    GL_FOG_COORD_ARRAY: Enabled;
    GL_FOG_COORD_ARRAY_TYPE: Word(|c| ANY_TYPE.encode(array(c, ATTRIB_FOG_COORD).ty));
    GL_FOG_COORD_ARRAY_STRIDE: Integer(|c| saturated(array(c, ATTRIB_FOG_COORD).stride));
    GL_FOG_COORD_ARRAY_BUFFER_BINDING: Word(|c| buffer(array(c, ATTRIB_FOG_COORD)));

    GL_EDGE_FLAG_ARRAY: Enabled;
    GL_EDGE_FLAG_ARRAY_STRIDE: Integer(|c| saturated(array(c, ATTRIB_EDGE_FLAG).stride));
    GL_EDGE_FLAG_ARRAY_BUFFER_BINDING: Word(|c| buffer(array(c, ATTRIB_EDGE_FLAG)));
    GL_EDGE_FLAG_ARRAY_COUNT_EXT: Integer(|c| saturated(array(c, ATTRIB_EDGE_FLAG).count));

    GL_TEXTURE_COORD_ARRAY: Enabled;
    GL_TEXTURE_COORD_ARRAY_SIZE: Word(|c| array(c, ATTRIB_TEX_COORD).given_size());
    GL_TEXTURE_COORD_ARRAY_TYPE: Word(|c| ANY_TYPE.encode(array(c, ATTRIB_TEX_COORD).ty));
    GL_TEXTURE_COORD_ARRAY_STRIDE: Integer(|c| saturated(array(c, ATTRIB_TEX_COORD).stride));
    GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING: Word(|c| buffer(array(c, ATTRIB_TEX_COORD)));
    GL_TEXTURE_COORD_ARRAY_COUNT_EXT: Integer(|c| saturated(array(c, ATTRIB_TEX_COORD).count));

    GL_ARRAY_BUFFER_BINDING: Word(|c| c.state.bindings.array_buffer.name());
    GL_ELEMENT_ARRAY_BUFFER_BINDING: Word(|c| c.state.bindings.element_array_buffer.name());
    GL_VERTEX_ARRAY_BINDING: Word(|c| c.state.bindings.vertex_array);
    GL_ARRAY_ELEMENT_LOCK_FIRST_EXT: Integer(|c| saturated(c.state.locked.first));
    GL_ARRAY_ELEMENT_LOCK_COUNT_EXT: Integer(|c| saturated(c.state.locked.count));
    GL_PRIMITIVE_RESTART: Enabled;
    GL_PRIMITIVE_RESTART_NV: Enabled;
    GL_PRIMITIVE_RESTART_FIXED_INDEX: Enabled;
    GL_PRIMITIVE_RESTART_INDEX: Word(|c| c.state.restart_index);
    GL_PRIMITIVE_RESTART_INDEX_NV: Word(|c| c.state.restart_index);
};
