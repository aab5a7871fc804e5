// 1 - erf(x), accurate relative to its own size in the tail.
fn brdf_erfc(x: f32) -> f32 {
    let a = min(abs(x), 11.0);
    if a < 0.75 {
        return 1.0 - brdf_erf(x);
    }
    let tail = brdf_erfc_tail(a);
    return select(tail, 2.0 - tail, x < 0.0);
}
