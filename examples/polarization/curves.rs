//! Curves over the angle of incidence.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use brdf::materials::GOLD;
use brdf::polarization::{Amplitudes, Complex, Interface, Jones, Stokes};
use brdf::{ParameterError, brewster_angle, critical_angle};
use plotters::style::RGBColor;

use super::colors::{BLUE, GREEN, GREY, RED};
use super::figure::{Curve, Figure, Panel};

/// A curve over angles from 0° to just below 90°.
fn curve(name: &str, color: RGBColor, at: impl Fn(f64) -> f64) -> Curve {
    let point = |step: u32| {
        let degrees = f64::from(step) * 0.1;
        (degrees, at(degrees.to_radians()))
    };
    Curve::new(name, color, (0..900).map(point).collect())
}

/// A vertical line at an angle, with its name and the angle.
fn mark(name: &str, angle: f64, low: f64, high: f64) -> Curve {
    let degrees = angle.to_degrees();
    Curve::new(format!("{name}{degrees:.1}°"), GREY, vec![(degrees, low), (degrees, high)]).dashed()
}

fn panel(heading: &str, y_name: &'static str, y: [f64; 2], curves: Vec<Curve>) -> Panel {
    Panel {
        heading: heading.to_owned(),
        x_name: "angle of incidence, degrees",
        y_name,
        x: 0.0..90.0,
        y: y[0]..y[1],
        list: true,
        curves,
        ..Panel::default()
    }
}

fn polarization(light: Stokes<f64>) -> f64 {
    light.degree_of_polarization()
}

/// Glass from outside and from inside.
pub fn glass() -> Result<Figure, ParameterError> {
    let (air, glass) = (Complex::real(1.0), Complex::real(1.5));
    let outside = Interface::new(air, glass)?;
    let inside = outside.reversed();
    let (brewster, back) = (brewster_angle(1.0, 1.5), brewster_angle(1.5, 1.0));
    let critical = critical_angle(1.5, 1.0);
    let of = |interface: Interface<f64>, name, color, part: fn(Amplitudes<f64>) -> f64| {
        curve(name, color, move |angle| part(interface.amplitudes(angle.cos())))
    };
    let natural = Stokes::unpolarized(1.0);
    let panels = vec![
        panel(
            "from air into glass",
            "reflectance",
            [0.0, 1.0],
            vec![
                of(outside, "R_s", BLUE, |found| found.reflectance().s),
                of(outside, "R_p", RED, |found| found.reflectance().p),
                mark("Brewster ", brewster, 0.0, 1.0),
            ],
        ),
        panel(
            "from glass into air",
            "reflectance",
            [0.0, 1.05],
            vec![
                of(inside, "R_s", BLUE, |found| found.reflectance().s),
                of(inside, "R_p", RED, |found| found.reflectance().p),
                mark("Brewster ", back, 0.0, 1.05),
                mark("total ", critical, 0.0, 1.05),
            ],
        ),
        panel(
            "from glass into air",
            "phase, degrees",
            [-185.0, 185.0],
            vec![
                of(inside, "arg r_s", BLUE, |found| found.r.s.arg().to_degrees()),
                of(inside, "arg r_p", RED, |found| found.r.p.arg().to_degrees()),
                mark("Brewster ", back, -185.0, 185.0),
                mark("total ", critical, -185.0, 185.0),
            ],
        ),
        panel(
            "natural light from air",
            "degree of polarisation",
            [0.0, 1.05],
            vec![
                curve("reflected", BLUE, |angle| {
                    polarization(outside.amplitudes(angle.cos()).mueller_reflection() * natural)
                }),
                curve("transmitted", RED, |angle| {
                    polarization(outside.amplitudes(angle.cos()).mueller_transmission() * natural)
                }),
                mark("Brewster ", brewster, 0.0, 1.05),
            ],
        ),
    ];
    Ok(Figure {
        name: "glass".into(),
        title: "Glass and polarised light".into(),
        subtitle:
            "Index 1.5. The phases are those of e^(−iωt), with r_p = −r_s at normal incidence."
                .into(),
        swatch: None,
        panels,
    })
}

/// Linear light at 45° after one and after two total reflections.
pub fn rhomb() -> Result<Figure, ParameterError> {
    let inside = Interface::new(Complex::real(1.51), Complex::real(1.0))?;
    let after = move |times: u32| {
        move |angle: f64| {
            let turn = inside.amplitudes(angle.cos()).mueller_reflection();
            let light = (0..times).fold(Stokes::linear(1.0, FRAC_PI_4), |light, _| turn * light);
            (light.v / light.i).abs()
        }
    };
    let first = 48.62_f64.to_radians();
    let second = 54.62_f64.to_radians();
    Ok(Figure {
        name: "rhomb".into(),
        title: "Fresnel's rhomb".into(),
        subtitle:
            "Two total reflections in glass of index 1.51 turn linear light at 45° into circular \
                   light, at 48.6° and at 54.6°."
                .into(),
        swatch: None,
        panels: vec![panel(
            "",
            "|V|/I",
            [0.0, 1.05],
            vec![
                curve("one reflection", BLUE, after(1)),
                curve("two reflections", RED, after(2)),
                mark("", first, 0.0, 1.05),
                mark("", second, 0.0, 1.05),
            ],
        )],
    })
}

/// Gold at 70° in linear light that is turned from s to p.
pub fn gold() -> Result<Figure, ParameterError> {
    let lines = [(650.0, "650 nm", RED), (550.0, "550 nm", GREEN), (450.0, "450 nm", BLUE)];
    let cos = 70_f64.to_radians().cos();
    let mut turned = Vec::new();
    let mut over_angle = Vec::new();
    for (wavelength, name, color) in lines {
        let index = GOLD.refractive_index(wavelength)?;
        let metal = Interface::new(Complex::real(1.0), Complex::new(index.eta, index.k))?;
        let mirror = metal.amplitudes(cos).mueller_reflection();
        turned.push(curve(name, color, |azimuth| (mirror * Stokes::linear(1.0, azimuth)).i));
        over_angle.push(curve(&format!("R_s, {name}"), color, |angle| {
            metal.amplitudes(angle.cos()).reflectance().s
        }));
        over_angle.push(
            curve(&format!("R_p, {name}"), color, |angle| {
                metal.amplitudes(angle.cos()).reflectance().p
            })
            .dashed(),
        );
    }
    over_angle.push(Curve::new("70°", GREY, vec![(70.0, 0.0), (70.0, 1.0)]).dashed());
    let azimuths = Panel {
        x_name: "azimuth of the polariser from s, degrees",
        ..panel("at 70°, through a polariser", "reflectance", [0.0, 1.0], turned)
    };
    let all = panel("over the angle", "reflectance", [0.0, 1.0], over_angle);
    Ok(Figure {
        name: "gold".into(),
        title: "Gold through a polariser".into(),
        subtitle:
            "In p-polarised light gold is far redder than in s-polarised light. Index: Johnson, \
                   Christy 1972."
                .into(),
        swatch: None,
        panels: vec![azimuths, all],
    })
}

/// The light of the sky, polarised across the direction to the sun, on a window; and what a polariser
/// in front of the eye leaves of it.
pub fn sky() -> Result<Figure, ParameterError> {
    // Of a clear sky at 90° from the sun.
    const SKY: f64 = 0.75;
    let glass = Interface::new(Complex::real(1.0), Complex::real(1.5))?;
    let brewster = brewster_angle(1.0, 1.5);
    let natural = Stokes::unpolarized(1.0);
    let sky = |azimuth: f64| {
        let Stokes { q, u, .. } = Stokes::linear(SKY, azimuth);
        Stokes { i: 1.0, q, u, v: 0.0 }
    };
    let reflected = |light: Stokes<f64>| {
        move |angle: f64| (glass.amplitudes(angle.cos()).mueller_reflection() * light).i
    };
    let over_angle = vec![
        curve("sky along s", BLUE, reflected(sky(0.0))),
        curve("overcast", GREEN, reflected(natural)),
        curve("sky along p", RED, reflected(sky(FRAC_PI_2))),
        mark("Brewster ", brewster, 0.0, 1.0),
    ];
    let through = |degrees: f64| {
        let light = glass.amplitudes(degrees.to_radians().cos()).mueller_reflection() * natural;
        move |azimuth: f64| (Jones::polarizer(azimuth).mueller() * light).i / light.i
    };
    let turned = vec![
        curve("at 30°", GREEN, through(30.0)),
        curve("Brewster, 56.3°", BLUE, through(brewster.to_degrees())),
        curve("at 75°", RED, through(75.0)),
    ];
    let azimuths = Panel {
        x_name: "azimuth of the polariser from s, degrees",
        ..panel(
            "an overcast sky in the window, through a polariser",
            "part that passes",
            [0.0, 1.05],
            turned,
        )
    };
    Ok(Figure {
        name: "sky".into(),
        title: "The sky in a window".into(),
        subtitle: "Glass of index 1.5. The light of a clear sky at 90° from the sun is taken as polarised by \
                   three quarters, along s or along p of the window; that of an overcast sky is natural."
            .into(),
        swatch: None,
        panels: vec![
            panel("the window", "reflectance", [0.0, 1.0], over_angle),
            azimuths,
        ],
    })
}
