//! Calls that record or save others: display lists, attribute stacks, selection and feedback.

pub(crate) mod arguments;
pub(crate) mod attrib;
pub(crate) mod attrib_changes;
pub(crate) mod client_attrib;
pub(crate) mod list_memory;
pub(crate) mod lists;
pub(crate) mod proxy;
pub(crate) mod render_mode;
