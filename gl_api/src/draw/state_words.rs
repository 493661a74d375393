//! The uniform words of the GL state that programs read (GLSL 1.30, section 7.4).

use crate::base::inverse::{inverse, inverse_3, rescale_factor};
use crate::context::Context;
use crate::draw::completeness::{draw_pass, samples};
use crate::draw::material::material;
use crate::interface::*;
use crate::state::light::Light;
use crate::state::material::Material;
use glam::DMat4;

/// A matrix of the state, in one of its forms.
fn matrix(context: &Context, matrix: StateMatrix, form: MatrixForm) -> DMat4 {
    let matrices = &context.state.matrices;
    let plain = match matrix {
        StateMatrix::ModelView => matrices.modelview.top,
        StateMatrix::Projection => matrices.projection.top,
        StateMatrix::ModelViewProjection => matrices.projection.top * matrices.modelview.top,
        StateMatrix::Texture(unit) => {
            matrices.texture.get(usize::from(unit)).map_or(DMat4::IDENTITY, |stack| stack.top)
        }
        StateMatrix::Program(number) => {
            matrices.program.get(usize::from(number)).map_or(DMat4::IDENTITY, |stack| stack.top)
        }
    };
    match form {
        MatrixForm::Plain => plain,
        MatrixForm::Inverse => inverse(plain),
        MatrixForm::Transpose => plain.transpose(),
        MatrixForm::InverseTranspose => inverse(plain).transpose(),
    }
}

/// Writes numbers as `f32` words from word `first` on; those past the end are left out.
pub(crate) fn put(words: &mut [u32], first: u32, values: impl IntoIterator<Item = f64>) {
    let Some(words) = words.get_mut(first as usize..) else { return };
    for (word, value) in words.iter_mut().zip(values) {
        *word = (value as f32).to_bits();
    }
}

/// The components of colours, in order.
fn colors<const N: usize>(colors: [[f32; 4]; N]) -> impl Iterator<Item = f64> {
    colors.into_iter().flatten().map(f64::from)
}

/// The product of a light's colour and a material's. Alpha is the material's, as in what lighting
/// produces (GL 2.1, section 2.14.1): shaders that add products up rely on it.
fn product(light: [f32; 4], material: [f32; 4]) -> [f32; 4] {
    let color = |i: usize| (f64::from(light[i]) * f64::from(material[i])) as f32;
    [color(0), color(1), color(2), material[3]]
}

/// The emission and the product of the ambient colours; alpha is the material's.
pub(crate) fn scene_color(material: &Material, ambient: [f32; 4]) -> [f64; 4] {
    let color = |i: usize| {
        f64::from(material.emission[i]) + f64::from(material.ambient[i]) * f64::from(ambient[i])
    };
    [color(0), color(1), color(2), material.diffuse[3].into()]
}

/// `gl_LightSource` of a light.
fn light(words: &mut [u32], first: u32, light: &Light) {
    let direction = light.spot_direction.to_array();
    let [constant, linear, quadratic] = light.attenuation.map(f64::from);
    put(words, first, colors([light.ambient, light.diffuse, light.specular]));
    put(words, first + 12, light.position.to_array());
    // No specification defines its w; other drivers have 1.
    put(words, first + 16, light.derived.half.extend(1.0).to_array());
    put(words, first + 20, direction);
    put(
        words,
        first + 23,
        [
            light.spot_exponent.into(),
            light.spot_cutoff.into(),
            light.derived.cos_cutoff,
            constant,
            linear,
            quadratic,
        ],
    );
}

fn put_state(context: &Context, words: &mut [u32], binding: StateBinding) {
    let StateBinding { var, word } = binding;
    let state = &context.state;
    match var {
        StateVar::Matrix(which, form) => {
            put(words, word, matrix(context, which, form).to_cols_array());
        }
        StateVar::NormalMatrix => {
            let inverse = inverse_3(state.matrices.modelview.top);
            put(words, word, inverse.transpose().to_cols_array());
        }
        StateVar::DepthRange => {
            let [near, far] = state.viewport.first.depth;
            put(words, word, [near, far, far - near]);
        }
        StateVar::TextureEnvColor(unit) => {
            if let Some(unit) = state.units.units.get(usize::from(unit)) {
                put(words, word, colors([unit.color]));
            }
        }
        StateVar::NormalScale => {
            let inverse = inverse_3(state.matrices.modelview.top);
            put(words, word, [rescale_factor(&inverse)]);
        }
        StateVar::Point => {
            let points = &context.state.raster.points;
            let limits = [points.size, points.size_min, points.size_max, points.fade];
            let all = limits.into_iter().chain(points.attenuation);
            put(words, word, all.map(f64::from));
        }
        StateVar::FramebufferHeight => {
            let height = draw_pass(context).map_or(0, |pass| pass.height);
            put(words, word, [height.into()]);
        }
        StateVar::SampleCount => {
            let samples = samples(context, state.bindings.draw_framebuffer);
            words[word as usize] = u32::from(samples.max(1));
        }
        StateVar::ClipPlane(plane) => {
            if let Some(plane) = state.clip.planes.get(usize::from(plane)) {
                put(words, word, plane.to_array());
            }
        }
        StateVar::ClipEnables => {
            let enabled = |plane: u8| f64::from(state.clip.enabled >> plane & 1);
            put(words, word, (0..8).map(enabled));
        }
        StateVar::Material(side) => {
            let Material { emission, ambient, diffuse, specular, shininess, indexes: _ } =
                material(context, side);
            put(words, word, colors([emission, ambient, diffuse, specular]));
            put(words, word + 16, [shininess.into()]);
        }
        StateVar::Light(index) => {
            if let Some(source) = state.lights.lights.get(usize::from(index)) {
                light(words, word, source);
            }
        }
        StateVar::LightModel => put(words, word, colors([state.lights.model.ambient])),
        StateVar::LightModelProduct(side) => {
            put(words, word, scene_color(&material(context, side), state.lights.model.ambient));
        }
        StateVar::LightProduct(side, index) => {
            if let Some(light) = state.lights.lights.get(usize::from(index)) {
                let material = material(context, side);
                let products = [
                    product(light.ambient, material.ambient),
                    product(light.diffuse, material.diffuse),
                    product(light.specular, material.specular),
                ];
                put(words, word, colors(products));
            }
        }
        StateVar::TexGen(plane, coord, unit) => {
            if let Some(unit) = state.units.units.get(usize::from(unit)) {
                let generate = &unit.generate[coord as usize];
                let plane = match plane {
                    TexGenPlane::Eye => generate.eye_plane,
                    TexGenPlane::Object => generate.object_plane,
                };
                put(words, word, plane.to_array());
            }
        }
        StateVar::Fog => {
            let fog = &state.fog;
            let (start, end) = (f64::from(fog.start), f64::from(fog.end));
            put(words, word, colors([fog.color]));
            put(words, word + 4, [fog.density.into(), start, end, 1.0 / (end - start)]);
        }
    }
}

/// Writes the state that a program reads into its words.
pub(crate) fn put_bindings(context: &Context, words: &mut [u32], bindings: &[StateBinding]) {
    for &binding in bindings {
        put_state(context, words, binding);
    }
}
