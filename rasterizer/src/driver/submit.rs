//! The queue: checks a command buffer, then runs it pass by pass.
//!
//! A pass is the unit of work. Its draws are shaded by vertices and set up as they come, their
//! shapes binned to tiles; when the pass ends (or the bins are full) every tile runs, in parallel,
//! its part of the whole pass.

use super::buffer::VertexBinding;
use super::command::{ClearValue, Command, IndexType, Indices, Rect, Viewport};
use super::device::{Device, SubmitError, SubmitReport};
use super::image::PassDesc;
use super::pipeline::{Pipeline, Topology};
use crate::output::DepthFormat;
use crate::plan::{DrawPlan, PlanInput, Textures};
use crate::primitive::{Primitives, SUBPIXEL, Setup, primitives, setup};
use crate::raster::{Chunk, ClearJob, DrawJob, Entry, PassJob, TileJob, Worker};
use crate::shader::Prepared;
use crate::target::{Plane, Surface, TILE, stored_components};
use crate::vertex::{VertexStage, shade};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use texunit::format::Format;
use texunit::plan::SamplePlan;

/// Primitives of a draw that are shaded and set up together.
const CHUNK: u32 = 1 << 15;
/// Primitives that are set up by one task.
const TASK: u32 = 1 << 11;
/// Shapes in the bins from which on they are drawn before the pass ends.
const BINS_FULL: usize = 1 << 20;

/// Checks the order and the ranges of commands.
pub fn check(commands: &[Command]) -> Result<(), SubmitError> {
    let mut pass: Option<&PassDesc> = None;
    let mut pipeline = false;
    let mut viewport = false;
    for (index, command) in commands.iter().enumerate() {
        let fail = |rule: &str| Err(SubmitError { index, rule: rule.to_owned() });
        if pass.is_none() && !matches!(command, Command::BeginPass(_)) {
            return fail("only BeginPass may stand outside a pass");
        }
        match command {
            Command::BeginPass(desc) => {
                if pass.is_some() {
                    return fail("BeginPass: the pass before it was not ended");
                }
                if let Err(rule) = check_pass(desc) {
                    return fail(&rule);
                }
                (pass, pipeline, viewport) = (Some(desc), false, false);
            }
            Command::EndPass => pass = None,
            Command::Draw { .. } | Command::DrawIndexed { .. } => {
                if !pipeline {
                    return fail("a draw needs BindPipeline before it in the pass");
                }
                if !viewport {
                    return fail("a draw needs SetViewport before it in the pass");
                }
            }
            Command::BindPipeline(_) => pipeline = true,
            Command::SetViewport(v) => {
                let all = [v.x, v.y, v.width, v.height, v.near, v.far];
                let fits = |v: f32| v.is_finite() && v.abs() <= 32768.0;
                if !all.into_iter().all(fits) || v.width < 0.0 || v.height < 0.0 {
                    return fail(
                        "SetViewport: numbers must be finite, at most 32768, sizes not negative",
                    );
                }
                viewport = true;
            }
            Command::Clear { value, .. } => {
                let nan = match value {
                    ClearValue::Color { .. } => false,
                    ClearValue::Depth(depth) => depth.is_nan(),
                };
                if nan {
                    return fail("Clear: the depth is NaN");
                }
            }
            Command::BindVertices(_)
            | Command::BindTextures { .. }
            | Command::SetUniforms(_)
            | Command::SetScissor(_) => {}
        }
    }
    if pass.is_some() {
        return Err(SubmitError {
            index: commands.len(),
            rule: "the last pass was not ended".into(),
        });
    }
    Ok(())
}

fn check_pass(desc: &PassDesc) -> Result<(), String> {
    let attachments = desc
        .colors
        .iter()
        .flatten()
        .map(|a| (a, "colour"))
        .chain(desc.depth.iter().map(|a| (a, "depth")));
    for (attachment, kind) in attachments {
        let texels = attachment.image.texels();
        let Some(level) = texels.level(attachment.face.into(), attachment.level.into()) else {
            return Err(format!(
                "BeginPass: the {kind} attachment has no level {} of face {}",
                attachment.level, attachment.face
            ));
        };
        if level.width < desc.width || level.height < desc.height {
            return Err(format!(
                "BeginPass: the {kind} attachment is {}×{}, smaller than the pass's {}×{}",
                level.width, level.height, desc.width, desc.height
            ));
        }
        if DepthFormat::of(level.format).is_some() != (kind == "depth") {
            return Err(format!(
                "BeginPass: {:?} is no format of a {kind} attachment",
                level.format
            ));
        }
    }
    Ok(())
}

/// Runs checked commands.
pub fn run(device: &Device, commands: &[Command]) -> SubmitReport {
    let mut report = SubmitReport::default();
    let mut pass = None;
    for (index, command) in commands.iter().enumerate() {
        match command {
            Command::BeginPass(desc) => pass = Some(Pass::begin(device, desc)),
            Command::EndPass => {
                if let Some(pass) = pass.take() {
                    pass.end(&mut report);
                }
            }
            Command::Clear { .. }
            | Command::BindPipeline(_)
            | Command::BindVertices(_)
            | Command::BindTextures { .. }
            | Command::SetUniforms(_)
            | Command::SetViewport(_)
            | Command::SetScissor(_)
            | Command::Draw { .. }
            | Command::DrawIndexed { .. } => {
                if let Some(pass) = pass.as_mut() {
                    pass.command(index, command, &mut report);
                }
            }
        }
    }
    report
}

/// The state that commands set.
struct Bound {
    pipeline: Option<Pipeline>,
    vertices: Arc<[VertexBinding]>,
    vertex_textures: Textures,
    fragment_textures: Textures,
    uniforms: Arc<[u32]>,
    viewport: Viewport,
    scissor: Option<Rect>,
}

/// What the shading of a draw's vertices needs, the same for all its chunks.
struct VertexJob<'a> {
    pipeline: &'a Pipeline,
    prepared: &'a Prepared,
    slots: &'a [u16],
    point_size: f32,
}

/// A pass that is being recorded into bins.
struct Pass<'a> {
    device: &'a Device,
    desc: &'a PassDesc,
    colors: Vec<Option<Surface>>,
    depth: Option<Surface>,
    across: u32,
    bins: Vec<Vec<Entry>>,
    job: PassJob,
    /// The command of each draw.
    commands: Vec<usize>,
    shapes: usize,
    bound: Bound,
}

impl<'a> Pass<'a> {
    fn begin(device: &'a Device, desc: &'a PassDesc) -> Self {
        let across = desc.width.div_ceil(TILE);
        let tiles = across as usize * desc.height.div_ceil(TILE) as usize;
        let none: Arc<[Option<Arc<SamplePlan>>]> = Arc::new([]);
        Self {
            device,
            desc,
            colors: desc
                .colors
                .iter()
                .map(|color| color.as_ref().and_then(|a| a.image.attach(a.face, a.level)))
                .collect(),
            depth: desc.depth.as_ref().and_then(|a| a.image.attach(a.face, a.level)),
            across,
            bins: vec![Vec::new(); tiles],
            job: PassJob {
                isa: device.desc().isa,
                budget: device.desc().budget,
                width: desc.width,
                height: desc.height,
                draws: Vec::new(),
                chunks: Vec::new(),
                clears: Vec::new(),
            },
            commands: Vec::new(),
            shapes: 0,
            bound: Bound {
                pipeline: None,
                vertices: Arc::new([]),
                vertex_textures: none.clone(),
                fragment_textures: none,
                uniforms: Arc::new([]),
                viewport: Viewport { x: 0.0, y: 0.0, width: 0.0, height: 0.0, near: 0.0, far: 1.0 },
                scissor: None,
            },
        }
    }

    fn command(&mut self, index: usize, command: &Command, report: &mut SubmitReport) {
        match command {
            Command::BeginPass(_) | Command::EndPass => {}
            Command::BindPipeline(pipeline) => self.bound.pipeline = Some(pipeline.clone()),
            Command::BindVertices(bindings) => self.bound.vertices = bindings.clone(),
            Command::BindTextures { vertex, fragment } => {
                self.bound.vertex_textures = vertex.clone();
                self.bound.fragment_textures = fragment.clone();
            }
            Command::SetUniforms(words) => self.bound.uniforms = words.clone(),
            Command::SetViewport(viewport) => self.bound.viewport = *viewport,
            Command::SetScissor(scissor) => self.bound.scissor = *scissor,
            Command::Clear { value, area } => self.clear(*value, *area),
            &Command::Draw { first, count, instances } => {
                self.draw(index, &Ids::Range(first), count, instances, report);
            }
            Command::DrawIndexed { indices, count, instances } => {
                self.draw(index, &Ids::Indexed(indices), *count, *instances, report);
            }
        }
    }

    /// First and one past the last pixel that `rect` leaves of the pass, x then y.
    fn area(&self, rect: Option<Rect>) -> [[i32; 2]; 2] {
        let whole = [self.desc.width as i32, self.desc.height as i32];
        let Some(rect) = rect else { return [[0, 0], whole] };
        let far = |start: i32, size: u32, most: i32| {
            (i64::from(start) + i64::from(size)).clamp(0, i64::from(most)) as i32
        };
        [
            [rect.x.max(0), rect.y.max(0)],
            [far(rect.x, rect.width, whole[0]), far(rect.y, rect.height, whole[1])],
        ]
    }

    fn clear(&mut self, value: ClearValue, rect: Rect) {
        let area = self.area(Some(rect));
        let index = self.job.clears.len() as u32;
        self.job.clears.push(ClearJob { value, area });
        self.bin(area[0], [area[1][0] - 1, area[1][1] - 1], Entry::Clear(index));
    }

    /// Puts an entry into the tiles from pixel `low` to pixel `high`, both inside the pass.
    fn bin(&mut self, low: [i32; 2], high: [i32; 2], entry: Entry) {
        if low[0] > high[0] || low[1] > high[1] {
            return;
        }
        for ty in low[1] / TILE as i32..=high[1] / TILE as i32 {
            for tx in low[0] / TILE as i32..=high[0] / TILE as i32 {
                self.bins[ty as usize * self.across as usize + tx as usize].push(entry);
            }
        }
    }

    fn draw(
        &mut self,
        command: usize,
        ids: &Ids<'_>,
        count: u32,
        instances: u32,
        report: &mut SubmitReport,
    ) {
        let area = self.area(self.bound.scissor);
        let Some(pipeline) = self.bound.pipeline.clone() else { return };
        if area[0][0] >= area[1][0] || area[0][1] >= area[1][1] {
            return;
        }
        let isa = self.job.isa;
        let format = |surface: &Option<Surface>| surface.as_ref().map(|s| s.format);
        let formats: Vec<Option<Format>> = self.colors.iter().map(format).collect();
        let plan = DrawPlan::new(
            &pipeline,
            PlanInput {
                isa,
                colors: &formats,
                depth: format(&self.depth),
                uniforms: &self.bound.uniforms,
                textures: self.bound.fragment_textures.clone(),
                viewport: self.bound.viewport,
            },
        );
        self.device.explain(&|| plan.describe());
        let draw = self.job.draws.len();
        self.job.draws.push(DrawJob { plan, area, stopped: AtomicBool::new(false) });
        self.commands.push(command);

        let compiled = pipeline.compiled();
        let prepared =
            compiled.vertex.prepare(isa, &self.bound.uniforms, &self.bound.vertex_textures);
        let slots: Vec<u16> = compiled.varyings.iter().map(|&(slot, _)| slot).collect();
        let desc = pipeline.desc();
        let job = VertexJob {
            pipeline: &pipeline,
            prepared: &prepared,
            slots: &slots,
            point_size: f32::from_bits(desc.point_size_bits),
        };
        let setup = Setup {
            viewport: self.bound.viewport,
            cull: desc.cull,
            front_face: desc.front_face,
            line_width: f32::from_bits(desc.line_width_bits),
            area,
        };
        let all = primitives(desc.topology, desc.provoking, count);
        for instance in 0..instances {
            let mut start = 0;
            while start < all.len {
                let range = start..all.len.min(start + CHUNK);
                start = range.end;
                if !self.chunk(draw, &job, &setup, ids, &all, range, instance) {
                    self.job.draws[draw].stopped.store(true, Ordering::Relaxed);
                    return;
                }
                if self.shapes >= BINS_FULL {
                    self.run_tiles(report);
                }
            }
        }
    }

    /// Shades and sets up a chunk of primitives; false if the vertex program ran over its budget.
    #[allow(clippy::too_many_arguments)]
    fn chunk(
        &mut self,
        draw: usize,
        job: &VertexJob<'_>,
        setup_state: &Setup,
        ids: &Ids<'_>,
        all: &Primitives,
        range: Range<u32>,
        instance: u32,
    ) -> bool {
        let ordinals = ordinals(job.pipeline.desc().topology, all, &range);
        let wanted: Vec<u32> = ordinals.iter().map(|ordinal| ids.get(ordinal)).collect();
        let unique = Unique::of(&wanted, ids);
        let compiled = job.pipeline.compiled();
        let stage = VertexStage {
            isa: self.job.isa,
            budget: self.job.budget,
            program: &compiled.vertex,
            prepared: job.prepared,
            textures: &self.bound.vertex_textures,
            bindings: &self.bound.vertices,
            viewport: setup_state.viewport,
            varyings: job.slots,
            point_size: job.point_size,
        };
        let Ok(geometry) = shade(&stage, &unique.ids, instance) else { return false };
        let local = |ordinal: u32| unique.local(&ordinals, &wanted, ordinal);
        let tasks: Vec<Range<u32>> = range
            .clone()
            .step_by(TASK as usize)
            .map(|start| start..range.end.min(start + TASK))
            .collect();
        let task = |task: Range<u32>| {
            let mut shapes = Vec::with_capacity(task.len());
            setup(setup_state, &geometry, task.map(|i| all.get(i)), local, &mut shapes);
            shapes
        };
        let mut shapes: Vec<_> = if tasks.len() == 1 {
            tasks.into_iter().map(task).collect()
        } else {
            tasks.into_par_iter().map(task).collect()
        };
        let shapes = if shapes.len() == 1 { shapes.remove(0) } else { shapes.concat() };
        let chunk = self.job.chunks.len() as u32;
        for (index, shape) in shapes.iter().enumerate() {
            let (mut low, mut high) = ([0; 2], [0; 2]);
            for axis in 0..2 {
                let c = shape.corners.map(|corner| corner[axis]);
                let [first, last] = [c[0].min(c[1]).min(c[2]), c[0].max(c[1]).max(c[2])]
                    .map(|v| v.div_euclid(SUBPIXEL));
                low[axis] = first.max(setup_state.area[0][axis]);
                high[axis] = last.min(setup_state.area[1][axis] - 1);
            }
            self.bin(low, high, Entry::Shape(chunk, index as u32));
        }
        self.shapes += shapes.len();
        self.job.chunks.push(Chunk { draw, geometry, shapes });
        true
    }

    /// Runs every tile that has something to do, and empties the bins.
    fn run_tiles(&mut self, report: &mut SubmitReport) {
        let mut tiles = Vec::new();
        let mut homes = Vec::new();
        for (index, bin) in self.bins.iter_mut().enumerate() {
            if bin.is_empty() {
                continue;
            }
            let (tx, ty) = (index as u32 % self.across, index as u32 / self.across);
            let take = |surface: &mut Surface| {
                let at = (ty * surface.tiles_across() + tx) as usize;
                std::mem::replace(&mut surface.planes[at], Plane::Cleared(0))
            };
            tiles.push(TileJob {
                x: (tx * TILE) as i32,
                y: (ty * TILE) as i32,
                colors: self
                    .colors
                    .iter_mut()
                    .map(|color| color.as_mut().map(|s| (take(s), stored_components(s.format))))
                    .collect(),
                depth: self
                    .depth
                    .as_mut()
                    .and_then(|s| DepthFormat::of(s.format).map(|format| (take(s), format))),
                entries: std::mem::take(bin),
            });
            homes.push((tx, ty));
        }
        let job = &self.job;
        tiles
            .par_iter_mut()
            .with_max_len(1)
            .for_each_init(Worker::default, |worker, tile| worker.run(job, tile));
        for (tile, (tx, ty)) in tiles.into_iter().zip(homes) {
            let put = |surface: &mut Surface, plane: Plane| {
                let at = (ty * surface.tiles_across() + tx) as usize;
                surface.planes[at] = plane;
            };
            for (surface, plane) in self.colors.iter_mut().zip(tile.colors) {
                if let (Some(surface), Some((plane, _))) = (surface, plane) {
                    put(surface, plane);
                }
            }
            if let (Some(surface), Some((plane, _))) = (&mut self.depth, tile.depth) {
                put(surface, plane);
            }
        }
        for (draw, &command) in self.job.draws.iter().zip(&self.commands) {
            if draw.stopped.load(Ordering::Relaxed) && !report.over_budget.contains(&command) {
                report.over_budget.push(command);
            }
        }
        // The draws stay: one of them may still be adding chunks.
        self.job.chunks.clear();
        self.job.clears.clear();
        self.shapes = 0;
    }

    fn end(mut self, report: &mut SubmitReport) {
        self.run_tiles(report);
        for (attachment, surface) in self.desc.colors.iter().zip(self.colors) {
            if let (Some(a), Some(surface)) = (attachment, surface) {
                a.image.detach(a.face, a.level, surface);
            }
        }
        if let (Some(a), Some(surface)) = (&self.desc.depth, self.depth) {
            a.image.detach(a.face, a.level, surface);
        }
    }
}

/// Where a draw's vertex numbers come from.
enum Ids<'a> {
    Range(u32),
    Indexed(&'a Indices),
}

impl Ids<'_> {
    /// The vertex of an ordinal of the draw.
    fn get(&self, ordinal: u32) -> u32 {
        match self {
            Self::Range(first) => first.wrapping_add(ordinal),
            Self::Indexed(indices) => {
                let (size, ordinal) = (indices.ty.size(), ordinal as usize);
                let at = ordinal.checked_mul(size).and_then(|at| at.checked_add(indices.offset));
                let bytes = at.and_then(|at| indices.buffer.bytes().get(at..at.checked_add(size)?));
                let index = bytes.map_or(0, |bytes| {
                    bytes.iter().rev().fold(0, |word, &byte| word << 8 | u32::from(byte))
                });
                index.wrapping_add_signed(indices.base_vertex)
            }
        }
    }
}

impl IndexType {
    /// Bytes of an index.
    pub fn size(self) -> usize {
        match self {
            Self::U8 => 1,
            Self::U16 => 2,
            Self::U32 => 4,
        }
    }
}

/// The ordinals that a range of primitives uses: a run, and vertex 0 for a fan or a closing line.
struct Ordinals {
    run: Range<u32>,
    zero: bool,
}

impl Ordinals {
    fn iter(&self) -> impl Iterator<Item = u32> {
        self.zero.then_some(0).into_iter().chain(self.run.clone())
    }

    /// Where an ordinal stands in [`Ordinals::iter`].
    fn position(&self, ordinal: u32) -> usize {
        if self.zero && ordinal == 0 {
            0
        } else {
            (ordinal - self.run.start) as usize + usize::from(self.zero)
        }
    }
}

fn ordinals(topology: Topology, all: &Primitives, range: &Range<u32>) -> Ordinals {
    let (start, end) = (range.start, range.end);
    let plain = |run| Ordinals { run, zero: false };
    match topology {
        Topology::Points => plain(start..end),
        Topology::Lines => plain(2 * start..2 * end),
        Topology::LineStrip => plain(start..end + 1),
        Topology::LineLoop if end == all.len => Ordinals { run: start..end, zero: true },
        Topology::LineLoop => plain(start..end + 1),
        Topology::Triangles => plain(3 * start..3 * end),
        Topology::TriangleStrip => plain(start..end + 2),
        Topology::TriangleFan | Topology::Polygon => {
            Ordinals { run: start + 1..end + 2, zero: true }
        }
        Topology::Quads => plain(start / 2 * 4..end.div_ceil(2) * 4),
        Topology::QuadStrip => plain(start / 2 * 2..end.div_ceil(2) * 2 + 2),
    }
}

/// The vertices to be shaded, each once where their numbers are dense.
struct Unique {
    ids: Vec<u32>,
    /// The smallest number, if `ids` is a run from it.
    dense: Option<u32>,
}

impl Unique {
    fn of(wanted: &[u32], ids: &Ids<'_>) -> Self {
        if let Ids::Indexed(_) = ids {
            let low = wanted.iter().copied().min().unwrap_or(0);
            let high = wanted.iter().copied().max().unwrap_or(0);
            if (high - low) as usize <= wanted.len() {
                return Self { ids: (low..=high).collect(), dense: Some(low) };
            }
        }
        Self { ids: wanted.to_vec(), dense: None }
    }

    /// Where in `ids` the vertex of an ordinal is.
    fn local(&self, ordinals: &Ordinals, wanted: &[u32], ordinal: u32) -> u32 {
        let at = ordinals.position(ordinal);
        match self.dense {
            Some(low) => wanted[at] - low,
            None => at as u32,
        }
    }
}
