//! Shading without registers: of programs that are a product ([`crate::shader::TexelProduct`]), texels are multiplied
//! as they come, and where nothing is blended they go straight into the attachment's words.

use super::block_run::{BlockRun, Level};
use crate::output::{Color, ColorPlan, pack_colors, put};
use crate::plan::{DrawPlan, FactorPlanes, FilledInput, ProductInputs, ProductPlan};
use crate::shader::{MAX_REGISTER_FILES, Machine, OverBudget, ProductCode, Run, TexelProduct};
use texunit::lanes::{F32s, Isa, Kernel, LANES, QUADS, Simd, U32s};
use texunit::plan::SamplePlan;
use texunit::sample::{
    Addresses, FilteredTexels, LevelHint, Lod, LookupScratch, SelectedLevels, TexelConsumer,
    UniformLevels,
};

/// The colours of a run, and the state between its lookups.
#[derive(Debug, Default)]
pub struct Products {
    /// Red, green, blue and alpha of each block.
    colors: Box<[[F32s; 4]; MAX_REGISTER_FILES]>,
    /// Products that are not done, by turns.
    between: Box<[[F32s; 4]; 2]>,
    /// Of lookups.
    room: Box<LookupScratch>,
    /// How the run has its factors.
    how: Factors,
    /// Factors that are the same all over a run, for as long as these are what they depend on: the draw, and the
    /// values of planes.
    factors: Box<[F32s; 4]>,
    draw: u64,
    values: Vec<u32>,
    /// What each lookup reads, where that is the same all over a shape.
    readings: Vec<Reading>,
    /// Whether a run reads what the one before has read.
    details: Details,
    /// The shapes all over which the factors and readings are known to be the same.
    level: Level,
    /// The planes' values of this run.
    now: Vec<u32>,
    /// Whether all of those factors are 1: then everything is what it was.
    is_one: bool,
}

/// How a run has its factors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Factors {
    /// They differ from pixel to pixel: computed in each register file.
    #[default]
    Varying,
    /// They are the same everywhere: computed in the first register file.
    Shared,
    /// They are what they were in the run before.
    Known,
}

/// What a lookup reads, and the weight of the second level.
type Reading = (Option<UniformLevels>, F32s);

/// How a run has the levels that its lookups read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Details {
    /// Each block finds them out.
    #[default]
    Varying,
    /// They are what they were in the run before.
    Known,
}

impl Products {
    /// Says which inputs a run needs: of the first register file, and of the others.
    pub fn inputs_of<'a>(
        &mut self,
        plan: &DrawPlan,
        of: &'a ProductPlan,
        run: &BlockRun,
    ) -> [&'a [FilledInput]; 2] {
        let details = run.level().details;
        let is_known = details.is_some() && details == self.level.details;
        self.details = if is_known { Details::Known } else { Details::Varying };
        let ProductInputs { all, lookups } = match self.details {
            Details::Varying => &of.inputs,
            Details::Known => &of.without_details,
        };
        match self.factors_of(plan, of, run) {
            Factors::Varying => [all; 2],
            Factors::Shared => [all, lookups],
            Factors::Known => [lookups; 2],
        }
    }

    /// Says how the factors of a run are to be had.
    fn factors_of(&mut self, plan: &DrawPlan, of: &ProductPlan, run: &BlockRun) -> Factors {
        let level = run.level().factors;
        if level.is_some() && level == self.level.factors {
            self.how = Factors::Known;
            return self.how;
        }
        let shared = match &of.factor_planes {
            Some(FactorPlanes { smooth, linear }) => {
                let now = &mut self.now;
                now.clear();
                let denominator = plan.denominator_plane.filter(|&plane| !run.is_one(plane));
                run.shares(linear, now)
                    && match denominator {
                        Some(plane) => run.shares_ones(smooth, plane, now),
                        None => run.shares(smooth, now),
                    }
            }
            None => false,
        };
        self.level.factors = level.filter(|_| shared);
        self.how = match shared {
            false => Factors::Varying,
            true if self.draw == plan.prepared.id() && self.now == self.values => Factors::Known,
            true => {
                self.draw = plan.prepared.id();
                self.values.clone_from(&self.now);
                Factors::Shared
            }
        };
        self.how
    }

    /// Runs the code before the lookups of a run, whose inputs are in the machine.
    ///
    /// # Errors
    /// When the budget is used up.
    pub fn begin(
        &mut self,
        machine: &mut Machine,
        run: &Run<'_>,
        product: &TexelProduct,
        files: usize,
    ) -> Result<(), OverBudget> {
        if self.readings.len() != product.lookups() {
            self.readings.resize(product.lookups(), (None, F32s::ZERO));
        }
        match self.how {
            Factors::Varying => return machine.run_before(run, product, ProductCode::Whole, files),
            Factors::Shared => {
                machine.run_before(run, product, ProductCode::Factors, 1)?;
                *self.factors = machine.factors(product, 0).map(|factor| *factor);
                self.is_one = self.factors.iter().all(|factor| factor[0] == 1.0);
            }
            Factors::Known => {}
        }
        machine.run_before(run, product, ProductCode::Lookups, files)
    }

    /// Notes of a run that is done what the next one of its shape need not find out.
    pub fn done(&mut self, run: &BlockRun) {
        self.level.details = run.level().details;
    }

    /// Red, green, blue or alpha of a block of the run, if colours were requested.
    #[inline(always)]
    pub fn color(&self, file: usize, component: usize) -> &F32s {
        &self.colors[file][component]
    }
}

/// Computes the products of a run, whose inputs are in the machine.
pub struct Multiply<'a> {
    pub isa: Isa,
    pub plan: &'a DrawPlan,
    pub product: &'a TexelProduct,
    pub machine: &'a Machine,
    pub run: &'a BlockRun,
    pub products: &'a mut Products,
    /// Receives the colours as words if present; otherwise they are stored here.
    pub words: Option<Words<'a>>,
}

/// Where colours go that are four bytes a pixel, and are not blended.
pub struct Words<'a> {
    pub color: &'a ColorPlan,
    /// The attachment's words.
    pub blocks: &'a mut [U32s],
}

impl Kernel for Multiply<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { isa, plan, product, machine, run, products, mut words } = self;
        let Products { colors, between, room, factors, how, is_one, readings, details, .. } =
            products;
        let (how, is_one) = (*how, *is_one && *how != Factors::Varying);
        let places = plan.product.as_ref().map_or(&[][..], |product| &product.places[..]);
        let [even, odd] = &mut **between;
        let known = match details {
            Details::Varying => None,
            Details::Known => Some(&readings[..]),
        };
        ask::<S>(plan, product, machine, run.len(), known);
        let is_kept = *details == Details::Varying && run.level().details.is_some();
        for (file, colors) in colors.iter_mut().enumerate().take(run.len()) {
            let given = match how {
                Factors::Varying => machine.factors(product, file),
                Factors::Shared | Factors::Known => factors.each_ref(),
            };
            // What lies here no store of colours can change.
            let (mut read, mut weight) = (None, F32s::ZERO);
            for (at, (kept, &places)) in readings.iter_mut().zip(places).enumerate() {
                let is_last = at + 1 == product.lookups();
                let (before, after) =
                    if at % 2 == 0 { (&*odd, &mut *even) } else { (&*even, &mut *odd) };
                let times = MultiplyKernel {
                    factors: if at == 0 { given } else { before.each_ref() },
                    is_one: is_one && at == 0,
                    to: match &mut words {
                        Some(Words { color, blocks }) if is_last => {
                            let (block, mask) = run.covered(file);
                            To::Words { color, stored: &mut blocks[block], mask }
                        }
                        _ if is_last => To::Lanes(colors),
                        _ => To::Lanes(after),
                    },
                };
                let texture = plan.textures.get(product.texture(at));
                if let Some(texture) = texture.and_then(Option::as_ref) {
                    let coords = machine.coords(product, at, file);
                    let lod = lod_of(texture, machine, product, at, file);
                    match (&*details, places) {
                        (Details::Known, _) => (read, weight) = *kept,
                        (Details::Varying, Addresses::Compute) => {
                            read = texture.uniform_levels::<S>(coords, &lod, &mut weight);
                        }
                        (Details::Varying, Addresses::Reuse) => {}
                    }
                    if is_kept {
                        *kept = (read, weight);
                    }
                    let known = SelectedLevels { levels: read, weight: &weight, addresses: places };
                    texture.sample_fused::<S, _>(isa, coords, lod, known, room, times);
                }
            }
        }
    }
}

/// Asks for the texels of a run: at every other pixel of each block. What the lookups read may be known.
#[inline(always)]
fn ask<S: Simd>(
    plan: &DrawPlan,
    product: &TexelProduct,
    machine: &Machine,
    files: usize,
    known: Option<&[Reading]>,
) {
    for at in 0..product.lookups() {
        let texture = plan.textures.get(product.texture(at));
        let Some(texture) = texture.and_then(Option::as_ref) else { continue };
        let like = match known.and_then(|readings| readings[at].0) {
            Some(read) => LevelHint::Uniform(read),
            None => {
                let lod = lod_of(texture, machine, product, at, 0);
                LevelHint::FirstLane(machine.coords(product, at, 0), lod)
            }
        };
        let mut points = [F32s::ZERO; 2];
        for file in 0..MAX_REGISTER_FILES {
            let coords = machine.coords(product, at, file.min(files - 1));
            for (points, coords) in points.iter_mut().zip(coords) {
                points.0[file * QUADS..][..QUADS].copy_from_slice(&coords.0[..QUADS]);
            }
        }
        texture.prefetch::<S>(points.each_ref(), like);
    }
}

/// The level of detail of a lookup, which is not looked up where the texture has no use for it.
#[inline(always)]
fn lod_of<'a>(
    texture: &SamplePlan,
    machine: &'a Machine,
    product: &'a TexelProduct,
    at: usize,
    file: usize,
) -> Lod<'a> {
    if texture.needs_lod() { machine.lod(product, at, file) } else { Lod::Implicit { bias: None } }
}

/// Multiplies a lookup.
struct MultiplyKernel<'a> {
    factors: [&'a F32s; 4],
    /// Whether all of them are 1.
    is_one: bool,
    to: To<'a>,
}

/// Where products go.
enum To<'a> {
    Lanes(&'a mut [F32s; 4]),
    Words { color: &'a ColorPlan, stored: &'a mut U32s, mask: u64 },
}

impl TexelConsumer for MultiplyKernel<'_> {
    type Output = ();

    #[inline(always)]
    fn consume<S: Simd>(self, texels: &impl FilteredTexels) {
        let Self { factors, is_one, to } = self;
        match to {
            To::Lanes([r, g, b, a]) => {
                times(texels, factors, 0, r);
                times(texels, factors, 1, g);
                times(texels, factors, 2, b);
                times(texels, factors, 3, a);
            }
            To::Words { color, stored, mask } => {
                let write = color.write_of(0);
                match texels.bytes() {
                    // A byte over 255 is that byte again.
                    Some(bytes) if is_one => put(stored, bytes, mask, write),
                    None if is_one => {
                        let words = pack_colors(&Alone(texels));
                        put(stored, &words, mask, write);
                    }
                    Some(_) | None => {
                        let words = pack_colors(&Colors { texels, factors });
                        put(stored, &words, mask, write);
                    }
                }
            }
        }
    }
}

#[inline(always)]
fn times(texels: &impl FilteredTexels, factors: [&F32s; 4], channel: usize, out: &mut F32s) {
    for lane in 0..LANES {
        out[lane] = factors[channel][lane] * texels.channel(lane, channel);
    }
}

/// The lookup as colours.
struct Alone<'a, T>(&'a T);

impl<T: FilteredTexels> Color for Alone<'_, T> {
    #[inline(always)]
    fn channel(&self, lane: usize, channel: usize) -> f32 {
        self.0.channel(lane, channel)
    }
    #[inline(always)]
    fn byte(&self, lane: usize, channel: usize) -> u32 {
        self.0.byte(lane, channel)
    }
}

/// The products as colours.
struct Colors<'a, T> {
    texels: &'a T,
    factors: [&'a F32s; 4],
}

impl<T: FilteredTexels> Color for Colors<'_, T> {
    #[inline(always)]
    fn channel(&self, lane: usize, channel: usize) -> f32 {
        self.factors[channel][lane] * self.texels.channel(lane, channel)
    }
}
