//! How pixels lie in the client's memory: formats, types and rows (GL 2.1, sections 3.6.3, 3.6.4).

use crate::constants::*;
use crate::error::{Result, Table, invalid_operation};
use crate::state::pixel_store::PixelStore;
use crate::types::*;

/// The components of a pixel in memory (GL 2.1, table 3.6).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ClientFormat {
    Red,
    Green,
    Blue,
    Alpha,
    Rg,
    Rgb,
    Bgr,
    Rgba,
    Bgra,
    Luminance,
    LuminanceAlpha,
    Depth,
}

/// The formats that are implemented.
pub(crate) const FORMAT: Table<ClientFormat> = Table {
    section: "GL 2.1, table 3.6",
    rows: &[
        (GL_RED, ClientFormat::Red),
        (GL_GREEN, ClientFormat::Green),
        (GL_BLUE, ClientFormat::Blue),
        (GL_ALPHA, ClientFormat::Alpha),
        (GL_RG, ClientFormat::Rg),
        (GL_RGB, ClientFormat::Rgb),
        (GL_BGR, ClientFormat::Bgr),
        (GL_RGBA, ClientFormat::Rgba),
        (GL_BGRA, ClientFormat::Bgra),
        (GL_LUMINANCE, ClientFormat::Luminance),
        (GL_LUMINANCE_ALPHA, ClientFormat::LuminanceAlpha),
        (GL_DEPTH_COMPONENT, ClientFormat::Depth),
    ],
};

impl ClientFormat {
    /// Components of a pixel.
    pub fn components(self) -> usize {
        match self {
            Self::Red | Self::Green | Self::Blue | Self::Alpha | Self::Luminance | Self::Depth => 1,
            Self::Rg | Self::LuminanceAlpha => 2,
            Self::Rgb | Self::Bgr => 3,
            Self::Rgba | Self::Bgra => 4,
        }
    }

    /// The pixel as R, G, B, A; depth as R (GL 2.1, section 3.6.4, final expansion).
    #[inline]
    pub fn expand(self, [a, b, c, d]: [f64; 4]) -> [f64; 4] {
        match self {
            Self::Red | Self::Depth => [a, 0.0, 0.0, 1.0],
            Self::Green => [0.0, a, 0.0, 1.0],
            Self::Blue => [0.0, 0.0, a, 1.0],
            Self::Alpha => [0.0, 0.0, 0.0, a],
            Self::Rg => [a, b, 0.0, 1.0],
            Self::Rgb => [a, b, c, 1.0],
            Self::Bgr => [c, b, a, 1.0],
            Self::Rgba => [a, b, c, d],
            Self::Bgra => [c, b, a, d],
            Self::Luminance => [a, a, a, 1.0],
            Self::LuminanceAlpha => [a, a, a, b],
        }
    }

    /// The components of the pixel R, G, B, A (GL 2.1, section 4.3.2); luminance is R + G + B.
    #[inline]
    pub fn select(self, [r, g, b, a]: [f64; 4]) -> [f64; 4] {
        match self {
            Self::Red | Self::Depth => [r, 0.0, 0.0, 0.0],
            Self::Green => [g, 0.0, 0.0, 0.0],
            Self::Blue => [b, 0.0, 0.0, 0.0],
            Self::Alpha => [a, 0.0, 0.0, 0.0],
            Self::Rg => [r, g, 0.0, 0.0],
            Self::Rgb => [r, g, b, 0.0],
            Self::Bgr => [b, g, r, 0.0],
            Self::Rgba => [r, g, b, a],
            Self::Bgra => [b, g, r, a],
            Self::Luminance => [r + g + b, 0.0, 0.0, 0.0],
            Self::LuminanceAlpha => [r + g + b, a, 0.0, 0.0],
        }
    }
}

/// The type of a component in memory (GL 2.1, table 3.5).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ClientType {
    U8,
    I8,
    U16,
    I16,
    U32,
    I32,
    F32,
}

/// The types that are implemented.
pub(crate) const TYPE: Table<ClientType> = Table {
    section: "GL 2.1, table 3.5",
    rows: &[
        (GL_UNSIGNED_BYTE, ClientType::U8),
        (GL_BYTE, ClientType::I8),
        (GL_UNSIGNED_SHORT, ClientType::U16),
        (GL_SHORT, ClientType::I16),
        (GL_UNSIGNED_INT, ClientType::U32),
        (GL_INT, ClientType::I32),
        (GL_FLOAT, ClientType::F32),
    ],
};

/// The nearest of `0 ..= largest`; clamps, NaN gives 0.
fn unsigned(value: f64, largest: f64) -> f64 {
    (value.max(0.0).min(1.0) * largest).round_ties_even()
}

/// GL 2.1, table 4.9: `((2^b - 1) f - 1) / 2`, of a value clamped to [-1, 1].
fn signed(value: f64, largest: f64) -> f64 {
    ((value.max(-1.0).min(1.0) * largest - 1.0) / 2.0).round_ties_even()
}

impl ClientType {
    /// Bytes of a component.
    pub fn size(self) -> usize {
        match self {
            Self::U8 | Self::I8 => 1,
            Self::U16 | Self::I16 => 2,
            Self::U32 | Self::I32 | Self::F32 => 4,
        }
    }

    /// A component as a number (GL 2.1, table 2.9). `bytes` has [`ClientType::size`] bytes.
    #[inline]
    pub fn read(self, bytes: [u8; 4]) -> f64 {
        let [a, b, ..] = bytes;
        let word = u32::from_ne_bytes(bytes);
        match self {
            Self::U8 => f64::from(a) / 255.0,
            Self::I8 => (2.0 * f64::from(a as i8) + 1.0) / 255.0,
            Self::U16 => f64::from(u16::from_ne_bytes([a, b])) / 65_535.0,
            Self::I16 => (2.0 * f64::from(i16::from_ne_bytes([a, b])) + 1.0) / 65_535.0,
            Self::U32 => f64::from(word) / f64::from(u32::MAX),
            Self::I32 => (2.0 * f64::from(word as i32) + 1.0) / f64::from(u32::MAX),
            Self::F32 => f64::from(f32::from_bits(word)),
        }
    }

    /// A number as a component (GL 2.1, table 4.9), in the first [`ClientType::size`] bytes.
    #[inline]
    pub fn write(self, value: f64) -> [u8; 4] {
        let two = |[a, b]: [u8; 2]| [a, b, 0, 0];
        match self {
            Self::U8 => [unsigned(value, 255.0) as u8, 0, 0, 0],
            Self::I8 => [signed(value, 255.0) as i8 as u8, 0, 0, 0],
            Self::U16 => two((unsigned(value, 65_535.0) as u16).to_ne_bytes()),
            Self::I16 => two((signed(value, 65_535.0) as i16).to_ne_bytes()),
            Self::U32 => (unsigned(value, u32::MAX.into()) as u32).to_ne_bytes(),
            Self::I32 => (signed(value, u32::MAX.into()) as i32).to_ne_bytes(),
            Self::F32 => (value as f32).to_ne_bytes(),
        }
    }
}

/// Where a rectangle of pixels lies in the client's memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Layout {
    pub format: ClientFormat,
    pub ty: ClientType,
    pub width: usize,
    pub height: usize,
    /// Byte of the first pixel.
    pub start: usize,
    /// Bytes from a row to the next.
    pub stride: usize,
    /// Bytes that the memory must have.
    pub needed: usize,
    /// Whether the bytes of each component are reversed.
    pub swap: bool,
}

impl Layout {
    /// GL 2.1, section 3.6.4, equation 3.10.
    ///
    /// # Errors
    /// When it reaches beyond the address space.
    pub fn new(
        store: &PixelStore,
        format: ClientFormat,
        ty: ClientType,
        width: usize,
        height: usize,
    ) -> Result<Self> {
        let pixel = format.components() * ty.size();
        let per_row = if store.row_length > 0 { store.row_length } else { width };
        // At most 2^31 pixels of 16 bytes, times 2^31 rows: no overflow in 128 bits.
        let row = per_row as u128 * pixel as u128;
        let stride = if ty.size() >= store.alignment {
            row
        } else {
            row.next_multiple_of(store.alignment as u128)
        };
        let start = store.skip_rows as u128 * stride + store.skip_pixels as u128 * pixel as u128;
        let needed = if width == 0 || height == 0 {
            0
        } else {
            start + (height as u128 - 1) * stride + width as u128 * pixel as u128
        };
        let byte =
            |value: u128| usize::try_from(value).ok().filter(|&bytes| bytes <= isize::MAX as usize);
        match (byte(start), byte(stride), byte(needed)) {
            (Some(start), Some(stride), Some(needed)) => Ok(Self {
                format,
                ty,
                width,
                height,
                start,
                stride,
                needed,
                swap: store.swap_bytes && ty.size() > 1,
            }),
            _ => invalid_operation(
                "GL 2.1, section 3.6.4",
                format!(
                    "{width}×{height} pixels laid out so take {needed} bytes, more than there are"
                ),
            ),
        }
    }

    /// Bytes of a pixel.
    pub fn pixel_bytes(&self) -> usize {
        self.format.components() * self.ty.size()
    }

    /// Checks that the client's memory is long enough. `alignment` is the pixel store's parameter
    /// (`GL_UNPACK_ALIGNMENT`), named in the message where changing it would help.
    pub fn check_length(&self, has: usize, alignment: &str) -> Result<()> {
        if has >= self.needed {
            return Ok(());
        }
        let tight = self.width * self.pixel_bytes();
        let hint = if has >= tight * self.height && self.stride > tight && self.start == 0 {
            format!(
                "; its rows of {tight} bytes seem to be tightly packed: call \
                 glPixelStorei({alignment}, 1)"
            )
        } else {
            String::new()
        };
        invalid_operation(
            "GL 2.1, section 3.6.4",
            format!(
                "{}×{} pixels of {} bytes, rows {} bytes apart, take {} bytes; the slice has \
                 {has}{hint}",
                self.width,
                self.height,
                self.pixel_bytes(),
                self.stride,
                self.needed
            ),
        )
    }
}

/// Format and type of a call.
pub(crate) fn format_and_type(format: GLenum, ty: GLenum) -> Result<(ClientFormat, ClientType)> {
    Ok((FORMAT.decode("format", format)?, TYPE.decode("type", ty)?))
}
