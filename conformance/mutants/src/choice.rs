//! A random choice of mistakes.

use crate::error::MutantsError;
use crate::places::{Place, places};
use std::collections::BTreeSet;
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
    pub place: Place,
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

/// A generator of random numbers (SplitMix64).
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ z >> 31) % end as u64) as usize
    }
}

/// `count` mistakes of the files whose path contains `only`, or all if there are fewer; the same for the same seed and
/// sources. Also says how many there are to choose from.
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
        let found = places(&text).map_err(|source| MutantsError::Syntax { path, source })?;
        all.extend(found.into_iter().map(|place| (file.clone(), place)));
    }
    if all.is_empty() {
        return Err(MutantsError::NothingSelected(only.to_owned()));
    }
    let mut random = Random(seed);
    let kept = count.min(all.len());
    for at in 0..kept {
        let other = at + random.below(all.len() - at);
        all.swap(at, other);
    }
    let from = all.len();
    all.truncate(kept);
    all.sort_by(|(a, p), (b, q)| (a, p.range.start, &p.after).cmp(&(b, q.range.start, &q.after)));
    let mutants = (1..).zip(all).map(|(number, (file, place))| Mutant { number, file, place });
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
    fn a_seed_chooses_the_same_mistakes_again() {
        let names = |seed| {
            let (mutants, from) = choose(&root(), "texunit", 30, seed).expect("files that parse");
            assert!(from > 1000, "{from}");
            mutants
                .iter()
                .map(|m| format!("{}:{}", m.file, m.place.range.start))
                .collect::<Vec<_>>()
        };
        assert_eq!(names(7), names(7));
        assert_ne!(names(7), names(8));
    }
}
