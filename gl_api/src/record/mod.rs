//! Calls that record or save others: display lists, attribute stacks, selection and feedback.

pub(crate) mod keep;
pub(crate) mod lists;
pub(crate) mod pixels;
pub(crate) mod proxy;

pub(crate) mod attrib;
pub(crate) mod client_attrib;
pub(crate) mod render_mode;
