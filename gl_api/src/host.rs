//! The interface for the crate of the C ABI alone: what EGL, OSMesa and the C functions of the entry points do with
//! contexts.
//!
//! Its types are opaque, so that nothing else of this crate has to be public for it.

use crate::base::constants::*;
use crate::base::error::{ErrorCode, GlError};
use crate::base::types::{GLeglImageOES, GLenum, GLint, GLuint};
use crate::calls::framebuffer::read::{ClientRows, RowOrder, read_rows};
use crate::calls::texture::egl_image;
use crate::context::debug::Output;
use crate::context::reset::ResetNotification;
use crate::context::sharing::CallScope;
use crate::context::window::{Visible, Window, base_level_attachment, format_of};
use crate::context::{Context, ContextDesc, ContextError, SurfaceDesc, sharing};
use crate::draw::warnings::visibility;
use crate::glu::{GLUquadric, GLUquadricCallback};
use crate::objects::egl_images;
use crate::objects::programs::ShaderOrProgram;
use crate::pixel::client::Pixel;
use crate::pixel::client::format::LuminanceOf;
use crate::pixel::convert::{Conversion, FinalConversion};
use crate::pixel::layout::{Extent, Layout};
use crate::pixel::store::PixelStore;
use crate::pixel::transfer::Transfer;
use rasterizer::driver::{DeviceDesc, DeviceError, Image, RowWriter};

pub use crate::base::refused_result::RefusedResult;
pub use crate::calls::texture::egl_image::{EglImageError, EglImageSource};
pub use crate::context::debug::Echo;
pub use crate::context::mirror::SurfaceMirror;
pub use crate::entry::current::{call, expect_thread_end, swap_current};
pub use texunit::lanes::FloatEnv;

/// Limits that hosts check.
pub mod limits {
    use crate::context;

    /// The latest version of OpenGL that contexts can be asked for.
    pub fn version() -> crate::Version {
        crate::base::version::reported()
    }

    /// The latest version of OpenGL ES that contexts can be asked for.
    pub fn es_version() -> crate::Version {
        crate::base::version::IMPLEMENTED_ES
    }

    /// Pixels of a side of a default framebuffer.
    pub const MAX_VIEWPORT_DIMS: u32 = crate::base::limits::MAX_VIEWPORT_DIMS;
    /// Environment parameters of an assembly program.
    pub const MAX_ENV_PARAMETERS: usize = crate::base::assembly_limits::MAX_ENV_PARAMETERS as usize;
    /// Local parameters of an assembly program.
    pub const MAX_LOCAL_PARAMETERS: usize =
        crate::base::assembly_limits::MAX_LOCAL_PARAMETERS as usize;
    /// Colour outputs of a framebuffer.
    pub const MAX_DRAW_BUFFERS: usize = crate::base::limits::MAX_COLOR_ATTACHMENTS;
    /// Components that transform feedback captures into one buffer.
    pub const MAX_CAPTURED_COMPONENTS: usize =
        glsl::limits::MAX_TRANSFORM_FEEDBACK_INTERLEAVED_COMPONENTS;
    /// Elements of an array of uniforms.
    pub const MAX_UNIFORM_ELEMENTS: usize = glsl::limits::MAX_UNIFORM_WORDS as usize;
    /// Bytes of a label with its final zero.
    pub const MAX_LABEL: usize = context::log::MAX_LABEL;
    /// Messages of a log.
    pub const MAX_LOGGED: usize = context::log::MAX_LOGGED;
    /// Bytes of a message with its final zero.
    pub const MAX_LENGTH: usize = context::log::MAX_LENGTH;
    /// Binding points of vertex buffers.
    pub const MAX_VERTEX_BUFFERS: usize = crate::base::limits::MAX_VERTEX_ATTRIB_BINDINGS;
    /// Viewports.
    pub const MAX_VIEWPORTS: usize = rasterizer::driver::MAX_VIEWPORTS;
    /// The order of an evaluator's map.
    pub const MAX_EVAL_ORDER: usize = crate::state::evaluators::MAX_EVAL_ORDER;
}

/// What contexts have that are made without a device of their own.
#[derive(Clone, Debug)]
pub struct ContextInfo {
    /// The name of the instruction set.
    pub isa: &'static str,
    /// How many threads draw.
    pub threads: usize,
    /// The latest version of OpenGL.
    pub gl: crate::Version,
    /// The latest version of OpenGL ES.
    pub es: crate::Version,
    /// Limits by the names of `glGet`, in small letters and without `GL_`.
    pub limits: &'static [(&'static str, u64)],
}

/// What contexts have, by the environment.
///
/// # Errors
/// A variable asks for something that there is not.
pub fn context_info() -> Result<ContextInfo, DeviceError> {
    use crate::base::limits::*;
    const LIMITS: &[(&str, u64)] = &[
        ("max_texture_size", MAX_TEXTURE_SIZE as u64),
        ("max_3d_texture_size", MAX_3D_TEXTURE_SIZE as u64),
        ("max_array_texture_layers", MAX_ARRAY_TEXTURE_LAYERS as u64),
        ("max_viewport_dims", MAX_VIEWPORT_DIMS as u64),
        ("max_color_attachments", MAX_COLOR_ATTACHMENTS as u64),
        ("max_samples", MAX_SAMPLES as u64),
    ];
    let desc = DeviceDesc::from_env()?;
    let (gl, es) = (limits::version(), limits::es_version());
    Ok(ContextInfo { isa: desc.isa.name(), threads: desc.threads, gl, es, limits: LIMITS })
}

/// A default framebuffer that is not, or not yet, a context's.
#[derive(Debug)]
pub struct Surface(Window);

impl Surface {
    /// Buffers of a size; `None` if there is no memory for them.
    pub fn new(width: u32, height: u32, desc: SurfaceDesc) -> Option<Self> {
        Window::new(width, height, desc).ok().map(Self)
    }

    /// The default framebuffer of a context that has none (GL 3.0, section 2.1).
    pub fn absent() -> Self {
        Self(Window::absent())
    }
}

/// What a new context needs to share the objects of another.
#[derive(Clone, Debug)]
pub struct ShareHandle(sharing::ShareHandle);

/// Whether a context logs its messages at first (`KHR_debug`, section 5.5).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DebugOutput {
    /// Not before `glEnable(GL_DEBUG_OUTPUT)`.
    Off,
    /// From the start.
    On,
}

/// A context on the heap, which may share objects: where a client's thread has as little stack as 128 KB.
///
/// # Errors
/// As [`Context::new`].
pub fn new_context(
    desc: ContextDesc,
    shared: Option<ShareHandle>,
    output: DebugOutput,
) -> Result<Box<Context>, ContextError> {
    let mut context = Context::boxed(desc, shared.map(|shared| shared.0))?;
    context.debug.begin_with(match output {
        DebugOutput::Off => Output::Off,
        DebugOutput::On => Output::On,
    });
    Ok(context)
}

/// What a new context needs to share this one's objects. Takes no lock, whatever thread has the context current.
pub fn share(context: &Context) -> ShareHandle {
    ShareHandle(context.share())
}

/// An EGL image, by its handle for GL: until it is dropped.
#[derive(Debug)]
pub struct EglImage(usize);

impl EglImage {
    /// An image that shares the texels of an object of contexts.
    ///
    /// # Errors
    /// EGL's.
    pub fn new(of: &ShareHandle, source: EglImageSource) -> Result<Self, EglImageError> {
        egl_image::make(&of.0, source).map(Self)
    }

    /// The argument of `glEGLImageTargetTexture2DOES`.
    pub fn handle(&self) -> GLeglImageOES {
        std::ptr::without_provenance_mut(self.0)
    }
}

/// Its targets keep the texels.
impl Drop for EglImage {
    fn drop(&mut self) {
        egl_images::withdraw(self.0);
    }
}

/// What it reports of stopped draws.
pub fn reset_notification(context: &Context) -> ResetNotification {
    context.resets.notification
}

/// Replaces the default framebuffer. Nothing may be recorded.
pub fn swap_surface(context: &mut Context, surface: Surface) -> Surface {
    Surface(context.swap_window(surface.0))
}

/// Replaces the default framebuffer that is read from; with `None` it is the one that is drawn to.
pub fn swap_read_surface(context: &mut Context, surface: Option<Surface>) -> Option<Surface> {
    context.swap_read_window(surface.map(|surface| surface.0)).map(Surface)
}

/// Sets viewport and scissor to the size of the first default framebuffer.
pub fn first_surface(context: &mut Context, width: u32, height: u32) {
    context.first_window(width, height);
}

/// Notes that the picture is about to be shown, and warns if nothing that was drawn is visible in it.
pub fn shows_picture(context: &mut Context) {
    visibility::picture(context);
    crate::draw::pass::end_of_frame(context);
}

/// Reports a GL error of the call `name`.
pub fn refuse(
    context: &mut Context,
    name: &'static str,
    section: &'static str,
    text: impl Into<String>,
) {
    context.refuse(name, GlError::new(ErrorCode::InvalidOperation, section, text));
}

/// Sets the mirror, which gets the next picture, or removes it.
pub fn set_mirror(context: &mut Context, mirror: Option<Box<dyn SurfaceMirror>>) {
    context.set_mirror(mirror);
}

/// Replaces how the mirror of a context copies, if there is one.
pub fn replace_mirror(context: &mut Context, mirror: Box<dyn SurfaceMirror>) {
    context.replace_mirror(mirror);
}

/// Submits everything and removes the mirror of a context.
pub fn end_mirror(context: &mut Context) {
    context.end_mirror();
}

/// How a pixel's components lie in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixels {
    /// GL's format and type.
    pub gl: (GLenum, GLenum),
    /// Where alpha is.
    pub alpha: Alpha,
}

/// Where alpha lies in a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Alpha {
    /// Where the format says.
    AsFormat,
    /// First; the other components follow.
    First,
}

/// Which row comes first in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FirstRow {
    /// The lowest.
    Bottom,
    /// The highest.
    Top,
}

/// Bytes of a pixel; `None` if there is no such format and type.
pub fn pixel_bytes(pixels: Pixels) -> Option<usize> {
    Pixel::new(pixels.gl.0, pixels.gl.1).ok().map(|pixel| pixel.bytes())
}

/// Copies the colours of the default framebuffer into memory for all of its rows, each `stride` bytes after the one
/// before.
pub fn copy_colors(
    context: &Context,
    pixels: Pixels,
    first: FirstRow,
    bytes: &mut [u8],
    stride: usize,
) {
    copy(context, &context.window.color, pixels, first, (bytes, stride));
}

/// The depths of the default framebuffer, of the highest 16 to 32 bits; `None` if it has none.
pub fn depths(context: &Context, first: FirstRow, bits: usize) -> Option<Vec<u32>> {
    let image = context.window.depth.as_ref()?;
    let [width, height] = [context.window.width, context.window.height].map(|side| side as usize);
    let mut depths = vec![0_u32; width * height];
    let pixels = Pixels { gl: (GL_DEPTH_COMPONENT, GL_UNSIGNED_INT), alpha: Alpha::AsFormat };
    copy(context, image, pixels, first, (bytemuck::cast_slice_mut(&mut depths), 4 * width));
    depths.iter_mut().for_each(|depth| *depth >>= 32 - bits);
    Some(depths)
}

fn copy(
    context: &Context,
    image: &Image,
    pixels: Pixels,
    first: FirstRow,
    (bytes, stride): (&mut [u8], usize),
) {
    let from = base_level_attachment(image);
    let (Some([width, height]), Some(format)) = (from.size(), format_of(&from)) else { return };
    let all = Visible { x: 0, y: 0, width: width as usize, height: height as usize };
    let Ok(pixel) = Pixel::new(pixels.gl.0, pixels.gl.1) else { return };
    let store = PixelStore { alignment: 1, ..PixelStore::default() };
    let Ok(row) = Layout::new(&store, pixel, [all.width, 1, 1], Extent::Flat) else { return };
    let (transfer, last) = (Transfer::default(), FinalConversion::of(format, LuminanceOf::Sum));
    let conversion = Conversion::pack(context.recorder.isa(), &row, format, &transfer, last);
    let row_bytes = row.row_bytes();
    let convert = |texels: &[u8], out: &mut [u8]| {
        conversion.pack_row(&row, texels, out);
        match pixels.alpha {
            Alpha::AsFormat => {}
            Alpha::First => {
                let (out, alpha) = (&mut out[..row_bytes], pixel.bytes() / 4);
                out.chunks_exact_mut(pixel.bytes()).for_each(|pixel| pixel.rotate_right(alpha));
            }
        }
    };
    let is_copy = conversion.is_copy(&row) && pixels.alpha == Alpha::AsFormat;
    let writer = if is_copy { RowWriter::Copy } else { RowWriter::Convert(&convert) };
    let order = match first {
        FirstRow::Bottom => RowOrder::BottomUp,
        FirstRow::Top => RowOrder::TopDown,
    };
    read_rows(
        &context.recorder.device(),
        &from,
        all,
        ClientRows { bytes, stride, row_bytes, order },
        writer,
    );
}

/// How many values the uniform at a location of a program has; 0 if there is none.
pub fn uniform_values(context: &mut Context, program: GLuint, location: GLint) -> usize {
    let scope = CallScope { context };
    match crate::calls::program::uniform_values::words(scope.context, program, location) {
        Ok((_, words)) => words.len(),
        Err(_) => 0,
    }
}

/// How many shaders are attached to a program; 0 if there is none.
pub fn attached_shaders(context: &mut Context, program: GLuint) -> usize {
    let scope = CallScope { context };
    match scope.context.objects.shared.programs.get(program) {
        Some(ShaderOrProgram::Program(program)) => program.attached.len(),
        Some(ShaderOrProgram::Shader(_)) | None => 0,
    }
}

/// How many values `pname` of a uniform block has; 0 if there are none.
pub fn block_values(context: &mut Context, program: GLuint, index: GLuint, pname: GLenum) -> usize {
    let scope = CallScope { context };
    match crate::calls::program::blocks::block_values(scope.context, program, index, pname) {
        Ok(values) => values.len(),
        Err(_) => 0,
    }
}

/// How many values `GL_COMPRESSED_TEXTURE_FORMATS` has.
pub fn compressed_formats(context: &Context) -> usize {
    crate::query::state::compressed_formats(context).len()
}

/// The setters of quadrics, which return the error callback for a value that was refused: it may delete the quadric, so
/// the caller calls it afterwards.
pub mod quadric {
    use super::{GLUquadric, GLUquadricCallback};
    use crate::base::types::GLenum;

    /// `gluQuadricNormals`.
    pub fn set_normals(quad: &mut GLUquadric, normal: GLenum) -> GLUquadricCallback {
        quad.set_normals(normal)
    }

    /// `gluQuadricOrientation`.
    pub fn set_orientation(quad: &mut GLUquadric, orientation: GLenum) -> GLUquadricCallback {
        quad.set_orientation(orientation)
    }

    /// `gluQuadricDrawStyle`.
    pub fn set_style(quad: &mut GLUquadric, draw: GLenum) -> GLUquadricCallback {
        quad.set_style(draw)
    }

    /// `gluQuadricCallback`.
    pub fn set_callback(
        quad: &mut GLUquadric,
        which: GLenum,
        callback: GLUquadricCallback,
    ) -> GLUquadricCallback {
        quad.set_callback(which, callback)
    }

    /// Calls the error callback of a value that was refused.
    pub fn tell(refused: GLUquadricCallback) {
        crate::glu::tell(refused);
    }
}
