//! Random numbers from bytes.

use trimalla_testkit::generators::SplitMix64;

/// Draws numbers from bytes; where those are used up, from a generator that all of them seed.
///
/// So a fuzzer that changes bytes changes choices, and eight bytes are enough for any input.
#[derive(Clone, Debug)]
pub struct Draws<'a> {
    bytes: &'a [u8],
    more: SplitMix64,
}

impl<'a> Draws<'a> {
    /// Draws from these bytes.
    #[must_use]
    pub fn new(bytes: &'a [u8]) -> Self {
        // FNV-1a.
        let seed =
            bytes.iter().fold(0xcbf2_9ce4_8422_2325_u64, |h, &b| (h ^ u64::from(b)).wrapping_mul(0x100_0000_01b3));
        Self { bytes, more: SplitMix64::new(seed) }
    }

    /// Draws from a generator alone.
    #[must_use]
    pub fn seeded(seed: u64) -> Draws<'static> {
        Draws { bytes: &[], more: SplitMix64::new(seed) }
    }

    /// Sixty-four bits.
    pub fn bits(&mut self) -> u64 {
        match self.bytes.split_first_chunk::<8>() {
            Some((first, rest)) => {
                self.bytes = rest;
                u64::from_le_bytes(*first)
            }
            None => self.more.next_u64(),
        }
    }

    /// An index below `n`, which is not 0.
    pub fn below(&mut self, n: usize) -> usize {
        let n = n.max(1) as u64;
        let drawn = match self.bytes.split_first() {
            Some((&first, rest)) if n <= 256 => {
                self.bytes = rest;
                u64::from(first)
            }
            _ => self.bits(),
        };
        (drawn % n) as usize
    }

    /// A number from `low` to `high`, both included.
    pub fn within(&mut self, low: usize, high: usize) -> usize {
        low + self.below(high - low + 1)
    }

    /// True once in `n` draws.
    pub fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == n - 1
    }

    /// One of the items, of which there is at least one.
    pub fn pick<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }

    /// A multiple of 2⁻⁵³ in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number between two others.
    pub fn range(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// The bytes that were not drawn from yet.
    #[must_use]
    pub fn rest(&self) -> &'a [u8] {
        self.bytes
    }
}
