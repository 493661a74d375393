//! Fragments that are shaded at each covered sample (ARB_sample_shading): a batch for each sample, whose planes are moved
//! there.

use super::batch::{Batch, BatchPixels, BlockOf};
use super::job::{DrawJob, PassJob, TileJob};
use super::shading::Shader;
use crate::plan::moved;

impl Shader {
    /// Shades the lanes that passed the early tests, sample by sample.
    #[cold]
    #[inline(never)]
    pub(super) fn shade_samples(
        &mut self,
        pass: &PassJob,
        job: &DrawJob,
        batch: &Batch<'_>,
        tile: &mut TileJob,
    ) {
        let samples = &job.plan.samples;
        for sample in 0..batch.masks.len() {
            let masks = &batch.masks.only(sample);
            if masks.any() == 0 || self.budget.is_stopped() {
                continue;
            }
            self.sample = Some(sample);
            let offset = samples.offset(sample);
            match batch.pixels {
                BatchPixels::Block(of) => {
                    let planes: Vec<[f32; 3]> =
                        of.planes.iter().map(|&plane| moved_plane(plane, offset)).collect();
                    let BlockOf { facing, tests, block, x, y, coverage, .. } = *of;
                    let of = BlockOf { planes: &planes, facing, tests, block, x, y, coverage };
                    let pixels = BatchPixels::Block(&of);
                    self.shade_tested(pass, job, &Batch { pixels, masks, ..*batch }, tile);
                }
                BatchPixels::Packed(packed) => {
                    let packed = packed.with_planes(|plane| moved_plane(plane, offset));
                    let pixels = BatchPixels::Packed(&packed);
                    self.shade_tested(pass, job, &Batch { pixels, masks, ..*batch }, tile);
                }
                // Of one sample.
                BatchPixels::Pixels(_) => {
                    self.shade_tested(pass, job, &Batch { masks, ..*batch }, tile);
                }
            }
            self.sample = None;
        }
    }
}

/// A plane, moved to a sample. One without steps stays as it is, with the sign of a zero.
fn moved_plane(plane: [f32; 3], offset: Option<[f32; 2]>) -> [f32; 3] {
    if plane[1..] == [0.0; 2] { plane } else { moved(plane, offset) }
}
