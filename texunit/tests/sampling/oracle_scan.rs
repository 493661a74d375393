//! The anisotropic filter of images in a plane in scalar `f64`, from the formulas at the top of
//! `sample/row_scan`. Rows and columns are walked one texel at a time; nothing is an integer.

use crate::oracle::{Answer, Oracle};
use texunit::image::Shape;
use texunit::sampler::{Filter, Mipmap, Wrap};

/// A footprint, in texels of the base level.
struct Footprint {
    /// 0 where columns are walked, 1 where rows are.
    axis: usize,
    excess: f64,
    slope: f64,
    even: f64,
    lambda: f64,
    margin: f64,
}

fn footprint(dx: [f64; 2], dy: [f64; 2], most: f64) -> Footprint {
    let moment = |a: usize, b: usize| dx[a] * dx[b] + dy[a] * dy[b];
    let (uu, uv, vv) = (moment(0, 0), moment(0, 1), moment(1, 1));
    // The eigenvalues, by the angle of the major axis.
    let angle = 0.5 * (2.0 * uv).atan2(uu - vv);
    let along = |a: f64| {
        let (sin, cos) = a.sin_cos();
        uu * cos * cos + 2.0 * uv * sin * cos + vv * sin * sin
    };
    let (major, minor) = (along(angle), along(angle + std::f64::consts::FRAC_PI_2).max(0.0));
    let axis = if vv > uu { 1 } else { 0 };
    let width = minor.max(major / (most * most));
    if major <= width {
        let lambda = 0.5 * major.log2();
        return Footprint { axis, excess: 0.0, slope: 0.0, even: 0.0, lambda, margin: 1.0 };
    }
    let part = (major - width) / (major - minor);
    let excess = part * (uu.max(vv) - minor);
    let slope = part * uv / (width.max(1.0) + excess);
    let elongation = 1.0 - width / major;
    Footprint {
        axis,
        excess,
        slope,
        even: 7.0 / 16.0 * slope * slope * width.min(1.0),
        lambda: 0.5 * (width + elongation * (1.0 - 9.0 / 16.0 * width)).log2(),
        margin: (uu - vv).abs() / (uu + vv),
    }
}

impl Oracle<'_> {
    /// Whether this is how the footprint is read.
    pub fn scans(&self) -> bool {
        let sampler = self.sampler;
        let level = self.image.level(0, sampler.base_level as usize).unwrap();
        let wraps = sampler.wrap[..2].iter().all(|wrap| match (self.image.shape(), wrap) {
            (Shape::Rect, Wrap::Clamp | Wrap::ClampToBorder) => false,
            (Shape::Rect, _) => true,
            (_, wrap) => matches!(wrap, Wrap::Repeat | Wrap::MirroredRepeat | Wrap::ClampToEdge),
        });
        sampler.max_anisotropy >= 2.0
            && matches!(self.image.shape(), Shape::D2 | Shape::Rect)
            && [sampler.min, sampler.mag] == [Filter::Linear; 2]
            && !(level.format.is_depth() && sampler.compare.is_some())
            && wraps
    }

    /// A sample under these derivatives of (s, t), whose λ has this bias.
    pub fn scan(&self, st: [f64; 2], dx: [f64; 2], dy: [f64; 2], bias: f64) -> Answer {
        let sampler = self.sampler;
        let base = sampler.base_level as usize;
        let size = self.image.level(0, base).unwrap().size().map(f64::from);
        let shape = self.image.shape();
        let texels = |d: [f64; 2]| match shape {
            Shape::Rect => d,
            _ => [d[0] * size[0], d[1] * size[1]],
        };
        let most = f64::from(sampler.max_anisotropy).clamp(1.0, 16.0).floor();
        let footprint = footprint(texels(dx), texels(dy), most);
        let lambda = (footprint.lambda + bias)
            .max(f64::from(sampler.min_lod))
            .min(f64::from(sampler.max_lod));
        let last = (base + size[0].max(size[1]).log2() as usize).min(sampler.max_level as usize);
        let held = lambda.clamp(0.0, (last - base) as f64);
        let margin = footprint.margin;
        match sampler.mipmap {
            Mipmap::None => self.rows(st, base, &footprint, margin),
            Mipmap::Nearest => {
                let number = (held + 0.5).ceil() as usize - 1;
                let near = (held - 0.5 - (held - 0.5).round()).abs();
                let near = if lambda == held { near } else { 1.0 };
                self.rows(st, base + number, &footprint, margin.min(near))
            }
            Mipmap::Linear => {
                let first = base + held.floor() as usize;
                let weight = held - held.floor();
                let a = self.rows(st, first, &footprint, margin);
                let b = self.rows(st, (first + 1).min(last), &footprint, margin);
                Answer {
                    rgba: [0, 1, 2, 3].map(|c| a.rgba[c] + (b.rgba[c] - a.rgba[c]) * weight),
                    margin: a.margin.min(b.margin),
                }
            }
        }
    }

    /// The rows (or columns) of one level.
    fn rows(&self, st: [f64; 2], number: usize, footprint: &Footprint, margin: f64) -> Answer {
        let shape = self.image.shape();
        let level = self.image.level(0, number).unwrap();
        let base = self.image.level(0, self.sampler.base_level as usize).unwrap().size();
        let size = level.size().map(f64::from);
        let part = [0, 1].map(|axis| size[axis] / f64::from(base[axis]));
        let (along, across) = (footprint.axis, 1 - footprint.axis);
        // Texels from the corner of the image that (s, t) lies in, mirrored or not.
        let mut slope = (footprint.slope * part[across] / part[along]).clamp(-2.0, 2.0);
        let mut margin = margin;
        let place = [0, 1].map(|axis| {
            let texels = if shape == Shape::Rect { 1.0 } else { size[axis] };
            let s = (st[axis] * texels + f64::from(self.offset[axis])) / size[axis];
            match self.wrap(axis) {
                Wrap::MirroredRepeat if s.floor().rem_euclid(2.0) == 1.0 => {
                    slope = -slope;
                    (1.0 - (s - s.floor())) * size[axis]
                }
                Wrap::MirroredRepeat | Wrap::Repeat => (s - s.floor()) * size[axis],
                _ => (s * size[axis]).clamp(-64.0, size[axis] + 64.0),
            }
        });
        let length = (1.0 + footprint.excess * part[along] * part[along]).sqrt().min(48.0);
        let (low, high) = (place[along] - 0.5 * length, place[along] + 0.5 * length);
        let mut rgba = [0.0; 4];
        for row in low.floor() as i64..high.ceil() as i64 {
            let weight = (high.min(row as f64 + 1.0) - low.max(row as f64)) / length;
            let x = place[across] + slope * (row as f64 + 0.5 - place[along]) - 0.5;
            let (left, alpha) = (x.floor() as i64, x - x.floor());
            let even = footprint.even;
            let right = even + (1.0 - 2.0 * even) * alpha;
            if even > 1e-6 {
                // Weights are not the same on either side of a texel's centre.
                margin = margin.min((x - x.round()).abs() * 4.0);
            }
            for (i, w) in [(left, 1.0 - right), (left + 1, right)] {
                let mut at = [0, 0, 0];
                at[along] = self.index(along, row, size[along]);
                at[across] = self.index(across, i, size[across]);
                let texel = self.texel(level, at);
                (0..4).for_each(|c| rgba[c] += weight * w * texel[c]);
            }
        }
        Answer { rgba, margin }
    }

    fn wrap(&self, axis: usize) -> Wrap {
        if self.image.shape() == Shape::Rect { Wrap::ClampToEdge } else { self.sampler.wrap[axis] }
    }

    fn index(&self, axis: usize, i: i64, size: f64) -> i32 {
        let n = size as i64;
        let i = match self.wrap(axis) {
            Wrap::Repeat => i.rem_euclid(n),
            Wrap::MirroredRepeat => {
                let i = i.rem_euclid(2 * n);
                if i < n { i } else { 2 * n - 1 - i }
            }
            _ => i.clamp(0, n - 1),
        };
        i as i32
    }
}
