//! A call for each model, and not the code of all of them in one function. A module for each of them, for
//! compilers make one unit of what a module has.

pub(super) mod eval {
    use crate::brdf::Brdf;
    use crate::real::Real;

    #[inline(never)]
    pub(in crate::any) fn of<T: Real, M: Brdf<T>>(model: &M, wi: T::Vec3, wo: T::Vec3) -> M::Color {
        model.eval(wi, wo)
    }
}

pub(super) mod pdf {
    use crate::brdf::Brdf;
    use crate::real::Real;

    #[inline(never)]
    pub(in crate::any) fn of<T: Real, M: Brdf<T>>(model: &M, wi: T::Vec3, wo: T::Vec3) -> T {
        model.pdf(wi, wo)
    }
}

pub(super) mod eval_pdf {
    use crate::brdf::Brdf;
    use crate::real::Real;

    #[inline(never)]
    pub(in crate::any) fn of<T: Real, M: Brdf<T>>(
        model: &M,
        wi: T::Vec3,
        wo: T::Vec3,
    ) -> (M::Color, T) {
        model.eval_pdf(wi, wo)
    }
}

pub(super) mod sample {
    use crate::brdf::{Brdf, Sample};
    use crate::real::Real;

    #[inline(never)]
    pub(in crate::any) fn of<T: Real, M: Brdf<T>>(
        model: &M,
        wo: T::Vec3,
        u: [T; 2],
    ) -> Sample<T, M::Color> {
        model.sample(wo, u)
    }
}
