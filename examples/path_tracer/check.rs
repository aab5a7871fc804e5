//! What is known of traced light without tracing it.

use std::error::Error;
use std::fmt;

use brdf::materials::GOLD;
use brdf::{Brdf, Color, CookTorrance, Fresnel, Ggx, Illuminant, Lambert, Observer, Spectrum};
use brdf::{Constant, colorimetry};
use glam::Vec3;
use rayon::prelude::*;

use crate::draws::Draws;
use crate::light::Lamp;
use crate::path::{Drawn, radiance_by};
use crate::plastic::Plastic;
use crate::scene::{Object, Scene};
use crate::shape::{Ray, Shape};
use crate::spectral::{BLACK, Spectral, WAVELENGTHS, WHITE, wavelengths};

/// A model that several objects are made of.
trait Model: Brdf<Color = Spectral> + Copy + 'static {}
impl<M: Brdf<Color = Spectral> + Copy + 'static> Model for M {}

/// Paths of one seed, and seeds.
const PATHS: u32 = 2048;
const SEEDS: u32 = 16;

/// A mean over many paths with its standard error, which is that between the seeds.
#[derive(Clone, Copy)]
struct Estimate {
    mean: f64,
    error: f64,
}

impl Estimate {
    fn of(values: &[f64]) -> Self {
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
        Self { mean, error: (squares / (count * (count - 1.0))).sqrt() }
    }

    /// Within five standard errors and the rounding of sums of `f32`.
    fn is(&self, other: Self) -> bool {
        (self.mean - other.mean).abs() < 5.0 * self.error.hypot(other.error) + 1e-5
    }
}

impl fmt::Display for Estimate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.5} ± {:.5}", self.mean, self.error)
    }
}

/// The mean radiance, over the wavelengths too, that a ray meets.
fn estimate(drawn: Drawn, scene: &Scene, ray: Ray) -> Estimate {
    let path =
        |seed, path| f64::from(radiance_by(drawn, scene, ray, &mut Draws::new(path, seed)).mean());
    let mean = |seed| (0..PATHS).map(|number| path(seed, number)).sum::<f64>() / f64::from(PATHS);
    Estimate::of(&(0..SEEDS).into_par_iter().map(mean).collect::<Vec<_>>())
}

/// A bowl on a floor, two lamps, and a ray into the bowl.
fn bowl(material: impl Model, surroundings: Spectral, lamp: Spectral) -> (Scene, Ray) {
    let object =
        |shape, height| Object { shape, center: Vec3::Y * height, material: Box::new(material) };
    let objects = vec![
        object(Shape::Floor, 0.0),
        object(Shape::Bowl { radius: 0.9, lip: 0.0, half_wall: 0.1 }, 1.0),
    ];
    let target = Vec3::new(0.0, 0.5, 0.0);
    let lamps = vec![
        Lamp::facing(target, Vec3::new(-2.0, 4.0, 1.0), [2.0, 2.0], lamp),
        Lamp::facing(target, Vec3::new(2.0, 3.0, 2.0), [0.5, 1.0], lamp),
    ];
    let eye = Vec3::new(0.5, 3.0, 4.0);
    let ray = Ray { origin: eye, direction: (target - eye).normalize() };
    (Scene { objects, lamps, surroundings }, ray)
}

fn verdict(holds: bool, what: &str, found: &str) -> Result<(), String> {
    println!("{} {what}: {found}", if holds { "  ok" } else { "FAIL" });
    if holds { Ok(()) } else { Err(format!("{what}: {found}")) }
}

/// White surfaces, however they see each other, in light of radiance 1 from everywhere: all is 1.
fn furnace(name: &str, white: impl Model) -> Result<(), Box<dyn Error>> {
    let (scene, ray) = bowl(white, WHITE, WHITE);
    let found = estimate(Drawn::Both, &scene, ray);
    let one = Estimate { mean: 1.0, error: 0.0 };
    Ok(verdict(found.is(one), &format!("white furnace, {name}"), &found.to_string())?)
}

/// Whichever way directions are drawn, the light is the same; only the noise differs.
fn strategies(name: &str, model: impl Model) -> Result<(), Box<dyn Error>> {
    let (scene, ray) = bowl(model, BLACK, WHITE * 5.0);
    let both = estimate(Drawn::Both, &scene, ray);
    for (drawn, by) in [(Drawn::Lamps, "lamps"), (Drawn::Surface, "surface")] {
        let one = estimate(drawn, &scene, ray);
        let found = format!("{one}, from both {both}");
        verdict(one.is(both), &format!("{name}, drawn from the {by}"), &found)?;
    }
    Ok(())
}

/// Sixteen wavelengths are enough for the colour of gold.
fn gold() -> Result<(), Box<dyn Error>> {
    let few = Observer::new(Illuminant::D65, WAVELENGTHS)?;
    let all = Observer::new(Illuminant::D65, colorimetry::WAVELENGTHS)?;
    let seen: Vec3 = few.linear_srgb(GOLD.conductor(wavelengths())?.reflectance(1.0));
    let spectrum = Spectrum(colorimetry::WAVELENGTHS);
    let exact = all.linear_srgb(GOLD.conductor(spectrum)?.reflectance(1.0)).as_vec3();
    let error = (seen - exact).abs().max_element();
    let found = format!("{seen:.3}, with all {exact:.3}");
    Ok(verdict(error < 0.01, "gold at sixteen wavelengths", &found)?)
}

pub fn all() -> Result<(), Box<dyn Error>> {
    let mirror = CookTorrance::new(Ggx::new(0.1)?, Constant::new(WHITE * 0.9)?);
    let (paper, gray) = (Lambert::new(WHITE)?, Lambert::new(WHITE * 0.5)?);
    let plastic = Plastic::new(WHITE, 0.3, 1.5)?;
    furnace("paper", paper)?;
    furnace("white plastic", plastic)?;
    strategies("gray", gray)?;
    strategies("mirror, α = 0.1", mirror)?;
    gold()
}
