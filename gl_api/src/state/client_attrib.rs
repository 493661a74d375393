//! Groups of client state on the attribute stack: `glPushClientAttrib`, GL 2.1, section 6.1.17.

use crate::base::types::*;
use crate::objects::arrays::Arrays;
use crate::objects::bound::Bound;
use crate::pixel::store as pixel_store;

/// The state that `glPushClientAttrib` saves: the groups of its mask.
#[derive(Debug)]
pub(crate) struct ClientAttribs {
    pub pixels: Option<ClientPixels>,
    pub arrays: Option<Box<ClientArrays>>,
}

/// Of `GL_CLIENT_PIXEL_STORE_BIT`.
#[derive(Debug)]
pub(crate) struct ClientPixels {
    pub pack: pixel_store::PixelStore,
    pub unpack: pixel_store::PixelStore,
    pub pack_buffer: Bound,
    pub unpack_buffer: Bound,
}

/// Of `GL_CLIENT_VERTEX_ARRAY_BIT`.
#[derive(Debug)]
pub(crate) struct ClientArrays {
    pub arrays: Box<Arrays>,
    pub array_buffer: Bound,
    pub element_array_buffer: Bound,
    pub vertex_array: GLuint,
    /// Whether primitives are restarted, and by which index.
    pub restart: (bool, GLuint),
    pub client_active: u8,
}
