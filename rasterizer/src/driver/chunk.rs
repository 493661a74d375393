//! Chunks of a draw: runs of primitives whose vertices are shaded, whose shapes are set up and
//! sorted by tiles, in parallel; what comes out is in the order of the primitives.

mod binning;
mod emitted;
mod viewports;

pub use binning::TileBin;
use binning::{sort_by_layer, sort_by_tile};
pub use emitted::GeometryProgram;

use crate::desc::{LineState, Topology, VertexBinding};
use crate::plan::{Pipeline, Textures};
use crate::primitive::{InvisibleReasons, Setup, Shape, reasons, setup, stipple_lines};
use crate::raster::{Chunk, ShapeLists};
use crate::shader::{Machine, OverBudget, Prepared};
use crate::threads::{ObjectPool, ThreadPool};
use crate::vertex::{
    Geometry, Layers, Placement, Primitive, Primitives, VertexIds, VertexList, VertexStage,
    Viewports, ordinals, shade,
};
use std::ops::Range;
use std::sync::atomic::AtomicU64;
use std::sync::{Arc, OnceLock};
use texunit::lanes::{Isa, LANES};

/// Consecutive primitives of an indexed draw whose shared vertices are shaded once.
pub const SHARED_VERTEX_PRIMITIVES: u32 = 1 << 14;
/// Primitives of a chunk.
const CHUNK: u32 = 1 << 12;

/// What is the same for all chunks of a draw.
pub struct DrawState<'a> {
    /// Its index in the pass.
    pub draw: usize,
    pub isa: Isa,
    pub budget: u64,
    pub thread_pool: &'a ThreadPool,
    pub machines: &'a ObjectPool<Machine>,
    pub geometries: &'a ObjectPool<Geometry>,
    pub lists: &'a ObjectPool<ShapeLists>,
    pub pipeline: &'a Pipeline,
    pub ids: &'a VertexIds<'a>,
    pub primitives: Primitives,
    pub bindings: &'a [VertexBinding],
    /// The vertex program's textures.
    pub textures: &'a Textures,
    /// The vertex program's values of this draw.
    pub prepared: Arc<Prepared>,
    /// The varying slots that the fragment stage reads.
    pub slots: &'a [u16],
    /// The geometry program, if there is one.
    pub geometry: Option<GeometryProgram<'a>>,
    /// How many layers the attachments have.
    pub layers: u32,
    pub setup: Setup<'a>,
    /// That of the viewports from number 1 on, where primitives choose; their draws follow this one.
    pub more_setups: Vec<Setup<'a>>,
    /// What the loops of its vertex and geometry programs have run.
    pub operations: AtomicU64,
    /// How far the line stipple has come, in subpixels.
    pub stipple: u32,
    /// Which instances: several only of [`Self::instances_per_chunk`].
    pub instances: Range<u32>,
    /// Upper bound of the primitives whose reason is recorded when no primitive of the draw is visible.
    pub max_reasons: u32,
    /// Why none of the first `max_reasons` primitives is visible, set if so.
    pub invisible_reasons: OnceLock<InvisibleReasons>,
}

/// Small draws with one plan that are merged into one chunk.
pub struct MergedDraws {
    /// The first of them.
    pub draw: usize,
    geometry: Geometry,
    lists: ShapeLists,
}

impl MergedDraws {
    /// An empty chunk of a draw.
    pub fn new(draw: usize, mut geometry: Geometry, mut lists: ShapeLists) -> Self {
        geometry.clear();
        lists.shapes.clear();
        Self { draw, geometry, lists }
    }

    /// How many shapes there are.
    pub fn len(&self) -> usize {
        self.lists.shapes.len()
    }

    /// Whether it has the size of a chunk.
    pub fn is_full(&self) -> bool {
        self.len() >= CHUNK as usize || self.geometry.len() >= 4 * CHUNK as usize
    }

    /// The chunk; `line` is the state of the draws.
    pub fn finish(self, layers: u32, line: &LineState) -> (Chunk, Vec<TileBin>) {
        chunk_of(self.draw, Arc::new(self.geometry), self.lists, (layers, line))
    }
}

/// A chunk of these shapes.
fn chunk_of(
    draw: usize,
    geometry: Arc<Geometry>,
    mut lists: ShapeLists,
    (layers, line): (u32, &LineState),
) -> (Chunk, Vec<TileBin>) {
    let bins = match geometry.has_layers() {
        false => sort_by_tile(&mut lists),
        true => sort_by_layer(&geometry, &mut lists, layers),
    };
    let batches = lists.shapes.iter().map(|shape| shape.batches(line));
    let batches = batches.fold(0, u64::saturating_add);
    (Chunk { draw, geometry, lists, batches }, bins)
}

impl DrawState<'_> {
    /// The number of instances in one chunk. A strip of lines restarts its stipple and has a chunk of its own.
    pub fn instances_per_chunk(&self) -> u32 {
        if self.is_strip() { 1 } else { (self.chunk_len() / self.primitives.len.max(1)).max(1) }
    }

    /// Primitives of a chunk.
    fn chunk_len(&self) -> u32 {
        self.geometry.as_ref().map_or(CHUNK, GeometryProgram::chunk_len)
    }

    /// The most primitives that [`Self::chunks`] takes.
    pub fn run_len(&self) -> u32 {
        match self.geometry {
            None => SHARED_VERTEX_PRIMITIVES,
            Some(_) => SHARED_VERTEX_PRIMITIVES.min(16 * self.chunk_len()),
        }
    }

    /// The operations of a batch of vertices and what its geometry program makes of them, each loop run once.
    pub fn batch_cost(&self) -> u64 {
        let geometry = self.geometry.as_ref().map_or(0, |own| own.program.cost(own.textures));
        self.pipeline.compiled().vertex.cost(self.textures) + geometry
    }

    /// The batches of fragments that the pixels are which can be drawn to, in all layers.
    pub fn batches_of_target(&self) -> u64 {
        let [low, high] = self.setup.drawable_area;
        let [across, down] = [0, 1]
            .map(|axis| u64::from(high[axis].saturating_sub(low[axis]).max(0).cast_unsigned()));
        (across * down).div_ceil(LANES as u64).saturating_mul(self.layers.max(1).into())
    }

    /// The most primitives that become shapes.
    pub fn drawn_len(&self) -> usize {
        let most = self.geometry.as_ref().map_or(1, GeometryProgram::amplification);
        (self.primitives.len as usize * self.instances.len()).saturating_mul(most)
    }

    /// Whether all lines of the draw are one, of which the stipple begins once: those around a polygon are, too.
    fn is_strip(&self) -> bool {
        match self.pipeline.desc().drawn() {
            Topology::LineStrip | Topology::LineLoop | Topology::LineStripAdjacency => true,
            Topology::Polygon => self.setup.raster.line.stipple.is_some(),
            Topology::Points
            | Topology::Lines
            | Topology::LinesAdjacency
            | Topology::Triangles
            | Topology::TrianglesAdjacency
            | Topology::TriangleStripAdjacency
            | Topology::TriangleStrip
            | Topology::TriangleFan
            | Topology::Quads
            | Topology::QuadStrip => false,
        }
    }

    /// Shades, sets up and sorts the primitives of `range`, at most [`Self::run_len`].
    ///
    /// # Errors
    /// When a batch of vertices runs over its budget.
    pub fn chunks(&mut self, range: Range<u32>) -> Result<Vec<(Chunk, Vec<TileBin>)>, OverBudget> {
        if !self.more_setups.is_empty() {
            return self.chunks_by_viewport(range);
        }
        if let Some(program) = &self.geometry {
            return self.emitted_chunks(program, range);
        }
        // Indices may share vertices all over the run; consecutive ones belong to their primitives,
        // but for the few that strips and fans share.
        let vertices = |range: &Range<u32>| {
            let mut geometry = self.geometries.take();
            let vertex_list = self.vertices(range, &mut geometry, 0)?;
            Ok((Arc::new(geometry), vertex_list))
        };
        let shared = match self.ids {
            VertexIds::Indexed(_) => Some(vertices(&range)?),
            VertexIds::Range(_) => None,
        };
        let shapes_of = |start: u32| -> Result<(Arc<Geometry>, ShapeLists), OverBudget> {
            let chunk_range = start..range.end.min(start + CHUNK);
            let own;
            let (geometry, vertex_list) = match &shared {
                Some(vertices) => vertices,
                None => {
                    own = vertices(&chunk_range)?;
                    &own
                }
            };
            let mut lists = self.lists.take();
            lists.shapes.clear();
            self.shapes(geometry, (&self.primitives, chunk_range), vertex_list, &mut lists);
            Ok((geometry.clone(), lists))
        };
        let is_strip = self.is_strip();
        let (draw, layers, line) = (self.draw, self.layers, &self.setup.raster.line);
        let is_stippled = line.stipple.is_some();
        let chunk = |(geometry, mut lists): (Arc<Geometry>, ShapeLists)| {
            if is_stippled {
                lists.shapes.retain(Shape::has_pixels);
            }
            chunk_of(draw, geometry, lists, (layers, line))
        };
        if range.len() <= CHUNK as usize {
            let mut one = shapes_of(range.start)?;
            if is_strip {
                let line = &self.setup.raster.line;
                self.stipple = stipple_lines(line, &mut one.1.shapes, self.stipple);
            }
            return Ok(vec![chunk(one)]);
        }
        let (thread_pool, starts) = (self.thread_pool, range.clone().step_by(CHUNK as usize));
        if !is_strip {
            return thread_pool
                .map(starts, 1, |start| shapes_of(start).map(chunk))
                .into_iter()
                .collect();
        }
        // A line's stipple begins where that of the line before ends.
        let all = thread_pool.map(starts, 1, shapes_of);
        let mut all = all.into_iter().collect::<Result<Vec<_>, _>>()?;
        for (_, lists) in &mut all {
            let shapes = &mut lists.shapes;
            self.stipple = stipple_lines(&self.setup.raster.line, shapes, self.stipple);
        }
        Ok(all.into_iter().map(chunk).collect())
    }

    /// Appends a draw of at most [`CHUNK`] primitives to a merged chunk.
    ///
    /// # Errors
    /// When a batch of vertices runs over its budget; then nothing of the draw is appended.
    pub fn append_to(&self, all: &mut MergedDraws) -> Result<(), OverBudget> {
        let MergedDraws { geometry, lists, .. } = all;
        let range = 0..self.primitives.len;
        if let Some(program) = &self.geometry {
            let mut input = self.geometries.take();
            let vertex_list = self.vertices(&range, &mut input, 0)?;
            let emitted = self.emit(program, (&input, &vertex_list), range, geometry, lists);
            self.geometries.give(input);
            return emitted;
        }
        let vertex_list = self.vertices(&range, geometry, geometry.len())?;
        self.shapes(geometry, (&self.primitives, range), &vertex_list, lists);
        Ok(())
    }

    /// Shades the vertices of a run of primitives, which begin at this one of a geometry.
    fn vertices(
        &self,
        range: &Range<u32>,
        geometry: &mut Geometry,
        first: usize,
    ) -> Result<VertexList, OverBudget> {
        let ordinals = ordinals(self.pipeline.desc().topology, &self.primitives, range);
        let numbered = match self.geometry {
            None => self.primitive_id(),
            // Its program numbers what it emits.
            Some(_) => [None; 2],
        };
        let mut vertex_list = match numbered {
            [None, None] => VertexList::new(ordinals, self.ids),
            [Some(_), _] | [None, Some(_)] => VertexList::without_sharing(ordinals, self.ids),
        };
        vertex_list.base = first as u32;
        let stage = VertexStage {
            isa: self.isa,
            budget: self.budget,
            operations: &self.operations,
            program: &self.pipeline.compiled().vertex,
            prepared: &self.prepared,
            thread_pool: self.thread_pool,
            machines: self.machines,
            textures: self.textures,
            bindings: self.bindings,
            viewport: self.setup.viewport,
            varyings: &self.pipeline.compiled().vertex_slots,
            point_size: match &self.geometry {
                None => self.setup.raster.point.source,
                Some(program) => program.vertex_point_size(),
            },
            edge_flag: self.setup.raster.polygon.edge_flag,
            place: match self.geometry {
                None => Placement::InWindow,
                Some(_) => Placement::Nowhere,
            },
            layers: self.layers(),
            viewports: self.viewports(),
        };
        shade(&stage, &vertex_list.ids, self.instances.clone(), (geometry, first))?;
        for (part, varying) in [0, 16].into_iter().zip(numbered) {
            let Some(varying) = varying else { continue };
            for (at, instance) in
                range.clone().flat_map(|at| (0..self.instances.len()).map(move |i| (at, i)))
            {
                let before = (instance * vertex_list.ids.len()) as u32;
                let vertex = before + vertex_list.local(provoking(self.primitives.get(at)));
                let bits = self.primitives.number(at) >> part & 0xFFFF;
                geometry.set_varying(vertex, varying, bits as f32);
            }
        }
        Ok(vertex_list)
    }

    fn layers(&self) -> Layers {
        if self.layers > 1 { Layers::Several } else { Layers::One }
    }

    fn viewports(&self) -> Viewports {
        if self.more_setups.is_empty() { Viewports::One } else { Viewports::Several }
    }

    /// Which of the varyings are the halves of the primitive's number, where the fragment stage reads
    /// them.
    fn primitive_id(&self) -> [Option<usize>; 2] {
        let first = self.pipeline.desc().fragment.module().primitive_id;
        let place = |slot| self.slots.iter().position(|&other| other == slot);
        [0, 1].map(|half| first.and_then(|first| place(first.saturating_add(half))))
    }

    /// Puts the shapes of a run of primitives behind others.
    fn shapes(
        &self,
        geometry: &Geometry,
        (primitives, range): (&Primitives, Range<u32>),
        vertex_list: &VertexList,
        lists: &mut ShapeLists,
    ) {
        let before = lists.shapes.len();
        // What a geometry program emits for several instances is one list.
        let instances = if self.geometry.is_some() { 1 } else { self.instances.len() };
        lists.shapes.reserve(range.len() * instances);
        let mut set_up = |vertex_list: &VertexList| {
            let range = (primitives, range.clone());
            setup(&self.setup, geometry, range, vertex_list, &mut lists.shapes);
        };
        set_up(vertex_list);
        (1..instances as u32).for_each(|at| set_up(&vertex_list.of_instance(at)));
        let is_visible = lists.shapes[before..].iter().any(Shape::has_pixels);
        if !is_visible && range.start == 0 && self.max_reasons > 0 {
            let first = (primitives, 0..range.end.min(self.max_reasons));
            self.invisible_reasons
                .get_or_init(|| reasons(&self.setup, geometry, first, vertex_list));
        }
    }
}

/// The ordinal of the vertex that provokes.
fn provoking(primitive: Primitive) -> u32 {
    match primitive {
        Primitive::Point(ordinal) => ordinal,
        Primitive::Line(ordinals, provoking) => ordinals[usize::from(provoking)],
        Primitive::Triangle(ordinals, provoking, _) => ordinals[usize::from(provoking)],
    }
}
