//! Plans of buffer textures, whose texels are fetched and never filtered (`ARB_texture_buffer_object`).

use super::SamplePlan;
use super::texture::{Alpha, LevelSelection, SampleKernel, TexelPath, Texture, WhyGeneral};
use crate::image::{Level, Shape};
use crate::sampler::{DepthMode, Filter, Seamless, Swizzle, Wrap};
use std::sync::Arc;

impl SamplePlan {
    /// The plan of a buffer texture: a one-dimensional image of any length.
    pub fn for_buffer_texture(level: Level) -> Self {
        let (shape, format, size) = (Shape::D1, level.format, level.size());
        let why = "texels are fetched by their numbers";
        let level_selection =
            LevelSelection::Fixed { filter: Filter::Nearest, level: 0, why, bias: 0.0 };
        Self(Ok(Texture {
            shape,
            format,
            size,
            scale: size.map(|side| shape.scale(side)),
            level_count: 1,
            levels: vec![vec![Arc::new(level)]],
            wrap: [Wrap::ClampToEdge; 3],
            seamless: Seamless::Off,
            border: [0.0; 4],
            compare: None,
            depth_mode: DepthMode::Luminance,
            swizzle: Swizzle::IDENTITY,
            texel_path: TexelPath::General,
            alpha: Alpha::Stored,
            direct: None,
            is_fusible: false,
            has_fusible_texels: false,
            kernel: SampleKernel::General(WhyGeneral::Fetch),
            level_selection,
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format::Format;
    use crate::image::MAX_SIZE;
    use crate::lanes::{F32s, I32s, Isa};

    #[test]
    fn a_buffer_texture_is_as_long_as_its_bytes_and_zero_beyond() {
        let count = 4 * MAX_SIZE as i32;
        let bytes: Vec<u8> = (0..count).flat_map(|i| (i as u16).to_le_bytes()).collect();
        // An incomplete texel at the end does not count.
        for (bytes, most, len) in [
            (&bytes[..], u32::MAX, count),
            (&bytes[..bytes.len() - 1], u32::MAX, count - 1),
            (&bytes[..], 50_000, 50_000),
            (&bytes[..], 5, 5),
            (&[7], u32::MAX, 0),
            (&[], u32::MAX, 0),
        ] {
            let level = Level::of_buffer_texture(Format::R16UI, bytes, most).expect("memory");
            let plan = SamplePlan::for_buffer_texture(level);
            let (zero, size) = (I32s::ZERO, I32s::splat(len));
            assert_eq!(plan.size(&zero), [size, I32s::splat(1), I32s::splat(1)]);
            let indices = [0, 1, 4, 5, len - 2, len - 1, len, len + 1, -1, i32::MIN, i32::MAX];
            let at = I32s::from_fn(|lane| indices[lane % indices.len()]);
            for isa in Isa::available() {
                let mut out = [F32s::splat(9.0); 4];
                plan.fetch(isa, [&at, &zero, &zero], &zero, [0; 3], &mut out);
                for (lane, &index) in indices.iter().enumerate() {
                    let inside = (0..len).contains(&index);
                    let want = if inside { [index as u32 & 0xFFFF, 0, 0, 1] } else { [0; 4] };
                    assert_eq!(out.each_ref().map(|c| c[lane].to_bits()), want, "{index} of {len}");
                }
            }
        }
    }
}
