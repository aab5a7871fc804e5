// Arc sine; beyond the ends that of the nearest.
fn brdf_asin(x: f32) -> f32 {
    let a = min(abs(x), 1.0);
    if a <= 0.5 {
        return x + brdf_arc_tail(x, x * x);
    }
    // pi/2 - 2 asin(sqrt((1 - a)/2)).
    let z = 0.5 * (1.0 - a);
    let s = sqrt(z);
    let y = 1.5707964 - (2.0 * (s + brdf_arc_tail(s, z)) + 4.371139e-8);
    return brdf_copysign(y, x);
}
