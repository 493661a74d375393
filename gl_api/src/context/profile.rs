//! The API, version and profile of a context.

use crate::base::availability::Api;
use crate::base::constants::*;
use crate::base::core_profile::{self, Argument, InCore};
use crate::base::types::GLenum;
use crate::base::version;
use crate::context::{Context, ContextDesc, ContextError};
use crate::glsl::ContextLanguage;
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
}

impl Profile {
    /// Of a context that is asked for.
    ///
    /// # Errors
    /// If there is no such API or version.
    pub fn of(desc: &ContextDesc) -> Result<Self, ContextError> {
        let ContextDesc { api, version: asked, forward_compatible, .. } = *desc;
        let most = version::reported();
        match api {
            Api::Compatibility | Api::Core if asked > most => {
                Err(ContextError::Version { asked, most })
            }
            Api::Compatibility => Ok(Self::Compatibility(forward_compatible)),
            Api::Core => Ok(Self::Core(forward_compatible)),
            Api::Es1 | Api::Es2 => Err(ContextError::Api(api)),
        }
    }

    pub fn is_core(self) -> bool {
        match self {
            Self::Compatibility(_) => false,
            Self::Core(_) => true,
        }
    }

    /// Whether lines wider than a pixel are refused (GL 3.3, appendix E.2.1).
    pub fn has_wide_lines(self) -> bool {
        self != Self::Core(ForwardCompatible::Yes)
    }

    /// `GL_CONTEXT_PROFILE_MASK` (GL 3.2, table 6.51).
    pub fn mask(self) -> GLenum {
        match self {
            Self::Compatibility(_) => GL_CONTEXT_COMPATIBILITY_PROFILE_BIT,
            Self::Core(_) => GL_CONTEXT_CORE_PROFILE_BIT,
        }
    }

    /// The bits of `GL_CONTEXT_FLAGS` (GL 3.0, table 6.47).
    pub fn flags(self) -> GLenum {
        match self {
            Self::Compatibility(ForwardCompatible::No) | Self::Core(ForwardCompatible::No) => 0,
            Self::Compatibility(ForwardCompatible::Yes) | Self::Core(ForwardCompatible::Yes) => {
                GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT
            }
        }
    }

    /// What depth textures are read as at first: core profiles have no `GL_DEPTH_TEXTURE_MODE`, and read red.
    pub fn depth_mode(self) -> DepthMode {
        match self {
            Self::Compatibility(_) => DepthMode::Luminance,
            Self::Core(_) => DepthMode::Red,
        }
    }

    /// What shaders may be written in.
    pub fn language(self) -> ContextLanguage {
        match self {
            Self::Compatibility(_) => ContextLanguage::Compatibility33,
            Self::Core(_) => ContextLanguage::Core33,
        }
    }
}

impl Context {
    /// Sets what begins otherwise in core contexts.
    pub(super) fn begin_with_profile(&mut self) {
        if self.profile.is_core() {
            // Points always have gl_PointCoord (GL 3.3, section 3.4).
            self.state.enables.set(Flag::PointSprite, true);
            for texture in &mut self.objects.default_textures {
                texture.state.sampler.depth_mode = self.profile.depth_mode();
            }
        }
    }

    /// Whether a call breaks a rule of the core profile, in a core context; the error is set then.
    #[cold]
    #[inline(never)]
    pub(crate) fn is_removed(
        &mut self,
        name: &'static str,
        in_core: InCore,
        arguments: &[Argument],
    ) -> bool {
        match core_profile::check(name, in_core, arguments) {
            Ok(()) => false,
            Err(error) => {
                self.refuse(name, error);
                self.debug.deliver();
                true
            }
        }
    }
}
