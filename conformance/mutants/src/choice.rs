//! A random choice of mistakes.

use crate::error::MutantsError;
use crate::replacements::{Replacement, replacements};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// Folders and files of the driver whose expressions decide about values of pixels, relative to the workspace.
pub const DRIVER: [&str; 47] = [
    "texunit/src/sample",
    "texunit/src/format",
    "texunit/src/image/fetch.rs",
    "texunit/src/image/blocks.rs",
    "texunit/src/lanes/math",
    "texunit/src/mipmap.rs",
    "texunit/src/mipmap",
    "texunit/src/pixel",
    "texunit/src/plan/lod_range.rs",
    "texunit/src/plan/selection.rs",
    "rasterizer/src/attachment",
    "rasterizer/src/output",
    "rasterizer/src/plan/samples.rs",
    "rasterizer/src/plan/stipple.rs",
    "rasterizer/src/primitive/clip.rs",
    "rasterizer/src/primitive/line.rs",
    "rasterizer/src/primitive/outline.rs",
    "rasterizer/src/primitive/planes.rs",
    "rasterizer/src/primitive/setup.rs",
    "rasterizer/src/primitive/triangles.rs",
    "rasterizer/src/raster/area.rs",
    "rasterizer/src/raster/edge_functions.rs",
    "rasterizer/src/raster/fragment_depth.rs",
    "rasterizer/src/raster/inputs.rs",
    "rasterizer/src/raster/interpolate.rs",
    "rasterizer/src/raster/line_rectangle.rs",
    "rasterizer/src/raster/perspective.rs",
    "rasterizer/src/raster/plane_weights.rs",
    "rasterizer/src/raster/sampled_triangle.rs",
    "rasterizer/src/raster/shading.rs",
    "rasterizer/src/raster/shape_cover.rs",
    "rasterizer/src/raster/small_triangles.rs",
    "rasterizer/src/raster/large_triangles.rs",
    "rasterizer/src/vertex",
    "gl_api/src/generate/fixed",
    "gl_api/src/draw/fixed_function",
    "gl_api/src/draw/raster_state.rs",
    "gl_api/src/draw/pixel_rectangle.rs",
    "gl_api/src/draw/pixel_zoom.rs",
    "gl_api/src/pixel",
    "gl_api/src/calls/evaluate",
    "gl_api/src/calls/framebuffer",
    "gl_api/src/calls/pixels",
    "gl_api/src/calls/transform",
    "gl_api/src/draw/feedback",
    "gl_api/src/glu",
    "gl_api/src/base/inverse.rs",
];

/// A mistake with its number, from 1.
#[derive(Clone, Debug)]
pub struct Mutant {
    /// What `DETGL_MUTANT` is for it.
    pub number: u32,
    /// The file, relative to the workspace.
    pub file: String,
    /// What becomes of which expression.
    pub replacement: Replacement,
}

/// The source files below [`DRIVER`].
///
/// # Errors
/// When a folder cannot be read.
pub fn driver_files(root: &Path) -> Result<BTreeSet<String>, MutantsError> {
    let mut files = BTreeSet::new();
    for entry in DRIVER {
        add_files(root, entry, &mut files)?;
    }
    Ok(files)
}

fn add_files(root: &Path, path: &str, files: &mut BTreeSet<String>) -> Result<(), MutantsError> {
    let full = root.join(path);
    if full.is_dir() {
        for entry in fs::read_dir(&full).map_err(MutantsError::io(&full))? {
            let name = entry.map_err(MutantsError::io(&full))?.file_name();
            add_files(root, &format!("{path}/{}", name.to_string_lossy()), files)?;
        }
    } else if path.ends_with(".rs") && !path.contains("test") {
        files.insert(path.to_owned());
    }
    Ok(())
}

/// The rank of a mistake in the random order of a seed: a hash (FNV-1a, mixed as SplitMix64 does) of what it is, the
/// `nth` of its file that reads so. A change of the sources elsewhere leaves it as it is.
fn rank(seed: u64, file: &str, mistake: &Replacement, nth: u64) -> u64 {
    let words = [seed, nth].into_iter().flat_map(u64::to_le_bytes);
    let texts = [file, &mistake.before, &mistake.after];
    let bytes = words.chain(texts.into_iter().flat_map(|text| text.bytes().chain([0])));
    let mut z = bytes.fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ z >> 31
}

/// `count` mistakes of the files whose path contains `only`, or all if there are fewer; the same for the same seed and
/// sources, nearly the same after a change of the sources. Also says how many there are to choose from.
///
/// # Errors
/// When a file cannot be read or does not parse.
pub fn choose(
    root: &Path,
    only: &str,
    count: usize,
    seed: u64,
) -> Result<(Vec<Mutant>, usize), MutantsError> {
    let mut all = Vec::new();
    for file in driver_files(root)?.into_iter().filter(|file| file.contains(only)) {
        let path = root.join(&file);
        let text = fs::read_to_string(&path).map_err(MutantsError::io(&path))?;
        let found = replacements(&text).map_err(|source| MutantsError::Syntax { path, source })?;
        let mut alike: BTreeMap<(String, String), u64> = BTreeMap::new();
        for mistake in found {
            let nth = alike.entry((mistake.before.clone(), mistake.after.clone())).or_default();
            all.push((rank(seed, &file, &mistake, *nth), file.clone(), mistake));
            *nth += 1;
        }
    }
    if all.is_empty() {
        return Err(MutantsError::NothingSelected(only.to_owned()));
    }
    let from = all.len();
    all.sort_by_key(|(rank, ..)| *rank);
    all.truncate(count);
    all.sort_by(|(_, a, p), (_, b, q)| {
        (a, p.range.start, &p.after).cmp(&(b, q.range.start, &q.after))
    });
    let mutants =
        (1..).zip(all).map(|(number, (_, file, replacement))| Mutant { number, file, replacement });
    Ok((mutants.collect(), from))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root() -> std::path::PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
    }

    #[test]
    fn everything_that_is_listed_exists() {
        for entry in DRIVER {
            assert!(root().join(entry).exists(), "{entry}");
        }
    }

    #[test]
    fn mistakes_that_read_the_same_have_ranks_of_their_own() {
        let mistake = |before: &str| Replacement {
            line: 7,
            range: 3..9,
            before: before.to_owned(),
            after: "b".to_owned(),
        };
        let first = rank(1, "a.rs", &mistake("a"), 0);
        let moved = Replacement { line: 8, range: 30..36, ..mistake("a") };
        assert_eq!(rank(1, "a.rs", &moved, 0), first);
        let others = [
            rank(2, "a.rs", &mistake("a"), 0),
            rank(1, "b.rs", &mistake("a"), 0),
            rank(1, "a.rs", &mistake("c"), 0),
            rank(1, "a.rs", &mistake("a"), 1),
        ];
        assert!(others.into_iter().all(|other| other != first));
    }

    #[test]
    fn a_seed_chooses_the_same_mistakes_again() {
        let names = |seed| {
            let (mutants, from) = choose(&root(), "texunit", 30, seed).expect("files that parse");
            assert!(from > 1000, "{from}");
            mutants
                .iter()
                .map(|m| format!("{}:{}", m.file, m.replacement.range.start))
                .collect::<Vec<_>>()
        };
        assert_eq!(names(7), names(7));
        assert_ne!(names(7), names(8));
    }
}
