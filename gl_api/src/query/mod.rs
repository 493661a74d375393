//! State queries: `glGet`, `glIsEnabled` and the table of state that they read, vertex arrays, pointers and strings.
//! They read every layer below, and none of them needs this one.

pub(crate) mod arrays;
pub(crate) mod attributes;
pub(crate) mod enabled;
pub(crate) mod extensions;
pub(crate) mod get;
pub(crate) mod indexed;
pub(crate) mod pointers;
pub(crate) mod state;
pub(crate) mod vertex_array_objects;
