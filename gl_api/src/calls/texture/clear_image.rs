//! `glClearTexImage` and `glClearTexSubImage`: texels of one value (`ARB_clear_texture`).

use crate::base::args::Data;
use crate::base::error::{Result, invalid_operation};
use crate::base::types::*;
use crate::calls::texture::specify::kinds_match;
use crate::calls::texture::stored_level::{Owner, StoredLevel, UnitBox, check_box};
use crate::context::Context;
use crate::objects::target::TextureTarget;
use crate::pixel::client::Pixel;
use crate::pixel::one_texel::one_texel;

const SECTION: &str = "ARB_clear_texture, section 3.9.X";

/// The part of a level that is cleared.
enum ClearedArea {
    /// All of it, the border too.
    Level,
    /// A box, as calls on the target give it.
    Box { at: [GLint; 3], size: [GLsizei; 3] },
}

/// A checked clear.
struct ClearRequest {
    level: StoredLevel,
    area: UnitBox,
    /// A texel as it is stored.
    texel: Vec<u8>,
}

impl ClearRequest {
    fn new(
        context: &mut Context,
        name: GLuint,
        level: GLint,
        area: ClearedArea,
        (format, ty): (GLenum, GLenum),
        data: Data<'_>,
    ) -> Result<Self> {
        let found = context.objects.shared.textures.get(name).filter(|_| name != 0);
        let Some(texture) = found else {
            return invalid_operation(SECTION, format!("texture = {name} is no texture"));
        };
        let (target, image) = (texture.target, texture.image.clone());
        let internal = texture.internal(0, level as usize);
        if target == TextureTarget::Buffer {
            return invalid_operation(SECTION, "a buffer texture is cleared by glClearBufferData");
        }
        let owner = Owner::Texture(name, target);
        let found = usize::try_from(level).ok();
        let Some(stored) = found.and_then(|at| StoredLevel::new(context, owner, &image, at)) else {
            return invalid_operation(SECTION, format!("level = {level} has no image"));
        };
        if stored.format.block().is_some() {
            return invalid_operation(SECTION, "compressed texels are not cleared");
        }
        let area = unit_box(target, &stored, area)?;
        let pixel = Pixel::new(format, ty)?;
        kinds_match(pixel, stored.format, internal)?;
        let isa = context.recorder.isa();
        let texel = one_texel(isa, SECTION, stored.format, pixel, data)?;
        Ok(Self { level: stored, area, texel })
    }

    fn apply(self, context: &mut Context) -> Result<()> {
        let Self { level, area, texel } = self;
        let row = texel.repeat(area.size[0]);
        level.write(context, area, std::iter::repeat(&*row))
    }
}

/// The cleared box, if it lies within the level and its border.
fn unit_box(target: TextureTarget, stored: &StoredLevel, area: ClearedArea) -> Result<UnitBox> {
    let border = stored.border.map(|side| side as i32);
    let (at, size) = match area {
        ClearedArea::Level => {
            let size = [0, 1, 2].map(|axis| stored.size[axis] as i32 + 2 * border[axis]);
            (border.map(|side| -side), size)
        }
        ClearedArea::Box { at, size } => (target.level_box(at), target.level_box(size)),
    };
    if let Err(rule) = check_box([at, size], stored.size, stored.border) {
        return invalid_operation(SECTION, rule);
    }
    Ok(UnitBox { at, size: size.map(|side| side as usize) })
}

pub(crate) fn clear_tex_image(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    format: GLenum,
    ty: GLenum,
    data: Data<'_>,
) -> Result<()> {
    let area = ClearedArea::Level;
    ClearRequest::new(context, texture, level, area, (format, ty), data)?.apply(context)
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn clear_tex_sub_image(
    context: &mut Context,
    texture: GLuint,
    level: GLint,
    xoffset: GLint,
    yoffset: GLint,
    zoffset: GLint,
    width: GLsizei,
    height: GLsizei,
    depth: GLsizei,
    format: GLenum,
    ty: GLenum,
    data: Data<'_>,
) -> Result<()> {
    let area = ClearedArea::Box { at: [xoffset, yoffset, zoffset], size: [width, height, depth] };
    ClearRequest::new(context, texture, level, area, (format, ty), data)?.apply(context)
}
