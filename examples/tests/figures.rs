//! What the captions of the lectures' figures say is so, measured in their pictures and traces.

use examples::matrix::dvec3;
use examples::picture::packed_pixel_t;
use examples::programs::{
    bump_shadows, forward_coverage, minification, mip_seams, pixel_area, textured_square,
    view_independence,
};
use examples::window::{Program, explain, render};
use gl_api::constants::*;
use gl_api::context::{Context, ContextDesc};
use gl_api::*;
use rasterizer::trace::{PixelEvent, Step};
use texunit::trace::SampleStep;

const SIZE: usize = 256;

/// A panel's pixels, without the lowest tenth, where its caption is.
fn panel(program: &Program, columns: usize, rows: usize, at: usize) -> Vec<Vec<packed_pixel_t>> {
    let desc = ContextDesc::default();
    let picture = render(program, SIZE, None, &desc).expect("a context of this size").picture;
    let (width, height) = (picture.width / columns, picture.height / rows);
    let (left, top) = (at % columns * width, at / columns * height);
    let row = |y: usize| &picture.pixels[y * picture.width + left..][..width];
    (top..top + height * 9 / 10).map(|y| row(y).to_vec()).collect()
}

fn count(panel: &[Vec<packed_pixel_t>], is: impl Fn(&packed_pixel_t) -> bool) -> usize {
    panel.iter().flatten().filter(|pixel| is(pixel)).count()
}

/// Texels and interpolations of the first sample at a pixel, by the steps of the texture unit; and whether
/// the interpolations, computed again, give what was sampled.
fn interpolations(program: &Program, pixel: [usize; 2]) -> (usize, usize, bool) {
    let desc = ContextDesc::default();
    let (_, explanation) = explain(program, SIZE, None, &desc, pixel).expect("a pixel inside");
    let traces = explanation.events.iter().filter_map(|event| match event {
        PixelEvent::Fragment(fragment) => Some(fragment),
        _ => None,
    });
    let mut traces = traces.flat_map(|fragment| &fragment.steps).filter_map(|step| match step {
        Step::Lookup(lookup) => lookup.trace.as_ref(),
        _ => None,
    });
    let trace = traces.next().expect("a sample");
    let (mut texels, mut lerps, mut levels): (Vec<f32>, usize, Vec<f32>) = (vec![], 0, vec![]);
    let (mut weights, mut between) = ([0_f32; 3], 0_f32);
    let mut lerp = |a: f32, b: f32, t: f32| {
        lerps += 1;
        a + (b - a) * t
    };
    let mut read = 0;
    for step in &trace.steps {
        match step {
            SampleStep::Levels { weight, .. } => between = *weight,
            SampleStep::Linear { weights: of, .. } => weights = *of,
            SampleStep::Texel { value, .. } => texels.push(value[0]),
            SampleStep::Filtered(_) => {
                let [a, b, c, d] = texels[..] else { panic!("four texels, not {texels:?}") };
                read += texels.len();
                texels.clear();
                let (low, high) = (lerp(a, b, weights[0]), lerp(c, d, weights[0]));
                levels.push(lerp(low, high, weights[1]));
            }
            _ => {}
        }
    }
    let value = match levels[..] {
        [one] => one,
        [low, high] => lerp(low, high, between),
        _ => panic!("one or two levels, not {levels:?}"),
    };
    (read, lerps, (value - trace.result[0]).abs() < 1e-5)
}

#[test]
fn trilinear_filtering_takes_eight_texels_and_seven_interpolations() {
    // In the half of the picture where texels are smaller than pixels.
    let y = SIZE / 5;
    assert_eq!(interpolations(&mip_seams::PROGRAM, [SIZE / 3, y]), (4, 3, true));
    assert_eq!(interpolations(&mip_seams::PROGRAM, [SIZE + SIZE / 3, y]), (8, 7, true));
}

#[test]
fn forward_mapping_leaves_holes_and_overlaps_and_areas_have_neither() {
    let texels = panel(&forward_coverage::PROGRAM, 2, 2, 1);
    let red = count(&texels, |p| p.r > 200 && p.g < 60);
    let yellow = count(&texels, |p| p.r > 200 && p.g > 200);
    assert!(red > 500 && yellow > 2000, "{red} {yellow}");
    // A hole: black between two that are not, in one row.
    let holes = |panel: &[Vec<packed_pixel_t>]| -> usize {
        let black = |p: &packed_pixel_t| *p == packed_pixel_t::default();
        let inside = |row: &Vec<packed_pixel_t>| {
            let first = row.iter().position(|p| !black(p))?;
            let last = row.iter().rposition(|p| !black(p))?;
            Some(row[first..=last].iter().filter(|p| black(p)).count())
        };
        panel.iter().filter_map(inside).sum()
    };
    assert!(holes(&texels) > 5000, "{}", holes(&texels));
    assert_eq!(holes(&panel(&forward_coverage::PROGRAM, 2, 2, 3)), 0);
}

#[test]
fn nearest_is_even_worse_than_bilinear_in_the_last_row() {
    let middle = |column: usize| {
        let panel = panel(&minification::PROGRAM, 4, 3, 8 + column);
        panel[panel.len() / 2][panel[0].len() / 2].r
    };
    let [_, nearest, bilinear, pyramid] = [0, 1, 2, 3].map(middle);
    assert_eq!(nearest, 26, "all dark");
    assert_eq!(bilinear, pyramid, "the mean");
    assert!((139..=142).contains(&bilinear), "{bilinear}");
}

#[test]
fn levels_of_four_to_one_and_sixteen_to_one_are_mixed_by_the_logarithm() {
    // The swatches' middles, from the top: 4:1, 16:1, their mean, GL's.
    let swatches = panel(&pixel_area::PROGRAM, 3, 1, 2);
    let red = |way: usize| f64::from(swatches[18 + way * 32][SIZE * 3 / 4].r);
    let (level1, level2) = (red(3), red(4));
    assert!((red(5) - (level1 + level2) / 2.).abs() <= 1., "{} {level1} {level2}", red(5));
    let weight = 9_f64.log2() / 2. - 1.;
    assert!((weight - 0.585).abs() < 1e-3);
    assert!((red(6) - (level1 + (level2 - level1) * weight)).abs() <= 1., "{}", red(6));
}

#[test]
fn a_diffuse_ball_is_the_same_from_both_sides_and_a_shining_one_is_not() {
    let is_lit = |p: &packed_pixel_t| p.r > 2;
    assert_eq!(count(&panel(&view_independence::PROGRAM, 3, 2, 2), is_lit), 0);
    assert!(count(&panel(&view_independence::PROGRAM, 3, 2, 5), is_lit) > 1000);
}

#[test]
fn a_bumped_ball_casts_the_smooth_balls_shadow() {
    let [smooth, bump, displaced] = [0, 1, 2].map(|at| panel(&bump_shadows::PROGRAM, 3, 1, at));
    // The floor's shadow is grey, the ball's own is brown.
    let shadow = |p: &packed_pixel_t| p.r < 60 && p.b >= p.r;
    let differ = |a: &[Vec<packed_pixel_t>], b: &[Vec<packed_pixel_t>]| {
        a.iter().flatten().zip(b.iter().flatten()).filter(|(a, b)| shadow(a) != shadow(b)).count()
    };
    assert!(count(&smooth, shadow) > 2000);
    assert_eq!(differ(&smooth, &bump), 0);
    assert!(differ(&smooth, &displaced) > 300, "{}", differ(&smooth, &displaced));
}

#[test]
fn the_nearest_of_three_planes_is_up_to_54_7_degrees_away() {
    let nearest = |x: f64, y: f64, z: f64| {
        let along = dvec3(x, y, z).normalize().abs().max_element();
        along.min(1.).acos().to_degrees()
    };
    let steps = -40..=40;
    let directions = || {
        steps.clone().flat_map(|x| {
            steps.clone().flat_map(move |y| (-40..=40).map(move |z| [x, y, z].map(f64::from)))
        })
    };
    let angles = directions().filter(|v| *v != [0.; 3]).map(|[x, y, z]| nearest(x, y, z));
    let largest = angles.fold(0_f64, f64::max);
    assert!((largest - 54.7356).abs() < 1e-4, "{largest}");
    assert!((nearest(1., 1., 1.) - largest).abs() < 1e-9);
    // Between two planes the lecture's rule holds.
    assert!((nearest(1., 1., 0.) - 45.).abs() < 1e-9);
}

#[test]
fn the_name_that_the_lecture_asks_for_is_not_in_its_shader() {
    let _current = Context::new(ContextDesc::default()).expect("a context").make_current();
    let compile = |kind, text: &str| {
        let shader = glCreateShader(kind);
        glShaderSource(shader, 1, text, NULL);
        glCompileShader(shader);
        shader
    };
    let source = textured_square::PROGRAM.source;
    let shader_of = |name: &str| {
        let text = source.split(name).nth(1).expect("the shader").split("\\\n").nth(1);
        text.expect("its text").split("\";").next().expect("its end").to_owned()
    };
    let program = glCreateProgram();
    glAttachShader(program, compile(GL_VERTEX_SHADER, &shader_of("const VERTEX_SHADER")));
    glAttachShader(program, compile(GL_FRAGMENT_SHADER, &shader_of("const FRAGMENT_SHADER")));
    glLinkProgram(program);
    assert_eq!(glGetUniformLocation(program, "texUnit0"), -1);
    assert!(glGetUniformLocation(program, "uTexUnit0") >= 0);
    // The call with it does nothing, and is no error: the sampler is on unit 0 as uniforms begin with 0.
    glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "texUnit0"), 3);
    let mut unit = [-1];
    glGetUniformiv(program, glGetUniformLocation(program, "uTexUnit0"), &mut unit);
    assert_eq!(unit, [0]);
    assert_eq!(glGetError(), GL_NO_ERROR);
}
