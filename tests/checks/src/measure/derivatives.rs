//! Whether the derivatives that a model answers over duals are those of its answers.

use std::array;

use brdf::description::{BrdfDescription, BsdfDescription, DescriptionError, Path};
use brdf::{AnyBrdf, AnyBsdf, Brdf, Bsdf, Dual, Mask, Real, TransportMode, Vector, Vector3};
use glam::DVec3;

use super::differences::{Difference, STEPS, Steps};
use crate::directions::pairs;

/// No derivative may be off by more, relative to its size or to 10⁻³ of the value over the size of the
/// number that changes: 1 for a direction.
pub const LARGEST: f64 = 1e-6;

/// What was compared of one model.
#[derive(Debug, Default)]
pub struct Derivatives {
    /// How many derivatives were compared.
    pub compared: usize,
    /// How many of them differences cannot tell that well: next to a kink or a jump, and in narrow
    /// lobes.
    pub undecided: usize,
    /// The largest error, as [`LARGEST`] counts it, and where it is. If differences cannot tell, what is
    /// beyond four times their own error.
    pub largest: f64,
    pub place: String,
    /// Derivatives that are no numbers though the answer is one, and values over duals that are not
    /// those over `f64`.
    pub faults: Vec<String>,
}

/// What a model is asked.
#[derive(Clone, Copy, Debug)]
pub struct Question {
    pub wi: DVec3,
    pub wo: DVec3,
    pub u: [f64; 2],
    /// The number that chooses the event, over the whole sphere.
    pub event: f64,
    /// Whether its albedo is asked for too.
    pub albedo: bool,
    /// Whether the answer is smooth there, so that differences can tell its derivatives. Elsewhere they
    /// have to be numbers.
    pub compared: bool,
}

/// So many pairs all over the hemisphere, at the first of which the albedo is asked for; pairs of which
/// both directions are equally steep, and the normal; ends of all ranges, where nothing is compared.
pub fn questions(count: usize, albedos: usize) -> Vec<Question> {
    let part = |index: usize, step: f64| (index as f64 * step + 0.3).fract();
    let mut all: Vec<Question> = (pairs(count).into_iter().enumerate())
        .map(|(index, (wi, wo))| {
            let u = [part(index, 0.618033988), part(index, 0.754877666)];
            let event = part(index, 0.569840291);
            Question { wi, wo, u, event, albedo: index < albedos, compared: true }
        })
        .collect();
    let steep = [DVec3::new(0.6, 0.0, 0.8), DVec3::new(-0.6, 0.0, 0.8), DVec3::new(0.0, 0.6, 0.8)];
    for wi in steep.into_iter().chain([DVec3::Z]) {
        for wo in steep.into_iter().chain([DVec3::Z]) {
            let albedo = albedos > 0 && wi == DVec3::Z;
            all.push(Question { wi, wo, u: [0.3, 0.7], event: 0.5, albedo, compared: true });
        }
    }
    let ends = [
        DVec3::Z,
        DVec3::new(1e-160, 0.0, 1.0),
        DVec3::new(1e-9, 1e-9, 1.0),
        DVec3::new(1.0, 0.0, 1e-10),
        DVec3::new(-1.0, 0.0, 1e-70),
        DVec3::new(0.0, 1.0, 1e-100),
        DVec3::X,
        DVec3::new(0.6, 0.0, -0.8),
        DVec3::ZERO,
        DVec3::NAN,
        DVec3::new(0.0, 1e300, 1.0),
    ];
    let (none, last) = ([0.0, 1e-300, f64::NAN], [1.0, 1.0 - 1e-16, 2.0]);
    for (index, wo) in ends.into_iter().enumerate() {
        for (other, wi) in ends.into_iter().chain([steep[0]]).enumerate() {
            let u = [none[index % 3], last[other % 3]];
            let u = if (index + other) % 2 == 0 { u } else { [u[1], u[0]] };
            let albedo = albedos > 0 && other == 0;
            all.push(Question { wi, wo, u, event: u[0], albedo, compared: false });
        }
    }
    all
}

/// Questions over the whole sphere: the same, with either direction, both or none turned over.
pub fn questions_over_sphere(count: usize) -> Vec<Question> {
    let over = |turned: bool, w: DVec3| if turned { DVec3::new(w.x, w.y, -w.z) } else { w };
    let all = questions(count, 0).into_iter().enumerate();
    all.map(|(index, at)| Question {
        wi: over(index & 1 > 0, at.wi),
        wo: over(index & 2 > 0, at.wo),
        ..at
    })
    .collect()
}

type One = Dual<f64, 1>;

/// Names of the numbers of [`answers`].
const NAMES: [&str; 14] = [
    "eval.x",
    "eval.y",
    "eval.z",
    "pdf",
    "sample.pdf",
    "sample.wi.x",
    "sample.wi.y",
    "sample.wi.z",
    "sample.weight.x",
    "sample.weight.y",
    "sample.weight.z",
    "albedo or lobes.x",
    "albedo or lobes.y",
    "albedo or lobes.z",
];
type Answers<T> = [T; NAMES.len()];

/// A description whose model is asked.
trait Described {
    type Model<T: Real>;

    /// The model of numbers that are made of the values and their places.
    ///
    /// # Errors
    /// If a number is not in its range.
    fn model<T: Real>(
        &self,
        number: impl FnMut(&Path<'_>, f64) -> T,
    ) -> Result<Self::Model<T>, DescriptionError>;

    /// Its value, density and sample, and one colour more.
    fn ask<T: Real>(model: &Self::Model<T>, wi: T::Vec3, wo: T::Vec3, at: &Question) -> Asked<T>;
}

/// What a model answers to a question: value, density, the direction, weight and density of a sample, and
/// the albedo, or the specular lobes.
struct Asked<T: Real>(T::Vec3, T, [T::Vec3; 2], T, T::Vec3);

impl Described for BrdfDescription {
    type Model<T: Real> = AnyBrdf<T>;

    fn model<T: Real>(
        &self,
        number: impl FnMut(&Path<'_>, f64) -> T,
    ) -> Result<AnyBrdf<T>, DescriptionError> {
        self.build_with(number)
    }

    #[inline(never)]
    fn ask<T: Real>(model: &AnyBrdf<T>, wi: T::Vec3, wo: T::Vec3, at: &Question) -> Asked<T> {
        let sample = model.sample(wo, at.u.map(T::lit));
        let none = Vector::new(T::zero(), T::zero(), T::zero());
        let albedo: T::Vec3 = if at.albedo { model.albedo(wo) } else { none };
        let (value, pdf) = (model.eval(wi, wo), model.pdf(wi, wo));
        Asked(value, pdf, [sample.wi, sample.weight], sample.pdf, albedo)
    }
}

impl Described for BsdfDescription {
    type Model<T: Real> = AnyBsdf<T>;

    fn model<T: Real>(
        &self,
        number: impl FnMut(&Path<'_>, f64) -> T,
    ) -> Result<AnyBsdf<T>, DescriptionError> {
        self.build_with(number)
    }

    #[inline(never)]
    fn ask<T: Real>(model: &AnyBsdf<T>, wi: T::Vec3, wo: T::Vec3, at: &Question) -> Asked<T> {
        let mode = TransportMode::Radiance;
        let [x, y] = at.u.map(T::lit);
        let sample = model.sample(wo, [x, y, T::lit(at.event)], mode);
        // Where nothing is drawn the direction means nothing.
        let drawn = sample.specular.or(sample.pdf.gt(T::zero()));
        let up: T::Vec3 = Vector::new(T::zero(), T::zero(), T::one());
        let direction = Vector::select(drawn, sample.wi, up);
        let lobes = model.specular(wo, mode);
        let lobes = lobes.reflected.weight + lobes.transmitted.weight * T::lit(0.5);
        let (value, pdf) = model.eval_pdf(wi, wo, mode);
        Asked(value, pdf, [direction, sample.weight], sample.pdf, lobes)
    }
}

fn answers<D: Described, T: Real>(
    model: &D::Model<T>,
    wi: T::Vec3,
    wo: T::Vec3,
    at: &Question,
) -> Answers<T> {
    let Asked(value, pdf, [drawn, weight], density, last) = D::ask(model, wi, wo, at);
    let mut all = [T::zero(); NAMES.len()];
    for (start, vector) in [0, 5, 8, 11].into_iter().zip([value, drawn, weight, last]) {
        all[start..start + 3].copy_from_slice(&[vector.x(), vector.y(), vector.z()]);
    }
    (all[3], all[4]) = (pdf, density);
    all
}

/// Compares derivatives of all answers of a model of reflection by every number of the description and
/// both directions with differences of the answers in `f64`.
#[inline(never)]
pub fn of_reflection(described: &BrdfDescription, questions: &[Question]) -> Derivatives {
    derivatives(described, questions)
}

/// The same of a model over the whole sphere.
#[inline(never)]
pub fn over_sphere(described: &BsdfDescription, questions: &[Question]) -> Derivatives {
    derivatives(described, questions)
}

fn derivatives<D: Described>(described: &D, questions: &[Question]) -> Derivatives {
    let mut result = Derivatives::default();
    for parameter in parameters(described) {
        result.by_parameter(described, &parameter, questions);
    }
    match (described.model(|_, value| One::lit(value)), described.model(|_, value| value)) {
        (Ok(model), Ok(plain)) => result.by_directions::<D>(&model, &plain, questions),
        _ => result.faults.push("not built".into()),
    }
    result
}

/// A number of a description.
struct Parameter {
    place: usize,
    path: String,
    value: f64,
}

fn parameters(described: &impl Described) -> Vec<Parameter> {
    let mut found = Vec::new();
    let built = described.model(|path, value| {
        found.push(Parameter { place: found.len(), path: path.to_string(), value });
        value
    });
    built.map_or_else(|_| Vec::new(), |_| found)
}

/// One of the numbers made by a function, the others constant.
fn built<D: Described, T: Real>(
    described: &D,
    parameter: &Parameter,
    change: impl Fn(f64) -> T,
) -> Result<D::Model<T>, DescriptionError> {
    let mut place = 0;
    described.model(|_: &Path<'_>, value| {
        place += 1;
        if place - 1 == parameter.place { change(value) } else { T::lit(value) }
    })
}

/// Which direction turns.
#[derive(Clone, Copy, PartialEq)]
enum Turned {
    Light,
    Viewer,
}

/// What is compared: by which number, of which size.
struct By<'a> {
    name: &'a str,
    size: f64,
    turned: Option<Turned>,
}

impl Derivatives {
    fn by_parameter<D: Described>(
        &mut self,
        described: &D,
        parameter: &Parameter,
        questions: &[Question],
    ) {
        let Ok(model) = built(described, parameter, |value| One::variable(value, 0)) else {
            self.faults.push(format!("{}: not built over duals", parameter.path));
            return;
        };
        let size = if parameter.value == 0.0 { 1.0 } else { parameter.value.abs() };
        let steps = Steps::of(0.05 * size);
        // Beyond the end of its range there is no model.
        let moved = steps.map(|step| built(described, parameter, |value| value + step).ok());
        let by = By { name: &parameter.path, size, turned: None };
        for at in questions {
            let dual = answers::<D, _>(&model, Dual::vector(at.wi), Dual::vector(at.wo), at);
            let plain = array::from_fn(|step| {
                let model = moved[step].as_ref().filter(|_| at.compared || step == 0)?;
                Some(answers::<D, _>(model, at.wi, at.wo, at))
            });
            self.compare(&by, at, &dual, &steps, &plain);
        }
    }

    fn by_directions<D: Described>(
        &mut self,
        model: &D::Model<One>,
        plain: &D::Model<f64>,
        questions: &[Question],
    ) {
        let steps = Steps::of(0.02);
        for at in questions {
            let ways = [(Turned::Light, at.wi), (Turned::Viewer, at.wo)]
                .map(|(turned, w)| tangents(w).map(|(tangent, way)| (turned, tangent, way)));
            for (turned, tangent, way) in ways.into_iter().flatten() {
                let moved = steps.map(|step| {
                    let (wi, wo) = match turned {
                        _ if step == 0.0 => (at.wi, at.wo),
                        _ if !at.compared => return None,
                        Turned::Light => (turn(at.wi, tangent, step), at.wo),
                        Turned::Viewer => (at.wi, turn(at.wo, tangent, step)),
                    };
                    Some(answers::<D, _>(plain, wi, wo, at))
                });
                let (wi, wo) = match turned {
                    Turned::Light => (along(at.wi, tangent), One::vector(at.wo)),
                    Turned::Viewer => (One::vector(at.wi), along(at.wo, tangent)),
                };
                let dual = answers::<D, _>(model, wi, wo, at);
                let by = By { name: way, size: 1.0, turned: Some(turned) };
                self.compare(&by, at, &dual, &steps, &moved);
            }
        }
    }

    fn compare(
        &mut self,
        by: &By<'_>,
        at: &Question,
        dual: &Answers<One>,
        steps: &Steps,
        moved: &[Option<Answers<f64>>; STEPS],
    ) {
        let Some(here) = &moved[0] else {
            self.faults.push(format!("{}: not built over f64", by.name));
            return;
        };
        for (index, (dual, here)) in dual.iter().zip(here).enumerate() {
            let turned = by.turned.map_or("", |turned| match turned {
                Turned::Light => " of wi",
                Turned::Viewer => " of wo",
            });
            let place = || format!("{} by {}{turned} at {at:?}", NAMES[index], by.name);
            if dual.value.to_bits() != here.to_bits() {
                self.faults.push(format!("{}: {} over duals, not {here}", place(), dual.value));
            }
            let [got] = dual.derivatives;
            if here.is_finite() && !got.is_finite() {
                self.faults.push(format!("{}: {got}", place()));
                continue;
            }
            // The azimuth of a draw is counted from that of the viewer, which the normal has not.
            let at_pole = by.turned == Some(Turned::Viewer)
                && at.wo == DVec3::Z
                && NAMES[index].starts_with("sample");
            if !at.compared || at_pole {
                continue;
            }
            let values = moved.each_ref().map(|moved| moved.as_ref().map(|moved| moved[index]));
            let Difference { slope, error, sides } = steps.difference(&values);
            // Many are 0 and come out as rounding, and the smallest numbers have no digits.
            let least = (1e-3 * here.abs() / by.size).max(1e-280);
            let scale = got.abs().max(slope.abs()).max(least);
            let decided = error <= 0.25 * LARGEST * scale;
            // Next to a kink the slope is that of the nearer side, on it the mean of both.
            let apart = [slope].into_iter().chain(sides.into_iter().flatten());
            let apart = apart.map(|slope| (got - slope).abs()).fold(f64::INFINITY, f64::min);
            let relative = if decided { apart } else { (apart - 4.0 * error).max(0.0) } / scale;
            self.compared += 1;
            self.undecided += usize::from(!decided);
            if relative > self.largest {
                self.largest = relative;
                self.place = format!("{}: {got:e}, not {slope:e} ± {error:e}", place());
            }
        }
    }
}

/// Both tangents of the sphere at a direction, with their names.
fn tangents(w: DVec3) -> [(DVec3, &'static str); 2] {
    let across = DVec3::new(-w.y, w.x, 0.0).normalize_or(DVec3::X);
    [(across, "azimuth"), (w.cross(across), "tilt")]
}

/// A direction turned by an angle towards a tangent.
fn turn(w: DVec3, tangent: DVec3, angle: f64) -> DVec3 {
    let (sin, cos) = Real::sin_cos(angle);
    w * cos + tangent * sin
}

/// A direction that turns towards a tangent.
fn along(w: DVec3, tangent: DVec3) -> Vector3<One> {
    let component = |value, derivative| Dual { value, derivatives: [derivative] };
    Vector3 {
        x: component(w.x, tangent.x),
        y: component(w.y, tangent.y),
        z: component(w.z, tangent.z),
    }
}
