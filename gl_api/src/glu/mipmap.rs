//! `gluBuild1DMipmaps`, `gluBuild2DMipmaps` and `gluScaleImage`.

use super::error::{GLU_INVALID_ENUM, GLU_INVALID_OPERATION, GLU_INVALID_VALUE};
use super::pixels::{self, ByteOrder, Components, Layout, Storage, Store, TIGHT, TooShort};
use super::scale::scale;
use crate::constants::*;
use crate::entry::{Arg, Data, DataOut, Located, LocatedOut, glGetIntegerv, glPixelStorei, glTexImage1D, glTexImage2D};
use crate::types::{GLenum, GLint, GLsizei};

/// Builds every mipmap level of a texture from one image of any size: scales it to powers of two
/// (the nearest, as libGLU's `closestFit`) no larger than `GL_MAX_TEXTURE_SIZE`, hands that to
/// `glTexImage2D` as level 0, and halves it down to 1×1, each level from the one before it.
///
/// `data` is `width` by `height` pixels where the `GL_UNPACK_*` state says.
///
/// Gives 0, or a GLU error code: `GLU_INVALID_VALUE` for a size below 1 or a slice that is too
/// short (then `glTexImage2D` also says how many bytes were needed), `GLU_INVALID_ENUM` for a format or type GLU does not scale, `GLU_INVALID_OPERATION` for
/// a format and type that do not go together. Errors of `glTexImage2D` are GL's.
pub fn gluBuild2DMipmaps<'a>(
    target: impl Arg<GLenum>,
    internal_format: impl Arg<GLint>,
    width: impl Arg<GLsizei>,
    height: impl Arg<GLsizei>,
    format: impl Arg<GLenum>,
    type_: impl Arg<GLenum>,
    data: impl Arg<Data<'a>>,
) -> GLenum {
    let all = Numbers { level: 0, base: 0, max: GLint::MAX };
    let texture = Texture::D2(target.arg(), internal_format.arg());
    let size = (width.arg(), height.arg());
    build(texture, size, (format.arg(), type_.arg()), all, data.arg())
}

/// [`gluBuild2DMipmaps`] of which only the levels from `base` to `max` are handed to GL; `data` is
/// that of level `level`. `GLU_INVALID_VALUE` unless `0 <= level <= base <= max`.
#[expect(clippy::too_many_arguments, reason = "GLU's signature")]
pub fn gluBuild2DMipmapLevels<'a>(
    target: impl Arg<GLenum>,
    internal_format: impl Arg<GLint>,
    width: impl Arg<GLsizei>,
    height: impl Arg<GLsizei>,
    format: impl Arg<GLenum>,
    type_: impl Arg<GLenum>,
    level: impl Arg<GLint>,
    base: impl Arg<GLint>,
    max: impl Arg<GLint>,
    data: impl Arg<Data<'a>>,
) -> GLenum {
    let numbers = Numbers { level: level.arg(), base: base.arg(), max: max.arg() };
    let texture = Texture::D2(target.arg(), internal_format.arg());
    let size = (width.arg(), height.arg());
    build(texture, size, (format.arg(), type_.arg()), numbers, data.arg())
}

/// [`gluBuild2DMipmaps`] of a row, by `glTexImage1D`.
pub fn gluBuild1DMipmaps<'a>(
    target: impl Arg<GLenum>,
    internal_format: impl Arg<GLint>,
    width: impl Arg<GLsizei>,
    format: impl Arg<GLenum>,
    type_: impl Arg<GLenum>,
    data: impl Arg<Data<'a>>,
) -> GLenum {
    let all = Numbers { level: 0, base: 0, max: GLint::MAX };
    let texture = Texture::D1(target.arg(), internal_format.arg());
    build(texture, (width.arg(), 1), (format.arg(), type_.arg()), all, data.arg())
}

/// [`gluBuild2DMipmapLevels`] of a row, by `glTexImage1D`.
#[expect(clippy::too_many_arguments, reason = "GLU's signature")]
pub fn gluBuild1DMipmapLevels<'a>(
    target: impl Arg<GLenum>,
    internal_format: impl Arg<GLint>,
    width: impl Arg<GLsizei>,
    format: impl Arg<GLenum>,
    type_: impl Arg<GLenum>,
    level: impl Arg<GLint>,
    base: impl Arg<GLint>,
    max: impl Arg<GLint>,
    data: impl Arg<Data<'a>>,
) -> GLenum {
    let numbers = Numbers { level: level.arg(), base: base.arg(), max: max.arg() };
    let texture = Texture::D1(target.arg(), internal_format.arg());
    build(texture, (width.arg(), 1), (format.arg(), type_.arg()), numbers, data.arg())
}

/// The call that takes the levels: its target and internal format.
#[derive(Clone, Copy)]
enum Texture {
    D1(GLenum, GLint),
    D2(GLenum, GLint),
}

impl Texture {
    fn upload(
        self,
        level: GLint,
        (width, height): (GLsizei, GLsizei),
        (format, type_): (GLenum, GLenum),
        data: Data<'_>,
    ) {
        match self {
            Self::D1(target, internal) => {
                glTexImage1D(target, level, internal, width, 0, format, type_, data);
            }
            Self::D2(target, internal) => {
                glTexImage2D(target, level, internal, width, height, 0, format, type_, data);
            }
        }
    }
}

/// The number of the level that the data is of, and of those that are wanted.
#[derive(Clone, Copy)]
struct Numbers {
    level: GLint,
    base: GLint,
    max: GLint,
}

fn build(
    texture: Texture,
    (width, height): (GLsizei, GLsizei),
    (format, type_): (GLenum, GLenum),
    numbers: Numbers,
    data: Data<'_>,
) -> GLenum {
    let Numbers { level, base, max } = numbers;
    if level < 0 || base < level || max < base {
        return GLU_INVALID_VALUE;
    }
    let store = Store::current(&UNPACK);
    let layout = match layout(width, height, format, type_, store) {
        Ok(layout) => layout,
        Err(code) => return code,
    };
    let Ok(image) = layout.read(bytes(data, &layout)) else {
        texture.upload(level, (width, height), (format, type_), data);
        return GLU_INVALID_VALUE;
    };
    let limit = get(GL_MAX_TEXTURE_SIZE).max(1);
    TIGHT.make_current(&UNPACK);
    for (number, image) in (level..).zip(chain(image, layout.storage, limit)) {
        if !(base..=max).contains(&number) {
            continue;
        }
        let layout = Layout::tight(image.width, image.height, image.count, layout.storage);
        let mut texels = vec![0; layout.needed()];
        if layout.write(&image, &mut texels).is_ok() {
            let size = (image.width as GLsizei, image.height as GLsizei);
            texture.upload(number, size, (format, type_), Data::Bytes(&texels));
        }
    }
    store.make_current(&UNPACK);
    0
}

/// Scales an image in client memory with GLU's box filter, from the `GL_UNPACK_*` state's layout
/// to the `GL_PACK_*` state's.
///
/// Gives 0 or a GLU error code, as [`gluBuild2DMipmaps`]; then `data_out` is as it was.
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
    let format = format.arg();
    let unpack = Store::current(&UNPACK);
    let pack = Store::current(&PACK);
    let from = layout(width_in.arg(), height_in.arg(), format, type_in.arg(), unpack);
    let to = layout(width_out.arg(), height_out.arg(), format, type_out.arg(), pack);
    let result = from.and_then(|from| {
        let to = to?;
        let LocatedOut::Bytes(out) = data_out.arg().locate(0, to.needed()) else {
            return Err(GLU_INVALID_VALUE);
        };
        rescale(&from, bytes(data_in.arg(), &from), &to, out).map_err(|_| GLU_INVALID_VALUE)
    });
    result.err().unwrap_or(0)
}

fn rescale(from: &Layout, data: &[u8], to: &Layout, out: &mut [u8]) -> Result<(), TooShort> {
    // Before any work: no size that the slice does not back.
    if out.len() < to.needed() {
        return Err(TooShort { needed: to.needed() });
    }
    let mut image = scale(&from.read(data)?, to.width, to.height, from.storage);
    for (at, value) in image.values.iter_mut().enumerate() {
        *value = from.storage.convert(to.storage, at % to.count, *value);
    }
    to.write(&image, out)
}

/// The client's memory; GLU knows no buffer objects.
fn bytes<'a>(data: Data<'a>, layout: &Layout) -> &'a [u8] {
    match data.locate(0, layout.needed()) {
        Located::Bytes(bytes) => bytes,
        Located::Offset(_) | Located::Null => &[],
    }
}

/// The images of all levels, the largest first.
fn chain(image: Components, storage: Storage, limit: usize) -> impl Iterator<Item = Components> {
    let fit = |size| nearest_power_of_two(size).min(limit);
    let (width, height) = (fit(image.width), fit(image.height));
    let base = resized(image, width, height, storage);
    std::iter::successors(Some(base), move |image| {
        let (width, height) = (image.width, image.height);
        (width > 1 || height > 1)
            .then(|| scale(image, (width / 2).max(1), (height / 2).max(1), storage))
    })
}

fn resized(image: Components, width: usize, height: usize, storage: Storage) -> Components {
    if (image.width, image.height) == (width, height) {
        return image;
    }
    scale(&image, width, height, storage)
}

/// libGLU's `nearestPower`: up from 3 quarters of the way on (3 gives 4, 5 gives 4, 6 gives 8).
fn nearest_power_of_two(size: usize) -> usize {
    let below = 1 << size.ilog2();
    if size >= below + below / 2 && size > 2 { below * 2 } else { below }
}

fn layout(
    width: GLsizei,
    height: GLsizei,
    format: GLenum,
    type_: GLenum,
    store: Store,
) -> Result<Layout, GLenum> {
    if width < 1 || height < 1 {
        return Err(GLU_INVALID_VALUE);
    }
    let count = pixels::components(format).ok_or(GLU_INVALID_ENUM)?;
    let storage = Storage::of(type_).ok_or(GLU_INVALID_ENUM)?;
    if !storage.holds(count) {
        return Err(GLU_INVALID_OPERATION);
    }
    Ok(Layout { width: width as usize, height: height as usize, count, storage, store })
}

/// The names of half of the `glPixelStore` state.
struct Names {
    alignment: GLenum,
    row_length: GLenum,
    skip_rows: GLenum,
    skip_pixels: GLenum,
    swap_bytes: GLenum,
}

const UNPACK: Names = Names {
    alignment: GL_UNPACK_ALIGNMENT,
    row_length: GL_UNPACK_ROW_LENGTH,
    skip_rows: GL_UNPACK_SKIP_ROWS,
    skip_pixels: GL_UNPACK_SKIP_PIXELS,
    swap_bytes: GL_UNPACK_SWAP_BYTES,
};

const PACK: Names = Names {
    alignment: GL_PACK_ALIGNMENT,
    row_length: GL_PACK_ROW_LENGTH,
    skip_rows: GL_PACK_SKIP_ROWS,
    skip_pixels: GL_PACK_SKIP_PIXELS,
    swap_bytes: GL_PACK_SWAP_BYTES,
};

/// A piece of state that is never negative; 0 without a context.
fn get(name: GLenum) -> usize {
    let mut value: GLint = 0;
    glGetIntegerv(name, &mut value);
    usize::try_from(value).unwrap_or(0)
}

impl Store {
    fn current(names: &Names) -> Self {
        Self {
            alignment: get(names.alignment).max(1),
            row_length: get(names.row_length),
            skip_rows: get(names.skip_rows),
            skip_pixels: get(names.skip_pixels),
            order: match get(names.swap_bytes) {
                0 => ByteOrder::Native,
                _ => ByteOrder::Swapped,
            },
        }
    }

    fn make_current(self, names: &Names) {
        glPixelStorei(names.alignment, self.alignment as GLint);
        glPixelStorei(names.row_length, self.row_length as GLint);
        glPixelStorei(names.skip_rows, self.skip_rows as GLint);
        glPixelStorei(names.skip_pixels, self.skip_pixels as GLint);
        glPixelStorei(names.swap_bytes, GLint::from(self.order == ByteOrder::Swapped));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// libGLU's own loop.
    fn oracle(mut value: usize) -> usize {
        let mut power = 1;
        loop {
            match value {
                1 => return power,
                3 => return power * 4,
                _ => {
                    value >>= 1;
                    power *= 2;
                }
            }
        }
    }

    #[test]
    fn sizes_go_to_the_power_of_two_that_libglu_takes() {
        for size in 1..5000 {
            assert_eq!(nearest_power_of_two(size), oracle(size), "{size}");
        }
    }

    #[test]
    fn a_chain_ends_at_one_pixel_and_keeps_the_mean_of_a_checkerboard() {
        let values: Vec<u8> =
            (0..128 * 128).map(|at| if (at + at / 128) % 2 == 0 { 0 } else { 255 }).collect();
        let image = Layout::tight(128, 128, 1, Storage::U8).read(&values).unwrap();
        let levels: Vec<_> = chain(image, Storage::U8, 8192).collect();
        let sizes: Vec<_> = levels.iter().map(|level| (level.width, level.height)).collect();
        assert_eq!(sizes, [128, 64, 32, 16, 8, 4, 2, 1].map(|side| (side, side)));
        assert!(levels[1..].iter().all(|level| level.values.iter().all(|&v| v == 128.0)));
    }

    #[test]
    fn a_long_image_is_halved_along_its_long_side_alone_at_the_end() {
        let image = Layout::tight(5, 3, 1, Storage::U8).read(&[9; 15]).unwrap();
        let sizes: Vec<_> =
            chain(image, Storage::U8, 8192).map(|level| (level.width, level.height)).collect();
        assert_eq!(sizes, [(4, 4), (2, 2), (1, 1)]);
        let image = Layout::tight(40, 2, 1, Storage::U8).read(&[9; 80]).unwrap();
        let sizes: Vec<_> =
            chain(image, Storage::U8, 16).map(|level| (level.width, level.height)).collect();
        assert_eq!(sizes, [(16, 2), (8, 1), (4, 1), (2, 1), (1, 1)]);
    }

    #[test]
    fn sizes_formats_and_types_are_checked() {
        for (width, format, type_, expected) in [
            (0, GL_RGB, GL_UNSIGNED_BYTE, GLU_INVALID_VALUE),
            (-1, GL_RGB, GL_UNSIGNED_BYTE, GLU_INVALID_VALUE),
            (2, GL_TEXTURE_2D, GL_UNSIGNED_BYTE, GLU_INVALID_ENUM),
            (2, GL_RGB, GL_TEXTURE_2D, GLU_INVALID_ENUM),
            (2, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4, GLU_INVALID_OPERATION),
        ] {
            assert_eq!(layout(width, 1, format, type_, TIGHT).err(), Some(expected));
        }
        let huge = layout(i32::MAX, i32::MAX, GL_RGBA, GL_FLOAT, TIGHT).unwrap();
        assert_eq!(huge.read(&[0; 5]), Err(TooShort { needed: huge.needed() }));
    }
}
