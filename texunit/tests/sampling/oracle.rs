//! The texture chapter of GL 2.1 and its extensions in scalar `f64`, written from their text and
//! not from the crate. (What a texel's bytes mean is tested beside the formats.)
//!
//! Where the specification steps (a nearest texel, a nearest level, the switch between filters),
//! a point close to the step may fall on either side in `f32`. Each answer therefore carries its
//! distance from the nearest step that it took.

use crate::oracle_cube::{is_cube, over_edges, project, select_face};
use texunit::format::{Encoding, Format};
use texunit::image::{Image, Level, Shape};
use texunit::sampler::{Compare, DepthMode, Filter, Mipmap, Sampler, Seamless, Swizzle, Wrap};

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
    /// The layer coordinate of an array of cubes.
    pub layer: f64,
    pub reference: f64,
    pub offset: [i32; 3],
}

/// Where a sample is taken, once face and layer are known.
#[derive(Clone, Copy)]
pub struct Position {
    pub face: usize,
    pub layer: i32,
    pub at: [f64; 3],
}

impl Oracle<'_> {
    /// Face and layer, and how far away the nearest other ones are.
    pub fn place(&self, at: [f64; 3]) -> (Position, f64) {
        let shape = self.image.shape();
        let base = self.sampler.base_level as usize;
        let size = self.image.level(0, base).unwrap().size().map(f64::from);
        let mut margin = f64::INFINITY;
        let mut place = Position { face: 0, layer: 0, at };
        let mut layer_of = |r: f64| {
            margin = (r + 0.5 - (r + 0.5).round()).abs();
            (r + 0.5).floor().clamp(0.0, size[2] - 1.0) as i32
        };
        // Six layers of storage are one layer of an array of cubes.
        let cubes = |q: f64| ((q + 0.5).floor().clamp(0.0, size[2] / 6.0 - 1.0)) as i32;
        match shape {
            Shape::D1 | Shape::D2 | Shape::D3 | Shape::Rect => {}
            Shape::D1Array => place.layer = layer_of(at[1]),
            Shape::D2Array => place.layer = layer_of(at[2]),
            Shape::Cube => {
                (place.face, margin) = select_face(at);
                let [s, t] = project(place.face, at);
                place.at = [s, t, 0.0];
            }
            Shape::CubeArray => {
                (place.face, margin) = select_face(at);
                margin = margin.min((self.layer + 0.5 - (self.layer + 0.5).round()).abs());
                place.layer = cubes(self.layer);
                let [s, t] = project(place.face, at);
                place.at = [s, t, 0.0];
            }
        }
        (place, margin)
    }

    pub fn sample(&self, at: [f64; 3], detail: Detail) -> Answer {
        let (shape, sampler) = (self.image.shape(), self.sampler);
        let base = sampler.base_level as usize;
        let size = self.image.level(0, base).unwrap().size().map(f64::from);
        let (place, mut margin) = self.place(at);
        let mut probes = vec![[0.0; 3]];
        let lambda_base = match detail {
            Detail::Lambda(lambda) => lambda + f64::from(sampler.lod_bias).clamp(-16.0, 16.0),
            Detail::Derivatives { dx, dy, bias } => {
                let [dx, dy] = [dx, dy].map(|d| self.on_face(place.face, at, d));
                if self.scans() {
                    let bias = (f64::from(sampler.lod_bias) + bias).clamp(-16.0, 16.0);
                    let plane = |v: [f64; 3]| [v[0], v[1]];
                    return self.swizzled(self.scan(plane(place.at), plane(dx), plane(dy), bias));
                }
                let scale = if shape == Shape::Rect { [1.0; 3] } else { size };
                let (width, step, near) = footprint(sampler, shape, dx, dy, scale);
                margin = margin.min(near);
                probes = step;
                width.log2() + (f64::from(sampler.lod_bias) + bias).clamp(-16.0, 16.0)
            }
        };
        let mut sum = Answer { rgba: [0.0; 4], margin };
        for probe in &probes {
            let at = [0, 1, 2].map(|axis| place.at[axis] + probe[axis]);
            let (there, near) = over_edges(shape, Position { at, ..place });
            let one = self.levels(there, lambda_base);
            sum.margin = sum.margin.min(near);
            for c in 0..4 {
                sum.rgba[c] += one.rgba[c] / probes.len() as f64;
            }
            sum.margin = sum.margin.min(one.margin);
        }
        self.swizzled(sum)
    }

    pub fn swizzled(&self, answer: Answer) -> Answer {
        let from = answer.rgba;
        let rgba = self.sampler.swizzle.map(|source| match source {
            Swizzle::Red => from[0],
            Swizzle::Green => from[1],
            Swizzle::Blue => from[2],
            Swizzle::Alpha => from[3],
            Swizzle::Zero => 0.0,
            Swizzle::One => 1.0,
        });
        Answer { rgba, ..answer }
    }

    /// A derivative of the coordinates that are filtered along.
    fn on_face(&self, face: usize, at: [f64; 3], d: [f64; 3]) -> [f64; 3] {
        match self.image.shape() {
            Shape::D1 | Shape::D1Array => [d[0], 0.0, 0.0],
            Shape::D2 | Shape::Rect | Shape::D2Array => [d[0], d[1], 0.0],
            Shape::D3 => d,
            Shape::Cube | Shape::CubeArray => {
                // The projection's own slope, by a central difference.
                let h = 1e-6;
                let ahead = project(face, [0, 1, 2].map(|i| at[i] + h * d[i]));
                let behind = project(face, [0, 1, 2].map(|i| at[i] - h * d[i]));
                let [s, t] = [0, 1].map(|i| (ahead[i] - behind[i]) / (2.0 * h));
                [s, t, 0.0]
            }
        }
    }

    /// One probe, over the levels.
    fn levels(&self, place: Position, lambda_base: f64) -> Answer {
        let sampler = self.sampler;
        let base = sampler.base_level as usize;
        let mut margin = f64::INFINITY;
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
            return self.level(place, base, sampler.mag, margin);
        }
        let sides = &self.image.level(0, base).unwrap().size()[..self.image.shape().axes()];
        let smallest = base + sides.iter().max().unwrap().ilog2() as usize;
        let q = smallest.min(sampler.max_level as usize);
        let level = base as f64 + lambda;
        match sampler.mipmap {
            Mipmap::None => self.level(place, base, sampler.min, margin),
            Mipmap::Nearest => {
                let step = (lambda - 0.5 - (lambda - 0.5).round()).abs();
                let d = if lambda <= 0.5 {
                    base
                } else if level <= q as f64 + 0.5 {
                    (level + 0.5).ceil() as usize - 1
                } else {
                    q
                };
                self.level(place, d, sampler.min, margin.min(step))
            }
            Mipmap::Linear => {
                let d1 = if level >= q as f64 { q } else { level.floor() as usize };
                let d2 = (d1 + 1).min(q);
                let first = self.level(place, d1, sampler.min, margin);
                let second = self.level(place, d2, sampler.min, margin);
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
    fn level(&self, place: Position, number: usize, filter: Filter, mut margin: f64) -> Answer {
        let shape = self.image.shape();
        let (level, slice) = self.stored(place, number);
        let seamless = is_cube(shape) && self.sampler.seamless == Seamless::On;
        // Per axis the indices and their weights.
        let mut along = [vec![(0.0, 1.0)], vec![(0.0, 1.0)], vec![(f64::from(slice), 1.0)]];
        for (axis, along) in along.iter_mut().enumerate().take(shape.axes()) {
            let n = f64::from(level.size()[axis]);
            let wrap = match (shape, self.sampler.wrap[axis]) {
                (Shape::Cube | Shape::CubeArray, _) if seamless => Wrap::Clamp,
                (Shape::Rect, Wrap::Clamp) => Wrap::Clamp,
                (Shape::Rect, Wrap::ClampToBorder) => Wrap::ClampToBorder,
                (Shape::Rect, _) => Wrap::ClampToEdge,
                (_, wrap) => wrap,
            };
            let texels = if shape == Shape::Rect { 1.0 } else { n };
            let s = place.at[axis] * texels / n + f64::from(self.offset[axis]) / n;
            let u = wrapped(wrap, s, n);
            *along = match filter {
                Filter::Nearest => {
                    let held = match wrap {
                        Wrap::Clamp => !(0.0..=1.0).contains(&s),
                        Wrap::MirrorClamp => s.abs() > 1.0 || s.abs() < 0.5 / n,
                        Wrap::MirrorClampToEdge => s.abs() < 0.5 / n || s.abs() > 1.0 - 0.5 / n,
                        Wrap::MirrorClampToBorder => s.abs() < 0.5 / n,
                        _ => false,
                    };
                    margin = margin.min(if held { f64::INFINITY } else { (u - u.round()).abs() });
                    let past = matches!(wrap, Wrap::ClampToBorder | Wrap::MirrorClampToBorder);
                    let last = !past && u >= n;
                    vec![(if last { n - 1.0 } else { u.floor() }, 1.0)]
                }
                Filter::Linear => {
                    let i = (u - 0.5).floor();
                    let weight = u - 0.5 - i;
                    let fold = |i: f64| match wrap {
                        Wrap::Repeat => i.rem_euclid(n),
                        // Weightless beyond the edge.
                        Wrap::ClampToEdge | Wrap::MirroredRepeat | Wrap::MirrorClampToEdge => {
                            i.clamp(0.0, n - 1.0)
                        }
                        Wrap::Clamp
                        | Wrap::ClampToBorder
                        | Wrap::MirrorClamp
                        | Wrap::MirrorClampToBorder => i,
                    };
                    vec![(fold(i), 1.0 - weight), (fold(i + 1.0), weight)]
                }
            };
        }
        let mut rgba = [0.0; 4];
        let mut missing = 0.0;
        let mut found = Vec::new();
        for &(k, wk) in &along[2] {
            for &(j, wj) in &along[1] {
                for &(i, wi) in &along[0] {
                    let at = [i as i32, j as i32, k as i32];
                    let texel = if seamless {
                        self.across(place, number, at)
                    } else {
                        Some(self.texel(level, at))
                    };
                    match texel {
                        Some(texel) => {
                            (0..4).for_each(|c| rgba[c] += wi * wj * wk * texel[c]);
                            found.push(texel);
                        }
                        None => missing += wi * wj,
                    }
                }
            }
        }
        for c in 0..4 {
            let mean = found.iter().map(|texel| texel[c]).sum::<f64>() / found.len() as f64;
            rgba[c] += missing * mean;
        }
        Answer { rgba, margin }
    }

    /// A texel of a seamless cube; none beyond a corner.
    pub fn across(&self, place: Position, number: usize, [i, j, _]: [i32; 3]) -> Option<[f64; 4]> {
        let (level, slice) = self.stored(place, number);
        let n = level.width as i32;
        let inside = |i: i32| (0..n).contains(&i);
        match (inside(i), inside(j)) {
            (true, true) => return Some(self.texel(level, [i, j, slice])),
            (false, false) => return None,
            _ => {}
        }
        // The direction of its place on the edge, a little further out, meets the other face.
        let on_edge = |i: i32| {
            let centre = (2.0 * f64::from(i) + 1.0) / f64::from(n) - 1.0;
            centre.clamp(-1.0 - 1e-9, 1.0 + 1e-9)
        };
        let (sc, tc) = (on_edge(i), on_edge(j));
        let direction = match place.face {
            0 => [1.0, -tc, -sc],
            1 => [-1.0, -tc, sc],
            2 => [sc, 1.0, tc],
            3 => [sc, -1.0, -tc],
            4 => [sc, -tc, 1.0],
            _ => [-sc, -tc, -1.0],
        };
        let (face, _) = select_face(direction);
        let [x, y] =
            project(face, direction).map(|s| ((s * f64::from(n)).floor() as i32).clamp(0, n - 1));
        let (level, slice) = self.stored(Position { face, ..place }, number);
        Some(self.texel(level, [x, y, slice]))
    }

    /// A level, and which slice of it a place is in.
    pub fn stored(&self, place: Position, number: usize) -> (&Level, i32) {
        let (face, slice) = match self.image.shape() {
            Shape::CubeArray => (0, 6 * place.layer + place.face as i32),
            _ => (place.face, place.layer),
        };
        (self.image.level(face, number).unwrap(), slice)
    }

    /// A texel, or the border colour where there is none.
    pub fn texel(&self, level: &Level, at: [i32; 3]) -> [f64; 4] {
        let border = border(level.format, self.sampler.border.floats());
        if !level.format.is_depth() {
            return match level.color_at(at) {
                Some(color) => color.map(f64::from),
                None => {
                    let mut stored = [0.0; 4];
                    for (to, &from) in stored.iter_mut().zip(level.format.base().sources()) {
                        *to = border[from] as f32;
                    }
                    texunit::format::convert::expand(level.format.base(), stored).map(f64::from)
                }
            };
        }
        let depth = level.channels_at(at).map_or(border[0], |channels| f64::from(channels[0]));
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
            DepthMode::Red => [d, 0.0, 0.0, 1.0],
        }
    }
}

/// The width of each probe in texels, where the probes lie, and the distance to another number of
/// probes. From the singular values of the Jacobian, by the angle of its first right vector.
fn footprint(
    sampler: &Sampler,
    shape: Shape,
    dx: [f64; 3],
    dy: [f64; 3],
    scale: [f64; 3],
) -> (f64, Vec<[f64; 3]>, f64) {
    let dot =
        |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| a[i] * scale[i] * b[i] * scale[i]).sum::<f64>();
    let (xx, xy, yy) = (dot(dx, dx), dot(dx, dy), dot(dy, dy));
    let most = f64::from(sampler.max_anisotropy).clamp(1.0, 16.0).floor();
    if most == 1.0 || shape.axes() == 1 {
        return (xx.max(yy).sqrt(), vec![[0.0; 3]], f64::INFINITY);
    }
    let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
    let along = |angle: f64| [0, 1, 2].map(|i| dx[i] * angle.cos() + dy[i] * angle.sin());
    let axis = along(angle);
    let across = along(angle + std::f64::consts::FRAC_PI_2);
    let (major, minor) = (dot(axis, axis).sqrt(), dot(across, across).sqrt());
    let steps = major / minor - 1.0 / 64.0;
    let n = steps.ceil().clamp(1.0, most);
    let near = if steps > most { f64::INFINITY } else { (steps - steps.round()).abs() };
    if n == 1.0 {
        return (major, vec![[0.0; 3]], near);
    }
    let width = minor.max(major / n);
    let gap = ((major * major - width * width) / (n * n - 1.0)).sqrt() / major;
    let probe = |i: f64| axis.map(|a| a * gap * (i - 0.5 * (n - 1.0)));
    (width, (0..n as usize).map(|i| probe(i as f64)).collect(), near)
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
        Wrap::MirrorClampToBorder => s.abs().clamp(half, 1.0 + half),
    }
}

/// The border colour as texels of a format can have it.
fn border(format: Format, color: [f32; 4]) -> [f64; 4] {
    let name = format!("{format:?}");
    let is_number = matches!(format.info().encoding, Encoding::Float | Encoding::SharedExponent)
        || (name.contains("Bptc") && name.contains("Float"));
    // Floats of 11, 10 and 9 bits have no sign; every format of numbers has what a test's border is otherwise.
    let has_sign = !["R11G11B10F", "Rgb9E5", "Unsigned"].iter().any(|part| name.contains(part));
    let least = if name.contains("Snorm") { -1.0 } else { 0.0 };
    color.map(f64::from).map(|c| match (is_number, has_sign) {
        (true, true) => c,
        (true, false) => c.max(0.0),
        (false, _) => c.clamp(least, 1.0),
    })
}
