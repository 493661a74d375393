//! A random argument of each type that entry points take.

use super::Random;
use crate::base::args::{Data, DataOut, Names, Pointers, Strings, TextOut};
use crate::base::types::GLvoid;
use crate::context::GLDEBUGPROC;

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
