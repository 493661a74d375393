//! The accumulation buffer of the default framebuffer: GL 2.1, section 4.2.4. Its components are
//! `f32`; it has memory from when it is first used.

/// Red, green, blue and alpha of each pixel, row by row; none before the first use.
#[derive(Clone, Debug, Default)]
pub(crate) struct Accumulation(pub(crate) Vec<[f32; 4]>);
