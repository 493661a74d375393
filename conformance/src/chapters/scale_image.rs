//! `gluScaleImage`: images in the client's memory, scaled into the client's memory.

use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::Variant;
use crate::oracle::mipmap::{Storage, Volume};
use crate::oracle::pixel::Store;
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;
use gl_api::glu::gluScaleImage;
use gl_api::types::GLenum;

/// Scaled images.
pub const SCALE: Check = Check {
    name: "glu-scale",
    citation: "GLU 1.3, 3.1: gluScaleImage; GL 2.1, 3.6.1 and 4.3.2: pixel storage on both sides",
    what: "every pixel of images of 1 to 4 components of bytes, shorts and floats: smaller, halved, larger, in either byte order",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 24) as f64,
    why: "area means in f64; bytes and shorts are rounded once, halves up; a float may be the next one: 2^-24 of 1",
    run,
};

type Size = [usize; 2];

/// From, and to. Rows that are halved have a path of their own, and so have runs of 64 pixels.
const SIZES: [[Size; 2]; 11] = [
    [[8, 6], [4, 3]],
    [[8, 6], [4, 6]],
    [[6, 8], [6, 4]],
    [[5, 7], [3, 4]],
    [[3, 2], [7, 5]],
    [[1, 1], [4, 3]],
    [[16, 1], [5, 1]],
    [[9, 9], [9, 9]],
    [[6, 5], [13, 2]],
    [[150, 3], [70, 2]],
    [[140, 4], [70, 2]],
];

/// Formats, and how many components each has.
const FORMATS: [(GLenum, usize); 5] =
    [(GL_RED, 1), (GL_LUMINANCE_ALPHA, 2), (GL_RGB, 3), (GL_BGRA, 4), (GL_RGBA, 4)];

const TYPES: [(GLenum, Storage); 3] = [
    (GL_UNSIGNED_BYTE, Storage::Bytes),
    (GL_UNSIGNED_SHORT, Storage::Shorts),
    (GL_FLOAT, Storage::Floats),
];

/// The pixels of one side in memory.
#[derive(Clone, Copy, Debug)]
struct Memory {
    size: Size,
    store: Store,
    is_swapped: bool,
    storage: Storage,
    components: usize,
}

impl Memory {
    fn random(rng: &mut Rng, size: Size, storage: Storage, components: usize) -> Self {
        let store = Store {
            alignment: rng.pick(&[1, 2, 4, 8]),
            row_length: rng.pick(&[0, size[0] + 1, size[0] + 4]),
            image_height: 0,
            skip: [rng.integer(0, 3) as usize, rng.integer(0, 2) as usize, 0],
        };
        Self { size, store, is_swapped: rng.integer(0, 1) == 1, storage, components }
    }

    fn element(&self) -> usize {
        match self.storage {
            Storage::Bytes | Storage::SrgbBytes => 1,
            Storage::Shorts => 2,
            Storage::Floats => 4,
        }
    }

    /// Where a component of a pixel begins.
    fn offset(&self, [x, y]: Size, component: usize) -> usize {
        let (element, pixel) = (self.element(), self.element() * self.components);
        self.store.place([x, y, 0], self.size, element, pixel, Variant::CORRECT)
            + component * element
    }

    fn len(&self) -> usize {
        self.offset(self.size.map(|n| n - 1), self.components)
    }

    fn pixels(&self) -> Vec<Size> {
        let [width, height] = self.size;
        (0..height).flat_map(|y| (0..width).map(move |x| [x, y])).collect()
    }

    /// Bytes with these numbers, and others between them.
    fn written(&self, rng: &mut Rng, image: &Volume) -> Vec<u8> {
        let mut bytes: Vec<u8> = (0..self.len()).map(|_| rng.byte()).collect();
        for (at, texel) in self.pixels().into_iter().zip(&image.texels) {
            for (component, &value) in texel.iter().enumerate().take(self.components) {
                let mut word = match self.storage {
                    Storage::Bytes | Storage::SrgbBytes => vec![(value * 255.0).round() as u8],
                    Storage::Shorts => ((value * 65535.0).round() as u16).to_ne_bytes().to_vec(),
                    Storage::Floats => (value as f32).to_ne_bytes().to_vec(),
                };
                if self.is_swapped {
                    word.reverse();
                }
                bytes[self.offset(at, component)..][..word.len()].copy_from_slice(&word);
            }
        }
        bytes
    }

    /// The numbers of a pixel; 0 for components that there are not.
    fn read(&self, bytes: &[u8], at: Size) -> [f64; 4] {
        let mut out = [0.0; 4];
        for (component, out) in out.iter_mut().enumerate().take(self.components) {
            let mut word = bytes[self.offset(at, component)..][..self.element()].to_vec();
            if self.is_swapped {
                word.reverse();
            }
            *out = match word[..] {
                [byte] => f64::from(byte) / 255.0,
                [a, b] => f64::from(u16::from_ne_bytes([a, b])) / 65535.0,
                [a, b, c, d] => f32::from_ne_bytes([a, b, c, d]).into(),
                _ => f64::NAN,
            };
        }
        out
    }

    /// Makes the storage the current one of uploads or of read-backs, by the names of its parameters.
    fn make_current(&self, [alignment, row_length, pixels, rows, swap]: [GLenum; 5]) {
        glPixelStorei(alignment, self.store.alignment as i32);
        glPixelStorei(row_length, self.store.row_length as i32);
        glPixelStorei(pixels, self.store.skip[0] as i32);
        glPixelStorei(rows, self.store.skip[1] as i32);
        glPixelStorei(swap, i32::from(self.is_swapped));
    }
}

fn image(rng: &mut Rng, [width, height]: Size, storage: Storage, components: usize) -> Volume {
    let mut number = || match storage {
        Storage::Bytes | Storage::SrgbBytes => f64::from(rng.byte()) / 255.0,
        Storage::Shorts => rng.integer(0, 65535) as f64 / 65535.0,
        Storage::Floats => rng.real(0.0, 1.0).into(),
    };
    let texels = (0..width * height)
        .map(|_| std::array::from_fn(|i| if i < components { number() } else { 0.0 }));
    Volume { size: [width, height, 1], texels: texels.collect() }
}

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("glu-scale");
    let all = SIZES.iter().flat_map(|sizes| TYPES.iter().map(move |ty| (sizes, ty)));
    for (&[from, to], &(ty, storage)) in all {
        let (format, components) = rng.pick(&FORMATS);
        let given = image(&mut rng, from, storage, components);
        let source = Memory::random(&mut rng, from, storage, components);
        let target = Memory::random(&mut rng, to, storage, components);
        let bytes = source.written(&mut rng, &given);
        let scaled = |variant| given.scaled([to[0], to[1], 1], storage, variant).texels;
        let (truth, expected) = (scaled(Variant::CORRECT), scaled(harness.variant));
        let expect = |[x, y]: &Size, variant: Variant| {
            let all = if variant == Variant::CORRECT { &truth } else { &expected };
            all[y * to[0] + x]
        };
        let pixels = target.pixels();
        harness.compare(tally, &(format, source, target), &pixels, expect, |session| {
            source.make_current([
                GL_UNPACK_ALIGNMENT,
                GL_UNPACK_ROW_LENGTH,
                GL_UNPACK_SKIP_PIXELS,
                GL_UNPACK_SKIP_ROWS,
                GL_UNPACK_SWAP_BYTES,
            ]);
            target.make_current([
                GL_PACK_ALIGNMENT,
                GL_PACK_ROW_LENGTH,
                GL_PACK_SKIP_PIXELS,
                GL_PACK_SKIP_ROWS,
                GL_PACK_SWAP_BYTES,
            ]);
            let mut out = vec![0xA5_u8; target.len()];
            let code = gluScaleImage(
                format,
                from[0],
                from[1],
                ty,
                &bytes[..],
                to[0],
                to[1],
                ty,
                &mut out[..],
            );
            session.check("scaling an image")?;
            if code != 0 {
                let (after, message) = ("scaling an image", "an error of GLU's".to_owned());
                return Err(ProbeError::Gl { after, code, message });
            }
            Ok(pixels.iter().map(|&at| target.read(&out, at)).collect())
        })?;
    }
    Ok(())
}
