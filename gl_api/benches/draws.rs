//! What a draw costs: many draws of two triangles, with a change of state before each, on one
//! thread, from the call to the picture.
//!
//! `cargo bench -p gl_api --bench draws [words…]` runs the scenes whose names hold one of the words.
//! All are measured in turn, round after round; a number is the least of a scene's rounds.

#[path = "../tests/common/shading.rs"]
mod shading;

use gl_api::*;
use rasterizer::driver::{Device, DeviceDesc};
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;
use texunit::lanes::Isa;

const SIZE: u32 = 256;
const DRAWS: usize = 20_000;
const ROUNDS: usize = 7;

const VERTEX: &str = "varying vec2 uv;
void main() { uv = gl_Vertex.xy; gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }";
const FRAGMENT: &str = "varying vec2 uv; uniform vec4 tint; uniform sampler2D image;
void main() { gl_FragColor = texture2D(image, uv) * tint; }";

/// A way to draw two triangles for the `n`th time.
type Draw = fn(&mut Context, i32, usize);

/// Names, whether a program is in use, and the draws.
const SCENES: [(&str, Stages, Draw); 9] = [
    ("fixed_arrays", Stages::Fixed, |c, _, _| arrays(c)),
    ("fixed_elements", Stages::Fixed, |c, _, _| elements(c)),
    ("fixed_list", Stages::Fixed, |c, _, _| c.call_list(1)),
    ("fixed_color", Stages::Fixed, |c, _, n| {
        c.color_3f(n as f32 / DRAWS as f32, 0.5, 0.5);
        arrays(c);
    }),
    ("fixed_matrix", Stages::Fixed, |c, _, n| {
        c.load_identity();
        c.translatef((n % 16) as f32 / 16.0, (n / 16 % 16) as f32 / 16.0, 0.0);
        arrays(c);
    }),
    ("fixed_texture", Stages::Fixed, |c, _, n| {
        c.bind_texture(GL_TEXTURE_2D, 1 + (n % 2) as GLuint);
        arrays(c);
    }),
    ("glsl_arrays", Stages::Program, |c, _, _| arrays(c)),
    ("glsl_uniform", Stages::Program, |c, tint, n| {
        c.uniform_4f(tint, n as f32 / DRAWS as f32, 0.5, 0.5, 1.0);
        arrays(c);
    }),
    ("glsl_matrix", Stages::Program, |c, _, n| {
        c.load_identity();
        c.translatef((n % 16) as f32 / 16.0, (n / 16 % 16) as f32 / 16.0, 0.0);
        elements(c);
    }),
];

/// What shades.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Stages {
    Fixed,
    Program,
}

fn arrays(c: &mut Context) {
    c.draw_arrays(GL_TRIANGLES, 0, 6);
}

fn elements(c: &mut Context) {
    c.draw_elements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, Data::Offset(0));
}

/// A context with two textures, a small square in buffers and in list 1, and where `tint` is.
fn context(stages: Stages) -> (Context, i32) {
    let (isa, budget) = (Isa::best(), DeviceDesc::BUDGET);
    let desc = DeviceDesc { budget, ..DeviceDesc::new(isa, 1) };
    let device = Some(Arc::new(Device::new(desc).expect("a thread starts")));
    let desc = ContextDesc { width: SIZE, height: SIZE, device, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a device");
    for name in 1..3 {
        c.bind_texture(GL_TEXTURE_2D, name);
        let texels = [64 * name as u8; 16 * 16 * 4];
        let rgba = GL_RGBA as GLint;
        let data = Data::Bytes(&texels);
        c.tex_image_2d(GL_TEXTURE_2D, 0, rgba, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR as GLint);
    }
    c.enable(GL_TEXTURE_2D);
    let corners = [[0.0, 0.0], [0.05, 0.0], [0.05, 0.05], [0.0, 0.0], [0.05, 0.05], [0.0, 0.05f32]];
    let bytes: Vec<u8> = corners.concat().into_iter().flat_map(f32::to_le_bytes).collect();
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    c.buffer_data(GL_ARRAY_BUFFER, 48, Data::Bytes(&bytes), GL_STATIC_DRAW);
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.vertex_pointer(2, GL_FLOAT, 0, Data::Offset(0));
    let indices: Vec<u8> = (0..6u16).flat_map(u16::to_le_bytes).collect();
    c.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, 2);
    c.buffer_data(GL_ELEMENT_ARRAY_BUFFER, 12, Data::Bytes(&indices), GL_STATIC_DRAW);
    c.new_list(1, GL_COMPILE);
    arrays(&mut c);
    c.end_list();
    let mut tint = -1;
    if stages == Stages::Program {
        let program = shading::use_program(&mut c, VERTEX, FRAGMENT);
        tint = c.get_uniform_location(program, "tint");
        c.uniform_4f(tint, 1.0, 1.0, 1.0, 1.0);
    }
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    (c, tint)
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|arg| !arg.starts_with('-')).collect();
    let wanted = |name: &str| words.is_empty() || words.iter().any(|word| name.contains(word));
    let scenes = SCENES.into_iter().filter(|(name, ..)| wanted(name));
    let mut cells: Vec<_> = scenes
        .map(|(name, stages, draw)| (name, draw, context(stages), f64::INFINITY, f64::INFINITY))
        .collect();
    let mut pixel = [0; 4];
    for _ in 0..ROUNDS {
        for (_, draw, (c, tint), recorded, finished) in &mut cells {
            let start = Instant::now();
            for n in 0..DRAWS {
                draw(c, *tint, n);
            }
            let out = DataOut::Bytes(&mut pixel);
            *recorded = recorded.min(start.elapsed().as_secs_f64());
            c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, black_box(out));
            *finished = finished.min(start.elapsed().as_secs_f64());
            assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
        }
    }
    println!(
        "{:<16} {:>16} {:>16} {:>16}",
        "scene", "µs, to record", "µs, to finish", "draws a second"
    );
    for (name, _, _, recorded, finished) in cells {
        let each = |seconds: f64| seconds * 1e6 / DRAWS as f64;
        let rate = DRAWS as f64 / finished;
        println!("{name:<16} {:>16.2} {:>16.2} {rate:>16.0}", each(recorded), each(finished));
    }
}
