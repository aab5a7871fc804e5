//! Glossy models without microfacets: lobes around the mirror direction or the half vector.

mod ashikhmin_shirley;
mod blinn_phong;
mod classic_phong;
mod cosine_power;
mod lafortune;
mod mirror;
mod phong;
mod schlick_power;
mod ward;

pub use ashikhmin_shirley::AshikhminShirley;
pub use blinn_phong::BlinnPhong;
pub use classic_phong::ClassicPhong;
#[cfg(feature = "serde")]
pub(crate) use lafortune::check_lobes;
pub use lafortune::{Lafortune, LafortuneLobe, MAX_LOBES};
pub use phong::Phong;
pub use schlick_power::SchlickPower;
pub use ward::{Ward, WardForm};
