//! Pipelines: shaders and fixed state, checked and compiled once, immutable ever after.

use super::arrays;
use super::specializations::Specializable;
use crate::desc::{PipelineDesc, PipelineError, ShaderModule, VertexBinding};
use crate::ir::{Input, Interpolation, Output, Stage};
use crate::shader::{
    AttributeSet, Facts, LevelOfDetail, OptimizedModule, Prepared, Program, SideVaryings,
};
use crate::threads::stack::with_large_stack;
use std::sync::{Arc, OnceLock};
use texunit::lanes::FloatEnv;
use texunit::plan::SamplePlan;

/// So many blocks deep, a module is compiled on any stack.
pub(super) const SHALLOW: usize = 16;

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
    /// The varyings whose planes are those of the side that is seen.
    pub sides: Vec<SideVaryings>,
    variant: Variant,
    /// See [`Pipeline::of_sprites`].
    of_sprites: OnceLock<Pipeline>,
    /// See [`Pipeline::of_lines`].
    of_lines: OnceLock<Pipeline>,
    /// See [`Pipeline::of_unit_scale_factor`].
    of_unit_scale_factor: OnceLock<Pipeline>,
    /// See [`Pipeline::of_separate_sides`].
    of_separate_sides: OnceLock<Pipeline>,
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
        let mut variant = Variant {
            hoisting: VaryingHoisting::On,
            lod: LevelOfDetail::Polygons,
            sides: SideSelection::ByPlanes,
        };
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
            variant.hoisting = VaryingHoisting::Off;
        }
        let compiled = Compiled::new(desc, variant);
        Ok(Self(Arc::new(compiled)))
    }

    /// The pipeline where sprites replace varyings, which are not there at the vertices: what fragments make of them
    /// stays with the fragments.
    pub(crate) fn of_sprites(&self) -> Self {
        if self.0.hoisted == 0 && self.0.sides.is_empty() {
            return self.clone();
        }
        let (hoisting, sides) = (VaryingHoisting::Off, SideSelection::ByFragments);
        self.variant(&self.0.of_sprites, Variant { hoisting, sides, ..self.0.variant })
    }

    /// The pipeline where lookups of lines have the level of detail of lines.
    pub(crate) fn of_lines(&self) -> Self {
        self.of_lod(&self.0.of_lines, LevelOfDetail::Lines)
    }

    /// The pipeline where lookups have the level of detail of points, pixel rectangles and bitmaps.
    pub(crate) fn of_unit_scale_factor(&self) -> Self {
        self.of_lod(&self.0.of_unit_scale_factor, LevelOfDetail::UnitScaleFactor)
    }

    fn of_lod(&self, compiled: &OnceLock<Self>, lod: LevelOfDetail) -> Self {
        if !self.0.desc.fragment.module().has_implicit_lod() {
            return self.clone();
        }
        self.variant(compiled, Variant { lod, ..self.0.variant })
    }

    /// The pipeline for a draw with these vertices: where one of two varyings that are selected by facing is equal at
    /// all of them and the other is not, both have planes of their own.
    pub(crate) fn of_arrays(&self, vertices: &[VertexBinding]) -> Self {
        if self.0.sides.is_empty() {
            return self.clone();
        }
        let arrays = arrays(vertices);
        let is_constant = |slot| self.0.is_constant(slot, arrays);
        let are_alike = |sides: &SideVaryings| is_constant(sides.front) == is_constant(sides.back);
        if self.0.sides.iter().all(are_alike) {
            return self.clone();
        }
        let sides = SideSelection::ByFragments;
        self.variant(&self.0.of_separate_sides, Variant { sides, ..self.0.variant })
    }

    fn variant(&self, compiled: &OnceLock<Self>, variant: Variant) -> Self {
        let compile = || Self(Arc::new(Compiled::new(self.0.desc.clone(), variant)));
        compiled.get_or_init(compile).clone()
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

/// How the programs of a pipeline are compiled.
#[derive(Clone, Copy, Debug)]
struct Variant {
    hoisting: VaryingHoisting,
    lod: LevelOfDetail,
    sides: SideSelection,
}

/// Who selects between two varyings by the facing of a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SideSelection {
    /// The planes of each polygon: the varying of the other side is not interpolated.
    ByPlanes,
    /// The fragment stage.
    ByFragments,
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
    /// Whether a varying is equal at all vertices of a draw with these arrays.
    pub fn is_constant(&self, slot: u16, arrays: AttributeSet) -> bool {
        self.geometry.is_none() && self.vertex.is_constant(slot, arrays)
    }

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
            sides: self.sides.clone(),
            variant: self.variant,
            of_sprites: OnceLock::new(),
            of_lines: OnceLock::new(),
            of_unit_scale_factor: OnceLock::new(),
            of_separate_sides: OnceLock::new(),
            specializable: None,
            facts,
        }
    }

    /// Compiles modules that are of their stages.
    fn new(desc: PipelineDesc, variant: Variant) -> Self {
        let is_deep = |stage: &ShaderModule| stage.module().nests_deeper_than(SHALLOW);
        let geometry_is_deep = desc.geometry.as_ref().is_some_and(is_deep);
        if is_deep(&desc.vertex) || is_deep(&desc.fragment) || geometry_is_deep {
            with_large_stack(|| Self::on_this_stack(desc, variant))
        } else {
            Self::on_this_stack(desc, variant)
        }
    }

    fn on_this_stack(desc: PipelineDesc, variant: Variant) -> Self {
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
        let extended_vertex = match variant.hoisting {
            VaryingHoisting::On => fragment.hoist_to_vertex(vertex),
            VaryingHoisting::Off => None,
        };
        let hoisted =
            extended_vertex.as_ref().map_or(0, |more| more.outputs.len() - vertex.outputs.len());
        let modes = fragment.module.varyings.clone();
        fragment.finish(variant.lod);
        let sides = match variant.sides {
            SideSelection::ByPlanes if desc.geometry.is_none() => fragment.merge_sides(),
            SideSelection::ByPlanes | SideSelection::ByFragments => Vec::new(),
        };
        let (fragment, finished) = fragment.lower();
        let specializable = Specializable::new(&fragment, finished);
        let mut slots: Vec<u16> = fragment
            .inputs()
            .iter()
            .filter_map(|input| match *input {
                Input::Varying(slot) | Input::Gradient { slot, .. } => Some(slot),
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
        slots.extend(sides.iter().map(|sides| sides.back));
        slots.sort_unstable();
        slots.dedup();
        let mode = |&slot: &u16| {
            let mode = modes.get(usize::from(slot)).copied();
            (slot, mode.unwrap_or(Interpolation::Smooth))
        };
        let varyings: Vec<(u16, Interpolation)> = slots.iter().map(mode).collect();
        let written_varyings =
            vertex.outputs.iter().filter(|(o, _)| matches!(o, Output::Varying(_))).count();
        let vertex = extended_vertex.as_ref().unwrap_or(vertex);
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
            sides,
            variant,
            of_sprites: OnceLock::new(),
            of_lines: OnceLock::new(),
            of_unit_scale_factor: OnceLock::new(),
            of_separate_sides: OnceLock::new(),
            specializable,
            facts: Facts::NONE,
        }
    }
}
