//! Pipelines: shaders and fixed state, checked and compiled once, immutable ever after.

use crate::desc::{PipelineDesc, PipelineError, ShaderModule};
use crate::ir::{Input, Interpolation, Module, Output, Stage};
use crate::shader::{FactSources, Facts, LevelOfDetail, OptimizedModule, Prepared, Program};
use crate::threads::stack::with_large_stack;
use parking_lot::Mutex;
use std::sync::{Arc, OnceLock};
use texunit::lanes::FloatEnv;
use texunit::plan::SamplePlan;

/// So many blocks deep, a module is compiled on any stack.
const SHALLOW: usize = 16;

/// Shaders and state, checked, optimized for each other and compiled. Cloning shares it.
#[derive(Clone, Debug)]
pub struct Pipeline(Arc<Compiled>);

/// What a pipeline holds.
#[derive(Debug)]
pub(crate) struct Compiled {
    pub desc: PipelineDesc,
    /// The vertex program: without varyings that the fragment program does not read, with what was hoisted from it.
    pub vertex: Arc<Program>,
    /// The geometry program, if there is one, without varyings that the fragment program does not read.
    pub geometry: Option<Arc<Program>>,
    /// The varying slots that the geometry program reads, or else the fragment program: those that vertices bring.
    pub vertex_slots: Vec<u16>,
    /// The fragment program, without outputs that are not used.
    pub fragment: Program,
    /// The varying slots that the fragment program reads, ascending, and how each is interpolated.
    pub varyings: Vec<(u16, Interpolation)>,
    /// Their slots alone.
    pub slots: Vec<u16>,
    /// How many varying slots the vertex module writes.
    pub written_varyings: usize,
    /// How many varyings hold what the fragment module makes of others.
    pub hoisted: usize,
    /// Who computes what fragments make of varyings.
    hoisting: VaryingHoisting,
    /// See [`Pipeline::of_sprites`].
    of_sprites: OnceLock<Pipeline>,
    /// See [`Pipeline::of_lines`].
    of_lines: OnceLock<Pipeline>,
    /// See [`Pipeline::of_unit_scale_factor`].
    of_unit_scale_factor: OnceLock<Pipeline>,
    /// What [`Pipeline::specialized`] compiles; none where the fragment program neither branches on a uniform value nor
    /// computes with one, or is one that was specialized.
    specializable: Option<Specializable>,
    /// What the fragment program was specialized for.
    pub facts: Facts,
}

impl Pipeline {
    /// The locations of the attributes that the vertex program reads; bindings of others do nothing.
    pub fn attributes(&self) -> impl Iterator<Item = u8> {
        self.0.vertex.inputs().iter().filter_map(|input| match *input {
            Input::Attribute { location, .. } => Some(location),
            Input::VertexId
            | Input::InstanceId
            | Input::OfVertex { .. }
            | Input::PrimitiveId
            | Input::Varying(_)
            | Input::Gradient { .. }
            | Input::FragCoord(_)
            | Input::FrontFacing
            | Input::PointCoord(_)
            | Input::Coverage
            | Input::SampleId
            | Input::SamplePosition(_)
            | Input::LineDirection(_) => None,
        })
    }

    /// Checks and compiles.
    ///
    /// # Errors
    /// When the stages are not of their kind.
    pub fn new(desc: PipelineDesc) -> Result<Self, PipelineError> {
        let _float_env = FloatEnv::enter();
        let (vertex, fragment) = (desc.vertex.module(), desc.fragment.module());
        if vertex.stage != Stage::Vertex {
            return Err(PipelineError("`vertex` must be a module of the vertex stage".into()));
        }
        if fragment.stage != Stage::Fragment {
            return Err(PipelineError("`fragment` must be a module of the fragment stage".into()));
        }
        let mut hoisting = VaryingHoisting::On;
        if let Some(geometry) = &desc.geometry {
            let Some(interface) = &geometry.module().geometry else {
                return Err(PipelineError(
                    "`geometry` must be a module of the geometry stage".into(),
                ));
            };
            if desc.topology.geometry_input() != Some(interface.input) {
                return Err(PipelineError(format!(
                    "{:?} are no {:?}, which the geometry module takes",
                    desc.topology, interface.input
                )));
            }
            hoisting = VaryingHoisting::Off;
        }
        let compiled = Compiled::new(desc, hoisting, LevelOfDetail::Polygons);
        Ok(Self(Arc::new(compiled)))
    }

    /// The pipeline where sprites replace varyings, which are not there at the vertices: what fragments make of them
    /// stays with the fragments.
    pub(crate) fn of_sprites(&self) -> Self {
        if self.0.hoisted == 0 {
            return self.clone();
        }
        let of_sprites = self.0.of_sprites.get_or_init(|| {
            let desc = self.0.desc.clone();
            Self(Arc::new(Compiled::new(desc, VaryingHoisting::Off, LevelOfDetail::Polygons)))
        });
        of_sprites.clone()
    }

    /// The pipeline where lookups of lines have the level of detail of lines.
    pub(crate) fn of_lines(&self) -> Self {
        if !self.0.desc.fragment.module().has_implicit_lod() {
            return self.clone();
        }
        let of_lines = self.0.of_lines.get_or_init(|| {
            let (desc, hoisting) = (self.0.desc.clone(), self.0.hoisting);
            Self(Arc::new(Compiled::new(desc, hoisting, LevelOfDetail::Lines)))
        });
        of_lines.clone()
    }

    /// The pipeline where lookups have the level of detail of points, pixel rectangles and bitmaps.
    pub(crate) fn of_unit_scale_factor(&self) -> Self {
        if !self.0.desc.fragment.module().has_implicit_lod() {
            return self.clone();
        }
        let of_unit_scale_factor = self.0.of_unit_scale_factor.get_or_init(|| {
            let (desc, hoisting) = (self.0.desc.clone(), self.0.hoisting);
            Self(Arc::new(Compiled::new(desc, hoisting, LevelOfDetail::UnitScaleFactor)))
        });
        of_unit_scale_factor.clone()
    }

    /// The pipeline whose fragment program leaves out what uniform values and textures of a draw make without effect;
    /// `None` where they leave out nothing, or were not seen before. `prepared` is of this one's fragment program, if that
    /// depends on uniform words.
    pub(crate) fn specialized(
        &self,
        prepared: Option<&Prepared>,
        textures: &[Option<Arc<SamplePlan>>],
    ) -> Option<Self> {
        let specializable = self.0.specializable.as_ref()?;
        let Specializable { module, sources, .. } = specializable;
        let facts = self.0.fragment.facts(sources, prepared, textures);
        if facts.is_empty() {
            return None;
        }
        specializable.find(facts, |facts| {
            let fragment = self.0.fragment.specialized(module, sources, facts)?;
            Some(Self(Arc::new(self.0.with_fragment(fragment, facts.clone()))))
        })
    }

    /// Whether its programs give the number of the viewport that a primitive goes to.
    pub fn chooses_viewports(&self) -> bool {
        let geometry = self.0.geometry.as_ref().map(|program| program.geometry());
        match geometry {
            Some(own) => own.is_some_and(|own| own.outputs.contains(&Output::ViewportIndex)),
            None => self.0.vertex.output(Output::ViewportIndex).is_some(),
        }
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

/// The most programs that a fragment program is specialized to.
const MAX_SPECIALIZATIONS: usize = 8;

/// What fragment programs are specialized from.
#[derive(Debug)]
struct Specializable {
    /// The module that was lowered.
    module: Module,
    sources: FactSources,
    known: Mutex<Vec<Specialization>>,
}

/// The draws with some facts.
#[derive(Debug)]
struct Specialization {
    facts: Facts,
    /// What was compiled for them; `None` for the general program.
    pipeline: Option<Pipeline>,
    state: SpecializationState,
}

/// Whether a program was compiled for facts: at the second draw that has them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SpecializationState {
    SeenOnce,
    Compiled,
}

impl Specializable {
    /// That of a program which was lowered from this module, if any draw may know facts of it.
    fn new(program: &Program, module: Module) -> Option<Self> {
        let sources = program.fact_sources(&module);
        let is_small = !module.nests_deeper_than(SHALLOW);
        let depends = program.depends_on_uniforms() || !program.texture_slots().is_empty();
        (is_small && depends).then(|| Self { module, sources, known: Mutex::default() })
    }

    /// The pipeline for facts, which `compile` makes at the second draw that has them.
    fn find(
        &self,
        facts: Facts,
        compile: impl FnOnce(&Facts) -> Option<Pipeline>,
    ) -> Option<Pipeline> {
        let mut known = self.known.lock();
        let Some(found) = known.iter_mut().find(|known| known.facts == facts) else {
            if known.len() < MAX_SPECIALIZATIONS {
                let state = SpecializationState::SeenOnce;
                known.push(Specialization { facts, pipeline: None, state });
            }
            return None;
        };
        if found.state == SpecializationState::SeenOnce {
            found.state = SpecializationState::Compiled;
            found.pipeline = compile(&found.facts);
        }
        found.pipeline.clone()
    }
}

/// Who computes what fragments make of varyings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum VaryingHoisting {
    /// The vertex stage, where that is as good.
    On,
    /// The fragment stage.
    Off,
}

/// The varying slots of vertices that a geometry program reads, ascending.
fn slots_of_vertices(geometry: &Program) -> Vec<u16> {
    let inputs = geometry.inputs().iter();
    let mut slots: Vec<u16> = inputs
        .filter_map(|input| match input {
            Input::OfVertex { output: Output::Varying(slot), .. } => Some(*slot),
            _ => None,
        })
        .collect();
    slots.sort_unstable();
    slots.dedup();
    slots
}

impl Compiled {
    /// The same with a fragment program that reads no other varyings.
    fn with_fragment(&self, fragment: Program, facts: Facts) -> Self {
        Self {
            desc: self.desc.clone(),
            vertex: Arc::clone(&self.vertex),
            geometry: self.geometry.clone(),
            vertex_slots: self.vertex_slots.clone(),
            fragment,
            varyings: self.varyings.clone(),
            slots: self.slots.clone(),
            written_varyings: self.written_varyings,
            hoisted: self.hoisted,
            hoisting: self.hoisting,
            of_sprites: OnceLock::new(),
            of_lines: OnceLock::new(),
            of_unit_scale_factor: OnceLock::new(),
            specializable: None,
            facts,
        }
    }

    /// Compiles modules that are of their stages.
    fn new(desc: PipelineDesc, hoisting: VaryingHoisting, lod: LevelOfDetail) -> Self {
        let is_deep = |stage: &ShaderModule| stage.module().nests_deeper_than(SHALLOW);
        let geometry_is_deep = desc.geometry.as_ref().is_some_and(is_deep);
        if is_deep(&desc.vertex) || is_deep(&desc.fragment) || geometry_is_deep {
            with_large_stack(|| Self::on_this_stack(desc, hoisting, lod))
        } else {
            Self::on_this_stack(desc, hoisting, lod)
        }
    }

    fn on_this_stack(desc: PipelineDesc, hoisting: VaryingHoisting, lod: LevelOfDetail) -> Self {
        let mut fragment = OptimizedModule::new(desc.fragment.module(), |output| match output {
            Output::Color { target, component } => desc
                .colors
                .get(usize::from(target))
                .is_some_and(|color| color.needs(usize::from(component))),
            Output::SecondColor(component) => {
                desc.colors.first().is_some_and(|color| color.needs_second(usize::from(component)))
            }
            Output::Depth => desc.depth.is_some(),
            Output::StencilReference => desc.output.stencil.is_some(),
            Output::SampleMask => true,
            Output::Position(_)
            | Output::PointSize
            | Output::ClipDistance(_)
            | Output::CullDistance(_)
            | Output::Varying(_)
            | Output::Layer
            | Output::PrimitiveId
            | Output::ViewportIndex => false,
        });
        let vertex = desc.vertex.module();
        let extended_vertex = match hoisting {
            VaryingHoisting::On => fragment.hoist_to_vertex(vertex),
            VaryingHoisting::Off => None,
        };
        let hoisted =
            extended_vertex.as_ref().map_or(0, |more| more.outputs.len() - vertex.outputs.len());
        let modes = fragment.module.varyings.clone();
        let (fragment, finished) = fragment.finish_and_keep(lod);
        let specializable = Specializable::new(&fragment, finished);
        let mut varyings: Vec<(u16, Interpolation)> = fragment
            .inputs()
            .iter()
            .filter_map(|input| match *input {
                Input::Varying(slot) | Input::Gradient { slot, .. } => {
                    let mode = modes.get(usize::from(slot)).copied();
                    Some((slot, mode.unwrap_or(Interpolation::Smooth)))
                }
                Input::Attribute { .. }
                | Input::VertexId
                | Input::InstanceId
                | Input::OfVertex { .. }
                | Input::PrimitiveId
                | Input::FragCoord(_)
                | Input::FrontFacing
                | Input::PointCoord(_)
                | Input::Coverage
                | Input::SampleId
                | Input::SamplePosition(_)
                | Input::LineDirection(_) => None,
            })
            .collect();
        varyings.sort_unstable_by_key(|&(slot, _)| slot);
        varyings.dedup();
        let written_varyings =
            vertex.outputs.iter().filter(|(o, _)| matches!(o, Output::Varying(_))).count();
        let vertex = extended_vertex.as_ref().unwrap_or(vertex);
        let slots: Vec<u16> = varyings.iter().map(|&(slot, _)| slot).collect();
        let reads_number = desc.fragment.module().primitive_id.is_some();
        let geometry = desc.geometry.as_ref().map(|geometry| {
            Arc::new(Program::new(geometry.module(), |output| match output {
                Output::Position(_)
                | Output::PointSize
                | Output::ClipDistance(_)
                | Output::CullDistance(_)
                | Output::Layer
                | Output::ViewportIndex => true,
                Output::Varying(slot) => slots.contains(&slot),
                Output::PrimitiveId => reads_number,
                Output::Color { .. }
                | Output::SecondColor(_)
                | Output::Depth
                | Output::StencilReference
                | Output::SampleMask => false,
            }))
        });
        let vertex_slots = geometry.as_deref().map_or_else(|| slots.clone(), slots_of_vertices);
        let vertex = Program::new(vertex, |output| match output {
            Output::Position(_) => true,
            // Any topology can end as points, and what is written to clip distances cuts.
            Output::PointSize | Output::ClipDistance(_) | Output::CullDistance(_) => true,
            Output::Varying(slot) => vertex_slots.contains(&slot),
            Output::Layer | Output::ViewportIndex => geometry.is_none(),
            Output::Color { .. }
            | Output::SecondColor(_)
            | Output::Depth
            | Output::StencilReference
            | Output::SampleMask
            | Output::PrimitiveId => false,
        });
        let (of_sprites, of_lines, of_unit_scale_factor) =
            (OnceLock::new(), OnceLock::new(), OnceLock::new());
        Self {
            desc,
            vertex: Arc::new(vertex),
            geometry,
            vertex_slots,
            fragment,
            varyings,
            slots,
            written_varyings,
            hoisted,
            hoisting,
            of_sprites,
            of_lines,
            of_unit_scale_factor,
            specializable,
            facts: Facts::NONE,
        }
    }
}
