//! Texels of attachments of all kinds, against the conversion of what a draw leaves in one of `f32`,
//! however fragments are put into batches.

use super::super::common::{bindings, fragment, pipeline, vertex};
use super::packing::{SIZE, TestDraw, inputs, picture, triangles};
use rasterizer::driver::{Blend, BlendEquation, BlendFactor, PipelineDesc, SrgbWrite};
use texunit::format::{Encoding, Format, convert};
use texunit::lanes::Isa;

/// Of one to four words, of words that are not whole, of every encoding of numbers.
const FORMATS: [Format; 16] = {
    use Format::{
        La16F, R5G6B5, R11G11B10F, R16F, Rg32F, Rgb5A1, Rgb8, Rgb10A2, Rgb32F, Rgba4, Rgba8,
        Rgba8Snorm, Rgba16, Rgba16F, Rgba32F, Srgb8A8,
    };
    [
        La16F, R5G6B5, R11G11B10F, R16F, Rg32F, Rgb5A1, Rgb8, Rgb10A2, Rgb32F, Rgba4, Rgba8,
        Rgba8Snorm, Rgba16, Rgba16F, Srgb8A8, Rgba32F,
    ]
};

fn draw(isa: Isa, desc: &PipelineDesc, target: Format, watched: bool) -> Vec<u8> {
    let vertices = &bindings(&triangles(), 2);
    let drawn = TestDraw { desc, textures: &[], vertices, count: 2700, target };
    let (mut bytes, _) = picture(isa, &drawn, watched);
    // Without the depths.
    bytes.truncate((SIZE * SIZE) as usize * target.bytes());
    bytes
}

/// The texel of a colour that is drawn: normalized numbers that have no sign round up at a half.
fn texel_of(format: Format, rgba: [f32; 4]) -> [u8; 16] {
    if format.info().encoding != Encoding::Unorm {
        return convert::encode(format, rgba);
    }
    let mut bytes = [0; 16];
    let mut texel = 0_u128;
    for (channel, &source) in format.base().sources().iter().enumerate() {
        let field = format.field(channel);
        let bits = (rgba[source].clamp(0.0, 1.0) * field.mask() as f32 + 0.5) as u128;
        texel |= bits << (32 * field.word as u32 + field.shift);
    }
    bytes.copy_from_slice(&texel.to_le_bytes());
    bytes
}

#[test]
fn a_texel_of_any_format_is_the_conversion_of_the_colour_that_is_drawn() {
    let mut desc = pipeline(vertex(4), fragment(4, inputs));
    desc.output.srgb = SrgbWrite::Encode;
    let colors = draw(Isa::BASELINE, &desc, Format::Rgba32F, true);
    let colors = colors.chunks(16).map(|texel| convert::decode(Format::Rgba32F, texel));
    for format in FORMATS {
        let size = format.bytes();
        let want: Vec<u8> =
            colors.clone().flat_map(|c| texel_of(format, c).into_iter().take(size)).collect();
        for isa in Isa::available() {
            for watched in [false, true] {
                let got = draw(isa, &desc, format, watched);
                assert!(got == want, "{format:?}, {}, watched {watched}", isa.name());
            }
        }
    }
}

#[test]
fn texels_of_any_format_are_blended_alike_however_they_are_packed() {
    use BlendFactor::{ConstantColor, DstAlpha, One, OneMinusSrcAlpha, SrcAlpha, SrcColor};
    let ways = [
        (BlendEquation::Add, [SrcAlpha; 2], [OneMinusSrcAlpha; 2]),
        (BlendEquation::Add, [One; 2], [One; 2]),
        (BlendEquation::ReverseSubtract, [SrcColor, DstAlpha], [One, ConstantColor]),
    ];
    for (equation, src, dst) in ways {
        let mut desc = pipeline(vertex(4), fragment(4, inputs));
        desc.output.srgb = SrgbWrite::Encode;
        let constant = [0.25, 0.5, 0.75, 1.5];
        desc.colors[0].blend = Some(Blend { equation: [equation; 2], src, dst, constant });
        for mask in [[true; 4], [true, false, true, true]] {
            desc.colors[0].mask = mask;
            for format in FORMATS {
                let want = draw(Isa::BASELINE, &desc, format, true);
                for isa in Isa::available() {
                    let got = draw(isa, &desc, format, false);
                    assert!(got == want, "{format:?}, {equation:?}, {mask:?}, {}", isa.name());
                }
            }
        }
    }
}
