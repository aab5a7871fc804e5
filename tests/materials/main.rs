//! Measured reality: the embedded materials, the colours of spectra, models fitted to surfaces, and
//! tables of integrals.

mod colorimetry;
mod colours;
mod ellipsometry;
mod fit_minima;
mod fit_parameters;
mod fit_refusals;
mod fits;
mod fresnel_reference;
mod generate;
mod lookup;
mod own;
mod plausible;
mod samples;
mod shortcut;
mod surroundings;
mod tables;
