//! The draw plan: every decision of a draw, taken once, before its loops.
//!
//! "Leave out what a scene does not need" is this plan. What it leaves out costs neither time nor
//! memory; `DETGL_EXPLAIN=1` prints it.

mod describe;
mod inputs;
mod leave_out;
mod outputs;
mod pipeline;
mod product;
mod samples;
mod specializations;
mod stipple;

pub use inputs::{
    FilledInput, FragmentInput, PlaneSource, draws_lines, has_unit_scale_factor, sprite_slots,
};
use inputs::{InputPlanes, InputPlanner};
pub use leave_out::LeaveOut;
pub use pipeline::Pipeline;
pub use product::{FactorPlanes, ProductInputs, ProductPlan};
pub use samples::{SampleMasks, Samples, moved, possible_samples, sample_positions};
use stipple::StippleLanes;

use crate::attachment::DepthFormat;
use crate::desc::{
    Antialiasing, PolygonMode, PolygonOffset, RasterState, VertexBinding, VertexSource, Viewport,
};
use crate::ir::{Input, Output};
use crate::output::{ColorPlan, Tests};
use crate::shader::{AttributeSet, Prepared};
use std::sync::Arc;
use texunit::format::Format;
use texunit::lanes::Isa;
use texunit::plan::SamplePlan;

/// Textures by slot.
pub type Textures = Arc<[Option<Arc<SamplePlan>>]>;

/// When the stencil and depth tests happen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TestTiming {
    /// Neither test nor write.
    Never,
    /// Before shading: fragments that fail are not shaded.
    Early,
    /// After shading: the shader discards fragments while the tests write, or writes depth or the stencil reference.
    Late(ShaderTestOutputs),
}

/// The program outputs that hold what a shader writes for the tests.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ShaderTestOutputs {
    /// The depth.
    pub depth: Option<usize>,
    /// The stencil reference.
    pub reference: Option<usize>,
}

/// The decisions of one draw.
#[derive(Debug)]
pub struct DrawPlan {
    /// The pipeline.
    pub pipeline: Pipeline,
    /// The fragment program's values of this draw.
    pub prepared: Prepared,
    /// The fragment program's textures.
    pub textures: Textures,
    /// The planes that a shape needs.
    pub planes: Vec<PlaneSource>,
    /// By input of the fragment program.
    pub inputs: Vec<FragmentInput>,
    /// Those of them that batches fill.
    pub interpolated_inputs: Vec<FilledInput>,
    /// Whether any of them is taken at the centroid of the covered samples.
    pub centroids: bool,
    /// Whether any of them is how much of its pixel is covered.
    pub reads_coverage: bool,
    /// The plane of depth, where it is used.
    pub depth_plane: Option<usize>,
    /// Whether shading needs the depths of its fragments: the program reads them, or a test waits for it.
    pub shades_depth: bool,
    /// The plane that smooth varyings are divided by, where there are any.
    pub denominator_plane: Option<usize>,
    /// The stencil and depth tests.
    pub tests: Tests,
    /// When they happen.
    pub timing: TestTiming,
    /// The smallest difference of depths, where it is the same for all.
    pub resolution: Option<f64>,
    /// What is written to which colour attachment.
    pub colors: Vec<ColorPlan>,
    /// Whether the fragment program has to run at all.
    pub shading: Shading,
    /// Blocks that may be shaded together, see [`crate::shader::Machine::run_files`].
    pub blocks_per_group: usize,
    /// How whole blocks are shaded without the interpreter, if they are.
    pub product: Option<ProductPlan>,
    /// How sparse fragments are packed.
    pub packing: Packing,
    /// The viewport.
    pub viewport: Viewport,
    /// The offset of filled polygons, where depth matters.
    pub offset: Option<PolygonOffset>,
    /// The samples of its pixels.
    pub samples: Samples,
    /// How primitives become fragments.
    pub raster: Arc<RasterState>,
    /// Which lanes the polygon stipple leaves.
    pub stipple: Option<StippleLanes>,
    /// The attribute components that come from arrays.
    arrays: AttributeSet,
    counting: Counting,
    leave_out: LeaveOut,
}

/// How fragments of sparsely covered blocks are put into batches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Packing {
    /// By quads: what is computed depends on neighbours, or on the fraction of a pixel that is covered.
    Quads,
    /// By quads whose pixels have several samples.
    SampledQuads,
    /// By pixels.
    Pixels,
}

/// Whether fragments are shaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// Yes.
    On,
    /// No: no colour is written and no fragment discarded. Only the depth and stencil tests and the sample counter run.
    Off,
}

/// What a plan depends on besides the pipeline.
pub struct PlanInput<'a> {
    /// The instruction set of the per-draw computations.
    pub isa: Isa,
    /// Formats of the colour attachments.
    pub colors: &'a [Option<Format>],
    /// Format of the depth attachment.
    pub depth: Option<Format>,
    /// Samples of a pixel of all attachments.
    pub samples: u8,
    /// The uniform words.
    pub uniforms: &'a [u32],
    /// The fragment textures.
    pub textures: Textures,
    /// The viewport.
    pub viewport: Viewport,
    /// How primitives become fragments.
    pub raster: Arc<RasterState>,
    /// Whether samples are counted.
    pub counting: Counting,
    /// What is left out.
    pub leave_out: LeaveOut,
    /// Where vertices come from.
    pub vertices: &'a [VertexBinding],
}

/// Whether the samples of a draw are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counting {
    /// They are not counted.
    Off,
    /// They are counted: what the shader discards must be known, even if nothing is written.
    On,
}

impl DrawPlan {
    /// Makes the decisions.
    pub fn new(pipeline: &Pipeline, input: PlanInput<'_>) -> Self {
        let compiled = pipeline.compiled();
        let (desc, fragment) = (&compiled.desc, &compiled.fragment);
        let output = |wanted: Output| fragment.output(wanted);

        let colors = outputs::colors(pipeline, input.colors, input.leave_out);
        let tests = outputs::tests(pipeline, input.depth, input.leave_out);
        let written = ShaderTestOutputs {
            depth: output(Output::Depth).filter(|_| tests.depth.is_some()),
            reference: output(Output::StencilReference).filter(|_| tests.stencil.is_some()),
        };
        let samples = Samples::new(input.samples, &input.raster.multisample, fragment);
        let discards = fragment.discards() || samples.alpha.or(samples.mask).is_some();
        let timing = if tests == Tests::default() {
            TestTiming::Never
        } else if discards && tests.write() || written != ShaderTestOutputs::default() {
            TestTiming::Late(written)
        } else {
            TestTiming::Early
        };
        let late = matches!(timing, TestTiming::Late(_));
        let counts = input.counting == Counting::On && discards;
        let is_seen = !colors.is_empty() || late || counts;
        let shading = match input.leave_out {
            LeaveOut::WithoutEffect if !is_seen => Shading::Off,
            LeaveOut::WithoutEffect | LeaveOut::Nothing => Shading::On,
        };

        // Nothing but levels of detail is made of slopes.
        let needs_slopes = fragment.queries_lod()
            || fragment
                .texture_slots()
                .iter()
                .filter_map(|&slot| input.textures.get(slot as usize)?.as_ref())
                .any(|texture| texture.needs_lod());
        let of = InputPlanner {
            compiled,
            replaced: sprite_slots(desc, &input.raster),
            arrays: arrays(input.vertices),
            needs_slopes,
            samples: &samples,
            planes: Vec::new(),
            denominator: None,
        };
        let tests_z = tests.depth.is_some() && written.depth.is_none();
        let reads_z = fragment.inputs().contains(&Input::FragCoord(2));
        let depth = (tests_z || reads_z).then_some(PlaneSource::Depth);
        let read = if shading == Shading::On { fragment.inputs() } else { &[] };
        let InputPlanes { planes, depth_plane, denominator_plane, inputs } = of.plan(depth, read);
        let within = |input: &FragmentInput| {
            matches!(input, FragmentInput::SmoothAtCentroid(_) | FragmentInput::LinearAtCentroid(_))
        };
        let needs_lod = |slot: u32| {
            let texture = input.textures.get(slot as usize).and_then(Option::as_ref);
            texture.is_some_and(|texture| texture.needs_lod())
        };
        let is_whole = samples.count == 1 && !inputs.contains(&FragmentInput::Coverage);
        let is_without_helper_lanes = is_whole && !fragment.reads_neighbours(needs_lod);
        let centroids = inputs.iter().any(within);
        // With nothing left to decide once they are shaded.
        let is_plain = samples.share_colors()
            && !centroids
            && !inputs.contains(&FragmentInput::Coverage)
            && shading == Shading::On
            && !late;
        let blocks_per_group = if is_plain { fragment.register_files() } else { 1 };
        let may_multiply = blocks_per_group > 1 && colors.len() == 1 && colors[0].target == 0;
        Self {
            product: if may_multiply {
                ProductPlan::new(input.isa, fragment, &inputs, &input.textures)
            } else {
                None
            },
            blocks_per_group,
            shades_depth: late || inputs.contains(&FragmentInput::Depth),
            packing: match samples.count {
                1 if is_without_helper_lanes => Packing::Pixels,
                1 => Packing::Quads,
                _ => Packing::SampledQuads,
            },
            centroids,
            reads_coverage: inputs.contains(&FragmentInput::Coverage),
            prepared: fragment.prepare(input.isa, input.uniforms, &input.textures),
            textures: input.textures,
            planes,
            interpolated_inputs: FilledInput::of(&inputs, |_| true),
            inputs,
            depth_plane,
            denominator_plane,
            tests,
            timing,
            resolution: input.depth.and_then(DepthFormat::of).and_then(DepthFormat::resolution),
            colors,
            shading,
            samples,
            viewport: input.viewport,
            offset: input.raster.polygon.offset[PolygonMode::Fill as usize]
                .filter(|_| depth_plane.is_some()),
            stipple: input.raster.polygon.stipple.as_ref().map(StippleLanes::new),
            arrays: arrays(input.vertices),
            counting: input.counting,
            leave_out: input.leave_out,
            raster: input.raster,
            pipeline: pipeline.clone(),
        }
    }

    /// Whether this plan is valid for another draw of the same pass, whose fragment program has the per-draw values
    /// `prepared`.
    pub fn is_reusable_for(
        &self,
        pipeline: &Pipeline,
        input: &PlanInput<'_>,
        prepared: Option<&Prepared>,
    ) -> bool {
        self.pipeline.is_same(pipeline)
            && same_textures(&self.textures, &input.textures)
            && prepared.is_none_or(|prepared| prepared.has_values_of(&self.prepared))
            && self.viewport == input.viewport
            && self.counting == input.counting
            && self.arrays == arrays(input.vertices)
            && (Arc::ptr_eq(&self.raster, &input.raster) || self.raster == input.raster)
    }

    /// Whether the outline of a triangle alone determines its coverage, with one sample.
    pub fn covers_by_outline(&self) -> bool {
        self.samples.count == 1
            && self.samples.keeps(0)
            && self.raster.polygon.antialiasing == Antialiasing::Aliased
            && self.stipple.is_none()
            && !self.reads_coverage
    }
}

impl DrawPlan {
    /// Whether its triangles overwrite every pixel that they cover, whatever was there.
    pub fn overwrites(&self) -> bool {
        let fragment = &self.pipeline.compiled().fragment;
        self.leave_out == LeaveOut::WithoutEffect
            && self.timing == TestTiming::Never
            && self.shading == Shading::On
            && self.covers_by_outline()
            && !fragment.discards()
            && !fragment.has_loops()
            && self.colors.iter().all(ColorPlan::overwrites)
    }

    /// Whether the draw leaves nothing behind: no colour, depth or stencil, and no count of samples.
    pub fn has_no_effect(&self) -> bool {
        self.shading == Shading::Off && !self.tests.write() && self.counting == Counting::Off
    }

    /// Whether it leaves nothing behind but colours.
    pub fn leaves_only_colors(&self) -> bool {
        self.timing == TestTiming::Never
    }
}

/// The attribute components that come from arrays.
pub fn arrays(bindings: &[VertexBinding]) -> AttributeSet {
    let of = |sources: AttributeSet, binding: &VertexBinding| match binding.source {
        VertexSource::Constant(_) => sources,
        VertexSource::Array { components, .. } => {
            sources.and(AttributeSet::attribute(binding.location, (1 << components.min(4)) - 1))
        }
    };
    bindings.iter().fold(AttributeSet::default(), of)
}

/// Whether two lists hold the same plans.
pub fn same_textures(a: &Textures, b: &Textures) -> bool {
    let same = |(a, b): (&Option<Arc<SamplePlan>>, &Option<Arc<SamplePlan>>)| match (a, b) {
        (Some(a), Some(b)) => Arc::ptr_eq(a, b),
        (None, None) => true,
        (Some(_), None) | (None, Some(_)) => false,
    };
    a.len() == b.len() && a.iter().zip(b.iter()).all(same)
}
