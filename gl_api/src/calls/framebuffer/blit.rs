//! `glBlitFramebuffer`: `ARB_framebuffer_object`, section 4.3.3.
//!
//! Where both sides have several samples a pixel, samples go to samples; a multisample image is else
//! read as what it resolves to, and every sample of one is written alike.

pub(crate) mod rows;

use crate::base::constants::*;
use crate::base::error::{Result, Table, invalid_operation, invalid_value};
use crate::base::memory::out_of_memory;
use crate::base::types::*;
use crate::calls::framebuffer::blit::rows::{RowConversion, reserved};
use crate::calls::framebuffer::es_blit;
use crate::calls::framebuffer::read::{Pixels, resolved_pixels, same_kind, sample_pixels};
use crate::context::Context;
use crate::context::profile::Profile;
use crate::context::window::format_of;
use crate::draw::completeness::{
    Aspect, checked_complete, draw_pass_of, draw_planes_of, read_attachment_of, read_samples,
    samples,
};
use crate::draw::pass::drawn_area;
use crate::draw::pipeline::srgb_write;
use crate::pixel::formats::format_name;
use crate::pixel::storage_error::storage_error;
use crate::pixel::texel;
use rasterizer::driver::{Attachment, Rect};
use texunit::format::Format;
use texunit::image::Level;
use texunit::pixel::Tap;
use texunit::sampler::Filter;

const SECTION: &str = "ARB_framebuffer_object, section 4.3.3";

const FILTER: Table<BlitFilter> = Table {
    section: SECTION,
    rows: &[
        (GL_NEAREST, BlitFilter::Plain(Filter::Nearest)),
        (GL_LINEAR, BlitFilter::Plain(Filter::Linear)),
        (GL_SCALED_RESOLVE_FASTEST_EXT, BlitFilter::ScaledResolve),
        (GL_SCALED_RESOLVE_NICEST_EXT, BlitFilter::ScaledResolve),
    ],
};

/// How pixels of the source become pixels of another size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum BlitFilter {
    Plain(Filter),
    /// Samples are resolved, and what that gives is filtered linearly (`EXT_framebuffer_multisample_blit_scaled`).
    ScaledResolve,
}

impl BlitFilter {
    fn of_resolved(self) -> Filter {
        match self {
            Self::Plain(filter) => filter,
            Self::ScaledResolve => Filter::Linear,
        }
    }
}

/// The conversion along one axis: from where to where, on both sides.
#[derive(Clone, Copy)]
struct Axis {
    src: [GLint; 2],
    dst: [GLint; 2],
}

/// What pixels that lie side by side are made of.
struct Taps {
    /// How many pixels before them lie outside of the source.
    before: usize,
    taps: Vec<Tap>,
}

impl Axis {
    /// The pixels of the destination from `first` on, `count` of them, as texels of a source of
    /// `size`, without those that lie outside of it.
    ///
    /// # Errors
    /// When there is no memory for them.
    fn taps(self, first: i32, count: u32, size: u32, filter: Filter) -> Result<Taps> {
        let [src0, src1] = self.src.map(i128::from);
        let [dst0, dst1] = self.dst.map(i128::from);
        // The source of the pixel's centre, in units of 1 / 2n texels.
        let units = 2 * (dst1 - dst0);
        let tap = |pixel: i32| {
            let at = (2 * (i128::from(pixel) - dst0) + 1) * (src1 - src0) + src0 * units;
            let (at, units) = if units < 0 { (-at, -units) } else { (at, units) };
            let nearest = at.div_euclid(units);
            let last = i128::from(size) - 1;
            if nearest < 0 || nearest > last {
                return None;
            }
            Some(match filter {
                Filter::Nearest => Tap { pixels: [nearest as usize; 2], weight: 0.0 },
                Filter::Linear => {
                    let at = at - units / 2;
                    let low = at.div_euclid(units);
                    let clamped = |texel: i128| texel.clamp(0, last) as usize;
                    Tap {
                        pixels: [clamped(low), clamped(low + 1)],
                        weight: at.rem_euclid(units) as f64 / units as f64,
                    }
                }
            })
        };
        let taps = (first..).take(count as usize).map(tap);
        // Those that lie within lie side by side.
        let before = taps.clone().take_while(Option::is_none).count();
        let mut within = reserved(count as usize).map_err(out_of_memory(SECTION, "its pixels"))?;
        within.extend(taps.flatten());
        Ok(Taps { before, taps: within })
    }

    /// First pixel of the destination, and one past the last.
    fn covered(self) -> [GLint; 2] {
        let [a, b] = self.dst;
        [a.min(b), a.max(b)]
    }

    fn is_empty(self) -> bool {
        self.src[0] == self.src[1] || self.dst[0] == self.dst[1]
    }

    fn is_scaled(self) -> bool {
        let length = |[a, b]: [GLint; 2]| i64::from(a).abs_diff(b.into());
        length(self.src) != length(self.dst)
    }
}

/// The names of the framebuffers that a blit reads and writes; 0 is the default one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Sides {
    pub read: GLuint,
    pub draw: GLuint,
}

/// A checked `glBlitFramebuffer`.
struct BlitRequest {
    axes: [Axis; 2],
    filter: Filter,
    /// Pixels across and up that the draw framebuffer has, within the scissor rectangle.
    drawn: Rect,
    copies: Vec<AspectCopy>,
}

/// Where an aspect is copied from and to.
struct AspectCopy {
    aspect: Aspect,
    from: Attachment,
    to: Vec<Attachment>,
}

impl AspectCopy {
    /// The pixels of the source, of every sample where both sides have several.
    ///
    /// # Errors
    /// When there is no memory for them.
    fn pixels(&self, context: &mut Context) -> Result<Vec<Pixels>> {
        let several = |attachment: &Attachment| attachment.sample_count() > 1;
        if several(&self.from) && self.to.iter().any(several) {
            sample_pixels(context, &self.from)
        } else {
            Ok(vec![resolved_pixels(context, &self.from)?])
        }
    }
}

/// What is written to an attachment, with the memory that it takes.
struct AttachmentWrite<'a> {
    /// Of every sample, or a sample each.
    from: &'a [Pixels],
    to: &'a Attachment,
    columns: Taps,
    rows: Taps,
    conversion: RowConversion<'static>,
}

impl BlitRequest {
    fn new(
        context: &Context,
        sides: Sides,
        axes: [Axis; 2],
        mask: GLbitfield,
        blit_filter: BlitFilter,
    ) -> Result<Self> {
        let filter = blit_filter.of_resolved();
        checked_complete(context, sides.read)?;
        let pass = draw_pass_of(context, sides.draw)?;
        let stays = axes.map(|axis| axis.src == axis.dst);
        if context.profile.is_es() {
            // A blit of nothing is refused as one of colours.
            let read = if mask == 0 { GL_COLOR_BUFFER_BIT } else { mask };
            for (_, aspect) in ASPECTS.iter().filter(|(bit, _)| read & bit != 0) {
                es_blit::check_samples(context, sides, (*aspect, stays))?;
            }
        } else {
            check_samples(context, sides, axes, blit_filter)?;
        }
        let mut copies = Vec::new();
        for (bit, aspect) in ASPECTS {
            if mask & bit == 0 {
                continue;
            }
            // What is missing on either side is left out (section 4.3.3).
            let to = destinations(context, sides.draw, aspect)?;
            let from = read_attachment_of(context, sides.read, aspect)?;
            let Some(from) = from.filter(|_| !to.is_empty()) else { continue };
            let format = format_of(&from);
            for (from, to) in to.iter().filter_map(|to| format.zip(format_of(to))) {
                check_formats(context.profile, aspect, from, to, filter)?;
            }
            if context.profile.is_es() {
                es_blit::check_images(context, sides, (aspect, &from), &to)?;
            }
            copies.push(AspectCopy { aspect, from, to });
        }
        Ok(Self { axes, filter, drawn: drawn_area(context, &pass), copies })
    }

    /// # Errors
    /// When there is no memory. Nothing is written then; where several attachments of several samples are written, those
    /// before the one that has no memory are.
    fn apply(&self, context: &mut Context) -> Result<()> {
        // All sources before anything is written: the framebuffers may share images.
        let pixels = self.copies.iter().map(|copy| copy.pixels(context));
        let pixels = pixels.collect::<Result<Vec<_>>>()?;
        if context.queries.discards() {
            return Ok(());
        }
        let Some(area) = covered(self.axes, self.drawn) else { return Ok(()) };
        let mut writes = Vec::new();
        for (copy, from) in self.copies.iter().zip(&pixels) {
            for to in &copy.to {
                writes.extend(self.write(context, from, to, copy.aspect, area)?);
            }
        }
        writes.into_iter().try_for_each(|write| write.apply(context, area))
    }

    /// What is written to an area of one attachment, from what every sample has or from a sample each.
    fn write<'a>(
        &self,
        context: &mut Context,
        from: &'a [Pixels],
        to: &'a Attachment,
        aspect: Aspect,
        area: Rect,
    ) -> Result<Option<AttachmentWrite<'a>>> {
        let Some((source, format)) = from.first().zip(format_of(to)) else { return Ok(None) };
        let (srgb, isa, [width, height]) =
            (srgb_write(context), context.recorder.isa(), source.size());
        let columns = self.axes[0].taps(area.x, area.width, width, self.filter)?;
        let rows = self.axes[1].taps(area.y, area.height, height, self.filter)?;
        // A copy without scaling and without a fractional offset needs no averaging.
        let is_exact = columns.taps.iter().chain(&rows.taps).all(|tap| tap.weight == 0.0);
        let filter = if is_exact { Filter::Nearest } else { self.filter };
        let conversion = RowConversion::new(isa, (aspect, filter), source, format, srgb)
            .map_err(out_of_memory(SECTION, "rows of pixels"))?;
        prepare_update(context, to)?;
        Ok(Some(AttachmentWrite { from, to, columns, rows, conversion }))
    }
}

impl AttachmentWrite<'_> {
    fn apply(self, context: &mut Context, area: Rect) -> Result<()> {
        let Self { from, to, columns, rows, mut conversion } = self;
        update_attachment_texels(context, to, |level, first, sample| {
            let Some(from) = from.get(sample).or(from.first()) else { return };
            let (format, row_bytes) = (level.format, level.row_bytes());
            let column = (area.x as usize + columns.before) * format.bytes();
            conversion.begin();
            for (y, &tap) in (area.y as usize + rows.before..).zip(&rows.taps) {
                let texels = &mut level.texels[first + y * row_bytes + column..];
                let used = columns.taps.len() * format.bytes();
                conversion.write(from, &columns.taps, tap, &mut texels[..used]);
            }
        })
    }
}

/// Takes the memory that [`update_attachment_texels`] needs of an attachment of one sample a pixel.
fn prepare_update(context: &mut Context, attachment: &Attachment) -> Result<()> {
    crate::draw::pass::submit_draws_to(context, &attachment.image);
    if attachment.sample_count() > 1 {
        return Ok(());
    }
    attachment.prepare_update().map_err(|error| storage_error(SECTION, &error))
}

/// Lets `change` write the texels of an attachment, of one sample after the other: a level, where in
/// its bytes they begin, and the number of the sample.
///
/// # Errors
/// When there is no memory; nothing has changed then.
pub(crate) fn update_attachment_texels(
    context: &mut Context,
    attachment: &Attachment,
    mut change: impl FnMut(&mut Level, usize, usize),
) -> Result<()> {
    let image = &attachment.image;
    prepare_update(context, attachment)?;
    context.outdate_mirror();
    if attachment.sample_count() > 1 {
        edit_samples(context, attachment, change)?;
    } else {
        edit_slice(attachment, |level, first| change(level, first, 0));
    }
    context.objects.images_changed(|other| other.shares_texels(image));
    Ok(())
}

fn edit_samples(
    context: &Context,
    attachment: &Attachment,
    mut change: impl FnMut(&mut Level, usize, usize),
) -> Result<()> {
    let samples = attachment.each_sample();
    let mut level = samples.map_err(|error| storage_error(SECTION, &error))?;
    for sample in 0..level.depth as usize {
        let first = sample * level.slice_bytes();
        change(&mut level, first, sample);
    }
    context.recorder.device().set_each_sample(attachment, &level);
    Ok(())
}

fn edit_slice(attachment: &Attachment, change: impl FnOnce(&mut Level, usize)) {
    attachment.image.update(|texels| {
        let (face, slice) = attachment.face_and_slice(texels.shape());
        if let Some(level) = texels.level_mut(face, attachment.level.into()) {
            let first = level.origin() + slice * level.slice_bytes();
            change(level, first);
        }
    });
}

/// The aspects that the bits of a mask name, in the order in which they are copied.
const ASPECTS: [(GLbitfield, Aspect); 3] = [
    (GL_COLOR_BUFFER_BIT, Aspect::Color),
    (GL_DEPTH_BUFFER_BIT, Aspect::Depth),
    (GL_STENCIL_BUFFER_BIT, Aspect::Stencil),
];

/// The attachments of the draw framebuffer that an aspect goes to.
fn destinations(context: &Context, draw: GLuint, aspect: Aspect) -> Result<Vec<Attachment>> {
    let (pass, planes) = (draw_pass_of(context, draw)?, draw_planes_of(context, draw));
    let depth = |there: bool| pass.depth.clone().filter(|_| there).into_iter().collect();
    Ok(match aspect {
        Aspect::Color => pass.colors.into_iter().flatten().collect(),
        Aspect::Depth => depth(planes.depth),
        Aspect::Stencil => depth(planes.stencil),
    })
}

/// Whether an aspect can go from one format to another with a filter.
fn check_formats(
    profile: Profile,
    aspect: Aspect,
    from: Format,
    to: Format,
    filter: Filter,
) -> Result<()> {
    if aspect != Aspect::Color {
        // OpenGL ES compares the formats of depth and stencil together (3.0, section 4.3.3); OpenGL's drivers compare
        // those of the aspect that is copied. Stencils have eight bits everywhere.
        let is_same = match aspect {
            _ if profile.is_es() => from == to,
            Aspect::Color | Aspect::Stencil => true,
            Aspect::Depth => texel::same_depths(from, to),
        };
        if !is_same {
            return invalid_operation(
                SECTION,
                format!(
                    "depth and stencil are not converted, from {} to {}",
                    format_name(from),
                    format_name(to)
                ),
            );
        }
        return Ok(());
    }
    if !same_kind(from, to) {
        return invalid_operation(
            SECTION,
            format!(
                "{} is not converted to {}: integers stay integers of their kind",
                format_name(from),
                format_name(to)
            ),
        );
    }
    if filter == Filter::Linear && from.is_integer() {
        return invalid_operation(
            SECTION,
            "filter is not GL_NEAREST, but integers are not filtered",
        );
    }
    Ok(())
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn blit_framebuffer(
    context: &mut Context,
    src_x0: GLint,
    src_y0: GLint,
    src_x1: GLint,
    src_y1: GLint,
    dst_x0: GLint,
    dst_y0: GLint,
    dst_x1: GLint,
    dst_y1: GLint,
    mask: GLbitfield,
    filter: GLenum,
) -> Result<()> {
    let bindings = &context.state.bindings;
    let sides = Sides { read: bindings.read_framebuffer, draw: bindings.draw_framebuffer };
    let (src, dst) = ([src_x0, src_y0, src_x1, src_y1], [dst_x0, dst_y0, dst_x1, dst_y1]);
    blit(context, sides, (src, dst), mask, filter)
}

/// Copies a rectangle of one framebuffer to another one.
pub(crate) fn blit(
    context: &mut Context,
    sides: Sides,
    ([src_x0, src_y0, src_x1, src_y1], [dst_x0, dst_y0, dst_x1, dst_y1]): ([GLint; 4], [GLint; 4]),
    mask: GLbitfield,
    filter: GLenum,
) -> Result<()> {
    let known = ASPECTS.iter().fold(0, |known, part| known | part.0);
    if mask & !known != 0 {
        return invalid_value(
            SECTION,
            format!("mask = {mask:#x} has bits that name no buffer: {:#x}", mask & !known),
        );
    }
    let (name, blit_filter) = (filter, FILTER.decode("filter", filter)?);
    let filter = blit_filter.of_resolved();
    crate::draw::pass::charge_surface(context);
    if filter == Filter::Linear && mask & !GL_COLOR_BUFFER_BIT != 0 {
        return invalid_operation(
            SECTION,
            format!(
                "filter = {}, but depth and stencil are copied with GL_NEAREST",
                enum_name(name)
            ),
        );
    }
    let axes = [
        Axis { src: [src_x0, src_x1], dst: [dst_x0, dst_x1] },
        Axis { src: [src_y0, src_y1], dst: [dst_y0, dst_y1] },
    ];
    BlitRequest::new(context, sides, axes, mask, blit_filter)?.apply(context)?;
    if mask & !GL_COLOR_BUFFER_BIT != 0 {
        context.depth_stencil_copied();
    }
    Ok(())
}

/// Several samples are resolved, not scaled (`EXT_framebuffer_multisample`, section 4.3.3), but by a filter that does both.
fn check_samples(
    context: &Context,
    sides: Sides,
    axes: [Axis; 2],
    filter: BlitFilter,
) -> Result<()> {
    let drawn = samples(context, sides.draw);
    if filter == BlitFilter::ScaledResolve {
        const SECTION: &str = "EXT_framebuffer_multisample_blit_scaled, section 4.3.3";
        let rule = match (read_samples(context, sides.read), drawn) {
            (0, _) => {
                "filter = GL_SCALED_RESOLVE_*, but the read framebuffer has one sample a pixel: take GL_LINEAR"
            }
            (_, 0) => return Ok(()),
            (_, _) => {
                "filter = GL_SCALED_RESOLVE_*, but the draw framebuffer has several samples a pixel, too"
            }
        };
        return invalid_operation(SECTION, rule);
    }
    if (drawn > 0 || read_samples(context, sides.read) > 0)
        && axes.iter().any(|axis| axis.is_scaled())
    {
        return invalid_operation(
            "EXT_framebuffer_multisample, section 4.3.3",
            "a framebuffer with several samples a pixel is not scaled: make both rectangles the \
             same size, or resolve with GL_SCALED_RESOLVE_NICEST_EXT",
        );
    }
    Ok(())
}

/// The pixels that a blit writes, if any.
fn covered(axes: [Axis; 2], drawn: Rect) -> Option<Rect> {
    if axes.iter().any(|axis| axis.is_empty()) {
        return None;
    }
    let within = |axis: Axis, start: i32, size: u32| {
        let [first, end] = axis.covered();
        let (first, end) = (first.max(start), end.min(start + size as i32));
        (first < end).then_some((first, (end - first) as u32))
    };
    let (x, width) = within(axes[0], drawn.x, drawn.width)?;
    let (y, height) = within(axes[1], drawn.y, drawn.height)?;
    Some(Rect { x, y, width, height })
}
