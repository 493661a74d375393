//! Textures whose texels are a buffer's bytes (`ARB_texture_buffer_object`): every format against
//! its formula, in both stages; that a draw finds the bytes that the buffer has then, whoever wrote
//! them; and what queries tell.

use super::{Stage, context, program};
use gl_api::*;

const T: GLenum = GL_TEXTURE_BUFFER;

/// What a sampler gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Float,
    Int,
    Uint,
}

impl Kind {
    const ALL: [Self; 3] = [Self::Float, Self::Int, Self::Uint];

    /// What comes before `vec4` and `samplerBuffer`, and the format of a pixel that holds it.
    fn names(self) -> (&'static str, GLenum, GLenum, GLenum) {
        match self {
            Self::Float => ("", GL_RGBA32F, GL_RGBA, GL_FLOAT),
            Self::Int => ("i", GL_RGBA32I, GL_RGBA_INTEGER, GL_INT),
            Self::Uint => ("u", GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT),
        }
    }

    /// One, as the words of its components are.
    fn one(self) -> u32 {
        if self == Self::Float { 1.0_f32.to_bits() } else { 1 }
    }
}

/// A program that fetches texel `at`, and a pixel for it.
struct Fetcher {
    kind: Kind,
    program: GLuint,
}

impl Fetcher {
    fn new(kind: Kind, stage: Stage) -> Self {
        let (k, ..) = kind.names();
        let fetch = format!(
            "#version 130\n#extension GL_EXT_gpu_shader4 : require\n\
             uniform {k}samplerBuffer s; uniform int at;\n\
             {k}vec4 fetch() {{ return at == -99 ? {k}vec4(textureSizeBuffer(s)) \
             : texelFetchBuffer(s, at); }}\n"
        );
        let version = "#version 130\n".to_owned();
        let (vertex, fragment) = match stage {
            Stage::Vertex => (
                format!(
                    "{fetch}flat out {k}vec4 v; void main() {{ v = fetch(); gl_Position = gl_Vertex; }}"
                ),
                format!("{version}flat in {k}vec4 v; out {k}vec4 r; void main() {{ r = v; }}"),
            ),
            Stage::Fragment => (
                format!("{version}void main() {{ gl_Position = gl_Vertex; }}"),
                format!("{fetch}out {k}vec4 r; void main() {{ r = fetch(); }}"),
            ),
        };
        Self { kind, program: program(&vertex, &fragment).unwrap() }
    }

    /// Records the draw into a framebuffer of its own, number `pixel`.
    fn draw(&self, at: i32, pixel: GLuint) {
        let (_, internal, ..) = self.kind.names();
        glBindFramebuffer(GL_FRAMEBUFFER, pixel);
        glBindRenderbuffer(GL_RENDERBUFFER, pixel);
        glRenderbufferStorage(GL_RENDERBUFFER, internal, 1, 1);
        let (point, target) = (GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, target, pixel);
        glViewport(0, 0, 1, 1);
        glUseProgram(self.program);
        glUniform1i(glGetUniformLocation(self.program, "at"), at);
        glRectf(-1, -1, 1, 1);
    }

    /// The words of the pixel of a draw.
    fn read(&self, pixel: GLuint) -> [u32; 4] {
        let (_, _, format, ty) = self.kind.names();
        glBindFramebuffer(GL_FRAMEBUFFER, pixel);
        let mut bytes = [0x55_u8; 16];
        glReadPixels(0, 0, 1, 1, format, ty, &mut bytes);
        assert_eq!(glGetError(), GL_NO_ERROR);
        std::array::from_fn(|i| u32::from_ne_bytes(bytes[4 * i..][..4].try_into().unwrap()))
    }

    /// The words of a texel.
    fn fetch(&self, at: i32) -> [u32; 4] {
        self.draw(at, 1);
        self.read(1)
    }
}

/// Gives buffer `name` these bytes, and texture 1 the buffer.
fn store(name: GLuint, internal: GLenum, bytes: &[u8]) {
    glBindBuffer(T, name);
    glBufferData(T, bytes.len(), bytes, GL_STATIC_DRAW);
    glBindTexture(T, 1);
    glTexBuffer(T, internal, name);
    assert_eq!(glGetError(), GL_NO_ERROR, "{}", enum_name(internal));
}

/// A component in memory.
#[derive(Clone, Copy, Debug)]
enum Component {
    Unorm(usize),
    Half,
    Float,
    Int(usize),
    Uint(usize),
}

/// The columns of [`FORMATS`].
const COMPONENTS: [Component; 10] = [
    Component::Unorm(1),
    Component::Unorm(2),
    Component::Half,
    Component::Float,
    Component::Int(1),
    Component::Int(2),
    Component::Int(4),
    Component::Uint(1),
    Component::Uint(2),
    Component::Uint(4),
];

/// Which component of a texel R, G, B and A are: a number, or `Z` and `O` for 0 and 1.
const Z: usize = 8;
const O: usize = 9;

#[rustfmt::skip]
const FORMATS: [(usize, [usize; 4], [GLenum; 10]); 8] = [
    (1, [Z, Z, Z, 0], [
        GL_ALPHA8, GL_ALPHA16, GL_ALPHA16F_ARB, GL_ALPHA32F_ARB, GL_ALPHA8I_EXT, GL_ALPHA16I_EXT,
        GL_ALPHA32I_EXT, GL_ALPHA8UI_EXT, GL_ALPHA16UI_EXT, GL_ALPHA32UI_EXT,
    ]),
    (1, [0, 0, 0, O], [
        GL_LUMINANCE8, GL_LUMINANCE16, GL_LUMINANCE16F_ARB, GL_LUMINANCE32F_ARB,
        GL_LUMINANCE8I_EXT, GL_LUMINANCE16I_EXT, GL_LUMINANCE32I_EXT, GL_LUMINANCE8UI_EXT,
        GL_LUMINANCE16UI_EXT, GL_LUMINANCE32UI_EXT,
    ]),
    (2, [0, 0, 0, 1], [
        GL_LUMINANCE8_ALPHA8, GL_LUMINANCE16_ALPHA16, GL_LUMINANCE_ALPHA16F_ARB,
        GL_LUMINANCE_ALPHA32F_ARB, GL_LUMINANCE_ALPHA8I_EXT, GL_LUMINANCE_ALPHA16I_EXT,
        GL_LUMINANCE_ALPHA32I_EXT, GL_LUMINANCE_ALPHA8UI_EXT, GL_LUMINANCE_ALPHA16UI_EXT,
        GL_LUMINANCE_ALPHA32UI_EXT,
    ]),
    (1, [0, 0, 0, 0], [
        GL_INTENSITY8, GL_INTENSITY16, GL_INTENSITY16F_ARB, GL_INTENSITY32F_ARB,
        GL_INTENSITY8I_EXT, GL_INTENSITY16I_EXT, GL_INTENSITY32I_EXT, GL_INTENSITY8UI_EXT,
        GL_INTENSITY16UI_EXT, GL_INTENSITY32UI_EXT,
    ]),
    (1, [0, Z, Z, O], [
        GL_R8, GL_R16, GL_R16F, GL_R32F, GL_R8I, GL_R16I, GL_R32I, GL_R8UI, GL_R16UI, GL_R32UI,
    ]),
    (2, [0, 1, Z, O], [
        GL_RG8, GL_RG16, GL_RG16F, GL_RG32F, GL_RG8I, GL_RG16I, GL_RG32I, GL_RG8UI, GL_RG16UI,
        GL_RG32UI,
    ]),
    (3, [0, 1, 2, O], [
        0, 0, 0, GL_RGB32F, 0, 0, GL_RGB32I, 0, 0, GL_RGB32UI,
    ]),
    (4, [0, 1, 2, 3], [
        GL_RGBA8, GL_RGBA16, GL_RGBA16F, GL_RGBA32F, GL_RGBA8I, GL_RGBA16I, GL_RGBA32I,
        GL_RGBA8UI, GL_RGBA16UI, GL_RGBA32UI,
    ]),
];

impl Component {
    fn size(self) -> usize {
        match self {
            Self::Unorm(size) | Self::Int(size) | Self::Uint(size) => size,
            Self::Half => 2,
            Self::Float => 4,
        }
    }

    fn kind(self) -> Kind {
        match self {
            Self::Unorm(_) | Self::Half | Self::Float => Kind::Float,
            Self::Int(_) => Kind::Int,
            Self::Uint(_) => Kind::Uint,
        }
    }

    /// The word that a shader gets of these bytes.
    fn word(self, bytes: &[u8]) -> u32 {
        let unsigned = bytes.iter().rev().fold(0_u32, |word, &byte| word << 8 | u32::from(byte));
        let bits = 8 * bytes.len() as i32;
        match self {
            Self::Unorm(_) => {
                let largest = 2_f64.powi(bits) - 1.0;
                ((f64::from(unsigned) / largest) as f32).to_bits()
            }
            // GL 3.0, section 2.1.2; none of them is infinite.
            Self::Half => {
                let (exponent, mantissa) = (unsigned >> 10 & 31, f64::from(unsigned & 1023));
                let value = match exponent {
                    0 => mantissa * 2_f64.powi(-24),
                    _ => (1.0 + mantissa / 1024.0) * 2_f64.powi(exponent as i32 - 15),
                };
                (if unsigned >> 15 == 1 { -value } else { value } as f32).to_bits()
            }
            Self::Float | Self::Uint(_) => unsigned,
            Self::Int(_) => ((unsigned << (32 - bits)) as i32 >> (32 - bits)) as u32,
        }
    }
}

#[test]
fn every_format_is_fetched_in_both_stages() {
    let _current = context();
    // No float or half of these is infinite or no number.
    let bytes: Vec<u8> = (0..67_u32).map(|i| ((i * 37 + 11) & 0xBB) as u8).collect();
    for (kind, stage) in
        Kind::ALL.into_iter().flat_map(|kind| [(kind, Stage::Vertex), (kind, Stage::Fragment)])
    {
        let fetcher = Fetcher::new(kind, stage);
        for (count, places, formats) in FORMATS {
            for (component, internal) in COMPONENTS.into_iter().zip(formats) {
                if component.kind() != kind || internal == 0 {
                    continue;
                }
                store(1, internal, &bytes);
                let size = component.size();
                // What is left of the last texel is none.
                let texels = (bytes.len() / (count * size)) as i32;
                for at in [0, 1, texels - 1, texels, -1, i32::MAX] {
                    let want = if (0..texels).contains(&at) {
                        places.map(|place| match place {
                            Z => 0,
                            O => kind.one(),
                            place => {
                                let start = (at as usize * count + place) * size;
                                component.word(&bytes[start..start + size])
                            }
                        })
                    } else {
                        [0; 4]
                    };
                    let got = fetcher.fetch(at);
                    assert_eq!(got, want, "{} {at}, {stage:?}", enum_name(internal));
                }
                let size = fetcher.fetch(-99);
                let want =
                    if kind == Kind::Float { (texels as f32).to_bits() } else { texels as u32 };
                assert_eq!(size, [want; 4], "{}", enum_name(internal));
            }
        }
    }
}

/// The first component of texel 1, where texels are words.
fn second(fetcher: &Fetcher) -> u32 {
    fetcher.fetch(1)[0]
}

#[test]
fn a_draw_finds_what_the_buffer_holds_then() {
    let _current = context();
    let fetcher = Fetcher::new(Kind::Uint, Stage::Fragment);
    let word = |value: u32| value.to_ne_bytes();
    store(1, GL_R32UI, &[word(1), word(2), word(3)].concat());
    assert_eq!(second(&fetcher), 2);
    glBufferSubData(T, 4, 4, &word(20)[..]);
    assert_eq!(second(&fetcher), 20);
    // Through another target, and from another buffer.
    glBindBuffer(GL_COPY_READ_BUFFER, 2);
    glBufferData(GL_COPY_READ_BUFFER, 4, &word(30)[..], GL_STATIC_DRAW);
    glCopyBufferSubData(GL_COPY_READ_BUFFER, T, 0, 4, 4);
    assert_eq!(second(&fetcher), 30);
    // Draws that wait keep what they saw.
    fetcher.draw(1, 1);
    glBufferSubData(T, 4, 4, &word(40)[..]);
    fetcher.draw(1, 2);
    glBufferData(T, 8, &[word(49), word(50)].concat()[..], GL_STATIC_DRAW);
    fetcher.draw(1, 3);
    assert_eq!([1, 2, 3].map(|pixel| fetcher.read(pixel)[0]), [30, 40, 50]);
    // One that is mapped and given back.
    let at = glMapBuffer(T, GL_WRITE_ONLY);
    assert!(!at.is_null());
    with_mapped(|bytes| bytes[4..8].copy_from_slice(&word(60)));
    assert!(glUnmapBuffer(T));
    assert_eq!(second(&fetcher), 60);
    // A deleted one goes on; another of its name is another.
    glDeleteBuffers(1, &1);
    assert_eq!(second(&fetcher), 60);
    glBindBuffer(T, 1);
    glBufferData(T, 8, &[word(0), word(70)].concat()[..], GL_STATIC_DRAW);
    assert_eq!(second(&fetcher), 60);
    glTexBuffer(T, GL_R32UI, 1);
    assert_eq!(second(&fetcher), 70);
    // None has no texels.
    glTexBuffer(T, GL_R32UI, 0);
    assert_eq!(fetcher.fetch(0), [0; 4]);
}

/// The bytes of the buffer that is mapped.
fn with_mapped(write: impl FnOnce(&mut [u8])) {
    with_current(|context| write(context.mapped_bytes(T).expect("mapped")));
}

#[test]
fn what_transform_feedback_captures_is_fetched() {
    let _current = context();
    let fetcher = Fetcher::new(Kind::Float, Stage::Fragment);
    store(1, GL_RG32F, &[0; 24]);
    assert_eq!(fetcher.fetch(2), [0, 0, 0, Kind::Float.one()]);
    let vertex = "varying vec2 v; void main() { v = 0.5 * gl_Vertex.xy; gl_Position = gl_Vertex; }";
    let capturing = program(vertex, "void main() { gl_FragColor = vec4(1.0); }").unwrap();
    glTransformFeedbackVaryings(capturing, 1, &["v"], GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(capturing);
    glUseProgram(capturing);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 1);
    glBeginTransformFeedback(GL_POINTS);
    glBegin(GL_POINTS);
    for x in [1.0, 3.0, 5.0] {
        glVertex2f(x, -x);
    }
    glEnd();
    glEndTransformFeedback();
    let want = [2.5_f32, -2.5, 0.0, 1.0].map(f32::to_bits);
    assert_eq!(fetcher.fetch(2), want);
}

#[test]
fn there_may_be_more_texels_than_an_image_has_in_a_row() {
    let _current = context();
    let fetcher = Fetcher::new(Kind::Uint, Stage::Fragment);
    let count = 1_000_003_u32;
    let bytes: Vec<u8> =
        (0..count).flat_map(|i| (i % 65_521).to_le_bytes()[..2].to_vec()).collect();
    store(1, GL_R16UI, &bytes);
    for at in [0, 16_383, 16_384, 65_535, 65_536, 999_999, count - 1] {
        assert_eq!(fetcher.fetch(at as i32), [at % 65_521, 0, 0, 1], "{at}");
    }
    assert_eq!(fetcher.fetch(count as i32), [0; 4]);
    assert_eq!(fetcher.fetch(-99), [count; 4]);
    let mut most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &mut most);
    assert!(most >= 65_536);
}

#[test]
fn a_range_is_a_part_of_the_buffer() {
    let _current = context();
    let fetcher = Fetcher::new(Kind::Uint, Stage::Fragment);
    let bytes: Vec<u8> = (1..=24).collect();
    store(1, GL_R8UI, &bytes);
    glTexBufferRange(T, GL_RG8UI, 1, 16, 5);
    let texels = |fetcher: &Fetcher| [0, 1, 2, -1].map(|at| fetcher.fetch(at));
    assert_eq!(texels(&fetcher), [[17, 18, 0, 1], [19, 20, 0, 1], [0; 4], [0; 4]]);
    assert_eq!(fetcher.fetch(-99), [2; 4]);
    assert_eq!(level(GL_TEXTURE_BUFFER_OFFSET), 16);
    assert_eq!(level(GL_TEXTURE_BUFFER_SIZE), 5);
    // A buffer that is too short by now has what it has.
    glBufferData(T, 19, &bytes[1..20], GL_STATIC_DRAW);
    assert_eq!(texels(&fetcher), [[18, 19, 0, 1], [0; 4], [0; 4], [0; 4]]);
    glBufferData(T, 9, &bytes[..9], GL_STATIC_DRAW);
    assert_eq!(fetcher.fetch(0), [0; 4]);
    // Without a buffer the range is not looked at.
    glTexBufferRange(T, GL_RG8UI, 0, -1, -1);
    assert_eq!(glGetError(), GL_NO_ERROR);
    assert_eq!(level(GL_TEXTURE_BUFFER_SIZE), 0);
}

/// What is known of the bound texture's texels.
fn level(pname: GLenum) -> i32 {
    let mut value = -1;
    glGetTexLevelParameteriv(T, 0, pname, &mut value);
    assert_eq!(glGetError(), GL_NO_ERROR, "{}", enum_name(pname));
    value
}

fn integer(pname: GLenum) -> i32 {
    let mut value = -1;
    glGetIntegerv(pname, &mut value);
    assert_eq!(glGetError(), GL_NO_ERROR, "{}", enum_name(pname));
    value
}

#[test]
fn queries_tell_what_is_bound_and_what_it_holds() {
    let _current = context();
    let asked = [
        GL_TEXTURE_BINDING_BUFFER,
        GL_TEXTURE_BUFFER_BINDING,
        GL_TEXTURE_BUFFER_DATA_STORE_BINDING,
        GL_TEXTURE_BUFFER_FORMAT_ARB,
    ];
    assert_eq!(asked.map(integer), [0, 0, 0, GL_LUMINANCE8 as i32]);
    store(7, GL_RGB32F, &[0; 40]);
    glBindBuffer(T, 8);
    assert_eq!(asked.map(integer), [1, 8, 7, GL_RGB32F as i32]);
    for (pname, want) in [
        (GL_TEXTURE_WIDTH, 3),
        (GL_TEXTURE_HEIGHT, 1),
        (GL_TEXTURE_DEPTH, 1),
        (GL_TEXTURE_BORDER, 0),
        (GL_TEXTURE_INTERNAL_FORMAT, GL_RGB32F as i32),
        (GL_TEXTURE_RED_SIZE, 32),
        (GL_TEXTURE_ALPHA_SIZE, 0),
        (GL_TEXTURE_BLUE_TYPE, GL_FLOAT as i32),
        (GL_TEXTURE_BUFFER_DATA_STORE_BINDING, 7),
        (GL_TEXTURE_BUFFER_OFFSET, 0),
        (GL_TEXTURE_BUFFER_SIZE, 40),
    ] {
        assert_eq!(level(pname), want, "{}", enum_name(pname));
    }
    // Other targets have no buffer.
    let mut value = -1;
    let pname = GL_TEXTURE_BUFFER_DATA_STORE_BINDING;
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, pname, &mut value);
    assert_eq!((value, glGetError()), (0, GL_NO_ERROR));
    // A deleted buffer is bound no more, but the texture has it.
    glDeleteBuffers(2, &[7, 8]);
    assert_eq!(asked.map(integer), [1, 0, 7, GL_RGB32F as i32]);
    assert_eq!(level(GL_TEXTURE_WIDTH), 3);
    // Calls on buffers are no part of a list.
    glNewList(1, GL_COMPILE);
    glTexBuffer(T, GL_R8, 0);
    glEndList();
    assert_eq!(integer(GL_TEXTURE_BUFFER_FORMAT_ARB), GL_R8 as i32);
}

#[test]
fn glsl_1_40_has_them_and_rectangles_without_an_extension() {
    let _current = context();
    let vertex = "#version 140\nvoid main() { gl_Position = gl_Vertex; }";
    let drawn = |declarations: &str, value: &str| {
        let fragment = format!(
            "#version 140\n{declarations}\nvoid main() {{ gl_FragColor = vec4({value}) / 255.0; }}"
        );
        let pixel = super::drawn(program(vertex, &fragment).unwrap());
        glUseProgram(0);
        pixel
    };
    store(1, GL_RGBA8UI, &[1, 2, 3, 4, 5, 6, 7, 8]);
    assert_eq!(drawn("uniform usamplerBuffer s;", "texelFetch(s, 1)"), [5, 6, 7, 8]);
    assert_eq!(drawn("uniform isamplerBuffer s;", "textureSize(s)"), [2; 4]);
    glTexBuffer(T, GL_RGBA8, 1);
    assert_eq!(drawn("uniform samplerBuffer s;", "255.0 * texelFetch(s, 0)"), [1, 2, 3, 4]);
    let (rect, rgba, byte) = (GL_TEXTURE_RECTANGLE, GL_RGBA, GL_UNSIGNED_BYTE);
    glBindTexture(rect, 2);
    glTexParameteri(rect, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(rect, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(rect, 0, rgba, 2, 1, 0, rgba, byte, &[1_u8, 2, 3, 4, 5, 6, 7, 8]);
    for call in [
        "texture(s, vec2(1.5, 0.5))",
        "textureProj(s, vec3(3.0, 1.0, 2.0))",
        "textureOffset(s, vec2(0.5), ivec2(1, 0))",
        "texelFetch(s, ivec2(1, 0))",
        "texelFetchOffset(s, ivec2(0), ivec2(1, 0))",
        "texture2DRect(s, vec2(1.5, 0.5))",
    ] {
        assert_eq!(drawn("uniform sampler2DRect s;", &format!("255.0 * {call}")), [5, 6, 7, 8]);
    }
    assert_eq!(drawn("uniform sampler2DRect s;", "textureSize(s), 3, 4"), [2, 1, 3, 4]);
    assert_eq!(glGetError(), GL_NO_ERROR);
}

#[test]
fn a_sampler_of_buffers_says_so() {
    let _current = context();
    for (kind, ty) in Kind::ALL.into_iter().zip([
        GL_SAMPLER_BUFFER,
        GL_INT_SAMPLER_BUFFER,
        GL_UNSIGNED_INT_SAMPLER_BUFFER,
    ]) {
        let fetcher = Fetcher::new(kind, Stage::Fragment);
        let mut types = Vec::new();
        for index in 0..2 {
            let (mut size, mut found, mut name) = (0, 0, String::new());
            glGetActiveUniform(fetcher.program, index, 16, NULL, &mut size, &mut found, &mut name);
            types.push((name, found));
        }
        assert!(types.contains(&("s".to_owned(), ty)), "{types:x?}");
    }
}
