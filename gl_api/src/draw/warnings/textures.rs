//! Warnings of textures: bound where a draw does not sample, incomplete, not compared, or sampled while drawn to.

use crate::base::constants::*;
use crate::base::types::GLuint;
use crate::context::Context;
use crate::context::warnings::DrawWarning;
use crate::draw::assembly_words::has_fragment_program;
use crate::generate::fixed::fragment::FragmentKey;
use crate::interface::{ATTRIB_TEX_COORD, MAX_COMBINED_TEXTURE_IMAGE_UNITS, MAX_TEXTURE_UNITS};
use crate::objects::bound::Bound;
use crate::objects::color_buffers::attachment_index;
use crate::objects::framebuffers::{Attached, Source};
use crate::objects::target::{TARGET, TextureTarget};
use crate::state::enable::{CAPABILITY, Flag};
use crate::state::texture_units::Unit;
use rasterizer::driver::{DepthWrite, Image, LevelInfo, VertexBinding, VertexSource};
use rasterizer::ir::{TextureDecl, Ty};
use std::iter::zip;
use texunit::sampler::{Mipmap, Sampler};

/// GL's name of a target.
fn target_name(target: TextureTarget) -> String {
    enum_name(TARGET.encode(target))
}

/// Where a texture is bound that a draw looks for at another target or unit.
enum Elsewhere {
    /// To another target of the unit.
    Target(GLuint, TextureTarget),
    /// To the target of another unit.
    Unit(GLuint, u8),
    Nowhere,
}

/// Where the texture may be bound that was meant for a target of a unit; `None` if something is bound there.
fn elsewhere(context: &Context, unit: u8, target: TextureTarget) -> Option<Elsewhere> {
    let units = &context.state.units.units;
    let name = |unit: &Unit, target: TextureTarget| unit.bound[target as usize].name();
    let own = &units[usize::from(unit)];
    let default = context.objects.texture(target, &Bound::default());
    let has_image = target != TextureTarget::Buffer && default.image.level(0, 0).is_some();
    if name(own, target) != 0 || has_image {
        return None;
    }
    if let Some(other) = TextureTarget::ALL.into_iter().find(|other| name(own, *other) != 0) {
        return Some(Elsewhere::Target(name(own, other), other));
    }
    let others = units.iter().zip(0..MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    let mut others = others.map(|(state, other)| (name(state, target), other));
    let found = others.find(|&(name, _)| name != 0);
    Some(found.map_or(Elsewhere::Nowhere, |(name, other)| Elsewhere::Unit(name, other)))
}

/// Warns of an incomplete texture that the fixed function would sample: the unit is as if disabled.
#[cold]
#[inline(never)]
pub(crate) fn incomplete(context: &mut Context, unit: u8, target: TextureTarget, reason: &str) {
    let name = context.state.units.units[usize::from(unit)].bound[target as usize].name();
    let asked = target_name(target);
    let text = match elsewhere(context, unit, target) {
        None => format!(
            "draw: texture {name} on {asked} of unit {unit} is incomplete: {reason} (GL 2.1, section \
             3.8.10)"
        ),
        Some(Elsewhere::Target(other, place)) => {
            let place = target_name(place);
            format!(
                "draw: {asked} is enabled on unit {unit}, where it has no texture; texture {other} is \
                 bound to {place} there: call glEnable({place})"
            )
        }
        Some(Elsewhere::Unit(other, place)) => format!(
            "draw: {asked} is enabled on unit {unit}, where no texture is bound; texture {other} is \
             bound to {asked} of unit {place}: call glActiveTexture(GL_TEXTURE{unit}) before \
             glBindTexture, or glActiveTexture(GL_TEXTURE{place}) before glEnable"
        ),
        Some(Elsewhere::Nowhere) => format!(
            "draw: {asked} is enabled on unit {unit}, where no texture is bound: call glBindTexture"
        ),
    };
    context.debug.warn(text);
}

/// Warns of a sampler uniform whose unit has no complete texture, or one that is not compared.
pub(crate) fn sampler(
    context: &mut Context,
    unit: u8,
    target: TextureTarget,
    word: u32,
    decl: TextureDecl,
) {
    let bound = &context.state.units.units[usize::from(unit)].bound[target as usize];
    let state = crate::draw::sampler::sampler(context, unit, target);
    match context.objects.texture(target, bound).incomplete_reason(&state) {
        Some(reason) => reads_black(context, unit, target, word, &reason),
        None if decl.compare && state.compare.is_none() => {
            let name = bound.name();
            uncompared(context, name, target, word);
        }
        None => other_texels(context, (unit, target), word, decl),
    }
}

/// Warns of a sampler of numbers with a texture of integers, or the other way round: what it reads is undefined.
fn other_texels(
    context: &mut Context,
    (unit, target): (u8, TextureTarget),
    word: u32,
    decl: TextureDecl,
) {
    let bound = &context.state.units.units[usize::from(unit)].bound[target as usize];
    let texture = context.objects.texture(target, bound);
    let level = texture.sampler().base_level as usize;
    let Some(LevelInfo { format, .. }) = texture.image.level(0, level) else { return };
    let of_integers = decl.texels != Ty::F32;
    // Stencils are integers in a format of depths.
    if format.is_depth() || format.is_integer() == of_integers {
        return;
    }
    let name = bound.name();
    if context.is_first_warning(DrawWarning::OtherTexels, name) {
        let uniform = uniform_name(context, word);
        let (reads, has) = match of_integers {
            true => ("integers", "numbers that are none: declare a sampler"),
            false => ("numbers", "integers: declare an isampler or a usampler"),
        };
        context.debug.warn(format!(
            "draw: sampler{uniform} reads {reads}, and the texels of texture {name} are {has}, or give the texture \
             another internal format; what it reads is undefined (GLSL 1.30, section 8.7)"
        ));
    }
}

#[cold]
#[inline(never)]
fn reads_black(context: &mut Context, unit: u8, target: TextureTarget, word: u32, reason: &str) {
    let name = context.state.units.units[usize::from(unit)].bound[target as usize].name();
    let uniform = uniform_name(context, word);
    let asked = target_name(target);
    let who = match uniform.is_empty() {
        true => "the assembly program".to_owned(),
        false => format!("sampler{uniform}"),
    };
    let reads = format!("draw: {who} samples {asked} of unit {unit}");
    let text = match elsewhere(context, unit, target) {
        None => format!(
            "draw: {who} reads black, as texture {name} on {asked} of unit {unit} is \
             incomplete: {reason} (GL 2.1, section 3.8.10)"
        ),
        Some(Elsewhere::Target(other, place)) => format!(
            "{reads}, where nothing is bound; texture {other} is bound to {} there",
            target_name(place)
        ),
        Some(Elsewhere::Unit(mut other, mut place)) => {
            let units = context.state.units.units.iter();
            let mut units = units.zip(0..MAX_COMBINED_TEXTURE_IMAGE_UNITS);
            let is_name = |at: GLuint| unit != 0 && at == GLuint::from(unit);
            let named = units.find(|(at, _)| is_name(at.bound[target as usize].name()));
            let mut advice = String::new();
            if !uniform.is_empty() {
                if let Some((_, at)) = named {
                    (other, place) = (unit.into(), at);
                    advice =
                        "a sampler takes the unit's number, not the texture's name: ".to_owned();
                }
                advice.push_str(&format!("call glUniform1i(location of{uniform}, {place}), or "));
            }
            format!(
                "{reads}, which has no texture; texture {other} is bound to {asked} of unit {place}: \
                 {advice}call glActiveTexture(GL_TEXTURE{unit}) before glBindTexture"
            )
        }
        Some(Elsewhere::Nowhere) => {
            format!("{reads}, which has no texture, and reads black: call glBindTexture")
        }
    };
    context.debug.warn(text);
}

/// Warns of a shadow sampler with a texture that is not compared.
#[cold]
#[inline(never)]
fn uncompared(context: &mut Context, name: GLuint, target: TextureTarget, word: u32) {
    if !context.is_first_warning(DrawWarning::NoComparison, name) {
        return;
    }
    let (uniform, target) = (uniform_name(context, word), target_name(target));
    context.debug.warn(format!(
        "draw: sampler{uniform} compares, but GL_TEXTURE_COMPARE_MODE of texture {name} is GL_NONE, so \
         what it reads is undefined: call glTexParameteri({target}, GL_TEXTURE_COMPARE_MODE, \
         GL_COMPARE_REF_TO_TEXTURE) (GLSL 1.20, section 8.7)"
    ));
}

/// The uniform of the program in use that has this word, quoted, after a space.
fn uniform_name(context: &Context, word: u32) -> String {
    context.executable().map_or_else(String::new, |linked| linked.quoted_name(word))
}

/// Checks that somebody wrote the texels of a texture, when it is sampled for the first time since it was changed.
pub(crate) fn without_texels(
    context: &mut Context,
    (unit, target): (u8, TextureTarget),
    image: &Image,
) {
    let bound = &context.state.units.units[usize::from(unit)].bound[target as usize];
    let texture = context.objects.texture(target, bound);
    if !texture.is_planned() && image.is_untouched() {
        let name = bound.name();
        untouched(context, (unit, target), name);
    }
}

#[cold]
#[inline(never)]
fn untouched(context: &mut Context, (unit, target): (u8, TextureTarget), name: GLuint) {
    if context.is_first_warning(DrawWarning::NoTexels, name) {
        let target = target_name(target);
        context.debug.warn(format!(
            "draw: texture {name} on {target} of unit {unit} has no texels: it was made without data (NULL), and nothing was \
             uploaded, copied or drawn to it, so it is black: call glTexSubImage* with texels, or draw to it before (GL \
             2.1, section 3.8.1)"
        ));
    }
}

/// Warns of a texture that a draw samples and may draw to (GL 3.1, section 4.4.3).
pub(crate) fn feedback_loop(
    context: &mut Context,
    place: (u8, TextureTarget),
    image: &Image,
    sampler: &Sampler,
) {
    let framebuffer = context.state.bindings.draw_framebuffer;
    let Some(object) = context.objects.framebuffers.get(framebuffer) else { return };
    if object.attached().any(|attached| attached.image.is_same_image(image)) {
        maybe_loop(context, place, image, sampler);
    }
}

/// It is a feedback loop if a level that is sampled is drawn to. `glTextureBarrierNV` counts as the warning given.
#[cold]
#[inline(never)]
fn maybe_loop(
    context: &mut Context,
    (unit, target): (u8, TextureTarget),
    image: &Image,
    sampler: &Sampler,
) {
    let framebuffer = context.state.bindings.draw_framebuffer;
    let Some(object) = context.objects.framebuffers.get(framebuffer) else { return };
    let last = if sampler.mipmap == Mipmap::None { sampler.base_level } else { sampler.max_level };
    let levels = sampler.base_level as usize..=last as usize;
    let sampled = |attached: &Option<Attached>| {
        attached.as_ref().is_some_and(|attached| match attached.source {
            Source::Texture { level, .. } => {
                attached.image.is_same_image(image) && levels.contains(&level)
            }
            Source::Renderbuffer(_) => false,
        })
    };
    let fragment = &context.state.fragment;
    let color = zip(&object.selection.draw, fragment.buffers.iter()).any(|(&buffer, state)| {
        let index = attachment_index(buffer).filter(|_| state.mask.contains(&true));
        index.is_some_and(|index| sampled(&object.colors[index]))
    });
    let tests = context.state.enables.has(Flag::DepthTest);
    let depth = tests && fragment.depth_write == DepthWrite::On && sampled(&object.depth);
    if (color || depth) && context.is_first_warning(DrawWarning::FeedbackLoop, 0) {
        let name = context.state.units.units[usize::from(unit)].bound[target as usize].name();
        context.debug.warn(format!(
            "draw: texture {name} is sampled and drawn to, as it is attached to framebuffer \
             {framebuffer}: what is read is undefined, but for what glTextureBarrierNV promises; draw to \
             another texture, or call glBindFramebuffer (GL 3.1, section 4.4.3)"
        ));
    }
}

/// Warns of textures that are bound while no unit is enabled and no program is in use, unless the client switched the
/// unit itself. It is checked again only when the units have changed.
pub(crate) fn nothing_enabled(context: &mut Context) {
    if context.has_program() || has_fragment_program(context) {
        return;
    }
    let units = &context.state.units.units;
    let now = (units.version(), context.debug.output);
    if context.recorder.nothing_enabled.replace(now) == Some(now) {
        return;
    }
    if units.iter().any(|unit| unit.enabled.contains(&true)) {
        return;
    }
    let switched = context.units_switched;
    let bound = units.iter().zip(0..MAX_COMBINED_TEXTURE_IMAGE_UNITS).find_map(|(unit, number)| {
        let is_known = number < MAX_TEXTURE_UNITS && switched >> number & 1 == 1;
        if is_known || unit.bound.iter().all(|bound| bound.name() == 0) {
            return None;
        }
        // The default texture may be set up for later draws: `unit_off` looks at the coordinates, too.
        set_up(context, unit)
            .filter(|(_, name)| *name != 0)
            .map(|(target, name)| (number, target, name))
    });
    let Some((unit, target, name)) = bound else { return };
    if context.is_first_warning(DrawWarning::TexturingOff, name) {
        let target = target_name(target);
        context.debug.warn(format!(
            "draw: texture {name} is bound to {target} of unit {unit}, but texturing is off: call \
             glEnable({target})"
        ));
    }
}

/// The texture that is set up at a unit for the fixed function: bound, or the default one with an image. A texture that
/// is drawn to is bound to be made.
fn set_up(context: &Context, unit: &Unit) -> Option<(TextureTarget, GLuint)> {
    TextureTarget::ALL.into_iter().find_map(|target| {
        // Targets that cannot be enabled are for shaders alone.
        CAPABILITY.get(TARGET.encode(target))?;
        let bound = &unit.bound[target as usize];
        let image = &context.objects.texture(target, bound).image;
        let is_set_up = bound.name() != 0 || image.level(0, 0).is_some();
        let is_attached = || {
            let mut framebuffers = context.objects.framebuffers.values();
            framebuffers.any(|object| object.attached().any(|at| at.image.is_same_image(image)))
        };
        (is_set_up && !is_attached()).then_some((target, bound.name()))
    })
}

/// Checks the units that are not enabled: one that has a texture, is given coordinates and was never switched on or off by
/// the client was forgotten, perhaps.
pub(crate) fn unit_off(context: &mut Context, vertices: &[VertexBinding], fragment: &FragmentKey) {
    let given = |unit: u8| {
        vertices.iter().any(|binding| {
            binding.location == ATTRIB_TEX_COORD + unit
                && matches!(binding.source, VertexSource::Array { .. })
        })
    };
    let known = context.recorder.unit_summary.enabled | context.units_switched;
    let off = (0..MAX_TEXTURE_UNITS).find(|&unit| known >> unit & 1 == 0 && given(unit));
    let Some(unit) = off else { return };
    // Of bound textures where no unit is enabled, `nothing_enabled` warns.
    if let Some((target, name)) = set_up(context, &context.state.units.units[usize::from(unit)])
        && (name == 0 || !fragment.units.is_empty())
        && context.is_first_warning(DrawWarning::UnitOff, unit.into())
    {
        let target = target_name(target);
        context.debug.warn(format!(
            "draw: texture {name} is bound to {target} of unit {unit}, which is given texture coordinates, but it is off: \
             call glActiveTexture(GL_TEXTURE{unit}) and glEnable({target}) (GL 2.1, section 3.8.16)"
        ));
    }
}
