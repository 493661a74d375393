//! The texture chapter of GL 2.1 in scalar `f64`, written from its text and not from the crate.
//!
//! Where the specification steps (a nearest texel, a nearest level, the switch between filters),
//! a point close to the step may fall on either side in `f32`. Each answer therefore carries its
//! distance from the nearest step that it took.

use texunit::format::BaseFormat;
use texunit::image::{Image, Level, Shape};
use texunit::sampler::{Compare, DepthMode, Filter, Mipmap, Sampler, Wrap};

/// Where λ comes from.
#[derive(Clone, Copy)]
pub enum Detail {
    Lambda(f64),
    Derivatives { dx: [f64; 3], dy: [f64; 3], bias: f64 },
}

/// A sample, and how far away the nearest step is (in texels or levels).
#[derive(Clone, Copy)]
pub struct Answer {
    pub rgba: [f64; 4],
    pub margin: f64,
}

pub struct Oracle<'a> {
    pub image: &'a Image,
    pub sampler: &'a Sampler,
    pub reference: f64,
}

impl Oracle<'_> {
    pub fn sample(&self, at: [f64; 3], detail: Detail) -> Answer {
        let sampler = self.sampler;
        let (face, [s, t], mut margin) = match self.image.shape() {
            Shape::Cube => {
                let (face, margin) = select_face(at);
                (face, project(face, at), margin)
            }
            _ => (0, [at[0], at[1]], f64::INFINITY),
        };
        let base = sampler.base_level as usize;
        let level0 = self.image.level(face, base).unwrap();
        let size = [f64::from(level0.width), f64::from(level0.height)];

        let lambda_base = match detail {
            Detail::Lambda(lambda) => lambda + f64::from(sampler.lod_bias).clamp(-16.0, 16.0),
            Detail::Derivatives { dx, dy, bias } => {
                let along = |d: [f64; 3]| match self.image.shape() {
                    Shape::Cube => {
                        // The projection's own slope, by a central difference.
                        let h = 1e-6;
                        let ahead = project(face, [0, 1, 2].map(|i| at[i] + h * d[i]));
                        let behind = project(face, [0, 1, 2].map(|i| at[i] - h * d[i]));
                        [0, 1].map(|i| (ahead[i] - behind[i]) / (2.0 * h))
                    }
                    _ => [d[0], d[1]],
                };
                let length = |d: [f64; 2]| (d[0] * size[0]).hypot(d[1] * size[1]);
                let rho = length(along(dx)).max(length(along(dy)));
                rho.log2() + (f64::from(sampler.lod_bias) + bias).clamp(-16.0, 16.0)
            }
        };
        let lambda = lambda_base.max(f64::from(sampler.min_lod)).min(f64::from(sampler.max_lod));

        let c = match (sampler.mag, sampler.min, sampler.mipmap) {
            (Filter::Linear, Filter::Nearest, Mipmap::Nearest | Mipmap::Linear) => 0.5,
            _ => 0.0,
        };
        // A λ that is held at a bound is the same number in any precision.
        let exact = lambda != lambda_base;
        if !exact && (sampler.min != sampler.mag || c > 0.0) {
            margin = margin.min((lambda - c).abs());
        }
        if lambda <= c {
            return self.level(face, base, sampler.mag, [s, t], margin);
        }
        let largest = level0.width.max(level0.height);
        let q = (base + largest.ilog2() as usize).min(sampler.max_level as usize);
        let level = base as f64 + lambda;
        match sampler.mipmap {
            Mipmap::None => self.level(face, base, sampler.min, [s, t], margin),
            Mipmap::Nearest => {
                let step = (lambda - 0.5 - (lambda - 0.5).round()).abs();
                let d = if lambda <= 0.5 {
                    base
                } else if level <= q as f64 + 0.5 {
                    (level + 0.5).ceil() as usize - 1
                } else {
                    q
                };
                self.level(face, d, sampler.min, [s, t], margin.min(step))
            }
            Mipmap::Linear => {
                let d1 = if level >= q as f64 { q } else { level.floor() as usize };
                let d2 = (d1 + 1).min(q);
                let first = self.level(face, d1, sampler.min, [s, t], margin);
                let second = self.level(face, d2, sampler.min, [s, t], margin);
                let weight = if level >= q as f64 { 0.0 } else { lambda - lambda.floor() };
                Answer {
                    rgba: [0, 1, 2, 3]
                        .map(|i| (1.0 - weight) * first.rgba[i] + weight * second.rgba[i]),
                    margin: first.margin.min(second.margin),
                }
            }
        }
    }

    /// One level with one filter.
    fn level(&self, face: usize, level: usize, filter: Filter, st: [f64; 2], m: f64) -> Answer {
        let level = self.image.level(face, level).unwrap();
        let sizes = [level.width, level.height];
        let [u, v] = [0, 1].map(|i| wrapped(self.sampler.wrap[i], st[i], f64::from(sizes[i])));
        match filter {
            Filter::Nearest => {
                let [(i, near_i), (j, near_j)] = [0, 1].map(|axis| {
                    let (x, n) = ([u, v][axis], f64::from(sizes[axis]));
                    let wrap = self.sampler.wrap[axis];
                    let held = wrap == Wrap::Clamp && !(0.0..=1.0).contains(&st[axis]);
                    let margin = if held { f64::INFINITY } else { (x - x.round()).abs() };
                    let last = wrap != Wrap::ClampToBorder && x >= n;
                    (if last { n - 1.0 } else { x.floor() }, margin)
                });
                Answer { rgba: self.texel(level, i, j), margin: m.min(near_i).min(near_j) }
            }
            Filter::Linear => {
                let mut rgba = [0.0; 4];
                let (i0, j0) = ((u - 0.5).floor(), (v - 0.5).floor());
                let (alpha, beta) = (u - 0.5 - i0, v - 0.5 - j0);
                for (dj, wj) in [(0.0, 1.0 - beta), (1.0, beta)] {
                    for (di, wi) in [(0.0, 1.0 - alpha), (1.0, alpha)] {
                        let fold = |wrap: Wrap, i: f64, n: u32| match wrap {
                            Wrap::Repeat => i.rem_euclid(f64::from(n)),
                            // Weightless beyond the edge.
                            Wrap::ClampToEdge | Wrap::MirroredRepeat => {
                                i.clamp(0.0, f64::from(n) - 1.0)
                            }
                            Wrap::Clamp | Wrap::ClampToBorder => i,
                        };
                        let i = fold(self.sampler.wrap[0], i0 + di, level.width);
                        let j = fold(self.sampler.wrap[1], j0 + dj, level.height);
                        let texel = self.texel(level, i, j);
                        for c in 0..4 {
                            rgba[c] += wi * wj * texel[c];
                        }
                    }
                }
                Answer { rgba, margin: m }
            }
        }
    }

    /// One texel or the border, compared, as a colour.
    fn texel(&self, level: &Level, i: f64, j: f64) -> [f64; 4] {
        let inside =
            i >= 0.0 && j >= 0.0 && i < f64::from(level.width) && j < f64::from(level.height);
        let border = self.sampler.border.map(f64::from);
        let base = level.format.base();
        let channels = match level.channels_at([i as i32, j as i32, 0]).filter(|_| inside) {
            // Conversions have their own oracles, beside them.
            Some(channels) => channels.map(f64::from),
            None => {
                let mut channels = [0.0; 4];
                for (channel, &source) in channels.iter_mut().zip(base.sources()) {
                    *channel = border[source];
                }
                channels
            }
        };
        if !level.format.is_depth() {
            return color(base, channels);
        }
        let depth = channels[0];
        let r = if self.reference.is_nan() { 0.0 } else { self.reference.clamp(0.0, 1.0) };
        let pass = |on: bool| if on { 1.0 } else { 0.0 };
        let d = match self.sampler.compare {
            None => depth,
            Some(Compare::Never) => 0.0,
            Some(Compare::Always) => 1.0,
            Some(Compare::Less) => pass(r < depth),
            Some(Compare::LessEqual) => pass(r <= depth),
            Some(Compare::Equal) => pass(r == depth),
            Some(Compare::NotEqual) => pass(r != depth),
            Some(Compare::GreaterEqual) => pass(r >= depth),
            Some(Compare::Greater) => pass(r > depth),
        };
        match self.sampler.depth_mode {
            DepthMode::Luminance => [d, d, d, 1.0],
            DepthMode::Intensity => [d; 4],
            DepthMode::Alpha => [0.0, 0.0, 0.0, d],
        }
    }
}

/// Section 3.8.7: the coordinate after the wrap mode, in texels.
fn wrapped(wrap: Wrap, s: f64, n: f64) -> f64 {
    let half = 0.5 / n;
    n * match wrap {
        Wrap::Repeat => s - s.floor(),
        Wrap::Clamp => s.clamp(0.0, 1.0),
        Wrap::ClampToEdge => s.clamp(half, 1.0 - half),
        Wrap::ClampToBorder => s.clamp(-half, 1.0 + half),
        Wrap::MirroredRepeat => {
            let fraction = s - s.floor();
            let even = s.floor().rem_euclid(2.0) == 0.0;
            (if even { fraction } else { 1.0 - fraction }).clamp(half, 1.0 - half)
        }
        Wrap::MirrorClamp => s.abs().clamp(half, 1.0),
        Wrap::MirrorClampToEdge => s.abs().clamp(half, 1.0 - half),
    }
}

/// The face of the largest component, and by how much it is the largest.
fn select_face(r: [f64; 3]) -> (usize, f64) {
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| r[b].abs().total_cmp(&r[a].abs()));
    let largest = order[0];
    let face = 2 * largest + usize::from(r[largest] < 0.0);
    (face, r[largest].abs() - r[order[1]].abs())
}

/// Table 3.19.
fn project(face: usize, [x, y, z]: [f64; 3]) -> [f64; 2] {
    let (sc, tc, ma) = match face {
        0 => (-z, -y, x),
        1 => (z, -y, x),
        2 => (x, z, y),
        3 => (x, -z, y),
        4 => (x, -y, z),
        _ => (-x, -y, z),
    };
    [0.5 * (sc / ma.abs() + 1.0), 0.5 * (tc / ma.abs() + 1.0)]
}

/// Table 3.15, from the channels that are stored.
fn color(base: BaseFormat, [a, b, c, d]: [f64; 4]) -> [f64; 4] {
    match base {
        BaseFormat::Alpha => [0.0, 0.0, 0.0, a],
        BaseFormat::Luminance | BaseFormat::Depth => [a, a, a, 1.0],
        BaseFormat::LuminanceAlpha => [a, a, a, b],
        BaseFormat::Intensity => [a; 4],
        BaseFormat::Red => [a, 0.0, 0.0, 1.0],
        BaseFormat::Rg => [a, b, 0.0, 1.0],
        BaseFormat::Rgb => [a, b, c, 1.0],
        BaseFormat::Rgba => [a, b, c, d],
    }
}
