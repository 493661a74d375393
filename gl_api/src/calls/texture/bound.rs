//! The texture that a call works on: the one that is bound to a target of the active unit, or the one that the call names
//! (`ARB_direct_state_access`).

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_enum, invalid_operation};
use crate::base::types::*;
use crate::context::Context;
use crate::context::profile::Profile;
use crate::objects::bound::Bound;
pub(crate) use crate::objects::target::TextureTarget;
use crate::objects::target::{FaceTarget, TARGET, TARGET_OF_DESKTOP, TARGET_OF_ES};
use crate::objects::texture::Texture;

const SECTION: &str = "ARB_direct_state_access, section 8.1";

/// The texture that is bound to a target of the active unit.
pub(crate) fn bound(context: &Context, target: TextureTarget) -> &Texture {
    let bound = &context.state.units.active().bound[target as usize];
    context.objects.texture(target, bound)
}

/// How a call names its texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Door {
    /// By a target of the active unit.
    Bound,
    /// By its own name.
    Named,
}

/// The texture that a call works on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct ChosenTexture {
    pub target: TextureTarget,
    object: Bound,
    door: Door,
}

impl ChosenTexture {
    /// The one that is bound to a target of the active unit; the default one, if none is.
    pub fn bound(context: &Context, target: TextureTarget) -> Self {
        let object = context.state.units.active().bound[target as usize].clone();
        Self { target, object, door: Door::Bound }
    }

    /// The one of a name.
    ///
    /// # Errors
    /// `GL_INVALID_OPERATION` for a name that no texture has.
    pub fn named(context: &mut Context, name: GLuint) -> Result<Self> {
        let textures = &mut context.objects.shared.textures;
        match textures.get(name).map(|texture| texture.target) {
            Some(target) => Ok(Self { target, object: textures.hold(name), door: Door::Named }),
            None => invalid_operation(
                SECTION,
                format!(
                    "texture = {name} is no texture: glCreateTextures makes some, and so does binding a name once"
                ),
            ),
        }
    }

    /// Its name; 0 of a default texture.
    pub fn name(&self) -> GLuint {
        self.object.name()
    }

    pub fn get<'a>(&self, context: &'a Context) -> &'a Texture {
        context.objects.texture(self.target, &self.object)
    }

    pub fn get_mut<'a>(&self, context: &'a mut Context) -> &'a mut Texture {
        context.objects.texture_mut(self.target, &self.object)
    }

    /// Its image on a face.
    pub fn face(self, face: u8) -> ChosenImage {
        ChosenImage { texture: self, faces: Faces::One(face) }
    }

    /// GL's name of its target.
    pub fn target_name(&self) -> String {
        enum_name(TARGET.encode(self.target))
    }

    /// The error of a call that does not take its target: `GL_INVALID_ENUM` where the client named that, else
    /// `GL_INVALID_OPERATION`.
    pub fn wrong_target<T>(&self, section: &'static str, rule: &str) -> Result<T> {
        let target = self.target_name();
        match self.door {
            Door::Bound => invalid_enum(section, format!("target = {target} {rule}")),
            Door::Named => invalid_operation(
                section,
                format!("texture {} is a {target}, which {rule}", self.name()),
            ),
        }
    }
}

/// Which images of a texture a call works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Faces {
    /// That of one face; what is no cube map has one only.
    One(u8),
    /// The faces of a cube map as layers.
    Layers,
}

/// The images that a call works on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct ChosenImage {
    pub texture: ChosenTexture,
    pub faces: Faces,
}

impl ChosenImage {
    /// An image of the texture that is bound.
    pub fn bound(context: &Context, face: FaceTarget) -> Self {
        ChosenTexture::bound(context, face.target).face(face.face)
    }
}

/// The targets that textures of a profile's contexts are bound to.
pub(crate) fn bindable(profile: Profile) -> &'static Table<TextureTarget> {
    if profile.is_es() { &TARGET_OF_ES } else { &TARGET_OF_DESKTOP }
}
