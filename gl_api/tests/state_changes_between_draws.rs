//! Draws between which little changes, as matrices, uniforms, current values or where vertices come from: the
//! picture, the errors and the messages are those of draws that are each carried out before the next call.

#[path = "common/random.rs"]
mod random;
#[path = "common/shading.rs"]
mod shading;
#[path = "common/switches.rs"]
mod switches;
#[path = "common/ways.rs"]
mod ways;

use gl_api::*;
use proptest::prelude::*;
use random::Random;
use switches::enable_some;
use ways::{Way, picture};

const SIZE: u32 = 64;
/// Vertices of each buffer: twelve floats.
const VERTICES: usize = 60;
const STRIDE: GLsizei = 48;

const PROGRAM: [&str; 2] = [
    "attribute vec4 shade; varying vec4 color; varying vec2 place; uniform vec2 move;
     void main() { color = shade + 0.5 * gl_Color; place = gl_Vertex.xy * 9.0;
         gl_Position = ftransform() + vec4(move, 0.0, 0.0); }",
    "uniform sampler2D image; uniform float part; varying vec4 color; varying vec2 place;
     void main() { gl_FragColor = mix(color, texture2D(image, place), part); }",
];

/// Its name and the places of its uniforms: to ask for them between draws would be a call as well.
const NAME: GLuint = 1;
const MOVE: GLint = 0;
const IMAGE: GLint = 1;
const PART: GLint = 2;

fn program(c: &mut Context) {
    let [vertex, fragment] = PROGRAM;
    let program = shading::use_program(c, vertex, fragment);
    let places = ["move", "image", "part"].map(|name| c.get_uniform_location(program, name));
    assert_eq!((program, places), (NAME, [MOVE, IMAGE, PART]));
}

fn context(random: &mut Random) -> Context {
    let desc = ContextDesc { width: SIZE, height: SIZE, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a device");
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    c.enable(GL_BLEND);
    c.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    let switches = [
        GL_LIGHTING,
        GL_COLOR_MATERIAL,
        GL_TEXTURE_2D,
        GL_TEXTURE_GEN_S,
        GL_FOG,
        GL_CLIP_PLANE0,
        GL_NORMALIZE,
        GL_CULL_FACE,
    ];
    enable_some(&mut c, random, &switches, 3);
    c.enable(GL_LIGHT0);
    c.lightfv(GL_LIGHT0, GL_SPECULAR, &[0.5; 4]);
    c.materialf(GL_FRONT_AND_BACK, GL_SHININESS, 5.0);
    c.color_material(GL_FRONT_AND_BACK, random.pick(&[GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR]));
    c.tex_geni(GL_S, GL_TEXTURE_GEN_MODE, random.pick(&[GL_EYE_LINEAR, GL_OBJECT_LINEAR]) as GLint);
    c.clip_plane(GL_CLIP_PLANE0, &[1.0, 0.5, 0.0, 0.3]);
    c.polygon_mode(GL_FRONT_AND_BACK, random.pick(&[GL_FILL, GL_FILL, GL_LINE]));
    scene(&mut c, random);
    if random.below(2) == 0 {
        program(&mut c);
    }
    c
}

/// Textures, buffers, and an array of positions.
fn scene(c: &mut Context, random: &mut Random) {
    for texture in [2, 1] {
        let texels: Vec<u8> = (0..256).map(|_| random.below(256) as u8).collect();
        c.bind_texture(GL_TEXTURE_2D, texture);
        let filter = if texture == 1 { GL_LINEAR } else { GL_NEAREST };
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter as GLint);
        let data = Data::Bytes(&texels);
        c.tex_image_2d(GL_TEXTURE_2D, 0, 4, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, data);
    }
    c.active_texture(GL_TEXTURE1);
    c.bind_texture(GL_TEXTURE_2D, 2);
    c.active_texture(GL_TEXTURE0);
    for buffer in 1..=2 {
        let floats: Vec<f32> = (0..VERTICES * 12).map(|_| random.float()).collect();
        c.bind_buffer(GL_ARRAY_BUFFER, buffer);
        let bytes = bytemuck::cast_slice(&floats);
        c.buffer_data(GL_ARRAY_BUFFER, bytes.len() as _, Data::Bytes(bytes), GL_STREAM_DRAW);
    }
    let indices: Vec<u8> = (0..200).map(|_| random.below(VERTICES as u64) as u8).collect();
    c.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, 3);
    c.buffer_data(GL_ELEMENT_ARRAY_BUFFER, 200, Data::Bytes(&indices), GL_STATIC_DRAW);
    c.enable_client_state(GL_VERTEX_ARRAY);
    c.vertex_pointer(2, GL_FLOAT, STRIDE, Data::Offset(0));
}

fn draw(c: &mut Context, random: &mut Random, mode: GLenum) {
    let first = random.pick(&[0, 3, 12, 57, 58]);
    match random.below(5) {
        0 => c.draw_elements(mode, 6, GL_UNSIGNED_BYTE, Data::Offset(random.below(180) as usize)),
        1 => {
            c.begin(mode);
            for _ in 0..3 {
                if random.below(3) == 0 {
                    current(c, random);
                }
                c.vertex_2f(random.float(), random.float());
            }
            c.end();
        }
        2 => c.multi_draw_arrays(mode, &[first, 9], &[3, 6], 2),
        _ => c.draw_arrays(mode, first, random.pick(&[3, 3, 6])),
    }
}

/// Sets the raster position, and draws a few pixels there.
fn raster(c: &mut Context, random: &mut Random) {
    match random.below(5) {
        0 => c.window_pos_2f(random.float().abs() * 60.0, 30.0),
        1 => c.raster_pos_4f(random.float(), random.float(), 0.1, random.pick(&[1.0, 1.5, 0.0])),
        _ => c.raster_pos_3f(random.float() * 0.7, random.float() * 0.7, random.float()),
    }
    if random.below(3) > 0 {
        c.bitmap(
            3,
            2,
            0.0,
            0.0,
            2.0,
            random.pick(&[0.0, 1.0]),
            Data::Bytes(&[0xA0, 0, 0, 0, 0x60]),
        );
    }
}

/// Sets a current value.
fn current(c: &mut Context, random: &mut Random) {
    let (x, y) = (random.float(), random.float().abs());
    match random.below(9) {
        0 => c.normal_3f(x, y, 0.5),
        1 => c.edge_flag(x < 0.0),
        2 => c.tex_coord_4f(x, y, 0.0, random.pick(&[1.0, 1.0, 0.5])),
        3 => c.vertex_attrib_4f(1, x, y, 0.5, 1.0),
        4 => c.fog_coordf(x),
        5 => c.materialfv(GL_FRONT, GL_DIFFUSE, &[y, 0.5, 0.1, 1.0]),
        6 => c.color_3f(0.0, 0.0, 0.0),
        7 => c.multi_tex_coord_2f(GL_TEXTURE3, x, y),
        _ => c.color_4f(x.abs(), y, 0.3, random.pick(&[0.4, 1.0])),
    }
}

fn matrix(c: &mut Context, random: &mut Random) {
    let (x, y) = (random.float() * 0.5, random.float() * 0.5);
    match random.below(9) {
        0 => c.matrix_mode(random.pick(&[GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE])),
        1 => c.load_identity(),
        2 => c.push_matrix(),
        3 => c.pop_matrix(),
        4 => c.rotatef(x * 90.0, y, 0.2, 1.0),
        5 => c.scalef(1.0 + x, 1.0 - y, 1.0),
        6 => {
            let mut projected = [0.0; 16];
            (0..4).for_each(|at| projected[at * 5] = 1.0);
            (projected[3], projected[12]) = (x * 0.5, y);
            c.load_matrixf(&projected);
        }
        _ => c.translatef(x, y, 0.0),
    }
}

fn arrays(c: &mut Context, random: &mut Random) {
    let offset = Data::Offset(random.pick(&[0, 8, 16]));
    match random.below(10) {
        0 => c.bind_buffer(GL_ARRAY_BUFFER, random.pick(&[1, 2])),
        1 => c.vertex_pointer(random.pick(&[2, 2, 3]), GL_FLOAT, STRIDE, offset),
        2 => c.color_pointer(random.pick(&[3, 4]), GL_FLOAT, STRIDE, offset),
        3 => c.tex_coord_pointer(random.pick(&[2, 4]), GL_FLOAT, STRIDE, offset),
        4 => c.vertex_attrib_pointer(1, 4, GL_FLOAT, false, STRIDE, offset),
        5 => c.enable_vertex_attrib_array(1),
        6 => c.disable_vertex_attrib_array(1),
        7 => {
            let sets = [
                Context::enable_client_state as fn(&mut Context, GLenum),
                Context::disable_client_state,
            ];
            let array = random.pick(&[GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_NORMAL_ARRAY]);
            random.pick(&sets)(c, array);
        }
        8 => c.interleaved_arrays(
            random.pick(&[GL_T2F_V3F, GL_C4F_N3F_V3F]),
            STRIDE,
            Data::Offset(0),
        ),
        _ => {
            // What is written is copied in parts from then on.
            let floats = [random.float(), random.float()];
            let bytes = Data::Bytes(bytemuck::cast_slice(&floats));
            c.buffer_sub_data(GL_ARRAY_BUFFER, 48 * random.below(5) as GLintptr, 8, bytes);
        }
    }
}

fn uniform(c: &mut Context, random: &mut Random) {
    // Without a program in use, an error.
    match random.below(5) {
        0 => c.uniform_1i(IMAGE, random.pick(&[0, 1, 5])),
        1 => c.uniform_1f(PART, random.pick(&[0.0, 0.5])),
        2 => c.use_program(random.pick(&[0, NAME, NAME, NAME])),
        _ => c.uniform_2f(MOVE, random.float() * 0.5, random.float() * 0.5),
    }
}

/// Changes what draws are decided by.
fn state(c: &mut Context, random: &mut Random) {
    let cap = random.pick(&[GL_LIGHTING, GL_TEXTURE_2D, GL_FOG, GL_CLIP_PLANE0, GL_DEPTH_TEST]);
    match random.below(7) {
        0 => c.enable(cap),
        1 => c.disable(cap),
        2 => c.bind_texture(GL_TEXTURE_2D, random.pick(&[1, 2])),
        3 => c.clip_plane(GL_CLIP_PLANE0, &[0.5, random.float().into(), 0.0, 0.4]),
        4 => c.lightfv(GL_LIGHT0, GL_POSITION, &[random.float(), 0.5, 1.0, 0.0]),
        5 => c.push_attrib(GL_CURRENT_BIT | GL_TRANSFORM_BIT),
        _ => c.pop_attrib(),
    }
}

/// The raster position, and what goes with it.
fn raster_state(c: &mut Context) -> Vec<[u32; 4]> {
    let mut state = |pname| {
        let mut values = [0.0; 4];
        c.get_floatv(pname, &mut values);
        values.map(f32::to_bits)
    };
    let mut all: Vec<[u32; 4]> = [
        GL_CURRENT_RASTER_POSITION,
        GL_CURRENT_RASTER_POSITION_VALID,
        GL_CURRENT_RASTER_DISTANCE,
        GL_CURRENT_RASTER_COLOR,
        GL_CURRENT_RASTER_SECONDARY_COLOR,
    ]
    .map(&mut state)
    .into();
    for unit in [GL_TEXTURE3, GL_TEXTURE0] {
        c.active_texture(unit);
        let mut values = [0.0; 4];
        c.get_floatv(GL_CURRENT_RASTER_TEXTURE_COORDS, &mut values);
        all.push(values.map(f32::to_bits));
    }
    all
}

type Outcome = (Vec<u8>, GLenum, Vec<String>, Vec<[u32; 4]>);

fn outcome(seed: u64, way: Way) -> Outcome {
    let mut random = Random(seed);
    let c = &mut context(&mut random);
    let modes: &[GLenum] = random.pick(&[
        &[GL_TRIANGLES][..],
        &[GL_TRIANGLES, GL_TRIANGLE_STRIP],
        &[GL_LINES, GL_TRIANGLES, GL_POINTS],
    ]);
    let changes = random.pick(&[
        &[current as fn(&mut Context, &mut Random), matrix, arrays, uniform][..],
        &[matrix, matrix, current, state],
        &[current, uniform, uniform],
        &[arrays, arrays, current, state],
        &[raster, raster, current, matrix],
        &[raster, raster, raster, current, matrix, uniform, state],
    ]);
    for _ in 0..random.below(50) + 5 {
        let mode = random.pick(modes);
        match random.below(12) {
            0 => {
                c.new_list(1, random.pick(&[GL_COMPILE, GL_COMPILE_AND_EXECUTE]));
                random.pick(changes)(c, &mut random);
                draw(c, &mut random, mode);
                c.end_list();
            }
            1 => c.call_list(1),
            2..6 => draw(c, &mut random, mode),
            _ => random.pick(changes)(c, &mut random),
        }
        way.go_on(c);
    }
    let picture = picture(c, SIZE);
    let mut messages: Vec<String> = c.messages().into_iter().map(|message| message.text).collect();
    // A bitmap that waits says later what there is to be said of it.
    messages.sort_unstable();
    (picture, c.get_error(), messages, raster_state(c))
}

/// A change that is one of a number in most draws, and decides something in this one.
#[test]
fn what_looks_like_a_number_and_is_none_is_seen() {
    type Call = fn(&mut Context);
    let cases: &[(Call, Call)] = &[
        (|c| c.enable(GL_TEXTURE_2D), |c| c.tex_coord_4f(0.3, 0.3, 0.0, 0.5)),
        (
            |c| c.enable(GL_TEXTURE_2D),
            |c| c.tex_coord_pointer(4, GL_FLOAT, STRIDE, Data::Offset(16)),
        ),
        (|c| c.polygon_mode(GL_FRONT_AND_BACK, GL_LINE), |c| c.edge_flag(false)),
        (
            |c| {
                c.color_material(GL_FRONT_AND_BACK, GL_SPECULAR);
                for cap in [GL_COLOR_MATERIAL, GL_LIGHTING, GL_LIGHT0] {
                    c.enable(cap);
                }
                c.color_3f(0.0, 0.0, 0.0);
                c.normal_3f(0.0, 0.0, 1.0);
            },
            |c| c.color_3f(1.0, 0.5, 0.2),
        ),
        (
            |c| {
                c.enable(GL_TEXTURE_2D);
                c.tex_coord_3f(0.1, 0.2, 0.0);
                c.matrix_mode(GL_TEXTURE);
            },
            |c| c.translatef(0.4, 0.4, 0.0),
        ),
        (
            |c| {
                program(c);
                c.uniform_1f(PART, 1.0);
            },
            |c| c.uniform_1i(IMAGE, 1),
        ),
    ];
    let draws: [Call; 2] = [
        |c| c.draw_arrays(GL_TRIANGLES, 0, 30),
        |c| {
            c.raster_pos_2f(0.1, 0.2);
            c.bitmap(8, 1, 0.0, 0.0, 0.0, 0.0, Data::Bytes(&[0xFF]));
        },
    ];
    let cases = cases.iter().enumerate().flat_map(|case| draws.map(|draw| (case, draw)));
    for ((number, (before, change)), draw) in cases {
        let outcome = |way: Way| {
            let desc = ContextDesc { width: SIZE, height: SIZE, ..ContextDesc::default() };
            let mut c = Context::new(desc).expect("a device");
            scene(&mut c, &mut Random(5));
            before(&mut c);
            for _ in 0..2 {
                draw(&mut c);
                way.go_on(&mut c);
                change(&mut c);
                c.translatef(0.01, 0.0, 0.0);
            }
            let picture = picture(&mut c, SIZE);
            assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
            picture
        };
        assert!(outcome(Way::Apart) == outcome(Way::Together), "case {number}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn what_changes_little_is_drawn_as_what_is_drawn_alone(seed: u64) {
        let (apart, together) = (outcome(seed, Way::Apart), outcome(seed, Way::Together));
        prop_assert_eq!(&together.1, &apart.1);
        prop_assert_eq!(&together.2, &apart.2);
        prop_assert_eq!(&together.3, &apart.3);
        prop_assert!(together.0 == apart.0, "the picture differs");
    }
}
