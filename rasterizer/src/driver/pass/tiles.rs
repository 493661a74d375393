//! Binning, and running the tiles of a pass.

use super::{LayerSurfaces, Pass};
use crate::attachment::{DepthFormat, Surface};
use crate::driver::chunk::TileBin;
use crate::driver::image::Attachment;
use crate::driver::report::{FrameSpending, SubmitReport};
use crate::plan::Shading;
use crate::primitive::Shape;
use crate::raster::{
    Chunk, ClearJob, FIRST_WAVE, Formats, TileCommand, TileJob, WAVE, WatchedPixel,
};
use crate::sizes::TILE;
use texunit::lanes::LANES;

/// Work of tiles, in additions of 64 lanes, that is not shared with another thread: waking one, and its waiting for more
/// work, takes about as much processor time.
const WORTH_A_THREAD: u64 = 1 << 16;

/// About how many additions of 64 lanes a shape takes besides its pixels.
const SHAPE_COST: u64 = 16;

/// About how many additions of 64 lanes coverage, tests and output of 64 pixels take, for each sample.
const BATCH_COST: u64 = 32;

/// The surfaces of colours, and that of depths.
type Surfaces<'a> = (&'a mut Vec<Option<Surface>>, &'a mut Option<Surface>);

/// The surfaces of a layer; `None` of one that has nothing to do.
fn surfaces_of<'a>(
    layer: usize,
    first: Surfaces<'a>,
    more_layers: &'a mut [Option<LayerSurfaces>],
) -> Option<Surfaces<'a>> {
    let Some(behind) = layer.checked_sub(1) else { return Some(first) };
    let LayerSurfaces { colors, depth } = more_layers[behind].as_mut()?;
    Some((colors, depth))
}

impl Pass<'_> {
    /// Appends a command to the bins of the tiles of every layer from pixel `low` to pixel `high`, both inside the pass.
    pub(super) fn bin(&mut self, low: [i32; 2], high: [i32; 2], command: TileCommand) {
        if low[0] > high[0] || low[1] > high[1] {
            return;
        }
        let tiles = self.tiles_per_layer();
        for bins in self.bins.chunks_mut(tiles) {
            for ty in low[1] / TILE as i32..=high[1] / TILE as i32 {
                for tx in low[0] / TILE as i32..=high[0] / TILE as i32 {
                    bins[ty as usize * self.across as usize + tx as usize].push(command);
                }
            }
        }
    }

    /// How many tiles a layer has.
    fn tiles_per_layer(&self) -> usize {
        (self.bins.len() / usize::from(self.desc.layers.max(1))).max(1)
    }

    /// Attaches the layers behind the first that have something to do.
    fn attach_layers(&mut self) {
        let tiles = self.tiles_per_layer();
        for (layer, surfaces) in self.more_layers.iter_mut().enumerate() {
            let bins = &self.bins[(layer + 1) * tiles..][..tiles];
            if surfaces.is_some() || bins.iter().all(Vec::is_empty) {
                continue;
            }
            // One that another context has specified anew meanwhile is left out.
            let attach = |(attachment, first): (&Option<Attachment>, &Option<Surface>)| {
                let (a, first) = (attachment.as_ref()?, first.as_ref()?);
                let layer = a.image.attach(&a.layer(layer as u16 + 1)?, self.thread_pool);
                layer.filter(|layer| layer.is_like(first))
            };
            let colors = self.desc.colors.iter().zip(&self.colors).map(attach).collect();
            let depth = attach((&self.desc.depth, &self.depth));
            *surfaces = Some(LayerSurfaces { colors, depth });
        }
    }

    /// Puts chunks into the bins of their tiles; returns whether there are any shapes.
    pub(super) fn bin_chunks(&mut self, chunks: Vec<(Chunk, Vec<TileBin>)>) -> bool {
        let (before, tiles) = (self.shapes, self.tiles_per_layer());
        for (chunk, runs) in chunks {
            // A draw of any number of vertices that are not seen takes no memory.
            if chunk.lists.shapes.is_empty() {
                self.resources.give_back(chunk);
                continue;
            }
            self.batches = self.batches.saturating_add(chunk.batches);
            let index = self.job.chunks.len() as u32;
            for TileBin { layer, tile: [x, y], first, end } in runs {
                let bin = &mut self.bins[layer as usize * tiles + (y * self.across + x) as usize];
                bin.push(TileCommand::Shapes { chunk: index, first, end });
            }
            self.shapes += chunk.lists.shapes.len();
            self.job.chunks.push(chunk);
        }
        self.shapes > before
    }

    /// Puts small draws into bins.
    pub(super) fn bin_merged(&mut self) {
        if let Some(all) = self.merged.take() {
            let line = &self.job.draws[all.draw].plan.raster.line;
            self.bin_chunks(vec![all.finish(self.desc.layers.into(), line)]);
        }
    }

    /// Whether the tiles are not worth another thread: whole clears, and shapes of few pixels.
    fn is_small_work(&self) -> bool {
        let Self { job, shapes, .. } = self;
        let writes_all = |clear: &ClearJob| clear.writes_all(job.width, job.height);
        let cost = |chunk: &Chunk| {
            let plan = &job.draws[chunk.draw].plan;
            let program = match plan.shading {
                Shading::On => plan.pipeline.compiled().fragment.cost(&plan.textures),
                Shading::Off => 0,
            };
            let pixels: u64 = chunk.lists.shapes.iter().map(Shape::pixels).sum();
            let batch = BATCH_COST * plan.samples.count as u64 + program;
            pixels.div_ceil(LANES as u64).saturating_mul(batch)
        };
        let of_shapes = SHAPE_COST * *shapes as u64;
        of_shapes <= WORTH_A_THREAD
            && job.clears.iter().all(writes_all)
            && job.chunks.iter().map(cost).fold(of_shapes, u64::saturating_add) <= WORTH_A_THREAD
    }

    /// Whether the fragment program of a draw in the bins has loops.
    fn has_loops(&self) -> bool {
        let mut draws = self.job.chunks.iter().map(|chunk| &self.job.draws[chunk.draw]);
        draws.any(|draw| draw.plan.pipeline.compiled().fragment.has_loops())
    }

    /// Divides the budget of each draw among those tiles of a wave that it touches.
    fn divide_budgets(&mut self, wave: &[TileJob], spent: FrameSpending) {
        // By draw: how many tiles, and the last of them.
        let mut touched = vec![(0, usize::MAX); self.job.draws.len()];
        for (at, tile) in wave.iter().enumerate() {
            for command in &tile.commands {
                let TileCommand::Shapes { chunk, .. } = *command else { continue };
                let (count, last) = &mut touched[self.job.chunks[chunk as usize].draw];
                if *last != at {
                    (*count, *last) = (*count + 1, at);
                }
            }
        }
        for (draw, (tiles, _)) in self.job.draws.iter_mut().zip(touched) {
            draw.budget.share_frame(spent.operations);
            draw.budget.divide(tiles);
        }
    }

    /// Runs tiles in parallel, at least so many by one thread.
    fn run_wave(&self, tiles: &mut [TileJob], least: usize) {
        let (job, tile_renderers) = (&self.job, &self.resources.tile_renderers);
        self.thread_pool.for_each_chunk(
            tiles,
            least,
            || tile_renderers.borrow(),
            |renderer, tiles| tiles.iter_mut().for_each(|tile| renderer.get().run(job, tile)),
        );
    }

    /// Runs every tile that has something to do, and empties the bins.
    pub(super) fn run_tiles(&mut self, report: &mut SubmitReport) {
        self.bin_merged();
        let formats = Formats {
            colors: self.formats.clone(),
            depth: self.depth_format().and_then(DepthFormat::of),
        };
        self.attach_layers();
        let tiles_per_layer = self.tiles_per_layer();
        let mut tiles = Vec::new();
        let mut positions = Vec::new();
        for (index, bin) in self.bins.iter_mut().enumerate() {
            if bin.is_empty() {
                continue;
            }
            let (layer, tile) = (index / tiles_per_layer, (index % tiles_per_layer) as u32);
            let (tx, ty) = (tile % self.across, tile / self.across);
            let first = (&mut self.colors, &mut self.depth);
            let Some((colors, depth)) = surfaces_of(layer, first, &mut self.more_layers) else {
                continue;
            };
            let take = |surface: &mut Surface| {
                let at = (ty * surface.tiles_across() + tx) as usize;
                surface.take(at)
            };
            tiles.push(TileJob {
                x: (tx * TILE) as i32,
                y: (ty * TILE) as i32,
                colors: colors.iter_mut().map(|color| color.as_mut().map(take)).collect(),
                depth: depth.as_mut().map(take),
                watched: self
                    .job
                    .watch
                    .as_ref()
                    .filter(|_| layer == 0)
                    .and_then(|watch| WatchedPixel::new(watch, [tx, ty], &formats)),
                commands: std::mem::take(bin),
                charges: Vec::new(),
            });
            positions.push((layer, tx, ty));
        }
        let least = if self.is_small_work() { tiles.len().max(1) } else { 1 };
        match self.has_loops() {
            false => self.run_wave(&mut tiles, least),
            true => {
                let count = FIRST_WAVE.min(tiles.len());
                let (first, rest) = tiles.split_at_mut(count);
                for wave in std::iter::once(first).chain(rest.chunks_mut(WAVE)) {
                    self.divide_budgets(wave, report.spent);
                    self.run_wave(wave, least);
                    for charge in wave.iter_mut().flat_map(|tile| tile.charges.drain(..)) {
                        self.job.draws[charge.draw].budget.deduct(&charge);
                    }
                    let stopped = self.job.draws.iter().filter(|draw| draw.budget.is_stopped);
                    stopped.for_each(|draw| report.spent.exhaust(draw.budget.frame()));
                }
            }
        }
        for (tile, (layer, tx, ty)) in tiles.into_iter().zip(positions) {
            let first = (&mut self.colors, &mut self.depth);
            let Some((colors, depth)) = surfaces_of(layer, first, &mut self.more_layers) else {
                continue;
            };
            let surfaces = colors.iter_mut().chain([depth]);
            for (surface, target) in surfaces.zip(tile.colors.into_iter().chain([tile.depth])) {
                if let (Some(surface), Some(target)) = (surface, target) {
                    let at = (ty * surface.tiles_across() + tx) as usize;
                    surface.put_back(at, target.planes);
                }
            }
        }
        for (draw, &command) in self.job.draws.iter().zip(&self.commands) {
            if draw.budget.is_stopped && !report.over_budget.contains(&command) {
                report.over_budget.push(command);
            }
        }
        // The draws stay: one of them may still be adding chunks.
        for chunk in self.job.chunks.drain(..) {
            self.resources.give_back(chunk);
        }
        self.job.clears.clear();
        self.shapes = 0;
    }
}
