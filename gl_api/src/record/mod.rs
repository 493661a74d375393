//! Calls that record or save others: display lists, attribute stacks, selection and feedback.

pub(crate) mod attrib;
pub(crate) mod client_attrib;
pub(crate) mod feedback;
pub(crate) mod list;
pub(crate) mod render_mode;
