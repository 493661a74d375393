//! Reading a part of a level back, by the texture's name: `ARB_get_texture_sub_image`; and all faces of a level of a cube
//! map (`ARB_direct_state_access`, section 8.11.4).

use crate::base::args::DataOut;
use crate::base::error::{Result, invalid_operation, invalid_value, not_negative};
use crate::base::types::*;
use crate::calls::texture::bound::ChosenTexture;
use crate::calls::texture::get::{check_readable, extent, requested_pixel};
use crate::context::Context;
use crate::objects::target::{TextureTarget, checked_level};
use crate::pixel::client::format::LuminanceOf;
use crate::pixel::layout::{Extent, Layout};
use crate::pixel::transfer::Transfer;
use crate::pixel::{blocks, convert};
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{Image, Level};

const SECTION: &str = "ARB_get_texture_sub_image, section 8.11.4";

/// A box of texels of a level; the faces of a cube are its images.
pub(crate) struct TexelBox {
    target: TextureTarget,
    /// The internal format that was asked for.
    internal: GLenum,
    level: usize,
    texels: Image,
    offset: [usize; 3],
    size: [usize; 3],
    /// Width, height and depth of the level.
    level_size: [usize; 3],
}

impl TexelBox {
    /// # Errors
    /// Where there is no such texture or level, or the box reaches out of it.
    fn new(
        context: &mut Context,
        name: GLuint,
        level: GLint,
        offset: [GLint; 3],
        size: [GLsizei; 3],
    ) -> Result<Self> {
        let texture = ChosenTexture::named(context, name)?;
        let level = Self::level(context, &texture, level)?;
        let offset = checked(["xoffset", "yoffset", "zoffset"], offset)?;
        let size = checked(["width", "height", "depth"], size)?;
        for (axis, level_end) in level.level_size.iter().enumerate() {
            let end = offset[axis] + size[axis];
            if end > *level_end {
                let axis = ["x", "y", "z"][axis];
                return invalid_value(
                    SECTION,
                    format!("the box ends at {axis} = {end}; the level has {level_end}"),
                );
            }
        }
        Ok(Self { offset, size, ..level })
    }

    /// All of a level.
    ///
    /// # Errors
    /// As the faces of a cube map differ.
    pub fn level(context: &mut Context, texture: &ChosenTexture, level: GLint) -> Result<Self> {
        let (target, image) = (texture.target, texture.get(context).image.clone());
        if target.is_multisample() || target == TextureTarget::Buffer {
            return invalid_operation(
                SECTION,
                "a texture with several samples has no texels to read, nor has one of a buffer",
            );
        }
        let level = checked_level(SECTION, target, level)?;
        let internal = texture.get(context).internal(0, level);
        crate::draw::pass::submit_draws_to(context, &image);
        let texels = image.texels();
        let faces = texels.shape().faces();
        let kind = |face| texels.level(face, level).map(|level| (level.size(), level.format));
        let (first, others) = (kind(0), 1..faces);
        if faces > 1 && (first.is_none() || others.map(kind).any(|other| other != first)) {
            return invalid_operation(SECTION, "the faces of the cube map are not all alike there");
        }
        // A level without an image has no texels.
        let mut level_size = first.map_or([0; 3], |(size, _)| target.level_box(size));
        if faces > 1 {
            level_size[2] = faces as u32;
        }
        let level_size = level_size.map(|side| side as usize);
        let (offset, size) = ([0; 3], level_size);
        Ok(Self { target, internal, level, texels, offset, size, level_size })
    }

    /// The faces that it reaches into.
    fn faces(&self) -> std::ops::Range<usize> {
        match self.texels.shape().faces() {
            1 => 0..usize::from(!self.size.contains(&0)),
            _ => self.offset[2]..self.offset[2] + self.size[2],
        }
    }

    /// The levels of these faces.
    fn levels(&self) -> impl Iterator<Item = &Arc<Level>> {
        self.faces().filter_map(|face| self.texels.level(face, self.level))
    }

    /// The format of the texels, if there are any.
    fn format(&self) -> Option<Format> {
        self.levels().next().map(|level| level.format)
    }

    /// Its texels out of those of a level, in units of `side` by `side` texels of so many bytes,
    /// which lie so far within what is stored.
    fn append_texels(&self, all: &[u8], unit: StorageUnit, out: &mut Vec<u8>) {
        let StorageUnit { side, bytes, border } = unit;
        let sides = [side, side, 1];
        let stored: [usize; 3] = std::array::from_fn(|axis| {
            self.level_size[axis].div_ceil(sides[axis]) + 2 * border[axis]
        });
        let first: [usize; 3] =
            std::array::from_fn(|axis| self.offset[axis] / sides[axis] + border[axis]);
        let count: [usize; 3] = std::array::from_fn(|axis| self.size[axis].div_ceil(sides[axis]));
        let is_cube = self.target == TextureTarget::Cube;
        let images = if is_cube { 0..1 } else { first[2]..first[2] + count[2] };
        for z in images {
            for y in first[1]..first[1] + count[1] {
                let start = ((z * stored[1] + y) * stored[0] + first[0]) * bytes;
                out.extend_from_slice(&all[start..start + count[0] * bytes]);
            }
        }
    }
}

/// What a level is stored in.
struct StorageUnit {
    /// How many texels wide and high.
    side: usize,
    bytes: usize,
    /// Along each axis, in front of the first.
    border: [usize; 3],
}

fn checked(names: [&str; 3], values: [GLint; 3]) -> Result<[usize; 3]> {
    let [x, y, z] = names;
    let value = |name, value: GLint| not_negative(SECTION, name, value.into());
    Ok([value(x, values[0])?, value(y, values[1])?, value(z, values[2])?])
}

pub(crate) fn check_size(needed: usize, size: GLsizei) -> Result<()> {
    if usize::try_from(size).is_ok_and(|size| needed <= size) {
        return Ok(());
    }
    invalid_operation(SECTION, format!("bufSize = {size}, but {needed} bytes are needed"))
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn get_texture_sub_image(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    zoffset: GLint,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
    format: GLenum,
    ty: GLenum,
    buf_size: GLsizei,
    pixels: DataOut<'_>,
) -> Result<()> {
    let (offset, size) = ([xoffset, yoffset, zoffset], [width, height, depth]);
    let texel_box = TexelBox::new(context, texture, level, offset, size)?;
    read_box(context, &texel_box, (format, ty), (buf_size, pixels))
}

/// Reads the texels of a box as the client's pixels.
pub(crate) fn read_box(
    context: &mut Context,
    texel_box: &TexelBox,
    (format, ty): (GLenum, GLenum),
    (buf_size, pixels): (GLsizei, DataOut<'_>),
) -> Result<()> {
    let pixel = requested_pixel(SECTION, format, ty)?;
    let Some(format) = texel_box.format() else { return Ok(()) };
    check_readable(pixel, format, texel_box.internal)?;
    // Its faces are layers here.
    let is_cube = texel_box.target == TextureTarget::Cube;
    let extent = if is_cube { Extent::Volume } else { extent(texel_box.target) };
    let layout = Layout::new(&context.state.pack, pixel, texel_box.size, extent)?;
    check_size(layout.needed, buf_size)?;
    // As of glGetTexImage, no transfer operations are performed.
    let (isa, transfer) = (context.recorder.isa(), Transfer::default());
    let (mut texels, mut stored) = (Vec::new(), format);
    for level in texel_box.levels() {
        if level.format.block().is_some() {
            stored = blocks::COLORS;
            let unit = StorageUnit { side: 1, bytes: stored.bytes(), border: [0; 3] };
            let colors = blocks::rows(isa, level).collect::<Vec<_>>().concat();
            texel_box.append_texels(&colors, unit, &mut texels);
        } else {
            let border = texel_box.target.level_box(level.border).map(|side| side as usize);
            let unit = StorageUnit { side: 1, bytes: format.bytes(), border };
            texel_box.append_texels(convert::texels(level), unit, &mut texels);
        }
    }
    crate::calls::pixels::memory::write_pixels(context, &layout, pixels, |bytes| {
        convert::pack(isa, &layout, stored, &transfer, LuminanceOf::Red, &texels, bytes);
    })
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn get_compressed_texture_sub_image(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    zoffset: GLint,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
    buf_size: GLsizei,
    pixels: DataOut<'_>,
) -> Result<()> {
    let (offset, size) = ([xoffset, yoffset, zoffset], [width, height, depth]);
    let texel_box = TexelBox::new(context, texture, level, offset, size)?;
    read_blocks_of_box(context, &texel_box, (buf_size, pixels))
}

/// Reads the blocks of a box of a compressed level.
pub(crate) fn read_blocks_of_box(
    context: &mut Context,
    texel_box: &TexelBox,
    (buf_size, pixels): (GLsizei, DataOut<'_>),
) -> Result<()> {
    let Some(format) = texel_box.format() else { return Ok(()) };
    if format.block().is_none() {
        return invalid_operation(SECTION, "the level is not compressed: use glGetTextureSubImage");
    }
    let side = format.block_side() as usize;
    for axis in [0, 1] {
        let (start, end) = (texel_box.offset[axis], texel_box.offset[axis] + texel_box.size[axis]);
        let ends = end.is_multiple_of(side) || end == texel_box.level_size[axis];
        if !start.is_multiple_of(side) || !ends {
            return invalid_value(
                SECTION,
                format!("the box from {start} to {end} cuts blocks of {side} texels"),
            );
        }
    }
    let mut all = Vec::new();
    for level in texel_box.levels() {
        let unit = StorageUnit { side, bytes: format.bytes(), border: [0; 3] };
        texel_box.append_texels(convert::texels(level), unit, &mut all);
    }
    check_size(all.len(), buf_size)?;
    crate::calls::pixels::memory::write_bytes(context, pixels, all.len(), |out| {
        out[..all.len()].copy_from_slice(&all)
    })
}
