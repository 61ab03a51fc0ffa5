//! Counts by ranges, equal ones and others.

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

/// How many values fall into each of some ranges of different width.
///
/// # Shape
/// Class `i` holds what is at least `bounds[i]` and less than `bounds[i + 1]`; the last one has no upper bound, and the
/// first one holds what lies below its bound, too.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Classes {
    /// The lower bounds, ascending.
    pub bounds: Vec<f64>,
    /// How many values fall into each class.
    pub counts: Vec<usize>,
}

impl Classes {
    /// Empty classes with these lower bounds, ascending.
    #[must_use]
    pub fn new(bounds: &[f64]) -> Self {
        Self { bounds: bounds.to_vec(), counts: vec![0; bounds.len()] }
    }

    /// Empty classes for [aspect ratios](super::aspect_ratio): narrow near 1, where those of good triangles lie. A
    /// smallest angle of 30, 20 and 10 degrees allows 1.30, 1.74 and 3.14.
    #[must_use]
    pub fn of_aspect_ratios() -> Self {
        Self::new(&[1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.75, 2.0, 3.0, 5.0, 10.0, 100.0])
    }

    /// Counts a value.
    pub fn add(&mut self, value: f64) {
        let class = self.bounds.partition_point(|bound| *bound <= value).saturating_sub(1);
        if let Some(count) = self.counts.get_mut(class) {
            *count += 1;
        }
    }

    /// The bounds of a class; the upper one of the last is infinite.
    #[must_use]
    pub fn range(&self, class: usize) -> [f64; 2] {
        [class, class + 1].map(|i| self.bounds.get(i).copied().unwrap_or(f64::INFINITY))
    }

    /// How many values were counted.
    #[must_use]
    pub fn total(&self) -> usize {
        self.counts.iter().sum()
    }
}
