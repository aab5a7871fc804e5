//! A number that a fit may change, and how far on the way from its lower to its upper bound it is.

use crate::error::Range;

/// The ratio of the bounds, or their distance, beyond which equal steps are equal ratios.
const WIDE: f64 = 100.0;

/// How close to a bound, in parts of the way between both, a number counts as being there.
pub(super) const END: f64 = 1e-6;

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Free {
    pub(super) path: String,
    pub(super) range: Range,
    /// Where the fit begins, which may lie beyond the bounds: then it is the nearer one.
    pub(super) start: f64,
}

/// On which scale equal steps are alike.
enum Scale {
    Even,
    /// Equal ratios, of a number whose bounds are far apart.
    Ratios,
    /// Equal ratios of 1 plus the distance from the lower bound, which is 0 or below.
    RatiosFromOne,
}

impl Free {
    const fn scale(&self) -> Scale {
        let Range { lower, upper } = self.range;
        if lower > 0.0 && upper / lower > WIDE {
            Scale::Ratios
        } else if upper - lower > WIDE {
            Scale::RatiosFromOne
        } else {
            Scale::Even
        }
    }

    /// The part of the way from the lower to the upper bound, 0 … 1, at which the fit begins.
    pub(super) fn start_part(&self) -> f64 {
        self.part(self.start).clamp(0.0, 1.0)
    }

    /// The part of the way from the lower to the upper bound at which a value lies.
    fn part(&self, value: f64) -> f64 {
        let Range { lower, upper } = self.range;
        match self.scale() {
            Scale::Even => (value - lower) / (upper - lower),
            Scale::Ratios => (value.max(lower) / lower).ln() / (upper / lower).ln(),
            Scale::RatiosFromOne => (value - lower).max(0.0).ln_1p() / (upper - lower).ln_1p(),
        }
    }

    /// The value at a part of the way, and its derivative by that part. Where the fit begins it is the
    /// start to the last bit.
    pub(super) fn value_and_slope(&self, part: f64) -> (f64, f64) {
        let Range { lower, upper } = self.range;
        let (value, slope) = match self.scale() {
            Scale::Even => (lower + (upper - lower) * part, upper - lower),
            Scale::Ratios => {
                let whole = (upper / lower).ln();
                let value = lower * (whole * part).exp();
                (value, value * whole)
            }
            Scale::RatiosFromOne => {
                let whole = (upper - lower).ln_1p();
                let above = (whole * part).exp_m1();
                (lower + above, (1.0 + above) * whole)
            }
        };
        let value = if part == self.start_part() {
            self.start
        } else if part >= 1.0 {
            upper
        } else {
            value
        };
        (value.clamp(lower, upper), slope)
    }

    pub(super) fn is_at_bound(&self, value: f64) -> bool {
        let part = self.part(value);
        !(END..=1.0 - END).contains(&part)
    }
}

#[cfg(test)]
mod tests {
    use super::Free;
    use crate::error::Range;

    #[test]
    fn values_stay_in_the_range_and_have_their_slopes() {
        for (lower, upper, start) in
            [(0.0, 1.0, 0.3), (1e-8, 1e4, 0.3), (-2.0, 5.0, 0.0), (0.0, 1e8, 30.0)]
        {
            let free = Free { path: String::new(), range: Range { lower, upper }, start };
            let at = |part: f64| free.value_and_slope(part).0;
            assert_eq!([at(0.0), at(free.start_part()), at(1.0)], [lower, start, upper]);
            for part in [0.01, 0.2, 0.45, 0.8, 0.99] {
                let (value, slope) = free.value_and_slope(part);
                assert!(lower < value && value < upper, "{value}");
                assert!((free.part(value) - part).abs() < 1e-14);
                let step = 1e-6;
                let difference = (at(part + step) - at(part - step)) / (2.0 * step);
                assert!((slope / difference - 1.0).abs() < 1e-8, "{slope} {difference}");
            }
            assert!(free.is_at_bound(lower) && free.is_at_bound(upper) && !free.is_at_bound(start));
        }
    }

    #[test]
    fn a_start_beyond_the_bounds_is_the_nearer_one() {
        for (lower, upper) in [(0.2, 0.5), (1e-3, 1.0), (0.1, 1e4)] {
            let begin = |start| {
                let free = Free { path: String::new(), range: Range { lower, upper }, start };
                free.value_and_slope(free.start_part()).0
            };
            assert_eq!([begin(0.0), begin(2e4)], [lower, upper]);
        }
    }
}
