//! Surfaces of planets and moons: dark grains that hide and scatter behind each other.

mod chandrasekhar;
mod hapke;
mod lommel_seeliger;
mod minnaert;
mod phase;
mod roughness;

pub use chandrasekhar::HFunction;
pub use hapke::Hapke;
pub use lommel_seeliger::LommelSeeliger;
pub use minnaert::Minnaert;
