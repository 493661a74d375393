//! The scenes of the error report: a surface, the texture on it, and which point of the texture a
//! point of the picture shows.

use super::texture;
use crate::oracle::texture::Level;
use crate::reference::Reconstruction;
use crate::reference::area;
use crate::reference::map::Homography;
use std::f64::consts::PI;

/// The surface that a texture is mapped to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Surface {
    /// From normalized device coordinates to texels.
    Plane(Homography),
    /// A sphere that fills the picture, seen in parallel projection; the texture goes round it
    /// four times and from pole to pole twice.
    Sphere,
}

/// A scene.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The name in file names and tables.
    pub name: &'static str,
    /// A description.
    pub what: &'static str,
    /// The texture, repeated.
    pub image: Level,
    /// The surface.
    pub surface: Surface,
}

/// How often the texture goes round the sphere.
pub const TURNS: f64 = 4.0;

/// The radius up to which the sphere counts; beyond it a pixel may show its edge.
const LIMB: f64 = 0.97;

/// A plane that is turned away by `tilt` degrees, seen from its front, its texture turned by 20°;
/// `scale` texels a pixel across at the middle of a picture of `side` pixels.
fn plane(tilt: f64, scale: f64, side: usize) -> Homography {
    let (sin, cos) = tilt.to_radians().sin_cos();
    // Half the field of view: so that the far end is three times as far as the near one at most.
    let k = if tilt == 0.0 { 0.5 } else { 0.5 * cos / sin };
    let half = scale * side as f64 / 2.0;
    let floor = Homography([[half * cos, 0.0, 0.0], [0.0, half, 0.0], [0.0, -k * sin, cos]]);
    let (s, c) = 20f64.to_radians().sin_cos();
    let turn = Homography([[c, -s, 17.3], [s, c, 40.9], [0.0, 0.0, 1.0]]);
    turn.after(&floor)
}

/// All scenes, for pictures of `side` × `side` pixels.
pub fn scenes(side: usize) -> Vec<Scene> {
    let town = texture::signs();
    let scene =
        |name, what, image: &Level, surface| Scene { name, what, image: image.clone(), surface };
    let floor = |name, what, tilt| scene(name, what, &town, Surface::Plane(plane(tilt, 1.0, side)));
    vec![
        scene("magnified", "5 pixels a texel", &town, Surface::Plane(plane(0.0, 0.2, side))),
        floor("floor-45", "a floor at 45°", 45.0),
        floor("floor-70", "a floor at 70°", 70.0),
        floor("floor-80", "a floor at 80°", 80.0),
        floor("floor-85", "a floor at 85°", 85.0),
        scene("sphere", "a sphere, its limb left out", &town, Surface::Sphere),
        scene(
            "zone-plate",
            "a zone plate at 2.5 texels a pixel",
            &texture::zone_plate(),
            Surface::Plane(plane(0.0, 2.5, side)),
        ),
        scene(
            "photograph",
            "a photograph at 60°",
            &texture::photograph(),
            Surface::Plane(plane(60.0, 1.5, side)),
        ),
    ]
}

impl Scene {
    /// The texel coordinates that a point in normalized device coordinates shows.
    pub fn texels(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        match self.surface {
            Surface::Plane(map) => map.apply([x, y]),
            Surface::Sphere => {
                let z = (1.0 - x * x - y * y).max(0.0).sqrt();
                let s = TURNS * x.atan2(z) / (2.0 * PI);
                let t = TURNS / 2.0 * y.asin() / PI;
                [s * self.image.width as f64, t * self.image.height as f64]
            }
        }
    }

    /// Whether the error of a pixel is counted.
    pub fn counts(&self, [x, y]: [usize; 2], side: usize) -> bool {
        match self.surface {
            Surface::Plane(_) => true,
            Surface::Sphere => {
                let far = |c: usize| {
                    let [a, b] = [c, c + 1].map(|c| (2.0 * c as f64 / side as f64 - 1.0).abs());
                    a.max(b)
                };
                far(x).hypot(far(y)) < LIMB
            }
        }
    }

    /// The exact mean of the bilinearly reconstructed texture over a pixel. The sphere's pixels are
    /// cut in 4×4 pieces, each of which is taken for a projective map of its corners.
    pub fn reference(&self, [x, y]: [usize; 2], side: usize) -> [f64; 4] {
        let to_ndc = 2.0 / side as f64;
        let of = Reconstruction::Bilinear;
        match self.surface {
            Surface::Plane(map) => {
                let to_ndc =
                    Homography([[to_ndc, 0.0, -1.0], [0.0, to_ndc, -1.0], [0.0, 0.0, 1.0]]);
                let square = [x as f64, y as f64, x as f64 + 1.0, y as f64 + 1.0];
                area::mean(&self.image, &map.after(&to_ndc), square, of)
            }
            Surface::Sphere => {
                const PIECES: usize = 4;
                let mut sum = [0.0; 4];
                for piece in 0..PIECES * PIECES {
                    let low = [
                        x as f64 + (piece % PIECES) as f64 / PIECES as f64,
                        y as f64 + (piece / PIECES) as f64 / PIECES as f64,
                    ];
                    let high = low.map(|c| c + 1.0 / PIECES as f64);
                    let corners = [low, [high[0], low[1]], high, [low[0], high[1]]]
                        .map(|p| self.texels(p.map(|c| c * to_ndc - 1.0)));
                    let square = [low[0], low[1], high[0], high[1]];
                    let mean = area::mean(
                        &self.image,
                        &Homography::of_square(square, corners),
                        square,
                        of,
                    );
                    for (sum, c) in sum.iter_mut().zip(mean) {
                        *sum += c / (PIECES * PIECES) as f64;
                    }
                }
                sum
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_floor_is_stretched_by_the_cosine_of_its_tilt() {
        let map = plane(80.0, 1.0, 256);
        let at = |x: f64, y: f64| map.apply([x, y]);
        let step = 1e-6;
        let length = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) / step;
        let (across, along) =
            (length(at(step, 0.0), at(0.0, 0.0)), length(at(0.0, step), at(0.0, 0.0)));
        assert!(
            (across - 128.0).abs() < 1e-2
                && (along - 128.0 / 80f64.to_radians().cos()).abs() < 1e-1
        );
    }

    #[test]
    fn no_scene_sees_a_horizon() {
        for scene in scenes(64) {
            if let Surface::Plane(map) = scene.surface {
                for corner in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
                    assert!(map.homogeneous(corner)[2] > 0.0, "{}", scene.name);
                }
            }
        }
    }
}
