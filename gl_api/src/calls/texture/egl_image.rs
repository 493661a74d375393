//! EGL images as the storage of textures and renderbuffers (`OES_EGL_image`), and how they are made from these
//! (EGL 1.5, section 3.9; `EGL_KHR_gl_image`).

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum, invalid_operation, invalid_value};
use crate::base::limits;
use crate::base::types::*;
use crate::calls::texture::bound::ChosenTexture;
use crate::context::Context;
use crate::context::sharing::ShareHandle;
use crate::objects::egl_images::{self, EglImage, SourceLevel};
use crate::objects::renderbuffers::{RENDERBUFFER_TARGET, Renderbuffer};
use crate::objects::target::{TARGET, TextureTarget};
use crate::objects::texture::Texture;
use crate::pixel::formats::{self, Renderable};
use rasterizer::driver::{Image, ViewDesc};
use std::sync::Arc;
use texunit::image::Shape;
use texunit::sampler::{Filter, Mipmap, Sampler};

const SECTION: &str = "OES_EGL_image, section 3.7.2";
const RENDERBUFFERS: &str = "OES_EGL_image, section 4.4.2.1";

/// What an image is made from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EglImageSource {
    /// A level of a two-dimensional texture.
    Texture2D {
        /// Its name.
        texture: GLuint,
        /// Which level.
        level: u32,
    },
    /// A level of a face of a cube map.
    CubeMapFace {
        /// Its name.
        texture: GLuint,
        /// Which face: 0 is +x, as of GL's targets.
        face: u8,
        /// Which level.
        level: u32,
    },
    /// A slice of a level of a volume.
    Texture3D {
        /// Its name.
        texture: GLuint,
        /// Which level.
        level: u32,
        /// Which slice.
        slice: u32,
    },
    /// A renderbuffer of one sample a pixel.
    Renderbuffer(GLuint),
}

/// Why no image can be made, by EGL's error.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EglImageError {
    /// `EGL_BAD_PARAMETER`, and the rule.
    BadParameter(String),
    /// `EGL_BAD_MATCH`, and the rule.
    BadMatch(String),
    /// `EGL_BAD_ACCESS`, and the rule.
    BadAccess(String),
}

impl std::fmt::Display for EglImageError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::BadParameter(rule) => write!(f, "EGL_BAD_PARAMETER: {rule}"),
            Self::BadMatch(rule) => write!(f, "EGL_BAD_MATCH: {rule}"),
            Self::BadAccess(rule) => write!(f, "EGL_BAD_ACCESS: {rule}"),
        }
    }
}

impl std::error::Error for EglImageError {}

type Made<T> = std::result::Result<T, EglImageError>;

fn bad_parameter<T>(rule: String) -> Made<T> {
    Err(EglImageError::BadParameter(rule))
}

/// A level of a texture as an image's source.
struct TextureLevel {
    name: GLuint,
    target: TextureTarget,
    at: SourceLevel,
}

impl TextureLevel {
    /// The level that a source is; the name of a renderbuffer if it is one.
    fn of(source: EglImageSource) -> std::result::Result<Self, GLuint> {
        let at = |face: u8, level: u32, slice: u32| SourceLevel {
            face: face.into(),
            level: level as usize,
            slice: slice as usize,
        };
        match source {
            EglImageSource::Texture2D { texture: name, level } => {
                Ok(Self { name, target: TextureTarget::D2, at: at(0, level, 0) })
            }
            EglImageSource::CubeMapFace { texture: name, face, level } => {
                Ok(Self { name, target: TextureTarget::Cube, at: at(face, level, 0) })
            }
            EglImageSource::Texture3D { texture: name, level, slice } => {
                Ok(Self { name, target: TextureTarget::D3, at: at(0, level, slice) })
            }
            EglImageSource::Renderbuffer(name) => Err(name),
        }
    }

    /// The image of the level.
    fn image(&self, texture: &Texture) -> Made<EglImage> {
        let &Self { name, target, at: SourceLevel { face, level, slice } } = self;
        let is = enum_name(TARGET.encode(texture.target));
        if texture.target != target {
            let asked = enum_name(TARGET.encode(target));
            return bad_parameter(format!("buffer = {name} is a {is}, target wants a {asked}"));
        }
        if face >= target.shape().faces() {
            return bad_parameter(format!("a cube map has no face {face}"));
        }
        check_complete(texture, name, level)?;
        let Some(info) = texture.image.level(face, level) else {
            let rule = format!("EGL_GL_TEXTURE_LEVEL = {level}: texture {name} has no such level");
            return Err(EglImageError::BadMatch(rule));
        };
        if info.border != [0; 3] {
            return bad_parameter(format!("level {level} of texture {name} has a border"));
        }
        if slice >= info.size[2] as usize {
            let depth = info.size[2];
            return bad_parameter(format!(
                "EGL_GL_TEXTURE_ZOFFSET = {slice} must be below {depth}, the depth of level {level}"
            ));
        }
        if texture.siblings.has(self.at) {
            let rule = format!("level {level} of texture {name} {SIBLING}");
            return Err(EglImageError::BadAccess(rule));
        }
        let layer = face + slice;
        let image = texture.image.view(ViewDesc {
            shape: Shape::D2,
            format: info.format,
            levels: level..level + 1,
            layers: layer..layer + 1,
        });
        Ok(EglImage { image, internal: texture.internal(face, level) })
    }
}

const SIBLING: &str =
    "is a sibling of an EGL image already: destroy that first, or make no second one";

/// Checks that a texture is complete as `EGL_KHR_gl_image` wants it for a level. For level 0 it need not be, where no other
/// level has been specified.
fn check_complete(texture: &Texture, name: GLuint, level: usize) -> Made<()> {
    if texture.immutable.is_some() {
        return Ok(());
    }
    let faces = 0..texture.target.shape().faces();
    let has = |level: usize| faces.clone().all(|face| texture.image.level(face, level).is_some());
    let mut others = (1..limits::MAX_TEXTURE_LEVELS)
        .flat_map(|level| faces.clone().map(move |face| (face, level)));
    let has_others = others.any(|(face, level)| texture.image.level(face, level).is_some());
    if level == 0 && has(0) && !has_others {
        return Ok(());
    }
    let chain = Sampler {
        min: Filter::Nearest,
        mag: Filter::Nearest,
        mipmap: Mipmap::Nearest,
        compare: None,
        max_anisotropy: 1.0,
        ..texture.sampler()
    };
    match texture.image.completeness(&chain) {
        Ok(_) => Ok(()),
        Err(reason) => bad_parameter(format!("texture {name} is incomplete: {reason}")),
    }
}

fn renderbuffer_image(renderbuffer: &Renderbuffer, name: GLuint) -> Made<EglImage> {
    let Some(info) = renderbuffer.level() else {
        return bad_parameter(format!(
            "renderbuffer {name} has no storage: call glRenderbufferStorage"
        ));
    };
    if info.samples > 1 {
        let samples = info.samples;
        return bad_parameter(format!(
            "renderbuffer {name} has {samples} samples a pixel: one is possible"
        ));
    }
    if renderbuffer.siblings.has(SourceLevel::default()) {
        return Err(EglImageError::BadAccess(format!("renderbuffer {name} {SIBLING}")));
    }
    let (shape, format) = (Shape::D2, info.format);
    let image = renderbuffer.image.view(ViewDesc { shape, format, levels: 0..1, layers: 0..1 });
    Ok(EglImage { image, internal: renderbuffer.format.name })
}

/// Makes an image from an object of a share group, and gives it a handle.
pub(crate) fn make(group: &ShareHandle, source: EglImageSource) -> Made<usize> {
    group.group.shared_with_others();
    let mut objects = group.group.lock();
    let image = match TextureLevel::of(source) {
        Ok(level) => {
            let name = level.name;
            let Some(texture) = objects.textures.get_mut(name) else {
                return bad_parameter(format!("buffer = {name} is no texture of ctx"));
            };
            let image = Arc::new(level.image(texture)?);
            texture.siblings.made(level.at, &image);
            image
        }
        Err(name) => {
            let Some(renderbuffer) = objects.renderbuffers.get_mut(name) else {
                return bad_parameter(format!("buffer = {name} is no renderbuffer of ctx"));
            };
            let image = Arc::new(renderbuffer_image(renderbuffer, name)?);
            renderbuffer.siblings.made(SourceLevel::default(), &image);
            image
        }
    };
    Ok(egl_images::publish(image))
}

/// The image of a handle that a client gives.
fn given(section: &'static str, handle: GLeglImageOES) -> Result<Arc<EglImage>> {
    match egl_images::find(handle as usize) {
        Some(image) => Ok(image),
        None => invalid_value(
            section,
            format!("image = {:#x} is no handle that eglCreateImage gave", handle as usize),
        ),
    }
}

/// Whether a context can have textures, or renderbuffers, of an internal format.
fn check_format(
    context: &Context,
    section: &'static str,
    internal: GLenum,
    object: &str,
    is_possible: impl Fn(&formats::InternalFormat) -> bool,
) -> Result<()> {
    // Blocks of OpenGL ES have no row, and are textures there.
    let possible = match formats::find(internal) {
        Some(row) => is_possible(row),
        None => context.profile.is_es() && object == "textures",
    };
    if possible {
        return Ok(());
    }
    let internal = enum_name(internal);
    invalid_operation(section, format!("the image is of {internal}, which no {object} here have"))
}

pub(crate) fn egl_image_target_texture_2d(
    context: &mut Context,
    target: GLenum,
    image: GLeglImageOES,
) -> Result<()> {
    const TARGETS: Table<TextureTarget> = Table {
        section: SECTION,
        rows: &[
            (GL_TEXTURE_2D, TextureTarget::D2),
            (GL_TEXTURE_EXTERNAL_OES, TextureTarget::External),
        ],
    };
    let target = TARGETS.decode("target", target)?;
    if target == TextureTarget::External && !context.profile.is_es() {
        return invalid_enum(
            "OES_EGL_image_external, section 3.7.1",
            "target = GL_TEXTURE_EXTERNAL_OES is of OpenGL ES: take GL_TEXTURE_2D",
        );
    }
    let image = given(SECTION, image)?;
    let chosen = ChosenTexture::bound(context, target);
    if chosen.get(context).immutable.is_some() {
        let name = chosen.name();
        return invalid_operation(
            "EXT_EGL_image_storage, section 8.5",
            format!("texture {name} has its storage for good, by glTexStorage: bind another"),
        );
    }
    check_format(context, SECTION, image.internal, "textures", |row| row.is_for_textures())?;
    let storage = prepare_to_share(context, chosen.get(context).image.clone());
    let internal = image.internal;
    let texture = chosen.get_mut(context);
    texture.siblings.show(&storage, image);
    for levels in &mut texture.requested {
        levels.fill(GL_NONE);
    }
    texture.requested[0][0] = internal;
    texture.samples = None;
    texture.texels_changed();
    Ok(())
}

pub(crate) fn egl_image_target_renderbuffer_storage(
    context: &mut Context,
    target: GLenum,
    image: GLeglImageOES,
) -> Result<()> {
    RENDERBUFFER_TARGET.decode("target", target)?;
    let image = given(RENDERBUFFERS, image)?;
    let bound = context.state.bindings.renderbuffer.clone();
    let Some(renderbuffer) = context.objects.shared.renderbuffers.bound(&bound) else {
        return invalid_operation(
            RENDERBUFFERS,
            "no renderbuffer is bound: call glBindRenderbuffer",
        );
    };
    let storage = renderbuffer.image.clone();
    let is_es = context.profile.is_es();
    check_format(context, RENDERBUFFERS, image.internal, "renderbuffers", |row| {
        let is_listed = if is_es { row.is_drawn_to_in_es() } else { row.is_for_renderbuffers() };
        is_listed && row.renderable != Renderable::No && !row.is_compressed()
    })?;
    let storage = prepare_to_share(context, storage);
    let format = formats::find(image.internal);
    if let (Some(renderbuffer), Some(format)) =
        (context.objects.shared.renderbuffers.bound_mut(&bound), format)
    {
        renderbuffer.siblings.show(&storage, image);
        renderbuffer.format = format;
    }
    Ok(())
}

/// Prepares an object for the storage of an EGL image: draws that were recorded to its own are submitted, and the share
/// group notes that other groups draw to its images and read them. Returns `storage`.
fn prepare_to_share(context: &mut Context, storage: Image) -> Image {
    crate::draw::pass::submit_draws_to(context, &storage);
    context.objects.shared.group().shared_with_others();
    storage
}
