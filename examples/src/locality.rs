//! The lines of a cache that texels take, by the order of their addresses.

use gl_api::glu::angle::sin_cos_degrees;

/// How the texels of a level follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Row after row, as the lecture has it.
    Rows,
    /// Tiles of 8 × 8 texels, row by row, and row by row inside.
    Tiles,
    /// The bits of i and j in turn.
    Morton,
}

/// All orders.
pub const ORDERS: [Order; 3] = [Order::Rows, Order::Tiles, Order::Morton];

/// RGBA8.
const BYTES_PER_TEXEL: u32 = 4;
/// Bytes of a line of the cache.
const LINE: u32 = 64;
/// Lines of the cache.
const LINES: usize = 64;
/// Side of the texture.
const WIDTH: u32 = 256;

impl Order {
    /// The address of texel (i, j), from the base of a level that is `width` texels wide.
    pub fn address(self, i: u32, j: u32, width: u32) -> u32 {
        let texel = match self {
            Self::Rows => i + j * width,
            Self::Tiles => {
                let tile = i / 8 + j / 8 * (width / 8);
                64 * tile + i % 8 + 8 * (j % 8)
            }
            Self::Morton => (0..16)
                .map(|bit| (i >> bit & 1) << (2 * bit) | (j >> bit & 1) << (2 * bit + 1))
                .sum(),
        };
        BYTES_PER_TEXEL * texel
    }
}

/// Lines that are loaded a pixel: 128 × 64 pixels, row by row, one texel a pixel, of a texture that is turned about
/// the middle; each reads four texels. The cache drops the line that was not used for longest.
pub fn lines_per_pixel(order: Order, degrees: f64) -> f64 {
    const ACROSS: i32 = 128;
    const DOWN: i32 = 64;
    let (sin, cos) = sin_cos_degrees(degrees);
    let mut cache: Vec<u32> = Vec::with_capacity(LINES + 1);
    let mut loaded = 0;
    for y in 0..DOWN {
        for x in 0..ACROSS {
            let (dx, dy) = (f64::from(x - ACROSS / 2) + 0.5, f64::from(y - DOWN / 2) + 0.5);
            let (u, v) = (dx * cos - dy * sin, dx * sin + dy * cos);
            let place = |at: f64| (at - 0.5).floor() as i32;
            for (di, dj) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
                let wrap = |at: i32| at.rem_euclid(WIDTH as i32) as u32;
                let (i, j) = (wrap(place(u) + di), wrap(place(v) + dj));
                let line = order.address(i, j, WIDTH) / LINE;
                match cache.iter().rposition(|&held| held == line) {
                    Some(at) => {
                        cache.remove(at);
                    }
                    None => loaded += 1,
                }
                cache.push(line);
                if cache.len() > LINES {
                    cache.remove(0);
                }
            }
        }
    }
    f64::from(loaded) / f64::from(ACROSS * DOWN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_texel_has_an_address_of_its_own() {
        for order in ORDERS {
            let mut found: Vec<u32> =
                (0..256).map(|at| order.address(at % 16, at / 16, 16)).collect();
            found.sort_unstable();
            assert!(found.iter().zip(0..).all(|(&address, at)| address == 4 * at), "{order:?}");
        }
    }

    #[test]
    fn morton_order_takes_turns_with_the_bits() {
        assert_eq!(Order::Morton.address(0b11, 0b01, 16), 4 * 0b0111);
        assert_eq!(Order::Rows.address(3, 1, 16), 4 * 19);
        assert_eq!(Order::Tiles.address(9, 1, 16), 4 * (64 + 9));
    }

    #[test]
    fn rows_suffer_from_a_quarter_turn_and_squares_do_not() {
        let [rows, _, morton] =
            ORDERS.map(|order| lines_per_pixel(order, 90.0) / lines_per_pixel(order, 0.0));
        assert!(rows > 8.0 && morton < 1.5, "{rows} {morton}");
    }
}
