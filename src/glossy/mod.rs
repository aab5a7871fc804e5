//! Glossy models without microfacets: lobes around the mirror direction or the half vector.

mod blinn_phong;
mod classic_phong;
mod cosine_power;
mod mirror;
mod phong;
mod schlick_power;

pub use blinn_phong::BlinnPhong;
pub use classic_phong::ClassicPhong;
pub use phong::Phong;
pub use schlick_power::SchlickPower;

use crate::error::{ParameterError, range};
use crate::real::{Color, Real};

/// The parameters that all lobes have.
fn check_lobe<T: Real, C: Color<T>>(specular: C, exponent: T) -> Result<(), ParameterError> {
    ParameterError::check("specular", range::UNIT, |lower, upper| specular.outside(lower, upper))?;
    ParameterError::check("exponent", range::EXPONENT, |lower, upper| {
        exponent.outside(lower, upper)
    })
}
