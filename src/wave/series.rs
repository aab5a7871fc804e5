//! The sum over the orders, of one pair of directions and of a block of them.

use super::orders::{Few, Many, Order, Orders, Pace, are_many};
use crate::block::{BLOCK, Block, Plane};
use crate::real::{Mask, Real};

/// Σ gᵐ e^(−g)/(m! m) e^(−e/m), over g of few orders, times g of [many](are_many): what a surface scatters of a
/// phase variance g in a direction with e = v_xy² τ²/4, but for a factor.
#[inline(always)]
pub(super) fn scattered<T: Real>(orders: &Orders<T>, e: T) -> T {
    let mut sum = T::zero();
    orders.visit(
        #[inline(always)]
        |order| sum = sum + term(&order, e),
    );
    sum
}

#[inline(always)]
fn term<T: Real>(Order { inverse, factor, exponent }: &Order<T>, e: T) -> T {
    *factor * *inverse * (*exponent - e * *inverse).exp()
}

impl<T: Real> Many<T> {
    /// Adds the term of where it is, and goes on.
    #[inline(always)]
    fn add_to(self, sum: T, e: T) -> (Self, T) {
        (self.next(), sum + term(&self.order(), e))
    }
}

/// [`scattered`] for a block of g and e, to the last bit: all of them take the same steps at once, as a
/// loop inside a loop would not become SIMD code. Two terms go into a step, which goes to memory.
#[inline(never)]
pub(super) fn scattered_block<T: Real>(block: Block<'_, T, 2>, sums: &mut Plane<T>) {
    let ([g, e], zero) = (block.planes, [T::zero(); BLOCK]);
    let mut peaks = [zero];
    block.numbers(
        &mut peaks,
        #[inline(always)]
        |index| [Orders::new(g[index], e[index]).peak()],
    );
    let block = block.of([g, e, &peaks[0]]);
    *sums = zero;
    if g.iter().any(|g| !are_many(*g).not().is_never()) {
        few_block(block, sums);
    }
    if g.iter().any(|g| !are_many(*g).is_never()) {
        many_block(block, sums);
    }
}

#[inline(always)]
fn orders<T: Real>(Block { planes: [g, _, peak], .. }: Block<'_, T, 3>, index: usize) -> Orders<T> {
    Orders::around(g[index], peak[index])
}

#[inline(always)]
fn pace<T: Real>(Block { planes, .. }: Block<'_, T, 6>, index: usize) -> Pace<T> {
    let [g, inverse_g, scale, ratio, inverse_ratio, step] = planes.map(
        #[inline(always)]
        |plane| plane[index],
    );
    Pace { g, inverse_g, scale, ratio, inverse_ratio, step }
}

/// Whether no later term changes the sum, of two terms that follow each other: beyond the largest they fall.
fn have_ended<T: Real>(sum: T, [first, second]: [T; 2]) -> T::Mask {
    let falling = second.le(first).and(sum.gt(T::zero()));
    second.le(sum * T::lit(0.125 * T::SPACING)).and(falling)
}

#[inline(always)]
fn few_block<T: Real>(block: Block<'_, T, 3>, sums: &mut Plane<T>) {
    const { assert!(Few::<f32>::COUNT.is_multiple_of(2) && Few::<f64>::COUNT.is_multiple_of(2)) }
    let e = block.planes[1];
    let mut state = [[T::zero(); BLOCK]; 4];
    let mut both_g = [[T::zero(); BLOCK]; 2];
    block.changed(
        &mut state,
        &mut both_g,
        #[inline(always)]
        |index, _| {
            let Few { at: [order, inverse, factor], g } = Few::first(&orders(block, index));
            ([order, inverse, factor, sums[index]], g)
        },
    );
    let [g, inverse_g] = &both_g;
    let mut terms = [[T::zero(); BLOCK]; 2];
    for _ in 0..Few::<T>::COUNT / 2 {
        block.changed(
            &mut state,
            &mut terms,
            #[inline(always)]
            |index, [order, inverse, factor, sum]| {
                let few = Few { at: [order, inverse, factor], g: [g[index], inverse_g[index]] };
                let (first, few) = (term(&few.order(), e[index]), few.next());
                let (second, few) = (term(&few.order(), e[index]), few.next());
                let [order, inverse, factor] = few.at;
                ([order, inverse, factor, sum + first + second], [first, second])
            },
        );
        let [.., sum] = &state;
        let ended = |index: usize| have_ended(sum[index], terms.each_ref().map(|it| it[index]));
        let none = |index: usize| are_many(block.planes[0][index]);
        if !T::HAS_DERIVATIVES
            && (0..BLOCK).all(|index| ended(index).or(none(index)).not().is_never())
        {
            break;
        }
    }
    let [.., summed] = state;
    *sums = summed;
}

#[inline(always)]
fn many_block<T: Real>(block: Block<'_, T, 3>, sums: &mut Plane<T>) {
    let e = block.planes[1];
    let mut paces = [[T::zero(); BLOCK]; 6];
    let mut state = [[T::zero(); BLOCK]; 4];
    for side in Many::<T>::SIDES {
        block.changed(
            &mut state,
            &mut paces,
            #[inline(always)]
            |index, _| {
                let Many { at: [up, down, y], pace } = Many::first(&orders(block, index), side);
                let Pace { g, inverse_g, scale, ratio, inverse_ratio, step } = pace;
                ([up, down, y, sums[index]], [g, inverse_g, scale, ratio, inverse_ratio, step])
            },
        );
        let paces = block.of(paces.each_ref());
        for _ in 0..side.count / 2 {
            block.changed(
                &mut state,
                &mut [],
                #[inline(always)]
                |index, [up, down, y, sum]| {
                    let many = Many { at: [up, down, y], pace: pace(paces, index) };
                    let (many, sum) = many.add_to(sum, e[index]);
                    let (Many { at: [up, down, y], .. }, sum) = many.add_to(sum, e[index]);
                    ([up, down, y, sum], [])
                },
            );
        }
        *sums = state[3];
    }
}

#[cfg(test)]
mod tests {
    use super::super::orders::{Orders, are_many};
    use super::{scattered, scattered_block};
    use crate::block::{BLOCK, Block, InstructionSet};
    use crate::real::Real;

    /// g, e and the sum, by 40 digits.
    #[rustfmt::skip]
    const SUMS: [[f64; 3]; 78] = [
        [1e-12, 0.0, 9.9999999999925e-13],
        [1e-12, 0.1, 9.0483741803529254e-13],
        [1e-12, 2.0, 1.3533528323656933e-13],
        [1e-12, 12.0, 6.1442123539417536e-18],
        [1e-3, 0.0, 0.00099925030546876902],
        [1e-3, 0.1, 0.00090417065624416858],
        [1e-3, 2.0, 0.00013529192203584682],
        [1e-3, 12.0, 6.7581569146354075e-9],
        [0.25, 0.0, 0.20757800281243345],
        [0.25, 0.1, 0.18843338036958838],
        [0.25, 2.0, 0.031193638212116428],
        [0.25, 12.0, 4.5440699129228806e-5],
        [1.0, 0.0, 0.48482910699568765],
        [1.0, 0.1, 0.4445569713547588],
        [1.0, 2.0, 0.09691908696705369],
        [1.0, 12.0, 0.00086466144639931205],
        [4.0, 0.0, 0.32358906727260325],
        [4.0, 0.4, 0.26910828484499572],
        [4.0, 8.0, 0.028436949671448242],
        [4.0, 48.0, 4.1647209006650305e-5],
        [9.0, 0.0, 0.12774196339646911],
        [9.0, 0.9, 0.11120438724557905],
        [9.0, 18.0, 0.013668492697964775],
        [9.0, 108.0, 6.8563035887664216e-6],
        [16.0, 0.0, 0.067021184070577105],
        [16.0, 1.6, 0.059689699998295632],
        [16.0, 32.0, 0.007982062169701438],
        [16.0, 192.0, 2.0527029595246771e-6],
        [23.5, 0.0, 0.044542076281232919],
        [23.5, 2.35, 0.039911521185659533],
        [23.5, 47.0, 0.0055297946158077172],
        [23.5, 282.0, 9.7091206372704316e-7],
        [24.5, 0.0, 0.042638419011690879],
        [24.5, 2.45, 0.038223762538146467],
        [24.5, 49.0, 0.0053124071194192876],
        [24.5, 294.0, 8.9806719811719114e-7],
        [30.0, 0.0, 0.034527121791989561],
        [30.0, 3.0, 0.031012514529935244],
        [30.0, 60.0, 0.0043682788561642646],
        [30.0, 360.0, 6.2046359878093817e-7],
        [40.0, 0.0, 0.025658862785975127],
        [40.0, 4.0, 0.023093588378377963],
        [40.0, 80.0, 0.003301877288989628],
        [40.0, 480.0, 3.768879395058451e-7],
        [55.5, 0.0, 0.018355048627813273],
        [55.5, 5.550000000000001, 0.016546277551764596],
        [55.5, 111.0, 0.002395664806991259],
        [55.5, 666.0, 2.2189024758923585e-7],
        [56.5, 0.0, 0.018024097127459863],
        [56.5, 5.65, 0.016249086483802355],
        [56.5, 113.0, 0.0023539875346525602],
        [56.5, 678.0, 2.1581363535742163e-7],
        [80.0, 0.0, 0.012660310554032884],
        [80.0, 8.0, 0.011426402813732953],
        [80.0, 160.0, 0.0016709143706323191],
        [80.0, 960.0, 1.2841550458041287e-7],
        [300.0, 0.0, 0.0033445192693037826],
        [300.0, 30.0, 0.0030242575606648312],
        [300.0, 600.0, 0.00044962065704422588],
        [300.0, 3600.0, 2.3915374210563504e-8],
        [5000.0, 0.0, 0.00020004001600960769],
        [5000.0, 500.0, 0.0001809966278675616],
        [5000.0, 10000.0, 2.7061644680723761e-5],
        [5000.0, 60000.0, 1.2409046757328358e-9],
        [1e5, 0.0, 1.000010000200006e-5],
        [1e5, 10000.0, 9.0484470208333041e-6],
        [1e5, 200000.0, 1.3533392990182575e-6],
        [1e5, 1200000.0, 6.1472232619120345e-11],
        [1e6, 0.0, 1.000001000002e-6],
        [1e6, 100000.0, 9.0483814643114263e-7],
        [1e6, 2000000.0, 1.353351479015099e-7],
        [1e6, 12000000.0, 6.1445134221789104e-12],
        [0.5, 300.0, 4.5785639615587416e-24],
        [1.0, 2000.0, 7.8979795335578869e-62],
        [20.0, 2000.0, 8.2267336904660981e-27],
        [50.0, 9000.0, 4.3721445794965691e-50],
        [60.0, 9000.0, 1.4626153564886885e-45],
        [1000.0, 200000.0, 5.2076225070918705e-84],
    ];

    #[test]
    fn blocks_have_the_bits_of_calls() {
        same_bits::<f32>();
        same_bits::<f64>();
    }

    fn same_bits<T: Real + PartialEq>() {
        let at = |index: usize| SUMS[index % SUMS.len()];
        let g: [T; BLOCK] = core::array::from_fn(|index| T::lit(at(index)[0]));
        let e: [T; BLOCK] = core::array::from_fn(|index| T::lit(at(index)[1]));
        for (g, e) in [(g, e), ([g[8]; BLOCK], e), ([g[66]; BLOCK], e)] {
            for set in InstructionSet::available() {
                let mut sums = [T::zero(); BLOCK];
                scattered_block(Block { set, planes: [&g, &e] }, &mut sums);
                for ((g, e), sum) in g.iter().zip(&e).zip(sums) {
                    assert_eq!(sum, scattered(&Orders::new(*g, *e), *e), "{g:?} {e:?}");
                }
            }
        }
    }

    fn sum<T: Real + Into<f64>>(g: f64, e: f64) -> f64 {
        let orders = Orders::new(T::lit(g), T::lit(e));
        let series: f64 = scattered(&orders, T::lit(e)).into();
        let many: f64 = T::select(are_many(T::lit(g)), T::one(), T::zero()).into();
        if many > 0.0 { series / g } else { series * g }
    }

    #[test]
    fn sums_have_their_values() {
        let mut worst = [0.0_f64; 2];
        for [g, e, want] in SUMS {
            let off = (sum::<f64>(g, e) / want - 1.0).abs();
            worst[0] = worst[0].max(off);
            assert!(off < 5e-14, "{g} {e}: {off:e}");
            if want > 1e-30 {
                // The exponents of single numbers have their own rounding.
                let exponent = (want / g.min(1.0 / g)).ln().abs();
                let off = (sum::<f32>(g, e) / want - 1.0).abs() / (1.0 + exponent);
                worst[1] = worst[1].max(off);
                assert!(off < 6e-7, "{g} {e}: {off:e}");
            }
        }
        println!("{worst:?}");
    }

    /// A mass is a product of up to 54 quotients, whose roundings add up.
    #[test]
    fn single_sums_are_those_of_double_ones() {
        for index in 1..480 {
            let g = f64::from(0.05_f32 * index as f32);
            for e in [0.0, g] {
                let want = sum::<f64>(g, e);
                let exponent = (want / g.min(1.0 / g)).ln().abs();
                let off = (sum::<f32>(g, e) / want - 1.0) / (1.0 + exponent);
                assert!(off.abs() < 1e-6, "{g} {e}: {off:e}");
            }
        }
    }
}
