// ln(1 + x), accurate near 0; the least number for what has none.
fn brdf_ln_1p(x: f32) -> f32 {
    if abs(x) < 0.29 {
        return brdf_ln_of_part(x, 0.0);
    }
    let bits = bitcast<u32>(1.0 + x) + 0x004afb0du;
    let n = i32(bits >> 23u) - 127;
    // (1 + x)/2^n - 1: both terms are exact.
    let scale = bitcast<f32>(u32(127 - clamp(n, -126, 126)) << 23u);
    let y = brdf_ln_of_part((scale - 1.0) + x * scale, f32(n));
    return select(-3.40282346e38, y, x > -1.0);
}
