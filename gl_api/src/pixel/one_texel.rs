//! One pixel of the client as a texel: what clears fill images and buffers with.

use crate::base::args::{Data, Located};
use crate::base::error::{Result, invalid_operation};
use crate::pixel::client::Pixel;
use crate::pixel::convert;
use crate::pixel::layout::{Extent, Layout};
use crate::pixel::store::PixelStore;
use crate::pixel::transfer::Transfer;
use texunit::format::Format;
use texunit::lanes::Isa;

/// The texel of `format`, zeros where `data` is null. The state of pixel stores and transfers does not count.
///
/// # Errors
/// When `data` is no memory, or less than a pixel.
pub(crate) fn one_texel(
    isa: Isa,
    section: &'static str,
    format: Format,
    pixel: Pixel,
    data: Data<'_>,
) -> Result<Vec<u8>> {
    let mut texel = vec![0; format.bytes()];
    let layout = Layout::new(&PixelStore::default(), pixel, [1; 3], Extent::Flat)?;
    match data.locate(0, layout.needed) {
        Located::Null => {}
        Located::Bytes(bytes) if bytes.len() >= layout.needed => {
            convert::unpack(isa, &layout, bytes, format, &Transfer::default(), &mut texel);
        }
        Located::Bytes(bytes) => {
            let (needed, has) = (layout.needed, bytes.len());
            return invalid_operation(section, format!("a pixel has {needed} bytes, data {has}"));
        }
        Located::Offset(_) => return invalid_operation(section, "data must be memory or NULL"),
    }
    Ok(texel)
}
