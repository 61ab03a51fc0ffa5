//! A picture of the faults of a drawing: the whole drawing with a number at each fault, and below it a window on each.

use std::io::{self, Write};

use trimalla::clean::{Fault, Findings};
use trimalla::drawing::Pslg;
use trimalla::geometry::{BoundingBox, Point};

use super::text::Escaped;
use crate::columns::{Points, Segments};
use crate::numbers::Real;
use crate::picture::{COLOURS, INK, PAPER};

/// The width of the sheet, and of a window, in units of the sheet.
const SHEET: f64 = 1000.0;
const WINDOW: f64 = 230.0;
const SPACE: f64 = 16.0;
/// Windows in a row.
const ROW: usize = 4;
/// No more windows than these: the first of each kind come first.
const MOST_WINDOWS: usize = 200;
/// What a window shows around a fault without size, as a part of the extent of the drawing.
const SHARE: f64 = 0.02;

/// Draws a drawing and its faults, as [`find`](trimalla::clean::find()) gives them. The window on a fault is so large
/// that the fault is about a third of it.
///
/// # Errors
/// Those of `out`; kind `InvalidInput` where columns have wrong lengths, an index has no vertex or a number is not
/// finite.
pub fn draw_faults(
    out: &mut dyn Write,
    pslg: &Pslg,
    found: &Findings,
    first_index: u32,
    title: &str,
) -> io::Result<()> {
    Points::of_pslg(pslg).check(first_index)?;
    Segments::of_pslg(pslg).check(pslg.points.len())?;
    let seeds = pslg.holes.iter().copied();
    let bounds = BoundingBox::of(pslg.points.iter().copied().chain(seeds)).unwrap_or_default();
    let extent = bounds.width().max(bounds.height()).max(f64::MIN_POSITIVE);
    let height = (SHEET * (bounds.height() / bounds.width().max(f64::MIN_POSITIVE)).clamp(0.05, 1.0)).round();
    let shown = &found.faults[..found.faults.len().min(MOST_WINDOWS)];
    let rows = shown.len().div_ceil(ROW);
    let total = height + 60.0 + rows as f64 * (WINDOW + 44.0) + SPACE;
    let width = SHEET + 2.0 * SPACE;
    writeln!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {total}\" font-family=\"system-ui,Helvetica,Arial,'DejaVu Sans',sans-serif\">"
    )?;
    writeln!(out, "<rect width=\"{width}\" height=\"{total}\" fill=\"{PAPER}\"/>")?;
    let hidden = found.faults.len() - shown.len();
    let more = if hidden == 0 { String::new() } else { format!(", {hidden} of them not shown") };
    writeln!(
        out,
        "<text x=\"{SPACE}\" y=\"26\" font-size=\"20\" font-weight=\"600\" fill=\"{INK}\">{}: {} faults{more}</text>",
        Escaped(title),
        found.faults.len()
    )?;
    let middle = bounds.center();
    let whole = View {
        x: SPACE,
        y: 40.0,
        width: SHEET,
        height,
        scale: 0.94
            * (SHEET / bounds.width().max(f64::MIN_POSITIVE)).min(height / bounds.height().max(f64::MIN_POSITIVE)),
        middle,
    };
    whole.open(out)?;
    whole.segments(out, pslg, 1.0)?;
    for (number, fault) in (1..).zip(shown) {
        let [x, y] = whole.place(fault.at);
        writeln!(
            out,
            "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"5\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>",
            COLOURS[0]
        )?;
        writeln!(
            out,
            "<text x=\"{:.2}\" y=\"{:.2}\" font-size=\"12\" fill=\"{}\">{number}</text>",
            x + 7.0,
            y - 5.0,
            COLOURS[0]
        )?;
    }
    writeln!(out, "</svg>")?;
    for (i, fault) in shown.iter().enumerate() {
        let (column, row) = (i % ROW, i / ROW);
        let x = SPACE + column as f64 * (SHEET - WINDOW) / (ROW - 1) as f64;
        let y = height + 60.0 + row as f64 * (WINDOW + 44.0);
        let shown = reach(pslg, fault, extent);
        let view = View { x, y, width: WINDOW, height: WINDOW, scale: WINDOW / shown, middle: fault.at };
        view.window(out, pslg, fault, i + 1, shown)?;
    }
    writeln!(out, "</svg>")
}

/// How much of the drawing a window shows.
fn reach(pslg: &Pslg, fault: &Fault, extent: f64) -> f64 {
    use trimalla::clean::FaultKind as Kind;
    let places = fault.vertices.iter().map(|&v| pslg.points[v as usize]);
    let size = match fault.kind {
        Kind::TinyAngle | Kind::Sliver => 0.0,
        _ => places.map(|p| (p.x - fault.at.x).abs().max((p.y - fault.at.y).abs())).fold(fault.size, f64::max),
    };
    match fault.kind {
        Kind::Sliver => 6.0 * fault.size,
        _ if size > 0.0 => 3.0 * size,
        _ => SHARE * extent,
    }
    .max(f64::MIN_POSITIVE)
}

/// A part of the sheet on which a part of the drawing is seen.
struct View {
    x: f64,
    y: f64,
    width: f64,
    height: f64,
    scale: f64,
    middle: Point,
}

impl View {
    /// The place of a point in the part of the sheet.
    fn place(&self, p: Point) -> [f64; 2] {
        [self.width / 2.0 + (p.x - self.middle.x) * self.scale, self.height / 2.0 - (p.y - self.middle.y) * self.scale]
    }

    fn open(&self, out: &mut dyn Write) -> io::Result<()> {
        let Self { x, y, width, height, .. } = self;
        writeln!(out, "<svg x=\"{x:.2}\" y=\"{y:.2}\" width=\"{width}\" height=\"{height}\">")?;
        writeln!(
            out,
            "<rect width=\"{width}\" height=\"{height}\" fill=\"none\" stroke=\"{INK}\" stroke-opacity=\"0.3\"/>"
        )
    }

    /// The segments, cut to what is seen: numbers far outside would lose their last places.
    fn segments(&self, out: &mut dyn Write, pslg: &Pslg, width: f64) -> io::Result<()> {
        write!(out, "<path fill=\"none\" stroke=\"{INK}\" stroke-width=\"{width}\" d=\"")?;
        for ends in &pslg.segments {
            let [a, b] = ends.map(|v| self.place(pslg.points[v as usize]));
            if let Some([[x, y], [u, v]]) = clipped(a, b, self.width, self.height) {
                write!(out, "M{x:.2} {y:.2}L{u:.2} {v:.2}")?;
            }
        }
        writeln!(out, "\"/>")
    }

    /// The window on a fault: what is there, its number, kind and size.
    fn window(&self, out: &mut dyn Write, pslg: &Pslg, fault: &Fault, number: usize, shown: f64) -> io::Result<()> {
        self.open(out)?;
        self.segments(out, pslg, 1.5)?;
        for (i, &p) in pslg.points.iter().enumerate() {
            let [x, y] = self.place(p);
            if (0.0..=self.width).contains(&x) && (0.0..=self.height).contains(&y) {
                let colour = if fault.vertices.contains(&(i as u32)) { COLOURS[0] } else { INK };
                writeln!(out, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"3\" fill=\"{colour}\"/>")?;
            }
        }
        let [x, y] = self.place(fault.at);
        writeln!(
            out,
            "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"9\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>",
            COLOURS[0]
        )?;
        writeln!(out, "</svg>")?;
        let size = match fault.kind.measure() {
            Some(measure) => format!(", {measure} {:.3e}", fault.size),
            None => String::new(),
        };
        let (x, y) = (self.x, self.y + self.height);
        writeln!(
            out,
            "<text x=\"{x:.2}\" y=\"{:.2}\" font-size=\"13\" fill=\"{INK}\">{number} {}{size}</text>",
            y + 16.0,
            fault.kind
        )?;
        writeln!(
            out,
            "<text x=\"{x:.2}\" y=\"{:.2}\" font-size=\"11\" fill=\"{INK}\">at {} {}, window {shown:.2e}</text>",
            y + 31.0,
            Real(fault.at.x),
            Real(fault.at.y)
        )
    }
}

/// The part of a segment within a rectangle from the origin, with some space around it.
fn clipped(a: [f64; 2], b: [f64; 2], width: f64, height: f64) -> Option<[[f64; 2]; 2]> {
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let (low, high) = (-10.0, [width, height][axis] + 10.0);
        let step = b[axis] - a[axis];
        if step == 0.0 {
            if a[axis] < low || a[axis] > high {
                return None;
            }
            continue;
        }
        let (one, other) = ((low - a[axis]) / step, (high - a[axis]) / step);
        from = from.max(one.min(other));
        to = to.min(one.max(other));
    }
    let at = |t: f64| [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
    let found = [at(from), at(to)];
    (from <= to && found.as_flattened().iter().all(|x| x.is_finite())).then_some(found)
}
