//! The public functions beside the models: frames, directions, Fresnel's equations, colours,
//! measured materials. For the inputs that they are documented for the answers are in range, for
//! all others they come without a panic.
#![no_main]

use arbitrary::Arbitrary;
use brdf::fresnel::{
    conductor_polarized, dielectric_polarized, forms, index_from_normal_incidence, normal_incidence,
};
use brdf::{
    Frame, Illuminant, Observer, Pair, Real, Spectrum, Vector, above_surface, brewster_angle,
    colorimetry, critical_angle, from_spherical, materials, reflect, refract, to_spherical,
};
use brdf_fuzz::geometry::{Direction, Directions};
use brdf_fuzz::numbers::Number;
use libfuzzer_sys::fuzz_target;

#[derive(Arbitrary, Debug)]
enum Call<'a> {
    Frame([Number; 3], [Number; 3]),
    Refract(Direction, Direction, Number, Number),
    Pair(Directions),
    Angles([Number; 3], [Number; 2]),
    Fresnel([Number; 3]),
    Index(Number),
    Observer(u8, [Number; 4], [Number; 4]),
    Materials(&'a str, Number),
}

#[derive(Arbitrary, Debug)]
struct Input<'a> {
    double: bool,
    call: Call<'a>,
}

fuzz_target!(|input: Input<'_>| {
    if input.double { check::<f64>(&input.call, 1e-14) } else { check::<f32>(&input.call, 2e-6) }
});

fn check<T: Real<Mask = bool> + Into<f64>>(call: &Call<'_>, tolerance: f64) {
    let lit = |Number(value): Number| T::lit(value);
    let vector = |[x, y, z]: [f64; 3]| -> T::Vec3 { Vector::new(T::lit(x), T::lit(y), T::lit(z)) };
    let numbers = |v: T::Vec3| -> [f64; 3] { [v.x(), v.y(), v.z()].map(Into::into) };
    let dot = |a: T::Vec3, b: T::Vec3| -> f64 {
        numbers(a).into_iter().zip(numbers(b)).map(|(a, b)| a * b).sum()
    };
    match *call {
        Call::Frame(normal, tangent) => {
            let [normal, tangent] = [normal, tangent].map(|v| vector(v.map(|Number(value)| value)));
            let frames =
                [Frame::from_normal(normal), Frame::from_normal_and_tangent(normal, tangent)];
            for frame in frames {
                let axes = [frame.tangent(), frame.bitangent(), frame.normal()];
                for (i, a) in axes.into_iter().enumerate() {
                    for (j, b) in axes.into_iter().enumerate() {
                        let want = f64::from(u8::from(i == j));
                        assert!((dot(a, b) - want).abs() <= tolerance, "{frame:?}");
                    }
                }
            }
        }
        Call::Refract(Direction(w), Direction(normal), Number(above), Number(below)) => {
            let (w, normal) = (vector(w), vector(normal));
            let answer = refract(w, normal, T::lit(above), T::lit(below));
            let indices = 1e-4..=1e4;
            let unit = |v| (dot(v, v) - 1.0).abs() < 1e-6;
            if unit(w) && unit(normal) && indices.contains(&above) && indices.contains(&below) {
                let ratio = (above / below).max(below / above);
                let length = dot(answer.direction, answer.direction).sqrt();
                // What the lengths and the cosine are off counts as often as the ratio is large.
                assert!((length - 1.0).abs() <= (tolerance + 2e-6) * (1.0 + ratio * ratio));
            }
            let _ = reflect(w, normal);
        }
        Call::Pair(Directions(pair)) => {
            let pair = Pair::<T>::new(vector(pair[0]), vector(pair[1]));
            if pair.above {
                assert!((dot(pair.h, pair.h) - 1.0).abs() <= tolerance, "{pair:?}");
                let cosines: [f64; 2] = [pair.cos_h, pair.cos_d].map(Into::into);
                assert!(cosines.into_iter().all(|cos| cos > 0.0 && cos < 1.006), "{pair:?}");
            }
        }
        Call::Angles(v, [theta, phi]) => {
            let v = vector(v.map(|Number(value)| value));
            let (polar, azimuth): (T, T) = to_spherical(v);
            let (polar, azimuth): (f64, f64) = (polar.into(), azimuth.into());
            if above_surface::<T, T::Vec3>(v) {
                assert!((0.0..1.5707964).contains(&polar) && azimuth.abs() < 3.1415928);
            }
            let Number(angle) = theta;
            let w = from_spherical(lit(theta), lit(phi));
            if angle.abs() <= 1e4 && phi.0.abs() <= 1e4 {
                assert!((dot(w, w) - 1.0).abs() <= tolerance, "{w:?}");
            }
            let angles: [f64; 2] =
                [critical_angle(lit(theta), lit(phi)), brewster_angle(lit(theta), lit(phi))]
                    .map(Into::into);
            let indices = 1e-4..=1e4;
            if indices.contains(&theta.0) && indices.contains(&phi.0) {
                assert!(angles.into_iter().all(|angle| angle > 0.0 && angle < 1.5707964));
            }
        }
        Call::Fresnel([eta, k, cos]) => {
            let allowed = (1e-4..=1e4).contains(&eta.0) && (0.0..=1e4).contains(&k.0);
            let (eta, k, cos) = (lit(eta), lit(k), lit(cos));
            let (dielectric, conductor) =
                (dielectric_polarized(eta, cos), conductor_polarized(eta, k, cos));
            let answers = [
                dielectric.s,
                dielectric.p,
                conductor.s,
                conductor.p,
                forms::gc(eta, cos),
                forms::abu(eta, k, cos),
                normal_incidence(eta, k),
            ];
            if allowed {
                for answer in answers.map(Into::into) {
                    assert!((0.0..=1.0).contains(&answer), "{answers:?}");
                }
                let (a, b) = forms::ab(eta, k, cos);
                let (a, b): (f64, f64) = (a.into(), b.into());
                assert!(a >= 0.0 && b >= 0.0 && a.is_finite() && b.is_finite(), "{a} {b}");
            }
        }
        Call::Index(r0) => {
            if let Ok(index) = index_from_normal_incidence(lit(r0)) {
                let (r0, back): (f64, f64) =
                    (lit(r0).into(), normal_incidence(index, T::lit(0.0)).into());
                assert!((back - r0).abs() <= 2.0 * tolerance.max(1e-12), "{back}");
            }
        }
        Call::Observer(illuminant, wavelengths, reflectance) => {
            let illuminant =
                [Illuminant::D65, Illuminant::A, Illuminant::E][usize::from(illuminant) % 3];
            let wavelengths = wavelengths.map(|Number(value)| value);
            let Ok(observer) = Observer::<T, 4>::new(illuminant, wavelengths) else { return };
            let clamped =
                reflectance.map(|Number(value)| T::lit(value).clamp(T::lit(0.0), T::lit(1.0)));
            let xyz = observer.xyz(Spectrum(clamped));
            let [x, y, z] = numbers(xyz);
            assert!((0.0..1.2).contains(&x) && (0.0..1.0001).contains(&y), "{xyz:?}");
            assert!((0.0..1.2).contains(&z), "{xyz:?}");
            let back = colorimetry::linear_srgb_to_xyz(observer.linear_srgb(Spectrum(clamped)));
            for (back, want) in numbers(back).into_iter().zip([x, y, z]) {
                assert!((back - want).abs() <= 2.0 * tolerance, "{back} {want}");
            }
            let wild = Spectrum(reflectance.map(lit));
            let shown = colorimetry::clamp_to_srgb::<T, _>(observer.adapted_linear_srgb(wild));
            assert!(numbers(shown).into_iter().all(|c| (0.0..=1.0).contains(&c)), "{shown:?}");
        }
        Call::Materials(name, wavelength) => {
            let Ok(material) = materials::find(name) else { return };
            let Ok(index) = material.refractive_index(lit(wavelength)) else { return };
            let (eta, k): (f64, f64) = (index.eta.into(), index.k.into());
            assert!(eta > 0.0 && eta < 20.0 && (0.0..40.0).contains(&k), "{material}: {eta} {k}");
            material.conductor(lit(wavelength)).expect("an index of a material is in range");
        }
    }
}
