//! Conversion of the components of current vertex attributes to floats: GL 2.1, section 2.7.

/// A component of an attribute.
pub(crate) trait Component: Copy {
    /// Whether a conversion is arithmetic.
    const COMPUTES: bool;
    /// Converted: 255 gives 255.0.
    fn plain(self) -> f32;
    /// Integers as fractions (GL 2.1, table 2.9).
    fn normalized(self) -> f32;
}

macro_rules! components {
    ($($ty:ty, $computes:literal: $c:ident => $normalized:expr;)*) => {
        $(impl Component for $ty {
            const COMPUTES: bool = $computes;

            fn plain(self) -> f32 {
                self as f32
            }

            fn normalized(self) -> f32 {
                if !Self::COMPUTES {
                    return self as f32;
                }
                let $c = f64::from(self);
                $normalized as f32
            }
        })*
    };
}

components! {
    u8, true: c => (c / 255.0);
    u16, true: c => (c / 65_535.0);
    u32, true: c => (c / 4_294_967_295.0);
    i8, true: c => ((2.0 * c + 1.0) / 255.0);
    i16, true: c => ((2.0 * c + 1.0) / 65_535.0);
    i32, true: c => ((2.0 * c + 1.0) / 4_294_967_295.0);
    f32, false: c => c;
    f64, true: c => c;
}

/// Missing components are 0, 0, 0, 1.
pub(crate) fn filled<const N: usize>(components: [f32; N]) -> [f32; 4] {
    let mut value = [0.0, 0.0, 0.0, 1.0];
    value[..N].copy_from_slice(&components);
    value
}
