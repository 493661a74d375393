//! Notes of what is recorded while a pixel is watched: what the state of a draw means in GL's names.

use crate::assembly::Target;
use crate::base::constants::enum_name;
use crate::context::Context;
use crate::context::watched_pixel::{CommandNote, DrawNote};
use crate::generate::fixed::fragment::FragmentKey;
use crate::glsl::SamplerSlot;
use crate::objects::target::{TARGET, TextureTarget};
use rasterizer::driver::{Command, PassDesc, ShaderModule};
use rasterizer::ir::Stage;

impl DrawNote {
    /// The note of a draw by a program.
    pub fn of_program(context: &Context, fragment: &ShaderModule, words: &[u32]) -> Self {
        let name = context.program_of(Stage::Fragment);
        let mut note = Self { title: format!("program {name}"), ..Self::default() };
        let Some(linked) = context.executable() else { return note };
        note.varyings.clone_from(&linked.program.varyings);
        for slot in 0..fragment.module().textures.len() {
            let sampler =
                linked.program.samplers.iter().find(|sampler| {
                    sampler.stage == Stage::Fragment && sampler.slot as usize == slot
                });
            let unit = sampler.and_then(|sampler| words.get(sampler.word as usize));
            let uniform = sampler.and_then(|sampler| {
                let of_word = |uniform: &&glsl::Uniform| uniform.word == sampler.word;
                linked.program.uniforms.iter().find(of_word)
            });
            let name = uniform.map_or_else(|| format!("sampler {slot}"), |u| u.name.to_string());
            let target = sampler.map(|sampler| TextureTarget::of_sampler(sampler.dim));
            note.textures.push(match unit.zip(target) {
                Some((&unit, target)) => format!("{name}: {}", texture(context, unit, target)),
                None => name,
            });
        }
        note
    }

    /// The note of a draw whose fragment stage is an assembly program.
    pub fn of_assembly(context: &Context, samplers: &[SamplerSlot], words: &[u32]) -> Self {
        let name = context.state.assembly.bound[Target::Fragment as usize].name();
        let of_fragments = samplers.iter().filter(|sampler| sampler.stage == Stage::Fragment);
        let textures = of_fragments.map(|sampler| {
            let unit = words.get(sampler.word as usize).copied().unwrap_or(0);
            let target = TextureTarget::of_sampler(sampler.dim);
            format!("texture[{unit}]: {}", texture(context, unit, target))
        });
        Self {
            title: format!("assembly program {name}"),
            textures: textures.collect(),
            ..Self::default()
        }
    }

    /// The note of a draw of the fixed function.
    pub fn of_fixed(context: &Context, key: &FragmentKey) -> Self {
        let of_unit = |unit: &crate::generate::fixed::fragment::UnitKey| {
            texture(context, unit.unit.into(), TextureTarget::of(unit.shape))
        };
        Self {
            title: "fixed function".into(),
            textures: key.units.iter().map(of_unit).collect(),
            formulas: key.formulas(),
            varyings: Vec::new(),
        }
    }
}

/// Names a texture unit and its texture.
pub(crate) fn texture(context: &Context, unit: u32, target: TextureTarget) -> String {
    let state = context.state.units.units.get(unit as usize);
    let name = state.map_or(0, |state| state.bound[target as usize].name());
    format!("unit {unit}, {} {name}", enum_name(TARGET.encode(target)))
}

/// Whether a pass draws to the watched pixel's framebuffer.
pub(crate) fn is_watched(context: &Context, pass: &PassDesc) -> bool {
    let window = &context.window.color;
    context.watched.is_some()
        && pass.colors.iter().flatten().any(|attachment| attachment.image.is_same_image(window))
}

/// Notes that the next command of the open pass, which is watched, is a draw.
pub(crate) fn watch_draw(context: &mut Context, note: DrawNote) {
    watch(context, CommandNote::Draw(Box::new(note)));
}

/// Notes that the next commands of the open pass, which is watched, are clears.
pub(crate) fn watch_clear(context: &mut Context) {
    watch(context, CommandNote::Clear);
}

pub(crate) fn watch(context: &mut Context, note: CommandNote) {
    let Some(watched) = &mut context.watched else { return };
    let label = watched.notes.len() as u32;
    watched.notes.push(note);
    context.recorder.push(Command::Watch(watched.watch.labelled(label)));
}
