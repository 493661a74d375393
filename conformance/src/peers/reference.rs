//! The reference picture of a frame, computed with the formulas in `f64`.
//!
//! Values that GL stores are rounded to their formats: colours to bytes, a shadow map's depths to 24
//! bits. Everything else is `f64`: vertices are not snapped, derivatives are analytic, and an
//! anisotropic texture is the exact area integral of its base level, since the extension leaves the
//! filter to the implementation.

use super::client::{Mesh, Vertex};
use super::frame::{
    Draw, Fragment, FrameDescription, Lighting, Output, Shading, Step, Texels, Texture,
};
use crate::mutation::Variant;
use crate::oracle::filter::Addressing;
use crate::oracle::lod::{Derivatives, LevelRange, Levels, LodState};
use crate::oracle::mipmap::{Storage, Volume};
use crate::oracle::sample::{self, Sampler};
use crate::oracle::texture::Level;
use crate::oracle::wrap::Wrap;
use crate::oracle::{cube, lod, matrix, seamless, vertex};
use crate::reference::map::Homography;
use crate::reference::{Reconstruction, area};

const TRUE: Variant = Variant::CORRECT;

/// The pixels whose columns and rows are multiples of `every`; the others are left as they are
/// cleared.
#[derive(Clone, Debug)]
pub struct ReferencePicture {
    /// RGBA, rows from the lowest.
    pub pixels: Vec<[u8; 4]>,
    /// 1 when every pixel counts.
    pub every: usize,
}

/// Draws a frame of `side` × `side` pixels.
pub fn render(recipe: &FrameDescription, side: usize) -> ReferencePicture {
    // The area integral is slow; a sixteenth of the pixels is enough.
    let every = if recipe.textures.iter().any(|texture| texture.anisotropy > 1.0) { 4 } else { 1 };
    let mut target = Target::new(side, every);
    let mut textures: Vec<Image> = recipe.textures.iter().map(Image::new).collect();
    for step in &recipe.steps {
        match step {
            Step::Clear(color) => target.clear(*color),
            Step::Draw(draw) => target.draw(draw, &textures),
            Step::ShadowMap(draw) => {
                let mut depth = Target::new(side, 1);
                depth.draw(draw, &[]);
                textures[0].shadow = depth.depths;
            }
            Step::Upload(level) => textures[0].levels[0] = level.clone(),
            Step::GenerateMipmaps => textures[0].derive_levels(),
            Step::ReadBack => {}
        }
    }
    let byte = |c: f64| (c * 255.0).round() as u8;
    ReferencePicture { pixels: target.colors.iter().map(|color| color.map(byte)).collect(), every }
}

/// A texture with the levels that a frame has drawn or derived.
struct Image {
    levels: Vec<Level>,
    sampler: Sampler,
    anisotropic: bool,
    /// The levels of a cube map: six faces each.
    cubes: Vec<Vec<Level>>,
    /// Depths of a shadow map, as many rows as columns.
    shadow: Vec<f64>,
}

impl Image {
    fn new(texture: &Texture) -> Self {
        let (levels, cubes, wrap): (_, Vec<Vec<Level>>, _) = match &texture.texels {
            Texels::Given(levels) => (levels.clone(), Vec::new(), Wrap::Repeat),
            Texels::Cube(faces) => {
                let cube = |number: usize| faces.iter().map(|face| face[number].clone()).collect();
                (Vec::new(), (0..faces[0].len()).map(cube).collect(), Wrap::ClampToEdge)
            }
            Texels::ShadowMap => (Vec::new(), Vec::new(), Wrap::Repeat),
        };
        let last = levels.len().max(cubes.len()).saturating_sub(1);
        let sampler = Sampler {
            at: Addressing { wrap: [wrap; 2], border: [0.0; 4] },
            filters: texture.filters,
            lod: LodState::default(),
            range: LevelRange { base: 0, last },
        };
        let anisotropic = texture.anisotropy > 1.0;
        Self { levels, sampler, anisotropic, cubes, shadow: Vec::new() }
    }

    /// The cube map in a direction with these derivatives, filtered across the edges of faces.
    fn cube(&self, direction: [f64; 3], [dx, dy]: [[f64; 3]; 2]) -> [f64; 4] {
        let by = |d: [f64; 3]| cube::derivative(direction, d, TRUE);
        let derivatives = Derivatives { dx: by(dx), dy: by(dy) };
        let lambda = sample::lambda(&self.cubes[0], &self.sampler, &derivatives, TRUE);
        let read = |level: usize| seamless::linear(&self.cubes[level], direction, TRUE);
        match lod::levels(lambda, self.sampler.filters, self.sampler.range, TRUE) {
            Levels::One(level, _) => read(level),
            Levels::Two([a, b], weight, _) => {
                let (a, b) = (read(a), read(b));
                std::array::from_fn(|c| (1.0 - weight) * a[c] + weight * b[c])
            }
        }
    }

    fn derive_levels(&mut self) {
        let base = self.levels[0].clone();
        let texels = (0..base.width * base.height)
            .map(|k| base.texel(k % base.width, k / base.width))
            .collect();
        let volume = Volume { size: [base.width, base.height, 1], texels };
        let byte = |c: f64| (c * 255.0).round() as u8;
        let derived = volume.chain(Storage::Bytes, TRUE).into_iter().map(|level| Level {
            width: level.size[0],
            height: level.size[1],
            texels: level.texels.iter().map(|texel| texel.map(byte)).collect(),
        });
        self.levels = std::iter::once(base).chain(derived).collect();
        self.sampler.range.last = self.levels.len() - 1;
    }

    /// `shadow2D` with `GL_LEQUAL` and `GL_NEAREST`.
    fn compare(&self, [s, t, r]: [f64; 3]) -> f64 {
        let side = self.shadow.len().isqrt();
        let texel = |c: f64| ((c - c.floor()) * side as f64) as usize;
        let stored = self.shadow[texel(t) * side + texel(s)];
        f64::from(u8::from(r.clamp(0.0, 1.0) <= stored))
    }
}

/// The numbers that a triangle's vertices hand to its fragments: (s, t), normal, object
/// coordinates, eye z, colour.
const VARYINGS: usize = 13;

/// A vertex in the window.
struct Corner {
    /// Window x, y, and depth.
    window: [f64; 3],
    /// 1/w.
    inverse_w: f64,
    varyings: [f64; VARYINGS],
}

impl Corner {
    fn new(draw: &Draw, of: &Vertex, side: usize) -> Self {
        let wide = |v: [f32; 3]| v.map(f64::from);
        let [x, y, z] = wide(of.position);
        let eye = vertex::eye(&draw.model_view, [x, y, z, 1.0], wide(of.normal), TRUE);
        let clip = matrix::apply(&draw.projection, eye.position);
        let half = side as f64 / 2.0;
        let ndc = [0, 1, 2].map(|c| clip[c] / clip[3]);
        let color = match draw.shading {
            Shading::Modulate(_) | Shading::CubeMapped | Shading::Program(_) => {
                of.color.map(f64::from)
            }
            Shading::Lit(lighting) => vertex::light(&eye, lighting.lights, &lighting.surface, TRUE),
        };
        let mut varyings = [0.0; VARYINGS];
        varyings[..2].copy_from_slice(&of.st.map(f64::from));
        varyings[2..5].copy_from_slice(&eye.normal);
        varyings[5..8].copy_from_slice(&[x, y, z]);
        varyings[8] = eye.position[2];
        varyings[9..].copy_from_slice(&color);
        let window = [(ndc[0] + 1.0) * half, (ndc[1] + 1.0) * half, (ndc[2] + 1.0) / 2.0];
        Self { window, inverse_w: 1.0 / clip[3], varyings }
    }
}

/// The framebuffer.
struct Target {
    side: usize,
    every: usize,
    colors: Vec<[f64; 4]>,
    depths: Vec<f64>,
}

impl Target {
    fn new(side: usize, every: usize) -> Self {
        let pixels = side * side;
        Self { side, every, colors: vec![[0.0; 4]; pixels], depths: vec![1.0; pixels] }
    }

    fn clear(&mut self, color: [f32; 4]) {
        self.colors.fill(color.map(|c| round_to(f64::from(c), 255.0)));
        self.depths.fill(1.0);
    }

    fn draw(&mut self, draw: &Draw, textures: &[Image]) {
        let Mesh { vertices, indices } = &draw.mesh;
        let corners: Vec<Corner> =
            vertices.iter().map(|vertex| Corner::new(draw, vertex, self.side)).collect();
        for triangle in indices.chunks_exact(3) {
            let [a, b, c] = [0, 1, 2].map(|k| &corners[triangle[k] as usize]);
            self.triangle(draw, textures, [a, b, c]);
        }
    }

    fn triangle(&mut self, draw: &Draw, textures: &[Image], corners: [&Corner; 3]) {
        let Some(plane) = Plane::new(corners) else { return };
        let bounds = |axis: usize| {
            let of = corners.map(|corner| corner.window[axis]);
            let low = of.into_iter().fold(f64::INFINITY, f64::min).floor().max(0.0);
            let high = of.into_iter().fold(0.0, f64::max).ceil().min(self.side as f64);
            low as usize..high as usize
        };
        let (columns, rows, every) = (bounds(0), bounds(1), self.every);
        for y in rows.filter(|y| y % every == 0) {
            for x in columns.clone().filter(|x| x % every == 0) {
                let center = [x as f64 + 0.5, y as f64 + 0.5];
                if plane.covers(center) {
                    self.fragment(draw, textures, &plane, [x, y]);
                }
            }
        }
    }

    fn fragment(&mut self, draw: &Draw, textures: &[Image], plane: &Plane<'_>, [x, y]: [usize; 2]) {
        let point = plane.at([x as f64 + 0.5, y as f64 + 0.5]);
        let pixel = y * self.side + x;
        let depth = round_to(point.depth, f64::from((1 << 24) - 1));
        if draw.output == Output::DepthTest {
            if depth >= self.depths[pixel] {
                return;
            }
            self.depths[pixel] = depth;
        }
        let square = [x as f64, y as f64, x as f64 + 1.0, y as f64 + 1.0];
        let color = shade(draw, textures, &point, square).map(|c| c.clamp(0.0, 1.0));
        let to = &mut self.colors[pixel];
        let blend = draw.output == Output::Blend;
        let source = if blend { color[3] } else { 1.0 };
        for (to, from) in to.iter_mut().zip(color) {
            *to = round_to(source * from + (1.0 - source) * *to, 255.0);
        }
    }
}

/// The nearest multiple of `1 / steps`.
fn round_to(c: f64, steps: f64) -> f64 {
    (c * steps).round() / steps
}

/// A triangle as functions of the window's x and y.
struct Plane<'a> {
    corners: [&'a Corner; 3],
    /// Of each corner: its weight is `[0] x + [1] y + [2]`, 1 at the corner and 0 on the edge
    /// across from it.
    weights: [[f64; 3]; 3],
    /// Whether a point exactly on the edge across from a corner belongs to this triangle: the
    /// other triangle of the edge, whose orientation is the other, says the opposite.
    owns: [bool; 3],
}

/// A point of a triangle.
struct Point {
    depth: f64,
    varyings: [f64; VARYINGS],
    /// By window x, and by window y, of (s, t).
    derivatives: Derivatives,
    /// By window x, and by window y, of the object coordinates.
    object_derivatives: [[f64; 3]; 2],
    /// From the window to (s, t).
    map: Homography,
}

impl<'a> Plane<'a> {
    /// `None` for a triangle without an area.
    fn new(corners: [&'a Corner; 3]) -> Option<Self> {
        let at = |k: usize| corners[k % 3].window;
        let mut owns = [false; 3];
        let mut weights = [[0.0; 3]; 3];
        for k in 0..3 {
            let (p, q, own) = (at(k + 1), at(k + 2), at(k));
            let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
            let value = dx * (own[1] - p[1]) - dy * (own[0] - p[0]);
            if value == 0.0 {
                return None;
            }
            weights[k] = [-dy / value, dx / value, (dy * p[0] - dx * p[1]) / value];
            // A left edge, or a horizontal one that lies above.
            let [rightward, upward, _] = weights[k];
            owns[k] = rightward > 0.0 || (rightward == 0.0 && upward < 0.0);
        }
        Some(Self { corners, weights, owns })
    }

    fn covers(&self, p: [f64; 2]) -> bool {
        (0..3).all(|k| {
            // The edge function itself, which is exact where a division is not.
            let (a, b) = (self.corners[(k + 1) % 3].window, self.corners[(k + 2) % 3].window);
            let own = self.corners[k].window;
            let side = |p: [f64; 2]| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
            let inside = side(p) * side([own[0], own[1]]).signum();
            inside > 0.0 || (inside == 0.0 && self.owns[k])
        })
    }

    /// `Σ weight · value` as a function of x and y.
    fn linear(&self, value: impl Fn(&Corner) -> f64) -> [f64; 3] {
        let values = self.corners.map(value);
        [0, 1, 2].map(|c| (0..3).map(|k| self.weights[k][c] * values[k]).sum())
    }

    fn at(&self, [x, y]: [f64; 2]) -> Point {
        let value = |of: [f64; 3]| of[0] * x + of[1] * y + of[2];
        let below = self.linear(|corner| corner.inverse_w);
        let w = 1.0 / value(below);
        let above = |n: usize| self.linear(|corner| corner.varyings[n] * corner.inverse_w);
        let varyings: [f64; VARYINGS] = std::array::from_fn(|n| value(above(n)) * w);
        let change = |n: usize, axis: usize| (above(n)[axis] - varyings[n] * below[axis]) * w;
        let by = |axis: usize| [0, 1].map(|n| change(n, axis));
        Point {
            depth: value(self.linear(|corner| corner.window[2])),
            varyings,
            derivatives: Derivatives { dx: by(0), dy: by(1) },
            object_derivatives: [0, 1].map(|axis| [5, 6, 7].map(|n| change(n, axis))),
            map: Homography([above(0), above(1), below]),
        }
    }
}

fn shade(draw: &Draw, textures: &[Image], point: &Point, square: [f64; 4]) -> [f64; 4] {
    let v = &point.varyings;
    let (st, color) = ([v[0], v[1]], [v[9], v[10], v[11], v[12]]);
    let texture = |unit: usize, st: [f64; 2]| -> [f64; 4] {
        let image = &textures[unit];
        if image.anisotropic {
            let base = &image.levels[0];
            let (w, h) = (base.width as f64, base.height as f64);
            let to_texels = Homography([[w, 0.0, 0.0], [0.0, h, 0.0], [0.0, 0.0, 1.0]]);
            let map = to_texels.after(&point.map);
            area::mean(base, &map, square, Reconstruction::Bilinear)
        } else {
            sample::sample(&image.levels, &image.sampler, st, &point.derivatives, TRUE)
        }
    };
    match draw.shading {
        Shading::Modulate(units) => (0..units).fold(color, |color, unit| {
            let texel = texture(unit, st);
            std::array::from_fn(|c| color[c] * texel[c])
        }),
        Shading::CubeMapped => {
            let texel = textures[0].cube([v[5], v[6], v[7]], point.object_derivatives);
            std::array::from_fn(|c| color[c] * texel[c])
        }
        Shading::Lit(lighting) => fogged(lighting, color, v[8]),
        Shading::Program(program) => (program.formula)(&Fragment {
            st,
            normal: [v[2], v[3], v[4]],
            object: [v[5], v[6], v[7]],
            color,
            texture_matrix: draw.texture_matrix,
            texture: &texture,
            cube: &|direction| textures[0].cube(direction, [[0.0; 3]; 2]),
            shadow: &|str| textures[0].compare(str),
        }),
    }
}

/// `f = e^-(density · |z|)²` of the colour and the rest of the fog's (section 3.10).
fn fogged(lighting: &Lighting, color: [f64; 4], eye_z: f64) -> [f64; 4] {
    let f = (-(lighting.density * eye_z).powi(2)).exp().clamp(0.0, 1.0);
    let mix = |c: usize| f * color[c] + (1.0 - f) * lighting.fog[c];
    [mix(0), mix(1), mix(2), color[3]]
}
