//! Derivatives by differences, extrapolated to the step 0.

/// How many values a difference is made of: the one without a step, and pairs of steps to both sides.
pub const STEPS: usize = 2 * LEVELS + 1;
const LEVELS: usize = 11;

/// Each pair of steps is so much smaller than the one before.
const RATIO: f64 = 3.0;

/// Steps 0, h, −h, h/3, −h/3, …
#[derive(Clone, Copy, Debug)]
pub struct Steps([f64; STEPS]);

/// A slope and how far it may be off.
#[derive(Clone, Copy, Debug)]
pub struct Difference {
    pub slope: f64,
    pub error: f64,
    /// The slopes to both sides, if they differ: there is a kink nearer than the smallest step.
    pub sides: Option<[f64; 2]>,
}

impl Difference {
    const NONE: Self = Self { slope: f64::NAN, error: f64::INFINITY, sides: None };

    fn best(self, other: Self) -> Self {
        if other.error < self.error { other } else { self }
    }
}

impl Steps {
    /// From a largest step.
    pub fn of(largest: f64) -> Self {
        let mut steps = [0.0; STEPS];
        let mut step = largest;
        for pair in steps[1..].chunks_exact_mut(2) {
            pair.copy_from_slice(&[step, -step]);
            step /= RATIO;
        }
        Self(steps)
    }

    /// Of what there is for each step.
    pub fn map<V>(&self, value: impl FnMut(f64) -> V) -> [V; STEPS] {
        self.0.map(value)
    }

    /// The slope at the step 0 from the values at all steps; from those of one side if the other has
    /// none. The mean of both sides where they differ.
    pub fn difference(&self, values: &[Option<f64>; STEPS]) -> Difference {
        let here = values[0].unwrap_or(f64::NAN);
        let (first, noise) = (self.first(here, values), self.noise(here, values));
        let (mut central, mut forward, mut backward) = (Vec::new(), Vec::new(), Vec::new());
        for (pair, step) in self.pairs(values).skip(first) {
            let [above, below] = [pair[0], pair[1]];
            forward.extend(above.map(|above| [(above - here) / step, step]));
            backward.extend(below.map(|below| [(here - below) / step, step]));
            if let (Some(above), Some(below)) = (above, below) {
                central.push([(above - below) / (2.0 * step), step]);
            }
        }
        let [forward, backward] = [forward, backward].map(|side| extrapolated(&side, noise, 1));
        let both = limit(&central, noise);
        if values.contains(&None) {
            // A parameter at or next to an end of its range.
            return both.best(forward).best(backward);
        }
        let differ =
            (forward.slope - backward.slope).abs() > 16.0 * (forward.error + backward.error);
        Difference { sides: differ.then_some([forward.slope, backward.slope]), ..both }
    }

    /// The values to both sides, with their step.
    fn pairs<'a>(
        &'a self,
        values: &'a [Option<f64>; STEPS],
    ) -> impl Iterator<Item = (&'a [Option<f64>], f64)> {
        values[1..].chunks_exact(2).zip(self.0[1..].iter().copied().step_by(2))
    }

    /// How far the values are off: by their own rounding, and by that inside their formula. It shows
    /// in the smallest steps, over which a value bends with the square of the step, and with the step
    /// where it has a kink: what is neither is noise.
    fn noise(&self, here: f64, values: &[Option<f64>; STEPS]) -> f64 {
        let bend = |(pair, _): (&[Option<f64>], f64)| Some((pair[0]? - here) + (pair[1]? - here));
        let bends: Vec<f64> = self.pairs(values).skip(LEVELS - 4).filter_map(bend).collect();
        let without = |bends: &[f64], power: i32| -> Vec<f64> {
            bends.windows(2).map(|pair| pair[1] - pair[0] / RATIO.powi(power)).collect()
        };
        let rest = without(&without(&bends, 1), 2);
        rest.into_iter().map(f64::abs).fold(4.0 * f64::EPSILON * here.abs(), f64::max)
    }

    /// The first pair of steps over which the value does not change altogether, unless there are few
    /// left: far away a narrow lobe is flat.
    fn first(&self, here: f64, values: &[Option<f64>; STEPS]) -> usize {
        let far = |(pair, _): &(&[Option<f64>], f64)| {
            pair.iter()
                .flatten()
                .any(|value| (value - here).abs() > 0.7 * value.abs().max(here.abs()))
        };
        self.pairs(values).take_while(far).count().min(LEVELS - 6)
    }
}

/// The limit of slopes to both sides. Where larger steps reach beyond a kink they may agree by chance on
/// what the smaller ones contradict.
fn limit(slopes: &[[f64; 2]], noise: f64) -> Difference {
    let all = |slopes| extrapolated(slopes, noise, 1).best(extrapolated(slopes, noise, 2));
    let (far, near) = (all(slopes), all(&slopes[slopes.len() / 2..]));
    let contradict = (far.slope - near.slope).abs() > 16.0 * (far.error + near.error);
    if contradict { near } else { far }
}

/// The limit of slopes for steps that shrink by the ratio, whose error has powers of the step that
/// are multiples of the order, by Richardson's extrapolation, as far as it converges.
///
/// The noise of the values bounds what they can tell.
fn extrapolated(slopes: &[[f64; 2]], noise: f64, order: i32) -> Difference {
    let mut best = Difference::NONE;
    let mut row: Vec<f64> = Vec::new();
    for [slope, step] in slopes {
        let rounding = noise / step;
        let mut next = vec![*slope];
        let mut power = 1.0;
        for above in &row {
            power *= RATIO.powi(order);
            let last = next[next.len() - 1];
            next.push(last + (last - above) / (power - 1.0));
        }
        // An entry is as good as it agrees with both that it is made of and the one before it.
        for column in 1..next.len() {
            let (entry, left, above) = (next[column], next[column - 1], row[column - 1]);
            // In the last column the one before has none above.
            let before = row.get(column).unwrap_or(&left);
            let apart = [left, above, *before].map(|other| (entry - other).abs());
            let error = apart.into_iter().fold(rounding, f64::max);
            if error < best.error {
                best = Difference { slope: entry, error, sides: None };
            }
        }
        row = next;
    }
    best
}
