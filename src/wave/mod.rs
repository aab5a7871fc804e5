//! Wave optics: surfaces whose heights are comparable with the wavelength, where a specular lobe remains.

mod beckmann_kirchhoff;
mod he;
mod lambert_w;
mod masking;
mod orders;
mod polarized;
mod proposal;
mod scattering;
mod series;
mod surface;

pub use beckmann_kirchhoff::BeckmannKirchhoff;
pub use he::He1991;
pub use masking::Masking;
