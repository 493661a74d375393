//! Pictures that clients write, as PPM, and how far two of them are apart.

use std::path::Path;

/// Rows of RGB bytes, in the client's order.
#[derive(Clone, PartialEq, Eq)]
pub struct Picture {
    pub width: usize,
    pub height: usize,
    pub pixels: Vec<u8>,
}

/// How far two pictures are apart.
#[derive(Clone, Copy, Debug)]
pub struct Distance {
    /// Mean difference of a component, in 255ths.
    pub mean: f64,
    /// The share of pixels of which a component differs by more than 8/255.
    pub visible: f64,
}

impl Picture {
    /// Reads what the clients write: three lines of header.
    pub fn read(path: &Path) -> Self {
        let file = std::fs::read(path).expect("the client wrote a picture");
        let mut parts = file.splitn(4, |&byte| byte == b'\n');
        let mut line = || parts.next().expect("a PPM has a header of three lines");
        let (magic, size, most, pixels) = (line(), line(), line(), line());
        assert_eq!((magic, most), (&b"P6"[..], &b"255"[..]));
        let size = std::str::from_utf8(size).expect("sizes are ASCII");
        let sides: Vec<usize> = size.split(' ').map(|side| side.parse().unwrap()).collect();
        assert_eq!(pixels.len(), sides[0] * sides[1] * 3);
        Self { width: sides[0], height: sides[1], pixels: pixels.to_vec() }
    }

    /// How many different colours it has: a picture of nothing has one.
    pub fn colors(&self) -> usize {
        let mut pixels: Vec<_> = self.pixels.chunks_exact(3).collect();
        pixels.sort_unstable();
        pixels.dedup();
        pixels.len()
    }

    /// The distance from another of the same size.
    pub fn distance(&self, other: &Self) -> Distance {
        assert_eq!((self.width, self.height), (other.width, other.height));
        let differences = || self.pixels.iter().zip(&other.pixels).map(|(a, b)| a.abs_diff(*b));
        let sum: u64 = differences().map(u64::from).sum();
        let differences: Vec<u8> = differences().collect();
        let visible = differences.chunks_exact(3).filter(|pixel| pixel.iter().any(|&d| d > 8));
        Distance {
            mean: sum as f64 / self.pixels.len() as f64,
            visible: visible.count() as f64 / (self.width * self.height) as f64,
        }
    }
}
