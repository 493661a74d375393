//! Texture units: GL 2.1, tables 6.17 to 6.20. Parameters of textures and of their images have queries of their own.

use super::row::Read::*;
use super::row::{Row, fixed_function, rows};
use crate::base::availability::{Availability, Version};
use crate::base::constants::*;
use crate::base::types::*;
use crate::calls::texture::bound::bound;
use crate::context::Context;
use crate::objects::target::TextureTarget;

/// The name of the texture that is bound to a target of the active unit.
fn binding(context: &Context, target: TextureTarget) -> GLuint {
    context.state.units.active().bound[target as usize].name()
}

/// The registry has targets of textures for shaders too.
const SWITCH_OF_1_0: Availability = fixed_function(Version::new(1, 0), None);
const SWITCH_OF_1_0_AND_ES: Availability =
    fixed_function(Version::new(1, 0), Some(Version::new(1, 0)));
const SWITCH_OF_1_2: Availability = fixed_function(Version::new(1, 2), None);
const SWITCH_OF_1_3: Availability = fixed_function(Version::new(1, 3), None);
const SWITCH_OF_3_1: Availability = fixed_function(Version::new(3, 1), None);

pub(super) const ROWS: &[Row] = rows! {
    GL_ACTIVE_TEXTURE: Word(|c| GL_TEXTURE0 + u32::from(c.state.units.active));
    GL_TEXTURE_1D: Enabled, SWITCH_OF_1_0;
    GL_TEXTURE_2D: Enabled, SWITCH_OF_1_0_AND_ES;
    GL_TEXTURE_3D: Enabled, SWITCH_OF_1_2;
    GL_TEXTURE_CUBE_MAP: Enabled, SWITCH_OF_1_3;
    GL_TEXTURE_RECTANGLE: Enabled, SWITCH_OF_3_1;
    GL_TEXTURE_CUBE_MAP_SEAMLESS: Enabled;
    GL_TEXTURE_GEN_S: Enabled;
    GL_TEXTURE_GEN_T: Enabled;
    GL_TEXTURE_GEN_R: Enabled;
    GL_TEXTURE_GEN_Q: Enabled;

    GL_TEXTURE_BINDING_1D: Word(|c| binding(c, TextureTarget::D1));
    GL_TEXTURE_BINDING_2D: Word(|c| binding(c, TextureTarget::D2));
    GL_TEXTURE_BINDING_3D: Word(|c| binding(c, TextureTarget::D3));
    GL_TEXTURE_BINDING_CUBE_MAP: Word(|c| binding(c, TextureTarget::Cube));
    GL_TEXTURE_BINDING_RECTANGLE: Word(|c| binding(c, TextureTarget::Rect));
    GL_TEXTURE_BINDING_1D_ARRAY: Word(|c| binding(c, TextureTarget::D1Array));
    GL_TEXTURE_BINDING_2D_ARRAY: Word(|c| binding(c, TextureTarget::D2Array));
    GL_TEXTURE_BINDING_CUBE_MAP_ARRAY: Word(|c| binding(c, TextureTarget::CubeArray));
    GL_TEXTURE_BINDING_2D_MULTISAMPLE: Word(|c| binding(c, TextureTarget::D2Multisample));
    GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY:
        Word(|c| binding(c, TextureTarget::D2MultisampleArray));
    GL_TEXTURE_BINDING_BUFFER: Word(|c| binding(c, TextureTarget::Buffer));
    GL_TEXTURE_BINDING_EXTERNAL_OES: Word(|c| binding(c, TextureTarget::External));
    GL_SAMPLER_BINDING: Word(|c| c.state.units.active().sampler.name());

    // `ARB_texture_buffer_object`: of the buffer texture that is bound.
    GL_TEXTURE_BUFFER_FORMAT_ARB: Word(|c| bound(c, TextureTarget::Buffer).store.internal);
    GL_TEXTURE_BUFFER_DATA_STORE_BINDING:
        Word(|c| bound(c, TextureTarget::Buffer).store.buffer.name());
    GL_TEXTURE_BUFFER: Word(|c| c.state.bindings.texture_buffer.name());
};
