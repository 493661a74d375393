//! The uniform words of the fixed function: what its generated stages read, worked out in `f64` once
//! a draw and rounded once.

use crate::base::clamp::Clamp;
use crate::generate::fixed::fragment::FragmentKey;
use crate::generate::fixed::light::LightingKey;
use crate::generate::fixed::vertex::VertexKey;
use glam::DMat4;

/// The words, as the last draw left them, and what the dear ones were made from.
#[derive(Debug, Default)]
pub(crate) struct FixedWords {
    pub words: Vec<u32>,
    pub transform: Option<Transform>,
    pub normal: Option<Normal>,
    pub lit: Option<Lit>,
}

/// What the words of lighting are made from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lit {
    pub key: LightingKey,
    /// The versions of lights and materials.
    pub versions: [u64; 2],
    /// The bits of the colour that materials track, if they do.
    pub color: Option<[u32; 4]>,
}

/// What positions are transformed by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Transform {
    pub modelview: DMat4,
    pub projection: DMat4,
}

/// What the matrix of normals is made from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Normal {
    pub modelview: DMat4,
    pub rescale: bool,
}

/// The stages of a draw that are the fixed function's.
#[derive(Debug)]
pub(crate) struct Keys {
    pub vertex: Option<VertexKey>,
    pub fragment: Option<FragmentKey>,
    /// Bit by user clip plane that cuts what a program's vertex stage writes.
    pub clip_planes: u8,
    /// Brings their equations from eye coordinates to those of what they cut.
    pub clip_space: DMat4,
    /// Whether colours of fragments are clamped.
    pub clamp: Clamp,
    /// How many words its stages read.
    pub needed: u32,
}

impl FixedWords {}
