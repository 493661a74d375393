//! Pipelines: shaders and fixed state, checked and compiled once, immutable ever after.

use super::output::OutputState;
use crate::ir::{Input, Interpolation, Module, Output, Stage};
use crate::shader::{Draft, Program};
use crate::stack::with_room;
use std::hash::{Hash, Hasher};
use std::sync::{Arc, OnceLock};
use texunit::sampler::Compare;
use thiserror::Error;

/// So many blocks deep, a module is compiled on any stack.
const SHALLOW: usize = 16;

/// A validated shader stage. Equal when it is the same module, not an equal one.
#[derive(Clone, Debug)]
pub struct ShaderModule(Arc<Module>);

impl ShaderModule {
    /// Takes a module in.
    ///
    /// # Errors
    /// When the module breaks a rule of the IR.
    pub fn new(module: Module) -> Result<Self, crate::ir::IrError> {
        module.validate()?;
        Ok(Self(Arc::new(module)))
    }

    /// The module.
    pub fn module(&self) -> &Module {
        &self.0
    }
}

impl PartialEq for ShaderModule {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for ShaderModule {}

impl Hash for ShaderModule {
    fn hash<H: Hasher>(&self, state: &mut H) {
        Arc::as_ptr(&self.0).hash(state);
    }
}

/// How vertices make primitives (GL 2.1, section 2.6.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Topology {
    /// Each vertex a point.
    Points,
    /// Each pair a line.
    Lines,
    /// Each vertex joined to the next.
    LineStrip,
    /// And the last to the first.
    LineLoop,
    /// Each three a triangle.
    Triangles,
    /// Each vertex with the two before it.
    TriangleStrip,
    /// Each two with the first.
    TriangleFan,
    /// Each four a quadrilateral.
    Quads,
    /// Each pair with the pair before it.
    QuadStrip,
    /// All vertices one convex polygon.
    Polygon,
}

/// Which faces are not drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Cull {
    /// All are drawn.
    None,
    /// Front faces are not drawn.
    Front,
    /// Back faces are not drawn.
    Back,
    /// No polygon is drawn; points and lines are.
    Both,
}

/// Which winding, seen in the window with y up, is the front.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FrontFace {
    /// Counter-clockwise.
    Ccw,
    /// Clockwise.
    Cw,
}

/// Which vertex flat varyings come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Provoking {
    /// GL's default.
    Last,
    /// Vulkan's default.
    First,
}

/// What is done with depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DepthState {
    /// `new OP stored` must hold.
    pub test: Compare,
    /// Whether passing fragments write.
    pub write: DepthWrite,
}

/// Whether passing fragments write their depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DepthWrite {
    /// They do.
    On,
    /// They do not.
    Off,
}

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
    fn needs(&self, component: usize) -> bool {
        // Blending weights every component by source alpha, or may.
        self.mask[component]
            || (component == 3 && self.blend.is_some() && self.mask.contains(&true))
    }
}

/// Everything a pipeline is made of; also the key to cache it by.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct PipelineDesc {
    /// The vertex stage.
    pub vertex: ShaderModule,
    /// The fragment stage; varyings meet by slot.
    pub fragment: ShaderModule,
    /// How vertices make primitives.
    pub topology: Topology,
    /// Which faces are not drawn.
    pub cull: Cull,
    /// Which winding is the front.
    pub front_face: FrontFace,
    /// Where flat varyings come from.
    pub provoking: Provoking,
    /// Depth test; `None` neither tests nor writes.
    pub depth: Option<DepthState>,
    /// By colour attachment; missing ones are not written.
    pub colors: Vec<ColorState>,
    /// What else happens to fragments after the shader.
    pub output: OutputState,
}

/// A pipeline that cannot be.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("pipeline: {0}")]
pub struct PipelineError(pub String);

/// Shaders and state, checked, optimized for each other and compiled. Cloning shares it.
#[derive(Clone, Debug)]
pub struct Pipeline(Arc<Compiled>);

/// What a pipeline holds.
#[derive(Debug)]
pub(crate) struct Compiled {
    pub desc: PipelineDesc,
    /// The vertex program, without the varyings that the fragment program does not read, and with what it left to it.
    pub vertex: Program,
    /// The fragment program, without outputs that nobody takes.
    pub fragment: Program,
    /// The varying slots that the fragment program reads, ascending, and how each is interpolated.
    pub varyings: Vec<(u16, Interpolation)>,
    /// Their slots alone.
    pub slots: Vec<u16>,
    /// How many varying slots the vertex module writes.
    pub written_varyings: usize,
    /// How many varyings hold what the fragment module makes of others.
    pub left: usize,
    /// See [`Pipeline::of_sprites`].
    of_sprites: OnceLock<Pipeline>,
}

impl Pipeline {
    /// The locations of the attributes that the vertex program reads; bindings of others do nothing.
    pub fn attributes(&self) -> impl Iterator<Item = u8> {
        self.0.vertex.inputs().iter().filter_map(|input| match *input {
            Input::Attribute { location, .. } => Some(location),
            Input::VertexId
            | Input::InstanceId
            | Input::Varying(_)
            | Input::Slope { .. }
            | Input::FragCoord(_)
            | Input::FrontFacing
            | Input::PointCoord(_)
            | Input::Coverage => None,
        })
    }

    /// Checks and compiles.
    ///
    /// # Errors
    /// When the stages are not of their kind.
    pub fn new(desc: PipelineDesc) -> Result<Self, PipelineError> {
        let (vertex, fragment) = (desc.vertex.module(), desc.fragment.module());
        if vertex.stage != Stage::Vertex {
            return Err(PipelineError("`vertex` must be a module of the vertex stage".into()));
        }
        if fragment.stage != Stage::Fragment {
            return Err(PipelineError("`fragment` must be a module of the fragment stage".into()));
        }
        Ok(Self(Arc::new(Compiled::new(desc, Sharing::Fair))))
    }

    /// The pipeline where sprites replace varyings, which are not there at the vertices: what fragments make of them
    /// stays with the fragments.
    pub(crate) fn of_sprites(&self) -> Self {
        if self.0.left == 0 {
            return self.clone();
        }
        let of_sprites = self
            .0
            .of_sprites
            .get_or_init(|| Self(Arc::new(Compiled::new(self.0.desc.clone(), Sharing::AsWritten))));
        of_sprites.clone()
    }

    /// Whether it is the same one, not an equal one.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }

    /// What it was made of.
    pub fn desc(&self) -> &PipelineDesc {
        &self.0.desc
    }

    pub(crate) fn compiled(&self) -> &Compiled {
        &self.0
    }
}

/// Who computes what fragments make of varyings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sharing {
    /// The vertex stage, where that is as good.
    Fair,
    /// The fragment stage.
    AsWritten,
}

impl Compiled {
    /// Compiles modules that are of their stages.
    fn new(desc: PipelineDesc, sharing: Sharing) -> Self {
        let is_deep = |stage: &ShaderModule| stage.module().nests_deeper_than(SHALLOW);
        if is_deep(&desc.vertex) || is_deep(&desc.fragment) {
            with_room(|| Self::on_this_stack(desc, sharing))
        } else {
            Self::on_this_stack(desc, sharing)
        }
    }

    fn on_this_stack(desc: PipelineDesc, sharing: Sharing) -> Self {
        let mut fragment = Draft::new(desc.fragment.module(), |output| match output {
            Output::Color { target, component } => desc
                .colors
                .get(usize::from(target))
                .is_some_and(|color| color.needs(usize::from(component))),
            Output::Depth => desc.depth.is_some(),
            Output::StencilReference => desc.output.stencil.is_some(),
            Output::Position(_)
            | Output::PointSize
            | Output::ClipDistance(_)
            | Output::Varying(_) => false,
        });
        let vertex = desc.vertex.module();
        let with_more = match sharing {
            Sharing::Fair => fragment.leave_to(vertex),
            Sharing::AsWritten => None,
        };
        let left = with_more.as_ref().map_or(0, |more| more.outputs.len() - vertex.outputs.len());
        let modes = fragment.module.varyings.clone();
        let fragment = fragment.finish();
        let mut varyings: Vec<(u16, Interpolation)> = fragment
            .inputs()
            .iter()
            .filter_map(|input| match *input {
                Input::Varying(slot) | Input::Slope { slot, .. } => {
                    let mode = modes.get(usize::from(slot)).copied();
                    Some((slot, mode.unwrap_or(Interpolation::Smooth)))
                }
                Input::Attribute { .. }
                | Input::VertexId
                | Input::InstanceId
                | Input::FragCoord(_)
                | Input::FrontFacing
                | Input::PointCoord(_)
                | Input::Coverage => None,
            })
            .collect();
        varyings.sort_unstable_by_key(|&(slot, _)| slot);
        varyings.dedup();
        let written_varyings =
            vertex.outputs.iter().filter(|(o, _)| matches!(o, Output::Varying(_))).count();
        let vertex = with_more.as_ref().unwrap_or(vertex);
        let vertex = Program::new(vertex, |output| match output {
            Output::Position(_) => true,
            // Any topology can end as points, and what is written to clip distances cuts.
            Output::PointSize | Output::ClipDistance(_) => true,
            Output::Varying(slot) => varyings.iter().any(|&(read, _)| read == slot),
            Output::Color { .. } | Output::Depth | Output::StencilReference => false,
        });
        let of_sprites = OnceLock::new();
        let slots = varyings.iter().map(|&(slot, _)| slot).collect();
        Self { desc, vertex, fragment, varyings, slots, written_varyings, left, of_sprites }
    }
}
