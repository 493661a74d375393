//! Texture images: GL 2.1, section 3.8.
//!
//! The modules in the order in which pixels pass through them: how they lie in the client's memory,
//! which internal formats there are, the conversion between both, the calls that specify images,
//! parameters, mipmaps, and reading back.

pub(crate) mod client;
pub(crate) mod convert;
pub(crate) mod copy;
pub(crate) mod get;
pub(crate) mod internal;
pub(crate) mod mipmap;
pub(crate) mod parameter;
pub(crate) mod specify;

use crate::constants::*;
use crate::context::{Context, limits};
use crate::error::{ErrorCode, GlError, Result, Table, invalid_value};
use crate::types::*;
use rasterizer::driver::Image;
use std::sync::Arc;
use texunit::image::{Image as Texels, ImageError, Shape};
use texunit::plan::SamplePlan;
use texunit::sampler::{Compare, Sampler};

/// What a texture can be bound to; also its place in per-target arrays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TextureTarget {
    D2,
    Cube,
}

impl TextureTarget {
    /// The targets, the one that wins where several are enabled last (section 3.8.15).
    pub const ALL: [Self; 2] = [Self::D2, Self::Cube];

    /// The shape of its images.
    pub fn shape(self) -> Shape {
        match self {
            Self::D2 => Shape::D2,
            Self::Cube => Shape::Cube,
        }
    }
}

/// What `glBindTexture` takes.
pub(crate) const TARGET: Table<TextureTarget> = Table {
    section: "GL 2.1, section 3.8.12",
    rows: &[(GL_TEXTURE_2D, TextureTarget::D2), (GL_TEXTURE_CUBE_MAP, TextureTarget::Cube)],
};

/// A 2D image within a texture: the target it is bound to, and the face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct FaceTarget {
    pub target: TextureTarget,
    pub face: u8,
}

const fn face(face: u8) -> FaceTarget {
    FaceTarget { target: TextureTarget::Cube, face }
}

/// What `glTexImage2D` takes.
pub(crate) const FACE_TARGET: Table<FaceTarget> = Table {
    section: "GL 2.1, section 3.8.1",
    rows: &[
        (GL_TEXTURE_2D, FaceTarget { target: TextureTarget::D2, face: 0 }),
        (GL_TEXTURE_CUBE_MAP_POSITIVE_X, face(0)),
        (GL_TEXTURE_CUBE_MAP_NEGATIVE_X, face(1)),
        (GL_TEXTURE_CUBE_MAP_POSITIVE_Y, face(2)),
        (GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, face(3)),
        (GL_TEXTURE_CUBE_MAP_POSITIVE_Z, face(4)),
        (GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, face(5)),
    ],
};

/// A texture object.
#[derive(Debug)]
pub(crate) struct Texture {
    pub target: TextureTarget,
    pub image: Image,
    pub sampler: Sampler,
    /// Whether a change of the base level makes the others anew.
    pub generate_mipmap: bool,
    pub priority: f32,
    /// `GL_TEXTURE_COMPARE_FUNC`, whether comparing is on or not.
    pub compare_func: Compare,
    /// The internal format that was asked for, by face and level.
    pub requested: Vec<[GLenum; limits::MAX_TEXTURE_LEVELS]>,
    /// How it is sampled with a unit's LOD bias (as bits), until something changes.
    plan: Option<(u32, Arc<SamplePlan>)>,
}

impl Texture {
    pub fn new(target: TextureTarget) -> Self {
        let shape = target.shape();
        Self {
            target,
            image: Image::new(Texels::new(shape)),
            sampler: Sampler::default(),
            generate_mipmap: false,
            priority: 1.0,
            compare_func: Compare::LessEqual,
            requested: vec![[GL_NONE; limits::MAX_TEXTURE_LEVELS]; shape.faces()],
            plan: None,
        }
    }

    /// To be called after every change of texels or parameters.
    pub fn changed(&mut self) {
        self.plan = None;
    }

    /// The sampler state with a unit's bias.
    pub fn unit_sampler(&self, lod_bias: f32) -> Sampler {
        let mut sampler = self.sampler.clone();
        sampler.lod_bias = crate::env::lod_bias(sampler.lod_bias + lod_bias);
        sampler
    }

    /// How it is sampled by a unit.
    pub fn plan(&mut self, lod_bias: f32) -> Arc<SamplePlan> {
        match &self.plan {
            Some((bits, plan)) if *bits == lod_bias.to_bits() => Arc::clone(plan),
            _ => {
                let plan = SamplePlan::new(&self.image.texels(), &self.unit_sampler(lod_bias));
                let plan = Arc::new(plan);
                self.plan = Some((lod_bias.to_bits(), Arc::clone(&plan)));
                plan
            }
        }
    }

    /// Why it cannot be sampled, if so.
    pub fn incomplete_reason(&self) -> Option<String> {
        self.image.texels().completeness(&self.sampler).err().map(|reason| reason.to_string())
    }
}

/// The texture that is bound to a target of the active unit.
pub(crate) fn bound(context: &Context, target: TextureTarget) -> &Texture {
    let name = context.state.units.active().bound[target as usize];
    context.objects.texture(target, name)
}

/// The texture that is bound to a target of the active unit, to be changed.
pub(crate) fn bound_mut(context: &mut Context, target: TextureTarget) -> &mut Texture {
    let name = context.state.units.active().bound[target as usize];
    context.objects.texture_mut(target, name)
}

/// A level number that a texture can have.
pub(crate) fn checked_level(section: &'static str, level: GLint) -> Result<usize> {
    match usize::try_from(level) {
        Ok(level) if level < limits::MAX_TEXTURE_LEVELS => Ok(level),
        _ => invalid_value(
            section,
            format!("level = {level} must be 0 to {}", limits::MAX_TEXTURE_LEVELS - 1),
        ),
    }
}

/// What an image that cannot be stored means to the client.
pub(crate) fn storage_error(section: &'static str, error: &ImageError) -> GlError {
    let code = match error {
        ImageError::NoMean { .. } => ErrorCode::InvalidOperation,
        ImageError::TooLarge { .. }
        | ImageError::OutOfMemory { .. }
        | ImageError::WrongBorder { .. }
        | ImageError::TooShort { .. }
        | ImageError::Outside { .. }
        | ImageError::CutsBlocks { .. }
        | ImageError::NoSuchLevel { .. }
        | ImageError::Missing { .. } => ErrorCode::OutOfMemory,
    };
    GlError { code, rule: error.to_string(), section }
}
