//! The strip below the picture: bar charts in columns, one under the other up to the height of the tallest, and as many
//! columns side by side as there is room for.

use std::io::{self, Write};

use super::text::Escaped;
use crate::bars::BarChart;
use crate::picture::{Colour, INK, MARGIN};

/// A strip is no narrower than this, whatever the picture is.
const LEAST_WIDTH: f64 = 900.0;
const ROW: f64 = 18.0;
const TITLE: f64 = 26.0;
/// Between columns, and between charts in a column.
const GAP: [f64; 2] = [34.0, 20.0];
const BAR: f64 = 84.0;
/// Width of a letter, generously: text may not run into a bar, whatever font there is.
const LETTER: f64 = 7.2;
const FADED: Colour = Colour(0x66727f);
const COLOUR: Colour = Colour(0x4292a7);

/// Charts and their places.
#[derive(Debug)]
pub(super) struct Strip<'a> {
    /// Each with its left upper corner, from that of the strip on.
    placed: Vec<([f64; 2], &'a BarChart)>,
    pub(super) width: f64,
    pub(super) height: f64,
}

impl<'a> Strip<'a> {
    /// A strip for a sheet of this width; of no height where there are no charts.
    pub(super) fn of(charts: &'a [BarChart], sheet: f64) -> Self {
        if charts.is_empty() {
            return Self { placed: Vec::new(), width: 0.0, height: 0.0 };
        }
        let tallest = charts.iter().map(height_of).fold(0.0, f64::max);
        let columns = columns(charts, tallest);
        let width = |column: &[BarChart]| column.iter().map(width_of).fold(0.0, f64::max);
        let widest = columns.iter().map(|column| width(column)).fold(LEAST_WIDTH - 2.0 * MARGIN, f64::max);
        let room = widest.max(sheet - 2.0 * MARGIN);
        let (mut left, mut top) = (0.0, 0.0);
        let mut placed = Vec::new();
        for column in columns {
            if left > 0.0 && left + width(column) > room {
                (left, top) = (0.0, top + tallest + GAP[1]);
            }
            let mut y = top;
            for chart in column {
                placed.push(([left, y], chart));
                y += height_of(chart) + GAP[1];
            }
            left += width(column) + GAP[0];
        }
        Self { placed, width: room + 2.0 * MARGIN, height: top + tallest + MARGIN }
    }

    /// Draws the charts, the strip's upper edge at this height.
    pub(super) fn draw(&self, out: &mut dyn Write, top: f64) -> io::Result<()> {
        for ([x, y], chart) in &self.placed {
            writeln!(out, "<g font-size=\"12\" transform=\"translate({:.2} {:.2})\">", MARGIN + x, top + y)?;
            draw(out, chart)?;
            writeln!(out, "</g>")?;
        }
        Ok(())
    }
}

/// Charts in their order, cut where the next one does not fit under those before.
fn columns(charts: &[BarChart], tallest: f64) -> Vec<&[BarChart]> {
    let mut columns = Vec::new();
    let (mut first, mut height) = (0, 0.0);
    for (i, chart) in charts.iter().enumerate() {
        if i > first && height + GAP[1] + height_of(chart) > tallest {
            columns.push(&charts[first..i]);
            (first, height) = (i, 0.0);
        }
        height += height_of(chart) + if i > first { GAP[1] } else { 0.0 };
    }
    columns.push(&charts[first..]);
    columns
}

fn height_of(chart: &BarChart) -> f64 {
    TITLE + ROW * chart.bars.len() as f64
}

/// Width of the labels of a chart.
fn label_width(chart: &BarChart) -> f64 {
    LETTER * chart.letters()[0] as f64
}

fn width_of(chart: &BarChart) -> f64 {
    let bars = label_width(chart) + BAR + 14.0 + LETTER * chart.letters()[1] as f64;
    bars.max(LETTER * 1.1 * chart.title.chars().count() as f64)
}

fn draw(out: &mut dyn Write, chart: &BarChart) -> io::Result<()> {
    writeln!(out, "<text x=\"0\" y=\"12\" font-size=\"13\" fill=\"{INK}\">{}</text>", Escaped(&chart.title))?;
    let left = label_width(chart);
    for (i, (bar, share)) in chart.bars.iter().zip(chart.shares()).enumerate() {
        let y = TITLE + ROW * i as f64;
        let line = y + 12.5;
        let length = BAR * share;
        let (label, value) = (Escaped(&bar.label), Escaped(&bar.value));
        writeln!(out, "<text x=\"{left:.2}\" y=\"{line:.2}\" text-anchor=\"end\" fill=\"{FADED}\">{label}</text>")?;
        if length > 0.0 {
            let (x, y, height) = (left + 7.0, y + 2.5, ROW - 5.0);
            writeln!(out, "<path fill=\"{COLOUR}\" d=\"M{x:.2} {y:.2}h{length:.2}v{height}h-{length:.2}z\"/>")?;
        }
        let x = left + 12.0 + length;
        writeln!(out, "<text x=\"{x:.2}\" y=\"{line:.2}\" font-size=\"11\" fill=\"{FADED}\">{value}</text>")?;
    }
    Ok(())
}
