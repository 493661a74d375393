//! The textures of a draw: which texture and sampler each slot of a stage reads.

use crate::base::error::Result;
use crate::context::Context;
use crate::context::recorder::stages::Textures;
use crate::draw::sampler::sampler;
use crate::draw::warnings;
use crate::glsl::{ComparisonResult, SamplerSlot};
use crate::interface::MAX_COMBINED_TEXTURE_IMAGE_UNITS;
use crate::objects::target::TextureTarget;
use rasterizer::driver::ShaderModule;
use rasterizer::ir::{Access, Expr, Module, Stage};
use std::sync::Arc;
use texunit::plan::SamplePlan;
use texunit::sampler::{DepthMode, SrgbRead};

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
            | TextureTarget::D2MultisampleArray
            | TextureTarget::External => {
                let reader = Reader::Program(module.module(), slot);
                plan(context, unit, target, sampler.result, reader)
            }
        }));
    }
    Ok(textures.into())
}

/// What reads a texture.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Reader<'a> {
    FixedFunction,
    /// A slot of a program's stage.
    Program(&'a Module, usize),
}

impl Reader<'_> {
    /// Whether no other texture can be what is seen: of several that a program has, uniforms may choose one.
    fn is_only_texture(self) -> bool {
        match self {
            Self::FixedFunction => true,
            Self::Program(module, _) => module.textures.len() == 1,
        }
    }

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
    crate::draw::pass::submit_draws_to(context, &image);
    let mut sampler = sampler(context, unit, target);
    match result {
        ComparisonResult::DepthTextureMode => {}
        ComparisonResult::Scalar => sampler.depth_mode = DepthMode::Red,
        ComparisonResult::Ignored => sampler.compare = None,
    }
    // A fetch decodes sRGB whatever the sampler has (EXT_texture_sRGB_decode; where a stage filters the texture as
    // well, that is undefined).
    if sampler.srgb == SrgbRead::AsIs && reader.fetches() {
        sampler.srgb = SrgbRead::Decode;
    }
    warnings::textures::feedback_loop(context, (unit, target), &image, &sampler);
    if reader.is_only_texture() {
        warnings::textures::without_texels(context, (unit, target), &image);
    }
    let bound = &context.state.units.units[usize::from(unit)].bound[target as usize];
    let texture = context.objects.texture_mut(target, bound);
    let plan = texture.plan(&context.recorder.device, &sampler);
    context.recorder.hold(texture.new_bytes());
    plan
}
