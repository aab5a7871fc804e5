//! The split-sum table, baked by batches.

use std::error::Error;

use brdf::batch::{DirectionBuffer, SampleBuffer};
use brdf::{Brdf, CookTorrance, Ggx, Schlick, SmithCorrelated, Spectrum, from_spherical};

/// Two numbers for each roughness and angle of the viewer: with Schlick's Fresnel term the
/// directional albedo is f0 · scale + bias. Their sum is the albedo of white facets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaleAndBias {
    pub scale: f64,
    pub bias: f64,
}

/// The middle of a cell of the unit interval cut into `count` cells.
pub fn middle(cell: usize, count: usize) -> f64 {
    (cell as f64 + 0.5) / count as f64
}

/// Uniform numbers for a bake: a lattice of the unit square (Kronecker's, with the plastic number),
/// whose points fill it more evenly than random ones.
pub struct Lattice([Vec<f64>; 2]);

impl Lattice {
    pub fn new(count: usize) -> Self {
        const PLASTIC: f64 = 1.324717957244746;
        let steps = [1.0 / PLASTIC, 1.0 / (PLASTIC * PLASTIC)];
        Self(steps.map(|step| (0..count).map(|i| (0.5 + step * i as f64).fract()).collect()))
    }
}

/// Memory for the samples of a cell.
pub struct Memory {
    wi: [Vec<f64>; 3],
    weight: Vec<Spectrum<f64, 2>>,
    pdf: Vec<f64>,
}

impl Memory {
    pub fn new(lattice: &Lattice) -> Self {
        let count = lattice.0[0].len();
        Self {
            wi: [(); 3].map(|()| vec![0.0; count]),
            weight: vec![Spectrum([0.0; 2]); count],
            pdf: vec![0.0; count],
        }
    }
}

/// One cell: GGX with height-correlated Smith shadowing, the mean weight of all samples.
///
/// # Errors
/// If the roughness is out of range.
pub fn cell(
    roughness: f64,
    cos_theta: f64,
    lattice: &Lattice,
    memory: &mut Memory,
) -> Result<ScaleAndBias, Box<dyn Error>> {
    // Black facets, f0 = 0, and white ones, f0 = 1, as two channels of one model.
    let fresnel = Schlick::new(Spectrum([0.0, 1.0]))?;
    let model = CookTorrance::new(Ggx::new(roughness)?, fresnel).with_shadowing(SmithCorrelated);
    let wo = from_spherical(cos_theta.acos(), 0.0);
    let [x, y, z] = &mut memory.wi;
    let samples = SampleBuffer {
        wi: DirectionBuffer::Planes([x, y, z]),
        weight: (&mut memory.weight).into(),
        pdf: &mut memory.pdf,
    };
    model.sample_batch(wo.into(), lattice.0.each_ref().into(), samples)?;
    let sum = memory.weight.iter().fold(Spectrum([0.0; 2]), |sum, weight| sum + *weight);
    let [bias, white] = sum.0.map(|sum| sum / memory.weight.len() as f64);
    Ok(ScaleAndBias { scale: white - bias, bias })
}
