//! The seeded bugs, by room of the crate.

mod diffuse;
mod fresnel;
mod glossy;
mod microfacet;

use super::mutant::Mutant;

/// All of them.
pub fn mutants() -> impl Iterator<Item = &'static Mutant> {
    diffuse::MUTANTS
        .iter()
        .chain(&glossy::MUTANTS)
        .chain(&microfacet::MUTANTS)
        .chain(&fresnel::MUTANTS)
}
