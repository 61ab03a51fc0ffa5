//! One chart on the sheet.

use std::fmt;
use std::io::{self, Write};

use super::axis::Axis;
use super::{Chart, Curve};

const LEFT: f64 = 76.0;
const TOP: f64 = 46.0;
const PLOT: [f64; 2] = [460.0, 330.0];
const BOTTOM: f64 = 58.0;
const LEGEND_GAP: f64 = 22.0;
const SAMPLE: f64 = 30.0;
const ROW: f64 = 19.0;
/// Width of a letter of the legend, generously: text may not run off the sheet, whatever font there is.
const LETTER: f64 = 6.3;
const LEGEND_LETTERS: [usize; 2] = [12, 64];

const INK: &str = "#1d2733";
const FADED: &str = "#66727f";
const GRID: &str = "#e4e7eb";

/// Colours that stay apart for the colour-blind and in grey, in the order of curves.
const COLOURS: [&str; 9] =
    ["#0b5fa5", "#d1495b", "#2b8a5a", "#8f5bb5", "#e08e0b", "#17a2b8", "#7a5230", "#5b6770", "#b0a000"];

/// Marks as paths about the origin: two cycles of colours and marks of different length meet again only after 63
/// curves.
const MARKS: [&str; 7] = [
    "m-3.2 0a3.2 3.2 0 1 0 6.4 0a3.2 3.2 0 1 0-6.4 0z",
    "m-2.9-2.9h5.8v5.8h-5.8z",
    "m0-3.9l3.7 6.5h-7.4z",
    "m0-4.1l4.1 4.1l-4.1 4.1l-4.1-4.1z",
    "m0 3.9l3.7-6.5h-7.4z",
    "m-1.3-4h2.6v2.7h2.7v2.6h-2.7v2.7h-2.6v-2.7h-2.7v-2.6h2.7z",
    "m-4-1.6h8v3.2h-8z",
];
const CROSS: &str = "m-3.4-3.4l6.8 6.8m0-6.8l-6.8 6.8";

pub(super) struct Panel<'a> {
    chart: &'a Chart,
    x: Axis,
    y: Axis,
}

impl<'a> Panel<'a> {
    pub(super) fn of(chart: &'a Chart) -> Self {
        let all =
            || chart.curves.iter().flat_map(|c| c.points.iter().flatten().chain(&c.doubted)).filter(|p| is_finite(p));
        Self { chart, x: Axis::exact(all().map(|p| p[0])), y: Axis::rounded(all().map(|p| p[1])) }
    }

    pub(super) fn width(&self) -> f64 {
        let [least, most] = LEGEND_LETTERS;
        let longest = self.chart.curves.iter().map(|c| c.label.chars().count()).max().unwrap_or(0).clamp(least, most);
        (LEFT + PLOT[0] + LEGEND_GAP + SAMPLE + 10.0 + LETTER * longest as f64 + 12.0).ceil()
    }

    pub(super) fn height(&self) -> f64 {
        let legend = TOP + ROW * (self.chart.curves.len() as f64 + 1.0);
        (TOP + PLOT[1] + BOTTOM).max(legend)
    }

    pub(super) fn draw(&self, out: &mut dyn Write) -> io::Result<()> {
        let title = Escaped(&self.chart.title);
        writeln!(
            out,
            "<text x=\"{LEFT}\" y=\"27\" font-size=\"16\" font-weight=\"600\" fill=\"{INK}\">{title}</text>"
        )?;
        self.draw_axes(out)?;
        // Later curves are drawn first, so that those named first in the legend lie on top.
        for (i, curve) in self.chart.curves.iter().enumerate().rev() {
            self.draw_curve(out, i, curve)?;
        }
        self.draw_legend(out)
    }

    fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [LEFT + PLOT[0] * self.x.place(x), TOP + PLOT[1] * (1.0 - self.y.place(y))]
    }

    fn draw_axes(&self, out: &mut dyn Write) -> io::Result<()> {
        let [w, h] = PLOT;
        let (right, bottom) = (LEFT + w, TOP + h);
        let xs: Vec<(f64, &f64)> = self.x.ticks.iter().map(|t| (LEFT + w * self.x.place(*t), t)).collect();
        let ys: Vec<(f64, &f64)> = self.y.ticks.iter().map(|t| (TOP + h * (1.0 - self.y.place(*t)), t)).collect();
        write!(out, "<path fill=\"none\" stroke=\"{GRID}\" d=\"")?;
        for (x, _) in &xs {
            write!(out, "M{x:.2} {TOP}V{bottom}")?;
        }
        for (y, _) in &ys {
            write!(out, "M{LEFT} {y:.2}H{right}")?;
        }
        write!(out, "\"/>\n<path fill=\"none\" stroke=\"{FADED}\" d=\"M{LEFT} {TOP}V{bottom}H{right}")?;
        for (x, _) in &xs {
            write!(out, "M{x:.2} {bottom}v5")?;
        }
        for (y, _) in &ys {
            write!(out, "M{LEFT} {y:.2}h-5")?;
        }
        writeln!(out, "\"/>\n<g fill=\"{INK}\" text-anchor=\"middle\">")?;
        for (x, tick) in &xs {
            writeln!(out, "<text x=\"{x:.2}\" y=\"{:.2}\">{}</text>", bottom + 19.0, Axis::label(**tick))?;
        }
        writeln!(out, "</g>\n<g fill=\"{INK}\" text-anchor=\"end\">")?;
        for (y, tick) in &ys {
            writeln!(out, "<text x=\"{:.2}\" y=\"{:.2}\">{}</text>", LEFT - 9.0, y + 4.2, Axis::label(**tick))?;
        }
        writeln!(out, "</g>\n<g fill=\"{INK}\" font-size=\"13\" text-anchor=\"middle\">")?;
        let (middle, below) = (LEFT + w / 2.0, bottom + 43.0);
        writeln!(out, "<text x=\"{middle:.2}\" y=\"{below:.2}\">{}</text>", Escaped(&self.chart.x_label))?;
        let scale = if self.y.is_logarithmic() { " (log scale)" } else { "" };
        let (label, middle) = (Escaped(&self.chart.y_label), TOP + h / 2.0);
        writeln!(out, "<text transform=\"translate(19 {middle:.2})rotate(-90)\">{label}{scale}</text>\n</g>")
    }

    fn draw_curve(&self, out: &mut dyn Write, index: usize, curve: &Curve) -> io::Result<()> {
        let (colour, mark) = (COLOURS[index % COLOURS.len()], MARKS[index % MARKS.len()]);
        let stroke = stroke(colour, curve.is_dashed);
        let mut is_on = false;
        let (mut line, mut marks) = (String::new(), String::new());
        for point in &curve.points {
            let Some([x, y]) = point.filter(is_finite).map(|p| self.at(p)) else {
                is_on = false;
                continue;
            };
            line += &format!("{}{x:.2} {y:.2}", if is_on { 'L' } else { 'M' });
            marks += &format!("M{x:.2} {y:.2}{mark}");
            is_on = true;
        }
        writeln!(out, "<path class=\"curve\" {stroke} d=\"{line}\"/>")?;
        let fill = if curve.is_dashed { "#fff" } else { colour };
        writeln!(
            out,
            "<path class=\"marks\" fill=\"{fill}\" stroke=\"{colour}\" stroke-width=\"1.2\" d=\"{marks}\"/>"
        )?;
        if curve.doubted.is_empty() {
            return Ok(());
        }
        write!(out, "<path class=\"doubted\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\" d=\"")?;
        for &point in curve.doubted.iter().filter(|p| is_finite(p)) {
            let [x, y] = self.at(point);
            write!(out, "M{x:.2} {y:.2}{CROSS}")?;
        }
        writeln!(out, "\"/>")
    }

    fn draw_legend(&self, out: &mut dyn Write) -> io::Result<()> {
        let x = LEFT + PLOT[0] + LEGEND_GAP;
        for (i, curve) in self.chart.curves.iter().enumerate() {
            let y = TOP + 8.0 + ROW * i as f64;
            let (colour, mark) = (COLOURS[i % COLOURS.len()], MARKS[i % MARKS.len()]);
            let fill = if curve.is_dashed { "#fff" } else { colour };
            writeln!(out, "<path {} d=\"M{x:.2} {y:.2}h{SAMPLE}\"/>", stroke(colour, curve.is_dashed))?;
            let middle = x + SAMPLE / 2.0;
            writeln!(
                out,
                "<path fill=\"{fill}\" stroke=\"{colour}\" stroke-width=\"1.2\" d=\"M{middle:.2} {y:.2}{mark}\"/>"
            )?;
            let label: String = curve.label.chars().take(LEGEND_LETTERS[1]).collect();
            let (x, y) = (x + SAMPLE + 8.0, y + 4.2);
            writeln!(out, "<text x=\"{x:.2}\" y=\"{y:.2}\" fill=\"{INK}\">{}</text>", Escaped(&label))?;
        }
        Ok(())
    }
}

fn stroke(colour: &str, is_dashed: bool) -> String {
    let dashes = if is_dashed { " stroke-dasharray=\"5 3.5\"" } else { "" };
    format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.7\" stroke-linejoin=\"round\"{dashes}")
}

fn is_finite(point: &[f64; 2]) -> bool {
    point.iter().all(|c| c.is_finite())
}

/// Text as XML has it; control characters, which it cannot have, are left out.
struct Escaped<'a>(&'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for c in self.0.chars().filter(|c| !c.is_control()) {
            match c {
                '&' => f.write_str("&amp;")?,
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                c => write!(f, "{c}")?,
            }
        }
        Ok(())
    }
}
