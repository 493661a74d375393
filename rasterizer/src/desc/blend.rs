//! Blending and colour masks of colour attachments.

use std::hash::{Hash, Hasher};

/// A factor of a blend equation (GL 2.1, table 4.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BlendFactor {
    /// 0.
    Zero,
    /// 1.
    One,
    /// Source colour.
    SrcColor,
    /// 1 - source colour.
    OneMinusSrcColor,
    /// Destination colour.
    DstColor,
    /// 1 - destination colour.
    OneMinusDstColor,
    /// Source alpha.
    SrcAlpha,
    /// 1 - source alpha.
    OneMinusSrcAlpha,
    /// Destination alpha.
    DstAlpha,
    /// 1 - destination alpha.
    OneMinusDstAlpha,
    /// The constant colour.
    ConstantColor,
    /// 1 - the constant colour.
    OneMinusConstantColor,
    /// The constant alpha.
    ConstantAlpha,
    /// 1 - the constant alpha.
    OneMinusConstantAlpha,
    /// min(source alpha, 1 - destination alpha) for colour, 1 for alpha.
    SrcAlphaSaturate,
}

/// How weighted source and destination are combined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BlendEquation {
    /// source + destination.
    Add,
    /// source - destination.
    Subtract,
    /// destination - source.
    ReverseSubtract,
    /// The smaller, unweighted.
    Min,
    /// The larger, unweighted.
    Max,
}

/// Blending of a colour attachment: `[colour, alpha]` of each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blend {
    /// Combination.
    pub equation: [BlendEquation; 2],
    /// Source factors.
    pub src: [BlendFactor; 2],
    /// Destination factors.
    pub dst: [BlendFactor; 2],
    /// The constant colour, unclamped.
    pub constant: [f32; 4],
}

impl Eq for Blend {}

impl Hash for Blend {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.equation, self.src, self.dst, self.constant.map(f32::to_bits)).hash(state);
    }
}

/// What is done with one colour attachment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ColorState {
    /// Blending, if switched on.
    pub blend: Option<Blend>,
    /// Which of red, green, blue, alpha are written.
    pub mask: [bool; 4],
}

impl ColorState {
    /// Whether a component of the source colour has any effect.
    pub(crate) fn needs(&self, component: usize) -> bool {
        // Blending weights every component by source alpha, or may.
        self.mask[component]
            || (component == 3 && self.blend.is_some() && self.mask.contains(&true))
    }
}
