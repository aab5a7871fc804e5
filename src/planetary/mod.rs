//! Surfaces of planets and moons: dark grains that hide and scatter behind each other.

mod lommel_seeliger;
mod minnaert;
mod phase;

pub use lommel_seeliger::LommelSeeliger;
pub use minnaert::Minnaert;
