//! A pass: the unit of work.
//!
//! Its draws are shaded by vertices and set up as they come, their shapes binned to tiles; when the
//! pass ends (or the bins are full) every tile runs, in parallel, its part of the whole pass.

mod account;
mod draw;
mod tiles;

use super::bound::BoundState;
use super::chunk::MergedDraws;
use super::command::{ClearValue, Command};
use super::image::PassDesc;
use super::report::SubmitReport;
use super::resources::Resources;
use crate::attachment::{
    DepthFormat, Surface, all_bits, component_bits, is_attachable, texel_words,
};
use crate::desc::{Rect, Viewport};
use crate::plan::DrawPlan;
use crate::raster::{ClearJob, PassJob, TileCommand};
use crate::sizes::TILE;
use crate::threads::ThreadPool;
use crate::trace::Cleared;
use crate::vertex::VertexIds;
use std::sync::Arc;
use texunit::format::Format;
use texunit::lanes::Isa;

/// The most primitives of a draw that may share a chunk with other draws of the same plan.
const SMALL_DRAW: usize = 256;

/// The attachments of a layer.
struct LayerSurfaces {
    colors: Vec<Option<Surface>>,
    depth: Option<Surface>,
}

/// Whether the attachments are what a pass needs, which was checked before they were taken.
fn fits(desc: &PassDesc, colors: &[Option<Surface>], depth: &Option<Surface>) -> bool {
    let colors = colors.iter().zip(&desc.colors).map(|(surface, asked)| (surface, asked, false));
    let all = colors.chain([(depth, &desc.depth, true)]);
    let mut samples = None;
    all.into_iter().all(|(surface, asked, is_depth)| match (surface, asked) {
        (_, None) => true,
        (None, Some(_)) => false,
        (Some(surface), Some(_)) => {
            surface.width >= desc.width
                && surface.height >= desc.height
                && *samples.get_or_insert(surface.samples) == surface.samples
                && surface.format.is_depth() == is_depth
                && is_attachable(surface.format)
        }
    })
}

/// Gives the attachments of a layer back.
fn detach(desc: &PassDesc, layer: u16, surfaces: LayerSurfaces, isa: Isa) {
    let LayerSurfaces { colors, depth } = surfaces;
    let attachments = desc.colors.iter().chain([&desc.depth]);
    for (attachment, surface) in attachments.zip(colors.into_iter().chain([depth])) {
        let of_layer = attachment.as_ref().and_then(|first| first.layer(layer));
        if let (Some(a), Some(surface)) = (of_layer, surface) {
            a.image.detach(&a, surface, isa);
        }
    }
}

/// The pixels of `area` that have their centre in the viewport.
fn within(mut area: [[i32; 2]; 2], viewport: &Viewport) -> [[i32; 2]; 2] {
    let [first, end] = viewport.pixels();
    for axis in 0..2 {
        area[0][axis] = area[0][axis].max(first[axis]);
        area[1][axis] = area[1][axis].min(end[axis]);
    }
    area
}

/// A pass that is being recorded into bins.
pub struct Pass<'a> {
    resources: &'a Resources,
    thread_pool: &'a ThreadPool,
    desc: PassDesc,
    colors: Vec<Option<Surface>>,
    depth: Option<Surface>,
    /// The attachments of the layers behind the first, from when something is drawn to them.
    more_layers: Vec<Option<LayerSurfaces>>,
    across: u32,
    /// By layer and tile.
    bins: Vec<Vec<TileCommand>>,
    job: PassJob,
    /// The command of each draw.
    commands: Vec<usize>,
    shapes: usize,
    /// Of all shapes of the pass ([`SubmitReport::batches`]).
    batches: u64,
    /// The last small draws, which following draws may join in one chunk.
    merged: Option<MergedDraws>,
    bound: BoundState,
    /// The formats of the colour attachments.
    formats: Vec<Option<Format>>,
    /// The most recent plans, newest last: draws alternate between a few states.
    recent: Vec<Arc<DrawPlan>>,
}

impl<'a> Pass<'a> {
    /// Opens a pass; `None` if another context has specified an attachment anew since the commands were checked, so that it
    /// does not fit.
    pub fn begin(
        resources: &'a Resources,
        thread_pool: &'a ThreadPool,
        desc: &PassDesc,
    ) -> Option<Self> {
        let desc = desc.pinned();
        let across = desc.width.div_ceil(TILE);
        let tiles = across as usize * desc.height.div_ceil(TILE) as usize;
        let attached = desc.colors.iter().map(|color| {
            let attachment = color.as_ref()?;
            attachment.image.attach(attachment, thread_pool)
        });
        let colors: Vec<Option<Surface>> = attached.collect();
        let depth = desc.depth.as_ref();
        let depth = depth.and_then(|a| a.image.attach(a, thread_pool));
        if !fits(&desc, &colors, &depth) {
            detach(&desc, 0, LayerSurfaces { colors, depth }, resources.desc.isa);
            return None;
        }
        let format = |surface: &Option<Surface>| surface.as_ref().map(|s| s.format);
        Some(Self {
            resources,
            thread_pool,
            formats: colors.iter().map(format).collect(),
            recent: Vec::new(),
            colors,
            depth,
            more_layers: (1..desc.layers).map(|_| None).collect(),
            across,
            bins: vec![Vec::new(); tiles * usize::from(desc.layers.max(1))],
            job: PassJob {
                isa: resources.desc.isa,
                width: desc.width,
                height: desc.height,
                draws: Vec::new(),
                chunks: Vec::new(),
                clears: Vec::new(),
                watch: None,
            },
            commands: Vec::new(),
            shapes: 0,
            batches: 0,
            merged: None,
            bound: BoundState::new(resources.desc.budget),
            desc,
        })
    }

    /// Takes one command of the pass.
    pub fn command(&mut self, index: usize, command: &Command, report: &mut SubmitReport) {
        match command {
            Command::BeginPass(_)
            | Command::EndPass
            | Command::BindPipeline(_)
            | Command::BindVertices(_)
            | Command::BindTextures { .. }
            | Command::BindGeometryTextures(_)
            | Command::SetUniforms(_)
            | Command::SetRaster(_)
            | Command::SetViewport(_)
            | Command::SetScissor(_)
            | Command::SetMoreViewports(_)
            | Command::SetCounter(_)
            | Command::SetBudget(_)
            | Command::SetFirstPrimitive(_) => self.bound.set(command),
            Command::Watch(watch) => {
                self.bound.label = watch.label();
                self.job.watch = Some(watch.clone());
            }
            Command::Clear { value, area } => self.clear(*value, *area),
            Command::Draw { first, count, instances } => {
                self.draw(index, &VertexIds::Range(*first), *count, instances, report);
            }
            Command::DrawIndexed { indices, count, instances } => {
                self.draw(index, &VertexIds::Indexed(indices), *count, instances, report);
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
        self.bin_merged();
        let index = self.job.clears.len() as u32;
        self.job.clears.push(job);
        self.bin(area[0], [area[1][0] - 1, area[1][1] - 1], TileCommand::Clear(index));
    }

    /// Runs what is left and gives the attachments back.
    pub fn end(mut self, report: &mut SubmitReport) {
        self.run_tiles(report);
        report.batches = report.batches.saturating_add(self.batches);
        let isa = self.resources.desc.isa;
        detach(&self.desc, 0, LayerSurfaces { colors: self.colors, depth: self.depth }, isa);
        for (layer, surfaces) in (1..).zip(self.more_layers) {
            if let Some(surfaces) = surfaces {
                detach(&self.desc, layer, surfaces, isa);
            }
        }
    }
}
