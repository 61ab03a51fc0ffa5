//! Positions sorted by their keys on the curve.
//!
//! Up to some tens of thousands everything fits the cache: four passes of eight bits, the least digit first. Above, one
//! pass by the most significant digit comes first; each of its buckets fits the cache, and three passes do the rest.

/// Fewer than this are sorted by comparisons.
const FEW: usize = 64;
/// From so many on the passes over all would leave the cache.
const BUCKETS_FROM: usize = 1 << 16;
/// Bits of a digit.
const BITS: u32 = 8;

/// How many keys have each digit; then where the next one of them goes.
type Digits = [u32; 1 << BITS];

/// A position and its place on the curve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Keyed {
    pub(super) key: u32,
    pub(super) position: u32,
}

impl Keyed {
    #[inline(always)]
    const fn digit(self, place: u32) -> usize {
        (self.key >> (BITS * place) & 0xff) as usize
    }
}

/// Sorts by key. Equal keys keep their order. `spare` is as long, and what it holds is lost.
///
/// # Complexity
/// Linear.
pub(super) fn sort_by_key(keyed: &mut [Keyed], spare: &mut [Keyed]) {
    match keyed.len() {
        0..FEW => keyed.sort_by_key(|k| k.key),
        FEW..BUCKETS_FROM => sort_by_least_digits::<4>(keyed, spare),
        _ => sort_by_buckets(keyed, spare),
    }
}

/// By the most significant digit into `spare`, and back bucket by bucket.
fn sort_by_buckets(keyed: &mut [Keyed], spare: &mut [Keyed]) {
    let mut ends = [0; 1 << BITS];
    for k in keyed.iter() {
        ends[k.digit(3)] += 1;
    }
    distribute(keyed, spare, 3, &mut ends);
    let mut start = 0;
    for end in ends {
        let bucket = start..end as usize;
        start = bucket.end;
        let (from, to) = (&mut spare[bucket.clone()], &mut keyed[bucket]);
        if from.len() < FEW {
            to.copy_from_slice(from);
            to.sort_by_key(|k| k.key);
        } else {
            sort_by_least_digits::<3>(from, to);
        }
    }
}

/// By so many digits, the least one first, to and fro: an odd number of passes leaves the result in `b`.
fn sort_by_least_digits<'a, const PASSES: usize>(mut a: &'a mut [Keyed], mut b: &'a mut [Keyed]) {
    let mut counts = [[0; 1 << BITS]; PASSES];
    for k in a.iter() {
        for (place, count) in (0..).zip(&mut counts) {
            count[k.digit(place)] += 1;
        }
    }
    for (place, count) in (0..).zip(&mut counts) {
        distribute(a, b, place, count);
        std::mem::swap(&mut a, &mut b);
    }
}

/// One pass: copies by one digit, of which the counts are given; leaves behind where each digit ends.
fn distribute(from: &[Keyed], to: &mut [Keyed], place: u32, slots: &mut Digits) {
    let mut start = 0;
    for slot in slots.iter_mut() {
        start += std::mem::replace(slot, start);
    }
    for &k in from {
        let slot = &mut slots[k.digit(place)];
        to[*slot as usize] = k;
        *slot += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_sorts_as_a_stable_sort_does() {
        for n in [0, 1, FEW - 1, FEW, 1000, BUCKETS_FROM - 1, BUCKETS_FROM, 100_000] {
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
