//! The client's memory that a list copies when it is compiled: pixels, from memory or a buffer, and names of lists.

use crate::base::args::{Data, Located};
use crate::base::begin_end::BeginEnd;
use crate::base::error::{ErrorCode, GlError};
use crate::base::limits::{MAX_3D_TEXTURE_SIZE, MAX_TEXTURE_SIZE};
use crate::base::memory::copied;
use crate::context::Context;
use crate::context::lists::RecordedCall;
use crate::pixel::client::Pixel;
use crate::pixel::layout::{Extent, Layout};
use crate::pixel::map::MAX_PIXEL_MAP_TABLE;
use crate::record::lists::NAME_TYPE;
use std::collections::TryReserveError;

/// The integers of a call, by position.
type Integers<'a> = &'a [i64];
/// Bytes that a call reads, by its integers; `None` where it refuses them: then nothing is read.
type Needed = fn(&Context, Integers<'_>) -> Option<usize>;

/// The calls whose last argument is a pointer to memory that they read, and the length of that memory.
const VOID_POINTER_LENGTHS: &[(&str, Needed)] = &[
    ("glBitmap", |c, a| bits(c, [a[0], a[1]])),
    ("glCallLists", |_, a| size(a[0])?.checked_mul(NAME_TYPE.get(a[1] as u32)?.size())),
    ("glCompressedTexImage1D", |_, a| blocks([a[3], 1, 1], a[5])),
    ("glCompressedTexImage2D", |_, a| blocks([a[3], a[4], 1], a[6])),
    ("glCompressedTexImage3D", |_, a| blocks([a[3], a[4], a[5]], a[7])),
    ("glCompressedTexSubImage1D", |_, a| blocks([a[3], 1, 1], a[5])),
    ("glCompressedTexSubImage2D", |_, a| blocks([a[4], a[5], 1], a[7])),
    ("glCompressedTexSubImage3D", |_, a| blocks([a[5], a[6], a[7]], a[9])),
    ("glDrawPixels", |c, a| image(c, [a[0], a[1], 1], [a[2], a[3]], Extent::Flat)),
    ("glPixelMapfv", |_, a| map(a[1], 4)),
    ("glPixelMapuiv", |_, a| map(a[1], 4)),
    ("glPixelMapusv", |_, a| map(a[1], 2)),
    ("glPolygonStipple", |c, _| bits(c, [32, 32])),
    ("glTexImage1D", |c, a| texture(c, [a[3], 1, 1], [a[5], a[6]], Extent::Flat)),
    ("glTexImage2D", |c, a| texture(c, [a[3], a[4], 1], [a[6], a[7]], Extent::Flat)),
    ("glTexImage3D", |c, a| texture(c, [a[3], a[4], a[5]], [a[7], a[8]], Extent::Volume)),
    ("glTexSubImage1D", |c, a| texture(c, [a[3], 1, 1], [a[4], a[5]], Extent::Flat)),
    ("glTexSubImage2D", |c, a| texture(c, [a[4], a[5], 1], [a[6], a[7]], Extent::Flat)),
    ("glTexSubImage3D", |c, a| texture(c, [a[5], a[6], a[7]], [a[8], a[9]], Extent::Volume)),
];

fn reader(name: &str) -> Option<Needed> {
    VOID_POINTER_LENGTHS.iter().find(|row| row.0 == name).map(|row| row.1)
}

impl Context {
    /// Refuses a call whose arguments cannot be copied.
    #[cold]
    #[inline(never)]
    pub(crate) fn has_no_memory_to_record(&mut self, name: &'static str) {
        let rule =
            "there is no memory for a copy of what the call reads, which the display list keeps";
        self.refuse(name, GlError::new(ErrorCode::OutOfMemory, "GL 2.1, section 5.4", rule));
    }

    /// Records a call of the table of entry points.
    pub(crate) fn record(&mut self, name: &'static str, begin_end: BeginEnd, run: RecordedCall) {
        let unpack = reads_pixels(name).then(|| Box::new(self.state.unpack.clone()));
        self.record_call(name, begin_end, unpack, run);
    }
}

/// Whether a call reads by the unpack state.
fn reads_pixels(name: &str) -> bool {
    name != "glCallLists" && reader(name).is_some()
}

/// What a call reads, copied; `None` where it reads nothing, or more than there is: then the call
/// says so when the list is called.
///
/// # Errors
/// If there is no memory for the copy.
pub(crate) fn bytes(
    context: &Context,
    name: &str,
    integers: Integers<'_>,
    data: Data<'_>,
) -> Result<Option<Vec<u8>>, TryReserveError> {
    let Some(needed) = reader(name).and_then(|needed| needed(context, integers)) else {
        return Ok(None);
    };
    if name == "glCallLists" {
        return match data.locate(0, needed) {
            Located::Bytes(bytes) => bytes.get(..needed).map(copied).transpose(),
            Located::Offset(_) | Located::Null => Ok(None),
        };
    }
    match crate::calls::pixels::memory::source(context, data, needed) {
        Ok(Some(source)) => source.bytes().get(..needed).map(copied).transpose(),
        Ok(None) | Err(_) => Ok(None),
    }
}

fn size(value: i64) -> Option<usize> {
    usize::try_from(value).ok()
}

/// Whether no texture has an image of this size, in any dimension, with a border.
fn is_too_large(size: [i64; 3]) -> bool {
    size.iter().any(|&side| side > i64::from(MAX_TEXTURE_SIZE.max(MAX_3D_TEXTURE_SIZE)) + 2)
}

/// Bytes of a texture's image.
fn texture(context: &Context, size: [i64; 3], format: [i64; 2], extent: Extent) -> Option<usize> {
    if is_too_large(size) { None } else { image(context, size, format, extent) }
}

/// Bytes of compressed blocks: at most 16 for 4×4 texels of each slice.
fn blocks(sides: [i64; 3], bytes: i64) -> Option<usize> {
    let [width, height, depth] = sides;
    let most = (width + 3) / 4 * ((height + 3) / 4) * depth * 16;
    if is_too_large(sides) || bytes > most { None } else { size(bytes) }
}

/// Bytes of a pixel map.
fn map(entries: i64, bytes: usize) -> Option<usize> {
    let entries = size(entries).filter(|entries| *entries <= MAX_PIXEL_MAP_TABLE)?;
    Some(entries * bytes)
}

fn image(
    context: &Context,
    size: [i64; 3],
    [format, ty]: [i64; 2],
    extent: Extent,
) -> Option<usize> {
    let pixel = Pixel::new(format as u32, ty as u32).ok()?;
    let [width, height, depth] = size.map(|side| usize::try_from(side).ok());
    let layout = Layout::new(&context.state.unpack, pixel, [width?, height?, depth?], extent);
    layout.ok().map(|layout| layout.needed)
}

/// Bytes of a bitmap (GL 2.1, section 3.7).
fn bits(context: &Context, [width, height]: [i64; 2]) -> Option<usize> {
    let size = [size(width)?, size(height)?, 1];
    let layout = Layout::new(&context.state.unpack, Pixel::BIT, size, Extent::Flat);
    layout.ok().map(|layout| layout.needed)
}
