//! `glCopyImageSubData`: texels as they are stored, between textures and renderbuffers (`ARB_copy_image`).

use crate::base::constants::*;
use crate::base::error::{Result, invalid_enum, invalid_operation, invalid_value, not_negative};
use crate::base::types::*;
use crate::calls::texture::bound::bindable;
use crate::calls::texture::stored_level::{Owner, StoredLevel, UnitBox};
use crate::context::Context;
use crate::objects::target::TextureTarget;
use crate::pixel::formats::format_name;
use rasterizer::driver::Image;
use texunit::format::{BaseFormat, Format};

const SECTION: &str = "ARB_copy_image, section 18.3.2";

/// What the arguments of one side are named by.
#[derive(Clone, Copy)]
enum Side {
    Source,
    Destination,
}

impl Side {
    fn prefix(self) -> &'static str {
        match self {
            Self::Source => "src",
            Self::Destination => "dst",
        }
    }
}

/// The arguments that name an image and a place in it.
struct ImageArguments {
    side: Side,
    name: GLuint,
    target: GLenum,
    level: GLint,
    at: [GLint; 3],
}

impl ImageArguments {
    /// The level, checked but for the region.
    fn stored(&self, context: &mut Context) -> Result<StoredLevel> {
        let prefix = self.side.prefix();
        let &Self { name, target, level, .. } = self;
        let target_is_wrong = || {
            let target = enum_name(target);
            invalid_enum(
                SECTION,
                format!(
                    "{prefix}Target = {target} must be GL_RENDERBUFFER, or the target of the texture, other than \
                     GL_TEXTURE_BUFFER"
                ),
            )
        };
        // The image, and its base level.
        let (owner, image, is_known) = if target == GL_RENDERBUFFER {
            let renderbuffers = &context.objects.shared.renderbuffers;
            let image = renderbuffers.get(name).map(|found| (found.image.clone(), 0));
            (Owner::Renderbuffer, image, renderbuffers.is_reserved(name))
        } else {
            let wanted = bindable(context.profile)
                .get(target)
                .filter(|target| *target != TextureTarget::Buffer);
            let Some(wanted) = wanted else { return target_is_wrong() };
            let textures = &context.objects.shared.textures;
            let found = textures.get(name);
            if found.is_some_and(|texture| texture.target != wanted) {
                return target_is_wrong();
            }
            let image =
                found.map(|texture| (texture.image.clone(), texture.sampler().base_level as usize));
            (Owner::Texture(name, wanted), image, textures.is_reserved(name))
        };
        if name == 0 || !is_known {
            return invalid_value(
                SECTION,
                format!("{prefix}Name = {name} is no object of its target"),
            );
        }
        let has_base = |(image, base): &(Image, usize)| image.level(0, *base).is_some();
        let Some((image, _)) = image.filter(has_base) else {
            return invalid_operation(
                SECTION,
                format!("{prefix}Name = {name} has no image yet: give it storage first"),
            );
        };
        let found = usize::try_from(level).ok();
        match found.and_then(|level| StoredLevel::new(context, owner, &image, level)) {
            Some(stored) => Ok(stored),
            None => invalid_value(SECTION, format!("{prefix}Level = {level} has no image")),
        }
    }

    /// Checks a region in texels, which a compressed image takes as whole blocks.
    fn check_region(&self, stored: &StoredLevel, size: [u64; 3]) -> Result<()> {
        let prefix = self.side.prefix();
        let side = u64::from(stored.format.block_side());
        for (axis, letter) in ["X", "Y", "Z"].into_iter().enumerate() {
            let (at, level) = (self.at[axis], u64::from(stored.size[axis]));
            let block = if axis < 2 { side } else { 1 };
            let Ok(start) = u64::try_from(at) else {
                return invalid_value(
                    SECTION,
                    format!("{prefix}{letter} = {at} must not be negative"),
                );
            };
            let end = start + size[axis];
            if end > level.next_multiple_of(block) {
                return invalid_value(
                    SECTION,
                    format!(
                        "{prefix}{letter} = {at}: the region ends at {end}, the level has {level}"
                    ),
                );
            }
            if !start.is_multiple_of(block) || !size[axis].is_multiple_of(block) && end != level {
                return invalid_value(
                    SECTION,
                    format!(
                        "{prefix}{letter} = {at} and {} texels cut blocks of {block}",
                        size[axis]
                    ),
                );
            }
        }
        Ok(())
    }

    /// The region in units of storage.
    fn units(&self, stored: &StoredLevel, size: [usize; 3]) -> UnitBox {
        let side = stored.format.block_side() as i32;
        UnitBox { at: [self.at[0] / side, self.at[1] / side, self.at[2]], size }
    }
}

/// Whether a format without blocks is one of table 8.22, whose texels are compatible with all others of their size.
fn is_in_a_view_class(format: Format) -> bool {
    match format.base() {
        BaseFormat::Red | BaseFormat::Rg | BaseFormat::Rgb | BaseFormat::Rgba => {}
        BaseFormat::Alpha
        | BaseFormat::Luminance
        | BaseFormat::LuminanceAlpha
        | BaseFormat::Intensity
        | BaseFormat::Depth => return false,
    }
    let is_small = matches!(
        format,
        Format::R3G3B2 | Format::R5G6B5 | Format::Rgba4 | Format::Rgb5A1 | Format::Rgb10
    );
    format.block().is_none() && !is_small
}

/// Whether texels of one format can be taken for texels of the other (table 8.22; a block for a texel of its size).
fn are_compatible(a: Format, b: Format) -> bool {
    if a == b || a.without_srgb() == b.without_srgb() {
        return true;
    }
    let same_size = a.bytes() == b.bytes();
    match (a.block(), b.block()) {
        (None, None) => same_size && is_in_a_view_class(a) && is_in_a_view_class(b),
        (Some(_), None) => same_size && is_in_a_view_class(b),
        (None, Some(_)) => same_size && is_in_a_view_class(a),
        // Signed or not.
        (Some(_), Some(_)) => {
            let alike = |of: fn(Format) -> bool| of(a) && of(b);
            (alike(is_rgtc) || alike(is_bptc_of_floats)) && same_size
        }
    }
}

fn is_rgtc(format: Format) -> bool {
    matches!(format, Format::Rgtc1 | Format::Rgtc1Snorm | Format::Rgtc2 | Format::Rgtc2Snorm)
}

fn is_bptc_of_floats(format: Format) -> bool {
    matches!(format, Format::BptcSignedFloat | Format::BptcUnsignedFloat)
}

/// A checked `glCopyImageSubData`.
struct CopyRequest {
    from: (StoredLevel, UnitBox),
    to: (StoredLevel, UnitBox),
}

impl CopyRequest {
    fn new(
        context: &mut Context,
        source: &ImageArguments,
        destination: &ImageArguments,
        size: [GLsizei; 3],
    ) -> Result<Self> {
        let from = source.stored(context)?;
        let to = destination.stored(context)?;
        let mut texels = [0; 3];
        for (axis, name) in ["srcWidth", "srcHeight", "srcDepth"].into_iter().enumerate() {
            texels[axis] = not_negative(SECTION, name, size[axis].into())? as u64;
        }
        source.check_region(&from, texels)?;
        let [side, other] = [&from, &to].map(|level| u64::from(level.format.block_side()));
        let units = [texels[0].div_ceil(side), texels[1].div_ceil(side), texels[2]];
        // The texels of the destination; its last blocks may reach beyond its edge.
        let mut texels = [units[0] * other, units[1] * other, units[2]];
        for (axis, count) in texels.iter_mut().enumerate().take(2) {
            let start = u64::try_from(destination.at[axis]).unwrap_or(0);
            let left = u64::from(to.size[axis]).saturating_sub(start);
            if *count > left && *count - left < other {
                *count = left;
            }
        }
        destination.check_region(&to, texels)?;
        if !are_compatible(from.format, to.format) {
            let [from, to] = [from.format, to.format].map(format_name);
            return invalid_operation(SECTION, format!("texels of {from} are none of {to}"));
        }
        if from.samples != to.samples {
            return invalid_operation(
                SECTION,
                format!(
                    "the images have {} and {} samples, not the same",
                    from.samples, to.samples
                ),
            );
        }
        let units = units.map(|side| side as usize);
        let (source, destination) = (source.units(&from, units), destination.units(&to, units));
        Ok(Self { from: (from, source), to: (to, destination) })
    }

    fn apply(self, context: &mut Context) -> Result<()> {
        let Self { from: (from, source), to: (to, destination) } = self;
        if source.size.contains(&0) {
            return Ok(());
        }
        let bytes = from.read(source);
        to.write(context, destination, bytes.chunks_exact(from.row_bytes(source)))
    }
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn copy_image_sub_data(
    context: &mut Context,
    src_name: GLuint,
    src_target: GLenum,
    src_level: GLint,
    src_x: GLint,
    src_y: GLint,
    src_z: GLint,
    dst_name: GLuint,
    dst_target: GLenum,
    dst_level: GLint,
    dst_x: GLint,
    dst_y: GLint,
    dst_z: GLint,
    src_width: GLsizei,
    src_height: GLsizei,
    src_depth: GLsizei,
) -> Result<()> {
    let source = ImageArguments {
        side: Side::Source,
        name: src_name,
        target: src_target,
        level: src_level,
        at: [src_x, src_y, src_z],
    };
    let destination = ImageArguments {
        side: Side::Destination,
        name: dst_name,
        target: dst_target,
        level: dst_level,
        at: [dst_x, dst_y, dst_z],
    };
    let size = [src_width, src_height, src_depth];
    CopyRequest::new(context, &source, &destination, size)?.apply(context)
}
