//! The general kernel: probes of a footprint, levels of a probe, one level after the other.
//!
//! A batch runs level by level: each distinct (filter, face, level) of its 64 lanes is sampled once in
//! all lanes, and a mask selects the lanes that read it. Most batches have one to three. The result of a lane does not
//! depend on the levels of other lanes.

use super::call::SampleCall;
use super::compare::unit_range;
use super::coordinates::Coordinates;
use super::footprint::{Footprint, FootprintSet, Probes};
use super::interpolate::{lerp_of_any, mix};
use super::level_taps::{self, LevelTaps};
use super::level_view::LevelView;
use super::recorder::Recorder;
use super::row_scan::{self, RowScan};
use super::{cube, expand, filter};
use crate::kernels::LookupKernel;
use crate::lanes::{F32s, Kernel, LANES, Simd, U32s};
use crate::plan::Texture;
use crate::trace::SampleStep;

impl<R: Recorder, F: FootprintSet> Kernel for SampleCall<'_, R, F> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { texture, coords, layer, reference, offset, lod, out, recorder, footprints: _ } =
            self;
        let reference = match texture.compare {
            Some(_) => unit_range(reference.unwrap_or(coords[2])),
            None => F32s::ZERO,
        };
        let mut at = Coordinates::in_plane(*coords);
        at.locate(texture, layer, recorder);
        let (taps, footprint) = level_taps::taps::<S, F>(texture, &at, *lod, recorder);
        let (probes, scan) = match &footprint {
            Footprint::Probes(probes) if F::PROBES => (Some(probes), None),
            Footprint::Scan(scan) if F::SCANS => (None, Some(scan)),
            Footprint::Isotropic | Footprint::Probes(_) | Footprint::Scan(_) => (None, None),
        };
        let context = SampleContext { texture, offset, reference: &reference, scan };
        sample_probes::<S, F>(&context, &at, &taps, probes, out, recorder);
        expand::expand(texture.format, texture.depth_mode, out);
        expand::swizzle(texture.format, texture.swizzle, out);
    }
}

/// The arguments that all probes and levels of a batch share.
struct SampleContext<'a> {
    texture: &'a Texture,
    offset: [i32; 3],
    reference: &'a F32s,
    /// Set where the footprints are scanned.
    scan: Option<&'a RowScan>,
}

/// The running mean of the probes: the mean of equal probes is exactly their value.
#[inline(always)]
fn sample_probes<S: Simd, F: FootprintSet>(
    context: &SampleContext<'_>,
    at: &Coordinates<'_>,
    taps: &LevelTaps,
    probes: Option<&Probes>,
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let probe_count = match probes {
        Some(probes) => {
            LookupKernel::GeneralProbes.note();
            probes.max_count
        }
        None => 1,
    };
    let mut probe_coords = None;
    let mut face_taps;
    let mut sample = None;
    for probe in 0..probe_count {
        let mut coords = at.filtered();
        let mut read = taps;
        if let Some(probes) = probes {
            let to = probe_coords.get_or_insert([F32s::ZERO; 3]);
            let axes = context.texture.shape.axes();
            for (axis, to) in to.iter_mut().enumerate().take(axes) {
                probe_coordinate(at.filtered()[axis], probes, axis, probe, to);
            }
            if context.texture.shape.is_cube() {
                let (faces, st) = cube::reproject(at.face(), [&to[0], &to[1]]);
                [to[0], to[1]] = st;
                face_taps = taps.on_faces(&faces);
                read = &face_taps;
            }
            coords = [&to[0], &to[1], &to[2]];
        }
        if let Some(probes) = probes {
            recorder.restrict_to(|lane| (probe as f32) < probes.count[lane]);
            recorder.record(|lane| SampleStep::Probe {
                number: probe,
                of: probes.count[lane] as u32,
                at: coords.map(|coord| coord[lane]),
            });
        }
        let target = if probe == 0 { &mut *out } else { sample.get_or_insert([F32s::ZERO; 4]) };
        let participates =
            |lane: usize| probes.is_none_or(|probes| (probe as f32) < probes.count[lane]);
        sample_taps::<S, F>(context, coords, &at.layer, read, participates, target, recorder);
        let (Some(probes), Some(sample)) = (probes, &sample) else { continue };
        let weight = 1.0 / (probe + 1) as f32;
        for channel in 0..context.texture.format.channels() {
            for lane in 0..LANES {
                let before = out[channel][lane];
                let mean = lerp_of_any(before, sample[channel][lane], weight);
                let counts = (probe as f32) < probes.count[lane];
                out[channel][lane] = if counts { mean } else { before };
            }
        }
        recorder.record(|lane| SampleStep::Mean(out.each_ref().map(|channel| channel[lane])));
    }
}

/// One coordinate of a probe's centre.
#[inline(always)]
fn probe_coordinate(from: &F32s, probes: &Probes, axis: usize, probe: u32, to: &mut F32s) {
    for lane in 0..LANES {
        let steps = probe as f32 - 0.5 * (probes.count[lane] - 1.0);
        to[lane] = from[lane] + steps * probes.step[axis][lane];
    }
}

/// Samples every distinct key once, and mixes two levels.
#[inline(always)]
fn sample_taps<S: Simd, F: FootprintSet>(
    context: &SampleContext<'_>,
    at: [&F32s; 3],
    layer: &U32s,
    taps: &LevelTaps,
    participates: impl Fn(usize) -> bool,
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    match taps {
        LevelTaps::Uniform(_) => LookupKernel::GeneralOneLevel.note(),
        LevelTaps::UniformPair { .. } => LookupKernel::GeneralTwoLevels.note(),
        LevelTaps::PerLane { .. } => LookupKernel::GeneralPerLane.note(),
    }
    let channels = context.texture.format.channels();
    let mut second = None;
    let mut per_lane = None;
    let mut key = taps.next::<S>(0);
    while key != level_taps::NO_KEY {
        let target = match taps {
            LevelTaps::UniformPair { keys, .. } if key == keys[1] => {
                second.get_or_insert([F32s::ZERO; 4])
            }
            LevelTaps::Uniform(_) | LevelTaps::UniformPair { .. } | LevelTaps::PerLane { .. } => {
                &mut *out
            }
        };
        recorder.restrict_to(|lane| participates(lane) && taps.of_lane(lane).contains(&key));
        let mask = match context.scan {
            Some(_) => taps.lane_mask(key),
            None => U32s::ZERO,
        };
        sample_key::<S, F>(context, key, at, [layer, &mask], target, recorder);
        if let LevelTaps::PerLane { keys, .. } = taps {
            let [first, second] = per_lane.get_or_insert([[F32s::ZERO; 4]; 2]);
            copy_lanes::<S>(&keys[0], key, channels, out, first);
            copy_lanes::<S>(&keys[1], key, channels, out, second);
        }
        key = taps.next::<S>(key);
    }
    match (taps, &second, &per_lane) {
        (LevelTaps::UniformPair { weight, .. }, Some(second), _) => {
            for channel in 0..channels {
                let first = out[channel];
                mix(&first, &second[channel], weight, &mut out[channel]);
            }
        }
        (LevelTaps::PerLane { weight, .. }, _, Some([first, second])) => {
            for channel in 0..channels {
                mix(&first[channel], &second[channel], weight, &mut out[channel]);
            }
        }
        (
            LevelTaps::Uniform(_) | LevelTaps::UniformPair { .. } | LevelTaps::PerLane { .. },
            _,
            _,
        ) => {}
    }
    recorder
        .restrict_to(|lane| participates(lane) && taps.of_lane(lane)[0] != taps.of_lane(lane)[1]);
    recorder.record(|lane| SampleStep::Mixed(out.each_ref().map(|channel| channel[lane])));
    recorder.restrict_to(participates);
}

/// Copies the values of the lanes that read this key.
#[inline(always)]
fn copy_lanes<S: Simd>(
    keys: &U32s,
    key: u32,
    channels: usize,
    values: &[F32s; 4],
    per_lane: &mut [F32s; 4],
) {
    let mut mask = U32s::ZERO;
    for lane in 0..LANES {
        mask[lane] = if keys[lane] == key { !0 } else { 0 };
    }
    if !S::any(&mask) {
        return;
    }
    for channel in 0..channels {
        let (from, to) = (values[channel].as_u32(), per_lane[channel].as_u32_mut());
        for lane in 0..LANES {
            to[lane] = from[lane] & mask[lane] | to[lane] & !mask[lane];
        }
    }
}

/// Samples one level of one face. Only lanes in the mask get a defined result.
#[inline(always)]
fn sample_key<S: Simd, F: FootprintSet>(
    context: &SampleContext<'_>,
    key: u32,
    at: [&F32s; 3],
    [layer, mask]: [&U32s; 2],
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let SampleContext { texture, offset, reference, scan } = *context;
    let (filter, face, number) = level_taps::split_key(key);
    let level = &*texture.levels[face][number];
    let view = LevelView { texture, filter, face, number, level, layer, reference };
    let moved = (offset != [0; 3]).then(|| shifted(&view, at, offset));
    // One call site: the whole level kernel is inlined here.
    let at = match &moved {
        Some([s, t, r]) => [s, t, r],
        None => at,
    };
    recorder.record(|_| SampleStep::Level {
        face: face as u32,
        level: number as u32,
        size: level.size(),
        filter,
    });
    match scan {
        Some(scan) if F::SCANS => sample_scanned::<S>(&view, at, scan, mask, out, recorder),
        Some(_) | None if F::ISOTROPIC => filter::sample_level::<S>(&view, at, out, recorder),
        Some(_) | None => {}
    }
    recorder.record(|lane| SampleStep::Filtered(out.each_ref().map(|channel| channel[lane])));
}

/// Samples one level in the lanes of a mask, by rows where footprints are not round.
#[inline(always)]
fn sample_scanned<S: Simd>(
    view: &LevelView<'_>,
    at: [&F32s; 3],
    scan: &RowScan,
    mask: &U32s,
    out: &mut [F32s; 4],
    recorder: &mut impl Recorder,
) {
    let mut round = row_scan::round_lanes(view, scan);
    let mut long = U32s::ZERO;
    for lane in 0..LANES {
        long[lane] = mask[lane] & !round[lane];
        round[lane] &= mask[lane];
    }
    let (has_round, has_long) = (S::any(&round), S::any(&long));
    if has_long {
        recorder.restrict_to(|lane| long[lane] != 0);
        row_scan::level::<S>(view, at, scan, &long, out, recorder);
    }
    if has_round {
        LookupKernel::GeneralRound.note();
        let mut isotropic = [F32s::ZERO; 4];
        recorder.restrict_to(|lane| round[lane] != 0);
        filter::sample_level::<S>(view, at, &mut isotropic, recorder);
        for (out, isotropic) in out.iter_mut().zip(&isotropic) {
            let (out, isotropic) = (out.as_u32_mut(), isotropic.as_u32());
            for lane in 0..LANES {
                out[lane] = isotropic[lane] & round[lane] | out[lane] & !round[lane];
            }
        }
    }
    recorder.restrict_to(|lane| mask[lane] != 0);
}

/// The coordinates with an offset in texels of this level.
#[inline(always)]
fn shifted(view: &LevelView<'_>, at: [&F32s; 3], offset: [i32; 3]) -> [F32s; 3] {
    LookupKernel::GeneralOffset.note();
    let size = view.level.size();
    let mut shifted = [F32s::ZERO; 3];
    for axis in 0..view.texture.shape.axes() {
        let scale = view.texture.shape.scale(size[axis]);
        let shift = offset[axis] as f32 / scale;
        for lane in 0..LANES {
            shifted[axis][lane] = at[axis][lane] + shift;
        }
    }
    shifted
}
