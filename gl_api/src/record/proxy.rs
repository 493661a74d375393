//! Which calls ask about a proxy texture: they are carried out at once while a list is compiled (GL 2.1, section 5.4).

use crate::base::constants::*;
use crate::base::types::GLenum;

/// Whether a call asks a proxy; `integers` are its arguments.
#[inline(never)]
pub(crate) fn asks_proxy(name: &str, integers: &[i64]) -> bool {
    name.starts_with("glTexImage") && is_proxy(integers[0])
}

/// Whether a target is a proxy.
fn is_proxy(target: i64) -> bool {
    const PROXIES: [GLenum; 10] = [
        GL_PROXY_TEXTURE_1D,
        GL_PROXY_TEXTURE_2D,
        GL_PROXY_TEXTURE_3D,
        GL_PROXY_TEXTURE_RECTANGLE,
        GL_PROXY_TEXTURE_CUBE_MAP,
        GL_PROXY_TEXTURE_1D_ARRAY,
        GL_PROXY_TEXTURE_2D_ARRAY,
        GL_PROXY_TEXTURE_CUBE_MAP_ARRAY,
        GL_PROXY_TEXTURE_2D_MULTISAMPLE,
        GL_PROXY_TEXTURE_2D_MULTISAMPLE_ARRAY,
    ];
    PROXIES.iter().any(|&proxy| i64::from(proxy) == target)
}
