//! Positions sorted by their keys on the curve.
//!
//! Where keys are spread evenly, two digits tell nearly all of them apart: two passes, the lower digit first, and a few
//! neighbours that agree in both. Elsewhere the bits below are a third digit, which comes before them.
//!
//! While everything fits the cache, the two digits are the upper 22 bits of a key. Above, one pass by the uppermost 8
//! comes first; each of its buckets fits the cache, and the digits there have 8 bits as well.

/// Below `SLOTS / FEW` keys a comparison sort is faster.
const FEW: usize = 8;
/// From this many keys on, a pass over all of them leaves the cache.
const BUCKETS_FROM: usize = 1 << 18;
/// Keys count as evenly spread if no value of their upper digit has more than this many times its share.
const EVEN: usize = 4;

/// A position and its place on the curve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Keyed {
    pub(super) key: u32,
    pub(super) position: u32,
}

/// A digit to sort by: as many bits of a key as tell `SLOTS` apart, above some others.
#[derive(Clone, Copy)]
struct Digit<const SLOTS: usize> {
    shift: u32,
}

impl<const SLOTS: usize> Digit<SLOTS> {
    const BITS: u32 = SLOTS.ilog2();

    #[inline(always)]
    const fn of(self, k: Keyed) -> usize {
        (k.key >> self.shift) as usize % SLOTS
    }

    /// The digit above this one.
    const fn above(self) -> Self {
        Self { shift: self.shift + Self::BITS }
    }

    /// How many there are of each value.
    fn counts(self, keyed: &[Keyed]) -> [u32; SLOTS] {
        let mut counts = [0; SLOTS];
        for &k in keyed {
            counts[self.of(k)] += 1;
        }
        counts
    }

    /// Copies the keys in the order of the digit; keys with equal digits keep their order.
    fn distribute(self, from: &[Keyed], to: &mut [Keyed]) {
        self.distribute_counted(from, to, self.counts(from));
    }

    /// [`distribute`](Self::distribute) with known [`counts`](Self::counts). Returns where each value ends.
    fn distribute_counted(self, from: &[Keyed], to: &mut [Keyed], counts: [u32; SLOTS]) -> [u32; SLOTS] {
        let mut slots = counts;
        let mut start = 0;
        for slot in &mut slots {
            start += std::mem::replace(slot, start);
        }
        for &k in from {
            let slot = &mut slots[self.of(k)];
            to[*slot as usize] = k;
            *slot += 1;
        }
        slots
    }
}

/// Sorts by key. Equal keys keep their order. `spare` is as long, and what it holds is lost.
///
/// # Complexity
/// Linear; evenly spread keys that agree in two digits are sorted by comparisons.
pub(super) fn sort_by_key(keyed: &mut [Keyed], spare: &mut [Keyed]) {
    if keyed.len() < BUCKETS_FROM {
        sort_by_digits(keyed, spare, Digit::<{ 1 << 11 }> { shift: 10 });
    } else {
        sort_by_buckets(keyed, spare);
    }
}

/// Sorts by the uppermost digit into `spare`, then back bucket by bucket.
fn sort_by_buckets(keyed: &mut [Keyed], spare: &mut [Keyed]) {
    let uppermost = Digit::<{ 1 << 8 }> { shift: 24 };
    let ends = uppermost.distribute_counted(keyed, spare, uppermost.counts(keyed));
    let mut start = 0;
    for end in ends {
        let bucket = start..end as usize;
        start = bucket.end;
        let (from, to) = (&mut spare[bucket.clone()], &mut keyed[bucket]);
        to.copy_from_slice(from);
        sort_by_digits(to, from, Digit::<{ 1 << 8 }> { shift: 8 });
    }
}

/// Sorts by a digit, the digit above it, and the bits below it, which are at most one digit. The bits above are equal
/// in all keys.
fn sort_by_digits<const SLOTS: usize>(keyed: &mut [Keyed], spare: &mut [Keyed], digit: Digit<SLOTS>) {
    if keyed.len() < SLOTS / FEW {
        keyed.sort_by_key(|k| k.key);
        return;
    }
    let upper = digit.above();
    let counts = upper.counts(keyed);
    if counts.iter().all(|&count| count as usize <= EVEN * keyed.len().div_ceil(SLOTS)) {
        digit.distribute(keyed, spare);
        upper.distribute_counted(spare, keyed, counts);
        let are_tied = |a: &Keyed, b: &Keyed| a.key >> digit.shift == b.key >> digit.shift;
        let ties = keyed.chunk_by_mut(are_tied).filter(|ties| ties.len() > 1);
        ties.for_each(|ties| ties.sort_by_key(|k| k.key));
    } else {
        Digit::<SLOTS> { shift: 0 }.distribute(keyed, spare);
        digit.distribute(spare, keyed);
        upper.distribute_counted(keyed, spare, counts);
        keyed.copy_from_slice(spare);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_sorts_as_a_stable_sort_does() {
        for n in [0, 1, 255, 256, 1000, 100_000, BUCKETS_FROM - 1, BUCKETS_FROM] {
            // Spread out, few keys, in one bucket, nearly all in one, buckets of a few.
            for (bits, shift) in [(0xffff_ffff, 0), (0xc000_0003, 0), (0xffff, 0), (0xff, 24), (0, 0), (0xffff, 16)] {
                let key = |i: u32| (i.wrapping_mul(0x9e37_79b1) ^ i >> 3) & bits;
                let skewed = |i: u32| if i % 1000 == 7 { i << 12 } else { key(i) << shift };
                let mut keyed: Vec<Keyed> = (0..n as u32).map(|i| Keyed { key: skewed(i), position: i }).collect();
                let mut expected = keyed.clone();
                expected.sort_by_key(|k| k.key);
                sort_by_key(&mut keyed, &mut vec![Keyed::default(); n]);
                assert_eq!(keyed, expected);
            }
        }
    }
}
