//! From values to places along an axis, and where its ticks are.

use trimalla::geometry::math;

/// An axis of some length, linear or logarithmic.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    low: f64,
    high: f64,
    is_log: bool,
    /// Where ticks are, in values, ascending.
    pub(super) ticks: Vec<f64>,
}

/// Beyond this ratio of largest to smallest value an axis is logarithmic.
const LOG_RATIO: f64 = 10.0;

impl Axis {
    /// An axis that begins and ends at the values' ends.
    pub(super) fn exact(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = range(values);
        let ticks = multiples(low, high, nice_step((high - low) / 17.0));
        Self { low, high, is_log: false, ticks }
    }

    /// An axis that begins and ends at ticks: logarithmic for values of very different size.
    pub(super) fn rounded(values: impl Iterator<Item = f64> + Clone) -> Self {
        let (low, high) = range(values.clone());
        let is_log =
            values.into_iter().filter(|v| v.is_finite()).all(|v| v > 0.0) && high / low > LOG_RATIO && low > 0.0;
        if is_log {
            return Self::logarithmic(low, high);
        }
        let low = if low > 0.0 { 0.0 } else { low };
        let step = nice_step((high - low) / 6.0);
        let (low, high) = ((low / step).floor() * step, (high / step).ceil() * step);
        Self { low, high, is_log: false, ticks: multiples(low, high, step) }
    }

    fn logarithmic(low: f64, high: f64) -> Self {
        let decades = (math::log10(low).floor() as i32)..=(math::log10(high).ceil() as i32);
        let is_long = decades.clone().count() > 5;
        let leading: &[f64] = if is_long { &[1.0] } else { &[1.0, 2.0, 5.0] };
        let ticks: Vec<f64> = decades.flat_map(|d| leading.iter().map(move |l| l * power_of_ten(d))).collect();
        let first = ticks.iter().rposition(|&t| t <= low).unwrap_or(0);
        let last = ticks.iter().position(|&t| t >= high).unwrap_or(ticks.len() - 1);
        let ticks = ticks[first..=last.max(first)].to_vec();
        Self { low: ticks[0], high: ticks[ticks.len() - 1], is_log: true, ticks }
    }

    pub(super) fn is_logarithmic(&self) -> bool {
        self.is_log
    }

    /// Where a value lies, from 0 to 1.
    pub(super) fn place(&self, value: f64) -> f64 {
        let scale = |v: f64| if self.is_log { math::log10(v) } else { v };
        let (low, high) = (scale(self.low), scale(self.high));
        // Halves do not overflow.
        let place = (scale(value) / 2.0 - low / 2.0) / (high / 2.0 - low / 2.0);
        if place.is_finite() { place.clamp(0.0, 1.0) } else { 0.5 }
    }

    /// The text of a tick.
    pub(super) fn label(value: f64) -> String {
        match value.abs() {
            0.0 => "0".to_owned(),
            1000.0..1e7 => grouped(value),
            1e-4..1000.0 => trimmed(&format!("{value:.4}")),
            _ => format!("{value:e}"),
        }
    }
}

fn grouped(value: f64) -> String {
    let digits = format!("{:.0}", value.abs());
    let mut text = String::from(if value < 0.0 { "−" } else { "" });
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i) % 3 == 0 {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

fn trimmed(text: &str) -> String {
    text.trim_end_matches('0').trim_end_matches('.').replace('-', "−")
}

/// The finite values' least and largest, set apart where they coincide.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let finite = values.filter(|v| v.is_finite());
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    match (low.is_finite(), (high - low).is_finite()) {
        (false, _) => (0.0, 1.0),
        (true, false) => (-f64::MAX / 4.0, f64::MAX / 4.0),
        _ if low == high && low.abs() < 1e300 => (low - low.abs().max(1.0) / 2.0, high + high.abs().max(1.0) / 2.0),
        _ => (low, high),
    }
}

/// The smallest of 1, 2, 5, 10, 20, 50, … times a power of ten that is at least this.
fn nice_step(least: f64) -> f64 {
    if !(least > 0.0 && least.is_finite()) {
        return 1.0;
    }
    let power = power_of_ten(math::log10(least).floor() as i32);
    let nice = [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|&s| s >= least * (1.0 - 1e-9));
    nice.unwrap_or(least)
}

/// Exact up to 22, and by one rounding beyond.
fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(1.0)
}

fn multiples(low: f64, high: f64, step: f64) -> Vec<f64> {
    const MOST: usize = 40;
    let (first, last) = ((low / step - 1e-9).ceil(), (high / step + 1e-9).floor());
    let count = (last - first + 1.0).clamp(0.0, MOST as f64) as usize;
    (0..count).map(|i| (first + i as f64) * step).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_numbers_that_span_the_values() {
        assert_eq!(Axis::exact([20.0, 37.0].into_iter()).ticks, (20..=37).map(f64::from).collect::<Vec<_>>());
        assert_eq!(Axis::rounded([57.0, 203.0].into_iter()).ticks, [0.0, 50.0, 100.0, 150.0, 200.0, 250.0]);
        let axis = Axis::rounded([57.0, 19_000.0].into_iter());
        assert!(axis.is_logarithmic());
        assert_eq!(axis.ticks, [50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0, 10_000.0, 20_000.0]);
    }

    #[test]
    fn places_run_from_end_to_end() {
        for axis in [Axis::rounded([57.0, 203.0].into_iter()), Axis::rounded([57.0, 19_000.0].into_iter())] {
            let (first, last) = (axis.ticks[0], axis.ticks[axis.ticks.len() - 1]);
            assert_eq!((axis.place(first), axis.place(last)), (0.0, 1.0));
        }
        let log = Axis::rounded([1.0, 100.0].into_iter());
        assert!((log.place(10.0) - 0.5).abs() < 1e-12);
    }

    #[test]
    fn labels_are_short() {
        let labels = [0.0, 0.05, 20.0, 20_000.0, 1e9, -0.5].map(Axis::label);
        assert_eq!(labels, ["0", "0.05", "20", "20\u{202f}000", "1e9", "−0.5"]);
    }
}
