//! Stencil tests of whole blocks of large triangles give what those of single fragments give. In a tile with a watched
//! pixel fragments are tested one batch at a time, so a picture of one tile can be drawn both ways.

use super::super::Random;
use super::super::common::{bindings, device, fragment, image, pipeline, vertex, viewport};
use super::packing::SIZE;
use rasterizer::driver::{
    Attachment, ClearValue, Command, CommandBuffer, Cull, DepthState, DepthWrite, Image,
    MultisampleState, PassDesc, Pipeline, PipelineDesc, RasterState, Rect, SampleRule, StencilFace,
    StencilOp, StencilState, Watch,
};
use rasterizer::ir::Input;
use std::collections::BTreeSet;
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{Image as Texels, Level, Shape};
use texunit::lanes::Isa;
use texunit::sampler::Compare;

const DRAWS: usize = 60;

const TESTS: [Compare; 8] = [
    Compare::Never,
    Compare::Less,
    Compare::Equal,
    Compare::LessEqual,
    Compare::Greater,
    Compare::NotEqual,
    Compare::GreaterEqual,
    Compare::Always,
];

const OPS: [StencilOp; 8] = [
    StencilOp::Keep,
    StencilOp::Zero,
    StencilOp::Replace,
    StencilOp::Increment,
    StencilOp::Decrement,
    StencilOp::IncrementWrap,
    StencilOp::DecrementWrap,
    StencilOp::Invert,
];

fn one_of<T: Copy>(random: &mut Random, all: &[T]) -> T {
    all[random.next() as usize % all.len()]
}

/// A face, mostly one that stores a word or only compares. Few references, so that comparisons have both outcomes.
fn face(random: &mut Random) -> StencilFace {
    let reference = one_of(random, &[0, 1, 2, 0xFF]);
    let read_mask = one_of(random, &[0xFF, 0xFF, 3]);
    let compare = one_of(random, &TESTS);
    let keep = StencilFace {
        test: compare,
        reference,
        read_mask,
        write_mask: 0xFF,
        fail: StencilOp::Keep,
        depth_fail: StencilOp::Keep,
        pass: StencilOp::Keep,
    };
    match random.next() % 5 {
        0 | 1 => StencilFace { test: Compare::Always, pass: one_of(random, &OPS[1..3]), ..keep },
        2 | 3 => keep,
        _ => StencilFace {
            write_mask: one_of(random, &[0xFF, 0x0F]),
            fail: one_of(random, &OPS),
            depth_fail: one_of(random, &OPS),
            pass: one_of(random, &OPS),
            ..keep
        },
    }
}

/// A draw with random tests, for one triangle of any facing over much of the picture.
fn draw(random: &mut Random) -> [Command; 3] {
    let mut desc: PipelineDesc = pipeline(
        vertex(4),
        fragment(4, |b| [0, 1, 2, 3].map(|slot| b.input(Input::Varying(slot)))),
    );
    desc.cull = Cull::None;
    desc.output.stencil = Some(StencilState { front: face(random), back: face(random) });
    if !random.next().is_multiple_of(3) {
        let write = one_of(random, &[DepthWrite::On, DepthWrite::Off]);
        desc.depth = Some(DepthState { test: one_of(random, &TESTS[1..]), write });
    }
    if random.next().is_multiple_of(6) {
        desc.colors[0].mask = [false; 4];
    }
    let color: Vec<f32> = [0; 4].map(|_| random.float(0.0, 1.0)).into();
    let reach = one_of(random, &[1.0, 1.6, 6.0]);
    let vertices: Vec<f32> = (0..3)
        .flat_map(|_| {
            let [x, y] = [0; 2].map(|_| random.float(-reach, reach));
            [vec![x, y, random.float(-0.9, 0.9), 1.0], color.clone()].concat()
        })
        .collect();
    [
        Command::BindPipeline(Pipeline::new(desc).expect("valid")),
        Command::BindVertices(bindings(&vertices, 2)),
        Command::Draw { first: 0, count: 3, instances: 0..1 },
    ]
}

fn sampled(format: Format, samples: u8) -> Image {
    if samples == 1 {
        return image(format, SIZE, SIZE);
    }
    let mut texels = Texels::new(Shape::D2);
    texels.set_level(0, 0, Level::new(format, SIZE, SIZE).expect("small")).expect("face 0");
    Image::with_samples(texels, samples)
}

/// Colours, depths and stencils after all draws.
fn drawn(isa: Isa, samples: u8, watched: bool, seed: u64) -> Vec<Vec<u8>> {
    let (color, depth) = (sampled(Format::Rgba8, samples), sampled(Format::D24S8, samples));
    let attach = |image: &Image| Attachment { image: image.clone(), face: 0, level: 0 };
    let area = Rect { x: 0, y: 0, width: SIZE, height: SIZE };
    let multisample = MultisampleState { rule: SampleRule::Each, ..MultisampleState::default() };
    let mut commands = vec![
        Command::BeginPass(PassDesc {
            colors: vec![Some(attach(&color))],
            depth: Some(attach(&depth)),
            width: SIZE,
            height: SIZE,
            layers: 1,
            samples,
        }),
        viewport(SIZE, SIZE),
        Command::SetRaster(Arc::new(RasterState { multisample, ..RasterState::default() })),
        Command::Clear { value: ClearValue::Depth(0.6), area },
        Command::Clear { value: ClearValue::Stencil { value: 1, mask: 0xFF }, area },
    ];
    if watched {
        commands.push(Command::Watch(Watch::new(20, 30)));
    }
    let mut random = Random(seed);
    commands.extend((0..DRAWS).flat_map(|_| draw(&mut random)));
    commands.push(Command::EndPass);
    device(isa, 1).submit(&CommandBuffer { commands }).expect("legal");
    let level = |image: &Image| {
        let texels = image.texels();
        texels.level(0, 0).expect("made with one").texels.to_vec()
    };
    vec![level(&color), level(&depth)]
}

#[test]
fn blocks_of_one_stencil_are_tested_as_their_fragments_are() {
    let mut stencils = BTreeSet::new();
    for samples in [1, 4] {
        for seed in 0..12 {
            let expected = drawn(Isa::BASELINE, samples, true, seed);
            stencils.extend(expected[1].chunks(4).map(|texel| texel[0]));
            for isa in Isa::available() {
                let got = drawn(isa, samples, false, seed);
                for (which, (got, expected)) in got.iter().zip(&expected).enumerate() {
                    let differing = got.iter().zip(expected).filter(|(a, b)| a != b).count();
                    let of = ["colours", "depths and stencils"][which];
                    let isa = isa.name();
                    assert_eq!(differing, 0, "{of}: bytes, {samples} samples, {seed}, {isa}");
                }
            }
        }
    }
    assert!(stencils.len() > 6, "{stencils:?}");
}
