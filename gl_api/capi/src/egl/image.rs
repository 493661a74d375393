//! EGL images: levels of textures, and renderbuffers, that contexts have in common which share nothing else (EGL 1.5,
//! section 3.9; `EGL_KHR_image_base`, `EGL_KHR_gl_image`).

use super::constants::*;
use super::error::{Code, Result, fail, name_of};
use super::raw::{Attrib, Handle, Int, handle};
use super::registry::registry;
use gl_api::host::{EglImage, EglImageError, EglImageSource};

/// The attributes of an image: which level and slice of a texture it is made from.
#[derive(Default)]
struct LevelAttributes {
    level: u32,
    slice: u32,
}

impl LevelAttributes {
    /// Checks that a target has these attributes: textures have a level, volumes a slice.
    fn new(target: u32, attributes: &[(Int, Attrib)]) -> Result<Self> {
        let is_texture = target as Int != EGL_GL_RENDERBUFFER;
        let is_volume = target as Int == EGL_GL_TEXTURE_3D;
        let mut level = Self::default();
        for &(name, value) in attributes {
            let at = || match u32::try_from(value) {
                Ok(value) => Ok(value),
                Err(_) => {
                    let name = name_of(name);
                    fail(Code::BadParameter, format!("{name} = {value} must not be negative"))
                }
            };
            match name {
                // Texels are preserved whatever the value.
                EGL_IMAGE_PRESERVED if [0, 1].contains(&value) => {}
                EGL_IMAGE_PRESERVED => {
                    let rule =
                        format!("EGL_IMAGE_PRESERVED = {value} must be EGL_TRUE or EGL_FALSE");
                    return fail(Code::BadParameter, rule);
                }
                EGL_GL_TEXTURE_LEVEL if is_texture => {
                    // A level that does not exist is EGL_BAD_MATCH, whatever its number.
                    level.level = u32::try_from(value).unwrap_or(u32::MAX);
                }
                EGL_GL_TEXTURE_ZOFFSET if is_volume => level.slice = at()?,
                _ => {
                    let (name, target) = (name_of(name), name_of(target));
                    let rule = format!("attrib_list: no attribute {name} of images of {target}");
                    return fail(Code::BadParameter, rule);
                }
            }
        }
        Ok(level)
    }
}

/// What a target, a buffer and attributes name.
fn source(target: u32, buffer: Handle, attributes: &[(Int, Attrib)]) -> Result<EglImageSource> {
    const FACES: [Int; 6] = [
        EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_X,
        EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_X,
        EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_Y,
        EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_Y,
        EGL_GL_TEXTURE_CUBE_MAP_POSITIVE_Z,
        EGL_GL_TEXTURE_CUBE_MAP_NEGATIVE_Z,
    ];
    let name = target as Int;
    let face = FACES.iter().position(|face| *face == name);
    let is_target = [EGL_GL_TEXTURE_2D, EGL_GL_TEXTURE_3D, EGL_GL_RENDERBUFFER].contains(&name);
    if !is_target && face.is_none() {
        return fail(
            Code::BadParameter,
            format!(
                "target = {} must be EGL_GL_TEXTURE_2D, EGL_GL_TEXTURE_3D, EGL_GL_RENDERBUFFER or a face of \
                 EGL_GL_TEXTURE_CUBE_MAP",
                name_of(target)
            ),
        );
    }
    let LevelAttributes { level, slice } = LevelAttributes::new(target, attributes)?;
    let object = match u32::try_from(buffer.addr()) {
        Ok(0) => {
            let rule =
                "buffer = 0: there are no images of default objects, give the name of another";
            return fail(Code::BadParameter, rule);
        }
        Ok(object) => object,
        Err(_) => return fail(Code::BadParameter, "buffer is no name of an object"),
    };
    Ok(match face {
        Some(face) => EglImageSource::CubeMapFace { texture: object, face: face as u8, level },
        None if name == EGL_GL_RENDERBUFFER => EglImageSource::Renderbuffer(object),
        None if name == EGL_GL_TEXTURE_3D => {
            EglImageSource::Texture3D { texture: object, level, slice }
        }
        None => EglImageSource::Texture2D { texture: object, level },
    })
}

pub(super) fn create(
    dpy: Handle,
    context: Handle,
    target: u32,
    buffer: Handle,
    attributes: &[(Int, Attrib)],
) -> Result<Handle> {
    let (display, share) = {
        let mut registry = registry();
        let display = registry.display(dpy)?;
        let (_, entry) = registry.context(display, context)?;
        (display, entry.share.clone())
    };
    let source = source(target, buffer, attributes)?;
    // While the objects are locked, the registry is not.
    let image = match EglImage::new(&share, source) {
        Ok(image) => image,
        Err(EglImageError::BadParameter(rule)) => return fail(Code::BadParameter, rule),
        Err(EglImageError::BadMatch(rule)) => return fail(Code::BadMatch, rule),
        Err(EglImageError::BadAccess(rule)) => return fail(Code::BadAccess, rule),
    };
    let id = image.handle().addr();
    registry().images.insert(id, (display, image));
    Ok(handle(id))
}

pub(super) fn destroy(dpy: Handle, image: Handle) -> Result<u32> {
    let mut registry = registry();
    let display = registry.display(dpy)?;
    let id = image.addr();
    if registry.images.get(&id).is_none_or(|(of, _)| *of != display) {
        let rule = format!("image = {id:#x} is none of this display");
        return fail(Code::BadParameter, rule);
    }
    let gone = registry.images.remove(&id);
    drop(registry);
    // Its memory is freed after the lock.
    drop(gone);
    Ok(1)
}
