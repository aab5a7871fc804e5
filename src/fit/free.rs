//! A number that a fit may change: between its bounds, by a number without bounds.

use crate::error::Range;

/// The ratio of the bounds beyond which equal steps are equal ratios.
const WIDE: f64 = 100.0;

/// How close to a bound, in parts of the way between both, a number counts as being there.
const END: f64 = 1e-6;

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Free {
    pub(super) path: String,
    pub(super) range: Range,
    pub(super) start: f64,
}

impl Free {
    /// Whether equal steps are equal ratios.
    fn has_ratios(&self) -> bool {
        self.range.lower > 0.0 && self.range.upper / self.range.lower > WIDE
    }

    /// The number without bounds that stands for the start. At a bound it would be infinite: a start
    /// there moves inside.
    pub(super) fn unbounded_start(&self) -> f64 {
        let part = self.part(self.start).clamp(1e-3, 1.0 - 1e-3);
        (part / (1.0 - part)).ln()
    }

    /// How far on the way from the lower to the upper bound a value lies.
    fn part(&self, value: f64) -> f64 {
        let Range { lower, upper } = self.range;
        if self.has_ratios() {
            (value / lower).ln() / (upper / lower).ln()
        } else {
            (value - lower) / (upper - lower)
        }
    }

    /// The value that a number without bounds stands for, and its derivative by that number.
    pub(super) fn value_and_slope(&self, unbounded: f64) -> (f64, f64) {
        let Range { lower, upper } = self.range;
        let part = 1.0 / (1.0 + (-unbounded).exp());
        let slope = part * (1.0 - part);
        let (value, slope) = if self.has_ratios() {
            let ratio = upper / lower;
            let value = lower * ratio.powf(part);
            (value, value * ratio.ln() * slope)
        } else {
            (lower + (upper - lower) * part, (upper - lower) * slope)
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
        for (lower, upper, start) in [(0.0, 1.0, 0.3), (1e-8, 1e4, 0.3), (-2.0, 5.0, 0.0)] {
            let free = Free { path: String::new(), range: Range { lower, upper }, start };
            let at = |x: f64| free.value_and_slope(x).0;
            assert!((at(free.unbounded_start()) - start).abs() < 1e-12 * (1.0 + start));
            for x in [-800.0, -30.0, -3.0, -0.1, 0.4, 5.0, 40.0, 800.0] {
                let (value, slope) = free.value_and_slope(x);
                assert!((lower..=upper).contains(&value), "{value}");
                let step = 1e-6;
                let difference = (at(x + step) - at(x - step)) / (2.0 * step);
                assert!(
                    (slope - difference).abs() <= 1e-8 * (upper - lower).min(1.0 + value.abs())
                );
            }
            assert!(free.is_at_bound(at(-40.0)) && free.is_at_bound(at(40.0)));
        }
    }
}
