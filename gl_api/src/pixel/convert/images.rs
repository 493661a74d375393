//! Whole images, from the client's memory, into it, and from format to format.

use super::{Conversion, FinalConversion};
use crate::base::error::Result;
use crate::pixel::client::format::LuminanceOf;
use crate::pixel::layout::Layout;
use crate::pixel::scratch::scratch;
use crate::pixel::transfer::Transfer;
use texunit::format::Format;
use texunit::image::Level;
use texunit::lanes::Isa;

/// The client's pixels as texels of `format`, tightly packed into `texels`. `bytes` has
/// `layout.needed` bytes.
pub(crate) fn unpack(
    isa: Isa,
    layout: &Layout,
    bytes: &[u8],
    format: Format,
    transfer: &Transfer,
    texels: &mut [u8],
) {
    if layout.needed == 0 {
        return;
    }
    let conversion = Conversion::unpack(isa, layout, format, transfer);
    if let Some(same) = conversion.copied(layout, bytes) {
        texels.copy_from_slice(same);
        return;
    }
    let run = layout.size[0] * format.bytes();
    for (at, out) in layout.rows().zip(texels.chunks_exact_mut(run)) {
        conversion.unpack_row(layout, &bytes[at..], out);
    }
}

/// The client's pixels themselves, where they are texels of `format`, tightly packed; never those
/// of a compressed format.
pub(crate) fn as_texels<'a>(
    isa: Isa,
    layout: &Layout,
    bytes: &'a [u8],
    format: Format,
    transfer: &Transfer,
) -> Option<&'a [u8]> {
    match format.block() {
        Some(_) => None,
        None => Conversion::unpack(isa, layout, format, transfer).copied(layout, bytes),
    }
}

/// Rows of texels of `format`, each with as many as the layout's rows have pixels, into the
/// client's memory, which has `layout.needed` bytes.
pub(crate) fn pack(
    isa: Isa,
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
    let last = FinalConversion::of(format, luminance);
    pack_rows(isa, layout, format, transfer, last, rows, bytes);
}

/// Rows of texels of `format`, each with as many as the layout's rows have pixels, to where each is
/// to begin in the client's memory.
pub(crate) fn pack_rows(
    isa: Isa,
    layout: &Layout,
    format: Format,
    transfer: &Transfer,
    last: FinalConversion,
    rows: impl Iterator<Item = (usize, impl AsRef<[u8]>)>,
    bytes: &mut [u8],
) {
    let conversion = Conversion::pack(isa, layout, format, transfer, last);
    for (at, row) in rows {
        conversion.pack_row(layout, row.as_ref(), &mut bytes[at..]);
    }
}

/// Texels of one format as texels of another.
///
/// # Errors
/// If there is no memory for them.
pub(crate) fn transcode(
    isa: Isa,
    from: Format,
    texels: &[u8],
    to: Format,
    transfer: &Transfer,
) -> Result<Vec<u8>> {
    let mut out = scratch(to, [texels.len() / from.bytes(), 1, 1])?;
    Conversion::between(isa, from, to, transfer).run(texels, &mut out);
    Ok(out)
}

/// The stencils of texels of one format as those of another.
///
/// # Errors
/// If there is no memory for them.
pub(crate) fn transcode_stencils(
    isa: Isa,
    from: Format,
    texels: &[u8],
    to: Format,
    transfer: &Transfer,
) -> Result<Vec<u8>> {
    let mut out = scratch(to, [texels.len() / from.bytes(), 1, 1])?;
    Conversion::between_stencils(isa, from, to, transfer).run(texels, &mut out);
    Ok(out)
}

/// The texels of a level, border included, without the padding.
pub(crate) fn texels(level: &Level) -> &[u8] {
    &level.texels[..level.texels.len() - texunit::image::PADDING]
}
