//! The pointer calls of `EXT_vertex_array`: GL's with a number of elements, which is kept for queries only.

use crate::base::args::Data;
use crate::base::error::{Result, not_negative};
use crate::base::types::*;
use crate::calls::vertex::arrays::{
    color_pointer, edge_flag_pointer, index_pointer, normal_pointer, tex_coord_location,
    tex_coord_pointer, vertex_pointer,
};
use crate::context::Context;
use crate::interface::*;

/// A row: the call, the one without a number, the array's location, and the parameters before the stride.
macro_rules! counted {
    ($($counted:ident, $call:ident, $location:expr, ($($param:ident: $ty:ty),*);)*) => { $(
        pub(crate) fn $counted(
            context: &mut Context,
            $($param: $ty,)*
            stride: GLsizei,
            count: GLsizei,
            pointer: Data<'_>,
        ) -> Result<()> {
            let count = not_negative("EXT_vertex_array, section 2.8", "count", count.into())?;
            $call(context, $($param,)* stride, pointer)?;
            let location = usize::from($location(context));
            context.state.arrays.by_location[location].count = count;
            Ok(())
        }
    )* };
}

counted! {
    vertex_pointer_ext, vertex_pointer, |_: &Context| ATTRIB_VERTEX, (size: GLint, ty: GLenum);
    normal_pointer_ext, normal_pointer, |_: &Context| ATTRIB_NORMAL, (ty: GLenum);
    color_pointer_ext, color_pointer, |_: &Context| ATTRIB_COLOR, (size: GLint, ty: GLenum);
    index_pointer_ext, index_pointer, |_: &Context| ATTRIB_INDEX, (ty: GLenum);
    tex_coord_pointer_ext, tex_coord_pointer, tex_coord_location, (size: GLint, ty: GLenum);
    edge_flag_pointer_ext, edge_flag_pointer, |_: &Context| ATTRIB_EDGE_FLAG, ();
}
