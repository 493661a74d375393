//! A level of a texture, or a renderbuffer, as the bytes that it is stored in: what `glCopyImageSubData` and
//! `glClearTexImage` work on.

use crate::base::error::Result;
use crate::base::types::*;
use crate::calls::texture::mipmap::base_level_changed;
use crate::context::Context;
use crate::context::window::base_level_attachment;
use crate::objects::target::TextureTarget;
use crate::pixel::storage_error::storage_error;
use rasterizer::driver::Image;
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{Image as Texels, Level};

/// The object that a level belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Owner {
    Texture(GLuint, TextureTarget),
    Renderbuffer,
}

/// A level of an object.
#[derive(Clone, Debug)]
pub(crate) struct StoredLevel {
    owner: Owner,
    image: Image,
    level: usize,
    pub format: Format,
    /// Width, height, and depth, layers or faces, in texels without border.
    pub size: [u32; 3],
    pub border: [u32; 3],
    pub samples: u8,
}

/// A box of a level in units of its storage: texels, or blocks of a compressed format; the third axis counts layers, or
/// faces of a cube.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct UnitBox {
    pub at: [i32; 3],
    pub size: [usize; 3],
}

/// Whether a box, of texels from `at` on, lies within a level of this size and its border.
///
/// # Errors
/// What reaches outside.
pub(crate) fn check_box(
    [at, size]: [[i32; 3]; 2],
    sides: [u32; 3],
    border: [u32; 3],
) -> Result<(), String> {
    for axis in 0..3 {
        let (from, texels) = (i64::from(at[axis]), i64::from(size[axis]));
        let border = i64::from(border[axis]);
        let (low, high) = (-border, i64::from(sides[axis]) + border);
        if texels < 0 || from < low || from + texels > high {
            let letter = ["x", "y", "z"][axis];
            return Err(format!(
                "{texels} texels along {letter} from {from} on reach outside {low} to {high}"
            ));
        }
    }
    Ok(())
}

/// A layer's sample: which face, and which slice of it.
struct Slice {
    face: usize,
    slice: usize,
}

impl StoredLevel {
    /// The level, if it exists. Draws to it are submitted.
    pub fn new(context: &mut Context, owner: Owner, image: &Image, level: usize) -> Option<Self> {
        let info = image.level(0, level)?;
        crate::draw::pass::submit_draws_to(context, image);
        let mut size = info.size;
        if owner.is_cube() {
            size[2] = 6;
        }
        Some(Self {
            owner,
            image: image.clone(),
            level,
            format: info.format,
            size,
            border: info.border,
            samples: info.samples,
        })
    }

    /// Where the samples of a layer or face are, one after the other.
    fn slices(&self, layer: usize) -> impl Iterator<Item = Slice> {
        let samples = usize::from(self.samples);
        let (face, first) = if self.owner.is_cube() { (layer, 0) } else { (0, layer * samples) };
        (0..samples).map(move |sample| Slice { face, slice: first + sample })
    }

    /// Bytes of a row of a box.
    pub fn row_bytes(&self, area: UnitBox) -> usize {
        area.size[0] * self.format.bytes()
    }

    /// The bytes of a box: unit by unit, row by row, sample by sample, layer by layer.
    pub fn read(&self, area: UnitBox) -> Vec<u8> {
        let mut bytes = Vec::new();
        let (run, rows) = (self.row_bytes(area), self.rows());
        for layer in 0..area.size[2] {
            for slice in self.slices(area.at[2] as usize + layer) {
                let Some(level) = rows.level(slice.face, self.level) else { continue };
                for y in 0..area.size[1] {
                    let start = offset(level, [area.at[0], area.at[1] + y as i32], slice.slice);
                    bytes.extend_from_slice(&level.texels[start..start + run]);
                }
            }
        }
        bytes
    }

    /// Overwrites a box with rows in the order of [`Self::read`]; does nothing if the box is empty.
    ///
    /// # Errors
    /// When there is no memory for the mipmaps that follow.
    pub fn write<'a>(
        &self,
        context: &mut Context,
        area: UnitBox,
        rows: impl IntoIterator<Item = &'a [u8]>,
    ) -> Result<()> {
        if area.size.contains(&0) {
            return Ok(());
        }
        let run = self.row_bytes(area);
        let mut from = rows.into_iter();
        let mut put = |level: &mut Level, slice: usize| {
            for y in 0..area.size[1] {
                let start = offset(level, [area.at[0], area.at[1] + y as i32], slice);
                let Some(row) = from.next() else { return };
                level.texels[start..start + run].copy_from_slice(row);
            }
        };
        let layers = area.at[2] as usize..area.at[2] as usize + area.size[2];
        let (name, target) = match self.owner {
            Owner::Renderbuffer => {
                if self.samples > 1 {
                    let attachment = base_level_attachment(&self.image);
                    let samples = attachment.each_sample();
                    let mut level =
                        samples.map_err(|error| storage_error("ARB_copy_image", &error))?;
                    (0..level.depth as usize).for_each(|slice| put(&mut level, slice));
                    context.recorder.device().set_each_sample(&attachment, &level);
                    return Ok(());
                }
                self.image.update(|texels| {
                    if let Some(level) = texels.level_mut(0, 0) {
                        put(level, 0);
                    }
                });
                return Ok(());
            }
            Owner::Texture(name, target) => (name, target),
        };
        // Its plan reads the texels: while it is there they would be copied first.
        if let Some(texture) = context.objects.shared.textures.get_mut(name) {
            texture.texels_changed();
        }
        self.image.update(|texels| {
            for slice in layers.clone().flat_map(|layer| self.slices(layer)) {
                if let Some(level) = texels.level_mut(slice.face, self.level) {
                    put(level, slice.slice);
                }
            }
        });
        let isa = context.recorder.isa();
        let faces = if target == TextureTarget::Cube { layers } else { 0..1 };
        match context.objects.shared.textures.get_mut(name) {
            Some(texture) => faces
                .into_iter()
                .try_for_each(|face| base_level_changed(isa, texture, face, self.level)),
            None => Ok(()),
        }
    }

    /// Its texels, every sample of a renderbuffer a slice.
    fn rows(&self) -> Rows {
        match self.owner {
            Owner::Renderbuffer if self.samples > 1 => {
                Rows::Samples(base_level_attachment(&self.image).each_sample().ok().map(Arc::new))
            }
            Owner::Renderbuffer | Owner::Texture(..) => Rows::Texels(self.image.texels()),
        }
    }
}

impl Owner {
    fn is_cube(self) -> bool {
        match self {
            Self::Texture(_, target) => target == TextureTarget::Cube,
            Self::Renderbuffer => false,
        }
    }
}

/// The rows of a level.
enum Rows {
    Texels(Texels),
    Samples(Option<Arc<Level>>),
}

impl Rows {
    fn level(&self, face: usize, level: usize) -> Option<&Level> {
        match self {
            Self::Texels(texels) => texels.level(face, level).map(|level| &**level),
            Self::Samples(level) => level.as_deref(),
        }
    }
}

/// The byte at which a unit of a slice begins; -1 is the border.
fn offset(level: &Level, [x, y]: [i32; 2], slice: usize) -> usize {
    let along =
        x as isize * level.format.bytes() as isize + y as isize * level.row_bytes() as isize;
    (level.origin() + slice * level.slice_bytes()).wrapping_add_signed(along)
}
