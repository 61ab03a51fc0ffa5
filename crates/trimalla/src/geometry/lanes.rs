//! Arithmetic on one number, or on two at once in a vector register.

use core::ops::{Add, Mul, Sub};

use super::Point;

/// One number, or two that go through the same arithmetic.
pub(crate) trait Number: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    fn of(number: f64) -> Self;
    fn abs(self) -> Self;
    /// The lesser one; `other` where they cannot be compared.
    fn lesser(self, other: Self) -> Self;
    /// The greater one; `other` where they cannot be compared.
    fn greater(self, other: Self) -> Self;
    /// The number where the magnitude of it is above `bound`, else zero.
    fn if_above(self, bound: Self) -> Self;
    /// The number where `other` lies between these bounds, else zero.
    fn if_within(self, other: Self, bounds: [f64; 2]) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn of(number: f64) -> Self {
        number
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn lesser(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[inline(always)]
    fn greater(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[inline(always)]
    fn if_above(self, bound: Self) -> Self {
        if self.abs() > bound { self } else { 0.0 }
    }

    #[inline(always)]
    fn if_within(self, other: Self, [least, most]: [f64; 2]) -> Self {
        // Not `&&`, which would be a branch.
        if (other >= least) & (other <= most) { self } else { 0.0 }
    }
}

/// Two numbers.
#[derive(Clone, Copy)]
pub(crate) struct Two(pub(crate) [f64; 2]);

impl Two {
    /// The coordinates of two points.
    #[inline(always)]
    pub(crate) fn coordinates([p, q]: [Point; 2]) -> [Self; 2] {
        [Self([p.x, q.x]), Self([p.y, q.y])]
    }

    #[inline(always)]
    fn with(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self([f(self.0[0], other.0[0]), f(self.0[1], other.0[1])])
    }
}

impl Number for Two {
    #[inline(always)]
    fn of(number: f64) -> Self {
        Self([number; 2])
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.map(f64::abs))
    }

    #[inline(always)]
    fn lesser(self, other: Self) -> Self {
        self.with(other, Number::lesser)
    }

    #[inline(always)]
    fn greater(self, other: Self) -> Self {
        self.with(other, Number::greater)
    }

    #[inline(always)]
    fn if_above(self, bound: Self) -> Self {
        self.with(bound, Number::if_above)
    }

    #[inline(always)]
    fn if_within(self, other: Self, bounds: [f64; 2]) -> Self {
        self.with(other, |x, y| x.if_within(y, bounds))
    }
}

impl Add for Two {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(other, f64::add)
    }
}

impl Sub for Two {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.with(other, f64::sub)
    }
}

impl Mul for Two {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(other, f64::mul)
    }
}
