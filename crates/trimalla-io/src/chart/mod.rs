//! `.svg`: charts of curves, for tables of measurements.
//!
//! ```text
//!   title
//!    ^ y label
//!  t |        o          curves in their order, each with a colour and a mark of its own
//!  i |   +  o            legend on the right
//!  c | +o+               logarithmic where the largest value is more than ten times the smallest
//!  k +------------>
//!    ticks, x label
//! ```
//! A curve may have gaps, may be dashed, and may carry points that are doubted: those are crosses on no line.
//! Coordinates are rounded to hundredths, so the bytes are the same on every platform.

mod axis;
mod panel;

use std::io::{self, Write};

use panel::Panel;

/// A curve of a chart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// What the legend calls it.
    pub label: String,
    /// Points from left to right; `None` is a gap.
    pub points: Vec<Option<[f64; 2]>>,
    /// Points that are shown as crosses, on no line.
    pub doubted: Vec<[f64; 2]>,
    /// Whether the line is dashed.
    pub is_dashed: bool,
}

/// A chart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart {
    /// The heading.
    pub title: String,
    /// What the horizontal axis shows, with its unit.
    pub x_label: String,
    /// What the vertical axis shows, with its unit.
    pub y_label: String,
    /// The curves.
    pub curves: Vec<Curve>,
}

const FONT: &str = "Helvetica Neue,Helvetica,Arial,Liberation Sans,DejaVu Sans,sans-serif";

/// Draws charts, so many in a row, each with axes, ticks and legend. Points that are not finite are left out.
///
/// # Errors
/// Those of `out`.
///
/// # Examples
/// ```
/// use trimalla_io::chart::{Chart, Curve, draw};
///
/// let points = vec![Some([20.0, 57.0]), Some([25.0, 71.0]), None, Some([35.0, 180.0])];
/// let curve = Curve { label: "lepp-centroid".to_owned(), points, ..Curve::default() };
/// let chart = Chart { title: "A".to_owned(), y_label: "vertices".to_owned(), curves: vec![curve], ..Chart::default() };
/// let mut svg = Vec::new();
/// draw(&mut svg, &[chart], 1)?;
/// assert!(svg.starts_with(b"<svg ") && svg.ends_with(b"</svg>\n"));
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn draw(out: &mut dyn Write, charts: &[Chart], in_a_row: usize) -> io::Result<()> {
    let panels: Vec<Panel<'_>> = charts.iter().map(Panel::of).collect();
    let in_a_row = in_a_row.max(1);
    let width = panels.iter().map(Panel::width).fold(0.0, f64::max);
    let height = panels.iter().map(Panel::height).fold(0.0, f64::max);
    let rows = panels.len().div_ceil(in_a_row);
    let (w, h) = (width * in_a_row.min(panels.len()) as f64, height * rows as f64);
    writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {w:.0} {h:.0}\" width=\"{w:.0}\" height=\"{h:.0}\" \
         font-family=\"{FONT}\" font-size=\"12\">"
    )?;
    writeln!(out, "<path fill=\"#fff\" d=\"M0 0h{w:.0}v{h:.0}H0z\"/>")?;
    for (i, panel) in panels.iter().enumerate() {
        let (x, y) = (width * (i % in_a_row) as f64, height * (i / in_a_row) as f64);
        writeln!(out, "<g transform=\"translate({x:.0} {y:.0})\">")?;
        panel.draw(out)?;
        writeln!(out, "</g>")?;
    }
    writeln!(out, "</svg>")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(charts: &[Chart], in_a_row: usize) -> String {
        let mut out = Vec::new();
        draw(&mut out, charts, in_a_row).unwrap();
        String::from_utf8(out).unwrap()
    }

    fn chart(points: &[[f64; 2]]) -> Chart {
        let curve =
            Curve { label: "a<b".to_owned(), points: points.iter().copied().map(Some).collect(), ..Curve::default() };
        Chart { title: "A & B".to_owned(), curves: vec![curve], ..Chart::default() }
    }

    #[test]
    fn words_are_escaped() {
        let text = text(&[chart(&[[1.0, 2.0]])], 1);
        assert!(text.contains("A &amp; B") && text.contains("a&lt;b"), "{text}");
    }

    #[test]
    fn nothing_finite_is_no_trouble() {
        for points in
            [vec![], vec![[f64::NAN, 1.0]], vec![[1.0, f64::INFINITY]], vec![[0.0, 0.0]], vec![[1e308, -1e308]]]
        {
            let text = text(&[chart(&points)], 3);
            assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
        }
        assert!(text(&[], 0).ends_with("</svg>\n"));
    }

    #[test]
    fn gaps_part_the_line_and_doubts_are_on_none() {
        let mut chart = chart(&[[1.0, 1.0], [2.0, 2.0], [3.0, 3.0], [4.0, 4.0]]);
        let lines = |chart: &Chart| {
            let text = text(std::slice::from_ref(chart), 1);
            let line = text.lines().find(|l| l.contains("class=\"curve\"")).unwrap().to_owned();
            (line.matches('M').count(), line.matches('L').count())
        };
        assert_eq!(lines(&chart), (1, 3));
        chart.curves[0].points[2] = None;
        assert_eq!(lines(&chart), (2, 1));
        chart.curves[0].doubted.push([3.0, 9.0]);
        assert_eq!(lines(&chart), (2, 1));
        assert_eq!(text(&[chart], 1).matches("class=\"doubted\"").count(), 1);
    }

    #[test]
    fn a_curve_alone_in_its_gap_is_a_mark() {
        let mut chart = chart(&[[1.0, 1.0]]);
        chart.curves[0].points.insert(0, None);
        assert!(text(&[chart], 1).contains("class=\"marks\""));
    }
}
