// Error function.
fn brdf_erf(x: f32) -> f32 {
    let a = min(abs(x), 11.0);
    if a >= 0.75 {
        return brdf_copysign(1.0 - brdf_erfc_tail(a), x);
    }
    let z = x * x;
    let q = z * z;
    return x + x * (0.12837917 - 0.3761264 * z + q * (0.11283778 - 0.02686474 * z
        + q * (0.0052166847 - 0.0008355273 * z + q * 9.460661e-5)));
}
