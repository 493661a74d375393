//! Shading without registers: of programs that are a product ([`crate::shader::TexelProduct`]), texels are multiplied
//! by the factors as the lookups return them; without blending the products are written to the words of the attachment.

use super::block_group::{BlockGroup, UniformOverShape};
use crate::output::{Color, ColorPlan, pack_colors, store_masked};
use crate::plan::{DrawPlan, FactorPlanes, FilledInput, ProductInputs, ProductPlan};
use crate::shader::{
    Invocation, MAX_REGISTER_FILES, Machine, OverBudget, ProductCode, TexelProduct,
};
use texunit::lanes::{F32s, Isa, Kernel, LANES, QUADS, Simd, U32s};
use texunit::plan::SamplePlan;
use texunit::sample::{
    Addresses, FilteredTexels, LevelHint, Lod, LookupScratch, SelectedLevels, TexelConsumer,
    UniformLevels,
};

/// The colours of a block group, and the state between its lookups.
#[derive(Debug, Default)]
pub struct Products {
    /// Red, green, blue and alpha of each block.
    colors: Box<[[F32s; 4]; MAX_REGISTER_FILES]>,
    /// The product before and after a lookup, alternating.
    partial_products: Box<[[F32s; 4]; 2]>,
    /// The scratch of the lookups.
    scratch: Box<LookupScratch>,
    /// How the factors of the group are computed.
    factor_source: FactorReuse,
    /// Factors that are the same all over a block group, for as long as these are what they depend on: the draw, and
    /// the values of planes.
    factors: Box<[F32s; 4]>,
    draw: u64,
    factor_values: Vec<u32>,
    /// The levels of each lookup, if they are uniform over a shape.
    lookup_levels: Vec<LookupLevels>,
    /// Whether the lookups read the levels of the previous group.
    lods: LodReuse,
    /// The shapes all over which the factors and the levels of the lookups are known to be the same.
    uniform: UniformOverShape,
    /// The planes' values of this group.
    plane_values: Vec<u32>,
    /// Whether all of `factors` are 1, so that multiplication has no effect.
    factors_are_one: bool,
}

/// How the factors of a block group are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FactorReuse {
    /// They differ from pixel to pixel: computed in each register file.
    #[default]
    Varying,
    /// Equal at all pixels: computed in the first register file only.
    Uniform,
    /// Equal to those of the previous group, and reused.
    Reused,
}

/// The levels that a lookup reads if they are uniform, and the weight of the second.
type LookupLevels = (Option<UniformLevels>, F32s);

/// How the levels that the lookups of a block group read are selected.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LodReuse {
    /// Selected for each block.
    #[default]
    Varying,
    /// Equal to those of the previous group, and reused.
    Reused,
}

impl Products {
    /// The inputs that a block group needs: those of the first register file, and of the others.
    pub fn inputs_of<'a>(
        &mut self,
        plan: &DrawPlan,
        of: &'a ProductPlan,
        block_group: &BlockGroup,
    ) -> [&'a [FilledInput]; 2] {
        let lods = block_group.uniform_over_shape().lods;
        let is_known = lods.is_some() && lods == self.uniform.lods;
        self.lods = if is_known { LodReuse::Reused } else { LodReuse::Varying };
        let ProductInputs { all, lookups } = match self.lods {
            LodReuse::Varying => &of.inputs,
            LodReuse::Reused => &of.without_lods,
        };
        match self.factors_of(plan, of, block_group) {
            FactorReuse::Varying => [all; 2],
            FactorReuse::Uniform => [all, lookups],
            FactorReuse::Reused => [lookups; 2],
        }
    }

    /// Decides how the factors of a block group are computed.
    fn factors_of(
        &mut self,
        plan: &DrawPlan,
        of: &ProductPlan,
        block_group: &BlockGroup,
    ) -> FactorReuse {
        let shape_number = block_group.uniform_over_shape().factors;
        if shape_number.is_some() && shape_number == self.uniform.factors {
            self.factor_source = FactorReuse::Reused;
            return self.factor_source;
        }
        let shared = match &of.factor_planes {
            Some(FactorPlanes { smooth, linear }) => {
                let values = &mut self.plane_values;
                values.clear();
                let denominator =
                    plan.denominator_plane.filter(|&plane| !block_group.is_one(plane));
                block_group.are_uniform(linear, values)
                    && match denominator {
                        Some(plane) => block_group.are_uniform_ones(smooth, plane, values),
                        None => block_group.are_uniform(smooth, values),
                    }
            }
            None => false,
        };
        self.uniform.factors = shape_number.filter(|_| shared);
        self.factor_source = match shared {
            false => FactorReuse::Varying,
            true if self.draw == plan.prepared.id() && self.plane_values == self.factor_values => {
                FactorReuse::Reused
            }
            true => {
                self.draw = plan.prepared.id();
                self.factor_values.clone_from(&self.plane_values);
                FactorReuse::Uniform
            }
        };
        self.factor_source
    }

    /// Runs the code before the lookups of a block group, whose inputs are in the machine.
    ///
    /// # Errors
    /// When the budget is used up.
    pub fn begin(
        &mut self,
        machine: &mut Machine,
        invocation: &Invocation<'_>,
        product: &TexelProduct,
        files: usize,
    ) -> Result<(), OverBudget> {
        if self.lookup_levels.len() != product.lookups() {
            self.lookup_levels.resize(product.lookups(), (None, F32s::ZERO));
        }
        match self.factor_source {
            FactorReuse::Varying => {
                return machine.run_before(invocation, product, ProductCode::Whole, files);
            }
            FactorReuse::Uniform => {
                machine.run_before(invocation, product, ProductCode::Factors, 1)?;
                *self.factors = machine.factors(product, 0).map(|factor| *factor);
                self.factors_are_one = self.factors.iter().all(|factor| factor[0] == 1.0);
            }
            FactorReuse::Reused => {}
        }
        machine.run_before(invocation, product, ProductCode::Lookups, files)
    }

    /// Stores after a block group what the next group of the same shape may reuse.
    pub fn finish_group(&mut self, block_group: &BlockGroup) {
        self.uniform.lods = block_group.uniform_over_shape().lods;
    }

    /// Red, green, blue or alpha of a block of the group, if colours were requested.
    #[inline(always)]
    pub fn color(&self, file: usize, component: usize) -> &F32s {
        &self.colors[file][component]
    }
}

/// Computes the products of a block group, whose inputs are in the machine.
pub struct Multiply<'a> {
    pub isa: Isa,
    pub plan: &'a DrawPlan,
    pub product: &'a TexelProduct,
    pub machine: &'a Machine,
    pub block_group: &'a BlockGroup,
    pub products: &'a mut Products,
    /// Receives the colours as words if present; otherwise they are stored here.
    pub words: Option<Words<'a>>,
}

/// The destination of colours of four bytes a pixel that are not blended.
pub struct Words<'a> {
    pub color: &'a ColorPlan,
    /// The attachment's words, or others.
    pub blocks: &'a mut [U32s],
    /// Those of each register file.
    pub slots: [WordSlot; MAX_REGISTER_FILES],
}

/// The destination of the words of a register file.
#[derive(Clone, Copy, Debug, Default)]
pub struct WordSlot {
    /// Which block.
    pub at: usize,
    /// The lanes that are stored.
    pub mask: u64,
}

impl Kernel for Multiply<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { isa, plan, product, machine, block_group, products, mut words } = self;
        let Products {
            colors,
            partial_products,
            scratch,
            factors,
            factor_source,
            factors_are_one,
            lookup_levels,
            lods,
            ..
        } = products;
        let (factor_source, factors_are_one) =
            (*factor_source, *factors_are_one && *factor_source != FactorReuse::Varying);
        let addresses = plan.product.as_ref().map_or(&[][..], |product| &product.addresses[..]);
        let [even, odd] = &mut **partial_products;
        let known = match lods {
            LodReuse::Varying => None,
            LodReuse::Reused => Some(&lookup_levels[..]),
        };
        prefetch_lookups::<S>(plan, product, machine, block_group.len(), known);
        let is_stored =
            *lods == LodReuse::Varying && block_group.uniform_over_shape().lods.is_some();
        for (file, colors) in colors.iter_mut().enumerate().take(block_group.len()) {
            let run_factors = match factor_source {
                FactorReuse::Varying => machine.factors(product, file),
                FactorReuse::Uniform | FactorReuse::Reused => factors.each_ref(),
            };
            // On the stack, so that the compiler sees that no store of colours changes them.
            let (mut selected_levels, mut weight) = (None, F32s::ZERO);
            for (at, (stored_levels, &addresses)) in
                lookup_levels.iter_mut().zip(addresses).enumerate()
            {
                let is_last = at + 1 == product.lookups();
                let (before, after) =
                    if at % 2 == 0 { (&*odd, &mut *even) } else { (&*even, &mut *odd) };
                let multiply = MultiplyKernel {
                    factors: if at == 0 { run_factors } else { before.each_ref() },
                    factors_are_one: factors_are_one && at == 0,
                    to: match &mut words {
                        Some(Words { color, blocks, slots }) if is_last => {
                            let WordSlot { at, mask } = slots[file];
                            ProductTarget::Words { color, stored: &mut blocks[at], mask }
                        }
                        _ if is_last => ProductTarget::Lanes(colors),
                        _ => ProductTarget::Lanes(after),
                    },
                };
                let texture = plan.textures.get(product.texture(at));
                if let Some(texture) = texture.and_then(Option::as_ref) {
                    let coords = machine.coords(product, at, file);
                    let lod = lod_of(texture, machine, product, at, file);
                    match (&*lods, addresses) {
                        (LodReuse::Reused, _) => (selected_levels, weight) = *stored_levels,
                        (LodReuse::Varying, Addresses::Compute) => {
                            selected_levels =
                                texture.uniform_levels::<S>(coords, &lod, &mut weight);
                        }
                        (LodReuse::Varying, Addresses::Reuse) => {}
                    }
                    if is_stored {
                        *stored_levels = (selected_levels, weight);
                    }
                    let known =
                        SelectedLevels { levels: selected_levels, weight: &weight, addresses };
                    texture.sample_fused::<S, _>(isa, coords, lod, known, scratch, multiply);
                }
            }
        }
    }
}

/// Prefetches the texels of a block group, at every other pixel of each block. `known` are the levels of the lookups,
/// where they are reused.
#[inline(always)]
fn prefetch_lookups<S: Simd>(
    plan: &DrawPlan,
    product: &TexelProduct,
    machine: &Machine,
    files: usize,
    known: Option<&[LookupLevels]>,
) {
    for at in 0..product.lookups() {
        let texture = plan.textures.get(product.texture(at));
        let Some(texture) = texture.and_then(Option::as_ref) else { continue };
        let hint = match known.and_then(|levels| levels[at].0) {
            Some(levels) => LevelHint::Uniform(levels),
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
        texture.prefetch::<S>(points.each_ref(), hint);
    }
}

/// The level of detail of a lookup, which is not read where the texture does not need it.
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

/// Multiplies the texels of one lookup by the factors.
struct MultiplyKernel<'a> {
    factors: [&'a F32s; 4],
    /// Whether all of them are 1.
    factors_are_one: bool,
    to: ProductTarget<'a>,
}

/// The destination of products.
enum ProductTarget<'a> {
    Lanes(&'a mut [F32s; 4]),
    Words { color: &'a ColorPlan, stored: &'a mut U32s, mask: u64 },
}

impl TexelConsumer for MultiplyKernel<'_> {
    type Output = ();

    #[inline(always)]
    fn consume<S: Simd>(self, texels: &impl FilteredTexels) {
        let Self { factors, factors_are_one, to } = self;
        match to {
            ProductTarget::Lanes([r, g, b, a]) => {
                multiply(texels, factors, 0, r);
                multiply(texels, factors, 1, g);
                multiply(texels, factors, 2, b);
                multiply(texels, factors, 3, a);
            }
            ProductTarget::Words { color, stored, mask } => {
                let write = color.write_of(0);
                match texels.bytes() {
                    // A byte over 255 is that byte again.
                    Some(bytes) if factors_are_one => store_masked(stored, bytes, mask, write),
                    None if factors_are_one => {
                        let words = pack_colors(&LookupColors(texels));
                        store_masked(stored, &words, mask, write);
                    }
                    Some(_) | None => {
                        let words = pack_colors(&ProductColors { texels, factors });
                        store_masked(stored, &words, mask, write);
                    }
                }
            }
        }
    }
}

#[inline(always)]
fn multiply(texels: &impl FilteredTexels, factors: [&F32s; 4], channel: usize, out: &mut F32s) {
    for lane in 0..LANES {
        out[lane] = factors[channel][lane] * texels.channel(lane, channel);
    }
}

/// The lookup as colours.
struct LookupColors<'a, T>(&'a T);

impl<T: FilteredTexels> Color for LookupColors<'_, T> {
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
struct ProductColors<'a, T> {
    texels: &'a T,
    factors: [&'a F32s; 4],
}

impl<T: FilteredTexels> Color for ProductColors<'_, T> {
    #[inline(always)]
    fn channel(&self, lane: usize, channel: usize) -> f32 {
        self.factors[channel][lane] * self.texels.channel(lane, channel)
    }
}
