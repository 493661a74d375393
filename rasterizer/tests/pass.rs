//! Passes: attachments of every format, clears, scissor, masks, several targets, budgets, rules.

mod common;

use common::{bindings, bytes, device, fragment, image, pass, pipeline, vertex, viewport};
use rasterizer::driver::{
    Attachment, ClearValue, ColorState, Command, CommandBuffer, DepthState, DepthWrite, Device,
    Image, PassDesc, Pipeline, PipelineDesc, Rect, ShaderModule,
};
use rasterizer::ir::{Builder, Op, Output, Stage, Stmt, TextureDecl, Ty, Value};
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{Image as Texels, Level, Shape};
use texunit::lanes::Isa;
use texunit::plan::SamplePlan;
use texunit::sampler::{Compare, Filter, Mipmap, Sampler};

fn one() -> Device {
    device(Isa::best(), 2)
}

fn rect(x: i32, y: i32, width: u32, height: u32) -> Rect {
    Rect { x, y, width, height }
}

fn constant(color: [f32; 4]) -> ShaderModule {
    fragment(0, |b| color.map(|v| b.float(v)))
}

/// Two triangles over the whole viewport at depth `z` (clip).
fn square(z: f32) -> Vec<f32> {
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
        .into_iter()
        .flat_map(|[x, y]| [x, y, z, 1.0])
        .collect()
}

/// The commands that draw a square through `desc`.
fn draw(desc: &PipelineDesc, z: f32) -> [Command; 3] {
    [
        Command::BindPipeline(Pipeline::new(desc.clone()).expect("valid")),
        Command::BindVertices(bindings(&square(z), 1)),
        Command::Draw { first: 0, count: 6, instances: 0..1 },
    ]
}

fn submit(device: &Device, commands: impl IntoIterator<Item = Command>) {
    let commands = CommandBuffer { commands: commands.into_iter().collect() };
    let report = device.submit(&commands).expect("legal");
    assert!(report.over_budget.is_empty());
}

#[test]
fn every_color_format_keeps_its_components_through_a_pass() {
    let rgba = [51, 102, 153, 204];
    let cases: &[(Format, &[u8])] = &[
        (Format::Rgba8, &[51, 102, 153, 204]),
        (Format::Srgb8A8, &[51, 102, 153, 204]),
        (Format::Rgb8, &[51, 102, 153]),
        (Format::Srgb8, &[51, 102, 153]),
        (Format::Rg8, &[51, 102]),
        (Format::R8, &[51]),
        (Format::L8, &[51]),
        (Format::I8, &[51]),
        (Format::La8, &[51, 204]),
        (Format::A8, &[204]),
    ];
    let color = rgba.map(|v: u8| f32::from(v) / 255.0);
    for &(format, want) in cases {
        // Half is drawn, half keeps what was there.
        let mut level = Level::new(format, 70, 66).expect("small");
        let used = level.row_bytes() * 66;
        level.texels[..used].fill(7);
        let mut texels = Texels::new(Shape::D2);
        texels.set_level(0, 0, level).expect("face 0");
        let target = Image::new(texels);
        let desc = pipeline(vertex(0), constant(color));
        let mut commands = vec![pass(&target, None, 70, 66), viewport(70, 66)];
        commands.push(Command::SetScissor(Some(rect(0, 0, 35, 66))));
        commands.extend(draw(&desc, 0.0));
        commands.push(Command::EndPass);
        submit(&one(), commands);
        let got = bytes(&target);
        for (i, texel) in got.chunks(want.len()).enumerate() {
            if i % 70 < 35 {
                assert_eq!(texel, want, "{format:?} at {i}");
            } else {
                assert!(texel.iter().all(|&b| b == 7), "{format:?} at {i}");
            }
        }
    }
}

#[test]
fn clears_obey_their_rectangle_and_mask_in_order_with_draws() {
    let target = image(Format::Rgba8, 130, 70);
    let clear = |value, mask, area| Command::Clear {
        value: ClearValue::Color { target: 0, value, mask },
        area,
    };
    let desc = pipeline(vertex(0), constant([1.0, 0.0, 0.0, 1.0]));
    let mut commands = vec![
        pass(&target, None, 130, 70),
        clear([0.0, 0.0, 1.0, 1.0], [true; 4], rect(0, 0, 130, 70)),
        viewport(130, 70),
        Command::SetScissor(Some(rect(10, 10, 20, 20))),
    ];
    commands.extend(draw(&desc, 0.0));
    // Only green, of a part that overlaps the square.
    commands.push(clear([1.0; 4], [false, true, false, false], rect(20, 20, 100, 1000)));
    // Beyond the attachment, and empty.
    commands.push(clear([1.0; 4], [true; 4], rect(-500, -500, 400, 400)));
    commands.push(clear([1.0; 4], [true; 4], rect(5, 5, 0, 3)));
    commands.push(Command::EndPass);
    submit(&one(), commands);
    let got = bytes(&target);
    for y in 0..70 {
        for x in 0..130 {
            let drawn = (10..30).contains(&x) && (10..30).contains(&y);
            let green = (20..120).contains(&x) && y >= 20;
            let want = [u8::from(drawn) * 255, u8::from(green) * 255, u8::from(!drawn) * 255, 255];
            assert_eq!(got[(y * 130 + x) * 4..][..4], want, "{x},{y}");
        }
    }
}

#[test]
fn masks_keep_components_and_alpha_that_is_not_stored_is_one() {
    let target = image(Format::Rgba8, 9, 9);
    let mut desc = pipeline(vertex(0), constant([1.0; 4]));
    desc.colors[0].mask = [true, false, true, false];
    let mut commands = vec![pass(&target, None, 9, 9), viewport(9, 9)];
    commands.extend(draw(&desc, 0.0));
    commands.push(Command::EndPass);
    submit(&one(), commands);
    assert!(bytes(&target).chunks(4).all(|p| p == [255, 0, 255, 0]));
}

#[test]
fn one_draw_writes_several_targets() {
    let targets = [image(Format::Rgba8, 20, 10), image(Format::R8, 40, 30)];
    let mut b = Builder::new(Stage::Fragment);
    for (target, value) in [(0, 0.2), (1, 0.6)] {
        for component in 0..4 {
            let out = b.output(Output::Color { target, component });
            let value = b.float(value);
            b.store(out, value);
        }
    }
    let module = ShaderModule::new(b.finish()).expect("valid");
    let mut desc = pipeline(vertex(0), module);
    desc.colors = vec![ColorState { blend: None, mask: [true; 4] }; 2];
    let colors = targets.iter().map(|image| Some(Attachment::new(image.clone(), 0, 0))).collect();
    let mut commands = vec![
        Command::BeginPass(PassDesc {
            colors,
            depth: None,
            width: 20,
            height: 10,
            layers: 1,
            samples: 1,
        }),
        viewport(20, 10),
    ];
    commands.extend(draw(&desc, 0.0));
    commands.push(Command::EndPass);
    submit(&one(), commands);
    assert!(bytes(&targets[0]).iter().all(|&b| b == 51));
    // The larger attachment is drawn to only as far as the pass reaches.
    for (i, &b) in bytes(&targets[1]).iter().enumerate() {
        assert_eq!(b, if i % 40 < 20 && i / 40 < 10 { 153 } else { 0 }, "{i}");
    }
}

#[test]
fn depth_formats_store_the_nearest_depth_of_a_pass_without_colour() {
    for (format, want) in [
        (Format::D16, 16384_u32.to_le_bytes()[..2].to_vec()),
        (Format::D24, 4_194_304_u32.to_le_bytes().to_vec()),
        (Format::D32F, 0.25_f32.to_le_bytes().to_vec()),
    ] {
        let depth = image(format, 33, 17);
        let mut desc = pipeline(vertex(0), constant([1.0; 4]));
        desc.colors.clear();
        desc.depth = Some(DepthState { test: Compare::Less, write: DepthWrite::On });
        let attachment = Attachment::new(depth.clone(), 0, 0);
        let desc_pass = PassDesc {
            colors: Vec::new(),
            depth: Some(attachment),
            width: 33,
            height: 17,
            layers: 1,
            samples: 1,
        };
        let mut commands = vec![
            Command::BeginPass(desc_pass),
            Command::Clear { value: ClearValue::Depth(1.0), area: rect(0, 0, 33, 17) },
            viewport(33, 17),
        ];
        commands.extend(draw(&desc, 0.5));
        commands.extend(draw(&desc, -0.5));
        commands.extend(draw(&desc, 0.0));
        commands.push(Command::EndPass);
        submit(&one(), commands);
        let got = bytes(&depth);
        assert!(got.chunks(want.len()).all(|t| t == want), "{format:?}: {:?}", &got[..4]);
    }
}

#[test]
fn a_texture_that_is_drawn_to_while_it_is_sampled_reads_what_it_held_before() {
    let target = image(Format::Rgba8, 16, 16);
    target.update(|texels| texels.level_mut(0, 0).expect("there").texels.fill(100));
    let sampler = Sampler { mipmap: Mipmap::None, mag: Filter::Nearest, ..Sampler::default() };
    let plan = Arc::new(SamplePlan::new(&target.texels(), &sampler));
    let shader = fragment(0, |b| {
        let slot = b.texture(TextureDecl::color(Shape::D2));
        let coords: [Value; 3] = [0.5, 0.5, 0.0].map(|v| b.float(v));
        let lod = rasterizer::ir::Lod::Implicit { bias: None };
        let texel = b.sample(slot, coords, None, lod);
        let more = b.float(10.0 / 255.0);
        texel.map(|v| b.op(Op::Add, &[v, more]))
    });
    let desc = pipeline(vertex(0), shader);
    let mut commands = vec![pass(&target, None, 16, 16), viewport(16, 16)];
    commands.push(Command::BindTextures { vertex: Arc::new([]), fragment: Arc::new([Some(plan)]) });
    commands.extend(draw(&desc, 0.0));
    commands.extend(draw(&desc, 0.0));
    commands.push(Command::EndPass);
    submit(&one(), commands);
    assert!(bytes(&target).iter().all(|&b| b == 110));
}

#[test]
fn faces_and_levels_of_one_image_are_drawn_to_one_after_another() {
    let mut texels = Texels::new(Shape::Cube);
    for face in 0..6 {
        for level in 0..2 {
            let size = 8 >> level;
            texels
                .set_level(face, level, Level::new(Format::Rgba8, size, size).expect("small"))
                .expect("a face");
        }
    }
    let cube = Image::new(texels);
    for face in 0..6_u16 {
        for level in 0..2_u8 {
            let size = 8 >> level;
            let value = f32::from(face * 2 + u16::from(level) + 1) * 10.0 / 255.0;
            let desc = pipeline(vertex(0), constant([value; 4]));
            let attachment = Attachment::new(cube.clone(), face, level);
            let mut commands = vec![
                Command::BeginPass(PassDesc {
                    colors: vec![Some(attachment)],
                    depth: None,
                    width: size,
                    height: size,
                    layers: 1,
                    samples: 1,
                }),
                viewport(size, size),
            ];
            commands.extend(draw(&desc, 0.0));
            commands.push(Command::EndPass);
            submit(&one(), commands);
        }
    }
    let texels = cube.texels();
    for face in 0..6 {
        for level in 0..2 {
            let got = texels.level(face, level).expect("there").texel(1, 1).to_vec();
            assert_eq!(got, [(face * 2 + level + 1) as u8 * 10; 4]);
        }
    }
}

#[test]
fn an_endless_shader_is_stopped_and_the_rest_is_drawn() {
    let target = image(Format::Rgba8, 64, 64);
    let mut b = Builder::new(Stage::Fragment);
    let out = b.output(Output::Color { target: 0, component: 0 });
    let value = b.float(1.0);
    b.push(Stmt::Loop { body: Vec::new(), continuing: Vec::new() });
    b.store(out, value);
    let endless = pipeline(vertex(0), ShaderModule::new(b.finish()).expect("valid"));
    let fine = pipeline(vertex(0), constant([0.2; 4]));
    let mut commands = vec![pass(&target, None, 64, 64), viewport(64, 64)];
    commands.extend(draw(&fine, 0.0));
    commands.extend(draw(&endless, 0.0));
    commands.push(Command::EndPass);
    let report = one().submit(&CommandBuffer { commands }).expect("legal");
    assert_eq!(report.over_budget, [7]);
    assert!(bytes(&target).iter().all(|&b| b == 51));
}

#[test]
fn draws_whose_vertices_never_end_are_left_out_one_by_one() {
    let mut b = Builder::resume(vertex(0).module().clone());
    let (limit, stops) = (b.float(0.0), b.uniform(0, Ty::F32));
    let condition = b.op(Op::Less, &[stops, limit]);
    let endless = Stmt::Loop { body: Vec::new(), continuing: Vec::new() };
    b.push(Stmt::If { condition, accept: vec![endless], reject: Vec::new() });
    let module = ShaderModule::new(b.finish()).expect("valid");
    let desc = pipeline(module, constant([0.2; 4]));
    let pipeline = Pipeline::new(desc).expect("valid");
    // Which draws end, those that do not, and what is left.
    let cases: [(&[f32], &[usize], u8); 3] =
        [(&[-1.0, 1.0, -1.0, 1.0], &[5, 9], 51), (&[1.0, -1.0], &[7], 51), (&[-1.0], &[5], 0)];
    for (stops, over, left) in cases {
        let target = image(Format::Rgba8, 64, 64);
        let mut commands = vec![pass(&target, None, 64, 64), viewport(64, 64)];
        commands.push(Command::BindPipeline(pipeline.clone()));
        commands.push(Command::BindVertices(bindings(&square(0.0), 1)));
        for stop in stops {
            commands.push(Command::SetUniforms(Arc::from([stop.to_bits()])));
            commands.push(Command::Draw { first: 0, count: 6, instances: 0..1 });
        }
        commands.push(Command::EndPass);
        let report = one().submit(&CommandBuffer { commands }).expect("legal");
        assert_eq!(report.over_budget, over);
        assert!(bytes(&target).iter().all(|&b| b == left), "{stops:?}");
    }
}

#[test]
fn what_breaks_a_rule_is_refused_whole() {
    let color = image(Format::Rgba8, 8, 8);
    let depth = image(Format::D24, 4, 8);
    let draw_only = Command::Draw { first: 0, count: 3, instances: 0..1 };
    let cases: Vec<(Vec<Command>, &str)> = vec![
        (vec![Command::EndPass], "outside a pass"),
        (vec![pass(&color, None, 8, 8)], "not ended"),
        (vec![pass(&color, None, 8, 8), pass(&color, None, 8, 8)], "was not ended"),
        (vec![pass(&color, None, 9, 8), Command::EndPass], "8×8, smaller than the pass's 9×8"),
        (vec![pass(&color, Some(&depth), 8, 8), Command::EndPass], "4×8, smaller"),
        (vec![pass(&depth, None, 4, 4), Command::EndPass], "no format of a colour attachment"),
        (vec![pass(&color, Some(&color), 8, 8), Command::EndPass], "no format of a depth"),
        (vec![pass(&color, None, 8, 8), draw_only, Command::EndPass], "needs BindPipeline"),
        (
            vec![
                pass(&color, None, 8, 8),
                Command::Clear { value: ClearValue::Depth(f32::NAN), area: rect(0, 0, 1, 1) },
                Command::EndPass,
            ],
            "NaN",
        ),
    ];
    for (commands, want) in cases {
        let error = one().submit(&CommandBuffer { commands }).expect_err(want);
        assert!(error.to_string().contains(want), "{error} does not say {want}");
    }
}

#[test]
fn nothing_is_drawn_beyond_the_viewport() {
    // The square reaches far out of the view volume on every side.
    let target = image(Format::Rgba8, 40, 30);
    let desc = pipeline(vertex(0), constant([1.0; 4]));
    let wide: Vec<f32> =
        square(0.0).chunks(4).flat_map(|v| [v[0] * 5.0, v[1] * 5.0, v[2], v[3]]).collect();
    let commands = [
        pass(&target, None, 40, 30),
        Command::SetViewport(rasterizer::driver::Viewport {
            x: 10.0,
            y: 5.0,
            width: 20.0,
            height: 8.0,
            near: 0.0,
            far: 1.0,
            depth_clip: Default::default(),
            clip_control: Default::default(),
        }),
        Command::BindPipeline(Pipeline::new(desc).expect("valid")),
        Command::BindVertices(bindings(&wide, 1)),
        Command::Draw { first: 0, count: 6, instances: 0..1 },
        Command::EndPass,
    ];
    submit(&one(), commands);
    for (i, pixel) in bytes(&target).chunks(4).enumerate() {
        let inside = (10..30).contains(&(i % 40)) && (5..13).contains(&(i / 40));
        assert_eq!(pixel, [u8::from(inside) * 255; 4], "{},{}", i % 40, i / 40);
    }
}

/// An image is put into tiles by several threads; one of them that waits may take up the commands of
/// another client meanwhile, which ask for the same image.
#[test]
#[cfg_attr(target_family = "wasm", ignore = "there are no threads there")]
fn clients_that_draw_to_one_image_at_a_time_do_not_wait_for_ever() {
    let device = &one();
    let mut level = Level::new(Format::Rgba8, 512, 512).expect("small");
    for (index, byte) in level.texels.iter_mut().enumerate() {
        *byte = (index * 37 % 253) as u8;
    }
    let mut texels = Texels::new(Shape::D2);
    texels.set_level(0, 0, level).expect("face 0");
    let target = &Image::new(texels);
    let desc = &pipeline(vertex(0), constant([1.0; 4]));
    std::thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(move || {
                for _ in 0..60 {
                    // Its tiles are made anew for each.
                    target.update(|_| ());
                    let begin = [pass(target, None, 512, 512), viewport(8, 8)];
                    let commands = begin.into_iter().chain(draw(desc, 0.0));
                    submit(device, commands.chain([Command::EndPass]));
                }
            });
        }
    });
}
