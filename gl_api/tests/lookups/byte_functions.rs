//! Long functions of texels whose channels are bytes: from the second draw on they are tables, with the same bits, and
//! they are functions again where a lookup gives something else.

use super::program;
use gl_api::*;

/// Texels across, one for each byte.
const TEXELS: usize = 256;

const VERTEX: &str =
    "varying float at; void main() { at = gl_MultiTexCoord0.s; gl_Position = gl_Vertex; }";

/// What fragments compute of the texel `c`.
const FUNCTIONS: [&str; 6] = [
    "pow(c, vec4(2.2))",
    "mix(pow((c + 0.055) / 1.055, vec4(2.4)), c / 12.92, vec4(lessThanEqual(c, vec4(0.04045))))",
    "vec4(exp(c.r), log(c.g), sin(30.0 * c.b), pow(max(c.a, 0.5), 1.0 / 2.2))",
    "sqrt(exp2(pow(c, vec4(3.3)) * -2.0))",
    "vec4(pow(c.r, c.g), pow(c.b, c.b), atan(c.a, 0.3), acos(c.g))",
    "vec4(pow(pow(c.r, 2.0), at), pow(2.0, c.g), tan(c.b), asin(c.a))",
];

/// Where the lookups are.
const COORDINATES: [&str; 2] = ["at", "1.5 * at - 0.2"];

/// The floats of one row, as words.
fn picture() -> Vec<u32> {
    glBegin(GL_QUADS);
    for (x, y, s) in [(-1, -1, 0.0), (1, -1, 1.0), (1, 1, 1.0), (-1, 1, 0.0)] {
        glTexCoord2f(s, 0.5);
        glVertex2f(x, y);
    }
    glEnd();
    let mut floats = [0_f32; 4 * TEXELS];
    glReadPixels(0, 0, TEXELS as i32, 1, GL_RGBA, GL_FLOAT, &mut floats[..]);
    floats.map(f32::to_bits).to_vec()
}

/// A texture of all bytes in each channel, in different orders.
fn texture(internal: GLenum) {
    let texels: Vec<u8> = (0..=255u8).flat_map(|i| [i, !i, i.wrapping_mul(7), i ^ 0x55]).collect();
    let (width, ty) = (TEXELS as i32, GL_UNSIGNED_BYTE);
    glTexImage2D(GL_TEXTURE_2D, 0, internal, width, 1, 0, GL_RGBA, ty, &texels);
}

/// How lookups give one texel, or something else.
const SAMPLERS: [(&str, fn()); 5] = [
    ("nearest", || ()),
    ("repeated", || glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT)),
    ("swizzled", || {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_ALPHA);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_G, GL_ONE);
    }),
    ("with a border of its own", || {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
        glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, &[0.123_f32, 0.777, 0.5, 0.3]);
    }),
    ("linear", || {
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    }),
];

fn start_texture() {
    let mut name = 0;
    glGenTextures(1, &mut name);
    glBindTexture(GL_TEXTURE_2D, name);
    for (parameter, value) in [
        (GL_TEXTURE_MIN_FILTER, GL_NEAREST),
        (GL_TEXTURE_MAG_FILTER, GL_NEAREST),
        (GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE),
    ] {
        glTexParameteri(GL_TEXTURE_2D, parameter, value);
    }
}

/// A framebuffer of floats.
fn float_target() {
    let (mut framebuffer, mut name) = (0, 0);
    glGenTextures(1, &mut name);
    glBindTexture(GL_TEXTURE_2D, name);
    let (width, ty) = (TEXELS as i32, GL_FLOAT);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, 1, 0, GL_RGBA, ty, NULL);
    glGenFramebuffers(1, &mut framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    let (target, attachment) = (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0);
    glFramebufferTexture2D(target, attachment, GL_TEXTURE_2D, name, 0);
    assert_eq!(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
}

#[test]
fn functions_of_bytes_have_the_same_bits_as_tables() {
    let desc = ContextDesc { width: 4, height: 4, ..ContextDesc::default() };
    let _current = Context::new(desc).expect("a device").make_current();
    float_target();
    glViewport(0, 0, TEXELS as i32, 1);
    let mut pictures = std::collections::BTreeSet::new();
    for function in FUNCTIONS {
        for coordinate in COORDINATES {
            let fragment = format!(
                "uniform sampler2D s; varying float at;
                 void main() {{ vec4 c = texture2D(s, vec2({coordinate}, 0.5)); gl_FragColor = {function}; }}"
            );
            for internal in
                [GL_RGBA8, GL_RGB8, GL_LUMINANCE8_ALPHA8, GL_INTENSITY8, GL_RGBA4, GL_RGBA16]
            {
                for (sampler, set) in SAMPLERS {
                    start_texture();
                    texture(internal);
                    set();
                    // A new one, whose first draw has no facts.
                    let program = program(VERTEX, &fragment).expect("a program");
                    glUseProgram(program);
                    let first = picture();
                    for again in 0..2 {
                        assert!(
                            picture() == first,
                            "{function} at {coordinate}, {internal:#x} {sampler}, once more: {again}"
                        );
                    }
                    // The program has tables, but the lookups are no bytes now.
                    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
                    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
                    let linear = picture();
                    assert!(
                        picture() == linear,
                        "{function}, {internal:#x} {sampler}, then linear"
                    );
                    assert_eq!(glGetError(), GL_NO_ERROR);
                    pictures.insert(first);
                    glDeleteProgram(program);
                }
            }
        }
    }
    // Each combination draws something of its own, but for swizzles and borders that change nothing.
    assert!(pictures.len() > FUNCTIONS.len() * COORDINATES.len() * 12, "{}", pictures.len());
}
