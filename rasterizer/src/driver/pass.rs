//! A pass: the unit of work.
//!
//! Its draws are shaded by vertices and set up as they come, their shapes binned to tiles; when the
//! pass ends (or the bins are full) every tile runs, in parallel, its part of the whole pass.

use super::bound::{Bound, Decided};
use super::chunk::{DrawState, Gathered, RUN, TileRun};
use super::command::{ClearValue, Command};
use super::device::{Device, SubmitReport};
use super::image::PassDesc;
use super::sight::Sight;
use crate::attachment::{DepthFormat, Surface, all_bits, component_bits, texel_words};
use crate::desc::Rect;
use crate::plan::{Counting, DrawPlan, Pipeline, PlanInput, sprite_slots};
use crate::primitive::{Setup, Shape};
use crate::raster::{Chunk, ClearJob, DrawJob, Entry, Formats, PassJob, Spot, TileJob};
use crate::shader::{OverBudget, Prepared};
use crate::sizes::TILE;
use crate::threads::Crew;
use crate::trace::Cleared;
use crate::vertex::{Ids, primitives};
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};
use texunit::format::Format;

/// Shapes in the bins from which on they are drawn before the pass ends. A tile's part of so many is worth a turn of
/// its own, and the next ones have their memory: it is near, and the system does not have to give any more.
const BINS_FULL: usize = 1 << 15;

/// Draws of so many primitives may share a chunk with others of the same plan.
const SMALL: usize = 256;

/// Pixels that short programs draw sooner than another thread is awake.
const LITTLE: u64 = 1 << 14;

/// So many plans are kept for draws that are as others were.
const RECENT: usize = 8;

/// A pass that is being recorded into bins.
pub struct Pass<'a> {
    device: &'a Device,
    crew: &'a Crew,
    desc: &'a PassDesc,
    colors: Vec<Option<Surface>>,
    depth: Option<Surface>,
    across: u32,
    bins: Vec<Vec<Entry>>,
    job: PassJob,
    /// The command of each draw.
    commands: Vec<usize>,
    shapes: usize,
    /// The last draws, if they were small: what follows may be in one chunk with them.
    gathered: Option<Gathered>,
    bound: Bound,
    /// The formats of the colour attachments.
    formats: Vec<Option<Format>>,
    /// The last plans that were made, the newest last: draws go to and fro between a few states.
    recent: Vec<Arc<DrawPlan>>,
}

impl<'a> Pass<'a> {
    /// Opens a pass.
    pub fn begin(device: &'a Device, crew: &'a Crew, desc: &'a PassDesc) -> Self {
        let across = desc.width.div_ceil(TILE);
        let tiles = across as usize * desc.height.div_ceil(TILE) as usize;
        let attached = desc.colors.iter().map(|color| {
            let attachment = color.as_ref()?;
            attachment.image.attach(attachment.face, attachment.level, crew)
        });
        let colors: Vec<Option<Surface>> = attached.collect();
        let format = |surface: &Option<Surface>| surface.as_ref().map(|s| s.format);
        Self {
            device,
            crew,
            desc,
            formats: colors.iter().map(format).collect(),
            recent: Vec::new(),
            colors,
            depth: desc.depth.as_ref().and_then(|a| a.image.attach(a.face, a.level, crew)),
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
                watch: None,
            },
            commands: Vec::new(),
            shapes: 0,
            gathered: None,
            bound: Bound::new(),
        }
    }

    /// Takes one command of the pass.
    pub fn command(&mut self, index: usize, command: &Command, report: &mut SubmitReport) {
        match command {
            Command::BeginPass(_)
            | Command::EndPass
            | Command::BindPipeline(_)
            | Command::BindVertices(_)
            | Command::BindTextures { .. }
            | Command::SetUniforms(_)
            | Command::SetRaster(_)
            | Command::SetViewport(_)
            | Command::SetScissor(_)
            | Command::SetCounter(_) => self.bound.set(command),
            Command::Watch(watch) => {
                self.bound.label = watch.label();
                self.job.watch = Some(watch.clone());
            }
            Command::Clear { value, area } => self.clear(*value, *area),
            Command::Draw { first, count, instances } => {
                self.draw(index, &Ids::Range(*first), *count, instances, report);
            }
            Command::DrawIndexed { indices, count, instances } => {
                self.draw(index, &Ids::Indexed(indices), *count, instances, report);
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

    /// The format of the depth attachment.
    fn depth_format(&self) -> Option<Format> {
        self.depth.as_ref().map(|surface| surface.format)
    }

    /// The pixels of `area` that have their centre in the viewport.
    fn inner_area(&self, mut area: [[i32; 2]; 2]) -> [[i32; 2]; 2] {
        let [first, end] = self.bound.viewport.pixels();
        for axis in 0..2 {
            area[0][axis] = area[0][axis].max(first[axis]);
            area[1][axis] = area[1][axis].min(end[axis]);
        }
        area
    }

    fn clear(&mut self, value: ClearValue, rect: Rect) {
        let (area, label) = (self.area(Some(rect)), self.bound.label);
        let color = |target: u8| self.formats.get(usize::from(target)).copied().flatten();
        let depth = self.depth_format();
        let first = |word: u32| [word, 0, 0, 0];
        let job = match value {
            ClearValue::Color { target, value, mask } => color(target).map(|format| ClearJob {
                target: Cleared::Color(target.into()),
                words: texel_words(format, value),
                write: component_bits(format, mask),
                all: all_bits(format),
                area,
                label,
            }),
            ClearValue::Texel { target, words, mask } => color(target).map(|format| ClearJob {
                target: Cleared::Color(target.into()),
                words,
                write: component_bits(format, mask),
                all: all_bits(format),
                area,
                label,
            }),
            ClearValue::Depth(value) => depth.and_then(DepthFormat::of).map(|format| ClearJob {
                target: Cleared::Depth,
                words: first(format.word(texunit::lanes::math::clamp(value, 0.0, 1.0))),
                write: first(!0),
                all: first(!0),
                area,
                label,
            }),
            ClearValue::Stencil { value, mask } => {
                depth.filter(|format| format.has_stencil()).map(|_| ClearJob {
                    target: Cleared::Stencil,
                    words: first(value.into()),
                    write: first(mask.into()),
                    all: first(0xFF),
                    area,
                    label,
                })
            }
        };
        let Some(job) = job else { return };
        self.take_gathered();
        let index = self.job.clears.len() as u32;
        self.job.clears.push(job);
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
        instances: &Range<u32>,
        report: &mut SubmitReport,
    ) {
        let Some(pipeline) = self.bound.pipeline.clone() else { return };
        let pipeline = match sprite_slots(pipeline.desc(), &self.bound.raster) {
            [] => pipeline,
            _ => pipeline.of_sprites(),
        };
        let area = self.area(self.bound.scissor);
        if area[0][0] >= area[1][0] || area[0][1] >= area[1][1] {
            return;
        }
        let inner = self.inner_area(area);
        let (plan, vertex) = match &self.bound.decided {
            Some(Decided { plan, vertex }) => (plan.clone(), vertex.clone()),
            None => self.decide(&pipeline),
        };
        let raster = plan.raster.clone();
        let draw = self.job.draws.len();
        let (counter, stopped) = (self.bound.counter.clone(), AtomicBool::new(false));
        let label = self.bound.label;
        self.job.draws.push(DrawJob { plan, area: inner, counter, stopped, label });
        self.commands.push(command);

        let compiled = pipeline.compiled();
        let desc = pipeline.desc();
        let resolution =
            self.depth_format().and_then(DepthFormat::of).and_then(DepthFormat::resolution);
        let primitives = primitives(desc.topology, desc.provoking, count);
        let vertices = self.bound.vertices.clone();
        let textures = self.bound.vertex_textures.clone();
        let mut state = DrawState {
            draw,
            isa: self.job.isa,
            budget: self.job.budget,
            crew: self.crew,
            machines: &self.device.machines,
            geometries: &self.device.geometries,
            lists: &self.device.lists,
            pipeline: &pipeline,
            ids,
            primitives,
            bindings: &vertices,
            textures: &textures,
            stipple: 0,
            instances: instances.clone(),
            asked: report.sight.asks(),
            unseen: OnceLock::new(),
            prepared: vertex,
            slots: &compiled.slots,
            setup: Setup {
                isa: self.job.isa,
                viewport: self.bound.viewport,
                cull: desc.cull,
                front_face: desc.front_face,
                raster: &raster,
                edge_flags: primitives.edge_flags(),
                area,
                inner,
                resolution,
            },
        };
        // Edge flags are kept of one draw, and so are lines that only carry a stipple on.
        let is_small = raster.polygon.edge_flag.is_none()
            && raster.line.stipple.is_none()
            && self.job.watch.is_none()
            && (1..=SMALL).contains(&(primitives.len as usize * instances.len()))
            && instances.len() <= state.at_once() as usize;
        let drawn = match is_small {
            true => self.gather(&state),
            false => self.draw_apart(&mut state, report),
        };
        let Ok(is_seen) = drawn else {
            self.job.draws[draw].stopped.store(true, Ordering::Relaxed);
            return;
        };
        if self.shapes >= BINS_FULL {
            self.run_tiles(report);
        }
        report.sight.add(match (is_seen, state.unseen.into_inner()) {
            (true, _) => Sight::Some,
            (false, None) => Sight::Undrawn,
            (false, Some(reasons)) => Sight::None(reasons),
        });
    }

    /// Puts a small draw into one chunk with those before it, where that is the same; says whether it has shapes.
    fn gather(&mut self, state: &DrawState<'_>) -> Result<bool, OverBudget> {
        let draws = &self.job.draws;
        let goes_on =
            |all: &Gathered| !all.is_full() && draws[all.draw].gathers(&draws[state.draw]);
        if !self.gathered.as_ref().is_some_and(goes_on) {
            self.take_gathered();
        }
        let Device { geometries, lists, .. } = self.device;
        let new = || Gathered::new(state.draw, geometries.take(), lists.take());
        let all = self.gathered.get_or_insert_with(new);
        let before = all.len();
        state.gather(all)?;
        Ok(all.len() > before)
    }

    /// Puts a draw into chunks of its own; says whether it has shapes.
    fn draw_apart(
        &mut self,
        state: &mut DrawState<'_>,
        report: &mut SubmitReport,
    ) -> Result<bool, OverBudget> {
        self.take_gathered();
        let mut is_seen = false;
        let (instances, at_once) = (state.instances.clone(), state.at_once());
        for first in instances.clone().step_by(at_once as usize) {
            state.instances = first..instances.end.min(first.saturating_add(at_once));
            state.stipple = 0;
            let mut start = 0;
            while start < state.primitives.len {
                let range = start..state.primitives.len.min(start + RUN);
                start = range.end;
                is_seen |= self.take(state.chunks(range)?);
                if self.shapes >= BINS_FULL {
                    self.run_tiles(report);
                }
            }
        }
        Ok(is_seen)
    }

    /// Decides how to draw with what is bound.
    fn decide(&mut self, pipeline: &Pipeline) -> (Arc<DrawPlan>, Arc<Prepared>) {
        let (isa, depth, bound) = (self.job.isa, self.depth_format(), &mut self.bound);
        let compiled = pipeline.compiled();
        let surface = self.colors.iter().flatten().chain(&self.depth).next();
        let samples = surface.map_or(1, |surface| surface.samples);
        let input = PlanInput {
            isa,
            colors: &self.formats,
            depth,
            samples,
            uniforms: &bound.uniforms,
            textures: bound.fragment_textures.clone(),
            viewport: bound.viewport,
            raster: bound.raster.clone().for_samples(samples),
            counting: match bound.counter {
                Some(_) => Counting::On,
                None => Counting::Off,
            },
            vertices: &bound.vertices,
        };
        // Uniforms, such as matrices, are mostly not the fragments'.
        let fragment = &compiled.fragment;
        let prepared = fragment
            .depends_on_uniforms()
            .then(|| fragment.prepare(isa, &bound.uniforms, &bound.fragment_textures));
        let mut recent = self.recent.iter().rev();
        let plan = match recent.find(|plan| plan.is_of(pipeline, &input, prepared.as_ref())) {
            Some(plan) => plan.clone(),
            None => {
                let plan = Arc::new(DrawPlan::new(pipeline, input));
                if self.recent.len() == RECENT {
                    self.recent.remove(0);
                }
                self.recent.push(plan.clone());
                plan
            }
        };
        self.device.explain(&|| plan.describe());
        let vertex = compiled.vertex.prepare(isa, &bound.uniforms, &bound.vertex_textures);
        let vertex = Arc::new(vertex);
        bound.decided = Some(Decided { plan: plan.clone(), vertex: vertex.clone() });
        (plan, vertex)
    }

    /// Puts chunks into the bins of their tiles; says whether there are any shapes.
    fn take(&mut self, chunks: Vec<(Chunk, Vec<TileRun>)>) -> bool {
        let before = self.shapes;
        for (chunk, runs) in chunks {
            let index = self.job.chunks.len() as u32;
            for TileRun { tile: [x, y], first, end } in runs {
                let bin = &mut self.bins[(y * self.across + x) as usize];
                bin.push(Entry::Shapes { chunk: index, first, end });
            }
            self.shapes += chunk.lists.shapes.len();
            self.job.chunks.push(chunk);
        }
        self.shapes > before
    }

    /// Puts small draws into bins.
    fn take_gathered(&mut self) {
        if let Some(all) = self.gathered.take() {
            self.take(vec![all.finish()]);
        }
    }

    /// Whether all of it is done sooner than another thread is awake: whole clears, and shapes of few pixels.
    fn is_little(&self) -> bool {
        let Self { job, shapes, .. } = self;
        let is_whole = |clear: &ClearJob| clear.is_whole(job.width, job.height);
        let cost = |chunk: &Chunk| {
            let pixels: u64 = chunk.lists.shapes.iter().map(Shape::pixels).sum();
            // What runs by itself is long.
            if job.draws[chunk.draw].plan.together > 1 { pixels } else { 16 * pixels }
        };
        *shapes <= SMALL
            && job.clears.iter().all(is_whole)
            && job.chunks.iter().map(cost).sum::<u64>() <= LITTLE
    }

    /// Runs every tile that has something to do, and empties the bins.
    fn run_tiles(&mut self, report: &mut SubmitReport) {
        self.take_gathered();
        let formats = Formats {
            colors: self.formats.clone(),
            depth: self.depth_format().and_then(DepthFormat::of),
        };
        let mut tiles = Vec::new();
        let mut homes = Vec::new();
        for (index, bin) in self.bins.iter_mut().enumerate() {
            if bin.is_empty() {
                continue;
            }
            let (tx, ty) = (index as u32 % self.across, index as u32 / self.across);
            let take = |surface: &mut Surface| {
                let at = (ty * surface.tiles_across() + tx) as usize;
                surface.take(at)
            };
            tiles.push(TileJob {
                x: (tx * TILE) as i32,
                y: (ty * TILE) as i32,
                colors: self.colors.iter_mut().map(|color| color.as_mut().map(take)).collect(),
                depth: self.depth.as_mut().map(take),
                watched: self
                    .job
                    .watch
                    .as_ref()
                    .and_then(|watch| Spot::new(watch, [tx, ty], &formats)),
                entries: std::mem::take(bin),
            });
            homes.push((tx, ty));
        }
        let (job, workers) = (&self.job, &self.device.workers);
        let least = if self.is_little() { tiles.len().max(1) } else { 1 };
        self.crew.share(
            &mut tiles,
            least,
            || workers.lend(),
            |worker, tiles| tiles.iter_mut().for_each(|tile| worker.get().run(job, tile)),
        );
        for (tile, (tx, ty)) in tiles.into_iter().zip(homes) {
            let surfaces = self.colors.iter_mut().chain([&mut self.depth]);
            for (surface, target) in surfaces.zip(tile.colors.into_iter().chain([tile.depth])) {
                if let (Some(surface), Some(target)) = (surface, target) {
                    let at = (ty * surface.tiles_across() + tx) as usize;
                    surface.tiles[at] = target.planes;
                }
            }
        }
        for (draw, &command) in self.job.draws.iter().zip(&self.commands) {
            if draw.stopped.load(Ordering::Relaxed) && !report.over_budget.contains(&command) {
                report.over_budget.push(command);
            }
        }
        // The draws stay: one of them may still be adding chunks.
        for chunk in self.job.chunks.drain(..) {
            self.device.lists.give(chunk.lists);
            if let Some(geometry) = Arc::into_inner(chunk.geometry) {
                self.device.geometries.give(geometry);
            }
        }
        self.job.clears.clear();
        self.shapes = 0;
    }

    /// Runs what is left and gives the attachments back.
    pub fn end(mut self, report: &mut SubmitReport) {
        self.run_tiles(report);
        let isa = self.device.desc().isa;
        for (attachment, surface) in self.desc.colors.iter().zip(self.colors) {
            if let (Some(a), Some(surface)) = (attachment, surface) {
                a.image.detach(a.face, a.level, surface, isa);
            }
        }
        if let (Some(a), Some(surface)) = (&self.desc.depth, self.depth) {
            a.image.detach(a.face, a.level, surface, isa);
        }
    }
}
