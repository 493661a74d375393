//! The API, version and profile of a context.

use crate::base::availability::{Api, REMOVED_VALUES, VALUES_OUTSIDE_ES, Version};
use crate::base::constants::*;
use crate::base::core_profile::{self, Argument, InCore, removed_value};
use crate::base::error::{ErrorCode, Result};
use crate::base::es_profile::{self, InEs, foreign_value};
use crate::base::types::GLenum;
use crate::base::version;
use crate::context::{Context, ContextDesc, ContextError};
use crate::glsl::ContextLanguage;
use crate::objects::color_buffers::Selection;
use crate::state::enable::Flag;
use texunit::sampler::DepthMode;

/// Whether a context has what the specification calls deprecated (GL 3.0, appendix E).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ForwardCompatible {
    /// It has.
    #[default]
    No,
    /// It has not: in core contexts, lines are no wider than a pixel.
    Yes,
}

/// The profile of a context (GL 3.3, appendix E).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Profile {
    /// With everything that later versions removed.
    Compatibility(ForwardCompatible),
    /// Without.
    Core(ForwardCompatible),
    /// OpenGL ES 3.0, which has all of 2.0.
    Es,
}

impl Profile {
    /// Of a context that is asked for.
    ///
    /// # Errors
    /// If there is no such API or version.
    pub fn of(desc: &ContextDesc) -> std::result::Result<Self, ContextError> {
        let ContextDesc { api, version: asked, forward_compatible, .. } = *desc;
        let most = version::reported();
        match api {
            Api::Compatibility | Api::Core if asked > most => {
                Err(ContextError::Version { asked, most })
            }
            Api::Compatibility => Ok(Self::Compatibility(forward_compatible)),
            Api::Core => Ok(Self::Core(forward_compatible)),
            Api::Es2 if asked > version::IMPLEMENTED_ES => {
                Err(ContextError::Version { asked, most: version::IMPLEMENTED_ES })
            }
            Api::Es2 => Ok(Self::Es),
            Api::Es1 => Err(ContextError::Api(api)),
        }
    }

    pub fn is_core(self) -> bool {
        match self {
            Self::Compatibility(_) | Self::Es => false,
            Self::Core(_) => true,
        }
    }

    pub fn is_es(self) -> bool {
        self == Self::Es
    }

    /// Whether it has the fixed function and all else that any version had.
    pub fn is_compatibility(self) -> bool {
        match self {
            Self::Compatibility(_) => true,
            Self::Core(_) | Self::Es => false,
        }
    }

    /// Whether lines wider than a pixel are refused (GL 3.3, appendix E.2.1).
    pub fn has_wide_lines(self) -> bool {
        self != Self::Core(ForwardCompatible::Yes)
    }

    /// The version that `glGet` reports.
    pub fn version(self) -> Version {
        match self {
            Self::Compatibility(_) | Self::Core(_) => version::reported(),
            Self::Es => version::IMPLEMENTED_ES,
        }
    }

    /// `GL_CONTEXT_PROFILE_MASK` (GL 3.2, table 6.51).
    pub fn mask(self) -> GLenum {
        match self {
            Self::Compatibility(_) => GL_CONTEXT_COMPATIBILITY_PROFILE_BIT,
            Self::Core(_) => GL_CONTEXT_CORE_PROFILE_BIT,
            Self::Es => 0,
        }
    }

    /// The bits of `GL_CONTEXT_FLAGS` (GL 3.0, table 6.47).
    pub fn flags(self) -> GLenum {
        match self {
            Self::Compatibility(ForwardCompatible::No)
            | Self::Core(ForwardCompatible::No)
            | Self::Es => 0,
            Self::Compatibility(ForwardCompatible::Yes) | Self::Core(ForwardCompatible::Yes) => {
                GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT
            }
        }
    }

    /// Checks that it has a value of an enum, whatever the type of the call's argument.
    pub fn check_value(self, argument: &str, value: GLenum) -> Result<()> {
        let error = match self {
            Self::Core(_) if REMOVED_VALUES.binary_search(&value).is_ok() => removed_value,
            Self::Es if VALUES_OUTSIDE_ES.binary_search(&value).is_ok() => foreign_value,
            Self::Compatibility(_) | Self::Core(_) | Self::Es => return Ok(()),
        };
        Err(error(argument, value, ErrorCode::InvalidEnum))
    }

    /// What depth textures are read as at first: core profiles and OpenGL ES have no `GL_DEPTH_TEXTURE_MODE`, and read red.
    pub fn depth_mode(self) -> DepthMode {
        match self {
            Self::Compatibility(_) => DepthMode::Luminance,
            Self::Core(_) | Self::Es => DepthMode::Red,
        }
    }

    /// What shaders may be written in.
    pub fn language(self) -> ContextLanguage {
        match self {
            Self::Compatibility(_) => ContextLanguage::Compatibility33,
            Self::Core(_) => ContextLanguage::Core33,
            Self::Es => ContextLanguage::Es30,
        }
    }
}

impl Context {
    /// Sets what begins otherwise in contexts without all of OpenGL.
    pub(super) fn begin_with_profile(&mut self) {
        let always: &[Flag] = match self.profile {
            Profile::Compatibility(_) => return,
            // Points always have gl_PointCoord (GL 3.3, section 3.4).
            Profile::Core(_) => &[Flag::PointSprite],
            // OpenGL ES has no capabilities of these names: points have the size that shaders write and gl_PointCoord
            // (3.0, section 3.4), cube maps are filtered across faces (3.8.10), colours for sRGB formats are encoded
            // (4.1.8).
            Profile::Es => &[
                Flag::PointSprite,
                Flag::VertexProgramPointSize,
                Flag::SeamlessCubeMaps,
                Flag::FramebufferSrgb,
            ],
        };
        always.iter().for_each(|flag| self.state.enables.set(*flag, true));
        if self.profile.is_es() {
            self.window.selection = Selection::window_of_es();
        }
        for texture in &mut self.objects.default_textures {
            texture.state.sampler.depth_mode = self.profile.depth_mode();
        }
    }

    /// Whether a call breaks a rule of the core profile in a core context, or one of OpenGL ES in one of that; the error
    /// is set then.
    #[cold]
    #[inline(never)]
    pub(crate) fn is_refused(
        &mut self,
        name: &'static str,
        in_core: InCore,
        in_es: InEs,
        arguments: &[Argument],
    ) -> bool {
        let checked = match self.profile {
            Profile::Compatibility(_) => Ok(()),
            Profile::Core(_) => core_profile::check(name, in_core, arguments),
            Profile::Es => es_profile::check(name, in_es, arguments),
        };
        match checked {
            Ok(()) => false,
            Err(error) => {
                self.refuse(name, error);
                self.debug.deliver();
                true
            }
        }
    }
}
