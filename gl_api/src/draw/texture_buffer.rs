//! The texels of a buffer texture, as a draw reads them.

use crate::base::error::{ErrorCode, GlError, Result, invalid_operation};
use crate::base::limits;
use crate::context::Context;
use crate::objects::buffers::BufferObject;
use crate::objects::target::TextureTarget;
use crate::objects::texture_buffer::DataStore;
use rasterizer::driver::Buffer;
use std::sync::Arc;
use texunit::image::Level;
use texunit::plan::SamplePlan;

const SECTION: &str = "GL 3.1, section 3.8.4";

/// The length of the buffer that a store reads; mapped or not.
pub(crate) fn length(context: &Context, store: &DataStore) -> usize {
    context.objects.shared.buffers.bound(&store.buffer).map_or(0, BufferObject::len)
}

/// How a draw fetches the texels of the texture that is bound to `GL_TEXTURE_BUFFER` of a unit.
///
/// # Errors
/// When the client has the buffer mapped, or there is no memory.
pub(crate) fn plan(context: &mut Context, unit: u8) -> Result<Arc<SamplePlan>> {
    let bound = &context.state.units.units[usize::from(unit)].bound[TextureTarget::Buffer as usize];
    let store = &context.objects.texture(TextureTarget::Buffer, bound).store;
    let buffer = match context.objects.shared.buffers.bound(&store.buffer) {
        Some(object) if object.is_mapped_alone() => {
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
    let level = Level::of_buffer_texture(store.format, bytes, limits::MAX_TEXTURE_BUFFER_SIZE)
        .map_err(|error| GlError::new(ErrorCode::OutOfMemory, SECTION, error.to_string()))?;
    context.recorder.hold(level.texels.len());
    let plan = Arc::new(SamplePlan::for_buffer_texture(level));
    let store = &mut context.objects.texture_mut(TextureTarget::Buffer, bound).store;
    store.plan = Some((buffer.version(), Arc::clone(&plan)));
    Ok(plan)
}
