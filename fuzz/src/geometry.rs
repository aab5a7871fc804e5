//! Directions and pairs of them.

use arbitrary::{Arbitrary, Result, Unstructured};

use crate::numbers::Number;

/// A direction, often grazing, close to the normal, or no direction at all.
#[derive(Clone, Copy, Debug)]
pub struct Direction(pub [f64; 3]);

impl<'a> Arbitrary<'a> for Direction {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        if u.ratio(1, 8)? {
            let [Number(x), Number(y), Number(z)] = u.arbitrary()?;
            return Ok(Self([x, y, z]));
        }
        let Number(cos) = u.arbitrary()?;
        let cos = cos.clamp(-1.0, 1.0);
        let azimuth = f64::from(u.arbitrary::<i16>()?) * 1e-4;
        let length = 1.0 + if u.ratio(1, 8)? { f64::from(u.arbitrary::<i8>()?) / 2e4 } else { 0.0 };
        let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
        Ok(Self([sin * azimuth.cos(), sin * azimuth.sin(), cos].map(|c| c * length)))
    }
}

/// `wi` and `wo`, often related to each other.
#[derive(Clone, Copy, Debug)]
pub struct Directions(pub [[f64; 3]; 2]);

impl<'a> Arbitrary<'a> for Directions {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let Direction(wo) = u.arbitrary()?;
        let wi = match u.int_in_range(0..=7)? {
            0 => [-wo[0], -wo[1], wo[2]],
            1 => wo,
            2 => wo.map(|c| -c),
            3 => {
                // Close to the mirror direction, where narrow lobes live.
                let [Number(x), Number(y)] = u.arbitrary()?;
                [-wo[0] + x * 1e-3, -wo[1] + y * 1e-3, wo[2]]
            }
            _ => Direction::arbitrary(u)?.0,
        };
        Ok(Self([wi, wo]))
    }
}
