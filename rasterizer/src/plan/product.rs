//! The texel-product fast path in a draw: which factors and levels of detail are constant over a shape.

use super::Textures;
use super::inputs::{FilledInput, FragmentInput};
use crate::shader::Program;
use texunit::lanes::Isa;
use texunit::plan::SamplePlan;
use texunit::sample::Addresses;

/// The plan of a draw whose fragment program is a [`crate::shader::TexelProduct`].
#[derive(Debug)]
pub struct ProductPlan {
    /// The planes that its factors depend on, if they depend on nothing else: where these are the same all over a
    /// shape, so are the factors.
    pub factor_planes: Option<FactorPlanes>,
    /// The planes that are divided by the denominator among those whose steps the levels of detail depend on, if they
    /// depend on nothing else: where these do not lie in perspective, levels are the same all over a shape.
    pub lod_planes: Option<Vec<usize>>,
    /// The inputs of a block.
    pub inputs: ProductInputs,
    /// Those where the levels of detail are known.
    pub without_lods: ProductInputs,
    /// For each lookup, whether its texel addresses are computed or reused from the lookup before.
    pub addresses: Vec<Addresses>,
}

/// The inputs that a block needs.
#[derive(Debug)]
pub struct ProductInputs {
    pub all: Vec<FilledInput>,
    /// Where the factors are known.
    pub lookups: Vec<FilledInput>,
}

/// The planes that factors depend on.
#[derive(Debug, Default)]
pub struct FactorPlanes {
    /// Those that are divided by the denominator.
    pub smooth: Vec<usize>,
    /// Those that are taken as they are.
    pub linear: Vec<usize>,
}

impl ProductPlan {
    /// Makes the plan; `None` where the interpreter is needed.
    pub(super) fn new(
        isa: Isa,
        fragment: &Program,
        inputs: &[FragmentInput],
        textures: &Textures,
    ) -> Option<Self> {
        let product = fragment.product()?;
        let is_there = |slot: u32| {
            let texture = textures.get(slot as usize).and_then(Option::as_ref);
            texture.is_some_and(|texture| texture.samples_color())
        };
        if !product.textures().all(is_there) {
            return None;
        }
        let addresses_of = |at: usize| {
            product.repeat(at).map_or(Addresses::Compute, |repeat| repeat.addresses(textures))
        };
        let mut factor_planes = Some(FactorPlanes::default());
        for &index in &product.factor_inputs {
            match inputs[index] {
                FragmentInput::Flat(plane) | FragmentInput::Linear(plane) => {
                    factor_planes.iter_mut().for_each(|planes| planes.linear.push(plane));
                }
                FragmentInput::Smooth(plane) => {
                    factor_planes.iter_mut().for_each(|planes| planes.smooth.push(plane));
                }
                FragmentInput::Zero => {}
                FragmentInput::SmoothAtCentroid(_)
                | FragmentInput::LinearAtCentroid(_)
                | FragmentInput::SmoothGradient(..)
                | FragmentInput::LinearGradient(..)
                | FragmentInput::X
                | FragmentInput::Y
                | FragmentInput::Depth
                | FragmentInput::Front
                | FragmentInput::Coverage
                | FragmentInput::PlaceOfSample(_)
                | FragmentInput::SampleId
                | FragmentInput::SamplePosition(_) => factor_planes = None,
            }
        }
        if let Some(FactorPlanes { smooth, linear }) = &mut factor_planes {
            for planes in [smooth, linear] {
                planes.sort_unstable();
                planes.dedup();
            }
        }
        let all = |takes: fn(&SamplePlan, Isa) -> bool| {
            product.textures().all(|slot| {
                let texture = textures.get(slot as usize).and_then(Option::as_ref);
                texture.is_some_and(|texture| !texture.needs_lod() || takes(texture, isa))
            })
        };
        let lods = product.lod_inputs.as_ref();
        let lod_planes = lods
            .filter(|_| all(SamplePlan::selects_uniform_levels))
            .and_then(|lods| lod_planes(lods, inputs));
        // Other lookups read the level of detail again where no level is the same in all lanes.
        let lods = lods.filter(|_| all(SamplePlan::fuses_uniform_levels));
        let filled = |left_out: &[usize]| {
            let is_in = |number: usize| !left_out.contains(&number);
            let is_of_lookup = |number| is_in(number) && product.lookup_inputs.contains(&number);
            ProductInputs {
                all: FilledInput::of(inputs, is_in),
                lookups: FilledInput::of(inputs, is_of_lookup),
            }
        };
        Some(Self {
            factor_planes,
            lod_planes,
            addresses: (0..product.lookups()).map(addresses_of).collect(),
            inputs: filled(&[]),
            without_lods: filled(lods.map_or(&[], |lods| &lods[..])),
        })
    }
}

/// The smooth planes whose steps these inputs are; `None` where there are no steps, or anything else.
fn lod_planes(lods: &[usize], inputs: &[FragmentInput]) -> Option<Vec<usize>> {
    let (mut smooth, mut any) = (Vec::new(), false);
    for &index in lods {
        match inputs[index] {
            FragmentInput::SmoothGradient(plane, _) => smooth.push(plane),
            FragmentInput::LinearGradient(..) => {}
            FragmentInput::Zero => continue,
            FragmentInput::Smooth(_)
            | FragmentInput::Linear(_)
            | FragmentInput::SmoothAtCentroid(_)
            | FragmentInput::LinearAtCentroid(_)
            | FragmentInput::Flat(_)
            | FragmentInput::X
            | FragmentInput::Y
            | FragmentInput::Depth
            | FragmentInput::Front
            | FragmentInput::Coverage
            | FragmentInput::PlaceOfSample(_)
            | FragmentInput::SampleId
            | FragmentInput::SamplePosition(_) => return None,
        }
        any = true;
    }
    any.then_some(smooth)
}
