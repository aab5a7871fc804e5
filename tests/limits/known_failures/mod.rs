//! What went wrong in other renderers and libraries, and must not go wrong here: each test names
//! the reports.

mod directions;
mod distributions;
mod fresnel;
mod models;
mod sampling;

/// A test for `f32` and one for `f64`, of a function over the number.
macro_rules! in_both_numbers {
    ($($(#[$meta:meta])* $test:ident($function:ident);)*) => {$(
        $(#[$meta])*
        mod $test {
            #[test]
            fn in_f32() {
                super::$function::<f32>();
            }
            #[test]
            fn in_f64() {
                super::$function::<f64>();
            }
        }
    )*};
}
use in_both_numbers;

/// What the tests ask of a number.
trait Number: brdf::Real<Mask = bool> + Into<f64> + PartialOrd {
    /// The largest number below 1.
    const BELOW_ONE: f64;
    /// The distance of 1 from the next number.
    const EPSILON: f64;
    /// The smallest number above 0.
    const LEAST: f64;

    fn double(self) -> f64 {
        self.into()
    }
}

impl Number for f32 {
    const BELOW_ONE: f64 = 1.0 - 1.0 / 16777216.0;
    const EPSILON: f64 = 1.0 / 8388608.0;
    const LEAST: f64 = 1.0e-45;
}

impl Number for f64 {
    const BELOW_ONE: Self = 1.0 - Self::EPSILON / 2.0;
    const EPSILON: Self = Self::EPSILON;
    const LEAST: Self = 5e-324;
}

fn vector<T: brdf::Real>(x: f64, y: f64, z: f64) -> T::Vec3 {
    brdf::Vector::new(T::lit(x), T::lit(y), T::lit(z))
}

/// Asserts that a number is within a relative error of what it should be.
#[track_caller]
fn assert_near<T: Number>(got: T, want: f64, relative: f64) {
    let got: f64 = got.into();
    assert!((got - want).abs() <= relative * want.abs(), "{got} instead of {want}");
}
