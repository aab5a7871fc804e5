//! Limits, equivalent forms, energy and published mistakes of every model.

mod derivatives;
mod distribution_samples;
mod distributions;
mod dual;
mod equivalences;
mod facets;
mod frame;
mod fresnel;
mod fresnel_approximations;
mod fresnel_averages;
mod fresnel_errata;
mod fresnel_precision;
mod fresnel_robustness;
mod hemisphere;
mod known_failures;
mod lobes;
mod microfacet;
mod polarization;
mod polarized_facets;
mod signs;
mod spectra;
mod sums;
