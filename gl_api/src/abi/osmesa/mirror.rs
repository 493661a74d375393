//! The memory of an OSMesa client, which has the picture after `glFlush` and `glFinish`.

use crate::abi::memory::ClientPointer;
use crate::constants::*;
use crate::context::Context;
use crate::draw::hints::sight;
use crate::object::sharing::Turn;
use crate::state::pixel_store::PixelStore;
use crate::texture::client::{LuminanceOf, Pixel};
use crate::texture::convert;
use crate::texture::layout::{Extent, Layout};
use crate::texture::transfer::Transfer;
use crate::types::GLenum;

/// How a pixel's components lie in the client's memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Pixels {
    /// GL's format and type.
    pub gl: (GLenum, GLenum),
    /// Whether alpha comes first: the components are moved on by one.
    pub alpha_first: bool,
}

/// Which row comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Up {
    /// The lowest.
    Y,
    /// The highest.
    NotY,
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
        let texels = context.recorder.device().texels(&context.window.color);
        let Some(level) = texels.level(0, 0) else { return };
        let (width, height) = (level.width as usize, level.height as usize);
        let Ok(pixel) = Pixel::new(self.pixels.gl.0, self.pixels.gl.1) else { return };
        let store = PixelStore { alignment: 1, ..PixelStore::default() };
        let Ok(row) = Layout::new(&store, pixel, [width, 1, 1], Extent::Flat) else { return };
        let length = if self.row_length > 0 { self.row_length } else { width };
        let step = length * pixel.bytes();
        let memory = self.memory.bytes_mut((height.max(1) - 1) * step + row.needed);
        let used = width * level.format.bytes();
        let (isa, transfer) = (context.recorder.isa(), Transfer::default());
        for y in 0..height {
            let from = &level.texels[y * level.row_bytes()..][..used];
            let at = match self.up {
                Up::Y => y,
                Up::NotY => height - 1 - y,
            };
            let Some(out) = memory.get_mut(at * step..at * step + row.needed) else { return };
            convert::pack(isa, &row, level.format, &transfer, LuminanceOf::Sum, from, out);
            if self.pixels.alpha_first {
                let alpha = pixel.bytes() / 4;
                out.chunks_exact_mut(pixel.bytes()).for_each(|pixel| pixel.rotate_right(alpha));
            }
        }
    }

    /// The depths, 16 or 32 bits each; rows as the picture's.
    pub(super) fn depths(&self, context: &Context, bits: usize) -> Option<Vec<u32>> {
        let texels = context.window.depth.as_ref()?.texels();
        let level = texels.level(0, 0)?;
        let (width, height) = (level.width as usize, level.height as usize);
        let pixel = Pixel::new(GL_DEPTH_COMPONENT, GL_UNSIGNED_INT).ok()?;
        let store = PixelStore { alignment: 1, ..PixelStore::default() };
        let row = Layout::new(&store, pixel, [width, 1, 1], Extent::Flat).ok()?;
        let used = width * level.format.bytes();
        let (isa, transfer) = (context.recorder.isa(), Transfer::default());
        let mut depths = vec![0_u32; width * height];
        for (y, out) in depths.chunks_exact_mut(width.max(1)).enumerate() {
            let y = match self.up {
                Up::Y => y,
                Up::NotY => height - 1 - y,
            };
            let from = &level.texels[y * level.row_bytes()..][..used];
            let bytes = bytemuck::cast_slice_mut(out);
            convert::pack(isa, &row, level.format, &transfer, LuminanceOf::Sum, from, bytes);
            out.iter_mut().for_each(|depth| *depth >>= 32 - bits);
        }
        Some(depths)
    }
}
