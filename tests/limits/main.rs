//! Limits, equivalent forms, energy and published mistakes of every model.

#[path = "../common/mod.rs"]
mod common;

mod distribution_samples;
mod distributions;
mod equivalences;
mod fresnel;
mod fresnel_approximations;
mod fresnel_averages;
mod fresnel_errata;
mod fresnel_precision;
mod fresnel_robustness;
mod hemisphere;
mod lobes;
mod microfacet;
mod signs;
mod sums;
