//! Shadowing and masking of facets.

use std::error::Error;

use brdf::{
    Beckmann, Distribution, Ggx, Pair, Shadowing, Smith, SmithCorrelated, SmithSeparable, VCavity,
    from_spherical,
};

use super::cartesian::{Axis, Plot};
use super::figure::{Curve, Figure, Panel};
use super::style::{BLUE, Dash, GREEN, INK, LONG, PENS, Pen, SHORT, VERMILION};

const SECTION: &str = "Microfacets";

type Term<D> = dyn Shadowing<f64, D>;

/// G over the angle of the viewer in degrees, from the crate's G/(4 (N·L)(N·V)), for a light at an
/// angle that depends on the viewer's.
fn shadowing<'a, D: Distribution<f64>>(
    term: &'a Term<D>,
    distribution: &'a D,
    light: impl Fn(f64) -> f64 + 'a,
) -> impl Fn(f64) -> f64 + 'a {
    move |viewer| {
        let wi = from_spherical(-light(viewer).to_radians(), 0.0);
        let pair = Pair::new(wi, from_spherical(viewer.to_radians(), 0.0));
        4.0 * pair.cos_i * pair.cos_o * term.visibility(distribution, &pair)
    }
}

fn panel(heading: &str, viewer: &'static str, x: (f64, f64), curves: Vec<Curve>) -> Panel {
    Panel::Plot(Plot {
        heading: heading.into(),
        x: Axis::new(viewer, x.0, x.1, 30.0),
        y: Axis::new("G", 0.0, 1.0, 0.2),
        curves,
        marks: vec![],
    })
}

/// The light stands still, the viewer moves through the plane of incidence.
pub(super) fn fixed_light() -> Result<Figure, Box<dyn Error>> {
    const LIGHT: f64 = 60.0;
    fn curves<D: Smith<f64>>(distribution: &D) -> Vec<Curve> {
        let terms: [(&str, &Term<D>); 3] = [
            ("V-cavity", &VCavity),
            ("Smith, correlated", &SmithCorrelated),
            ("Smith, separable", &SmithSeparable),
        ];
        let with_pens = terms.into_iter().zip(PENS);
        let curve = |((name, term), pen): ((&str, &Term<D>), Pen)| {
            Curve::new(name, pen, (-89.99, 89.99), shadowing(term, distribution, |_| LIGHT))
        };
        with_pens.map(curve).collect()
    }
    let viewer = "angle of the viewer θₒ / °";
    Ok(Figure {
        name: "shadowing".into(),
        section: SECTION,
        title: format!("Shadowing and masking, light at {LIGHT}°, roughness 0.7"),
        caption: "The fraction of facets that light and viewer both see, in the plane of incidence; \
            negative angles are on the side of the light. The \
            V-cavities do not ask for the distribution; their kinks are where one of the three terms \
            of the minimum takes over. Correlated is never below separable."
            .into(),
        height: 420.0,
        columns: 3,
        panels: vec![
            panel("Beckmann", viewer, (-90.0, 90.0), curves(&Beckmann::new(0.7)?)),
            panel("GGX", viewer, (-90.0, 90.0), curves(&Ggx::new(0.7)?)),
        ],
    })
}

/// Light and viewer at equal angles on opposite sides, at several roughnesses.
pub(super) fn mirror() -> Result<Figure, Box<dyn Error>> {
    fn curves<D: Smith<f64>>(distributions: &[(f64, D)]) -> Vec<Curve> {
        let over = |label: String, pen, term: &Term<D>, distribution: &D| {
            Curve::new(label, pen, (0.0, 89.99), shadowing(term, distribution, |viewer| viewer))
        };
        let smith: [(&str, Dash, &Term<D>); 2] =
            [("correlated", Dash::Solid, &SmithCorrelated), ("separable", SHORT, &SmithSeparable)];
        let mut curves = Vec::new();
        for (kind, dash, term) in smith {
            for ((m, distribution), color) in distributions.iter().zip([BLUE, VERMILION, GREEN]) {
                let label = format!("Smith {kind}, α = {m}");
                curves.push(over(label, Pen { color, dash }, term, distribution));
            }
        }
        if let Some((_, any)) = distributions.first() {
            curves.push(over("V-cavity".into(), Pen { color: INK, dash: LONG }, &VCavity, any));
        }
        curves
    }
    let (mut beckmann, mut ggx) = (Vec::new(), Vec::new());
    for m in [0.2, 0.5, 1.0] {
        beckmann.push((m, Beckmann::new(m)?));
        ggx.push((m, Ggx::new(m)?));
    }
    let viewer = "θₒ = θᵢ / °";
    Ok(Figure {
        name: "shadowing-mirror".into(),
        section: SECTION,
        title: "Shadowing and masking in the mirror configuration".into(),
        caption: "Light and viewer at equal angles on opposite sides, h along the normal. No groove hides \
            a horizontal facet, so the V-cavities give 1; Smith's surface hides more the rougher it \
            is, and GGX more than Beckmann."
            .into(),
        height: 420.0,
        columns: 3,
        panels: vec![
            panel("Beckmann", viewer, (0.0, 90.0), curves(&beckmann)),
            panel("GGX", viewer, (0.0, 90.0), curves(&ggx)),
        ],
    })
}
