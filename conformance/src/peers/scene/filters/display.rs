//! What displays, signals and lenses make of a picture.

use super::{Color, SIDE, dot, each, mix, opaque, texel};
use crate::peers::frame::Program;
use std::f64::consts::TAU;

pub(super) static TUBE: Program = Program {
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

pub(super) static COMPOSITE: Program = Program {
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

pub(super) static DITHER: Program = Program {
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

pub(super) static LENS: Program = Program {
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

pub(super) static PALETTE: Program = Program {
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
