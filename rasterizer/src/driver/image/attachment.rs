//! What a pass draws to.

use super::Image;
use super::state::face_and_slice;
use texunit::format::Format;
use texunit::image::Shape;

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
}

impl Attachment {
    /// Pixels across and up, if it exists.
    pub fn size(&self) -> Option<[u32; 2]> {
        let info = self.image.attachment(self.face, self.level)?;
        Some([info.width, info.height])
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
