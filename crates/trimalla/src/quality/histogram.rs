//! Counts by equal ranges.

/// How many values fall into each of some equal ranges of degrees.
///
/// # Shape
/// Bin `i` holds what is at least `i * width_deg` and less than `(i + 1) * width_deg`; the last one holds what lies
/// on its upper end or beyond, too.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Histogram {
    /// Width of a bin, in degrees.
    pub width_deg: f64,
    /// How many values fall into each bin.
    pub counts: Vec<usize>,
}

impl Histogram {
    /// So many empty bins, at least one, from 0 to `end_deg`.
    #[must_use]
    pub fn new(bins: usize, end_deg: f64) -> Self {
        let bins = bins.max(1);
        Self { width_deg: end_deg / bins as f64, counts: vec![0; bins] }
    }

    /// Counts a value.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a cast saturates, and what is too large belongs into the last bin"
    )]
    pub fn add(&mut self, value_deg: f64) {
        let bin = (value_deg / self.width_deg).floor() as usize;
        let last = self.counts.len().saturating_sub(1);
        if let Some(count) = self.counts.get_mut(bin.min(last)) {
            *count += 1;
        }
    }

    /// The range of a bin, in degrees.
    #[must_use]
    pub fn range_deg(&self, bin: usize) -> [f64; 2] {
        [bin as f64 * self.width_deg, (bin + 1) as f64 * self.width_deg]
    }

    /// How many values were counted.
    #[must_use]
    pub fn total(&self) -> usize {
        self.counts.iter().sum()
    }
}
