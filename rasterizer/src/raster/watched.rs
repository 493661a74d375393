//! A watched pixel within its tile: the effects of clears and fragments on it are recorded.

mod fragment;

pub use fragment::{Shaded, Tested};

use super::batch::BlockOf;
use super::clear::ClearJob;
use super::job::{Chunk, PassJob, TileJob};
use crate::attachment::{BatchLayout, BlockDepth, DepthFormat, TileTarget, WordPlane, texel_color};
use crate::plan::{DrawPlan, PlaneSource, SampleMasks, Shading, moved};
use crate::primitive::{Clipping, Shape, ShapeKind};
use crate::sizes::TILE;
use crate::trace::{Clear, Cleared, Fate, Fragment, PixelEvent, Texel, Vertex, Watch, When};
use std::collections::VecDeque;
use texunit::format::Format;
use texunit::lanes::{Isa, LANES, QUADS, lane_x, lane_y};

/// The watched pixel and its events so far.
#[derive(Debug)]
pub struct WatchedPixel {
    watch: Watch,
    /// Which block of the tile it is in, and which lane of the block it is.
    block: usize,
    lane: usize,
    formats: Formats,
    /// `None` where the fragment is being shaded.
    events: Vec<Option<PixelEvent>>,
    /// The fragments that are not shaded yet, in order.
    pending: VecDeque<PendingFragment>,
}

/// The formats of a pass's attachments.
#[derive(Clone, Debug)]
pub struct Formats {
    /// By index.
    pub colors: Vec<Option<Format>>,
    /// Of depth.
    pub depth: Option<DepthFormat>,
}

/// A fragment that is not shaded yet.
#[derive(Debug)]
struct PendingFragment {
    event: usize,
    /// By plane: the values at the vertices, of varyings.
    values: Vec<Vec<f32>>,
}

/// What an attachment holds at the pixel, by sample.
pub type Stored = Vec<Texel>;

impl WatchedPixel {
    /// The watched pixel, if it is in the tile at column and row `at`.
    pub fn new(watch: &Watch, at: [u32; 2], formats: &Formats) -> Option<Box<Self>> {
        let position = watch.pixel();
        if [0, 1].iter().any(|&axis| position[axis] / TILE != at[axis]) {
            return None;
        }
        let [x, y] = position.map(|v| (v % TILE) as usize);
        let lane = (0..LANES).find(|&lane| (lane_x(lane), lane_y(lane)) == (x % 8, y % 8))?;
        Some(Box::new(Self {
            watch: watch.clone(),
            block: y / 8 * 8 + x / 8,
            lane,
            formats: formats.clone(),
            events: Vec::new(),
            pending: VecDeque::new(),
        }))
    }

    /// Whether it is among the lanes of a block.
    pub fn is_in(&self, block: usize, lanes: u64) -> bool {
        self.block == block && lanes >> self.lane & 1 == 1
    }

    /// Its lane in a batch that covers it.
    pub fn lane_of(&self, layout: BatchLayout<'_>, lanes: u64) -> Option<usize> {
        let lane = match layout {
            BatchLayout::Block(block) => (block == self.block).then_some(self.lane)?,
            BatchLayout::Quads(positions, _) => {
                // Its quad may be there more than once, the pixel may not.
                let first = self.lane / QUADS * QUADS;
                let quad = self.block * LANES + self.lane % QUADS;
                let is_covered = |&at: &usize| {
                    usize::from(positions[at]) == quad && lanes >> (first + at) & 1 == 1
                };
                first + (0..QUADS).find(is_covered)?
            }
            BatchLayout::Pixels(at, _) => {
                let index = self.block * LANES + self.lane;
                (0..LANES).find(|&lane| lanes >> lane & 1 == 1 && usize::from(at[lane]) == index)?
            }
        };
        (lanes >> lane & 1 == 1).then_some(lane)
    }

    /// Appends the events to the watch.
    pub fn finish(self) {
        self.watch.append(self.events.into_iter().flatten().collect());
    }

    /// What an attachment holds at the pixel, by sample.
    fn stored(&self, target: Option<&TileTarget>, color: impl Fn([u32; 4]) -> [f32; 4]) -> Stored {
        let Some(target) = target else { return Vec::new() };
        let texel = |planes: &[WordPlane]| {
            let word =
                |at: usize| planes.get(at).map_or(0, |plane| plane.block(self.block)[self.lane]);
            let words = [0, 1, 2, 3].map(word);
            Texel { words, color: color(words) }
        };
        target.planes.chunks(target.planes_per_sample.max(1)).map(texel).collect()
    }

    /// A clear was done.
    fn cleared(&mut self, job: &ClearJob, stored: &Stored) {
        let position = self.watch.pixel().map(|v| v as i32);
        let reaches =
            |axis: usize| (job.area[0][axis]..job.area[1][axis]).contains(&position[axis]);
        if let Some(&after) = stored.first().filter(|_| reaches(0) && reaches(1)) {
            let clear = Clear { label: job.label, target: job.target, after };
            self.events.push(Some(PixelEvent::Clear(clear)));
        }
    }

    /// A shape covers the pixel.
    pub fn covered(&mut self, pass: &PassJob, chunk: &Chunk, shape: &Shape, masks: &SampleMasks) {
        let job = &pass.draws[chunk.draw];
        let before = pass.chunks.iter().take_while(|other| !std::ptr::eq(*other, chunk));
        let before = before.filter(|other| other.draw == chunk.draw);
        let before: usize = before.map(|other| other.lists.shapes.len()).sum();
        let at = chunk.lists.shapes.iter().position(|other| std::ptr::eq(other, shape));
        let corners = match (shape.kind, shape.clipping) {
            (ShapeKind::Triangle, _)
            | (ShapeKind::Line { .. } | ShapeKind::Point { .. }, Clipping::Cut) => 3,
            (ShapeKind::Line { .. }, Clipping::Whole) => 2,
            (ShapeKind::Point { .. }, Clipping::Whole) => 1,
        };
        let ids = &shape.vertices[..corners];
        let vertex = |&id: &u32| {
            let window = chunk.geometry.window(&job.plan.viewport, id);
            Vertex { clip: chunk.geometry.clip(id), window }
        };
        let values = |source: &PlaneSource| match *source {
            PlaneSource::Smooth(at)
            | PlaneSource::NoPerspective(at)
            | PlaneSource::Sprite(at, _) => {
                ids.iter().map(|&id| chunk.geometry.varyings_of(id)[at]).collect()
            }
            PlaneSource::SmoothOfSides(sides) => {
                let at = sides[shape.facing as usize];
                ids.iter().map(|&id| chunk.geometry.varyings_of(id)[at]).collect()
            }
            PlaneSource::Depth
            | PlaneSource::Denominator
            | PlaneSource::InverseW
            | PlaneSource::Flat(_)
            | PlaneSource::FlatOfSides(_)
            | PlaneSource::LineDirection(_)
            | PlaneSource::PointCoord(_) => Vec::new(),
        };
        let covered = (0..)
            .zip(masks.iter())
            .fold(0, |bits, (sample, mask)| bits | u8::from(mask >> self.lane & 1 == 1) << sample);
        self.pending.push_back(PendingFragment {
            event: self.events.len(),
            values: job.plan.planes.iter().map(values).collect(),
        });
        self.events.push(Some(PixelEvent::Fragment(Box::new(Fragment {
            label: job.label,
            shape: before + at.unwrap_or(0),
            vertices: ids.iter().map(vertex).collect(),
            facing: shape.facing,
            samples: (covered, job.plan.samples.count),
            inputs: Vec::new(),
            steps: Vec::new(),
            more_steps: 0,
            outputs: Vec::new(),
            tests: Vec::new(),
            fate: Fate::NoColor,
            writes: Vec::new(),
        }))));
    }

    /// Records the early tests; `masks` are the samples that passed.
    fn tested_early(&mut self, plan: &DrawPlan, of: &Tested<'_>, masks: &SampleMasks) {
        let left: u64 = masks.any();
        let Some(pending) = self.pending.back() else { return };
        let event = self.events.get_mut(pending.event);
        let Some(Some(PixelEvent::Fragment(fragment))) = event else { return };
        fragment.tests.extend(of.tests(plan, fragment.facing, masks, self.lane));
        if left >> self.lane & 1 == 0 {
            fragment.fate = Fate::TestFailed;
            self.pending.pop_back();
        }
    }

    /// The fragment that is shaded now, if the batch covers the pixel.
    pub fn begin(&mut self, layout: BatchLayout<'_>, lanes: u64) -> Option<Shaded> {
        let lane = self.lane_of(layout, lanes)?;
        let PendingFragment { event, values } = self.pending.pop_front()?;
        match self.events.get_mut(event)?.take()? {
            PixelEvent::Fragment(fragment) => Some(Shaded { event, lane, fragment, values }),
            clear @ PixelEvent::Clear(_) => {
                self.events[event] = Some(clear);
                None
            }
        }
    }

    /// It is done.
    pub fn end(&mut self, shaded: Shaded) {
        self.events[shaded.event] = Some(PixelEvent::Fragment(shaded.fragment));
    }
}

impl TileJob {
    /// What a colour attachment holds at the watched pixel.
    pub fn watched_color(&self, index: usize) -> Stored {
        let Some(pixel) = &self.watched else { return Vec::new() };
        let format = pixel.formats.colors.get(index).copied().flatten();
        let target = self.colors.get(index).and_then(Option::as_ref);
        pixel.stored(target, |words| format.map_or([0.0; 4], |format| texel_color(format, words)))
    }

    /// What the depth attachment holds there.
    pub fn watched_depth(&self) -> Stored {
        let Some(pixel) = &self.watched else { return Vec::new() };
        let depth = |word: u32| pixel.formats.depth.map_or(0.0, |format| format.depth(word));
        pixel.stored(self.depth.as_ref(), |words| [depth(words[0]), 0.0, 0.0, 1.0])
    }

    /// A clear was done.
    pub fn record_clear(&mut self, job: &ClearJob) {
        let stored = match job.target {
            Cleared::Color(index) => self.watched_color(index),
            Cleared::Depth | Cleared::Stencil => self.watched_depth(),
        };
        if let Some(pixel) = &mut self.watched {
            pixel.cleared(job, &stored);
        }
    }

    /// Records the early tests of a block; `before` is the depth stored before.
    pub fn record_early_tests(
        &mut self,
        isa: Isa,
        plan: &DrawPlan,
        of: &BlockOf<'_>,
        masks: &SampleMasks,
        before: &Stored,
    ) {
        let after = self.watched_depth();
        let Some(pixel) = &mut self.watched else { return };
        let depth = |sample: usize| {
            let plane =
                plan.depth_plane.map(|at| moved(of.planes[at], plan.samples.offset(sample)));
            let depths = plan.viewport.depths();
            plane.map_or(0.0, |plane| isa.run(BlockDepth { plane, depths })[pixel.lane])
        };
        let depths: Vec<f32> = (0..plan.samples.count).map(depth).collect();
        let (when, reference, after) = (When::Early, None, &after);
        let tested = Tested { when, depths: &depths, reference, before, after };
        pixel.tested_early(plan, &tested, masks);
        if plan.shading == Shading::Off {
            pixel.pending.clear();
        }
    }
}
