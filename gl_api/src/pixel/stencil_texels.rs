//! The stencil values of images that have depth and stencil, to be sampled (`ARB_stencil_texturing`).

use texunit::format::Format;
use texunit::image::{Image, Level};

/// The image with the stencil values of each level as unsigned integers; levels without stencil, and those for which there
/// is no memory, as they are.
pub(crate) fn stencil_texels(image: &Image) -> Image {
    let mut stencil = image.clone();
    for face in 0..image.shape().faces() {
        for number in 0.. {
            let Some(level) = image.level(face, number) else { break };
            if let Some(level) = stencil_level(level) {
                // It has the size of the one that it replaces.
                let _ = stencil.set_level(face, number, level);
            }
        }
    }
    stencil
}

fn stencil_level(level: &Level) -> Option<Level> {
    // The byte of the stencil in a texel.
    let field = level.format.info().stencil;
    if field.bits == 0 {
        return None;
    }
    let at = 4 * field.word + field.shift as usize / 8;
    let mut stencil = Level::with_size(Format::R8UI, level.size(), level.border).ok()?;
    let texels = level.texels.chunks_exact(level.format.bytes());
    let [width, height, depth] = stencil.stored_size().map(|side| side as usize);
    let count = width * height * depth;
    for (to, texel) in stencil.texels[..count].iter_mut().zip(texels) {
        *to = texel[at];
    }
    Some(stencil)
}
