//! GLSL of fragments: derivatives, what fragments know of themselves, interpolation, clip distances and depths.

use super::pictures::{Pictures, Pixel, drawn};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::painter::inside;
use crate::oracle::polygon::signed_area;
use crate::probe::{ProbeError, Session, Stages};
use crate::rng::Rng;
use gl_api::constants::*;

/// Derivatives.
pub const DERIVATIVES: Check = Check {
    name: "glsl-derivatives",
    citation: "GLSL 1.20, 8.8: dFdx, dFdy by differences to a neighbour, fwidth = |dFdx| + |dFdy|",
    what: "every pixel of a quadratic function over random triangles, whose quads are partly covered",
    unit: Unit::FullScale,
    tolerance: 0.0,
    why: "the function's values and their differences are exact in f32",
    run: derivatives,
};

/// `gl_FragCoord`.
pub const FRAG_COORD: Check = Check {
    name: "glsl-frag-coord",
    citation: "GLSL 1.20, 7.2: x + 1/2, y + 1/2, z_w, 1/w",
    what: "every pixel of random triangles in perspective",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 21) as f64,
    why: "f32: depths up to 1 and 1/w up to 2 from planes over 61 pixels, 2^-23 each; x and y are exact",
    run: |harness, tally| fragments(harness, tally, Shown::FragCoord),
};

/// `gl_FrontFacing`.
pub const FRONT_FACING: Check = Check {
    name: "glsl-front-facing",
    citation: "GLSL 1.20, 7.2: gl_FrontFacing; GL 2.1, 2.14.1: the sign of the area",
    what: "every pixel of random triangles of either winding",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "true or false",
    run: |harness, tally| fragments(harness, tally, Shown::FrontFacing),
};

/// Linear in the window.
pub const NOPERSPECTIVE: Check = Check {
    name: "glsl-noperspective",
    citation: "GLSL 1.30, 4.3.7: noperspective is linear in the window, smooth is not",
    what: "every pixel of random triangles in perspective, an input of each kind",
    unit: Unit::FullScale,
    tolerance: 1.8 / (1 << 22) as f64,
    why: "f32: values up to 1 from planes over 61 pixels, 2^-23 each",
    run: |harness, tally| fragments(harness, tally, Shown::Inputs),
};

/// Clip distances.
pub const CLIP_DISTANCE: Check = Check {
    name: "glsl-clip-distance",
    citation: "GLSL 1.30, 7.1; GL 3.0, 2.17: a primitive is cut where gl_ClipDistance, linear in space, is negative",
    what: "every pixel of random triangles in perspective with two random distances",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "a pixel is drawn or not; those near a cut are left out",
    run: |harness, tally| fragments(harness, tally, Shown::ClipDistance),
};

/// `gl_FragDepth`.
pub const FRAG_DEPTH: Check = Check {
    name: "glsl-frag-depth",
    citation: "GLSL 1.20, 7.2: gl_FragDepth stands for the depth of the fragment, also in the depth test",
    what: "every pixel of two random triangles whose shaders write depths of their own",
    unit: Unit::Draws,
    tolerance: 0.0,
    why: "the one or the other",
    run: frag_depth,
};

const PICTURE: Pixel = [61, 47];

const VERTEX: &str = "
in vec4 place; in vec4 value;
out vec4 smoothly; noperspective out vec4 linearly; out float gl_ClipDistance[2];
void main() {
    gl_Position = place;
    smoothly = value; linearly = value;
    gl_ClipDistance[0] = value.x; gl_ClipDistance[1] = value.y;
}";

/// Three corners: window x and y, clip w and depth, and a value.
#[derive(Clone, Copy, Debug)]
struct Triangle {
    at: [[f64; 2]; 3],
    w: [f64; 3],
    z: [f64; 3],
    value: [[f32; 4]; 3],
}

impl Triangle {
    fn random(rng: &mut Rng, low: f64) -> Self {
        loop {
            let place = |rng: &mut Rng| {
                PICTURE.map(|n| (rng.integer(0, n as i64 * 128 - 1) * 2 + 1) as f64 / 256.0)
            };
            let at = [place(rng), place(rng), place(rng)];
            // Not so thin that its planes are steep.
            if signed_area(&at).abs() > 300.0 {
                return Self {
                    at,
                    w: [0; 3].map(|_: i32| f64::from(rng.dyadic(0.5, 2.0, 0.125))),
                    z: [0; 3].map(|_: i32| f64::from(rng.dyadic(-0.75, 0.75, 0.125))),
                    value: [0; 3].map(|_: i32| [0; 4].map(|_: i32| rng.real(low, 1.0))),
                };
            }
        }
    }

    /// The weights of the corners in the window and in space.
    fn weights(&self, [x, y]: Pixel) -> [[f64; 3]; 2] {
        let p = [x as f64 + 0.5, y as f64 + 0.5];
        let [a, b, c] = self.at;
        let whole = signed_area(&[a, b, c]);
        let window = [[p, b, c], [a, p, c], [a, b, p]].map(|of| signed_area(&of) / whole);
        let parts = [0, 1, 2].map(|k: usize| window[k] / self.w[k]);
        let sum: f64 = parts.iter().sum();
        [window, parts.map(|part| part / sum)]
    }

    fn has(&self, [x, y]: Pixel) -> Option<bool> {
        inside(self.at, [x as f64 + 0.5, y as f64 + 0.5])
    }

    fn draw(&self, session: &Session) -> Result<(), ProbeError> {
        let places: Vec<f32> = (0..3)
            .flat_map(|k| {
                let [x, y] = [0, 1].map(|i| 2.0 * self.at[k][i] / PICTURE[i] as f64 - 1.0);
                [x * self.w[k], y * self.w[k], self.z[k] * self.w[k], self.w[k]].map(|c| c as f32)
            })
            .collect();
        session.float_array(0, 4, &places)?;
        session.float_array(1, 4, self.value.as_flattened())?;
        glDrawArrays(GL_TRIANGLES, 0, 3);
        session.check("drawing a triangle")
    }
}

/// What a shader shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shown {
    FragCoord,
    FrontFacing,
    Inputs,
    ClipDistance,
}

impl Shown {
    fn fragment(self) -> &'static str {
        match self {
            Self::FragCoord => {
                "out vec4 color; void main() { color = gl_FragCoord / vec4(64.0, 64.0, 1.0, 1.0); }"
            }
            Self::FrontFacing => {
                "out vec4 color; void main() { color = vec4(1.0, gl_FrontFacing ? 1.0 : 0.0, 0.0, 0.0); }"
            }
            Self::Inputs => {
                "in vec4 smoothly; noperspective in vec4 linearly; out vec4 color;
                void main() { color = vec4(smoothly.xy, linearly.xy); }"
            }
            Self::ClipDistance => {
                "out vec4 color; void main() { color = vec4(1.0, 0.0, 0.0, 0.0); }"
            }
        }
    }

    fn expect(self, of: &Triangle, pixel: Pixel, variant: Variant) -> Option<[f64; 4]> {
        if !of.has(pixel)? {
            return Some([0.0; 4]);
        }
        let [window, space] = of.weights(pixel);
        let mix = |weights: [f64; 3], values: [f64; 3]| -> f64 {
            (0..3).map(|k| weights[k] * values[k]).sum()
        };
        let value = |weights: [f64; 3], i: usize| mix(weights, of.value.map(|v| f64::from(v[i])));
        Some(match self {
            Self::FragCoord => {
                let half = if variant.has(Mutation::InterpolatedAtCorner) { 0.0 } else { 0.5 };
                let [x, y] = pixel.map(|c| (c as f64 + half) / 64.0);
                let over_w = mix(window, of.w.map(|w| 1.0 / w));
                let w = if variant.has(Mutation::DivideByW) { 1.0 / over_w } else { over_w };
                [x, y, 0.5 * mix(window, of.z) + 0.5, w]
            }
            Self::FrontFacing => {
                let front = (signed_area(&of.at) > 0.0) != variant.has(Mutation::FacesSwapped);
                [1.0, f64::from(u8::from(front)), 0.0, 0.0]
            }
            Self::Inputs => {
                let linear = if variant.has(Mutation::AlwaysPerspective) { space } else { window };
                let smooth = if variant.has(Mutation::Affine) { window } else { space };
                [value(smooth, 0), value(smooth, 1), value(linear, 0), value(linear, 1)]
            }
            Self::ClipDistance => {
                let weights = if variant.has(Mutation::Affine) { window } else { space };
                let distances = [value(weights, 0), value(weights, 1)];
                // Values of up to 1 change by no more than 1/5 a pixel.
                // Where a cut meets a side, its corner is snapped, and the side moves.
                if distances.iter().any(|d| d.abs() < 2e-3) || window.iter().any(|w| *w < 0.01) {
                    return None;
                }
                drawn(distances.iter().all(|d| *d > 0.0))
            }
        })
    }
}

/// Uses a program whose attributes are the place and the value.
fn program(session: &Session, fragment: &str) -> Result<(), ProbeError> {
    let vertex = VERTEX.replace(
        "in vec4 place; in vec4 value;",
        "layout(location = 0) in vec4 place; layout(location = 1) in vec4 value;",
    );
    session.stages(&Stages { vertex: &vertex, geometry: "", fragment }).map(|_| ())
}

fn fragments(harness: &Harness, tally: &mut Tally, shown: Shown) -> Result<(), ProbeError> {
    let mut rng = Rng::named("glsl-fragments");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    let low = if shown == Shown::ClipDistance { -1.0 } else { 0.0 };
    for _ in 0..harness.cases(48).max(6) {
        let of = Triangle::random(&mut rng, low);
        let expect = |pixel: Pixel, variant: Variant| shown.expect(&of, pixel, variant);
        pictures.compare(&of, expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            program(session, shown.fragment())?;
            if shown == Shown::ClipDistance {
                glEnable(GL_CLIP_DISTANCE0);
                glEnable(GL_CLIP_DISTANCE0 + 1);
            }
            of.draw(session)?;
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(95, 2);
    Ok(())
}

fn derivatives(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("glsl-derivatives");
    let mut covered = 0;
    for _ in 0..harness.cases(32).max(4) {
        let of = Triangle::random(&mut rng, 0.0);
        let [a, b, c, d, e] = [0; 5].map(|_: i32| f64::from(rng.dyadic(-1.0, 1.0, 1.0 / 16.0)));
        let value = move |x: i64, y: i64| {
            let (x, y) = (x as f64 + 0.5, y as f64 + 0.5);
            a * x * x + b * x * y + c * y * y + d * x + e * y
        };
        let pixels: Vec<Pixel> =
            super::pictures::all(PICTURE).filter(|pixel| of.has(*pixel) == Some(true)).collect();
        covered += pixels.len();
        // The differences to the left, to the right, downwards and upwards.
        let expect = |&[x, y]: &Pixel, variant: Variant| {
            let (x, y) = (x as i64, y as i64);
            let here = value(x, y);
            let scale = if variant.has(Mutation::DifferencesHalved) { 0.5 } else { 1.0 };
            [
                here - value(x - 1, y),
                value(x + 1, y) - here,
                here - value(x, y - 1),
                value(x, y + 1) - here,
            ]
            .map(|difference| scale * difference)
        };
        let error = |_: &Pixel, expected: [f64; 4], found: [f64; 4]| {
            let either =
                |low: f64, high: f64, found: f64| (low - found).abs().min((high - found).abs());
            // In the oracle's own place of the driver's: dx, dy, and the width of both.
            let [dx, dy, width, _] = if found[3] == -1e9 {
                [found[0], found[1], found[2], 0.0]
            } else {
                [found[0], found[2], found[0].abs() + found[2].abs(), 0.0]
            };
            either(expected[0], expected[1], dx)
                .max(either(expected[2], expected[3], dy))
                .max((dx.abs() + dy.abs() - width).abs())
        };
        let scene = (of.at, [a, b, c, d, e]);
        harness.compare_by(tally, &scene, &pixels, expect, error, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            let fragment = format!(
                "out vec4 color;
                void main() {{
                    float x = gl_FragCoord.x, y = gl_FragCoord.y;
                    float f = {a:?} * x * x + {b:?} * x * y + {c:?} * y * y + {d:?} * x + {e:?} * y;
                    color = vec4(dFdx(f), dFdy(f), fwidth(f), -1.0e9);
                }}"
            );
            program(session, &fragment)?;
            of.draw(session)?;
            let picture = session.read_floats(PICTURE)?;
            Ok(pixels.iter().map(|[x, y]| picture[y * PICTURE[0] + x]).collect())
        })?;
    }
    tally.reach("pixels in triangles", covered, 500);
    Ok(())
}

fn frag_depth(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("glsl-frag-depth");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for _ in 0..harness.cases(32).max(4) {
        let triangles = [Triangle::random(&mut rng, 0.0), Triangle::random(&mut rng, 0.0)];
        let phase = [rng.integer(0, 15), rng.integer(0, 15)];
        let depth =
            |k: usize, [x, y]: Pixel| ((5 * x + 3 * y) as i64 + phase[k]) % 16 * 2 + k as i64;
        let expect = |pixel: Pixel, variant: Variant| {
            let mut shown: Option<usize> = None;
            for (k, triangle) in triangles.iter().enumerate() {
                if triangle.has(pixel)? {
                    let nearer = match shown {
                        None => true,
                        Some(_) if variant.has(Mutation::ShaderDepthIgnored) => true,
                        Some(other) => depth(k, pixel) < depth(other, pixel),
                    };
                    shown = if nearer { Some(k) } else { shown };
                }
            }
            Some([shown.map_or(0.0, |k| (k + 1) as f64), 0.0, 0.0, 0.0])
        };
        pictures.compare(&(triangles[0].at, phase), expect, |session| {
            session.deep_frame(GL_RGBA32F, GL_DEPTH_COMPONENT24, PICTURE, 0)?;
            glEnable(GL_DEPTH_TEST);
            for (k, triangle) in triangles.iter().enumerate() {
                let fragment = format!(
                    "out vec4 color;
                    void main() {{
                        int sum = 5 * int(gl_FragCoord.x) + 3 * int(gl_FragCoord.y) + {};
                        gl_FragDepth = float(sum % 16 * 2 + {k}) / 64.0;
                        color = vec4({}.0, 0.0, 0.0, 0.0);
                    }}",
                    phase[k],
                    k + 1
                );
                program(session, &fragment)?;
                triangle.draw(session)?;
            }
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(95, 10);
    Ok(())
}
