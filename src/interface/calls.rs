//! A call for each model, and not the code of all of them in one function. A module for each of them, for
//! compilers make one unit of what a module has. As closures, which carry their arguments in memory, calls of
//! light models take half as long again.

pub(super) mod eval {
    use crate::bsdf::{Bsdf, TransportMode};
    use crate::real::Real;

    #[inline(never)]
    pub(in crate::interface) fn of<T: Real, M: Bsdf<T>>(
        model: &M,
        wi: T::Vec3,
        wo: T::Vec3,
        mode: TransportMode,
    ) -> M::Color {
        model.eval(wi, wo, mode)
    }
}

pub(super) mod pdf {
    use crate::bsdf::{Bsdf, TransportMode};
    use crate::real::Real;

    #[inline(never)]
    pub(in crate::interface) fn of<T: Real, M: Bsdf<T>>(
        model: &M,
        wi: T::Vec3,
        wo: T::Vec3,
        mode: TransportMode,
    ) -> T {
        model.pdf(wi, wo, mode)
    }
}

pub(super) mod eval_pdf {
    use crate::bsdf::{Bsdf, TransportMode};
    use crate::real::Real;

    #[inline(never)]
    pub(in crate::interface) fn of<T: Real, M: Bsdf<T>>(
        model: &M,
        wi: T::Vec3,
        wo: T::Vec3,
        mode: TransportMode,
    ) -> (M::Color, T) {
        model.eval_pdf(wi, wo, mode)
    }
}

pub(super) mod sample {
    use crate::bsdf::{Bsdf, BsdfSample, TransportMode};
    use crate::real::Real;

    #[inline(never)]
    pub(in crate::interface) fn of<T: Real, M: Bsdf<T>>(
        model: &M,
        wo: T::Vec3,
        u: [T; 3],
        mode: TransportMode,
    ) -> BsdfSample<T, M::Color> {
        model.sample(wo, u, mode)
    }
}

pub(super) mod specular {
    use crate::bsdf::{Bsdf, Lobes, TransportMode};
    use crate::real::Real;

    #[inline(never)]
    pub(in crate::interface) fn of<T: Real, M: Bsdf<T>>(
        model: &M,
        wo: T::Vec3,
        mode: TransportMode,
    ) -> Lobes<T, M::Color> {
        model.specular(wo, mode)
    }
}
