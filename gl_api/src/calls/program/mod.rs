//! What is set and asked of programs: uniforms, attributes, and what a link found.

pub(crate) mod assembly;
pub(crate) mod assembly_names;
pub(crate) mod assembly_query;
pub(crate) mod binaries;
pub(crate) mod blocks;
pub(crate) mod data_type;
pub(crate) mod es2_compiler;
pub(crate) mod generic_attributes;
pub(crate) mod inspect;
pub(crate) mod integer_attributes;
pub(crate) mod pipelines;
pub(crate) mod programs;
pub(crate) mod shader_objects_arb;
pub(crate) mod shaders;
pub(crate) mod similar_names;
pub(crate) mod uniform;
pub(crate) mod uniform_values;
pub(crate) mod validate;
pub(crate) mod varyings;
