//! Textures whose texels are the bytes of a buffer object: `glTexBuffer`, `glTexBufferRange`
//! (`ARB_texture_buffer_object`, `ARB_texture_buffer_object_rgb32`, `ARB_texture_buffer_range`; GL
//! 3.1, section 3.8.4).
//!
//! A draw makes a row of texels of the bytes that the buffer has then, and keeps it until somebody
//! asks to write to the buffer.

use super::internal::INTERNAL_FORMAT;
use super::{TextureTarget, bound_mut};
use crate::constants::*;
use crate::context::{Context, limits};
use crate::error::{
    ErrorCode, GlError, Result, Table, invalid_enum, invalid_operation, invalid_value,
};
use crate::object::bound::Bound;
use crate::object::buffers::BufferObject;
use crate::types::*;
use rasterizer::driver::{Buffer, Version};
use std::ops::Range;
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::Level;
use texunit::plan::SamplePlan;

const SECTION: &str = "GL 3.1, section 3.8.4";
const RANGE: &str = "ARB_texture_buffer_range, section 3.8.4";

const TARGET: Table<()> = Table { section: SECTION, rows: &[(GL_TEXTURE_BUFFER, ())] };

/// The formats of the table in `ARB_texture_buffer_object`, those of GL 3.1 (table 3.15), and those
/// of `ARB_texture_buffer_object_rgb32`.
#[rustfmt::skip]
const FORMATS: [GLenum; 73] = [
    GL_ALPHA8, GL_ALPHA16, GL_ALPHA16F_ARB, GL_ALPHA32F_ARB,
    GL_ALPHA8I_EXT, GL_ALPHA16I_EXT, GL_ALPHA32I_EXT,
    GL_ALPHA8UI_EXT, GL_ALPHA16UI_EXT, GL_ALPHA32UI_EXT,
    GL_LUMINANCE8, GL_LUMINANCE16, GL_LUMINANCE16F_ARB, GL_LUMINANCE32F_ARB,
    GL_LUMINANCE8I_EXT, GL_LUMINANCE16I_EXT, GL_LUMINANCE32I_EXT,
    GL_LUMINANCE8UI_EXT, GL_LUMINANCE16UI_EXT, GL_LUMINANCE32UI_EXT,
    GL_LUMINANCE8_ALPHA8, GL_LUMINANCE16_ALPHA16,
    GL_LUMINANCE_ALPHA16F_ARB, GL_LUMINANCE_ALPHA32F_ARB,
    GL_LUMINANCE_ALPHA8I_EXT, GL_LUMINANCE_ALPHA16I_EXT, GL_LUMINANCE_ALPHA32I_EXT,
    GL_LUMINANCE_ALPHA8UI_EXT, GL_LUMINANCE_ALPHA16UI_EXT, GL_LUMINANCE_ALPHA32UI_EXT,
    GL_INTENSITY8, GL_INTENSITY16, GL_INTENSITY16F_ARB, GL_INTENSITY32F_ARB,
    GL_INTENSITY8I_EXT, GL_INTENSITY16I_EXT, GL_INTENSITY32I_EXT,
    GL_INTENSITY8UI_EXT, GL_INTENSITY16UI_EXT, GL_INTENSITY32UI_EXT,
    GL_R8, GL_R16, GL_R16F, GL_R32F,
    GL_R8I, GL_R16I, GL_R32I, GL_R8UI, GL_R16UI, GL_R32UI,
    GL_RG8, GL_RG16, GL_RG16F, GL_RG32F,
    GL_RG8I, GL_RG16I, GL_RG32I, GL_RG8UI, GL_RG16UI, GL_RG32UI,
    GL_RGB32F, GL_RGB32I, GL_RGB32UI,
    GL_RGBA8, GL_RGBA16, GL_RGBA16F, GL_RGBA32F,
    GL_RGBA8I, GL_RGBA16I, GL_RGBA32I, GL_RGBA8UI, GL_RGBA16UI, GL_RGBA32UI,
];

/// Where the texels of a buffer texture come from.
#[derive(Debug)]
pub(crate) struct DataStore {
    /// The internal format that was asked for.
    pub internal: GLenum,
    pub format: Format,
    /// The buffer, if there is one: the texture keeps it when it is deleted.
    pub buffer: Bound,
    /// The bytes of the buffer that are texels, unless all are.
    range: Option<Range<usize>>,
    /// How the texels of these bytes are fetched.
    plan: Option<(Version, Arc<SamplePlan>)>,
}

impl Default for DataStore {
    /// As a new texture has it (`ARB_texture_buffer_object`, section 6.2).
    fn default() -> Self {
        let (internal, format) = (GL_LUMINANCE8, Format::L8);
        Self { internal, format, buffer: Bound::default(), range: None, plan: None }
    }
}

impl DataStore {
    /// Why there are no texels, if so.
    pub fn incomplete_reason(&self) -> Option<String> {
        (self.buffer.name() == 0).then(|| "it has no buffer: give it one with glTexBuffer".into())
    }

    /// Which bytes of a buffer are texels.
    pub fn range_of(&self, length: usize) -> Range<usize> {
        match &self.range {
            None => 0..length,
            Some(range) => range.start.min(length)..range.end.min(length),
        }
    }

    /// How many texels so many bytes are.
    pub fn texels(&self, bytes: usize) -> u32 {
        let most = limits::MAX_TEXTURE_BUFFER_SIZE;
        u32::try_from(bytes / self.format.bytes()).map_or(most, |texels| texels.min(most))
    }
}

/// The length of the buffer that a store reads; mapped or not.
pub(super) fn length(context: &Context, store: &DataStore) -> usize {
    context.objects.buffers.bound(&store.buffer).map_or(0, BufferObject::len)
}

/// How a draw fetches the texels of the texture that is bound to `GL_TEXTURE_BUFFER` of a unit.
///
/// # Errors
/// When the client has the buffer mapped, or there is no memory.
pub(crate) fn plan(context: &mut Context, unit: u8) -> Result<Arc<SamplePlan>> {
    let bound = &context.state.units.units[usize::from(unit)].bound[TextureTarget::Buffer as usize];
    let store = &context.objects.texture(TextureTarget::Buffer, bound).store;
    let buffer = match context.objects.buffers.bound(&store.buffer) {
        Some(object) if object.map.is_some() => {
            let (buffer, name) = (store.buffer.name(), bound.name());
            let rule = format!("buffer {buffer} of texture {name} is mapped: call glUnmapBuffer");
            return invalid_operation("ARB_texture_buffer_object, section 3.8", rule);
        }
        Some(object) => object.buffer().clone(),
        None => Buffer::default(),
    };
    if let Some((version, plan)) = &store.plan
        && version.is_of(&buffer)
    {
        return Ok(Arc::clone(plan));
    }
    let bytes = &buffer.bytes()[store.range_of(buffer.bytes().len())];
    let row = Level::row(store.format, bytes, limits::MAX_TEXTURE_BUFFER_SIZE)
        .map_err(|error| GlError::new(ErrorCode::OutOfMemory, SECTION, error.to_string()))?;
    context.recorder.hold(row.texels.len());
    let plan = Arc::new(SamplePlan::for_buffer(row));
    let store = &mut context.objects.texture_mut(TextureTarget::Buffer, bound).store;
    store.plan = Some((buffer.version(), Arc::clone(&plan)));
    Ok(plan)
}

/// Gives the bound texture its texels, if the arguments are right.
fn attach(
    context: &mut Context,
    target: GLenum,
    internal: GLenum,
    buffer: GLuint,
    range: impl FnOnce(usize) -> Result<Option<Range<usize>>>,
) -> Result<()> {
    TARGET.decode("target", target)?;
    let format = INTERNAL_FORMAT.get(internal).filter(|_| FORMATS.contains(&internal));
    let Some(format) = format else {
        return invalid_enum(
            SECTION,
            format!(
                "internalformat = {} must be one of table 3.15, as GL_RGBA8 or GL_R32F",
                enum_name(internal)
            ),
        );
    };
    let range = match context.objects.buffers.get(buffer) {
        _ if buffer == 0 => None,
        Some(object) => range(object.len())?,
        None => {
            let rule =
                format!("buffer = {buffer} is no buffer object: bind it once, to any target");
            return invalid_operation(SECTION, rule);
        }
    };
    let buffer = context.objects.buffers.hold(buffer);
    bound_mut(context, TextureTarget::Buffer).store =
        DataStore { internal, format, buffer, range, ..DataStore::default() };
    Ok(())
}

pub(crate) fn tex_buffer(
    context: &mut Context,
    target: GLenum,
    internalformat: GLenum,
    buffer: GLuint,
) -> Result<()> {
    attach(context, target, internalformat, buffer, |_| Ok(None))
}

pub(crate) fn tex_buffer_range(
    context: &mut Context,
    target: GLenum,
    internalformat: GLenum,
    buffer: GLuint,
    offset: GLintptr,
    size: GLsizeiptr,
) -> Result<()> {
    attach(context, target, internalformat, buffer, |length| {
        let alignment = limits::TEXTURE_BUFFER_OFFSET_ALIGNMENT;
        let range = usize::try_from(offset).ok().zip(usize::try_from(size).ok());
        match range.and_then(|(offset, size)| Some(offset..offset.checked_add(size)?)) {
            Some(range) if !range.start.is_multiple_of(alignment) => invalid_value(
                RANGE,
                format!(
                    "offset = {offset} must be a multiple of {alignment}, \
                     GL_TEXTURE_BUFFER_OFFSET_ALIGNMENT"
                ),
            ),
            Some(range) if !range.is_empty() && range.end <= length => Ok(Some(range)),
            Some(_) | None => invalid_value(
                RANGE,
                format!(
                    "offset = {offset} and size = {size} must name bytes of the {length} that the \
                     buffer has, at least one"
                ),
            ),
        }
    })
}
