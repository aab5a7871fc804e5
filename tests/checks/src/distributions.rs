//! Every distribution of facet normals at a roughness, for what holds of all of them.

use brdf::{Beckmann, Blinn, Distribution, Gaussian, Ggx, Mixture, Smith};

pub type Normals = Box<dyn Distribution<f64>>;
pub type SmithNormals = Box<dyn Smith<f64>>;

/// A distribution with the slopes about which it is wide.
pub struct Surface<D> {
    pub name: String,
    pub distribution: D,
    pub scale: [f64; 2],
}

fn surface<D>(name: &str, scale: [f64; 2], distribution: D) -> Surface<D> {
    Surface { name: format!("{name} {scale:?}"), distribution, scale }
}

/// Those that know Smith's Λ, with roughness along x and y.
pub fn with_smith(x: f64, y: f64) -> Vec<Surface<SmithNormals>> {
    let beckmann = |part: f64| Beckmann::anisotropic(part * x, part * y).expect("in range");
    let ggx = |part: f64| Ggx::anisotropic(part * x, part * y).expect("in range");
    let of_beckmann = Mixture::new([(1.0, beckmann(1.0)), (3.0, beckmann(0.7))]);
    let of_both: [(f64, SmithNormals); 2] =
        [(0.4, Box::new(beckmann(1.0))), (0.6, Box::new(ggx(0.5)))];
    let all: [(&str, SmithNormals); 4] = [
        ("Beckmann", Box::new(beckmann(1.0))),
        ("GGX", Box::new(ggx(1.0))),
        ("mixture of Beckmann", Box::new(of_beckmann.expect("in range"))),
        ("mixture of Beckmann and GGX", Box::new(Mixture::new(of_both).expect("in range"))),
    ];
    all.into_iter().map(|(name, distribution)| surface(name, [x, y], distribution)).collect()
}

/// Those without; all are isotropic.
pub fn without_smith(roughness: f64) -> Vec<Surface<Normals>> {
    let gaussian = |part: f64| Gaussian::new(part * roughness).expect("in range");
    let mixture = Mixture::new([(0.5, gaussian(1.0)), (0.5, gaussian(0.6))]);
    let mut all: Vec<(&str, Normals)> = vec![
        ("Gaussian", Box::new(gaussian(1.0))),
        ("mixture of Gaussians", Box::new(mixture.expect("in range"))),
    ];
    // A power of the cosine has no roughness beyond 1, and none below what its exponent allows.
    if let Ok(blinn) = Blinn::from_roughness(roughness) {
        all.push(("Blinn", Box::new(blinn)));
    }
    // An angle of 1 is a slope of about 1, and wider angles end at the horizon.
    let scale = roughness.min(1.0);
    all.into_iter().map(|(name, normals)| surface(name, [scale, scale], normals)).collect()
}
