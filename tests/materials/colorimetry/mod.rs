//! Spectra to colours: the tables of the observer and the illuminants, and what is made of them.

mod colors;
mod generate;
