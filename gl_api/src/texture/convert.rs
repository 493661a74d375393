//! Pixels in the client's memory to stored texels and back.
//!
//! The general path takes each pixel through `f64`: elements → components → R, G, B, A → transfer →
//! channels → texel. Where client and texel have the same elements, in whatever order, [`Shuffle`]
//! copies them instead; which goes where it finds out by sending marked numbers down the general
//! path.

use super::client::{ClientFormat, ClientType, LuminanceOf, Numbers};
use super::layout::{ByteOrder, Layout};
use super::texel::{self, Bytes};
use super::transfer::{Kind, Steps, Transfer};
use crate::state::clamp::Clamp;
use texunit::format::{Encoding, Format};
use texunit::image::Level;

/// The last steps on the way to the client (GL 2.1, section 4.3.2, final conversion).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Final {
    pub luminance: LuminanceOf,
    /// Whether components are clamped to [0, 1], whatever the client's numbers can hold.
    pub clamp: Clamp,
}

impl Final {
    /// The steps for texels of a format: fractions stay fractions.
    pub fn of(format: Format, luminance: LuminanceOf) -> Self {
        let is_fraction = format.info().encoding.range() == Some(Encoding::UNIT);
        let clamp = if is_fraction && !format.has_stencil() { Clamp::On } else { Clamp::Off };
        Self { luminance, clamp }
    }

    #[inline]
    fn clamped(self, components: [f64; 4]) -> [f64; 4] {
        match self.clamp {
            Clamp::On => components.map(|c| c.clamp(0.0, 1.0)),
            Clamp::Off => components,
        }
    }
}

/// What both directions know of a conversion.
struct Conversion<'a> {
    layout: &'a Layout,
    format: Format,
    numbers: Numbers,
    last: Final,
    steps: Steps<'a>,
}

impl<'a> Conversion<'a> {
    fn new(layout: &'a Layout, format: Format, transfer: &'a Transfer, last: Final) -> Self {
        let numbers = texel::numbers(format, layout.pixel.numbers);
        let kind = layout.pixel.format.kind();
        let steps = transfer.of(kind, numbers);
        Self { layout, format, numbers, last, steps }
    }

    /// A pixel of the client's as a texel.
    #[inline]
    fn unpack(&self, pixel: &[u8]) -> Bytes {
        let (ty, size) = (self.layout.pixel.ty, self.layout.pixel.ty.size());
        let mut words = [0; 4];
        for (word, element) in words.iter_mut().zip(pixel.chunks_exact(size)) {
            *word = load(element, self.layout.order);
        }
        let components = ty.read(words, self.layout.pixel.elements(self.numbers));
        let rgba = self.layout.pixel.format.expand(components);
        texel::encode(self.format, self.steps.apply(rgba))
    }

    /// A texel as a pixel of the client's.
    #[inline]
    fn pack(&self, texel: &[u8], pixel: &mut [u8]) {
        let (ty, size) = (self.layout.pixel.ty, self.layout.pixel.ty.size());
        let rgba = self.steps.apply(texel::decode(self.format, texel));
        let components = self.layout.pixel.format.select(rgba, self.last.luminance);
        let mut components = self.last.clamped(components);
        // A byte with a sign takes the lower seven bits of a stencil (GL 2.1, section 4.3.2).
        if (self.layout.pixel.format, ty) == (ClientFormat::Stencil, ClientType::I8) {
            components[0] = (components[0] as u8 & 0x7F).into();
        }
        let words = ty.write(components, self.numbers);
        for (word, element) in words.into_iter().zip(pixel.chunks_exact_mut(size)) {
            store(word, element, self.layout.order);
        }
    }

    fn unpack_row(&self, row: &[u8], texels: &mut [u8]) {
        let (pixel, texel) = (self.layout.pixel.bytes(), self.format.bytes());
        if let Some(bits) = self.layout.bits {
            for (column, out) in texels.chunks_exact_mut(texel).enumerate() {
                out.copy_from_slice(&self.unpack(&[bits.at(row, column)])[..texel]);
            }
            return;
        }
        for (pixel, out) in row.chunks_exact(pixel).zip(texels.chunks_exact_mut(texel)) {
            out.copy_from_slice(&self.unpack(pixel)[..texel]);
        }
    }

    fn pack_row(&self, texels: &[u8], row: &mut [u8]) {
        let (pixel, texel) = (self.layout.pixel.bytes(), self.format.bytes());
        if let Some(bits) = self.layout.bits {
            for (column, texel) in texels.chunks_exact(texel).enumerate() {
                let mut index = [0];
                self.pack(texel, &mut index);
                bits.put(row, column, index[0]);
            }
            return;
        }
        for (texel, out) in texels.chunks_exact(texel).zip(row.chunks_exact_mut(pixel)) {
            self.pack(texel, out);
        }
    }

    /// The elements of the client's pixel, if a texel has the same, and where each component's is.
    fn elements(&self) -> Option<(usize, [usize; 4])> {
        let ty = self.layout.pixel.ty;
        let plain = (ty.size(), [0, 1, 2, 3]);
        let is_native = cfg!(target_endian = "little") && self.layout.order == ByteOrder::Native;
        let info = self.format.info();
        let bits = info.fields[0].bits;
        // Channels one after the other, as `FormatInfo::uniform` has them.
        let is_uniform = bits as usize * self.format.channels() == 8 * info.bytes
            && info.fields[..self.format.channels()].iter().all(|field| field.bits == bits)
            && !self.format.is_depth();
        let same = match (info.encoding, ty, bits) {
            (Encoding::Unorm | Encoding::Srgb, ClientType::U8, 8) => Some(plain),
            (Encoding::Unorm | Encoding::Srgb, ClientType::Packed(packed), 8)
                if packed.bits == [8; 4] =>
            {
                // Where the first component is at the top, it comes last in memory.
                let is_top = packed.field(0).0 != 0;
                let is_last = is_top == is_native;
                Some((1, if is_last { [3, 2, 1, 0] } else { [0, 1, 2, 3] }))
            }
            (Encoding::Unorm, ClientType::U16, 16) | (Encoding::Float, ClientType::F32, 32)
                if is_native =>
            {
                Some(plain)
            }
            (_, _, _) => None,
        };
        let same = same.filter(|_| is_uniform);
        same.filter(|_| self.steps.is_identity() && self.numbers != Numbers::Integer)
    }

    fn unpack_shuffle(&self) -> Option<Shuffle> {
        let (size, places) = self.elements()?;
        let rgba = self.layout.pixel.format.expand(MARKS);
        let channels = texel::channels(self.format.base(), rgba);
        let count = self.format.channels();
        let one = self.layout.pixel.ty.write([1.0; 4], self.numbers)[0];
        let from = self.layout.pixel.format.components();
        Shuffle::new(size, from, &channels[..count], one, |component| places[component])
    }

    fn pack_shuffle(&self) -> Option<Shuffle> {
        // A copy clamps nothing.
        if self.last.clamp == Clamp::On && self.format.info().encoding == Encoding::Float {
            return None;
        }
        let (size, places) = self.elements()?;
        let rgba = texel::rgba(self.format.base(), MARKS);
        let components = self.layout.pixel.format.select(rgba, self.last.luminance);
        let count = self.layout.pixel.format.components();
        let mut placed = [0.0; 4];
        for (component, value) in components.into_iter().enumerate().take(count) {
            placed[places[component]] = value;
        }
        let one = self.layout.pixel.ty.write([1.0; 4], self.numbers)[0];
        Shuffle::new(size, self.format.channels(), &placed[..count], one, |channel| channel)
    }
}

/// Numbers that a conversion without arithmetic hands on as they are, or not at all; no sum of
/// some of them is another.
const MARKS: [f64; 4] = [10.0, 100.0, 1_000.0, 10_000.0];

/// A copy of elements, or of the constants 0 and 1.
struct Shuffle {
    /// Bytes of an element.
    size: usize,
    /// Elements of what is read.
    from: usize,
    /// Of each element that is written: the element that is read, or else the constant.
    elements: Vec<Result<usize, u32>>,
}

impl Shuffle {
    /// `marks` are what came of [`MARKS`]; `place` says where the component is that had a mark.
    fn new(
        size: usize,
        from: usize,
        marks: &[f64],
        one: u32,
        place: impl Fn(usize) -> usize,
    ) -> Option<Self> {
        let one = if size == 1 { one & 0xFF } else { one };
        let element = |&mark: &f64| match MARKS.iter().position(|&other| other == mark) {
            Some(index) => Some(Ok(place(index))),
            None if mark == 0.0 => Some(Err(0)),
            None if mark == 1.0 => Some(Err(one)),
            None => None,
        };
        let elements = marks.iter().map(element).collect::<Option<_>>()?;
        Some(Self { size, from, elements })
    }

    fn is_copy(&self) -> bool {
        self.from == self.elements.len()
            && self.elements.iter().enumerate().all(|(at, from)| *from == Ok(at))
    }

    fn run(&self, from: &[u8], to: &mut [u8]) {
        if self.is_copy() {
            to.copy_from_slice(from);
            return;
        }
        match self.size {
            1 => self.run_sized::<1>(from, to),
            2 => self.run_sized::<2>(from, to),
            _ => self.run_sized::<4>(from, to),
        }
    }

    fn run_sized<const SIZE: usize>(&self, from: &[u8], to: &mut [u8]) {
        let count = self.elements.len();
        for (at, element) in self.elements.iter().enumerate() {
            let to = to.chunks_exact_mut(SIZE).skip(at).step_by(count);
            match element {
                Ok(place) => {
                    let from = from.chunks_exact(SIZE).skip(*place).step_by(self.from);
                    to.zip(from).for_each(|(to, from)| to.copy_from_slice(from));
                }
                Err(constant) => {
                    let bytes = constant.to_le_bytes();
                    to.for_each(|to| to.copy_from_slice(&bytes[..SIZE]));
                }
            }
        }
    }
}

/// An element of up to four bytes as a word.
#[inline]
fn load(element: &[u8], order: ByteOrder) -> u32 {
    let mut bytes = [0; 4];
    bytes[..element.len()].copy_from_slice(element);
    if order == ByteOrder::Swapped {
        bytes[..element.len()].reverse();
    }
    match (bytes, element.len()) {
        ([a, ..], 1) => a.into(),
        ([a, b, ..], 2) => u16::from_ne_bytes([a, b]).into(),
        (bytes, _) => u32::from_ne_bytes(bytes),
    }
}

/// The low bytes of a word as an element.
#[inline]
fn store(word: u32, element: &mut [u8], order: ByteOrder) {
    match element.len() {
        1 => element[0] = word as u8,
        2 => element.copy_from_slice(&(word as u16).to_ne_bytes()),
        _ => element.copy_from_slice(&word.to_ne_bytes()),
    }
    if order == ByteOrder::Swapped {
        element.reverse();
    }
}

/// The client's pixels as texels of `format`, tightly packed into `texels`. `bytes` has
/// `layout.needed` bytes.
pub(crate) fn unpack(
    layout: &Layout,
    bytes: &[u8],
    format: Format,
    transfer: &Transfer,
    texels: &mut [u8],
) {
    if layout.needed == 0 {
        return;
    }
    let last = Final::of(format, LuminanceOf::Red);
    let conversion = Conversion::new(layout, format, transfer, last);
    let shuffle = conversion.unpack_shuffle();
    let run = layout.size[0] * format.bytes();
    for (at, out) in layout.rows().zip(texels.chunks_exact_mut(run)) {
        let row = &bytes[at..at + layout.row_bytes()];
        match &shuffle {
            Some(shuffle) => shuffle.run(row, out),
            None => conversion.unpack_row(row, out),
        }
    }
}

/// The client's pixels themselves, where they are texels of `format`, tightly packed; never those
/// of a compressed format.
pub(crate) fn as_texels<'a>(
    layout: &Layout,
    bytes: &'a [u8],
    format: Format,
    transfer: &Transfer,
) -> Option<&'a [u8]> {
    let [_, height, depth] = layout.size;
    let run = layout.row_bytes();
    let is_tight = (height == 1 || layout.stride == run)
        && (depth == 1 || layout.image_stride == run * height);
    let last = Final::of(format, LuminanceOf::Red);
    let conversion = Conversion::new(layout, format, transfer, last);
    let is_copy = format.block().is_none()
        && layout.bits.is_none()
        && is_tight
        && conversion.unpack_shuffle().is_some_and(|shuffle| shuffle.is_copy());
    is_copy.then(|| &bytes[layout.start..layout.start + run * height * depth])
}

/// Rows of texels of `format`, each with as many as the layout's rows have pixels, into the
/// client's memory, which has `layout.needed` bytes.
pub(crate) fn pack(
    layout: &Layout,
    format: Format,
    transfer: &Transfer,
    luminance: LuminanceOf,
    texels: &[u8],
    bytes: &mut [u8],
) {
    if layout.needed == 0 {
        return;
    }
    let run = layout.size[0] * format.bytes();
    let rows = layout.rows().zip(texels.chunks_exact(run));
    pack_rows(layout, format, transfer, Final::of(format, luminance), rows, bytes);
}

/// Rows of texels of `format`, each with as many as the layout's rows have pixels, to where each is
/// to begin in the client's memory.
pub(crate) fn pack_rows<'a>(
    layout: &Layout,
    format: Format,
    transfer: &Transfer,
    last: Final,
    rows: impl Iterator<Item = (usize, &'a [u8])>,
    bytes: &mut [u8],
) {
    let conversion = Conversion::new(layout, format, transfer, last);
    let shuffle = conversion.pack_shuffle();
    for (at, row) in rows {
        let out = &mut bytes[at..at + layout.row_bytes()];
        match &shuffle {
            Some(shuffle) => shuffle.run(row, out),
            None => conversion.pack_row(row, out),
        }
    }
}

/// Texels of one format as texels of another, as a copy from a framebuffer makes them: luminance
/// and intensity take R (GL 2.1, table 3.15).
pub(crate) fn transcode(from: Format, texels: &[u8], to: Format, transfer: &Transfer) -> Vec<u8> {
    let kind = if from.is_depth() { Kind::Depth } else { Kind::Color };
    let steps = transfer.of(kind, crate::framebuffer::read::numbers_of(from));
    if from == to && steps.is_identity() {
        return texels.to_vec();
    }
    texels
        .chunks_exact(from.bytes())
        .flat_map(|texel| {
            let rgba = steps.apply(texel::decode(from, texel));
            texel::encode(to, rgba).into_iter().take(to.bytes())
        })
        .collect()
}

/// The texels of a level, border included, without the padding.
pub(crate) fn texels(level: &Level) -> &[u8] {
    &level.texels[..level.texels.len() - texunit::image::PADDING]
}

#[cfg(test)]
mod tests {
    use super::super::client::{FORMAT, Pixel, TYPE};
    use super::super::layout::Extent;
    use super::*;
    use crate::state::pixel_store::PixelStore;

    /// Every shuffle gives the bytes of the general path, both ways.
    #[test]
    fn shuffles_are_the_general_path_to_the_bit() {
        let noise: Vec<u8> =
            (0..7 * 16_u32).map(|i| (i.wrapping_mul(0x9E37_79B9) >> 24) as u8).collect();
        // Floats of which none is a signalling NaN.
        let floats: Vec<u8> = (0..28).flat_map(|i| (i as f32 / 7.0 - 1.5).to_ne_bytes()).collect();
        let mut found = 0;
        for (name, _) in FORMAT.rows {
            for (type_name, ty) in TYPE.rows {
                let Ok(pixel) = Pixel::new(*name, *type_name) else { continue };
                for swap_bytes in [false, true] {
                    let store = PixelStore { swap_bytes, alignment: 1, ..PixelStore::default() };
                    let layout = Layout::new(&store, pixel, [7, 1, 1], Extent::Flat).unwrap();
                    for format in Format::ALL {
                        let transfer = Transfer::default();
                        let last = Final::of(format, LuminanceOf::Sum);
                        let conversion = Conversion::new(&layout, format, &transfer, last);
                        let bytes = if *ty == ClientType::F32 { &floats } else { &noise };
                        if let Some(shuffle) = conversion.unpack_shuffle() {
                            let mut got = vec![9; 7 * format.bytes()];
                            let mut want = vec![8; 7 * format.bytes()];
                            shuffle.run(&bytes[..layout.needed], &mut got);
                            conversion.unpack_row(&bytes[..layout.needed], &mut want);
                            assert_eq!(got, want, "{pixel:?} {format:?}");
                            found += 1;
                        }
                        if let Some(shuffle) = conversion.pack_shuffle() {
                            let (mut got, mut want) =
                                (vec![9; layout.needed], vec![8; layout.needed]);
                            shuffle.run(&bytes[..7 * format.bytes()], &mut got);
                            conversion.pack_row(&bytes[..7 * format.bytes()], &mut want);
                            assert_eq!(got, want, "{pixel:?} {format:?}");
                            found += 1;
                        }
                    }
                }
            }
        }
        assert!(found > 200, "{found}");
    }
}
