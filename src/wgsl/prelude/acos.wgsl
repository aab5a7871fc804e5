// Arc cosine; beyond the ends that of the nearest.
fn brdf_acos(x: f32) -> f32 {
    let a = min(abs(x), 1.0);
    if a <= 0.5 {
        return 1.5707964 - (x - (-4.371139e-8 - brdf_arc_tail(x, x * x)));
    }
    // 2 asin(sqrt((1 - a)/2)).
    let z = 0.5 * (1.0 - a);
    let s = sqrt(z);
    let twice = 2.0 * (s + brdf_arc_tail(s, z));
    return select(3.1415927 - (twice + 8.742278e-8), twice, x > 0.0);
}
