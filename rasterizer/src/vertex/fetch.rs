//! Attributes from memory to lanes.

use crate::desc::{VertexFormat, VertexSource, VertexType};
use texunit::format::small_float::{decode_half, decode_unsigned};
use texunit::lanes::{F32s, Isa, Kernel, LANES, Simd, U32s};

/// Which elements are read, at most 64.
#[derive(Clone, Copy)]
pub struct Elements<'a> {
    ids: &'a [u32],
    furthest: u32,
}

impl<'a> Elements<'a> {
    /// The elements with these numbers.
    pub fn new(ids: &'a [u32]) -> Self {
        debug_assert!(ids.len() <= LANES);
        Self { ids, furthest: ids.iter().copied().max().unwrap_or(0) }
    }

    /// Relative to this first element; elements before it get numbers beyond any buffer.
    fn counted_from(self, first: u32, memory: &'a mut [u32; LANES]) -> Self {
        if first == 0 {
            return self;
        }
        for (id, from) in memory.iter_mut().zip(self.ids) {
            *id = from.wrapping_sub(first);
        }
        Elements::new(&memory[..self.ids.len().min(LANES)])
    }
}

impl VertexSource {
    /// A component of the attribute, 0 to 3, for each of at most 64 elements.
    pub fn component(&self, isa: Isa, component: u8, elements: &[u32], out: &mut F32s) {
        self::component(isa, self, component, Elements::new(elements), out);
    }

    /// The attribute of one vertex of the first instance.
    pub fn read(&self, vertex: u32) -> [f32; 4] {
        let mut lanes = F32s::ZERO;
        [0, 1, 2, 3].map(|component| {
            self::component(Isa::BASELINE, self, component, Elements::new(&[vertex]), &mut lanes);
            lanes[0]
        })
    }
}

/// Component `component` of an attribute for each of some elements.
pub fn component(
    isa: Isa,
    source: &VertexSource,
    component: u8,
    elements: Elements<'_>,
    out: &mut F32s,
) {
    use VertexFormat::{Integer, Normalized, NormalizedBgra, NormalizedSymmetric, Plain};
    match source {
        VertexSource::Constant(value) => *out = F32s::splat(value[usize::from(component)]),
        VertexSource::Array { components, format, .. } if component >= *components => {
            let one = match format {
                Plain | Normalized | NormalizedBgra | NormalizedSymmetric => 1.0,
                Integer => bits(1),
            };
            *out = F32s::splat(if component == 3 { one } else { 0.0 });
        }
        VertexSource::Array { buffer, first, offset, stride, ty, format, .. } => {
            let mut memory = [0; LANES];
            let elements = elements.counted_from(*first, &mut memory);
            let component = match format {
                NormalizedBgra => [2, 1, 0, 3][usize::from(component)],
                Plain | Normalized | NormalizedSymmetric | Integer => component,
            };
            let start = offset.saturating_add(usize::from(component) * ty.size());
            let words = Words { bytes: buffer.bytes(), start, stride: *stride, elements };
            match (ty, format) {
                (VertexType::F32, _) => words.floats(isa, out),
                (VertexType::F16, _) => {
                    words.each(out, |b| decode_half(u16::from_le_bytes(b).into()));
                }
                (VertexType::Fixed, _) => {
                    words.each(out, |b| i32::from_le_bytes(b) as f32 / 65536.0);
                }
                (VertexType::F64, _) => words.each(out, |b| f64::from_le_bytes(b) as f32),
                (VertexType::I8, Plain) => {
                    words.each(out, |b| f32::from(i8::from_le_bytes(b)));
                }
                (VertexType::U8, Plain) => words.each(out, |[b]| f32::from(b)),
                (VertexType::I16, Plain) => {
                    words.each(out, |b| f32::from(i16::from_le_bytes(b)));
                }
                (VertexType::U16, Plain) => {
                    words.each(out, |b| f32::from(u16::from_le_bytes(b)));
                }
                (VertexType::I32, Plain) => {
                    words.each(out, |b| i32::from_le_bytes(b) as f32);
                }
                (VertexType::U32, Plain) => {
                    words.each(out, |b| u32::from_le_bytes(b) as f32);
                }
                (VertexType::I8, Integer) => {
                    words.each(out, |b| bits(i8::from_le_bytes(b).into()));
                }
                (VertexType::U8, Integer) => words.each(out, |[b]| bits(b.into())),
                (VertexType::I16, Integer) => {
                    words.each(out, |b| bits(i16::from_le_bytes(b).into()));
                }
                (VertexType::U16, Integer) => {
                    words.each(out, |b| bits(u16::from_le_bytes(b).into()));
                }
                (VertexType::I32 | VertexType::U32, Integer) => {
                    words.each(out, f32::from_le_bytes);
                }
                // GL 2.1, table 2.9, in f64 so that the quotient is rounded once.
                (VertexType::I8, Normalized | NormalizedBgra) => {
                    words.each(out, |b| signed(i8::from_le_bytes(b).into(), 255.0));
                }
                (VertexType::U8, Normalized | NormalizedBgra | NormalizedSymmetric) => {
                    words.each(out, |[b]| f32::from(b) / 255.0);
                }
                (VertexType::I16, Normalized | NormalizedBgra) => {
                    words.each(out, |b| signed(i16::from_le_bytes(b).into(), 65535.0));
                }
                (VertexType::U16, Normalized | NormalizedBgra | NormalizedSymmetric) => {
                    words.each(out, |b| f32::from(u16::from_le_bytes(b)) / 65535.0);
                }
                (VertexType::I32, Normalized | NormalizedBgra) => {
                    words.each(out, |b| signed(i32::from_le_bytes(b).into(), 4_294_967_295.0));
                }
                (VertexType::U32, Normalized | NormalizedBgra | NormalizedSymmetric) => {
                    let largest = f64::from(u32::MAX);
                    words.each(out, |b| (f64::from(u32::from_le_bytes(b)) / largest) as f32);
                }
                (VertexType::I8, NormalizedSymmetric) => {
                    words.each(out, |b| symmetric(i8::from_le_bytes(b).into(), 127.0));
                }
                (VertexType::I16, NormalizedSymmetric) => {
                    words.each(out, |b| symmetric(i16::from_le_bytes(b).into(), 32767.0));
                }
                (VertexType::I32, NormalizedSymmetric) => {
                    words.each(out, |b| symmetric(i32::from_le_bytes(b).into(), 2_147_483_647.0));
                }
                (VertexType::I1010102, NormalizedSymmetric) => {
                    let field = Field::new(component);
                    let largest = f64::from((1 << (field.bits - 1)) - 1);
                    let signed = |b| field.signed(u32::from_le_bytes(b));
                    words.each(out, |b| symmetric(signed(b).into(), largest));
                }
                (VertexType::I1010102, _) => {
                    let field = Field::new(component);
                    let signed = |b| field.signed(u32::from_le_bytes(b));
                    words.each(out, |b| field.convert(signed(b).into(), *format, self::signed));
                }
                (VertexType::U1010102, _) => {
                    let field = Field::new(component);
                    let unsigned = |b| field.unsigned(u32::from_le_bytes(b));
                    let fraction = |c: f64, largest: f64| (c / largest) as f32;
                    words.each(out, |b| field.convert(unsigned(b).into(), *format, fraction));
                }
                (VertexType::F111110, _) => {
                    let (at, mantissa) = [(0, 6), (11, 6), (22, 5)][usize::from(component.min(2))];
                    let float = |b| u32::from_le_bytes(b) >> at & ((32 << mantissa) - 1);
                    words.each(out, |b| decode_unsigned(float(b), mantissa));
                }
            }
        }
    }
}

/// The bits of an integer as an `f32`, the type of attribute lanes.
fn bits(c: i32) -> f32 {
    f32::from_bits(c as u32)
}

/// `(2c + 1) / (2^b - 1)`.
fn signed(c: f64, largest: f64) -> f32 {
    ((2.0 * c + 1.0) / largest) as f32
}

/// `max(c / (2^(b-1) - 1), -1)`.
fn symmetric(c: f64, largest: f64) -> f32 {
    (c / largest).max(-1.0) as f32
}

/// A component of four in a word.
#[derive(Clone, Copy)]
struct Field {
    /// Its lowest bit.
    at: u32,
    bits: u32,
}

impl Field {
    fn new(component: u8) -> Self {
        Self { at: 10 * u32::from(component), bits: if component == 3 { 2 } else { 10 } }
    }

    fn unsigned(self, word: u32) -> u32 {
        word >> self.at & ((1 << self.bits) - 1)
    }

    fn signed(self, word: u32) -> i32 {
        (word << (32 - self.at - self.bits)) as i32 >> (32 - self.bits)
    }

    /// The component as a format has it; `fraction` takes it and the largest number of its bits.
    fn convert(self, c: f64, format: VertexFormat, fraction: impl Fn(f64, f64) -> f32) -> f32 {
        match format {
            VertexFormat::Plain => c as f32,
            VertexFormat::Normalized
            | VertexFormat::NormalizedBgra
            | VertexFormat::NormalizedSymmetric => fraction(c, f64::from((1 << self.bits) - 1)),
            VertexFormat::Integer => bits(c as i32),
        }
    }
}

/// One component of a strided array.
struct Words<'a> {
    bytes: &'a [u8],
    start: usize,
    stride: usize,
    elements: Elements<'a>,
}

impl Words<'_> {
    /// Reads floats: a gather if all 64 are inside the buffer.
    fn floats(&self, isa: Isa, out: &mut F32s) {
        let ids = <&[u32; LANES]>::try_from(self.elements.ids);
        match (ids, u32::try_from(self.start), self.end::<4>()) {
            (Ok(ids), Ok(start), Some(end)) if end <= i32::MAX as usize => {
                let (bytes, stride) = (&self.bytes[..end], self.stride as u32);
                isa.run(Gather { bytes, start, stride, ids, out });
            }
            _ => self.each(out, f32::from_le_bytes),
        }
    }

    /// One past the last byte of all `N`-byte words; `None` if some are outside the buffer.
    fn end<const N: usize>(&self) -> Option<usize> {
        let furthest = self.elements.furthest as usize;
        let last = furthest.checked_mul(self.stride)?.checked_add(self.start)?;
        last.checked_add(N).filter(|&end| end <= self.bytes.len())
    }

    /// Reads `N` bytes a vertex; bytes past the end of the buffer read as zeros.
    fn each<const N: usize>(&self, out: &mut F32s, convert: impl Fn([u8; N]) -> f32) {
        // One bounds check for all: the furthest element is inside.
        if let Some(end) = self.end::<N>() {
            let bytes = &self.bytes[..end];
            for (value, &id) in out.0.iter_mut().zip(self.elements.ids) {
                let at = id as usize * self.stride + self.start;
                *value = convert(*bytes[at..].first_chunk().unwrap_or(&[0; N]));
            }
            return;
        }
        for (value, &id) in out.0.iter_mut().zip(self.elements.ids) {
            let word = (id as usize)
                .checked_mul(self.stride)
                .and_then(|at| at.checked_add(self.start))
                .and_then(|at| self.bytes.get(at..)?.first_chunk::<N>())
                .copied()
                .unwrap_or([0; N]);
            *value = convert(word);
        }
    }
}

/// A word of each of 64 vertices; all are inside `bytes`.
struct Gather<'a> {
    bytes: &'a [u8],
    start: u32,
    stride: u32,
    ids: &'a [u32; LANES],
    out: &'a mut F32s,
}

impl Kernel for Gather<'_> {
    type Output = ();
    #[inline(always)]
    fn run<S: Simd>(self) {
        let mut offsets = U32s::ZERO;
        for lane in 0..LANES {
            offsets[lane] = self.ids[lane].wrapping_mul(self.stride).wrapping_add(self.start);
        }
        *self.out = *S::gather(self.bytes, &offsets).as_f32();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::desc::Buffer;

    #[test]
    fn components_convert_as_table_2_9_says() {
        let cases: &[(VertexType, VertexFormat, &[u8], f32)] = &[
            (VertexType::U8, VertexFormat::Plain, &[255], 255.0),
            (VertexType::U8, VertexFormat::Normalized, &[255], 1.0),
            (VertexType::U8, VertexFormat::Normalized, &[51], 0.2),
            (VertexType::I8, VertexFormat::Normalized, &[127], 1.0),
            (VertexType::I8, VertexFormat::Normalized, &[128], -1.0),
            (VertexType::I8, VertexFormat::NormalizedSymmetric, &[128], -1.0),
            (VertexType::I8, VertexFormat::NormalizedSymmetric, &[0], 0.0),
            (VertexType::I16, VertexFormat::Plain, &[0, 128], -32768.0),
            (VertexType::I16, VertexFormat::NormalizedSymmetric, &[0xFF, 0x7F], 1.0),
            (VertexType::I32, VertexFormat::NormalizedSymmetric, &[0, 0, 0, 128], -1.0),
            (VertexType::U16, VertexFormat::NormalizedSymmetric, &[255, 255], 1.0),
            (VertexType::U16, VertexFormat::Normalized, &[255, 255], 1.0),
            (VertexType::U32, VertexFormat::Normalized, &[255; 4], 1.0),
            (VertexType::I32, VertexFormat::Plain, &[254, 255, 255, 255], -2.0),
            (VertexType::F32, VertexFormat::Plain, &[0, 0, 128, 63], 1.0),
            (VertexType::F16, VertexFormat::Plain, &[0, 0xC1], -2.5),
            (VertexType::F16, VertexFormat::Normalized, &[0xFF, 0x7B], 65504.0),
            (VertexType::F64, VertexFormat::Plain, &[0, 0, 0, 0, 0, 0, 0xE0, 0x3F], 0.5),
            (VertexType::Fixed, VertexFormat::Plain, &[0, 0xC0, 0xFE, 0xFF], -1.25),
            (VertexType::Fixed, VertexFormat::Normalized, &[0, 0, 3, 0], 3.0),
            (VertexType::I1010102, VertexFormat::Plain, &[0, 2, 0, 0x40], -512.0),
            (VertexType::I1010102, VertexFormat::Normalized, &[0xFF, 1, 0, 0x40], 1.0),
            (VertexType::I1010102, VertexFormat::NormalizedSymmetric, &[0, 2, 0, 0], -1.0),
            (VertexType::I1010102, VertexFormat::NormalizedSymmetric, &[0xFF, 1, 0, 0], 1.0),
            (VertexType::U1010102, VertexFormat::Plain, &[0xFF, 3, 0, 0x40], 1023.0),
            (VertexType::U1010102, VertexFormat::NormalizedBgra, &[0, 0, 0xF0, 0x7F], 1.0),
            // 2.5 is 2 · (1 + 16/64), in 11 bits of exponent 16 and mantissa 16.
            (VertexType::F111110, VertexFormat::Plain, &[0x10, 4, 0, 0], 2.5),
            (VertexType::F111110, VertexFormat::Normalized, &[0xBF, 0xFF, 0xFF, 0xFF], 65024.0),
            // Too short for its type: zero bytes.
            (VertexType::F32, VertexFormat::Plain, &[0, 0, 128], 0.0),
        ];
        for (ty, format, bytes, want) in cases {
            let source = VertexSource::Array {
                buffer: Buffer::new(bytes.to_vec()),
                first: 0,
                offset: 0,
                stride: 16,
                ty: *ty,
                components: 1,
                format: *format,
                divisor: 0,
            };
            let mut out = F32s::ZERO;
            component(Isa::best(), &source, 0, Elements::new(&[0, 1, u32::MAX]), &mut out);
            assert_eq!(out[0], *want, "{ty:?} {format:?}");
            component(Isa::best(), &source, 3, Elements::new(&[0]), &mut out);
            assert_eq!(out[0], 1.0);
        }
    }

    /// A source that begins with a later element is the whole array, of which what comes before reads as zeros.
    #[test]
    fn an_array_may_begin_with_a_later_element() {
        let ids: [u32; LANES] = std::array::from_fn(|lane| lane as u32 + 5);
        let words: Vec<u8> = ids.iter().flat_map(|&id| (id as f32).to_le_bytes()).collect();
        let source = VertexSource::Array {
            buffer: Buffer::new(words),
            first: 5,
            offset: 0,
            stride: 4,
            ty: VertexType::F32,
            components: 1,
            format: VertexFormat::Plain,
            divisor: 0,
        };
        assert_eq!(source.end(), (LANES + 5) * 4);
        let mut out = F32s::ZERO;
        for isa in Isa::available() {
            component(isa, &source, 0, Elements::new(&ids), &mut out);
            assert_eq!(out, F32s::from_fn(|lane| ids[lane] as f32));
            component(isa, &source, 0, Elements::new(&[0, 4, 5, 68, 69]), &mut out);
            assert_eq!(out.0[..5], [0.0, 0.0, 5.0, 68.0, 0.0]);
        }
    }
}
