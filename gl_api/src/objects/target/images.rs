//! The images within textures that calls name: faces, proxies, and what calls of each number of dimensions take.

use super::TextureTarget;
use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum, must_be};
use crate::base::types::*;

/// An image within a texture: the target it is bound to, and the face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FaceTarget {
    pub target: TextureTarget,
    pub face: u8,
}

/// The image or proxy that a `target` names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ImageTarget {
    /// An image of the bound texture.
    Bound(FaceTarget),
    /// A proxy, which tells whether such an image could be stored (section 3.8.11).
    Proxy(TextureTarget),
}

impl ImageTarget {
    pub fn target(self) -> TextureTarget {
        match self {
            Self::Bound(FaceTarget { target, .. }) | Self::Proxy(target) => target,
        }
    }
}

const fn face(face: u8) -> FaceTarget {
    FaceTarget { target: TextureTarget::Cube, face }
}

const fn single_face(target: TextureTarget) -> FaceTarget {
    FaceTarget { target, face: 0 }
}

/// The images that can be attached to a framebuffer, those of two dimensions.
pub(crate) const FACE_TARGET: Table<FaceTarget> = Table {
    section: "GL 2.1, section 3.8.1",
    rows: &[
        (GL_TEXTURE_2D, single_face(TextureTarget::D2)),
        (GL_TEXTURE_CUBE_MAP_POSITIVE_X, face(0)),
        (GL_TEXTURE_CUBE_MAP_NEGATIVE_X, face(1)),
        (GL_TEXTURE_CUBE_MAP_POSITIVE_Y, face(2)),
        (GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, face(3)),
        (GL_TEXTURE_CUBE_MAP_POSITIVE_Z, face(4)),
        (GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, face(5)),
        (GL_TEXTURE_RECTANGLE, single_face(TextureTarget::Rect)),
        (GL_TEXTURE_2D_MULTISAMPLE, single_face(TextureTarget::D2Multisample)),
    ],
};

/// What `glFramebufferTexture1D` (1), `2D` (2) or `3D` (3) names as `textarget`.
pub(crate) fn attachable_target(axes: usize, textarget: GLenum) -> Result<FaceTarget> {
    const LINES: Table<FaceTarget> = Table {
        section: "ARB_framebuffer_object, section 4.4.2",
        rows: &[(GL_TEXTURE_1D, single_face(TextureTarget::D1))],
    };
    const VOLUMES: Table<FaceTarget> = Table {
        section: "ARB_framebuffer_object, section 4.4.2",
        rows: &[(GL_TEXTURE_3D, single_face(TextureTarget::D3))],
    };
    let table = match axes {
        1 => &LINES,
        2 => &FACE_TARGET,
        _ => &VOLUMES,
    };
    table.decode("textarget", textarget)
}

const SECTION: &str = "GL 2.1, section 3.8.1";

const IMAGE_1D: Table<ImageTarget> = Table {
    section: SECTION,
    rows: &[
        (GL_TEXTURE_1D, ImageTarget::Bound(single_face(TextureTarget::D1))),
        (GL_PROXY_TEXTURE_1D, ImageTarget::Proxy(TextureTarget::D1)),
    ],
};

const IMAGE_2D: Table<ImageTarget> = Table {
    section: SECTION,
    rows: &[
        (GL_TEXTURE_2D, ImageTarget::Bound(single_face(TextureTarget::D2))),
        (GL_TEXTURE_CUBE_MAP_POSITIVE_X, ImageTarget::Bound(face(0))),
        (GL_TEXTURE_CUBE_MAP_NEGATIVE_X, ImageTarget::Bound(face(1))),
        (GL_TEXTURE_CUBE_MAP_POSITIVE_Y, ImageTarget::Bound(face(2))),
        (GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, ImageTarget::Bound(face(3))),
        (GL_TEXTURE_CUBE_MAP_POSITIVE_Z, ImageTarget::Bound(face(4))),
        (GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, ImageTarget::Bound(face(5))),
        (GL_TEXTURE_RECTANGLE, ImageTarget::Bound(single_face(TextureTarget::Rect))),
        (GL_TEXTURE_1D_ARRAY, ImageTarget::Bound(single_face(TextureTarget::D1Array))),
        (GL_PROXY_TEXTURE_2D, ImageTarget::Proxy(TextureTarget::D2)),
        (GL_PROXY_TEXTURE_CUBE_MAP, ImageTarget::Proxy(TextureTarget::Cube)),
        (GL_PROXY_TEXTURE_RECTANGLE, ImageTarget::Proxy(TextureTarget::Rect)),
        (GL_PROXY_TEXTURE_1D_ARRAY, ImageTarget::Proxy(TextureTarget::D1Array)),
    ],
};

const IMAGE_3D: Table<ImageTarget> = Table {
    section: SECTION,
    rows: &[
        (GL_TEXTURE_3D, ImageTarget::Bound(single_face(TextureTarget::D3))),
        (GL_TEXTURE_2D_ARRAY, ImageTarget::Bound(single_face(TextureTarget::D2Array))),
        (GL_TEXTURE_CUBE_MAP_ARRAY, ImageTarget::Bound(single_face(TextureTarget::CubeArray))),
        (GL_PROXY_TEXTURE_3D, ImageTarget::Proxy(TextureTarget::D3)),
        (GL_PROXY_TEXTURE_2D_ARRAY, ImageTarget::Proxy(TextureTarget::D2Array)),
        (GL_PROXY_TEXTURE_CUBE_MAP_ARRAY, ImageTarget::Proxy(TextureTarget::CubeArray)),
    ],
};

/// The images with several samples a texel, which only calls of their own specify
/// (`ARB_texture_multisample`, section 3.8.X).
pub(crate) const IMAGE_2D_MULTISAMPLE: Table<ImageTarget> = Table {
    section: "ARB_texture_multisample, section 3.8.X",
    rows: &[
        (GL_TEXTURE_2D_MULTISAMPLE, ImageTarget::Bound(single_face(TextureTarget::D2Multisample))),
        (GL_PROXY_TEXTURE_2D_MULTISAMPLE, ImageTarget::Proxy(TextureTarget::D2Multisample)),
    ],
};

/// Arrays of them.
pub(crate) const IMAGE_3D_MULTISAMPLE: Table<ImageTarget> = Table {
    section: "ARB_texture_multisample, section 3.8.X",
    rows: &[
        (
            GL_TEXTURE_2D_MULTISAMPLE_ARRAY,
            ImageTarget::Bound(single_face(TextureTarget::D2MultisampleArray)),
        ),
        (
            GL_PROXY_TEXTURE_2D_MULTISAMPLE_ARRAY,
            ImageTarget::Proxy(TextureTarget::D2MultisampleArray),
        ),
    ],
};

/// The texels of a buffer, which are specified as a buffer's bytes.
const IMAGE_BUFFER: Table<ImageTarget> = Table {
    section: "ARB_texture_buffer_object, section 6.1.3",
    rows: &[(GL_TEXTURE_BUFFER, ImageTarget::Bound(single_face(TextureTarget::Buffer)))],
};

/// The dimensions that a call's name ends in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dimensions {
    One,
    Two,
    Three,
}

impl Dimensions {
    const ALL: [Self; 3] = [Self::One, Self::Two, Self::Three];

    /// The images that calls of so many dimensions work on, and proxies.
    pub fn table(self) -> &'static Table<ImageTarget> {
        match self {
            Self::One => &IMAGE_1D,
            Self::Two => &IMAGE_2D,
            Self::Three => &IMAGE_3D,
        }
    }

    /// The image that `target` names, or a proxy.
    pub fn image(self, target: GLenum) -> Result<ImageTarget> {
        self.table().decode("target", target)
    }

    /// The image that `target` names; proxies have no texels.
    pub fn bound(self, target: GLenum) -> Result<FaceTarget> {
        refuse_proxy(target, self.image(target)?)
    }
}

fn refuse_proxy(target: GLenum, image: ImageTarget) -> Result<FaceTarget> {
    match image {
        ImageTarget::Bound(target) => Ok(target),
        ImageTarget::Proxy(_) => invalid_enum(
            "GL 2.1, section 3.8.11",
            format!("target = {} is a proxy, which has no texels", enum_name(target)),
        ),
    }
}

/// The image of any number of dimensions that `target` names, or a proxy.
pub(crate) fn any_image(target: GLenum) -> Result<ImageTarget> {
    match Dimensions::ALL.into_iter().find_map(|dimensions| dimensions.table().get(target)) {
        Some(image) => Ok(image),
        None => invalid_enum(
            SECTION,
            format!(
                "target = {} {}",
                enum_name(target),
                must_be(
                    target,
                    &[IMAGE_1D.values(), IMAGE_2D.values(), IMAGE_3D.values()].concat()
                )
            ),
        ),
    }
}

/// What `target` names of which something is known: an image with any number of samples, a proxy, or
/// the texels of a buffer.
pub(crate) fn any_known(target: GLenum) -> Result<ImageTarget> {
    let special = [&IMAGE_2D_MULTISAMPLE, &IMAGE_3D_MULTISAMPLE, &IMAGE_BUFFER];
    match special.into_iter().find_map(|table| table.get(target)) {
        Some(image) => Ok(image),
        None => any_image(target),
    }
}

/// The image of any number of dimensions that `target` names; proxies have no texels.
pub(crate) fn any_bound(target: GLenum) -> Result<FaceTarget> {
    refuse_proxy(target, any_image(target)?)
}
