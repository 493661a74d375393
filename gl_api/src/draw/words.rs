//! The uniform words of a draw: a program's uniforms and the state that its stages read.

use crate::context::Context;
use crate::fixed::word;
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
