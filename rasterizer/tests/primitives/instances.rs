//! What is done together though it is of several instances or draws: the picture and the samples that passed are
//! those of each by itself.

use super::super::common::{bytes, device, fragment, image, pass, pipeline, viewport};
use rasterizer::driver::{
    Blend, BlendEquation, BlendFactor, Buffer, ColorState, Command, CommandBuffer, Counter, Device,
    IndexType, Indices, LineState, LineStipple, Pipeline, PipelineDesc, PolygonMode, PolygonState,
    RasterState, Rect, ShaderModule, Topology, VertexBinding, VertexFormat, VertexSource,
    VertexType,
};
use rasterizer::ir::{Builder, Input, Op, Output, Stage, Ty};
use std::sync::Arc;
use texunit::format::Format;
use texunit::lanes::Isa;

const SIZE: u32 = 150;
const TOPOLOGIES: [Topology; 10] = [
    Topology::Points,
    Topology::Lines,
    Topology::LineStrip,
    Topology::LineLoop,
    Topology::Triangles,
    Topology::TriangleStrip,
    Topology::TriangleFan,
    Topology::Quads,
    Topology::QuadStrip,
    Topology::Polygon,
];

/// Numbers from -1 to 1, the same ones each time.
fn numbers(count: usize) -> impl Iterator<Item = f32> {
    (1..=count as u32).map(|at| (at.wrapping_mul(2_654_435_761) >> 8) as f32 / 8_388_608.0 - 1.0)
}

/// Positions are attribute 0, a third of it, and attribute 1 and two uniform words; attribute 2 is handed on.
fn vertex() -> ShaderModule {
    let mut b = Builder::new(Stage::Vertex);
    for component in 0..4 {
        let mut value = b.input(Input::Attribute { location: 0, component });
        if component < 2 {
            let third = b.float(0.3);
            let place = b.input(Input::Attribute { location: 1, component });
            let moved = b.uniform(component.into(), Ty::F32);
            value = b.op(Op::Mul, &[value, third]);
            value = b.op(Op::Add, &[value, place]);
            value = b.op(Op::Add, &[value, moved]);
        }
        let out = b.output(Output::Position(component));
        b.store(out, value);
        let color = b.input(Input::Attribute { location: 2, component });
        let out = b.output(Output::Varying(component.into()));
        b.store(out, color);
    }
    ShaderModule::new(b.finish()).expect("valid")
}

/// A pipeline that blends, so that order matters; its colours are those of attribute 2.
fn blended(topology: Topology) -> Pipeline {
    let colors = fragment(4, |b| [0, 1, 2, 3].map(|slot| b.input(Input::Varying(slot))));
    let blend = Blend {
        equation: [BlendEquation::Add; 2],
        src: [BlendFactor::SrcAlpha; 2],
        dst: [BlendFactor::OneMinusSrcAlpha; 2],
        constant: [0.0; 4],
    };
    let colors_of = vec![ColorState { blend: Some(blend), mask: [true; 4] }];
    let desc = PipelineDesc { topology, colors: colors_of, ..pipeline(vertex(), colors) };
    Pipeline::new(desc).expect("valid")
}

fn array(location: u8, components: u8, divisor: u32, count: usize) -> VertexBinding {
    let floats = numbers(count * usize::from(components));
    let source = VertexSource::Array {
        buffer: Buffer::new(floats.flat_map(f32::to_le_bytes).collect()),
        first: 0,
        offset: 0,
        stride: usize::from(components) * 4,
        ty: VertexType::F32,
        components,
        format: VertexFormat::Plain,
        divisor,
    };
    VertexBinding { location, source }
}

/// What passes leave of a picture.
fn picture(device: &Device, draws: &[Vec<Command>]) -> Vec<u8> {
    let color = image(Format::Rgba8, SIZE, SIZE);
    for draws in draws {
        let mut commands = vec![pass(&color, None, SIZE, SIZE), viewport(SIZE, SIZE)];
        commands.extend_from_slice(draws);
        commands.push(Command::EndPass);
        let report = device.submit(&CommandBuffer { commands }).expect("legal");
        assert!(report.over_budget.is_empty());
    }
    bytes(&color)
}

#[test]
fn instances_are_drawn_as_one_by_one() {
    let device = device(Isa::best(), 2);
    for topology in TOPOLOGIES {
        for (count, instances) in [(4, 3..40), (5, 0..7), (70, 0..9), (2100, 1..5), (12, 2..3)] {
            for divisors in [[1, 0], [3, 2], [0, 1]] {
                let numbers = (0..count).map(|at| at * 7 % (count / 2 + 1));
                let indices = Indices {
                    buffer: Buffer::new(numbers.flat_map(u32::to_le_bytes).collect()),
                    offset: 0,
                    ty: IndexType::U32,
                    base_vertex: 0,
                };
                let state = [
                    Command::BindPipeline(blended(topology)),
                    Command::SetUniforms(Arc::from([0.1_f32.to_bits(), 0])),
                    Command::BindVertices(Arc::from([
                        array(0, 2, 0, count as usize),
                        array(1, 2, divisors[0], 2100),
                        array(2, 4, divisors[1], 2100),
                    ])),
                ];
                let draw = |instances| Command::Draw { first: 0, count, instances };
                let indexed = |instances| {
                    let indices = indices.clone();
                    Command::DrawIndexed { indices, count, instances }
                };
                let with_state = |draw: Command| [&state[..], &[draw]].concat();
                let each = |draw: &dyn Fn(u32) -> Command| -> Vec<Vec<Command>> {
                    instances.clone().map(|at| with_state(draw(at))).collect()
                };
                let what = format!("{topology:?}, {count} vertices, {instances:?}, {divisors:?}");
                let together = picture(&device, &[with_state(draw(instances.clone()))]);
                assert!(together == picture(&device, &each(&|at| draw(at..at + 1))), "{what}");
                let together = picture(&device, &[with_state(indexed(instances.clone()))]);
                let apart = picture(&device, &each(&|at| indexed(at..at + 1)));
                assert!(together == apart, "{what}, by index");
            }
        }
    }
}

/// As polygons are drawn, some by their edges.
fn rasters() -> [Arc<RasterState>; 3] {
    let stipple = Some(LineStipple { factor: 2, pattern: 0xA53C });
    let line = LineState { stipple, ..RasterState::default().line };
    let polygon = PolygonState { mode: [PolygonMode::Line; 2], ..PolygonState::default() };
    let flagged = PolygonState { edge_flag: Some(3), ..polygon.clone() };
    [
        Arc::default(),
        Arc::new(RasterState { line, polygon, ..RasterState::default() }),
        Arc::new(RasterState { line, polygon: flagged, ..RasterState::default() }),
    ]
}

#[test]
fn small_draws_are_drawn_as_one_by_one() {
    let device = device(Isa::best(), 2);
    let (rasters, places) = (rasters(), numbers(800).collect::<Vec<f32>>());
    let buffer = Buffer::new((0..90).map(|at: u16| (at * 7 % 60) as u8).collect());
    let mut flags = array(3, 1, 0, 999);
    if let VertexSource::Array { buffer, .. } = &mut flags.source {
        buffer.bytes_mut().chunks_exact_mut(8).for_each(|pair| pair[..4].fill(0));
    }
    for topology in TOPOLOGIES {
        let state = [
            Command::BindPipeline(blended(topology)),
            Command::BindVertices(Arc::from([
                array(0, 2, 0, 999),
                array(1, 2, 2, 9),
                array(2, 4, 0, 999),
                flags.clone(),
            ])),
        ];
        let draw = |at: usize, counters: &[Counter; 2]| {
            let [x, y] = [places[2 * at], places[2 * at + 1]].map(|place| (place * 0.3).to_bits());
            let area = Rect { x: 20, y: 30, width: 90, height: 70 };
            let indices = Indices {
                buffer: buffer.clone(),
                offset: at % 9,
                ty: IndexType::U8,
                base_vertex: 3,
            };
            let first = (at % 90) as u32;
            vec![
                Command::SetUniforms(Arc::from([x, y])),
                Command::SetCounter(Some(counters[at / 7 % 2].clone())),
                Command::SetScissor((at / 11 % 2 == 1).then_some(area)),
                Command::SetRaster(rasters[at / 17 % 3].clone()),
                match at % 5 {
                    0 => Command::Draw { first, count: 0, instances: 0..3 },
                    1 if at % 30 == 1 => Command::Draw { first, count: 800, instances: 0..1 },
                    1 | 2 => Command::Draw { first, count: 6, instances: 1..4 },
                    3 => Command::DrawIndexed { indices, count: 9, instances: 0..2 },
                    _ => Command::DrawIndexed { indices, count: 7, instances: 3..4 },
                },
            ]
        };
        let counters = [Counter::new(), Counter::new()];
        let all = (0..300).flat_map(|at| draw(at, &counters));
        let together = picture(&device, &[state.iter().cloned().chain(all).collect()]);
        let others = [Counter::new(), Counter::new()];
        let each = (0..300).map(|at| [&state[..], &draw(at, &others)].concat());
        assert!(together == picture(&device, &each.collect::<Vec<_>>()), "{topology:?}");
        for (counter, other) in counters.iter().zip(&others) {
            assert!(counter.samples() == other.samples(), "{topology:?}");
        }
    }
}
