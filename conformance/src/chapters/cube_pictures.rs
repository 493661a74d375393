//! Cube maps over whole pictures, which cross faces and their edges, of every size of texel.

use super::pictures::{Pictures, Pixel};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::cube;
use crate::oracle::format::{Base, Encoding, linear, stored};
use crate::oracle::wrap::{self, Index, Wrap};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Linear filters of cube maps.
pub const CUBE: Check = Check {
    name: "picture-cube",
    citation: "GL 2.1, 3.8.6 and 3.8.8: GL_LINEAR on the face, by the wrap modes of s and t",
    what: "every pixel of squares whose directions cross faces, with linear cube maps of 9 formats and 3 wrap modes, into floats",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 18) as f64,
    why: "f32 directions: s and t of up to 16 texels off by 2^-20 in each of two weights, of texels up to 1 apart",
    run,
};

/// Levels of cube maps.
pub const LEVELS: Check = Check {
    name: "picture-cube-levels",
    citation: "GL 2.1, 3.8.6 and 3.8.8: λ of s and t on the face, of directions that a fragment shader computes or not",
    what: "every pixel of squares whose directions cross faces, with cube maps of which each level has one value",
    unit: Unit::Levels,
    tolerance: 1.5 / (1 << 20) as f64,
    why: "f32: λ up to 8 is rounded by 2^-22, and so are logarithm and mix; λ may be that of a difference or of a derivative",
    run: levels,
};

const PICTURE: Pixel = [67, 45];
/// Coordinates of its pixels are whole numbers of 1/64.
const EXACT_PICTURE: Pixel = [64, 64];

const SIDES: [usize; 4] = [16, 5, 1, 8];

const WRAPS: [(u32, Wrap); 3] = [
    (GL_CLAMP_TO_EDGE, Wrap::ClampToEdge),
    (GL_REPEAT, Wrap::Repeat),
    (GL_MIRRORED_REPEAT, Wrap::MirroredRepeat),
];

const TEXELS: [(u32, Base, Encoding); 9] = {
    use Base::{LuminanceAlpha, Red, Rg, Rgb, Rgba};
    use Encoding::{Half, Single, Srgb, Unorm};
    [
        (GL_RGBA8, Rgba, Unorm([8; 4])),
        (GL_RGB8, Rgb, Unorm([8; 4])),
        (GL_RG8, Rg, Unorm([8; 4])),
        (GL_R8, Red, Unorm([8; 4])),
        (GL_LUMINANCE8_ALPHA8, LuminanceAlpha, Unorm([8; 4])),
        (GL_RGB5_A1, Rgba, Unorm([5, 5, 5, 1])),
        (GL_SRGB8, Rgb, Srgb),
        (GL_RGBA16F, Rgba, Half),
        (GL_RGBA32F, Rgba, Single),
    ]
};

/// Nearer to an edge of the cube than this, rounding decides between two faces.
const EDGE: f64 = 0.999;

/// Directions as an affine function of window coordinates from -1 to 1.
#[derive(Clone, Copy, Debug)]
struct Directions {
    picture: Pixel,
    middle: [f64; 3],
    across: [f64; 3],
    up: [f64; 3],
}

impl Directions {
    fn random(rng: &mut Rng) -> Self {
        let mut vector = |length: f64| [0; 3].map(|_: i32| f64::from(rng.real(-length, length)));
        Self { picture: PICTURE, middle: vector(1.0), across: vector(1.5), up: vector(1.5) }
    }

    /// Whole numbers of 1/256 over a picture of powers of two, so that each pixel's direction is one that f32 has.
    fn exact(&self) -> Self {
        let of = |v: [f64; 3]| v.map(|c| (c * 256.0).round() / 256.0);
        let Self { middle, across, up, .. } = *self;
        Self { picture: EXACT_PICTURE, middle: of(middle), across: of(across), up: of(up) }
    }

    fn at(&self, x: f64, y: f64) -> [f64; 3] {
        [0, 1, 2].map(|i| self.middle[i] + x * self.across[i] + y * self.up[i])
    }

    /// The direction at a point of the picture, in pixels.
    fn at_point(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let [w, h] = self.picture.map(|n| n as f64);
        self.at(2.0 * x / w - 1.0, 2.0 * y / h - 1.0)
    }

    fn of(&self, pixel: Pixel) -> [f64; 3] {
        self.at_point(pixel.map(|c| c as f64 + 0.5))
    }

    /// The whole picture as a square with these texture coordinates.
    fn draw(&self) {
        glBegin(GL_QUADS);
        for [x, y] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
            let [s, t, r] = self.at(x, y);
            glTexCoord3d(s, t, r);
            glVertex2d(x, y);
        }
        glEnd();
    }
}

/// Whether rounding may choose another face, or moves the place on it by more than the tolerance allows.
fn is_open(direction: [f64; 3]) -> bool {
    let mut sorted = direction.map(f64::abs);
    sorted.sort_by(f64::total_cmp);
    sorted[1] > EDGE * sorted[2] || sorted[2] < 0.2
}

fn run(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("picture-cube");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(54).max(TEXELS.len()) {
        let (internal, base, encoding) = TEXELS[round % TEXELS.len()];
        let side = SIDES[round / 2 % SIDES.len()];
        let (names, wraps): (Vec<u32>, Vec<Wrap>) = (0..2).map(|_| rng.pick(&WRAPS)).unzip();
        // Numbers that the format has, so that rounding on the way in does not matter.
        let faces: Vec<Vec<[f64; 4]>> = (0..6)
            .map(|_| {
                let texel = |_| {
                    let given = [0; 4].map(|_: i32| f64::from(rng.real(0.0, 1.0)));
                    base.queried(stored(base, encoding, given, Variant::CORRECT), Variant::CORRECT)
                };
                (0..side * side).map(texel).collect()
            })
            .collect();
        let directions = Directions::random(&mut rng);
        let expect = |pixel: Pixel, variant: Variant| {
            let direction = directions.of(pixel);
            if is_open(direction) {
                return None;
            }
            let (face, [s, t]) = cube::select(direction, variant);
            let read = |i: Index, j: Index| match (i, j) {
                (Index::Texel(i), Index::Texel(j)) => {
                    let texel = faces[face as usize][j * side + i];
                    let codes = stored(base, encoding, texel, Variant::CORRECT);
                    base.sampled(linear(base, encoding, codes, variant), variant)
                }
                // With weight 0.
                (Index::Border, _) | (_, Index::Border) => [0.0; 4],
            };
            let (i, a) = wrap::linear(wraps[0], s, side, variant);
            let (j, b) = wrap::linear(wraps[1], t, side, variant);
            let (a, b) = if variant.has(Mutation::WeightsSwapped) { (b, a) } else { (a, b) };
            let corners = [read(i[0], j[0]), read(i[1], j[0]), read(i[0], j[1]), read(i[1], j[1])];
            let weights = [(1.0 - a) * (1.0 - b), a * (1.0 - b), (1.0 - a) * b, a * b];
            Some(std::array::from_fn(|c| (0..4).map(|k| weights[k] * corners[k][c]).sum()))
        };
        let scene = (enum_name(internal), side, &wraps, directions);
        pictures.compare(&scene, expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            let target = GL_TEXTURE_CUBE_MAP;
            glBindTexture(target, 1);
            for (face, texels) in (GL_TEXTURE_CUBE_MAP_POSITIVE_X..).zip(&faces) {
                let numbers: Vec<f32> = texels.as_flattened().iter().map(|&c| c as f32).collect();
                glTexImage2D(face, 0, internal, side, side, 0, GL_RGBA, GL_FLOAT, &numbers);
            }
            for (name, value) in [
                (GL_TEXTURE_MIN_FILTER, GL_LINEAR),
                (GL_TEXTURE_MAG_FILTER, GL_LINEAR),
                (GL_TEXTURE_WRAP_S, names[0]),
                (GL_TEXTURE_WRAP_T, names[1]),
            ] {
                glTexParameteri(target, name, value);
            }
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
            if round % 2 == 0 {
                glEnable(target);
            } else {
                session.fragment_only(
                    "uniform samplerCube image;
                    void main() { gl_FragColor = textureCube(image, gl_TexCoord[0].stp); }",
                )?;
            }
            session.check("preparing a cube map")?;
            directions.draw();
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(80, 80);
    Ok(())
}

/// Levels of the cube maps whose λ is compared.
const COUNT: usize = 9;

/// λ at a pixel, by differences within its quad and by derivatives; those of the quad's first pixel, too.
fn lambdas(directions: &Directions, [x, y]: Pixel, variant: Variant) -> [f64; 3] {
    let of = |x: f64, y: f64| directions.at_point([x + 0.5, y + 0.5]);
    let (x, y) = (x as f64, y as f64);
    let (x0, y0) = ((x / 2.0).floor() * 2.0, (y / 2.0).floor() * 2.0);
    let here = of(x, y);
    let between = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| b[i] - a[i]);
    let side = (1 << (COUNT - 1)) as f64;
    let lambda = |dx: [f64; 3], dy: [f64; 3]| {
        let length = |d: [f64; 3]| {
            let [s, t] = cube::derivative(here, d, variant);
            (s * side).hypot(t * side)
        };
        length(dx).max(length(dy)).log2()
    };
    // Directions are affine, so that all differences are the same; what differs is where they are projected.
    let (dx, dy) = (between(of(x0, y), of(x0 + 1.0, y)), between(of(x, y0), of(x, y0 + 1.0)));
    let moved = |at: [f64; 3], d: [f64; 3]| {
        let to = [0, 1, 2].map(|i| at[i] + d[i]);
        let ((a, from), (b, to)) = (cube::select(at, variant), cube::select(to, variant));
        (a == b).then(|| [0, 1].map(|i| (to[i] - from[i]) * side))
    };
    let length = |[s, t]: [f64; 2]| s.hypot(t);
    let own = lambda(dx, dy);
    let step = |x: f64, y: f64| match (moved(of(x0, y), dx), moved(of(x, y0), dy)) {
        (Some(dx), Some(dy)) => length(dx).max(length(dy)).log2(),
        (_, _) => own,
    };
    [own, step(x, y), step(x0, y0)]
}

/// How a shader has a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Given {
    /// As it is interpolated.
    Varying,
    /// Computed by sums and products.
    Sum,
    /// Computed by a function: its derivatives are differences within a quad.
    Maximum,
}

impl Given {
    fn shader(self) -> &'static str {
        match self {
            Self::Varying => {
                "uniform samplerCube image;
                void main() {
                    gl_FragColor = vec4(textureCube(image, gl_TexCoord[0].stp).r, 0.0, 0.0, 0.0);
                }"
            }
            Self::Sum => {
                "uniform samplerCube image;
                void main() {
                    vec3 r = gl_TexCoord[0].stp;
                    r = vec3(r.x + r.y, r.y + r.z, r.z + r.x);
                    r = 0.5 * vec3(r.x - r.y + r.z, r.x + r.y - r.z, r.y + r.z - r.x);
                    gl_FragColor = vec4(textureCube(image, r).r, 0.0, 0.0, 0.0);
                }"
            }
            Self::Maximum => {
                "uniform samplerCube image;
                void main() {
                    vec3 r = max(gl_TexCoord[0].stp, vec3(-64.0));
                    gl_FragColor = vec4(textureCube(image, r).r, 0.0, 0.0, 0.0);
                }"
            }
        }
    }
}

fn levels(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("picture-cube-levels");
    let (mut kept, mut reached) = (0, [0usize; COUNT]);
    let rounds = harness.cases(27).max(9);
    let mut pixels_of_all = 0;
    for round in 0..rounds {
        let scale = [1.0, 0.25, 0.05][round % 3];
        let given = [Given::Varying, Given::Sum, Given::Maximum][round / 3 % 3];
        let mut directions = Directions::random(&mut rng);
        directions.across = directions.across.map(|c| c * scale);
        directions.up = directions.up.map(|c| c * scale);
        if given == Given::Maximum {
            // Differences of rounded directions are off by more than λ may be.
            directions = directions.exact();
        }
        let picture = directions.picture;
        pixels_of_all += picture[0] * picture[1];
        let in_range = |lambda: f64| (0.0..(COUNT - 1) as f64).contains(&lambda);
        let pixels: Vec<Pixel> = super::pictures::all(picture)
            .filter(|pixel| {
                !is_open(directions.of(*pixel))
                    && lambdas(&directions, *pixel, Variant::CORRECT).into_iter().all(in_range)
            })
            .collect();
        kept += pixels.len();
        for pixel in &pixels {
            reached[lambdas(&directions, *pixel, Variant::CORRECT)[0] as usize] += 1;
        }
        let expect = |pixel: &Pixel, variant: Variant| {
            let off = if variant.has(Mutation::LambdaOffByOne) { 1.0 } else { 0.0 };
            [lambdas(&directions, *pixel, variant)[0] + off, 0.0, 0.0, 0.0]
        };
        let error = |pixel: &Pixel, expected: [f64; 4], found: [f64; 4]| {
            // λ may be any of several, or between them; a mistake moves all of them.
            let all = lambdas(&directions, *pixel, Variant::CORRECT);
            let moved = all.map(|lambda| lambda + expected[0] - all[0]);
            let low = moved.into_iter().fold(f64::INFINITY, f64::min);
            let high = moved.into_iter().fold(f64::NEG_INFINITY, f64::max);
            (low - found[0]).max(found[0] - high).max(0.0)
        };
        harness.compare_by(tally, &(directions, given), &pixels, expect, error, |session| {
            session.frame(GL_RGBA32F, picture, 0)?;
            let target = GL_TEXTURE_CUBE_MAP;
            glBindTexture(target, 1);
            for level in 0..COUNT {
                let side = 1usize << (COUNT - 1 - level);
                let texels = vec![level as f32; side * side];
                for face in GL_TEXTURE_CUBE_MAP_POSITIVE_X..GL_TEXTURE_CUBE_MAP_POSITIVE_X + 6 {
                    glTexImage2D(face, level, GL_R32F, side, side, 0, GL_RED, GL_FLOAT, &texels);
                }
            }
            glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
            glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
            session.fragment_only(given.shader())?;
            directions.draw();
            let found = session.read_floats(picture)?;
            Ok(pixels.iter().map(|[x, y]| found[y * picture[0] + x]).collect())
        })?;
    }
    tally.reach("pixels compared", kept, pixels_of_all / 3);
    tally.reach("levels of detail", reached.iter().filter(|count| **count > 0).count(), 4);
    Ok(())
}
