//! Plots as SVG text.

use plotters::prelude::*;

/// A named series of points.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// The name in the legend.
    pub name: String,
    /// (x, y); those that are not positive are left out of a logarithmic plot.
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

/// Width and height in pixels.
const SIZE: (u32, u32) = (760, 460);

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

/// The range from the smallest to the largest value, with a margin; 1 to 10 if there are no values.
fn range(values: impl Iterator<Item = f64>) -> std::ops::Range<f64> {
    let mut range = values.fold(f64::INFINITY..0.0, |r, v| r.start.min(v)..r.end.max(v));
    if range.start > range.end {
        range = 1.0..10.0;
    }
    range.start / 1.6..range.end * 1.6
}

fn draw(
    caption: Caption<'_>,
    lines: &[Line],
    bound: Option<f64>,
    style: Style<'_>,
    svg: &mut String,
) -> Result<(), Box<dyn std::error::Error>> {
    let shown = |p: &&(f64, f64)| p.0 > 0.0 && p.1 > 0.0 && p.0.is_finite() && p.1.is_finite();
    let points = || lines.iter().flat_map(|line| line.points.iter()).filter(shown);
    let x = range(points().map(|p| p.0));
    let y = range(points().map(|p| p.1).chain(bound));
    let root = SVGBackend::with_string(svg, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root)
        .caption(caption.title, ("sans-serif", 18))
        .margin(10)
        .x_label_area_size(42)
        .y_label_area_size(70)
        .build_cartesian_2d(x.clone().log_scale(), y.log_scale())?;
    let number = |v: &f64| format!("{v:.0e}");
    chart
        .configure_mesh()
        .x_desc(caption.x)
        .y_desc(caption.y)
        .x_label_formatter(&number)
        .y_label_formatter(&number)
        .light_line_style(WHITE)
        .draw()?;
    for (index, line) in lines.iter().enumerate() {
        let color = Palette99::pick(index).to_rgba();
        let points: Vec<(f64, f64)> = line.points.iter().filter(shown).copied().collect();
        let width = match style {
            Style::Joined => 2,
            Style::Named(_) => 0,
        };
        chart
            .draw_series(LineSeries::new(points.clone(), color.stroke_width(width)))?
            .label(&line.name)
            .legend(move |(x, y)| Circle::new((x + 8, y), 4, color.filled()));
        chart.draw_series(points.into_iter().map(|p| Circle::new(p, 4, color.filled())))?;
        if let Style::Named(names) = style {
            let font = ("sans-serif", 9).into_font().color(&color);
            let named = line.points.iter().zip(names).filter(|(point, _)| shown(point));
            chart.draw_series(named.map(|(&point, &name)| {
                EmptyElement::at(point) + Text::new(name.to_owned(), (6, -4), font.clone())
            }))?;
        }
    }
    if let Some(bound) = bound {
        chart
            .draw_series(LineSeries::new([(x.start, bound), (x.end, bound)], RED.mix(0.5)))?
            .label("bound")
            .legend(|(x, y)| PathElement::new([(x, y), (x + 16, y)], RED.mix(0.5)));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.8))
        .border_style(BLACK.mix(0.3))
        .draw()?;
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
}
