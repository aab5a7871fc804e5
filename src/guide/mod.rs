//! Pages that say more than the front page.

// They are the files of the folder `docs`, which refer to each other and to pictures by labels that
// they define at their end. Definitions in front of them count instead: so in this documentation, to
// which no other files belong, pages are modules and pictures are data.

#[cfg_attr(not(doctest), doc = include_str!("links.md"))]
#[doc = include_str!("../../docs/certificate.md")]
pub mod certificate {}

#[cfg_attr(not(doctest), doc = include_str!("links.md"))]
#[doc = include_str!("../../docs/evaluate.md")]
pub mod evaluate {}

#[cfg_attr(not(doctest), doc = include_str!("links.md"))]
#[cfg_attr(not(doctest), doc = include_str!("pictures.md"))]
#[doc = include_str!("../../docs/history.md")]
pub mod history {}

#[cfg_attr(not(doctest), doc = include_str!("links.md"))]
#[cfg_attr(not(doctest), doc = include_str!("pictures.md"))]
#[doc = include_str!("../../docs/measured-fits.md")]
pub mod measured_fits {}

#[cfg_attr(not(doctest), doc = include_str!("links.md"))]
#[doc = include_str!("../../docs/models.md")]
pub mod models {}

#[cfg_attr(not(doctest), doc = include_str!("links.md"))]
#[doc = include_str!("../../docs/numbers.md")]
pub mod numbers {}

#[cfg_attr(not(doctest), doc = include_str!("links.md"))]
#[doc = include_str!("../../docs/refractive-indices.md")]
pub mod refractive_indices {}

#[cfg_attr(not(doctest), doc = include_str!("links.md"))]
#[doc = include_str!("../../docs/shaders.md")]
pub mod shaders {}

#[cfg_attr(not(doctest), doc = include_str!("links.md"))]
#[doc = include_str!("../../docs/speed.md")]
pub mod speed {}
