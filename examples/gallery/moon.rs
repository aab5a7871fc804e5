//! The moon and surfaces that stand in for it.

use brdf::{
    Brdf, Color, Hapke, Lambert, LommelSeeliger, Minnaert, OrenNayarFull, ParameterError, Real,
};
use glam::Vec3;

/// w, ξ, B₀, h and θ̄: found by least squares on the measured curve and rounded.
const MOON: [f64; 5] = [0.22, -0.2, 1.96, 0.06, 0.28];

/// A model with its name.
pub type Named<T, C> = (&'static str, Box<dyn Brdf<T, Color = C>>);

/// What the models reflect at full moon in the middle of the disc, sr⁻¹.
///
/// # Errors
/// None but those of the constants.
pub fn middle() -> Result<f32, ParameterError> {
    let moon = moon::<f32, Vec3>()?;
    Ok(moon.eval(Vec3::Z, Vec3::Z).x)
}

fn moon<T: Real, C: Color<T>>() -> Result<Hapke<C, T>, ParameterError> {
    let [w, xi, b0, h, theta_bar] = MOON.map(T::lit);
    Hapke::new(C::splat(w))?.with_phase(xi)?.with_surge(b0, h)?.with_roughness(theta_bar)
}

/// Five models, equally bright in the middle of the disc at full moon.
///
/// # Errors
/// None but those of the constants.
pub fn models<T: Real, C: Color<T> + 'static>() -> Result<Vec<Named<T, C>>, ParameterError> {
    let value = |model: &dyn Brdf<T, Color = C>| {
        let normal = brdf::from_spherical::<T, T::Vec3>(T::zero(), T::zero());
        model.eval(normal, normal).mean()
    };
    let hapke = moon()?;
    let middle = value(&hapke);
    // What a reflectance must be, when one of `tried` makes `got`.
    let scaled = |tried: T, got: T| C::splat(tried * (middle / got));
    let (try_this, grains) = (T::lit(0.15), T::lit(MOON[1]));
    let lambert = Lambert::new(C::splat(try_this))?;
    let flat = |albedo| Minnaert::new(albedo, T::lit(0.5));
    let dust = |w| LommelSeeliger::new(w, grains);
    // Light that facets send to each other grows as the square of the albedo: in two steps.
    let rough = |albedo| OrenNayarFull::new(albedo, T::lit(0.5));
    let first = scaled(try_this, value(&rough(C::splat(try_this))?));
    let second = scaled(first.mean(), value(&rough(first)?));
    Ok(vec![
        ("Lambert", Box::new(Lambert::new(scaled(try_this, value(&lambert)))?)),
        ("Oren–Nayar, σ = 0.5", Box::new(rough(second)?)),
        ("Minnaert, k = ½", Box::new(flat(scaled(try_this, value(&flat(C::splat(try_this))?)))?)),
        (
            "Lommel–Seeliger, ξ = −0.2",
            Box::new(dust(scaled(try_this, value(&dust(C::splat(try_this))?)))?),
        ),
        ("Hapke", Box::new(hapke)),
    ])
}
