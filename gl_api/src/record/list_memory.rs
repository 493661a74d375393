//! The client's memory that a list copies when it is compiled: pixels, from memory or a buffer, and names of lists.

use crate::base::args::{Data, Located};
use crate::base::begin_end::BeginEnd;
use crate::context::Context;
use crate::context::lists::RecordedCall;
use crate::pixel::client::Pixel;
use crate::pixel::layout::{Extent, Layout};
use crate::record::lists::NAME_TYPE;

/// The integers of a call, by position.
type Integers<'a> = &'a [i64];
/// Bytes that a call reads, by its integers; `None` where they make no sense.
type Needed = fn(&Context, Integers<'_>) -> Option<usize>;

/// The calls that read the memory their last argument points to, and how much of it.
const READERS: &[(&str, Needed)] = &[
    ("glBitmap", |c, a| bits(c, [a[0], a[1]])),
    ("glCallLists", |_, a| size(a[0])?.checked_mul(NAME_TYPE.get(a[1] as u32)?.size())),
    ("glCompressedTexImage1D", |_, a| size(a[5])),
    ("glCompressedTexImage2D", |_, a| size(a[6])),
    ("glCompressedTexImage3D", |_, a| size(a[7])),
    ("glCompressedTexSubImage1D", |_, a| size(a[5])),
    ("glCompressedTexSubImage2D", |_, a| size(a[7])),
    ("glCompressedTexSubImage3D", |_, a| size(a[9])),
    ("glDrawPixels", |c, a| image(c, [a[0], a[1], 1], [a[2], a[3]], Extent::Flat)),
    ("glPixelMapfv", |_, a| size(a[1])?.checked_mul(4)),
    ("glPixelMapuiv", |_, a| size(a[1])?.checked_mul(4)),
    ("glPixelMapusv", |_, a| size(a[1])?.checked_mul(2)),
    ("glPolygonStipple", |c, _| bits(c, [32, 32])),
    ("glTexImage1D", |c, a| image(c, [a[3], 1, 1], [a[5], a[6]], Extent::Flat)),
    ("glTexImage2D", |c, a| image(c, [a[3], a[4], 1], [a[6], a[7]], Extent::Flat)),
    ("glTexImage3D", |c, a| image(c, [a[3], a[4], a[5]], [a[7], a[8]], Extent::Volume)),
    ("glTexSubImage1D", |c, a| image(c, [a[3], 1, 1], [a[4], a[5]], Extent::Flat)),
    ("glTexSubImage2D", |c, a| image(c, [a[4], a[5], 1], [a[6], a[7]], Extent::Flat)),
    ("glTexSubImage3D", |c, a| image(c, [a[5], a[6], a[7]], [a[8], a[9]], Extent::Volume)),
];

fn reader(name: &str) -> Option<Needed> {
    READERS.iter().find(|row| row.0 == name).map(|row| row.1)
}

impl Context {
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
pub(crate) fn bytes(
    context: &Context,
    name: &str,
    integers: Integers<'_>,
    data: Data<'_>,
) -> Option<Vec<u8>> {
    let needed = reader(name)?(context, integers)?;
    if name == "glCallLists" {
        return match data.locate(0, needed) {
            Located::Bytes(bytes) => bytes.get(..needed).map(<[u8]>::to_vec),
            Located::Offset(_) | Located::Null => None,
        };
    }
    let source = crate::calls::pixels::memory::source(context, data, needed).ok()??;
    source.bytes().get(..needed).map(<[u8]>::to_vec)
}

fn size(value: i64) -> Option<usize> {
    usize::try_from(value).ok()
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
