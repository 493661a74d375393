//! `glTextureView`: a texture that shows levels and layers of another one's storage, as a format of the same class (GL 4.3,
//! section 8.18).

use crate::base::constants::*;
use crate::base::error::{Result, invalid_operation, invalid_value};
use crate::base::limits;
use crate::base::types::*;
use crate::calls::texture::format_properties::Supported;
use crate::context::Context;
use crate::objects::target::{TARGET, TextureTarget};
use crate::objects::texture::{Shown, Texture};
use crate::pixel::formats::{self, view_class, viewed_as};
use rasterizer::driver::ViewDesc;
use texunit::image::FACES;

const SECTION: &str = "GL 4.3, section 8.18";

impl Supported {
    /// Whether views can show its texels: those of storage for good.
    pub fn is_viewed(&self) -> bool {
        self.texture().is_some() && self.format.is_sized()
    }

    /// The class of formats that views of its texels may have; 0 where only itself is possible.
    pub fn view_class(&self) -> GLenum {
        let class = view_class(self.format.name).filter(|_| self.is_viewed());
        class.unwrap_or(GL_NONE)
    }
}

/// The targets of views of a texture of a target (GL 4.3, table 8.21).
fn targets_of_views(of: TextureTarget) -> &'static [TextureTarget] {
    match of {
        TextureTarget::D1 | TextureTarget::D1Array => &[TextureTarget::D1, TextureTarget::D1Array],
        TextureTarget::D2 => &[TextureTarget::D2, TextureTarget::D2Array],
        TextureTarget::D3 => &[TextureTarget::D3],
        TextureTarget::Rect => &[TextureTarget::Rect],
        TextureTarget::Cube | TextureTarget::D2Array | TextureTarget::CubeArray => &[
            TextureTarget::D2,
            TextureTarget::D2Array,
            TextureTarget::Cube,
            TextureTarget::CubeArray,
        ],
        TextureTarget::D2Multisample | TextureTarget::D2MultisampleArray => {
            &[TextureTarget::D2Multisample, TextureTarget::D2MultisampleArray]
        }
        TextureTarget::Buffer | TextureTarget::External => &[],
    }
}

/// The part of a range that begins at `first` of the texture's, and how much is left there.
fn checked_part(
    [first_name, count_name]: [&str; 2],
    (first, count): (GLuint, GLuint),
    there: u32,
) -> Result<u32> {
    if first >= there {
        return invalid_value(
            SECTION,
            format!("{first_name} = {first} must be below {there}, as many as origtexture has"),
        );
    }
    if count == 0 {
        return invalid_value(SECTION, format!("{count_name} = 0 must be at least 1"));
    }
    Ok(count.min(there - first))
}

/// Checks how many layers a view has: `asked` by the client, of which there are `layers`.
fn check_layers(target: TextureTarget, asked: GLuint, layers: u32) -> Result<()> {
    let name = enum_name(TARGET.encode(target));
    match target {
        TextureTarget::D1
        | TextureTarget::D2
        | TextureTarget::D3
        | TextureTarget::Rect
        | TextureTarget::External
        | TextureTarget::D2Multisample
        | TextureTarget::Buffer
            if asked != 1 =>
        {
            invalid_value(SECTION, format!("numlayers = {asked} of a {name} must be 1"))
        }
        TextureTarget::Cube if layers as usize != FACES => invalid_value(
            SECTION,
            format!("numlayers = {asked}, which are {layers} here: a {name} has {FACES}"),
        ),
        TextureTarget::CubeArray if !(layers as usize).is_multiple_of(FACES) => invalid_value(
            SECTION,
            format!(
                "numlayers = {asked}, which are {layers} here: a {name} has a multiple of {FACES}"
            ),
        ),
        TextureTarget::D1
        | TextureTarget::D2
        | TextureTarget::D3
        | TextureTarget::Rect
        | TextureTarget::External
        | TextureTarget::Cube
        | TextureTarget::D1Array
        | TextureTarget::D2Array
        | TextureTarget::CubeArray
        | TextureTarget::D2Multisample
        | TextureTarget::D2MultisampleArray
        | TextureTarget::Buffer => Ok(()),
    }
}

/// The texture that is viewed, and what it shows of its storage, which must be immutable.
fn origin(context: &Context, name: GLuint) -> Result<(&Texture, Shown)> {
    let Some(texture) = context.objects.shared.textures.get(name) else {
        return invalid_value(SECTION, format!("origtexture = {name} is no texture"));
    };
    match texture.immutable {
        Some(shown) => Ok((texture, shown)),
        None => invalid_operation(
            SECTION,
            format!(
                "origtexture = {name} has no immutable storage: give it some with glTexStorage2D"
            ),
        ),
    }
}

/// Checks that a name can become a view.
fn check_name(context: &Context, name: GLuint) -> Result<()> {
    if name == 0 {
        return invalid_value(SECTION, "texture = 0 is the default one: use glGenTextures");
    }
    let textures = &context.objects.shared.textures;
    match textures.get(name) {
        None if textures.is_reserved(name) => Ok(()),
        None => invalid_operation(
            SECTION,
            format!("texture = {name} must be a name that glGenTextures gave"),
        ),
        Some(texture) => invalid_operation(
            SECTION,
            format!(
                "texture = {name} is a {} already: take a name that was not bound yet",
                enum_name(TARGET.encode(texture.target))
            ),
        ),
    }
}

#[expect(clippy::too_many_arguments, reason = "GL's signature")]
pub(crate) fn texture_view(
    context: &mut Context,
    texture: GLuint,
    target: GLenum,
    origtexture: GLuint,
    internalformat: GLenum,
    minlevel: GLuint,
    numlevels: GLuint,
    minlayer: GLuint,
    numlayers: GLuint,
) -> Result<()> {
    check_name(context, texture)?;
    let (of, shown) = origin(context, origtexture)?;
    let possible = targets_of_views(of.target);
    let Some(target) = TARGET.get(target).filter(|target| possible.contains(target)) else {
        let possible: Vec<String> =
            possible.iter().map(|target| enum_name(TARGET.encode(*target))).collect();
        return invalid_operation(
            SECTION,
            format!(
                "target = {}, but views of a {} are {}",
                enum_name(target),
                enum_name(TARGET.encode(of.target)),
                possible.join(" or ")
            ),
        );
    };
    let names = ["minlevel", "numlevels"];
    let levels = checked_part(names, (minlevel, numlevels), shown.levels)?;
    let names = ["minlayer", "numlayers"];
    let layers = checked_part(names, (minlayer, numlayers), shown.layers)?;
    check_layers(target, numlayers, layers)?;
    let stored = of.internal(0, 0);
    let possible = viewed_as(&stored);
    let is_viewed = possible.contains(&internalformat);
    let Some(format) = formats::find(internalformat).filter(|_| is_viewed) else {
        let possible: Vec<String> = possible.iter().map(|internal| enum_name(*internal)).collect();
        return invalid_operation(
            SECTION,
            format!(
                "internalformat = {}, but texels of {} are viewed as {}",
                enum_name(internalformat),
                enum_name(stored),
                possible.join(", ")
            ),
        );
    };
    let [width, height, _] = of.image.level(0, minlevel as usize).map_or([0; 3], |info| info.size);
    if target.shape().is_cube() && width != height {
        return invalid_operation(
            SECTION,
            format!(
                "target = {}, but the layers are of {width}×{height}, not square",
                enum_name(TARGET.encode(target))
            ),
        );
    }
    let image = of.image.view(ViewDesc {
        shape: target.shape(),
        format: format.stored,
        levels: minlevel as usize..(minlevel + levels) as usize,
        layers: minlayer as usize..(minlayer + layers) as usize,
    });
    let mut view = Texture::new(target);
    view.image = image;
    view.state.sampler.depth_mode = context.profile.depth_mode();
    view.samples = of.samples;
    view.immutable = Some(Shown {
        storage_levels: shown.storage_levels,
        first_level: shown.first_level + minlevel,
        levels,
        first_layer: shown.first_layer + minlayer,
        layers,
    });
    let last = (levels as usize).min(limits::MAX_TEXTURE_LEVELS);
    for requested in &mut view.requested {
        requested[..last].fill(internalformat);
    }
    context.objects.shared.textures.create(texture, || view);
    Ok(())
}
