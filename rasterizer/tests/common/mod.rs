//! Small scenes for the tests of the driver.

use rasterizer::driver::{
    Attachment, Buffer, ColorState, Command, Cull, Device, DeviceDesc, Explain, FrontFace, Image,
    OutputState, PassDesc, PipelineDesc, Provoking, ShaderModule, Topology, VertexBinding,
    VertexFormat, VertexSource, VertexType, Viewport,
};
use rasterizer::ir::{Builder, Input, Interpolation, Output, Stage, Value};
use texunit::format::Format;
use texunit::image::{Image as Texels, Level, Shape};
use texunit::lanes::Isa;

/// A device that keeps its plans.
pub fn device(isa: Isa, threads: usize) -> Device {
    let desc =
        DeviceDesc { budget: 1 << 20, explain: Explain::Keep, ..DeviceDesc::new(isa, threads) };
    Device::new(desc).expect("threads start")
}

/// An image of one level.
pub fn image(format: Format, width: u32, height: u32) -> Image {
    let mut texels = Texels::new(Shape::D2);
    texels.set_level(0, 0, Level::new(format, width, height).expect("small")).expect("face 0");
    Image::new(texels)
}

/// The bytes of an image's only level, without padding.
pub fn bytes(image: &Image) -> Vec<u8> {
    let texels = image.texels();
    let level = texels.level(0, 0).expect("made with one");
    level.texels[..level.row_bytes() * level.height as usize].to_vec()
}

/// A vertex module that passes attribute 0 on as the position and `varyings` scalars of attributes
/// 1, 2, … as slots 0, 1, …
pub fn vertex(varyings: u16) -> ShaderModule {
    let mut b = Builder::new(Stage::Vertex);
    for component in 0..4 {
        let value = b.input(Input::Attribute { location: 0, component });
        let out = b.output(Output::Position(component));
        b.store(out, value);
    }
    for slot in 0..varyings {
        let value = b.input(Input::Attribute {
            location: 1 + (slot / 4) as u8,
            component: (slot % 4) as u8,
        });
        let out = b.output(Output::Varying(slot));
        b.store(out, value);
    }
    ShaderModule::new(b.finish()).expect("valid")
}

/// A fragment module with `varyings` smooth slots whose colour `f` gives.
pub fn fragment(varyings: u16, f: impl FnOnce(&mut Builder) -> [Value; 4]) -> ShaderModule {
    let mut b = Builder::new(Stage::Fragment);
    b.module_mut().varyings = vec![Interpolation::Smooth; usize::from(varyings)];
    let color = f(&mut b);
    for (component, value) in color.into_iter().enumerate() {
        let out = b.output(Output::Color { target: 0, component: component as u8 });
        b.store(out, value);
    }
    ShaderModule::new(b.finish()).expect("valid")
}

/// A pipeline of triangles that writes one colour attachment.
pub fn pipeline(vertex: ShaderModule, fragment: ShaderModule) -> PipelineDesc {
    PipelineDesc {
        vertex,
        geometry: None,
        fragment,
        topology: Topology::Triangles,
        cull: Cull::None,
        front_face: FrontFace::Ccw,
        provoking: Provoking::Last,
        depth: None,
        colors: vec![ColorState { blend: None, mask: [true; 4] }],
        output: OutputState::default(),
    }
}

/// Interleaved `f32` vertices: four of position, then four for each further attribute.
pub fn bindings(vertices: &[f32], attributes: u8) -> std::sync::Arc<[VertexBinding]> {
    let buffer = Buffer::new(vertices.iter().flat_map(|v| v.to_le_bytes()).collect());
    (0..attributes)
        .map(|location| VertexBinding {
            location,
            source: VertexSource::Array {
                buffer: buffer.clone(),
                first: 0,
                offset: usize::from(location) * 16,
                stride: usize::from(attributes) * 16,
                ty: VertexType::F32,
                components: 4,
                format: VertexFormat::Plain,
                divisor: 0,
            },
        })
        .collect()
}

/// A pass over `color` and `depth`.
pub fn pass(color: &Image, depth: Option<&Image>, width: u32, height: u32) -> Command {
    let attach = |image: &Image| Attachment::new(image.clone(), 0, 0);
    Command::BeginPass(PassDesc {
        colors: vec![Some(attach(color))],
        depth: depth.map(attach),
        width,
        height,
        layers: 1,
        samples: 1,
    })
}

/// A viewport over the whole of an image.
pub fn viewport(width: u32, height: u32) -> Command {
    Command::SetViewport(Viewport {
        x: 0.0,
        y: 0.0,
        width: width as f32,
        height: height as f32,
        near: 0.0,
        far: 1.0,
        depth_clip: Default::default(),
        clip_control: Default::default(),
    })
}
