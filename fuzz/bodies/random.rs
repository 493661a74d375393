//! Random numbers for the arguments of calls. Each byte of an input determines one of them.

/// SplitMix64; a byte of the input is mixed into each number until the input ends.
pub struct Random<'a> {
    state: u64,
    bytes: &'a [u8],
}

impl<'a> Random<'a> {
    /// The generator of a seed and an input.
    pub fn new(seed: u64, bytes: &'a [u8]) -> Self {
        Self { state: seed, bytes }
    }

    /// The next number.
    pub fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        if let Some((first, rest)) = self.bytes.split_first() {
            self.state ^= u64::from(*first);
            self.bytes = rest;
        }
        let z = (self.state ^ self.state >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ z >> 31
    }

    /// One of the elements of `from`.
    pub fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[(self.next() % from.len() as u64) as usize]
    }
}
