//! A symbol: running a formula on it records what the formula does, as the generation of shader
//! text would. A formula that branches on a value, or turns a comparison into a `bool`, cannot
//! run on it at all.

use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

use brdf::{Mask, Real, Vector3};

/// One recorded operation on earlier results; a mask is 1 where it is true.
struct Step {
    operation: fn([f64; 3]) -> f64,
    arguments: [usize; 3],
    literal: f64,
}

thread_local! {
    static TAPE: RefCell<Vec<Step>> = const { RefCell::new(Vec::new()) };
}

/// A number that is not known yet: the place of its step on the tape of this thread.
#[derive(Clone, Copy, Debug)]
pub struct Traced(usize);

/// A comparison that is not known yet.
#[derive(Clone, Copy, Debug)]
pub struct TracedMask(usize);

#[inline(never)]
fn record(operation: fn([f64; 3]) -> f64, arguments: [usize; 3], literal: f64) -> usize {
    TAPE.with_borrow_mut(|tape| {
        tape.push(Step { operation, arguments, literal });
        tape.len() - 1
    })
}

/// Records a formula of `N` symbols and gives back a function that plays the record.
pub fn trace<const N: usize>(
    formula: impl FnOnce([Traced; N]) -> Vec<Traced>,
) -> impl Fn([f64; N]) -> Vec<f64> {
    TAPE.with_borrow_mut(Vec::clear);
    let results = formula(std::array::from_fn(|_| Traced(record(|[x, ..]| x, [0; 3], 0.0))));
    let tape = TAPE.with_borrow_mut(std::mem::take);
    move |inputs| {
        let mut values: Vec<f64> = Vec::with_capacity(tape.len());
        for (place, step) in tape.iter().enumerate() {
            let of = |argument: usize| values.get(argument).copied().unwrap_or(f64::NAN);
            let [a, b, c] = step.arguments;
            values.push(match inputs.get(place) {
                Some(input) => *input,
                None if step.arguments == [usize::MAX; 3] => step.literal,
                None => (step.operation)([of(a), of(b), of(c)]),
            });
        }
        results.iter().map(|result| values[result.0]).collect()
    }
}

fn as_mask(truth: bool) -> f64 {
    f64::from(u8::from(truth))
}

impl Mask for TracedMask {
    fn and(self, other: Self) -> Self {
        Self(record(|[a, b, _]| a * b, [self.0, other.0, 0], 0.0))
    }
    fn or(self, other: Self) -> Self {
        Self(record(|[a, b, _]| a.max(b), [self.0, other.0, 0], 0.0))
    }
    fn not(self) -> Self {
        Self(record(|[a, ..]| 1.0 - a, [self.0, 0, 0], 0.0))
    }
}

macro_rules! operators {
    ($($operator:ident $method:ident)*) => {$(
        impl $operator for Traced {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(record(|[a, b, _]| a.$method(b), [self.0, other.0, 0], 0.0))
            }
        }
    )*};
}
operators!(Add add Sub sub Mul mul Div div);

impl Neg for Traced {
    type Output = Self;
    fn neg(self) -> Self {
        Self(record(|[a, ..]| -a, [self.0, 0, 0], 0.0))
    }
}

macro_rules! functions {
    ($($function:ident)*) => {$(
        fn $function(self) -> Self {
            Self(record(|[a, ..]| Real::$function(a), [self.0, 0, 0], 0.0))
        }
    )*};
}
macro_rules! functions_of_two {
    ($($function:ident)*) => {$(
        fn $function(self, other: Self) -> Self {
            Self(record(|[a, b, _]| Real::$function(a, b), [self.0, other.0, 0], 0.0))
        }
    )*};
}

impl Real for Traced {
    type Mask = TracedMask;
    type Vec3 = Vector3<Self>;

    fn lit(value: f64) -> Self {
        Self(record(|_| f64::NAN, [usize::MAX; 3], value))
    }
    fn max_finite() -> Self {
        Self::lit(f64::MAX)
    }
    fn select(mask: TracedMask, yes: Self, no: Self) -> Self {
        let choose = |[mask, yes, no]: [f64; 3]| if mask == 1.0 { yes } else { no };
        Self(record(choose, [mask.0, yes.0, no.0], 0.0))
    }
    fn outside(self, _lower: f64, _upper: f64) -> Option<f64> {
        None
    }
    fn lt(self, other: Self) -> TracedMask {
        TracedMask(record(|[a, b, _]| as_mask(a < b), [self.0, other.0, 0], 0.0))
    }
    fn le(self, other: Self) -> TracedMask {
        TracedMask(record(|[a, b, _]| as_mask(a <= b), [self.0, other.0, 0], 0.0))
    }
    fn power_of_part(self, rest: Self, exponent: Self) -> Self {
        let power = |[part, rest, exponent]: [f64; 3]| Real::power_of_part(part, rest, exponent);
        Self(record(power, [self.0, rest.0, exponent.0], 0.0))
    }
    fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }
    fn sin_cos_turns(self) -> (Self, Self) {
        let sin = record(|[a, ..]| Real::sin_cos_turns(a).0, [self.0, 0, 0], 0.0);
        (Self(sin), Self(record(|[a, ..]| Real::sin_cos_turns(a).1, [self.0, 0, 0], 0.0)))
    }
    functions!(abs floor sqrt rsqrt exp exp_m1 ln ln_1p sin cos tan asin acos);
    functions!(angle_squared erf erfc erf_inv);
    functions_of_two!(min max copysign powf atan2 decay);
}
