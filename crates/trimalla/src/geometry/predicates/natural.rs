//! Natural numbers of any size, for comparisons that double precision leaves open.

use core::cmp::Ordering;

/// A natural number: digits of 64 bits, the lowest first, the highest not zero.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Natural(Vec<u64>);

impl Natural {
    pub(super) const ZERO: Self = Self(Vec::new());

    /// `value * 2^shift`.
    pub(crate) fn shifted(value: u128, shift: usize) -> Self {
        let mut all = vec![0; shift / 64];
        let bits = shift % 64;
        let (low, high) = (value as u64, (value >> 64) as u64);
        let above = |digit: u64| if bits == 0 { 0 } else { digit >> (64 - bits) };
        all.extend([low << bits, (high << bits) | above(low), above(high)]);
        Self(all).trimmed()
    }

    /// The digits, the lowest first; the highest is not zero.
    pub(super) fn digits(&self) -> &[u64] {
        &self.0
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The number of binary digits.
    fn bits(&self) -> usize {
        self.0.last().map_or(0, |top| 64 * self.0.len() - top.leading_zeros() as usize)
    }

    fn trimmed(mut self) -> Self {
        while self.0.last() == Some(&0) {
            self.0.pop();
        }
        self
    }

    /// Adds a number.
    pub(crate) fn add(&mut self, other: &Self) {
        if self.0.len() < other.0.len() {
            self.0.resize(other.0.len(), 0);
        }
        let mut carry = false;
        for (i, digit) in self.0.iter_mut().enumerate() {
            let (sum, over) = digit.overflowing_add(other.0.get(i).copied().unwrap_or(0));
            let (sum, again) = sum.overflowing_add(u64::from(carry));
            (*digit, carry) = (sum, over || again);
        }
        if carry {
            self.0.push(1);
        }
    }

    /// Subtracts a number that is no larger.
    fn subtract(&mut self, other: &Self) {
        let mut borrow = false;
        for (i, digit) in self.0.iter_mut().enumerate() {
            let (rest, under) = digit.overflowing_sub(other.0.get(i).copied().unwrap_or(0));
            let (rest, again) = rest.overflowing_sub(u64::from(borrow));
            (*digit, borrow) = (rest, under || again);
        }
        while self.0.last() == Some(&0) {
            self.0.pop();
        }
    }

    /// The distance of two numbers.
    pub(crate) fn distance(mut one: Self, mut two: Self) -> Self {
        if one < two {
            std::mem::swap(&mut one, &mut two);
        }
        one.subtract(&two);
        one
    }

    /// The product.
    pub(crate) fn times(&self, other: &Self) -> Self {
        let mut product = vec![0; self.0.len() + other.0.len()];
        for (i, &a) in self.0.iter().enumerate() {
            let mut carry = 0;
            for (j, &b) in other.0.iter().enumerate() {
                let sum = u128::from(a) * u128::from(b) + u128::from(product[i + j]) + carry;
                product[i + j] = sum as u64;
                carry = sum >> 64;
            }
            product[i + other.0.len()] = carry as u64;
        }
        Self(product).trimmed()
    }

    /// The number times a small one.
    pub(crate) fn times_small(&self, factor: u64) -> Self {
        self.times(&Self::shifted(u128::from(factor), 0))
    }

    /// The number times `2^(64 * digits)`.
    pub(crate) fn raised(&self, digits: usize) -> Self {
        let mut all = vec![0; digits];
        all.extend(&self.0);
        Self(all).trimmed()
    }

    /// Doubles the number `times` times and adds `low`, which is less than `2^times`; `times` is 1 or 2.
    fn push_bits(&mut self, times: u32, low: u64) {
        let mut carry = low;
        for digit in &mut self.0 {
            let out = *digit >> (64 - times);
            *digit = (*digit << times) | carry;
            carry = out;
        }
        if carry != 0 {
            self.0.push(carry);
        }
    }

    /// Halves the number, rounded down.
    fn halve(&mut self) {
        let mut carry = 0;
        for digit in self.0.iter_mut().rev() {
            let out = *digit << 63;
            *digit = (*digit >> 1) | carry;
            carry = out;
        }
        if self.0.last() == Some(&0) {
            self.0.pop();
        }
    }

    /// The square root, rounded down: one binary digit after the other, as by hand.
    pub(crate) fn root(&self) -> Self {
        let (mut root, mut rest) = (Self::default(), Self::default());
        for pair in (0..self.bits().div_ceil(2)).rev() {
            let two = (self.0[pair / 32] >> (2 * (pair % 32))) & 3;
            rest.push_bits(2, two);
            root.push_bits(2, 1);
            let is_one = rest >= root;
            if is_one {
                rest.subtract(&root);
            }
            root.halve();
            if is_one {
                match root.0.first_mut() {
                    Some(lowest) => *lowest |= 1,
                    None => root.0.push(1),
                }
            }
        }
        root
    }

    /// The square root, if the number is a square.
    pub(crate) fn exact_root(&self) -> Option<Self> {
        let root = self.root();
        (root.times(&root) == *self).then_some(root)
    }
}

impl Ord for Natural {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.len().cmp(&other.0.len()).then_with(|| self.0.iter().rev().cmp(other.0.iter().rev()))
    }
}

impl PartialOrd for Natural {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_numbers_are_those_of_the_machine() {
        let of = |value: u128| Natural::shifted(value, 0);
        for (a, b) in [(0_u64, 0_u64), (1, 3), (u64::MAX, u64::MAX), (u64::MAX, 1), (1 << 63, 1 << 62), (12345, 678)] {
            let (a, b) = (u128::from(a), u128::from(b));
            let mut sum = of(a);
            sum.add(&of(b));
            assert_eq!(sum, of(a + b));
            assert_eq!(Natural::distance(of(a), of(b)), of(a.abs_diff(b)));
            assert_eq!(of(a).times(&of(b)), of(a * b));
            assert_eq!(of(a).cmp(&of(b)), a.cmp(&b));
            assert_eq!(of(a * b).root(), of((a * b).isqrt()));
            assert_eq!(of(a * a).exact_root(), Some(of(a)));
            assert_eq!(of(a * a + a).exact_root().is_some(), a == 0);
        }
    }

    #[test]
    fn roots_of_long_numbers_are_rounded_down() {
        for shift in [0, 1, 63, 64, 65, 500, 511] {
            let n = Natural::shifted(0x1234_5678_9abc_def0_0fed_cba9_8765_4321, shift);
            let root = n.root();
            let mut next = root.clone();
            next.add(&Natural::shifted(1, 0));
            assert!(root.times(&root) <= n && n < next.times(&next));
        }
        assert_eq!(Natural::shifted(1, 512).root(), Natural::shifted(1, 256));
        assert_eq!(Natural::shifted(3, 64).raised(2), Natural::shifted(3, 192));
    }
}
