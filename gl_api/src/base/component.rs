//! Conversion of the components of current vertex attributes to floats: GL 2.1, section 2.7.

/// A component of an attribute.
pub(crate) trait Component: Copy {
    /// Converted: 255 gives 255.0.
    fn plain(self) -> f32;
    /// Integers as fractions (GL 2.1, table 2.9).
    fn normalized(self) -> f32;
}

macro_rules! components {
    ($($ty:ty: $c:ident => $normalized:expr;)*) => {
        $(impl Component for $ty {
            fn plain(self) -> f32 {
                self as f32
            }

            fn normalized(self) -> f32 {
                let $c = f64::from(self);
                $normalized as f32
            }
        })*
    };
}

components! {
    u8: c => (c / 255.0);
    u16: c => (c / 65_535.0);
    u32: c => (c / 4_294_967_295.0);
    i8: c => ((2.0 * c + 1.0) / 255.0);
    i16: c => ((2.0 * c + 1.0) / 65_535.0);
    i32: c => ((2.0 * c + 1.0) / 4_294_967_295.0);
    f32: c => c;
    f64: c => c;
}

/// Missing components are 0, 0, 0, 1.
pub(crate) fn filled<const N: usize>(components: [f32; N]) -> [f32; 4] {
    let mut value = [0.0, 0.0, 0.0, 1.0];
    value[..N].copy_from_slice(&components);
    value
}
