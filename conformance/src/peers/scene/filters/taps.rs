//! Filters over the texels around a pixel.

use super::{Color, SIDE, dot, each, mix, opaque, smoothstep, texel};
use crate::peers::frame::Program;

pub(super) static BLUR: Program = Program {
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

pub(super) static CUBIC: Program = Program {
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

pub(super) static EDGES: Program = Program {
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

pub(super) static MEDIAN: Program = Program {
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

pub(super) static GLOW: Program = Program {
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

pub(super) static SHARPEN: Program = Program {
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
