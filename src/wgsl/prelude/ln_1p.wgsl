// ln(1 + x), accurate near 0; the least number for what has none.
fn brdf_ln_1p(x: f32) -> f32 {
    if abs(x) < 0.29 {
        return brdf_ln_of_part(x, 0.0);
    }
    let whole = 1.0 + x;
    let bits = bitcast<u32>(whole) + 0x004afb0du;
    let n = i32(bits >> 23u) - 127;
    // (1 + x)/2^n - 1, of which both terms are exact; from 2^30 on the sum is.
    let scale = bitcast<f32>(u32(127 - clamp(n, -30, 30)) << 23u);
    let mantissa = bitcast<f32>((bits & 0x007fffffu) + 0x3f3504f3u);
    let f = select((scale - 1.0) + x * scale, mantissa - 1.0, n > 30);
    return select(-3.40282346e38, brdf_ln_of_part(f, f32(n)), x > -1.0);
}
