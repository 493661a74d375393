//! Colours of vertices: two sides, materials from colours, highlights apart, rescaled normals.

use super::pictures::{Pictures, Pixel, window};
use super::vertex::{self as vertices, Case};
use crate::check::{Check, Harness, Tally, Unit};
use crate::gl::*;
use crate::mutation::{Mutation, Variant};
use crate::oracle::matrix;
use crate::oracle::vertex::{self, Eye, Light, Surface};
use crate::probe::ProbeError;
use crate::rng::Rng;
use gl_api::constants::*;

/// Both sides.
pub const TWO_SIDED: Check = Check {
    name: "two-sided-light",
    citation: "GL 2.1, 2.14.1: the back colour: −n, the back material; the sign of the area selects",
    what: "every pixel of rectangles of either winding under random lights, glFrontFace both ways",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 21) as f64,
    why: "f32: cosines off by 2^-24, raised to powers up to 32, of highlights up to 1/4 that are that steep",
    run: two_sided,
};

/// Materials from colours.
pub const COLOR_MATERIAL: Check = Check {
    name: "color-material",
    citation: "GL 2.1, 2.14.3: GL_COLOR_MATERIAL tracks one of five sets of parameters",
    what: "lit colours under random lights where glColor changes at each vertex",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 21) as f64,
    why: "f32: cosines off by 2^-24, raised to powers up to 32, of highlights up to 1/4 that are that steep, times two lights",
    run: color_material,
};

/// Highlights apart.
pub const SEPARATE_SPECULAR: Check = Check {
    name: "separate-specular",
    citation: "GL 2.1, 2.14.1 and 3.9: GL_SEPARATE_SPECULAR_COLOR: added after texturing",
    what: "lit and textured colours under random lights",
    unit: Unit::FullScale,
    tolerance: 1.0 / (1 << 21) as f64,
    why: "f32: cosines off by 2^-24, raised to powers up to 32, of highlights up to 1/4 that are that steep, times two lights",
    run: separate_specular,
};

/// Rescaled normals.
pub const RESCALE: Check = Check {
    name: "rescale-normal",
    citation: "GL 2.1, 2.11.3, equation 2.2: f = 1/√(m31² + m32² + m33²) of the inverse",
    what: "normals under random model-view matrices with GL_RESCALE_NORMAL, and without",
    unit: Unit::FullScale,
    tolerance: 1.5 / (1 << 22) as f64,
    why: "f32: three products with elements of an inverse up to 2 and their sum, 2^-24 each",
    run: rescaled,
};

const PICTURE: Pixel = [61, 43];

/// A light that is infinitely far.
fn far_light(rng: &mut Rng) -> Light {
    let mut light = vertices::light(rng);
    light.position[3] = 0.0;
    (light.spot_cutoff, light.spot_exponent) = (180.0, 0.0);
    light
}

fn material(face: u32, of: &Surface) {
    let single = |v: [f64; 4]| v.map(|c| c as f32);
    glMaterialfv(face, GL_AMBIENT, &single(of.ambient));
    glMaterialfv(face, GL_DIFFUSE, &single(of.diffuse));
    glMaterialfv(face, GL_SPECULAR, &single(of.specular));
    glMaterialfv(face, GL_EMISSION, &single(of.emission));
    glMaterialf(face, GL_SHININESS, of.shininess);
}

fn two_sided(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("two-sided-light");
    let mut pictures = Pictures::new(harness, tally, PICTURE);
    for round in 0..harness.cases(48).max(4) {
        let lights: Vec<Light> = (0..=round % 2).map(|_| far_light(&mut rng)).collect();
        let front = Surface { local_viewer: false, ..vertices::surface(&mut rng) };
        let back = Surface {
            scene_ambient: front.scene_ambient,
            ..Surface { local_viewer: false, ..vertices::surface(&mut rng) }
        };
        let ccw_is_front = round / 2 % 2 == 0;
        // Two columns of rectangles, one of each winding, with a normal each.
        let rows = 7;
        let normals: Vec<[f64; 3]> = (0..2 * rows)
            .map(|_| {
                loop {
                    let n = [0; 3].map(|_: i32| f64::from(rng.real(-1.0, 1.0)));
                    let length = n.iter().map(|c| c * c).sum::<f64>().sqrt();
                    let unit = n.map(|c| c / length);
                    let eye =
                        Eye { object: [0.0; 4], position: [0.0, 0.0, 0.0, 1.0], normal: unit };
                    if length > 0.3 && lights.iter().all(|light| !vertices::on_edge(light, &eye)) {
                        break unit;
                    }
                }
            })
            .collect();
        let cell = |[x, y]: Pixel| {
            (x * 2 / (PICTURE[0] - 1)).min(1) * rows + (y * rows / PICTURE[1]).min(rows - 1)
        };
        let bounds = |k: usize| {
            let (column, row) = (k / rows, k % rows);
            let x = [0, PICTURE[0] / 2, PICTURE[0]];
            let y = |row: usize| (row * PICTURE[1]).div_ceil(rows);
            ([x[column], x[column + 1]], [y(row), y(row + 1)])
        };
        let expect = |pixel: Pixel, variant: Variant| {
            let k = cell(pixel);
            let is_ccw = k < rows;
            let swapped = variant.has(Mutation::FacesSwapped);
            let is_front = (is_ccw == ccw_is_front) != swapped;
            let (of, sign) = if is_front { (&front, 1.0) } else { (&back, -1.0) };
            let sign = if variant.has(Mutation::BackNormalKept) { 1.0 } else { sign };
            let normal = normals[k].map(|c| sign * c);
            let eye = Eye { object: [0.0; 4], position: [0.0, 0.0, 0.0, 1.0], normal };
            Some(vertex::light(&eye, &lights, of, variant))
        };
        pictures.compare(&(round, ccw_is_front), expect, |session| {
            session.frame(GL_RGBA32F, PICTURE, 0)?;
            session.lighting(&lights, &front)?;
            glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
            material(GL_FRONT, &front);
            material(GL_BACK, &back);
            glFrontFace(if ccw_is_front { GL_CCW } else { GL_CW });
            window(PICTURE);
            glBegin(GL_QUADS);
            for (k, [x, y, z]) in normals.iter().enumerate() {
                let ([x0, x1], [y0, y1]) = bounds(k);
                let mut corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
                if k >= rows {
                    corners.reverse();
                }
                glNormal3d(*x, *y, *z);
                for [x, y] in corners {
                    glVertex2f(x as f32, y as f32);
                }
            }
            glEnd();
            session.read_floats(PICTURE)
        })?;
    }
    pictures.finish(100, 90);
    Ok(())
}

/// Cases without lights at grazing angles or at the edge of a spot.
fn lit_cases(rng: &mut Rng, m: &[f32; 16], lights: &[Light]) -> Vec<Case> {
    let mut cases = vertices::cases(rng, 128);
    cases.retain(|case| {
        let v = vertices::eye(m, case, Variant::CORRECT);
        lights.iter().all(|light| !vertices::on_edge(light, &v))
    });
    cases
}

const TRACKED: [u32; 5] =
    [GL_AMBIENT_AND_DIFFUSE, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION];

fn color_material(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("color-material");
    for round in 0..harness.cases(40).max(5) {
        let mode = TRACKED[round % 5];
        let lights: Vec<Light> = (0..=round % 2).map(|_| vertices::light(&mut rng)).collect();
        let (surface, m) = (vertices::surface(&mut rng), vertices::model_view(&mut rng));
        let cases: Vec<(Case, [f32; 4])> = lit_cases(&mut rng, &m, &lights)
            .into_iter()
            .map(|case| (case, [0; 4].map(|_: i32| rng.real(0.0, 1.0))))
            .collect();
        let expect = |(case, color): &(Case, [f32; 4]), variant: Variant| {
            let mut of = surface;
            let color = color.map(f64::from);
            let mode =
                if variant.has(Mutation::AlwaysAmbientAndDiffuse) { TRACKED[0] } else { mode };
            match mode {
                GL_AMBIENT => of.ambient = color,
                GL_DIFFUSE => of.diffuse = color,
                GL_SPECULAR => of.specular = color,
                GL_EMISSION => of.emission = color,
                _ => (of.ambient, of.diffuse) = (color, color),
            }
            vertex::light(&vertices::eye(&m, case, variant), &lights, &of, variant)
        };
        harness.compare(tally, &(enum_name(mode), round), &cases, expect, |session| {
            session.float_target()?;
            glLoadIdentity();
            session.lighting(&lights, &surface)?;
            glColorMaterial(GL_FRONT_AND_BACK, mode);
            // What is not tracked stays as it is.
            glColor4f(0.5, 0.5, 0.5, 0.5);
            glEnable(GL_COLOR_MATERIAL);
            glLoadMatrixf(&m);
            session.points(cases.len(), |k| {
                let (case, [r, g, b, a]) = cases[k];
                glColor4f(r, g, b, a);
                vertices::draw(case);
            })
        })?;
        tally.reach(format!("cases of {} {round}", enum_name(mode)), cases.len(), 90);
    }
    Ok(())
}

/// A texture of one texel, modulating.
pub(super) fn one_texel(texel: [f32; 4]) {
    let target = GL_TEXTURE_2D;
    glBindTexture(target, 3);
    glTexImage2D(target, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, &texel);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    glEnable(target);
}

fn separate_specular(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("separate-specular");
    for round in 0..harness.cases(40).max(4) {
        let lights: Vec<Light> = (0..=round % 2).map(|_| vertices::light(&mut rng)).collect();
        let (surface, m) = (vertices::surface(&mut rng), vertices::model_view(&mut rng));
        let texel = [0; 4].map(|_: i32| rng.real(0.0, 1.0));
        let cases = lit_cases(&mut rng, &m, &lights);
        let expect = |case: &Case, variant: Variant| {
            let eye = vertices::eye(&m, case, variant);
            let none = [0.0; 4];
            if variant.has(Mutation::SpecularTextured) {
                let all = vertex::light(&eye, &lights, &surface, variant);
                return std::array::from_fn(|i| all[i] * f64::from(texel[i]));
            }
            let dull = Surface { specular: none, ..surface };
            let shiny = Surface { ambient: none, diffuse: none, emission: none, ..surface };
            let primary = vertex::light(&eye, &lights, &dull, variant);
            let secondary = vertex::light(&eye, &lights, &shiny, variant);
            let mut sum: [f64; 4] = std::array::from_fn(|i| {
                (primary[i] * f64::from(texel[i]) + secondary[i]).clamp(0.0, 1.0)
            });
            sum[3] = primary[3] * f64::from(texel[3]);
            sum
        };
        harness.compare(tally, &round, &cases, expect, |session| {
            session.float_target()?;
            // The target has floats, but the sum is clamped as for a window.
            glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_TRUE);
            glLoadIdentity();
            session.lighting(&lights, &surface)?;
            glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR as i32);
            one_texel(texel);
            glLoadMatrixf(&m);
            session.points(cases.len(), |k| vertices::draw(cases[k]))
        })?;
    }
    Ok(())
}

fn rescaled(harness: &Harness, tally: &mut Tally) -> Result<(), ProbeError> {
    let mut rng = Rng::named("rescale-normal");
    for round in 0..harness.cases(32).max(4) {
        let (m, rescales) = (vertices::model_view(&mut rng), round % 2 == 0);
        let cases = vertices::cases(&mut rng, 128);
        let expect = |(_, normal): &Case, variant: Variant| {
            let inverse = matrix::inverse(&matrix::from_columns(&m));
            let [x, y, z] = normal.map(f64::from);
            let n = matrix::apply_row([x, y, z, 0.0], &inverse);
            let [a, b, c, _] = inverse[2];
            let f = (a * a + b * b + c * c).sqrt();
            let f = if rescales && !variant.has(Mutation::RescaleIgnored) { 1.0 / f } else { 1.0 };
            [f * n[0], f * n[1], f * n[2], 1.0]
        };
        harness.compare(tally, &(rescales, round), &cases, expect, |session| {
            session.float_target()?;
            session.show_coordinates()?;
            for (coordinate, enable) in
                [(GL_S, GL_TEXTURE_GEN_S), (GL_T, GL_TEXTURE_GEN_T), (GL_R, GL_TEXTURE_GEN_R)]
            {
                glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP as i32);
                glEnable(enable);
            }
            if rescales {
                glEnable(GL_RESCALE_NORMAL);
            }
            glLoadMatrixf(&m);
            session.points(cases.len(), |k| {
                glTexCoord4f(0, 0, 0, 1);
                vertices::draw(cases[k]);
            })
        })?;
    }
    Ok(())
}
