//! `gluScaleImage`, and images where the client's pixel store has them.

use super::error::{GLU_INVALID_ENUM, GLU_INVALID_OPERATION, GLU_INVALID_VALUE, GLU_OUT_OF_MEMORY};
use super::pixels;
use super::pixels::{Layout, Meaning, Storage, Store};
use super::scale::scale;
use crate::base::args::{Data, DataOut, Located, LocatedOut};
use crate::base::constants::*;
use crate::base::memory::copied;
use crate::base::types::{GLenum, GLint, GLsizei};
use crate::entry::{Arg, glGetIntegerv, glPixelStorei};
use crate::pixel::layout::ByteOrder;
use texunit::lanes::FloatEnv;

/// Scales an image in client memory with GLU's box filter, from the `GL_UNPACK_*` state's layout
/// to the `GL_PACK_*` state's.
///
/// Gives 0 or a GLU error code, as [`super::gluBuild2DMipmaps`]; then `data_out` is as it was.
#[expect(clippy::too_many_arguments, reason = "GLU's signature")]
pub fn gluScaleImage<'a>(
    format: impl Arg<GLenum>,
    width_in: impl Arg<GLsizei>,
    height_in: impl Arg<GLsizei>,
    type_in: impl Arg<GLenum>,
    data_in: impl Arg<Data<'a>>,
    width_out: impl Arg<GLsizei>,
    height_out: impl Arg<GLsizei>,
    type_out: impl Arg<GLenum>,
    data_out: impl Arg<DataOut<'a>>,
) -> GLenum {
    let _float_env = FloatEnv::enter();
    let format = format.arg();
    let flat = |store| Store { image_height: 0, skip_images: 0, ..store };
    let unpack = flat(Store::current(&UNPACK));
    let pack = flat(Store::current(&PACK));
    let from = layout([width_in.arg(), height_in.arg(), 1], format, type_in.arg(), unpack);
    let to = layout([width_out.arg(), height_out.arg(), 1], format, type_out.arg(), pack);
    let result = from.and_then(|from| {
        let to = to?;
        // A copy: C may want the new image where the old one is.
        let given = copied(bytes(data_in.arg(), &from)).map_err(|_| GLU_OUT_OF_MEMORY)?;
        let LocatedOut::Bytes(out) = data_out.arg().locate(0, to.needed()) else {
            return Err(GLU_INVALID_VALUE);
        };
        scale(Meaning::of(format), (&from, &given), (&to, out)).map_err(|_| GLU_INVALID_VALUE)
    });
    result.err().unwrap_or(0)
}

/// The client's memory; GLU knows no buffer objects.
pub(super) fn bytes<'a>(data: Data<'a>, layout: &Layout) -> &'a [u8] {
    match data.locate(0, layout.needed()) {
        Located::Bytes(bytes) => bytes,
        Located::Offset(_) | Located::Null => &[],
    }
}

/// An image of this size, format and type in client memory.
///
/// # Errors
/// GLU's error code, as `gluBuild2DMipmaps` gives it.
pub(super) fn layout(
    size: [GLsizei; 3],
    format: GLenum,
    type_: GLenum,
    store: Store,
) -> Result<Layout, GLenum> {
    if size.iter().any(|side| *side < 1) {
        return Err(GLU_INVALID_VALUE);
    }
    let count = pixels::components(format).ok_or(GLU_INVALID_ENUM)?;
    let storage = Storage::of(type_).ok_or(GLU_INVALID_ENUM)?;
    if !storage.holds(count) {
        return Err(GLU_INVALID_OPERATION);
    }
    let size = size.map(|side| side as usize);
    let numbers = size.iter().try_fold(count, |product, &side| product.checked_mul(side));
    if numbers.is_none_or(|numbers| numbers > MOST_NUMBERS) {
        return Err(GLU_OUT_OF_MEMORY);
    }
    Ok(Layout { size, count, storage, store })
}

/// How many components an image may have that is scaled: 1 GiB as `f32`.
const MOST_NUMBERS: usize = 1 << 28;

/// The names of half of the `glPixelStore` state.
pub(super) struct Names {
    alignment: GLenum,
    row_length: GLenum,
    skip_rows: GLenum,
    skip_pixels: GLenum,
    image_height: GLenum,
    skip_images: GLenum,
    swap_bytes: GLenum,
}

pub(super) const UNPACK: Names = Names {
    alignment: GL_UNPACK_ALIGNMENT,
    row_length: GL_UNPACK_ROW_LENGTH,
    skip_rows: GL_UNPACK_SKIP_ROWS,
    skip_pixels: GL_UNPACK_SKIP_PIXELS,
    image_height: GL_UNPACK_IMAGE_HEIGHT,
    skip_images: GL_UNPACK_SKIP_IMAGES,
    swap_bytes: GL_UNPACK_SWAP_BYTES,
};

const PACK: Names = Names {
    alignment: GL_PACK_ALIGNMENT,
    row_length: GL_PACK_ROW_LENGTH,
    skip_rows: GL_PACK_SKIP_ROWS,
    skip_pixels: GL_PACK_SKIP_PIXELS,
    image_height: GL_PACK_IMAGE_HEIGHT,
    skip_images: GL_PACK_SKIP_IMAGES,
    swap_bytes: GL_PACK_SWAP_BYTES,
};

/// A piece of state that is never negative; 0 without a context.
pub(super) fn get(name: GLenum) -> usize {
    let mut value: GLint = 0;
    glGetIntegerv(name, &mut value);
    usize::try_from(value).unwrap_or(0)
}

impl Store {
    pub(super) fn current(names: &Names) -> Self {
        Self {
            alignment: get(names.alignment).max(1),
            row_length: get(names.row_length),
            skip_rows: get(names.skip_rows),
            skip_pixels: get(names.skip_pixels),
            image_height: get(names.image_height),
            skip_images: get(names.skip_images),
            order: match get(names.swap_bytes) {
                0 => ByteOrder::Native,
                _ => ByteOrder::Swapped,
            },
        }
    }

    pub(super) fn make_current(self, names: &Names) {
        glPixelStorei(names.alignment, self.alignment as GLint);
        glPixelStorei(names.row_length, self.row_length as GLint);
        glPixelStorei(names.skip_rows, self.skip_rows as GLint);
        glPixelStorei(names.skip_pixels, self.skip_pixels as GLint);
        glPixelStorei(names.image_height, self.image_height as GLint);
        glPixelStorei(names.skip_images, self.skip_images as GLint);
        glPixelStorei(names.swap_bytes, GLint::from(self.order == ByteOrder::Swapped));
    }
}

#[cfg(test)]
mod tests {
    use super::super::pixels::{TIGHT, TooShort};
    use super::*;

    #[test]
    fn sizes_formats_and_types_are_checked() {
        for (width, format, type_, expected) in [
            (0, GL_RGB, GL_UNSIGNED_BYTE, GLU_INVALID_VALUE),
            (-1, GL_RGB, GL_UNSIGNED_BYTE, GLU_INVALID_VALUE),
            (2, GL_TEXTURE_2D, GL_UNSIGNED_BYTE, GLU_INVALID_ENUM),
            (2, GL_RGB, GL_TEXTURE_2D, GLU_INVALID_ENUM),
            (2, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4, GLU_INVALID_OPERATION),
        ] {
            assert_eq!(layout([width, 1, 1], format, type_, TIGHT).err(), Some(expected));
        }
        for format in [GL_COLOR_INDEX, GL_STENCIL_INDEX, GL_DEPTH_COMPONENT] {
            assert_eq!(layout([2, 1, 1], format, GL_UNSIGNED_BYTE, TIGHT).map(|l| l.count), Ok(1));
        }
        let huge = layout([i32::MAX, i32::MAX, 1], GL_RGBA, GL_FLOAT, TIGHT);
        assert_eq!(huge.err(), Some(GLU_OUT_OF_MEMORY));
        let huge = layout([8000, 8000, 1], GL_RGBA, GL_FLOAT, TIGHT).unwrap();
        assert_eq!(huge.check(&[0; 5]), Err(TooShort { needed: huge.needed() }));
    }

    #[test]
    fn indices_are_the_same_numbers_in_every_type() {
        let from = Layout::tight([4, 1, 1], 1, Storage::U8);
        let to = Layout::tight([2, 1, 1], 1, Storage::U16);
        for (format, expected) in [(GL_COLOR_INDEX, [2_u16, 7]), (GL_RED, [514, 1799])] {
            let mut out = [0; 4];
            let given = (&from, &[1, 3, 6, 8][..]);
            assert_eq!(scale(Meaning::of(format), given, (&to, &mut out)), Ok(()));
            let pairs = [[out[0], out[1]], [out[2], out[3]]].map(u16::from_ne_bytes);
            assert_eq!(pairs, expected);
        }
    }
}
