//! Lookups that are fused into another kernel: the filtered channels of a lane are computed where the consumer uses
//! them, from texels that are still words, and are not stored to memory in between. Same bits as [`super::uniform`].

use super::fast::{self, Addresses, QuadLoad, TexelQuad};
use super::interpolate::lerp;
use super::scratch::{QuadScratch, SelectedLevels};
use super::uniform_levels::{self, UniformLevels};
use crate::format::convert::{byte_channel, byte_of, over_255};
use crate::kernels::LookupKernel;
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s, math};
use crate::plan::{Alpha, Texture};
use crate::sampler::Filter;

/// The result of a lookup, computed lane by lane.
pub trait FilteredTexels {
    /// Red, green, blue or alpha of a lane.
    fn channel(&self, lane: usize, channel: usize) -> f32;

    /// The channel times 255, rounded to the nearest byte.
    #[inline(always)]
    fn byte(&self, lane: usize, channel: usize) -> u32 {
        math::byte(self.channel(lane, channel))
    }

    /// The result as four bytes over 255, first channel lowest, where the result is exactly that: texels of a nearest
    /// filter.
    fn bytes(&self) -> Option<&U32s>;
}

/// The code that a lookup is fused into: see [`crate::plan::SamplePlan::sample_fused`].
pub trait TexelConsumer {
    /// The result of the kernel.
    type Output;
    /// Uses the result. Must be `#[inline(always)]`, see [`crate::lanes::Kernel`].
    fn consume<S: Simd>(self, texels: &impl FilteredTexels) -> Self::Output;
}

/// Colours that an ordinary lookup stored.
pub(crate) struct LaneColors<'a>(pub &'a [F32s; 4]);

impl FilteredTexels for LaneColors<'_> {
    #[inline(always)]
    fn channel(&self, lane: usize, channel: usize) -> f32 {
        self.0[channel][lane]
    }
    #[inline(always)]
    fn bytes(&self) -> Option<&U32s> {
        None
    }
}

/// One texel of four bytes per lane (nearest filter).
struct SingleTexels(U32s);

impl FilteredTexels for SingleTexels {
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
    /// The mean of a channel of the four texels, 0 to 255.
    #[inline(always)]
    fn mean(&self, lane: usize, channel: usize) -> f32 {
        let texel = |corner: usize| byte_of(self.words[corner][lane], channel);
        let [alpha, beta] = [self.weights[0][lane], self.weights[1][lane]];
        let (lower, upper) = (lerp(texel(0), texel(1), alpha), lerp(texel(2), texel(3), alpha));
        lerp(lower, upper, beta)
    }
}

impl FilteredTexels for &TexelQuad {
    #[inline(always)]
    fn channel(&self, lane: usize, channel: usize) -> f32 {
        over_255(self.mean(lane, channel))
    }
    #[inline(always)]
    fn byte(&self, lane: usize, channel: usize) -> u32 {
        // Same byte as `math::unit_byte` of the channel (a test holds this for every mean).
        math::nearest_byte(self.mean(lane, channel))
    }
    #[inline(always)]
    fn bytes(&self) -> Option<&U32s> {
        None
    }
}

/// Texels whose alpha is known to be 1.
struct OpaqueTexels<'a, T>(&'a T);

impl<T: FilteredTexels> FilteredTexels for OpaqueTexels<'_, T> {
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

/// Means of two levels, with the weight of the second.
struct TwoLevelMeans<'a, Q>(&'a [Q; 2], &'a F32s);

impl<Q> FilteredTexels for TwoLevelMeans<'_, Q>
where
    for<'q> &'q Q: FilteredTexels,
{
    #[inline(always)]
    fn channel(&self, lane: usize, channel: usize) -> f32 {
        let Self([first, second], weight) = *self;
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

/// Samples 64 lanes of a fusible texture: texels of red, green, blue and perhaps alpha, a byte each. Returns the
/// consumer where the fast path does not apply.
#[inline(always)]
pub(crate) fn sample_fused<S: Simd, T: TexelConsumer>(
    texture: &Texture,
    coords: [&F32s; 3],
    SelectedLevels { levels, weight, addresses }: SelectedLevels<'_>,
    quads: &mut QuadScratch,
    consumer: T,
) -> Result<T::Output, T> {
    let Some(UniformLevels { filter, face, levels }) = levels else { return Err(consumer) };
    match (filter, texture.alpha) {
        (Filter::Nearest, _) if levels[0] == levels[1] => {
            let view = uniform_levels::face_view(texture, filter, face, levels[0]);
            let Some(mut words) = fast::texels::<S>(&view, coords) else { return Err(consumer) };
            // In texels without alpha the fourth byte is not defined.
            if texture.format.channels() < 4 {
                for word in &mut words.0 {
                    *word |= 0xFF00_0000;
                }
            }
            LookupKernel::FusedNearest.note();
            Ok(consumer.consume::<S>(&SingleTexels(words)))
        }
        // Two levels of one texel each are rare.
        (Filter::Nearest, _) => Err(consumer),
        // Outlined, so that the code size of one does not add to the other.
        (Filter::Linear, Alpha::Stored) => {
            let levels = (face, levels);
            S::outlined(LookupMeans { texture, levels, coords, weight, addresses, quads, consumer })
        }
        (Filter::Linear, Alpha::One) => {
            LookupKernel::FusedOpaque.note();
            let (levels, consumer) = ((face, levels), OpaqueConsumer(consumer));
            let means = LookupMeans { texture, levels, coords, weight, addresses, quads, consumer };
            S::outlined(means).map_err(|OpaqueConsumer(consumer)| consumer)
        }
    }
}

/// A linear filter on one level, or on two.
struct LookupMeans<'a, T> {
    texture: &'a Texture,
    /// The face, and the levels.
    levels: (u32, [u32; 2]),
    coords: [&'a F32s; 3],
    weight: &'a F32s,
    addresses: Addresses,
    quads: &'a mut QuadScratch,
    consumer: T,
}

impl<T: TexelConsumer> Kernel for LookupMeans<'_, T> {
    type Output = Result<T::Output, T>;

    #[inline(always)]
    fn run<S: Simd>(self) -> Self::Output {
        let Self { texture, levels: (face, levels), coords, weight, addresses, quads, consumer } =
            self;
        let is_mixed = levels[0] != levels[1];
        let addresses = if quads.is_inside { addresses } else { Addresses::Compute };
        if addresses == Addresses::Reuse {
            LookupKernel::FusedReused.note();
        }
        quads.is_inside = true;
        let used = &mut quads.levels[..1 + usize::from(is_mixed)];
        for (number, quad) in levels.into_iter().zip(used) {
            let view = uniform_levels::face_view(texture, Filter::Linear, face, number);
            match fast::load_quad::<S>(&view, coords, addresses, quad) {
                QuadLoad::Inside => {}
                QuadLoad::AcrossEdge => {
                    LookupKernel::FusedAcrossEdge.note();
                    quads.is_inside = false;
                }
                QuadLoad::NotApplicable => {
                    quads.is_inside = false;
                    return Err(consumer);
                }
            }
        }
        match is_mixed {
            false => LookupKernel::FusedLinear.note(),
            true => LookupKernel::FusedTwoLevels.note(),
        }
        match is_mixed {
            false => Ok(consumer.consume::<S>(&&quads.levels[0])),
            true => Ok(consumer.consume::<S>(&TwoLevelMeans(&quads.levels, weight))),
        }
    }
}

/// Stores the result to lanes, one loop per channel.
pub(super) struct WriteLanes<'a>(pub &'a mut [F32s; 4]);

impl TexelConsumer for WriteLanes<'_> {
    type Output = ();

    #[inline(always)]
    fn consume<S: Simd>(self, texels: &impl FilteredTexels) {
        let Self([r, g, b, a]) = self;
        write_channel(texels, 0, r);
        write_channel(texels, 1, g);
        write_channel(texels, 2, b);
        write_channel(texels, 3, a);
    }
}

#[inline(always)]
fn write_channel(texels: &impl FilteredTexels, channel: usize, out: &mut F32s) {
    for lane in 0..LANES {
        out[lane] = texels.channel(lane, channel);
    }
}

/// Passes texels on whose alpha is known to be 1.
struct OpaqueConsumer<T>(T);

impl<T: TexelConsumer> TexelConsumer for OpaqueConsumer<T> {
    type Output = T::Output;

    #[inline(always)]
    fn consume<S: Simd>(self, texels: &impl FilteredTexels) -> T::Output {
        self.0.consume::<S>(&OpaqueTexels(texels))
    }
}
