// Natural logarithm; the least number for what has none.
fn brdf_ln(x: f32) -> f32 {
    let subnormal = x < 1.1754944e-38;
    let bits = bitcast<u32>(select(x, x * 16777216.0, subnormal)) + 0x004afb0du;
    let mantissa = bitcast<f32>((bits & 0x007fffffu) + 0x3f3504f3u);
    let n = i32(bits >> 23u) - select(127, 151, subnormal);
    let y = brdf_ln_of_part(mantissa - 1.0, f32(n));
    return select(-3.40282346e38, y, x > 0.0);
}
