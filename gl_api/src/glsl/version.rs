//! The versions of the language and its extensions.

use super::Stage;

/// A version that `#version` can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Version {
    /// GLSL 1.10, what a shader without `#version` is written in.
    V110,
    /// GLSL 1.20.
    V120,
    /// GLSL 1.30.
    V130,
}

impl Version {
    /// Every version.
    pub const ALL: [Self; 3] = [Self::V110, Self::V120, Self::V130];

    /// The number that `#version` takes and `__VERSION__` gives.
    pub fn number(self) -> i32 {
        match self {
            Self::V110 => 110,
            Self::V120 => 120,
            Self::V130 => 130,
        }
    }

    /// As the specification's title has it.
    pub fn title(self) -> &'static str {
        match self {
            Self::V110 => "GLSL 1.10",
            Self::V120 => "GLSL 1.20",
            Self::V130 => "GLSL 1.30",
        }
    }
}

/// The extensions that a shader can enable.
pub const EXTENSIONS: [&str; 2] = ["GL_ARB_draw_buffers", "GL_ARB_shader_texture_lod"];

/// What names are available to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stages {
    /// Both.
    Any,
    /// The vertex stage.
    Vertex,
    /// The fragment stage.
    Fragment,
}

impl Stages {
    /// Whether `stage` is among them.
    pub fn has(self, stage: Stage) -> bool {
        match self {
            Self::Any => true,
            Self::Vertex => stage == Stage::Vertex,
            Self::Fragment => stage == Stage::Fragment,
        }
    }
}

/// As messages name a stage.
pub fn stage_name(stage: Stage) -> &'static str {
    match stage {
        Stage::Vertex => "vertex",
        Stage::Fragment => "fragment",
    }
}
