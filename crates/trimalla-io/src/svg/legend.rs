//! The panel beside the picture: scale of colours, histogram, counts.

use std::io::{self, Write};

use crate::picture::{CLASS_DEG, CLASSES, COLOURS, Colour, Frame, Histogram, INK};

/// Width and least height of the panel.
pub(super) const WIDTH: f64 = 250.0;
pub(super) const HEIGHT: f64 = 430.0;

/// Rows that the scale takes, with the space under it.
pub(super) const SCALE_ROWS: f64 = CLASSES as f64 + 1.7;

const ROW: f64 = 22.0;
const LONGEST_BAR: f64 = 110.0;
const FADED: Colour = Colour(0x66727f);

/// One line of text: a label and a value.
#[derive(Debug)]
pub(super) struct Line {
    label: &'static str,
    value: String,
}

impl Line {
    pub(super) fn new(label: &'static str, value: String) -> Self {
        Self { label, value }
    }

    pub(super) fn count(label: &'static str, count: usize) -> Self {
        Self::new(label, grouped(count))
    }
}

/// The digits of a count in groups of three.
fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let mut text = String::with_capacity(digits.len() + digits.len() / 3);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i) % 3 == 0 {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

/// Draws the scale: a box a class, and beside it a bar as long as the class is large.
pub(super) fn draw_scale(out: &mut dyn Write, frame: &Frame, histogram: &Histogram) -> io::Result<()> {
    let (left, top) = frame.panel_corner();
    let most = histogram.counts.iter().copied().max().unwrap_or(0).max(1) as f64;
    writeln!(out, "<g font-size=\"13\" fill=\"{FADED}\">")?;
    writeln!(out, "<text x=\"{left:.2}\" y=\"{:.2}\" fill=\"{INK}\">smallest angle of a triangle</text>", top + 14.0)?;
    for (class, (colour, &count)) in COLOURS.iter().zip(&histogram.counts).enumerate() {
        let y = scale_top(top) + ROW * (CLASSES - 1 - class) as f64;
        let bar_width = LONGEST_BAR * (count as f64 / most);
        writeln!(out, "<path fill=\"{colour}\" d=\"M{:.2} {y:.2}h22v{ROW}h-22z\"/>", left + 30.0)?;
        if count > 0 {
            let (x, y, h) = (left + 58.0, y + 3.0, ROW - 6.0);
            writeln!(out, "<path fill=\"{colour}\" d=\"M{x:.2} {y:.2}h{bar_width:.2}v{h}h-{bar_width:.2}z\"/>")?;
            let (x, y) = (x + bar_width + 5.0, y + 12.5);
            writeln!(out, "<text x=\"{x:.2}\" y=\"{y:.2}\" font-size=\"11\">{}</text>", grouped(count))?;
        }
    }
    for tick in (0..=CLASSES).step_by(2) {
        let y = scale_top(top) + ROW * (CLASSES - tick) as f64 + 4.5;
        writeln!(
            out,
            "<text x=\"{:.2}\" y=\"{y:.2}\" text-anchor=\"end\">{}°</text>",
            left + 25.0,
            CLASS_DEG * tick as f64
        )?;
    }
    writeln!(out, "</g>")
}

fn scale_top(top: f64) -> f64 {
    top + 32.0
}

/// Draws lines of text below `rows_above` rows of the panel.
pub(super) fn draw_lines(out: &mut dyn Write, frame: &Frame, rows_above: f64, lines: &[Line]) -> io::Result<()> {
    let (left, top) = frame.panel_corner();
    writeln!(out, "<g font-size=\"14\" fill=\"{INK}\">")?;
    for (i, line) in lines.iter().enumerate() {
        let y = scale_top(top) + ROW * (rows_above + i as f64);
        writeln!(out, "<text x=\"{left:.2}\" y=\"{y:.2}\" fill=\"{FADED}\">{}</text>", line.label)?;
        writeln!(out, "<text x=\"{:.2}\" y=\"{y:.2}\" text-anchor=\"end\">{}</text>", left + 168.0, line.value)?;
    }
    writeln!(out, "</g>")
}

#[cfg(test)]
mod tests {
    use super::grouped;

    #[test]
    fn counts_are_grouped_by_thousands() {
        assert_eq!([0, 999, 1000, 1_234_567].map(grouped), ["0", "999", "1\u{202f}000", "1\u{202f}234\u{202f}567"]);
    }
}
