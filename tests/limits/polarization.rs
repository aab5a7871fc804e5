//! Amplitudes, films and plates: energy, limits, precision, and what finite inputs can do.

use brdf::colorimetry::WAVELENGTHS;
use brdf::polarization::{
    Complex, Interface, Jones, Layer, Layers, MAX_LAYERS, Mueller, Plates, Stokes,
};
use brdf::{
    BelcourBarla, Fresnel, Illuminant, Lanes, Lift, Observer, Spectrum, Stack, brewster_angle,
};
use glam::{DVec3, Vec3};

/// Numbers in 0 … 1 that fill it evenly, with a seed.
fn numbers(seed: f64) -> impl FnMut() -> f64 {
    let mut place = seed;
    move || {
        place = (place + 0.618_033_988_749_895) % 1.0;
        // Folded, so that neighbours differ.
        (place * 9973.0) % 1.0
    }
}

/// A cosine, close to grazing every tenth time.
fn cosine(next: &mut impl FnMut() -> f64) -> f64 {
    if next() < 0.1 { 10_f64.powf(-12.0 * next()) } else { next() }
}

fn transparent(next: &mut impl FnMut() -> f64) -> Complex<f64> {
    Complex::real(1.0 + 2.0 * next())
}

fn stack(
    next: &mut impl FnMut() -> f64,
    layers: usize,
    index: impl Fn(&mut dyn FnMut() -> f64) -> Complex<f64>,
) -> Layers<f64> {
    let layers: Vec<_> =
        (0..layers).map(|_| Layer { index: index(next), thickness: 2000.0 * next() }).collect();
    let (outside, substrate) = (transparent(next), index(next));
    Layers::new(outside, &layers, substrate, 550.0).expect("in range")
}

/// With one and with a few layers to 10⁻¹³; in a stack of up to 64 a resonance may make more of
/// rounding.
#[test]
fn transparent_media_lose_nothing() {
    let mut next = numbers(0.1);
    for (most, allowed) in [(0, 1e-14), (1, 1e-14), (8, 1e-13), (MAX_LAYERS, 1e-11)] {
        let mut worst = 0.0_f64;
        for _ in 0..4000 {
            let count = (next() * (most as f64 + 1.0)) as usize;
            let stack = stack(&mut next, count, |mut next| transparent(&mut next));
            let found = stack.amplitudes(cosine(&mut next));
            let (r, t) = (found.reflectance(), found.transmittance);
            worst = worst.max((r.s + t.s - 1.0).abs()).max((r.p + t.p - 1.0).abs());
        }
        println!("up to {most} layers: {worst:e}");
        assert!(worst < allowed, "up to {most} layers: {worst:e}");
    }
    let mut worst = 0.0_f64;
    for _ in 0..4000 {
        let count = (10_f64.powf(6.0 * next())) as u32;
        let pile = Plates::new(1.0 + 2.0 * next(), count, 0.0).expect("in range");
        let found = pile.at(cosine(&mut next));
        let (r, t) = (found.reflectance, found.transmittance);
        worst = worst.max((r.s + t.s - 1.0).abs()).max((r.p + t.p - 1.0).abs());
    }
    println!("plates: {worst:e}");
    assert!(worst < 1e-13, "plates: {worst:e}");
}

/// What absorbs returns no more than arrives.
#[test]
fn films_are_passive() {
    let mut next = numbers(0.2);
    for _ in 0..10_000 {
        let count = (next() * 10.0) as usize;
        let stack = stack(&mut next, count, |next| {
            Complex::new(10_f64.powf(3.0 * next() - 2.0), 10_f64.powf(4.0 * next() - 3.0))
        });
        let found = stack.amplitudes(cosine(&mut next));
        let (r, t) = (found.reflectance(), found.transmittance);
        assert!(r.s + t.s < 1.0 + 1e-14 && r.p + t.p < 1.0 + 1e-14, "{stack:?}: {found:?}");
        assert!(t.s >= 0.0 && t.p >= 0.0);
        let both = [found.mueller_reflection(), found.mueller_transmission()];
        assert!(both.iter().all(|matrix| matrix.realizability() > -1e-13), "{found:?}");
    }
}

/// The Mueller matrix of a sum of Jones matrices is realisable; one that turns a handedness alone is
/// not, although it never makes more of light than there is.
#[test]
fn what_cannot_be_is_not_realizable() {
    let diagonal = |d: [f64; 4]| Mueller {
        rows: std::array::from_fn(|row| {
            std::array::from_fn(|column| if row == column { d[row] } else { 0.0 })
        }),
    };
    assert!(diagonal([1.0, 1.0, 1.0, -1.0]).realizability() < -0.1);
    assert!(diagonal([1.0, 1.1, 0.0, 0.0]).realizability() < -0.01);
    assert!(diagonal([-1.0, 0.0, 0.0, 0.0]).realizability() < -0.1);
    assert_eq!(diagonal([0.0; 4]).realizability(), 0.0);
    for matrix in [diagonal([1.0, 1.0, -1.0, -1.0]), Mueller::rotation(0.3), diagonal([1.0; 4])] {
        assert!(matrix.realizability() > -1e-15);
    }
    assert!(Mueller::depolarizer(0.5).realizability() > 0.001);
    let mean = diagonal([1.0, 0.3, 0.3, -0.3]);
    assert!(mean.realizability() > 0.0, "{}", mean.realizability());
}

/// A millimetre of gold is gold; glass between glass is nothing; an index that is that of the layer
/// below makes a layer disappear.
#[test]
fn thick_and_absent_layers() {
    let (air, gold) = (Complex::real(1.0), Complex::new(0.43, 2.455));
    let bare = Interface::new(air, gold).expect("in range");
    let millimetre = Layer { index: gold, thickness: 1e6 };
    for thickness in [1e4, 1e6, 1e9] {
        let layer = Layer { thickness, ..millimetre };
        let thick = Layers::new(air, &[layer], Complex::real(1.5), 548.6).expect("in range");
        for cos in [1.0, 0.5, 1e-3, 0.0] {
            let (thick, bare) = (thick.amplitudes(cos), bare.amplitudes(cos));
            assert_eq!(thick.r, bare.r, "{thickness} nm at {cos}");
            assert!(thick.transmittance.s < 1e-200);
        }
    }
    let mut next = numbers(0.3);
    for _ in 0..1000 {
        let (index, cos) = (transparent(&mut next), cosine(&mut next));
        let same = Layer { index, thickness: 3000.0 * next() };
        let inside = Layers::new(index, &[same, same], index, 500.0).expect("in range");
        let nothing = inside.amplitudes(cos);
        assert_eq!(nothing.reflectance().unpolarized(), 0.0);
        assert!((nothing.transmittance.p - 1.0).abs() < 1e-13, "{nothing:?} at {cos}");
        let invisible = Layers::new(air, &[same], index, 500.0).expect("in range");
        let bare = Interface::new(air, index).expect("in range").amplitudes(cos);
        let off = invisible.amplitudes(cos).reflectance().p - bare.reflectance().p;
        assert!(off.abs() < 1e-14, "{off:e}");
    }
}

/// Where there is no boundary, light passes at every angle; where there is one, however faint, nothing
/// passes at grazing.
#[test]
fn without_a_boundary_light_passes_at_grazing() {
    macro_rules! tested {
        ($number:ident, $cosines:expr) => {
            let (four, least) = (4.0 * $number::EPSILON, Complex::real(1.0 + $number::EPSILON));
            let cosines: [$number; 8] = $cosines;
            for index in [1e-4, 1.0, 1.5, 1e4].map(Complex::real) {
                let same = Layer { index, thickness: 300.0 };
                let boundary = Interface::new(index, index).expect("in range");
                let layers = Layers::new(index, &[same, same], index, 500.0).expect("in range");
                for cos in cosines {
                    for passed in [boundary.amplitudes(cos), layers.amplitudes(cos)] {
                        let (t, power) =
                            (passed.t.map(Complex::norm_squared), passed.transmittance);
                        assert_eq!(passed.reflectance().unpolarized(), 0.0, "{index:?} {cos}");
                        for passed in [t.s, t.p, power.s, power.p] {
                            assert!((passed - 1.0).abs() <= four, "{passed} of {index:?} at {cos}");
                        }
                    }
                }
            }
            for index in [least, Complex::real(1.5), Complex::new(1.0, 1e-6)] {
                let air = Complex::real(1.0);
                let faint = Interface::new(air, index).expect("in range").amplitudes(0.0);
                assert!((faint.reflectance().s - 1.0).abs() <= four, "{index:?}");
                assert!((faint.reflectance().p - 1.0).abs() <= four, "{index:?}");
                assert_eq!(faint.transmittance.unpolarized(), 0.0, "{index:?}");
            }
        };
    }
    tested!(f64, [0.0, -0.0, 1e-100, 1e-30, 1e-12, 1e-9, 1e-3, 1.0]);
    tested!(f32, [0.0, -0.0, 1e-37, 1e-30, 1e-12, 1e-9, 1e-3, 1.0]);
    // Plates of nothing, without and with absorption.
    for (absorption, passed) in [(0.0, 1.0), (1e-3, 0.0)] {
        let nothing = Plates::new(1.0_f64, 3, absorption).expect("in range").at(0.0);
        assert_eq!(nothing.reflectance.unpolarized(), 0.0);
        assert_eq!(nothing.transmittance.unpolarized(), passed);
    }
}

/// An antireflection coating of a quarter of a wavelength, and the period of a film.
#[test]
fn quarter_and_half_waves() {
    let (air, glass) = (Complex::real(1.0), Complex::real(1.5625));
    let coated = |thickness: f64| -> f64 {
        let layer = Layer { index: Complex::real(1.25), thickness };
        Layers::new(air, &[layer], glass, 500.0).expect("in range").reflectance(1.0)
    };
    assert!(coated(100.0) < 1e-30);
    assert!((coated(200.0) - coated(0.0)).abs() < 1e-15);
}

/// The figures of the documentation: how far `f32` is from `f64` in films of up to so many nanometres,
/// where 1 − R is not that of grazing.
#[test]
fn f32_follows_f64_up_to_a_thickness() {
    let mut next = numbers(0.4);
    for (film, substrate, thickest) in [
        (2.4, Complex::new(2.6, 3.4), 500.0),
        (1.5, Complex::new(0.43, 2.455), 500.0),
        (1.38, Complex::real(1.52), 1000.0),
        (1.33, Complex::real(1.0), 500.0),
    ] {
        let mut worst = 0.0_f64;
        for _ in 0..20_000 {
            let layer =
                Layer { index: Complex::real(film as f32), thickness: (thickest * next()) as f32 };
            let cos = (0.1 + 0.9 * next()) as f32;
            let narrow = |z: Complex<f64>| Complex::new(z.re as f32, z.im as f32);
            let wide = |z: Complex<f32>| Complex::new(f64::from(z.re), f64::from(z.im));
            let single =
                Layers::new(Complex::real(1.0_f32), &[layer], narrow(substrate), 550.0).unwrap();
            let layer = Layer { index: wide(layer.index), thickness: f64::from(layer.thickness) };
            let double =
                Layers::new(Complex::real(1.0_f64), &[layer], wide(narrow(substrate)), 550.0)
                    .unwrap();
            let off = f64::from(single.reflectance(cos)) - double.reflectance(f64::from(cos));
            worst = worst.max(off.abs());
        }
        println!("{film} on {substrate:?} up to {thickest} nm: {worst:e}");
        assert!(worst < 2e-6, "{film} on {substrate:?} up to {thickest} nm: {worst:e}");
    }
}

/// Finite for every finite input, in the precision that overflows first.
#[test]
fn extremes_stay_finite() {
    let (n, k) = ([1e-4_f32, 0.5, 1.0, 1.0 + f32::EPSILON, 1e4], [0.0_f32, 1e-20, 1.0, 1e4]);
    let all: Vec<_> = n.iter().flat_map(|n| k.map(|k| Complex::new(*n, k))).collect();
    let cosines = [0.0_f32, 1e-38, 1e-19, 1e-3, 0.5, 1.0, 1.01];
    for (place, outside) in all.iter().enumerate() {
        for (other, index) in all.iter().enumerate() {
            let substrate = all[(place * 7 + other * 3) % all.len()];
            for thickness in [0.0, 100.0, 1e9] {
                let layer = Layer { index: *index, thickness };
                let stack = Layers::new(*outside, &[layer, layer], substrate, 1.0).unwrap();
                for cos in cosines {
                    let found = stack.amplitudes(cos);
                    let numbers = [found.r.s, found.r.p, found.t.s, found.t.p];
                    let finite = numbers.iter().all(|z| z.re.is_finite() && z.im.is_finite())
                        && found.transmittance.s.is_finite()
                        && found.transmittance.p.is_finite()
                        && stack.reflectance(cos).is_finite();
                    assert!(finite, "{stack:?} at {cos}: {found:?}");
                    assert!(outside.im > 0.0 || stack.reflectance(cos) <= 1.0);
                    let matrix = found.mueller_transmission();
                    assert!(matrix.rows.iter().flatten().all(|m| m.is_finite()), "{found:?}");
                }
            }
        }
        for cos in cosines {
            let film: BelcourBarla<Vec3> =
                BelcourBarla::new(outside.re, 1e9, [outside.re, outside.im], 1.5).unwrap();
            assert!(film.reflectance(cos).is_finite(), "{film:?} at {cos}: {:?}", film.xyz(cos));
            let pile = Plates::new(outside.re, 1000, outside.im).unwrap().at(cos);
            let matrices = [pile.mueller_reflection(), pile.mueller_transmission()];
            assert!(matrices.iter().all(|it| it.rows.iter().flatten().all(|m| m.is_finite())));
        }
    }
    for z in [Complex::real(0.0_f32), Complex::new(1e18, -1e18), Complex::new(1e-38, 1e-38)] {
        let (root, inverse) = (z.root(), z.inverse());
        assert!([root.re, root.im, inverse.re, inverse.im].iter().all(|x| x.is_finite()), "{z:?}");
    }
}

/// The root is that of a wave that leaves: on every ray of the plane its parts have a positive sum.
#[test]
fn roots_leave_the_surface() {
    for step in 0..360 {
        let z = Complex::from_turns(3.0_f64, (f64::from(step) + 0.5) / 360.0);
        let root = z.root();
        assert!(root.re + root.im > 0.0, "{z:?} {root:?}");
        let off = root.squared() - z;
        assert!(off.norm_squared() < 1e-29, "{z:?} {root:?}");
        let one = z * z.inverse();
        assert!((one - Complex::real(1.0)).norm_squared() < 1e-30);
    }
}

/// Eight plates at Brewster's angle take some of the polarisation of light at 45°.
#[test]
fn a_pile_depolarizes() {
    let cos = brewster_angle(1.0_f64, 1.5).cos();
    let pile = Plates::new(1.5, 8, 0.0).expect("in range").at(cos).mueller_transmission();
    let light = pile * Stokes::linear(1.0, std::f64::consts::FRAC_PI_4);
    assert!((light.degree_of_polarization() - 0.7288).abs() < 5e-5);
    assert!(pile.realizability() > -1e-15);
    assert_eq!(Plates::new(1.0, 5, 0.0).expect("in range").at(0.3).transmittance.s, 1.0);
}

/// A polariser behind another one: Malus's law; a half-wave plate turns the azimuth round its axis.
#[test]
fn polarizers_and_retarders() {
    use std::f64::consts::PI;
    for step in 0..20 {
        let angle = f64::from(step) * 0.17;
        let crossed = Jones::polarizer(angle) * Jones::polarizer(0.4);
        let passed = crossed.mueller() * Stokes::linear(1.0, 0.4);
        assert!((passed.i - (angle - 0.4).cos().powi(2)).abs() < 1e-15);
        let turned = Jones::retarder(PI, angle).mueller() * Stokes::linear(1.0, 0.4);
        let want = Stokes::linear(1.0, 2.0 * angle - 0.4);
        assert!((turned.q - want.q).abs() < 1e-15 && (turned.u - want.u).abs() < 1e-15);
        let there_and_back = Mueller::rotation(-angle) * Mueller::rotation(angle);
        assert!((there_and_back.rows[1][1] - 1.0_f64).abs() < 1e-15);
    }
}

const LINES: DVec3 = DVec3::new(650.0, 550.0, 450.0);

fn iridescent(thickness: f64) -> Stack<DVec3, f64> {
    let gray = |n: f64, k: f64| Complex::new(DVec3::splat(n), DVec3::splat(k));
    let layers = [
        Layer { index: gray(2.4, 0.01), thickness },
        Layer { index: gray(1.4, 0.0), thickness: 0.5 * thickness },
    ];
    Stack::new(gray(1.0, 0.0), &layers, gray(2.6, 3.4), LINES).expect("in range")
}

/// Blocks, lanes and single answers are one formula.
#[test]
fn batches_and_lanes_have_the_same_bits() {
    let cosines: Vec<f64> = (0..301).map(|step| f64::from(step) / 300.0).collect();
    let soap: BelcourBarla<DVec3, f64> =
        BelcourBarla::new(1.33, 300.0, [1.0, 0.0], 1.0).expect("in range");
    let bare = Stack::new(
        Complex::new(DVec3::ONE, DVec3::ZERO),
        &[],
        Complex::new(DVec3::splat(1.5), DVec3::ZERO),
        LINES,
    );
    let (film, bare) = (iridescent(60.0), bare.expect("in range"));
    let terms: [&dyn Fresnel<f64, Color = DVec3>; 3] = [&film, &bare, &soap];
    for term in terms {
        let mut values = vec![DVec3::ZERO; cosines.len()];
        term.reflectance_batch(&cosines, (&mut values).into()).expect("the same lengths");
        for (cos, value) in cosines.iter().zip(values) {
            assert_eq!(value, term.reflectance(*cos), "at {cos}");
        }
    }
    let lanes = film.lift(|parameter| Lanes([parameter; 4]));
    let four = lanes.reflectance(Lanes([0.1, 0.4, 0.7, 1.0]));
    assert_eq!(four.y.0[1], film.reflectance(0.4).y);
}

/// A mirror under no film is white.
#[test]
fn the_white_of_belcour_barla_is_white() {
    let mirror: BelcourBarla<DVec3, f64> =
        BelcourBarla::new(1.0, 0.0, [1e-4, 1e4], 1.0).expect("in range");
    let off = mirror.reflectance(1.0) - DVec3::new(1.0005, 1.0002, 1.0011);
    assert!(off.abs().max_element() < 2e-3, "{off}");
}

/// At most so far from the integral over the spectrum of equal energy, in X, Y and Z: what the
/// documentation says.
#[test]
fn belcour_barla_is_near_the_integral_over_the_spectrum() {
    let observer = Observer::<f64, 81>::new(Illuminant::E, WAVELENGTHS).expect("in order");
    let white = observer.xyz(Spectrum([1.0; 81])).to_array();
    let (air, lines) = (Complex::real(1.0), WAVELENGTHS);
    for (film, [n, k], allowed) in [
        (1.33, [1.0, 0.0], 0.0145),
        (1.45, [1.33, 0.0], 0.0017),
        (2.4, [2.6, 3.4], 0.0196),
        (1.5, [0.43, 2.455], 0.0252),
    ] {
        let (mut worst, mut sum, mut count) = (0.0_f64, 0.0, 0.0);
        for step in 0..40 {
            let thickness = 10.0 * 1.15_f64.powi(step);
            let model: BelcourBarla<DVec3, f64> =
                BelcourBarla::new(film, thickness, [n, k], 1.0).expect("in range");
            let layer = [Layer { index: Complex::real(film), thickness }];
            let at = |wavelength| {
                Layers::new(air, &layer, Complex::new(n, k), wavelength).expect("in range")
            };
            let exact = lines.map(at);
            for cos in [1.0, 0.9, 0.75, 0.6, 0.45, 0.3] {
                let spectrum = std::array::from_fn(|line| exact[line].reflectance(cos));
                let want = observer.xyz(Spectrum(spectrum)).to_array();
                for axis in 0..3 {
                    let off = (model.xyz(cos)[axis] - want[axis] / white[axis]).abs();
                    worst = worst.max(off);
                    (sum, count) = (sum + off, count + 1.0);
                }
            }
        }
        println!("{film} on {n} + {k}i: largest {worst:.4}, mean {:.4}", sum / count);
        assert!(worst < allowed, "{film} on {n} + {k}i: {worst}");
    }
    // Thin soap next to the horizon.
    let model: BelcourBarla<DVec3, f64> =
        BelcourBarla::new(1.33, 10.0, [1.0, 0.0], 1.0).expect("in range");
    let layer = [Layer { index: Complex::real(1.33), thickness: 10.0 }];
    let exact = lines
        .map(|wavelength| Layers::new(air, &layer, air, wavelength).expect("in range"))
        .map(|soap| soap.reflectance(0.1));
    let off = model.xyz(0.1)[0] - observer.xyz(Spectrum(exact)).to_array()[0] / white[0];
    assert!((0.05..0.06).contains(&off), "{off}");
}

/// The wave does not tunnel through a film that is thinner than a wavelength, as that of
/// [`Layers`] does.
#[test]
fn belcour_barla_reflects_all_beyond_the_critical_angle_of_the_film() {
    for thickness in [0.0, 1.0, 1000.0] {
        let film: BelcourBarla<DVec3, f64> =
            BelcourBarla::new(1.0, thickness, [1.5, 0.0], 1.33).expect("in range");
        let [_, y, _] = film.xyz(0.5);
        // Its white is off by as much: see `the_white_of_belcour_barla_is_white`.
        assert!((y - 1.0).abs() < 2e-3, "{thickness}: {y}");
        let layer = [Layer { index: Complex::real(1.0), thickness }];
        let exact = Layers::new(Complex::real(1.33), &layer, Complex::real(1.5), 550.0);
        let exact = exact.expect("in range").reflectance(0.5);
        assert_eq!(exact > 0.99, thickness == 1000.0, "{thickness}: {exact}");
    }
}

#[test]
fn quotients_of_small_numbers_keep_their_digits() {
    let small = Complex::new(1e-300_f64, 1e-300);
    let quotient = Complex::real(1e-300) / small;
    assert!((quotient.re - 0.5).abs() < 1e-15 && (quotient.im + 0.5).abs() < 1e-15, "{quotient:?}");
    assert_eq!(Complex::real(0.0_f64).inverse(), Complex::new(0.0, 0.0));
    assert_eq!(Complex::real(1.0_f32) / Complex::real(0.0), Complex::new(0.0, 0.0));
}
