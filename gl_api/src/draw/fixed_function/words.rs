//! The uniform words that generated stages read, computed in `f64` once a draw and rounded once to `f32`.

use crate::base::inverse::{inverse_3, rescale_factor};
use crate::context::Context;
use crate::context::recorder::fixed_function::{FixedWords, Lit, Normal, StageKeys, Transform};
use crate::draw::material::material;
use crate::draw::state_words::{put, scene_color};
use crate::generate::fixed::fog::constants as fog_constants;
use crate::generate::fixed::fragment::FragmentKey;
use crate::generate::fixed::light::{LightingKey, Varying};
use crate::generate::fixed::vertex::{Generated, PointSize, VertexKey};
use crate::generate::fixed::word;
use crate::interface::*;
use crate::state::enable::Flag;
use crate::state::light::Light;
use crate::state::material::Material;
use crate::state::texture_units::texgen::GenMode;
use glam::{DMat3, DMat4, DVec4};

impl FixedWords {
    /// The words for a draw, at least as many as its stages read.
    fn update(&mut self, context: &Context, keys: &StageKeys) {
        self.words.resize(word::COUNT as usize, 0);
        let reference = keys.clamp.component(context.state.fragment.alpha_ref);
        put(&mut self.words, word::ALPHA_REF, [reference.into()]);
        if let Some(key) = &keys.fragment {
            fragment(&mut self.words, context, key);
        }
        // Planes are in the space of the positions that they cut.
        clip_planes(&mut self.words, context, keys.clip_planes, keys.clip_space);
        if let Some(key) = &keys.vertex {
            self.transform(context);
            if key.reads_normals() {
                self.normal(context);
            }
            vertex(&mut self.words, context, key);
            if let Some(key) = key.lighting {
                self.lighting(context, key);
            }
        }
    }

    fn lighting(&mut self, context: &Context, key: LightingKey) {
        let state = &context.state;
        let color = state.current[usize::from(ATTRIB_COLOR)].map(f32::to_bits);
        let lit = Lit {
            key,
            versions: [state.lights.version(), state.materials.version()],
            color: state.enables.has(Flag::ColorMaterial).then_some(color),
        };
        if self.lit != Some(lit) {
            lighting(&mut self.words, context, &key);
            self.lit = Some(lit);
        }
    }

    fn transform(&mut self, context: &Context) {
        let matrices = &context.state.matrices;
        let (modelview, projection) = (matrices.modelview.top, matrices.projection.top);
        let transform = Transform { modelview, projection };
        if self.transform != Some(transform) {
            put(&mut self.words, word::MVP, (projection * modelview).to_cols_array());
            put(&mut self.words, word::MODELVIEW, modelview.to_cols_array());
            self.transform = Some(transform);
        }
    }

    /// The transposed inverse of the model-view matrix, with the factor of `GL_RESCALE_NORMAL`;
    /// normalizing makes that superfluous.
    fn normal(&mut self, context: &Context) {
        let modelview = context.state.matrices.modelview.top;
        let enables = &context.state.enables;
        let rescale = enables.has(Flag::RescaleNormal) && !enables.has(Flag::Normalize);
        let normal = Normal { modelview, rescale };
        if self.normal != Some(normal) {
            let inverse: DMat3 = inverse_3(modelview);
            let factor = if rescale { rescale_factor(&inverse) } else { 1.0 };
            put(&mut self.words, word::NORMAL, (inverse.transpose() * factor).to_cols_array());
            self.normal = Some(normal);
        }
    }
}

pub(crate) fn fragment(words: &mut [u32], context: &Context, key: &FragmentKey) {
    if key.fog.is_some() {
        let fog = &context.state.fog;
        let [red, green, blue, _] = key.clamp.color(fog.color).map(f64::from);
        let [density, start, end] = [fog.density, fog.start, fog.end].map(f64::from);
        let [factor, end_or_zero] = fog_constants(fog.mode, density, start, end);
        put(words, word::FOG, [red, green, blue, factor, end_or_zero]);
    }
    for unit in &key.units {
        let color = context.state.units.units[usize::from(unit.unit)].color;
        let color = key.clamp.color(color).map(f64::from);
        put(words, word::ENV_COLOR + 4 * u32::from(unit.unit), color);
    }
}

pub(crate) fn clip_planes(words: &mut [u32], context: &Context, enabled: u8, to_eye: DMat4) {
    for (plane, equation) in context.state.clip.planes.iter().enumerate() {
        if enabled >> plane & 1 == 1 {
            let plane = word::CLIP_PLANES + 4 * plane as u32;
            put(words, plane, (to_eye * *equation).to_array());
        }
    }
}

pub(crate) fn vertex(words: &mut [u32], context: &Context, key: &VertexKey) {
    let state = &context.state;
    let to_eye = state.matrices.modelview.top.transpose();
    clip_planes(words, context, key.clip_planes, to_eye);
    for (number, mode) in key.generated.iter().flatten().enumerate() {
        if *mode == Some(Generated::Linear) {
            let plane = object_plane(context, to_eye, number / 4, number % 4);
            put(words, word::PLANES + 4 * number as u32, plane.to_array());
        }
    }
    for (unit, stack) in state.matrices.texture.iter().enumerate() {
        if key.matrices >> unit & 1 == 1 {
            put(words, word::TEXTURE_MATRIX + 16 * unit as u32, stack.top.to_cols_array());
        }
    }
    if key.point_size == PointSize::Attenuated {
        let points = &state.raster.points;
        let sizes = [points.size, points.size_min, points.size_max];
        let all = sizes.into_iter().chain(points.attenuation);
        put(words, word::POINT, all.map(f64::from));
    }
}

fn lighting(words: &mut [u32], context: &Context, lighting: &LightingKey) {
    let state = &context.state;
    let ambient = state.lights.model.ambient;
    put(words, word::MODEL_AMBIENT, [ambient[0], ambient[1], ambient[2]].map(f64::from));
    let lights = || {
        let on = lighting.lights.iter().zip(&state.lights.lights).enumerate();
        on.filter(|(_, (key, _))| key.is_some()).map(|(index, (_, light))| (index, light))
    };
    for (index, light) in lights() {
        put_light(words, word::light(index), light);
    }
    let sides: &[Side] =
        if lighting.two_sided { &[Side::Front, Side::Back] } else { &[Side::Front] };
    for &side in sides {
        let own = lighting.varying(side);
        put_material(words, side, &material(context, side), own, ambient);
        let material = constant_parts(material(context, side), own);
        for (index, light) in lights() {
            put_products(words, word::products(index, side), light, &material);
        }
    }
}

/// The plane that a coordinate is generated by, in object coordinates.
fn object_plane(context: &Context, to_eye: DMat4, unit: usize, coord: usize) -> DVec4 {
    let generate = &context.state.units.units[unit].generate[coord];
    match generate.mode {
        GenMode::EyeLinear => to_eye * generate.eye_plane,
        GenMode::ObjectLinear
        | GenMode::SphereMap
        | GenMode::ReflectionMap
        | GenMode::NormalMap => generate.object_plane,
    }
}

fn put_light(words: &mut [u32], at: u32, light: &Light) {
    let derived = &light.derived;
    put(words, at, derived.position.to_array());
    put(words, at + 3, derived.half.to_array());
    put(words, at + 6, derived.spot_axis.to_array());
    put(words, at + 9, [derived.cos_cutoff, light.spot_exponent.into()]);
    put(words, at + 11, light.attenuation.map(f64::from));
}

/// A material with white in place of the parts that vary by vertex: products with it are the light's colours.
fn constant_parts(mut material: Material, own: Varying) -> Material {
    if own.ambient.is_some() {
        material.ambient = [1.0; 4];
    }
    if own.diffuse.is_some() {
        material.diffuse = [1.0; 4];
    }
    if own.specular.is_some() {
        material.specular = [1.0; 4];
    }
    material
}

/// Writes a side's scene colour without the parts that vary by vertex, with alpha, and its shininess.
fn put_material(
    words: &mut [u32],
    side: Side,
    material: &Material,
    own: Varying,
    ambient: [f32; 4],
) {
    let mut material = material.clone();
    if own.emission.is_some() {
        material.emission = [0.0; 4];
    }
    if own.ambient.is_some() {
        material.ambient = [0.0; 4];
    }
    let at = word::material(side);
    put(words, at, scene_color(&material, ambient));
    put(words, at + 4, [material.shininess.into()]);
}

/// Writes the products of a light's colours and a material's.
fn put_products(words: &mut [u32], at: u32, light: &Light, material: &Material) {
    let pairs = [
        (light.ambient, material.ambient),
        (light.diffuse, material.diffuse),
        (light.specular, material.specular),
    ];
    let products = pairs.into_iter().flat_map(|(light, material)| {
        [0, 1, 2].map(|i| f64::from(light[i]) * f64::from(material[i]))
    });
    put(words, at, products);
}

/// Appends what a draw's stages read of the words, up to the last one of them.
pub(crate) fn append(context: &mut Context, words: &mut Vec<u32>, keys: &StageKeys) {
    let mut fixed = std::mem::take(&mut context.recorder.fixed_words);
    fixed.update(context, keys);
    let count = (keys.needed as usize).saturating_sub(words.len()).min(fixed.words.len());
    words.extend_from_slice(&fixed.words[..count]);
    context.recorder.fixed_words = fixed;
}
