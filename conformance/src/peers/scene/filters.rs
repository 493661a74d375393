//! Filters as emulators, players and games run them over a whole picture: one fragment program each, many lookups at
//! computed coordinates, many transcendental functions, loops.

use super::definition::{Scene, Workload};
use super::mesh::square;
use super::texture::bricks;
use crate::peers::frame::{
    BILINEAR, Draw, Fragment, FrameDescription, NEAREST, Program, Shading, Step, Texture,
};
use crate::reference::map::Homography;
use std::f64::consts::TAU;

/// The scenes.
#[rustfmt::skip]
pub const SCENES: &[Scene] = &[
    Scene { name: "filter-blur", what: "9 taps of a blur in linear light", load: Workload::Filter,
        recipe: |_| filter(&BLUR) },
    Scene { name: "filter-cubic", what: "16 taps of a Catmull-Rom filter", load: Workload::Filter,
        recipe: |_| filter(&CUBIC) },
    Scene { name: "filter-crt", what: "scan lines and a mask of a tube", load: Workload::Filter,
        recipe: |_| filter(&TUBE) },
    Scene { name: "filter-ntsc", what: "17 taps that decode a composite signal", load: Workload::Filter,
        recipe: |_| filter(&COMPOSITE) },
    Scene { name: "filter-edges", what: "13 taps of an edge-directed scaler", load: Workload::Filter,
        recipe: |_| filter(&EDGES) },
    Scene { name: "filter-median", what: "the median of 3×3 texels", load: Workload::Filter,
        recipe: |_| filter(&MEDIAN) },
    Scene { name: "filter-march", what: "rays marched through a lattice of balls", load: Workload::Filter,
        recipe: |_| filter(&MARCH) },
    Scene { name: "filter-dither", what: "4 levels, dithered in order", load: Workload::Filter,
        recipe: |_| filter(&DITHER) },
    Scene { name: "filter-glow", what: "13 taps of what is bright", load: Workload::Filter,
        recipe: |_| filter(&GLOW) },
    Scene { name: "filter-sharpen", what: "5 taps, sharpened by their contrast", load: Workload::Filter,
        recipe: |_| filter(&SHARPEN) },
    Scene { name: "filter-lens", what: "a lens with coloured edges", load: Workload::Filter,
        recipe: |_| bilinear(&LENS) },
    Scene { name: "filter-palette", what: "the nearest of 16 colours", load: Workload::Filter,
        recipe: |_| filter(&PALETTE) },
];

/// Texels along a side of the picture that is filtered.
const SIDE: f64 = 256.0;

/// The whole picture under a program, texels nearest.
fn filter(program: &'static Program) -> FrameDescription {
    whole(program, Texture::new(vec![bricks(SIDE as usize)], NEAREST))
}

/// The whole picture under a program, texels bilinear.
fn bilinear(program: &'static Program) -> FrameDescription {
    whole(program, Texture::new(vec![bricks(SIDE as usize)], BILINEAR))
}

fn whole(program: &'static Program, texture: Texture) -> FrameDescription {
    let mesh = square(&Homography([[0.5, 0.0, 0.5], [0.0, 0.5, 0.5], [0.0, 0.0, 1.0]]));
    FrameDescription {
        textures: vec![texture],
        steps: vec![Step::Draw(Draw::new(mesh, Shading::Program(program)))],
    }
}

type Color = [f64; 3];

/// The texel so many columns and rows from the one at (s, t).
fn texel(f: &Fragment<'_>, [x, y]: [f64; 2]) -> Color {
    let cell = f.st.map(|c| (c * SIDE).floor());
    let [r, g, b, _] = (f.texture)(0, [(cell[0] + x + 0.5) / SIDE, (cell[1] + y + 0.5) / SIDE]);
    [r, g, b]
}

fn each(f: impl Fn(usize) -> f64) -> Color {
    std::array::from_fn(f)
}

fn opaque([r, g, b]: Color) -> [f64; 4] {
    [r, g, b, 1.0].map(|c| c.clamp(0.0, 1.0))
}

fn dot(a: Color, b: Color) -> f64 {
    (0..3).map(|c| a[c] * b[c]).sum()
}

fn mix(a: f64, b: f64, t: f64) -> f64 {
    a * (1.0 - t) + b * t
}

fn smoothstep(low: f64, high: f64, x: f64) -> f64 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// `texel` in GLSL.
macro_rules! with_texels {
    ($body:literal) => {
        concat!(
            "
uniform sampler2D unit0;
vec3 texel(float x, float y) {
    vec2 cell = floor(gl_TexCoord[0].st * 256.0);
    return texture2D(unit0, (cell + vec2(x + 0.5, y + 0.5)) / 256.0).rgb;
}
",
            $body
        )
    };
}

static BLUR: Program = Program {
    fragment: with_texels!(
        "
void main() {
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int k = -4; k <= 4; k++) {
        float w = exp(-0.1 * float(k * k));
        sum += w * pow(texel(float(k), 0.0), vec3(2.2));
        weights += w;
    }
    gl_FragColor = vec4(pow(sum / weights, vec3(1.0 / 2.2)), 1.0);
}
"
    ),
    formula: |f| {
        let taps = (-4..=4).map(|k| (f64::from(k), (-0.1 * f64::from(k * k)).exp()));
        let weights: f64 = taps.clone().map(|(_, w)| w).sum();
        let mean = each(|c| {
            taps.clone().map(|(k, w)| w * texel(f, [k, 0.0])[c].powf(2.2)).sum::<f64>() / weights
        });
        opaque(mean.map(|c| c.powf(1.0 / 2.2)))
    },
};

static CUBIC: Program = Program {
    fragment: with_texels!(
        "
vec4 weights(float t) {
    float t2 = t * t;
    float t3 = t2 * t;
    return 0.5 * vec4(2.0 * t2 - t3 - t, 3.0 * t3 - 5.0 * t2 + 2.0, 4.0 * t2 - 3.0 * t3 + t, t3 - t2);
}
vec3 row(vec4 w, float y) {
    return w.x * texel(-1.0, y) + w.y * texel(0.0, y) + w.z * texel(1.0, y) + w.w * texel(2.0, y);
}
void main() {
    vec2 t = fract(gl_TexCoord[0].st * 256.0);
    vec4 x = weights(t.x);
    vec4 y = weights(t.y);
    vec3 color = y.x * row(x, -1.0) + y.y * row(x, 0.0) + y.z * row(x, 1.0) + y.w * row(x, 2.0);
    gl_FragColor = vec4(color, 1.0);
}
"
    ),
    formula: |f| {
        let weights = |t: f64| {
            let (t2, t3) = (t * t, t * t * t);
            [
                2.0 * t2 - t3 - t,
                3.0 * t3 - 5.0 * t2 + 2.0,
                4.0 * t2 - 3.0 * t3 + t,
                t3 - t2,
            ]
            .map(|w| 0.5 * w)
        };
        let [x, y] = f.st.map(|c| weights((c * SIDE).fract()));
        let mut sum = [0.0; 3];
        for (j, y) in y.iter().enumerate() {
            for (i, x) in x.iter().enumerate() {
                let of = texel(f, [i as f64 - 1.0, j as f64 - 1.0]);
                sum = each(|c| sum[c] + x * y * of[c]);
            }
        }
        opaque(sum)
    },
};

static TUBE: Program = Program {
    fragment: with_texels!(
        "
vec3 beam(vec3 color, float away) {
    vec3 width = 0.3 + 0.3 * color;
    vec3 d = vec3(away) / width;
    return color * exp(-d * d);
}
void main() {
    vec2 p = gl_TexCoord[0].st * 256.0;
    float y = fract(p.y);
    float x = fract(p.x);
    vec3 here = pow(mix(texel(0.0, 0.0), texel(1.0, 0.0), x * x * (3.0 - 2.0 * x)), vec3(2.4));
    vec3 above = pow(mix(texel(0.0, 1.0), texel(1.0, 1.0), x * x * (3.0 - 2.0 * x)), vec3(2.4));
    vec3 light = beam(here, y) + beam(above, 1.0 - y);
    float phase = p.x * 6.283185307;
    vec3 mask = 0.8 + 0.2 * sin(vec3(phase, phase + 2.094395102, phase + 4.188790205));
    gl_FragColor = vec4(pow(min(light * mask, 1.0), vec3(1.0 / 2.2)), 1.0);
}
"
    ),
    formula: |f| {
        let [x, y] = f.st.map(|c| (c * SIDE).fract());
        let t = x * x * (3.0 - 2.0 * x);
        let beam = |color: f64, away: f64| color * (-(away / (0.3 + 0.3 * color)).powi(2)).exp();
        let line =
            |row: f64, c: usize| mix(texel(f, [0.0, row])[c], texel(f, [1.0, row])[c], t).powf(2.4);
        opaque(each(|c| {
            let light = beam(line(0.0, c), y) + beam(line(1.0, c), 1.0 - y);
            let mask = 0.8 + 0.2 * (f.st[0] * SIDE * TAU + c as f64 * TAU / 3.0).sin();
            (light * mask).min(1.0).powf(1.0 / 2.2)
        }))
    },
};

static COMPOSITE: Program = Program {
    fragment: with_texels!(
        "
void main() {
    vec3 yiq = vec3(0.0);
    vec2 cell = floor(gl_TexCoord[0].st * 256.0);
    for (int k = -8; k <= 8; k++) {
        vec3 color = texel(float(k), 0.0);
        float phase = (cell.x + float(k)) * 2.094395102 + cell.y * 1.047197551;
        float c = cos(phase);
        float s = sin(phase);
        float signal = dot(color, vec3(0.299, 0.587, 0.114)) + c * dot(color, vec3(0.596, -0.274, -0.322))
            + s * dot(color, vec3(0.211, -0.523, 0.312));
        float w = 0.5 + 0.5 * cos(float(k) * 0.349065850);
        yiq += signal * vec3(k > -2 && k < 2 ? 1.0 / 3.0 : 0.0, w * c / 4.25, w * s / 4.25);
    }
    gl_FragColor = vec4(yiq.x + 0.956 * yiq.y + 0.621 * yiq.z, yiq.x - 0.272 * yiq.y - 0.647 * yiq.z,
        yiq.x - 1.106 * yiq.y + 1.703 * yiq.z, 1.0);
}
"
    ),
    formula: |f| {
        let cell = f.st.map(|c| (c * SIDE).floor());
        let mut yiq = [0.0; 3];
        for k in -8..=8 {
            let x = f64::from(k);
            let color = texel(f, [x, 0.0]);
            let (s, c) = ((cell[0] + x) * TAU / 3.0 + cell[1] * TAU / 6.0).sin_cos();
            let signal = dot(color, [0.299, 0.587, 0.114])
                + c * dot(color, [0.596, -0.274, -0.322])
                + s * dot(color, [0.211, -0.523, 0.312]);
            let w = 0.5 + 0.5 * (x * TAU / 18.0).cos();
            let luma = if (-1..=1).contains(&k) { 1.0 / 3.0 } else { 0.0 };
            let by = [luma, w * c / 4.25, w * s / 4.25];
            yiq = each(|c| yiq[c] + signal * by[c]);
        }
        let [y, i, q] = yiq;
        opaque([y + 0.956 * i + 0.621 * q, y - 0.272 * i - 0.647 * q, y - 1.106 * i + 1.703 * q])
    },
};

static EDGES: Program = Program {
    fragment: with_texels!(
        "
float luma(vec3 c) { return dot(c, vec3(0.3, 0.6, 0.1)); }
void main() {
    vec2 p = fract(gl_TexCoord[0].st * 256.0) - 0.5;
    vec2 way = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    p = abs(p);
    vec3 e = texel(0.0, 0.0);
    vec3 f = texel(way.x, 0.0);
    vec3 h = texel(0.0, way.y);
    float le = luma(e), lf = luma(f), lh = luma(h);
    float li = luma(texel(way.x, way.y));
    float lb = luma(texel(0.0, -way.y));
    float ld = luma(texel(-way.x, 0.0));
    float lc = luma(texel(way.x, -way.y));
    float lg = luma(texel(-way.x, way.y));
    float lf4 = luma(texel(2.0 * way.x, 0.0));
    float lh5 = luma(texel(0.0, 2.0 * way.y));
    float li4 = luma(texel(2.0 * way.x, way.y));
    float li5 = luma(texel(way.x, 2.0 * way.y));
    float along = abs(le - lc) + abs(le - lg) + abs(li - lh5) + abs(li - lf4) + 4.0 * abs(lh - lf);
    float across = abs(lh - ld) + abs(lh - li5) + abs(lf - li4) + abs(lf - lb) + 4.0 * abs(le - li);
    float edge = smoothstep(0.0, 0.4, across - along);
    float corner = smoothstep(0.3, 0.7, p.x + p.y);
    float nearer = smoothstep(-0.1, 0.1, abs(le - lh) - abs(le - lf));
    gl_FragColor = vec4(mix(e, mix(h, f, nearer), edge * corner), 1.0);
}
"
    ),
    formula: |f| {
        let p = f.st.map(|c| (c * SIDE).fract() - 0.5);
        let [wx, wy] = p.map(|c| if c < 0.0 { -1.0 } else { 1.0 });
        let luma = |x: f64, y: f64| dot(texel(f, [x * wx, y * wy]), [0.3, 0.6, 0.1]);
        let (le, lf, lh, li) = (luma(0.0, 0.0), luma(1.0, 0.0), luma(0.0, 1.0), luma(1.0, 1.0));
        let (lb, ld, lc, lg) = (luma(0.0, -1.0), luma(-1.0, 0.0), luma(1.0, -1.0), luma(-1.0, 1.0));
        let (lf4, lh5, li4, li5) = (luma(2.0, 0.0), luma(0.0, 2.0), luma(2.0, 1.0), luma(1.0, 2.0));
        let sum = |of: [f64; 4], last: f64| of.map(f64::abs).iter().sum::<f64>() + 4.0 * last.abs();
        let along = sum([le - lc, le - lg, li - lh5, li - lf4], lh - lf);
        let across = sum([lh - ld, lh - li5, lf - li4, lf - lb], le - li);
        let edge = smoothstep(0.0, 0.4, across - along);
        let corner = smoothstep(0.3, 0.7, p[0].abs() + p[1].abs());
        let nearer = smoothstep(-0.1, 0.1, (le - lh).abs() - (le - lf).abs());
        let [e, right, up] = [[0.0, 0.0], [wx, 0.0], [0.0, wy]].map(|at| texel(f, at));
        opaque(each(|c| mix(e[c], mix(up[c], right[c], nearer), edge * corner)))
    },
};

static MEDIAN: Program = Program {
    fragment: with_texels!(
        "
void order(inout vec3 a, inout vec3 b) { vec3 low = min(a, b); b = max(a, b); a = low; }
void main() {
    vec3 a = texel(-1.0, -1.0), b = texel(0.0, -1.0), c = texel(1.0, -1.0);
    vec3 d = texel(-1.0, 0.0), e = texel(0.0, 0.0), f = texel(1.0, 0.0);
    vec3 g = texel(-1.0, 1.0), h = texel(0.0, 1.0), i = texel(1.0, 1.0);
    order(b, c); order(e, f); order(h, i);
    order(a, b); order(d, e); order(g, h);
    order(b, c); order(e, f); order(h, i);
    order(a, d); order(f, i); order(e, h);
    order(d, g); order(b, e); order(c, f);
    order(e, h); order(e, c); order(g, e);
    order(e, c);
    gl_FragColor = vec4(e, 1.0);
}
"
    ),
    formula: |f| {
        let places = (-1..=1).flat_map(|y| (-1..=1).map(move |x| [x, y].map(f64::from)));
        let texels: Vec<Color> = places.map(|at| texel(f, at)).collect();
        opaque(each(|c| {
            let mut channel: Vec<f64> = texels.iter().map(|texel| texel[c]).collect();
            channel.sort_by(f64::total_cmp);
            channel[4]
        }))
    },
};

static MARCH: Program = Program {
    fragment: "
uniform sampler2D unit0;
void main() {
    vec3 way = normalize(vec3(gl_TexCoord[0].st * 2.0 - 1.0, 1.5));
    vec3 from = vec3(0.3, 0.9, -3.0);
    float far = 0.0;
    for (int k = 0; k < 64; k++) {
        vec3 p = from + far * way;
        float d = length(mod(p, 2.0) - 1.0) - 0.45;
        if (d < 0.001 || far > 24.0) break;
        far += d;
    }
    vec3 p = mod(from + far * way, 2.0) - 1.0;
    vec3 color = texture2D(unit0, gl_TexCoord[0].st).rgb;
    float light = 0.5 + 0.5 * dot(p, vec3(0.3, 0.6, -0.6)) / 0.45;
    gl_FragColor = vec4(mix(color, vec3(light), exp(-0.12 * far)), 1.0);
}
",
    formula: |f| {
        let way = [f.st[0] * 2.0 - 1.0, f.st[1] * 2.0 - 1.0, 1.5];
        let length = dot(way, way).sqrt();
        let from = [0.3, 0.9, -3.0];
        let at = |far: f64| each(|c| (from[c] + far * way[c] / length).rem_euclid(2.0) - 1.0);
        let mut far = 0.0;
        for _ in 0..64 {
            let p = at(far);
            let d = dot(p, p).sqrt() - 0.45;
            if d < 0.001 || far > 24.0 {
                break;
            }
            far += d;
        }
        let light = 0.5 + 0.5 * dot(at(far), [0.3, 0.6, -0.6]) / 0.45;
        let color = (f.texture)(0, f.st);
        opaque(each(|c| mix(color[c], light, (-0.12 * far).exp())))
    },
};

static DITHER: Program = Program {
    fragment: with_texels!(
        "
float bayer(vec2 p) {
    vec2 a = mod(p, 2.0);
    vec2 b = mod(floor(p / 2.0), 2.0);
    float low = 2.0 * a.x + 3.0 * a.y - 4.0 * a.x * a.y;
    float high = 2.0 * b.x + 3.0 * b.y - 4.0 * b.x * b.y;
    return (4.0 * low + high + 0.5) / 16.0;
}
void main() {
    float threshold = bayer(floor(gl_TexCoord[0].st * 512.0));
    vec3 color = pow(texel(0.0, 0.0), vec3(1.2));
    gl_FragColor = vec4(floor(color * 3.0 + threshold) / 3.0, 1.0);
}
"
    ),
    formula: |f| {
        let p = f.st.map(|c| (c * 512.0).floor());
        let two = |[x, y]: [f64; 2]| 2.0 * x + 3.0 * y - 4.0 * x * y;
        let low = two(p.map(|c| c.rem_euclid(2.0)));
        let high = two(p.map(|c| (c / 2.0).floor().rem_euclid(2.0)));
        let threshold = (4.0 * low + high + 0.5) / 16.0;
        opaque(texel(f, [0.0, 0.0]).map(|c| (c.powf(1.2) * 3.0 + threshold).floor() / 3.0))
    },
};

static GLOW: Program = Program {
    fragment: with_texels!(
        "
vec3 bright(float x, float y) {
    vec3 c = texel(x, y);
    float l = dot(c, vec3(0.2126, 0.7152, 0.0722));
    return c * smoothstep(0.4, 0.8, l);
}
void main() {
    vec3 sum = 0.125 * bright(0.0, 0.0);
    for (int k = 0; k < 4; k++) {
        float x = k < 2 ? -1.0 : 1.0;
        float y = k == 0 || k == 3 ? -1.0 : 1.0;
        sum += 0.125 * bright(x, y) + 0.03125 * bright(2.0 * x, 2.0 * y);
        sum += 0.0625 * bright(x + y, x - y);
    }
    gl_FragColor = vec4(texel(0.0, 0.0) + 0.6 * sum, 1.0);
}
"
    ),
    formula: |f| {
        let bright = |x: f64, y: f64| {
            let c = texel(f, [x, y]);
            let by = smoothstep(0.4, 0.8, dot(c, [0.2126, 0.7152, 0.0722]));
            c.map(|c| c * by)
        };
        let mut sum = bright(0.0, 0.0).map(|c| 0.125 * c);
        for [x, y] in [[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]] {
            let taps = [bright(x, y), bright(2.0 * x, 2.0 * y), bright(x + y, x - y)];
            sum =
                each(|c| sum[c] + 0.125 * taps[0][c] + 0.03125 * taps[1][c] + 0.0625 * taps[2][c]);
        }
        let here = texel(f, [0.0, 0.0]);
        opaque(each(|c| here[c] + 0.6 * sum[c]))
    },
};

static SHARPEN: Program = Program {
    fragment: with_texels!(
        "
void main() {
    vec3 b = texel(0.0, -1.0), d = texel(-1.0, 0.0), e = texel(0.0, 0.0);
    vec3 f = texel(1.0, 0.0), h = texel(0.0, 1.0);
    vec3 low = min(min(min(b, d), min(f, h)), e);
    vec3 high = max(max(max(b, d), max(f, h)), e);
    vec3 amount = sqrt(clamp(min(low, 1.0 - high) / max(high, 0.01), 0.0, 1.0));
    vec3 w = -amount / 6.0;
    gl_FragColor = vec4(clamp(((b + d + f + h) * w + e) / (1.0 + 4.0 * w), 0.0, 1.0), 1.0);
}
"
    ),
    formula: |f| {
        let places = [[0.0, -1.0], [-1.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let (around, e) = (places.map(|at| texel(f, at)), texel(f, [0.0, 0.0]));
        opaque(each(|c| {
            let low = around.iter().map(|of| of[c]).fold(e[c], f64::min);
            let high = around.iter().map(|of| of[c]).fold(e[c], f64::max);
            let amount = (low.min(1.0 - high) / high.max(0.01)).clamp(0.0, 1.0).sqrt();
            let w = -amount / 6.0;
            (around.iter().map(|of| of[c]).sum::<f64>() * w + e[c]) / (1.0 + 4.0 * w)
        }))
    },
};

static LENS: Program = Program {
    fragment: "
uniform sampler2D unit0;
float channel(vec2 p, float k) {
    return dot(texture2D(unit0, 0.5 + p * (1.0 + k * dot(p, p))).rgb, vec3(0.4, 0.4, 0.2));
}
void main() {
    vec2 p = gl_TexCoord[0].st - 0.5;
    vec3 color = vec3(channel(p, 0.18), channel(p, 0.2), channel(p, 0.22));
    gl_FragColor = vec4(color * (1.0 - 0.8 * pow(length(p), 2.5)), 1.0);
}
",
    formula: |f| {
        let p = f.st.map(|c| c - 0.5);
        let square = p[0] * p[0] + p[1] * p[1];
        let dark = 1.0 - 0.8 * square.sqrt().powf(2.5);
        opaque([0.18, 0.2, 0.22].map(|k| {
            let [r, g, b, _] = (f.texture)(0, p.map(|c| 0.5 + c * (1.0 + k * square)));
            dot([r, g, b], [0.4, 0.4, 0.2]) * dark
        }))
    },
};

static PALETTE: Program = Program {
    fragment: with_texels!(
        "
void main() {
    vec3 color = texel(0.0, 0.0);
    vec3 nearest = vec3(0.0);
    float least = 10.0;
    for (int k = 0; k < 16; k++) {
        float x = float(k) / 15.0;
        vec3 of = 0.52 + 0.47 * cos(6.283185307 * (x * vec3(1.0, 0.7, 0.4) + vec3(0.0, 0.33, 0.67)));
        vec3 away = color - of;
        float d = dot(away, away);
        if (d < least) {
            least = d;
            nearest = of;
        }
    }
    gl_FragColor = vec4(nearest, 1.0);
}
"
    ),
    formula: |f| {
        let color = texel(f, [0.0, 0.0]);
        let (by, from) = ([1.0, 0.7, 0.4], [0.0, 0.33, 0.67]);
        let palette = (0..16).map(|k| {
            let x = f64::from(k) / 15.0;
            each(|c| 0.52 + 0.47 * (TAU * (x * by[c] + from[c])).cos())
        });
        let away = |of: &Color| (0..3).map(|c| (color[c] - of[c]).powi(2)).sum::<f64>();
        let nearest = palette.min_by(|a, b| away(a).total_cmp(&away(b)));
        opaque(nearest.unwrap_or_default())
    },
};
