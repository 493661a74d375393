//! The draw plan: every decision of a draw, taken once, before its loops.
//!
//! "Leave out what a scene does not need" is this plan. What it leaves out costs neither time nor
//! memory; `DETGL_EXPLAIN=1` prints it.

use crate::driver::{DepthWrite, Pipeline, PolygonOffset, Viewport};
use crate::ir::{Axis, Input, Interpolation, Output};
use crate::output::{ColorPlan, DepthFormat, DepthPlan};
use crate::raster::PlaneSource;
use crate::shader::Prepared;
use crate::target::stored_components;
use std::fmt::Write;
use std::sync::Arc;
use texunit::format::Format;
use texunit::lanes::Isa;
use texunit::plan::SamplePlan;
use texunit::sampler::Compare;

/// Textures by slot.
pub type Textures = Arc<[Option<Arc<SamplePlan>>]>;

/// Where a fragment program's input comes from. The numbers are planes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FragmentInput {
    /// Divided by the denominator.
    Smooth(usize),
    /// The plane as it is.
    Linear(usize),
    /// The plane's value at the provoking vertex.
    Flat(usize),
    /// How a smooth value changes from pixel to pixel.
    SmoothSlope(usize, Axis),
    /// How a linear value changes from pixel to pixel.
    LinearSlope(usize, Axis),
    /// Window x.
    X,
    /// Window y.
    Y,
    /// Window depth.
    Depth,
    /// Which side is seen.
    Front,
    /// Not there in this stage, or not needed by this draw.
    Zero,
}

/// When the depth test happens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DepthTiming {
    /// Neither test nor write.
    Never,
    /// Before shading: what fails is not shaded.
    Early(DepthPlan),
    /// After shading: the shader throws fragments away or writes depth. The program output that
    /// holds the depth, if it does.
    Late(DepthPlan, Option<usize>),
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
    /// The plane of depth, where anybody needs it.
    pub depth_plane: Option<usize>,
    /// The plane that smooth varyings are divided by, where there are any.
    pub denominator_plane: Option<usize>,
    /// When depth is tested.
    pub depth: DepthTiming,
    /// What is written to which colour attachment.
    pub colors: Vec<ColorPlan>,
    /// Whether the fragment program has to run at all.
    pub shading: Shading,
    /// Where the window is.
    pub viewport: Viewport,
    /// The polygon offset, where depth matters.
    pub offset: Option<PolygonOffset>,
}

/// Whether fragments are shaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// They are.
    On,
    /// Nobody takes a colour and nothing is thrown away: the depth test is all there is.
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
    /// The uniform words.
    pub uniforms: &'a [u32],
    /// The fragment textures.
    pub textures: Textures,
    /// The viewport.
    pub viewport: Viewport,
}

impl DrawPlan {
    /// Decides.
    pub fn new(pipeline: &Pipeline, input: PlanInput<'_>) -> Self {
        let compiled = pipeline.compiled();
        let (desc, fragment) = (&compiled.desc, &compiled.fragment);
        let output = |wanted: Output| fragment.outputs().iter().position(|&o| o == wanted);

        let mut colors = Vec::new();
        for (target, state) in desc.colors.iter().enumerate() {
            let Some(format) = input.colors.get(target).copied().flatten() else { continue };
            let outputs = [0, 1, 2, 3]
                .map(|component| output(Output::Color { target: target as u8, component }));
            let stored = stored_components(format);
            let mut write_mask = 0;
            for (component, (mask, stored)) in state.mask.into_iter().zip(stored).enumerate() {
                if mask && stored {
                    write_mask |= 0xFF << (8 * component);
                }
            }
            // A target that the shader never mentions is not written.
            let mentioned = desc.fragment.module().outputs.iter().any(
                |(o, _)| matches!(o, Output::Color { target: t, .. } if usize::from(*t) == target),
            );
            if write_mask != 0 && mentioned {
                colors.push(ColorPlan { target, outputs, blend: state.blend, write_mask });
            }
        }

        let depth_output = output(Output::Depth);
        let depth = match (desc.depth, input.depth.and_then(DepthFormat::of)) {
            (Some(state), Some(format))
                if state.test != Compare::Always || state.write == DepthWrite::On =>
            {
                let plan = DepthPlan { format, test: state.test, write: state.write };
                let thrown_away = fragment.discards() && state.write == DepthWrite::On;
                if thrown_away || depth_output.is_some() {
                    DepthTiming::Late(plan, depth_output)
                } else {
                    DepthTiming::Early(plan)
                }
            }
            _ => DepthTiming::Never,
        };
        let late = matches!(depth, DepthTiming::Late(..));
        let shading = if colors.is_empty() && !late { Shading::Off } else { Shading::On };

        let mut planes = Vec::new();
        let mut inputs = Vec::new();
        let mut plane = |source: PlaneSource| {
            planes.iter().position(|&p| p == source).unwrap_or_else(|| {
                planes.push(source);
                planes.len() - 1
            })
        };
        let reads_z = fragment.inputs().contains(&Input::FragCoord(2));
        let tests_z = matches!(depth, DepthTiming::Early(_) | DepthTiming::Late(_, None));
        let depth_plane = (tests_z || reads_z).then(|| plane(PlaneSource::Depth));
        let mut denominator_plane = None;
        // Nothing but levels of detail is made of slopes.
        let needs_slopes = fragment
            .texture_slots()
            .iter()
            .filter_map(|&slot| input.textures.get(slot as usize)?.as_ref())
            .any(|texture| texture.needs_lod());
        let read = if shading == Shading::On { fragment.inputs() } else { &[] };
        for &wanted in read {
            inputs.push(match wanted {
                Input::Varying(slot) => {
                    let at = compiled.varyings.iter().position(|&(s, _)| s == slot);
                    let (at, mode) =
                        at.map_or((0, Interpolation::Flat), |at| (at, compiled.varyings[at].1));
                    match mode {
                        Interpolation::Smooth => {
                            denominator_plane = Some(plane(PlaneSource::Denominator));
                            FragmentInput::Smooth(plane(PlaneSource::Smooth(at)))
                        }
                        Interpolation::NoPerspective => {
                            FragmentInput::Linear(plane(PlaneSource::NoPerspective(at)))
                        }
                        Interpolation::Flat => FragmentInput::Flat(plane(PlaneSource::Flat(at))),
                    }
                }
                Input::Slope { slot, axis } => {
                    let at = compiled.varyings.iter().position(|&(s, _)| s == slot);
                    match at.map(|at| (at, compiled.varyings[at].1)).filter(|_| needs_slopes) {
                        Some((at, Interpolation::Smooth)) => {
                            denominator_plane = Some(plane(PlaneSource::Denominator));
                            FragmentInput::SmoothSlope(plane(PlaneSource::Smooth(at)), axis)
                        }
                        Some((at, Interpolation::NoPerspective)) => {
                            FragmentInput::LinearSlope(plane(PlaneSource::NoPerspective(at)), axis)
                        }
                        Some((_, Interpolation::Flat)) | None => FragmentInput::Zero,
                    }
                }
                Input::FragCoord(0) => FragmentInput::X,
                Input::FragCoord(1) => FragmentInput::Y,
                Input::FragCoord(2) => FragmentInput::Depth,
                Input::FragCoord(_) => FragmentInput::Linear(plane(PlaneSource::InverseW)),
                Input::FrontFacing => FragmentInput::Front,
                Input::PointCoord(axis) => {
                    FragmentInput::Linear(plane(PlaneSource::PointCoord(axis)))
                }
                Input::Attribute { .. } | Input::VertexId | Input::InstanceId => {
                    FragmentInput::Zero
                }
            });
        }
        Self {
            prepared: fragment.prepare(input.isa, input.uniforms, &input.textures),
            textures: input.textures,
            planes,
            inputs,
            depth_plane,
            denominator_plane,
            depth,
            colors,
            shading,
            viewport: input.viewport,
            offset: desc.polygon_offset.filter(|_| depth_plane.is_some()),
            pipeline: pipeline.clone(),
        }
    }

    /// What runs, what was left out, and why.
    pub fn describe(&self) -> String {
        let compiled = self.pipeline.compiled();
        let desc = &compiled.desc;
        let mut text = String::new();
        let mut line = |name: &str, what: String| {
            let _ = writeln!(text, "  {name:<12} {what}");
        };
        line("vertex", compiled.vertex.describe());
        let dropped = compiled.written_varyings.saturating_sub(compiled.varyings.len());
        line(
            "varyings",
            format!(
                "{} scalars interpolated{}{}",
                compiled.varyings.len(),
                if dropped > 0 {
                    format!("; left out: {dropped} that the fragment stage does not read")
                } else {
                    String::new()
                },
                if self.denominator_plane.is_none() {
                    "; left out: perspective division (nothing smooth is read)"
                } else {
                    ""
                },
            ),
        );
        line(
            "depth",
            match (self.depth, desc.depth) {
                (DepthTiming::Never, None) => "left out: no depth test".into(),
                (DepthTiming::Never, Some(_)) => {
                    "left out: no depth attachment, or always passes and never writes".into()
                }
                (DepthTiming::Early(plan), _) => {
                    format!("early, {:?}, write {:?}", plan.test, plan.write)
                }
                (DepthTiming::Late(plan, output), _) => format!(
                    "late, {:?}, write {:?}: the shader {}",
                    plan.test,
                    plan.write,
                    if output.is_some() { "writes depth" } else { "throws fragments away" },
                ),
            },
        );
        match self.shading {
            Shading::On => {
                line("fragment", compiled.fragment.describe());
                for note in &desc.fragment.module().notes {
                    line("", note.clone());
                }
            }
            Shading::Off => line("fragment", "left out: no colour is written".into()),
        }
        for (slot, texture) in self.textures.iter().enumerate() {
            let used = compiled.fragment.texture_slots().contains(&(slot as u32));
            line(
                &format!("texture {slot}"),
                match texture {
                    _ if !used => "left out: not sampled".into(),
                    Some(plan) => plan.describe(),
                    None => "no texture: samples as (0, 0, 0, 1)".into(),
                },
            );
        }
        for color in &self.colors {
            line(
                &format!("colour {}", color.target),
                format!(
                    "{}, written bits {:08x}",
                    match color.blend {
                        Some(blend) => format!("blended, {:?}", blend.equation),
                        None => "left out: blending (the old colour is not read)".into(),
                    },
                    color.write_mask,
                ),
            );
        }
        line("planes", format!("{} evaluated a pixel", self.planes.len()));
        text
    }
}
