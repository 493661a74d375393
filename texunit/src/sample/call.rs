//! The arguments of one sample of 64 lanes.

use super::lookup::Lod;
use crate::lanes::F32s;
use crate::plan::Texture;
use std::marker::PhantomData;

/// One call: 64 samples of a complete texture.
pub(crate) struct SampleCall<'a, R, F> {
    pub texture: &'a Texture,
    /// By reference, as is `lod`: a vector copy of words that were just stored one by one would stall on store
    /// forwarding.
    pub coords: &'a [&'a F32s; 3],
    pub layer: Option<&'a F32s>,
    pub reference: Option<&'a F32s>,
    /// Texels added along s, t, r, on each level (GLSL 1.30, section 8.7).
    pub offset: [i32; 3],
    pub lod: &'a Lod<'a>,
    pub out: &'a mut [F32s; 4],
    pub recorder: &'a mut R,
    /// The footprints that the kernel is compiled for.
    pub footprints: PhantomData<F>,
}
