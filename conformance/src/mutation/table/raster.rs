//! Mistakes of rasterization.

use super::{MutationRow, row};
use crate::mutation::Mutation;

/// The rows of this file.
pub(super) const ROWS: &[MutationRow] = {
    use Mutation::*;
    &[
        row(
            PointParitySwapped,
            "point-size",
            "odd sizes are centred on corners, even ones on centres",
        ),
        row(DiameterIsRadius, "point-smooth", "the size is the radius"),
        row(AttenuationWithoutRoot, "point-attenuation", "the root is left out"),
        row(SizeUnclamped, "point-attenuation", "the limits of sizes are left out"),
        row(SpriteUpsideDown, "point-sprite", "the origins change places"),
        row(SpriteUpsideDown, "point-coord", "the origins change places"),
        row(DiamondIsPixel, "line-diamond", "diamonds reach to the next centres"),
        row(LastPixelDrawn, "line-diamond", "the pixel of the end is drawn"),
        row(WidthAlongLine, "line-width", "wide lines grow along their direction"),
        row(WidthNotCentred, "line-width", "wide lines grow to one side"),
        row(StippleFactorIgnored, "line-stipple", "the factor is 1"),
        row(StippleReversed, "line-stipple", "the highest bit comes first"),
        row(StippleRestarted, "line-stipple", "the pattern begins anew at each segment"),
        row(DiameterIsRadius, "line-smooth", "the width is half the width"),
        row(LineEndsRound, "line-smooth", "lines reach beyond their ends"),
        row(Affine, "line-interpolation", "places on the screen are places in space"),
        row(SamplesAtCentre, "sample-shading", "all samples are shaded at the centre"),
        row(DepthWithoutTest, "depth-only", "the last depth stays"),
        row(EyePlaneNotMoved, "eye-plane-inverse", "planes are left as they are"),
        row(TiesMovedUp, "line-ties", "ends are moved up and to the right"),
        row(LastPixelDrawn, "line-wide-values", "the column of the end is drawn"),
        row(
            WideValuesAcross,
            "line-wide-values",
            "values are constant at right angles to the line",
        ),
        row(LoopNotClosed, "line-joints", "a loop is a strip"),
        row(LastPixelDrawn, "line-joints", "the pixel where segments meet is drawn twice"),
        row(StippleReversed, "polygon-stipple", "the lowest bit is at the left"),
        row(StippleRowsFromTop, "polygon-stipple", "the first row is the highest"),
        row(OffsetQuartered, "polygon-offset-units", "a quarter of the resolvable difference"),
        row(
            OffsetOfOne,
            "polygon-offset-units",
            "the resolvable difference of a float is that of 1",
        ),
        row(SlopeOfX, "polygon-offset-slope", "the slope along y is left out"),
        row(FrontFaceSwapped, "cull-face", "front and back change places"),
        row(BothNotCulled, "cull-face", "GL_FRONT_AND_BACK culls nothing"),
        row(EdgeFlagsIgnored, "polygon-mode", "edge flags are left out"),
        row(CoverageOfCentre, "polygon-smooth", "a pixel is covered or not"),
        row(ClipPlaneNotMoved, "clip-plane", "planes do not pass the inverse model-view matrix"),
        row(ClipSideSwapped, "clip-plane", "the other side is left"),
    ]
};
