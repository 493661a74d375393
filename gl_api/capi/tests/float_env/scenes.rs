//! Pictures whose last bits tell how was computed. What they hand to GL is exact, or written out: this thread's
//! arithmetic is the host's.

use super::c::*;
use gl_api::constants::*;

/// A denormal number.
const DENORMAL: f32 = f32::from_bits(0x0040_1235);

pub(crate) type Scene = (&'static str, fn() -> Vec<u32>);

pub(crate) const SCENES: &[Scene] = &[
    ("blending", blending),
    ("sRGB mipmaps", srgb_mipmaps),
    ("trilinear", trilinear),
    ("multisampling", multisampling),
    ("depth", depth),
    ("light", lighting),
    ("GLSL", glsl),
    ("lines", lines),
    ("uploads", uploads),
    ("quadrics", quadrics),
    ("matrices", matrices),
    ("evaluators", evaluators),
    ("Rust's functions", rust),
    ("GLU's mipmaps", mipmaps),
];

/// Draws a scene into a framebuffer of floats that was cleared.
pub(crate) fn draw((name, scene): Scene) -> Vec<u32> {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    target();
    let drawn = scene();
    glUseProgram(0);
    glPopAttrib();
    for mode in [GL_PROJECTION, GL_MODELVIEW] {
        glMatrixMode(mode);
        glLoadIdentity();
    }
    assert_eq!(glGetError(), GL_NO_ERROR, "{name}");
    drawn
}

const COLOR: u32 = 101;
const DEPTH: u32 = 102;
const TEXTURE: u32 = 103;

fn target() {
    glBindFramebuffer(GL_FRAMEBUFFER, 1);
    for (name, format, base, attachment) in [
        (COLOR, GL_RGBA32F, GL_RGBA, GL_COLOR_ATTACHMENT0),
        (DEPTH, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_DEPTH_ATTACHMENT),
    ] {
        glBindTexture(GL_TEXTURE_2D, name);
        blank(format, base);
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, name, 0);
    }
    assert_eq!(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    glBindTexture(GL_TEXTURE_2D, TEXTURE);
    glViewport(0, 0, SIDE as i32, SIDE as i32);
    glClearColor(0.1, 0.2, 0.3, 0.4);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/// Triangles that overlap, in the colours of their corners.
fn triangles() {
    glBegin(GL_TRIANGLES);
    for (x, y, z) in [
        (-0.93, -0.81, 0.3),
        (0.87, -0.77, -0.9),
        (0.11, 0.95, 0.7),
        (0.91, 0.83, -0.1),
        (-0.79, 0.71, 0.2),
        (-0.13, -0.97, 0.9),
    ] {
        glColor4f(x, y, z, 0.7);
        glTexCoord2f(y, x);
        glNormal3f(x, y, z);
        glVertex3f(x, y, z);
    }
    glEnd();
}

/// Bytes of an image.
fn bytes<const N: usize>() -> [u8; N] {
    std::array::from_fn(|i| (i * 37 % 251) as u8)
}

fn filter(min: u32) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, min as i32);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR as i32);
    glEnable(GL_TEXTURE_2D);
}

fn blending() -> Vec<u32> {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    triangles();
    // What underflows.
    glColor4f(1e-20, 1e-30, DENORMAL, 1e-19);
    glBegin(GL_TRIANGLES);
    glVertex2f(-1.0, -1.0);
    glVertex2f(0.3, -1.0);
    glVertex2f(-1.0, 0.3);
    glEnd();
    colors()
}

fn srgb_mipmaps() -> Vec<u32> {
    image(GL_SRGB8_ALPHA8, 16, GL_UNSIGNED_BYTE, &bytes::<1024>());
    glGenerateMipmap(GL_TEXTURE_2D);
    filter(GL_LINEAR_MIPMAP_LINEAR);
    triangles();
    [colors(), texels(1, 64), texels(3, 4)].concat()
}

fn trilinear() -> Vec<u32> {
    let scale = [0.1, 1.7, DENORMAL, 3.3e-38];
    let pixels: Vec<f32> = (0..1024).map(|i| if i % 7 == 0 { 0.9 } else { scale[i % 4] }).collect();
    image(GL_RGBA32F, 16, GL_FLOAT, &pixels);
    glGenerateMipmap(GL_TEXTURE_2D);
    filter(GL_LINEAR_MIPMAP_LINEAR);
    glMatrixMode(GL_PROJECTION);
    gluPerspective(63.0, 1.1, 0.1, 9.0);
    glMatrixMode(GL_MODELVIEW);
    glTranslated(0.1, 0.1, -1.7);
    glRotatef(51.0, 0.3, 0.7, 0.1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 4);
    triangles();
    [colors(), texels(2, 16)].concat()
}

fn multisampling() -> Vec<u32> {
    glBindFramebuffer(GL_FRAMEBUFFER, 2);
    glBindRenderbuffer(GL_RENDERBUFFER, 1);
    let side = SIDE as i32;
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA32F, side, side);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 1);
    assert_eq!(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    glClear(GL_COLOR_BUFFER_BIT);
    triangles();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 1);
    glBlitFramebuffer(0, 0, side, side, 0, 0, side, side, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, 1);
    colors()
}

fn depth() -> Vec<u32> {
    glEnable(GL_DEPTH_TEST);
    glMatrixMode(GL_MODELVIEW);
    glRotated(33.0, 0.1, 0.9, 0.2);
    triangles();
    glScaled(0.7, -0.9, 1.1);
    triangles();
    [colors(), depths()].concat()
}

fn lighting() -> Vec<u32> {
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_NORMALIZE);
    light(GL_POSITION, &[0.3, 0.9, 1.7, 1.0]);
    light(GL_SPECULAR, &[0.9, 0.8, 0.7, 1.0]);
    light(GL_SPOT_DIRECTION, &[-0.1, -0.5, -0.9, 0.0]);
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 50.0);
    glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 3.3);
    glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.3);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 7.7);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_FOG);
    triangles();
    colors()
}

fn glsl() -> Vec<u32> {
    let program = program(
        "varying vec2 t; void main() { gl_Position = gl_Vertex; t = gl_Vertex.xy * 1.7; }",
        "varying vec2 t; uniform float zero, tiny;
         void main() {
             float wild = 1.0 / zero + log(zero) + sqrt(t.x - 9.0) + exp2(t.y * 900.0);
             gl_FragColor = vec4(pow(abs(t.x), 2.3) + sin(t.y * 7.1),
                                 wild > 0.0 ? 0.1 : inversesqrt(dot(t, t)) * atan(t.x, t.y),
                                 tiny * 0.3 + tiny * t.x, 1.0 / 3.0 + length(t) * exp(t.x));
         }",
    );
    uniform(program, c"zero", 0.0);
    uniform(program, c"tiny", 3e-38);
    triangles();
    colors()
}

fn lines() -> Vec<u32> {
    for (width, smooth) in [(1.0, false), (2.3, true)] {
        glLineWidth(width);
        if smooth {
            glEnable(GL_LINE_SMOOTH);
        }
        glEnable(GL_LINE_STIPPLE);
        glLineStipple(1, 0x5F3F);
        glBegin(GL_LINE_LOOP);
        for (x, y) in [(-0.93, -0.3), (0.87, 0.47), (0.13, -0.91), (-0.41, 0.77)] {
            glColor4f(0.1, x, y, 0.3);
            glVertex2f(x, y);
        }
        glEnd();
    }
    colors()
}

fn uploads() -> Vec<u32> {
    glPixelTransferf(GL_RED_SCALE, 0.3);
    glPixelTransferf(GL_GREEN_BIAS, 0.1);
    glPixelTransferf(GL_BLUE_SCALE, 1e-38);
    image(GL_RGBA32F, 16, GL_UNSIGNED_BYTE, &bytes::<1024>());
    let floats = texels(0, 256);
    image(GL_RGBA16F, 16, GL_UNSIGNED_BYTE, &bytes::<1024>());
    let halves = texels(0, 256);
    image(GL_RGB10_A2, 8, GL_FLOAT, &[0.1_f32; 256]);
    let tenths = texels(0, 64);
    glRasterPos2f(-0.7, -0.9);
    glPixelZoom(1.3, -1.7);
    draw_pixels(8, &bytes::<256>());
    [colors(), floats, halves, tenths].concat()
}

fn quadrics() -> Vec<u32> {
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.3, 0.2, -0.1, 0.3, 0.3, 9.0);
    glMatrixMode(GL_MODELVIEW);
    gluLookAt(0.3, 0.7, 1.9, 0.1, 0.0, 0.1, 0.2, 0.9, 0.1);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    image(GL_RGBA8, 16, GL_UNSIGNED_BYTE, &bytes::<1024>());
    filter(GL_LINEAR);
    sphere(0.7);
    cylinder_and_disk();
    colors()
}

fn matrices() -> Vec<u32> {
    glMatrixMode(GL_MODELVIEW);
    glRotated(33.3, 0.1, 0.7, 0.3);
    glScaled(0.1, 0.3, 0.7);
    gluOrtho2D(-0.1, 0.7, -0.3, 0.9);
    glTranslated(0.1, 0.2, 0.3);
    gluPerspective(33.0, 1.7, 0.1, 7.0);
    let matrix = matrix(GL_MODELVIEW_MATRIX);
    let numbers = |from: f64| std::array::from_fn(|i| if i % 5 == 0 { from } else { 0.1 });
    [matrix, projected(&numbers(0.9), &numbers(0.7))].concat()
}

fn evaluators() -> Vec<u32> {
    curve(&[[-0.9, -0.7, 0.1], [-0.3, 0.9, 0.2], [0.3, -0.9, 0.3], [0.9, 0.7, 0.1]]);
    glEnable(GL_MAP1_VERTEX_3);
    glBegin(GL_TRIANGLE_STRIP);
    for at in [0.0, 0.1, 0.3, 0.4, 0.7, 0.9, 1.0] {
        glColor4d(at, 0.1, 0.3, 0.7);
        glEvalCoord1d(at);
        glColor4us(11, 1777, 33, 60000);
        glVertex2d(at, 0.1);
    }
    glEnd();
    glColor3f(0.1, 0.2, 0.3);
    glBegin(GL_TRIANGLES);
    glVertex3d(-0.1, 0.9, 0.1);
    glVertex3d(-0.9, 0.7, 0.3);
    glVertex3d(-0.7, 0.1, 0.7);
    glEnd();
    colors()
}

fn rust() -> Vec<u32> {
    use gl_api::{glu, *};
    glMatrixMode(GL_MODELVIEW);
    glRotated(21.0, 0.1, 0.2, 0.9);
    glu::gluLookAt(0.1, 0.2, 0.3, -0.1, 0.1, -0.3, 0.1, 0.9, 0.1);
    glBegin(GL_TRIANGLES);
    for (x, y) in [(-0.93, -0.81), (0.87, -0.77), (0.11, 0.95)] {
        glColor4d(x, y, 0.1, 0.3);
        glVertex2d(x, y);
    }
    glEnd();
    glu::gluCylinder(&glu::gluNewQuadric(), 0.3, 0.1, 0.7, 7, 3);
    let model = std::array::from_fn(|i| if i % 5 == 0 { 0.9 } else { 0.1 });
    let at = glu::gluProject(0.1, 0.2, 0.3, &model, &model, &[0, 0, 7, 9]).unwrap_or_default();
    let at = at.into_iter().map(|value| value.to_bits() as u32).collect();
    [colors(), at].concat()
}

fn mipmaps() -> Vec<u32> {
    mipmaps_of_glu(15, &bytes::<900>());
    filter(GL_LINEAR_MIPMAP_NEAREST);
    triangles();
    [colors(), texels(1, 64)].concat()
}
