//! The scene of the picture: things on the floor of a photographer's studio.

use std::error::Error;

use brdf::materials::{ALUMINIUM, COPPER, GOLD, Material as Measured};
use brdf::{Conductor, CookTorrance, Ggx, Lambert, OrenNayar, ParameterError};
use glam::Vec3;

use crate::film::Camera;
use crate::light::Lamp;
use crate::plastic::Plastic;
use crate::scene::{Material, Object, Scene};
use crate::shape::Shape;
use crate::spectral::{Spectral, WHITE, black_body, pigment, wavelengths};

pub fn camera() -> Camera {
    Camera {
        position: Vec3::new(0.0, 4.6, 12.0),
        target: Vec3::new(-0.1, 0.72, 0.2),
        half_width: 0.295,
    }
}

/// A metal, exact at each wavelength.
fn metal(facets: Ggx, measured: &Measured) -> Result<Material, ParameterError> {
    let surface: Conductor<Spectral> = measured.conductor(wavelengths())?;
    Ok(Box::new(CookTorrance::new(facets, surface)))
}

fn object(shape: Shape, center: [f32; 3], material: Material) -> Object {
    Object { shape, center: Vec3::from_array(center), material }
}

pub fn scene() -> Result<Scene, Box<dyn Error>> {
    // Short wavelengths, long ones, and where the pigment goes from one to the other.
    let (blue, clay) = (pigment(0.55, 0.02, 500.0), pigment(0.16, 0.6, 575.0));
    let red = pigment(0.03, 0.75, 595.0);
    let sphere = |radius| Shape::Sphere { radius };
    let objects = vec![
        object(Shape::Floor, [0.0, 0.0, 0.0], Box::new(Lambert::new(WHITE * 0.5)?)),
        object(
            Shape::Bowl { radius: 0.95, lip: 0.12, half_wall: 0.05 },
            [-2.6, 1.0, -0.3],
            Box::new(OrenNayar::new(clay, 0.5)?),
        ),
        object(sphere(0.56), [-2.5, 0.67, -0.22], Box::new(Plastic::new(red, 0.05, 1.5)?)),
        object(sphere(1.1), [-0.4, 1.1, -0.7], metal(Ggx::new(0.17)?, &GOLD)?),
        object(
            Shape::Disc { radius: 0.9, half_height: 0.22, edge: 0.05 },
            [-0.75, 0.22, 1.7],
            metal(Ggx::anisotropic(0.05, 0.3)?, &ALUMINIUM)?,
        ),
        object(sphere(0.6), [1.2, 0.6, 1.1], metal(Ggx::new(0.08)?, &COPPER)?),
        object(sphere(0.95), [2.3, 0.95, -0.5], Box::new(Plastic::new(blue, 0.07, 1.5)?)),
    ];
    let target = Vec3::new(0.0, 0.6, 0.0);
    let lamps = vec![
        // The key, above at the left; a strip at the right; a large dim one overhead.
        Lamp::facing(target, Vec3::new(-5.5, 6.0, 3.5), [3.2, 3.2], black_body(4700.0) * 17.0),
        Lamp::facing(target, Vec3::new(6.5, 3.5, 0.5), [1.2, 5.0], black_body(8000.0) * 7.0),
        Lamp::facing(target, Vec3::new(0.0, 7.0, -3.0), [7.0, 1.6], WHITE * 3.0),
    ];
    Ok(Scene { objects, lamps, surroundings: black_body(9000.0) * 0.07 })
}
