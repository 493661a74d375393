//! `glTexSubImage1D`, `2D` and `3D`: GL 2.1, section 3.8.2.

use crate::base::args::Data;
use crate::base::error::{Result, invalid_operation, invalid_value, not_negative};
use crate::base::types::*;
use crate::calls::pixels::memory::pixel_source;
use crate::calls::texture::bound::{ChosenImage, ChosenTexture, Faces};
use crate::calls::texture::specify::{extent, kinds_match};
use crate::context::Context;
use crate::objects::target::{Dimensions, checked_level};
use crate::pixel::client::Pixel;
use crate::pixel::layout::Layout;
use crate::pixel::memory::Source;
use crate::pixel::scratch::scratch;
use crate::pixel::storage_error::storage_error;
use crate::pixel::{blocks, convert, es_texels};
use std::ops::Range;
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{FACES, ImageError, Level};

const SECTION: &str = "GL 2.1, section 3.8.2";

/// A box of a level of a texture, which a call is to overwrite: it exists, and lies inside the level or its border.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct BoxRequest {
    texture: ChosenTexture,
    /// The faces in which there is such a box, one after the other in the client's pixels.
    faces: Range<usize>,
    pub level: usize,
    /// The level's format.
    pub format: Format,
    /// Width, height and depth of the level.
    level_size: [u32; 3],
    /// The lowest corner within the level; -1 is the border.
    at: [i32; 3],
    /// Width, height and depth within the level.
    size: [u32; 3],
}

impl BoxRequest {
    pub fn new(
        context: &Context,
        image: ChosenImage,
        level: GLint,
        mut offset: [GLint; 3],
        mut size: [GLsizei; 3],
    ) -> Result<Self> {
        let ChosenImage { texture, faces } = image;
        let target = texture.target;
        let level = checked_level(SECTION, target, level)?;
        for (argument, side) in ["width", "height", "depth"].into_iter().zip(size) {
            not_negative(SECTION, argument, side.into())?;
        }
        let faces = match faces {
            Faces::One(face) => usize::from(face)..usize::from(face) + 1,
            Faces::Layers => {
                let faces = layers(offset[2], size[2])?;
                (offset[2], size[2]) = (0, 1);
                faces
            }
        };
        let image = texture.get(context).image.texels();
        let kind = |face| image.level(face, level).map(|level| (level.size(), level.format));
        let first = faces.start.min(FACES - 1);
        if faces.clone().any(|face| kind(face) != kind(first)) {
            return invalid_operation(
                "ARB_direct_state_access, section 8.6",
                format!("the faces of the cube map differ at level {level}"),
            );
        }
        let Some(texels) = image.level(first, level) else {
            return invalid_operation(
                SECTION,
                format!(
                    "level {level} has no image yet: call {} first",
                    target.shape().image_call()
                ),
            );
        };
        let limits = target.level_box(texels.size());
        let borders = target.level_box(texels.border);
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
            faces,
            level,
            format: texels.format,
            level_size: texels.size(),
            at: target.level_box(offset),
            size: target.level_box(size.map(|side| side as u32)),
            texture,
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
        if self.faces.is_empty() {
            return Ok(());
        }
        let image = self.texture.get(context).image.clone();
        crate::draw::pass::submit_draws_to(context, &image);
        let isa = context.recorder.isa();
        // Its plan reads the texels: while it is there they would be copied first.
        self.texture.get_mut(context).texels_changed();
        let first = self.faces.start;
        if image.update(|image| is_expensive_to_copy(image.level(first, self.level))) {
            crate::draw::pass::submit(context);
        }
        let texture = self.texture.get_mut(context);
        let bytes = texels.len() / self.faces.len();
        for (at, face) in self.faces.clone().enumerate() {
            let texels = &texels[at * bytes..(at + 1) * bytes];
            let written = texture.image.update(|image| {
                image.unshare(face, self.level)?;
                image
                    .level_mut(face, self.level)
                    .map_or(Ok(()), |level| level.write_box(self.at, self.size, texels))
            });
            written.map_err(|error| storage_error(SECTION, &error))?;
            crate::calls::texture::mipmap::base_level_changed(isa, texture, face, self.level)?;
        }
        Ok(())
    }

    /// The internal format that was asked for there.
    pub fn internal(&self, context: &Context) -> GLenum {
        self.texture.get(context).internal(self.faces.start.min(FACES - 1), self.level)
    }

    /// Width, height and depth of the client's pixels; faces are layers.
    pub fn pixels_size(&self) -> [u32; 3] {
        let [width, height, depth] = self.size;
        [width, height, depth * self.faces.len() as u32]
    }

    /// Overwrites the box with tightly packed texels of [`Self::transfer_format`].
    pub fn apply_converted(&self, context: &mut Context, texels: &[u8]) -> Result<()> {
        if self.format.block().is_some() {
            let level = blocks::compress(self.format, self.pixels_size(), texels)?;
            return self.apply(context, convert::texels(&level));
        }
        self.apply(context, texels)
    }

    /// The format that pixels are converted to: the level's, or that of colours which are compressed then.
    fn transfer_format(&self) -> Format {
        if self.format.block().is_some() { blocks::COLORS } else { self.format }
    }
}

/// The faces of a cube map that a box reaches into.
fn layers(offset: GLint, count: GLsizei) -> Result<Range<usize>> {
    let end = i64::from(offset) + i64::from(count);
    if offset < 0 || end > FACES as i64 {
        return invalid_value(
            SECTION,
            format!("zoffset = {offset} and depth = {count} reach outside 0 to {FACES}, the faces"),
        );
    }
    Ok(offset as usize..end as usize)
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
    kind: (GLenum, GLenum),
    pixels: Data<'_>,
) -> Result<()> {
    let image = ChosenImage::bound(context, dimensions.bound(target)?);
    replace_box(context, (dimensions, image), level, offset, size, kind, pixels)
}

/// Replaces a box of a level by the client's pixels.
pub(crate) fn replace_box(
    context: &mut Context,
    (dimensions, image): (Dimensions, ChosenImage),
    level: GLint,
    offset: [GLint; 3],
    size: [GLsizei; 3],
    (format, ty): (GLenum, GLenum),
    pixels: Data<'_>,
) -> Result<()> {
    let is_es = context.profile.is_es();
    let pixel = if is_es {
        Pixel::new_in_es(es_texels::plain_format(format), ty)
    } else {
        Pixel::new(format, ty)
    }?;
    let area = BoxRequest::new(context, image, level, offset, size)?;
    context.lists.charge_image(size);
    let internal = area.internal(context);
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
