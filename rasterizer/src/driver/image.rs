//! Images: texels that can be sampled, and attachments that can be drawn to.

use parking_lot::Mutex;
use std::sync::Arc;
use texunit::image::Image as Texels;

/// An image of the driver. Cloning gives another handle to the same image.
#[derive(Clone, Debug)]
pub struct Image(Arc<Mutex<Texels>>);

impl Image {
    /// An image with these texels.
    pub fn new(texels: Texels) -> Self {
        Self(Arc::new(Mutex::new(texels)))
    }

    /// Its texels as they are after everything submitted so far. Shares them: later writes to the
    /// image copy.
    pub fn texels(&self) -> Texels {
        self.0.lock().clone()
    }

    /// Changes its texels. Draws that were recorded earlier keep what they saw.
    pub fn update<R>(&self, change: impl FnOnce(&mut Texels) -> R) -> R {
        change(&mut self.0.lock())
    }

    /// Whether both handles name the same image.
    pub fn same(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// One face of one level of an image, to be drawn to.
#[derive(Clone, Debug)]
pub struct Attachment {
    /// The image.
    pub image: Image,
    /// 0 for a 2D image, 0 to 5 for a cube.
    pub face: u8,
    /// Which level; it must exist.
    pub level: u8,
}

/// What a pass draws to. All attachments are at least `width` × `height`.
#[derive(Clone, Debug)]
pub struct PassDesc {
    /// Colour attachments by index; formats Rgba8, Rgb8, R8, L8 … (every 8-bit colour format).
    pub colors: Vec<Option<Attachment>>,
    /// Depth attachment: D16, D24 or D32F.
    pub depth: Option<Attachment>,
    /// Pixels across.
    pub width: u32,
    /// Pixels up.
    pub height: u32,
}
