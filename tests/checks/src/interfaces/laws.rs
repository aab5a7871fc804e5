//! What holds of every model over the whole sphere, over `f64` and over numbers that err.

use brdf::{BsdfSample, Lobe, TransportMode};
use glam::DVec3;

use super::{Entry, MODES, Model, pairs, viewers};
use crate::sound::unsound_anywhere;
use crate::values::{Verdict, fail};

/// A law, over a model of numbers whose errors, if there are any, are armed as it answers.
pub type Law = fn(&Entry<f64>) -> Verdict;

/// All of them, quick ones first.
pub const LAWS: [(&str, Law); 7] = [
    ("radiance and importance are adjoint", adjointness),
    ("specular lobes are adjoint", adjointness_of_lobes),
    ("samples agree with value, density and lobes", samples_agree),
    ("density is the probability over the Jacobian", density_is_the_jacobian),
    ("a model on two sides is its mirror image below", two_sides),
    ("robustness over the sphere", robustness),
    ("power", power),
];

/// The largest number below 1.
const LAST: f64 = 1.0 - f64::EPSILON / 2.0;

/// A lattice of places in the unit square, off its edges.
fn places(count: u32) -> impl Iterator<Item = [f64; 2]> {
    (0..count).map(move |index| {
        let along = (f64::from(index) + 0.5) / f64::from(count);
        [along, (f64::from(index) * 0.618_033_988_749_894_9 + 0.25).fract()]
    })
}

fn viewers_and_modes() -> impl Iterator<Item = (DVec3, TransportMode)> {
    viewers().into_iter().flat_map(|wo| MODES.map(|mode| (wo, mode)))
}

/// Importance is the transpose of radiance to the last bit, and light that crosses is scaled by the
/// indices of both sides: f(wi, wo)/n_o² = f(wo, wi)/n_i².
fn adjointness(entry: &Entry<f64>) -> Verdict {
    let (row, model) = (entry.row, &*entry.model);
    let mut crossing = 0;
    for (wi, wo) in pairs() {
        let radiance = model.eval(wi, wo, TransportMode::Radiance);
        let importance = model.eval(wi, wo, TransportMode::Importance);
        let transposed = model.eval(wo, wi, TransportMode::Radiance);
        let there = radiance / row.index_squared(wo);
        let back = importance / row.index_squared(wi);
        let same = (there - back).abs().cmple(there * 4e-16).all();
        if importance != transposed || !same {
            return fail(format!("{radiance} {importance} {transposed} at {wi} {wo}"));
        }
        crossing += u32::from(wi.z * wo.z < 0.0 && there.x > 0.0);
    }
    if row.is_rough() && crossing == 0 {
        return fail("no pair crosses the surface".to_owned());
    }
    Ok(())
}

/// The lobe back through a lobe leads to where it came from, with the transposed weight.
fn adjointness_of_lobes(entry: &Entry<f64>) -> Verdict {
    let (row, model) = (entry.row, &*entry.model);
    let mut seen = 0;
    for (wo, mode) in viewers_and_modes() {
        let there = model.specular(wo, mode);
        for (lobe, transmitted) in [(there.reflected, false), (there.transmitted, true)] {
            if lobe.weight == DVec3::ZERO {
                continue;
            }
            let back = model.specular(lobe.wi, mode);
            let back = if transmitted { back.transmitted } else { back.reflected };
            // What the beams have of power: radiance over n² is the same all along a beam.
            let indices = match mode {
                TransportMode::Radiance => row.index_squared(lobe.wi) / row.index_squared(wo),
                TransportMode::Importance => 1.0,
            };
            let [power, power_back] = [lobe.weight * indices, back.weight / indices];
            let near = back.wi.abs_diff_eq(wo, 1e-12)
                && (power - power_back).abs().cmple(power * 1e-10).all();
            let straight = (lobe.wi.length_squared() - 1.0).abs() < 1e-14
                && (lobe.wi.z * wo.z < 0.0) == transmitted;
            if !near || !straight {
                return fail(format!("{lobe:?} of {wo}, back {back:?}"));
            }
            seen += 1;
        }
    }
    if seen == 0 && !row.scatters() {
        return fail("no lobe".to_owned());
    }
    Ok(())
}

/// The event of the first third number at a place of the square, its probability, and the event of
/// the last: the same one where there is no other.
fn events(
    model: &Model<f64>,
    wo: DVec3,
    [x, y]: [f64; 2],
    mode: TransportMode,
) -> [(BsdfSample<f64, DVec3>, f64); 2] {
    let at = |u| model.sample(wo, [x, y, u], mode);
    let (first, last) = (at(0.0), at(LAST));
    let (mut below, mut above) = (0.0, 1.0);
    if last.wi == first.wi {
        below = 1.0;
    }
    while above - below > 1e-12 {
        let middle = 0.5 * (below + above);
        *(if at(middle).wi == first.wi { &mut below } else { &mut above }) = middle;
    }
    [(first, below), (last, if below == 1.0 { 1.0 } else { 1.0 - below })]
}

/// The weight of a draw is f |cosθ|/pdf, of a lobe its weight over the probability of drawing it. The
/// density of a draw is that of its direction.
fn samples_agree(entry: &Entry<f64>) -> Verdict {
    let model = &*entry.model;
    let mut drawn = 0;
    for (wo, mode) in viewers_and_modes() {
        let lobes = model.specular(wo, mode);
        let lobes = [lobes.reflected, lobes.transmitted];
        for place in places(30) {
            for (sample, chance) in events(model, wo, place, mode) {
                let wrong =
                    || fail(format!("{sample:?} of {wo} {place:?} with {chance}, lobes {lobes:?}"));
                if sample.specular {
                    let is = |lobe: &&Lobe<f64, DVec3>| {
                        lobe.wi == sample.wi && lobe.weight != DVec3::ZERO
                    };
                    let Some(lobe) = lobes.iter().find(is) else { return wrong() };
                    let weight = sample.weight * chance;
                    let near = (weight - lobe.weight).abs().cmple(lobe.weight * 1e-9 + 1e-11);
                    if sample.pdf != 0.0 || !near.all() {
                        return wrong();
                    }
                    drawn += 1;
                } else if sample.pdf > 0.0 {
                    let (value, pdf) = model.eval_pdf(sample.wi, wo, mode);
                    let weight = value * (sample.wi.z.abs() / pdf);
                    let near = (weight - sample.weight).abs().cmple(weight * 1e-11);
                    if pdf != sample.pdf || !near.all() {
                        return wrong();
                    }
                    drawn += 1;
                }
            }
        }
    }
    if drawn < 200 { fail(format!("{drawn} draws")) } else { Ok(()) }
}

/// The solid angle that belongs to a small area of the square around a draw, per that area.
fn spread(model: &Model<f64>, wo: DVec3, [x, y, u]: [f64; 3]) -> Option<f64> {
    const STEP: f64 = 1e-5;
    let at = |x, y| {
        let sample = model.sample(wo, [x, y, u], TransportMode::Radiance);
        (sample.pdf > 0.0).then_some(sample.wi)
    };
    let first = at(x + STEP, y)? - at(x - STEP, y)?;
    let second = at(x, y + STEP)? - at(x, y - STEP)?;
    Some(first.cross(second).length() / (4.0 * STEP * STEP))
}

/// The density is the probability of the event over the solid angle over which the sampler spreads its
/// first two numbers. Where several parts draw the same direction it is a sum of those, which draws that
/// are counted tell.
fn density_is_the_jacobian(entry: &Entry<f64>) -> Verdict {
    let (row, model) = (entry.row, &*entry.model);
    if !row.scatters() || row.has_parts() {
        return Ok(());
    }
    for wo in viewers().into_iter().filter(|wo| wo.z > 0.0 || row.is_open()) {
        let (mut off, mut seen, mut worst) = (0, 0, 0.0_f64);
        for place in places(60).filter(|u| u.iter().all(|u| (0.03..0.97).contains(u))) {
            let both = events(model, wo, place, TransportMode::Radiance);
            for ((sample, chance), u) in both.into_iter().zip([0.0, LAST]) {
                let [x, y] = place;
                let Some(area) = spread(model, wo, [x, y, u]) else { continue };
                let product = sample.pdf * area;
                // Next to the critical angle differences see little.
                let near = (product - chance).abs() < 1e-4 * chance + 1e-7;
                seen += 1;
                if !near {
                    off += 1;
                    let error = (product / chance - 1.0).abs();
                    worst = if error.is_nan() { error } else { worst.max(error) };
                }
            }
        }
        if seen < 10 || off > 3 {
            return fail(format!("{off} of {seen} densities are off, by up to {worst} at {wo}"));
        }
    }
    Ok(())
}

/// A model on two sides is its mirror image below.
fn two_sides(entry: &Entry<f64>) -> Verdict {
    let (both, model) = (&*entry.two_sided, &*entry.model);
    for (index, (wi, wo)) in pairs().into_iter().enumerate() {
        let up = |w: DVec3| if wo.z < 0.0 { DVec3::new(w.x, w.y, -w.z) } else { w };
        let turned = |lobe: Lobe<f64, DVec3>| Lobe { wi: up(lobe.wi), ..lobe };
        for mode in MODES {
            let mut same = both.eval(wi, wo, mode) == model.eval(up(wi), up(wo), mode)
                && both.pdf(wi, wo, mode) == model.pdf(up(wi), up(wo), mode)
                && both.eval_pdf(wi, wo, mode) == model.eval_pdf(up(wi), up(wo), mode);
            let (mine, theirs) = (both.specular(wo, mode), model.specular(up(wo), mode));
            same &= mine.reflected == turned(theirs.reflected)
                && mine.transmitted == turned(theirs.transmitted);
            let u = [0.3, 0.6, (index as f64 * 0.618).fract()];
            let (mine, theirs) = (both.sample(wo, u, mode), model.sample(up(wo), u, mode));
            same &= mine == BsdfSample { wi: up(theirs.wi), ..theirs };
            if !same {
                return fail(format!("{mine:?} for {theirs:?} at {wi} {wo}"));
            }
        }
    }
    let [wo, up] = [DVec3::new(0.6, 0.0, -0.8), DVec3::new(0.6, 0.0, 0.8)];
    let same = both.power(wo) == model.power(up);
    if same { Ok(()) } else { fail(format!("powers {:?} {:?}", both.power(wo), model.power(up))) }
}

/// Every answer is finite and not negative, whatever goes in.
fn robustness(entry: &Entry<f64>) -> Verdict {
    unsound_anywhere(&*entry.model).map_or(Ok(()), fail)
}

/// Powers are the means of weights, all that arrives where nothing is lost, and never more. Of models with
/// several parts the weights of draws differ most, in wave optics next to the horizon without bound.
fn power(entry: &Entry<f64>) -> Verdict {
    let (row, model) = (entry.row, &*entry.model);
    for wo in viewers().into_iter().step_by(3) {
        let [returned, passed] = mean_weights(model, wo, 5000);
        let power = model.power(wo);
        let share = if row.has_parts() { 2e-2 } else { 4e-3 };
        let near = |got: DVec3, want: DVec3| {
            (got - want).abs().max_element() < share * got.max_element().max(1.0)
        };
        if row.is_wave() && wo.z < 0.1 {
            continue;
        }
        if !near(power.reflectance, returned) || !near(power.transmittance, passed) {
            return fail(format!("{power:?} at {wo}, but {returned} {passed}"));
        }
        let total = power.reflectance + power.transmittance;
        let answers = wo.z > 0.0 || row.is_open();
        let kept = (total - 1.0).abs().max_element() <= 1e-13;
        if total.max_element() > row.gain() + 1e-13 || row.lossless && answers && !kept {
            return fail(format!("{power:?} at {wo}"));
        }
    }
    Ok(())
}

/// The mean weights of draws that fill the cube evenly, of those that return and of those that pass.
pub fn mean_weights(model: &Model<f64>, wo: DVec3, count: u32) -> [DVec3; 2] {
    // The additive recurrence of the cube's generalised golden ratio.
    const STEP: [f64; 3] =
        [0.819_172_513_396_164_4, 0.671_043_606_703_789_2, 0.549_700_477_901_970_3];
    let mut sums = [DVec3::ZERO; 2];
    for index in 0..count {
        let u = STEP.map(|step| (0.5 + f64::from(index) * step).fract());
        let sample = model.sample(wo, u, TransportMode::Importance);
        sums[usize::from(sample.wi.z * wo.z < 0.0)] += sample.weight;
    }
    sums.map(|sum| sum / f64::from(count))
}

/// Answers of a model from everywhere, to see what it is made of.
pub(crate) fn probe(entry: &Entry<f64>) {
    for model in [&*entry.model, &*entry.two_sided] {
        for (wo, mode) in viewers_and_modes() {
            model.specular(wo, mode);
            for [x, y] in places(16) {
                for u in [0.0, LAST] {
                    let sample = model.sample(wo, [x, y, u], mode);
                    model.eval_pdf(sample.wi, wo, mode);
                }
            }
        }
        model.power(viewers()[0]);
    }
}
