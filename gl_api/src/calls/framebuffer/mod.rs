//! Framebuffers: attachments, clears, reads, copies.

pub(crate) mod accumulate;
pub(crate) mod attach;
pub(crate) mod blit;
pub(crate) mod buffers;
pub(crate) mod clear;
pub(crate) mod es_blit;
pub(crate) mod inspect;
pub(crate) mod invalidate;
pub(crate) mod named;
pub(crate) mod names;
pub(crate) mod parameters;
pub(crate) mod read;
pub(crate) mod renderbuffers;
