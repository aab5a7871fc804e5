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
