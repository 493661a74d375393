//! Pictures that stay black for a reason that only the whole of a program, or of a picture, shows.

use super::scene::*;
use super::shading::{use_program, use_stages};
use super::texts;
use gl_api::*;

/// Name, what is drawn before a picture is taken, and words of the warning.
type Mistake = (&'static str, fn(&mut Context), &'static str);
/// Name, and what is drawn.
type Intended = (&'static str, fn(&mut Context));

const IN_150: &str = "#version 150\nin vec2 pos; void main() { gl_Position = vec4(pos, 0, 1); }";
const OUT_150: &str = "#version 150\nout vec4 o; void main() { o = vec4(1.0); }";
const TINTED: &str = "#version 120\nuniform sampler2D s; uniform vec4 tint; varying vec2 uv;\n\
    void main() { vec4 color = texture2D(s, uv); color *= tint; gl_FragColor = color; }";
const OUT_1: &str = "#version 330\nlayout(location = 1) out vec4 o; void main() { o = vec4(1.0); }";
const IN_330: &str = "#version 330\nlayout(location = 0) in vec2 pos;\n\
    void main() { gl_Position = vec4(pos, 0, 1); }";

/// Puts a geometry shader with this body in use, and draws.
fn geometry(c: &mut Context, body: &str) {
    let source = format!(
        "#version 150\nlayout(triangles) in; layout(triangle_strip, max_vertices = 3) out;\n\
        void main() {{ {body} }}"
    );
    let stages =
        [(GL_VERTEX_SHADER, IN_150), (GL_GEOMETRY_SHADER, &source), (GL_FRAGMENT_SHADER, OUT_150)];
    use_stages(c, &stages);
    positions(c);
    draw(c);
}

/// A texture without texels, sampled by the fixed function.
fn blank_texture(c: &mut Context) {
    let (rgba, ty) = (GL_RGBA8 as GLint, GL_UNSIGNED_BYTE);
    c.bind_texture(GL_TEXTURE_2D, 3);
    c.tex_image_2d(GL_TEXTURE_2D, 0, rgba, 4, 4, 0, GL_RGBA, ty, Data::Null);
    c.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as GLint);
    c.enable(GL_TEXTURE_2D);
}

/// Conditional rendering by a query of nothing.
fn conditional(c: &mut Context) {
    c.begin_query(GL_SAMPLES_PASSED, 1);
    c.end_query(GL_SAMPLES_PASSED);
    c.begin_conditional_render(1, GL_QUERY_WAIT);
    triangle(c);
    c.end_conditional_render();
}

/// Draws a lit triangle with one normal.
fn lit(c: &mut Context, z: f32) {
    c.enable(GL_LIGHTING);
    c.enable(GL_LIGHT0);
    c.normal_3f(0.0, 0.0, z);
    triangle(c);
}

const MISTAKES: &[Mistake] = &[
    (
        "every fragment is discarded",
        |c| {
            shaded(c, "#version 120\nvoid main() { gl_FragColor = vec4(1.0); discard; }");
            triangle(c);
        },
        "draw: the fragment stage of program 1 discards every fragment, whatever its inputs are",
    ),
    (
        "every fragment is discarded, in both branches",
        |c| {
            let fragment = "#version 120\nuniform float u; varying vec2 uv;\n\
                void main() { if (uv.x > u) discard; else discard; gl_FragColor = vec4(1.0); }";
            shaded(c, fragment);
            triangle(c);
        },
        "discards every fragment",
    ),
    (
        "no vertex is emitted",
        |c| geometry(c, "gl_Position = gl_in[0].gl_Position; EndPrimitive();"),
        "draw: the geometry stage of program 1 calls EmitVertex() nowhere",
    ),
    (
        "a colour that nobody set",
        |c| {
            shaded(c, "#version 120\nuniform vec4 colour; void main() { gl_FragColor = colour; }");
            triangle(c);
        },
        "draw: the fragment stage of program 1 multiplies its colour by the uniform \"colour\", which was never set \
         and is 0, so all is black: call glUniform* with location 0",
    ),
    (
        "a tint that nobody set",
        |c| {
            texture(c, 1, GL_RGBA);
            shaded(c, TINTED);
            triangle(c);
        },
        "multiplies its colour by the uniform \"tint\"",
    ),
    (
        "a colour that is no number",
        |c| {
            let fragment = "#version 120\nvoid main() { float zero = 0.0;\n\
                gl_FragColor = vec4(vec3(sqrt(zero - 1.0)), 1.0); }";
            shaded(c, fragment);
            triangle(c);
        },
        "draw: the colour of the fragment stage of program 1 is NaN everywhere, which is written as 0",
    ),
    (
        "lights behind the only face",
        |c| lit(c, -1.0),
        "draw: all that was drawn with GL_LIGHTING since the last picture is black: the normal is (0, 0, -1), and \
         every enabled light shines from behind it: call glNormal3f(0, 0, 1)",
    ),
    (
        "a texture without texels",
        |c| {
            blank_texture(c);
            triangle(c);
        },
        "draw: texture 3 on GL_TEXTURE_2D of unit 0 has no texels: it was made without data (NULL)",
    ),
    (
        "a texture without texels that a program samples",
        |c| {
            blank_texture(c);
            shaded(c, TEXTURED);
            triangle(c);
        },
        "draw: texture 3 on GL_TEXTURE_2D of unit 0 has no texels",
    ),
    (
        "a condition that nothing fulfils",
        conditional,
        "draw: nothing was drawn since the last picture: the query of glBeginConditionalRender counted no samples",
    ),
    (
        "a location that is not drawn to",
        |c| {
            use_program(c, IN_330, OUT_1);
            positions(c);
            draw(c);
        },
        "draw: the fragment stage of program 1 writes its colour to location 1, and draw buffer 1 is GL_NONE or masked",
    ),
    (
        "no vertices",
        |c| {
            positions(c);
            c.draw_arrays(GL_TRIANGLES, 0, 0);
        },
        "draw: nothing was drawn: glDrawArrays was called with 0 vertices or instances",
    ),
    (
        "no indices",
        |c| {
            positions(c);
            c.draw_elements(GL_TRIANGLES, 0, GL_UNSIGNED_BYTE, Data::Bytes(&[]));
        },
        "draw: nothing was drawn: glDrawElements was called with 0 vertices or instances",
    ),
    (
        "another framebuffer is read",
        |c| {
            draw_to_color(c);
            triangle(c);
            c.bind_framebuffer(GL_FRAMEBUFFER, 0);
        },
        "glReadPixels: framebuffer 0 is read, to which nothing was ever drawn, cleared or copied, and what was drawn went \
         to framebuffer 1: call glBindFramebuffer(GL_READ_FRAMEBUFFER, 1)",
    ),
];

const INTENDED: &[Intended] = &[
    ("a condition before a discard", |c| {
        let fragment = "#version 120\nvarying vec2 uv;\n\
            void main() { if (uv.x > 2.0) discard; gl_FragColor = vec4(1.0); }";
        shaded(c, fragment);
        triangle(c);
    }),
    ("a return before a discard", |c| {
        let fragment = "#version 120\nvarying vec2 uv;\n\
            void main() { gl_FragColor = vec4(1.0); if (uv.x < 2.0) return; discard; }";
        shaded(c, fragment);
        triangle(c);
    }),
    ("vertices that are emitted under a condition", |c| {
        geometry(
            c,
            "for (int i = 0; i < 3; i++) { gl_Position = gl_in[i].gl_Position; EmitVertex(); }",
        );
    }),
    ("black that was set", |c| {
        let fragment = "#version 120\nuniform vec4 colour; void main() { gl_FragColor = colour; }";
        let program = shaded(c, fragment);
        let location = c.get_uniform_location(program, "colour");
        c.uniform_4f(location, 0.0, 0.0, 0.0, 1.0);
        triangle(c);
    }),
    ("a colour that is added to", |c| {
        let fragment = "#version 120\nuniform vec4 more; varying vec2 uv;\n\
            void main() { gl_FragColor = vec4(uv, 0.0, 1.0) + more; }";
        shaded(c, fragment);
        triangle(c);
    }),
    ("light that is added", |c| {
        let fragment = "#version 120\nuniform vec4 light, glow; varying vec2 uv;\n\
            void main() { gl_FragColor = vec4(uv, 0.0, 1.0) * light + vec4(0.5) * (glow + 1.0); }";
        shaded(c, fragment);
        triangle(c);
    }),
    ("black in one of two branches", |c| {
        let fragment = "#version 120\nuniform vec4 colour; varying vec2 uv;\n\
            void main() { gl_FragColor = vec4(1.0); if (uv.x > 0.5) gl_FragColor = colour; }";
        shaded(c, fragment);
        triangle(c);
    }),
    ("a face that is not lit beside one that is", |c| {
        lit(c, -1.0);
        lit(c, 1.0);
    }),
    ("faces by arrays of normals", |c| {
        c.enable(GL_LIGHTING);
        c.enable(GL_LIGHT0);
        c.begin(GL_TRIANGLES);
        for [x, y, z] in [[-1.0, -1.0, -1.0], [3.0, -1.0, -0.5], [-1.0, 3.0, -1.0]] {
            c.normal_3f(0.0, 0.0, z);
            c.vertex_2f(x, y);
        }
        c.end();
    }),
    ("a light at a place", |c| {
        c.lightfv(GL_LIGHT0, GL_POSITION, &[0.0, 0.0, -5.0, 1.0]);
        lit(c, -1.0);
    }),
    ("texels that come later", |c| {
        blank_texture(c);
        let (texels, ty) = (Data::Bytes(&[200; 4]), GL_UNSIGNED_BYTE);
        c.tex_sub_image_2d(GL_TEXTURE_2D, 0, 1, 1, 1, 1, GL_RGBA, ty, texels);
        triangle(c);
    }),
    ("a texture that was cleared", |c| {
        blank_texture(c);
        draw_to(c, GL_COLOR_ATTACHMENT0, 3, 0);
        c.clear(GL_COLOR_BUFFER_BIT);
        c.bind_framebuffer(GL_FRAMEBUFFER, 0);
        triangle(c);
    }),
    ("a condition beside other draws", |c| {
        triangle(c);
        conditional(c);
    }),
    ("no vertices beside other draws", |c| {
        positions(c);
        draw(c);
        c.draw_arrays(GL_TRIANGLES, 0, 0);
    }),
    ("a picture that is only cleared", |c| c.clear(GL_COLOR_BUFFER_BIT)),
    ("the second draw buffer", |c| {
        for point in [GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT0 + 1] {
            texture(c, 1 + point - GL_COLOR_ATTACHMENT0, GL_RGBA);
            draw_to(c, point, 1 + point - GL_COLOR_ATTACHMENT0, 0);
        }
        c.bind_texture(GL_TEXTURE_2D, 0);
        c.draw_buffers(2, &[GL_NONE, GL_COLOR_ATTACHMENT0 + 1]);
        c.read_buffer(GL_COLOR_ATTACHMENT0 + 1);
        use_program(c, IN_330, OUT_1);
        positions(c);
        draw(c);
    }),
    ("the window, which was cleared, beside a framebuffer", |c| {
        c.clear(GL_COLOR_BUFFER_BIT);
        draw_to_color(c);
        triangle(c);
        c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    }),
    ("a texture that was uploaded, by way of a framebuffer", |c| {
        triangle(c);
        draw_to_color(c);
    }),
    ("a copy of what was drawn", |c| {
        draw_to_color(c);
        triangle(c);
        c.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
        c.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        c.bind_framebuffer(GL_FRAMEBUFFER, 0);
    }),
];

/// What is said of three pictures.
fn said(draw: fn(&mut Context)) -> Vec<String> {
    let mut c = context();
    c.enable(GL_DEBUG_OUTPUT);
    let mut given = Vec::new();
    draw(&mut c);
    for _ in 0..3 {
        let mut pixel = [0_u8; 4];
        c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, DataOut::Bytes(&mut pixel));
        given.extend(texts(&mut c));
    }
    assert_eq!(c.get_error(), GL_NO_ERROR, "{given:#?}");
    given
}

#[test]
fn a_black_picture_has_one_message() {
    for (name, draw, words) in MISTAKES {
        let given = said(*draw);
        let times = given.iter().filter(|text| text.contains(words)).count();
        assert_eq!((times, given.len()), (1, 1), "{name}: {words:?} in {given:#?}");
    }
}

#[test]
fn what_looks_like_it_has_none() {
    for (name, draw) in INTENDED {
        assert_eq!(said(*draw), [""; 0], "{name}");
    }
}
