//! Pixels in the client's memory to stored texels and back, and texels of one format to another.
//!
//! Pixels go 64 at a time through `f64`: the numbers of a record → R, G, B, A → transfer → the numbers of
//! another. Which goes where is decided once; where nothing is done to them and both records have the same
//! bits for the same numbers, those are moved ([`texunit::pixel`]).

mod images;
mod record;

pub(crate) use images::{
    as_texels, pack, pack_rows, texels, transcode, transcode_stencils, unpack,
};

use crate::base::clamp::Clamp;
use crate::pixel::client::element::ClientType;
use crate::pixel::client::format::{ClientFormat, LuminanceOf, Numbers};
use crate::pixel::layout::Layout;
use crate::pixel::texel;
use crate::pixel::transfer::{Steps, Transfer, TransferKind};
use rasterizer::driver::SrgbWrite;
use record::{Components, PixelRecord};
use texunit::format::{Encoding, Field, Format};
use texunit::lanes::{F64s, Isa, LANES};
use texunit::pixel;
use texunit::pixel::{BitMoves, NumberEncoding, NumberTransform, PixelLayout, Source};

/// The last steps on the way to the client (GL 2.1, section 4.3.2, final conversion).
#[derive(Clone, Copy, Debug)]
pub(crate) struct FinalConversion {
    pub luminance: LuminanceOf,
    /// Whether components are clamped to [0, 1], whatever the client's numbers can hold.
    pub clamp: Clamp,
}

impl FinalConversion {
    /// The steps for texels of a format: fractions stay fractions.
    pub fn of(format: Format, luminance: LuminanceOf) -> Self {
        let is_fraction = format.info().encoding.range() == Some(Encoding::UNIT);
        let clamp = if is_fraction && !format.has_stencil() { Clamp::On } else { Clamp::Off };
        Self { luminance, clamp }
    }
}

/// A conversion from one pixel layout to another.
pub(crate) struct Conversion<'a> {
    isa: Isa,
    from: PixelRecord,
    to: PixelRecord,
    steps: Steps<'a>,
    luminance: LuminanceOf,
    /// What is done to numbers last.
    final_transform: Option<NumberTransform>,
    /// Where nothing is done to numbers that have the same bits in both records.
    moves: Option<BitMoves>,
}

impl<'a> Conversion<'a> {
    fn new(
        isa: Isa,
        [from, to]: [PixelRecord; 2],
        steps: Steps<'a>,
        luminance: LuminanceOf,
        final_transform: Option<NumberTransform>,
    ) -> Self {
        let fields = from.layout.fields();
        let is_byte = |&(field, code): &(Field, NumberEncoding)| {
            code == NumberEncoding::Uint && field.bits <= 8
        };
        let steps = if fields.iter().all(is_byte) { steps.of_byte_stencils() } else { steps };
        let is_fraction = |&(_, code): &(Field, NumberEncoding)| match code {
            NumberEncoding::Unorm | NumberEncoding::Srgb | NumberEncoding::Depth => true,
            NumberEncoding::Fixed
            | NumberEncoding::Snorm
            | NumberEncoding::Uint
            | NumberEncoding::Sint
            | NumberEncoding::SnormSteps => false,
            NumberEncoding::Float | NumberEncoding::SharedExponent => false,
        };
        // What is within [0, 1] and stays there.
        let is_clamped =
            steps.is_identity() && !to.is_sum(luminance) && fields.iter().all(is_fraction);
        let final_transform =
            final_transform.filter(|&transform| transform != NumberTransform::Clamp || !is_clamped);
        let mut conversion = Self { isa, from, to, steps, luminance, final_transform, moves: None };
        conversion.moves = conversion.moves();
        conversion
    }

    /// To texels, which hold what their format can.
    fn to_texels(isa: Isa, from: PixelRecord, format: Format, steps: Steps<'a>) -> Self {
        Self::new(isa, [from, PixelRecord::texel(format)], steps, LuminanceOf::Red, None)
    }

    /// The client's pixels as texels.
    pub fn unpack(isa: Isa, layout: &Layout, format: Format, transfer: &'a Transfer) -> Self {
        let numbers = texel::numbers(format, layout.pixel.numbers);
        let steps = transfer.of(layout.pixel.format.kind(), numbers);
        let from = PixelRecord::client(layout, layout.pixel.elements(numbers));
        if layout.pixel.format == ClientFormat::Stencil && format.has_stencil() {
            let records = [from, PixelRecord::stencil(format)];
            return Self::new(isa, records, steps, LuminanceOf::Red, None);
        }
        Self::to_texels(isa, from, format, steps)
    }

    /// Texels as the client's pixels.
    pub fn pack(
        isa: Isa,
        layout: &Layout,
        format: Format,
        transfer: &'a Transfer,
        last: FinalConversion,
    ) -> Self {
        let pixel = layout.pixel;
        let numbers = texel::numbers(format, pixel.numbers);
        let steps = transfer.of(pixel.format.kind(), numbers);
        let from = match pixel.format.kind() {
            TransferKind::Stencil => PixelRecord::stencil(format),
            TransferKind::Color
            | TransferKind::ColorIndex
            | TransferKind::Depth
            | TransferKind::DepthStencil => PixelRecord::texel(format),
        };
        let records = [from, PixelRecord::client(layout, numbers)];
        let final_transform = match (pixel.format, pixel.ty, last.clamp) {
            // As a byte with a sign has them (GL 2.1, section 4.3.2).
            (ClientFormat::Stencil, ClientType::I8, _) => Some(NumberTransform::SevenBits),
            (_, _, Clamp::On) => Some(NumberTransform::Clamp),
            (_, _, Clamp::Off) => None,
        };
        Self::new(isa, records, steps, last.luminance, final_transform)
    }

    /// Texels of one format as texels of another, as a copy from a framebuffer makes them: luminance
    /// and intensity take R (GL 2.1, table 3.15).
    pub fn between(isa: Isa, from: Format, to: Format, transfer: &'a Transfer) -> Self {
        let kind = if from.is_depth() { TransferKind::Depth } else { TransferKind::Color };
        let steps = transfer.of(kind, texel::numbers_of(from));
        Self::to_texels(isa, PixelRecord::texel(from), to, steps)
    }

    /// Colours of one format as those of another, as a blit has them.
    pub fn blit(isa: Isa, from: Format, to: Format, srgb: SrgbWrite) -> Self {
        let records = [from, to].map(|format| PixelRecord::color(format, srgb));
        Self::new(isa, records, Steps::IDENTITY, LuminanceOf::Red, None)
    }

    /// The stencils of texels as bytes.
    pub fn stencils(isa: Isa, from: Format, transfer: &'a Transfer) -> Self {
        let steps = transfer.of(TransferKind::Stencil, Numbers::Integer);
        Self::to_texels(isa, PixelRecord::stencil(from), Format::R8UI, steps)
    }

    /// The stencils of texels of one format as those of another, whose depths are 0.
    fn between_stencils(isa: Isa, from: Format, to: Format, transfer: &'a Transfer) -> Self {
        let steps = transfer.of(TransferKind::Stencil, Numbers::Integer);
        let records = [from, to].map(PixelRecord::stencil);
        Self::new(isa, records, steps, LuminanceOf::Red, None)
    }

    /// Bytes as the stencils of texels, whose depths are 0.
    pub fn to_stencils(isa: Isa, to: Format) -> Self {
        let components = Components::Client(ClientFormat::Stencil);
        let records = [
            PixelRecord { components, layout: PixelLayout::of(Format::R8UI) },
            PixelRecord::stencil(to),
        ];
        Self::new(isa, records, Steps::IDENTITY, LuminanceOf::Red, None)
    }

    /// Where each number comes from, if nothing is done to any.
    fn moves(&self) -> Option<BitMoves> {
        if self.final_transform.is_some()
            || !self.steps.is_identity()
            || self.to.is_sum(self.luminance)
        {
            return None;
        }
        let fields = [0, 1, 2, 3].map(Source::Field);
        let rgba = self.from.components.rgba(fields, Source::Zero, Source::One);
        let sources = self.to.components.numbers(rgba, Source::Zero, rgba[0]);
        BitMoves::new(self.isa, &self.from.layout, &self.to.layout, sources)
    }

    /// The client's pixels themselves, where they are what they become, and tightly packed.
    fn copied<'b>(&self, layout: &Layout, bytes: &'b [u8]) -> Option<&'b [u8]> {
        let [_, height, depth] = layout.size;
        let run = layout.row_bytes();
        let is_tight = (height == 1 || layout.stride == run)
            && (depth == 1 || layout.image_stride == run * height);
        let same = || &bytes[layout.start..layout.start + run * height * depth];
        (is_tight && self.is_copy(layout)).then(same)
    }

    /// Whether the client's pixels are what they become, or come from.
    pub fn is_copy(&self, layout: &Layout) -> bool {
        layout.bits.is_none() && self.moves.as_ref().is_some_and(BitMoves::is_copy)
    }

    /// Whether numbers are moved as they are.
    pub fn is_moved(&self) -> bool {
        self.moves.is_some()
    }

    /// R, G, B and A of up to 64 pixels that lie one after the other.
    pub fn read(&self, from: &[u8]) -> [F64s; 4] {
        let mut numbers = [F64s::ZERO; 4];
        pixel::read(self.isa, &self.from.layout, from, &mut numbers);
        self.from.components.rgba(numbers, F64s::ZERO, F64s::splat(1.0))
    }

    /// Up to 64 pixels of these R, G, B and A.
    pub fn write(&self, rgba: &[F64s; 4], to: &mut [u8]) {
        let numbers = self.to.components.numbers(rgba.each_ref(), &F64s::ZERO, &rgba[0]);
        pixel::write(self.isa, &self.to.layout, numbers, to);
    }

    /// Converts pixels that lie one after the other: as many as `from` has.
    pub fn run(&self, from: &[u8], to: &mut [u8]) {
        match &self.moves {
            Some(moves) => {
                let (from_record, to_record) = (&self.from.layout, &self.to.layout);
                pixel::move_all(self.isa, moves, (from_record, from), (to_record, to));
            }
            None => self.compute(from, to),
        }
    }

    /// A row of the client's memory, from where it begins there, as texels.
    pub fn unpack_row(&self, layout: &Layout, row: &[u8], texels: &mut [u8]) {
        let row = &row[..layout.row_bytes()];
        match bits_as_bytes(layout, row) {
            Some(bytes) => self.run(&bytes, texels),
            None => self.run(row, texels),
        }
    }

    /// A row of texels into the client's memory from where it begins there.
    pub fn pack_row(&self, layout: &Layout, row: &[u8], out: &mut [u8]) {
        let out = &mut out[..layout.row_bytes()];
        let Some(bits) = layout.bits else { return self.run(row, out) };
        let mut indices = vec![0; layout.size[0]];
        self.run(row, &mut indices);
        indices.iter().enumerate().for_each(|(column, &index)| bits.put(out, column, index));
    }

    /// [`Conversion::run`] through `f64`.
    fn compute(&self, from: &[u8], to: &mut [u8]) {
        const ZEROS: &F64s = &F64s::ZERO;
        const ONES: &F64s = &F64s::splat(1.0);
        let [mut read, mut transferred, mut transformed] = [[F64s::ZERO; 4]; 3];
        let runs = from.chunks(LANES * self.from.layout.bytes());
        for (from, to) in runs.zip(to.chunks_mut(LANES * self.to.layout.bytes())) {
            pixel::read(self.isa, &self.from.layout, from, &mut read);
            let mut rgba = self.from.components.rgba(read.each_ref(), ZEROS, ONES);
            if !self.steps.is_identity() {
                self.steps.apply(self.isa, rgba, &mut transferred);
                rgba = transferred.each_ref();
            }
            let mut luminance = *rgba[0];
            if self.to.is_sum(self.luminance) {
                for numbers in &rgba[1..3] {
                    pixel::add(self.isa, 1.0, &numbers.0, &mut luminance.0);
                }
            }
            let numbers = self.to.components.numbers(rgba, ZEROS, &luminance);
            let Some(final_transform) = self.final_transform else {
                pixel::write(self.isa, &self.to.layout, numbers, to);
                continue;
            };
            for (numbers, out) in numbers.into_iter().zip(&mut transformed) {
                pixel::transform(self.isa, final_transform, numbers, out);
            }
            pixel::write(self.isa, &self.to.layout, transformed.each_ref(), to);
        }
    }
}

/// The bits of a row as bytes, one for each.
fn bits_as_bytes(layout: &Layout, row: &[u8]) -> Option<Vec<u8>> {
    let bits = layout.bits?;
    Some((0..layout.size[0]).map(|column| bits.at(row, column)).collect())
}

#[cfg(test)]
mod tests {
    use crate::pixel::client::Pixel;
    use crate::pixel::client::element::TYPE;
    use crate::pixel::client::format::FORMAT;
    use crate::pixel::convert::*;
    use crate::pixel::layout::Extent;
    use crate::pixel::store::PixelStore;

    /// What is moved is what goes through `f64`, both ways.
    #[test]
    fn moves_are_the_general_path_to_the_bit() {
        // Neither NaN nor the lowest signed number, which has another of its value.
        let noise: Vec<u8> =
            (0..7 * 16_u32).map(|i| (i.wrapping_mul(0x9E37_79B9) >> 24) as u8 % 0x78).collect();
        let (transfer, isa) = (Transfer::default(), Isa::best());
        let mut found = 0;
        let mut check = |conversion: &Conversion<'_>, from: usize, to: usize, what: &str| {
            // Noise is no depth, and not an exponent that was shared by the rule.
            let is_noise = |&(_, code): &(_, NumberEncoding)| {
                code != NumberEncoding::SharedExponent && code != NumberEncoding::Depth
            };
            if conversion.moves.is_some() && conversion.from.layout.fields().iter().all(is_noise) {
                let (mut got, mut want) = (vec![9; 7 * to], vec![8; 7 * to]);
                conversion.run(&noise[..7 * from], &mut got);
                conversion.compute(&noise[..7 * from], &mut want);
                assert_eq!(got, want, "{what}");
                found += 1;
            }
        };
        for format in Format::ALL.into_iter().filter(|format| format.block().is_none()) {
            for (name, _) in FORMAT.rows {
                for (type_name, ty) in TYPE.rows {
                    let Ok(pixel) = Pixel::new(*name, *type_name) else { continue };
                    if *ty == ClientType::Bit {
                        continue;
                    }
                    for swap_bytes in [false, true] {
                        let store =
                            PixelStore { swap_bytes, alignment: 1, ..PixelStore::default() };
                        let layout = Layout::new(&store, pixel, [7, 1, 1], Extent::Flat).unwrap();
                        let (size, what) = (pixel.bytes(), format!("{pixel:?} {format:?}"));
                        let unpack = Conversion::unpack(isa, &layout, format, &transfer);
                        check(&unpack, size, format.bytes(), &what);
                        let last = FinalConversion::of(format, LuminanceOf::Sum);
                        let pack = Conversion::pack(isa, &layout, format, &transfer, last);
                        check(&pack, format.bytes(), size, &what);
                    }
                }
            }
            for to in Format::ALL.into_iter().filter(|to| to.block().is_none()) {
                for srgb in [SrgbWrite::AsIs, SrgbWrite::Encode] {
                    let blit = Conversion::blit(isa, format, to, srgb);
                    check(&blit, format.bytes(), to.bytes(), &format!("{format:?} {to:?}"));
                }
            }
        }
        assert!(found > 2000, "{found}");
    }
}
