//! The calls of texture objects: names, images, parameters, reading back.

pub(crate) mod bound;
pub(crate) mod buffer;
pub(crate) mod clear_image;
pub(crate) mod compressed;
pub(crate) mod copy;
pub(crate) mod copy_image;
pub(crate) mod environment;
pub(crate) mod format_properties;
pub(crate) mod get;
pub(crate) mod get_sub;
pub(crate) mod internal_format;
pub(crate) mod level_request;
pub(crate) mod mipmap;
pub(crate) mod multisample;
pub(crate) mod named;
pub(crate) mod named_parameters;
pub(crate) mod named_storage;
pub(crate) mod names;
pub(crate) mod parameter;
pub(crate) mod query;
mod read_only;
pub(crate) mod samplers;
pub(crate) mod specify;
pub(crate) mod storage;
pub(crate) mod stored_level;
pub(crate) mod sub;
pub(crate) mod view;
