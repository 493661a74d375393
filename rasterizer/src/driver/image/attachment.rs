//! What a pass draws to.

use super::Image;
use super::state::face_and_slice;
use crate::plan::possible_samples;
use texunit::format::Format;
use texunit::image::{ImageError, Level, Shape};

/// The size and kind of what is attached.
pub(crate) struct AttachmentInfo {
    pub format: Format,
    pub width: u32,
    pub height: u32,
    pub samples: u8,
}

/// One slice of one level of an image, to be drawn to.
#[derive(Clone, Debug)]
pub struct Attachment {
    /// The image.
    pub image: Image,
    /// Which face of a cube, slice of a volume, or layer of an array (of cubes: which of all
    /// faces); else 0.
    pub face: u16,
    /// Which level; it must exist.
    pub level: u8,
    /// How many samples a pixel has while it is drawn to: the texels of the image are what they are resolved to.
    pub samples: AttachmentSamples,
}

/// How many samples a pixel of an attachment has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AttachmentSamples {
    /// As many as its image.
    #[default]
    OfImage,
    /// So many, of an image that has one: as many as [`possible_samples`](crate::plan::possible_samples) says. They are
    /// there as long as the level is drawn to in this way and nothing else changes the image; then each has the texel.
    Implicit(u8),
}

impl AttachmentSamples {
    /// The number, of an image that has so many itself.
    pub(super) fn of(self, image: u8) -> u8 {
        match self {
            Self::Implicit(samples) if image == 1 => possible_samples(samples),
            Self::OfImage | Self::Implicit(_) => image,
        }
    }
}

impl Attachment {
    /// A slice with the samples that its image has.
    pub fn new(image: Image, face: u16, level: u8) -> Self {
        Self { image, face, level, samples: AttachmentSamples::OfImage }
    }

    /// The samples, each a slice ([`crate::driver::Device::set_each_sample`]).
    ///
    /// # Errors
    /// If it does not exist, or there is no memory for them.
    pub fn each_sample(&self) -> Result<Level, ImageError> {
        self.image.each_sample(self)
    }

    /// Takes the memory that an [`Image::update`] of its level needs, which writes to it by
    /// [`texunit::image::Image::level_mut`]: until the texels are requested again it cannot fail then.
    ///
    /// # Errors
    /// If there is none; nothing has changed then.
    pub fn prepare_update(&self) -> Result<(), ImageError> {
        self.image.prepare_update(self)
    }

    /// That of a layer so many behind it.
    pub(crate) fn layer(&self, behind: u16) -> Option<Self> {
        Some(Self { face: self.face.checked_add(behind)?, ..self.clone() })
    }

    /// Pixels across and up, if it exists.
    pub fn size(&self) -> Option<[u32; 2]> {
        let info = self.info()?;
        Some([info.width, info.height])
    }

    /// What it names, if it exists.
    pub(crate) fn info(&self) -> Option<AttachmentInfo> {
        self.image.attachment(self)
    }

    /// How many samples a pixel has; 1 if it is no multisample image and has no samples of its own.
    pub fn sample_count(&self) -> u8 {
        self.samples.of(self.image.samples())
    }

    /// Which face it names, if its image is of this shape, and which slice.
    pub fn face_and_slice(&self, shape: Shape) -> (usize, usize) {
        face_and_slice(shape, self.face.into())
    }
}

/// What a pass draws to. All attachments are at least `width` × `height` and have the same number
/// of samples.
#[derive(Clone, Debug)]
pub struct PassDesc {
    /// Colour attachments by index, of any format but depths, compressed ones and shared exponents.
    pub colors: Vec<Option<Attachment>>,
    /// Depth attachment: D16, D24, D32F, or D24S8, D32FS8, which are the stencil attachment too.
    pub depth: Option<Attachment>,
    /// Pixels across.
    pub width: u32,
    /// Pixels up.
    pub height: u32,
    /// How many layers there are: [`Attachment::face`] is the number of the first, which the others follow. Draws go to
    /// the first, but where a geometry program says another; clears go to all.
    pub layers: u16,
    /// How many samples a pixel has where there is no attachment that says so: the next larger of 1, 2 and 4.
    pub samples: u8,
}

impl PassDesc {
    /// The same attachments, whatever storage their images get until the pass has ended.
    pub(crate) fn pinned(&self) -> Self {
        let pinned = |attachment: &Attachment| Attachment {
            image: attachment.image.pinned(),
            ..attachment.clone()
        };
        Self {
            colors: self.colors.iter().map(|color| color.as_ref().map(pinned)).collect(),
            depth: self.depth.as_ref().map(pinned),
            ..*self
        }
    }
}
