//! Planes of several shapes are those of each by itself, to the bit.

use super::*;
use crate::desc::{Facing, SpriteOrigin, Viewport};
use crate::primitive::{Clipping, ConstantDirection, DepthSetup, ShapeKind};

/// A number in [-1, 1) from a counter.
fn random(state: &mut u64) -> f32 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 40) as f32 / 8_388_608.0 - 1.0
}

#[test]
fn shapes_together_have_the_planes_they_have_alone() {
    have_the_planes_they_have_alone(|n| n % 3 == 0);
}

#[test]
fn so_have_those_of_a_parallel_view() {
    have_the_planes_they_have_alone(|_| true);
}

/// `is_flat` says of which shapes w is 1.
fn have_the_planes_they_have_alone(is_flat: impl Fn(u32) -> bool) {
    let viewport = Viewport {
        x: 3.0,
        y: 5.0,
        width: 640.0,
        height: 480.0,
        near: 0.25,
        far: 1.0,
        depth_clip: Default::default(),
        clip_control: Default::default(),
    };
    let mut state = 9;
    let mut geometry = Geometry::default();
    geometry.stride = VARYINGS + 8;
    let mut shapes = Vec::new();
    for n in 0..64_u32 {
        let w = if is_flat(n) { 1.0 } else { 0.0 };
        for _ in 0..3 {
            let w = if w > 0.0 { w } else { 1.5 + random(&mut state) };
            // Some thin, some degenerate, some huge.
            let size = [0.01, 1e-7, 1.0, 0.0][n as usize % 4];
            let (x, y) = (random(&mut state) * size + 0.3, random(&mut state) * size - 0.2);
            let clip = [x * w, y * w, random(&mut state) * w, w];
            let window = viewport.window(&clip.map(f64::from));
            geometry.snapped.push(window.map(crate::vertex::snap));
            geometry.values.extend(clip);
            geometry.values.extend([0; 8].map(|_| random(&mut state)));
        }
        let vertices = [3 * n, 3 * n + 1, 3 * n + 2];
        shapes.push(Shape {
            corners: vertices.map(|v| geometry.snapped[v as usize]),
            bounds: [[0; 2]; 2],
            vertices,
            provoking: 2,
            clipping: if n % 11 == 0 { Clipping::Cut } else { Clipping::Whole },
            kind: ShapeKind::Triangle,
            facing: if n % 3 == 1 { Facing::Back } else { Facing::Front },
        });
    }
    let setup = PlaneSetup {
        sources: &[
            PlaneSource::Depth,
            PlaneSource::Denominator,
            PlaneSource::Smooth(0),
            PlaneSource::Smooth(2),
            PlaneSource::Flat(1),
            PlaneSource::SmoothOfSides([0, 3]),
            PlaneSource::SmoothOfSides([1, 4]),
            PlaneSource::SmoothOfSides([6, 2]),
            PlaneSource::SmoothOfSides([7, 3]),
            PlaneSource::FlatOfSides([5, 6]),
            PlaneSource::Smooth(7),
        ],
        depth: DepthSetup { viewport, offset: None, resolution: None },
        origin: SpriteOrigin::UpperLeft,
        line_constant: ConstantDirection::Perpendicular,
    };
    let bits = |group: &PlaneGroup, lane: usize| {
        let mut out = [[0.0; 3]; 11];
        group.at(lane, 320, 200, &mut out);
        out.concat().into_iter().map(f32::to_bits).collect::<Vec<_>>()
    };
    let mut single = PlaneGroup::default();
    for isa in Isa::available() {
        let mut group = PlaneGroup::default();
        let mut lanes = ShapeLanes::default();
        lanes.load(shapes.iter());
        group.compute(isa, &setup, &geometry, &lanes, shapes.iter());
        let mut windows = Windows::default();
        windows.compute(isa, [320, 192], &lanes);
        group.evaluate_windows(isa, [320, 192], &windows);
        for (lane, shape) in shapes.iter().enumerate() {
            lanes.load(std::iter::once(shape));
            single.compute(isa, &setup, &geometry, &lanes, std::iter::once(shape));
            let mut at_block = [[0.0; 3]; 11];
            for (row, column) in (0..9).map(|block| (block / 3, block % 3)) {
                if column > windows.extra_blocks[0] || row > windows.extra_blocks[1] {
                    continue;
                }
                let block = row * 3 + column;
                let [x, y] = [0, 1].map(|axis| {
                    let first = 2 * (windows.first_quads[axis][lane] & !3);
                    [320, 192][axis] + first + 8 * [column, row][axis] as i32
                });
                single.at(0, x, y, &mut at_block);
                let bits = |planes: &[[f32; 3]]| {
                    planes.concat().into_iter().map(f32::to_bits).collect::<Vec<_>>()
                };
                let entered: Vec<_> = group.in_window(lane, block).collect();
                assert_eq!(bits(&entered), bits(&at_block), "{} {lane}", isa.name());
            }
            assert_eq!(bits(&group, lane), bits(&single, 0), "{} {lane}", isa.name());
        }
    }
}
