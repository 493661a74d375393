//! Every C function of GL with pointers that end where memory ends: each has as many elements as the specification says,
//! and what follows is not mapped. So a call that reads or writes one byte more ends the test, which names it.
//!
//! Lengths of typed pointers are those of the Khronos registry ([`crate::lengths`]), of untyped ones the formulas of
//! the specification, which stand here once more ([`data_bytes`]).

use crate::lengths::{Rule, rules};
use crate::param::{Param, TERMINATED};
use gl_api::constants::*;
use gl_api::*;
use std::cell::Cell;
use std::ffi::{c_char, c_int, c_void};
use std::ptr::{null, null_mut};

/// At least the page size of every machine.
const PAGE: usize = 1 << 16;
/// Pointers of a call, at most.
const SLOTS: usize = 12;

unsafe extern "C" {
    fn mmap(
        at: *mut c_void,
        len: usize,
        prot: c_int,
        flags: c_int,
        fd: c_int,
        offset: i64,
    ) -> *mut c_void;
    fn mprotect(at: *mut c_void, len: usize, prot: c_int) -> c_int;
    fn signal(number: c_int, handler: usize) -> usize;
    fn write(fd: c_int, bytes: *const c_void, count: usize) -> isize;
    fn _exit(code: c_int) -> !;
}

thread_local! {
    /// The name of the call that runs, for the handler.
    static NAME: Cell<&'static str> = const { Cell::new("") };
}

extern "C" fn names_the_call(_: c_int) {
    let text = b"\nreads or writes past the end of its memory: ";
    // SAFETY: such bytes as the slices have; both functions may be called from a handler.
    unsafe {
        write(2, text.as_ptr().cast(), text.len());
        let name = NAME.get();
        write(2, name.as_ptr().cast(), name.len());
        write(2, b"\n".as_ptr().cast(), 1);
        _exit(101);
    }
}

/// A page, and after it one that cannot be reached.
#[derive(Clone, Copy)]
struct Slot(*mut u8);

impl Slot {
    fn new() -> Self {
        const READ_WRITE: c_int = 3;
        const NONE: c_int = 0;
        // Linux: private and of no file.
        const PRIVATE_ANONYMOUS: c_int = 0x22;
        // SAFETY: memory of its own.
        unsafe {
            let start = mmap(null_mut(), 2 * PAGE, READ_WRITE, PRIVATE_ANONYMOUS, -1, 0);
            assert_ne!(start.addr(), usize::MAX, "no memory");
            assert_eq!(mprotect(start.byte_add(PAGE), PAGE, NONE), 0);
            Self(start.cast())
        }
    }

    /// The last `bytes` of the page, with small numbers in them.
    fn last(self, bytes: usize, random: &Random) -> *mut u8 {
        let bytes = bytes.min(PAGE);
        // SAFETY: within the page.
        unsafe {
            let start = self.0.add(PAGE - bytes);
            for at in 0..bytes {
                *start.add(at) = if at % 4 == 0 { random.below(6) as u8 } else { 0 };
            }
            start
        }
    }
}

/// What a count is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Counts {
    /// Small, and the memory has so many elements.
    Honest,
    /// Negative or huge, of the parameter of this number; the memory has a few elements.
    Hostile(usize),
}

#[derive(Debug)]
struct Random(Cell<u64>);

impl Random {
    fn below(&self, limit: u64) -> u64 {
        let mut z = self.0.get().wrapping_add(0x9E37_79B9_7F4A_7C15);
        self.0.set(z);
        z = (z ^ z >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z ^ z >> 31) % limit
    }

    fn pick<T: Copy>(&self, from: &[T]) -> T {
        from[self.below(from.len() as u64) as usize]
    }
}

const HOSTILE: &[i64] = &[0x7FFF_FFFF, 0x4000_0001, 1 << 24, -1, -0x8000_0000];

const FORMATS: &[(GLenum, usize)] = &[
    (GL_RED, 1),
    (GL_ALPHA, 1),
    (GL_LUMINANCE, 1),
    (GL_DEPTH_COMPONENT, 1),
    (GL_STENCIL_INDEX, 1),
    (GL_LUMINANCE_ALPHA, 2),
    (GL_RG, 2),
    (GL_RGB, 3),
    (GL_BGR, 3),
    (GL_RGBA, 4),
    (GL_BGRA, 4),
];
/// Types: bytes of a component, or of the whole pixel.
const TYPES: &[(GLenum, usize, bool)] = &[
    (GL_UNSIGNED_BYTE, 1, false),
    (GL_BYTE, 1, false),
    (GL_UNSIGNED_SHORT, 2, false),
    (GL_SHORT, 2, false),
    (GL_UNSIGNED_INT, 4, false),
    (GL_INT, 4, false),
    (GL_FLOAT, 4, false),
    (GL_HALF_FLOAT, 2, false),
    (GL_UNSIGNED_BYTE_3_3_2, 1, true),
    (GL_UNSIGNED_SHORT_5_6_5, 2, true),
    (GL_UNSIGNED_SHORT_4_4_4_4, 2, true),
    (GL_UNSIGNED_INT_8_8_8_8, 4, true),
    (GL_UNSIGNED_INT_2_10_10_10_REV, 4, true),
];
const TARGETS: &[GLenum] = &[
    GL_TEXTURE_2D,
    GL_TEXTURE_1D,
    GL_TEXTURE_3D,
    GL_TEXTURE_CUBE_MAP,
    GL_TEXTURE_CUBE_MAP_POSITIVE_X,
    GL_TEXTURE_RECTANGLE,
    GL_TEXTURE_ENV,
    GL_TEXTURE_FILTER_CONTROL,
    GL_ARRAY_BUFFER,
    GL_ELEMENT_ARRAY_BUFFER,
    GL_FRAMEBUFFER,
    GL_RENDERBUFFER,
    GL_MAP1_VERTEX_3,
    GL_MAP1_COLOR_4,
    GL_MAP2_VERTEX_3,
    GL_MAP2_TEXTURE_COORD_2,
    GL_VERTEX_PROGRAM_ARB,
    GL_FRAGMENT_PROGRAM_ARB,
    GL_SAMPLES_PASSED,
    GL_POINT_SPRITE,
    GL_UNIFORM_BUFFER,
    GL_TRANSFORM_FEEDBACK_BUFFER,
    GL_FOG_HINT,
    GL_PROXY_TEXTURE_2D,
    GL_TEXTURE_BUFFER,
    GL_TEXTURE_2D_ARRAY,
];
/// Where names of state and parameters lie.
const NAMES: &[(GLenum, GLenum)] = &[
    (0x0B00, 0x0DFF),
    (0x1200, 0x1203),
    (0x1600, 0x1603),
    (0x2200, 0x2203),
    (0x2500, 0x2503),
    (0x2800, 0x2803),
    (0x8000, 0x8FFF),
    (0x9000, 0x91FF),
    (0x1000, 0x1005),
    (0x0A00, 0x0A03),
    (0x2300, 0x2305),
];

/// A number for a parameter that is none of a length.
fn number(random: &Random, name: &str, ty: &str) -> i64 {
    match (name, ty) {
        ("format", "GLenum") => random.pick(FORMATS).0.into(),
        ("ty" | "type_", "GLenum") => random.pick(TYPES).0.into(),
        ("target", "GLenum") => random.pick(TARGETS).into(),
        ("pname" | "name" | "param" | "value", "GLenum") => {
            let (first, last) = random.pick(NAMES);
            (u64::from(first) + random.below(u64::from(last - first) + 1)) as i64
        }
        (_, "GLenum") => match random.below(3) {
            0 => random.below(10) as i64,
            1 => random.pick(TARGETS).into(),
            _ => random
                .pick(&[
                    GL_LIGHT0,
                    GL_FRONT,
                    GL_COLOR,
                    GL_DEPTH,
                    GL_STENCIL,
                    GL_S,
                    GL_FLOAT,
                    GL_RGBA8,
                    GL_RGBA,
                    GL_PIXEL_MAP_R_TO_R,
                    GL_VERTEX_SHADER,
                    GL_BACK,
                    GL_STATIC_DRAW,
                    GL_UNSIGNED_INT,
                    GL_UNSIGNED_SHORT,
                    GL_UNSIGNED_BYTE,
                    GL_DONT_CARE,
                    GL_COLOR_ATTACHMENT0,
                    GL_TEXTURE,
                    GL_BUFFER,
                    GL_PROGRAM,
                ])
                .into(),
        },
        (_, "GLuint") => random.below(4) as i64,
        ("level" | "border" | "base" | "xoffset" | "yoffset" | "zoffset", _) => {
            random.below(8) as i64 / 7
        }
        ("location", _) => random.below(5) as i64 - 1,
        ("internal_format" | "internalformat", _) => {
            random.pick(&[GL_RGBA8, GL_RGBA, GL_R8, GL_DEPTH_COMPONENT24]).into()
        }
        ("order" | "uorder" | "vorder", _) => random.below(4) as i64,
        ("stride" | "ustride" | "vstride", _) => random.below(9) as i64,
        _ => random.below(5) as i64,
    }
}

/// Whether a parameter says how much memory there is, or how large an image is.
fn is_count(name: &str, ty: &str) -> bool {
    matches!(ty, "GLsizei" | "GLsizeiptr" | "GLintptr")
        || matches!(
            name,
            "order"
                | "uorder"
                | "vorder"
                | "stride"
                | "ustride"
                | "vstride"
                | "count"
                | "size"
                | "n"
        )
}

/// Bytes of pixels in rows that begin at multiples of 4 (GL 2.1, section 3.6.4): the last row has no padding.
fn image(size: [isize; 3], format: isize, ty: isize) -> Option<usize> {
    let components = FORMATS.iter().find(|row| row.0 == format as GLenum)?.1;
    let &(_, bytes, packed) = TYPES.iter().find(|row| row.0 == ty as GLenum)?;
    let [width, height, depth] = size.map(|side| usize::try_from(side).unwrap_or(0));
    let row = width * bytes * if packed { 1 } else { components };
    match width * height * depth {
        0 => Some(0),
        _ => Some(row.next_multiple_of(4) * (height * depth - 1) + row),
    }
}

fn bits(width: isize, height: isize) -> Option<usize> {
    let (width, height) = (usize::try_from(width).ok()?, usize::try_from(height).ok()?);
    let row = width.div_ceil(8);
    Some(if row * height == 0 { 0 } else { row.next_multiple_of(4) * (height - 1) + row })
}

/// Bytes of an index, and of a name of a list.
fn element(ty: isize) -> usize {
    match ty as GLenum {
        GL_UNSIGNED_BYTE | GL_BYTE => 1,
        GL_UNSIGNED_SHORT | GL_SHORT | GL_2_BYTES => 2,
        GL_3_BYTES => 3,
        _ => 4,
    }
}

/// How many bytes an untyped pointer stands for; `None` where the null pointer is passed: what a call keeps, and what
/// no formula of arguments says.
fn data_bytes(name: &str, a: &[isize]) -> Option<usize> {
    let many = |count: isize, each: usize| Some(usize::try_from(count).unwrap_or(0) * each);
    match name {
        "glBitmap" => bits(a[0], a[1]),
        "glPolygonStipple" | "glGetPolygonStipple" => Some(128),
        "glCallLists" => many(a[0], element(a[1])),
        "glTexImage1D" => image([a[3], 1, 1], a[5], a[6]),
        "glTexImage2D" => image([a[3], a[4], 1], a[6], a[7]),
        "glTexImage3D" | "glTexImage3DEXT" => image([a[3], a[4], a[5]], a[7], a[8]),
        "glTexSubImage1D" | "glTexSubImage1DEXT" => image([a[3], 1, 1], a[4], a[5]),
        "glTexSubImage2D" | "glTexSubImage2DEXT" => image([a[4], a[5], 1], a[6], a[7]),
        "glTexSubImage3D" | "glTexSubImage3DEXT" => image([a[5], a[6], a[7]], a[8], a[9]),
        "glDrawPixels" => image([a[0], a[1], 1], a[2], a[3]),
        "glReadPixels" => image([a[2], a[3], 1], a[4], a[5]),
        "glPixelMapfv" | "glPixelMapuiv" => many(a[1], 4),
        "glPixelMapusv" => many(a[1], 2),
        // A table that nobody has set has one entry.
        "glGetPixelMapfv" | "glGetPixelMapuiv" => Some(4),
        "glGetPixelMapusv" => Some(2),
        "glBufferData" | "glBufferDataARB" => many(a[1], 1),
        "glBufferSubData"
        | "glBufferSubDataARB"
        | "glGetBufferSubData"
        | "glGetBufferSubDataARB" => many(a[2], 1),
        "glDrawElements"
        | "glDrawElementsBaseVertex"
        | "glDrawElementsInstanced"
        | "glDrawElementsInstancedARB"
        | "glDrawElementsInstancedEXT"
        | "glDrawElementsInstancedBaseVertex" => many(a[1], element(a[2])),
        "glDrawRangeElements" | "glDrawRangeElementsEXT" | "glDrawRangeElementsBaseVertex" => {
            many(a[3], element(a[4]))
        }
        "glCompressedTexImage1D" | "glCompressedTexImage1DARB" => many(a[5], 1),
        "glCompressedTexImage2D" | "glCompressedTexImage2DARB" => many(a[6], 1),
        "glCompressedTexImage3D" | "glCompressedTexImage3DARB" => many(a[7], 1),
        "glCompressedTexSubImage1D" | "glCompressedTexSubImage1DARB" => many(a[5], 1),
        "glCompressedTexSubImage2D" | "glCompressedTexSubImage2DARB" => many(a[7], 1),
        "glCompressedTexSubImage3D" | "glCompressedTexSubImage3DARB" => many(a[9], 1),
        _ => None,
    }
}

/// Calls that read or write as many elements as the client says, without a limit: with a huge count it is the client
/// that has to have the memory.
const UNLIMITED: &[&str] = &[
    "glAreTexturesResident",
    "glAreTexturesResidentEXT",
    "glBufferData",
    "glBufferDataARB",
    "glCallLists",
    "glDebugMessageControl",
    "glDebugMessageControlARB",
    "glDeleteBuffers",
    "glDrawPixels",
    "glBitmap",
    "glGetActiveUniformsiv",
    "glGetUniformIndices",
    "glPrioritizeTextures",
    "glPrioritizeTexturesEXT",
    "glSelectBuffer",
    "glFeedbackBuffer",
    "glShaderSource",
    "glShaderSourceARB",
    "glMap1f",
    "glMap1d",
    "glMap2f",
    "glMap2d",
    "glReadPixels",
    "glShaderBinary",
    "glProgramStringARB",
];

fn is_unlimited(name: &str) -> bool {
    let starts = |beginning| name.starts_with(beginning);
    UNLIMITED.contains(&name)
        || starts("glGen")
        || starts("glDelete")
        || starts("glMultiDraw")
        || starts("glDrawElements")
        || starts("glDrawRangeElements")
}

/// A parameter's C argument: a number, or memory.
trait Argument<'a>: Param<'a> {
    /// Of what is no pointer.
    fn number(_: i64) -> Option<Self::Raw> {
        None
    }

    /// Of a pointer with so many elements, or [`TERMINATED`].
    fn memory(slot: Slot, length: usize, random: &Random) -> Self::Raw;
}

macro_rules! number_arguments {
    ($($ty:ty: $value:ident => $number:expr;)*) => { $(
        impl Argument<'_> for $ty {
            fn number($value: i64) -> Option<<$ty as Param<'static>>::Raw> {
                Some($number)
            }

            fn memory(_: Slot, _: usize, _: &Random) -> <$ty as Param<'static>>::Raw {
                unreachable!("a number")
            }
        }
    )* };
}

number_arguments! {
    i8: value => value as i8;
    u8: value => value as u8;
    i16: value => value as i16;
    u16: value => value as u16;
    i32: value => value as i32;
    u32: value => value as u32;
    i64: value => value;
    u64: value => value as u64;
    isize: value => value as isize;
    usize: value => value as usize;
    f32: value => value as f32 / 4.0;
    f64: value => value as f64 / 4.0;
    bool: value => (value & 1) as u8;
    *const c_void: _value => null();
    *mut c_void: _value => null_mut();
    GLDEBUGPROC: _value => None;
}

impl<'a, T: Copy + 'static> Argument<'a> for &'a [T] {
    fn memory(slot: Slot, length: usize, random: &Random) -> *const T {
        slot.last(length.saturating_mul(size_of::<T>()), random).cast_const().cast()
    }
}

impl<'a, T: Copy + 'static> Argument<'a> for &'a mut [T] {
    fn memory(slot: Slot, length: usize, random: &Random) -> *mut T {
        slot.last(length.saturating_mul(size_of::<T>()), random).cast()
    }
}

impl<'a> Argument<'a> for TextOut<'a> {
    fn memory(slot: Slot, length: usize, random: &Random) -> *mut c_char {
        slot.last(length, random).cast()
    }
}

/// Text that ends where memory ends: with a zero, if its length is not said.
fn text(slot: Slot, length: usize, random: &Random) -> *const c_char {
    let (length, zero) = if length == TERMINATED { (63, 1) } else { (length.min(PAGE), 0) };
    let start = slot.last(length + zero, random);
    // SAFETY: within the page.
    unsafe {
        for at in 0..length {
            *start.add(at) = b'u';
        }
        if zero == 1 {
            *start.add(length) = 0;
        }
    }
    start.cast_const().cast()
}

impl<'a> Argument<'a> for &'a str {
    fn memory(slot: Slot, length: usize, random: &Random) -> *const c_char {
        text(slot, length, random)
    }
}

/// Pointers to one text, which a zero ends.
fn texts(slot: Slot, length: usize, random: &Random) -> *const *const c_char {
    thread_local! { static TEXT: Slot = Slot::new(); }
    let text = text(TEXT.with(|slot| *slot), TERMINATED, random);
    let count = length.min(PAGE / size_of::<usize>());
    let start = slot.last(count * size_of::<usize>(), random).cast::<*const c_char>();
    for at in 0..count {
        // SAFETY: within the page.
        unsafe { start.add(at).write_unaligned(text) };
    }
    start.cast_const()
}

impl<'a> Argument<'a> for Strings<'a> {
    fn memory(slot: Slot, length: usize, random: &Random) -> *const *const c_char {
        texts(slot, length, random)
    }
}

impl<'a> Argument<'a> for Names<'a> {
    fn memory(slot: Slot, length: usize, random: &Random) -> *const *const c_char {
        texts(slot, length, random)
    }
}

impl<'a> Argument<'a> for Pointers<'a> {
    fn memory(slot: Slot, length: usize, random: &Random) -> *const *const c_void {
        texts(slot, length, random).cast()
    }
}

impl<'a> Argument<'a> for Data<'a> {
    fn memory(slot: Slot, length: usize, random: &Random) -> *const c_void {
        if length == TERMINATED { null() } else { slot.last(length, random).cast_const().cast() }
    }
}

impl<'a> Argument<'a> for DataOut<'a> {
    fn memory(slot: Slot, length: usize, random: &Random) -> *mut c_void {
        if length == TERMINATED { null_mut() } else { slot.last(length, random).cast() }
    }
}

/// Elements of a pointer: as many as its rule says; of untyped memory, bytes.
fn elements(rule: Option<&Rule>, name: &str, numbers: &[isize], counts: Counts) -> usize {
    let honest = match rule {
        None | Some(Rule::None) => data_bytes(name, numbers).unwrap_or(TERMINATED),
        Some(rule) => rule.length(numbers),
    };
    match (counts, rule) {
        (Counts::Honest, _) => honest,
        // The call may look at as many as it has a use for.
        (Counts::Hostile(_), Some(Rule::TimesAtMost { .. })) => honest,
        (Counts::Hostile(_), _) if honest == TERMINATED => honest,
        (Counts::Hostile(_), _) => honest.min(256),
    }
}

/// A C function with arguments of its types.
struct Case {
    name: &'static str,
    /// The numbers of the parameters that are counts.
    counts: Vec<usize>,
    run: fn(&[Slot; SLOTS], &Random, Counts),
}

/// All names of all rows.
fn cases() -> Vec<Case> {
    let mut all = Vec::new();
    macro_rules! add {
        ($method:ident [$first:ident $($alias:ident)*] $params:tt $ret:tt) => {
            add!(@one $first $first $params);
            $(add!(@one $first $alias $params);)*
        };
        (@one $first:ident $gl:ident ($($param:ident: $ty:ty),*)) => {
            let parameters: &[(&str, &str)] = &[$((stringify!($param), stringify!($ty))),*];
            let counts = parameters.iter().enumerate().filter(|(_, (name, ty))| is_count(name, ty));
            all.push(Case {
                name: stringify!($gl),
                counts: counts.map(|(at, _)| at).collect(),
                run: {
                    #[allow(clippy::extra_unused_lifetimes, reason = "for the rows that borrow")]
                    fn run<'a>(slots: &[Slot; SLOTS], random: &Random, counts: Counts) {
                        let rules = const {
                            rules(stringify!($first), stringify!($gl), [$(<$ty as Param<'a>>::COUNTED),*])
                        };
                        let mut _at = 0;
                        let mut next = |name: &str, ty: &str| {
                            let number = match counts {
                                Counts::Hostile(at) if at == _at => random.pick(HOSTILE),
                                Counts::Hostile(_) | Counts::Honest => number(random, name, ty),
                            };
                            _at += 1;
                            number
                        };
                        let _ = &mut next;
                        $(let $param = <$ty as Argument<'a>>::number(next(stringify!($param), stringify!($ty)));)*
                        let _numbers: &[isize] = &[$($param.map_or(0, <$ty as Param<'a>>::number)),*];
                        let mut _slots = slots.iter();
                        let mut _rules = rules.iter();
                        $(
                            let (slot, rule) = (_slots.next(), _rules.next());
                            let $param = match ($param, slot) {
                                (Some(number), _) => number,
                                (None, Some(slot)) => {
                                    let length = elements(rule, stringify!($gl), _numbers, counts);
                                    <$ty as Argument<'a>>::memory(*slot, length, random)
                                }
                                (None, None) => unreachable!("there are more slots than parameters"),
                            };
                        )*
                        // SAFETY: what the test is about.
                        let _ = unsafe { super::$gl($($param),*) };
                    }
                    run
                },
            });
        };
    }
    entry_points!(each_row add);
    all
}

/// A context with an object of each kind that calls look up, most of them named 1.
fn context() -> Current {
    let desc = ContextDesc { width: 16, height: 16, ..ContextDesc::default() };
    let mut c = Context::new(desc).expect("a device");
    c.bind_texture(GL_TEXTURE_2D, 1);
    let texels = Data::Bytes(&[7; 64]);
    c.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    c.bind_buffer(GL_ARRAY_BUFFER, 1);
    c.buffer_data(GL_ARRAY_BUFFER, 64, Data::Null, GL_STATIC_DRAW);
    c.bind_buffer(GL_ARRAY_BUFFER, 0);
    let shader = c.create_shader(GL_FRAGMENT_SHADER);
    let source =
        "uniform vec4 u[4]; uniform mat3 m; void main() { gl_FragColor = u[3] + m[1].xyzz; }";
    c.shader_source(shader, 1, Strings(vec![source]), &[]);
    c.compile_shader(shader);
    let program = c.create_program();
    c.attach_shader(program, shader);
    c.link_program(program);
    c.use_program(program);
    c.begin_query(GL_SAMPLES_PASSED, 1);
    c.end_query(GL_SAMPLES_PASSED);
    assert_eq!(c.get_error(), GL_NO_ERROR, "{:?}", c.messages());
    c.make_current()
}

/// Runs a call a few times, within a list too.
fn try_case(case: &Case, slots: &[Slot; SLOTS], random: &Random, counts: Counts, rounds: usize) {
    NAME.set(case.name);
    for round in 0..rounds {
        // A list copies what a uniform takes at most: which one it is for is not known yet.
        let is_uniform = counts != Counts::Honest && case.name.starts_with("glUniform");
        let in_list = round % 4 == 3 && !is_uniform;
        if in_list {
            with_current(|c| c.new_list(1, GL_COMPILE));
        }
        (case.run)(slots, random, counts);
        with_current(|c| {
            c.end();
            if in_list {
                c.end_list();
            }
            while c.get_error() != GL_NO_ERROR {}
            c.messages();
        });
    }
}

fn guarded() -> [Slot; SLOTS] {
    // SAFETY: the handler calls what handlers may call.
    unsafe { signal(11, names_the_call as *const () as usize) };
    std::array::from_fn(|_| Slot::new())
}

#[test]
fn no_call_passes_the_end_of_what_the_specification_gives_it() {
    let slots = guarded();
    let random = Random(Cell::new(1));
    let cases = cases();
    assert!(cases.len() > 1100, "{}", cases.len());
    for case in &cases {
        let current = context();
        try_case(case, &slots, &random, Counts::Honest, 32);
        drop(current);
    }
}

#[test]
fn no_call_touches_memory_by_a_count_that_it_refuses() {
    let slots = guarded();
    let random = Random(Cell::new(2));
    let mut tried = 0;
    for case in cases().iter().filter(|case| !is_unlimited(case.name)) {
        let current = context();
        for &at in &case.counts {
            try_case(case, &slots, &random, Counts::Hostile(at), 24);
            tried += 1;
        }
        drop(current);
    }
    assert!(tried > 250, "{tried} counts");
}
