//! Plots as SVG text.

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::prelude::*;

/// A named series of points.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// The name in the legend.
    pub name: String,
    /// (x, y); 0 and infinity have places of their own on logarithmic axes.
    pub points: Vec<(f64, f64)>,
}

/// The title of a plot and the labels of its axes.
#[derive(Clone, Copy, Debug)]
pub struct Caption<'a> {
    /// The title.
    pub title: &'a str,
    /// Label of the x axis.
    pub x: &'a str,
    /// Label of the y axis.
    pub y: &'a str,
}

/// Why a plot could not be drawn.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the plot {title:?} cannot be drawn: {reason}")]
pub struct PlotError {
    title: String,
    reason: String,
}

/// How the points of a series are drawn.
#[derive(Clone, Copy, Debug)]
enum Style<'a> {
    /// Joined by a line.
    Joined,
    /// As single points; the k-th point of every series is labelled with the k-th name.
    Named(&'a [&'a str]),
}

/// Width and height in pixels; what is right of the plot is the legend.
const SIZE: (u32, u32) = (960, 460);
/// Width of the plot.
const PLOT: u32 = 700;
/// Letters of a line of the legend.
const LETTERS: usize = 34;

/// A line plot with logarithmic axes. A horizontal line marks `bound`.
///
/// # Errors
/// When plotters cannot draw it.
pub fn log_log(
    caption: Caption<'_>,
    lines: &[Line],
    bound: Option<f64>,
) -> Result<String, PlotError> {
    svg(caption, lines, bound, Style::Joined)
}

/// A scatter plot with logarithmic axes. The k-th point of every series is labelled `names[k]`.
///
/// # Errors
/// When plotters cannot draw it.
pub fn scatter(caption: Caption<'_>, rows: &[Line], names: &[&str]) -> Result<String, PlotError> {
    svg(caption, rows, None, Style::Named(names))
}

fn svg(
    caption: Caption<'_>,
    lines: &[Line],
    bound: Option<f64>,
    style: Style<'_>,
) -> Result<String, PlotError> {
    let mut svg = String::new();
    draw(caption, lines, bound, style, &mut svg).map_err(|error| PlotError {
        title: caption.title.to_owned(),
        reason: error.to_string(),
    })?;
    Ok(svg)
}

/// A logarithmic axis with a place for 0 below its smallest value, and for infinity above its largest:
/// positions are logarithms to base 10.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Axis {
    low: f64,
    high: f64,
    zero: Option<f64>,
    infinite: Option<f64>,
}

impl Axis {
    /// The axis on which these values have places; of 1 to 10 if there are none.
    fn of(values: impl Iterator<Item = f64> + Clone) -> Self {
        let logarithms = values.clone().filter(|v| *v > 0.0 && v.is_finite()).map(f64::log10);
        let (low, high) = logarithms
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        let (low, high) = if low > high { (0.0, 1.0) } else { (low - 0.2, high + 0.2) };
        // A tenth of the axis.
        let apart = (0.1 * (high - low)).max(0.3);
        let zero = values.clone().any(|v| v <= 0.0).then_some(low - apart);
        let infinite = values.clone().any(|v| v == f64::INFINITY).then_some(high + apart);
        Self { low, high, zero, infinite }
    }

    fn place(&self, value: f64) -> f64 {
        match (self.zero, self.infinite) {
            (Some(zero), _) if value <= 0.0 => zero,
            (_, Some(infinite)) if value.is_infinite() => infinite,
            _ => value.log10(),
        }
    }

    /// From end to end.
    fn ends(&self) -> std::ops::Range<f64> {
        let below = self.zero.map_or(self.low, |zero| zero - 0.1);
        below..self.infinite.map_or(self.high, |infinite| infinite + 0.1)
    }

    /// The places that have labels: 0, infinity, and powers of ten.
    fn keys(&self) -> Vec<f64> {
        let (first, last) = (self.low.ceil() as i32, self.high.floor() as i32);
        let step = ((last - first) / 8 + 1).max(1) as usize;
        let powers = (first..=last).step_by(step).map(f64::from);
        self.zero.into_iter().chain(powers).chain(self.infinite).collect()
    }

    fn label(&self, place: f64) -> String {
        if self.zero == Some(place) {
            "0".to_owned()
        } else if self.infinite == Some(place) {
            "inf".to_owned()
        } else if (-3.5..4.5).contains(&place) {
            // Few digits, and no rounding's.
            format!("{}", (10f64.powf(place) * 1e4).round() / 1e4)
        } else {
            format!("1e{place:.0}")
        }
    }

    /// Where the axis is broken.
    fn breaks(&self) -> Vec<f64> {
        let below = self.zero.map(|zero| 0.5 * (zero + self.low));
        let above = self.infinite.map(|infinite| 0.5 * (infinite + self.high));
        below.into_iter().chain(above).collect()
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, place: &f64, (start, end): (i32, i32)) -> i32 {
        let ends = self.ends();
        let part = (place - ends.start) / (ends.end - ends.start);
        start + (part * f64::from(end - start)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.keys()
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.ends()
    }
}

impl ValueFormatter<f64> for Axis {
    fn format(place: &f64) -> String {
        place.to_string()
    }
}

/// A text in lines of at most [`LETTERS`].
fn wrapped(text: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if line.chars().count() + word.chars().count() < LETTERS => {
                line.push(' ');
                line.push_str(word);
            }
            Some(_) | None => lines.push(word.to_owned()),
        }
    }
    lines
}

fn draw(
    caption: Caption<'_>,
    lines: &[Line],
    bound: Option<f64>,
    style: Style<'_>,
    svg: &mut String,
) -> Result<(), Box<dyn std::error::Error>> {
    let points = || lines.iter().flat_map(|line| line.points.iter());
    let x = Axis::of(points().map(|p| p.0).collect::<Vec<_>>().into_iter());
    let y = Axis::of(points().map(|p| p.1).chain(bound).collect::<Vec<_>>().into_iter());
    let root = SVGBackend::with_string(svg, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let (area, legend) = root.split_horizontally(PLOT);
    let mut chart = ChartBuilder::on(&area)
        .caption(caption.title, ("sans-serif", 18))
        .margin(10)
        .x_label_area_size(42)
        .y_label_area_size(70)
        .build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .x_desc(caption.x)
        .y_desc(caption.y)
        .x_label_formatter(&|place| x.label(*place))
        .y_label_formatter(&|place| y.label(*place))
        .light_line_style(WHITE)
        .draw()?;
    let broken = WHITE.stroke_width(5);
    for place in y.breaks() {
        let across = [(x.ends().start, place), (x.ends().end, place)];
        chart.draw_series(LineSeries::new(across, broken))?;
    }
    for place in x.breaks() {
        let up = [(place, y.ends().start), (place, y.ends().end)];
        chart.draw_series(LineSeries::new(up, broken))?;
    }
    let mut row = 40;
    for (index, line) in lines.iter().enumerate() {
        let color = Palette99::pick(index).to_rgba();
        let places: Vec<(f64, f64)> =
            line.points.iter().map(|p| (x.place(p.0), y.place(p.1))).collect();
        let width = match style {
            Style::Joined => 2,
            Style::Named(_) => 0,
        };
        chart.draw_series(LineSeries::new(places.clone(), color.stroke_width(width)))?;
        chart.draw_series(places.iter().map(|&p| Circle::new(p, 3, color.filled())))?;
        if let Style::Named(names) = style {
            let font = ("sans-serif", 9).into_font().color(&color);
            chart.draw_series(places.iter().zip(names).map(|(&point, &name)| {
                EmptyElement::at(point) + Text::new(name.to_owned(), (6, -4), font.clone())
            }))?;
        }
        legend.draw(&Circle::new((10, row + 6), 4, color.filled()))?;
        for text in wrapped(&line.name) {
            legend.draw(&Text::new(text, (22, row), ("sans-serif", 12)))?;
            row += 15;
        }
    }
    if let Some(bound) = bound {
        let ends = [(x.ends().start, y.place(bound)), (x.ends().end, y.place(bound))];
        chart.draw_series(LineSeries::new(ends, RED.mix(0.5)))?;
        legend.draw(&PathElement::new([(3, row + 6), (17, row + 6)], RED.mix(0.5)))?;
        legend.draw(&Text::new("bound", (22, row), ("sans-serif", 12)))?;
    }
    root.present()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plot_has_its_lines_and_words() -> Result<(), PlotError> {
        let line =
            Line { name: "steep".to_owned(), points: vec![(1.0, 1e-3), (10.0, 1e-6), (0.0, 1.0)] };
        let caption = Caption { title: "Errors", x: "time", y: "size" };
        let svg = log_log(caption, &[line], Some(1e-2))?;
        for part in ["<svg", "Errors", "time", "size", "steep", "bound"] {
            assert!(svg.contains(part), "{part}");
        }
        let points = Line { name: "fast".to_owned(), points: vec![(2.0, 0.5)] };
        let svg = scatter(caption, &[points], &["wood"])?;
        assert!(svg.contains("wood") && svg.contains("fast"));
        log_log(caption, &[], None).map(|_| ())
    }

    #[test]
    fn zero_and_infinity_have_places() {
        let axis = Axis::of([0.0, 1e-3, 10.0, f64::INFINITY].into_iter());
        let places = [0.0, 1e-3, 10.0, f64::INFINITY].map(|value| axis.place(value));
        assert!(places.is_sorted() && places[0] < -3.2, "{places:?}");
        let keys = axis.keys();
        let labels: Vec<String> = keys.into_iter().map(|key| axis.label(key)).collect();
        assert_eq!(labels, ["0", "0.001", "0.01", "0.1", "1", "10", "inf"]);
        assert_eq!(axis.breaks().len(), 2);
        assert_eq!(Axis::of([2.0].into_iter()).breaks(), Vec::<f64>::new());
    }

    #[test]
    fn long_names_wrap() {
        let lines = wrapped("anisotropic, one direction 100, and what else there is");
        assert!(lines.len() == 2 && lines.iter().all(|line| line.len() <= LETTERS), "{lines:?}");
    }
}
