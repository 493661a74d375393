//! Numbers for random calls: the same ones from the same seed.

/// What comes from a seed, one number after the other.
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, end: u64) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % end
    }

    pub fn pick<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len() as u64) as usize]
    }

    pub fn float(&mut self) -> f32 {
        self.below(201) as f32 / 100.0 - 1.0
    }
}
