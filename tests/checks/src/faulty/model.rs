//! A model over numbers that err, as a model over `f64`.

use brdf::{Brdf, Bsdf, BsdfSample, Color, Lobe, Lobes, Power, Sample, TransportMode};
use glam::DVec3;

use super::number::Faulty;
use super::place::{Fault, armed};
use super::vector::FaultyVector;

/// A model whose fault is armed while it answers, on whatever thread that is, so that what is
/// measured of other models can be measured of it.
pub struct Seeded<M> {
    pub model: M,
    pub fault: Option<&'static Fault>,
}

fn seeded(w: DVec3) -> FaultyVector {
    Color::<f64>::lift(w, Faulty)
}

fn plain(w: FaultyVector) -> DVec3 {
    Color::<Faulty>::lift(w, |component| component.0)
}

impl<M> Seeded<M> {
    /// With the fault armed. Without one, what this thread watches is left alone, so that the places
    /// that a model reaches can be recorded.
    fn answer<A>(&self, run: impl FnOnce() -> A) -> A {
        match self.fault {
            Some(_) => armed(self.fault, run),
            None => run(),
        }
    }
}

impl<M: Brdf<Faulty, Color = FaultyVector>> Brdf<f64> for Seeded<M> {
    type Color = DVec3;

    fn eval(&self, wi: DVec3, wo: DVec3) -> DVec3 {
        self.answer(|| plain(self.model.eval(seeded(wi), seeded(wo))))
    }

    fn pdf(&self, wi: DVec3, wo: DVec3) -> f64 {
        self.answer(|| self.model.pdf(seeded(wi), seeded(wo)).0)
    }

    fn sample(&self, wo: DVec3, u: [f64; 2]) -> Sample<f64, DVec3> {
        self.answer(|| {
            let sample = self.model.sample(seeded(wo), u.map(Faulty));
            Sample { wi: plain(sample.wi), weight: plain(sample.weight), pdf: sample.pdf.0 }
        })
    }

    fn albedo(&self, wo: DVec3) -> DVec3 {
        self.answer(|| plain(self.model.albedo(seeded(wo))))
    }
}

impl<M: Bsdf<Faulty, Color = FaultyVector>> Bsdf<f64> for Seeded<M> {
    type Color = DVec3;

    fn eval(&self, wi: DVec3, wo: DVec3, mode: TransportMode) -> DVec3 {
        self.answer(|| plain(self.model.eval(seeded(wi), seeded(wo), mode)))
    }

    fn pdf(&self, wi: DVec3, wo: DVec3, mode: TransportMode) -> f64 {
        self.answer(|| self.model.pdf(seeded(wi), seeded(wo), mode).0)
    }

    fn sample(&self, wo: DVec3, u: [f64; 3], mode: TransportMode) -> BsdfSample<f64, DVec3> {
        self.answer(|| {
            let sample = self.model.sample(seeded(wo), u.map(Faulty), mode);
            BsdfSample {
                wi: plain(sample.wi),
                weight: plain(sample.weight),
                pdf: sample.pdf.0,
                specular: sample.specular.into(),
            }
        })
    }

    fn specular(&self, wo: DVec3, mode: TransportMode) -> Lobes<f64, DVec3> {
        self.answer(|| {
            let Lobes { reflected, transmitted } = self.model.specular(seeded(wo), mode);
            let [reflected, transmitted] = [reflected, transmitted]
                .map(|lobe| Lobe { wi: plain(lobe.wi), weight: plain(lobe.weight) });
            Lobes { reflected, transmitted }
        })
    }

    fn power(&self, wo: DVec3) -> Power<DVec3> {
        self.answer(|| {
            let Power { reflectance, transmittance } = self.model.power(seeded(wo));
            Power { reflectance: plain(reflectance), transmittance: plain(transmittance) }
        })
    }
}
