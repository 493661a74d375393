//! The state that says how an image is read.

/// What happens to a coordinate outside [0, 1] (GL 2.1, section 3.8.7).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Wrap {
    /// `GL_REPEAT`.
    Repeat,
    /// `GL_CLAMP`: to [0, 1], so that a linear filter mixes in the border.
    Clamp,
    /// `GL_CLAMP_TO_EDGE`.
    ClampToEdge,
    /// `GL_CLAMP_TO_BORDER`.
    ClampToBorder,
    /// `GL_MIRRORED_REPEAT`.
    MirroredRepeat,
    /// `GL_MIRROR_CLAMP_EXT`: mirrored once at 0, then as `Clamp`.
    MirrorClamp,
    /// `GL_MIRROR_CLAMP_TO_EDGE_EXT`: mirrored once at 0, then as `ClampToEdge`.
    MirrorClampToEdge,
    /// `GL_MIRROR_CLAMP_TO_BORDER_EXT`: mirrored once at 0, then as `ClampToBorder`.
    MirrorClampToBorder,
}

impl Wrap {
    /// Every mode.
    pub const ALL: [Self; 8] = [
        Self::Repeat,
        Self::Clamp,
        Self::ClampToEdge,
        Self::ClampToBorder,
        Self::MirroredRepeat,
        Self::MirrorClamp,
        Self::MirrorClampToEdge,
        Self::MirrorClampToBorder,
    ];

    /// Whether a sample can mix in the border colour. `Clamp` holds the point inside, so that only
    /// a linear filter reaches past the edge.
    pub const fn reaches_border(self, filter: Filter) -> bool {
        match (self, filter) {
            (Self::ClampToBorder | Self::MirrorClampToBorder, Filter::Nearest | Filter::Linear)
            | (Self::Clamp | Self::MirrorClamp, Filter::Linear) => true,
            (Self::Clamp | Self::MirrorClamp, Filter::Nearest)
            | (
                Self::Repeat | Self::ClampToEdge | Self::MirroredRepeat | Self::MirrorClampToEdge,
                Filter::Nearest | Filter::Linear,
            ) => false,
        }
    }
}

/// How the texels of one level are combined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Filter {
    /// The texel that the point lies in.
    Nearest,
    /// The weighted mean of the nearest 2×2.
    Linear,
}

/// How levels are combined when the image is minified.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mipmap {
    /// Only the base level.
    None,
    /// The nearest level.
    Nearest,
    /// The weighted mean of the two nearest levels.
    Linear,
}

/// A depth comparison, `reference OP texel`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Compare {
    /// False.
    Never,
    /// `<`.
    Less,
    /// `==`.
    Equal,
    /// `<=`.
    LessEqual,
    /// `>`.
    Greater,
    /// `!=`.
    NotEqual,
    /// `>=`.
    GreaterEqual,
    /// True.
    Always,
}

/// Which filters an image of depths is complete with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DepthFilter {
    /// Every filter.
    #[default]
    Any,
    /// Those that take no mean, as OpenGL ES has it of depths that are not compared (3.0, section 3.8.13).
    Nearest,
}

/// How a depth texel becomes a colour (`GL_DEPTH_TEXTURE_MODE`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DepthMode {
    /// (D, D, D, 1).
    Luminance,
    /// (D, D, D, D).
    Intensity,
    /// (0, 0, 0, D).
    Alpha,
    /// (D, 0, 0, 1) (`ARB_texture_rg`).
    Red,
}

/// What a linear filter does at the edges of a cube's faces (ARB_seamless_cube_map).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Seamless {
    /// Each face by itself, with its wrap modes.
    Off,
    /// Texels beyond an edge are those of the face there; at a corner, where there is none, the
    /// mean of the other three. Wrap modes do not matter.
    On,
}

/// Where a component of a sample comes from (EXT_texture_swizzle).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Swizzle {
    /// Red of the sample.
    Red,
    /// Green of the sample.
    Green,
    /// Blue of the sample.
    Blue,
    /// Alpha of the sample.
    Alpha,
    /// 0.
    Zero,
    /// 1.
    One,
}

impl Swizzle {
    /// Each component from itself.
    pub const IDENTITY: [Self; 4] = [Self::Red, Self::Green, Self::Blue, Self::Alpha];
}

/// The largest useful `max_anisotropy` (`GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT`).
pub const MAX_ANISOTROPY: f32 = 16.0;

/// Bound of the sum of the LOD biases, both ways (`GL_MAX_TEXTURE_LOD_BIAS`).
pub const MAX_LOD_BIAS: f32 = 16.0;

/// What there is beyond the edge of an image (`GL_TEXTURE_BORDER_COLOR`): R, G, B, A as they were
/// given, unclamped. Integer textures take integers as they are, others numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Border {
    /// Of textures that are not of integers.
    Float([f32; 4]),
    /// Of signed integers (`glTexParameterIiv`).
    Sint([i32; 4]),
    /// Of unsigned integers (`glTexParameterIuiv`).
    Uint([u32; 4]),
}

impl Border {
    /// The components as numbers, integers rounded to the nearest there is.
    pub fn floats(self) -> [f32; 4] {
        match self {
            Self::Float(color) => color,
            Self::Sint(color) => color.map(|c| c as f32),
            Self::Uint(color) => color.map(|c| c as f32),
        }
    }

    /// The components as integers: numbers rounded to the nearest, ties to even; NaN is 0.
    pub fn integers(self) -> [i64; 4] {
        match self {
            Self::Float(color) => color.map(|c| f64::from(c).round_ties_even() as i64),
            Self::Sint(color) => color.map(i64::from),
            Self::Uint(color) => color.map(i64::from),
        }
    }
}

impl From<[f32; 4]> for Border {
    fn from(color: [f32; 4]) -> Self {
        Self::Float(color)
    }
}

/// What becomes of colours that are stored sRGB-encoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SrgbRead {
    /// They are made linear.
    Decode,
    /// They are numbers like others (`EXT_texture_sRGB_decode`).
    AsIs,
}

/// Everything beside the texels that a sample depends on.
#[derive(Clone, Debug, PartialEq)]
pub struct Sampler {
    /// Wrap of s, t, r.
    pub wrap: [Wrap; 3],
    /// Within a level, when minified.
    pub min: Filter,
    /// Between levels, when minified.
    pub mipmap: Mipmap,
    /// When magnified.
    pub mag: Filter,
    /// Added to λ before the clamp: object and unit together; the shader's own comes with the call.
    pub lod_bias: f32,
    /// Lower bound of λ.
    pub min_lod: f32,
    /// Upper bound of λ.
    pub max_lod: f32,
    /// `GL_TEXTURE_BASE_LEVEL`.
    pub base_level: u32,
    /// `GL_TEXTURE_MAX_LEVEL`.
    pub max_level: u32,
    /// What there is beyond the edge.
    pub border: Border,
    /// Depth compare, if switched on.
    pub compare: Option<Compare>,
    /// How depth becomes a colour.
    pub depth_mode: DepthMode,
    /// Whether an image of depths is filtered.
    pub depth_filter: DepthFilter,
    /// The most probes along a stretched footprint, 1 to [`MAX_ANISOTROPY`]; at 1, off.
    pub max_anisotropy: f32,
    /// At the edges of cube faces.
    pub seamless: Seamless,
    /// Before the filter.
    pub srgb: SrgbRead,
    /// The last step of a sample: which component each one is taken from.
    pub swizzle: [Swizzle; 4],
}

impl Default for Sampler {
    /// The state of a new GL texture object (GL 2.1, table 6.16).
    fn default() -> Self {
        Self {
            wrap: [Wrap::Repeat; 3],
            min: Filter::Nearest,
            mipmap: Mipmap::Linear,
            mag: Filter::Linear,
            lod_bias: 0.0,
            min_lod: -1000.0,
            max_lod: 1000.0,
            base_level: 0,
            max_level: 1000,
            border: Border::Float([0.0; 4]),
            compare: None,
            depth_mode: DepthMode::Luminance,
            depth_filter: DepthFilter::Any,
            max_anisotropy: 1.0,
            seamless: Seamless::Off,
            srgb: SrgbRead::Decode,
            swizzle: Swizzle::IDENTITY,
        }
    }
}
