//! The calls, by subject: each converts its arguments, validates them, and applies the request.

pub(crate) mod buffer;
pub(crate) mod color_index;
pub(crate) mod debug;
pub(crate) mod dispatch;
pub(crate) mod display_list;
pub(crate) mod enable;
pub(crate) mod evaluate;
pub(crate) mod flush;
pub(crate) mod fragment;
pub(crate) mod framebuffer;
pub(crate) mod lighting;
pub(crate) mod parameter_forms;
pub(crate) mod pixels;
pub(crate) mod program;
pub(crate) mod raster;
pub(crate) mod sync;
pub(crate) mod texture;
pub(crate) mod transform;
pub(crate) mod transform_feedback;
pub(crate) mod vertex;
