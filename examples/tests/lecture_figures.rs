//! The tables of figures in `docs/lectures.md` are what the programs measure.

use examples::lectures::PAGE;
use examples::locality::{ORDERS, lines_per_pixel};
use examples::picture::Picture;
use examples::plane_view::{lecture_rho, opengl_rho};
use examples::programs::{filter_cost, fixed_point, gift_wrapping, projective_shortcut};
use examples::stretch::{extremes, stretches};
use examples::window::{Program, explain, render};
use gl_api::context::ContextDesc;
use glam::{DVec2, dvec2};
use rasterizer::trace::{PixelEvent, Step};
use texunit::trace::SampleStep;

/// Fails with the table if the page does not have it.
fn is_on_the_page(rows: &[String]) {
    let table = rows.iter().map(|row| format!("{row}\n")).collect::<String>();
    assert!(PAGE.contains(&table), "docs/lectures.md should have\n\n{table}");
}

/// Pixels along each side of a panel.
const SIDE: usize = 256;
/// Rows that a caption may cover.
const CAPTION: usize = 24;

/// A panel's pixels above its caption.
fn panel(picture: &Picture, column: usize, row: usize) -> Vec<[u8; 3]> {
    let rows = row * SIDE..(row + 1) * SIDE - CAPTION;
    rows.flat_map(|y| (0..SIDE).map(move |x| y * picture.width + column * SIDE + x))
        .map(|at| picture.pixels[at])
        .map(|pixel| [pixel.r, pixel.g, pixel.b])
        .collect()
}

/// The largest difference of a component.
fn largest_difference(a: &[[u8; 3]], b: &[[u8; 3]]) -> u8 {
    let components = a.as_flattened().iter().zip(b.as_flattened());
    components.map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0)
}

fn draw(program: &Program) -> Picture {
    render(program, SIDE, None, &ContextDesc::default()).expect("a context").picture
}

#[test]
fn gift_wrapping_stretches_as_the_page_says() {
    let mut rows = vec![
        "| surface | least area | largest area | longest ellipse |".to_owned(),
        "|---|---|---|---|".to_owned(),
    ];
    for (name, mesh, _) in gift_wrapping::wrapped() {
        let [least, most, axes] = extremes(&mesh);
        rows.push(format!("| {name} | {least:.2} | {most:.2} | {axes:.2} : 1 |"));
    }
    is_on_the_page(&rows);
}

#[test]
fn a_sphere_shrinks_circles_by_the_cosine_of_the_latitude() {
    let [(_, sphere, _), ..] = gift_wrapping::wrapped();
    let all = stretches(&sphere);
    // 96 columns of two triangles a row; at the poles one of each two has no area.
    let row = |row: usize| all[96 + (row - 1) * 192];
    let equator = row(24);
    let mut rows = vec!["| latitude | area | ellipse |".to_owned(), "|---|---|---|".to_owned()];
    for at in [24, 32, 40, 46] {
        let (latitude, stretch) = (3.75 * (at as f64 - 23.5), row(at));
        let cosine = latitude.to_radians().cos();
        assert!((stretch.area / equator.area - cosine).abs() < 0.04, "{latitude}°: {stretch:?}");
        assert!((stretch.axes * cosine - 1.0).abs() < 0.35, "{latitude}°: {stretch:?}");
        let area = stretch.area / equator.area;
        rows.push(format!("| {latitude:.0}° | {area:.2} | {:.2} : 1 |", stretch.axes));
    }
    is_on_the_page(&rows);
}

#[test]
fn bits_of_a_fraction_err_as_the_page_says() {
    let picture = draw(&fixed_point::PROGRAM);
    let panels = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(x, y)| panel(&picture, x, y));
    let mut rows = vec![
        "| bits of a fraction of s | off by at most, of 256 texels | levels of 255 in the picture |".to_owned(),
        "|---|---|---|".to_owned(),
    ];
    for (bits, of) in fixed_point::BITS.into_iter().zip(&panels).skip(1) {
        let (texels, levels) = (1 << (bits - 7), largest_difference(of, &panels[0]));
        rows.push(format!("| {bits} | 1/{texels} texel | {levels} |"));
    }
    is_on_the_page(&rows);
}

#[test]
fn one_reciprocal_draws_what_two_and_txp_draw() {
    let picture = draw(&projective_shortcut::PROGRAM);
    let [twice, once, txp] = [(2, 0), (0, 1), (1, 1)].map(|(x, y)| panel(&picture, x, y));
    assert!(largest_difference(&twice, &once) <= 1 && largest_difference(&once, &txp) <= 1);
    let without_q = panel(&picture, 1, 0);
    assert!(largest_difference(&without_q, &once) > 100, "q has no effect");
}

#[test]
fn both_measures_of_a_footprint_are_as_the_page_says() {
    let mut rows = vec![
        "| footprint: steps along x and y, in texels | the lecture's ρ | OpenGL's ρ | λ, lecture less OpenGL |".to_owned(),
        "|---|---|---|---|".to_owned(),
    ];
    let footprints: [(&str, [DVec2; 2]); 5] = [
        ("(2, 0), (0, 2): a square", [dvec2(2., 0.), dvec2(0., 2.)]),
        ("(1, 1), (-1, 1): a square, turned by 45°", [dvec2(1., 1.), dvec2(-1., 1.)]),
        ("(2, 2), (0, 0.5): long along x, on the diagonal", [dvec2(2., 2.), dvec2(0., 0.5)]),
        ("(2, 0), (2, 0.5): u along x and y", [dvec2(2., 0.), dvec2(2., 0.5)]),
        ("(4, 0), (0, 1): long along u and x", [dvec2(4., 0.), dvec2(0., 1.)]),
    ];
    for (name, steps) in footprints {
        let (lecture, opengl) = (lecture_rho(steps), opengl_rho(steps));
        let levels = (lecture / opengl).log2();
        rows.push(format!("| {name} | {lecture:.2} | {opengl:.2} | {levels:.2} |"));
    }
    is_on_the_page(&rows);
}

#[test]
fn orders_of_texels_take_as_many_lines_as_the_page_says() {
    let mut rows = vec![
        "| order | 0° | 15° | 30° | 45° | 60° | 90° |".to_owned(),
        "|---|---|---|---|---|---|---|".to_owned(),
    ];
    for order in ORDERS {
        let cells = [0., 15., 30., 45., 60., 90.]
            .map(|degrees| format!("{:.2}", lines_per_pixel(order, degrees)));
        rows.push(format!("| {order:?} | {} |", cells.join(" | ")));
    }
    is_on_the_page(&rows);
}

/// Texels that the first lookup of a pixel reads.
fn texels_read(program: &Program, pixel: [usize; 2]) -> usize {
    let desc = ContextDesc::default();
    let (_, explanation) = explain(program, SIDE, None, &desc, pixel).expect("a pixel inside");
    let traces = explanation.events.iter().find_map(|event| match event {
        PixelEvent::Fragment(fragment) => fragment.steps.iter().find_map(|step| match step {
            Step::Lookup(lookup) => lookup.trace.as_ref(),
            Step::Value { .. } | Step::Discard => None,
        }),
        PixelEvent::Clear(_) => None,
    });
    let steps = &traces.expect("a lookup").steps;
    steps.iter().filter(|step| matches!(step, SampleStep::Texel { .. })).count()
}

#[test]
fn filters_read_as_many_texels_as_their_captions_say_near_and_far() {
    let program = &filter_cost::PROGRAM;
    for (at, caption) in program.panels.iter().enumerate() {
        let (column, row) = (at % 3 * SIDE, at / 3 * SIDE);
        let number = caption.split(' ').find_map(|word| word.parse().ok());
        // Both are minified.
        for below in [60, 72] {
            let read = texels_read(program, [column + 128, row + below]);
            assert_eq!(Some(read), number, "{caption}, row {below}");
        }
    }
}
