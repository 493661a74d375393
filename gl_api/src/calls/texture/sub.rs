//! `glTexSubImage1D`, `2D` and `3D`: GL 2.1, section 3.8.2.

use crate::base::args::Data;
use crate::base::error::{Result, invalid_operation, invalid_value, not_negative};
use crate::base::types::*;
use crate::calls::pixels::memory::pixel_source;
use crate::calls::texture::bound::{bound, bound_mut};
use crate::calls::texture::specify::{extent, kinds_match};
use crate::context::Context;
use crate::objects::target::{Dimensions, FaceTarget, checked_level};
use crate::pixel::client::Pixel;
use crate::pixel::layout::Layout;
use crate::pixel::memory::Source;
use crate::pixel::scratch::scratch;
use crate::pixel::storage_error::storage_error;
use crate::pixel::{blocks, convert, es_texels};
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{ImageError, Level};

const SECTION: &str = "GL 2.1, section 3.8.2";

/// A box of a level of the bound texture, which a call is to overwrite: it exists, and lies inside the level or its
/// border.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct BoxRequest {
    target: FaceTarget,
    pub level: usize,
    /// The level's format.
    pub format: Format,
    /// Width, height and depth of the level.
    level_size: [u32; 3],
    /// The lowest corner within the level; -1 is the border.
    at: [i32; 3],
    /// Width, height and depth within the level.
    pub size: [u32; 3],
}

impl BoxRequest {
    pub fn new(
        context: &Context,
        target: FaceTarget,
        level: GLint,
        offset: [GLint; 3],
        size: [GLsizei; 3],
    ) -> Result<Self> {
        let level = checked_level(SECTION, target.target, level)?;
        for (argument, side) in ["width", "height", "depth"].into_iter().zip(size) {
            not_negative(SECTION, argument, side.into())?;
        }
        let image = bound(context, target.target).image.texels();
        let Some(texels) = image.level(target.face.into(), level) else {
            return invalid_operation(
                SECTION,
                format!(
                    "level {level} has no image yet: call {} first",
                    target.target.shape().image_call()
                ),
            );
        };
        let limits = target.target.level_box(texels.size());
        let borders = target.target.level_box(texels.border);
        let names = [("xoffset", "width"), ("yoffset", "height"), ("zoffset", "depth")];
        for (axis, (name, argument)) in names.into_iter().enumerate() {
            let (at, side) = (offset[axis], size[axis]);
            let (low, high) = (-i64::from(borders[axis]), i64::from(limits[axis] + borders[axis]));
            if i64::from(at) < low || i64::from(at) + i64::from(side) > high {
                return invalid_value(
                    SECTION,
                    format!("{name} = {at} and {argument} = {side} reach outside {low} to {high}"),
                );
            }
        }
        Ok(Self {
            target,
            level,
            format: texels.format,
            level_size: texels.size(),
            at: target.target.level_box(offset),
            size: target.target.level_box(size.map(|side| side as u32)),
        })
    }

    /// Refuses a box that cuts blocks of a compressed level (`EXT_texture_compression_s3tc`, section 3.8.2). Every call
    /// checks its pixels first.
    pub fn check_blocks(&self) -> Result<()> {
        if self.format.block().is_none() {
            return Ok(());
        }
        self.check_blocks_of(self.format.block_side())
    }

    /// The same for blocks of this side, whatever is stored.
    pub fn check_blocks_of(&self, side: u32) -> Result<()> {
        let &Self { at, size, level_size, .. } = self;
        let cuts = |axis: usize| {
            let reaches_edge =
                i64::from(at[axis]) + i64::from(size[axis]) >= level_size[axis].into();
            at[axis].rem_euclid(side as i32) != 0
                || !size[axis].is_multiple_of(side) && !reaches_edge
        };
        match cuts(0) || cuts(1) {
            true => Err(storage_error(SECTION, &ImageError::CutsBlocks { at, size })),
            false => Ok(()),
        }
    }

    /// Overwrites the box with texels of the level's format.
    pub fn apply(&self, context: &mut Context, texels: &[u8]) -> Result<()> {
        let (target, face) = (self.target.target, self.target.face.into());
        let image = bound(context, target).image.clone();
        crate::draw::pass::submit_draws_to(context, &image);
        let isa = context.recorder.isa();
        // Its plan reads the texels: while it is there they would be copied first.
        bound_mut(context, target).texels_changed();
        if image.update(|image| is_expensive_to_copy(image.level(face, self.level))) {
            crate::draw::pass::submit(context);
        }
        let texture = bound_mut(context, target);
        let written = texture.image.update(|image| {
            image.unshare(face, self.level)?;
            image
                .level_mut(face, self.level)
                .map_or(Ok(()), |level| level.write_box(self.at, self.size, texels))
        });
        written.map_err(|error| storage_error(SECTION, &error))?;
        crate::calls::texture::mipmap::base_level_changed(isa, texture, face, self.level)
    }

    /// Overwrites the box with tightly packed texels of [`Self::transfer_format`].
    pub fn apply_converted(&self, context: &mut Context, texels: &[u8]) -> Result<()> {
        if self.format.block().is_some() {
            let level = blocks::compress(self.format, self.size, texels)?;
            return self.apply(context, convert::texels(&level));
        }
        self.apply(context, texels)
    }

    /// The format that pixels are converted to: the level's, or that of colours which are compressed then.
    fn transfer_format(&self) -> Format {
        if self.format.block().is_some() { blocks::COLORS } else { self.format }
    }
}

/// Whether to copy a level for draws that wait costs more than to carry these out before it is written to.
fn is_expensive_to_copy(level: Option<&Arc<Level>>) -> bool {
    const EXPENSIVE: usize = 1 << 19;
    level.is_some_and(|level| level.texels.len() >= EXPENSIVE && Arc::strong_count(level) > 1)
}

/// A checked `glTexSubImage`: the box, and the pixels that go there.
struct TexSubImageRequest<'a> {
    area: BoxRequest,
    layout: Layout,
    source: Source<'a>,
}

impl<'a> TexSubImageRequest<'a> {
    /// `None` for a box without texels.
    fn new(
        context: &mut Context,
        area: BoxRequest,
        layout: Layout,
        pixels: Data<'a>,
    ) -> Result<Option<Self>> {
        if layout.needed == 0 {
            return Ok(None);
        }
        let Some(source) = pixel_source(context, "glTexSubImage", &layout, pixels)? else {
            return invalid_operation(
                SECTION,
                format!("pixels must not be NULL: {} bytes are needed", layout.needed),
            );
        };
        area.check_blocks()?;
        Ok(Some(Self { area, layout, source }))
    }

    fn apply(self, context: &mut Context) -> Result<()> {
        let Self { area, layout, source } = self;
        let (isa, transfer) = (context.recorder.isa(), &context.state.transfer);
        let (bytes, format) = (source.bytes(), area.transfer_format());
        if let Some(texels) = convert::as_texels(isa, &layout, bytes, area.format, transfer) {
            return area.apply(context, texels);
        }
        let mut texels = scratch(format, layout.size)?;
        convert::unpack(isa, &layout, bytes, format, transfer, &mut texels);
        area.apply_converted(context, &texels)
    }
}

fn tex_sub_image(
    context: &mut Context,
    (dimensions, target): (Dimensions, GLenum),
    level: GLint,
    offset: [GLint; 3],
    size: [GLsizei; 3],
    (format, ty): (GLenum, GLenum),
    pixels: Data<'_>,
) -> Result<()> {
    let target = dimensions.bound(target)?;
    let is_es = context.profile.is_es();
    let pixel = if is_es { Pixel::new_in_es(format, ty) } else { Pixel::new(format, ty) }?;
    let area = BoxRequest::new(context, target, level, offset, size)?;
    let internal = bound(context, target.target).internal(target.face.into(), area.level);
    kinds_match(pixel, area.format, internal)?;
    if is_es {
        es_texels::check_replaced(internal, format, ty)?;
    }
    let size = size.map(|side| side as usize);
    let layout = Layout::new(&context.state.unpack, pixel, size, extent(dimensions))?;
    match TexSubImageRequest::new(context, area, layout, pixels)? {
        Some(request) => request.apply(context),
        None => Ok(()),
    }
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn tex_sub_image_1d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    xoffset: GLint,
    width: GLsizei,
    format: GLenum,
    ty: GLenum,
    pixels: Data<'_>,
) -> Result<()> {
    let target = (Dimensions::One, target);
    tex_sub_image(context, target, level, [xoffset, 0, 0], [width, 1, 1], (format, ty), pixels)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn tex_sub_image_2d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    width: GLsizei,
    height: GLsizei,
    format: GLenum,
    ty: GLenum,
    pixels: Data<'_>,
) -> Result<()> {
    let (target, offset) = ((Dimensions::Two, target), [xoffset, yoffset, 0]);
    tex_sub_image(context, target, level, offset, [width, height, 1], (format, ty), pixels)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn tex_sub_image_3d(
    context: &mut Context,
    target: GLenum,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    zoffset: GLint,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
    format: GLenum,
    ty: GLenum,
    pixels: Data<'_>,
) -> Result<()> {
    let (target, offset) = ((Dimensions::Three, target), [xoffset, yoffset, zoffset]);
    tex_sub_image(context, target, level, offset, [width, height, depth], (format, ty), pixels)
}

#[cfg(test)]
mod tests {
    use crate::base::constants::*;
    use crate::calls::texture::sub::*;
    use crate::context::ContextDesc;

    /// Whether a draw still waits after a texel of the texture that it reads was written.
    fn waits(size: GLsizei) -> bool {
        let mut c = Context::new(ContextDesc::default()).expect("a device");
        let target = GL_TEXTURE_2D;
        let (internal, data) = (GL_RGBA8 as GLint, Data::Null);
        c.tex_image_2d(target, 0, internal, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
        c.tex_parameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR as GLint);
        c.enable(target);
        c.rectf(-1.0, -1.0, 1.0, 1.0);
        let texel = Data::Bytes(&[9; 4]);
        c.tex_sub_image_2d(target, 0, 3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel);
        assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
        c.recorder.is_waiting()
    }

    #[test]
    fn draws_are_carried_out_where_a_copy_for_them_would_be_expensive() {
        assert!(waits(64) && !waits(512));
    }
}
