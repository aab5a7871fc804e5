//! Glossy models without microfacets: lobes around the mirror direction or the half vector.

mod ashikhmin_shirley;
mod blinn_phong;
mod classic_phong;
mod cosine_power;
mod lafortune;
mod mirror;
mod phong;
mod schlick_1994;
mod schlick_layer;
mod schlick_power;
mod schlick_rational;
mod ward;

pub use ashikhmin_shirley::AshikhminShirley;
pub use blinn_phong::BlinnPhong;
pub use classic_phong::ClassicPhong;
#[cfg(feature = "serde")]
pub(crate) use lafortune::check_lobes;
pub use lafortune::{Lafortune, LafortuneLobe, MAX_LOBES};
pub use phong::Phong;
pub use schlick_1994::Schlick1994;
#[cfg(feature = "serde")]
pub(crate) use schlick_1994::check_schlick_layers;
pub use schlick_layer::{Schlick1994Layer, SchlickShadowing};
pub use schlick_power::SchlickPower;
pub use schlick_rational::{schlick_beckmann, schlick_masking};
pub use ward::{Ward, WardForm};
