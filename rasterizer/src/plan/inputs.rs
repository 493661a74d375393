//! Where the inputs of fragments come from: the planes that are set up for each primitive of a draw, and which of
//! them an input reads.

use super::pipeline::Compiled;
use super::samples::Samples;
use crate::desc::{PipelineDesc, PolygonMode, PolygonSubject, PrimitiveClass, RasterState};
use crate::ir::{Axis, Input, Interpolation};
use crate::shader::AttributeSet;

/// What one plane of a draw holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneSource {
    /// Window depth.
    Depth,
    /// What smooth varyings are divided by: `1/w`, or 1 where all three `w` are the same.
    Denominator,
    /// `1/w` itself (`gl_FragCoord.w`).
    InverseW,
    /// A varying over `w` (its index in the geometry).
    Smooth(usize),
    /// A varying, linear in the window.
    NoPerspective(usize),
    /// A varying of the provoking vertex.
    Flat(usize),
    /// As [`PlaneSource::Smooth`], of front and of back faces.
    SmoothOfSides([usize; 2]),
    /// As [`PlaneSource::Flat`], of front and of back faces.
    FlatOfSides([usize; 2]),
    /// `gl_PointCoord`, 0 for s, 1 for t.
    PointCoord(u8),
    /// As [`PlaneSource::Smooth`], but component 0 to 3 of (s, t, 0, 1) where the shape is a point.
    Sprite(usize, u8),
    /// The direction of a line ([`Input::LineDirection`]).
    LineDirection(Axis),
}

/// The source of an input of a fragment program. The numbers are indices of planes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FragmentInput {
    /// Divided by the denominator.
    Smooth(usize),
    /// The plane as it is.
    Linear(usize),
    /// As [`Self::Smooth`], at the centroid of the covered samples.
    SmoothAtCentroid(usize),
    /// As [`Self::Linear`], at the centroid of the covered samples.
    LinearAtCentroid(usize),
    /// The plane's value at the provoking vertex.
    Flat(usize),
    /// The derivative of a smooth value along an axis.
    SmoothGradient(usize, Axis),
    /// The derivative of a linear value along an axis.
    LinearGradient(usize, Axis),
    /// Window x.
    X,
    /// Window y.
    Y,
    /// Window depth.
    Depth,
    /// The facing of the primitive.
    Front,
    /// The covered fraction of the pixel.
    Coverage,
    /// Window x or y of the sample that is shaded.
    PlaceOfSample(Axis),
    /// The number of the sample that is shaded.
    SampleId,
    /// Where that lies in its pixel.
    SamplePosition(Axis),
    /// 0: not an input of this stage, or not needed by this draw.
    Zero,
}

/// An input that each batch fills.
#[derive(Clone, Copy, Debug)]
pub struct FilledInput {
    /// Of the program's inputs.
    pub number: usize,
    pub from: FragmentInput,
    /// Those that are the slopes of this one across and up: filled with it, as they are made of the same quotient.
    pub slopes: Option<[usize; 2]>,
}

impl FilledInput {
    /// The inputs that are not zero and for which `is_needed` is true.
    pub fn of(inputs: &[FragmentInput], is_needed: impl Fn(usize) -> bool) -> Vec<Self> {
        let is_filled =
            |&number: &usize| inputs[number] != FragmentInput::Zero && is_needed(number);
        let all: Vec<usize> = (0..inputs.len()).filter(is_filled).collect();
        let slope = |plane: usize, axis: Axis| {
            let of = FragmentInput::SmoothGradient(plane, axis);
            all.iter().copied().find(|&number| inputs[number] == of)
        };
        let filled = all.iter().map(|&number| {
            let slopes = match inputs[number] {
                FragmentInput::Smooth(plane) => slope(plane, Axis::X).zip(slope(plane, Axis::Y)),
                FragmentInput::Linear(_)
                | FragmentInput::SmoothAtCentroid(_)
                | FragmentInput::LinearAtCentroid(_)
                | FragmentInput::Flat(_)
                | FragmentInput::SmoothGradient(..)
                | FragmentInput::LinearGradient(..)
                | FragmentInput::X
                | FragmentInput::Y
                | FragmentInput::Depth
                | FragmentInput::Front
                | FragmentInput::Coverage
                | FragmentInput::PlaceOfSample(_)
                | FragmentInput::SampleId
                | FragmentInput::SamplePosition(_)
                | FragmentInput::Zero => None,
            };
            Self { number, from: inputs[number], slopes: slopes.map(<[usize; 2]>::from) }
        });
        let mut filled: Vec<Self> = filled.collect();
        let slopes: Vec<usize> = filled.iter().filter_map(|input| input.slopes).flatten().collect();
        filled.retain(|input| !slopes.contains(&input.number));
        filled
    }
}

/// Collects the planes that the inputs of a draw read.
pub struct InputPlanner<'a> {
    pub compiled: &'a Compiled,
    /// The first slots of the varyings that sprites replace.
    pub replaced: &'a [u16],
    /// The attribute components that come from arrays.
    pub arrays: AttributeSet,
    /// Whether any level of detail is made of slopes.
    pub needs_slopes: bool,
    pub samples: &'a Samples,
    pub planes: Vec<PlaneSource>,
    /// The plane that smooth values are divided by.
    pub denominator: Option<usize>,
}

/// The planes of a draw and what reads them.
pub struct InputPlanes {
    pub planes: Vec<PlaneSource>,
    pub depth_plane: Option<usize>,
    pub denominator_plane: Option<usize>,
    /// By input of the fragment program.
    pub inputs: Vec<FragmentInput>,
}

impl InputPlanner<'_> {
    /// Finds the planes of these inputs, and of the depth that is tested or read.
    pub fn plan(mut self, depth: Option<PlaneSource>, read: &[Input]) -> InputPlanes {
        let depth_plane = depth.map(|depth| self.plane(depth));
        let inputs = read.iter().map(|&input| self.input(input)).collect();
        let Self { planes, denominator, .. } = self;
        InputPlanes { planes, depth_plane, denominator_plane: denominator, inputs }
    }

    /// The number of a plane.
    fn plane(&mut self, source: PlaneSource) -> usize {
        self.planes.iter().position(|&plane| plane == source).unwrap_or_else(|| {
            self.planes.push(source);
            self.planes.len() - 1
        })
    }

    fn input(&mut self, input: Input) -> FragmentInput {
        match input {
            Input::Varying(slot) => self.varying(slot),
            Input::Gradient { slot, axis } => self.slope(slot, axis),
            Input::FragCoord(0) if self.samples.is_shaded_each() => {
                FragmentInput::PlaceOfSample(Axis::X)
            }
            Input::FragCoord(1) if self.samples.is_shaded_each() => {
                FragmentInput::PlaceOfSample(Axis::Y)
            }
            Input::FragCoord(0) => FragmentInput::X,
            Input::FragCoord(1) => FragmentInput::Y,
            Input::FragCoord(2) => FragmentInput::Depth,
            Input::FragCoord(_) => FragmentInput::Linear(self.plane(PlaneSource::InverseW)),
            Input::FrontFacing => FragmentInput::Front,
            Input::Coverage => FragmentInput::Coverage,
            Input::SampleId => FragmentInput::SampleId,
            Input::SamplePosition(axis) => FragmentInput::SamplePosition(axis),
            // It turns slopes.
            Input::LineDirection(axis) if self.needs_slopes => {
                FragmentInput::Flat(self.plane(PlaneSource::LineDirection(axis)))
            }
            Input::LineDirection(_) => FragmentInput::Zero,
            Input::PointCoord(axis) => {
                FragmentInput::Linear(self.plane(PlaneSource::PointCoord(axis)))
            }
            Input::Attribute { .. }
            | Input::VertexId
            | Input::InstanceId
            | Input::OfVertex { .. }
            | Input::PrimitiveId => FragmentInput::Zero,
        }
    }

    fn varying(&mut self, slot: u16) -> FragmentInput {
        let (at, mode) = self.varying_at(slot).unwrap_or((0, Interpolation::Flat));
        let mode = if self.is_constant(slot) { Interpolation::Flat } else { mode };
        // With one sample, it lies at the centre. What is shaded at a sample is interpolated there (ARB_sample_shading).
        let centroids = &self.compiled.desc.fragment.module().centroids;
        let at_centroid =
            self.samples.is_each() && !self.samples.is_shaded_each() && centroids.contains(&slot);
        match mode {
            Interpolation::Smooth => match self.smooth(slot, at) {
                index if at_centroid => FragmentInput::SmoothAtCentroid(index),
                index => FragmentInput::Smooth(index),
            },
            Interpolation::NoPerspective => match self.plane(PlaneSource::NoPerspective(at)) {
                index if at_centroid => FragmentInput::LinearAtCentroid(index),
                index => FragmentInput::Linear(index),
            },
            Interpolation::Flat => FragmentInput::Flat(self.flat(slot, at)),
        }
    }

    fn slope(&mut self, slot: u16, axis: Axis) -> FragmentInput {
        match self.varying_at(slot).filter(|_| self.needs_slopes && !self.is_constant(slot)) {
            Some((at, Interpolation::Smooth)) => {
                FragmentInput::SmoothGradient(self.smooth(slot, at), axis)
            }
            Some((at, Interpolation::NoPerspective)) => {
                FragmentInput::LinearGradient(self.plane(PlaneSource::NoPerspective(at)), axis)
            }
            Some((_, Interpolation::Flat)) | None => FragmentInput::Zero,
        }
    }

    /// The index of a varying among those that are interpolated, and its mode.
    fn varying_at(&self, slot: u16) -> Option<(usize, Interpolation)> {
        let varyings = &self.compiled.varyings;
        let at = varyings.iter().position(|&(of, _)| of == slot)?;
        Some((at, varyings[at].1))
    }

    /// The first of the four slots that a sprite replaces, if this one is among them.
    fn sprite(&self, slot: u16) -> Option<u16> {
        self.replaced.iter().copied().find(|first| (*first..first + 4).contains(&slot))
    }

    /// Whether a varying is equal at all vertices; it then needs no plane.
    fn is_constant(&self, slot: u16) -> bool {
        self.sprite(slot).is_none() && self.compiled.is_constant(slot, self.arrays)
    }

    /// The indices of a varying and of that whose planes it has at back faces, if it is one of two.
    fn sides(&self, slot: u16, at: usize) -> Option<[usize; 2]> {
        let sides = self.compiled.sides.iter().find(|sides| sides.front == slot)?;
        Some([at, self.varying_at(sides.back)?.0])
    }

    /// The plane of a flat varying.
    fn flat(&mut self, slot: u16, at: usize) -> usize {
        let sides = self.sides(slot, at);
        self.plane(sides.map_or(PlaneSource::Flat(at), PlaneSource::FlatOfSides))
    }

    /// The plane of a smooth varying, or of what a sprite puts in its place.
    fn smooth(&mut self, slot: u16, at: usize) -> usize {
        self.denominator = Some(self.plane(PlaneSource::Denominator));
        let source = match (self.sprite(slot), self.sides(slot, at)) {
            (Some(first), _) => PlaneSource::Sprite(at, (slot - first) as u8),
            (None, Some(sides)) => PlaneSource::SmoothOfSides(sides),
            (None, None) => PlaneSource::Smooth(at),
        };
        self.plane(source)
    }
}

/// Whether a draw may draw lines.
pub fn draws_lines(desc: &PipelineDesc, raster: &RasterState) -> bool {
    match desc.drawn().class() {
        PrimitiveClass::Points => false,
        PrimitiveClass::Lines => true,
        PrimitiveClass::Polygons => raster.polygon.mode.contains(&PolygonMode::Line),
    }
}

/// Whether ρ of all that a draw draws is 1 (GL 2.1, section 3.8.8): of points that have the same varyings everywhere, so no
/// sprites, and of pixel rectangles and bitmaps.
pub fn has_unit_scale_factor(desc: &PipelineDesc, raster: &RasterState) -> bool {
    match raster.polygon.subject {
        PolygonSubject::PixelRectangle => return true,
        PolygonSubject::Polygons => {}
    }
    let draws_only_points = match desc.drawn().class() {
        PrimitiveClass::Points => true,
        PrimitiveClass::Lines => false,
        PrimitiveClass::Polygons => {
            raster.polygon.mode.iter().all(|mode| *mode == PolygonMode::Point)
        }
    };
    draws_only_points && sprite_slots(desc, raster).is_empty()
}

/// The first slots of the varyings that points of a draw replace, where it draws any.
pub fn sprite_slots<'a>(desc: &PipelineDesc, raster: &'a RasterState) -> &'a [u16] {
    let points = match desc.drawn().class() {
        PrimitiveClass::Points => true,
        PrimitiveClass::Lines => false,
        PrimitiveClass::Polygons => raster.polygon.mode.contains(&PolygonMode::Point),
    };
    if points { raster.point.sprite.as_deref().unwrap_or(&[]) } else { &[] }
}
