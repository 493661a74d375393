//! Client pixels of every format and type, unpacked into float textures and packed from them.

use super::error::ProbeError;
use super::session::Session;
use crate::gl::*;
use crate::oracle::pixel::Store;
use gl_api::constants::*;
use std::fmt;

/// The layout of a client pixel.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct ClientPixels {
    /// Parameter of `glTexImage2D`.
    pub format: u32,
    /// Parameter of `glTexImage2D`.
    pub ty: u32,
    /// `GL_UNPACK_SWAP_BYTES` or `GL_PACK_SWAP_BYTES`.
    pub swapped: bool,
}

impl fmt::Debug for ClientPixels {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let order = if self.swapped { ", swapped" } else { "" };
        write!(f, "{} of {}{order}", enum_name(self.format), enum_name(self.ty))
    }
}

/// A box of pixels in client memory.
#[derive(Clone, Copy, Debug)]
pub struct StoredBox {
    /// The layout of a pixel.
    pub pixels: ClientPixels,
    /// Width, height, depth.
    pub size: [usize; 3],
    /// The pixel store parameters.
    pub store: Store,
    /// Size of a pixel in bytes.
    pub pixel: usize,
}

/// The enums of the pixel store: alignment, row length, image height, skips, swap.
type StoreNames = [u32; 7];

const UNPACK: StoreNames = [
    GL_UNPACK_ALIGNMENT,
    GL_UNPACK_ROW_LENGTH,
    GL_UNPACK_IMAGE_HEIGHT,
    GL_UNPACK_SKIP_PIXELS,
    GL_UNPACK_SKIP_ROWS,
    GL_UNPACK_SKIP_IMAGES,
    GL_UNPACK_SWAP_BYTES,
];

const PACK: StoreNames = [
    GL_PACK_ALIGNMENT,
    GL_PACK_ROW_LENGTH,
    GL_PACK_IMAGE_HEIGHT,
    GL_PACK_SKIP_PIXELS,
    GL_PACK_SKIP_ROWS,
    GL_PACK_SKIP_IMAGES,
    GL_PACK_SWAP_BYTES,
];

/// Sets the pixel store to pixels without gaps.
const TIGHT: Store = Store { alignment: 1, row_length: 0, image_height: 0, skip: [0; 3] };

fn set_store(names: StoreNames, store: Store, swapped: bool) {
    let Store { alignment, row_length, image_height, skip: [x, y, z] } = store;
    let values = [alignment, row_length, image_height, x, y, z, usize::from(swapped)];
    for (name, value) in names.into_iter().zip(values) {
        glPixelStorei(name, value);
    }
}

impl Session {
    /// R, G, B, A of `count` pixels after `glTexImage2D` into a float texture.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn unpacked(
        &self,
        pixels: ClientPixels,
        count: usize,
        memory: &[u8],
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        let ClientPixels { format, ty, swapped } = pixels;
        glBindTexture(GL_TEXTURE_2D, 1);
        set_store(UNPACK, TIGHT, swapped);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, count, 1, 0, format, ty, memory);
        self.check("unpacking pixels")?;
        self.level_texels(GL_TEXTURE_2D, 0, [count, 1, 1])
    }

    /// The bytes that `glGetTexImage` packs float texels to.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn packed(
        &self,
        pixels: ClientPixels,
        texels: &[[f32; 4]],
        pixel: usize,
    ) -> Result<Vec<u8>, ProbeError> {
        let ClientPixels { format, ty, swapped } = pixels;
        let mut bytes = vec![0u8; texels.len() * pixel];
        let (width, target) = (texels.len(), GL_TEXTURE_2D);
        let texels = texels.as_flattened();
        glBindTexture(target, 1);
        glTexImage2D(target, 0, GL_RGBA32F, width, 1, 0, GL_RGBA, GL_FLOAT, texels);
        set_store(PACK, TIGHT, swapped);
        glGetTexImage(target, 0, format, ty, &mut bytes);
        self.check("packing pixels")?;
        Ok(bytes)
    }

    /// The pixels that GL unpacks from a box in memory, without gaps.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn unpacked_box(&self, of: &StoredBox, memory: &[u8]) -> Result<Vec<u8>, ProbeError> {
        set_store(UNPACK, of.store, false);
        self.upload_box(of, memory);
        let mut tight = vec![0u8; of.size.iter().product::<usize>() * of.pixel];
        glGetTexImage(GL_TEXTURE_3D, 0, of.pixels.format, of.pixels.ty, &mut tight);
        self.check("unpacking a box")?;
        Ok(tight)
    }

    /// Memory of `bytes` bytes after GL packs pixels into a box in it.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn packed_box(
        &self,
        of: &StoredBox,
        tight: &[u8],
        bytes: usize,
    ) -> Result<Vec<u8>, ProbeError> {
        self.upload_box(of, tight);
        set_store(PACK, of.store, false);
        let mut memory = vec![0u8; bytes];
        glGetTexImage(GL_TEXTURE_3D, 0, of.pixels.format, of.pixels.ty, &mut memory);
        self.check("packing a box")?;
        Ok(memory)
    }

    fn upload_box(&self, of: &StoredBox, memory: &[u8]) {
        let [w, h, d] = of.size;
        let ClientPixels { format, ty, .. } = of.pixels;
        glBindTexture(GL_TEXTURE_3D, 1);
        glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA16, w, h, d, 0, format, ty, memory);
    }

    /// Bytes after pixel transfer with a scale and a bias into `GL_RGBA8`.
    ///
    /// # Errors
    /// When a call sets the error flag.
    pub fn transferred(
        &self,
        scale: [f32; 4],
        bias: [f32; 4],
        texels: &[[u8; 4]],
    ) -> Result<Vec<[f64; 4]>, ProbeError> {
        let scales = [GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE];
        let biases = [GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS];
        for (name, value) in scales.iter().zip(scale).chain(biases.iter().zip(bias)) {
            glPixelTransferf(*name, value);
        }
        let (width, target) = (texels.len(), GL_TEXTURE_2D);
        let bytes = texels.as_flattened();
        glBindTexture(target, 1);
        glTexImage2D(target, 0, GL_RGBA8, width, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
        for name in scales {
            glPixelTransferf(name, 1);
        }
        for name in biases {
            glPixelTransferf(name, 0);
        }
        self.check("transferring pixels")?;
        self.level_texels(target, 0, [width, 1, 1])
    }
}
