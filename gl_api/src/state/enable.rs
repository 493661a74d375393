//! What can be switched on and off: `glEnable` and `glEnableClientState`.

use crate::constants::*;
use crate::context::Context;
use crate::context::debug::Output;
use crate::error::{Result, Table};
use crate::interface::{
    ATTRIB_COLOR, ATTRIB_FOG_COORD, ATTRIB_NORMAL, ATTRIB_SECONDARY_COLOR, ATTRIB_TEX_COORD,
    ATTRIB_VERTEX,
};
use crate::texture::TextureTarget;
use crate::types::*;

/// A capability of the context as a whole, as its bit in [`Enables`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Flag {
    AlphaTest,
    Blend,
    ColorLogicOp,
    CullFace,
    DebugOutputSynchronous,
    DepthTest,
    Dither,
    FramebufferSrgb,
    Multisample,
    PolygonOffsetFill,
    PrimitiveRestart,
    ScissorTest,
    SeamlessCubeMaps,
    StencilTest,
    StencilTestTwoSide,
}

/// What `glEnable` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Capability {
    Flag(Flag),
    /// Of the active texture unit.
    Texture(TextureTarget),
    /// Whether the log of `KHR_debug` is kept.
    DebugOutput,
}

/// What is implemented; anything else is `GL_INVALID_ENUM` with this list in the message.
/// `GL_DITHER` changes nothing, and messages are always synchronous.
pub(crate) const CAPABILITY: Table<Capability> = Table {
    section: "GL 2.1, table 6.22 and others; what DetGL implements",
    rows: &[
        (GL_ALPHA_TEST, Capability::Flag(Flag::AlphaTest)),
        (GL_BLEND, Capability::Flag(Flag::Blend)),
        (GL_COLOR_LOGIC_OP, Capability::Flag(Flag::ColorLogicOp)),
        (GL_CULL_FACE, Capability::Flag(Flag::CullFace)),
        (GL_DEBUG_OUTPUT, Capability::DebugOutput),
        (GL_DEBUG_OUTPUT_SYNCHRONOUS, Capability::Flag(Flag::DebugOutputSynchronous)),
        (GL_DEPTH_TEST, Capability::Flag(Flag::DepthTest)),
        (GL_DITHER, Capability::Flag(Flag::Dither)),
        (GL_FRAMEBUFFER_SRGB, Capability::Flag(Flag::FramebufferSrgb)),
        (GL_MULTISAMPLE, Capability::Flag(Flag::Multisample)),
        (GL_POLYGON_OFFSET_FILL, Capability::Flag(Flag::PolygonOffsetFill)),
        (GL_PRIMITIVE_RESTART, Capability::Flag(Flag::PrimitiveRestart)),
        (GL_SCISSOR_TEST, Capability::Flag(Flag::ScissorTest)),
        (GL_STENCIL_TEST, Capability::Flag(Flag::StencilTest)),
        (GL_STENCIL_TEST_TWO_SIDE_EXT, Capability::Flag(Flag::StencilTestTwoSide)),
        (GL_TEXTURE_CUBE_MAP_SEAMLESS, Capability::Flag(Flag::SeamlessCubeMaps)),
        (GL_TEXTURE_1D, Capability::Texture(TextureTarget::D1)),
        (GL_TEXTURE_2D, Capability::Texture(TextureTarget::D2)),
        (GL_TEXTURE_3D, Capability::Texture(TextureTarget::D3)),
        (GL_TEXTURE_RECTANGLE, Capability::Texture(TextureTarget::Rect)),
        (GL_TEXTURE_CUBE_MAP, Capability::Texture(TextureTarget::Cube)),
    ],
};

/// Which flags are on.
#[derive(Clone, Debug)]
pub(crate) struct Enables(u32);

impl Default for Enables {
    fn default() -> Self {
        Self(1 << Flag::Dither as u32 | 1 << Flag::Multisample as u32)
    }
}

impl Enables {
    pub fn has(&self, flag: Flag) -> bool {
        self.0 >> flag as u32 & 1 == 1
    }

    pub fn set(&mut self, flag: Flag, on: bool) {
        self.0 = self.0 & !(1 << flag as u32) | u32::from(on) << flag as u32;
    }
}

fn switch(context: &mut Context, cap: GLenum, on: bool) -> Result<()> {
    match CAPABILITY.decode("cap", cap)? {
        Capability::Flag(flag) => {
            context.state.enables.set(flag, on);
            if flag == Flag::Blend {
                for buffer in &mut context.state.fragment.buffers {
                    buffer.blend = on;
                }
            }
        }
        Capability::Texture(target) => {
            context.state.units.active_coordinates("GL 2.1, section 3.8.16")?;
            context.state.units.active_mut().enabled[target as usize] = on;
        }
        Capability::DebugOutput => {
            context.debug.output = if on { Output::On } else { Output::Off };
        }
    }
    Ok(())
}

pub(crate) fn enable(context: &mut Context, cap: GLenum) -> Result<()> {
    switch(context, cap, true)
}

pub(crate) fn disable(context: &mut Context, cap: GLenum) -> Result<()> {
    switch(context, cap, false)
}

pub(crate) fn is_enabled(context: &mut Context, cap: GLenum) -> Result<bool> {
    is_on(context, cap)
}

/// Whether a capability or a client array is on.
pub(crate) fn is_on(context: &Context, cap: GLenum) -> Result<bool> {
    if let Some(location) = CLIENT_ARRAY.get(cap) {
        return Ok(context.state.arrays.by_location[client_location(context, location)].enabled);
    }
    Ok(match CAPABILITY.decode("cap", cap)? {
        Capability::Flag(flag) => context.state.enables.has(flag),
        Capability::Texture(target) => context.state.units.active().enabled[target as usize],
        Capability::DebugOutput => context.debug.output == Output::On,
    })
}

/// The conventional arrays, as their attribute location.
pub(crate) const CLIENT_ARRAY: Table<u8> = Table {
    section: "GL 2.1, section 2.8",
    rows: &[
        (GL_VERTEX_ARRAY, ATTRIB_VERTEX),
        (GL_NORMAL_ARRAY, ATTRIB_NORMAL),
        (GL_COLOR_ARRAY, ATTRIB_COLOR),
        (GL_SECONDARY_COLOR_ARRAY, ATTRIB_SECONDARY_COLOR),
        (GL_FOG_COORD_ARRAY, ATTRIB_FOG_COORD),
        (GL_TEXTURE_COORD_ARRAY, ATTRIB_TEX_COORD),
    ],
};

/// The location with the client's active texture unit applied.
fn client_location(context: &Context, location: u8) -> usize {
    let unit = if location == ATTRIB_TEX_COORD { context.state.units.client_active } else { 0 };
    usize::from(location + unit)
}

fn switch_client(context: &mut Context, array: GLenum, on: bool) -> Result<()> {
    // NV_primitive_restart has it among the client's arrays.
    if array == GL_PRIMITIVE_RESTART_NV {
        context.state.enables.set(Flag::PrimitiveRestart, on);
        return Ok(());
    }
    let location = client_location(context, CLIENT_ARRAY.decode("array", array)?);
    context.state.arrays.by_location[location].enabled = on;
    Ok(())
}

pub(crate) fn enable_client_state(context: &mut Context, array: GLenum) -> Result<()> {
    switch_client(context, array, true)
}

pub(crate) fn disable_client_state(context: &mut Context, array: GLenum) -> Result<()> {
    switch_client(context, array, false)
}
