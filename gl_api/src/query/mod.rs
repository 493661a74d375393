//! State queries: `glGet` and the tables it reads. It reads every layer below, and none of them needs it.

pub(crate) mod attributes;
pub(crate) mod get;

pub(crate) mod arrays;
pub(crate) mod extensions;
pub(crate) mod pointers;
pub(crate) mod table;
