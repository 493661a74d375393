//! How primitives become fragments: state that changes from draw to draw without compiling
//! anything (GL 2.1, sections 3.3 to 3.5).

use super::mask::PixelMask;
use std::sync::Arc;

/// The largest size of a point in pixels; larger ones are drawn with it.
pub const MAX_POINT_SIZE: f32 = 256.0;
/// The largest width of a line in pixels; wider ones are drawn with it.
pub const MAX_LINE_WIDTH: f32 = 64.0;

/// How a polygon is drawn (GL 2.1, section 3.5.4).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum PolygonMode {
    /// Its vertices as points.
    Point,
    /// Its edges as lines.
    Line,
    /// Its inside.
    #[default]
    Fill,
}

/// Whether coverage of a pixel is all or nothing, or a fraction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Antialiasing {
    /// A fragment covers all of its pixel or does not exist.
    #[default]
    Aliased,
    /// A fragment for every pixel that is touched; `Input::Coverage` is the fraction that is covered.
    Smooth,
}

/// Added to the depth of a polygon: `factor · m + units · r` (GL 2.1, section 3.5.5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolygonOffset {
    /// Times the largest depth slope.
    pub factor: f32,
    /// Times the smallest resolvable difference.
    pub units: f32,
    /// The largest sum if positive, the least if negative (`ARB_polygon_offset_clamp`); 0 bounds nothing.
    pub clamp: f32,
}

/// The stipple of filled polygons: the pixels that are drawn.
#[derive(Clone, Debug, PartialEq)]
pub enum Stipple {
    /// Of every 32×32, row by row from the lowest, the leftmost pixel in the highest bit (GL 2.1, section
    /// 3.5.2).
    Pattern([u32; 32]),
    /// The pixels of a bitmap.
    Mask(Arc<PixelMask>),
}

/// What polygons stand for, which says by which scale factor they are textured (GL 2.1, section 3.8.8).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum PolygonSubject {
    /// Themselves.
    #[default]
    Polygons,
    /// A pixel rectangle or a bitmap, whose ρ is 1.
    PixelRectangle,
}

/// Polygons, however they are drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PolygonState {
    /// What they stand for.
    pub subject: PolygonSubject,
    /// How front and back faces are drawn.
    pub mode: [PolygonMode; 2],
    /// By the mode that a polygon is drawn in: points, lines, filled.
    pub offset: [Option<PolygonOffset>; 3],
    /// Antialiasing of filled ones.
    pub antialiasing: Antialiasing,
    /// The stipple of filled ones; `None` draws all pixels.
    pub stipple: Option<Stipple>,
    /// The location of an attribute of one component: not zero where a boundary edge begins (GL 2.1,
    /// section 2.6.2). `None` makes all edges boundaries.
    pub edge_flag: Option<u8>,
}

/// The stipple of lines: fragment `s` is drawn if bit `(s / factor) mod 16` of the pattern is set
/// (GL 2.1, section 3.4.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LineStipple {
    /// Fragments per bit, 1 to 256.
    pub factor: u16,
    /// The pattern, from its lowest bit up.
    pub pattern: u16,
}

/// Lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineState {
    /// In pixels; above zero.
    pub width: f32,
    /// Their antialiasing.
    pub antialiasing: Antialiasing,
    /// The stipple; `None` draws all fragments.
    pub stipple: Option<LineStipple>,
}

/// The source of point sizes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PointSize {
    /// The state.
    #[default]
    State,
    /// The vertex stage, where it writes one.
    Vertex,
}

/// The edge of a point sprite at which t is 0 (GL 2.1, section 3.3).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SpriteOrigin {
    /// At its upper edge.
    #[default]
    UpperLeft,
    /// At its lower edge.
    LowerLeft,
}

/// Points.
#[derive(Clone, Debug, PartialEq)]
pub struct PointState {
    /// In pixels; above zero.
    pub size: f32,
    /// Whether the vertex stage replaces it.
    pub source: PointSize,
    /// Antialiasing of those that are no sprites.
    pub antialiasing: Antialiasing,
    /// The first of four varying slots that become (s, t, 0, 1) of the sprite; `None` where points
    /// are no sprites.
    pub sprite: Option<Vec<u16>>,
    /// The origin of `Input::PointCoord`.
    pub origin: SpriteOrigin,
    /// Where each sample is covered by itself: points below this size are drawn with it, and `Input::Coverage` is by
    /// how much they fade (GL 2.1, section 3.3). `None` where none does.
    pub fade: Option<f32>,
}

/// Which samples of a pixel a primitive covers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SampleRule {
    /// All or none, as it does the centre.
    #[default]
    Center,
    /// Coverage is computed for each sample. Antialiasing state is ignored; points are discs and lines rectangles.
    Each,
}

/// Whether alpha determines how many samples a fragment keeps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AlphaToCoverage {
    /// All covered samples.
    #[default]
    Off,
    /// Of the `n` samples, the first `round(alpha n)`, alpha being that of the first colour.
    On,
}

/// Whether a fragment's alpha becomes 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AlphaToOne {
    /// Unchanged.
    #[default]
    Off,
    /// Alpha becomes 1, after [`AlphaToCoverage`] has used it.
    On,
}

/// Which samples all fragments keep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SampleCoverage {
    /// Of the `n` samples, the first `round(value n)`.
    Part(f32),
    /// The others.
    AllBut(f32),
}

/// Several samples a pixel (GL 2.1, sections 3.2.1 and 4.1.3); nothing where attachments have one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MultisampleState {
    /// Which are covered.
    pub rule: SampleRule,
    /// Which of them alpha leaves.
    pub alpha_to_coverage: AlphaToCoverage,
    /// What alpha is written.
    pub alpha_to_one: AlphaToOne,
    /// The samples that the coverage value keeps.
    pub coverage: Option<SampleCoverage>,
    /// The samples that the mask keeps, bit by sample (`ARB_texture_multisample`, section 4.1.3).
    pub mask: u32,
    /// How often fragments are shaded.
    pub shading: SampleShading,
}

/// How often fragments of several samples are shaded (`ARB_sample_shading`). A program that reads a sample's number or
/// position is run for each in any case.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SampleShading {
    /// Once.
    #[default]
    Once,
    /// For each covered sample, at its position.
    Each,
}

impl Default for MultisampleState {
    fn default() -> Self {
        Self {
            rule: SampleRule::default(),
            alpha_to_coverage: AlphaToCoverage::default(),
            alpha_to_one: AlphaToOne::default(),
            coverage: None,
            mask: u32::MAX,
            shading: SampleShading::default(),
        }
    }
}

/// What the left, right, lower and upper side of the view volume do to lines and points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ViewSides {
    /// They clip lines, which are as wide outside, and drop points whose centre is outside (GL 2.1, section 2.12).
    #[default]
    Clip,
    /// They clip neither (OpenGL ES 3.0, section 2.17); nothing is drawn outside the viewport.
    Bound,
}

/// All raster state.
#[derive(Clone, Debug, PartialEq)]
pub struct RasterState {
    /// Polygons.
    pub polygon: PolygonState,
    /// Lines, and polygons drawn as lines.
    pub line: LineState,
    /// Points, and polygons drawn as points.
    pub point: PointState,
    /// The sides of the view volume, for lines and points.
    pub sides: ViewSides,
    /// The samples of pixels.
    pub multisample: MultisampleState,
}

impl Default for RasterState {
    fn default() -> Self {
        Self {
            polygon: PolygonState::default(),
            line: LineState { width: 1.0, antialiasing: Antialiasing::Aliased, stipple: None },
            point: PointState {
                size: 1.0,
                source: PointSize::State,
                antialiasing: Antialiasing::Aliased,
                sprite: None,
                origin: SpriteOrigin::UpperLeft,
                fade: None,
            },
            sides: ViewSides::default(),
            multisample: MultisampleState::default(),
        }
    }
}

impl LineState {
    /// The width that lines are drawn with: whole pixels unless smooth (GL 2.1, section 3.4.2).
    pub(crate) fn drawn_width(&self) -> f32 {
        match self.antialiasing {
            Antialiasing::Aliased => self.width.round().clamp(1.0, MAX_LINE_WIDTH),
            Antialiasing::Smooth => self.width.clamp(1.0 / 256.0, MAX_LINE_WIDTH),
        }
    }
}

impl RasterState {
    /// The same for attachments of `samples` samples. Where each is covered by itself, a primitive
    /// may touch the pixels that one with a smooth edge touches.
    pub(crate) fn for_samples(self: Arc<Self>, samples: u8) -> Arc<Self> {
        if samples == 1 || self.multisample.rule == SampleRule::Center {
            return self;
        }
        let mut state = (*self).clone();
        state.polygon.antialiasing = Antialiasing::Smooth;
        state.line.antialiasing = Antialiasing::Smooth;
        state.point.antialiasing = Antialiasing::Smooth;
        Arc::new(state)
    }

    /// The first rule that it breaks, if any.
    pub(crate) fn fault(&self) -> Option<&'static str> {
        if !(self.line.width > 0.0 && self.point.size > 0.0) {
            return Some("SetRaster: widths and sizes must be above zero");
        }
        if self.line.stipple.is_some_and(|stipple| !(1..=256).contains(&stipple.factor)) {
            return Some("SetRaster: the stipple factor must be 1 to 256");
        }
        None
    }
}
