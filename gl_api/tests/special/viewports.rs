//! Viewports by number (ARB_viewport_array, AMD_vertex_shader_viewport_index, AMD_vertex_shader_layer,
//! ARB_fragment_layer_viewport): each primitive is drawn as by one call with the viewport, the depth range and the scissor
//! rectangle of its provoking vertex.

use super::{context, fine};
use gl_api::*;

const SIZE: u32 = 96;

/// A program of these sources, in use.
fn program(c: &mut Context, stages: &[(GLenum, &str)]) -> GLuint {
    let program = c.create_program();
    for (stage, source) in stages {
        let shader = c.create_shader(*stage);
        c.shader_source(shader, 1, Strings(vec![source]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
    }
    c.link_program(program);
    let mut log = String::new();
    c.get_program_info_log(program, 512, &mut [], TextOut::String(&mut log));
    c.use_program(program);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{log}");
    program
}

const HEAD: &str = "#version 150 compatibility
#extension GL_ARB_viewport_array : require
#extension GL_ARB_fragment_layer_viewport : require
#extension GL_AMD_vertex_shader_viewport_index : require
#extension GL_AMD_vertex_shader_layer : require
";
const VERTEX: &str = "out float number;
void main() { gl_Position = gl_Vertex; gl_FrontColor = gl_Color; number = gl_MultiTexCoord0.x; }";
const CHOOSING_VERTEX: &str = "void main() {
    gl_Position = gl_Vertex; gl_FrontColor = gl_Color; gl_ViewportIndex = int(gl_MultiTexCoord0.x);
}";
const FRAGMENT: &str = "void main() { gl_FragColor = gl_Color; }";

/// A geometry shader that passes primitives on, each vertex with the number of its viewport.
fn passing(input: &str, output: &str, vertices: u32) -> String {
    format!(
        "{HEAD}layout({input}) in; layout({output}, max_vertices = {vertices}) out; in float number[];
         void main() {{
             for (int i = 0; i < {vertices}; i++) {{
                 gl_Position = gl_in[i].gl_Position; gl_FrontColor = gl_in[i].gl_FrontColor;
                 gl_ViewportIndex = int(number[i]); EmitVertex();
             }}
         }}"
    )
}

/// The numbers of a linear congruential generator.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, limit: u32) -> u32 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % u64::from(limit)) as u32
    }

    fn within(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.below(1 << 16) as f32 / 65536.0
    }
}

struct Place {
    viewport: [f32; 4],
    depths: [f64; 2],
    scissor: Option<[i32; 4]>,
}

struct Vertex {
    at: [f32; 4],
    color: [f32; 4],
    viewport: u32,
}

/// Viewports beside each other: nothing of one is drawn over another.
fn tiles() -> Vec<Place> {
    let tile = |at: u32| Place {
        viewport: [at % 4, at / 4, 1, 1].map(|side| (side * SIZE / 4) as f32),
        depths: [0.0, f64::from(at) / 16.0],
        scissor: Some([at % 4, at / 4, 1, 1].map(|side| (side * SIZE / 4) as i32)),
    };
    (0..16).map(tile).collect()
}

fn places(random: &mut Numbers) -> Vec<Place> {
    let sides = |random: &mut Numbers, size: u32| {
        [0, 1].map(|axis| (random.below(SIZE) as f32 - 8.0, axis, random.below(size) as f32 + 8.0))
    };
    let place = |_| {
        let [(x, _, w), (y, _, h)] = sides(random, SIZE / 2);
        let near = random.below(4) as f64 / 8.0;
        let scissor = (random.below(2) == 0).then(|| {
            [0, 1, 2, 3].map(|at| random.below(SIZE / 2) as i32 + if at < 2 { 0 } else { 20 })
        });
        Place { viewport: [x, y, w, h], depths: [near, 1.0 - near / 2.0], scissor }
    };
    (0..16).map(place).collect()
}

fn vertices(random: &mut Numbers, count: usize, viewports: u32) -> Vec<Vertex> {
    (0..count)
        .map(|_| Vertex {
            at: [
                random.within(-1.5, 1.5),
                random.within(-1.5, 1.5),
                random.within(-1.2, 1.2),
                random.within(0.8, 1.4),
            ],
            color: [0; 4].map(|_| random.within(0.0, 1.0)),
            viewport: random.below(viewports),
        })
        .collect()
}

fn put(c: &mut Context, vertices: impl Iterator<Item = usize>, all: &[Vertex], mode: GLenum) {
    c.begin(mode);
    for at in vertices {
        let Vertex { at, color, viewport } = &all[at];
        c.color_4fv(color);
        c.tex_coord_1f(*viewport as f32);
        c.vertex_4fv(at);
    }
    c.end();
}

fn pixels(c: &mut Context) -> (Vec<u8>, Vec<u8>) {
    let side = SIZE as i32;
    let (mut colors, mut depths) =
        (vec![0; (SIZE * SIZE * 4) as usize], vec![0; (SIZE * SIZE * 4) as usize]);
    c.read_pixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut colors));
    c.read_pixels(
        0,
        0,
        side,
        side,
        GL_DEPTH_COMPONENT,
        GL_UNSIGNED_INT,
        DataOut::Bytes(&mut depths),
    );
    fine(c);
    (colors, depths)
}

fn cleared(c: &mut Context) {
    c.disable(GL_SCISSOR_TEST);
    c.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/// Sets the places as viewports of their numbers.
fn set_all(c: &mut Context, places: &[Place]) {
    for (at, place) in (0..).zip(places) {
        c.viewport_indexedfv(at, &place.viewport);
        c.depth_range_indexed(at, place.depths[0], place.depths[1]);
        match place.scissor {
            None => c.disablei(GL_SCISSOR_TEST, at),
            Some(area) => {
                c.scissor_indexedv(at, &area);
                c.enablei(GL_SCISSOR_TEST, at);
            }
        }
    }
}

/// Sets one place as the only viewport.
fn set_one(c: &mut Context, place: &Place) {
    let [x, y, w, h] = place.viewport.map(|side| side as i32);
    c.viewport(x, y, w, h);
    c.depth_range(place.depths[0], place.depths[1]);
    match place.scissor {
        None => c.disable(GL_SCISSOR_TEST),
        Some([x, y, w, h]) => {
            c.scissor(x, y, w, h);
            c.enable(GL_SCISSOR_TEST);
        }
    }
}

/// How viewports lie to each other.
#[derive(Clone, Copy, Debug)]
enum Lie {
    Beside,
    Over,
}

/// The mode of the draw and of each of its primitives, the vertices of primitive `i`, which of them provokes by each
/// convention, and the geometry shader's primitives, if it is drawn with one.
struct Case {
    mode: GLenum,
    each: GLenum,
    vertices: fn(usize) -> Vec<usize>,
    provoking: [usize; 2],
    geometry: Option<[&'static str; 2]>,
}

const CASES: &[Case] = &[
    Case {
        mode: GL_TRIANGLES,
        each: GL_TRIANGLES,
        vertices: |i| vec![3 * i, 3 * i + 1, 3 * i + 2],
        provoking: [0, 2],
        geometry: Some(["triangles", "triangle_strip"]),
    },
    Case {
        mode: GL_TRIANGLES,
        each: GL_TRIANGLES,
        vertices: |i| vec![3 * i, 3 * i + 1, 3 * i + 2],
        provoking: [0, 2],
        geometry: None,
    },
    // Vertices are shared by primitives of different viewports.
    Case {
        mode: GL_TRIANGLE_FAN,
        each: GL_TRIANGLES,
        vertices: |i| vec![0, i + 1, i + 2],
        provoking: [1, 2],
        geometry: None,
    },
    Case {
        mode: GL_LINES,
        each: GL_LINES,
        vertices: |i| vec![2 * i, 2 * i + 1],
        provoking: [0, 1],
        geometry: Some(["lines", "line_strip"]),
    },
    Case {
        mode: GL_LINE_STRIP,
        each: GL_LINES,
        vertices: |i| vec![i, i + 1],
        provoking: [0, 1],
        geometry: None,
    },
    Case {
        mode: GL_POINTS,
        each: GL_POINTS,
        vertices: |i| vec![i],
        provoking: [0, 0],
        geometry: Some(["points", "points"]),
    },
    Case {
        mode: GL_POINTS,
        each: GL_POINTS,
        vertices: |i| vec![i],
        provoking: [0, 0],
        geometry: None,
    },
];

/// `lie`: how the viewports lie.
fn check(case: &Case, convention: usize, mode: GLenum, depth: bool, (viewports, lie): (u32, Lie)) {
    let mut random = Numbers(7 + u64::from(viewports));
    let places = match lie {
        Lie::Beside => tiles(),
        Lie::Over => places(&mut random),
    };
    let vertices = vertices(&mut random, 600, viewports);
    let primitives = (0..).take_while(|&i| (case.vertices)(i).iter().all(|&at| at < 600)).count();
    let mut c = context(SIZE, SIZE);
    let [vertex, choosing, fragment] =
        [VERTEX, CHOOSING_VERTEX, FRAGMENT].map(|s| format!("{HEAD}{s}"));
    c.point_size(5.0);
    c.line_width(3.0);
    c.polygon_mode(GL_FRONT_AND_BACK, mode);
    c.provoking_vertex([GL_FIRST_VERTEX_CONVENTION, GL_LAST_VERTEX_CONVENTION][convention]);
    c.shade_model(GL_FLAT);
    if depth {
        c.enable(GL_DEPTH_TEST);
    }
    let plain = program(&mut c, &[(GL_VERTEX_SHADER, &vertex), (GL_FRAGMENT_SHADER, &fragment)]);
    cleared(&mut c);
    for i in 0..primitives {
        let own = (case.vertices)(i);
        set_one(&mut c, &places[vertices[own[case.provoking[convention]]].viewport as usize]);
        put(&mut c, own.into_iter(), &vertices, case.each);
    }
    let expected = pixels(&mut c);
    c.delete_program(plain);
    match case.geometry {
        Some([input, output]) => {
            let count = (case.vertices)(0).len() as u32;
            let geometry = passing(input, output, count);
            program(
                &mut c,
                &[
                    (GL_VERTEX_SHADER, &vertex),
                    (GL_GEOMETRY_SHADER, &geometry),
                    (GL_FRAGMENT_SHADER, &fragment),
                ],
            );
        }
        None => {
            program(&mut c, &[(GL_VERTEX_SHADER, &choosing), (GL_FRAGMENT_SHADER, &fragment)]);
        }
    }
    cleared(&mut c);
    set_all(&mut c, &places);
    put(&mut c, 0..600, &vertices, case.mode);
    let found = pixels(&mut c);
    assert!(expected.0.iter().any(|&byte| byte != 0));
    let name = enum_name(case.mode);
    assert!(
        found == expected,
        "{name} {convention} {} {depth} {viewports} {lie:?}",
        enum_name(mode)
    );
}

#[test]
fn primitives_are_drawn_as_by_calls_with_their_viewports() {
    for case in CASES {
        for convention in [0, 1] {
            let all = [
                (false, (16, Lie::Over)),
                (true, (16, Lie::Over)),
                (false, (2, Lie::Over)),
                (false, (16, Lie::Beside)),
            ];
            for (depth, viewports) in all {
                // A fan's triangles have another first vertex where each is drawn alone.
                if case.mode == GL_TRIANGLE_FAN && convention == 0 {
                    continue;
                }
                check(case, convention, GL_FILL, depth, viewports);
            }
        }
    }
    check(&CASES[0], 1, GL_LINE, true, (16, Lie::Over));
    check(&CASES[1], 0, GL_POINT, true, (5, Lie::Over));
}

/// Indices share shaded vertices across primitives of different viewports, instances have vertices of their own, and a
/// strip's stipple goes on from viewport to viewport as it does in one.
#[test]
fn shared_vertices_instances_and_stipples_are_those_of_one_viewport() {
    let fragment = format!("{HEAD}{FRAGMENT}");
    let choosing = format!(
        "{HEAD}uniform int viewports;
         void main() {{
             gl_Position = gl_Vertex + vec4(0.1 * float(gl_InstanceID)); gl_FrontColor = gl_Color;
             gl_ViewportIndex = (gl_VertexID + gl_InstanceID) % viewports;
         }}"
    );
    let mut random = Numbers(3);
    let all = vertices(&mut random, 300, 1);
    let bytes: Vec<u8> = all.iter().flat_map(|v| v.at).flat_map(f32::to_le_bytes).collect();
    let colors: Vec<u8> = all.iter().flat_map(|v| v.color).flat_map(f32::to_le_bytes).collect();
    let indices: Vec<u8> =
        (0..900).flat_map(|_| (random.below(300) as u16).to_le_bytes()).collect();
    // The same viewport under all numbers, so that numbers must not matter.
    let draw = |viewports: i32, mode: GLenum| {
        let mut c = context(SIZE, SIZE);
        let program =
            program(&mut c, &[(GL_VERTEX_SHADER, &choosing), (GL_FRAGMENT_SHADER, &fragment)]);
        let location = c.get_uniform_location(program, "viewports");
        c.uniform_1i(location, viewports);
        c.viewport(10, 5, 80, 90);
        // Another depth range alone has the other viewports told from the first.
        c.depth_range_indexed(15, 0.0, 0.5);
        c.line_stipple(3, 0x3A5F);
        c.enable(GL_LINE_STIPPLE);
        c.shade_model(GL_FLAT);
        for (buffer, bytes) in (1..).zip([&bytes, &colors]) {
            c.bind_buffer(GL_ARRAY_BUFFER, buffer);
            c.buffer_data(
                GL_ARRAY_BUFFER,
                bytes.len() as isize,
                Data::Bytes(bytes),
                GL_STATIC_DRAW,
            );
            match buffer {
                1 => c.vertex_pointer(4, GL_FLOAT, 0, Data::Offset(0)),
                _ => c.color_pointer(4, GL_FLOAT, 0, Data::Offset(0)),
            }
        }
        c.enable_client_state(GL_VERTEX_ARRAY);
        c.enable_client_state(GL_COLOR_ARRAY);
        c.draw_elements_instanced(mode, 900, GL_UNSIGNED_SHORT, Data::Bytes(&indices), 3);
        pixels(&mut c)
    };
    for mode in [GL_TRIANGLES, GL_LINE_STRIP, GL_LINE_LOOP, GL_QUADS] {
        let expected = draw(1, mode);
        assert!(expected.0.iter().any(|&byte| byte != 0));
        assert!(draw(15, mode) == expected, "{}", enum_name(mode));
    }
}

/// What a number without viewport or layer is: the first viewport, no layer; the fragment stage reads what was written,
/// and 0 where nothing was.
#[test]
fn fragments_read_what_was_written() {
    let mut c = context(SIZE, SIZE);
    let fragment = format!(
        "{HEAD}uniform ivec2 written;
         void main() {{
             bool same = gl_Layer == written.x && gl_ViewportIndex == written.y;
             gl_FragColor = same ? vec4(0.0, 1.0, 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);
         }}"
    );
    let body = "void main() { gl_Position = gl_Vertex; gl_Layer = written.x; gl_ViewportIndex = written.y; }";
    let vertex = format!("{HEAD}uniform ivec2 written; {body}");
    let silent = format!("{HEAD}{VERTEX}");
    let geometry = format!(
        "{HEAD}layout(triangles) in; layout(triangle_strip, max_vertices = 3) out; uniform ivec2 written;
         void main() {{
             for (int i = 0; i < 3; i++) {{
                 gl_Position = gl_in[i].gl_Position; gl_Layer = written.x; gl_ViewportIndex = written.y;
                 EmitVertex();
             }}
         }}"
    );
    let green = [0, 255, 0, 255];
    let programs: [&[(GLenum, &str)]; 3] = [
        &[(GL_VERTEX_SHADER, &vertex), (GL_FRAGMENT_SHADER, &fragment)],
        &[
            (GL_VERTEX_SHADER, &silent),
            (GL_GEOMETRY_SHADER, &geometry),
            (GL_FRAGMENT_SHADER, &fragment),
        ],
        &[(GL_VERTEX_SHADER, &silent), (GL_FRAGMENT_SHADER, &fragment)],
    ];
    for (at, stages) in programs.iter().enumerate() {
        let program = program(&mut c, stages);
        let location = c.get_uniform_location(program, "written");
        let pairs: &[[i32; 2]] = match at {
            2 => &[[0, 0]],
            _ => &[[0, 0], [3, 5], [-1, 16], [70_000, -70_000]],
        };
        for pair in pairs {
            c.clear(GL_COLOR_BUFFER_BIT);
            c.uniform_2iv(location, 1, pair);
            super::draw(
                &mut c,
                GL_TRIANGLES,
                &[[-1.0, -1.0, 0.0], [3.0, -1.0, 0.0], [-1.0, 3.0, 0.0]],
            );
            assert_eq!(super::pixel(&mut c, 40, 40), green, "{at} {pair:?}");
        }
    }
}

/// The vertex stage chooses layers where there is no geometry stage (AMD_vertex_shader_layer).
#[test]
fn vertices_choose_layers() {
    let mut c = context(SIZE, SIZE);
    let vertex = format!(
        "{HEAD}void main() {{
             gl_Position = gl_Vertex; gl_FrontColor = gl_Color; gl_Layer = int(gl_MultiTexCoord0.x);
         }}"
    );
    let fragment = format!("{HEAD}{FRAGMENT}");
    c.bind_texture(GL_TEXTURE_2D_ARRAY, 1);
    c.tex_image_3d(
        GL_TEXTURE_2D_ARRAY,
        0,
        GL_RGBA8 as i32,
        4,
        4,
        4,
        0,
        GL_RGBA,
        GL_UNSIGNED_BYTE,
        Data::Null,
    );
    c.bind_framebuffer(GL_FRAMEBUFFER, 1);
    c.framebuffer_texture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, 1, 0);
    c.viewport(0, 0, 4, 4);
    program(&mut c, &[(GL_VERTEX_SHADER, &vertex), (GL_FRAGMENT_SHADER, &fragment)]);
    c.clear(GL_COLOR_BUFFER_BIT);
    for (layer, red) in [(2.0, 51), (0.0, 102), (3.0, 153), (4.0, 255), (-1.0, 255)] {
        c.color_3ub(red, 0, 0);
        c.tex_coord_1f(layer);
        c.rectf(-1.0, -1.0, 1.0, 1.0);
    }
    let mut texels = vec![0; 4 * 4 * 4 * 4];
    c.get_tex_image(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut texels));
    fine(&mut c);
    let reds: Vec<u8> = texels.chunks(64).map(|layer| layer[0]).collect();
    assert_eq!(reds, [102, 0, 51, 153]);
    assert!(texels.chunks(64).all(|layer| layer.chunks(4).all(|texel| texel[0] == layer[0])));
}

fn numbers(c: &mut Context, name: GLenum, index: u32) -> Vec<f64> {
    let mut values = [-1.0; 4];
    c.get_doublei_v(name, index, &mut values);
    values[..if name == GL_DEPTH_RANGE { 2 } else { 4 }].to_vec()
}

/// Commands without a number set all viewports, those with one set one; `glPushAttrib` keeps all.
#[test]
fn state_has_numbers() {
    let mut c = context(16, 8);
    let names = [GL_VIEWPORT, GL_SCISSOR_BOX, GL_DEPTH_RANGE];
    let initial: [&[f64]; 3] = [&[0.0, 0.0, 16.0, 8.0], &[0.0, 0.0, 16.0, 8.0], &[0.0, 1.0]];
    for (name, expected) in names.into_iter().zip(initial) {
        (0..16).for_each(|at| assert_eq!(numbers(&mut c, name, at), expected));
    }
    c.push_attrib(GL_VIEWPORT_BIT | GL_SCISSOR_BIT);
    c.viewport_arrayv(2, 2, &[0.5, 1.25, 2.5, 3.75, -4.0, -5.0, 99999.0, 7.0]);
    c.scissor_arrayv(14, 2, &[1, 2, 3, 4, 5, 6, 7, 8]);
    c.depth_range_arrayv(0, 2, &[0.25, 0.5, -1.0, 2.0]);
    c.enablei(GL_SCISSOR_TEST, 9);
    assert_eq!(numbers(&mut c, GL_VIEWPORT, 2), [0.5, 1.25, 2.5, 3.75]);
    assert_eq!(numbers(&mut c, GL_VIEWPORT, 3), [-4.0, -5.0, 8192.0, 7.0]);
    assert_eq!(numbers(&mut c, GL_VIEWPORT, 1), initial[0]);
    assert_eq!(numbers(&mut c, GL_SCISSOR_BOX, 15), [5.0, 6.0, 7.0, 8.0]);
    assert_eq!(numbers(&mut c, GL_SCISSOR_BOX, 0), initial[1]);
    assert_eq!(numbers(&mut c, GL_DEPTH_RANGE, 0), [0.25, 0.5]);
    assert_eq!(numbers(&mut c, GL_DEPTH_RANGE, 1), [0.0, 1.0]);
    let tests = |c: &mut Context| -> Vec<u32> {
        (0..16).filter(|&at| c.is_enabledi(GL_SCISSOR_TEST, at)).collect()
    };
    assert_eq!((tests(&mut c), c.is_enabled(GL_SCISSOR_TEST)), (vec![9], false));
    c.push_attrib(GL_ENABLE_BIT);
    c.enable(GL_SCISSOR_TEST);
    c.disablei(GL_SCISSOR_TEST, 0);
    assert_eq!(tests(&mut c), (1..16).collect::<Vec<_>>());
    c.pop_attrib();
    assert_eq!(tests(&mut c), [9]);
    c.disable(GL_SCISSOR_TEST);
    assert_eq!(tests(&mut c), []);
    c.viewport(1, 2, 3, 4);
    c.scissor(5, 6, 7, 8);
    c.depth_range(0.5, 0.75);
    let common: [&[f64]; 3] = [&[1.0, 2.0, 3.0, 4.0], &[5.0, 6.0, 7.0, 8.0], &[0.5, 0.75]];
    for (name, expected) in names.into_iter().zip(common) {
        (0..16).for_each(|at| assert_eq!(numbers(&mut c, name, at), expected));
    }
    c.viewport_indexedf(0, 9.0, 9.0, 9.0, 9.0);
    let mut first = [0; 4];
    c.get_integerv(GL_VIEWPORT, &mut first);
    assert_eq!((first, numbers(&mut c, GL_VIEWPORT, 1)), ([9; 4], common[0].to_vec()));
    c.pop_attrib();
    for (name, expected) in names.into_iter().zip(initial) {
        (0..16).for_each(|at| assert_eq!(numbers(&mut c, name, at), expected));
    }
    fine(&mut c);
}

/// Display lists hold the arrays as they were.
#[test]
fn lists_hold_arrays() {
    let mut c = context(16, 8);
    let mut sides = [1.0, 2.0, 3.0, 4.0];
    c.new_list(1, GL_COMPILE);
    c.viewport_arrayv(5, 1, &sides);
    c.scissor_indexed(6, 1, 2, 3, 4);
    c.end_list();
    sides[0] = 7.0;
    assert_eq!(numbers(&mut c, GL_VIEWPORT, 5), [0.0, 0.0, 16.0, 8.0]);
    c.call_list(1);
    assert_eq!(numbers(&mut c, GL_VIEWPORT, 5), [1.0, 2.0, 3.0, 4.0]);
    assert_eq!(numbers(&mut c, GL_SCISSOR_BOX, 6), [1.0, 2.0, 3.0, 4.0]);
    assert_ne!(numbers(&mut c, GL_VIEWPORT, 5)[0], f64::from(sides[0]));
    fine(&mut c);
}
