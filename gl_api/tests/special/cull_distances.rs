//! `gl_CullDistance` (ARB_cull_distance): what has one negative distance at all vertices is not drawn, anything else whole.

use super::shading::use_program;
use gl_api::*;

const RED: [u8; 4] = [255, 0, 0, 255];
const HEAD: &str = "#version 150 compatibility\n#extension GL_ARB_cull_distance : require\n";
const FRAGMENT: &str = "void main() { gl_FragColor = vec4(1.0, 0.0, 0.0, 1.0); }";

fn context() -> Context {
    Context::new(ContextDesc { width: 8, height: 8, ..ContextDesc::default() }).expect("a device")
}

/// Vertices in the middle of the window, or around all of it; `distances` are the first two of each.
fn draw(c: &mut Context, mode: GLenum, distances: &[[f32; 2]]) -> [u8; 4] {
    c.clear(GL_COLOR_BUFFER_BIT);
    c.point_size(8.0);
    c.line_width(8.0);
    let around: &[[f32; 2]] = match distances.len() {
        1 => &[[0.0, 0.0]],
        2 => &[[-2.0, 0.0], [2.0, 0.0]],
        _ => &[[-4.0, -4.0], [4.0, -4.0], [0.0, 4.0]],
    };
    c.begin(mode);
    for (at, of) in around.iter().zip(distances) {
        c.tex_coord_2f(of[0], of[1]);
        c.vertex_2f(at[0], at[1]);
    }
    c.end();
    let mut pixel = [0; 4];
    c.read_pixels(4, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    pixel
}

const CASES: &[(GLenum, &[[f32; 2]], bool)] = &[
    (GL_TRIANGLES, &[[-1.0, 1.0]; 3], false),
    (GL_TRIANGLES, &[[1.0, -0.5]; 3], false),
    (GL_TRIANGLES, &[[0.0, 0.0]; 3], true),
    // One vertex that is inside keeps all of it.
    (GL_TRIANGLES, &[[-1.0, 1.0], [-1.0, 1.0], [0.0, 1.0]], true),
    // Each vertex is outside, but not of one distance.
    (GL_TRIANGLES, &[[-1.0, 1.0], [-1.0, 1.0], [1.0, -1.0]], true),
    (GL_LINES, &[[-1.0, 1.0]; 2], false),
    (GL_LINES, &[[-1.0, 1.0], [1.0, -1.0]], true),
    (GL_POINTS, &[[1.0, -1.0]], false),
    (GL_POINTS, &[[1.0, 0.0]], true),
];

/// Edges and corners that a polygon is drawn as are no primitives of their own.
#[test]
fn polygons_that_are_drawn_as_lines_or_points_are_culled_as_polygons() {
    let vertex = format!(
        "{HEAD}out float gl_CullDistance[1];
         void main() {{ gl_Position = gl_Vertex; gl_CullDistance[0] = gl_MultiTexCoord0.x; }}"
    );
    let mut c = context();
    use_program(&mut c, &vertex, FRAGMENT);
    let mut lit = |mode: GLenum, distances: [f32; 3]| {
        c.clear(GL_COLOR_BUFFER_BIT);
        c.polygon_mode(GL_FRONT_AND_BACK, mode);
        c.begin(GL_TRIANGLES);
        for ([x, y], distance) in
            [[-0.75, -0.75], [0.75, -0.75], [0.0, 0.75]].into_iter().zip(distances)
        {
            c.tex_coord_1f(distance);
            c.vertex_2f(x, y);
        }
        c.end();
        let mut pixels = vec![0; 8 * 8 * 4];
        c.read_pixels(0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixels));
        assert_eq!(c.get_error(), GL_NO_ERROR);
        pixels.chunks(4).filter(|pixel| **pixel == RED).count()
    };
    for mode in [GL_FILL, GL_LINE, GL_POINT] {
        let whole = lit(mode, [1.0; 3]);
        assert!(whole > 0);
        assert_eq!(lit(mode, [-1.0, -1.0, 1.0]), whole);
        assert_eq!(lit(mode, [-1.0; 3]), 0);
    }
}

#[test]
fn primitives_are_drawn_whole_or_not_at_all() {
    let vertex = format!(
        "{HEAD}out float gl_CullDistance[2];
         void main() {{
             gl_Position = gl_Vertex;
             gl_CullDistance[0] = gl_MultiTexCoord0.x; gl_CullDistance[1] = gl_MultiTexCoord0.y;
         }}"
    );
    let mut c = context();
    use_program(&mut c, &vertex, FRAGMENT);
    for (mode, distances, is_drawn) in CASES {
        let expected = if *is_drawn { RED } else { [0; 4] };
        assert_eq!(draw(&mut c, *mode, distances), expected, "{} {distances:?}", enum_name(*mode));
    }
}

/// The distances that a geometry shader emits count, not those that it reads.
#[test]
fn geometry_shaders_emit_distances() {
    let vertex = format!(
        "{HEAD}void main() {{ gl_Position = gl_Vertex; gl_CullDistance[0] = gl_MultiTexCoord0.x; }}"
    );
    let geometry = format!(
        "{HEAD}layout(triangles) in; layout(triangle_strip, max_vertices = 3) out;
         void main() {{
             for (int i = 0; i < 3; i++) {{
                 gl_Position = gl_in[i].gl_Position;
                 gl_CullDistance[0] = gl_in[i].gl_CullDistance[0] + 2.0;
                 EmitVertex();
             }}
         }}"
    );
    let mut c = context();
    let program = c.create_program();
    for (stage, source) in [
        (GL_VERTEX_SHADER, &*vertex),
        (GL_GEOMETRY_SHADER, &*geometry),
        (GL_FRAGMENT_SHADER, FRAGMENT),
    ] {
        let shader = c.create_shader(stage);
        c.shader_source(shader, 1, Strings(vec![source]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
    }
    c.link_program(program);
    c.use_program(program);
    assert_eq!(draw(&mut c, GL_TRIANGLES, &[[-1.0, 0.0]; 3]), RED);
    assert_eq!(draw(&mut c, GL_TRIANGLES, &[[-3.0, 0.0]; 3]), [0; 4]);
}

/// The fragment stage reads them interpolated, and transform feedback captures them.
#[test]
fn distances_pass_to_fragments_and_are_captured() {
    let vertex = format!(
        "{HEAD}out float gl_CullDistance[2]; out float gl_ClipDistance[6];
         void main() {{
             gl_Position = gl_Vertex;
             gl_ClipDistance[5] = 1.0; gl_CullDistance[1] = gl_MultiTexCoord0.x;
         }}"
    );
    let fragment = format!(
        "{HEAD}in float gl_CullDistance[2];
         void main() {{ gl_FragColor = vec4(0.0, gl_CullDistance[1], gl_CullDistance.length() == 2, 1.0); }}"
    );
    let mut c = context();
    let program = use_program(&mut c, &vertex, &fragment);
    assert_eq!(draw(&mut c, GL_TRIANGLES, &[[0.2, 0.0]; 3]), [0, 51, 255, 255]);
    let names = Names(vec!["gl_CullDistance"]);
    c.transform_feedback_varyings(program, 1, names, GL_INTERLEAVED_ATTRIBS);
    c.link_program(program);
    c.bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 1);
    c.buffer_data(GL_TRANSFORM_FEEDBACK_BUFFER, 24, Data::Null, GL_STREAM_READ);
    c.begin_transform_feedback(GL_TRIANGLES);
    draw(&mut c, GL_TRIANGLES, &[[0.5, 0.0]; 3]);
    c.end_transform_feedback();
    let mut bytes = [0; 24];
    c.get_buffer_sub_data(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 24, DataOut::Bytes(&mut bytes));
    let expected: Vec<u8> = [0.0f32, 0.5].repeat(3).iter().flat_map(|x| x.to_le_bytes()).collect();
    assert_eq!(bytes, *expected);
    assert_eq!(c.get_error(), GL_NO_ERROR);
}

/// Selection and the raster position know them, too.
#[test]
fn selection_and_raster_positions_are_culled() {
    let vertex = format!(
        "{HEAD}void main() {{ gl_Position = gl_Vertex; gl_CullDistance[0] = gl_MultiTexCoord0.x; }}"
    );
    let mut c = context();
    use_program(&mut c, &vertex, FRAGMENT);
    let hits = |c: &mut Context, distance: f32| {
        c.select_buffer(16, DataOut::Null);
        c.render_mode(GL_SELECT);
        c.init_names();
        c.push_name(1);
        c.begin(GL_TRIANGLES);
        for [x, y] in [[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]] {
            c.tex_coord_2f(distance, 0.0);
            c.vertex_2f(x, y);
        }
        c.end();
        c.render_mode(GL_RENDER)
    };
    assert_eq!([hits(&mut c, 1.0), hits(&mut c, -1.0)], [1, 0]);
    for (distance, expected) in [(1.0, GL_TRUE), (-1.0, GL_FALSE)] {
        c.tex_coord_2f(distance, 0.0);
        c.raster_pos_2f(0.0, 0.0);
        let mut valid = [9];
        c.get_booleanv(GL_CURRENT_RASTER_POSITION_VALID, &mut valid);
        assert_eq!(u32::from(valid[0]), expected);
    }
}

/// Together with clip distances there are eight, used or declared.
#[test]
fn more_than_eight_distances_do_not_link() {
    for (clip, cull, links) in [(6, 2, true), (0, 8, true), (8, 1, false), (5, 4, false)] {
        let clip = match clip {
            0 => String::new(),
            clip => format!("gl_ClipDistance[{}] = 1.0;", clip - 1),
        };
        let source = format!(
            "{HEAD}out float gl_CullDistance[{cull}]; void main() {{ gl_Position = vec4(0.0); {clip} }}"
        );
        let mut c = context();
        let program = c.create_shader_programv(GL_VERTEX_SHADER, 1, Names(vec![&source]));
        let mut status = [9];
        c.get_programiv(program, GL_LINK_STATUS, &mut status);
        let mut said = String::new();
        c.get_program_info_log(program, 512, &mut [], TextOut::String(&mut said));
        assert_eq!(status[0] == 1, links, "{source}: {said}");
        assert_eq!(said.contains("gl_MaxCombinedClipAndCullDistances"), !links, "{said}");
    }
}
