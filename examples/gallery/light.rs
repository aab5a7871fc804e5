//! What lights the spheres.

use glam::Vec3;

use crate::environment::Environment;

/// What lights the spheres.
#[derive(Clone, Copy, Debug)]
pub enum Light<'a> {
    /// Radiance from all around.
    Around(&'a Environment),
    /// Radiance 1 from everywhere, shown without a tone curve: 1 is white.
    Furnace,
    /// Parallel light from a direction in the camera's frame (x right, y up, z to the viewer),
    /// with the irradiance of a surface that faces it.
    Distant {
        /// Towards the light; of length 1.
        towards: Vec3,
        /// For all three channels.
        irradiance: f32,
    },
    /// The sun in a black sky, at the right.
    Sun {
        /// The angle between sun and viewer, radians: 0 is a full moon.
        phase: f32,
        /// Of a surface that faces it, for all three channels.
        irradiance: f32,
    },
}

impl Light<'_> {
    /// What a caption says of it.
    pub fn words(&self) -> String {
        match self {
            Self::Around(_) => "Light: the square and the lamp.".into(),
            Self::Furnace => {
                "Light: a white furnace, radiance 1 from everywhere. 1 is shown white, and what is \
                 above 1 red."
                    .into()
            }
            Self::Distant { towards, .. } if towards.z > 0.999 => {
                "Light: parallel, from behind the viewer.".into()
            }
            Self::Distant { towards, .. } => {
                let angle = towards.z.acos().to_degrees();
                format!("Light: parallel, from the right, {angle:.0}° from the viewer.")
            }
            Self::Sun { phase, .. } => {
                format!("Light: the sun alone, at a phase angle of {:.0}°.", phase.to_degrees())
            }
        }
    }
}
