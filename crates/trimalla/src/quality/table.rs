//! Statistics as text: a table and histograms of bars.

use std::fmt;

use super::histogram::Histogram;
use super::measure::Spread;
use super::statistics::{AngleAt, Statistics};

/// Length of the longest bar.
const BAR: usize = 40;
/// Significant digits of a number.
const DIGITS: usize = 6;

/// A table of all counts and measures and four histograms, 80 columns wide, with a line break at the end.
impl fmt::Display for Statistics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_counts(f)?;
        self.write_measures(f)?;
        let bins = |h: &Histogram| (0..h.counts.len()).map(|i| range_label(h.range_deg(i))).collect::<Vec<_>>();
        write_bars(f, "smallest angle of each triangle", &bins(&self.smallest_angles), &self.smallest_angles.counts)?;
        write_bars(f, "all angles", &bins(&self.all_angles), &self.all_angles.counts)?;
        let classes: Vec<String> =
            (0..self.aspect_ratios.counts.len()).map(|i| ratio_label(self.aspect_ratios.range(i))).collect();
        write_bars(f, "aspect ratio of each triangle", &classes, &self.aspect_ratios.counts)?;
        let (degrees, counts): (Vec<String>, Vec<usize>) =
            self.degrees.iter().enumerate().filter(|(_, n)| **n > 0).map(|(d, &n)| (format!("{d:>12}"), n)).unzip();
        write_bars(f, "edges at a vertex", &degrees, &counts)
    }
}

impl Statistics {
    fn write_counts(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows = [
            ("vertices", self.vertices),
            ("  used", self.used_vertices),
            ("  of the input", self.input_vertices),
            ("triangles", self.triangles),
            ("edges", self.edges),
            ("  on the boundary", self.boundary_edges),
            ("subsegments", self.subsegments),
            ("boundary loops", self.boundary_loops),
            ("components", self.components),
            ("holes", self.holes),
        ];
        rows.iter().try_for_each(|(name, count)| writeln!(f, "{name:<18}{count:>14}"))?;
        if self.unmeasured > 0 {
            writeln!(f, "{:<18}{:>14}", "not measurable", self.unmeasured)?;
        }
        Ok(())
    }

    fn write_measures(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{:<18}{:>14}", "area", number(self.total_area))?;
        write_angle(f, "smallest angle", self.min_angle)?;
        write_angle(f, "largest angle", self.max_angle)?;
        writeln!(f, "\n{:<18}{:>14}{:>14}{:>14}", "", "min", "mean", "max")?;
        write_spread(f, "edge length", self.edge_length)?;
        write_spread(f, "triangle area", self.area)?;
        write_spread(f, "aspect ratio", self.aspect_ratio)
    }
}

fn write_angle(f: &mut fmt::Formatter<'_>, name: &str, angle: Option<AngleAt>) -> fmt::Result {
    match angle {
        Some(AngleAt { angle, triangle }) => {
            let degrees = format!("{angle:.4}");
            writeln!(f, "{name:<18}{degrees:>15} in triangle {triangle}")
        }
        None => writeln!(f, "{name:<18}{:>14}", "-"),
    }
}

fn write_spread(f: &mut fmt::Formatter<'_>, name: &str, spread: Option<Spread>) -> fmt::Result {
    let columns = spread.map_or(["-".into(), "-".into(), "-".into()], |s| [s.min, s.mean, s.max].map(number));
    writeln!(f, "{name:<18}{:>14}{:>14}{:>14}", columns[0], columns[1], columns[2])
}

/// A title and one line a bin; nothing where there are no bins.
fn write_bars(f: &mut fmt::Formatter<'_>, title: &str, labels: &[String], counts: &[usize]) -> fmt::Result {
    let most = counts.iter().copied().max().unwrap_or(0);
    if most == 0 {
        return Ok(());
    }
    writeln!(f, "\n{title}")?;
    for (label, &count) in labels.iter().zip(counts) {
        let bar = "#".repeat(bar_length(count, most));
        let line = format!("{label} {count:>10}  {bar}");
        writeln!(f, "{}", line.trim_end())?;
    }
    Ok(())
}

/// The length of a bar in proportion to its count, rounded up, so that no bin with a count looks empty.
fn bar_length(count: usize, most: usize) -> usize {
    let (count, most) = (count as u128, most as u128);
    usize::try_from((count * BAR as u128).div_ceil(most)).unwrap_or(BAR)
}

fn range_label([from, to]: [f64; 2]) -> String {
    let short = |v: f64| format!("{v:.1}").trim_end_matches(".0").to_owned();
    format!("{:>5} – {:>4}°", short(from), short(to))
}

fn ratio_label([from, to]: [f64; 2]) -> String {
    if to == f64::INFINITY { format!("{from:>5} –     ") } else { format!("{from:>5} – {to:>4}") }
}

/// A number with six significant digits, in plain or exponent form, whichever is easier to read.
fn number(value: f64) -> String {
    let exponent_form = format!("{value:.*e}", DIGITS - 1);
    let exponent = exponent_form.split_once('e').and_then(|(_, e)| e.parse::<i32>().ok());
    match exponent {
        Some(e @ -4..=8) if value != 0.0 => {
            let decimals = usize::try_from(5 - e).unwrap_or(0);
            let plain = format!("{value:.decimals$}");
            if plain.contains('.') { plain.trim_end_matches('0').trim_end_matches('.').to_owned() } else { plain }
        }
        _ if value == 0.0 || !value.is_finite() => format!("{value}"),
        _ => exponent_form,
    }
}
