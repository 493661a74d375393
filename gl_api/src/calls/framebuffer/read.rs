//! `glReadPixels`: GL 2.1, section 4.3.2.

use crate::base::args::DataOut;
use crate::base::constants::*;
use crate::base::error::{Result, invalid_operation, not_negative};
use crate::base::types::*;
use crate::calls::texture::specify::kinds_match;
use crate::context::Context;
use crate::context::window::{Region, Visible, format_of};
use crate::draw::completeness::{Aspect, read_attachment};
use crate::draw::implicit_samples::samples_to_resolve;
use crate::draw::warnings;
use crate::pixel::client::Pixel;
use crate::pixel::client::format::{ClientFormat, LuminanceOf};
use crate::pixel::convert::{Conversion, FinalConversion};
use crate::pixel::es_texels;
use crate::pixel::layout::{Extent, Layout};
use crate::pixel::scratch::scratch;
use crate::pixel::storage_error::storage_error;
use crate::pixel::transfer::TransferKind;
use rasterizer::driver::{Attachment, Device, RowSpan, RowWriter};
use std::sync::Arc;
use texunit::format::{BaseFormat, Encoding, Format};
use texunit::image::{ImageError, Level};

const SECTION: &str = "GL 2.1, section 4.3.2";

/// A slice of a level that is read from.
pub(crate) struct Pixels {
    level: Arc<Level>,
    slice: usize,
}

impl Pixels {
    /// Those of an attachment, as everything submitted leaves them.
    fn of(device: &Device, attachment: &Attachment) -> std::result::Result<Self, ImageError> {
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
        self.level.row_span([x, y, self.slice], width)
    }

    /// The texels of a region, tightly packed; zeros where it lies outside.
    pub fn region(&self, region: Region) -> Result<Vec<u8>> {
        let size = self.format().bytes();
        let mut texels = scratch(self.format(), [region.width, region.height, 1])?;
        let [width, height] = self.size();
        if let Some(visible) = region.within(width, height) {
            for y in visible.y..visible.y + visible.height {
                let row = self.row(visible.x, y, visible.width);
                let at = ((y as i64 - region.y) as usize * region.width
                    + (visible.x as i64 - region.x) as usize)
                    * size;
                texels[at..at + row.len()].copy_from_slice(row);
            }
        }
        Ok(texels)
    }
}

/// The pixels of an attachment as everything recorded leaves them.
///
/// # Errors
/// When there is no memory for them.
pub(crate) fn resolved_pixels(context: &mut Context, attachment: &Attachment) -> Result<Pixels> {
    crate::draw::pass::submit_draws_to(context, &attachment.image);
    let pixels = Pixels::of(&context.recorder.device(), attachment);
    pixels.map_err(|error| storage_error(SECTION, &error))
}

/// The pixels of every sample of an attachment, as everything recorded leaves them.
///
/// # Errors
/// When there is no memory for them.
pub(crate) fn sample_pixels(context: &mut Context, attachment: &Attachment) -> Result<Vec<Pixels>> {
    crate::draw::pass::submit_draws_to(context, &attachment.image);
    let level = attachment.each_sample();
    let level = Arc::new(level.map_err(|error| storage_error(SECTION, &error))?);
    Ok((0..level.depth as usize).map(|slice| Pixels { level: Arc::clone(&level), slice }).collect())
}

/// A buffer of the framebuffer that is read from: it is there, and has one sample a pixel.
pub(crate) struct ReadBuffer {
    attachment: Attachment,
    pub format: Format,
}

impl ReadBuffer {
    /// # Errors
    /// Where the framebuffer is incomplete, has several samples a pixel, or has no such buffer.
    pub fn new(context: &Context, aspect: Aspect) -> Result<Self> {
        check_samples(context, aspect)?;
        let attachment = read_attachment(context, aspect)?;
        let found = attachment.and_then(|found| format_of(&found).map(|format| (found, format)));
        match found {
            Some((attachment, format)) => Ok(Self { attachment, format }),
            None => invalid_operation(SECTION, nothing_there(context, aspect)),
        }
    }

    /// Depths with stencils, which one image has.
    pub fn depth_stencil(context: &Context) -> Result<Self> {
        Self::new(context, Aspect::Stencil)?;
        Self::new(context, Aspect::Depth)
    }

    /// Its pixels as everything recorded leaves them.
    pub fn pixels(&self, context: &mut Context) -> Result<Pixels> {
        resolved_pixels(context, &self.attachment)
    }
}

/// What is missing in the framebuffer that is read from, and what to do about it.
fn nothing_there(context: &Context, aspect: Aspect) -> String {
    let name = context.state.bindings.read_framebuffer;
    let object = context.objects.framebuffers.get(name);
    let kind = match aspect {
        Aspect::Depth => "depth",
        Aspect::Stencil => "stencil",
        Aspect::Color => {
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
fn check_samples(context: &Context, aspect: Aspect) -> Result<()> {
    let name = context.state.bindings.read_framebuffer;
    if name != 0 && samples_to_resolve(context, name, aspect) > 0 {
        return invalid_operation(
            "EXT_framebuffer_multisample, section 4.3.2",
            format!("framebuffer {name} has several samples a pixel: call glBlitFramebuffer first"),
        );
    }
    Ok(())
}

/// A checked `glReadPixels`; the memory is checked when the pixels are written to it.
pub(crate) struct ReadPixelsRequest {
    buffer: ReadBuffer,
    region: Region,
    layout: Layout,
    final_conversion: FinalConversion,
}

impl ReadPixelsRequest {
    fn new(context: &Context, region: Region, pixel: Pixel) -> Result<Self> {
        if pixel.format == ClientFormat::ColorIndex {
            return invalid_operation(
                SECTION,
                "format = GL_COLOR_INDEX: the framebuffer has colours, no indices",
            );
        }
        let size = [region.width, region.height, 1];
        let layout = Layout::new(&context.state.pack, pixel, size, Extent::Flat)?;
        let buffer = match pixel.format.kind() {
            TransferKind::Depth => ReadBuffer::new(context, Aspect::Depth)?,
            TransferKind::Stencil => ReadBuffer::new(context, Aspect::Stencil)?,
            TransferKind::DepthStencil => ReadBuffer::depth_stencil(context)?,
            TransferKind::Color | TransferKind::ColorIndex => {
                ReadBuffer::new(context, Aspect::Color)?
            }
        };
        let from = buffer.format;
        if pixel.format != ClientFormat::Stencil {
            kinds_match(pixel, from, GL_NONE)?;
        }
        let mut final_conversion = FinalConversion::of(from, LuminanceOf::Sum);
        if !pixel.format.is_depth() && !from.is_integer() {
            final_conversion.clamp = crate::draw::color_clamp::of_reading(context, from);
        }
        Ok(Self { buffer, region, layout, final_conversion })
    }

    /// The bytes from the first pixel to the end of the last, with the client's row length and alignment.
    pub fn needed(&self) -> usize {
        self.layout.needed
    }

    /// # Errors
    /// Where the memory is none, or too short.
    pub fn apply(&self, context: &mut Context, pixels: DataOut<'_>) -> Result<()> {
        let &Self {
            buffer: ReadBuffer { ref attachment, format, .. },
            region,
            ref layout,
            final_conversion,
        } = self;
        crate::draw::pass::submit_draws_to(context, &attachment.image);
        warnings::picture::read(context, attachment);
        warnings::visibility::picture(context);
        crate::draw::pass::end_of_frame(context);
        let (device, isa) = (context.recorder.device(), context.recorder.isa());
        let transfer = context.state.transfer;
        // Pixels outside are left as they are.
        let visible = attachment.size().and_then(|[width, height]| region.within(width, height));
        crate::calls::pixels::memory::write_pixels(context, layout, pixels, |bytes| {
            let Some(visible) = visible else { return };
            let column = (visible.x as i64 - region.x) as usize;
            let row = (visible.y as i64 - region.y) as usize;
            let run = layout.run(column, row, visible.width);
            let conversion = Conversion::pack(isa, &run, format, &transfer, final_conversion);
            let convert = |texels: &[u8], out: &mut [u8]| conversion.pack_row(&run, texels, out);
            let writer = if conversion.is_copy(&run) {
                RowWriter::Copy
            } else {
                RowWriter::Convert(&convert)
            };
            let (stride, row_bytes) = (run.stride, run.row_bytes());
            let end = run.start + (visible.height - 1) * stride + row_bytes;
            let (bytes, order) = (&mut bytes[run.start..end], RowOrder::BottomUp);
            let to = ClientRows { bytes, stride, row_bytes, order };
            read_rows(&device, attachment, visible, to, writer);
        })
    }
}

/// The `format` and `type` that the read buffer is best read with: `GL_IMPLEMENTATION_COLOR_READ_FORMAT` and
/// `GL_IMPLEMENTATION_COLOR_READ_TYPE` (OpenGL ES 3.0, section 4.3.2).
pub(crate) fn preferred(from: Format) -> (GLenum, GLenum) {
    let info = from.info();
    let format = match (from.base(), from.is_integer()) {
        (BaseFormat::Red, false) => GL_RED,
        (BaseFormat::Red, true) => GL_RED_INTEGER,
        (BaseFormat::Rg, false) => GL_RG,
        (BaseFormat::Rg, true) => GL_RG_INTEGER,
        (BaseFormat::Rgb, false) => GL_RGB,
        (_, true) => GL_RGBA_INTEGER,
        (_, false) => GL_RGBA,
    };
    let ty = match (from, info.encoding) {
        (Format::Rgb10A2 | Format::Rgb10A2UI, _) => GL_UNSIGNED_INT_2_10_10_10_REV,
        (Format::R5G6B5, _) => GL_UNSIGNED_SHORT_5_6_5,
        (Format::Rgba4, _) => GL_UNSIGNED_SHORT_4_4_4_4,
        (Format::Rgb5A1, _) => GL_UNSIGNED_SHORT_5_5_5_1,
        (_, Encoding::Float) => GL_FLOAT,
        (_, Encoding::Sint) => GL_INT,
        (_, Encoding::Uint) => GL_UNSIGNED_INT,
        (_, _) => GL_UNSIGNED_BYTE,
    };
    (format, ty)
}

/// Checks that OpenGL ES reads a buffer as such pixels: each kind of numbers as `GL_RGBA` of one type, or as the
/// implementation prefers (3.0, section 4.3.2; `EXT_read_format_bgra`).
fn check_es(from: Format, (format, ty): (GLenum, GLenum)) -> Result<()> {
    let always: &[(GLenum, GLenum)] = match from.info().encoding {
        Encoding::Sint => &[(GL_RGBA_INTEGER, GL_INT)],
        Encoding::Uint => &[(GL_RGBA_INTEGER, GL_UNSIGNED_INT)],
        Encoding::Float => &[(GL_RGBA, GL_FLOAT)],
        Encoding::Unorm if from == Format::Rgb10A2 => {
            &[(GL_RGBA, GL_UNSIGNED_BYTE), (GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV)]
        }
        Encoding::Unorm
        | Encoding::Snorm
        | Encoding::Srgb
        | Encoding::SharedExponent
        | Encoding::Block(_)
        | Encoding::SrgbBlock(_) => &[(GL_RGBA, GL_UNSIGNED_BYTE), (GL_BGRA, GL_UNSIGNED_BYTE)],
    };
    if always.contains(&(format, ty)) || preferred(from) == (format, ty) {
        return Ok(());
    }
    let (other_format, other_type) = preferred(from);
    let all = always.iter().copied().chain([(other_format, other_type)]);
    let all: Vec<String> =
        all.map(|(format, ty)| format!("{} with {}", enum_name(format), enum_name(ty))).collect();
    let [format, ty] = [format, ty].map(enum_name);
    let rule = format!(
        "format = {format} with type = {ty}: OpenGL ES reads this buffer as {}",
        all.join(" or ")
    );
    invalid_operation("OpenGL ES 3.0, section 4.3.2", rule)
}

/// Checks the arguments of `glReadPixels`: the lowest left pixel, pixels across and up, and format and type.
///
/// # Errors
/// As `glReadPixels`, but of the memory.
pub(crate) fn request(
    context: &Context,
    [x, y]: [GLint; 2],
    [width, height]: [GLsizei; 2],
    (format, ty): (GLenum, GLenum),
) -> Result<ReadPixelsRequest> {
    let width = not_negative(SECTION, "width", width.into())?;
    let height = not_negative(SECTION, "height", height.into())?;
    let is_es = context.profile.is_es();
    let pixel = if is_es { Pixel::new_in_es(format, ty) } else { Pixel::new(format, ty) }?;
    let request = ReadPixelsRequest::new(context, Region::new(x, y, width, height), pixel)?;
    if is_es {
        check_es(request.buffer.format, (format, es_texels::plain_type(ty)))?;
    }
    Ok(request)
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
    request(context, [x, y], [width, height], (format, ty))?.apply(context, pixels)
}

/// Which row comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RowOrder {
    /// The lowest.
    BottomUp,
    /// The highest.
    TopDown,
}

/// Where a client has its rows: the first byte of each so many after that of the one before.
pub(crate) struct ClientRows<'a> {
    pub bytes: &'a mut [u8],
    pub stride: usize,
    pub row_bytes: usize,
    pub order: RowOrder,
}

/// Puts the pixels of an attachment, as everything submitted leaves them, where a client has its rows.
pub(crate) fn read_rows(
    device: &Device,
    attachment: &Attachment,
    visible: Visible,
    to: ClientRows<'_>,
    writer: RowWriter<'_>,
) {
    let ClientRows { bytes, stride, row_bytes, order } = to;
    let [x, y, width] = [visible.x, visible.y, visible.width].map(|at| at as u32);
    if stride < row_bytes {
        // They overlap, and the last one stays.
        for (row, y) in (y..).take(visible.height).enumerate() {
            let at = match order {
                RowOrder::BottomUp => row,
                RowOrder::TopDown => visible.height - 1 - row,
            };
            let out = &mut bytes[at * stride..][..row_bytes];
            device.read(attachment, RowSpan { x, y, width }, &mut [out], writer);
        }
    } else {
        let mut rows: Vec<&mut [u8]> = bytes.chunks_mut(stride).collect();
        if order == RowOrder::TopDown {
            rows.reverse();
        }
        device.read(attachment, RowSpan { x, y, width }, &mut rows, writer);
    }
}

/// Whether signed integers go to signed ones, unsigned to unsigned and other numbers to others, as a blit needs.
pub(crate) fn same_kind(a: Format, b: Format) -> bool {
    let kind =
        |format: Format| (format.is_integer()).then(|| format.info().encoding == Encoding::Sint);
    kind(a) == kind(b)
}
