//! What is set and asked of programs: uniforms, attributes, and what a link found.

pub(crate) mod arb;
pub(crate) mod attribute;
pub(crate) mod data_type;
pub(crate) mod inspect;
pub(crate) mod integer;
mod near;
pub(crate) mod uniform;
pub(crate) mod validate;
