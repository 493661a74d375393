//! Two varyings that are selected by the facing of a polygon are one whose planes are those of the side that is seen:
//! pictures are those of a program that interpolates both and selects.

use super::super::common::{bindings, bytes, device, image, pass, pipeline, vertex, viewport};
use super::packing::{SIZE, triangles};
use rasterizer::driver::{
    Command, CommandBuffer, Pipeline, PipelineDesc, PointState, PolygonMode, PolygonState,
    RasterState, ShaderModule, VertexBinding, VertexSource,
};
use rasterizer::ir::{Builder, Input, Interpolation, Op, Output, Stage};
use std::sync::Arc;
use texunit::format::Format;
use texunit::lanes::Isa;

/// What the plan says where the planes select two of the varyings.
const LEFT_OUT: &str = "left out: 2 of the side that is not seen";

/// How a fragment program writes a selection by facing.
#[derive(Clone, Copy, Debug)]
enum Selection {
    /// As `front ? a : b`, for which the planes are found.
    ByFacing,
    /// As `!front ? b : a`, which stays.
    ByNegation,
}

/// Varyings 0 and 1 at front faces and 4 and 5 at back faces, and varying 6 at both.
fn selecting(selection: Selection, mode: Interpolation) -> ShaderModule {
    let mut b = Builder::new(Stage::Fragment);
    b.module_mut().varyings = vec![mode; 8];
    let facing = b.input(Input::FrontFacing);
    let selected = [0, 1].map(|slot| {
        let [front, back] = [slot, slot + 4].map(|slot| b.input(Input::Varying(slot)));
        match selection {
            Selection::ByFacing => b.op(Op::SelectF, &[facing, front, back]),
            Selection::ByNegation => {
                let is_back = b.op(Op::Not, &[facing]);
                b.op(Op::SelectF, &[is_back, back, front])
            }
        }
    });
    let [other, one] = [b.input(Input::Varying(6)), b.float(1.0)];
    for (component, value) in [selected[0], selected[1], other, one].into_iter().enumerate() {
        let out = b.output(Output::Color { target: 0, component: component as u8 });
        b.store(out, value);
    }
    ShaderModule::new(b.finish()).expect("valid")
}

/// A position, four values of front faces and four of back faces a vertex.
fn two_sided() -> (Arc<[VertexBinding]>, u32) {
    let vertices: Vec<f32> = triangles()
        .chunks(8)
        .flat_map(|vertex| {
            let back = vertex[4..].iter().rev().map(|value| 0.75 - 0.5 * value);
            vertex.iter().copied().chain(back).collect::<Vec<_>>()
        })
        .collect();
    (bindings(&vertices, 3), vertices.len() as u32 / 12)
}

struct Scene {
    mode: Interpolation,
    raster: RasterState,
    vertices: Arc<[VertexBinding]>,
    count: u32,
}

/// The picture of a scene, and what is said of its draw.
fn drawn(isa: Isa, threads: usize, scene: &Scene, selection: Selection) -> (Vec<u8>, String) {
    let desc: PipelineDesc = pipeline(vertex(8), selecting(selection, scene.mode));
    let color = image(Format::Rgba32F, SIZE, SIZE);
    let commands = vec![
        pass(&color, None, SIZE, SIZE),
        viewport(SIZE, SIZE),
        Command::BindPipeline(Pipeline::new(desc).expect("valid")),
        Command::BindVertices(scene.vertices.clone()),
        Command::SetRaster(Arc::new(scene.raster.clone())),
        Command::Draw { first: 0, count: scene.count, instances: 0..1 },
        Command::EndPass,
    ];
    let device = device(isa, threads);
    device.submit(&CommandBuffer { commands }).expect("legal");
    (bytes(&color), device.take_explanations().concat())
}

/// Compares both selections on every instruction set, and looks whether the planes select.
fn compare(scene: &Scene, planes_select: bool) {
    let (expected, said) = drawn(Isa::BASELINE, 1, scene, Selection::ByNegation);
    assert!(!said.contains("not seen"), "{said}");
    for isa in Isa::executions() {
        for threads in [1, 3] {
            let (picture, said) = drawn(isa, threads, scene, Selection::ByFacing);
            assert_eq!(said.contains(LEFT_OUT), planes_select, "{said}");
            let differing = picture.iter().zip(&expected).filter(|(a, b)| a != b).count();
            assert_eq!(differing, 0, "bytes differ, {} with {threads} threads", isa.name());
        }
    }
    let colors: std::collections::BTreeSet<&[u8]> = expected.chunks(16).collect();
    assert!(colors.len() > 100, "{} colours", colors.len());
}

#[test]
fn smooth_and_flat_varyings_are_those_of_the_side_that_is_seen() {
    let (vertices, count) = two_sided();
    for mode in [Interpolation::Smooth, Interpolation::Flat] {
        let raster = RasterState::default();
        compare(&Scene { mode, raster, vertices: vertices.clone(), count }, true);
        // Few shapes are set up one by one.
        let raster = RasterState::default();
        let few = Scene { mode, raster, vertices: vertices.clone(), count: 15 };
        let [(planes, _), (fragments, _)] = [Selection::ByFacing, Selection::ByNegation]
            .map(|selection| drawn(Isa::BASELINE, 1, &few, selection));
        assert_eq!(planes, fragments);
    }
}

#[test]
fn so_are_those_of_outlines_of_polygons() {
    let (vertices, count) = two_sided();
    for mode in [
        [PolygonMode::Fill, PolygonMode::Line],
        [PolygonMode::Point, PolygonMode::Fill],
        [PolygonMode::Line, PolygonMode::Point],
    ] {
        let polygon = PolygonState { mode, ..RasterState::default().polygon };
        let raster = RasterState { polygon, ..RasterState::default() };
        let vertices = vertices.clone();
        compare(&Scene { mode: Interpolation::Smooth, raster, vertices, count }, true);
    }
}

#[test]
fn sprites_replace_what_fragments_select() {
    let (vertices, count) = two_sided();
    let default = RasterState::default();
    let mode = [PolygonMode::Fill, PolygonMode::Point];
    let raster = RasterState {
        polygon: PolygonState { mode, ..default.polygon.clone() },
        point: PointState { size: 5.0, sprite: Some(vec![4]), ..default.point.clone() },
        ..default
    };
    compare(&Scene { mode: Interpolation::Smooth, raster, vertices, count }, false);
}

#[test]
fn a_side_that_is_equal_at_all_vertices_stays_so() {
    let (vertices, count) = two_sided();
    let mut vertices = vertices.to_vec();
    for binding in vertices.iter_mut().filter(|binding| binding.location == 2) {
        binding.source = VertexSource::Constant([0.1, 0.2, 0.3, 0.7]);
    }
    let raster = RasterState::default();
    let mode = Interpolation::Smooth;
    compare(&Scene { mode, raster, vertices: vertices.into(), count }, false);
}
