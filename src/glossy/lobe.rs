//! What all lobes have: a colour and an exponent.

use crate::error::{ParameterError, range};
use crate::real::{Color, Real, unsigned};

/// Checks both and gives the colour back, without a sign where it is zero.
pub(super) fn check_lobe<T: Real, C: Color<T>>(
    specular: C,
    exponent: T,
) -> Result<C, ParameterError> {
    range::UNIT.check("specular", specular)?;
    range::EXPONENT.check("exponent", exponent)?;
    Ok(unsigned(specular))
}
