//! Numbers of every kind.

use arbitrary::{Arbitrary, Result, Unstructured};

/// Any number at all; often one that a parameter can have.
#[derive(Clone, Copy, Debug)]
pub struct Number(pub f64);

/// Where formulas change their ways.
const AWKWARD: [f64; 24] = [
    0.0,
    -0.0,
    5e-324,
    1e-45,
    1e-40,
    1e-38,
    1e-30,
    1e-20,
    1e-8,
    1e-7,
    0.3,
    0.5,
    1.0 - f64::EPSILON / 2.0,
    1.0 - 1.0 / 16777216.0,
    1.0,
    1.0 + f64::EPSILON,
    1.0 + 1.0 / 8388608.0,
    std::f64::consts::FRAC_PI_2,
    1e4,
    1e8,
    1e10,
    3.4e38,
    f64::INFINITY,
    f64::NAN,
];

impl<'a> Arbitrary<'a> for Number {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        Ok(Self(match u.int_in_range(0..=7)? {
            0 => f64::from_bits(u.arbitrary()?),
            1 => f64::from(f32::from_bits(u.arbitrary()?)),
            2 => *u.choose(&AWKWARD)?,
            3 => -*u.choose(&AWKWARD)?,
            4 | 5 => f64::from(u.arbitrary::<u32>()?) / f64::from(u32::MAX),
            // The ranges of roughness, index and exponent, a bit beyond them too.
            _ => 10_f64.powf(f64::from(u.arbitrary::<i32>()?) / 2e8),
        }))
    }
}

/// A red, a green and a blue, often gray.
#[derive(Clone, Copy, Debug)]
pub struct Channels(pub [f64; 3]);

impl<'a> Arbitrary<'a> for Channels {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let Number(first) = u.arbitrary()?;
        Ok(Self(if u.arbitrary()? {
            [first; 3]
        } else {
            [first, Number::arbitrary(u)?.0, Number::arbitrary(u)?.0]
        }))
    }
}
