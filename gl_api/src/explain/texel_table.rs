//! The texels of a level: which, their weights, where they lie in memory, what they hold.

use crate::base::compare::COMPARE;
use crate::base::constants::enum_name;
use crate::explain::page::{Page, number, numbers};
use texunit::trace::{SampleStep, TexelSource};

/// The names of the faces of a cube.
pub const FACES: [&str; 6] = ["+X", "-X", "+Y", "-Y", "+Z", "-Z"];

/// What the lecture assumes: four bytes of RGBA8.
const BYTES_PER_TEXEL: u32 = 4;

/// Side of the tiles of the second address.
const TILE: u32 = 8;

/// The texels that are read between two steps of another kind.
#[derive(Debug, Default)]
pub struct TexelTable {
    /// The weights of the texels to come.
    weights: Vec<f32>,
    /// The lecture's names of the addresses to come.
    names: Vec<&'static str>,
    /// Width and height of the level.
    size: [u32; 2],
    rows: Vec<Vec<String>>,
}

impl TexelTable {
    /// A level begins.
    pub fn level(&mut self, [width, height, _]: [u32; 3]) {
        self.size = [width, height];
    }

    /// What comes is read by itself.
    pub fn nearest(&mut self) {
        self.weights.clear();
        self.names.clear();
    }

    /// Two texels of a row, and their weights.
    pub fn row(&mut self, weights: [f32; 2]) {
        self.weights.extend(weights);
    }

    /// What comes is the corners of a linear filter: lower before upper along s, then t, then r.
    pub fn linear(&mut self, [alpha, beta, gamma]: [f32; 3], axes: usize) {
        let pair = |t: f32| [1.0 - t, t];
        let mut weights = pair(alpha).to_vec();
        for t in [beta, gamma].into_iter().take(axes.saturating_sub(1)) {
            weights = pair(t).iter().flat_map(|w| weights.iter().map(move |v| v * w)).collect();
        }
        self.weights = weights;
        // The lecture's first digit is of i, its second of j.
        self.names = if axes == 2 { vec!["addr00", "addr10", "addr01", "addr11"] } else { vec![] };
    }

    /// Adds a row.
    pub fn texel(&mut self, step: &SampleStep) {
        let SampleStep::Texel { face, at, source, value, compare } = step else { return };
        if self.rows.is_empty() {
            let heading =
                ["texel", "weight", "address by rows", "in 8×8 tiles", "stored channels", ""];
            self.rows.push(heading.map(String::from).to_vec());
        }
        let weight = if self.weights.is_empty() { 1.0 } else { self.weights.remove(0) };
        let name = if self.names.is_empty() { "" } else { self.names.remove(0) };
        let [i, j, k] = at;
        let note = match (source, compare) {
            (TexelSource::Border, _) => "the border colour".to_owned(),
            (TexelSource::Corner, _) => {
                "beyond the cube's corner: the mean of the others".to_owned()
            }
            (TexelSource::Stored, Some((op, reference, passes))) => {
                format!("r = {} {}: {passes}", number(*reference), enum_name(COMPARE.encode(*op)))
            }
            (TexelSource::Stored, None) if *face > 0 => {
                format!("face {}", FACES[*face as usize % 6])
            }
            (TexelSource::Stored, None) => String::new(),
        };
        let [by_rows, in_tiles] = match source {
            TexelSource::Stored => self.addresses([*i, *j, *k]),
            TexelSource::Border | TexelSource::Corner => [String::new(), String::new()],
        };
        self.rows.push(vec![
            format!("({i}, {j}, {k})"),
            number(weight),
            format!("{name} {by_rows}").trim().to_owned(),
            in_tiles,
            numbers(value),
            note,
        ]);
    }

    /// From the base of the level, in bytes: row after row, and in tiles that are row after row inside.
    fn addresses(&self, [i, j, k]: [u32; 3]) -> [String; 2] {
        let [width, height] = self.size;
        let rows = i + width * (j + height * k);
        let across = width.div_ceil(TILE);
        let tile = i / TILE + across * (j / TILE + height.div_ceil(TILE) * k);
        let tiles = TILE * TILE * tile + i % TILE + TILE * (j % TILE);
        [rows, tiles].map(|texels| format!("base + {}", BYTES_PER_TEXEL * texels))
    }

    /// Prints the rows so far.
    pub fn print(&mut self, page: &mut Page) {
        if !self.rows.is_empty() {
            page.table(5, &std::mem::take(&mut self.rows));
        }
    }
}
