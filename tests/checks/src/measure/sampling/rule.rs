//! The quadrature rule of Gauss and Kronrod with 3 and 7 nodes.

/// Nodes on [−1, 1] with their Kronrod weights and, for the three that Gauss's rule shares, its
/// weights. Exact to degree 11 and 5.
pub const NODES: [(f64, f64, f64); 7] = [
    (-0.960491268708020283, 0.104656226026467265, 0.0),
    (-0.774596669241483377, 0.268488089868333441, 5.0 / 9.0),
    (-0.434243749346802558, 0.401397414775962223, 0.0),
    (0.0, 0.450916538658474142, 8.0 / 9.0),
    (0.434243749346802558, 0.401397414775962223, 0.0),
    (0.774596669241483377, 0.268488089868333441, 5.0 / 9.0),
    (0.960491268708020283, 0.104656226026467265, 0.0),
];

/// The nodes between two ends.
pub fn nodes(from: f64, to: f64) -> [f64; 7] {
    let (center, half) = (0.5 * (from + to), 0.5 * (to - from));
    NODES.map(|(node, ..)| center + half * node)
}

/// The likely error of the rule of 7 nodes from its difference to that of 3, as in QUADPACK: at
/// least the difference itself unless it is tiny against the `variation`, the integral of the
/// distance from the mean.
pub fn likely_error(difference: f64, variation: f64) -> f64 {
    let difference = difference.abs();
    if variation > 0.0 {
        variation * (200.0 * difference / variation).powf(1.5).min(1.0)
    } else {
        difference
    }
}
