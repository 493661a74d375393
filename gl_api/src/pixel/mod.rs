//! Pixels in client memory and texels in storage: formats, layout, transfer, conversion.

pub(crate) mod blocks;
pub(crate) mod client;
pub(crate) mod component_bits;
pub(crate) mod convert;
pub(crate) mod es_texels;
pub(crate) mod etc;
pub mod formats;
pub(crate) mod layout;
pub(crate) mod map;
pub(crate) mod memory;
pub(crate) mod one_texel;
pub(crate) mod packed;
pub(crate) mod scratch;
pub(crate) mod stencil_texels;
pub(crate) mod storage_error;
pub(crate) mod store;
pub(crate) mod texel;
pub(crate) mod transfer;
