//! Vertex array objects (`ARB_vertex_array_object`): the arrays and the element buffer under a
//! name. The current object's state is in the context; the others' is kept here.

use crate::objects::arrays::Arrays;
use crate::objects::bound::Bound;

/// What a vertex array object holds while it is not bound.
#[derive(Clone, Debug, Default)]
pub(crate) struct VertexArray {
    pub arrays: Arrays,
    pub element_array_buffer: Bound,
}
