//! `glTexStorage1D`, `2D` and `3D`: immutable storage of all levels (`ARB_texture_storage`).

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum, invalid_operation, invalid_value};
use crate::base::types::*;
use crate::calls::texture::bound::ChosenTexture;
use crate::calls::texture::level_request::{
    Destination, ImageRequest, LevelDesc, LevelRequest, ProxyRequest,
};
use crate::context::Context;
use crate::objects::egl_images::Specified;
use crate::objects::target::{FaceTarget, ImageTarget, TextureTarget};
use crate::pixel::etc;
use crate::pixel::formats::{InternalFormat, sized_format};
use texunit::image::Image as Texels;

const SECTION: &str = "ARB_texture_storage, section 3.8.X";

const fn texture(target: TextureTarget) -> ImageTarget {
    ImageTarget::Bound(FaceTarget { target, face: 0 })
}

pub(crate) const STORAGE_1D: Table<ImageTarget> = Table {
    section: SECTION,
    rows: &[
        (GL_TEXTURE_1D, texture(TextureTarget::D1)),
        (GL_PROXY_TEXTURE_1D, ImageTarget::Proxy(TextureTarget::D1)),
    ],
};

pub(crate) const STORAGE_2D: Table<ImageTarget> = Table {
    section: SECTION,
    rows: &[
        (GL_TEXTURE_2D, texture(TextureTarget::D2)),
        (GL_TEXTURE_RECTANGLE, texture(TextureTarget::Rect)),
        (GL_TEXTURE_CUBE_MAP, texture(TextureTarget::Cube)),
        (GL_TEXTURE_1D_ARRAY, texture(TextureTarget::D1Array)),
        (GL_PROXY_TEXTURE_2D, ImageTarget::Proxy(TextureTarget::D2)),
        (GL_PROXY_TEXTURE_RECTANGLE, ImageTarget::Proxy(TextureTarget::Rect)),
        (GL_PROXY_TEXTURE_CUBE_MAP, ImageTarget::Proxy(TextureTarget::Cube)),
        (GL_PROXY_TEXTURE_1D_ARRAY, ImageTarget::Proxy(TextureTarget::D1Array)),
    ],
};

pub(crate) const STORAGE_3D: Table<ImageTarget> = Table {
    section: SECTION,
    rows: &[
        (GL_TEXTURE_3D, texture(TextureTarget::D3)),
        (GL_TEXTURE_2D_ARRAY, texture(TextureTarget::D2Array)),
        (GL_TEXTURE_CUBE_MAP_ARRAY, texture(TextureTarget::CubeArray)),
        (GL_PROXY_TEXTURE_3D, ImageTarget::Proxy(TextureTarget::D3)),
        (GL_PROXY_TEXTURE_2D_ARRAY, ImageTarget::Proxy(TextureTarget::D2Array)),
        (GL_PROXY_TEXTURE_CUBE_MAP_ARRAY, ImageTarget::Proxy(TextureTarget::CubeArray)),
    ],
};

/// How many levels a call asks for, of those that sides of this length have.
fn checked_levels(target: TextureTarget, levels: GLsizei, size: [GLsizei; 3]) -> Result<usize> {
    if levels < 1 || size.iter().any(|side| *side < 1) {
        let [width, height, depth] = size;
        return invalid_value(
            SECTION,
            format!("levels = {levels} and the size {width}×{height}×{depth} must be at least 1"),
        );
    }
    let sides = &size[..target.shape().axes()];
    let largest = sides.iter().fold(1, |most, side| most.max(*side));
    let most = if target == TextureTarget::Rect { 1 } else { largest.ilog2() + 1 };
    if levels as u32 > most {
        return invalid_operation(
            SECTION,
            format!("levels = {levels}, but a side of {largest} has {most} levels"),
        );
    }
    Ok(levels as usize)
}

/// A checked `glTexStorage`.
pub(crate) enum StorageRequest {
    /// All levels that a texture is to have, with memory for them.
    Texture { texture: ChosenTexture, internal: GLenum, levels: usize, texels: Texels },
    /// The answers for all levels of a proxy.
    Proxy { target: TextureTarget, levels: Vec<ProxyRequest> },
}

impl StorageRequest {
    pub fn new(
        context: &Context,
        destination: Destination,
        levels: GLsizei,
        internal: GLenum,
        size: [GLsizei; 3],
    ) -> Result<Self> {
        let image = destination.image();
        let target = image.target();
        let in_profile =
            |format: &&InternalFormat| !context.profile.is_es() || format.is_for_textures_in_es();
        let row = sized_format(internal).filter(in_profile).map(|format| format.stored);
        let blocks = etc::find(internal)
            .filter(|format| context.profile.is_es() && format.name != GL_ETC1_RGB8_OES);
        if blocks.is_some() && target == TextureTarget::D3 {
            let rule = "this target takes no images of ETC2 or EAC";
            return invalid_operation("OpenGL ES 3.0, section 3.8.4", rule);
        }
        let Some(format) = row.or(blocks.map(|format| format.stored)) else {
            return invalid_enum(
                SECTION,
                format!(
                    "internalformat = {} must be sized, as GL_RGBA8 or GL_DEPTH_COMPONENT24",
                    enum_name(internal)
                ),
            );
        };
        let count = checked_levels(target, levels, size)?;
        if let Destination::Texture(texture) = &destination {
            let name = texture.name();
            if name == 0 || texture.get(context).immutable.is_some() {
                let why =
                    if name == 0 { "is the default one" } else { "has storage for good already" };
                return invalid_operation(SECTION, format!("texture {name} {why}: bind another"));
            }
        }
        let (mut levels, mut proxies) = (Vec::new(), Vec::new());
        let mut side = target.level_box(size.map(|side| side as u32));
        for level in 0..count as GLint {
            let given = target.level_box(side).map(|side| side as GLsizei);
            let desc = LevelDesc::new(image, level, internal, format, given, 0)?;
            match desc.request_of(context, &destination)? {
                ImageRequest::Texture(request) => levels.push(request),
                ImageRequest::Proxy(request) => {
                    let fits = request.image.is_some();
                    proxies.push(request);
                    if !fits {
                        break;
                    }
                }
            }
            side = target.shape().halved(side);
        }
        Ok(match destination {
            Destination::Texture(texture) => {
                let texels = storage(texture.target, &levels)?;
                Self::Texture { texture, internal, levels: levels.len(), texels }
            }
            Destination::Proxy(target) => Self::Proxy { target, levels: proxies },
        })
    }

    pub fn apply(self, context: &mut Context) {
        match self {
            Self::Texture { texture, internal, levels, texels } => {
                store(context, &texture, (internal, levels), texels);
            }
            // One level that cannot be stored is enough for the proxy to say so.
            Self::Proxy { target, levels } if levels.iter().any(|level| level.image.is_none()) => {
                context.state.proxies[target as usize] = Default::default();
            }
            Self::Proxy { levels, .. } => {
                levels.into_iter().for_each(|level| level.apply(context));
            }
        }
    }
}

/// Memory for all levels of a texture, its bytes all 0.
fn storage(target: TextureTarget, levels: &[LevelRequest]) -> Result<Texels> {
    let mut all = Texels::new(target.shape());
    for (number, level) in levels.iter().enumerate() {
        for face in 0..target.shape().faces() {
            all.set_level(face, number, level.storage()?)
                .map_err(|error| crate::pixel::storage_error::storage_error(SECTION, &error))?;
        }
    }
    Ok(all)
}

/// Replaces all levels that a texture has.
fn store(
    context: &mut Context,
    texture: &ChosenTexture,
    (internal, levels): (GLenum, usize),
    texels: Texels,
) {
    let image = texture.get(context).image.clone();
    crate::draw::pass::submit_draws_to(context, &image);
    let texture = texture.get_mut(context);
    texture.specify(Specified::All);
    texture.image.update(|image| *image = texels);
    for requested in &mut texture.requested {
        requested.fill(GL_NONE);
        requested[..levels].fill(internal);
    }
    texture.make_immutable(levels as u32);
    texture.texels_changed();
}

pub(crate) fn tex_storage_1d(
    context: &mut Context,
    target: GLenum,
    levels: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
) -> Result<()> {
    let image = STORAGE_1D.decode("target", target)?;
    let to = Destination::new(context, image);
    StorageRequest::new(context, to, levels, internalformat, [width, 1, 1])?.apply(context);
    Ok(())
}

pub(crate) fn tex_storage_2d(
    context: &mut Context,
    target: GLenum,
    levels: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
) -> Result<()> {
    let image = STORAGE_2D.decode("target", target)?;
    let to = Destination::new(context, image);
    StorageRequest::new(context, to, levels, internalformat, [width, height, 1])?.apply(context);
    Ok(())
}

pub(crate) fn tex_storage_3d(
    context: &mut Context,
    target: GLenum,
    levels: GLsizei,
    internalformat: GLenum,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
) -> Result<()> {
    let image = STORAGE_3D.decode("target", target)?;
    let to = Destination::new(context, image);
    StorageRequest::new(context, to, levels, internalformat, [width, height, depth])?
        .apply(context);
    Ok(())
}
