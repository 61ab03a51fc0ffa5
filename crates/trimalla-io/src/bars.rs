//! Bar charts: a title and labelled numbers, as text and [below a picture](crate::PictureOptions::with_charts).
//!
//! ```text
//! insertions by kind
//!           free     812  ########################################
//!        on edge       0
//! segment middle      49  ###
//!          shell      13  #
//! ```

use std::fmt;

use trimalla::quality::Statistics;
use trimalla::refine::{Report, StepTimes};

/// Length of the longest bar in text.
const BAR: f64 = 40.0;
/// Paths longer than this are counted together.
const LONGEST_PATH: usize = 12;

/// A title and labelled numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BarChart {
    /// The heading.
    pub title: String,
    /// The bars, from top to bottom.
    pub bars: Vec<Bar>,
}

/// One number.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bar {
    /// The label of the bar.
    pub label: String,
    /// The length of its bar, not negative, in any unit that all bars of the chart share.
    pub size: f64,
    /// The number in words.
    pub value: String,
}

impl BarChart {
    /// A chart of counts.
    #[must_use]
    pub fn of_counts<L: Into<String>>(title: &str, counts: impl IntoIterator<Item = (L, u64)>) -> Self {
        let bar = |(label, n): (L, u64)| Bar { label: label.into(), size: n as f64, value: n.to_string() };
        Self { title: title.to_owned(), bars: counts.into_iter().map(bar).collect() }
    }

    /// A chart of counts by ranges, from the first to the last that is not empty.
    fn of_ranges(title: &str, counts: &[usize], label: impl Fn(usize) -> String) -> Self {
        let is_filled = |count: &usize| *count > 0;
        let (first, last) = (counts.iter().position(is_filled), counts.iter().rposition(is_filled));
        let shown = first.zip(last).map_or(0..0, |(first, last)| first..last + 1);
        Self::of_counts(title, shown.map(|i| (label(i), counts[i] as u64)))
    }

    /// The length of each bar as a part of the longest; 0 for what is no size.
    pub(crate) fn shares(&self) -> Vec<f64> {
        let size = |bar: &Bar| if bar.size.is_finite() { bar.size.max(0.0) } else { 0.0 };
        let longest = self.bars.iter().map(size).fold(0.0, f64::max);
        self.bars.iter().map(|bar| if longest > 0.0 { size(bar) / longest } else { 0.0 }).collect()
    }

    /// The most letters of a label, and of a value.
    pub(crate) fn letters(&self) -> [usize; 2] {
        let most = |text: fn(&Bar) -> &str| self.bars.iter().map(|b| text(b).chars().count()).max().unwrap_or(0);
        [most(|bar| &bar.label), most(|bar| &bar.value)]
    }
}

/// The title, and a line each bar; a bar that is not empty is seen.
impl fmt::Display for BarChart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [labels, values] = self.letters();
        writeln!(f, "{}", self.title)?;
        for (Bar { label, value, .. }, share) in self.bars.iter().zip(self.shares()) {
            let bar = "#".repeat((BAR * share).ceil() as usize);
            writeln!(f, "{}", format!("{label:>labels$}  {value:>values$}  {bar}").trim_end())?;
        }
        Ok(())
    }
}

/// Everything that can be counted of a refinement and its mesh but the [smallest angles](smallest_angles): all angles,
/// aspect ratios, lengths of paths, insertions, leftovers, time; no chart of what did not occur.
///
/// # Examples
/// ```
/// use trimalla::quality::Statistics;
/// use trimalla::{MeshOptions, drawing::Pslg, geometry::Point};
/// use trimalla_io::bars;
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [0.0, 3.0]].map(Point::from).to_vec();
/// let pslg = Pslg { points, segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]], ..Pslg::default() };
/// let trimalla::Meshed { mesh, report, .. } = trimalla::mesh(&pslg, &MeshOptions::default())?;
/// let charts = bars::of_report(&Statistics::of(&mesh), &report);
/// assert!(charts.iter().any(|chart| chart.title == "insertions by kind"));
/// # Ok::<(), trimalla::Error>(())
/// ```
#[must_use]
pub fn of_report(statistics: &Statistics, report: &Report) -> Vec<BarChart> {
    let reasons = report.reasons().into_iter().map(|(reason, n)| (reason.key(), n as u64));
    let kinds = report.insertions().map(|(kind, n)| (kind.key(), n));
    let mut charts = vec![
        of_all_angles(statistics),
        of_aspect_ratios(statistics),
        of_paths(&report.lepp_lengths),
        BarChart::of_counts("insertions by kind", kinds),
        BarChart::of_counts("triangles below the bound, by reason", reasons),
    ];
    charts.extend(report.step_times.as_ref().map(of_times));
    charts.retain(|chart| chart.bars.iter().any(|bar| bar.size > 0.0));
    charts
}

/// The smallest angle of each triangle; the legend of a picture shows these bars, too.
#[must_use]
pub fn smallest_angles(statistics: &Statistics) -> BarChart {
    let angles = &statistics.smallest_angles;
    BarChart::of_ranges("smallest angle of each triangle", &angles.counts, |i| degrees(angles.range_deg(i)))
}

fn of_all_angles(statistics: &Statistics) -> BarChart {
    let angles = &statistics.all_angles;
    BarChart::of_ranges("all angles", &angles.counts, |i| degrees(angles.range_deg(i)))
}

fn of_aspect_ratios(statistics: &Statistics) -> BarChart {
    let ratios = &statistics.aspect_ratios;
    let label = |i| match ratios.range(i) {
        [from, to] if to.is_finite() => format!("{from} – {to}"),
        [from, _] => format!("{from} and more"),
    };
    BarChart::of_ranges("aspect ratio of each triangle", &ratios.counts, label)
}

/// Lengths of longest-edge propagation paths, and their mean.
fn of_paths(lengths: &[u64]) -> BarChart {
    let total: u64 = lengths.iter().sum();
    let sum: u64 = (0..).zip(lengths).map(|(length, n)| length * n).sum();
    let mean = if total > 0 { sum as f64 / total as f64 } else { 0.0 };
    let (short, long) = lengths.split_at(lengths.len().min(LONGEST_PATH + 1));
    let mut counts: Vec<(String, u64)> =
        (0..).zip(short).skip(1).map(|(i, &n): (usize, _)| (i.to_string(), n)).collect();
    if !long.is_empty() {
        counts.push((format!("{} and more", LONGEST_PATH + 1), long.iter().sum()));
    }
    BarChart::of_counts(&format!("triangles in a path, {mean:.2} on average"), counts)
}

fn of_times(times: &StepTimes) -> BarChart {
    let total = times.total();
    let bar = |(label, seconds): (&str, f64)| {
        let share = if total > 0.0 { 100.0 * seconds / total } else { 0.0 };
        Bar { label: label.to_owned(), size: seconds, value: format!("{:.3} ms, {share:.0} %", 1000.0 * seconds) }
    };
    BarChart { title: "time by step".to_owned(), bars: times.by_name().into_iter().map(bar).collect() }
}

fn degrees([from, to]: [f64; 2]) -> String {
    let short = |v: f64| format!("{v:.1}").trim_end_matches(".0").to_owned();
    format!("{} – {}°", short(from), short(to))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_are_in_proportion_and_what_is_there_is_seen() {
        let chart = BarChart::of_counts("fruit", [("apple", 400), ("fig", 1), ("", 0)]);
        let bars = ["#".repeat(40), "#".to_owned()];
        assert_eq!(chart.to_string(), format!("fruit\napple  400  {}\n  fig    1  {}\n         0\n", bars[0], bars[1]));
        assert_eq!(BarChart::default().to_string(), "\n");
    }

    #[test]
    fn empty_ends_are_left_out_and_empty_middles_are_not() {
        let labels = |counts: &[usize]| {
            let chart = BarChart::of_ranges("", counts, |i| i.to_string());
            chart.bars.into_iter().map(|bar| bar.label).collect::<Vec<_>>()
        };
        assert_eq!(labels(&[0, 3, 0, 1, 0]), ["1", "2", "3"]);
        assert!(labels(&[0, 0]).is_empty() && labels(&[]).is_empty());
    }

    #[test]
    fn long_paths_are_counted_together() {
        let mut lengths = vec![0, 2, 5];
        lengths.resize(40, 1);
        let chart = of_paths(&lengths);
        assert_eq!(chart.bars.len(), LONGEST_PATH + 1);
        assert_eq!(chart.bars[LONGEST_PATH].value, (40 - LONGEST_PATH - 1).to_string());
        assert_eq!(chart.bars.iter().map(|bar| bar.size).sum::<f64>(), lengths.iter().sum::<u64>() as f64);
        assert!(of_report(&Statistics::default(), &Report::default()).is_empty());
    }
}
