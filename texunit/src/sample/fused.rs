//! Lookups that are part of another kernel: what a lane gets is computed where it is used, from texels that are
//! still words, and lies in no memory between. The numbers are those of [`super::uniform`].

use super::fast::{self, Places, QuadLoad, TexelQuad};
use super::interpolate::lerp;
use super::scratch::{Known, QuadScratch};
use super::uniform_levels::{self, Read};
use crate::format::convert::{byte_channel, byte_of, over_255};
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s, math};
use crate::plan::{Alpha, Texture};
use crate::sampler::Filter;

/// What a lookup gives.
pub trait Texels {
    /// Red, green, blue or alpha of a lane.
    fn channel(&self, lane: usize, channel: usize) -> f32;

    /// The same to the nearest byte.
    #[inline(always)]
    fn byte(&self, lane: usize, channel: usize) -> u32 {
        math::byte(self.channel(lane, channel))
    }

    /// The same as four bytes over 255, where that is all that they are.
    fn bytes(&self) -> Option<&U32s>;
}

/// What is done with it, as part of the kernel: see [`crate::plan::SamplePlan::take`].
pub trait Take {
    /// What comes of it.
    type Output;
    /// Does it. `#[inline(always)]`, see [`crate::lanes::Kernel`].
    fn take<S: Simd>(self, texels: &impl Texels) -> Self::Output;
}

/// Computed before.
pub(crate) struct LaneColors<'a>(pub &'a [F32s; 4]);

impl Texels for LaneColors<'_> {
    #[inline(always)]
    fn channel(&self, lane: usize, channel: usize) -> f32 {
        self.0[channel][lane]
    }
    #[inline(always)]
    fn bytes(&self) -> Option<&U32s> {
        None
    }
}

/// A texel of four bytes.
struct SingleTexels(U32s);

impl Texels for SingleTexels {
    #[inline(always)]
    fn channel(&self, lane: usize, channel: usize) -> f32 {
        byte_channel(self.0[lane], channel)
    }
    #[inline(always)]
    fn bytes(&self) -> Option<&U32s> {
        Some(&self.0)
    }
}

impl TexelQuad {
    /// Of the four texels' bytes.
    #[inline(always)]
    fn mean(&self, lane: usize, channel: usize) -> f32 {
        let texel = |corner: usize| byte_of(self.words[corner][lane], channel);
        let [alpha, beta] = [self.weights[0][lane], self.weights[1][lane]];
        let (lower, upper) = (lerp(texel(0), texel(1), alpha), lerp(texel(2), texel(3), alpha));
        lerp(lower, upper, beta)
    }
}

impl Texels for &TexelQuad {
    #[inline(always)]
    fn channel(&self, lane: usize, channel: usize) -> f32 {
        over_255(self.mean(lane, channel))
    }
    #[inline(always)]
    fn byte(&self, lane: usize, channel: usize) -> u32 {
        // As `unit_byte` of the channel, whichever mean it is: see the tests.
        math::nearest_byte(self.mean(lane, channel))
    }
    #[inline(always)]
    fn bytes(&self) -> Option<&U32s> {
        None
    }
}

/// Of texels whose alpha is 1.
struct OpaqueTexels<'a, T>(&'a T);

impl<T: Texels> Texels for OpaqueTexels<'_, T> {
    #[inline(always)]
    fn channel(&self, lane: usize, channel: usize) -> f32 {
        if channel == 3 { 1.0 } else { self.0.channel(lane, channel) }
    }
    #[inline(always)]
    fn byte(&self, lane: usize, channel: usize) -> u32 {
        if channel == 3 { 255 } else { self.0.byte(lane, channel) }
    }
    #[inline(always)]
    fn bytes(&self) -> Option<&U32s> {
        None
    }
}

/// Of two levels, with the weight of the second.
struct TwoLevelMeans<'a>(&'a [TexelQuad; 2], &'a F32s);

impl Texels for TwoLevelMeans<'_> {
    #[inline(always)]
    fn channel(&self, lane: usize, channel: usize) -> f32 {
        let Self([first, second], weight) = self;
        // As `interpolate::mix`: means of bytes are finite, and the weight is not below 0.
        lerp(first.channel(lane, channel), second.channel(lane, channel), weight[lane])
    }
    #[inline(always)]
    fn byte(&self, lane: usize, channel: usize) -> u32 {
        // A mean of bytes over 255.
        math::unit_byte(self.channel(lane, channel))
    }
    #[inline(always)]
    fn bytes(&self) -> Option<&U32s> {
        None
    }
}

/// Looks up 64 lanes of a texture whose texels are red, green, blue and, if any, alpha in bytes; gives `take` back
/// where that leads nowhere.
#[inline(always)]
pub(crate) fn sample_fused<S: Simd, T: Take>(
    texture: &Texture,
    coords: [&F32s; 3],
    Known { read, weight, places }: Known<'_>,
    squares: &mut QuadScratch,
    take: T,
) -> Result<T::Output, T> {
    let Some(Read { filter, levels }) = read else { return Err(take) };
    match (filter, texture.alpha) {
        (Filter::Nearest, _) if levels[0] == levels[1] => {
            let view = uniform_levels::plane_view(texture, filter, levels[0]);
            let Some(mut words) = fast::texels::<S>(&view, coords) else { return Err(take) };
            // Of texels without alpha the fourth byte is anything.
            if texture.format.channels() < 4 {
                for word in &mut words.0 {
                    *word |= 0xFF00_0000;
                }
            }
            Ok(take.take::<S>(&SingleTexels(words)))
        }
        // Two levels of one texel each are rare.
        (Filter::Nearest, _) => Err(take),
        // Kernels of their own, so that none carries another's size.
        (Filter::Linear, Alpha::Stored) => {
            S::apart(LookupMeans { texture, levels, coords, weight, places, squares, take })
        }
        (Filter::Linear, Alpha::One) => {
            let take = OpaqueConsumer(take);
            let mean = LookupMeans { texture, levels, coords, weight, places, squares, take };
            S::apart(mean).map_err(|OpaqueConsumer(take)| take)
        }
    }
}

/// The means of texels of one level, or of two.
struct LookupMeans<'a, T> {
    texture: &'a Texture,
    levels: [u32; 2],
    coords: [&'a F32s; 3],
    weight: &'a F32s,
    places: Places,
    squares: &'a mut QuadScratch,
    take: T,
}

impl<T: Take> Kernel for LookupMeans<'_, T> {
    type Output = Result<T::Output, T>;

    #[inline(always)]
    fn run<S: Simd>(self) -> Self::Output {
        let Self { texture, levels, coords, weight, places, squares, take } = self;
        let reads_both = levels[0] != levels[1];
        let places = if squares.inside { places } else { Places::Own };
        squares.inside = true;
        let wanted = &mut squares.levels[..1 + usize::from(reads_both)];
        for (number, square) in levels.into_iter().zip(wanted) {
            let view = uniform_levels::plane_view(texture, Filter::Linear, number);
            match fast::load_quad::<S>(&view, coords, places, square) {
                QuadLoad::Inside => {}
                QuadLoad::AcrossEdge => squares.inside = false,
                QuadLoad::NotApplicable => {
                    squares.inside = false;
                    return Err(take);
                }
            }
        }
        match reads_both {
            false => Ok(take.take::<S>(&&squares.levels[0])),
            true => Ok(take.take::<S>(&TwoLevelMeans(&squares.levels, weight))),
        }
    }
}

/// Takes a lookup as lanes, each channel computed in one loop.
pub(super) struct WriteLanes<'a>(pub &'a mut [F32s; 4]);

impl Take for WriteLanes<'_> {
    type Output = ();

    #[inline(always)]
    fn take<S: Simd>(self, texels: &impl Texels) {
        let Self([r, g, b, a]) = self;
        spread(texels, 0, r);
        spread(texels, 1, g);
        spread(texels, 2, b);
        spread(texels, 3, a);
    }
}

#[inline(always)]
fn spread(texels: &impl Texels, channel: usize, out: &mut F32s) {
    for lane in 0..LANES {
        out[lane] = texels.channel(lane, channel);
    }
}

/// Takes texels of which it is known that their alpha is 1.
struct OpaqueConsumer<T>(T);

impl<T: Take> Take for OpaqueConsumer<T> {
    type Output = T::Output;

    #[inline(always)]
    fn take<S: Simd>(self, texels: &impl Texels) -> T::Output {
        self.0.take::<S>(&OpaqueTexels(texels))
    }
}
