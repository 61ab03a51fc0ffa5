//! The Hilbert curve: keys in whose order neighbours in the plane are mostly neighbours in memory.
//!
//! The curve visits the four quadrants of a square one after the other, and each of them as a copy of itself that may
//! be transposed and turned by half. These two choices are the state; one pair of coordinate bits in a state gives one
//! digit to base four and the next state. The table takes four such steps at once: 4 states times 16 by 16 positions.

/// Entry `state * 256 + x * 16 + y`: four digits in the low byte, the next state above them.
const STEPS: [u16; 1024] = four_steps();

/// The key of a cell of the 65536 by 65536 grid.
///
/// # Guarantees
/// A bijection; cells of successive keys share a side. Key 0 is the cell (0, 0), the last key the cell (65535, 0).
///
/// # Source
/// The curve of `[Hilbert91]`; the automaton is derived in the head of this file.
#[must_use]
#[inline]
pub fn hilbert_key_16(x: u16, y: u16) -> u32 {
    let (mut state, mut key) = (0, 0);
    for shift in [12, 8, 4, 0] {
        let step = step(state, u32::from(x) >> shift, u32::from(y) >> shift);
        key = key << 8 | u32::from(step & 0xff);
        state = step & 0x300;
    }
    key
}

/// The key of a cell of the 2^32 by 2^32 grid; a bijection, in which cells of successive keys share a side.
#[doc(alias = "space-filling curve")]
#[doc(alias = "BRIO")]
#[must_use]
#[inline]
pub fn hilbert_key_32(x: u32, y: u32) -> u64 {
    let (mut state, mut key) = (0, 0);
    for shift in [28, 24, 20, 16, 12, 8, 4, 0] {
        let step = step(state, x >> shift, y >> shift);
        key = key << 8 | u64::from(step & 0xff);
        state = step & 0x300;
    }
    key
}

/// Looks up four steps for the low four bits of each coordinate.
#[inline(always)]
fn step(state: u16, x: u32, y: u32) -> u16 {
    let index = usize::from(state) | ((x & 15) << 4 | y & 15) as usize;
    STEPS[index & 1023]
}

/// Builds the table, one bit of each coordinate after the other.
const fn four_steps() -> [u16; 1024] {
    let mut table = [0; 1024];
    let mut index = 0;
    while index < 1024 {
        let (mut transposed, mut turned) = (index >> 8 & 1, index >> 9 & 1);
        let mut digits = 0;
        let mut bit = 4;
        while bit > 0 {
            bit -= 1;
            let (x, y) = (index >> (4 + bit) & 1 ^ turned, index >> bit & 1 ^ turned);
            let (x, y) = if transposed == 1 { (y, x) } else { (x, y) };
            digits = digits << 2 | (3 * x) ^ y;
            if y == 0 {
                transposed ^= 1;
                turned ^= x;
            }
        }
        table[index] = (digits | transposed << 8 | turned << 9) as u16;
        index += 1;
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn successive_cells_share_a_side() {
        let mut cells = vec![None; 1 << 16];
        for x in 0..256_u16 {
            for y in 0..256_u16 {
                let key = hilbert_key_16(x, y) as usize;
                assert_eq!(cells[key].replace((x, y)), None);
            }
        }
        let cells: Vec<_> = cells.into_iter().flatten().collect();
        assert_eq!(cells.len(), 1 << 16);
        for pair in cells.windows(2) {
            assert_eq!(pair[0].0.abs_diff(pair[1].0) + pair[0].1.abs_diff(pair[1].1), 1);
        }
    }

    #[test]
    fn the_curve_runs_from_corner_to_corner() {
        assert_eq!(hilbert_key_16(0, 0), 0);
        assert_eq!(hilbert_key_16(u16::MAX, 0), u32::MAX);
        assert_eq!(hilbert_key_32(0, 0), 0);
        assert_eq!(hilbert_key_32(u32::MAX, 0), u64::MAX);
    }

    #[test]
    fn the_finer_curve_refines_the_coarser_one() {
        for (x, y) in [(1, 2), (0xabcd, 0x1234), (0xffff, 0xffff), (77, 0x8000)] {
            let fine = hilbert_key_32(u32::from(x) << 16 | 0x5a5a, u32::from(y) << 16 | 0x1221);
            assert_eq!((fine >> 32) as u32, hilbert_key_16(x, y));
        }
    }
}
