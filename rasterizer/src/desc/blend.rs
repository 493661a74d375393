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
    /// The second source colour (GL 3.3, table 4.2).
    Src1Color,
    /// 1 - the second source colour.
    OneMinusSrc1Color,
    /// The second source alpha.
    Src1Alpha,
    /// 1 - the second source alpha.
    OneMinusSrc1Alpha,
}

impl BlendFactor {
    /// Whether it is made of the second source colour.
    pub fn is_of_second_color(self) -> bool {
        match self {
            Self::Src1Color
            | Self::OneMinusSrc1Color
            | Self::Src1Alpha
            | Self::OneMinusSrc1Alpha => true,
            Self::Zero
            | Self::One
            | Self::SrcColor
            | Self::OneMinusSrcColor
            | Self::DstColor
            | Self::OneMinusDstColor
            | Self::SrcAlpha
            | Self::OneMinusSrcAlpha
            | Self::DstAlpha
            | Self::OneMinusDstAlpha
            | Self::ConstantColor
            | Self::OneMinusConstantColor
            | Self::ConstantAlpha
            | Self::OneMinusConstantAlpha
            | Self::SrcAlphaSaturate => false,
        }
    }
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

impl Blend {
    /// Whether it gives the source where the source's alpha is 1.
    pub fn replaces_where_opaque(&self) -> bool {
        (0..2).all(|part| {
            let [src, dst] = [self.src[part], self.dst[part]];
            self.equation[part] == BlendEquation::Add
                && matches!(src, BlendFactor::One | BlendFactor::SrcAlpha)
                && matches!(dst, BlendFactor::Zero | BlendFactor::OneMinusSrcAlpha)
        })
    }

    /// Whether a factor that counts is made of the second source colour: minimum and maximum have no factors.
    pub fn reads_second_color(&self) -> bool {
        (0..2).any(|part| match self.equation[part] {
            BlendEquation::Min | BlendEquation::Max => false,
            BlendEquation::Add | BlendEquation::Subtract | BlendEquation::ReverseSubtract => {
                self.src[part].is_of_second_color() || self.dst[part].is_of_second_color()
            }
        })
    }
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

    /// Whether a component of the second source colour has any effect.
    pub(crate) fn needs_second(&self, component: usize) -> bool {
        self.blend.is_some_and(|blend| blend.reads_second_color()) && self.needs(component)
    }
}
