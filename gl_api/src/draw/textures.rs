//! The textures of a draw: which texture and sampler each slot of a stage reads.

use crate::base::error::Result;
use crate::context::Context;
use crate::context::recorder::stages::Textures;
use crate::draw::warnings;
use crate::glsl::{ComparisonResult, SamplerSlot};
use crate::interface::MAX_COMBINED_TEXTURE_IMAGE_UNITS;
use crate::objects::target::TextureTarget;
use crate::state::enable::Flag;
use rasterizer::driver::ShaderModule;
use rasterizer::ir::{Access, Expr, Module, Stage};
use std::sync::Arc;
use texunit::plan::SamplePlan;
use texunit::sampler::{Border, DepthMode, Sampler, Seamless, SrgbRead};

/// The textures of a program's stage, from the units that its sampler uniforms name.
pub(crate) fn program_textures(
    context: &mut Context,
    stage: Stage,
    module: &ShaderModule,
    samplers: &[SamplerSlot],
    words: &[u32],
) -> Result<Textures> {
    let found = |slot: usize| {
        let sampler = samplers
            .iter()
            .find(|sampler| sampler.stage == stage && sampler.slot as usize == slot)?;
        let unit = u8::try_from(*words.get(sampler.word as usize)?).ok()?;
        (unit < MAX_COMBINED_TEXTURE_IMAGE_UNITS).then_some((sampler, unit))
    };
    let mut textures = Vec::new();
    for slot in 0..module.module().textures.len() {
        let Some((sampler, unit)) = found(slot) else {
            textures.push(None);
            continue;
        };
        let target = TextureTarget::of_sampler(sampler.dim);
        let decl = module.module().textures[slot];
        warnings::textures::sampler(context, unit, target, sampler.word, decl);
        textures.push(Some(match target {
            TextureTarget::Buffer => crate::draw::texture_buffer::plan(context, unit)?,
            TextureTarget::D1Array
            | TextureTarget::D2Array
            | TextureTarget::CubeArray
            | TextureTarget::D1
            | TextureTarget::D2
            | TextureTarget::Rect
            | TextureTarget::D3
            | TextureTarget::Cube
            | TextureTarget::D2Multisample
            | TextureTarget::D2MultisampleArray => {
                let reader = Reader::Program(module.module(), slot);
                plan(context, unit, target, sampler.result, reader)
            }
        }));
    }
    Ok(textures.into())
}

/// The sampler state of a unit and target: that of the bound sampler object or else the texture's,
/// with the unit's bias.
pub(crate) fn sampler(context: &Context, unit: u8, target: TextureTarget) -> Sampler {
    let state = &context.state.units.units[usize::from(unit)];
    let texture = context.objects.texture(target, &state.bound[target as usize]);
    let own = texture.sampler();
    // Multisample textures ignore sampler objects.
    let object = context.objects.samplers.bound(&state.sampler);
    let mut sampler = match object.filter(|_| !target.is_multisample()) {
        Some(object) => Sampler {
            base_level: own.base_level,
            max_level: own.max_level,
            depth_mode: own.depth_mode,
            swizzle: own.swizzle,
            ..object.sampler.clone()
        },
        None => own,
    };
    if context.state.enables.has(Flag::SeamlessCubeMaps) {
        sampler.seamless = Seamless::On;
    }
    // GL 2.1, section 3.8.4: the border is clamped to [0, 1], except for floats and integers.
    if !texture.has_wide_texels() {
        let fractions =
            sampler.border.floats().map(|c| crate::base::convert::unit(c.into()) as f32);
        sampler.border = Border::Float(fractions);
    }
    sampler.lod_bias = crate::base::convert::lod_bias(sampler.lod_bias + state.lod_bias);
    sampler
}

/// What reads a texture.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Reader<'a> {
    FixedFunction,
    /// A slot of a program's stage.
    Program(&'a Module, usize),
}

impl Reader<'_> {
    /// Whether any of its accesses is a fetch.
    fn fetches(self) -> bool {
        let Self::Program(module, slot) = self else { return false };
        module.values.iter().any(|value| {
            let Expr::Sample(sample) = value else { return false };
            sample.texture.0 as usize == slot && matches!(sample.access, Access::Fetch { .. })
        })
    }
}

/// How a unit samples the texture of a target. What was recorded and writes to the texture is submitted before.
pub(crate) fn plan(
    context: &mut Context,
    unit: u8,
    target: TextureTarget,
    result: ComparisonResult,
    reader: Reader<'_>,
) -> Arc<SamplePlan> {
    let bound = &context.state.units.units[usize::from(unit)].bound[target as usize];
    let image = context.objects.texture(target, bound).image.clone();
    crate::draw::pass::settle(context, &image);
    let mut sampler = sampler(context, unit, target);
    match result {
        ComparisonResult::DepthTextureMode => {}
        ComparisonResult::Scalar => sampler.depth_mode = DepthMode::Red,
        ComparisonResult::Ignored => sampler.compare = None,
    }
    // A fetch decodes sRGB whatever the sampler has (EXT_texture_sRGB_decode; where a stage filters the texture as well, that
    // is undefined).
    if sampler.srgb == SrgbRead::AsIs && reader.fetches() {
        sampler.srgb = SrgbRead::Decode;
    }
    warnings::textures::feedback_loop(context, (unit, target), &image, &sampler);
    let bound = &context.state.units.units[usize::from(unit)].bound[target as usize];
    let texture = context.objects.texture_mut(target, bound);
    let plan = texture.plan(&context.recorder.device, &sampler);
    context.recorder.hold(texture.new_bytes());
    plan
}
