//! Every entry point with random arguments, made from the table: what bounded tests and the fuzz
//! target `table` draw from. An argument is random by its type, and by its name where a size would
//! only cost time.

use crate::base::args::{Data, DataOut, Names, Pointers, Strings, TextOut};
use crate::base::constants::*;
use crate::base::types::GLvoid;
use crate::context::{Context, GLDEBUGPROC};

/// An entry point that can be called with random arguments.
pub struct Exercise {
    /// GL's name.
    pub name: &'static str,
    #[cfg(test)]
    pub(crate) begin_end: crate::base::begin_end::BeginEnd,
    /// The call.
    pub run: fn(&mut Context, &mut Random<'_>),
}

/// Every row of the table.
pub fn exercises() -> Vec<Exercise> {
    super::table::exercises()
}

/// splitmix64, with a byte of an input mixed into each number as long as there are any.
#[derive(Debug)]
pub struct Random<'a> {
    state: u64,
    bytes: &'a [u8],
}

impl<'a> Random<'a> {
    /// The numbers of a seed, and what an input decides of them.
    pub fn new(seed: u64, bytes: &'a [u8]) -> Self {
        Self { state: seed, bytes }
    }

    /// The next number.
    pub fn number(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        if let Some((first, rest)) = self.bytes.split_first() {
            self.state ^= u64::from(*first);
            self.bytes = rest;
        }
        let z = (self.state ^ self.state >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ z >> 31
    }

    /// A number below a limit.
    pub fn below(&mut self, limit: usize) -> usize {
        (self.number() % limit as u64) as usize
    }

    fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len())]
    }

    /// A value of the registry, mostly, or any number.
    fn enumerant(&mut self) -> u32 {
        match self.below(16) {
            0 => self.number() as u32,
            1..4 => self.below(14) as u32,
            4..12 => self.pick(COMMON),
            _ => VALUES[self.below(VALUES.len())].0,
        }
    }

    fn float(&mut self) -> f64 {
        match self.below(4) {
            0 => self.pick(&[
                0.0,
                -0.0,
                1.0,
                -1.0,
                1e30,
                -1e30,
                f64::MAX,
                f64::INFINITY,
                f64::NEG_INFINITY,
                f64::NAN,
                1e-40,
                1e7,
            ]),
            1 => f32::from_bits(self.number() as u32).into(),
            _ => self.below(2001) as f64 / 1000.0 - 1.0,
        }
    }

    fn integer(&mut self, name: &str) -> i64 {
        const LONG: [&str; 14] = [
            "width",
            "height",
            "depth",
            "count",
            "primcount",
            "instances",
            "instancecount",
            "size",
            "range",
            "n",
            "border",
            "imageSize",
            "levels",
            "samples",
        ];
        // What is as long as this says costs as much.
        if LONG.contains(&name) {
            return match self.below(8) {
                0 => self.pick(&[-1, i64::from(i32::MIN), 8193, 33]),
                _ => self.below(17) as i64,
            };
        }
        match self.below(8) {
            0 => self.pick(&[i32::MIN, -1, 255, 8192, i32::MAX]).into(),
            1 => self.number() as i32 as i64,
            2 => self.enumerant().into(),
            _ => self.below(20) as i64,
        }
    }

    fn bytes(&mut self) -> Vec<u8> {
        let length = self.pick(&[0, 1, 3, 4, 16, 64, 1000, 5000]);
        let first = self.number();
        (0..length).map(|at: u64| (first.wrapping_add(at * 37 + at / 5)) as u8).collect()
    }
}

/// Values that many calls take.
const COMMON: &[u32] = &[
    GL_TEXTURE_2D,
    GL_TEXTURE_CUBE_MAP,
    GL_TEXTURE_CUBE_MAP_POSITIVE_X,
    GL_TEXTURE_1D,
    GL_TEXTURE_3D,
    GL_TEXTURE_2D_ARRAY,
    GL_TEXTURE_CUBE_MAP_ARRAY,
    GL_TEXTURE_2D_MULTISAMPLE,
    GL_TEXTURE_2D_MULTISAMPLE_ARRAY,
    GL_RGB,
    GL_RGBA,
    GL_RGBA8,
    GL_DEPTH_COMPONENT,
    GL_UNSIGNED_BYTE,
    GL_FLOAT,
    GL_UNSIGNED_SHORT,
    GL_UNSIGNED_INT,
    GL_TEXTURE_MIN_FILTER,
    GL_NEAREST,
    GL_LINEAR,
    GL_TEXTURE0,
    GL_TEXTURE1,
    GL_MODELVIEW,
    GL_PROJECTION,
    GL_LIGHTING,
    GL_LIGHT0,
    GL_AMBIENT,
    GL_DIFFUSE,
    GL_FRONT,
    GL_BACK,
    GL_FRONT_AND_BACK,
    GL_COMPILE,
    GL_COMPILE_AND_EXECUTE,
    GL_ARRAY_BUFFER,
    GL_ELEMENT_ARRAY_BUFFER,
    GL_STATIC_DRAW,
    GL_READ_ONLY,
    GL_VERTEX_ARRAY,
    GL_COLOR_ARRAY,
    GL_FRAMEBUFFER,
    GL_RENDERBUFFER,
    GL_COLOR_ATTACHMENT0,
    GL_DEPTH_ATTACHMENT,
    GL_VERTEX_SHADER,
    GL_FRAGMENT_SHADER,
    GL_SAMPLES_PASSED,
    GL_QUERY_WAIT,
    GL_SELECT,
    GL_FEEDBACK,
    GL_RENDER,
    GL_3D_COLOR,
    GL_MAP1_VERTEX_3,
    GL_MAP2_VERTEX_3,
    GL_FILL,
    GL_LINE,
    GL_ACCUM,
    GL_RETURN,
    GL_LESS,
    GL_ALWAYS,
    GL_ONE,
    GL_SRC_ALPHA,
    GL_FUNC_ADD,
    GL_DEPTH_TEST,
    GL_BLEND,
    GL_UNPACK_ALIGNMENT,
];

const TEXTS: &[&str] = &[
    "a",
    "gl_Position",
    "m[0]",
    "",
    "\u{fffd}\u{1}",
    "void main() { gl_Position = ftransform(); gl_TexCoord[0] = gl_MultiTexCoord0; }",
    "uniform sampler2D t; void main() { gl_FragColor = texture2D(t, gl_TexCoord[0].st); }",
    "#version 130\nin vec4 a; out vec4 v; uniform mat4 m; void main() { v = a; gl_Position = m * a; }",
    "#version 130\nin vec4 v; out vec4 c; uniform int n; void main() { c = v * float(n); }",
    "void main() { ((((((",
];

/// A parameter's type, random: what is held during the call, and what is lent to it.
pub(crate) trait Exercised<'a>: Sized {
    type Held: 'static;

    /// A value for the parameter `name`, whose type is spelled `ty`.
    fn held(random: &mut Random<'_>, name: &str, ty: &str) -> Self::Held;

    fn lend(held: &'a mut Self::Held) -> Self;
}

/// A number of memory.
pub(crate) trait Element: Copy + 'static {
    fn element(random: &mut Random<'_>) -> Self;
}

macro_rules! numbers {
    ($($ty:ty: |$random:ident, $name:ident, $spelled:ident| $value:expr;)*) => { $(
        impl Exercised<'_> for $ty {
            type Held = $ty;

            fn held($random: &mut Random<'_>, $name: &str, $spelled: &str) -> $ty {
                ($value) as $ty
            }

            fn lend(held: &mut $ty) -> $ty {
                *held
            }
        }

        impl Element for $ty {
            fn element(random: &mut Random<'_>) -> $ty {
                <$ty as Exercised<'_>>::held(random, "", "")
            }
        }
    )* };
}

numbers! {
    i8: |random, _name, _ty| random.number();
    u8: |random, _name, _ty| random.number();
    i16: |random, _name, _ty| random.number();
    u16: |random, _name, _ty| random.number();
    i32: |random, name, _ty| random.integer(name);
    u32: |random, _name, ty| match ty {
        "GLenum" => random.enumerant(),
        "GLbitfield" => random.number() as u32 & random.pick(&[u32::MAX, 0x4700, 3, 0xFFFFF]),
        _ => random.pick(&[0, 1, 2, 3, 4, 5, 6, 7, 666, u32::MAX]),
    };
    i64: |random, name, _ty| random.integer(name);
    u64: |random, _name, _ty| random.pick(&[0, 1, 1000, u64::MAX]);
    isize: |random, _name, _ty| {
        let small = random.below(5000) as isize;
        random.pick(&[small, small, small, 0, -1, isize::MIN, isize::MAX])
    };
    f32: |random, _name, _ty| random.float();
    f64: |random, _name, _ty| random.float();
}

impl Exercised<'_> for bool {
    type Held = bool;

    fn held(random: &mut Random<'_>, _: &str, _: &str) -> bool {
        random.below(2) == 1
    }

    fn lend(held: &mut bool) -> bool {
        *held
    }
}

fn elements<T: Element>(random: &mut Random<'_>) -> Vec<T> {
    let length = random.pick(&[0, 1, 2, 3, 4, 16, 40]);
    (0..length).map(|_| T::element(random)).collect()
}

impl<'a, T: Element> Exercised<'a> for &'a [T] {
    type Held = Vec<T>;

    fn held(random: &mut Random<'_>, _: &str, _: &str) -> Vec<T> {
        elements(random)
    }

    fn lend(held: &'a mut Vec<T>) -> Self {
        held
    }
}

impl<'a, T: Element> Exercised<'a> for &'a mut [T] {
    type Held = Vec<T>;

    fn held(random: &mut Random<'_>, _: &str, _: &str) -> Vec<T> {
        elements(random)
    }

    fn lend(held: &'a mut Vec<T>) -> Self {
        held
    }
}

impl Element for *mut GLvoid {
    fn element(_: &mut Random<'_>) -> Self {
        std::ptr::null_mut()
    }
}

/// A handle or an address that is only kept: nothing reads through it.
fn address(random: &mut Random<'_>) -> usize {
    random.below(4)
}

impl Exercised<'_> for *mut GLvoid {
    type Held = usize;

    fn held(random: &mut Random<'_>, _: &str, _: &str) -> usize {
        address(random)
    }

    fn lend(held: &mut usize) -> Self {
        std::ptr::without_provenance_mut(*held)
    }
}

impl Exercised<'_> for *const GLvoid {
    type Held = usize;

    fn held(random: &mut Random<'_>, _: &str, _: &str) -> usize {
        address(random)
    }

    fn lend(held: &mut usize) -> Self {
        std::ptr::without_provenance(*held)
    }
}

impl Exercised<'_> for GLDEBUGPROC {
    type Held = ();

    fn held(_: &mut Random<'_>, _: &str, _: &str) {}

    fn lend((): &mut ()) -> Self {
        None
    }
}

impl<'a> Exercised<'a> for &'a str {
    type Held = &'static str;

    fn held(random: &mut Random<'_>, _: &str, _: &str) -> &'static str {
        random.pick(TEXTS)
    }

    fn lend(held: &'a mut &'static str) -> Self {
        held
    }
}

impl<'a> Exercised<'a> for Strings<'a> {
    type Held = Vec<&'static str>;

    fn held(random: &mut Random<'_>, _: &str, _: &str) -> Self::Held {
        (0..random.below(4)).map(|_| random.pick(TEXTS)).collect()
    }

    fn lend(held: &'a mut Self::Held) -> Self {
        Strings(held.clone())
    }
}

impl<'a> Exercised<'a> for Names<'a> {
    type Held = Vec<&'static str>;

    fn held(random: &mut Random<'_>, _: &str, _: &str) -> Self::Held {
        (0..random.below(4)).map(|_| random.pick(TEXTS)).collect()
    }

    fn lend(held: &'a mut Self::Held) -> Self {
        Names(held.clone())
    }
}

/// Memory, an offset, or nothing.
pub(crate) enum Held {
    Bytes(Vec<u8>),
    Offset(usize),
    Null,
}

fn held(random: &mut Random<'_>) -> Held {
    match random.below(6) {
        0 => Held::Null,
        1 => Held::Offset(random.pick(&[0, 1, 4, 16, 1000, usize::MAX])),
        _ => Held::Bytes(random.bytes()),
    }
}

impl<'a> Exercised<'a> for Data<'a> {
    type Held = Held;

    fn held(random: &mut Random<'_>, _: &str, _: &str) -> Held {
        held(random)
    }

    fn lend(held: &'a mut Held) -> Self {
        match held {
            Held::Bytes(bytes) => Data::Bytes(bytes),
            Held::Offset(offset) => Data::Offset(*offset),
            Held::Null => Data::Null,
        }
    }
}

impl<'a> Exercised<'a> for DataOut<'a> {
    type Held = Held;

    fn held(random: &mut Random<'_>, _: &str, _: &str) -> Held {
        held(random)
    }

    fn lend(held: &'a mut Held) -> Self {
        match held {
            Held::Bytes(bytes) => DataOut::Bytes(bytes),
            Held::Offset(offset) => DataOut::Offset(*offset),
            Held::Null => DataOut::Null,
        }
    }
}

impl<'a> Exercised<'a> for Pointers<'a> {
    type Held = Vec<Held>;

    fn held(random: &mut Random<'_>, _: &str, _: &str) -> Vec<Held> {
        (0..random.below(4)).map(|_| held(random)).collect()
    }

    fn lend(held: &'a mut Vec<Held>) -> Self {
        Pointers(held.iter_mut().map(Data::lend).collect())
    }
}

impl<'a> Exercised<'a> for TextOut<'a> {
    type Held = Held;

    fn held(random: &mut Random<'_>, _: &str, _: &str) -> Held {
        held(random)
    }

    fn lend(held: &'a mut Held) -> Self {
        match held {
            Held::Bytes(bytes) => TextOut::Bytes(bytes),
            Held::Offset(_) | Held::Null => TextOut::Null,
        }
    }
}

#[cfg(test)]
mod tests;
