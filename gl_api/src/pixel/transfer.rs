//! Pixel transfer, which applies to every pixel that is read or written: scale and bias, the maps of
//! [`crate::pixel::map`], and the shift and offset of indices (GL 2.1, sections 3.6.3 and 3.6.5).

use crate::base::constants::*;
use crate::base::error::Table;
use crate::pixel::client::format::Numbers;
use crate::pixel::map::{PixelMap, PixelMaps};
use texunit::lanes::{F64s, Isa};
use texunit::pixel;
use texunit::pixel::NumberTransform;

/// A number times a scale, plus a bias.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Linear {
    pub scale: f32,
    pub bias: f32,
}

impl Linear {
    const IDENTITY: Self = Self { scale: 1.0, bias: 0.0 };

    fn change(self) -> NumberTransform {
        NumberTransform::Linear { scale: self.scale.into(), bias: self.bias.into() }
    }
}

/// The state of `glPixelTransfer` and `glPixelMap`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Transfer {
    /// Red, green, blue, alpha, depth.
    pub linear: [Linear; 5],
    /// Whether colours are looked up.
    pub map_color: bool,
    /// Whether stencils are looked up.
    pub map_stencil: bool,
    /// To the left; negative to the right.
    pub index_shift: i32,
    pub index_offset: i32,
    pub maps: PixelMaps,
}

impl Default for Transfer {
    fn default() -> Self {
        Self {
            linear: [Linear::IDENTITY; 5],
            map_color: false,
            map_stencil: false,
            index_shift: 0,
            index_offset: 0,
            maps: PixelMaps::default(),
        }
    }
}

/// The kinds of pixels to which different steps of pixel transfer apply.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TransferKind {
    Color,
    /// Indices of colours, as R.
    ColorIndex,
    /// Depths, as R.
    Depth,
    /// Depths as R, stencils beside them as G.
    DepthStencil,
    /// Stencils, as R.
    Stencil,
}

impl Transfer {
    /// The steps for pixels of this kind. Integers are not changed (`EXT_texture_integer`).
    pub fn of(&self, kind: TransferKind, numbers: Numbers) -> Steps<'_> {
        let [r, g, b, a, depth] = self.linear;
        let beside = if self.moves_indices() { Index::Stencil(1, self) } else { Index::None };
        let same = Linear::IDENTITY;
        match (kind, numbers) {
            (
                TransferKind::Color | TransferKind::Depth | TransferKind::DepthStencil,
                Numbers::Integer,
            ) => Steps::IDENTITY,
            (TransferKind::Color, Numbers::Fixed | Numbers::SignedNormalized) => Steps {
                linear: [r, g, b, a],
                colors: self.map_color.then(|| self.maps.colors()),
                index: Index::None,
            },
            (
                TransferKind::Depth | TransferKind::DepthStencil,
                Numbers::Fixed | Numbers::SignedNormalized,
            ) => Steps { linear: [depth, same, same, same], colors: None, index: beside },
            // Their colours come from the maps, behind the steps of colours (figure 3.7).
            (TransferKind::ColorIndex, _) => Steps { index: Index::Color(self), ..Steps::IDENTITY },
            // Of an index the bits count that a buffer has.
            (TransferKind::Stencil, _) => {
                Steps { index: Index::Stencil(0, self), ..Steps::IDENTITY }
            }
        }
    }

    /// Whether anything is done to stencils.
    fn moves_indices(&self) -> bool {
        self.index_shift != 0 || self.index_offset != 0 || self.map_stencil
    }

    /// An index shifted and offset (GL 2.1, section 3.6.5).
    fn index(&self, index: f64) -> i64 {
        let index = index.floor() as i64;
        let shifted = match self.index_shift {
            shift @ 0.. => index.checked_shl(shift as u32).unwrap_or(0),
            shift => index.checked_shr(shift.unsigned_abs()).unwrap_or(0),
        };
        shifted.wrapping_add(self.index_offset.into())
    }

    /// A stencil shifted, offset and looked up, of which the bits count that a buffer has.
    fn stencil(&self, index: f64) -> f64 {
        let moved = self.index(index);
        let looked_up =
            if self.map_stencil { self.maps.stencil().at_index(moved) as i64 } else { moved };
        (looked_up & 0xFF) as f64
    }
}

/// The steps of pixel transfer for one kind of pixels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Steps<'a> {
    linear: [Linear; 4],
    /// The tables of R, G, B, A.
    colors: Option<[&'a PixelMap; 4]>,
    index: Index<'a>,
}

/// What an index is mapped to.
#[derive(Clone, Copy, Debug)]
enum Index<'a> {
    /// There is none, or it stays.
    None,
    /// A colour.
    Color(&'a Transfer),
    /// Another stencil, in this component.
    Stencil(usize, &'a Transfer),
}

impl Steps<'_> {
    pub const IDENTITY: Self =
        Self { linear: [Linear::IDENTITY; 4], colors: None, index: Index::None };

    /// Whether pixels are not changed.
    pub fn is_identity(&self) -> bool {
        self.linear.iter().all(|&linear| linear == Linear::IDENTITY)
            && self.colors.is_none()
            && matches!(self.index, Index::None)
    }

    /// The same for stencils that are bytes: where nothing else is done to one, all of its bits count.
    pub fn of_byte_stencils(self) -> Self {
        match self.index {
            Index::Stencil(_, transfer) if !transfer.moves_indices() => {
                Self { index: Index::None, ..self }
            }
            Index::None | Index::Color(_) | Index::Stencil(..) => self,
        }
    }

    /// Scales, biases and looks up R, G, B, A of 64 pixels.
    pub fn apply(&self, isa: Isa, rgba: [&F64s; 4], out: &mut [F64s; 4]) {
        for ((linear, from), out) in self.linear.iter().zip(rgba).zip(&mut *out) {
            pixel::transform(isa, linear.change(), from, out);
        }
        for (map, values) in self.colors.iter().flatten().zip(&mut *out) {
            values.0.iter_mut().for_each(|value| *value = map.at_fraction(*value).into());
        }
        match self.index {
            Index::None => {}
            Index::Color(transfer) => {
                let maps = transfer.maps.of_indices();
                for (lane, &index) in rgba[0].0.iter().enumerate() {
                    let index = transfer.index(index);
                    for (map, values) in maps.iter().zip(&mut *out) {
                        values[lane] = map.at_index(index).into();
                    }
                }
            }
            Index::Stencil(at, transfer) => {
                out[at].0.iter_mut().for_each(|value| *value = transfer.stencil(*value));
            }
        }
    }
}

/// A parameter of `glPixelTransfer`; scale and bias by component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Parameter {
    Scale(u8),
    Bias(u8),
    MapColor,
    MapStencil,
    IndexShift,
    IndexOffset,
}

/// What `glPixelTransfer` takes.
pub(crate) const PARAMETER: Table<Parameter> = Table {
    section: "GL 2.1, table 3.2",
    rows: &[
        (GL_RED_SCALE, Parameter::Scale(0)),
        (GL_GREEN_SCALE, Parameter::Scale(1)),
        (GL_BLUE_SCALE, Parameter::Scale(2)),
        (GL_ALPHA_SCALE, Parameter::Scale(3)),
        (GL_DEPTH_SCALE, Parameter::Scale(4)),
        (GL_RED_BIAS, Parameter::Bias(0)),
        (GL_GREEN_BIAS, Parameter::Bias(1)),
        (GL_BLUE_BIAS, Parameter::Bias(2)),
        (GL_ALPHA_BIAS, Parameter::Bias(3)),
        (GL_DEPTH_BIAS, Parameter::Bias(4)),
        (GL_MAP_COLOR, Parameter::MapColor),
        (GL_MAP_STENCIL, Parameter::MapStencil),
        (GL_INDEX_SHIFT, Parameter::IndexShift),
        (GL_INDEX_OFFSET, Parameter::IndexOffset),
    ],
};
