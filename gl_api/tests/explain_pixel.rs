//! Explanations of a pixel: the page for primitives, texture accesses, environments, programs, blending and cube maps.

use gl_api::context::{Context, ContextDesc};
use gl_api::*;

/// What is drawn after `pixel` of a picture of 16×16 is watched, and how it came to be.
fn explained(pixel: [u32; 2], draw: impl FnOnce()) -> String {
    let desc = ContextDesc { width: 16, height: 16, ..ContextDesc::default() };
    let mut context = Context::new(desc).expect("a context");
    context.watch_pixel(pixel[0], pixel[1]).expect("the pixel is inside");
    let _current = context.make_current();
    glClearColor(0.25, 0.5, 0.75, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw();
    assert_eq!(glGetError(), GL_NO_ERROR);
    let explanation = with_current(Context::explain_pixel).flatten().expect("it is watched");
    let last = explanation.last_write().expect("it was drawn to");
    assert_eq!(last.color, explanation.value);
    let mut shown = [0_u8; 4];
    glReadPixels(pixel[0], pixel[1], 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &mut shown);
    assert_eq!(last.words[0], u32::from_le_bytes(shown));
    explanation.to_string()
}

/// A texture of 4×4 texels with all its levels on a unit.
fn texture(unit: u32, seed: u8) {
    let mut name: GLuint = 0;
    glGenTextures(1, &mut name);
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, name);
    let texels: Vec<u8> = (0..64_u8).map(|at| at.wrapping_mul(37).wrapping_add(seed)).collect();
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, &texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glEnable(GL_TEXTURE_2D);
}

/// A quad over the whole window; `s` and `t` run from 0 to these on both units.
fn quad(s: f32, t: f32) {
    glBegin(GL_QUADS);
    for (x, y) in [(0., 0.), (1., 0.), (1., 1.), (0., 1.)] {
        glMultiTexCoord2f(GL_TEXTURE0, x * s, y * t);
        glMultiTexCoord2f(GL_TEXTURE1, x * s, y * t);
        glVertex2f(2. * x - 1., 2. * y - 1.);
    }
    glEnd();
}

#[test]
fn bilinear() {
    insta::assert_snapshot!(explained([5, 9], || {
        texture(0, 3);
        glEnable(GL_DEPTH_TEST);
        glColor4f(1, 0.5, 0.25, 1);
        quad(1., 1.);
    }));
}

/// Each primitive has a section of its own for how it is filled and what its values are.
#[test]
fn primitives_by_their_sections() {
    for (mode, places) in [
        (GL_POINTS, [" 3.3.1", " 3.3.1"]),
        (GL_LINES, [" 3.4.1", " 3.4.1, equation 3.6"]),
        (GL_TRIANGLES, [" 3.5.1", " 3.5.1, equation 3.8"]),
    ] {
        let page = explained([8, 8], || {
            texture(0, 3);
            glPointSize(16);
            glBegin(mode);
            for (x, y) in [(0.05, 0.5), (0.05, -1.), (1., -1.)] {
                glTexCoord2f(x, y);
                glVertex2f(x, y);
            }
            glEnd();
        });
        for (what, place) in ["of those that are filled", "interpolation:"].iter().zip(places) {
            let line = page.lines().find(|line| line.contains(what)).expect(&page);
            assert!(line.ends_with(&format!("section{place}")), "{line}");
        }
    }
}

#[test]
fn trilinear_and_anisotropic() {
    insta::assert_snapshot!(explained([8, 4], || {
        texture(0, 3);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 4);
        glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 0.25);
        quad(7., 17.);
    }));
}

#[test]
fn combiners_of_two_units() {
    insta::assert_snapshot!(explained([3, 3], || {
        texture(0, 3);
        texture(1, 90);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
        glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_INTERPOLATE);
        glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_CONSTANT);
        glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_ADD_SIGNED);
        glTexEnvi(GL_TEXTURE_ENV, GL_RGB_SCALE, 2);
        glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &[0.1, 0.2, 0.3, 0.75]);
        quad(1., 1.);
    }));
}

#[test]
fn a_program() {
    insta::assert_snapshot!(explained([12, 2], || {
        texture(0, 3);
        let program = glCreateProgram();
        for (kind, source) in
            [(GL_VERTEX_SHADER, VERTEX_SHADER), (GL_FRAGMENT_SHADER, FRAGMENT_SHADER)]
        {
            let shader = glCreateShader(kind);
            glShaderSource(shader, 1, source, NULL);
            glCompileShader(shader);
            glAttachShader(program, shader);
        }
        glLinkProgram(program);
        glUseProgram(program);
        glUniform2f(glGetUniformLocation(program, "scale"), 2, 3);
        glBegin(GL_TRIANGLES);
        for (x, y, w) in [(-2, -1, 1.), (2, -1, 1.), (0, 4, 3.)] {
            glVertex4f(x, y, 0, w);
        }
        glEnd();
    }));
}

const VERTEX_SHADER: &str = "
varying vec2 place;
void main() {
    place = gl_Vertex.xy;
    gl_Position = gl_Vertex;
}
";

const FRAGMENT_SHADER: &str = "
uniform sampler2D picture;
uniform vec2 scale;
varying vec2 place;
void main() {
    vec4 texel = texture2D(picture, place * scale);
    if (texel.r > 0.9) discard;
    gl_FragColor = vec4(mix(texel.rgb, vec3(fract(place), 0.5), 0.25), 1.0);
}
";

#[test]
fn blending_of_three_layers_and_one_that_is_hidden() {
    insta::assert_snapshot!(explained([0, 15], || {
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        for (z, alpha) in [(0.5, 0.25), (0.25, 0.5), (0.75, 0.5), (-0.5, 0.75)] {
            glColor4f(1, 0, 0.5, alpha);
            glBegin(GL_TRIANGLES);
            for (x, y) in [(-1, -1), (3, 1), (-1, 3)] {
                glVertex3f(x, y, z);
            }
            glEnd();
        }
    }));
}

#[test]
fn a_cube_map() {
    insta::assert_snapshot!(explained([10, 6], || {
        for (face, target) in (0..6_u8).zip(GL_TEXTURE_CUBE_MAP_POSITIVE_X..) {
            let texels: Vec<u8> = (0..16_u8).map(|at| at * 10 + face * 16).collect();
            let (format, ty) = (GL_RGBA, GL_UNSIGNED_BYTE);
            glTexImage2D(target, 0, GL_RGBA8, 2, 2, 0, format, ty, &texels);
        }
        glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glEnable(GL_TEXTURE_CUBE_MAP);
        glBegin(GL_QUADS);
        for (x, y) in [(-1, -1), (1, -1), (1, 1), (-1, 1)] {
            glTexCoord3f(x, y, -0.75);
            glVertex2f(x, y);
        }
        glEnd();
    }));
}

#[test]
fn nothing_is_said_of_a_pixel_that_is_not_there_or_not_watched() {
    let desc = ContextDesc { width: 4, height: 3, ..ContextDesc::default() };
    let mut context = Context::new(desc).expect("a context");
    assert!(context.explain_pixel().is_none());
    let error = context.watch_pixel(4, 0).expect_err("there are four columns");
    assert!(error.to_string().contains("pixel (4, 0) is not in"), "{error}");
    context.watch_pixel(3, 2).expect("the last pixel");
    let page = context.explain_pixel().expect("it is watched").to_string();
    assert!(page.contains("nothing was drawn here"), "{page}");
}
