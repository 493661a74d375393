//! The room of the lightmap picture: surfaces with a decal each, and their light,
//! precomputed as by Quake 2's `qrad`.

use crate::matrix::{DVec3, dvec3};
use crate::picture::{Color, Picture, add, dim};

/// The decals' files.
pub const DECALS: [&str; 3] = ["bricks.ppm", "flagstones.ppm", "planks.ppm"];

/// A rectangle of wall, floor, ceiling or crate.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// The corner at texture coordinate (0, 0).
    pub origin: DVec3,
    /// The edge along s.
    pub s_edge: DVec3,
    /// The edge along t; s × t faces into the room.
    pub t_edge: DVec3,
    /// The decal's file.
    pub decal: &'static str,
    /// Repetitions of the decal per unit of length.
    pub density: f64,
}

struct Lamp {
    at: DVec3,
    color: Color,
}

/// A crate or pillar, and its decal.
struct Block {
    low: DVec3,
    high: DVec3,
    decal: &'static str,
    density: f64,
}

const LAMPS: [Lamp; 4] = [
    Lamp { at: dvec3(-0.9, 2.1, -3.4), color: [1.9, 1.5, 0.95] },
    Lamp { at: dvec3(1.3, 2.1, -7.2), color: [2.0, 1.1, 0.5] },
    Lamp { at: dvec3(-1.2, 2.2, -12.2), color: [0.7, 1.3, 2.6] },
    Lamp { at: dvec3(0.9, 1.2, -15.0), color: [0.5, 1.0, 0.45] },
];

const BLOCKS: [Block; 5] = [
    Block {
        low: dvec3(0.55, 0., -5.7),
        high: dvec3(1.65, 1.1, -4.6),
        decal: DECALS[2],
        density: 0.91,
    },
    Block {
        low: dvec3(0.75, 1.1, -5.5),
        high: dvec3(1.4, 1.75, -4.85),
        decal: DECALS[2],
        density: 1.54,
    },
    Block {
        low: dvec3(-1.75, 0., -8.9),
        high: dvec3(-0.65, 1.1, -7.8),
        decal: DECALS[2],
        density: 0.91,
    },
    Block {
        low: dvec3(-2., 0., -10.6),
        high: dvec3(-1.5, 3., -10.1),
        decal: DECALS[1],
        density: 0.5,
    },
    Block {
        low: dvec3(1.5, 0., -10.6),
        high: dvec3(2., 3., -10.1),
        decal: DECALS[1],
        density: 0.5,
    },
];

/// Width, height and length of the corridor; it begins at z = 0 and goes toward -z.
const SIZE: DVec3 = dvec3(4.0, 3.0, 16.0);

/// Ambient light.
const AMBIENT: Color = [0.07, 0.07, 0.09];
/// Lightmap texels per unit of length.
const LUXELS: f64 = 8.0;
/// The lamps' size, for soft shadows.
const LAMP_RADIUS: f64 = 0.09;

/// Every surface of the corridor.
pub fn surfaces() -> Vec<Surface> {
    let (width, height, length) = (SIZE.x, SIZE.y, SIZE.z);
    let (x, y, z) = (DVec3::X * width, DVec3::Y * height, DVec3::Z * length);
    let corner = dvec3(-width / 2.0, 0.0, -length);
    let [bricks, stones, planks] = DECALS;
    let wall =
        |origin, s_edge, t_edge, decal, density| Surface { origin, s_edge, t_edge, decal, density };
    let mut all = vec![
        wall(corner, z, x, stones, 0.5),
        wall(corner + y, x, z, planks, 0.5),
        wall(corner + z, -z, y, bricks, 0.5),
        wall(corner + x, z, y, bricks, 0.5),
        wall(corner, x, y, bricks, 0.5),
    ];
    all.extend(BLOCKS.iter().flat_map(Block::surfaces));
    all
}

impl Block {
    /// The four sides and the top, facing outward.
    fn surfaces(&self) -> [Surface; 5] {
        let size = self.high - self.low;
        let (x, y, z) = (DVec3::X * size.x, DVec3::Y * size.y, DVec3::Z * size.z);
        let side = |origin, s_edge, t_edge| Surface {
            origin,
            s_edge,
            t_edge,
            decal: self.decal,
            density: self.density,
        };
        [
            side(self.low + z, x, y),
            side(self.low + x, -x, y),
            side(self.low, z, y),
            side(self.low + x + z, -z, y),
            side(self.low + y + z, x, -z),
        ]
    }

    /// Whether the segment from `from` to `to` intersects the box.
    fn blocks(&self, from: DVec3, to: DVec3) -> bool {
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for axis in 0..3 {
            let way = to[axis] - from[axis];
            // A segment parallel to the slab divides by zero, which gives infinities of the right sign.
            let (a, b) =
                ((self.low[axis] - from[axis]) / way, (self.high[axis] - from[axis]) / way);
            enter = enter.max(a.min(b));
            leave = leave.min(a.max(b));
        }
        enter < leave
    }
}

impl Surface {
    /// The unit normal.
    pub fn normal(&self) -> DVec3 {
        self.s_edge.cross(self.t_edge).normalize()
    }

    /// The lightmap, the row at t = 0 first.
    pub fn lightmap(&self) -> Picture {
        let texels = |edge: DVec3| (edge.length() * LUXELS).ceil();
        let (width, height) = (texels(self.s_edge), texels(self.t_edge));
        let normal = self.normal();
        Picture::paint_centers(width as usize, height as usize, |s, t| {
            let point = self.origin + self.s_edge * s + self.t_edge * t + normal * 1e-3;
            LAMPS.iter().fold(AMBIENT, |sum, lamp| add(sum, lamp.light(point, normal)))
        })
    }
}

impl Lamp {
    /// The irradiance at a point, from distance, angle and the visible fraction of each lamp.
    fn light(&self, point: DVec3, normal: DVec3) -> Color {
        let way = self.at - point;
        let distance = way.length();
        let facing = (normal.dot(way) / distance).max(0.0);
        if facing == 0.0 {
            return [0.0; 3];
        }
        let corners = (0..8).filter(|corner| {
            let sign = |bit: i32| if corner & bit == 0 { -LAMP_RADIUS } else { LAMP_RADIUS };
            let seen = self.at + dvec3(sign(1), sign(2), sign(4));
            BLOCKS.iter().all(|block| !block.blocks(point, seen))
        });
        let visible = corners.count() as f64 / 8.0;
        dim(self.color, visible * facing / (0.9 + distance * distance * 0.36))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_stops_only_what_passes_through_it() {
        let block = &BLOCKS[0];
        let (left, right) = (dvec3(0.0, 0.5, -5.0), dvec3(2.0, 0.5, -5.0));
        assert!(block.blocks(left, right));
        assert!(!block.blocks(left, left + DVec3::Y));
        assert!(!block.blocks(left + DVec3::Y * 2.0, right + DVec3::Y * 2.0));
    }

    #[test]
    fn surfaces_face_into_the_room() {
        let center = dvec3(0.0, SIZE.y / 2.0, -SIZE.z / 2.0);
        for surface in &surfaces()[..5] {
            assert!(surface.normal().dot(center - surface.origin) > 0.0, "{surface:?}");
        }
    }

    #[test]
    fn the_floor_is_lit_and_hardly_washed_out() {
        let floor = surfaces()[0].lightmap();
        assert!(floor.pixels.iter().any(|pixel| pixel.r > 150));
        let washed_out = floor.pixels.iter().filter(|pixel| pixel.r == 255).count();
        assert!(washed_out < floor.pixels.len() / 20);
    }
}
