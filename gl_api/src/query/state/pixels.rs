//! Pixels: GL 2.1, tables 6.23 to 6.30.

use super::row::Read::*;
use super::row::{Row, rows, saturated};
use crate::base::constants::*;
use crate::context::Context;
use crate::pixel::map::{MAX_PIXEL_MAP_TABLE, PixelMapName};

fn map_size(context: &Context, name: PixelMapName) -> i32 {
    saturated(context.state.transfer.maps.map(name).entries().len())
}

pub(super) const ROWS: &[Row] = rows! {
    GL_UNPACK_SWAP_BYTES: Flag(|c| c.state.unpack.swap_bytes);
    GL_UNPACK_LSB_FIRST: Flag(|c| c.state.unpack.lsb_first);
    GL_UNPACK_ROW_LENGTH: Integer(|c| saturated(c.state.unpack.row_length));
    GL_UNPACK_SKIP_ROWS: Integer(|c| saturated(c.state.unpack.skip_rows));
    GL_UNPACK_SKIP_PIXELS: Integer(|c| saturated(c.state.unpack.skip_pixels));
    GL_UNPACK_IMAGE_HEIGHT: Integer(|c| saturated(c.state.unpack.image_height));
    GL_UNPACK_SKIP_IMAGES: Integer(|c| saturated(c.state.unpack.skip_images));
    GL_UNPACK_ALIGNMENT: Integer(|c| saturated(c.state.unpack.alignment));
    GL_PACK_SWAP_BYTES: Flag(|c| c.state.pack.swap_bytes);
    GL_PACK_LSB_FIRST: Flag(|c| c.state.pack.lsb_first);
    GL_PACK_ROW_LENGTH: Integer(|c| saturated(c.state.pack.row_length));
    GL_PACK_SKIP_ROWS: Integer(|c| saturated(c.state.pack.skip_rows));
    GL_PACK_SKIP_PIXELS: Integer(|c| saturated(c.state.pack.skip_pixels));
    GL_PACK_IMAGE_HEIGHT: Integer(|c| saturated(c.state.pack.image_height));
    GL_PACK_SKIP_IMAGES: Integer(|c| saturated(c.state.pack.skip_images));
    GL_PACK_ALIGNMENT: Integer(|c| saturated(c.state.pack.alignment));
    GL_PIXEL_PACK_BUFFER_BINDING: Word(|c| c.state.bindings.pixel_pack_buffer.name());
    GL_PIXEL_UNPACK_BUFFER_BINDING: Word(|c| c.state.bindings.pixel_unpack_buffer.name());

    GL_MAP_COLOR: Flag(|c| c.state.transfer.map_color);
    GL_MAP_STENCIL: Flag(|c| c.state.transfer.map_stencil);
    GL_INDEX_SHIFT: Integer(|c| c.state.transfer.index_shift);
    GL_INDEX_OFFSET: Integer(|c| c.state.transfer.index_offset);
    GL_RED_SCALE: Float(|c| c.state.transfer.linear[0].scale);
    GL_GREEN_SCALE: Float(|c| c.state.transfer.linear[1].scale);
    GL_BLUE_SCALE: Float(|c| c.state.transfer.linear[2].scale);
    GL_ALPHA_SCALE: Float(|c| c.state.transfer.linear[3].scale);
    GL_DEPTH_SCALE: Float(|c| c.state.transfer.linear[4].scale);
    GL_RED_BIAS: Float(|c| c.state.transfer.linear[0].bias);
    GL_GREEN_BIAS: Float(|c| c.state.transfer.linear[1].bias);
    GL_BLUE_BIAS: Float(|c| c.state.transfer.linear[2].bias);
    GL_ALPHA_BIAS: Float(|c| c.state.transfer.linear[3].bias);
    GL_DEPTH_BIAS: Float(|c| c.state.transfer.linear[4].bias);

    GL_ZOOM_X: Float(|c| c.state.pixel_zoom[0]);
    GL_ZOOM_Y: Float(|c| c.state.pixel_zoom[1]);
    GL_MAX_PIXEL_MAP_TABLE: Integer(|_| saturated(MAX_PIXEL_MAP_TABLE));
    GL_PIXEL_MAP_I_TO_I_SIZE: Integer(|c| map_size(c, PixelMapName::IToI));
    GL_PIXEL_MAP_S_TO_S_SIZE: Integer(|c| map_size(c, PixelMapName::SToS));
    GL_PIXEL_MAP_I_TO_R_SIZE: Integer(|c| map_size(c, PixelMapName::IToR));
    GL_PIXEL_MAP_I_TO_G_SIZE: Integer(|c| map_size(c, PixelMapName::IToG));
    GL_PIXEL_MAP_I_TO_B_SIZE: Integer(|c| map_size(c, PixelMapName::IToB));
    GL_PIXEL_MAP_I_TO_A_SIZE: Integer(|c| map_size(c, PixelMapName::IToA));
    GL_PIXEL_MAP_R_TO_R_SIZE: Integer(|c| map_size(c, PixelMapName::RToR));
    GL_PIXEL_MAP_G_TO_G_SIZE: Integer(|c| map_size(c, PixelMapName::GToG));
    GL_PIXEL_MAP_B_TO_B_SIZE: Integer(|c| map_size(c, PixelMapName::BToB));
    GL_PIXEL_MAP_A_TO_A_SIZE: Integer(|c| map_size(c, PixelMapName::AToA));
};
