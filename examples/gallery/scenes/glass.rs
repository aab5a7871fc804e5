//! Glass, bubbles and oxide: light that passes, and films.

use std::error::Error;

use brdf::colorimetry::WAVELENGTHS;
use brdf::description::{BsdfDescription, FresnelDescription};
use brdf::materials::{N_BK7_GLASS_SCHOTT, WATER_20_C_DAIMON_2007};
use brdf::polarization::{Complex, Layer};
use brdf::{
    AnyFresnel, BelcourBarla, CookTorrance, Fresnel, Ggx, Illuminant, Observer, Spectrum, Stack,
};
use glam::{DVec3, Vec3};

use super::{Scene, material};
use crate::environment::Environment;
use crate::light::Light;
use crate::picture::Picture;
use crate::solid::{Ball, Bubble, Film, Solid};
use crate::spectral::{self, Spectral, wavelengths};
use crate::sphere::{Material, Tile};

const SECTION: &str = "Glass and films";

pub(super) fn scenes(square: &Environment) -> Result<Vec<Scene<'_>>, Box<dyn Error>> {
    let light = Light::Around(square);
    Ok(vec![balls(light)?, bubbles(light)?, titanium(light)?])
}

fn scene<'a>(
    name: &str,
    title: &str,
    caption: &str,
    tiles: Vec<(String, Tile)>,
    light: Light<'a>,
) -> Scene<'a> {
    let caption = format!("{caption} {}", light.words());
    let picture =
        Picture { file: format!("{name}.png"), title: title.into(), caption, section: SECTION };
    Scene { picture, tiles, light }
}

/// Clear and frosted balls, of what a description says.
fn balls(light: Light<'_>) -> Result<Scene<'_>, Box<dyn Error>> {
    let ball = |text: &str| -> Result<Tile, Box<dyn Error>> {
        let described: BsdfDescription = serde_json::from_str(text)?;
        let (surface, glass) = (described.build::<f32>()?, N_BK7_GLASS_SCHOTT.dielectric(550.0)?);
        Ok(Tile::Solid(Box::new(Ball { surface, glass })))
    };
    let frosted = |roughness: f32| {
        ball(&format!(
            r#"{{"rough_dielectric": {{"distribution": {{"ggx": {{"roughness": {roughness}}}}},
                                       "ior": {{"material": "BK7"}}}}}}"#
        ))
    };
    let tiles = vec![
        ("smooth".into(), ball(r#"{"dielectric": {"ior": {"material": "BK7"}}}"#)?),
        ("frosted, α = 0.05".into(), frosted(0.05)?),
        ("frosted, α = 0.15".into(), frosted(0.15)?),
        ("frosted, α = 0.4".into(), frosted(0.4)?),
    ];
    Ok(scene(
        "glass-spheres",
        "Smooth and frosted glass",
        "Solid balls of the glass BK7, n = 1.5185 at 550 nm, smooth and with facets of Trowbridge and \
         Reitz (Walter 2007); a ball shows what is behind it upside down. No dispersion.",
        tiles,
        light,
    ))
}

/// How thick the bubbles are at the top and at the bottom.
const THICKNESS: [f32; 2] = [120.0, 620.0];
const THICKEST: f32 = 700.0;

fn bubbles(light: Light<'_>) -> Result<Scene<'_>, Box<dyn Error>> {
    // Water at sixteen wavelengths, and each order of reflection seen by the observer.
    let observer =
        Observer::<f32, { spectral::CHANNELS }>::new(Illuminant::D65, spectral::WAVELENGTHS)?;
    let water = WATER_20_C_DAIMON_2007.refractive_index(wavelengths())?;
    let index = Complex::new(water.eta, water.k);
    let air = Complex::new(spectral::WHITE, spectral::BLACK);
    let stack = |thickness| Stack::new(air, &[Layer { index, thickness }], air, wavelengths());
    let exact = Film::new(THICKEST, stack, |film, cos| film.reflectance(cos))?;
    let seen = move |color: Spectral| observer.linear_srgb(color);
    let exact: Box<dyn Solid> = Box::new(Bubble { film: exact, thickness: THICKNESS, seen });

    let film = |thickness| BelcourBarla::<Vec3, f32>::new(1.333, thickness, [1.0, 0.0], 1.0);
    let colours = Film::new(THICKEST, film, |film, cos| film.reflectance(cos))?;
    let seen = |color: Vec3| color;
    let colours: Box<dyn Solid> = Box::new(Bubble { film: colours, thickness: THICKNESS, seen });

    let lines = Vec3::new(650.0, 550.0, 450.0);
    let gray = |n| Complex::new(Vec3::splat(n), Vec3::ZERO);
    let stack = |thickness| {
        let film = Layer { index: gray(1.333), thickness };
        Stack::new(gray(1.0), &[film], gray(1.0), lines)
    };
    let three = Film::new(THICKEST, stack, |film, cos| film.reflectance(cos))?;
    let three: Box<dyn Solid> = Box::new(Bubble { film: three, thickness: THICKNESS, seen });

    let tiles = vec![
        ("sixteen wavelengths".into(), Tile::Solid(exact)),
        ("Belcour and Barla".into(), Tile::Solid(colours)),
        ("three wavelengths".into(), Tile::Solid(three)),
        ("Belcour, Barla − sixteen,\n× 4".into(), Tile::Difference { of: 1, minus: 0, times: 4.0 }),
        ("three − sixteen,\n× 4".into(), Tile::Difference { of: 2, minus: 0, times: 4.0 }),
    ];
    Ok(scene(
        "soap-bubbles",
        "Soap bubbles",
        "A film of water in air, 120 nm thick at the top and 620 nm at the bottom. Coherent films at \
         sixteen wavelengths, each order seen by the standard observer; the film of Belcour and Barla \
         (2017), a colour of the whole spectrum; and films at 650, 550 and 450 nm as red, green and blue.",
        tiles,
        light,
    ))
}

/// A reflectance over the cosine of the angle, tabulated: the colour of a spectrum costs no more than
/// one number.
struct Tabulated(Vec<Vec3>);

impl Tabulated {
    fn new(reflectance: impl Fn(f64) -> DVec3) -> Self {
        Self((0..=512_u16).map(|step| reflectance(f64::from(step) / 512.0).as_vec3()).collect())
    }
}

impl Fresnel for Tabulated {
    type Color = Vec3;

    fn reflectance(&self, cos: f32) -> Vec3 {
        let last = self.0.len() - 1;
        let at = cos.abs().min(1.0) * last as f32;
        let below = (at as usize).min(last - 1);
        self.0[below].lerp(self.0[below + 1], at - below as f32)
    }
}

/// Oxide on titanium, at the 81 wavelengths of the observer, of what a description says.
fn titanium(light: Light<'_>) -> Result<Scene<'_>, Box<dyn Error>> {
    let observer = Observer::<f64, 81>::new(Illuminant::D65, WAVELENGTHS)?;
    let metal = |thickness: f64| -> Result<Material, Box<dyn Error>> {
        let described: FresnelDescription = serde_json::from_str(&format!(
            r#"{{"stack": {{"layers": [{{"index": {{"material": "TiO2_film"}}, "thickness": {thickness}}}],
                           "substrate": {{"material": "Ti"}}}}}}"#
        ))?;
        let film: AnyFresnel<f64, Spectrum<f64, 81>> = described.build_spectrum(&WAVELENGTHS)?;
        let seen = Tabulated::new(|cos| observer.linear_srgb(film.reflectance(cos)));
        Ok(material(CookTorrance::new(Ggx::new(0.12)?, seen)))
    };
    let mut tiles = Vec::new();
    for (thickness, label) in [
        (0.0, "bare"),
        (20.0, "20 nm"),
        (35.0, "35 nm"),
        (55.0, "55 nm"),
        (80.0, "80 nm"),
        (110.0, "110 nm"),
    ] {
        tiles.push((label.to_owned(), Tile::Sphere(metal(thickness)?)));
    }
    Ok(scene(
        "titanium-spheres",
        "Anodised titanium",
        "A film of titanium dioxide grows on titanium with the voltage: coherent films with the measured \
         indices of oxide and metal, at 81 wavelengths, seen by the standard observer; GGX, α = 0.12.",
        tiles,
        light,
    ))
}
