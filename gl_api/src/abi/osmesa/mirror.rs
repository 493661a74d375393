//! The memory of an OSMesa client, which has the picture after `glFlush` and `glFinish`.

use crate::abi::memory::ClientPointer;
use crate::constants::*;
use crate::context::Context;
use crate::draw::hints::sight;
use crate::framebuffer::read::{ClientRows, Up, read_rows};
use crate::framebuffer::{Visible, format_of, whole};
use crate::object::sharing::Turn;
use crate::state::pixel_store::PixelStore;
use crate::texture::client::{LuminanceOf, Pixel};
use crate::texture::convert::{Conversion, Final};
use crate::texture::layout::{Extent, Layout};
use crate::texture::transfer::Transfer;
use crate::types::GLenum;
use rasterizer::driver::{Image, Put};

/// How a pixel's components lie in the client's memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pixels {
    /// GL's format and type.
    pub gl: (GLenum, GLenum),
    /// Whether alpha comes first: the components are moved on by one.
    pub alpha_first: bool,
}

/// Whether the client's memory has the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Copied {
    /// It has the last one.
    Yes,
    /// There may be a newer one.
    No,
}

/// The client's memory.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mirror {
    pub(super) memory: ClientPointer<'static>,
    pub(super) pixels: Pixels,
    pub(super) row_length: usize,
    pub(super) up: Up,
    pub(super) copied: Copied,
}

impl Context {
    /// Copies the picture for an OSMesa client; everything recorded has been carried out.
    pub(crate) fn show_mirror(&mut self) {
        if let Some(mirror) = self.mirror {
            mirror.update(self);
            self.mirror = Some(Mirror { copied: Copied::Yes, ..mirror });
            sight::picture(self);
        }
    }

    /// Takes note that the client's memory has another picture than was just drawn.
    pub(crate) fn outdate_mirror(&mut self) {
        if let Some(mirror) = &mut self.mirror {
            mirror.copied = Copied::No;
        }
    }

    /// Draws everything and forgets the client's memory, as it is current no more. What the client
    /// has seen already is not copied again: it may have freed memory that it is done with.
    pub(crate) fn end_mirror(&mut self) {
        let turn = Turn::begin(self);
        crate::draw::submit(turn.context);
        drop(turn);
        if let Some(mirror) = self.mirror.take().filter(|mirror| mirror.copied == Copied::No) {
            mirror.update(self);
        }
    }
}

impl Mirror {
    fn update(&self, context: &Context) {
        let Ok(pixel) = Pixel::new(self.pixels.gl.0, self.pixels.gl.1) else { return };
        let [width, height] =
            [context.window.width, context.window.height].map(|side| side as usize);
        let length = if self.row_length > 0 { self.row_length } else { width };
        let stride = length.saturating_mul(pixel.bytes());
        let before = (height - 1).saturating_mul(stride);
        let memory = self.memory.bytes_mut(before.saturating_add(width * pixel.bytes()));
        if !memory.is_empty() {
            self.copy(context, &context.window.color, self.pixels, (memory, stride));
        }
    }

    /// The depths, 16 or 32 bits each; rows as the picture's.
    pub(super) fn depths(&self, context: &Context, bits: usize) -> Option<Vec<u32>> {
        let image = context.window.depth.as_ref()?;
        let [width, height] =
            [context.window.width, context.window.height].map(|side| side as usize);
        let mut depths = vec![0_u32; width * height];
        let pixels = Pixels { gl: (GL_DEPTH_COMPONENT, GL_UNSIGNED_INT), alpha_first: false };
        let to = (bytemuck::cast_slice_mut(&mut depths), 4 * width);
        self.copy(context, image, pixels, to);
        depths.iter_mut().for_each(|depth| *depth >>= 32 - bits);
        Some(depths)
    }

    /// Puts an image into memory for all of its rows, each so many bytes after the one before.
    fn copy(
        &self,
        context: &Context,
        image: &Image,
        pixels: Pixels,
        (bytes, stride): (&mut [u8], usize),
    ) {
        let from = whole(image);
        let (Some([width, height]), Some(format)) = (from.size(), format_of(&from)) else { return };
        let all = Visible { x: 0, y: 0, width: width as usize, height: height as usize };
        let Ok(pixel) = Pixel::new(pixels.gl.0, pixels.gl.1) else { return };
        let store = PixelStore { alignment: 1, ..PixelStore::default() };
        let Ok(row) = Layout::new(&store, pixel, [all.width, 1, 1], Extent::Flat) else { return };
        let (transfer, last) = (Transfer::default(), Final::of(format, LuminanceOf::Sum));
        let conversion = Conversion::pack(context.recorder.isa(), &row, format, &transfer, last);
        let row_bytes = row.row_bytes();
        let convert = |texels: &[u8], out: &mut [u8]| {
            conversion.pack_row(&row, texels, out);
            if pixels.alpha_first {
                let (out, alpha) = (&mut out[..row_bytes], pixel.bytes() / 4);
                out.chunks_exact_mut(pixel.bytes()).for_each(|pixel| pixel.rotate_right(alpha));
            }
        };
        let is_copy = conversion.is_copy(&row) && !pixels.alpha_first;
        let put = if is_copy { Put::AsStored } else { Put::By(&convert) };
        let to = ClientRows { bytes, stride, row_bytes, up: self.up };
        read_rows(&context.recorder.device(), &from, all, to, put);
    }
}
