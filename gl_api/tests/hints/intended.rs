//! The table of programs that look like one of the mistakes, but are intended.

use super::scene::*;
use super::shading::use_program;
use gl_api::*;

/// Name, and calls.
type Case = (&'static str, fn(&mut Context));

const EMPTY: &str = "#version 120\nvoid main() {}";
/// The corners of a full-screen triangle, computed from the vertex numbers.
const NUMBERED: &str = "#version 130\nout vec2 uv;\nvoid main() {\n\
    uv = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n\
    gl_Position = vec4(uv * 4.0 - 1.0, 0.0, 1.0); }";

fn mask(c: &mut Context) {
    c.color_mask(false, false, false, false);
}

pub const ROWS: &[Case] = &[
    ("a pass over a whole picture with a test of depths that there are not", |c| {
        shaded(c, WHITE);
        positions(c);
        draw_to_color(c);
        c.enable(GL_DEPTH_TEST);
        draw(c);
    }),
    ("no texture coordinates for a texture that is a colour", |c| {
        c.bind_texture(GL_TEXTURE_2D, 1);
        let texel = Data::Bytes(&[255; 4]);
        c.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA as i32, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
        let vertex = "#version 120\nattribute vec4 corner, VertexTexCoord; varying vec2 uv;\n\
            void main() { uv = VertexTexCoord.st; gl_Position = corner; }";
        let program = c.create_program();
        for (stage, source) in [(GL_VERTEX_SHADER, vertex), (GL_FRAGMENT_SHADER, TEXTURED)] {
            let shader = c.create_shader(stage);
            c.shader_source(shader, 1, Strings(vec![source]), &[]);
            c.compile_shader(shader);
            c.attach_shader(program, shader);
        }
        c.bind_attrib_location(program, 0, "corner");
        c.bind_attrib_location(program, 1, "VertexTexCoord");
        c.link_program(program);
        c.use_program(program);
        let corners: &[f32] = &[-1.0, -1.0, 3.0, -1.0, -1.0, 3.0];
        c.enable_vertex_attrib_array(0);
        c.vertex_attrib_pointer(0, 2, GL_FLOAT, false, 0, corners.arg());
        draw(c);
    }),
    ("a triangle", |c| {
        c.clear(GL_DEPTH_BUFFER_BIT);
        c.enable(GL_DEPTH_TEST);
        c.enable(GL_STENCIL_TEST);
        c.enable(GL_SCISSOR_TEST);
        texture(c, 1, GL_RGBA);
        c.enable(GL_TEXTURE_2D);
        triangle(c);
    }),
    ("a name of another program", |c| {
        let other = "#version 120\nuniform vec4 uSMatrix; void main() { gl_FragColor = uSMatrix; }";
        shaded(c, other);
        let program = shaded(
            c,
            "#version 120\nuniform vec4 uMatrix; void main() { gl_FragColor = uMatrix; }",
        );
        assert_eq!(c.get_uniform_location(program, "uSMatrix"), -1);
    }),
    ("arrays that are just long enough", |c| {
        shaded(c, WHITE);
        buffer(c, 1, 24);
        array(c, 0, 2);
        draw(c);
        c.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, Data::Bytes(&[0, 1, 2]));
        let indices = Data::Bytes(&[5, 6, 7]);
        c.draw_elements_base_vertex(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, indices, -5);
    }),
    ("an index that restarts", |c| {
        positions(c);
        c.enable(GL_PRIMITIVE_RESTART);
        c.primitive_restart_index(255);
        let indices = Data::Bytes(&[0, 1, 2, 255, 0, 1, 2]);
        c.draw_elements(GL_TRIANGLE_STRIP, 7, GL_UNSIGNED_BYTE, indices);
    }),
    ("a short array that nobody reads", |c| {
        shaded(c, WHITE);
        buffer(c, 1, 4);
        array(c, 5, 4);
        c.enable_client_state(GL_COLOR_ARRAY);
        positions(c);
        draw(c);
    }),
    ("depth alone, with colours that blending keeps", |c| {
        c.clear(GL_DEPTH_BUFFER_BIT);
        c.enable(GL_BLEND);
        c.blend_func(GL_ZERO, GL_ONE);
        c.enable(GL_DEPTH_TEST);
        triangle(c);
    }),
    ("primitives that are counted and not drawn", |c| {
        c.enable(GL_RASTERIZER_DISCARD);
        c.begin_query(GL_PRIMITIVES_GENERATED, 1);
        triangle(c);
        c.end_query(GL_PRIMITIVES_GENERATED);
    }),
    ("lines under a stipple of polygons", |c| {
        c.polygon_stipple(Data::Bytes(&[0; 128]));
        c.enable(GL_POLYGON_STIPPLE);
        c.begin(GL_LINES);
        c.vertex_2f(-1.0, -0.9);
        c.vertex_2f(1.0, 0.9);
        c.end();
    }),
    ("depth alone, with masked colours", |c| {
        c.clear(GL_DEPTH_BUFFER_BIT);
        mask(c);
        c.enable(GL_DEPTH_TEST);
        triangle(c);
    }),
    ("a shadow map", |c| {
        draw_to_depth(c);
        c.enable(GL_DEPTH_TEST);
        shaded(c, EMPTY);
        triangle(c);
    }),
    ("a mask in the stencil buffer", |c| {
        c.clear(GL_DEPTH_BUFFER_BIT);
        mask(c);
        c.depth_mask(false);
        c.enable(GL_DEPTH_TEST);
        c.enable(GL_STENCIL_TEST);
        c.stencil_op(GL_KEEP, GL_INCR_WRAP, GL_KEEP);
        triangle(c);
    }),
    ("pixels that are counted", |c| {
        mask(c);
        c.depth_mask(false);
        c.begin_query(GL_SAMPLES_PASSED, 1);
        triangle(c);
        c.end_query(GL_SAMPLES_PASSED);
    }),
    ("a picture from numbers of vertices", |c| {
        use_program(c, NUMBERED, WHITE);
        draw(c);
    }),
    ("numbers of vertices, and a colour for all", |c| {
        let vertex = NUMBERED.replace("out vec2 uv", "in vec2 uv0; out vec2 uv");
        use_program(c, &vertex.replace("uv = ", "uv = uv0 + "), WHITE);
        draw(c);
    }),
    ("a point where a constant says", |c| {
        shaded(c, WHITE);
        c.vertex_attrib_2f(0, 0.0, 0.0);
        c.draw_arrays(GL_POINTS, 0, 1);
    }),
    ("a level from the one before", |c| {
        texture(c, 1, GL_RGBA);
        c.generate_mipmap(GL_TEXTURE_2D);
        draw_to(c, GL_COLOR_ATTACHMENT0, 1, 1);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST as GLint);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 0);
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
        shaded(c, TEXTURED);
        triangle(c);
    }),
    ("a texture that is drawn to and looked up in turn", |c| {
        draw_to_color(c);
        c.bind_texture(GL_TEXTURE_2D, 1);
        shaded(c, TEXTURED);
        c.texture_barrier();
        triangle(c);
    }),
    ("a depth that is read while it is tested", |c| {
        draw_to_depth(c);
        texture(c, 2, GL_RGBA);
        draw_to(c, GL_COLOR_ATTACHMENT0, 2, 0);
        c.draw_buffer(GL_COLOR_ATTACHMENT0);
        c.enable(GL_DEPTH_TEST);
        c.depth_mask(false);
        c.bind_texture(GL_TEXTURE_2D, 1);
        shaded(c, TEXTURED);
        triangle(c);
    }),
    ("vertices that are captured and not seen", |c| {
        let program = c.create_program();
        let shader = c.create_shader(GL_VERTEX_SHADER);
        let vertex = "#version 140\nin vec2 pos; out vec2 found; void main() { found = pos; }";
        c.shader_source(shader, 1, Strings(vec![vertex]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
        c.transform_feedback_varyings(program, 1, Names(vec!["found"]), GL_INTERLEAVED_ATTRIBS);
        c.link_program(program);
        c.use_program(program);
        c.bind_buffer_base(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 1);
        c.buffer_data(GL_TRANSFORM_FEEDBACK_BUFFER, 64, Data::Null, GL_DYNAMIC_READ);
        positions(c);
        c.enable(GL_RASTERIZER_DISCARD);
        c.viewport(0, 0, 0, 0);
        c.begin_transform_feedback(GL_TRIANGLES);
        draw(c);
        c.end_transform_feedback();
    }),
    ("names that are not there", |c| {
        let fragment = "#version 120\nuniform vec4 color; uniform vec4 colour; uniform vec4 map1;\n\
            void main() { gl_FragColor = colour + map1; }";
        let program = shaded(c, fragment);
        // Nothing uses it; another element; nothing alike.
        for name in ["color", "map2", "modelViewMatrix", "gl_ModelViewMatrix", "s"] {
            assert_eq!(c.get_uniform_location(program, name), -1, "{name}");
        }
        assert_eq!(c.get_attrib_location(program, "normal"), -1);
    }),
    ("letters that a font leaves out", |c| {
        c.call_lists(2, GL_UNSIGNED_BYTE, Data::Bytes(&[7, 9]));
        c.call_list(0);
        assert_eq!(c.gen_lists(1), 1);
        c.call_list(1);
    }),
    ("what shines without a light", |c| {
        c.enable(GL_LIGHTING);
        c.materialfv(GL_FRONT_AND_BACK, GL_EMISSION, &[1.0, 0.5, 0.0, 1.0]);
        triangle(c);
    }),
    ("light from everywhere", |c| {
        c.enable(GL_LIGHTING);
        c.light_modelfv(GL_LIGHT_MODEL_AMBIENT, &[1.0; 4]);
        triangle(c);
    }),
    ("lighting that a program leaves out", |c| {
        c.enable(GL_LIGHTING);
        shaded(c, WHITE);
        triangle(c);
    }),
    ("a shadow that is compared", |c| {
        texture(c, 1, GL_DEPTH_COMPONENT);
        let mode = GL_COMPARE_REF_TO_TEXTURE as GLint;
        c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, mode);
        shaded(c, SHADOWED);
        triangle(c);
    }),
    ("a depth that is only read", |c| {
        texture(c, 1, GL_DEPTH_COMPONENT);
        shaded(c, TEXTURED);
        triangle(c);
    }),
    ("a test that everything passes", |c| {
        draw_to_color(c);
        c.enable(GL_DEPTH_TEST);
        c.depth_func(GL_ALWAYS);
        c.enable(GL_STENCIL_TEST);
        triangle(c);
    }),
    ("strips as long as data says", |c| {
        positions(c);
        for mode in [GL_LINE_STRIP, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_POLYGON] {
            c.draw_arrays(mode, 0, 1);
        }
        c.draw_arrays(GL_TRIANGLES, 0, 0);
    }),
    ("a scissor box that hides part of a window", |c| {
        c.enable(GL_SCISSOR_TEST);
        c.scissor(3, 0, 0, 5);
        triangle(c);
    }),
    ("pixels, whatever the viewport is", |c| {
        c.viewport(0, 0, 0, 0);
        c.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Data::Bytes(&[0; 4]));
    }),
    ("a texture that is drawn to, and not sampled", |c| {
        draw_to_color(c);
        c.bind_texture(GL_TEXTURE_2D, 1);
        triangle(c);
        c.bind_framebuffer(GL_FRAMEBUFFER, 0);
        triangle(c);
    }),
    ("a viewport that is larger than the framebuffer", |c| {
        draw_to_color(c);
        c.viewport(0, 0, 512, 512);
        triangle(c);
    }),
    ("a texture's silhouette", |c| {
        texture(c, 1, GL_ALPHA);
        c.enable(GL_TEXTURE_2D);
        c.color_3f(0.0, 0.0, 0.0);
        triangle(c);
    }),
    ("a shadow of a picture", |c| {
        texture(c, 1, GL_RGBA);
        c.enable(GL_TEXTURE_2D);
        c.enable(GL_BLEND);
        c.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        c.color_4f(0.0, 0.0, 0.0, 0.5);
        triangle(c);
    }),
    ("one texel for all", |c| {
        texture(c, 1, GL_RGBA);
        c.enable(GL_TEXTURE_2D);
        c.tex_coord_2f(0.5, 0.5);
        c.rectf(0.0, 0.0, 1.0, 1.0);
    }),
    ("black for all vertices", |c| {
        let vertex = "#version 120\nattribute vec2 pos; attribute vec4 col; varying vec4 c;\n\
            void main() { c = col; gl_Position = vec4(pos, 0.0, 1.0); }";
        let fragment = "#version 120\nvarying vec4 c; void main() { gl_FragColor = c; }";
        let program = use_program(c, vertex, fragment);
        let location = c.get_attrib_location(program, "col");
        c.vertex_attrib_4f(location as GLuint, 0.0, 0.0, 0.0, 1.0);
        let at = c.get_attrib_location(program, "pos") as GLuint;
        let corners = bytes(&[-1.0, -1.0, 3.0, -1.0, -1.0, 3.0]);
        c.enable_vertex_attrib_array(at);
        c.vertex_attrib_pointer(at, 2, GL_FLOAT, false, 0, Data::Bytes(&corners));
        draw(c);
    }),
    ("a mask that is drawn before it is compared", |c| {
        c.enable(GL_STENCIL_TEST);
        c.stencil_func(GL_ALWAYS, 1, 0xff);
        c.stencil_op(GL_KEEP, GL_KEEP, GL_REPLACE);
        triangle(c);
        c.stencil_func(GL_EQUAL, 1, 0xff);
        c.stencil_op(GL_KEEP, GL_KEEP, GL_KEEP);
        triangle(c);
    }),
    ("depths that are drawn before they are compared", |c| {
        c.enable(GL_DEPTH_TEST);
        c.depth_func(GL_ALWAYS);
        triangle(c);
        c.depth_func(GL_LEQUAL);
        triangle(c);
    }),
    ("depths the other way round", |c| {
        c.clear_depth(0.0);
        c.clear(GL_DEPTH_BUFFER_BIT);
        c.enable(GL_DEPTH_TEST);
        c.depth_func(GL_GREATER);
        triangle(c);
    }),
    ("a cut-out", |c| {
        texture(c, 1, GL_RGBA);
        c.enable(GL_TEXTURE_2D);
        c.enable(GL_ALPHA_TEST);
        c.alpha_func(GL_GREATER, 0.5);
        triangle(c);
    }),
];
