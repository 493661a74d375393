//! Pixels in client memory: `format` and `type`, and their valid combinations (GL 2.1, tables 3.5, 3.6 and 3.8).
//!
//! Every component is an `f64`, which holds each of GL's types exactly.

pub(crate) mod element;
pub(crate) mod format;

pub(crate) use crate::pixel::client::element::{ClientType, TYPE};
pub(crate) use crate::pixel::client::format::{ClientFormat, FORMAT, Numbers};

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum, invalid_operation};
use crate::base::types::*;
use crate::pixel::client::format::ClientFormat::{ColorIndex, DepthStencil, Rgb, Stencil};
use crate::pixel::client::format::Numbers::{Fixed, Integer};
use crate::pixel::es_texels::plain_type;

/// A valid combination of `format` and `type`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Pixel {
    pub format: ClientFormat,
    pub numbers: Numbers,
    pub ty: ClientType,
}

impl Pixel {
    /// The pixels of `glBitmap`.
    pub const BIT: Self = Self { format: ColorIndex, numbers: Fixed, ty: ClientType::Bit };

    /// The combination of a call's `format` and `type`.
    ///
    /// # Errors
    /// `GL_INVALID_ENUM` for unknown ones, for integers written as floats, and for bits that are no indices,
    /// `GL_INVALID_OPERATION` for packed types that hold another number of components
    /// (GL 2.1, table 3.8).
    pub fn new(format: GLenum, ty: GLenum) -> Result<Self> {
        let pixel = Self::decoded(format, ty)?;
        let refuse = |what: &str| {
            invalid_operation(
                "GL 2.1, table 3.8",
                format!("type = {} takes {what}, not {}", enum_name(ty), enum_name(format)),
            )
        };
        let (count, rgb) = (pixel.format.components(), pixel.format == Rgb);
        match pixel.ty {
            ClientType::Packed(packed) if packed.bits.len() == 3 && !rgb => refuse("GL_RGB"),
            ClientType::Packed(packed) if packed.bits.len() != count => {
                refuse("GL_RGBA or GL_BGRA")
            }
            ClientType::Rgb9E5 | ClientType::R11G11B10F if !rgb || pixel.numbers == Integer => {
                refuse("GL_RGB")
            }
            ClientType::Depth24Stencil8 | ClientType::Depth32FStencil8
                if pixel.format != DepthStencil =>
            {
                refuse("GL_DEPTH_STENCIL")
            }
            _ => Ok(pixel),
        }
    }

    /// The same in OpenGL ES, where a known format does not go with a known type by `GL_INVALID_OPERATION` (3.0,
    /// section 3.7.1.2).
    ///
    /// # Errors
    /// `GL_INVALID_ENUM` for unknown ones.
    pub fn new_in_es(format: GLenum, ty: GLenum) -> Result<Self> {
        let ty = plain_type(ty);
        // EXT_texture_type_2_10_10_10_REV has the type with GL_RGB, whose texels have no place for the fourth field.
        let packed = format == GL_RGB && ty == GL_UNSIGNED_INT_2_10_10_10_REV;
        let pixel = Self::new(if packed { GL_RGBA } else { format }, ty);
        if pixel.is_err() && FORMAT.get(format).is_some() && TYPE.get(ty).is_some() {
            let [format, ty] = [format, ty].map(enum_name);
            let rule = format!("format = {format} does not go with type = {ty}");
            return invalid_operation("OpenGL ES 3.0, table 3.2", rule);
        }
        pixel
    }

    fn decoded(format: GLenum, ty: GLenum) -> Result<Self> {
        let (name, ty_name) = (format, ty);
        let (format, numbers) = FORMAT.decode("format", name)?;
        let ty = TYPE.decode("type", ty_name)?;
        let refuse = |section, what: &str| {
            invalid_enum(
                section,
                format!("type = {} with {}: {what}", enum_name(ty_name), enum_name(name)),
            )
        };
        match (format, numbers, ty) {
            (Stencil | ColorIndex, _, ty) => Ok(Self { format, numbers, ty }),
            (_, _, ClientType::Bit) => {
                refuse("GL 2.1, section 3.6.4", "bits are GL_COLOR_INDEX or GL_STENCIL_INDEX")
            }
            (_, Integer, ty) if ty.is_float() => {
                refuse("EXT_texture_integer, section 3.6.4", "integers are not written as floats")
            }
            (DepthStencil, _, ClientType::Depth24Stencil8 | ClientType::Depth32FStencil8) => {
                Ok(Self { format, numbers, ty })
            }
            (DepthStencil, ..) => refuse(
                "EXT_packed_depth_stencil, section 3.6.4",
                "must be GL_UNSIGNED_INT_24_8 or GL_FLOAT_32_UNSIGNED_INT_24_8_REV",
            ),
            (_, _, ty) => Ok(Self { format, numbers, ty }),
        }
    }

    /// How its integers are interpreted, given how those of the texel are: colour indices are always integers.
    pub fn elements(self, stored: Numbers) -> Numbers {
        if self.format == ColorIndex { Integer } else { stored }
    }

    /// Bytes of a pixel; of a bit, those of the index that it is expanded to.
    pub fn bytes(self) -> usize {
        self.ty.size() * self.ty.elements(self.format.components())
    }
}
