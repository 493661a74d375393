//! What is set and asked of programs: uniforms, attributes, and what a link found.

pub(crate) mod arb;
pub(crate) mod assembly;
pub(crate) mod assembly_names;
pub(crate) mod assembly_query;
pub(crate) mod attribute;
pub(crate) mod blocks;
pub(crate) mod compiler;
pub(crate) mod data_type;
pub(crate) mod inspect;
pub(crate) mod integer;
pub(crate) mod near;
pub(crate) mod programs;
pub(crate) mod shaders;
pub(crate) mod uniform;
pub(crate) mod validate;
pub(crate) mod varyings;
