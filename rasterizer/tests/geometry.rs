//! Geometry programs: what they emit is drawn as the same primitives are without them, on every instruction set and
//! any number of threads.

mod common;

use common::{device, fragment, image, pass, pipeline, viewport};
use rasterizer::driver::{
    Attachment, Blend, BlendEquation, BlendFactor, Buffer, ClearValue, ColorState, Command,
    CommandBuffer, Device, DeviceDesc, Image, IndexType, Indices, PassDesc, Pipeline, PipelineDesc,
    Provoking, Rect, ShaderModule, Topology,
};
use rasterizer::ir::{
    Builder, GeometryInput, GeometryInterface, GeometryOutput, Input, Interpolation, Op, Output,
    Stage, Stmt, Value,
};
use texunit::format::Format;
use texunit::image::{Image as Texels, Level, Shape};
use texunit::lanes::Isa;

const SIZE: u32 = 140;

/// Position and four varyings.
fn outputs() -> Vec<Output> {
    let position = (0..4).map(Output::Position);
    position.chain((0..4).map(Output::Varying)).collect()
}

fn builder(input: GeometryInput, output: GeometryOutput, max_vertices: u32) -> Builder {
    let mut b = Builder::new(Stage::Geometry);
    b.module_mut().geometry =
        Some(GeometryInterface { input, output, max_vertices, outputs: outputs() });
    b
}

fn finish(b: Builder) -> ShaderModule {
    ShaderModule::new(b.finish()).expect("valid")
}

/// What the vertex stage wrote for a vertex.
fn of_vertex(b: &mut Builder, vertex: u8) -> Vec<Value> {
    outputs().into_iter().map(|output| b.input(Input::OfVertex { vertex, output })).collect()
}

/// Emits these vertices of the primitive as they are.
fn emit(b: &mut Builder, vertices: &[u8]) {
    for &vertex in vertices {
        let values = of_vertex(b, vertex);
        b.push(Stmt::EmitVertex(values));
    }
}

/// Numbers from -1 to 1, the same ones each time.
fn numbers(count: usize) -> Vec<f32> {
    let number = |at: u32| (at.wrapping_mul(2_654_435_761) >> 8) as f32 / 8_388_608.0 - 1.0;
    (1..=count as u32).map(number).collect()
}

/// Vertices of a position and a colour; some positions are behind the viewer.
fn vertices(count: usize) -> Vec<f32> {
    let mut all = numbers(8 * count);
    for vertex in all.chunks_exact_mut(8) {
        vertex[3] += 0.95;
        vertex[4..].iter_mut().for_each(|color| *color = color.abs());
    }
    all
}

/// Blended, so that order matters, and flat where the second colour is.
fn blended(topology: Topology, provoking: Provoking) -> PipelineDesc {
    let blend = Blend {
        equation: [BlendEquation::Add; 2],
        src: [BlendFactor::SrcAlpha; 2],
        dst: [BlendFactor::OneMinusSrcAlpha; 2],
        constant: [0.0; 4],
    };
    let mut colors = fragment(4, |b| [0, 1, 2, 3].map(|slot| b.input(Input::Varying(slot))));
    let mut module = colors.module().clone();
    module.varyings[1] = Interpolation::Flat;
    colors = ShaderModule::new(module).expect("valid");
    let of = vec![ColorState { blend: Some(blend), mask: [true; 4] }];
    PipelineDesc { topology, provoking, colors: of, ..pipeline(common::vertex(4), colors) }
}

fn draw(desc: PipelineDesc, floats: &[f32], draws: Vec<Command>) -> Vec<Command> {
    let mut commands = vec![
        Command::BindPipeline(Pipeline::new(desc).expect("valid")),
        Command::BindVertices(common::bindings(floats, 2)),
    ];
    commands.extend(draws);
    commands
}

fn picture(device: &Device, draws: Vec<Command>) -> Vec<u8> {
    let color = image(Format::Rgba8, SIZE, SIZE);
    let mut commands = vec![pass(&color, None, SIZE, SIZE), viewport(SIZE, SIZE)];
    commands.extend(draws);
    commands.push(Command::EndPass);
    let report = device.submit(&CommandBuffer { commands }).expect("legal");
    assert!(report.over_budget.is_empty());
    common::bytes(&color)
}

fn devices() -> Vec<Device> {
    let threads = [1, 4];
    Isa::available()
        .into_iter()
        .flat_map(|isa| threads.map(|threads| device(isa, threads)))
        .collect()
}

#[test]
fn what_passes_through_is_drawn_as_it_is() {
    let triangles: &[u8] = &[0, 1, 2];
    let cases = [
        (Topology::Points, GeometryOutput::Points, &[0][..]),
        (Topology::Lines, GeometryOutput::LineStrip, &[0, 1]),
        (Topology::LineStrip, GeometryOutput::LineStrip, &[0, 1]),
        (Topology::LineLoop, GeometryOutput::LineStrip, &[0, 1]),
        (Topology::LinesAdjacency, GeometryOutput::LineStrip, &[1, 2]),
        (Topology::LineStripAdjacency, GeometryOutput::LineStrip, &[1, 2]),
        (Topology::Triangles, GeometryOutput::TriangleStrip, triangles),
        (Topology::TriangleStrip, GeometryOutput::TriangleStrip, triangles),
        (Topology::TriangleFan, GeometryOutput::TriangleStrip, triangles),
        (Topology::TrianglesAdjacency, GeometryOutput::TriangleStrip, &[0, 2, 4]),
        (Topology::TriangleStripAdjacency, GeometryOutput::TriangleStrip, &[0, 2, 4]),
    ];
    for (topology, output, passed) in cases {
        let input = topology.geometry_input().expect("one that geometry programs take");
        let mut b = builder(input, output, passed.len() as u32);
        emit(&mut b, passed);
        let geometry = finish(b);
        for (provoking, count, instances) in [
            (Provoking::Last, 13, 0..1),
            (Provoking::First, 140, 2..5),
            (Provoking::Last, 2500, 0..1),
        ] {
            let floats = vertices(count as usize);
            let indices = Indices {
                buffer: Buffer::new(
                    (0..count)
                        .map(|at| at * 7 % (count / 2 + 1))
                        .flat_map(u32::to_le_bytes)
                        .collect(),
                ),
                offset: 0,
                ty: IndexType::U32,
                base_vertex: 0,
            };
            let draws = [
                Command::Draw { first: 0, count, instances: instances.clone() },
                Command::DrawIndexed { indices, count, instances },
            ];
            for command in draws {
                let desc = blended(topology, provoking);
                let with = PipelineDesc { geometry: Some(geometry.clone()), ..desc.clone() };
                let one = device(Isa::best(), 1);
                let want = picture(&one, draw(desc, &floats, vec![command.clone()]));
                assert!(count < 100 || want.iter().any(|&byte| byte != 0), "{topology:?}");
                let devices = if count < 1000 { devices() } else { vec![device(Isa::best(), 4)] };
                for device in devices {
                    let got = picture(&device, draw(with.clone(), &floats, vec![command.clone()]));
                    assert!(got == want, "{topology:?} {provoking:?} {count}");
                }
            }
        }
    }
}

/// The lanes emit strips of different lengths: six vertices, or four and two, of which the latter make no triangle.
#[test]
fn strips_are_those_of_draws() {
    let mut b = builder(GeometryInput::TrianglesAdjacency, GeometryOutput::TriangleStrip, 6);
    emit(&mut b, &[0, 1, 2, 3]);
    let red = b.input(Input::OfVertex { vertex: 0, output: Output::Varying(0) });
    let half = b.float(0.5);
    let condition = b.op(Op::Less, &[red, half]);
    b.push(Stmt::If { condition, accept: vec![Stmt::EndPrimitive], reject: Vec::new() });
    emit(&mut b, &[4, 5, 0, 1]);
    let geometry = finish(b);
    let floats = vertices(6 * 150);
    let command = Command::Draw { first: 0, count: 6 * 150, instances: 0..1 };
    for provoking in [Provoking::Last, Provoking::First] {
        let strips = blended(Topology::TriangleStrip, provoking);
        let draws = floats.chunks_exact(6 * 8).zip(0..).map(|(own, at)| {
            let count = if own[4] < 0.5 { 4 } else { 6 };
            Command::Draw { first: 6 * at, count, instances: 0..1 }
        });
        let want = picture(&device(Isa::best(), 1), draw(strips, &floats, draws.collect()));
        let desc = PipelineDesc {
            geometry: Some(geometry.clone()),
            ..blended(Topology::TrianglesAdjacency, provoking)
        };
        for device in devices() {
            assert!(picture(&device, draw(desc.clone(), &floats, vec![command.clone()])) == want);
        }
    }
}

/// A fragment stage that shows the primitive's number.
fn numbered(topology: Topology) -> PipelineDesc {
    let mut b = Builder::new(Stage::Fragment);
    b.module_mut().varyings = vec![Interpolation::Flat; 6];
    b.module_mut().primitive_id = Some(4);
    let scale = b.float(1.0 / 255.0);
    let low = b.input(Input::Varying(4));
    let color = b.op(Op::Mul, &[low, scale]);
    for component in 0..4 {
        let out = b.output(Output::Color { target: 0, component });
        b.store(out, color);
    }
    PipelineDesc { topology, ..pipeline(common::vertex(4), finish(b)) }
}

#[test]
fn primitives_have_the_number_that_is_emitted_or_that_of_the_input() {
    let floats = vertices(90);
    let command = Command::Draw { first: 0, count: 90, instances: 0..1 };
    let plain = numbered(Topology::Triangles);
    let want =
        picture(&device(Isa::best(), 1), draw(plain.clone(), &floats, vec![command.clone()]));
    assert!(want.iter().any(|&byte| byte > 9));
    let mut b = builder(GeometryInput::Triangles, GeometryOutput::TriangleStrip, 3);
    emit(&mut b, &[0, 1, 2]);
    let own = finish(b);
    let mut b = builder(GeometryInput::Triangles, GeometryOutput::TriangleStrip, 3);
    let number = b.input(Input::PrimitiveId);
    let two = b.int(2);
    let doubled = b.op(Op::IMul, &[number, two]);
    for vertex in 0..3 {
        let mut values = of_vertex(&mut b, vertex);
        values.push(doubled);
        b.push(Stmt::EmitVertex(values));
    }
    b.module_mut().geometry.as_mut().expect("set").outputs.push(Output::PrimitiveId);
    let other = finish(b);
    for device in devices() {
        let of = |geometry: &ShaderModule| {
            let desc = PipelineDesc { geometry: Some(geometry.clone()), ..plain.clone() };
            picture(&device, draw(desc, &floats, vec![command.clone()]))
        };
        assert!(of(&own) == want);
        let twice: Vec<u8> = want.iter().map(|byte| byte * 2).collect();
        assert!(of(&other) == twice);
    }
}

/// An image of layers of zeros.
fn layered(layers: u32) -> Image {
    let mut texels = Texels::new(Shape::D2Array);
    let level = Level::with_size(Format::Rgba8, [SIZE, SIZE, layers], [0; 3]).expect("small");
    texels.set_level(0, 0, level).expect("face 0");
    Image::new(texels)
}

fn layer(image: &Image, layer: usize) -> Vec<u8> {
    let texels = image.texels();
    let level = texels.level(0, 0).expect("one");
    let row = |y| level.row_span([0, y, layer], SIZE as usize).to_vec();
    (0..SIZE as usize).flat_map(row).collect()
}

#[test]
fn each_primitive_goes_to_the_layer_of_its_provoking_vertex() {
    const LAYERS: u16 = 3;
    let mut b = builder(GeometryInput::Triangles, GeometryOutput::TriangleStrip, 3);
    let number = b.input(Input::PrimitiveId);
    // Layers -1, 0, 1, 2 and 3, of which three exist; of vertices that do not provoke, another.
    let five = b.int(5);
    let one = b.int(1);
    let rest = b.op(Op::IRem, &[number, five]);
    let own = b.op(Op::ISub, &[rest, one]);
    for vertex in 0..3 {
        let mut values = of_vertex(&mut b, vertex);
        values.push(if vertex == 2 { own } else { one });
        b.push(Stmt::EmitVertex(values));
    }
    b.module_mut().geometry.as_mut().expect("set").outputs.push(Output::Layer);
    let geometry = finish(b);
    let count = 300;
    let floats = vertices(count as usize);
    let grey = Command::Clear {
        value: ClearValue::Color { target: 0, value: [0.25; 4], mask: [true; 4] },
        area: Rect { x: 3, y: 5, width: 100, height: 120 },
    };
    let desc = blended(Topology::Triangles, Provoking::Last);
    let want: Vec<Vec<u8>> = (1..=u32::from(LAYERS))
        .map(|rest| {
            let own = (rest..count / 3).step_by(5);
            let one = |at| Command::Draw { first: 3 * at, count: 3, instances: 0..1 };
            let mut draws = vec![grey.clone()];
            draws.extend(draw(desc.clone(), &floats, own.map(one).collect()));
            picture(&device(Isa::best(), 1), draws)
        })
        .collect();
    for device in devices() {
        let image = layered(LAYERS.into());
        let color = Some(Attachment::new(image.clone(), 0, 0));
        let mut commands = vec![
            Command::BeginPass(PassDesc {
                colors: vec![color],
                depth: None,
                width: SIZE,
                height: SIZE,
                layers: LAYERS,
                samples: 1,
            }),
            viewport(SIZE, SIZE),
            grey.clone(),
        ];
        let desc = PipelineDesc { geometry: Some(geometry.clone()), ..desc.clone() };
        commands.extend(draw(
            desc,
            &floats,
            vec![Command::Draw { first: 0, count, instances: 0..1 }],
        ));
        commands.push(Command::EndPass);
        device.submit(&CommandBuffer { commands }).expect("legal");
        for (at, want) in want.iter().enumerate() {
            assert!(layer(&image, at) == *want, "layer {at}");
        }
    }
}

/// The draw of a program that emits for points.
fn of_points(geometry: ShaderModule, count: u32) -> Vec<Command> {
    let desc =
        PipelineDesc { geometry: Some(geometry), ..blended(Topology::Points, Provoking::Last) };
    let floats = vertices(count as usize);
    draw(desc, &floats, vec![Command::Draw { first: 0, count, instances: 0..1 }])
}

#[test]
fn programs_that_emit_nothing_or_too_much_or_do_not_end_do_no_harm() {
    let one = device(Isa::best(), 2);
    let blank = picture(&one, Vec::new());
    let nothing = builder(GeometryInput::Points, GeometryOutput::TriangleStrip, 0);
    let too_few = {
        let mut b = builder(GeometryInput::Points, GeometryOutput::TriangleStrip, 3);
        emit(&mut b, &[0, 0]);
        b
    };
    let nan = {
        let mut b = builder(GeometryInput::Points, GeometryOutput::TriangleStrip, 3);
        let nan = b.float(f32::NAN);
        (0..3).for_each(|_| b.push(Stmt::EmitVertex(vec![nan; 8])));
        b
    };
    for geometry in [nothing, too_few, nan] {
        assert!(picture(&one, of_points(finish(geometry), 200)) == blank);
    }
    // More vertices than are allowed: those beyond are left out.
    let most = |emitted: u8| {
        let mut b = builder(GeometryInput::Points, GeometryOutput::Points, 2);
        emit(&mut b, &vec![0; emitted.into()]);
        finish(b)
    };
    let [two, nine] = [2, 9].map(|emitted| picture(&one, of_points(most(emitted), 200)));
    assert!(two == nine && two != blank);
    // The most vertices of the most primitives.
    let mut many = Builder::new(Stage::Geometry);
    many.module_mut().geometry = Some(GeometryInterface {
        input: GeometryInput::Points,
        output: GeometryOutput::TriangleStrip,
        max_vertices: 256,
        outputs: (0..4).map(Output::Position).collect(),
    });
    for vertex in 0..300 {
        let mut values = of_vertex(&mut many, 0);
        values.truncate(4);
        values[vertex % 2] = many.float((vertex % 7) as f32 * 0.01);
        many.push(Stmt::EmitVertex(values));
    }
    // They take more than the little that these tests' devices allow.
    let ample = Device::new(DeviceDesc::new(Isa::best(), 2)).expect("threads start");
    picture(&ample, of_points(finish(many), 3000));
    // A loop that emits without an end is stopped; the same on every machine.
    let mut endless = builder(GeometryInput::Points, GeometryOutput::Points, 4);
    let values = of_vertex(&mut endless, 0);
    let body = vec![Stmt::EmitVertex(values), Stmt::EndPrimitive];
    endless.push(Stmt::Loop { body, continuing: Vec::new() });
    let mut draws = of_points(finish(endless), 200);
    let color = image(Format::Rgba8, SIZE, SIZE);
    let mut commands = vec![pass(&color, None, SIZE, SIZE), viewport(SIZE, SIZE)];
    commands.append(&mut draws);
    commands.push(Command::EndPass);
    let report = one.submit(&CommandBuffer { commands }).expect("legal");
    assert_eq!(report.over_budget.len(), 1);
    assert!(common::bytes(&color) == blank);
}

#[test]
fn pipelines_take_what_fits() {
    let geometry = |input| {
        let mut b = builder(input, GeometryOutput::Points, 1);
        emit(&mut b, &[0]);
        Some(finish(b))
    };
    let desc = blended(Topology::Triangles, Provoking::Last);
    let of = |geometry| Pipeline::new(PipelineDesc { geometry, ..desc.clone() });
    assert!(of(geometry(GeometryInput::Triangles)).is_ok());
    let refused = of(geometry(GeometryInput::Lines)).expect_err("other primitives");
    assert!(refused.to_string().contains("Triangles are no Lines"), "{refused}");
    assert!(of(Some(common::vertex(0))).is_err());
}
