//! The checks of every call that specifies a level (GL 2.1, section 3.8.1): [`LevelDesc`] is what such a call describes,
//! [`ImageRequest`] what is checked.

use crate::base::error::{Result, invalid_operation, invalid_value, not_negative};
use crate::base::types::*;
use crate::calls::texture::bound::ChosenTexture;
use crate::context::Context;
use crate::objects::egl_images::Specified;
use crate::objects::target::{FaceTarget, ImageTarget, TextureTarget, checked_level};
use crate::objects::texture::{Proxy, Samples};
use crate::pixel::storage_error::storage_error;
use texunit::format::Format;
use texunit::image::{FACES, Level};

const SECTION: &str = "GL 2.1, section 3.8.1";

/// A level as a call describes it. Checked by itself: not yet against the largest size, nor against the bound texture.
pub(crate) struct LevelDesc {
    pub image: ImageTarget,
    pub level: usize,
    pub internal: GLenum,
    pub format: Format,
    /// Width, height and depth as the call has them: with the border, layers of a one-dimensional
    /// array as height.
    pub given: [u32; 3],
    /// Width, height and depth of the level, without border.
    pub size: [u32; 3],
    pub border: u32,
    /// Of an image with several a texel.
    pub samples: Option<Samples>,
    /// The first side of `given` that is too large.
    oversized: Option<Oversized>,
}

struct Oversized {
    argument: &'static str,
    side: u32,
    most: u32,
}

impl LevelDesc {
    pub fn new(
        image: ImageTarget,
        level: GLint,
        internal: GLenum,
        format: Format,
        given: [GLsizei; 3],
        border: GLint,
    ) -> Result<Self> {
        let target = image.target();
        let level = checked_level(SECTION, target, level)?;
        let border = checked_border(target, border)?;
        if target == TextureTarget::D3 && format.is_depth() {
            return invalid_operation(SECTION, "three-dimensional textures have no depth formats");
        }
        if format.block().is_some() {
            checked_blocks(target, format, border)?;
        }
        let borders = target.level_box(target.shape().border(border));
        let (limits, axes) = (target.limits(), target.shape().axes());
        let (mut sides, mut oversized) = ([0; 3], None);
        for (axis, argument) in ["width", "height", "depth"].into_iter().enumerate() {
            let side = not_negative(SECTION, argument, given[axis].into())? as u32;
            let Some(inside) = side.checked_sub(2 * borders[axis]) else {
                return invalid_value(
                    SECTION,
                    format!("{argument} = {side} must be at least 2, as border = 1"),
                );
            };
            let limit = if axis < axes { limits[axis] >> level } else { limits[axis] };
            if inside > limit && oversized.is_none() {
                oversized = Some(Oversized { argument, side, most: limit + 2 * borders[axis] });
            }
            sides[axis] = inside;
        }
        let given = given.map(|side| side as u32);
        let [width, height, depth] = given;
        if target.shape().is_cube() && width != height {
            return invalid_value(
                SECTION,
                format!("width = {width} and height = {height} of a cube map's face must be equal"),
            );
        }
        if target == TextureTarget::CubeArray && !(depth as usize).is_multiple_of(FACES) {
            return invalid_value(
                "ARB_texture_cube_map_array, section 3.9.1",
                format!(
                    "depth = {depth} must be a multiple of 6: it counts the faces of all cubes"
                ),
            );
        }
        let size = target.level_box(sides);
        let samples = None;
        Ok(Self { image, level, internal, format, given, size, border, samples, oversized })
    }

    /// Checks the description against the largest size and the bound texture. A proxy refuses nothing.
    pub fn request(self, context: &Context) -> Result<ImageRequest> {
        let destination = Destination::new(context, self.image);
        self.request_of(context, &destination)
    }

    /// The same for a texture that may not be bound.
    pub fn request_of(self, context: &Context, destination: &Destination) -> Result<ImageRequest> {
        let texture = match destination {
            Destination::Texture(texture) => texture.clone(),
            &Destination::Proxy(target) => {
                let image = self.fits().then_some(Proxy {
                    size: self.size,
                    border: self.border,
                    internal: self.internal,
                    format: self.format,
                    samples: self.samples,
                });
                return Ok(ImageRequest::Proxy(ProxyRequest { target, level: self.level, image }));
            }
        };
        if let Some(Oversized { argument, side, most }) = self.oversized {
            let level = self.level;
            return invalid_value(
                SECTION,
                format!("{argument} = {side} must not be above {most} at level {level}"),
            );
        }
        if texture.get(context).immutable.is_some() {
            return invalid_operation(
                "ARB_texture_storage, section 3.8.X",
                "the texture's levels were given for good by glTexStorage: fill them with \
                 glTexSubImage",
            );
        }
        Ok(ImageRequest::Texture(LevelRequest { texture, desc: self }))
    }

    /// Whether such a level could be stored, as a proxy tells.
    fn fits(&self) -> bool {
        let borders = self.image.target().shape().border(self.border).map(|side| 2 * side);
        let has_bytes = || {
            let (width, height) = (self.size[0] + borders[0], self.size[1] + borders[1]);
            let slices = self.slices() + borders[2];
            Level::required_bytes(self.format, width, height, slices).is_some()
        };
        self.oversized.is_none() && has_bytes()
    }

    /// The slices of the level: every sample of a layer has one.
    fn slices(&self) -> u32 {
        self.size[2] * self.samples.map_or(1, |samples| samples.count.into())
    }
}

/// What a call specifies levels of.
pub(crate) enum Destination {
    Texture(ChosenTexture),
    /// A proxy, which tells whether such levels could be stored.
    Proxy(TextureTarget),
}

impl Destination {
    /// What a target names.
    pub fn new(context: &Context, image: ImageTarget) -> Self {
        match image {
            ImageTarget::Bound(face) => Self::Texture(ChosenTexture::bound(context, face.target)),
            ImageTarget::Proxy(target) => Self::Proxy(target),
        }
    }

    /// The image, or the first one, as a target names it.
    pub fn image(&self) -> ImageTarget {
        match self {
            Self::Texture(texture) => {
                ImageTarget::Bound(FaceTarget { target: texture.target, face: 0 })
            }
            &Self::Proxy(target) => ImageTarget::Proxy(target),
        }
    }
}

/// A checked call that specifies a level.
pub(crate) enum ImageRequest {
    Texture(LevelRequest),
    Proxy(ProxyRequest),
}

/// An answer that a proxy is to give.
pub(crate) struct ProxyRequest {
    pub target: TextureTarget,
    pub level: usize,
    /// `None` for an image that could not be stored.
    pub image: Option<Proxy>,
}

impl ProxyRequest {
    pub fn apply(self, context: &mut Context) {
        context.state.proxies[self.target as usize][self.level] = self.image;
    }
}

/// A level that a texture is to have.
pub(crate) struct LevelRequest {
    pub texture: ChosenTexture,
    pub desc: LevelDesc,
}

impl LevelRequest {
    /// Memory for the level, its bytes all 0.
    pub fn storage(&self) -> Result<Level> {
        let border = self.desc.image.target().shape().border(self.desc.border);
        let [width, height, _] = self.desc.size;
        Level::with_size(self.desc.format, [width, height, self.desc.slices()], border)
            .map_err(|error| storage_error(SECTION, &error))
    }

    /// Puts the level in place, with these texels, and lets everything that depends on it know.
    pub fn apply(self, context: &mut Context, texels: Level) -> Result<()> {
        let Self { texture, desc: LevelDesc { image, level, internal, .. } } = self;
        let face = match image {
            ImageTarget::Bound(face) => usize::from(face.face),
            ImageTarget::Proxy(_) => return Ok(()),
        };
        let image = texture.get(context).image.clone();
        crate::draw::pass::submit_draws_to(context, &image);
        let isa = context.recorder.isa();
        let texture = texture.get_mut(context);
        texture.specify(Specified::One { face, level });
        texture
            .image
            .update(|image| image.set_level(face, level, texels))
            .map_err(|error| storage_error(SECTION, &error))?;
        texture.requested[face][level] = internal;
        texture.texels_changed();
        crate::calls::texture::mipmap::base_level_changed(isa, texture, face, level)
    }
}

/// Blocks are of two dimensions, so that volumes are made of BPTC alone, slice by slice (GL 4.2, table 3.14), and have no
/// border.
fn checked_blocks(target: TextureTarget, format: Format, border: u32) -> Result<()> {
    const SECTION: &str = "EXT_texture_compression_s3tc, section 3.8.3";
    match target {
        TextureTarget::D3 if format.has_volumes() && border == 0 => Ok(()),
        TextureTarget::D2
        | TextureTarget::Cube
        | TextureTarget::D2Array
        | TextureTarget::CubeArray => match border {
            0 => Ok(()),
            _ => invalid_operation(SECTION, "compressed images have no border"),
        },
        TextureTarget::D1
        | TextureTarget::D3
        | TextureTarget::Rect
        | TextureTarget::External
        | TextureTarget::D1Array
        | TextureTarget::D2Multisample
        | TextureTarget::D2MultisampleArray
        | TextureTarget::Buffer => {
            invalid_operation(SECTION, "this target takes no compressed internalformat")
        }
    }
}

fn checked_border(target: TextureTarget, border: GLint) -> Result<u32> {
    match (target, border) {
        (_, 0) => Ok(0),
        (TextureTarget::Rect, _) => {
            invalid_value(SECTION, format!("border = {border} of a rectangle must be 0"))
        }
        (
            TextureTarget::D1
            | TextureTarget::D2
            | TextureTarget::External
            | TextureTarget::D3
            | TextureTarget::Cube
            | TextureTarget::D1Array
            | TextureTarget::D2Array
            | TextureTarget::CubeArray
            | TextureTarget::D2Multisample
            | TextureTarget::D2MultisampleArray
            | TextureTarget::Buffer,
            1,
        ) => Ok(1),
        (_, _) => invalid_value(SECTION, format!("border = {border} must be 0 or 1")),
    }
}
