//! Every formula against reference values of 50 digits, against its integrals and its limits.
//!
//! Each check is written once, over any number whose value is known: it runs over `f64` for what the
//! formulas say, and over numbers that err for whether it would notice if they said something else.

mod directions;
mod distributions;
mod fresnel;
mod interfaces;
mod limits;
mod lobes;
mod microfacet;
mod planetary;
mod polarization;
mod reference;
mod wave;

use std::error::Error;

use brdf::{Real, Vector};
use glam::DVec3;

use crate::faulty::Faulty;
pub use reference::unread;

/// What a check says: nothing, or what is wrong in words.
pub type Verdict = Result<(), Box<dyn Error>>;

pub(crate) fn fail(what: String) -> Verdict {
    Err(what.into())
}

/// A check with its name.
pub type Check = (&'static str, fn() -> Verdict);

/// All of them in double precision.
pub fn double() -> Vec<Check> {
    all::<f64>()
}

/// All of them over numbers that err, quick ones first.
pub(crate) fn faulty() -> Vec<Check> {
    all::<Faulty>()
}

fn all<T: Number>() -> Vec<Check> {
    [
        &fresnel::all::<T>()[..],
        &directions::all::<T>(),
        &distributions::all::<T>(),
        &microfacet::all::<T>(),
        &lobes::all::<T>(),
        &planetary::all::<T>(),
        &polarization::all::<T>(),
        &interfaces::all::<T>(),
        &wave::all::<T>(),
        &limits::all::<T>(),
    ]
    .concat()
}

/// A number whose value is known.
trait Number: Real + Into<f64> {}
impl<T: Real + Into<f64>> Number for T {}

/// A direction of double precision in another number.
fn vector<T: Real>(w: DVec3) -> T::Vec3 {
    Vector::new(T::lit(w.x), T::lit(w.y), T::lit(w.z))
}

/// A direction in double precision.
fn plain<T: Number>(w: T::Vec3) -> DVec3 {
    DVec3::new(w.x().into(), w.y().into(), w.z().into())
}

fn near(what: &str, got: impl Into<f64>, want: f64, tolerance: f64) -> Verdict {
    let got: f64 = got.into();
    let off = (got - want).abs();
    if off <= tolerance { Ok(()) } else { fail(format!("{what}: {got} for {want}")) }
}
