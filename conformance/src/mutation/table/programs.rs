//! Mistakes of transformation, light and GLSL.

use super::{MutationRow, row};
use crate::mutation::Mutation;

/// The rows of this file.
pub(super) const ROWS: &[MutationRow] = {
    use Mutation::*;
    &[
        row(DomainIgnored, "evaluator-curve", "the domain is taken for [0, 1]"),
        row(ControlPointsReversed, "evaluator-curve", "the last control point comes first"),
        row(ParametersSwapped, "evaluator-surface", "u and v change places"),
        row(CrossReversed, "evaluator-normal", "the normal is dp/dv × dp/du"),
        row(GridOneLess, "evaluator-grid", "a grid of n steps has n + 1"),
        row(AxisNotNormalized, "matrix-rotate", "the axis is taken as it is"),
        row(RotationReversed, "matrix-rotate", "clockwise"),
        row(AlwaysCentred, "matrix-frustum", "frusta are symmetrical"),
        row(FieldOfViewIsHalf, "matrix-frustum", "the field of view is half of it"),
        row(AlwaysCentred, "matrix-ortho", "boxes are symmetrical"),
        row(UpNotOrthogonal, "matrix-look-at", "up is taken as it is"),
        row(ProductReversed, "matrix-product", "matrices are multiplied from the left"),
        row(TransposeIgnored, "matrix-product", "glMultTransposeMatrix does not transpose"),
        row(ViewportOriginIgnored, "viewport", "the corner of the viewport is left out"),
        row(ViewportOriginIgnored, "raster-position", "the corner of the viewport is left out"),
        row(AlwaysValid, "raster-position", "positions outside are valid"),
        row(DepthsOfDevice, "selection", "depths are those of the device"),
        row(FacesSwapped, "two-sided-light", "front and back change places"),
        row(BackNormalKept, "two-sided-light", "the normal of the back is not reversed"),
        row(AlwaysAmbientAndDiffuse, "color-material", "ambient and diffuse are always tracked"),
        row(SpecularTextured, "separate-specular", "highlights are textured"),
        row(RescaleIgnored, "rescale-normal", "GL_RESCALE_NORMAL is left out"),
        row(SumBeforeTexture, "color-sum", "colours are summed before texturing"),
        row(ClampedLast, "vertex-color-clamp", "colours are clamped after they are interpolated"),
        row(Affine, "fog-depth", "places on the screen are places in space"),
        row(FogReversed, "fog-depth", "the factor weighs the fog"),
        row(IntegersSaturate, "glsl-integer-arithmetic", "sums do not wrap round"),
        row(QuotientFloored, "glsl-integer-arithmetic", "quotients are floored"),
        row(ShiftWithoutSign, "glsl-integer-bits", "int is shifted as uint is"),
        row(ComparedWithoutSign, "glsl-integer-compare", "int is compared as uint is"),
        row(ConversionRounds, "glsl-conversions", "fractions are rounded"),
        row(AllIsAny, "glsl-relational", "all is any"),
        row(NanIsLess, "glsl-relational", "not(lessThan) is greaterThanEqual"),
        row(StepStrict, "glsl-selecting", "step is 0 at its edge"),
        row(ReflectionReversed, "glsl-selecting", "faceforward turns the other way"),
        row(RowsForColumns, "glsl-matrix-product", "rows and columns change places"),
        row(RowsForColumns, "glsl-transpose", "rows and columns change places"),
        row(CofactorSignsIgnored, "glsl-determinant", "cofactors have no signs"),
        row(RowsForColumns, "glsl-inverse", "rows and columns change places"),
    ]
};
