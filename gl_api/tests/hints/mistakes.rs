//! The table of mistakes after which a picture stays black or is not what was meant.

use super::scene::*;
use super::shading::use_program;
use gl_api::*;

/// Name, calls that are made once, calls that are repeated, and words of the warning.
type Case = (&'static str, fn(&mut Context), fn(&mut Context), &'static str);

/// A vertex shader with a colour beside the position, at locations 0 and 1.
const COLORED: &str = "#version 120\nattribute vec2 pos; attribute vec4 col; varying vec4 c;\n\
    void main() { c = col; gl_Position = vec4(pos, 0.0, 1.0); }";
const COLOR: &str = "#version 120\nvarying vec4 c; void main() { gl_FragColor = c; }";

/// Puts a program of two attributes in use; the position is 0.
fn colored(c: &mut Context) {
    let program = c.create_program();
    for (stage, source) in [(GL_VERTEX_SHADER, COLORED), (GL_FRAGMENT_SHADER, COLOR)] {
        let shader = c.create_shader(stage);
        c.shader_source(shader, 1, Strings(vec![source]), &[]);
        c.compile_shader(shader);
        c.attach_shader(program, shader);
    }
    c.bind_attrib_location(program, 0, "pos");
    c.bind_attrib_location(program, 1, "col");
    c.link_program(program);
    c.use_program(program);
}

const NUMBERED: &str = "#version 130\nvoid main() {\n\
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }";

/// A texture of integers, bound to `GL_TEXTURE_2D`.
fn integers(c: &mut Context) {
    c.bind_texture(GL_TEXTURE_2D, 1);
    let (format, ty) = (GL_RGBA_INTEGER, GL_UNSIGNED_BYTE);
    c.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8UI as GLint, 4, 4, 0, format, ty, Data::Null);
    for filter in [GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER] {
        c.tex_parameteri(GL_TEXTURE_2D, filter, GL_NEAREST as GLint);
    }
}

const BLOCK: &str = "#version 140\nlayout(std140) uniform B { vec4 color; };\n\
    out vec4 o; void main() { o = color; }";
const IN_140: &str = "#version 140\nin vec2 pos; void main() { gl_Position = vec4(pos, 0, 1); }";
const CALLED_COLOUR: &str =
    "#version 120\nuniform vec4 colour; void main() { gl_FragColor = colour; }";

pub const ROWS: &[Case] = &[
    (
        "no viewport",
        |c| c.viewport(0, 0, 0, 0),
        triangle,
        "draw: the viewport is 0×0, so nothing is drawn: call glViewport",
    ),
    (
        "no scissor",
        |c| {
            c.enable(GL_SCISSOR_TEST);
            c.scissor(0, 0, 0, 0);
        },
        triangle,
        "the scissor box is 0×0",
    ),
    (
        "colours are masked",
        |c| c.color_mask(false, false, false, false),
        triangle,
        "glColorMask lets no colour through",
    ),
    (
        "nothing is rasterized",
        |c| c.enable(GL_RASTERIZER_DISCARD),
        triangle,
        "GL_RASTERIZER_DISCARD is enabled, and no transform feedback or query of primitives is active",
    ),
    (
        "a stipple without a bit",
        |c| {
            c.polygon_stipple(Data::Bytes(&[0; 128]));
            c.enable(GL_POLYGON_STIPPLE);
        },
        triangle,
        "no bit of the pattern is set, so no fragment is drawn: call glPolygonStipple",
    ),
    (
        "blending that keeps what is there",
        |c| {
            c.enable(GL_BLEND);
            c.blend_func(GL_ZERO, GL_ONE);
        },
        triangle,
        "glBlendFunc(GL_ZERO, GL_ONE), which keeps the colours that are there",
    ),
    (
        "a logical operation without effect",
        |c| {
            c.enable(GL_COLOR_LOGIC_OP);
            c.logic_op(GL_NOOP);
        },
        triangle,
        "glLogicOp(GL_NOOP), so no colour changes",
    ),
    (
        "integers read as numbers",
        |c| {
            integers(c);
            use_program(
                c,
                NUMBERED,
                "#version 130\nuniform sampler2D s; void main() { gl_FragColor = texture(s, vec2(0.5)); }",
            );
        },
        draw,
        "sampler \"s\" reads numbers, and the texels of texture 1 are integers: declare an isampler",
    ),
    (
        "numbers read as integers",
        |c| {
            texture(c, 1, GL_RGBA);
            use_program(
                c,
                NUMBERED,
                "#version 130\nuniform usampler2D s; void main() { gl_FragColor = vec4(texture(s, vec2(0.5))); }",
            );
        },
        draw,
        "sampler \"s\" reads integers, and the texels of texture 1 are numbers that are none: declare",
    ),
    ("no buffer", |c| c.draw_buffer(GL_NONE), triangle, "no colour buffer is drawn to"),
    (
        "no array is enabled",
        |c| {
            shaded(c, WHITE);
        },
        draw,
        "\"pos\" is the same at all vertices and nothing is seen: call glEnableVertexAttribArray(0)",
    ),
    (
        "no conventional array is enabled",
        |c| {
            let vertex = "#version 120\nvoid main() { gl_Position = gl_Vertex; }";
            use_program(c, vertex, WHITE);
        },
        draw,
        "\"gl_Vertex\" is the same at all vertices and nothing is seen: call \
         glEnableClientState(GL_VERTEX_ARRAY)",
    ),
    (
        "no program and no array",
        |_| {},
        draw,
        "draw: nothing is drawn, as no array of positions is enabled: call glEnableClientState",
    ),
    (
        "an index past the buffer",
        |c| {
            shaded(c, WHITE);
            buffer(c, 1, 24);
            array(c, 0, 2);
        },
        |c| c.draw_elements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, Data::Bytes(&[0, 99, 2])),
        "draw: element 99 ends at byte 800, but array 0 reads buffer 1 (bound to GL_ARRAY_BUFFER when \
         its pointer was set) from byte 0 on, which has 24 bytes; what lies beyond reads as 0",
    ),
    (
        "an index past memory, by a base vertex",
        |c| {
            c.enable_client_state(GL_VERTEX_ARRAY);
            c.vertex_pointer(2, GL_FLOAT, 0, Data::Bytes(&[0; 24]));
        },
        |c| {
            let indices = Data::Bytes(&[0, 1, 2]);
            c.draw_elements_base_vertex(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, indices, 1);
        },
        "draw: element 3 ends at byte 32, but GL_VERTEX_ARRAY has 24 bytes",
    ),
    (
        "a short second array",
        |c| {
            colored(c);
            buffer(c, 2, 20);
            array(c, 1, 4);
            positions(c);
        },
        draw,
        "draw: element 2 ends at byte 48, but array 1 reads buffer 2",
    ),
    (
        "a short array of instances",
        |c| {
            colored(c);
            buffer(c, 2, 32);
            array(c, 1, 4);
            c.vertex_attrib_divisor(1, 2);
            positions(c);
        },
        |c| c.draw_arrays_instanced(GL_TRIANGLES, 0, 3, 5),
        "draw: element 2 ends at byte 48, but array 1 reads buffer 2",
    ),
    (
        "a second array of nothing",
        |c| {
            colored(c);
            positions(c);
            c.enable_vertex_attrib_array(1);
        },
        draw,
        "array 1 has no memory: no buffer was bound to GL_ARRAY_BUFFER when its pointer was set",
    ),
    (
        "depth is tested without a buffer",
        |c| {
            draw_to_color(c);
            c.enable(GL_DEPTH_TEST);
        },
        triangle,
        "GL_DEPTH_TEST is enabled, but framebuffer 1 has no depth buffer, so every fragment passes: \
         if it should not, attach one",
    ),
    (
        "stencil is tested without a buffer",
        |c| {
            draw_to_color(c);
            c.enable(GL_STENCIL_TEST);
            c.stencil_func(GL_NEVER, 0, 255);
        },
        triangle,
        "GL_STENCIL_TEST is enabled, but framebuffer 1 has no stencil buffer",
    ),
    (
        "a shadow that is not compared",
        |c| {
            texture(c, 1, GL_DEPTH_COMPONENT);
            shaded(c, SHADOWED);
        },
        triangle,
        "sampler \"s\" compares, but GL_TEXTURE_COMPARE_MODE of texture 1 is GL_NONE, so what it reads \
         is undefined: call glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE",
    ),
    (
        "no light",
        |c| {
            c.enable(GL_LIGHTING);
        },
        triangle,
        "GL_LIGHTING is enabled and no light is, so nearly everything is black: call \
         glEnable(GL_LIGHT0)",
    ),
    (
        "a texture is sampled and drawn to",
        |c| {
            draw_to_color(c);
            c.bind_texture(GL_TEXTURE_2D, 1);
            c.enable(GL_TEXTURE_2D);
        },
        triangle,
        "texture 1 is sampled and drawn to, as it is attached to framebuffer 1",
    ),
    (
        "a depth texture is sampled and drawn to",
        |c| {
            draw_to_depth(c);
            c.enable(GL_DEPTH_TEST);
            c.bind_texture(GL_TEXTURE_2D, 1);
            shaded(c, TEXTURED);
        },
        triangle,
        "texture 1 is sampled and drawn to",
    ),
    (
        "a misspelt uniform",
        |c| {
            shaded(c, CALLED_COLOUR);
        },
        |c| {
            c.get_uniform_location(1, "color");
        },
        "glGetUniformLocation: -1, as program 1 has no active uniform \"color\"; did you mean \
         \"colour\"?",
    ),
    (
        "a misspelt attribute",
        |c| {
            let vertex =
                "#version 120\nattribute vec4 position; void main() { gl_Position = position; }";
            use_program(c, vertex, WHITE);
        },
        |c| {
            c.get_attrib_location(1, "postion");
        },
        "glGetAttribLocation: -1, as program 1 has no active attribute \"postion\"; did you mean \
         \"position\"?",
    ),
    (
        "no position in GLSL 1.40",
        |c| {
            let fragment = "#version 140\nout vec4 o; void main() { o = vec4(1); }";
            use_program(c, "#version 140\nvoid main() {}", fragment);
        },
        |_| {},
        "glLinkProgram: program 1 linked:\nwarning: the vertex shader never writes gl_Position",
    ),
    (
        "no colour is written",
        |c| {
            shaded(c, "#version 120\nvoid main() { vec4 color = vec4(1.0); }");
        },
        triangle,
        "the fragment stage of program 1 writes no colour",
    ),
    (
        "a quad of three",
        |_| {},
        |c| {
            c.begin(GL_QUADS);
            for _ in 0..3 {
                c.vertex_2f(0.0, 0.0);
            }
            c.end();
        },
        "draw: GL_QUADS takes 4 vertices each, so of 3 the last 3 are left out",
    ),
    (
        "triangles counted as vertices",
        positions,
        |c| c.draw_elements(GL_TRIANGLES, 4, GL_UNSIGNED_BYTE, Data::Bytes(&[0, 1, 2, 0])),
        "draw: GL_TRIANGLES takes 3 vertices each, so of 4 the last 1 are left out",
    ),
    (
        "a list that is none",
        |_| {},
        |c| c.call_list(77),
        "glCallList: list 77 does not exist, so nothing is called: see glNewList",
    ),
    (
        "a sampler of another unit",
        |c| {
            c.active_texture(GL_TEXTURE0 + 5);
            texture(c, 2, GL_RGBA);
            shaded(c, TEXTURED);
        },
        triangle,
        "sampler \"s\" samples GL_TEXTURE_2D of unit 0, which has no texture; texture 2 is bound to \
         GL_TEXTURE_2D of unit 5: call glUniform1i(location of \"s\", 5), or \
         call glActiveTexture(GL_TEXTURE0) before glBindTexture",
    ),
    (
        "a sampler that has a texture's name",
        |c| {
            texture(c, 3, GL_RGBA);
            let program = shaded(c, TEXTURED);
            set(c, program, "s", 3);
        },
        triangle,
        "texture 3 is bound to GL_TEXTURE_2D of unit 0: a sampler takes the unit's number, not the \
         texture's name: call glUniform1i(location of \"s\", 0)",
    ),
    (
        "a sampler of another target",
        |c| {
            c.bind_texture(GL_TEXTURE_3D, 4);
            shaded(c, TEXTURED);
        },
        triangle,
        "sampler \"s\" samples GL_TEXTURE_2D of unit 0, where nothing is bound; texture 4 is bound to \
         GL_TEXTURE_3D there",
    ),
    (
        "a sampler of nothing",
        |c| {
            shaded(c, TEXTURED);
        },
        triangle,
        "sampler \"s\" samples GL_TEXTURE_2D of unit 0, which has no texture, and reads black: call \
         glBindTexture",
    ),
    (
        "another unit is enabled",
        |c| {
            texture(c, 2, GL_RGBA);
            c.active_texture(GL_TEXTURE1);
            c.enable(GL_TEXTURE_2D);
        },
        triangle,
        "GL_TEXTURE_2D is enabled on unit 1, where no texture is bound; texture 2 is bound to \
         GL_TEXTURE_2D of unit 0: call glActiveTexture(GL_TEXTURE1) before glBindTexture, or \
         glActiveTexture(GL_TEXTURE0) before glEnable",
    ),
    (
        "another target is enabled",
        |c| {
            c.bind_texture(GL_TEXTURE_CUBE_MAP, 2);
            c.enable(GL_TEXTURE_2D);
        },
        triangle,
        "GL_TEXTURE_2D is enabled on unit 0, where it has no texture; texture 2 is bound to \
         GL_TEXTURE_CUBE_MAP there: call glEnable(GL_TEXTURE_CUBE_MAP)",
    ),
    (
        "a block without a buffer",
        |c| {
            use_program(c, IN_140, BLOCK);
            positions(c);
        },
        draw,
        "draw: the uniform block \"B\" has no buffer: call glBindBufferBase(GL_UNIFORM_BUFFER, 0, \
         buffer) (GL 3.1, section 2.11.4)",
    ),
    (
        "a block with a short buffer",
        |c| {
            use_program(c, IN_140, BLOCK);
            positions(c);
            c.bind_buffer_base(GL_UNIFORM_BUFFER, 0, 1);
            c.buffer_data(GL_UNIFORM_BUFFER, 8, Data::Null, GL_STATIC_DRAW);
        },
        draw,
        "draw: the uniform block \"B\" needs 16 bytes, and buffer 1, bound to index 0 of \
         GL_UNIFORM_BUFFER, has 8",
    ),
    (
        "depths that were never cleared",
        |c| {
            c.enable(GL_DEPTH_TEST);
        },
        triangle,
        "draw: GL_DEPTH_TEST is enabled, but the depths that it compares with were never cleared, so they \
         are undefined",
    ),
    (
        "depths that were cleared to 0",
        |c| {
            c.clear_depth(0.0);
            c.clear(GL_DEPTH_BUFFER_BIT);
            c.enable(GL_DEPTH_TEST);
        },
        triangle,
        "draw: glDepthFunc is GL_LESS, and the depths were cleared to 0 (glClearDepth), so nothing in front \
         of or behind that depth passes GL_DEPTH_TEST: call glClearDepth(1), or glDepthFunc(GL_GREATER)",
    ),
    (
        "a depth function against the clear",
        |c| {
            c.clear(GL_DEPTH_BUFFER_BIT);
            c.enable(GL_DEPTH_TEST);
            c.depth_func(GL_GEQUAL);
        },
        triangle,
        "draw: glDepthFunc is GL_GEQUAL, and the depths were cleared to 1 (glClearDepth)",
    ),
    (
        "a depth function that rejects all",
        |c| {
            c.clear(GL_DEPTH_BUFFER_BIT);
            c.enable(GL_DEPTH_TEST);
            c.depth_func(GL_NEVER);
        },
        triangle,
        "draw: GL_DEPTH_TEST is enabled and glDepthFunc is GL_NEVER, so no fragment passes",
    ),
    (
        "a near plane at 0",
        |c| {
            c.clear(GL_DEPTH_BUFFER_BIT);
            c.enable(GL_DEPTH_TEST);
            c.matrix_mode(GL_PROJECTION);
            // gluPerspective(90, 1, 0, 100).
            c.load_matrixf(&[
                1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, -1.0, 0.0, 0.0, 0.0, 0.0,
            ]);
            c.matrix_mode(GL_MODELVIEW);
            c.translatef(0.0, 0.0, -2.0);
        },
        triangle,
        "draw: GL_PROJECTION is a perspective with zNear = 0, so all that is drawn has the same depth",
    ),
    (
        "an attribute that nobody enabled",
        |c| {
            colored(c);
            positions(c);
        },
        draw,
        "draw: program 1 reads the attribute \"col\", whose array is not enabled and whose value was never \
         set, so it is (0, 0, 0, 1) at all vertices: call glEnableVertexAttribArray(1), or glVertexAttrib4f(1",
    ),
    (
        "texture coordinates that a program reads and nobody gives",
        |c| {
            texture(c, 1, GL_RGBA);
            let vertex = "#version 120\nvarying vec2 uv;\n\
                void main() { uv = gl_MultiTexCoord0.st; gl_Position = gl_Vertex; }";
            use_program(c, vertex, TEXTURED);
        },
        untextured,
        "draw: program 1 reads the attribute \"gl_MultiTexCoord0\", whose array is not enabled",
    ),
    (
        "no texture coordinates",
        |c| {
            texture(c, 1, GL_RGBA);
            c.enable(GL_TEXTURE_2D);
        },
        untextured,
        "draw: texture 1 is sampled by unit 0, but no texture coordinate was given, so every vertex has (0, 0) \
         and all fragments the same texel: call glTexCoord2f before each glVertex",
    ),
    (
        "a stencil that nobody wrote",
        |c| {
            c.enable(GL_STENCIL_TEST);
            c.stencil_func(GL_EQUAL, 1, 0xff);
        },
        triangle,
        "draw: glStencilFunc(GL_EQUAL, 1, 0xff) passes nowhere, as every stencil is 0",
    ),
    (
        "a stencil function that rejects all",
        |c| {
            c.enable(GL_STENCIL_TEST);
            c.stencil_func(GL_NEVER, 1, 0xff);
        },
        triangle,
        "draw: GL_STENCIL_TEST is enabled, glStencilFunc has GL_NEVER and glStencilOp keeps what fails",
    ),
    (
        "an alpha reference that nothing is above",
        |c| {
            c.enable(GL_ALPHA_TEST);
            c.alpha_func(GL_GREATER, 1.0);
        },
        triangle,
        "draw: GL_ALPHA_TEST is enabled with glAlphaFunc(GL_GREATER, 1), and every fragment has alpha 1, so \
         every fragment is rejected",
    ),
    (
        "a program whose alpha cannot pass",
        |c| {
            c.enable(GL_ALPHA_TEST);
            c.alpha_func(GL_LESS, 0.0);
            shaded(c, WHITE);
        },
        triangle,
        "glAlphaFunc(GL_LESS, 0), and alpha is 0 to 1, so every fragment is rejected",
    ),
    (
        "blending with alpha 0",
        |c| {
            c.enable(GL_BLEND);
            c.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
            c.color_4f(1.0, 0.0, 0.0, 0.0);
        },
        triangle,
        "draw: GL_BLEND is enabled with glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), and the current \
         colour has alpha 0, so nothing is seen: call glColor4f",
    ),
    (
        "a texture that is multiplied by black",
        |c| {
            texture(c, 1, GL_RGBA);
            c.enable(GL_TEXTURE_2D);
            c.color_3f(0.0, 0.0, 0.0);
        },
        triangle,
        "draw: the current colour is (0, 0, 0), and GL_TEXTURE_ENV_MODE of unit 0 is GL_MODULATE, which \
         multiplies the texture by it, so it is black: call glColor3f(1, 1, 1)",
    ),
    (
        "texturing is off",
        |c| texture(c, 1, GL_RGBA),
        triangle,
        "draw: texture 1 is bound to GL_TEXTURE_2D of unit 0, but texturing is off: call \
         glEnable(GL_TEXTURE_2D)",
    ),
    (
        "texturing with the default texture is off",
        |c| texture(c, 0, GL_RGBA),
        triangle,
        "draw: texture 0 is bound to GL_TEXTURE_2D of unit 0, which is given texture coordinates, but it is off",
    ),
    (
        "the second unit is off",
        |c| {
            texture(c, 1, GL_RGBA);
            c.enable(GL_TEXTURE_2D);
            c.active_texture(GL_TEXTURE1);
            texture(c, 2, GL_RGBA);
        },
        |c| {
            c.begin(GL_TRIANGLES);
            for [x, y] in [[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]] {
                c.multi_tex_coord_2f(GL_TEXTURE0, x, y);
                c.multi_tex_coord_2f(GL_TEXTURE1, x, y);
                c.vertex_2f(x, y);
            }
            c.end();
        },
        "draw: texture 2 is bound to GL_TEXTURE_2D of unit 1, which is given texture coordinates, but it is \
         off: call glActiveTexture(GL_TEXTURE1) and glEnable(GL_TEXTURE_2D)",
    ),
    (
        "a program in use whose last link failed",
        |c| {
            let program = shaded(c, WHITE);
            let broken = c.create_shader(GL_FRAGMENT_SHADER);
            c.shader_source(broken, 1, Strings(vec!["void main() { oops }"]), &[]);
            c.compile_shader(broken);
            c.attach_shader(program, broken);
            c.link_program(program);
        },
        triangle,
        "draw: program 1 is in use, but its last glLinkProgram failed, so what it was before is drawn: see \
         glGetProgramInfoLog (GL 2.1, section 2.15.2)",
    ),
];

/// A triangle over the whole picture, without texture coordinates.
fn untextured(c: &mut Context) {
    c.begin(GL_TRIANGLES);
    for [x, y] in [[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]] {
        c.vertex_2f(x, y);
    }
    c.end();
}
