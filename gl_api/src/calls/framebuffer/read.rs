//! `glReadPixels`: GL 2.1, section 4.3.2.

use crate::base::args::DataOut;
use crate::base::constants::*;
use crate::base::error::{Result, invalid_operation, not_negative};
use crate::base::types::*;
use crate::calls::texture::specify::kinds_match;
use crate::context::Context;
use crate::context::window::{Region, Visible, format_of};
use crate::draw::completeness::{Readable, read_attachment};
use crate::draw::warnings::visibility;
use crate::pixel::client::Pixel;
use crate::pixel::client::format::{ClientFormat, LuminanceOf};
use crate::pixel::convert::{Conversion, Final};
use crate::pixel::layout::{Extent, Layout};
use crate::pixel::transfer::TransferKind;
use rasterizer::driver::{Attachment, Device, RowSpan, RowWriter};
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::Level;

const SECTION: &str = "GL 2.1, section 4.3.2";

/// A slice of a level that is read from.
pub(crate) struct Pixels {
    level: Arc<Level>,
    slice: usize,
}

impl Pixels {
    /// Those of an attachment, as everything submitted leaves them.
    fn of(device: &Device, attachment: &Attachment) -> Option<Self> {
        device.resolved(attachment).map(|(level, slice)| Self { level, slice })
    }

    /// How its texels are stored.
    pub fn format(&self) -> Format {
        self.level.format
    }

    /// Pixels across and up.
    pub fn size(&self) -> [u32; 2] {
        [self.level.width, self.level.height]
    }

    /// The texels of a row from column `x` on, `width` of them.
    pub fn row(&self, x: usize, y: usize, width: usize) -> &[u8] {
        self.level.run([x, y, self.slice], width)
    }
}

/// The pixels of an attachment as everything recorded leaves them.
pub(crate) fn settled(context: &mut Context, attachment: &Attachment) -> Option<Pixels> {
    crate::draw::pass::settle(context, &attachment.image);
    Pixels::of(&context.recorder.device(), attachment)
}

/// The pixels of every sample of an attachment, as everything recorded leaves them.
pub(crate) fn settled_samples(context: &mut Context, attachment: &Attachment) -> Vec<Pixels> {
    let Attachment { image, face, level } = attachment;
    crate::draw::pass::settle(context, image);
    let Some(level) = image.each_sample(*face, *level).map(Arc::new) else { return Vec::new() };
    (0..level.depth as usize).map(|slice| Pixels { level: Arc::clone(&level), slice }).collect()
}

/// What is read from, which is there, and its format.
///
/// # Errors
/// Where the framebuffer is incomplete, has several samples a pixel, or has no such buffer.
fn readable(context: &Context, what: Readable) -> Result<(Attachment, Format)> {
    check_samples(context)?;
    let attachment = read_attachment(context, what)?;
    match attachment
        .and_then(|attachment| format_of(&attachment).map(|format| (attachment, format)))
    {
        Some(found) => Ok(found),
        None => invalid_operation(SECTION, nothing_there(context, what)),
    }
}

/// The pixels that are read from.
///
/// # Errors
/// As those of [`readable`].
pub(crate) fn source(context: &mut Context, what: Readable) -> Result<Pixels> {
    let (attachment, _) = readable(context, what)?;
    match settled(context, &attachment) {
        Some(pixels) => Ok(pixels),
        None => invalid_operation(SECTION, nothing_there(context, what)),
    }
}

/// What is missing in the framebuffer that is read from, and what to do about it.
fn nothing_there(context: &Context, what: Readable) -> String {
    let name = context.state.bindings.read_framebuffer;
    let object = context.objects.framebuffers.get(name);
    let kind = match what {
        Readable::Depth => "depth",
        Readable::Stencil => "stencil",
        Readable::Color => {
            let read = object.map_or(context.window.selection.read, |object| object.selection.read);
            let first = object.and_then(|object| object.colors.iter().position(Option::is_some));
            let fix = match (object, first) {
                (None, _) => "call glReadBuffer(GL_BACK)".to_owned(),
                (Some(_), Some(first)) => format!("call glReadBuffer(GL_COLOR_ATTACHMENT{first})"),
                (Some(_), None) => "no colour is attached at all".to_owned(),
            };
            return match read {
                GL_NONE => format!("framebuffer {name} reads GL_NONE: {fix}"),
                _ => format!(
                    "framebuffer {name} reads {}, where nothing is attached: {fix}",
                    enum_name(read)
                ),
            };
        }
    };
    match object {
        Some(_) => format!(
            "framebuffer {name}, which is read from, has nothing attached to GL_{}_ATTACHMENT",
            kind.to_ascii_uppercase()
        ),
        None => format!("the default framebuffer, which is read from, has no {kind} buffer"),
    }
}

/// Refuses to read from several samples a pixel (`EXT_framebuffer_multisample`, section 4.3.2).
fn check_samples(context: &Context) -> Result<()> {
    let name = context.state.bindings.read_framebuffer;
    if name != 0 && crate::draw::completeness::samples(context, name) > 0 {
        return invalid_operation(
            "EXT_framebuffer_multisample, section 4.3.2",
            format!("framebuffer {name} has several samples a pixel: call glBlitFramebuffer first"),
        );
    }
    Ok(())
}

/// What a pixel of the client's is read from.
fn chosen(context: &Context, format: ClientFormat) -> Result<(Attachment, Format)> {
    match format.kind() {
        TransferKind::Depth => readable(context, Readable::Depth),
        TransferKind::Stencil => readable(context, Readable::Stencil),
        TransferKind::DepthStencil => {
            readable(context, Readable::Stencil)?;
            readable(context, Readable::Depth)
        }
        TransferKind::Color | TransferKind::ColorIndex => readable(context, Readable::Color),
    }
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn read_pixels(
    context: &mut Context,
    x: GLint,
    y: GLint,
    width: GLsizei,
    height: GLsizei,
    format: GLenum,
    ty: GLenum,
    pixels: DataOut<'_>,
) -> Result<()> {
    let width = not_negative(SECTION, "width", width.into())?;
    let height = not_negative(SECTION, "height", height.into())?;
    let pixel = Pixel::new(format, ty)?;
    if pixel.format == ClientFormat::ColorIndex {
        return invalid_operation(
            SECTION,
            "format = GL_COLOR_INDEX: the framebuffer has colours, no indices",
        );
    }
    let layout = Layout::new(&context.state.pack, pixel, [width, height, 1], Extent::Flat)?;
    let (attachment, from) = chosen(context, pixel.format)?;
    if pixel.format != ClientFormat::Stencil {
        kinds_match(pixel, from)?;
    }
    let region = Region::new(x, y, width, height);
    let transfer = context.state.transfer;
    let mut last = Final::of(from, LuminanceOf::Sum);
    if !pixel.format.is_depth() && !from.is_integer() {
        last.clamp = crate::draw::color_clamp::of_reading(context, from);
    }
    crate::draw::pass::settle(context, &attachment.image);
    visibility::picture(context);
    let device = context.recorder.device();
    let isa = context.recorder.isa();
    // Pixels outside are left as they are.
    let visible = attachment.size().and_then(|[width, height]| region.within(width, height));
    crate::calls::pixels::memory::write_pixels(context, &layout, pixels, |bytes| {
        let Some(visible) = visible else { return };
        let column = (visible.x as i64 - region.x) as usize;
        let row = (visible.y as i64 - region.y) as usize;
        let run = layout.run(column, row, visible.width);
        let conversion = Conversion::pack(isa, &run, from, &transfer, last);
        let convert = |texels: &[u8], out: &mut [u8]| conversion.pack_row(&run, texels, out);
        let writer =
            if conversion.is_copy(&run) { RowWriter::Copy } else { RowWriter::Convert(&convert) };
        let (stride, row_bytes) = (run.stride, run.row_bytes());
        let end = run.start + (visible.height - 1) * stride + row_bytes;
        let (bytes, up) = (&mut bytes[run.start..end], Up::Y);
        let to = ClientRows { bytes, stride, row_bytes, up };
        read_rows(&device, &attachment, visible, to, writer);
    })
}

/// Which row comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Up {
    /// The lowest.
    Y,
    /// The highest.
    NotY,
}

/// Where a client has its rows: the first byte of each so many after that of the one before.
pub(crate) struct ClientRows<'a> {
    pub bytes: &'a mut [u8],
    pub stride: usize,
    pub row_bytes: usize,
    pub up: Up,
}

/// Puts the pixels of an attachment, as everything submitted leaves them, where a client has its rows.
pub(crate) fn read_rows(
    device: &Device,
    attachment: &Attachment,
    visible: Visible,
    to: ClientRows<'_>,
    writer: RowWriter<'_>,
) {
    let ClientRows { bytes, stride, row_bytes, up } = to;
    let [x, y, width] = [visible.x, visible.y, visible.width].map(|at| at as u32);
    if stride < row_bytes {
        // They overlap, and the last one stays.
        for (row, y) in (y..).take(visible.height).enumerate() {
            let at = match up {
                Up::Y => row,
                Up::NotY => visible.height - 1 - row,
            };
            let out = &mut bytes[at * stride..][..row_bytes];
            device.read(attachment, RowSpan { x, y, width }, &mut [out], writer);
        }
    } else {
        let mut rows: Vec<&mut [u8]> = bytes.chunks_mut(stride).collect();
        if up == Up::NotY {
            rows.reverse();
        }
        device.read(attachment, RowSpan { x, y, width }, &mut rows, writer);
    }
}

/// Whether signed integers go to signed ones, unsigned to unsigned and other numbers to others, as a blit needs.
pub(crate) fn same_kind(a: Format, b: Format) -> bool {
    let kind = |format: Format| {
        (format.is_integer()).then(|| format.info().encoding == texunit::format::Encoding::Sint)
    };
    kind(a) == kind(b)
}
