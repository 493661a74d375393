//! The nearest texel of each lane's level.

use super::ScatteredLevel;
use crate::lanes::math::index;
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s};
use crate::sample::compare::compare;
use crate::sample::fast::{channels_of_texel, word_offsets};

pub struct Nearest<'a> {
    pub lanes: &'a ScatteredLevel<'a>,
    pub out: &'a mut [F32s; 4],
}

impl Kernel for Nearest<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { lanes: ScatteredLevel { texture, class, sources, level, at, reference }, out } =
            self;
        let u = level.texel_coordinate::<S>(texture.wrap[0], 0, at[0]);
        let v = level.texel_coordinate::<S>(texture.wrap[1], 1, at[1]);
        let (mut x, mut y) = (U32s::ZERO, U32s::ZERO);
        for lane in 0..LANES {
            // A coordinate may be rounded up to the size.
            x[lane] = index(u[lane], (level.size[0][lane] - 1) as i32 as f32);
            y[lane] = index(v[lane], (level.size[1][lane] - 1) as i32 as f32);
        }
        let offsets = level.offsets(level.face, [&x, &y]);
        let numbers = level.sources(level.face);
        let format = texture.format;
        for word in 0..format.words() {
            let words = S::gather_from(sources, &numbers, &word_offsets(&offsets, word));
            channels_of_texel::<S>(*class, format.channels(), word, &words, out);
        }
        if let Some(op) = texture.compare {
            compare(op, reference, &mut out[0]);
        }
    }
}
