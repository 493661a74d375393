//! Bytes of a texel as words, and stored channels as a colour.

use super::{BaseFormat, Component, Format};

/// The words of a texel. Bytes that are missing count as 0.
pub(crate) fn words_of(format: Format, texel: &[u8]) -> [u32; 4] {
    let mut bytes = [0; 16];
    for (to, from) in bytes.iter_mut().zip(texel.iter().take(format.bytes())) {
        *to = *from;
    }
    [0, 4, 8, 12].map(|i| u32::from_le_bytes([bytes[i], bytes[i + 1], bytes[i + 2], bytes[i + 3]]))
}

/// Words as bytes, little end first.
pub(super) fn bytes_of(words: [u32; 4]) -> [u8; 16] {
    let mut bytes = [0; 16];
    for (to, word) in bytes.chunks_exact_mut(4).zip(words) {
        to.copy_from_slice(&word.to_le_bytes());
    }
    bytes
}

/// Stored channels as the colour that a sample returns, depth as luminance.
pub fn expand(base: BaseFormat, channels: [f32; 4]) -> [f32; 4] {
    base.components().map(|component| match component {
        Component::Stored(channel) => channels[channel],
        Component::Zero => 0.0,
        Component::One => 1.0,
    })
}
