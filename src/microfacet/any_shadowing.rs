use super::mixture_block;
use super::shadowing::{Draw, Kinks, Mirrored, Shadowing};
use super::smith::{SmithCorrelated, SmithSeparable};
use super::v_cavity::VCavity;
use crate::block::{DrawBlock, PairBlock, Plane};
use crate::direction::Pair;
use crate::distribution::{
    AnyDistribution, Smith, each_distribution, each_single_smith, each_smith,
};
use crate::real::{Real, call, lift};

/// Any shadowing of this crate for [any distribution](AnyDistribution), chosen at run time.
///
/// Smith's kinds need his Λ. Where that is not known of the distribution
/// ([`AnyDistribution::has_smith`] is false) they are the V-cavities, which suit all.
///
/// ```
/// use brdf::{AnyDistribution, AnyShadowing, Brdf, CookTorrance, Ggx, Schlick};
/// use glam::Vec3;
///
/// let (ggx, plastic) = (Ggx::new(0.3)?, Schlick::new(Vec3::splat(0.04))?);
/// let any = CookTorrance::new(AnyDistribution::from(ggx), plastic);
/// assert_eq!(any.shadowing(), &AnyShadowing::SmithCorrelated);
/// let known = CookTorrance::new(ggx, plastic);
/// assert_eq!(any.eval(Vec3::Z, Vec3::Z), known.eval(Vec3::Z, Vec3::Z));
/// # Ok::<(), brdf::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum AnyShadowing {
    /// [`VCavity`].
    VCavity,
    /// [`SmithCorrelated`].
    #[default]
    SmithCorrelated,
    /// [`SmithSeparable`].
    SmithSeparable,
}

lift!(AnyShadowing);

impl From<VCavity> for AnyShadowing {
    fn from(_: VCavity) -> Self {
        Self::VCavity
    }
}

impl From<SmithCorrelated> for AnyShadowing {
    fn from(_: SmithCorrelated) -> Self {
        Self::SmithCorrelated
    }
}

impl From<SmithSeparable> for AnyShadowing {
    fn from(_: SmithSeparable) -> Self {
        Self::SmithSeparable
    }
}

/// The same expression for every kind, with the distribution as the kind needs it; the last one for
/// V-cavities.
macro_rules! chosen {
    ($any:expr, $distribution:ident, $kind:ident => $result:expr, $cavity:expr) => {
        chosen!(each_smith; $any, $distribution, $kind => $result, $cavity)
    };
    ($each:ident; $any:expr, $distribution:ident, $kind:ident => $result:expr, $cavity:expr) => {
        match $any {
            AnyShadowing::VCavity => $cavity,
            AnyShadowing::SmithCorrelated => {
                let $kind = SmithCorrelated;
                $each!($distribution, one => { let $distribution = one; $result }, $cavity)
            }
            AnyShadowing::SmithSeparable => {
                let $kind = SmithSeparable;
                $each!($distribution, one => { let $distribution = one; $result }, $cavity)
            }
        }
    };
}

/// A function of blocks of mixtures for the kind of shadowing.
macro_rules! of_mixture {
    ($any:expr, $mixture:ident, $function:ident($($argument:expr),*)) => {
        match $any {
            AnyShadowing::SmithCorrelated if $mixture.as_smith().is_some() => {
                mixture_block::$function::<T, SmithCorrelated>($mixture, $($argument),*);
            }
            AnyShadowing::SmithSeparable if $mixture.as_smith().is_some() => {
                mixture_block::$function::<T, SmithSeparable>($mixture, $($argument),*);
            }
            _ => mixture_block::$function::<T, VCavity>($mixture, $($argument),*),
        }
    };
}

/// The same for blocks, with a function of the module of mixtures for these.
macro_rules! block {
    (
        $any:expr, $distribution:ident, $kind:ident => $result:expr,
        $mixture:ident($($argument:expr),*)
    ) => {
        match $distribution {
            AnyDistribution::Mixture(mixture) => {
                of_mixture!($any, mixture, $mixture($($argument),*));
            }
            _ => chosen!(
                each_single_smith; $any, $distribution, $kind => $result,
                {
                    let $kind = VCavity;
                    each_distribution!(
                        $distribution, one => { let $distribution = one; $result }
                    )
                }
            ),
        }
    };
}

impl<T: Real> Shadowing<T, AnyDistribution<T>> for AnyShadowing {
    #[inline(always)]
    fn visibility(&self, distribution: &AnyDistribution<T>, pair: &Pair<T>) -> T {
        chosen!(
            self, distribution, kind => kind.visibility(distribution, pair),
            VCavity.visibility(distribution, pair)
        )
    }

    #[inline(always)]
    fn masking(&self, distribution: &AnyDistribution<T>, pair: &Pair<T>) -> T {
        chosen!(
            self, distribution, kind => kind.masking(distribution, pair),
            VCavity.masking(distribution, pair)
        )
    }

    #[inline(always)]
    fn unshadowed(&self, distribution: &AnyDistribution<T>, pair: &Pair<T>) -> T {
        chosen!(
            self, distribution, kind => kind.unshadowed(distribution, pair),
            VCavity.unshadowed(distribution, pair)
        )
    }

    #[inline]
    fn sample_visible(&self, distribution: &AnyDistribution<T>, wo: T::Vec3, u: [T; 2]) -> T::Vec3 {
        match self {
            Self::VCavity => VCavity.sample_visible(distribution, wo, u),
            // Both kinds of Smith's draw the same normals.
            Self::SmithCorrelated | Self::SmithSeparable => each_smith!(
                distribution, one => one.sample_visible(wo, u),
                VCavity.sample_visible(distribution, wo, u)
            ),
        }
    }

    #[inline]
    fn sample_visible_along(
        &self,
        distribution: &AnyDistribution<T>,
        wo: T::Vec3,
        u: [T; 2],
    ) -> T::Vec3 {
        match self {
            Self::VCavity => VCavity.sample_visible_along(distribution, wo, u),
            Self::SmithCorrelated | Self::SmithSeparable => each_smith!(
                distribution, one => one.sample_visible_along(wo, u),
                VCavity.sample_visible_along(distribution, wo, u)
            ),
        }
    }

    fn kinks(&self, distribution: &AnyDistribution<T>) -> Option<Kinks> {
        Some(
            chosen!(self, distribution, _kind => { let _ = distribution; Kinks::None }, Kinks::Grooves),
        )
    }

    #[inline]
    fn mirrored(&self, distribution: &AnyDistribution<T>, wi: T::Vec3, wo: T::Vec3) -> Mirrored<T> {
        chosen!(
            self, distribution, kind => call!(|| kind.mirrored(distribution, wi, wo)),
            each_distribution!(distribution, one => call!(|| VCavity.mirrored(one, wi, wo)))
        )
    }

    #[inline]
    fn pdf(&self, distribution: &AnyDistribution<T>, wi: T::Vec3, wo: T::Vec3) -> T {
        chosen!(
            self, distribution, kind => call!(|| kind.pdf(distribution, wi, wo)),
            each_distribution!(distribution, one => call!(|| VCavity.pdf(one, wi, wo)))
        )
    }

    #[inline]
    fn mirrored_pdf(
        &self,
        distribution: &AnyDistribution<T>,
        wi: T::Vec3,
        wo: T::Vec3,
    ) -> (Mirrored<T>, T) {
        chosen!(
            self, distribution, kind => call!(|| kind.mirrored_pdf(distribution, wi, wo)),
            each_distribution!(distribution, one => call!(|| VCavity.mirrored_pdf(one, wi, wo)))
        )
    }

    #[inline]
    fn mirror(&self, distribution: &AnyDistribution<T>, wo: T::Vec3, h: T::Vec3) -> Draw<T> {
        chosen!(
            self, distribution, kind => call!(|| kind.mirror(distribution, wo, h)),
            each_distribution!(distribution, one => call!(|| VCavity.mirror(one, wo, h)))
        )
    }

    fn sample_visible_block(
        &self,
        distribution: &AnyDistribution<T>,
        draws: DrawBlock<'_, T>,
        h: &mut [Plane<T>; 4],
    ) {
        chosen!(
            self, distribution, kind => kind.sample_visible_block(distribution, draws, h),
            VCavity.sample_visible_block(distribution, draws, h)
        );
    }

    fn mirrored_block(
        &self,
        distribution: &AnyDistribution<T>,
        pairs: PairBlock<'_, T>,
        mirrored: &mut [Plane<T>; 2],
    ) {
        block!(
            self, distribution, kind => kind.mirrored_block(distribution, pairs, mirrored),
            mirrored(pairs, mirrored)
        );
    }

    fn pdf_block(
        &self,
        distribution: &AnyDistribution<T>,
        pairs: PairBlock<'_, T>,
        densities: &mut Plane<T>,
    ) {
        block!(
            self, distribution, kind => kind.pdf_block(distribution, pairs, densities),
            pdf(pairs, densities)
        );
    }

    fn mirrored_pdf_block(
        &self,
        distribution: &AnyDistribution<T>,
        pairs: PairBlock<'_, T>,
        mirrored: &mut [Plane<T>; 2],
        densities: &mut Plane<T>,
    ) {
        block!(
            self, distribution,
            kind => kind.mirrored_pdf_block(distribution, pairs, mirrored, densities),
            mirrored_pdf(pairs, mirrored, densities)
        );
    }

    fn mirror_block(
        &self,
        distribution: &AnyDistribution<T>,
        draws: DrawBlock<'_, T>,
        wi_pdf: &mut [Plane<T>; 4],
        weight: &mut [Plane<T>; 2],
    ) {
        block!(
            self, distribution, kind => kind.mirror_block(distribution, draws, wi_pdf, weight),
            mirror(draws, wi_pdf, weight)
        );
    }
}
