//! Models fitted to measured materials by least squares: the documented tables are what the fits
//! give, and what is said about them holds.
//!
//! It compares; with `BRDF_REGENERATE=1` in the environment it writes the tables.

use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use brdf::Brdf;
use brdf_checks::fits::family::Family::{self, Beckmann, BlinnPhong, Ggx, Lambert, OrenNayar};
use brdf_checks::fits::measured::{Point, direction};
use brdf_checks::fits::{self, Row};
use glam::DVec3;

static ROWS: LazyLock<Vec<Row>> = LazyLock::new(|| fits::all(|| {}));

/// The materials with a coloured lobe whose shape the slices resolve.
const LOBES: [&str; 4] =
    ["satin_rosaline", "vch_golden_yellow", "cc_ibiza_sunset", "cc_iris_purple_gem"];
const GLOSSY: &str = "cg_sunflower";

fn row(key: &str) -> &'static Row {
    ROWS.iter().find(|row| row.material.key == key).expect("a measured material")
}

fn relative(key: &str, family: Family) -> f64 {
    row(key).fit(family).residuals.relative
}

#[test]
fn the_documented_tables_are_those_of_the_fits() {
    let (start, end) = ("<!-- tables -->\n", "<!-- end of tables -->");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/measured-fits.md");
    let text = fs::read_to_string(&path).expect("the document is in the repository");
    let (head, rest) = text.split_once(start).expect("a start of the tables");
    let (tables, tail) = rest.split_once(end).expect("an end of the tables");
    let want = format!("\n{}\n", fits::table::text(&ROWS));
    if std::env::var_os("BRDF_REGENERATE").is_some() {
        fs::write(&path, [head, start, &want, end, tail].concat()).expect("it can be written");
    } else {
        assert!(tables == want, "out of date: run this test with BRDF_REGENERATE=1; now\n{want}");
    }
}

#[test]
fn all_measured_values_are_read() {
    let counts: Vec<usize> = ROWS.iter().map(|row| row.material.points.len()).collect();
    assert_eq!(counts.iter().sum::<usize>(), 4656);
    let negative: Vec<f64> = ROWS.iter().map(|row| row.material.negative()).collect();
    // Out of gamut: the saturated films alone, the yellow one most.
    assert_eq!(negative[..3], [0.0; 3]);
    assert!((0.27..0.29).contains(&row(GLOSSY).material.negative()), "{negative:?}");
}

/// A minimum: no small step of a parameter makes the fit better.
#[test]
fn the_fits_are_minima() {
    for row in ROWS.iter() {
        for fit in &row.fits {
            for parameter in &fit.parameters {
                for step in [-1e-3, 1e-3] {
                    let stepped = fit.description.with_numbers(|path, value| {
                        let moved = value * (1.0 + step);
                        if path.to_string() == parameter.path { moved } else { value }
                    });
                    // Some values are at the end of their range.
                    let Ok(stepped) = stepped else { continue };
                    let other = fits::solve::measure(&stepped.build().unwrap(), &row.material);
                    assert!(
                        other.cube_root >= fit.residuals.cube_root * (1.0 - 1e-9)
                            || parameter.at_bound,
                        "{} {} {}",
                        row.material.key,
                        fit.family.name(),
                        parameter.path
                    );
                }
            }
        }
    }
}

/// What was found is known to so many digits as the tables show, or it is at an end of its range.
#[test]
fn the_tables_do_not_show_more_than_is_known() {
    for row in ROWS.iter() {
        for fit in &row.fits {
            for parameter in &fit.parameters {
                assert!(parameter.at_bound == parameter.standard_error.is_none(), "{parameter:?}");
            }
        }
    }
}

#[test]
fn none_of_the_materials_brightens_towards_the_light_as_oren_and_nayar_have_it() {
    for row in ROWS.iter() {
        let (lambert, oren_nayar) = (row.fit(Lambert), row.fit(OrenNayar));
        assert!(oren_nayar.values()[3] < 1e-3, "{} {:?}", row.material.key, oren_nayar.values());
        assert!((oren_nayar.residuals.cube_root / lambert.residuals.cube_root - 1.0).abs() < 1e-6);
    }
}

#[test]
fn a_lobe_helps_every_material() {
    for row in ROWS.iter() {
        for family in [BlinnPhong, Beckmann, Ggx] {
            assert!(row.fit(family).residuals.relative < 0.9 * row.fit(Lambert).residuals.relative);
        }
    }
}

#[test]
fn ggx_has_the_tails_of_paint_and_films() {
    for key in LOBES.into_iter().chain(["colodur_napoli_4f"]) {
        let residuals = |family| row(key).fit(family).residuals;
        let [beckmann, ggx] = [Beckmann, Ggx].map(residuals);
        assert!(ggx.cube_root < 0.95 * beckmann.cube_root, "{key}");
        assert!(ggx.plain < beckmann.plain, "{key}");
        assert!(beckmann.cube_root < 0.7 * residuals(BlinnPhong).cube_root, "{key}");
    }
    // On paper the two are alike.
    let ratio = relative("paper_white", Ggx) / relative("paper_white", Beckmann);
    assert!((1.0..1.03).contains(&ratio), "{ratio}");
}

#[test]
fn diffuse_materials_are_fitted_to_a_few_percent_and_films_are_not() {
    for key in ["paper_white", "colodur_napoli_4f"] {
        assert!(relative(key, Ggx) < 0.06, "{key}");
    }
    for key in LOBES {
        for family in Family::ALL {
            assert!(relative(key, family) > 0.15, "{key} {}", family.name());
        }
    }
}

/// The glossy film's lobe falls between the measured directions: Blinn–Phong, whose height does not
/// grow towards grazing, comes closest to what the instrument saw, and not close.
#[test]
fn the_lobe_of_the_glossy_film_is_not_resolved() {
    let best = relative(GLOSSY, BlinnPhong);
    assert!(best < relative(GLOSSY, Beckmann) && best < relative(GLOSSY, Ggx));
    assert!((0.2..0.3).contains(&best), "{best}");
    // Two degrees from the mirror direction at normal incidence is 300 times less.
    assert!(measured(GLOSSY, 0.0, 0.0).y > 300.0 * measured(GLOSSY, 0.0, 2.0).y);
    // What GGX has where nothing was measured.
    let highest = row(GLOSSY).material.points.iter().map(|point| point.value.max_element());
    assert!(highest.fold(0.0, f64::max) < 200.0);
    let (wi, wo) = (direction(68.776, 0.0), direction(68.776, 180.0));
    let peak = row(GLOSSY).fit(Ggx).model.eval(wi, wo).y;
    assert!((1.5e4..3e4).contains(&peak), "{peak}");
}

/// The measured value on the mirror side.
fn measured(key: &str, theta_i: f64, theta_o: f64) -> DVec3 {
    let wanted = (theta_i, theta_o, 180.0);
    let at = |point: &&Point| (point.theta_i, point.theta_o, point.azimuth) == wanted;
    row(key).material.points.iter().find(at).expect("a measured direction").value
}

/// Interference turns purple into pink already where Fresnel's term has hardly begun to rise.
#[test]
fn the_hue_of_a_colour_shifting_film_changes_more_than_the_models_can() {
    let key = "cc_iris_purple_gem";
    let red_over_blue = |value: DVec3| value.x / value.z;
    let turn = |value: &dyn Fn(f64, f64) -> DVec3| {
        red_over_blue(value(53.6461, 54.0)) / red_over_blue(value(0.0, 0.0))
    };
    let film = turn(&|theta_i, theta_o| measured(key, theta_i, theta_o));
    let model = &row(key).fit(Ggx).model;
    let ggx =
        turn(&|theta_i, theta_o| model.eval(direction(theta_i, 0.0), direction(theta_o, 180.0)));
    assert!(film > 4.0 && ggx < 1.5, "{film} {ggx}");
}

#[test]
fn duller_materials_are_rougher() {
    for family in [Beckmann, Ggx] {
        let roughness = |key: &str| row(key).fit(family).values()[6];
        let films = LOBES.map(roughness);
        assert!(roughness("paper_white") > roughness("colodur_napoli_4f"));
        assert!(films.iter().all(|film| roughness("colodur_napoli_4f") > 3.0 * film));
        assert!(films.iter().all(|film| *film > 10.0 * roughness(GLOSSY)));
    }
}
