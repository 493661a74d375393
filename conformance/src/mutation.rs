//! The wrong variants of the formulas: what proves that a check can fail.
//!
//! A check compares the driver with an oracle. Were the comparison blind, it would pass whatever
//! the driver does; so every oracle can be made wrong in the ways that implementations really are,
//! one at a time, and the check about it must then fail. [`MUTATIONS`] is the one list.

/// One mistake, built into an oracle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[expect(missing_docs, reason = "each is described by its row of MUTATIONS")]
pub enum Mutation {
    RepeatTruncates,
    MirrorAsRepeat,
    ClampAsClampToEdge,
    EdgeClampedToWholeTexel,
    BorderAsEdge,
    BorderColorBlack,
    WrapAxesSwapped,
    RoundForFloor,
    TexelOffByOne,
    RowsUpsideDown,
    HalfTexelOff,
    WeightsReversed,
    WeightsSwapped,
    NearestForLinear,
    WeightsOf4Bits,
    RhoOfSum,
    RhoOfMinimum,
    RhoOfX,
    RhoWithoutSize,
    RhoOfLargestComponent,
    LambdaOffByOne,
    LambdaOfSquare,
    BiasAfterClamp,
    BiasOfObjectIgnored,
    BiasOfUnitIgnored,
    BiasOfShaderIgnored,
    MinLodIgnored,
    MaxLodIgnored,
    LevelByFloor,
    LevelByCeil,
    MagnifiedAtZero,
    BaseLevelIgnored,
    MaxLevelIgnored,
    LevelWeightsReversed,
    OneLevelForTwo,
    CubeCoordinatesSwapped,
    CubeFacesOfAxisSwapped,
    CubeTopFlipped,
    CubeMajorAxisX,
    CubeWithoutDivide,
    CubeHandedness,
    ModulateReplaces,
    DecalBlendsAlpha,
    BlendReversed,
    BlendWithoutConstant,
    AddAddsAlpha,
    AddUnclamped,
    ReplaceOverwritesAlpha,
    IntensityAsLuminance,
    SrgbGamma22,
    SrgbWithoutLinearPart,
    SrgbAlphaDecoded,
    SrgbUndecoded,
    CompareReversed,
    CompareStrictly,
    CompareLoosely,
    BlendFactorsSwapped,
    SubtractReversed,
    MinWeighted,
    SaturateAsSrcAlpha,
    DestinationAlphaIsOne,
    Affine,
    InterpolatedAtCorner,
    DepthPerspective,
    DepthRangeIgnored,
    BottomRightRule,
    EdgesInclusive,
    EdgesExclusive,
    CoveredAtCorner,
    MissingDivide,
    DivideOfSOnly,
    DivideByW,
}

/// What a mutation does, and which check must notice.
#[derive(Clone, Copy, Debug)]
pub struct MutationRow {
    /// The mistake.
    pub mutation: Mutation,
    /// Name of the check that is about it.
    pub check: &'static str,
    /// The mistake in words.
    pub what: &'static str,
}

const fn row(mutation: Mutation, check: &'static str, what: &'static str) -> MutationRow {
    MutationRow { mutation, check, what }
}

/// Every wrong variant.
pub const MUTATIONS: &[MutationRow] = {
    use Mutation::*;
    &[
        row(RepeatTruncates, "wrap-nearest", "GL_REPEAT drops the integer part towards zero"),
        row(MirrorAsRepeat, "wrap-nearest", "GL_MIRRORED_REPEAT does not turn odd periods round"),
        row(BorderAsEdge, "wrap-nearest", "the edge texel stands in for the border"),
        row(BorderColorBlack, "wrap-nearest", "the border is black whatever its colour"),
        row(WrapAxesSwapped, "wrap-nearest", "s wraps by the mode of t and t by that of s"),
        row(ClampAsClampToEdge, "wrap-linear", "GL_CLAMP does not mix in the border"),
        row(EdgeClampedToWholeTexel, "wrap-linear", "GL_CLAMP_TO_EDGE clamps to [0, 1]"),
        row(RoundForFloor, "nearest", "the texel is rounded, not floored"),
        row(TexelOffByOne, "nearest", "one texel to the right"),
        row(RowsUpsideDown, "nearest", "the first row is the top one"),
        row(HalfTexelOff, "bilinear", "texel centres lie on whole coordinates"),
        row(WeightsReversed, "bilinear", "alpha weighs the left texel"),
        row(WeightsSwapped, "bilinear", "alpha and beta change places"),
        row(NearestForLinear, "bilinear", "one texel instead of four"),
        row(WeightsOf4Bits, "bilinear", "weights are cut to 4 bits"),
        row(RhoOfSum, "lod", "rho is the sum over x and y, not the larger"),
        row(RhoOfMinimum, "lod", "rho is the smaller over x and y"),
        row(RhoOfX, "lod", "rho looks along x only"),
        row(RhoWithoutSize, "lod", "derivatives of s and t, not of u and v"),
        row(RhoOfLargestComponent, "lod", "rho is the largest component, not the length"),
        row(LambdaOffByOne, "lod", "lambda is 1 too high"),
        row(LambdaOfSquare, "lod", "log2 of rho squared without the half"),
        row(BiasAfterClamp, "lod-bias-clamp", "the bias is added after the clamp"),
        row(BiasOfObjectIgnored, "lod-bias-clamp", "the texture object's bias is left out"),
        row(BiasOfUnitIgnored, "lod-bias-clamp", "the texture unit's bias is left out"),
        row(BiasOfShaderIgnored, "lod-bias-clamp", "the shader's bias is left out"),
        row(MinLodIgnored, "lod-bias-clamp", "GL_TEXTURE_MIN_LOD is left out"),
        row(MaxLodIgnored, "lod-bias-clamp", "GL_TEXTURE_MAX_LOD is left out"),
        row(LevelByFloor, "level", "the level is floored, not rounded"),
        row(LevelByCeil, "level", "the level is rounded up"),
        row(MagnifiedAtZero, "level", "magnified from lambda <= 0 for every pair of filters"),
        row(BaseLevelIgnored, "level", "level 0 is the base level"),
        row(MaxLevelIgnored, "level", "GL_TEXTURE_MAX_LEVEL is left out"),
        row(LevelWeightsReversed, "level", "frac(lambda) weighs the larger level"),
        row(OneLevelForTwo, "level", "the nearest level instead of two"),
        row(CubeCoordinatesSwapped, "cube-face", "s and t of a face change places"),
        row(CubeFacesOfAxisSwapped, "cube-face", "+X and -X (…) change places"),
        row(CubeTopFlipped, "cube-face", "t of +Y and -Y has the other sign"),
        row(CubeMajorAxisX, "cube-face", "x is the major axis unless it is zero"),
        row(CubeWithoutDivide, "cube-face", "s and t are not divided by the major axis"),
        row(CubeHandedness, "cube-face", "faces are seen from outside"),
        row(ModulateReplaces, "env", "GL_MODULATE does not multiply"),
        row(DecalBlendsAlpha, "env", "GL_DECAL changes alpha too"),
        row(BlendReversed, "env", "GL_BLEND weighs the wrong way round"),
        row(BlendWithoutConstant, "env", "GL_BLEND leaves out the environment colour"),
        row(AddAddsAlpha, "env", "GL_ADD adds alpha where it multiplies"),
        row(AddUnclamped, "env", "GL_ADD wraps round instead of clamping"),
        row(ReplaceOverwritesAlpha, "env", "GL_REPLACE sets alpha to 1 where there is none"),
        row(IntensityAsLuminance, "env", "an intensity texture has no alpha"),
        row(SrgbGamma22, "srgb", "a plain power of 2.2"),
        row(SrgbWithoutLinearPart, "srgb", "no linear part near black"),
        row(SrgbAlphaDecoded, "srgb", "alpha is decoded too"),
        row(SrgbUndecoded, "srgb", "no decoding"),
        row(CompareReversed, "shadow-compare", "texel OP reference"),
        row(CompareStrictly, "shadow-compare", "<= and >= without equality"),
        row(CompareReversed, "depth-test", "stored OP incoming"),
        row(CompareStrictly, "depth-test", "<= and >= without equality"),
        row(CompareLoosely, "depth-test", "< and > with equality"),
        row(BlendFactorsSwapped, "blend", "the factors change places"),
        row(SubtractReversed, "blend", "GL_FUNC_SUBTRACT subtracts the wrong way round"),
        row(MinWeighted, "blend", "GL_MIN applies the factors"),
        row(SaturateAsSrcAlpha, "blend", "GL_SRC_ALPHA_SATURATE does not look at the destination"),
        row(DestinationAlphaIsOne, "blend", "the framebuffer's alpha is taken for 1"),
        row(Affine, "perspective", "no perspective correction"),
        row(InterpolatedAtCorner, "perspective", "evaluated at the pixel's corner"),
        row(DepthPerspective, "depth", "depth is divided by 1/w too"),
        row(DepthRangeIgnored, "depth", "glDepthRange is left out"),
        row(InterpolatedAtCorner, "depth", "evaluated at the pixel's corner"),
        row(BottomRightRule, "coverage", "bottom and right edges own their pixels"),
        row(EdgesInclusive, "coverage", "every edge owns its pixels"),
        row(EdgesExclusive, "coverage", "no edge owns its pixels"),
        row(CoveredAtCorner, "coverage", "the pixel's corner decides"),
        row(EdgesInclusive, "shared-edges", "pixels on a shared edge are drawn twice"),
        row(EdgesExclusive, "shared-edges", "pixels on a shared edge are left out"),
        row(MissingDivide, "projective", "s and t are not divided by q"),
        row(DivideOfSOnly, "projective", "only s is divided by q"),
        row(DivideByW, "projective", "divided by the third component"),
    ]
};

/// The oracles as they should be, or with one mistake.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Variant(Option<Mutation>);

impl Variant {
    /// The formulas as the specification has them.
    pub const TRUE: Self = Self(None);

    /// With this mistake.
    pub const fn wrong(mutation: Mutation) -> Self {
        Self(Some(mutation))
    }

    /// Whether this mistake is built in.
    pub fn has(self, mutation: Mutation) -> bool {
        self.0 == Some(mutation)
    }
}
