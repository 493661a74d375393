//! `gluBuild1DMipmaps`, `gluBuild2DMipmaps`, `gluBuild3DMipmaps`, and those of some levels.

use super::error::GLU_INVALID_VALUE;
use super::image::{UNPACK, bytes, get, layout};
use super::pixels::{Layout, Meaning, Storage, Store, TIGHT, TooShort};
use super::scale;
use super::scale::{halve, scale};
use crate::base::args::Data;
use crate::base::constants::*;
use crate::base::types::{GLenum, GLint, GLsizei};
use crate::entry::{Arg, glTexImage1D, glTexImage2D, glTexImage3D};
use crate::pixel::convert;
use texunit::lanes::FloatEnv;

/// Builds every mipmap level of a texture from one image of any size: scales it to powers of two
/// (the nearest, as libGLU's `closestFit`) no larger than `GL_MAX_TEXTURE_SIZE`, hands that to
/// `glTexImage2D` as level 0, and halves it down to 1×1, each level from the one before it.
///
/// `data` is `width` by `height` pixels where the `GL_UNPACK_*` state says.
///
/// Gives 0, or a GLU error code: `GLU_INVALID_VALUE` for a size below 1 or a slice that is too
/// short (then `glTexImage2D` also says how many bytes were needed), `GLU_INVALID_ENUM` for a format
/// or type GLU does not scale, `GLU_INVALID_OPERATION` for a format and type that do not go together. Errors of `glTexImage2D` are GL's.
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
    let size = [width.arg(), height.arg(), 1];
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
    let size = [width.arg(), height.arg(), 1];
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
    build(texture, [width.arg(), 1, 1], (format.arg(), type_.arg()), all, data.arg())
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
    build(texture, [width.arg(), 1, 1], (format.arg(), type_.arg()), numbers, data.arg())
}

/// [`gluBuild2DMipmaps`] of a volume, by `glTexImage3D`, no side larger than
/// `GL_MAX_3D_TEXTURE_SIZE`.
#[expect(clippy::too_many_arguments, reason = "GLU's signature")]
pub fn gluBuild3DMipmaps<'a>(
    target: impl Arg<GLenum>,
    internal_format: impl Arg<GLint>,
    width: impl Arg<GLsizei>,
    height: impl Arg<GLsizei>,
    depth: impl Arg<GLsizei>,
    format: impl Arg<GLenum>,
    type_: impl Arg<GLenum>,
    data: impl Arg<Data<'a>>,
) -> GLenum {
    let all = Numbers { level: 0, base: 0, max: GLint::MAX };
    let texture = Texture::D3(target.arg(), internal_format.arg());
    let size = [width.arg(), height.arg(), depth.arg()];
    build(texture, size, (format.arg(), type_.arg()), all, data.arg())
}

/// [`gluBuild2DMipmapLevels`] of a volume, by `glTexImage3D`.
#[expect(clippy::too_many_arguments, reason = "GLU's signature")]
pub fn gluBuild3DMipmapLevels<'a>(
    target: impl Arg<GLenum>,
    internal_format: impl Arg<GLint>,
    width: impl Arg<GLsizei>,
    height: impl Arg<GLsizei>,
    depth: impl Arg<GLsizei>,
    format: impl Arg<GLenum>,
    type_: impl Arg<GLenum>,
    level: impl Arg<GLint>,
    base: impl Arg<GLint>,
    max: impl Arg<GLint>,
    data: impl Arg<Data<'a>>,
) -> GLenum {
    let numbers = Numbers { level: level.arg(), base: base.arg(), max: max.arg() };
    let texture = Texture::D3(target.arg(), internal_format.arg());
    let size = [width.arg(), height.arg(), depth.arg()];
    build(texture, size, (format.arg(), type_.arg()), numbers, data.arg())
}

/// The call that takes the levels: its target and internal format.
#[derive(Clone, Copy)]
enum Texture {
    D1(GLenum, GLint),
    D2(GLenum, GLint),
    D3(GLenum, GLint),
}

impl Texture {
    /// The largest side.
    fn limit(self) -> usize {
        let name = match self {
            Self::D1(..) | Self::D2(..) => GL_MAX_TEXTURE_SIZE,
            Self::D3(..) => GL_MAX_3D_TEXTURE_SIZE,
        };
        get(name).max(1)
    }

    /// The pixel store without what the call does not heed.
    fn heeded(self, store: Store) -> Store {
        match self {
            Self::D1(..) | Self::D2(..) => Store { image_height: 0, skip_images: 0, ..store },
            Self::D3(..) => store,
        }
    }

    fn upload(
        self,
        level: GLint,
        [width, height, depth]: [GLsizei; 3],
        (format, ty): (GLenum, GLenum),
        data: Data<'_>,
    ) {
        match self {
            Self::D1(target, internal) => {
                glTexImage1D(target, level, internal, width, 0, format, ty, data);
            }
            Self::D2(target, internal) => {
                glTexImage2D(target, level, internal, width, height, 0, format, ty, data);
            }
            Self::D3(target, internal) => {
                glTexImage3D(target, level, internal, width, height, depth, 0, format, ty, data);
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
    size: [GLsizei; 3],
    (format, type_): (GLenum, GLenum),
    numbers: Numbers,
    data: Data<'_>,
) -> GLenum {
    let _float_env = FloatEnv::enter();
    let Numbers { level, base, max } = numbers;
    if level < 0 || base < level || max < base {
        return GLU_INVALID_VALUE;
    }
    let store = Store::current(&UNPACK);
    let layout = match layout(size, format, type_, texture.heeded(store)) {
        Ok(layout) => layout,
        Err(code) => return code,
    };
    let put = |number: usize, size: [usize; 3], texels: &[u8]| {
        let number = level.saturating_add(number as GLint);
        if (base..=max).contains(&number) {
            let size = size.map(|side| side as GLsizei);
            texture.upload(number, size, (format, type_), Data::Bytes(texels));
        }
    };
    let limit = texture.limit();
    let given = bytes(data, &layout);
    if given.len() < layout.needed() {
        texture.upload(level, size, (format, type_), data);
        return GLU_INVALID_VALUE;
    }
    TIGHT.make_current(&UNPACK);
    levels(&layout, given, limit, put);
    store.make_current(&UNPACK);
    0
}

/// An image without gaps at another size, of the same type.
fn at_size(layout: &Layout, given: &[u8], size: [usize; 3]) -> Result<Vec<u8>, TooShort> {
    if layout.size == size {
        return layout.texels(given);
    }
    let tight = Layout::tight(size, layout.count, layout.storage);
    let mut texels = vec![0; tight.needed()];
    scale(Meaning::Fractions, (layout, given), (&tight, &mut texels))?;
    Ok(texels)
}

/// Hands the images of all levels to `put`, the largest first, without gaps and of the type of the first: number, size
/// and texels. Ends where there is no memory for one.
fn levels(
    layout: &Layout,
    given: &[u8],
    limit: usize,
    mut put: impl FnMut(usize, [usize; 3], &[u8]),
) {
    let size = layout.size.map(|side| nearest_power_of_two(side).min(limit));
    let Ok(texels) = at_size(layout, given, size) else { return };
    put(0, size, &texels);
    if layout.storage == Storage::U8 {
        bytes_below(size, layout.count, &texels, put);
    } else {
        numbers_below(&Layout { size, store: TIGHT, ..*layout }, texels, put);
    }
}

/// The levels below one of bytes.
fn bytes_below(
    size: [usize; 3],
    count: usize,
    texels: &[u8],
    mut put: impl FnMut(usize, [usize; 3], &[u8]),
) {
    let Ok(mut level) = scale::bytes(size, count, texels) else { return };
    for number in 1.. {
        if level.size() == [1; 3] {
            return;
        }
        let Ok(half) = halve(&level) else { return };
        put(number, half.size().map(|side| side as usize), convert::texels(&half));
        level = half;
    }
}

/// The levels below one of any type.
fn numbers_below(
    layout: &Layout,
    mut texels: Vec<u8>,
    mut put: impl FnMut(usize, [usize; 3], &[u8]),
) {
    let mut layout = *layout;
    for number in 1.. {
        if layout.size == [1; 3] {
            return;
        }
        let half = layout.size.map(|side| (side / 2).max(1));
        let Ok(halved) = at_size(&layout, &texels, half) else { return };
        put(number, half, &halved);
        (layout.size, texels) = (half, halved);
    }
}

/// libGLU's `nearestPower`: up from 3 quarters of the way on (3 gives 4, 5 gives 4, 6 gives 8).
fn nearest_power_of_two(size: usize) -> usize {
    let below = 1 << size.ilog2();
    if size >= below + below / 2 && size > 2 { below * 2 } else { below }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

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

    /// Size and texels of each level.
    fn all(layout: &Layout, given: &[u8], limit: usize) -> Vec<([usize; 3], Vec<u8>)> {
        let mut all = Vec::new();
        levels(layout, given, limit, |number, size, texels| {
            assert_eq!(number, all.len());
            all.push((size, texels.to_vec()));
        });
        all
    }

    #[test]
    fn a_chain_ends_at_one_pixel_and_keeps_the_mean_of_a_checkerboard() {
        let values: Vec<u8> =
            (0..128 * 128).map(|at| if (at + at / 128) % 2 == 0 { 0 } else { 255 }).collect();
        let shorts: Vec<u8> = values.iter().flat_map(|&v| u16::from(v).to_ne_bytes()).collect();
        for (storage, given, mean) in [
            (Storage::U8, values, vec![128]),
            (Storage::U16, shorts, 128_u16.to_ne_bytes().to_vec()),
        ] {
            let levels = all(&Layout::tight([128, 128, 1], 1, storage), &given, 8192);
            let sizes: Vec<_> = levels.iter().map(|(size, _)| *size).collect();
            assert_eq!(sizes, [128, 64, 32, 16, 8, 4, 2, 1].map(|side| [side, side, 1]));
            let is_mean = |texels: &[u8]| texels.chunks(mean.len()).all(|texel| texel == mean);
            assert!(levels[1..].iter().all(|(_, texels)| is_mean(texels)));
        }
    }

    #[test]
    fn a_long_image_is_halved_along_its_long_side_alone_at_the_end() {
        for (storage, bytes) in [(Storage::U8, 1), (Storage::F32, 4)] {
            let sizes = |size: [usize; 3], limit| {
                let given = vec![0; size[0] * size[1] * bytes];
                let levels = all(&Layout::tight(size, 1, storage), &given, limit);
                levels.iter().map(|(size, _)| (size[0], size[1])).collect::<Vec<_>>()
            };
            assert_eq!(sizes([5, 3, 1], 8192), [(4, 4), (2, 2), (1, 1)]);
            assert_eq!(sizes([40, 2, 1], 16), [(16, 2), (8, 1), (4, 1), (2, 1), (1, 1)]);
        }
    }

    proptest! {
        #[test]
        fn bytes_have_the_levels_that_numbers_have(
            size in (1usize..40, 1usize..40, 1usize..5),
            count in 1usize..5,
            alignment in prop::sample::select(vec![1, 2, 4, 8]),
            skipped in (0usize..4, 0usize..4, 0usize..4),
            powers: bool,
            seed: u64,
        ) {
            let mut size = [size.0, size.1, size.2];
            if powers {
                size = size.map(usize::next_power_of_two);
            }
            let (row_length, skip_rows, skip_pixels) = (size[0] + 3, skipped.0, skipped.1);
            let store = Store {
                alignment,
                row_length: if skip_pixels == 0 { 0 } else { row_length },
                skip_rows,
                skip_pixels,
                skip_images: skipped.2,
                ..TIGHT
            };
            let layout = Layout { store, ..Layout::tight(size, count, Storage::U8) };
            let mut random = seed;
            let given: Vec<u8> = (0..layout.needed())
                .map(|_| {
                    random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                    (random >> 33) as u8
                })
                .collect();
            let levels = all(&layout, &given, 32);
            let (size, texels) = levels[0].clone();
            prop_assert!(at_size(&layout, &given, size) == Ok(texels.clone()));
            let mut numbers = vec![(size, texels.clone())];
            numbers_below(&Layout::tight(size, count, Storage::U8), texels, |_, size, texels| {
                numbers.push((size, texels.to_vec()));
            });
            prop_assert!(levels == numbers);
        }
    }
}
