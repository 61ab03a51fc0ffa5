//! The order of the sweep: by x, then by y.

use crate::geometry::{Point, lexicographically_less};

/// Below this number, points are compared where they are; above, they are sorted by a key of whole numbers.
const FEW: usize = 24;

/// Sorts the indices of points by x, then by y, then by index.
pub(super) fn sort(points: &[Point], keys: &mut Vec<(u64, u32)>, order: &mut Vec<u32>) {
    order.clear();
    if points.len() <= FEW {
        for i in 0..points.len() as u32 {
            order.push(i);
            let mut at = i as usize;
            while at > 0 && lexicographically_less(points[i as usize], points[order[at - 1] as usize]) {
                order[at] = order[at - 1];
                at -= 1;
            }
            order[at] = i;
        }
        return;
    }
    keys.clear();
    keys.extend(points.iter().zip(0..).map(|(p, i)| (key(p.x), i)));
    keys.sort_unstable();
    order.extend(keys.iter().map(|&(_, i)| i));
    let mut begin = 0;
    while begin < keys.len() {
        let mut end = begin + 1;
        while end < keys.len() && keys[end].0 == keys[begin].0 {
            end += 1;
        }
        if end - begin > 1 {
            order[begin..end].sort_unstable_by_key(|&i| (key(points[i as usize].y), i));
        }
        begin = end;
    }
}

/// A whole number in the order of the numbers.
#[inline]
fn key(number: f64) -> u64 {
    // Adding zero makes the negative zero positive.
    let bits = (number + 0.0).to_bits();
    if bits >> 63 == 0 { bits | 1 << 63 } else { !bits }
}
