//! Random numbers for the cases of checks: the same in every run.

/// SplitMix64 (Steele, Lea, Flood 2014).
#[derive(Clone, Debug)]
pub struct Rng(u64);

impl Rng {
    /// The generator that is seeded with a name.
    pub fn named(name: &str) -> Self {
        let fnv = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        Self(name.bytes().fold(0xcbf2_9ce4_8422_2325, fnv))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// An integer in `low..=high`.
    pub fn integer(&mut self, low: i64, high: i64) -> i64 {
        low + (self.next() % (high - low + 1) as u64) as i64
    }

    /// A multiple of `step` in [low, high]; exact in `f32` when `step` is a power of two and the
    /// bounds are within 2^24 steps.
    pub fn dyadic(&mut self, low: f64, high: f64, step: f64) -> f32 {
        (self.integer((low / step) as i64, (high / step) as i64) as f64 * step) as f32
    }

    /// An `f32` in [low, high], rounded from 53 random bits.
    pub fn real(&mut self, low: f64, high: f64) -> f32 {
        let unit = (self.next() >> 11) as f64 / (1u64 << 53) as f64;
        (low + (high - low) * unit) as f32
    }

    /// A byte, uniformly distributed.
    pub fn byte(&mut self) -> u8 {
        self.next() as u8
    }

    /// One of the elements of `of`.
    pub fn pick<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.integer(0, of.len() as i64 - 1) as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_first_number_of_seed_zero() {
        assert_eq!(Rng(0).next(), 0xe220_a839_7b1d_cdaf);
    }

    #[test]
    fn ranges_are_kept() {
        let mut rng = Rng::named("ranges");
        for _ in 0..1000 {
            assert!((-3..=4).contains(&rng.integer(-3, 4)));
            let d = f64::from(rng.dyadic(-1.0, 1.0, 0.125));
            assert!(d.abs() <= 1.0 && (d * 8.0).fract() == 0.0);
        }
    }
}
