use core::f64::consts::{LN_2, SQRT_2};

use crate::parameter::model;
use crate::real::{Mask, Real};

model! {
    /// The three distributions that Blinn compared in 1977, as printed: not normalised, with maximum
    /// 1, and scaled so that all of them fall to ½ at the same angle β.
    ///
    /// # Formula
    /// ```text
    /// D₁ = cos^c₁ θ_h                            c₁ = −ln 2/ln cosβ      Phong
    /// D₂ = exp(−(c₂ θ_h)²)                       c₂ = √(ln 2)/β          Torrance–Sparrow
    /// D₃ = (c₃²/(cos²θ_h (c₃² − 1) + 1))²        c₃² = (cos²β − 1)/(cos²β − √2)   Trowbridge–Reitz
    /// ```
    parameters {
        beta: T, HALF_WIDTH, "β", "angle at which D = ½, radians";
    }
    constants {
        let sin_squared = beta.sin().squared();
        /// c₁, the exponent of D₁.
        c1: T = T::lit(2.0 * LN_2) / beta.tan().squared().ln_1p();
        /// c₂, the inverse of the angle at which D₂ falls to 1/e.
        c2: T = T::lit(LN_2.sqrt()) / beta;
        /// c₃².
        c3_squared: T = sin_squared / (T::lit(SQRT_2 - 1.0) + sin_squared);
    }
    /// | θ_h | `theta_h` | angle between the half vector and the normal, radians | 0 … π/2 |
    ///
    /// For reflection use the normalised forms: [`Blinn`](crate::Blinn) with exponent c₁,
    /// [`Gaussian`](crate::Gaussian) with roughness 1/c₂, [`Ggx`](crate::Ggx) with roughness c₃, which
    /// is D₃/(π c₃²). Beyond ±π/2 all three are zero.
    ///
    /// # Sources
    /// J. F. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977,
    /// [doi:10.1145/563858.563893](https://doi.org/10.1145/563858.563893).
    ///
    /// ```
    /// use brdf::Blinn1977;
    ///
    /// let blinn = Blinn1977::new(0.3_f64)?;
    /// assert!((blinn.d1(0.3) - 0.5).abs() < 1e-15);
    /// assert!((blinn.d2(0.3) - 0.5).abs() < 1e-15);
    /// assert!((blinn.d3(0.3) - 0.5).abs() < 1e-15);
    /// # Ok::<(), brdf::ParameterError>(())
    /// ```
    pub struct Blinn1977<T = f32>;

    /// The three distributions with the given half-width angle in radians.
    pub fn new;
}

impl<T: Real> Blinn1977<T> {
    /// The exponent of D₁.
    #[must_use]
    pub fn c1(&self) -> T {
        self.c1
    }

    /// The inverse of the angle in radians at which D₂ falls to 1/e.
    #[must_use]
    pub fn c2(&self) -> T {
        self.c2
    }

    /// The ratio of the axes of the ellipsoid of D₃ (which Blinn calls its eccentricity): 0 for a
    /// mirror, 1 for a sphere.
    #[must_use]
    pub fn c3(&self) -> T {
        self.c3_squared.sqrt()
    }

    /// Phong's power of the cosine.
    #[inline(always)]
    #[must_use]
    pub fn d1(&self, theta_h: T) -> T {
        let (sin, cos) = theta_h.sin_cos();
        let above = above(theta_h, cos);
        let tan_squared = (sin / T::select(above, cos, T::one())).squared();
        let power = (T::lit(-0.5) * self.c1 * tan_squared.ln_1p()).exp();
        power.only_where(above)
    }

    /// Torrance and Sparrow's normal distribution of the angle.
    #[inline(always)]
    #[must_use]
    pub fn d2(&self, theta_h: T) -> T {
        let above = above(theta_h, theta_h.cos());
        let exponent = (self.c2 * theta_h).squared().min(T::lit(1e4));
        ((-exponent).exp()).only_where(above)
    }

    /// Trowbridge and Reitz's ellipsoids.
    #[inline(always)]
    #[must_use]
    pub fn d3(&self, theta_h: T) -> T {
        let (sin, cos) = theta_h.sin_cos();
        // cos²θ_h (c₃² − 1) + 1 without the difference.
        let sum = sin.squared() + self.c3_squared * cos.squared();
        ((self.c3_squared / sum).squared()).only_where(above(theta_h, cos))
    }
}

/// Where an angle is below π/2, exactly, and not a turn beyond.
#[inline(always)]
fn above<T: Real>(theta_h: T, cos: T) -> T::Mask {
    cos.gt(T::zero()).and(theta_h.abs().lt(T::lit(2.0)))
}
