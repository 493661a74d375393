//! The uniform words of a draw: a program's uniforms and the state that its stages read.

use crate::context::{Context, limits};
use crate::fixed::word;
use crate::framebuffer::complete::draw_pass;
use crate::interface::*;
use glam::{DMat3, DMat4};

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
    };
    match form {
        MatrixForm::Plain => plain,
        MatrixForm::Inverse => plain.inverse(),
        MatrixForm::Transpose => plain.transpose(),
        MatrixForm::InverseTranspose => plain.inverse().transpose(),
    }
}

/// Writes numbers as `f32` words from a place on; what lies beyond the end is left out.
fn put(words: &mut [u32], first: u32, values: impl IntoIterator<Item = f64>) {
    let Some(words) = words.get_mut(first as usize..) else { return };
    for (word, value) in words.iter_mut().zip(values) {
        *word = (value as f32).to_bits();
    }
}

/// The initial value of state that no call changes (GL 2.1, tables 6.9 to 6.14 and 6.17).
fn initial(var: StateVar) -> Vec<f64> {
    let gray = |value: f64| [value, value, value, 1.0];
    let (black, none, white) = (gray(0.0), [0.0; 4], gray(1.0));
    let (ambient, diffuse, scene) = (gray(0.2), gray(0.8), gray(0.04));
    match var {
        StateVar::Material(_) => {
            [black, ambient, diffuse, black].concat().into_iter().chain([0.0]).collect()
        }
        StateVar::Light(light) => {
            let color = if light == 0 { white } else { black };
            let toward = [0.0, 0.0, 1.0, 0.0];
            let spot = [0.0, 0.0, -1.0, 0.0, 180.0, -1.0, 1.0, 0.0, 0.0];
            [black, color, color, toward, toward].concat().into_iter().chain(spot).collect()
        }
        StateVar::LightModel => ambient.into(),
        StateVar::LightModelProduct(_) => scene.into(),
        StateVar::LightProduct(_, light) => {
            let lit = if light == 0 { diffuse } else { black };
            [black, lit, black].concat()
        }
        StateVar::TexGen(_, TexCoord::S, _) => vec![1.0, 0.0, 0.0, 0.0],
        StateVar::TexGen(_, TexCoord::T, _) => vec![0.0, 1.0, 0.0, 0.0],
        StateVar::TexGen(_, TexCoord::R | TexCoord::Q, _) | StateVar::ClipPlane(_) => none.into(),
        StateVar::Fog => none.into_iter().chain([1.0, 0.0, 1.0, 1.0]).collect(),
        StateVar::Matrix(..)
        | StateVar::NormalMatrix
        | StateVar::DepthRange
        | StateVar::TextureEnvColor(_)
        | StateVar::NormalScale
        | StateVar::ClipEnables
        | StateVar::FramebufferHeight
        | StateVar::Point => vec![0.0; var.words() as usize],
    }
}

fn put_state(context: &Context, words: &mut [u32], binding: StateBinding) {
    let StateBinding { var, word } = binding;
    match var {
        StateVar::Matrix(which, form) => {
            put(words, word, matrix(context, which, form).to_cols_array());
        }
        StateVar::NormalMatrix => {
            let upper = DMat3::from_mat4(context.state.matrices.modelview.top);
            put(words, word, upper.inverse().transpose().to_cols_array());
        }
        StateVar::DepthRange => {
            let [near, far] = context.state.viewport.depth;
            put(words, word, [near, far, far - near]);
        }
        StateVar::TextureEnvColor(unit) => {
            let color = context
                .state
                .units
                .units
                .get(usize::from(unit))
                .map_or([0.0; 4], |unit| unit.color);
            put(words, word, color.map(f64::from));
        }
        StateVar::NormalScale => {
            let inverse = DMat3::from_mat4(context.state.matrices.modelview.top).inverse();
            put(words, word, [1.0 / inverse.row(2).length()]);
        }
        StateVar::Point => {
            let size = f64::from(context.state.raster.point_size);
            put(words, word, [size, 0.0, limits::MAX_WIDTH.into(), 1.0, 1.0, 0.0, 0.0]);
        }
        StateVar::FramebufferHeight => {
            let height = draw_pass(context).map_or(0, |pass| pass.height);
            put(words, word, [height.into()]);
        }
        StateVar::ClipPlane(_)
        | StateVar::ClipEnables
        | StateVar::Material(_)
        | StateVar::Light(_)
        | StateVar::LightModel
        | StateVar::LightModelProduct(_)
        | StateVar::LightProduct(..)
        | StateVar::TexGen(..)
        | StateVar::Fog => put(words, word, initial(var)),
    }
}

/// The state that a program reads, into its words.
pub(super) fn put_bindings(context: &Context, words: &mut [u32], bindings: &[StateBinding]) {
    for &binding in bindings {
        put_state(context, words, binding);
    }
}

/// The state that the fixed function reads, from word `base` on.
pub(super) fn put_fixed(context: &Context, words: &mut Vec<u32>, base: u32) {
    words.resize((base + word::COUNT) as usize, 0);
    let mut state = |var, word| {
        put_state(context, words, StateBinding { var, word: base + word });
    };
    state(StateVar::Matrix(StateMatrix::ModelViewProjection, MatrixForm::Plain), word::MVP);
    for unit in 0..MAX_TEXTURE_UNITS {
        let number = u32::from(unit);
        state(
            StateVar::Matrix(StateMatrix::Texture(unit), MatrixForm::Plain),
            word::TEXTURE_MATRIX + 16 * number,
        );
        state(StateVar::TextureEnvColor(unit), word::ENV_COLOR + 4 * number);
    }
    put(words, base + word::ALPHA_REF, [context.state.fragment.alpha_ref.into()]);
}
