//! The shapes of a chunk, sorted by the tiles that they may touch.

use crate::primitive::Shape;
use crate::raster::ShapeLists;
use crate::sizes::TILE;
use crate::vertex::Geometry;

/// The shapes of one tile: a range of `binned` of a chunk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TileBin {
    pub layer: u32,
    /// The tile, across and up.
    pub tile: [u32; 2],
    pub first: u32,
    pub end: u32,
}

/// The shapes of each tile that they may touch, in order, layer after layer and tile after tile. Those of layers that
/// do not exist are left out.
pub fn sort_by_layer(geometry: &Geometry, lists: &mut ShapeLists, layers: u32) -> Vec<TileBin> {
    let layer_of = |shape: &Shape| {
        let provoking = shape.vertices[usize::from(shape.provoking)];
        geometry.layer(provoking).filter(|&layer| layer < layers)
    };
    // Sorting is stable. The layer of a shape is given by its place from here on.
    let mut numbered: Vec<(u32, Shape)> =
        lists.shapes.iter().filter_map(|shape| Some((layer_of(shape)?, *shape))).collect();
    numbered.sort_by_key(|&(layer, _)| layer);
    lists.shapes.clear();
    let mut bins = Vec::new();
    let (mut own, mut binned) = (ShapeLists::default(), Vec::new());
    for shapes in numbered.chunk_by(|a, b| a.0 == b.0) {
        own.shapes.clear();
        own.shapes.extend(shapes.iter().map(|&(_, shape)| shape));
        let (first_shape, first) = (lists.shapes.len() as u32, binned.len() as u32);
        bins.extend(sort_by_tile(&mut own).into_iter().map(|bin| TileBin {
            layer: shapes[0].0,
            first: bin.first + first,
            end: bin.end + first,
            ..bin
        }));
        binned.extend(own.binned.iter().map(|&number| number + first_shape));
        lists.shapes.append(&mut own.shapes);
    }
    lists.binned = binned;
    bins
}

/// The shapes of each tile that they may touch, in order, tile after tile.
pub fn sort_by_tile(lists: &mut ShapeLists) -> Vec<TileBin> {
    let ShapeLists { shapes, binned } = lists;
    let tile = |pixel: u16| u32::from(pixel) / TILE;
    let Some(first) = shapes.first() else { return Vec::new() };
    let [mut low, mut high] = first.bounds;
    for shape in &*shapes {
        let [first, last] = shape.bounds;
        for axis in 0..2 {
            low[axis] = low[axis].min(first[axis]);
            high[axis] = high[axis].max(last[axis]);
        }
    }
    let (low, high) = (low.map(tile), high.map(tile));
    if low == high {
        let end = shapes.len() as u32;
        binned.clear();
        binned.extend(0..end);
        return vec![TileBin { layer: 0, tile: low, first: 0, end }];
    }
    let across = (high[0] - low[0] + 1) as usize;
    let up = (high[1] - low[1] + 1) as usize;
    let index = |x: u32, y: u32| (y - low[1]) as usize * across + (x - low[0]) as usize;
    // The first tile of a shape, and the others if there are any.
    let first = |shape: &Shape| {
        let [first, last] = shape.bounds.map(|pixel| pixel.map(tile));
        (index(first[0], first[1]), first != last)
    };
    let all = |shape: &Shape| {
        let [first, last] = shape.bounds.map(|pixel| pixel.map(tile));
        (first[1]..=last[1]).flat_map(move |y| (first[0]..=last[0]).map(move |x| index(x, y)))
    };
    let mut ends = vec![0_u32; across * up];
    for shape in &*shapes {
        match first(shape) {
            (tile, false) => ends[tile] += 1,
            (_, true) => all(shape).for_each(|tile| ends[tile] += 1),
        }
    }
    let mut bins = Vec::new();
    let mut total = 0;
    for (index, end) in ends.iter_mut().enumerate() {
        let first = total;
        total += *end;
        if *end > 0 {
            let tile = [low[0] + (index % across) as u32, low[1] + (index / across) as u32];
            bins.push(TileBin { layer: 0, tile, first, end: total });
        }
        *end = first;
    }
    binned.clear();
    binned.resize(total as usize, 0);
    for (shape, number) in shapes.iter().zip(0..) {
        let mut put = |tile: usize| {
            let at = &mut ends[tile];
            binned[*at as usize] = number;
            *at += 1;
        };
        match first(shape) {
            (tile, false) => put(tile),
            (_, true) => all(shape).for_each(put),
        }
    }
    bins
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::desc::Facing;
    use crate::primitive::{Clipping, ShapeKind};

    #[test]
    fn every_tile_gets_the_shapes_that_touch_it_in_order() {
        let shape = |low: [u16; 2], high: [u16; 2]| Shape {
            corners: [[0; 2]; 3],
            bounds: [low, high],
            vertices: [0; 3],
            provoking: 0,
            clipping: Clipping::Whole,
            kind: ShapeKind::Triangle,
            facing: Facing::Front,
        };
        let shapes = [
            shape([70, 10], [90, 20]),
            shape([60, 60], [70, 70]),
            shape([200, 100], [201, 101]),
            shape([64, 0], [127, 63]),
        ];
        let mut lists = ShapeLists { shapes: shapes.to_vec(), binned: vec![7] };
        let bins = sort_by_tile(&mut lists);
        let binned = lists.binned;
        let by_tile: Vec<([u32; 2], &[u32])> = bins
            .iter()
            .map(|bin| (bin.tile, &binned[bin.first as usize..bin.end as usize]))
            .collect();
        let want: &[([u32; 2], &[u32])] =
            &[([0, 0], &[1]), ([1, 0], &[0, 1, 3]), ([0, 1], &[1]), ([1, 1], &[1]), ([3, 1], &[2])];
        assert_eq!(by_tile, want);
        assert_eq!(sort_by_tile(&mut ShapeLists::default()), vec![]);
    }
}
