//! The keys of the generated stages: which state changes their code, and how.

use crate::base::clamp::Clamp;
use crate::context::Context;
use crate::context::recorder::fixed_function::UnitSummary;
use crate::draw::alpha_test::alpha_test;
use crate::draw::material::material;
use crate::draw::no_effect;
use crate::draw::sampler::sampler;
use crate::draw::warnings;
use crate::generate::fixed::environment::{Environment, environment_base};
use crate::generate::fixed::fog::FogKey;
use crate::generate::fixed::fragment::{Coordinates, FragmentKey, UnitKey};
use crate::generate::fixed::light::{LightKey, LightPosition, LightingKey, Spot, Varying};
use crate::generate::fixed::vertex::{Generated, Normals, PointSize, VertexKey};
use crate::interface::*;
use crate::objects::target::TextureTarget;
use crate::pixel::texel::is_wide;
use crate::state::enable::Flag;
use crate::state::fog::FogSource;
use crate::state::light::{ColorControl, Light};
use crate::state::material::{MaterialParameter, column};
use crate::state::texture_units::Unit;
use crate::state::texture_units::texgen::GenMode;
use glam::{DMat4, DVec4};
use rasterizer::driver::{Antialiasing, LevelInfo, VertexBinding, VertexSource};
use std::sync::Arc;
use texunit::format::BaseFormat;

/// Brings what is known of the texture units up to date.
pub(crate) fn update_unit_summary(context: &mut Context) {
    let version = context.state.units.units.version();
    if context.recorder.unit_summary.version != version {
        let units = (0..).zip(&context.state.units.units[..MAX_TEXTURE_UNITS.into()]);
        let enabled = |(bit, unit): (u8, &Arc<Unit>)| u8::from(unit.enabled.contains(&true)) << bit;
        let enabled = units.map(enabled).fold(0, |all, unit| all | unit);
        context.recorder.unit_summary =
            UnitSummary { version, enabled, generated: generated(context) };
    }
}

/// The vertex stage for the current state. `base` is its first uniform word.
pub(crate) fn vertex_key(context: &Context, vertices: &[VertexBinding], base: u32) -> VertexKey {
    let state = &context.state;
    let mut matrices = 0;
    for (unit, stack) in state.matrices.texture.iter().enumerate() {
        matrices |= u8::from(stack.top != DMat4::IDENTITY) << unit;
    }
    let mut key = VertexKey {
        base,
        matrices,
        generated: context.recorder.unit_summary.generated,
        lighting: lighting_key(context, vertices),
        normals: Normals::Unnormalized,
        clip_planes: state.clip.enabled,
        fog: state.fog.source,
        point_size: match state.raster.points.attenuates() {
            true => PointSize::Attenuated,
            false => PointSize::Constant,
        },
        clamp: crate::draw::color_clamp::of_vertices(context),
    };
    if state.enables.has(Flag::Normalize) && key.reads_normals() {
        key.normals = Normals::Normalized;
    }
    key
}

pub(crate) fn generated(context: &Context) -> [[Option<Generated>; 4]; MAX_TEXTURE_UNITS as usize] {
    let units = &context.state.units.units;
    std::array::from_fn(|unit| {
        std::array::from_fn(|coord| {
            let generate = &units[unit].generate[coord];
            generate.enabled.then_some(match generate.mode {
                GenMode::ObjectLinear | GenMode::EyeLinear => Generated::Linear,
                GenMode::SphereMap => Generated::SphereMap,
                GenMode::ReflectionMap => Generated::ReflectionMap,
                GenMode::NormalMap => Generated::NormalMap,
            })
        })
    })
}

/// How vertices are lit, if they are.
fn lighting_key(context: &Context, vertices: &[VertexBinding]) -> Option<LightingKey> {
    let state = &context.state;
    if !state.enables.has(Flag::Lighting) {
        return None;
    }
    let materials = [Side::Front, Side::Back].map(|side| varying(context, vertices, side));
    let model = &state.lights.model;
    let two_sided = no_effect::lights_two_sides(context);
    let sides: &[Side] = if two_sided { &[Side::Front, Side::Back] } else { &[Side::Front] };
    let has_specular = sides.iter().zip(&materials).any(|(&side, varying)| {
        varying.specular.is_some() || is_colored(material(context, side).specular)
    });
    let lights = std::array::from_fn(|index| {
        let light = &state.lights.lights[index];
        let on = state.lights.enabled >> index & 1 == 1 && !no_effect::light(context, light);
        let mut key = on.then(|| light_key(light))?;
        key.specular &= has_specular;
        Some(key)
    });
    let specular = lights.iter().flatten().any(|light: &LightKey| light.specular);
    Some(LightingKey {
        lights,
        local_viewer: specular && model.local_viewer,
        two_sided,
        separate_specular: specular && model.color_control == ColorControl::Separate,
        materials,
    })
}

fn is_colored(color: [f32; 4]) -> bool {
    color[..3].iter().any(|component| *component != 0.0)
}

fn light_key(light: &Light) -> LightKey {
    LightKey {
        position: match light.is_local() {
            false => LightPosition::Infinite,
            true if light.attenuation == [1.0, 0.0, 0.0] => LightPosition::Local,
            true => LightPosition::Attenuated,
        },
        spot: match (light.spot_cutoff, light.spot_exponent) {
            (180.0, _) => Spot::Off,
            (_, 0.0) => Spot::Even,
            (_, _) => Spot::Focused,
        },
        specular: is_colored(light.specular),
    }
}

/// The parts of a side's material that vary by vertex: those that track a colour that varies, and those that
/// `glMaterial` set between `glBegin` and `glEnd`. A colour that is constant over the draw is in the material's words
/// instead.
pub(crate) fn varying(context: &Context, vertices: &[VertexBinding], side: Side) -> Varying {
    let varies = |location: u8| {
        vertices.iter().any(|binding| {
            binding.location == location && matches!(binding.source, VertexSource::Array { .. })
        })
    };
    let materials = &context.state.materials;
    let tracked = (context.state.enables.has(Flag::ColorMaterial) && materials.faces.has(side))
        .then_some(materials.tracked);
    let of_color = varies(ATTRIB_COLOR).then_some(ATTRIB_COLOR);
    // Columns of materials come behind all others.
    let any = vertices.last().is_some_and(|binding| binding.location >= ATTRIB_MATERIAL);
    let own = |part: MaterialParameter| match tracked {
        Some(tracked) if tracked.has(part) => of_color,
        Some(_) | None => any.then(|| column(side, part)).filter(|&location| varies(location)),
    };
    Varying {
        emission: own(MaterialParameter::Emission),
        ambient: own(MaterialParameter::Ambient),
        diffuse: own(MaterialParameter::Diffuse),
        specular: own(MaterialParameter::Specular),
        shininess: own(MaterialParameter::Shininess),
    }
}

/// The fragment stage for the current state. `vertices` are those of the fixed-function vertex
/// stage, where it runs.
pub(crate) fn fragment_key(
    context: &mut Context,
    vertices: Option<&[VertexBinding]>,
    base: u32,
    clamp: Clamp,
) -> FragmentKey {
    let units = enabled_units(context, vertices, clamp);
    let state = &context.state;
    let model = &state.lights.model;
    let lit = vertices.is_some() && state.enables.has(Flag::Lighting);
    // Section 3.9: lighting sums what it separates, whatever GL_COLOR_SUM says.
    let color_sum = if lit {
        model.color_control == ColorControl::Separate
    } else {
        state.enables.has(Flag::ColorSum)
            && !vertices.is_some_and(|vertices| no_effect::color_sum(context, vertices))
    };
    let source = if vertices.is_some() { state.fog.source } else { FogSource::Coordinate };
    let facts = context.recorder.facts;
    let keeps_alpha = vertices.is_some() && units.iter().all(keeps_alpha);
    let passes = facts.alpha_passes && keeps_alpha;
    context.recorder.is_opaque = facts.alpha_is_one && keeps_alpha;
    let state = &context.state;
    FragmentKey {
        base,
        shade_model: state.raster.shade_model,
        two_sided: vertices.is_some() && no_effect::lights_two_sides(context),
        color_sum,
        fog: (state.enables.has(Flag::Fog) && !no_effect::fog(context) && !facts.is_before_fog)
            .then_some(FogKey { mode: state.fog.mode, source }),
        alpha: alpha_test(context).filter(|_| !passes),
        units,
        antialiasing: Antialiasing::Aliased,
        clamp,
    }
}

/// Whether alpha after a unit is that before it.
fn keeps_alpha(unit: &UnitKey) -> bool {
    let has_alpha = match unit.base {
        BaseFormat::Luminance | BaseFormat::Red | BaseFormat::Rg | BaseFormat::Rgb => false,
        BaseFormat::Alpha
        | BaseFormat::LuminanceAlpha
        | BaseFormat::Intensity
        | BaseFormat::Rgba
        | BaseFormat::Depth => true,
    };
    !has_alpha && matches!(unit.environment, Environment::Standard(_))
}

/// The active texture units: enabled, with a complete texture (GL 2.1, section 3.8.15).
fn enabled_units(
    context: &mut Context,
    vertices: Option<&[VertexBinding]>,
    clamp: Clamp,
) -> Vec<UnitKey> {
    let mut units = Vec::new();
    let enabled = context.recorder.unit_summary.enabled;
    for unit in (0..MAX_TEXTURE_UNITS).filter(|unit| enabled >> unit & 1 == 1) {
        let state = &context.state.units.units[usize::from(unit)];
        let winner = TextureTarget::ALL.into_iter().rfind(|target| state.enabled[*target as usize]);
        let Some(target) = winner else { continue };
        let texture = context.objects.texture(target, &state.bound[target as usize]);
        let sampler = sampler(context, unit, target);
        if let Some(reason) = texture.incomplete_reason(&sampler) {
            warnings::textures::incomplete(context, unit, target, &reason);
            continue;
        }
        let level = texture.image.level(0, sampler.base_level as usize);
        let Some(LevelInfo { format, .. }) = level else { continue };
        units.push(UnitKey {
            unit,
            environment: Environment::new(state.mode, &state.combiners),
            base: environment_base(format.base(), sampler.depth_mode),
            shape: target.shape(),
            compare: format.is_depth() && sampler.compare.is_some(),
            clamp: if is_wide(format) { clamp } else { Clamp::Off },
            coordinates: coordinates(context, unit, vertices),
        });
    }
    units
}

/// Whether a unit's q may be other than 1.
fn coordinates(context: &Context, unit: u8, vertices: Option<&[VertexBinding]>) -> Coordinates {
    let Some(vertices) = vertices else { return Coordinates::Projective };
    let state = &context.state;
    let place = usize::from(unit);
    if state.matrices.texture[place].top.row(3) != DVec4::W
        || state.units.units[place].generate[TexCoord::Q as usize].enabled
    {
        return Coordinates::Projective;
    }
    let location = ATTRIB_TEX_COORD + unit;
    let source = vertices.iter().find(|binding| binding.location == location);
    let projective = match source.map(|found| &found.source) {
        Some(VertexSource::Constant(value)) => value[3] != 1.0,
        Some(VertexSource::Array { components, .. }) => *components == 4,
        None => false,
    };
    if projective { Coordinates::Projective } else { Coordinates::Plain }
}
